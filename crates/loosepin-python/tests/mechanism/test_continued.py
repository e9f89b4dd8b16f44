"""A run that continues another one is the run in one go, as nearly as the integrator allows."""

import json
import pickle

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, REPOSITORY

CLEARANCE, RESTITUTION = "joint.gudgeon.radial_clearance", "contact.steel_pin.restitution"
# The pin of the model strikes for the first time some 0.1 turns after the start: here it is in contact, or has struck several times.
QUARTER = {"turns": 0.25, "transient": 0, "samples": 200, "second_run": False}


@pytest.fixture(scope="module")
def model() -> lp.Model:
    return lp.Model.load(MODEL)


def halves(model: lp.Model, turns: float, **arguments) -> tuple[lp.Simulation, lp.Simulation, lp.Simulation]:
    """A run in one go, its first half, and its second half continued from there."""
    fixed = {"transient": 0, "samples": 200, "second_run": False} | arguments
    whole = model.simulate(turns=2 * turns, **fixed)
    first = model.simulate(turns=turns, **fixed)
    return whole, first, model.simulate(turns=turns, start=first, **fixed)


def positions(run: lp.Simulation) -> np.ndarray:
    """Coordinates of the centres of mass of all bodies, m."""
    return np.array([values for states in run.states.values() for values in (states.x_m, states.y_m)])


# m; the tolerance of a position. Impacts amplify errors: two motions part as far as one of them is wrong, or some times further.
TOLERANCE = 1e-9
TIMES = 10
FILES = "crates/loosepin-simulate/tests/files"


# Play of pins, of a block in its guide and of teeth; friction with and without memory; flexible bodies; a control with an integral; the end
# in contact and in flight.
@pytest.mark.parametrize(
    ("case", "turns", "is_closed"),
    [
        ("cases/slider_crank_worn_pin/model.toml", 1.0, True),
        ("cases/slider_crank_guide/model.toml", 0.5, False),
        ("cases/four_bar_friction/model.toml", 1.0, True),
        ("cases/four_bar_three_clearances/model.toml", 0.25, True),
        ("cases/geared_four_bar_backlash/model.toml", 0.5, True),
        ("cases/flexible_slider_crank/model.toml", 0.1, True),
        (f"{FILES}/slider_crank_joint_friction.toml", 0.25, False),
        (f"{FILES}/two_link_arm_with_play.toml", 0.5, True),
    ],
)
def test_identity_two_turns_are_one_and_one_more(case, turns, is_closed):
    model = lp.Model.load(REPOSITORY / case)
    whole, first, second = halves(model, turns, states=True)
    finer = model.simulate(turns=2 * turns, transient=0, samples=200, second_run=False, states=True, tolerance="1e-10 m")
    rows, places = len(second.time_s), positions(whole)
    most = max(TOLERANCE, TIMES * float(np.abs(positions(finer) - places).max()))
    np.testing.assert_allclose(second.time_s, whole.time_s[-rows:], rtol=1e-12)
    assert np.abs(positions(second) - places[:, -rows:]).max() <= most < 1e-4 * np.ptp(places, axis=1).max()
    # It begins where the first one ended, to the last bit, and strikes as often as the run in one go.
    np.testing.assert_array_equal(positions(second)[:, 0], positions(first)[:, -1])
    assert second.time_s[0] == first.time_s[-1]
    assert len(first.impacts) + len(second.impacts) == len(whole.impacts) > 0
    assert any(first.summary["end_state"]["is_closed"]) == is_closed


def test_identity_the_same_of_a_mechanism_that_its_drives_move_alone(model):
    whole, first, second = halves(model, 0.5, set={CLEARANCE: 0.0})
    np.testing.assert_allclose(second["slider"], whole["slider"][-len(second.time_s) :], atol=1e-15)
    assert first.summary["end_state"]["coordinates_si"] == []


def test_a_continued_run_may_be_continued_stored_and_pickled(model, tmp_path):
    first = model.simulate(**QUARTER)
    second = model.simulate(start=first, **QUARTER)
    first.save(tmp_path / "first")
    for again in (pickle.loads(pickle.dumps(first)), lp.Simulation.load(tmp_path / "first")):
        np.testing.assert_array_equal(model.simulate(start=again, **QUARTER)["slider"], second["slider"])
    third = model.simulate(start=second, **QUARTER)
    assert third.time_s[0] == second.time_s[-1] == pytest.approx(2 * first.time_s[-1])
    settings = second.summary["settings"]
    assert settings["continued_at_s"] == first.time_s[-1] and "continued_at_s" not in first.summary["settings"]
    assert "repeat" not in second.summary, "no command makes it"


def test_the_energy_account_and_the_trust_begin_anew(model):
    first = model.simulate(turns=0.5, transient=0, samples=100)
    # In contact at the start: its energy is there as well.
    assert first.summary["end_state"]["is_closed"] == [True] or first.contact_forces_n["gudgeon"][-1] == 0
    second = model.simulate(turns=0.5, samples=100, start=first)
    assert second.summary["energy"]["relative_residual"] < 1e-5
    assert second.summary["trust"] != first.summary["trust"]


def test_contacts_and_loads_may_be_others_and_positions_may_not(model):
    first = model.simulate(**QUARTER)
    soft = model.simulate(start=first, set={RESTITUTION: 0.5}, **QUARTER)
    assert soft["slider"][0] == first["slider"][-1] and soft != model.simulate(start=first, **QUARTER)
    wrong = r"error\[E0706\]: 'joint.gudgeon.radial_clearance' is 0.4 mm, but 0.3 mm in the run that is continued"
    with pytest.raises(lp.LoosepinValueError, match=wrong) as refused:
        model.simulate(start=first, set={CLEARANCE: 4e-4}, **QUARTER)
    assert refused.value.code == "E0706"
    many = model.simulate_many({RESTITUTION: [0.5, 0.9]}, start=first, turns=0.25, samples=200, progress=False)
    np.testing.assert_array_equal(many[0]["slider"], soft["slider"])


def test_a_run_of_something_else_is_refused(model):
    other = lp.Model.load(REPOSITORY / "cases/four_bar_settling/model.toml").simulate(turns=0.1, transient=0, second_run=False)
    with pytest.raises(lp.LoosepinValueError, match="the run is that of another model: only this one has"):
        model.simulate(start=other)
    with pytest.raises(TypeError, match="start is a str; must be a loosepin.Simulation or None"):
        model.simulate(start="run")
    first = model.simulate(**QUARTER)
    for key, value, words in [
        ("rates_si", ["nan"] * 2, "the state holds a number that is not finite among its rates"),
        ("rates_si", [0.0], "the state has 1 rates, the mechanism"),
        ("contacts", ["gudgen"], "the state has a contact 'gudgen' where the mechanism has 'gudgeon'"),
        ("time_s", "inf", "not finite among its times"),
    ]:
        changed = json.loads(first._native.summary_json())
        if key == "rates_si" and len(value) == 2:
            value = ["nan"] * len(changed["end_state"][key])
        changed["end_state"][key] = value
        with pytest.raises(lp.LoosepinValueError, match=words):
            model.simulate(start=restored(changed))
    del changed["end_state"]
    with pytest.raises(lp.LoosepinValueError, match="holds no state at its end"):
        model.simulate(start=restored(changed))


def restored(summary: dict) -> lp.Simulation:
    return lp.Simulation(lp._loosepin.Simulation.from_parts((json.dumps(summary), None)))
