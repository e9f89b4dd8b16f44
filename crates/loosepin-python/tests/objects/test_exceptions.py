"""Errors are also the exceptions that Python's users expect."""

import copy
import errno
import pickle
from concurrent.futures import ProcessPoolExecutor

import loosepin as lp
import pytest
from conftest import MODEL, REPOSITORY, STUDY, write_study

MISSING = "nothing.toml"


def missing_model(folder):
    return lp.Model.load(folder / MISSING)


def missing_model_of_a_study(folder):
    (folder / "study.toml").write_text(STUDY.replace("model.toml", MISSING), encoding="utf-8")
    return lp.Study.load(folder / "study.toml")


CALLS = {
    "model": missing_model,
    "study": lambda folder: lp.Study.load(folder / MISSING),
    "model of a study": missing_model_of_a_study,
    "surrogates": lambda folder: lp.Surrogates.load(folder / MISSING),
}


@pytest.mark.parametrize("call", CALLS)
def test_a_file_that_is_not_there(call, tmp_path):
    for kind in (FileNotFoundError, OSError, lp.LoosepinError, lp.LoosepinFileNotFoundError):
        with pytest.raises(kind) as refused:
            CALLS[call](tmp_path)
        error = refused.value
        assert (error.errno, error.code) == (errno.ENOENT, "E0101")
        assert error.filename == str(tmp_path / MISSING)
        assert MISSING in str(error) and "there is no such file" in str(error) and "Errno" not in str(error)
        assert not isinstance(error, ValueError)


def test_a_missing_table_names_its_file(tmp_path):
    write_study(tmp_path, STUDY + '[[measured]]\nkind = "motion"\noutput = "slider"\nfeature = "range"\nvalue = "3 kg"\nerror = "1 mm"\n')
    with pytest.raises(ValueError):
        lp.Study.load(tmp_path / "study.toml")


def test_a_folder_in_place_of_a_file_is_no_missing_file(tmp_path):
    with pytest.raises(lp.LoosepinError) as refused:
        lp.Model.load(tmp_path)
    assert refused.value.code == "E0101" and not isinstance(refused.value, (FileNotFoundError, ValueError))


VALUES = {
    "syntax": lambda: lp.Model.from_text("name ="),
    "key": lambda: lp.Model.from_text('name = "x"\ngravety = 3\n'),
    "unit": lambda: lp.Model.load(MODEL).simulate(set={"joint.gudgeon.radial_clearance": 0.3}),
    "path": lambda: lp.Model.load(MODEL).simulate(set={"joint.gudgen.radial_clearance": "0.3 mm"}),
    "rule": lambda: lp.Model.load(MODEL).simulate(set={"joint.gudgeon.radial_clearance": "-0.3 mm"}),
    "tolerance": lambda: lp.Model.load(MODEL).simulate(tolerance="600 mm"),
    "distribution": lambda: lp.bounds(lambda x: x, {"x": lp.Normal(0, -1)}),
    "samples": lambda: lp.bounds(lambda x: x, {"x": lp.Normal(0, 1)}, inner=255),
    "kind of file": lambda: lp.Study.load(MODEL),
}


@pytest.mark.parametrize("call", VALUES)
def test_a_wrong_text_or_value(call):
    for kind in (ValueError, lp.LoosepinError, lp.LoosepinValueError):
        with pytest.raises(kind) as refused:
            VALUES[call]()
        assert refused.value.code is not None and refused.value.diagnostics


def test_what_is_no_fault_of_a_value_is_neither(tmp_path):
    study = lp.Study.load(write_study(tmp_path))
    with pytest.raises(lp.LoosepinError) as refused:
        study.run(tmp_path)
    assert refused.value.code == "E0901" and type(refused.value) is lp.LoosepinError


def test_a_run_that_failed_crosses_a_process_with_its_record():
    model = lp.Model.load(REPOSITORY / "cases/slider_crank_5000/model.toml")
    with pytest.warns(lp.LoosepinWarning, match="E0822"), pytest.raises(lp.LoosepinError, match="energy balance") as failed:
        model.simulate(tolerance="0.5 mm")
    assert failed.value.code == "E0820" and type(failed.value) is lp.LoosepinError
    same = pickle.loads(pickle.dumps(failed.value))
    assert same.simulation == failed.value.simulation and len(same.simulation.time_s) > 100


def test_they_cross_a_process(tmp_path):
    for call in (lambda: missing_model(tmp_path), VALUES["unit"]):
        with pytest.raises(lp.LoosepinError) as refused:
            call()
        error = refused.value
        for same in (pickle.loads(pickle.dumps(error)), copy.copy(error), copy.deepcopy(error)):
            assert type(same) is type(error) and str(same) == str(error)
            assert (same.code, same.diagnostics, same.args) == (error.code, error.diagnostics, error.args)
            assert getattr(same, "filename", None) == getattr(error, "filename", None)
            assert getattr(same, "errno", None) == getattr(error, "errno", None)
    with ProcessPoolExecutor(1) as workers, pytest.raises(FileNotFoundError) as refused:
        workers.submit(missing_model, tmp_path).result()
    assert refused.value.filename == str(tmp_path / MISSING) and refused.value.code == "E0101"


def test_an_exception_that_somebody_else_made_has_all_attributes():
    for kind in (lp.LoosepinError, lp.LoosepinValueError, lp.LoosepinFileNotFoundError):
        error = kind("no more")
        assert (str(error), error.code, error.diagnostics, error.simulation) == ("no more", None, (), None)
        assert type(pickle.loads(pickle.dumps(error))) is kind
