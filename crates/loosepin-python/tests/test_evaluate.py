"""Arrays in, arrays out: runs at inputs that were chosen."""

import os
import signal
import subprocess
import sys

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, REPOSITORY, RANDOM_STUDY

CLEARANCE = "joint.gudgeon.radial_clearance"
LENGTHS = ("parameter.crank_length", "parameter.rod_length")
# m; both runs err by far less than the tolerance of 1e-8 m that they are given, over a tenth of a turn with one impact or two.
TOLERANCE_M = 5e-8
SHORT = {"turns": 0.1, "transient": 0, "samples": 40}
# s; a free machine takes milliseconds.
SOON_S = 30


@pytest.fixture(scope="module")
def study(desk):
    return lp.Study.load(desk / "study.toml")


@pytest.fixture(scope="module")
def model():
    return lp.Model.load(MODEL)


def random_design(study, runs, seed=1):
    return study.design(np.random.default_rng(seed).random((runs, len(study.inputs))))


def test_inputs_are_the_columns_of_a_design(study):
    assert [(each.name, each.unit, each.kind) for each in study.inputs] == [
        ("parameter.crank_length", "m", "random"),
        ("parameter.rod_length", "m", "random"),
        (CLEARANCE, "m", "unknown"),
    ]
    crank, _, clearance = study.inputs
    assert crank.words == "normal, mean 50 mm, standard deviation 0.02 mm"
    assert (crank.lower, crank.upper, crank.nominal) == (-np.inf, np.inf, 0.05)
    assert (clearance.words, clearance.lower, clearance.upper) == ("somewhere between 0.1 mm and 0.5 mm", 1e-4, 5e-4)


def test_analytic_a_design_follows_the_distributions(study):
    middle = study.design(np.full((1, 3), 0.5))
    np.testing.assert_allclose(middle, [[0.05, 0.12, 3e-4]], rtol=1e-15)
    # The normal quantile at 0.975 is 1.959963984540054.
    np.testing.assert_allclose(study.design([[0.975, 0.5, 0.25]]), [[0.05 + 1.959963984540054 * 2e-5, 0.12, 2e-4]], rtol=1e-12)


def test_analytic_a_design_has_the_correlations_and_uncertain_parameters_of_its_study(desk, model):
    text = (desk / "study.toml").read_text(encoding="utf-8")
    text = text.replace('standard_deviation = "0.02 mm"', 'standard_deviation = { interval = ["0.01 mm", "0.03 mm"] }')
    correlation = f"[[correlation]]\nof = {list(LENGTHS)}\nrank = 0.6\n[[ask]]"
    study = lp.Study.from_text(text.replace("[[ask]]", correlation, 1), model)
    parameter = "parameter.crank_length standard deviation"
    assert [(each.name, each.nominal) for each in study.inputs[2:]] == [(parameter, None), (CLEARANCE, 3e-4)]
    # Half way between its ends, at a quantile of 1.959963984540054 deviations.
    np.testing.assert_allclose(study.design([[0.975, 0.5, 0.5, 0.5]])[0, [0, 2]], [0.05 + 1.959963984540054 * 2e-5, 2e-5], rtol=1e-12)
    crank, rod = study.design(np.random.default_rng(1).random((4000, 4)))[:, :2].T
    ranks = np.corrcoef(crank.argsort().argsort(), rod.argsort().argsort())[0, 1]
    # The standard error of 4000 pairs is 0.01; that of the uncertain deviation does not change ranks much.
    assert abs(ranks - 0.6) < 0.05


def test_identity_rows_are_those_of_a_run_of_the_study(study, result):
    names = [each.name for each in study.inputs]
    table = np.column_stack([result.samples[name] for name in names])
    found = study.evaluate(table, progress=False)
    [name] = result.samples.outputs
    assert found[name].tobytes() == np.asarray(result.samples[name]).tobytes()
    for counter, values in found.counters.items():
        assert values.tobytes() == np.asarray(result.samples[counter]).tobytes(), counter
        assert found.units[counter] == result.samples.units[counter]
    assert set(found) == set(study.recorded) and found.units | study.recorded == found.units
    again = study.evaluate({name: result.samples[name] for name in reversed(names)}, progress=False)
    assert again[name].tobytes() == found[name].tobytes()


def test_identity_a_run_is_independent_of_the_others_and_of_threads(study):
    table = random_design(study, 70)
    one, two = (study.evaluate(table, threads=threads, progress=False) for threads in (1, 2))
    order = np.random.default_rng(2).permutation(70)
    mixed = study.evaluate(table[order], threads=2, progress=False)
    alone = study.evaluate(table[41:42], progress=False)
    for name in one:
        assert one[name].tobytes() == two[name].tobytes()
        assert one[name][order].tobytes() == mixed[name].tobytes()
        assert one[name][41:42].tobytes() == alone[name].tobytes()


