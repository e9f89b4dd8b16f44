"""What objects say of themselves, which arguments have a code where they are wrong, and numbers beside texts."""

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL
from every_object import every_object

CLEARANCE = "joint.gudgeon.radial_clearance"
SHORT = {"turns": 0.1, "transient": 0, "samples": 20, "second_run": False}


@pytest.fixture(scope="module")
def model() -> lp.Model:
    return lp.Model.load(MODEL)


@pytest.mark.parametrize("name", sorted(every_object()))
def test_no_object_prints_whole_arrays(name):
    assert len(repr(every_object()[name][0])) < 2500


def test_a_record_shows_shape_first_and_last(model):
    run = model.simulate(**SHORT | {"states": True})
    orbit = run.orbits["gudgeon"]
    text = repr(orbit)
    assert text.startswith("Orbit(joint='gudgeon', radial_clearance_m=0.0003, x_m=<array of 3, ") or "x_m=array([" in text
    x_m = run.states["rod"].x_m
    assert f"x_m=<array of {len(x_m)}, {x_m[0]:.6g} ... {x_m[-1]:.6g}>" in repr(run.states["rod"]) or len(x_m) <= 4
    motion = model.motion()["slider"]
    assert "value=<array of 361, " in repr(motion) and len(repr(motion)) < 1500
    assert repr(lp.Normal(3, 1)).startswith("Normal(mean=3")


