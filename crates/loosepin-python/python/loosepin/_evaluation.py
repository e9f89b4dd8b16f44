"""Runs at inputs that were chosen, as arrays."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _loosepin
from ._extras import need
from ._notebook.html import evaluation_html
from ._objects.arguments import item_named
from ._objects.arrays import frozen, read_only, read_only_copy
from ._objects.logs import LOGGER, long_run
from ._objects.records import Record
from ._progress import Listener, listener
from ._records import Array
from ._warning import LoosepinWarning

if TYPE_CHECKING:
    import pandas
    import xarray

Recorded = tuple[str, str, list[float] | None, list[int]]
"""Name, SI unit, angles of a curve in rad, and columns of a row."""


class Evaluation(Record, Mapping[str, Array]):
    """Runs at chosen inputs: `evaluation["slider total maximum_absolute"]` holds a number for each run, SI.

    A number of a run is an array of the shape (runs,), a curve one of the shape (runs, poses), whose angles are in `pose_rad`.
    Not-a-number stands where a run failed. All arrays are read-only.
    """

    def __init__(
        self,
        inputs: Mapping[str, Array],
        outputs: Mapping[str, Array],
        units: Mapping[str, str],
        pose_rad: Mapping[str, Array],
        reasons: Sequence[str | None],
        counters: Mapping[str, NDArray[Any]],
    ) -> None:
        """Use `Study.evaluate` or `Model.evaluate`."""
        self._outputs = dict(outputs)
        self.inputs: dict[str, Array] = dict(inputs)
        """The value of each input in each run, SI, by name; of a law its place in the list."""
        self.units: dict[str, str] = dict(units)
        """SI unit of each output, input and counter; "1" for pure numbers and counts."""
        self.pose_rad: dict[str, Array] = dict(pose_rad)
        """Angles of the drive at the columns of each curve, rad."""
        self.reasons: tuple[str | None, ...] = tuple(reasons)
        """Why each run failed, in words; None for a finished one."""
        self.failed: NDArray[np.bool_] = read_only(np.array([reason is not None for reason in self.reasons], dtype=bool))
        """Whether each run failed."""
        self.counters: dict[str, NDArray[Any]] = dict(counters)
        """What else was counted of each run, with the names of `runs.parquet`: `steps`, `evaluations`, `energy_residual`, and for each
        joint with play `contacts`, `largest_penetration` and `peak_force`. The last is looked for at a few points of each step and may be
        a few thousandths below the true peak; an output `force_in` with the reduction "maximum" has that. Where the clearance of a joint is
        zero, it has no contacts, and the others are NaN."""

    def __getitem__(self, name: str) -> Array:
        return item_named(self._outputs, name, "output")

    def __iter__(self) -> Iterator[str]:
        return iter(self._outputs)

    def __len__(self) -> int:
        return len(self._outputs)

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with a row for each run: inputs, outputs, and `reason` (empty for a finished run).

        A curve has a column for each pose, `slider total at 1.1 rad`.
        """
        pandas_ = need("pandas", "to_pandas()")
        columns: dict[str, Any] = dict(self.inputs)
        for name, values in self.items():
            if name in self.pose_rad:
                columns |= {
                    f"{name} at {round(angle, 9)} rad": values[:, place] for place, angle in enumerate(self.pose_rad[name].tolist())
                }
            else:
                columns[name] = values
        columns["reason"] = [reason or "" for reason in self.reasons]
        frame: pandas.DataFrame = pandas_.DataFrame(columns)
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """A Dataset over the dimension `run`, and of a curve also over its angles; units are in the attributes.

        Inputs are coordinates of `run`. The angles are the coordinate `pose_rad`; curves with other angles than the first one have a
        coordinate of their own, `pose_rad of NAME`.
        """
        xarray_ = need("xarray", "to_xarray()")
        coordinates: dict[str, Any] = {name: ("run", values, {"units": self.units[name]}) for name, values in self.inputs.items()}
        coordinates["failed"] = ("run", self.failed)
        variables: dict[str, Any] = {}
        for name, values in self.items():
            dimensions: tuple[str, ...] = ("run",)
            if name in self.pose_rad:
                poses = self.pose_rad[name]
                known = coordinates.setdefault("pose_rad", ("pose_rad", poses, {"units": "rad"}))[1]
                dimension = "pose_rad" if np.array_equal(known, poses) else f"pose_rad of {name}"
                coordinates.setdefault(dimension, (dimension, poses, {"units": "rad"}))
                dimensions = ("run", dimension)
            variables[name] = (dimensions, values, {"units": self.units[name]})
        dataset: xarray.Dataset = xarray_.Dataset(variables, coordinates).copy(deep=True)
        return dataset

    def _hash_key(self) -> Hashable:
        return len(self.failed), *self, *self.inputs

    def __repr__(self) -> str:
        return f"<loosepin.Evaluation: {self._counts()}, inputs {', '.join(self.inputs)}; outputs {', '.join(self)}>"

    def _repr_html_(self) -> str:
        rows = ((name, self.units[name], values) for name, values in self.items())
        return evaluation_html(self._counts(), rows, [reason for reason in self.reasons if reason is not None])

    def _counts(self) -> str:
        runs, failed = len(self.failed), int(self.failed.sum())
        return f"{runs} run{'' if runs == 1 else 's'}" + (f", {failed} failed" if failed else "")


def evaluated(
    native: _loosepin.Evaluator,
    inputs: tuple[Sequence[str], Mapping[str, str], Array],
    recorded: Mapping[str, Recorded],
    threads: int | None,
    progress: bool | Listener,
    warn: Callable[[Warning], None],
) -> Evaluation:
    """Runs at a table of inputs, whose names and units come before it; `recorded` is what of each row is given, by name."""
    names, input_units, table = inputs
    with long_run(f"evaluation of {len(table)} runs", listener(progress)) as notify:
        rows, reasons, counters, coarse = native.evaluate(table, threads, notify)
    if coarse is not None:
        LOGGER.warning("%s", coarse)
        warn(LoosepinWarning(coarse))
    outputs = {
        name: read_only_copy(rows[:, columns] if poses is not None else rows[:, columns[0]])
        for name, (_, _, poses, columns) in recorded.items()
    }
    units = dict(input_units) | {column.name: column.unit for column in counters}
    units |= {name: unit for name, (_, unit, _, _) in recorded.items()}
    return Evaluation(
        {name: read_only_copy(table[:, place]) for place, name in enumerate(names)},
        outputs,
        units,
        {name: read_only(np.array(poses)) for name, (_, _, poses, _) in recorded.items() if poses is not None},
        reasons,
        {column.name: frozen(column.values) for column in counters},
    )
