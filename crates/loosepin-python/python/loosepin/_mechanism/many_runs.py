"""Recorded runs of one mechanism with many values of some parameters."""

from __future__ import annotations

import os
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from .. import _loosepin
from .._extras import need
from .._objects.errors import refused
from .._objects.arrays import read_only, read_only_copy, refuse_taken
from .._objects.logs import long_run
from .._objects.records import Record
from .._progress import Listener, listener
from .._records import Array

if TYPE_CHECKING:
    import pandas
    import xarray


class _Run(Protocol):
    """What is asked of a simulation."""

    time_s: Array
    drive_angle_rad: Array
    history: dict[str, Array]

    def series(self) -> dict[str, tuple[Array, str]]: ...


RunT = TypeVar("RunT", bound=_Run)


class Simulations(Record, Sequence["RunT | None"], Generic[RunT]):
    """Recorded runs in the order of their inputs: `simulations[3]["slider"]`; None stands for a run that failed."""

    def __init__(self, inputs: Mapping[str, Array], units: Mapping[str, str], runs: Sequence[RunT | None], reasons: Sequence[str | None]) -> None:
        """Use `Model.simulate_many`."""
        self.inputs: dict[str, Array] = dict(inputs)
        """The value of each input in each run, SI, by its path."""
        self.units: dict[str, str] = dict(units)
        """SI unit of each input."""
        self._runs = tuple(runs)
        self.reasons: tuple[str | None, ...] = tuple(reasons)
        """Why each run failed, in words; None for a finished one."""
        self.failed: NDArray[np.bool_] = read_only(np.array([run is None for run in runs], dtype=bool))
        """Whether each run failed."""

    def __getitem__(self, place: Any) -> Any:
        return self._runs[place]

    def __len__(self) -> int:
        return len(self._runs)

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the rows of all finished runs below each other: `run`, the inputs under their paths, and the columns of
        `history.csv`.
        """
        pandas_ = need("pandas", "to_pandas()")
        frames = []
        for place, run in enumerate(self._runs):
            if run is not None:
                columns: dict[str, Any] = {"run": place}
                for name, values in self.inputs.items():
                    refuse_taken(name, run.history)
                    columns[name] = values[place]
                frames.append(pandas_.DataFrame(columns | run.history))
        none: dict[str, list[float]] = {name: [] for name in ("run", *self.inputs)}
        frame: pandas.DataFrame = pandas_.concat(frames, ignore_index=True) if frames else pandas_.DataFrame(none)
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """All histories as a Dataset over the dimensions `run` and `row`, as `Simulation.to_xarray` names them; NaN where a run failed, or
        where a joint has no play in it.

        `time_s` and `drive_angle_rad` have both dimensions too; inputs are coordinates of `run`; units are in the attributes. Raises
        ValueError if no run is finished.
        """
        xarray_ = need("xarray", "to_xarray()")
        first = next((run for run in self._runs if run is not None), None)
        if first is None:
            raise ValueError(f"no run is finished\nhint: the first reason is: {self.reasons[0]}")

        nothing = np.full(len(first.time_s), np.nan)

        def variable(arrays: Iterable[Array | None], unit: str) -> tuple[tuple[str, str], Array, dict[str, str]]:
            return ("run", "row"), np.array([nothing if values is None else values for values in arrays]), {"units": unit}

        of_runs = [{} if run is None else run.series() for run in self._runs]
        units = {name: unit for series in of_runs for name, (_, unit) in series.items()}
        variables: dict[str, Any] = {
            name: variable((series[name][0] if name in series else None for series in of_runs), unit) for name, unit in units.items()
        }
        coordinates: dict[str, Any] = {name: ("run", values, {"units": self.units[name]}) for name, values in self.inputs.items()}
        coordinates["failed"] = ("run", self.failed)
        coordinates["time_s"] = variable((None if run is None else run.time_s for run in self._runs), "s")
        coordinates["drive_angle_rad"] = variable((None if run is None else run.drive_angle_rad for run in self._runs), "rad")
        dataset: xarray.Dataset = xarray_.Dataset(variables, coordinates).copy(deep=True)
        return dataset

    def _hash_key(self) -> Hashable:
        return len(self), *self.inputs

    def __repr__(self) -> str:
        failed = int(self.failed.sum())
        return f"<loosepin.Simulations: {len(self)} runs{f', {failed} failed' if failed else ''}, inputs {', '.join(self.inputs)}>"


def simulated(
    simulate: Callable[[int], RunT],
    count: int,
    columns: Mapping[str, Array],
    units: Mapping[str, str],
    threads: int | None,
    progress: bool | Listener,
) -> Simulations[RunT]:
    """Makes `count` runs, one for each row of `columns`, by `simulate`, which leaves the lock of the interpreter while it works."""
    made: list[RunT | None] = [None] * count
    reasons: list[str | None] = [None] * count
    if threads is not None and threads < 1:
        raise refused(f"threads {threads}; must be at least 1")
    workers = ThreadPoolExecutor(threads or os.cpu_count() or 1)
    with long_run(f"{count} simulations", listener(progress)) as notify:
        waiting = {workers.submit(simulate, run): run for run in range(count)}
        try:
            for finished, future in enumerate(as_completed(waiting), 1):
                run = waiting[future]
                try:
                    made[run] = future.result()
                except _loosepin.LoosepinError as error:
                    reasons[run] = str(error)
                if notify is not None:
                    notify(finished, count)
        finally:
            # After Ctrl-C the runs under way are waited for, and no other begins.
            workers.shutdown(cancel_futures=True)
    return Simulations({name: read_only_copy(values) for name, values in columns.items()}, units, made, reasons)
