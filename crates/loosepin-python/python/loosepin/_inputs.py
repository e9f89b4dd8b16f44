"""Uncertain inputs: distributions, intervals, lists and other descriptions.

A parameter of a distribution may be an `Interval` or another epistemic input: the distribution is then a probability box.
A distribution has the methods `cdf(x)` and `ppf(q)`, with the meaning of SciPy: a float for a number, an array for an array. Two inputs of
the same kind with the same numbers are equal, and have the same hash. Lists and arrays are kept as tuples.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ._objects.laws import Law, fixed
from ._objects.records import Record


class _Fixed:
    """A dataclass whose lists become tuples."""

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            object.__setattr__(self, name, fixed(value))


@dataclass(frozen=True)
class Interval(Record):
    """An unknown number between two ends."""

    lower: float
    upper: float


@dataclass(frozen=True)
class Periodic(Record):
    """An unknown number between two ends that are the same place, for example an angle from 0 to 2 pi."""

    lower: float
    upper: float


@dataclass(frozen=True)
class OneOf(Record, _Fixed):
    """An unknown number, one of a few."""

    values: Sequence[float]


@dataclass(frozen=True)
class Evidence(Record, _Fixed):
    """Intervals with masses that sum to 1 (Dempster-Shafer): elements = [(lower, upper, mass), ...]."""

    elements: Sequence[tuple[float, float, float]]


@dataclass(frozen=True)
class Fuzzy(Record, _Fixed):
    """A trapezoidal fuzzy number: possible between the outer corners, entirely so between the inner ones."""

    corners: tuple[float, float, float, float]


Unknown = Interval | Periodic | OneOf | Evidence | Fuzzy
"""Any epistemic input."""
Parameter = float | Unknown
"""A parameter of a distribution."""


@dataclass(frozen=True)
class Normal(Law):
    """Normal distribution."""

    mean: Parameter
    standard_deviation: Parameter


@dataclass(frozen=True)
class TruncatedNormal(Law):
    """Normal distribution, mean and standard deviation before it was cut at both ends."""

    mean: Parameter
    standard_deviation: Parameter
    lower: Parameter
    upper: Parameter


@dataclass(frozen=True)
class Uniform(Law):
    """Every value between the ends as likely as any other."""

    lower: Parameter
    upper: Parameter


@dataclass(frozen=True)
class Lognormal(Law):
    """Lognormal distribution; mean and standard deviation are those of the variable itself, not of its logarithm."""

    mean: Parameter
    standard_deviation: Parameter


@dataclass(frozen=True)
class Triangular(Law):
    """Density that rises from the lower end to the mode and falls to the upper end."""

    lower: Parameter
    mode: Parameter
    upper: Parameter


@dataclass(frozen=True)
class Beta(Law):
    """Beta distribution between two ends."""

    alpha: Parameter
    beta: Parameter
    lower: Parameter = 0.0
    upper: Parameter = 1.0


@dataclass(frozen=True)
class Weibull(Law):
    """Weibull distribution above a lower end."""

    shape: Parameter
    scale: Parameter
    lower: Parameter = 0.0


@dataclass(frozen=True)
class Gamma(Law):
    """Gamma distribution above a lower end."""

    shape: Parameter
    scale: Parameter
    lower: Parameter = 0.0


@dataclass(frozen=True)
class Gumbel(Law):
    """Gumbel distribution of largest values."""

    mode: Parameter
    scale: Parameter


@dataclass(frozen=True)
class Exponential(Law):
    """Exponential distribution above a lower end; the mean is that of the variable itself."""

    mean: Parameter
    lower: Parameter = 0.0


@dataclass(frozen=True)
class Discrete(Law, _Fixed):
    """One of a few values, with known probabilities."""

    values: Sequence[float]
    probabilities: Sequence[float]


@dataclass(frozen=True)
class Empirical(Law, _Fixed):
    """A measured sample: each of its values with the same probability, and no other."""

    values: Sequence[float]


Distribution = (
    Normal
    | TruncatedNormal
    | Uniform
    | Lognormal
    | Triangular
    | Beta
    | Weibull
    | Gamma
    | Gumbel
    | Exponential
    | Discrete
    | Empirical
)
"""Any random input."""
Input = Distribution | Unknown
"""An uncertain number."""
