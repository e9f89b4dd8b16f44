"""A sweep from Python is that of the command."""

import csv
import os
import re

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, command

CLEARANCE = "joint.gudgeon.radial_clearance"
FEW = {"points": 5, "transient": 1, "turns": 4, "tolerance": "1e-7 m", "progress": False}


@pytest.fixture(scope="module")
def model() -> lp.Model:
    return lp.Model.load(MODEL)


@pytest.fixture(scope="module")
def sweep(model: lp.Model) -> lp.Sweep:
    return model.sweep(CLEARANCE, between=("0.1mm", "0.3mm"), threads=1, set={"contact.steel_pin.restitution": 0.7}, **FEW)


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory):
    """The folder of the same sweep by the command, with what that printed."""
    folder = tmp_path_factory.mktemp("sweep")
    arguments = ["--points", "5", "--transient", "1", "--turns", "4", "--tolerance", "1e-7 m", "--set", "contact.steel_pin.restitution=0.7"]
    ended = command("sweep", str(MODEL), "--over", f"{CLEARANCE}=0.1mm..0.3mm", *arguments, "--out", "run", cwd=folder)
    assert ended.returncode == 0, ended.stderr
    (folder / "printed.txt").write_text(ended.stdout, encoding="utf-8")
    return folder / "run"


def rows(path):
    with open(path, encoding="utf-8", newline="") as file:
        names, *cells = csv.reader(file)
    return names, cells


def test_identity_sweep_is_that_of_the_command(sweep, written, tmp_path):
    assert sweep._native.summary_json() == (written / "summary.json").read_text(encoding="utf-8")
    assert str(sweep) == (written.parent / "printed.txt").read_text(encoding="utf-8")
    assert sweep.report(tmp_path / "page.html").read_bytes() == (written / "report.html").read_bytes()


def test_identity_sections_are_those_of_the_command(sweep, written):
    names, cells = rows(written / "sections.csv")
    assert names == ["value", "turn", "slider_m"] and list(sweep) == ["slider"]
    expected = np.array(cells, dtype=float)
    assert sweep["slider"].shape == (5, 4)
    np.testing.assert_array_equal(sweep["slider"].ravel(), expected[:, 2])
    np.testing.assert_array_equal(np.repeat(sweep.values_si, 4), expected[:, 0])
    assert sweep.path == CLEARANCE and sweep.units == {CLEARANCE: "m", "slider": "m"}


def test_identity_frame_has_the_columns_of_the_command(sweep, written):
    names, cells = rows(written / "sweep.csv")
    frame = sweep.to_pandas()
    assert list(frame.columns) == names
    for place, name in enumerate(names[:-1]):
        expected = [float(row[place] or "nan") for row in cells]
        np.testing.assert_array_equal(frame[name], expected, err_msg=name)
    assert (frame["failure"] == "").all()
    np.testing.assert_array_equal(sweep.joints["gudgeon"].peak_force_n, frame["gudgeon.peak_force_n"])
    dataset = sweep.to_xarray()
    assert dataset["slider"].dims == ("run", "turn") and dataset["slider"].attrs["units"] == "m"
    np.testing.assert_array_equal(dataset[CLEARANCE], sweep.values_si)


def test_identity_numbers_in_si_and_any_threads_are_the_same_sweep(sweep, model):
    again = model.sweep(CLEARANCE, between=(1e-4, 3e-4), threads=2, set={"contact.steel_pin.restitution": 0.7}, **FEW)
    assert again.summary["points"] == sweep.summary["points"]
    assert "0.0001 m..0.0003 m" in again.summary["repeat"]["command"]


def test_identity_listed_values_give_the_same_runs(sweep, model):
    settings = {"contact.steel_pin.restitution": 0.7}
    few = {key: value for key, value in FEW.items() if key != "points"}
    order = [3, 0, 4]
    listed = model.sweep(CLEARANCE, values=sweep.values_si[order], set=settings, **few)
    np.testing.assert_array_equal(listed["slider"], sweep["slider"][order])
    np.testing.assert_array_equal(listed.joints["gudgeon"].impacts_per_turn, sweep.joints["gudgeon"].impacts_per_turn[order])
    assert "repeat" not in listed.summary


