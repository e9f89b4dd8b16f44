"""How accurately a mechanism moves when its parts scatter and its joints have play.

    import loosepin as lp

    result = lp.Study.load("study.toml").run()
    print(result)
    result.report("report.html")

Numbers are SI unless a name says otherwise. Files and their keys are those of the command `loosepin`.
"""

from ._design import StudyInput
from ._evaluation import Evaluation
from ._function_bounds import AccuracyReached, AccuracyStep, Band, Box, FunctionBounds, bounds
from ._identification import Identification, MotionPlan, Posterior, Unknown
from ._inputs import (
    Beta,
    Discrete,
    Empirical,
    Evidence,
    Exponential,
    Fuzzy,
    Gamma,
    Gumbel,
    Interval,
    Lognormal,
    Normal,
    OneOf,
    Periodic,
    Triangular,
    TruncatedNormal,
    Uniform,
    Weibull,
)
from ._loosepin import Diagnostic, LoosepinError, __version__
from ._model import Model, Output, Parameter, Simulation
from ._objects.errors import LoosepinFileNotFoundError, LoosepinValueError
from ._records import Bound, BoundEnd, Curve, Extreme, ExtremePoint
from ._result import Samples, StudyResult
from ._mechanism.many_runs import Simulations
from ._mechanism.paths import PointPath
from ._mechanism.run_records import BodyStates, Lyapunov, MeasuredCurve, Orbit, Spectrum
from ._study import Study
from ._surrogates import SurrogateOutput, Surrogates
from ._mechanism.sweep import Sweep, SweptJoint
from ._warning import LoosepinWarning
from ._mechanism.wear import JointWear, SurfaceLife, SurfaceWear, Wear
from ._mechanism.without_runs import Check, CheckSection, Motion, OutputMotion

__all__ = [
    "__version__",
    "AccuracyReached",
    "AccuracyStep",
    "Band",
    "Beta",
    "BodyStates",
    "Bound",
    "BoundEnd",
    "bounds",
    "Box",
    "Check",
    "CheckSection",
    "Curve",
    "Diagnostic",
    "Discrete",
    "Empirical",
    "Evaluation",
    "Evidence",
    "Exponential",
    "Extreme",
    "ExtremePoint",
    "FunctionBounds",
    "Fuzzy",
    "Gamma",
    "Gumbel",
    "Identification",
    "Interval",
    "JointWear",
    "Lognormal",
    "LoosepinError",
    "LoosepinFileNotFoundError",
    "LoosepinValueError",
    "LoosepinWarning",
    "Lyapunov",
    "MeasuredCurve",
    "Model",
    "Motion",
    "MotionPlan",
    "Normal",
    "OneOf",
    "Orbit",
    "Output",
    "OutputMotion",
    "Parameter",
    "Periodic",
    "PointPath",
    "Posterior",
    "Samples",
    "Simulation",
    "Simulations",
    "Spectrum",
    "Study",
    "StudyInput",
    "StudyResult",
    "SurfaceLife",
    "SurfaceWear",
    "SurrogateOutput",
    "Surrogates",
    "Sweep",
    "SweptJoint",
    "Triangular",
    "TruncatedNormal",
    "Uniform",
    "Unknown",
    "Wear",
    "Weibull",
]
