"""Runs for many values of one quantity: where the motion repeats itself, and how often its joints strike."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import _loosepin
from .._extras import need
from .._figures import shown, sweep_figure
from .._progress import Listener, listener
from .._objects.arguments import item_named
from .._objects.arrays import NoArray, read_only, refuse_masked
from .._objects.errors import refused
from .._objects.logs import long_run
from .._objects.pickles import pickled
from .._objects.records import Record
from .._objects.stored import loaded, saved
from .._records import Array, numbers

if TYPE_CHECKING:
    import matplotlib.figure
    import pandas
    import xarray


@dataclass(frozen=True, eq=False, repr=False)
class SweptJoint(Record):
    """A joint with play in the turns that were examined; all arrays have one entry for each value, NaN where the run failed."""

    impacts_per_turn: Array
    """Impacts in a turn."""
    flight_share: Array
    """Share of the time without contact, 0 to 1."""
    losses_per_turn: Array
    """Contacts that ended, in a turn."""
    peak_force_n: Array
    """Largest normal force."""
    largest_penetration_m: Array
    """Largest penetration."""


_OF_JOINT = tuple(SweptJoint.__dataclass_fields__)
_UNITS = {"impacts_per_turn": "1", "flight_share": "1", "losses_per_turn": "1", "peak_force_n": "N", "largest_penetration_m": "m"}


class Sweep(NoArray, Mapping[str, Array]):
    """Runs for many values of a quantity: `sweep["slider"]` holds its deviation from the ideal motion once a turn, SI.

    Its shape is (values, turns): a Poincaré section for each value. It holds the outputs that are positions or angles. A run that failed
    is NaN.
    """

    def __init__(self, native: _loosepin.Sweep) -> None:
        """Use `Model.sweep`."""
        self._native = native
        points, turns = self.summary["points"], self.summary["recorded_turns"]
        self.path: str = self.summary["path"]
        """Path of the quantity in the model."""
        self.values_si: Array = numbers(point["value_si"] for point in points)
        """Its values, in `units[path]`."""
        self.units: dict[str, str] = {self.path: self.summary["unit"]} | {each["name"]: each["unit"] for each in self.summary["outputs"]}
        """SI unit of the quantity and of each output."""
        self.reasons: tuple[str | None, ...] = tuple(point["failure"] for point in points)
        """Why each run failed, in words; None for a finished one."""
        self.failed: NDArray[np.bool_] = read_only(np.array([reason is not None for reason in self.reasons], dtype=bool))
        """Whether each run failed."""
        self.period_turns: Array = numbers(np.nan if point["period_turns"] is None else point["period_turns"] for point in points)
        """Turns after which the motion repeats itself; NaN where it does not within half of the turns that were examined."""
        nothing = [np.nan] * turns
        self._sections = {
            each["name"]: read_only(
                np.array([point["sections_si"][place] if point["sections_si"] else nothing for point in points], dtype=np.float64)
            )
            for place, each in enumerate(self.summary["outputs"])
        }
        self.joints: dict[str, SweptJoint] = {joint: _joint(points, place) for place, joint in enumerate(self.summary["joints"])}
        """The joints with play, by name."""

    def __getitem__(self, name: str) -> Array:
        return item_named(self._sections, name, "output")

    def __iter__(self) -> Iterator[str]:
        return iter(self._sections)

    def __len__(self) -> int:
        return len(self._sections)

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The sweep as `summary.json` has it; SI."""
        summary: dict[str, Any] = json.loads(self._native.summary_json())
        return summary

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with a row for each value and the columns of `sweep.csv`: `value`, `period_turns`, those of joints, `failure`."""
        pandas_ = need("pandas", "to_pandas()")
        columns: dict[str, Any] = {"value": self.values_si, "period_turns": self.period_turns}
        columns |= {f"{joint}.{what}": getattr(of_joint, what) for joint, of_joint in self.joints.items() for what in _OF_JOINT}
        columns["failure"] = [reason or "" for reason in self.reasons]
        frame: pandas.DataFrame = pandas_.DataFrame(columns)
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """A Dataset over the dimensions `run` and `turn`: the outputs once a turn, and `gudgeon.peak_force_n` and so on of each joint.

        The quantity is a coordinate of `run`, under its path; units are in the attributes.
        """
        xarray_ = need("xarray", "to_xarray()")
        variables: dict[str, Any] = {name: (("run", "turn"), values, {"units": self.units[name]}) for name, values in self.items()}
        variables["period_turns"] = ("run", self.period_turns)
        for joint, of_joint in self.joints.items():
            variables |= {f"{joint}.{what}": ("run", getattr(of_joint, what), {"units": _UNITS[what]}) for what in _OF_JOINT}
        coordinates = {
            self.path: ("run", self.values_si, {"units": self.units[self.path]}),
            "turn": np.arange(1, self.summary["recorded_turns"] + 1),
            "failed": ("run", self.failed),
        }
        dataset: xarray.Dataset = xarray_.Dataset(variables, coordinates, {"model": self.summary["model"]}).copy(deep=True)
        return dataset

    def plot(self, *outputs: str, ax: Any = None) -> matplotlib.figure.Figure:
        """Draws the bifurcation diagram: the deviation once a turn over the quantity; all outputs where none is named.

        ax: as for `Simulation.plot`.
        """
        drawn = [(name, self.units[name], self[name]) for name in outputs or self]
        return sweep_figure((self.path, self.units[self.path], self.values_si), drawn, self.summary["display_units"], ax)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the page that the command `loosepin sweep` writes: one file, readable without a network."""
        self._native.write_page(os.fspath(path))
        return Path(path)

    @classmethod
    def load(cls, folder: str | os.PathLike[str]) -> Sweep:
        """Reads the finished sweep in a folder of results, which `save` or `loosepin sweep --out` wrote. Nothing in it is changed."""
        return cls(loaded(_loosepin.Sweep.load, folder))

    def save(self, folder: str | os.PathLike[str], *, force: bool = False) -> Path:
        """Writes the files of `loosepin sweep --out` into a folder: summary.json, sweep.csv, sections.csv and report.html.

        force: replaces other results there. Raises LoosepinError if the folder holds something else. Returns the folder.
        """
        return saved(self._native, folder, force)

    def __reduce__(self) -> tuple[Any, ...]:
        return pickled("Sweep", _restored, self._native.summary_json())

    def __eq__(self, other: object) -> bool:
        """Whether both have the same numbers: those of `summary.json`."""
        return isinstance(other, Sweep) and self._native.summary_json() == other._native.summary_json()

    def __hash__(self) -> int:
        return hash((Sweep, self.summary["model"], tuple(self)))

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        return f"<loosepin.Sweep of {self.summary['model']!r} over {self.path}: {self._counts()}, outputs {', '.join(self)}>"

    def _repr_html_(self) -> str:
        unit, factor = shown(self.units[self.path], self.summary["display_units"])
        ends = f"{self.values_si.min() * factor:.4g} to {self.values_si.max() * factor:.4g} {unit}"
        return f"<p><b>{escape(self.summary['model'])}</b>, {escape(self.path)} from {escape(ends)}: {self._counts()}</p><pre>{escape(str(self))}</pre>"

    def _counts(self) -> str:
        runs, failed = len(self.failed), int(self.failed.sum())
        return f"{runs} run{'' if runs == 1 else 's'}" + (f", {failed} failed" if failed else "")


