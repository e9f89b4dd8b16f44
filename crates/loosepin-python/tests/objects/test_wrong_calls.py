"""What is wrong with a call is said by the names of Python: each text names the argument, and none has an option of the command."""

import re

import loosepin as lp
import pytest
from conftest import STUDY, command
from every_object import every_object, of_files
from test_evaluate_errors import GOOD, OF_MODEL, OF_STUDY
from test_identification import STROKE

PATH = "joint.gudgeon.radial_clearance"
X = {"x": lp.Normal(0, 1)}
XY = X | {"y": lp.Normal(0, 1)}


def model():
    return of_files()[0]


def study():
    return of_files()[1]


def surrogates():
    return every_object()["Surrogates"][0]


def bounds(statistics=("mean",), **options):
    return lp.bounds(lambda x: x, options.pop("inputs", X), statistics, **options)


# The argument that the text must name, and the call.
CALLS = [
    ("path", lambda: lp.Model.load(3)),
    ("path", lambda: lp.Study.load(None)),
    ("path", lambda: lp.Surrogates.load(3)),
    ("text", lambda: lp.Model.from_text(3)),
    ("text", lambda: lp.Study.from_text(b"")),
    ("text", lambda: lp.Surrogates.from_text(3)),
    ("name", lambda: lp.Model.from_text("", name=3)),
    ("mapping", lambda: lp.Model.from_dict(3)),
    ("mapping", lambda: lp.Study.from_dict([1])),
    ("model", lambda: lp.Study.from_text(STUDY, model="model.toml")),
    ("model", lambda: lp.Study.from_dict({"name": "x", "model": 3})),
    ("turns", lambda: model().simulate(turns="two")),
    ("turns", lambda: model().simulate(turns=-1)),
    ("transient", lambda: model().simulate(transient=[1])),
    ("samples", lambda: model().simulate(samples=0.5)),
    ("samples", lambda: model().simulate(samples=0)),
    ("tolerance", lambda: model().simulate(tolerance=1e-9)),
    ("tolerance", lambda: model().simulate(tolerance="-1 m")),
    ("tolerance", lambda: model().simulate(tolerance="600 mm")),
    ("states", lambda: model().simulate(states="yes")),
    ("second_run", lambda: model().simulate(second_run=3)),
    ("set", lambda: model().simulate(set=3)),
    ("set", lambda: model().simulate(set={3: "1 mm"})),
    ("set", lambda: model().simulate(set={PATH: None})),
    ("set", lambda: model().simulate(set={"joint.gudgen.radial_clearance": "1 mm"})),
    ("set", lambda: model().simulate(set={PATH: "1 kg"})),
    ("set", lambda: model().simulate(set={PATH: "-1 mm"})),
    ("set", lambda: model().simulate(set={"contact.steel_pin.law": "herz"})),
    ("set", lambda: model().simulate(set={PATH: "1 mm", f" {PATH}": "2 mm"})),
    ("path", lambda: every_object()["Simulation"][0].report(3)),
    ("folder", lambda: study().run(3)),
    ("resume", lambda: study().run(resume="yes")),
    ("force", lambda: study().run(force=None)),
    ("threads", lambda: study().run(threads="2")),
    ("threads", lambda: study().run(threads=True)),
    ("threads", lambda: study().run(threads=0)),
    ("progress", lambda: study().run(progress=3)),
    ("accuracy", lambda: study().run(accuracy="1 um")),
    ("accuracy", lambda: study().run(accuracy=[3])),
    ("accuracy", lambda: study().run(accuracy=["rocker=1 um"])),
    ("accuracy", lambda: study().run(accuracy=["slider=1 kg"])),
    ("budget", lambda: study().run(budget=10)),
    ("budget", lambda: study().run(budget="10 runs")),
    ("budget", lambda: study().run(budget="10 m")),
    ("client", lambda: study().run(client=3)),
    ("property 'outptu'", lambda: every_object()["StudyResult"][0].select(outptu="slider")),
    ("points", lambda: study().identify(points=0)),
    ("points", lambda: study().identify(points=0.5)),
    ("confidence", lambda: study().identify(confidence="high")),
    ("confidence", lambda: study().identify(confidence=2)),
    ("specimen", lambda: study().identify(specimen=3)),
    ("posterior", lambda: study().identify(posterior="yes")),
    ("lengths", lambda: study().identify(lengths=1)),
    ("confidence", lambda: study().plan_motion(confidence="x")),
    ("function", lambda: lp.bounds(3, X)),
    ("function", lambda: lp.bounds(lambda x: "a", X)),
    ("function", lambda: study().bounds(3)),
    ("inputs", lambda: bounds(inputs=3)),
    ("inputs", lambda: bounds(inputs={3: lp.Normal(0, 1)})),
    ("input 'x'", lambda: bounds(inputs={"x": 3})),
    ("input 'x': mean", lambda: bounds(inputs={"x": lp.Normal("a", 1)})),
    ("input 'x': values", lambda: bounds(inputs={"x": lp.Discrete(3, [1])})),
    ("input 'x': interval", lambda: bounds(inputs={"x": lp.Interval(2, 1)})),
    ("input 'x': elements", lambda: bounds(inputs={"x": lp.Evidence([(1, 2)])})),
    ("input 'x': corners", lambda: bounds(inputs={"x": lp.Fuzzy((1, 2))})),
    ("statistics", lambda: bounds(3)),
    ("statistics", lambda: bounds("mean")),
    ("statistics", lambda: bounds([3])),
    ("statistic 'maen'", lambda: bounds(["maen"])),
    ("statistic 'quantile'", lambda: bounds([{"quantile": "x"}])),
    ("quantile", lambda: bounds([{"quantile": 2}])),
    ("outputs", lambda: bounds(outputs="y")),
    ("outputs", lambda: bounds(outputs=[3])),
    ("outputs", lambda: bounds(outputs=["a", "b"])),
    ("correlation", lambda: bounds(correlation=3)),
    ("correlation", lambda: bounds(correlation={("x", "z"): 0.3})),
    ("correlation", lambda: bounds(correlation={"xyz": 0.2})),
    ("correlation", lambda: lp.bounds(lambda x, y: x, XY, correlation={("x", "y"): "a"})),
    ("correlation", lambda: lp.bounds(lambda x, y: x, XY, correlation={("x", "y"): 2})),
    ("reading", lambda: bounds(reading="open")),
    ("reading", lambda: bounds(reading=3)),
    ("outer", lambda: bounds(outer=-1)),
    ("inner", lambda: bounds(inner=0.5)),
    ("inner", lambda: bounds(inner=255)),
    ("replicates", lambda: bounds(replicates=0)),
    ("confidence", lambda: bounds(confidence=2)),
    ("seed", lambda: bounds(seed="x")),
    ("accuracy", lambda: bounds(accuracy="x")),
    ("accuracy", lambda: bounds(accuracy={"z": 1})),
    ("budget", lambda: bounds(budget=3)),
    ("budget", lambda: bounds(accuracy=0.001, budget=3)),
    ("points", lambda: study().design("x")),
    ("output", lambda: surrogates().predict("x", {})),
    ("output 99", lambda: surrogates().predict(99, {})),
    ("values", lambda: surrogates().predict(0, 3)),
    ("outputs", lambda: model().evaluate({}, 3)),
    ("turns", lambda: model().evaluate({}, "slider total rms", turns="x")),
]
# An option, not the minus signs of a rule or an exponent.
OPTION = re.compile(r"--[a-z]")