WRONG = {
    "samples": (lambda model: model.simulate(samples=0), "E0501", "samples 0; must be between 1 and 1000000"),
    "turns": (lambda model: model.simulate(turns=-1), "E0501", r"turns -1.0; must be a number in \(0, 1e6\]"),
    "integrator": (lambda model: model.simulate(integrator="fast"), "E0204", "integrator 'fast'; must be 'explicit' or 'implicit'"),
    "lyapunov": (lambda model: model.simulate(lyapunov=5), "E0501", "lyapunov 5; must be between 20 and 1000000"),
    "threads": (lambda model: model.sweep(CLEARANCE, values=[1e-4], threads=0), "E0501", "threads 0; must be between 1 and 1024"),
    "threads of many": (lambda model: model.simulate_many({CLEARANCE: [1e-4]}, threads=0), "E0501", "threads 0; must be at least 1"),
    "range": (lambda model: model.sweep(CLEARANCE), "E0205", "sweep needs either between or values"),
    "shape": (lambda model: model.sweep(CLEARANCE, values=[[1e-4]]), "E0203", r"values: shape \(1, 1\)"),
    "seed": (lambda model: lp.bounds(lambda x: x, {"x": lp.Normal(0, 1)}, ["mean"], seed=-1), "E0501", "seed -1; must be >= 0"),
    "set twice": (lambda model: model.simulate_many({CLEARANCE: [1e-4]}, set={CLEARANCE: 2e-4}), "E0409", "is one of the inputs as well"),
    "budget": (lambda model: lp.bounds(lambda x: x, {"x": lp.Normal(0, 1)}, ["mean"], accuracy=0.1, budget="1 min"), "E0301", "budget '1 min'; must be a number of runs"),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_impossible_values_are_loosepin_value_errors_with_a_code(model, wrong):
    call, code, words = WRONG[wrong]
    with pytest.raises(lp.LoosepinValueError, match=words) as refused:
        call(model)
    assert refused.value.code == code and refused.value.diagnostics[0].code == code
    assert str(refused.value).startswith(f"error[{code}]: ")


def test_a_number_of_si_and_a_text_of_the_file_are_told_apart(model):
    with pytest.raises(lp.LoosepinValueError, match="for example 0.5 mm; a number that is no text is in SI units"):
        model.simulate(set={CLEARANCE: "0.3"})
    with pytest.raises(lp.LoosepinValueError, match="inputs: run 1: .* 300 mm; must be below .*\nhint: .*; numbers are in SI units"):
        model.evaluate({CLEARANCE: [1e-4, 0.3]}, ["slider total rms"], progress=False)


def test_accuracy_and_budget_are_texts_or_numbers(desk):
    asked, inputs = ["mean", {"quantile": 0.9}], {"x": lp.Normal(0, 1)}
    found = [
        lp.bounds(lambda x: x, inputs, asked, accuracy=accuracy, budget=budget, seed=1)
        for accuracy, budget in [({"y.mean": 0.05}, 4000), (["y.mean=0.05"], "4000 runs"), ({"y.mean": "0.05"}, 4000)]
    ]
    assert found[0] == found[1] == found[2] and found[0].accuracy is not None
    study = lp.Study.load(desk / "study.toml")
    name = "slider.quantile"
    texts = study.run(accuracy=[f"{name}=30 um"], budget="2000 runs", progress=False)
    numbers = study.run(accuracy={name: 3e-5}, budget=2000, progress=False)
    assert texts.bounds == numbers.bounds and texts.summary["accuracy"] == numbers.summary["accuracy"]


def test_what_no_bound_has_is_an_error_with_what_there_is(desk, result):
    with pytest.raises(lp.LoosepinValueError, match="no bound has at='cycle'; must be one of 'curve', 'reduced'"):
        result.select(at="cycle")
    assert result.select(at="curve", statistic="quantile") == [], "each of them is there, and no bound has both"


def test_a_dataset_has_states_orbits_and_forces_with_units(model):
    run = model.simulate(**SHORT | {"states": True})
    dataset = run.to_xarray()
    for name, unit, values in [
        ("gudgeon.orbit_x", "m", run.orbits["gudgeon"].x_m),
        ("gudgeon.contact_force", "N", run.contact_forces_n["gudgeon"]),
        ("rod.ax_m_s2", "m/s^2", run.states["rod"].ax_m_s2),
        ("slider_deviation", "m", run.deviation["slider"]),
    ]:
        np.testing.assert_array_equal(dataset[name], values)
        assert dataset[name].attrs["units"] == unit and dataset[name].dims == ("time_s",)
    many = model.simulate_many({CLEARANCE: [0.0, 3e-4]}, **SHORT, progress=False)
    both = many.to_xarray()
    assert np.isnan(both["gudgeon.orbit_x"][0]).all(), "without play there is no orbit"
    np.testing.assert_array_equal(both["gudgeon.orbit_x"][1], many[1].orbits["gudgeon"].x_m)
    frame = many.to_pandas()
    assert list(frame.columns[:3]) == ["run", CLEARANCE, "time_s"] and len(frame) == 2 * len(many[0].time_s)
    np.testing.assert_array_equal(frame[frame["run"] == 1]["slider_m"], many[1]["slider"])


def test_many_runs_take_what_a_single_run_takes(model, tmp_path):
    table = tmp_path / "stand.csv"
    table.write_text("angle [deg], slider [mm]\n5, 169.5\n20, 166.1\n", encoding="utf-8")
    common = {**SHORT, "set": {"contact.steel_pin.restitution": 0.7}, "measured": [table]}
    (one,) = model.simulate_many({CLEARANCE: [2e-4]}, **common, progress=False)
    alone = model.simulate(**common | {"set": common["set"] | {CLEARANCE: 2e-4}})
    np.testing.assert_array_equal(one["slider"], alone["slider"])
    assert one.measured == alone.measured and len(one.measured) == 1


def test_a_time_before_the_record_is_told_how_to_be_mended(model, tmp_path):
    table = tmp_path / "stand.csv"
    table.write_text("time [ms], slider [mm]\n0.1, 169.5\n0.5, 166.1\n", encoding="utf-8")
    with pytest.raises(lp.LoosepinValueError, match="times count from the start of the run, and turns of start-up are not recorded") as refused:
        model.simulate(**SHORT | {"transient": 1}, measured=[table])
    assert "(transient 0)" in str(refused.value) and "--transient" not in str(refused.value)
    assert len(model.simulate(**SHORT, measured=[table]).measured) == 1