def _restored(summary: str) -> Sweep:
    return Sweep(_loosepin.Sweep.from_json(summary))


def _joint(points: Sequence[dict[str, Any]], place: int) -> SweptJoint:
    """The joint at this place in every run."""
    return SweptJoint(*(numbers(point["joints"][place][what] if point["joints"] else np.nan for point in points) for what in _OF_JOINT))


def swept(
    native: _loosepin.Model,
    over: str,
    between: tuple[str | float, str | float] | None,
    values: Any,
    points: int,
    turns: tuple[int, int],
    tolerance: str,
    settings: list[str],
    threads: int | None,
    progress: bool | Listener,
) -> tuple[Sweep, list[_loosepin.Diagnostic]]:
    """The sweep of a model over `over`, and warnings about the request; `turns` are those before, and those that are examined."""
    if (between is None) == (values is None):
        raise refused("sweep needs either between or values", "E0205")
    ends = None if between is None else _ends(native, over, between)
    listed = [] if values is None else _listed(values)
    with long_run(f"sweep of {over}", listener(progress)) as notify:
        made, warnings = native.sweep(over, ends, listed, points, *turns, tolerance, settings, threads, notify)
    return Sweep(made), warnings


def _ends(native: _loosepin.Model, over: str, between: Any) -> list[str]:
    """The ends of a range as texts with units."""
    between = between.tolist() if isinstance(between, np.ndarray) else between
    if not isinstance(between, Sequence) or isinstance(between, str) or len(between) != 2:
        raise refused(f"between {between!r}; must be two values, from and to", "E0203")
    return [end if isinstance(end, str) else native.text_of_value("over", over, float(end)) for end in between]


def _listed(values: Any) -> list[float]:
    """Values in SI."""
    refuse_masked("values", values)
    array = np.asarray(values)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"values: values of type {array.dtype}; must be numbers in SI units")
    if array.ndim != 1 or not len(array):
        raise refused(f"values: shape {array.shape}; must be an array with one dimension and at least one value", "E0203")
    if not np.isfinite(array).all():
        raise refused("values: must be finite", "E0308")
    listed: list[float] = array.astype(np.float64).tolist()
    return listed
