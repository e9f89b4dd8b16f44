"""Results of a study."""

from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Hashable, Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _loosepin
from ._extras import need
from ._figures import study_figure
from ._notebook.html import study_html
from ._notebook.display import Figure, NotebookDisplay
from ._objects.arguments import item_named, must_be
from ._objects.arrays import NoArray, read_only
from ._objects.pickles import pickled
from ._objects.records import Record, are_same
from ._records import Array, Bound, Curve, bound, curve, selected
from ._surrogates import Surrogates

if TYPE_CHECKING:
    import matplotlib.figure
    import pandas
    import xarray

_WORDS = {
    *("output", "of", "at", "reduction", "statistic", "treatment", "reading", "unit", "guarantee"),
    *("lower_witness", "upper_witness"),
}
"""Columns of `bounds.csv` that hold no numbers."""


class Samples(Record, Mapping[str, Any]):
    """Every run of a study: a NumPy array for each column of `runs.parquet`, by name; all are read-only."""

    def __init__(self, native: _loosepin.StudyResult, inputs: list[str]) -> None:
        """Use `StudyResult.samples`."""
        columns = native.samples()
        self._columns: dict[str, Any] = {column.name: read_only(np.asarray(column.values)) for column in columns}
        self.units: dict[str, str] = {column.name: column.unit for column in columns}
        """SI unit of each column; "1" for counts and words."""
        names = list(self._columns)
        self.inputs: dict[str, Any] = {name: self._columns[name] for name in inputs if name in self._columns}
        """The uncertain inputs by path; a law is a word."""
        last = max((names.index(name) for name in self.inputs), default=-1)
        self.outputs: dict[str, Any] = {name: self._columns[name] for name in names[last + 1 : names.index("status")]}
        """The scalar outputs, NaN where a run has none."""

    def __getitem__(self, name: str) -> Any:
        return item_named(self._columns, name, "column")

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def to_pandas(self) -> pandas.DataFrame:
        """The runs as a DataFrame, one a row."""
        pandas_ = need("pandas", "to_pandas()")
        frame: pandas.DataFrame = pandas_.DataFrame(self._columns)
        return frame

    def _hash_key(self) -> Hashable:
        return tuple(self)

    def __repr__(self) -> str:
        rows = len(next(iter(self._columns.values()), ()))
        return f"<loosepin.Samples: {rows} runs, inputs {', '.join(self.inputs)}; outputs {', '.join(self.outputs)}>"


