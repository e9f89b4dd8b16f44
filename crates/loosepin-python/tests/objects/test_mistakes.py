"""Mistakes that would give wrong numbers without a word, and texts that say how to mend a call."""

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


def test_masked_values_are_refused(model):
    masked = np.ma.array([1e-4, 2e-4], mask=[False, True])
    for call in (
        lambda: model.evaluate({CLEARANCE: masked}, ["slider total rms"], progress=False),
        lambda: model.simulate_many({CLEARANCE: masked}, progress=False),
        lambda: model.sweep(CLEARANCE, values=masked, progress=False),
    ):
        with pytest.raises(ValueError, match="some values are masked"):
            call()
    asked = {"x": lp.Uniform(0, 1)}
    runs = lp.bounds(lambda x: np.ma.array(x, mask=x > 0.9), asked, [{"probability_below": 0.5}], inner=64)
    assert runs.failed_runs == lp.bounds(lambda x: np.where(x > 0.9, np.nan, x), asked, [{"probability_below": 0.5}], inner=64).failed_runs > 0


def test_names_that_clash_are_refused(model):
    text = model.text.replace("[output.slider_velocity]", "[output.slider_deviation]")
    assert text != model.text
    clash = lp.Model.from_text(text)
    for dataset in (lambda: clash.simulate(**SHORT).to_xarray(), lambda: clash.simulate_many({CLEARANCE: [1e-4]}, progress=False).to_xarray()):
        with pytest.raises(ValueError, match="two variables of the Dataset would be called 'slider_deviation'"):
            dataset()
    with pytest.raises(ValueError, match="outputs: two have the same name"):
        lp.bounds(lambda x: np.stack([x, x], axis=1), {"x": lp.Uniform(0, 1)}, ["mean"], outputs=["a", "a"])


@pytest.mark.parametrize("name", ["Simulation", "Evaluation", "Samples", "Sweep", "Motion", "Wear", "Check"])
def test_a_name_that_is_not_there_is_told_with_those_that_are(name):
    one = every_object()[name][0]
    with pytest.raises(KeyError, match=f"there is no .* 'nothing'; must be one of {next(iter(one))}"):
        one["nothing"]
    assert "nothing" not in one and next(iter(one)) in one and list(one.keys()) == list(one)


def test_numbers_that_are_none_are_told_by_their_argument(model):
    for value in (float("nan"), float("inf"), 10**400):
        with pytest.raises(ValueError, match=f"set: '{CLEARANCE}' is .*; must be finite"):
            model.simulate(set={CLEARANCE: value})
    with pytest.raises(TypeError, match="must be the name of a contact law"):
        model.simulate(set={"contact.steel_pin.law": 1.0})
    with pytest.raises(ValueError, match="samples is too large"):
        model.simulate(samples=2**70)
    with pytest.raises(ValueError, match="outer is too large"):
        lp.bounds(lambda x: x, {"x": lp.Uniform(0, 1)}, ["mean"], outer=2**70)


def test_runs_that_are_kept_are_not_replaced_by_mistake(tmp_path):
    study = every_object()["Study"][0]
    with pytest.raises(ValueError, match="resume and force exclude each other"):
        study.run(tmp_path, resume=True, force=True)
    with pytest.raises(ValueError, match="resume needs the folder"):
        study.run(resume=True)


def test_an_angle_of_a_later_turn_is_that_of_the_later_turn(model):
    poses = {"slider": {"output": "slider", "of": "value", "poses": {"crank": ["90 deg", "450 deg"]}}}
    few = {"turns": 2, "samples": 36, "progress": False}
    asked = model.evaluate({}, poses, **few)
    whole = model.evaluate({}, ["slider value"], **few)
    places = [int(np.argmin(np.abs(whole.pose_rad["slider value"] - angle))) for angle in asked.pose_rad["slider"]]
    assert places == [9, 45]
    np.testing.assert_array_equal(asked["slider"][0], whole["slider value"][0, places])
    assert asked["slider"][0, 0] != asked["slider"][0, 1]
    # One turn does not pass there.
    with pytest.raises(lp.LoosepinError, match=r"asked at 450\.0* deg; the recorded 1 turns do not pass there"):
        model.evaluate({}, poses, **(few | {"turns": 1}))
