"""Numbers of a result as plain records: bounds and curves."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class BoundEnd:
    """One end of a bound, in the unit of the bound."""

    value: float
    """Value of the statistic at the witness."""
    widened: float
    """The value moved outwards by the unresolved part: the bound to rely on."""
    error_sampling: float
    """Numerical error from the finite number of random samples."""
    error_optimisation: float
    """Numerical error from the search over the unknown (epistemic) inputs."""
    error_surrogate: float
    """Numerical error from a surrogate; 0 where none was used."""
    witness: dict[str, float | str]
    """The values of the unknown inputs that attain it, by path: numbers in SI, laws by name."""


@dataclass(frozen=True)
class Bound:
    """The least and the greatest value of a statistic over all unknown inputs."""

    output: str
    """Name of the output."""
    of: str
    """"value", or a deviation from the ideal motion: "total", "dimensional" or "clearance"."""
    at: str
    """"whole", "pose", "curve" (one pose of a whole curve) or "reduced"."""
    pose_rad: float | None
    """Angle of the drive, if the bound is at one."""
    reduction: str | None
    """Reduction of the cycle to one number: "maximum_absolute", "rms", ..."""
    statistic: str
    """"mean", "standard_deviation", "quantile", "probability_above", ..."""
    parameter: float | None
    """Probability of a quantile, limit of a probability in SI, share of a band."""
    treatment: str
    """"mixed", "probability_only" or "interval_only"."""
    reading: str
    """Reading of an interval: "fixed", "unknown_distribution" or "random_set"."""
    unit: str
    """SI unit of the values; "1" for a probability."""
    lower: BoundEnd
    """The least value."""
    upper: BoundEnd
    """The greatest value."""
    guarantee: str
    """"enclosure", "optimised", "sampled" or "inner" (the true range is at least this wide)."""
    confidence: float | None
    """Confidence of the sampling error, if the guarantee has one."""

    @property
    def widened(self) -> tuple[float, float]:
        """Both ends moved outwards by their numerical errors: the bound to rely on."""
        return (self.lower.widened, self.upper.widened)

    def __str__(self) -> str:
        at = self.reduction or (self.at if self.pose_rad is None else f"at {self.pose_rad:.4g} rad")
        statistic = self.statistic if self.parameter is None else f"{self.statistic} {self.parameter:.6g}"
        unit = "" if self.unit == "1" else f" {self.unit}"
        return (
            f"{self.output} {self.of} {at}: {statistic} in [{self.lower.widened:.6g}, {self.upper.widened:.6g}]{unit}"
            f" ({self.guarantee})"
        )


@dataclass(frozen=True, eq=False)
class Curve:
    """A deviation over the cycle; all arrays have one entry for each pose, SI."""

    output: str
    """Name of the output."""
    of: str
    """Which deviation."""
    unit: str
    """SI unit of the values."""
    pose_rad: Array
    """Angle of the drive."""
    ideal: Array
    """The output of the ideal mechanism."""
    nominal: Array
    """The deviation with nominal dimensions and unknown inputs in the middle of their ranges."""
    probabilities: tuple[float, float]
    """Probabilities of the ends of the bands."""
    random: tuple[Array, Array]
    """The band of the random scatter alone, with unknown inputs in the middle of their ranges."""
    mixed: tuple[Array, Array]
    """The band for all values of the unknown inputs, numerical error included."""


def bound(record: dict[str, Any]) -> Bound:
    """A bound of `summary.json`."""
    statistic, at, guarantee = dict(record["statistic"]), record["at"], record["guarantee"]
    kind = statistic.pop("kind")
    return Bound(
        output=record["output"],
        of=record["of"],
        at=at["kind"],
        pose_rad=at.get("pose_rad"),
        reduction=at.get("reduction"),
        statistic=kind,
        parameter=next(iter(statistic.values()), None),
        treatment=record["treatment"],
        reading=record["reading"],
        unit=record["unit"],
        lower=_end(record["lower"]),
        upper=_end(record["upper"]),
        guarantee=guarantee["kind"],
        confidence=guarantee.get("confidence"),
    )


def _end(record: dict[str, Any]) -> BoundEnd:
    error = record["error"]
    return BoundEnd(
        value=float(record["value_si"]),
        widened=float(record["widened_si"]),
        error_sampling=float(error["sampling_si"]),
        error_optimisation=float(error["optimisation_si"]),
        error_surrogate=float(error["surrogate_si"]),
        witness=record["witness"],
    )


def curve(record: dict[str, Any]) -> Curve:
    """A curve of `summary.json`."""

    def band(ends: dict[str, Any]) -> tuple[Array, Array]:
        return numbers(ends["lower_si"]), numbers(ends["upper_si"])

    lower, upper = record["probabilities"]
    return Curve(
        output=record["output"],
        of=record["of"],
        unit=record["unit"],
        pose_rad=numbers(record["pose_rad"]),
        ideal=numbers(record["ideal_si"]),
        nominal=numbers(record["nominal_si"]),
        probabilities=(float(lower), float(upper)),
        random=band(record["random"]),
        mixed=band(record["mixed"]),
    )


def numbers(values: Iterable[Any]) -> Array:
    """Numbers of `summary.json`, where those that are not finite are words."""
    return np.array([float(value) for value in values], dtype=np.float64)