class StudyResult(NotebookDisplay, NoArray):
    """A finished study: `print(result)` shows the tables of the terminal, `result.bounds` holds every bound."""

    def __init__(self, native: _loosepin.StudyResult) -> None:
        """Use `Study.run` or `load`."""
        self._native = native

    @classmethod
    def load(cls, folder: str | os.PathLike[str]) -> StudyResult:
        """Reads the finished study in a folder of results, which `Study.run` or `loosepin study` wrote. Nothing in it is changed.

        Raises LoosepinError if the folder holds no finished study, or one of its files is not as it was written.
        """
        must_be("a path", folder=folder)
        return cls(_loosepin.StudyResult.load(os.fspath(folder)))

    @property
    def name(self) -> str:
        """Name of the study."""
        return self._native.name

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The whole result, as in `summary.json`; SI. Numbers that are not finite are "inf", "-inf" or "nan"."""
        summary: dict[str, Any] = json.loads(self._native.summary_json())
        return summary

    @cached_property
    def bounds(self) -> tuple[Bound, ...]:
        """Every bound, in the order of `bounds.csv`."""
        return tuple(bound(record) for record in self.summary["bounds"])

    def select(self, **properties: Any) -> list[Bound]:
        """The bounds with these properties: result.select(output="slider", of="total", statistic="mean", at="reduced")."""
        return selected(self.bounds, properties)

    @property
    def requirements(self) -> list[dict[str, Any]]:
        """The requirements with their `verdict`: "met", "promised", "not_met" or "undecided"."""
        requirements: list[dict[str, Any]] = self.summary["requirements"]
        return requirements

    @property
    def is_met(self) -> bool:
        """Whether all requirements are met for all values of the unknown inputs, numerical error included.

        A requirement that a promise decides is not: it is "promised", for a share of the box.
        """
        return all(requirement["verdict"] == "met" for requirement in self.requirements)

    @property
    def promise(self) -> dict[str, Any] | None:
        """The promise for a share of the box, as in `summary.json`; None if the study promises nothing."""
        promise: dict[str, Any] | None = self.summary.get("promise")
        return promise

    @cached_property
    def curves(self) -> tuple[Curve, ...]:
        """The deviations over the cycle."""
        return tuple(curve(record) for record in self.summary["curves"])

    @cached_property
    def samples(self) -> Samples:
        """Every run: inputs, outputs, purpose, failure and its reason, counters."""
        return Samples(self._native, [each["path"] for each in self.summary["inputs"]])

    @cached_property
    def surrogates(self) -> Surrogates | None:
        """Surrogates, if the study asks for them."""
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
        dataset: xarray.Dataset = xarray_.Dataset(variables, coordinates, {"study": self.name}).copy(deep=True)
        return dataset

    def _bounds_over_poses(self) -> Iterator[tuple[str, str, Array]]:
        """Name, unit and bounds of each statistic of each curve."""
        statistics: dict[str, list[Bound]] = {}
        first = self.bounds[0].reading if self.bounds else ""
        for each in self.select(at="curve", treatment="mixed"):
            parameter = "" if each.parameter is None else f"_{each.parameter:.6g}"
            reading = "" if each.reading == first else f"_{each.reading}"
            name = f"{each.output}_{each.of}_{each.statistic}{parameter}{reading}".replace(" ", "_")
            statistics.setdefault(name, []).append(each)
        for name, bounds in statistics.items():
            yield name, bounds[0].unit, np.array([each.widened for each in bounds])

    def plot(
        self, kind: str | None = None, *, output: str | None = None, of: str | None = None, ax: Any = None
    ) -> matplotlib.figure.Figure:
        """Draws a standard figure with matplotlib.

        kind: "curves" (the band of each deviation over the cycle with its bounds), "box" (bounds of distribution functions) or
        "contributors" (sources of the width of a band: random scatter in one colour, unknown inputs in another); by default
        the first of these that there is. output, of: one output or deviation alone. ax: axes of matplotlib to draw into, one for
        each; a new figure if omitted. Returns the figure. It is not shown, and figures of the caller stay open.
        """
        return study_figure(self.name, self.curves, self.summary, kind, output, of, ax)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the page that the command `loosepin study` writes: one file, readable without a network."""
        must_be("a path", path=path)
        self._native.write_page(os.fspath(path))
        return Path(path)

    def __reduce__(self) -> tuple[Any, ...]:
        return pickled("StudyResult", _restored, *self._content())

    def __eq__(self, other: object) -> bool:
        """Whether both have the same numbers: bounds, runs and surrogates."""
        return isinstance(other, StudyResult) and are_same(self._content(), other._content())

    def __hash__(self) -> int:
        return hash(self._native.summary_json())

    def _content(self) -> tuple[str, list[tuple[str, str, Any]], str | None]:
        samples = [(column.name, column.unit, column.values) for column in self._native.samples()]
        return self._native.summary_json(), samples, self._native.surrogates_json()

    def __str__(self) -> str:
        return self.text()

    def text(self, *, all: bool = False) -> str:
        """What `print` shows: the answer, warnings and main tables; with `all`, every table and how it was computed."""
        return self._native.text(all)

    def __repr__(self) -> str:
        runs = self.summary["counts"]["runs"]
        return f"<loosepin.StudyResult {self.name!r}: {len(self.bounds)} bounds from {runs} runs; print() shows them>"

    def _repr_html_(self) -> str:
        return study_html(self.name, self._native.excerpt())

    def _figure(self) -> Figure:
        return Figure(self.name, *self._native.frame())


def _restored(summary: str, samples: list[tuple[str, str, Any]], surrogates: str | None) -> StudyResult:
    return StudyResult(_loosepin.StudyResult.from_parts(summary, samples, surrogates))
