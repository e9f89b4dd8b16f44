"""Everything that a run records, as arrays: states, orbits, contact forces, spectra, exponents, measured curves."""

import csv
import faulthandler
import json
import os
import signal
import threading

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, REPOSITORY, command

# s; how long an end is waited for, on a busy machine.
PATIENCE_S = 60
TURNS = ["--turns", "1", "--transient", "0", "--samples", "60", "--tolerance", "1e-7 m"]
PENDULUM = REPOSITORY / "crates/loosepin-simulate/tests/files/nodal_pendulum.toml"


@pytest.fixture(scope="module")
def model() -> lp.Model:
    return lp.Model.load(MODEL)


@pytest.fixture(scope="module")
def run(model: lp.Model) -> lp.Simulation:
    return model.simulate(turns=1, transient=0, samples=60, tolerance="1e-7 m", states=True)


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory):
    """The folder of the same run by the command."""
    folder = tmp_path_factory.mktemp("run")
    ended = command("simulate", str(MODEL), *TURNS, "--states", "--out", "run", cwd=folder)
    assert ended.returncode == 0, ended.stderr
    return folder / "run"


def test_analytic_states_of_the_crank(run):
    assert list(run.states) == ["crank", "rod", "slider"]
    crank, angle = run.states["crank"], run.drive_angle_rad
    speed = 5000 * 2 * np.pi / 60
    # m, rad/s, m/s^2: round-off; the drive is followed exactly.
    np.testing.assert_allclose(crank.x_m, 0.025 * np.cos(angle), atol=1e-15)
    np.testing.assert_allclose(crank.y_m, 0.025 * np.sin(angle), atol=1e-15)
    np.testing.assert_allclose(crank.omega_rad_s, speed, rtol=1e-13)
    np.testing.assert_allclose(crank.ay_m_s2, -0.025 * speed**2 * np.sin(angle), atol=1e-9)
    np.testing.assert_array_equal(run.states["slider"].x_m, run["slider"])


def test_identity_orbit_and_contact_force_are_those_of_the_command(run, written):
    summary = json.loads((written / "summary.json").read_text(encoding="utf-8"))
    (expected,) = summary["orbits"]
    orbit, force_n = run.orbits["gudgeon"], run.contact_forces_n["gudgeon"]
    assert orbit.joint == expected["joint"] and orbit.radial_clearance_m == expected["radial_clearance_m"] == 0.3e-3
    np.testing.assert_array_equal(orbit.x_m, expected["x_m"])
    np.testing.assert_array_equal(orbit.y_m, expected["y_m"])
    np.testing.assert_array_equal(force_n, summary["contact_forces"][0]["force_n"])
    # A pin that presses on its bearing is beyond the clearance, by no more than the largest penetration.
    penetration_m = orbit.eccentricity_m - orbit.radial_clearance_m
    assert (force_n > 0).any() and (penetration_m[force_n > 0] > 0).all()
    assert penetration_m.max() <= summary["joints"][0]["largest_penetration_m"]


def test_identity_spectra_are_those_of_the_command(run, written):
    with open(written / "spectrum.csv", encoding="utf-8", newline="") as file:
        names, *rows = csv.reader(file)
    expected = np.array(rows, dtype=float)
    assert list(run.spectra) == [*run, "gudgeon.contact_force"]
    assert names == ["order", "slider_m", "slider_velocity_m_s", "slider_acceleration_m_s2", "gudgeon_force_n", "gudgeon.contact_force_n"]
    for place, (name, spectrum) in enumerate(run.spectra.items(), start=1):
        np.testing.assert_array_equal(spectrum.order, expected[:, 0])
        np.testing.assert_array_equal(spectrum.amplitude, expected[:, place], err_msg=name)
    slider = run.spectra["slider"]
    assert (slider.of, slider.unit) == ("slider", "m")
    # Hz: the crank turns 5000 times a minute.
    np.testing.assert_allclose(slider.frequency_hz, slider.order * 5000 / 60, rtol=1e-14)
    # The last row is the first of the next turn.
    np.testing.assert_allclose(slider.mean, run["slider"][:-1].mean(), rtol=1e-14)
    np.testing.assert_allclose(slider.rms, np.sqrt(np.mean(run["slider"][:-1] ** 2)), rtol=1e-14)


