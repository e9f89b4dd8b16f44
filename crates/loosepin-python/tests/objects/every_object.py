"""An object of each public class, and another one of the same class that is not equal to it."""

import shutil
import tomllib
import warnings
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import loosepin as lp
import numpy as np
from conftest import MODEL, REPOSITORY, STUDY

SURROGATE = '[surrogate]\nkind = "chaos"\ndirect = "confirming"\ntraining_runs = 60\nconfirming_runs = 8\n'

# What is no object of its own: a text, a function, and exceptions, which are equal to themselves only.
NO_OBJECTS = {"__version__", "bounds", "LoosepinError", "LoosepinFileNotFoundError", "LoosepinValueError", "LoosepinWarning"}

LAWS = [
    (lp.Normal(3, 1), lp.Normal(3, 2)),
    (lp.TruncatedNormal(3, 1, 2, 5), lp.TruncatedNormal(3, 1, 2, 6)),
    (lp.Uniform(1, 2), lp.Uniform(1, 3)),
    (lp.Lognormal(3, 1), lp.Lognormal(3, 2)),
    (lp.Triangular(1, 2, 5), lp.Triangular(1, 3, 5)),
    (lp.Beta(2, 3, 1, 4), lp.Beta(2, 4, 1, 4)),
    (lp.Weibull(2, 3, 1), lp.Weibull(2, 3, 2)),
    (lp.Gamma(2, 3, 1), lp.Gamma(2, 3, 2)),
    (lp.Gumbel(2, 3), lp.Gumbel(2, 4)),
    (lp.Exponential(3, 1), lp.Exponential(3, 2)),
    (lp.Discrete([1, 2, 4], [0.2, 0.3, 0.5]), lp.Discrete([1, 2, 5], [0.2, 0.3, 0.5])),
    (lp.Empirical(np.array([1.0, 2.0, 4.0, 7.0])), lp.Empirical([1.0, 2.0, 4.0, 8.0])),
]
DESCRIPTIONS = [
    (lp.Interval(1, 2), lp.Interval(1, 3)),
    (lp.Periodic(1, 2), lp.Periodic(1, 3)),
    (lp.OneOf([1, 2]), lp.OneOf(np.array([1, 3]))),
    (lp.Evidence([(1, 2, 0.4), (2, 3, 0.6)]), lp.Evidence([(1, 2, 0.5), (2, 3, 0.5)])),
    (lp.Fuzzy((1, 2, 3, 4)), lp.Fuzzy((1, 2, 3, 5))),
]


