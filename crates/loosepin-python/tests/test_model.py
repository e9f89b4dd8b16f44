"""One run from Python is that of the command."""

import csv
import tomllib

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, command


@pytest.fixture(scope="module")
def model() -> lp.Model:
    return lp.Model.load(MODEL)


@pytest.fixture(scope="module")
def simulation(model: lp.Model) -> lp.Simulation:
    return model.simulate(turns=0.25, transient=0, samples=60, states=True, set={"joint.gudgeon.radial_clearance": "0.3 mm"})


def test_identity_history_is_that_of_the_command(simulation, tmp_path):
    arguments = ["--turns", "0.25", "--transient", "0", "--samples", "60", "--states"]
    arguments += ["--set", "joint.gudgeon.radial_clearance=0.3 mm", "--out", "run"]
    ended = command("simulate", str(MODEL), *arguments, cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    with open(tmp_path / "run/history.csv", encoding="utf-8", newline="") as file:
        names, *rows = csv.reader(file)
    assert list(simulation.history) == names
    expected = np.array(rows, dtype=float)
    for index, name in enumerate(names):
        np.testing.assert_array_equal(simulation.history[name], expected[:, index], err_msg=name)
    assert simulation.report(tmp_path / "page.html").read_bytes() == (tmp_path / "run/report.html").read_bytes()
    assert str(simulation) == ended.stdout


def test_identity_deviation_is_value_minus_ideal(simulation):
    assert list(simulation) == ["slider", "slider_velocity", "slider_acceleration", "gudgeon_force"]
    assert simulation.units["slider_acceleration"] == "m/s^2"
    # Stored differences were taken before rounding: they agree to the last bits of 0.17 m.
    np.testing.assert_allclose(simulation["slider"] - simulation.ideal["slider"], simulation.deviation["slider"], atol=1e-15)


def test_analytic_ideal_motion_of_the_slider_crank(simulation):
    angle = simulation.drive_angle_rad
    expected = 0.05 * np.cos(angle) + np.sqrt(0.12**2 - (0.05 * np.sin(angle)) ** 2)
    # m: round-off of the positions.
    np.testing.assert_allclose(simulation.ideal["slider"], expected, atol=1e-13)


def test_identity_a_dict_is_the_file(simulation, model):
    with open(MODEL, "rb") as file:
        again = lp.Model.from_dict(tomllib.load(file))
    run = again.simulate(turns=0.25, transient=0, samples=60, states=True, set={"joint.gudgeon.radial_clearance": "0.3 mm"})
    np.testing.assert_array_equal(run["slider"], simulation["slider"])
    assert again.outputs == model.outputs
    assert lp.Model.from_text(again.text).text == again.text


def test_frames(simulation):
    frame = simulation.to_pandas()
    assert list(frame.columns) == list(simulation.history)
    dataset = simulation.to_xarray()
    np.testing.assert_array_equal(dataset["slider_deviation"].values, simulation.deviation["slider"])
    assert dataset["slider_velocity"].attrs["units"] == "m/s"
    assert len(simulation.impacts) == len(simulation.summary["impacts"]) > 0


def test_figures_and_notebook(simulation, model):
    figure = simulation.plot("slider", "gudgeon_force")
    assert [axis.get_ylabel() for axis in figure.axes] == ["slider [mm]", "gudgeon_force [N]"]
    assert simulation.plot("slider", deviation=True).axes[0].get_ylabel() == "slider, deviation [mm]"
    assert simulation._repr_html_().count('<img src="data:image/svg+xml') == 2
    assert "x of slider.pin" in model._repr_html_()


def test_arrays_are_plain(simulation):
    values = simulation["slider_velocity"]
    assert type(values) is np.ndarray and values.dtype == np.float64 and not values.flags.writeable and values.flags.c_contiguous