def test_identity_a_model_is_evaluated_by_the_runs_of_its_study(study, model):
    """Nothing unknown is in the middle of an interval other than the value of the model: then the drawing is the same, and so are the bits."""
    without = lp.Study.from_text(RANDOM_STUDY, model)
    table = random_design(without, 12)
    inputs = dict(zip(LENGTHS, table.T))
    found = model.evaluate(inputs, ["slider total", "slider total maximum_absolute"], **SHORT, tolerance="1e-6 m", progress=False)
    due = without.evaluate(table, progress=False)
    for name in found:
        assert found[name].tobytes() == due[name].tobytes()
    np.testing.assert_array_equal(found.pose_rad["slider total"], due.pose_rad["slider total"])


def test_identity_a_run_is_that_of_simulate(model):
    """The single run integrates each step by itself and finds its ideal motion anew: another path, held to the tolerance of both."""
    values = {CLEARANCE: [1e-4, 4e-4], "parameter.rod_length": [0.1201, 0.118], "contact.steel_pin.restitution": 0.7}
    outputs = {"value": "slider value", "error": "slider clearance", "range": {"output": "slider", "of": "value", "reduce": "range"}}
    found = model.evaluate(values, outputs, **SHORT, progress=False)
    for run in range(2):
        of_run = {path: f"{value[run]!r} m" for path, value in values.items() if isinstance(value, list)}
        single = model.simulate(**SHORT, tolerance="1e-8 m", second_run=False, set=of_run | {"contact.steel_pin.restitution": 0.7})
        assert len(single["slider"]) == found["value"].shape[1]
        np.testing.assert_allclose(found["value"][run], single["slider"], rtol=0, atol=TOLERANCE_M)
        np.testing.assert_allclose(found["error"][run], single.deviation["slider"], rtol=0, atol=TOLERANCE_M)
        assert found.counters["contacts gudgeon"][run] == single.summary["joints"][0]["contacts"]
    # Ranges are those within the steps, which rows only come near to.
    assert np.all(found["range"] >= np.ptp(found["value"], axis=1) - TOLERANCE_M)


def test_identity_the_drawing_is_the_model_whatever_the_other_runs_are(model):
    ask = dict(SHORT, tolerance="1e-6 m", progress=False)
    lengths = np.array([0.1195, 0.12, 0.1205])
    many = model.evaluate({"parameter.rod_length": lengths}, "slider total maximum_absolute", **ask)
    for run, length in enumerate(lengths):
        one = model.evaluate({"parameter.rod_length": length}, "slider total maximum_absolute", **ask)
        assert one["slider total maximum_absolute"][0] == many["slider total maximum_absolute"][run]
    text = model.evaluate({"parameter.rod_length": "119.5 mm"}, "slider total maximum_absolute", **ask)
    assert text["slider total maximum_absolute"][0] == many["slider total maximum_absolute"][0]


def test_every_parameter_can_be_set_to_its_value(model):
    known = {each.name: (each.unit, each.nominal) for each in model.parameters}
    assert known[CLEARANCE] == ("m", 3e-4) and known["contact.steel_pin.restitution"] == ("1", 0.8)
    as_it_is = model.evaluate({CLEARANCE: 3e-4}, "slider value", **SHORT, progress=False)
    inputs = {name: nominal for name, (_, nominal) in known.items() if name != "drive.crank.start_angle"}
    assert model.evaluate(inputs, "slider value", **SHORT, progress=False)["slider value"].tobytes() == as_it_is["slider value"].tobytes()


def test_angles_reductions_and_laws(model):
    ask = dict(turns=1, transient=0, samples=8, tolerance="1e-6 m", progress=False)
    outputs = {"two": {"output": "slider", "of": "value", "poses": {"crank": [1.0, "90 deg"]}}, "one": "slider value at 1 rad"}
    found = model.evaluate({CLEARANCE: [2e-4, 3e-4]}, outputs, **ask)
    assert (found["two"].shape, found["one"].shape) == ((2, 2), (2,))
    np.testing.assert_allclose(found.pose_rad["two"], [1.0, np.pi / 2])
    assert found["two"][:, 0].tobytes() == found["one"].tobytes() and "one" not in found.pose_rad
    laws = [model.evaluate({CLEARANCE: 2e-4, "contact.steel_pin.law": law}, "slider value", **ask) for law in ("flores", "hunt-crossley")]
    assert not np.array_equal(laws[0]["slider value"], laws[1]["slider value"])