@cache
def every_object():
    """By the name of the class."""
    model, study, result = of_files()
    inputs = study.design(np.full((2, len(study.inputs)), 0.5))
    evaluations = [study.evaluate(rows, progress=False) for rows in (inputs, inputs * 1.001)]
    simulations = [model.simulate(turns=0.25, transient=0, samples=samples, states=True) for samples in (60, 50)]
    other = lp.Study.from_text(study.text.replace("seed = 7", "seed = 8"), model).run(progress=False)
    saved = (result.surrogates, lp.Surrogates.from_text(other._native.surrogates_json()))
    asked = {"x": lp.Normal(0, 1), "u": lp.Interval(-1, 1)}
    found = [
        lp.bounds(lambda x, u: (x + u) * factor, asked, ["mean", "cdf"], outputs=[name], accuracy=0.2, seed=seed)
        for name, factor, seed in (("y", 1, 1), ("z", 2, 2))
    ]
    answers = identifications()
    full, other_full = full_runs()
    sweeps, wears = sweeps_and_wears()
    motions = [model.motion(set={"joint.gudgeon.radial_clearance": clearance}, paths=["rod.small_end"]) for clearance in ("0.3 mm", "0.4 mm")]
    checks = (model.check(), study.check())
    ends = [result.bounds[0].lower, result.bounds[0].upper]
    objects = {
        "Model": (model, lp.Model.from_text(model.text + "\n# another\n")),
        "Study": (study, lp.Study.from_text(study.text + "\n# another\n", model)),
        "StudyResult": (result, other),
        "Samples": (result.samples, other.samples),
        "Bound": (result.bounds[0], result.bounds[1]),
        "BoundEnd": tuple(ends),
        "Curve": (result.curves[0], replace(result.curves[0], nominal=result.curves[0].nominal + 1e-6)),
        "Surrogates": saved,
        "SurrogateOutput": (saved[0].outputs[0], saved[0].outputs[1]),
        "Simulation": tuple(simulations),
        "Extreme": simulations[0].extremes[:2],
        "ExtremePoint": (simulations[0].extremes[0].minimum, simulations[0].extremes[0].maximum),
        "Simulations": tuple(
            model.simulate_many({"joint.gudgeon.radial_clearance": [3e-4, last]}, turns=0.1, transient=0, samples=20, progress=False)
            for last in (4e-4, 5e-4)
        ),
        "BodyStates": (full.states["rod"], full.states["crank"]),
        "Orbit": (full.orbits["gudgeon"], other_full.orbits["gudgeon"]),
        "Spectrum": (full.spectra["slider"], full.spectra["gudgeon.contact_force"]),
        "Lyapunov": (full.lyapunov, other_full.lyapunov),
        "MeasuredCurve": (full.measured[0], other_full.measured[0]),
        "Motion": tuple(motions),
        "PointPath": tuple(motion.paths["rod.small_end"] for motion in motions),
        "OutputMotion": tuple(motion["slider"] for motion in motions),
        "Check": checks,
        "CheckSection": tuple(check.sections[0] for check in checks),
        "Sweep": sweeps,
        "SweptJoint": tuple(sweep.joints["gudgeon"] for sweep in sweeps),
        "Wear": wears,
        "JointWear": tuple(wear["gudgeon"] for wear in wears),
        "SurfaceWear": tuple(wear["gudgeon"].surfaces["bearing"] for wear in wears),
        "SurfaceLife": tuple(lp.SurfaceLife(*(np.full(shape, depth) for shape in (2, 2, (2, 3)))) for depth in (1e-9, 2e-9)),
        "Evaluation": tuple(evaluations),
        "Output": model.outputs[:2],
        "Parameter": model.parameters[:2],
        "StudyInput": study.inputs[:2],
        "FunctionBounds": tuple(found),
        "Band": found[0].bands[:2],
        "Box": (found[0].boxes[0], found[1].boxes[0]),
        "AccuracyReached": (found[0].accuracy, found[1].accuracy),
        "AccuracyStep": (found[0].accuracy.steps[0], found[1].accuracy.steps[0]),
        "Identification": answers,
        "Unknown": answers[0].unknowns[:2],
        "Posterior": tuple(lp.Posterior("a.b", "m", (0.2, 0.8), mean, 0.1, (0.4, 0.7), None) for mean in (0.5, 0.6)),
        "MotionPlan": tuple(lp.MotionPlan("a table", f'{{"features": [], "confidence": {level}}}') for level in (0.9, 0.95)),
        "Diagnostic": tuple(lp.Diagnostic("E0201", "error", words, None, None, None, None, words) for words in ("one", "two")),
    }
    return objects | {type(law).__name__: (law, changed) for law, changed in LAWS + DESCRIPTIONS}


@cache
def full_runs():
    """Two runs with everything that a run can hold."""
    model = lp.Model.load(MODEL)
    with TemporaryDirectory() as folder:
        measured = Path(folder) / "stand.csv"
        measured.write_text("angle [deg], slider [mm]\n30, 161.0\n60, 137.1\n90, 109.2\n", encoding="utf-8")
        setting = "joint.gudgeon.radial_clearance"
        return tuple(
            model.simulate(turns=1, transient=1, samples=72, states=True, lyapunov=20, measured=[measured], set={setting: clearance})
            for clearance in ("0.3 mm", "0.4 mm")
        )


@cache
def sweeps_and_wears():
    model = lp.Model.load(MODEL)
    over, few = "joint.gudgeon.radial_clearance", {"transient": 0, "turns": 2, "tolerance": "1e-7 m", "progress": False}
    sweeps = tuple(model.sweep(over, between=("0.1 mm", last), points=3, **few) for last in ("0.3 mm", "0.4 mm"))
    keys = tomllib.loads(model.text)
    keys["joint"]["gudgeon"] |= {"bearing_length": "20 mm", "wear": {"bearing": {"coefficient": "1e-15 m^2/N"}}}
    worn = lp.Model.from_dict(keys)
    wears = tuple(worn.wear(turns=0.5, transient=0, tolerance="1e-7 m", set={"wear.cycles": cycles}) for cycles in ("1e3", "2e3"))
    return sweeps, wears


@cache
def of_files():
    """A model, a study of it with everything that a result can hold, and this result."""
    model = lp.Model.load(MODEL)
    head, mark, asks = STUDY.partition("[[ask]]")
    study = lp.Study.from_text(head + SURROGATE + mark + asks.replace(', "contributors"', ""), model)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lp.LoosepinWarning)
        return model, study, study.run(progress=False)


@cache
def identifications():
    with TemporaryDirectory() as folder:
        for name in ["model.toml", "first.toml", "study.toml"]:
            shutil.copy(REPOSITORY / "cases/backlash_test" / name, Path(folder) / name)
        study = lp.Study.load(Path(folder) / "study.toml")
        return tuple(study.identify(confidence=level, progress=False) for level in (0.99, 0.9))
