"""Folders of results of simulations, sweeps and motions, written by the command or by Python, are read as what they were."""

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, command

CLEARANCE = "joint.gudgeon.radial_clearance"
SWEEP = {"between": ("0.1 mm", "0.3 mm"), "points": 3, "transient": 2, "turns": 2}


@pytest.fixture(scope="module")
def model() -> lp.Model:
    return lp.Model.load(MODEL)


@pytest.fixture(scope="module")
def made(model) -> dict[str, object]:
    """An object of each kind."""
    return {
        "simulate": model.simulate(turns=0.5, transient=0, samples=60, tolerance="1e-7 m", states=True),
        "sweep": model.sweep(CLEARANCE, **SWEEP, progress=False),
        "motion": model.motion(),
    }


@pytest.mark.parametrize("kind", ["simulate", "sweep", "motion"])
def test_identity_what_is_saved_is_loaded_and_shown_by_the_command(made, kind, tmp_path):
    before = made[kind]
    assert before.save(tmp_path / "kept") == tmp_path / "kept"
    after = type(before).load(tmp_path / "kept")
    assert after == before and str(after) == str(before) and list(after) == list(before)
    for name in before:
        if kind != "motion":
            np.testing.assert_array_equal(after[name], before[name])
    shown = command("report", "kept", cwd=tmp_path)
    assert shown.returncode == 0 and shown.stdout.strip() == str(before).strip()
    # The same once more changes nothing; something else is refused, and replaced by force.
    stamp = (tmp_path / "kept/summary.json").stat().st_mtime_ns
    before.save(tmp_path / "kept")
    assert (tmp_path / "kept/summary.json").stat().st_mtime_ns == stamp
    other = next(each for name, each in made.items() if name != kind)
    with pytest.raises(lp.LoosepinError, match="nothing is overwritten") as refused:
        other.save(tmp_path / "kept")
    assert "force=True" in str(refused.value) and "--force" not in str(refused.value)
    other.save(tmp_path / "kept", force=True)
    with pytest.raises(lp.LoosepinError, match="expected a"):
        type(before).load(tmp_path / "kept")


def test_identity_a_run_of_the_command_is_that_of_python(made, tmp_path):
    arguments = ["--turns", "0.5", "--transient", "0", "--samples", "60", "--tolerance", "1e-7 m", "--states"]
    ended = command("simulate", str(MODEL), *arguments, "--out", "run", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    stored, run = lp.Simulation.load(tmp_path / "run"), made["simulate"]
    assert list(stored.states) == ["crank", "rod", "slider"]
    for body, states in run.states.items():
        assert stored.states[body] == states
    for name, values in run.history.items():
        np.testing.assert_array_equal(stored.history[name], values)
    assert stored.summary["end_state"] == run.summary["end_state"]
    assert [path.name for path in sorted((tmp_path / "run").glob("*.csv"))] == ["history.csv", "impacts.csv"]


def test_wrong_folders_are_refused(made, tmp_path):
    with pytest.raises(lp.LoosepinError, match="there is no folder"):
        lp.Simulation.load(tmp_path / "nothing")
    with pytest.raises(TypeError, match="folder is a int; must be a path"):
        lp.Sweep.load(3)
    made["simulate"].save(tmp_path / "kept")
    history = tmp_path / "kept/history.csv"
    history.write_text(history.read_text(encoding="utf-8").replace("0.", "1.", 1), encoding="utf-8")
    with pytest.raises(lp.LoosepinError, match="history.csv is not the file that the simulation") as refused:
        lp.Simulation.load(tmp_path / "kept")
    assert "compute the result again into this folder with force=True" in str(refused.value)
