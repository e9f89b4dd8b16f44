"""Many recorded runs are the runs that `simulate` makes one by one; numbers and witnesses are taken as they are."""

import threading

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, STUDY

CLEARANCE, STEEL = "joint.gudgeon.radial_clearance", "contact.steel_pin.restitution"
SHORT = {"turns": 0.25, "transient": 0, "samples": 60}


@pytest.fixture(scope="module")
def model() -> lp.Model:
    return lp.Model.load(MODEL)


def test_identity_runs_are_those_of_simulate_for_any_number_of_threads(model):
    inputs = {CLEARANCE: np.array([1e-4, 2e-4, 3e-4]), STEEL: 0.8}
    told = []
    one = model.simulate_many(inputs, **SHORT, threads=1, progress=False)
    many = model.simulate_many(inputs, **SHORT, threads=3, progress=lambda *numbers: told.append(numbers))
    assert one == many and len(many) == 3 and not many.failed.any() and many.reasons == (None,) * 3
    assert told[-1] == (3, 3)
    for run, clearance in zip(many, ["0.1 mm", "0.2 mm", "0.3 mm"]):
        alone = model.simulate(**SHORT, second_run=False, set={CLEARANCE: clearance, STEEL: "0.8"})
        np.testing.assert_array_equal(run["slider"], alone["slider"])
        np.testing.assert_array_equal(run.deviation["slider"], alone.deviation["slider"])
    np.testing.assert_array_equal(many.inputs[CLEARANCE], inputs[CLEARANCE])
    np.testing.assert_array_equal(many.inputs[STEEL], [0.8] * 3)
    assert many.units == {CLEARANCE: "m", STEEL: "1"}


def test_a_run_that_fails_is_none_with_its_reason_and_not_a_number_in_xarray(model):
    runs = model.simulate_many({"parameter.rod_length": [0.12, 0.04, 0.13]}, **SHORT, progress=False)
    assert list(runs.failed) == [False, True, False]
    assert runs[1] is None and "error[" in runs.reasons[1]
    dataset = runs.to_xarray()
    assert dataset["slider"].dims == ("run", "row") and dataset["slider"].attrs["units"] == "m"
    np.testing.assert_array_equal(dataset["slider"][0], runs[0]["slider"])
    np.testing.assert_array_equal(dataset["slider_deviation"][2], runs[2].deviation["slider"])
    assert np.isnan(dataset["slider"][1]).all()


def test_laws_are_names_and_wrong_inputs_are_named(model):
    runs = model.simulate_many({"contact.steel_pin.law": "lankarani-nikravesh", CLEARANCE: [1e-4]}, **SHORT, progress=False)
    assert len(runs) == 1 and runs[0] is not None
    with pytest.raises(ValueError, match="inputs: .*'joint.gudgeon.radial_clearence'|inputs: the model has no quantity"):
        model.simulate_many({"joint.gudgeon.radial_clearence": [1e-4]}, **SHORT, progress=False)
    with pytest.raises(ValueError, match="threads 0; must be at least 1"):
        model.simulate_many({CLEARANCE: [1e-4]}, **SHORT, threads=0, progress=False)


def test_identity_paths_of_many_runs_are_those_of_simulate(model):
    runs = model.simulate_many({CLEARANCE: [1e-4, 3e-4]}, **SHORT, paths=["rod.small_end"], progress=False)
    alone = model.simulate(**SHORT, second_run=False, set={CLEARANCE: 3e-4}, paths=["rod.small_end"])
    for name in ("rod.small_end x", "rod.small_end y", "rod.small_end velocity x"):
        np.testing.assert_array_equal(runs[1][name], alone[name])
        np.testing.assert_array_equal(runs.to_xarray()[name][1], alone[name])
    assert not np.array_equal(runs[0]["rod.small_end y"], runs[1]["rod.small_end y"])
    with pytest.raises(lp.LoosepinError, match=r"paths: there is no point 'rod.small_edn'"):
        model.simulate_many({CLEARANCE: [1e-4]}, **SHORT, paths=["rod.small_edn"], progress=False)
    with pytest.raises(TypeError, match="paths is a str; must be a list of str"):
        model.simulate_many({CLEARANCE: [1e-4]}, **SHORT, paths="rod.small_end", progress=False)


def test_what_a_listener_raises_ends_the_runs(model):
    before = threading.active_count()

    def refuse(finished, most):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        model.simulate_many({CLEARANCE: np.linspace(1e-4, 3e-4, 40)}, **SHORT, threads=2, progress=refuse)
    assert threading.active_count() == before


def test_numbers_in_si_and_witnesses_are_settings(model):
    number = model.simulate(**SHORT, second_run=False, set={CLEARANCE: 3e-4})
    text = model.simulate(**SHORT, second_run=False, set={CLEARANCE: "0.3 mm"})
    np.testing.assert_array_equal(number["slider"], text["slider"])
    study = lp.Study.from_text(STUDY, model)
    witness = study.run(progress=False).bounds[0].lower.witness
    assert witness and all(isinstance(value, (float, str)) for value in witness.values())
    fed = model.simulate(**SHORT, second_run=False, set=witness)
    assert fed["slider"].shape == text["slider"].shape
    with pytest.raises(lp.LoosepinValueError, match="set: the model has no quantity 'joint.gudgeon.radial_clearence'"):
        model.simulate(set={"joint.gudgeon.radial_clearence": 3e-4})


def test_a_study_has_the_paths_of_further_points(model):
    study = lp.Study.from_text(STUDY, model)
    result = study.run(paths=["rod.small_end"], progress=False)
    assert [path["name"] for path in result.summary["paths"]["paths"]] == ["rod.small_end"]
    assert study.run(progress=False).summary.get("paths") is None
    with pytest.raises(lp.LoosepinError, match=r"paths: there is no point 'rod.small_edn'"):
        study.run(paths=["rod.small_edn"], progress=False)
