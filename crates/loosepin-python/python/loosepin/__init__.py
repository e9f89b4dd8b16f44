"""How accurately a planar mechanism moves when its parts scatter and its joints have play.

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
from ._study import Study
from ._surrogates import SurrogateOutput, Surrogates
from ._warning import LoosepinWarning

__all__ = [
    "__version__",
    "AccuracyReached",
    "AccuracyStep",
    "Band",
    "Beta",
    "Bound",
    "BoundEnd",
    "bounds",
    "Box",
    "Diagnostic",
    "Curve",
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
    "Lognormal",
    "LoosepinError",
    "LoosepinFileNotFoundError",
    "LoosepinValueError",
    "LoosepinWarning",
    "Model",
    "MotionPlan",
    "Normal",
    "OneOf",
    "Output",
    "Parameter",
    "Periodic",
    "Posterior",
    "Samples",
    "Simulation",
    "Study",
    "StudyInput",
    "StudyResult",
    "SurrogateOutput",
    "Surrogates",
    "Triangular",
    "TruncatedNormal",
    "Uniform",
    "Unknown",
    "Weibull",
]