def test_there_are_enough_of_them():
    assert len(CALLS) + len(OF_STUDY) + len(OF_MODEL) >= 50


@pytest.mark.parametrize("place", range(len(CALLS)))
def test_wrong_calls_name_the_argument(place):
    argument, call = CALLS[place]
    with pytest.raises((TypeError, ValueError, IndexError)) as refused:
        call()
    text = str(refused.value)
    assert re.search(rf"(^|[\s:]){re.escape(argument)}(?!\w)", text), text
    assert not OPTION.search(text), text
    for diagnostic in getattr(refused.value, "diagnostics", ()):
        assert not OPTION.search(str(diagnostic)) and not OPTION.search(f"{diagnostic.hint} {diagnostic.file}")


@pytest.mark.parametrize("wrong", [("inputs", name) for name in OF_STUDY] + [("model", name) for name in OF_MODEL])
def test_wrong_evaluations_have_no_options(wrong):
    of, name = wrong
    with pytest.raises((TypeError, ValueError)) as refused:
        if of == "inputs":
            study().evaluate(OF_STUDY[name][0], progress=False)
        else:
            model().evaluate(**GOOD | OF_MODEL[name][0], progress=False)
    assert not OPTION.search(str(refused.value))


@pytest.mark.parametrize("code", ["E0101", "E0303", "E0407", "E0804", "E0806", "E0815", "E0820", "E0824", "E0901", "E0907", "E0909", "E0910", "E0913"])
def test_explanations_are_those_of_python(code):
    text = lp.Diagnostic(code, "error", "x", None, None, None, None, "x").explanation
    assert text.endswith(".") and not OPTION.search(text)


