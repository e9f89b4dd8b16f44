"""What is wrong with the arguments of an evaluation is said by their names, and of no file that nobody wrote."""

import loosepin as lp
import numpy as np
import pytest
from conftest import MODEL

CLEARANCE = "joint.gudgeon.radial_clearance"
COLUMNS = "parameter.crank_length, parameter.rod_length, joint.gudgeon.radial_clearance"
ROW = {"parameter.crank_length": 0.05, "parameter.rod_length": 0.12, CLEARANCE: 3e-4}

OF_STUDY = {
    "wrong name": (
        ROW | {"parameter.crank_lenght": 0.05},
        ValueError,
        "inputs: there is no input 'parameter.crank_lenght'\nhint: did you mean 'parameter.crank_length'?",
    ),
    "strange name": (ROW | {"xyz": 0.05}, ValueError, f"inputs: there is no input 'xyz'\nhint: the inputs are {COLUMNS}"),
    "missing input": (
        {CLEARANCE: 3e-4, "parameter.rod_length": 0.12},
        ValueError,
        "inputs: 'parameter.crank_length' missing\nhint: one number stands for all runs",
    ),
    "columns": (
        np.zeros((4, 2)),
        ValueError,
        f"inputs: shape (4, 2); must be (runs, 3), a column for each input\nhint: the columns are {COLUMNS}",
    ),
    "one row": ([0.05, 0.12, 3e-4], ValueError, "inputs: shape (3,); must be (runs, 3)\nhint: for one run write inputs[np.newaxis]"),
    "three dimensions": (
        np.zeros((2, 2, 3)),
        ValueError,
        f"inputs: shape (2, 2, 3); must be (runs, 3), a column for each input\nhint: the columns are {COLUMNS}",
    ),
    "not a number": (
        [[0.05, 0.12, 3e-4], [0.05, np.nan, 3e-4]],
        ValueError,
        "inputs: 'parameter.rod_length' is nan in run 1; must be finite",
    ),
    "infinite": (ROW | {CLEARANCE: [3e-4, np.inf]}, ValueError, f"inputs: '{CLEARANCE}' is inf in run 1; must be finite"),
    "texts": ([["0.05", "0.12", "3e-4"]], TypeError, "inputs: texts; must be numbers in SI units"),
    "truth values": (ROW | {CLEARANCE: [True, False]}, TypeError, f"inputs: '{CLEARANCE}': truth values; must be numbers in SI units"),
    "no runs": (np.zeros((0, 3)), ValueError, "inputs: the design has no runs; give at least one row"),
    "lengths": (
        ROW | {"parameter.rod_length": [0.12, 0.12], CLEARANCE: [3e-4, 3e-4, 3e-4]},
        ValueError,
        f"inputs: '{CLEARANCE}' has 3 values, but 'parameter.rod_length' has 2; must be as many, or one number",
    ),
    "two dimensions": (
        ROW | {CLEARANCE: [[3e-4]]},
        ValueError,
        f"inputs: '{CLEARANCE}': shape (1, 1); must be one number, or an array with one dimension",
    ),
    "unit": (
        ROW | {CLEARANCE: "0.3 s"},
        lp.LoosepinError,
        f"error[E0304]: inputs: {CLEARANCE} is a time; must be a length\nhint: for example 0.5 mm",
    ),
    "not allowed": (
        ROW | {CLEARANCE: -1e-4},
        lp.LoosepinError,
        "error[E0501]: inputs: joint 'gudgeon': radial clearance -0.1 mm; must be >= 0\nhint: the radial clearance is radius of the hole minus radius of the pin",
    ),
    "nothing": (None, TypeError, "inputs: values of type object; must be numbers in SI units"),
}

GOOD = {"inputs": {CLEARANCE: [2e-4, 3e-4]}, "outputs": "slider total rms"}
ERROR = {"output": "slider", "of": "total", "reduce": "rms"}