def test_failed_runs_are_not_a_number_with_their_reason(model, study):
    # A rod of 5 mm would pull the pin out of its hole.
    inputs = {CLEARANCE: [2e-4, 2e-4, 1e-9, 3e-4], "parameter.rod_length": [0.12, 0.005, 0.12, 0.12]}
    found = model.evaluate(inputs, ["slider total", "slider total rms"], **SHORT, progress=False)
    assert found.failed.tolist() == [False, True, True, False]
    assert found.reasons[0] is None
    assert "beyond any contact law" in found.reasons[1]
    assert found.reasons[2] == "the tolerance 1e-5 mm is larger than the smallest clearance, 1e-6 mm in joint 'gudgeon'"
    assert np.isnan(found["slider total"][found.failed]).all() and np.isfinite(found["slider total"][~found.failed]).all()
    assert np.isnan(found["slider total rms"]).tolist() == [False, True, True, False]
    assert found.counters["steps"].tolist()[1:3] == [0, 0]
    assert repr(found).startswith("<loosepin.Evaluation: 4 runs, 2 failed, inputs joint.gudgeon.radial_clearance, parameter.rod_length; outputs slider")
    assert "beyond any contact law" in found._repr_html_() and "<script" not in found._repr_html_()
    of_study = study.evaluate({"parameter.crank_length": 0.05, "parameter.rod_length": 0.12, CLEARANCE: [1e-9, 2e-4]}, progress=False)
    assert of_study.failed.tolist() == [True, False]


def test_a_tolerance_that_is_coarse_for_a_run_is_warned_of(model):
    with pytest.warns(lp.LoosepinWarning, match="is more than a hundredth of the smallest clearance, 0.1 mm in joint 'gudgeon'") as warned:
        model.evaluate({CLEARANCE: [3e-4, 1e-4]}, "slider value", **SHORT, tolerance="2e-6 m", progress=False)
    assert [each.filename for each in warned] == [__file__]


def test_frames_and_datasets(study):
    found = study.evaluate(random_design(study, 5), progress=False)
    frame = found.to_pandas()
    poses = [f"slider total at {round(angle, 9)} rad" for angle in found.pose_rad["slider total"].tolist()]
    assert list(frame.columns) == [*found.inputs, *poses, "slider total maximum_absolute", "reason"]
    np.testing.assert_array_equal(frame[poses].to_numpy(), found["slider total"])
    again = study.evaluate(frame[[each.name for each in study.inputs]], progress=False)
    assert again["slider total"].tobytes() == found["slider total"].tobytes()
    dataset = found.to_xarray()
    assert dataset["slider total"].dims == ("run", "pose_rad") and dataset["slider total"].attrs == {"units": "m"}
    assert dataset[CLEARANCE].attrs == {"units": "m"} and dataset.sizes == {"run": 5, "pose_rad": 5}
    np.testing.assert_array_equal(dataset["slider total maximum_absolute"].values, found["slider total maximum_absolute"])


def test_laws_of_a_study_are_names_or_places(desk, model):
    text = (desk / "study.toml").read_text(encoding="utf-8")
    law = '"contact.steel_pin.law" = { any_of = ["lankarani-nikravesh", "flores"] }\n[[ask]]'
    study = lp.Study.from_text(text.replace("[[ask]]", law, 1), model)
    assert study.inputs[-1].laws == ("lankarani-nikravesh", "flores")
    inputs = {"parameter.crank_length": 0.05, "parameter.rod_length": 0.12, CLEARANCE: "0.4 mm"}
    words, places = (
        study.evaluate(inputs | {"contact.steel_pin.law": law}, progress=False) for law in (["flores", "lankarani-nikravesh"], [1, 0])
    )
    assert words["slider total"].tobytes() == places["slider total"].tobytes()
    assert words["slider total"][0].tobytes() != words["slider total"][1].tobytes()


def test_progress_counts_the_runs(study):
    told = []
    study.evaluate(random_design(study, 40), progress=lambda finished, most: told.append((finished, most)))
    assert told[-1] == (40, 40) and told == sorted(told)


def test_what_a_listener_raises_comes_out_unchanged(study):
    class Enough(Exception):
        pass

    def stop(finished, most):
        raise Enough("of this")

    with pytest.raises(Enough, match="of this"):
        study.evaluate(random_design(study, 40), progress=stop)


CHILD = """
import sys
import loosepin as lp
import numpy as np

def told(finished, most):
    if finished > 64:
        print("running", flush=True)

study = lp.Study.load(sys.argv[1])
try:
    study.evaluate(study.design(np.random.default_rng(1).random((200_000, 4))), threads=2, progress=told)
except KeyboardInterrupt as interrupt:
    print(interrupt, flush=True)
    sys.exit(130)
"""


@pytest.mark.skipif(os.name != "posix", reason="signals as on Unix")
def test_ctrl_c_ends_an_evaluation():
    long_study = REPOSITORY / "cases/slider_crank_worn_pin/study.toml"
    child = subprocess.Popen([sys.executable, "-c", CHILD, str(long_study)], stdout=subprocess.PIPE, text=True)
    assert child.stdout is not None and child.stdout.readline() == "running\n"
    child.send_signal(signal.SIGINT)
    printed, _ = child.communicate(timeout=SOON_S)
    assert child.returncode == 130
    last = printed.splitlines()[-1]
    assert last.startswith("interrupted after ") and last.endswith(" of 200000 runs; nothing is kept"), printed
