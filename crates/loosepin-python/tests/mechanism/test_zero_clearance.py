"""A clearance that is zero in some runs: the joint has no play there, and the others are as they would be alone."""

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, REPOSITORY

CLEARANCE = "joint.gudgeon.radial_clearance"
VALUES = [0.0, 2e-4, 3e-4]


@pytest.fixture(scope="module")
def model() -> lp.Model:
    return lp.Model.load(MODEL)


def test_identity_a_sweep_from_zero_has_the_runs_of_one_without_it(model):
    arguments = {"transient": 1, "turns": 4, "progress": False}
    found = model.sweep(CLEARANCE, values=VALUES, **arguments)
    alone = model.sweep(CLEARANCE, values=VALUES[1:], **arguments)
    assert not found.failed.any()
    np.testing.assert_array_equal(found["slider"][1:], alone["slider"])
    np.testing.assert_array_equal(found.joints["gudgeon"].peak_force_n[1:], alone.joints["gudgeon"].peak_force_n)
    # Without play there is no deviation, and the motion repeats itself every turn.
    np.testing.assert_allclose(found["slider"][0], 0.0, atol=1e-15)
    assert found.period_turns[0] == 1 and found.joints["gudgeon"].impacts_per_turn[0] == 0
    between = model.sweep(CLEARANCE, between=(0.0, 3e-4), points=2, **arguments)
    np.testing.assert_array_equal(between["slider"][1], found["slider"][2])
    assert "gudgeon" in str(found) and lp.Sweep.__name__ in repr(found)


def test_identity_evaluations_at_zero_are_those_of_simulate(model):
    turn = {"turns": 1, "transient": 0}
    outputs = ["slider clearance maximum_absolute", "slider value maximum"]
    found = model.evaluate({CLEARANCE: VALUES}, outputs, **turn, progress=False)
    alone = model.evaluate({CLEARANCE: VALUES[1:]}, outputs, **turn, progress=False)
    assert not found.failed.any(), found.reasons
    for name in outputs:
        np.testing.assert_array_equal(found[name][1:], alone[name])
    run = model.simulate(**turn, set={CLEARANCE: 0.0}, second_run=False)
    assert found[outputs[0]][0] == pytest.approx(0.0, abs=1e-12)
    assert found[outputs[1]][0] == pytest.approx(run.extremes[0].maximum.value, abs=1e-9)
    np.testing.assert_array_equal(found.counters["contacts gudgeon"][0], 0)
    assert np.isnan(found.counters["peak_force gudgeon"][0]) and (found.counters["peak_force gudgeon"][1:] > 0).all()


def test_identity_a_model_without_play_is_evaluated_with_some(model):
    without = lp.Model.from_text(model.text.replace('radial_clearance = "0.3 mm"', 'radial_clearance = "0 mm"'))
    assert without.text != model.text
    outputs, turn = ["slider clearance maximum_absolute"], {"turns": 1, "transient": 0, "progress": False}
    found = without.evaluate({CLEARANCE: VALUES}, outputs, **turn)
    np.testing.assert_array_equal(found[outputs[0]], model.evaluate({CLEARANCE: VALUES}, outputs, **turn)[outputs[0]])
    assert (found.counters["peak_force gudgeon"][1:] > 0).all()


def test_several_joints_have_play_or_not(model):
    double = lp.Model.load(REPOSITORY / "cases/slider_crank_two_clearances/model.toml")
    play = [parameter.name for parameter in double.parameters if parameter.name.endswith("radial_clearance")][:2]
    name = f"{double.outputs[0].name} clearance maximum_absolute"
    inputs = {play[0]: [0.0, 1e-4, 0.0, 1e-4], play[1]: [0.0, 0.0, 1e-4, 1e-4]}
    found = double.evaluate(inputs, [name], turns=0.25, transient=0, progress=False)
    assert not found.failed.any(), found.reasons
    assert found[name][0] == pytest.approx(0.0, abs=1e-12) and (found[name][1:] > 1e-6).all()


def test_analytic_play_without_effect_is_proven_to_be_zero():
    elbow = lp.Model.load(REPOSITORY / "cases/five_bar_elbow_drive/model.toml")
    motion = elbow.motion()
    for name in ("apex x", "apex y"):
        # Both drives hold the left link, whose end the output is: no play of the apex moves it.
        assert (motion[name].worst_case == 0).all() and not np.signbit(motion[name].worst_case).any()
        assert all((ends == 0).all() for ends in motion[name].proven)
    assert "The play of 'apex' moves none of the outputs." in str(motion) and "not proven" not in str(motion)
    assert "No joint has play" not in str(motion)


def test_values_that_break_a_rule_are_told_before_any_run(model):
    broken_rule = r"run 1: joint 'gudgeon': radial clearance -0.1 mm; must be >= 0"
    outputs = ["slider total rms"]
    study = lp.Study.from_dict(
        {"name": "rule", "seed": 1, "cycle": {"recorded_turns": 0.1, "transient_turns": 0}, "epistemic": {CLEARANCE: {"interval": ["0.1 mm", "0.5 mm"]}},
         "ask": [{"output": "slider", "of": "total", "reduce": "rms", "statistics": ["mean"]}]}, model=model)
    for argument, call in [
        ("inputs", lambda: model.evaluate({CLEARANCE: [1e-4, -1e-4]}, outputs, progress=False)),
        ("inputs", lambda: model.simulate_many({CLEARANCE: [1e-4, -1e-4]}, progress=False)),
        ("inputs", lambda: study.evaluate({CLEARANCE: [1e-4, -1e-4]}, progress=False)),
        ("values", lambda: model.sweep(CLEARANCE, values=[1e-4, -1e-4], progress=False)),
    ]:
        with pytest.raises(lp.LoosepinValueError, match=f"{argument}: {broken_rule}") as refused:
            call()
        assert refused.value.code == "E0501"
    # A rule between two values as well: the pin is as large as its hole.
    with pytest.raises(lp.LoosepinValueError, match="inputs: run 0: .* must be below .*bearing radius"):
        model.simulate_many({CLEARANCE: [2e-4]}, set={"joint.gudgeon.bearing_radius": "0.1 mm"}, progress=False)
