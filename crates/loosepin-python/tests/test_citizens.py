"""Objects can be pickled, copied, compared and used as keys."""

import copy
import pickle

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL, REPOSITORY

STUDY = REPOSITORY / "cases/slider_crank_worn_pin/study.toml"


def again(thing):
    return pickle.loads(pickle.dumps(thing))


def test_a_model_is_its_text(tmp_path):
    model = lp.Model.load(MODEL)
    elsewhere = tmp_path / "other.toml"
    elsewhere.write_text(model.text, encoding="utf-8")
    for same in (again(model), copy.deepcopy(model), lp.Model.load(elsewhere)):
        assert same == model and hash(same) == hash(model) and {model: 1}[same] == 1
        assert [each.name for each in same.outputs] == [each.name for each in model.outputs]
    assert model != lp.Model.from_text(model.text + "\n# another\n") and model != model.text


def test_a_study_is_its_texts():
    study = lp.Study.load(STUDY)
    assert again(study) == study == copy.deepcopy(study) and hash(again(study)) == hash(study)
    assert study != lp.Study.from_text(study.text + "\n# another\n", study.model)


def test_an_error_crosses_a_process():
    with pytest.raises(lp.LoosepinError) as refused:
        lp.Model.from_text('name = "x"\ngravity = 3\n')
    error = refused.value
    for same in (again(error), copy.deepcopy(error)):
        assert str(same) == str(error) and same.code == error.code
        assert same.diagnostics == error.diagnostics and hash(same.diagnostics) == hash(error.diagnostics)


def test_an_evaluation_crosses_a_process():
    study = lp.Study.load(STUDY)
    runs = study.evaluate(study.design(np.full((2, len(study.inputs)), 0.5)), progress=False)
    same = again(runs)
    assert list(same) == list(runs) and same.reasons == runs.reasons
    for name, values in runs.items():
        np.testing.assert_array_equal(same[name], values)


def test_a_pickle_of_another_version_is_refused():
    made, (_, texts) = lp.Model.load(MODEL).__reduce__()
    with pytest.raises(ValueError, match="a model of loosepin 0.0.0; this is loosepin"):
        made("0.0.0", texts)