OF_MODEL = {
    "wrong path": (
        {"inputs": {"joint.gudgen.radial_clearance": 1e-4}},
        lp.LoosepinError,
        f"error[E0405]: inputs: the model has no quantity 'joint.gudgen.radial_clearance'\nhint: did you mean '{CLEARANCE}'?",
    ),
    "no unit": (
        {"inputs": {CLEARANCE: "0.3"}},
        lp.LoosepinError,
        f"error[E0303]: inputs: {CLEARANCE} is 0.3 without a unit; must be a length\nhint: for example 0.5 mm",
    ),
    "no mapping": ({"inputs": [1e-4]}, TypeError, "inputs is a list; must be a mapping from paths in the model to values"),
    "start": (
        {"inputs": {"drive.crank.start_angle": [0.1, 0.2]}},
        lp.LoosepinError,
        "error[E0608]: inputs: 'drive.crank.start_angle' is the start of the drive: every sample must start at the same position to be compared with the ideal motion\nhint: make the angle of a link uncertain instead, for example with the position of a point",
    ),
    "wrong law": (
        {"inputs": {"contact.steel_pin.law": "florez"}},
        lp.LoosepinError,
        "error[E0204]: inputs: 'contact.steel_pin.law' is 'florez', which is no contact law\nhint: did you mean 'flores'?",
    ),
    "several laws": (
        {"inputs": {"contact.steel_pin.law": ["flores"]}},
        TypeError,
        "inputs: 'contact.steel_pin.law' is a list; must be the name of a contact law, the same for all runs",
    ),
    "wrong name": (
        {"outputs": "slider totl rms"},
        lp.LoosepinError,
        "error[E0401]: outputs: no number or curve of this model is called 'slider totl rms'\nhint: did you mean 'slider total rms'?",
    ),
    "nothing asked": ({"outputs": []}, ValueError, "outputs is empty; give at least one"),
    "no question": (
        {"outputs": {"a": 3}},
        TypeError,
        "outputs: 'a' is a int; must be a text or a dict with the keys output, of, and at, poses or reduce",
    ),
    "wrong output": (
        {"outputs": {"a": ERROR | {"output": "slidr"}}},
        lp.LoosepinError,
        "error[E0401]: outputs 'a': the model has no output 'slidr'\nhint: did you mean 'slider'?",
    ),
    "wrong reduction": (
        {"outputs": {"a": ERROR | {"reduce": "rm"}}},
        lp.LoosepinError,
        'error[E0204]: outputs \'a\': reduce is \'rm\'; must be "maximum", "minimum", "maximum_absolute", "rms", "mean" or "range"\nhint: did you mean "rms"?',
    ),
    "statistics": (
        {"outputs": {"a": ERROR | {"statistics": ["mean"]}}},
        lp.LoosepinError,
        "error[E0201]: outputs 'a' has no key 'statistics'\nhint: its keys are output, component, of, at, poses, reduce",
    ),
    "angle not passed": (
        {"outputs": "slider total at 1.5 rad", "turns": 0.1, "transient": 0},
        lp.LoosepinError,
        "error[E0608]: outputs: output 'slider' is asked at 85.943669 deg; the recorded 0.1 turns do not pass there\nhint: record more turns, or ask for an angle that is passed",
    ),
    "tolerance": ({"tolerance": "3 kg"}, lp.LoosepinError, "error[E0304]: tolerance is a mass; must be a length\nhint: for example 0.5 mm"),
    "turns": ({"turns": 5000}, lp.LoosepinError, "error[E0501]: turns 5000.0; must be at most 1000"),
    "samples": (
        {"outputs": "slider total", "samples": 5000, "turns": 1},
        lp.LoosepinError,
        "error[E0608]: samples 5000 in each of 1 turns; a curve must have at most 2000 poses\nhint: ask for fewer samples; 180 in a turn give a good curve",
    ),
    "threads": ({"threads": 0}, ValueError, "threads 0; must be between 1 and 1024"),
}


def words(error: Exception, kind: type[Exception]) -> str:
    """The text of an error; of a plain ValueError in the table without its code, which it has all the same."""
    if kind is not ValueError:
        return str(error)
    assert isinstance(error, lp.LoosepinValueError) and error.code is not None
    return str(error).removeprefix(f"error[{error.code}]: ")


@pytest.mark.parametrize("wrong", OF_STUDY)
def test_wrong_inputs_of_a_study(desk, wrong):
    inputs, kind, text = OF_STUDY[wrong]
    with pytest.raises(kind) as refused:
        lp.Study.load(desk / "study.toml").evaluate(inputs, progress=False)
    assert words(refused.value, kind) == text


@pytest.mark.parametrize("wrong", OF_MODEL)
def test_wrong_arguments_of_a_model(wrong):
    arguments, kind, text = OF_MODEL[wrong]
    with pytest.raises(kind) as refused:
        lp.Model.load(MODEL).evaluate(**GOOD | arguments, progress=False)
    assert words(refused.value, kind) == text
    if kind is lp.LoosepinError:
        assert [each.line for each in refused.value.diagnostics] == [None] * len(refused.value.diagnostics)


def test_an_unknown_column_is_a_key_error(desk):
    found = lp.Study.load(desk / "study.toml").evaluate(ROW, progress=False)
    with pytest.raises(KeyError):
        found["slider totl"]


def test_wrong_points_of_a_design(desk):
    study = lp.Study.load(desk / "study.toml")
    with pytest.raises(ValueError, match=r"points: shape \(2,\); must be \(runs, 3\), a column for each input"):
        study.design([0.5, 0.5])
    with pytest.raises(ValueError, match="points: must be at least one row of numbers between 0 and 1, both excluded"):
        study.design([[0.5, 1.0, 0.5]])