def test_a_run_that_fails_is_nan_with_its_reason(model):
    # A crank of 130 mm is longer than the rod of 120 mm.
    found = model.sweep("parameter.crank_length", values=[0.05, 0.13], transient=0, turns=2, tolerance="1e-6 m", progress=False)
    assert found.failed.tolist() == [False, True] and found.reasons[0] is None and found.reasons[1]
    assert np.isfinite(found["slider"][0]).all() and np.isnan(found["slider"][1]).all()
    assert np.isnan(found.joints["gudgeon"].peak_force_n[1]) and np.isnan(found.period_turns[1])


def test_progress_is_told_and_what_a_listener_raises_ends_the_sweep(model):
    heard = []
    few = FEW | {"progress": lambda finished, most: heard.append((finished, most))}
    model.sweep(CLEARANCE, between=("0.1 mm", "0.3 mm"), **few)
    assert heard[-1] == (5, 5)

    calls = []

    def interrupt(finished, most):
        calls.append(finished)
        raise KeyboardInterrupt

    long = {"points": 2000, "transient": 200, "turns": 64, "progress": interrupt}
    with pytest.raises(KeyboardInterrupt, match="interrupted after .* of 2000 runs; nothing is kept") as interrupted:
        model.sweep(CLEARANCE, between=("0.1 mm", "0.3 mm"), **long)
    # No further run is begun: those under way end, at most one on each thread.
    finished = int(re.search(r"after (\d+) of", str(interrupted.value))[1])
    assert len(calls) == 1 and finished <= calls[0] + os.cpu_count(), (calls, interrupted.value)


def test_figure_and_notebook(sweep):
    figure = sweep.plot()
    assert figure.axes[0].get_xlabel() == f"{CLEARANCE} [mm]"
    assert figure.axes[0].get_ylabel().endswith("[mm]")
    assert "5 runs" in sweep._repr_html_() and "5 runs" in repr(sweep)


@pytest.mark.parametrize(
    "arguments, error, words",
    [
        ({}, ValueError, "either between or values"),
        ({"between": ("0.1 mm", "0.2 mm"), "values": [1e-4]}, ValueError, "either between or values"),
        ({"between": ("0.1 mm", "0.2 mm"), "points": 1}, ValueError, "points 1; must be between 2 and 100000"),
        ({"between": "0.1 mm"}, ValueError, "between '0.1 mm'; must be two values"),
        ({"between": ("0.1 mm", "0.1 mm")}, lp.LoosepinError, "between: .* to the same value"),
        ({"between": ("0.1 mm", "0.2 kg")}, lp.LoosepinError, "between: .* must be a length"),
        ({"values": [1e-4, -1e-4]}, lp.LoosepinError, "values: .*-0.1 mm"),
        ({"values": []}, ValueError, "at least one value"),
        ({"values": ["0.1 mm"]}, TypeError, "must be numbers in SI units"),
        ({"values": [1e-4, np.inf]}, ValueError, "must be finite"),
        ({"values": [1e-4], "turns": 1}, ValueError, "turns 1; must be between 2 and 100000"),
        ({"values": [1e-4], "threads": 0}, ValueError, "threads 0; must be between 1 and 1024"),
        ({"values": [1e-4], "set": {CLEARANCE: "0.2 mm"}}, lp.LoosepinError, "over: .* set a second time"),
        ({"values": [1e-4], "set": {"parameter.rod_length": "0.12"}}, lp.LoosepinError, "set: .* without a unit"),
        ({"values": [1e-4], "tolerance": "1 mm"}, lp.LoosepinError, "the tolerance 1 mm is larger"),
    ],
)
def test_arguments_that_are_wrong_are_named(model, arguments, error, words):
    with pytest.raises(error, match=words):
        model.sweep(CLEARANCE, progress=False, **arguments)


def test_a_path_that_is_not_there_is_refused(model):
    for values in ({"between": (1e-4, 2e-4)}, {"between": ("0.1 mm", "0.2 mm")}, {"values": [1e-4]}):
        with pytest.raises(lp.LoosepinError, match=f"over: .*radial_clearence'\\nhint: did you mean '{CLEARANCE}'"):
            model.sweep("joint.gudgeon.radial_clearence", progress=False, **values)
