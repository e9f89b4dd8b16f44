"""The types are right: those of the package among themselves, those of the compiled part, those that a user sees."""

import subprocess
import sys
from pathlib import Path

import loosepin as lp

PACKAGE = Path(__file__).resolve().parents[1]

USER = """
import loosepin as lp
import numpy as np

model = lp.Model.load("model.toml")
run = model.simulate(turns=2, set={"joint.gudgeon.radial_clearance": "0.3 mm", "contact.steel_pin.restitution": 0.8})
peak: float = float(np.max(run["slider"]))
runs = model.evaluate({"joint.gudgeon.radial_clearance": np.linspace(1e-4, 3e-4, 5)}, ["slider total rms"], progress=False)
worst: float = float(np.max(runs["slider total rms"]))
result = lp.Study.from_dict({"model": model}).run("results", progress=lambda finished, most: None)
widest: tuple[float, float] = result.bounds[0].widened
found = lp.bounds(lambda x, u: x + u, {"x": lp.Normal(0, 1), "u": lp.Interval(-1, 1)}, ["mean", {"quantile": 0.975}])
reveal_type(found.bounds)
"""


EVERY_NAME = """
import logging

import loosepin as lp
import numpy as np
from matplotlib import pyplot
from numpy.typing import NDArray
from scipy import stats  # type: ignore[import-untyped]

version: str = lp.__version__
logging.getLogger("loosepin").setLevel(logging.INFO)
laws: list[lp.Normal | lp.TruncatedNormal | lp.Uniform | lp.Lognormal | lp.Triangular | lp.Beta] = [
    lp.Normal(0, 1), lp.TruncatedNormal(0, 1, -1, 1), lp.Uniform(0, 1), lp.Lognormal(2, 1), lp.Triangular(0, 1, 2), lp.Beta(2, 3)]
more: list[lp.Weibull | lp.Gamma | lp.Gumbel | lp.Exponential | lp.Discrete | lp.Empirical] = [
    lp.Weibull(2, 3), lp.Gamma(2, 3), lp.Gumbel(2, 3), lp.Exponential(3), lp.Discrete([1, 2], [0.5, 0.5]), lp.Empirical([1, 2])]
unknown: list[lp.Interval | lp.Periodic | lp.OneOf | lp.Evidence | lp.Fuzzy] = [
    lp.Interval(0, 1), lp.Periodic(0, 1), lp.OneOf([1, 2]), lp.Evidence([(0, 1, 1)]), lp.Fuzzy((0, 1, 2, 3))]
number: float = laws[0].ppf(0.975) + more[0].cdf(1.5)
array: float | NDArray[np.float64] = lp.Normal(lp.Interval(0, 1), 1).ppf([0.1, 0.2])
found: lp.FunctionBounds = lp.bounds(
    lambda x, y: x + y, {"x": lp.Normal(0, 1), "y": stats.norm(3, 1)}, seed=np.random.default_rng(1), accuracy=0.1)
seed: int | None = found.seed
bands: tuple[lp.Band, ...] = found.bands
boxes: tuple[lp.Box, ...] = found.boxes
reached: lp.AccuracyReached | None = found.accuracy
steps: tuple[lp.AccuracyStep, ...] = () if reached is None else reached.steps
try:
    model: lp.Model = lp.Model.load("model.toml")
except lp.LoosepinFileNotFoundError as missing:
    print(missing.filename, missing.errno, missing.code)
except lp.LoosepinValueError as wrong:
    each: lp.Diagnostic = wrong.diagnostics[0]
    print(each.message, each.hint)
except lp.LoosepinError as error:
    print(error.simulation)
except lp.LoosepinWarning:
    pass
outputs: tuple[lp.Output, ...] = model.outputs
parameters: tuple[lp.Parameter, ...] = model.parameters
run: lp.Simulation = model.simulate()
extremes: tuple[lp.Extreme, ...] = run.extremes
point: lp.ExtremePoint = extremes[0].maximum
figure, axes = pyplot.subplots()
run.plot("slider", ax=axes)
again: lp.Simulation = model.simulate(start=run, set={"contact.steel_pin.restitution": 0.6})
again.save("run", force=True)
stored: lp.Simulation = lp.Simulation.load("run")
series: dict[str, tuple[NDArray[np.float64], str]] = stored.series()
runs: lp.Simulations[lp.Simulation] = model.simulate_many({"joint.gudgeon.radial_clearance": np.linspace(1e-4, 3e-4, 5)}, start=run)
rows: int = len(runs.to_pandas())
states: dict[str, lp.BodyStates] = run.states
orbits: dict[str, lp.Orbit] = run.orbits
spectra: dict[str, lp.Spectrum] = run.spectra
lyapunov: lp.Lyapunov | None = run.lyapunov
measured: tuple[lp.MeasuredCurve, ...] = run.measured
motion: lp.Motion = model.motion()
moved: lp.OutputMotion = motion["slider"]
traced: lp.PointPath = model.motion(paths=["rod.small_end"]).paths["rod.small_end"]
corners: NDArray[np.float64] = traced.zone_m
check: lp.Check = model.check()
section: lp.CheckSection = check["joints"]
sweep: lp.Sweep = model.sweep("joint.gudgeon.radial_clearance", between=("0.1 mm", 3e-4), points=3)
sweep.save("sweep")
motion.save("motion")
loaded: tuple[lp.Sweep, lp.Motion] = lp.Sweep.load("sweep"), lp.Motion.load("motion")
swept: lp.SweptJoint = sweep.joints["gudgeon"]
wear: lp.Wear[lp.Simulation] = model.wear()
worn: lp.JointWear = wear["gudgeon"]
surface: lp.SurfaceWear = worn.surfaces["bearing"]
lives: dict[str, lp.SurfaceLife] = worn.life
study: lp.Study = lp.Study.from_dict({"model": model, "seed": None})
inputs: tuple[lp.StudyInput, ...] = study.inputs
evaluation: lp.Evaluation = study.evaluate(study.design(np.full((1, 3), 0.5)))
result: lp.StudyResult = study.run(threads=2, accuracy={"slider.mean": 1e-6, "slider.quantile": "2 um"}, budget=20_000)
samples: lp.Samples = result.samples
bound: lp.Bound = result.bounds[0]
end: lp.BoundEnd = bound.lower
curve: lp.Curve = result.curves[0]
same: bool = result == study.run() and hash(result) == hash(bound)
surrogates: lp.Surrogates | None = result.surrogates
if surrogates is not None:
    output: lp.SurrogateOutput = surrogates.outputs[0]
identification: lp.Identification[lp.Study] = study.identify(posterior=True)
unknowns: tuple[lp.Unknown, ...] = identification.unknowns
posterior: tuple[lp.Posterior, ...] = identification.posterior
plan: lp.MotionPlan = study.plan_motion()
"""


