"""Results of a study."""

from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _loosepin
from ._extras import need

if TYPE_CHECKING:
    import matplotlib.figure
    import pandas
    import xarray

    from ._surrogates import Surrogates

Array = NDArray[np.float64]

_WORDS = {
    *("output", "of", "at", "reduction", "statistic", "treatment", "reading", "unit", "guarantee"),
    *("lower_witness", "upper_witness"),
}
"""Columns of `bounds.csv` that hold no numbers."""


@dataclass(frozen=True)
class BoundEnd:
    """One end of a bound, in the unit of the bound."""

    value: float
    """Value of the statistic at the witness."""
    widened: float
    """The value moved outwards by what was not resolved: the bound to rely on."""
    error_sampling: float
    """Numerical error from the finite number of random samples."""
    error_optimisation: float
    """Numerical error from the search over the epistemic inputs."""
    error_surrogate: float
    """Numerical error from a surrogate; 0 where none was used."""
    witness: dict[str, float | str]
    """The values of what is not known that attain it, by path: numbers in SI, laws by name."""


@dataclass(frozen=True)
class Bound:
    """The least and the greatest value of a statistic over everything that is not known."""

    output: str
    """Name of the output."""
    of: str
    """"value", or a deviation from the ideal motion: "total", "dimensional" or "clearance"."""
    at: str
    """"whole", "pose", "curve" (one pose of a whole curve) or "reduced"."""
    pose_rad: float | None
    """Angle of the drive, where the bound is at one."""
    reduction: str | None
    """How the cycle became one number: "maximum_absolute", "rms", ..."""
    statistic: str
    """"mean", "standard_deviation", "quantile", "probability_above", ..."""
    parameter: float | None
    """Probability of a quantile, limit of a probability in SI, share of a band."""
    treatment: str
    """"mixed", "probability_only" or "interval_only"."""
    reading: str
    """How an interval is read: "fixed", "unknown_distribution" or "random_set"."""
    unit: str
    """SI unit of the values; "1" for a probability."""
    lower: BoundEnd
    """The least value."""
    upper: BoundEnd
    """The greatest value."""
    guarantee: str
    """"enclosure", "optimised", "sampled" or "inner" (the true range is at least this wide)."""
    confidence: float | None
    """Confidence of the sampling error, where the guarantee has one."""

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
    """The deviation with nominal dimensions and what is not known in the middle."""
    probabilities: tuple[float, float]
    """Probabilities of the ends of the bands."""
    random: tuple[Array, Array]
    """The band of the random scatter alone, with unknown inputs in the middle of their ranges."""
    mixed: tuple[Array, Array]
    """The band for every value of what is not known, numerical error included."""


class Samples(Mapping[str, Any]):
    """Every run of a study: a NumPy array for each column of `runs.parquet`, by name."""

    def __init__(self, native: _loosepin.StudyResult, inputs: list[str]) -> None:
        """Use `StudyResult.samples`."""
        self._columns = {column.name: np.asarray(column.values) for column in native.samples()}
        self.units: dict[str, str] = {column.name: column.unit for column in native.samples()}
        """SI unit of each column; "1" for counts and words."""
        names = list(self._columns)
        self.inputs: dict[str, Any] = {name: self._columns[name] for name in inputs if name in self._columns}
        """The uncertain inputs by path; a law is a word."""
        last = max((names.index(name) for name in self.inputs), default=-1)
        self.outputs: dict[str, Any] = {name: self._columns[name] for name in names[last + 1 : names.index("status")]}
        """The scalar outputs, not-a-number where a run has none."""

    def __getitem__(self, name: str) -> Any:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def to_pandas(self) -> pandas.DataFrame:
        """The runs as a DataFrame, one a row."""
        pandas_ = need("pandas", "to_pandas()")
        frame: pandas.DataFrame = pandas_.DataFrame(self._columns, copy=False)
        return frame

    def __repr__(self) -> str:
        rows = len(next(iter(self._columns.values()), ()))
        return f"<loosepin.Samples: {rows} runs, inputs {', '.join(self.inputs)}; outputs {', '.join(self.outputs)}>"


