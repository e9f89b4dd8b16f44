"""Every public object can be pickled, copied, compared, hashed and shown; its arrays are its own, and it is none itself."""

import copy
import pickle
import sys

import loosepin as lp
import numpy as np
import pytest
from every_object import DESCRIPTIONS, LAWS, NO_OBJECTS, every_object

CLASSES = sorted(set(lp.__all__) - NO_OBJECTS)


def again(thing):
    return pickle.loads(pickle.dumps(thing))


def test_every_public_class_is_here():
    assert sorted(every_object()) == CLASSES
    for name, (one, other) in every_object().items():
        assert type(one) is type(other) is getattr(lp, name)


@pytest.mark.parametrize("name", CLASSES)
def test_copies_and_pickles_are_equal_and_others_are_not(name):
    one, other = every_object()[name]
    for same in (again(one), copy.copy(one), copy.deepcopy(one)):
        assert type(same) is type(one)
        assert same == one and not same != one
        assert hash(same) == hash(one) and {one: 1}[same] == 1
        assert repr(same) == repr(one)
    assert one != other and not one == other
    assert one != name
    assert len({one, other, copy.deepcopy(one)}) == 2


@pytest.mark.parametrize("name", CLASSES)
def test_repr_says_what_it_is(name):
    text = repr(every_object()[name][0])
    assert name in text and " object at 0x" not in text


@pytest.mark.parametrize("name", sorted(set(CLASSES) - {"Diagnostic"}))
def test_a_pickle_of_another_version_is_refused(name):
    made, (version, *parts) = every_object()[name][0].__reduce__()
    assert version == lp.__version__
    with pytest.raises(ValueError, match=r"^an? \w+ of loosepin 0.0.0; this is loosepin \d"):
        made("0.0.0", *parts)


@pytest.mark.parametrize("name", sorted(set(CLASSES) - {"Diagnostic"}))
def test_an_object_is_no_array(name):
    with pytest.raises(TypeError, match=rf"^an? {name} is not an array\nhint: "):
        np.asarray(every_object()[name][0])


def test_an_unpickled_result_gives_the_same_texts_and_pages(tmp_path):
    for name in ("StudyResult", "Simulation", "Identification", "Motion", "Sweep", "Wear"):
        one = every_object()[name][0]
        same = again(one)
        assert str(same) == str(one)
        for number, each in enumerate((one, same)):
            each.report(tmp_path / f"{name} {number}.html")
        assert (tmp_path / f"{name} 0.html").read_bytes() == (tmp_path / f"{name} 1.html").read_bytes()
    found = every_object()["Identification"][0]
    assert again(found).narrowed() == found.narrowed()
    result = every_object()["StudyResult"][0]
    assert again(result).to_pandas().equals(result.to_pandas()) and again(result).surrogates == result.surrogates


@pytest.mark.parametrize("name", ["StudyResult", "Simulation", "Identification"])
def test_nothing_is_run_again(name):
    pickled = pickle.dumps(every_object()[name][0])
    called = []
    sys.setprofile(lambda frame, event, what: called.append(what.__name__) if event == "c_call" else None)
    try:
        pickle.loads(pickled)
    finally:
        sys.setprofile(None)
    assert "from_parts" in called and not {"run", "simulate", "identify", "evaluate"} & set(called)


def arrays_of(thing, seen):
    """Every array that an object hands out: its attributes, what it holds by name, and those of its parts."""
    if isinstance(thing, np.ndarray):
        yield thing
    elif isinstance(thing, dict):
        for value in thing.values():
            yield from arrays_of(value, seen)
    elif isinstance(thing, (list, tuple)):
        for value in thing:
            yield from arrays_of(value, seen)
    elif type(thing).__module__.startswith("loosepin") and id(thing) not in seen:
        seen.add(id(thing))
        if hasattr(thing, "keys"):
            for key in thing:
                yield from arrays_of(thing[key], seen)
        for name in dir(thing):
            if not name.startswith("_") and not callable(value := getattr(thing, name)):
                yield from arrays_of(value, seen)


WITH_ARRAYS = [
    *("BodyStates", "Box", "Curve", "Evaluation", "FunctionBounds", "JointWear", "Lyapunov", "MeasuredCurve", "Motion", "Orbit"),
    *("OutputMotion", "PointPath", "Samples", "Simulation", "Simulations", "Spectrum", "StudyResult", "SurfaceLife", "SurfaceWear", "SurrogateOutput", "Surrogates"),
    *("Sweep", "SweptJoint", "Wear"),
]


def test_the_classes_with_arrays_are_known():
    assert [name for name in CLASSES if list(arrays_of(every_object()[name][0], set()))] == WITH_ARRAYS


@pytest.mark.parametrize("name", WITH_ARRAYS)
def test_arrays_cannot_be_changed(name):
    one = every_object()[name][0]
    for thing in (one, again(one), copy.deepcopy(one), copy.copy(one)):
        for array in arrays_of(thing, set()):
            assert not array.flags.writeable
            with pytest.raises(ValueError, match="read-only"):
                array[...] = array[::-1].copy()


@pytest.mark.parametrize(
    "name", ["Evaluation", "FunctionBounds", "Motion", "Samples", "Simulation", "StudyResult", "Sweep", "Wear"]
)
def test_frames_are_copies(name):
    one = every_object()[name][0]
    before = copy.deepcopy(one)
    frame = one.to_pandas()
    for column in frame.columns:
        frame.loc[:, column] = frame[column].iloc[0]
    if hasattr(one, "to_xarray"):
        dataset = one.to_xarray()
        for variable in dataset.data_vars.values():
            variable[...] = -5.0
            assert float(variable.values.ravel()[0]) == -5.0
    assert one == before


def test_answers_are_new_arrays_each_time():
    study, surrogates = every_object()["Study"][0], every_object()["Surrogates"][0]
    points = np.full((2, len(study.inputs)), 0.5)
    first = study.design(points)
    kept = first.copy()
    first[...] = 0
    np.testing.assert_array_equal(study.design(points), kept)
    values = {name: 0.0 for name in surrogates.inputs} | dict(zip(surrogates.inputs, kept[0]))
    predicted, _ = surrogates.predict(0, values)
    again_predicted = predicted.copy()
    predicted[...] = 0
    np.testing.assert_array_equal(surrogates.predict(0, values)[0], again_predicted)
    law = lp.Normal(3, 1)
    law.ppf([0.2, 0.3])[...] = 0
    assert law.ppf([0.2, 0.3])[0] > 2


def test_an_evaluation_does_not_hold_the_array_that_was_given():
    study = every_object()["Study"][0]
    rows = study.design(np.full((2, len(study.inputs)), 0.5))
    runs = study.evaluate(rows, progress=False)
    name = study.inputs[0].name
    kept = float(runs.inputs[name][0])
    rows[...] = 0
    assert runs.inputs[name][0] == kept > 0


def test_lists_of_inputs_cannot_be_changed_later():
    values = [1.0, 2.0, 4.0]
    law = lp.Empirical(values)
    values[0] = 0.0
    assert law == lp.Empirical(np.array([1.0, 2.0, 4.0])) and law.values == (1.0, 2.0, 4.0)
    for one, other in LAWS + DESCRIPTIONS:
        assert one != other and len({one, other}) == 2
    with pytest.raises(AttributeError):
        law.values = (1.0,)