def check(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-m", *arguments], cwd=PACKAGE, capture_output=True, text=True)


def test_package_keeps_its_own_types():
    ended = check("mypy", "python/loosepin")
    assert ended.returncode == 0, ended.stdout


def test_stub_is_what_was_compiled():
    ended = check("mypy.stubtest", "loosepin._loosepin")
    assert ended.returncode == 0, ended.stdout


def test_users_get_types(tmp_path):
    (tmp_path / "user.py").write_text(USER, encoding="utf-8")
    ended = check("mypy", "--strict", str(tmp_path / "user.py"))
    assert 'Revealed type is "tuple[loosepin._records.Bound, ...]"' in ended.stdout.replace("builtins.tuple", "tuple"), ended.stdout
    assert ended.returncode == 0, ended.stdout


def test_users_can_use_every_name(tmp_path):
    # Not all names of the tutorial: all that there are.
    unused = [name for name in lp.__all__ if f"lp.{name}" not in EVERY_NAME]
    assert not unused
    (tmp_path / "every_name.py").write_text(EVERY_NAME, encoding="utf-8")
    ended = check("mypy", "--strict", str(tmp_path / "every_name.py"))
    assert ended.returncode == 0, ended.stdout


def test_wrong_uses_are_found(tmp_path):
    wrong = EVERY_NAME + 'bad: str = lp.Normal(0, 1).ppf(0.5)\nlp.bounds(lambda x: x, {"x": 3})\nlp.bounds(lambda x: x, {}, seed="a")\n'
    (tmp_path / "wrong.py").write_text(wrong, encoding="utf-8")
    ended = check("mypy", "--strict", str(tmp_path / "wrong.py"))
    assert ended.stdout.count("error:") == 3, ended.stdout
