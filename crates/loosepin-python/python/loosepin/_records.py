"""Numbers of a result as plain records: bounds and curves."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._objects.arrays import read_only
from ._objects.errors import refused
from ._objects.records import Record

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class BoundEnd(Record):
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


@dataclass(frozen=True, eq=False, repr=False)
class Bound(Record):
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
    """"enclosure", "optimised", "sampled", "inner" (the true range is at least this wide) or "finished_runs" (failed runs leave no bound of a
    mean or deviation: values are those of the finished runs)."""
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


@dataclass(frozen=True, eq=False, repr=False)
class Curve(Record):
    """A deviation over the cycle; all arrays have one entry for each pose, SI, and are read-only."""

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


@dataclass(frozen=True, eq=False, repr=False)
class ExtremePoint(Record):
    """A smallest or largest value of a run, and when it was."""

    value: float
    """The value, in the unit of the extreme."""
    time_s: float
    """Time since the start of the run."""
    drive_angle_rad: float
    """Angle of the drive, continuous over turns."""


@dataclass(frozen=True, eq=False, repr=False)
class Extreme(Record):
    """The smallest and the largest value of an output, or of its deviation, over the recorded time.

    They are located on the motion between the rows as well, so they lie outside of the values at the rows, or on them.
    """

    output: str
    """Name of the output."""
    of: str
    """"value", or "total" for the deviation (`Simulation.deviation` says from which motion)."""
    unit: str
    """SI unit of the values."""
    minimum: ExtremePoint
    """The smallest value."""
    maximum: ExtremePoint
    """The largest value."""


def extreme(record: dict[str, Any]) -> Extreme:
    """An extreme of the `summary.json` of a run."""

    def point(end: dict[str, Any]) -> ExtremePoint:
        return ExtremePoint(float(end["value_si"]), float(end["time_s"]), float(end["drive_angle_rad"]))

    return Extreme(record["name"], record["of"], record["unit"], point(record["minimum"]), point(record["maximum"]))


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
    return read_only(np.array([float(value) for value in values], dtype=np.float64))


def selected(bounds: Iterable[Bound], properties: Mapping[str, Any]) -> list[Bound]:
    """The bounds with these properties. Raises TypeError for a property that no bound has, ValueError for a value that none has."""
    bounds = tuple(bounds)
    for name in properties:
        if name not in Bound.__annotations__:
            raise TypeError(f"a bound has no property {name!r}; must be one of {', '.join(Bound.__annotations__)}")
    for name, value in properties.items():
        known = list(dict.fromkeys(getattr(each, name) for each in bounds if not isinstance(getattr(each, name), BoundEnd)))
        if known and value not in known:
            raise refused(f"no bound has {name}={value!r}; must be one of {', '.join(map(repr, known))}", "E0204")
    return [each for each in bounds if all(getattr(each, name) == properties[name] for name in properties)]