def test_an_unknown_code_has_no_explanation():
    assert lp.Diagnostic("E9999", "error", "x", None, None, None, None, "x").explanation == ""


def test_hints_of_folders_are_those_of_python(tmp_path, desk, result):
    (tmp_path / "other").mkdir()
    (tmp_path / "other/notes.txt").write_text("mine", encoding="utf-8")
    own = lp.Study.load(desk / "study.toml")
    with pytest.raises(lp.LoosepinError) as refused:
        own.run(tmp_path / "other", progress=False)
    hint = "give another folder; force=True keeps these files, but overwrites those with the same names"
    assert refused.value.diagnostics[0].hint == hint and str(refused.value).endswith(f"hint: {hint}")
    ended = command("study", str(desk / "study.toml"), "--out", str(tmp_path / "other"), cwd=tmp_path)
    assert "--force keeps these files" in ended.stderr
    other = lp.Study.from_text(own.text.replace("seed = 7", "seed = 8"), own.model)
    with pytest.raises(lp.LoosepinError, match="hint: give another folder, or replace these results with force=True$"):
        other.run(desk / "python", progress=False)


def test_runs_that_are_kept_are_met_by_arguments(tmp_path, desk):
    own = lp.Study.load(desk / "study.toml")

    def stop(finished, most):
        if finished > 8:
            raise RuntimeError("no more")

    with pytest.raises(RuntimeError, match="no more"):
        own.run(tmp_path / "kept", threads=1, progress=stop)
    with pytest.raises(lp.LoosepinError, match="hint: resume=True continues with them, force=True starts again$") as refused:
        own.run(tmp_path / "kept", progress=False)
    assert refused.value.code == "E0910"


def test_hints_of_an_identification_are_those_of_python():
    measured = lp.Study.from_text(STROKE.replace('value = "100.3 mm"\n', ""), model())
    with pytest.raises(lp.LoosepinError) as refused:
        measured.identify(progress=False)
    assert "call plan_motion to see how much it would narrow the unknowns" in str(refused.value)
    assert not OPTION.search(str(refused.value))
    readings = every_object()["Identification"][0].narrowed()
    with pytest.raises(lp.LoosepinError, match="hint: omit lengths=True, or add features of a motion$"):
        readings.identify(lengths=True, progress=False)


def test_a_text_of_the_user_stays_as_it_is():
    with pytest.raises(lp.LoosepinError, match="'--set'"):
        model().evaluate({}, "--set", progress=False)