class StudyResult:
    """A finished study: `print(result)` shows the tables of the terminal, `result.bounds` holds every bound."""

    def __init__(self, native: _loosepin.StudyResult) -> None:
        """Use `Study.run`."""
        self._native = native

    @property
    def name(self) -> str:
        """Name of the study."""
        return self._native.name

    @cached_property
    def summary(self) -> dict[str, Any]:
        """Everything, as `summary.json` has it; SI. What is not finite is "inf", "-inf" or "nan"."""
        summary: dict[str, Any] = json.loads(self._native.summary_json())
        return summary

    @cached_property
    def bounds(self) -> tuple[Bound, ...]:
        """Every bound, in the order of `bounds.csv`."""
        return tuple(_bound(bound) for bound in self.summary["bounds"])

    def select(self, **properties: Any) -> list[Bound]:
        """The bounds with these properties: result.select(output="slider", of="total", statistic="mean", at="reduced")."""
        return [bound for bound in self.bounds if all(getattr(bound, name) == properties[name] for name in properties)]

    @property
    def requirements(self) -> list[dict[str, Any]]:
        """The requirements with their `verdict`: "met", "promised", "not_met" or "undecided"."""
        requirements: list[dict[str, Any]] = self.summary["requirements"]
        return requirements

    @property
    def is_met(self) -> bool:
        """Whether all requirements are met for every value of what is not known, numerical error included.

        A requirement that a promise decides is not: it is "promised", for a share of the box.
        """
        return all(requirement["verdict"] == "met" for requirement in self.requirements)

    @property
    def promise(self) -> dict[str, Any] | None:
        """What is promised for a share of the box, as `summary.json` has it; nothing where the study promises nothing."""
        promise: dict[str, Any] | None = self.summary.get("promise")
        return promise

    @cached_property
    def curves(self) -> tuple[Curve, ...]:
        """The deviations over the cycle."""
        return tuple(_curve(curve) for curve in self.summary["curves"])

    @cached_property
    def samples(self) -> Samples:
        """Every run: inputs, outputs, what it was for, whether it failed and why, counters."""
        return Samples(self._native, [each["path"] for each in self.summary["inputs"]])

    @cached_property
    def surrogates(self) -> Surrogates | None:
        """Surrogates, where the study asks for them."""
        from ._surrogates import Surrogates

        text = self._native.surrogates_json()
        return None if text is None else Surrogates.from_text(text)

    def to_pandas(self) -> pandas.DataFrame:
        """Every bound as a row of a DataFrame, with the columns of `bounds.csv`."""
        pandas_ = need("pandas", "to_pandas()")
        names, *rows = csv.reader(io.StringIO(self._native.bounds_csv().decode(), newline=""))
        frame: pandas.DataFrame = pandas_.DataFrame(rows, columns=names)
        for name in names:
            if name not in _WORDS:
                # Python reads every number to the last bit, which pandas does not promise.
                frame[name] = [float(cell or "nan") for cell in frame[name]]
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """The curves as a Dataset over `pose_rad`, SI.

        `slider_total_nominal` is the nominal deviation; with the dimensions (pose_rad, end) `slider_total_random` and
        `slider_total_mixed` are bands (see `Curve`), and `slider_total_mean`, `slider_total_quantile_0.975` and so on the bounds of each
        statistic that was asked for, numerical error included.
        """
        xarray_ = need("xarray", "to_xarray()")
        variables: dict[str, Any] = {}
        for curve in self.curves:
            name = f"{curve.output}_{curve.of}".replace(" ", "_")
            unit = {"units": curve.unit}
            variables[f"{name}_nominal"] = ("pose_rad", curve.nominal, unit)
            for band, ends in (("random", curve.random), ("mixed", curve.mixed)):
                variables[f"{name}_{band}"] = (("pose_rad", "end"), np.stack(ends, axis=1), unit)
        for name, unit_symbol, ends_of_poses in self._bounds_over_poses():
            variables[name] = (("pose_rad", "end"), ends_of_poses, {"units": unit_symbol})
        coordinates: dict[str, Any] = {"end": ["lower", "upper"]}
        if self.curves:
            coordinates["pose_rad"] = ("pose_rad", self.curves[0].pose_rad, {"units": "rad"})
        dataset: xarray.Dataset = xarray_.Dataset(variables, coordinates, {"study": self.name})
        return dataset

    def _bounds_over_poses(self) -> Iterator[tuple[str, str, Array]]:
        """Name, unit and bounds of each statistic of each curve."""
        statistics: dict[str, list[Bound]] = {}
        first = self.bounds[0].reading if self.bounds else ""
        for bound in self.select(at="curve", treatment="mixed"):
            parameter = "" if bound.parameter is None else f"_{bound.parameter:.6g}"
            reading = "" if bound.reading == first else f"_{bound.reading}"
            name = f"{bound.output}_{bound.of}_{bound.statistic}{parameter}{reading}".replace(" ", "_")
            statistics.setdefault(name, []).append(bound)
        for name, bounds in statistics.items():
            yield name, bounds[0].unit, np.array([bound.widened for bound in bounds])

    def plot(self, kind: str | None = None, *, output: str | None = None, of: str | None = None) -> matplotlib.figure.Figure:
        """Draws a standard figure with matplotlib.

        kind: "curves" (the band of each deviation over the cycle with its bounds), "box" (bounds of distribution functions) or
        "contributors" (what the width of a band comes from: scatter in one colour, what is not known in another); by default
        the first of these that there is. output, of: one output or deviation alone.
        """
        from ._figures import study_figure

        return study_figure(self, kind, output, of)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the page that the command `loosepin study` writes: one file, readable without a network."""
        self._native.write_page(os.fspath(path))
        return Path(path)

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        runs = self.summary["counts"]["runs"]
        return f"<loosepin.StudyResult {self.name!r}: {len(self.bounds)} bounds from {runs} runs; print() shows them>"

    def _repr_html_(self) -> str:
        from ._html import study_html

        return study_html(self)


def _bound(record: dict[str, Any]) -> Bound:
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


def _curve(record: dict[str, Any]) -> Curve:
    def numbers(values: list[Any]) -> Array:
        return np.array([float(value) for value in values])

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
