"""Frozen distributions of SciPy as those of the package. SciPy itself is not imported: who has such an object has done so."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Protocol

from .._inputs import Beta, Discrete, Exponential, Gamma, Gumbel, Lognormal, Normal, Triangular, TruncatedNormal, Uniform, Weibull

# Values of a discrete distribution, at most.
_MOST_VALUES = 10_000


class FrozenDistribution(Protocol):
    """A distribution of SciPy with its parameters, such as `scipy.stats.norm(3, 1)`."""

    dist: Any
    args: tuple[Any, ...]
    kwds: dict[str, Any]


_Shapes = dict[str, float]
# By the name in SciPy, from shapes, loc and scale.
_COUNTERPARTS: dict[str, Callable[[_Shapes, float, float], Any]] = {
    "norm": lambda _, loc, scale: Normal(loc, scale),
    "uniform": lambda _, loc, scale: Uniform(loc, loc + scale),
    "truncnorm": lambda shape, loc, scale: TruncatedNormal(loc, scale, loc + shape["a"] * scale, loc + shape["b"] * scale),
    "triang": lambda shape, loc, scale: Triangular(loc, loc + shape["c"] * scale, loc + scale),
    "beta": lambda shape, loc, scale: Beta(shape["a"], shape["b"], loc, loc + scale),
    "weibull_min": lambda shape, loc, scale: Weibull(shape["c"], scale, loc),
    "rayleigh": lambda _, loc, scale: Weibull(2.0, math.sqrt(2) * scale, loc),
    "gamma": lambda shape, loc, scale: Gamma(shape["a"], scale, loc),
    "chi2": lambda shape, loc, scale: Gamma(shape["df"] / 2, 2 * scale, loc),
    "gumbel_r": lambda _, loc, scale: Gumbel(loc, scale),
    "expon": lambda _, loc, scale: Exponential(loc + scale, loc),
}


def from_scipy(name: str, stated: Any) -> Any:
    """The law of the package for the input `name`, if a distribution of SciPy was stated; whatever else was stated as it is.

    Raises TypeError for a distribution that has no counterpart: none is approximated.
    """
    if type(stated).__module__.partition(".")[0] != "scipy":
        return stated
    distribution = getattr(stated, "dist", None)
    if distribution is None or not hasattr(stated, "kwds"):
        raise TypeError(
            f"input '{name}' is a {type(stated).__name__} of SciPy; must be a frozen distribution, for example scipy.stats.norm(3, 1)"
        )
    of_scipy = f"input '{name}' is scipy.stats.{distribution.name}"
    if hasattr(distribution, "pmf"):
        return _discrete(of_scipy, stated)
    shapes, loc, scale = _parameters(of_scipy, distribution, stated)
    if distribution.name == "lognorm" and loc == 0:
        # SciPy has the deviation of the logarithm and the median.
        mean = scale * math.exp(shapes["s"] ** 2 / 2)
        return Lognormal(mean, mean * math.sqrt(math.expm1(shapes["s"] ** 2)))
    if distribution.name not in _COUNTERPARTS:
        shifted = " with loc" if distribution.name == "lognorm" else ""
        raise TypeError(
            f"{of_scipy}{shifted}, which has no exact counterpart; known are {', '.join(sorted([*_COUNTERPARTS, 'lognorm']))} and "
            "discrete ones with finitely many values\nhint: loosepin.Empirical takes a sample of it, sample = law.rvs(10000)"
        )
    return _COUNTERPARTS[distribution.name](shapes, loc, scale)


def _parameters(of_scipy: str, distribution: Any, frozen: FrozenDistribution) -> tuple[_Shapes, float, float]:
    """Shapes by name, loc and scale, stated by place or by name."""
    shapes = [each.strip() for each in (distribution.shapes or "").split(",") if each.strip()]
    stated = {"loc": 0.0, "scale": 1.0} | dict(zip([*shapes, "loc", "scale"], frozen.args)) | frozen.kwds
    for key, value in stated.items():
        if getattr(value, "ndim", 0) or isinstance(value, (list, tuple)):
            raise TypeError(f"{of_scipy} with an array as {key}; must be one number: each input is one variable")
    numbers = {key: float(value) for key, value in stated.items()}
    return {key: numbers[key] for key in shapes}, numbers["loc"], numbers["scale"]


def _discrete(of_scipy: str, frozen: Any) -> Discrete:
    lower, upper = (float(end) for end in frozen.support())
    if not upper - lower < _MOST_VALUES:
        raise TypeError(
            f"{of_scipy} with values from {lower:g} to {upper:g}; a discrete distribution must have at most {_MOST_VALUES} values"
        )
    values = [lower + step for step in range(int(upper - lower) + 1)]
    masses = [(value, float(frozen.pmf(value))) for value in values]
    masses = [(value, mass) for value, mass in masses if mass > 0]
    return Discrete([value for value, _ in masses], [mass for _, mass in masses])