def test_identity_lyapunov_exponent_is_that_of_the_command(model, tmp_path):
    arguments = ["--turns", "0.1", "--transient", "1", "--tolerance", "1e-6 m", "--lyapunov", "20", "--no-second-run"]
    ended = command("simulate", str(MODEL), *arguments, "--out", "run", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    text = (tmp_path / "run/summary.json").read_text(encoding="utf-8")
    run = model.simulate(turns=0.1, transient=1, tolerance="1e-6 m", lyapunov=20, second_run=False)
    assert run._native.summary_json() == text
    expected, found = json.loads(text)["lyapunov"], run.lyapunov
    assert found is not None and found.exponent_1_s == expected["exponent_1_s"] and found.kind == expected["kind"]
    assert found.interval_1_s == (expected["lower_1_s"], expected["upper_1_s"])
    assert len(found.growth) == 20
    # The exponent is the mean growth over the duration of a turn.
    np.testing.assert_allclose(found.growth.mean() / found.turn_s, found.exponent_1_s, rtol=1e-13)


@pytest.mark.skipif(os.name != "posix", reason="signals as on Unix")
def test_ctrl_c_ends_a_long_measurement_of_the_exponent(model):
    # By itself it ends after hours: a measurement that does not hear the signal ends the tests, with a trace.
    faulthandler.dump_traceback_later(PATIENCE_S, exit=True)
    timer = threading.Timer(0.5, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        model.simulate(turns=0.1, transient=0, tolerance="1e-6 m", second_run=False, lyapunov=1_000_000)
    faulthandler.cancel_dump_traceback_later()


def test_nothing_is_measured_that_nobody_asked_for(run):
    assert run.lyapunov is None and run.measured == ()


def test_identity_measured_curves_are_compared_as_by_the_command(model, run, tmp_path):
    # At the rows of the history, where nothing is interpolated, 0.1 mm too far out.
    rows = zip(np.degrees(run.drive_angle_rad[1:50:7]), 1e3 * run["slider"][1:50:7] + 0.1)
    text = "angle [deg], slider [mm]\n" + "".join(f"{angle!r}, {value!r}\n" for angle, value in ((float(a), float(v)) for a, v in rows))
    (tmp_path / "stand.csv").write_text(text, encoding="utf-8")
    ended = command("simulate", str(MODEL), *TURNS, "--measured", str(tmp_path / "stand.csv"), "--out", "run", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    again = model.simulate(turns=1, transient=0, samples=60, tolerance="1e-7 m", measured=[tmp_path / "stand.csv"])
    assert again._native.summary_json() == (tmp_path / "run/summary.json").read_text(encoding="utf-8")
    (curve,) = again.measured
    assert (curve.output, curve.unit, curve.abscissa, len(curve.at)) == ("slider", "m", "drive_angle", 7)
    # m: the round-off of angles in degrees, times the speed of the slider over the angle.
    np.testing.assert_allclose(curve.residual, 1e-4, atol=1e-12)
    np.testing.assert_allclose(curve.rms, 1e-4, atol=1e-12)


def test_a_measured_curve_of_no_output_is_refused(model, tmp_path):
    (tmp_path / "stand.csv").write_text("time [s], slyder [mm]\n0, 1\n", encoding="utf-8")
    with pytest.raises(lp.LoosepinError, match="did you mean 'slider'") as refused:
        model.simulate(turns=0.1, transient=0, measured=[tmp_path / "stand.csv"])
    assert refused.value.diagnostics[0].file.endswith("stand.csv") and refused.value.diagnostics[0].line == 1


def test_identity_implicit_integrator_is_that_of_the_command(tmp_path):
    arguments = ["--turns", "0.05", "--transient", "0", "--samples", "100", "--tolerance", "1e-6 m", "--no-second-run"]
    ended = command("simulate", str(PENDULUM), *arguments, "--integrator", "implicit", "--out", "run", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    settings = {"turns": 0.05, "transient": 0, "samples": 100, "tolerance": "1e-6 m", "second_run": False}
    run = lp.Model.load(PENDULUM).simulate(**settings, integrator="implicit")
    assert run._native.summary_json() == (tmp_path / "run/summary.json").read_text(encoding="utf-8")
    explicit = lp.Model.load(PENDULUM).simulate(**settings)
    assert run.summary["settings"]["method"] != explicit.summary["settings"]["method"]


def test_arguments_that_are_wrong_are_named(model):
    with pytest.raises(ValueError, match="integrator 'euler'; must be 'explicit' or 'implicit'"):
        model.simulate(integrator="euler")
    with pytest.raises(ValueError, match="lyapunov 19; must be between 20 and 1000000"):
        model.simulate(lyapunov=19)
    with pytest.raises(lp.LoosepinError, match="hint: omit integrator"):
        model.simulate(turns=0.1, integrator="implicit")
    with pytest.raises(lp.LoosepinError, match="hint: omit lyapunov"):
        model.simulate(turns=0.1, lyapunov=20, set={"joint.gudgeon.radial_clearance": "0 mm"})
    with pytest.raises(lp.LoosepinError, match="missing.csv"):
        model.simulate(turns=0.1, measured=["missing.csv"])
