"""Wear of the joints of a run."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, Protocol, TypeVar

import numpy as np

from .. import _loosepin
from .._extras import need
from .._objects.arguments import item_named
from .._objects.arrays import NoArray, read_only
from .._objects.pickles import pickled
from .._objects.records import Record
from .._records import Array, numbers

if TYPE_CHECKING:
    import pandas
    import xarray


class _Run(Protocol):
    """What is asked of a simulation."""

    @property
    def _native(self) -> _loosepin.Simulation: ...

    @property
    def summary(self) -> dict[str, Any]: ...

    def report(self, path: str | os.PathLike[str]) -> Path: ...


RunT = TypeVar("RunT", bound=_Run)


@dataclass(frozen=True, eq=False, repr=False)
class SurfaceWear(Record):
    """Wear of one surface after all cycles; the arrays have one entry for each sector of its circumference."""

    coefficient_m2_n: float
    """Wear coefficient of Archard's law."""
    volume_m3: float
    """Worn volume."""
    greatest_depth_m: float
    """Greatest depth among the sectors."""
    depth_m: Array
    """Mean depth of each sector."""
    from_rad: Array
    """Where each sector begins, from the x axis of the body with the surface."""
    to_rad: Array
    """Where it ends."""


@dataclass(frozen=True, eq=False, repr=False)
class SurfaceLife(Record):
    """Wear of one surface over the cycles of a life."""

    volume_m3: Array
    """Worn volume, one entry for each of `Wear.life_cycles`."""
    greatest_depth_m: Array
    """Greatest depth among the sectors, likewise."""
    depth_m: Array
    """Depths, shape (cycles, sectors)."""


@dataclass(frozen=True, eq=False, repr=False)
class JointWear(Record):
    """Wear of a joint; the keys of the dicts are "bearing" and "journal", of those that wear."""

    joint: str
    """Name of the joint."""
    cycles: float
    """Cycles; a cycle is the recorded part of the run."""
    friction_path_j: float
    """Integral of normal force times sliding speed over a cycle."""
    radial_clearance_m: float
    """Radial clearance of the unworn joint."""
    surfaces: dict[str, SurfaceWear]
    """The surfaces that wear, with unworn geometry."""
    life: dict[str, SurfaceLife]
    """The same over the cycles of `Wear.life_cycles`, where the worn shape acts back; else empty."""
    checks: dict[str, Any]
    """Checks that the run makes, as in `summary.json`."""


class Wear(NoArray, Mapping[str, JointWear], Generic[RunT]):
    """Wear after the cycles of `[wear]`: `wear["gudgeon"].surfaces["bearing"].volume_m3`; `print(wear)` shows the tables."""

    def __init__(self, simulation: RunT) -> None:
        """Use `Model.wear`."""
        self.simulation: RunT = simulation
        """The run of a cycle that it was computed from."""
        self.life: dict[str, Any] | None = simulation.summary.get("life")
        """The life with `geometry = "worn"`, as in `summary.json`: limits, deviations of outputs, errors of the jumps; else None."""
        self.life_cycles: Array = numbers(self.life["cycles"] if self.life else ())
        """Cycles at the ends of the jumps of that life; else empty."""
        lives = {each["joint"]: each for each in self.life["joints"]} if self.life else {}
        self._joints = {record["joint"]: _joint(record, lives.get(record["joint"])) for record in simulation.summary["wear"]}

    def __getitem__(self, name: str) -> JointWear:
        return item_named(self._joints, name, "joint that wears")

    def __iter__(self) -> Iterator[str]:
        return iter(self._joints)

    def __len__(self) -> int:
        return len(self._joints)

    @property
    def summary(self) -> dict[str, Any]:
        """That of the run, as in `summary.json`; SI."""
        return self.simulation.summary

    def to_xarray(self) -> xarray.Dataset:
        """The depths as a Dataset: `gudgeon.bearing.depth_m` over the sectors, whose beginnings are the coordinate `gudgeon.from_rad`.

        Where the worn shape acts back, `gudgeon.bearing.life_depth_m` also has the dimension `cycles`.
        """
        xarray_ = need("xarray", "to_xarray()")
        variables: dict[str, Any] = {}
        coordinates: dict[str, Any] = {"cycles": self.life_cycles} if self.life else {}
        for name, joint in self.items():
            sector = f"{name}.from_rad"
            for word, surface in joint.surfaces.items():
                coordinates[sector] = (sector, surface.from_rad, {"units": "rad"})
                variables[f"{name}.{word}.depth_m"] = (sector, surface.depth_m, {"units": "m"})
            for word, life in joint.life.items():
                variables[f"{name}.{word}.life_depth_m"] = (("cycles", sector), life.depth_m, {"units": "m"})
        dataset: xarray.Dataset = xarray_.Dataset(variables, coordinates, {"model": self.simulation._native.model}).copy(deep=True)
        return dataset

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the columns of `wear.csv`: joint, surface, sector, from_rad, to_rad, depth_m."""
        pandas_ = need("pandas", "to_pandas()")
        surfaces = [(name, word, surface) for name, joint in self.items() for word, surface in joint.surfaces.items()]
        rows = [
            {"joint": name, "surface": word, "sector": sector, "from_rad": from_rad, "to_rad": to_rad, "depth_m": depth_m}
            for name, word, surface in surfaces
            for sector, (from_rad, to_rad, depth_m) in enumerate(zip(surface.from_rad, surface.to_rad, surface.depth_m))
        ]
        frame: pandas.DataFrame = pandas_.DataFrame(rows)
        return frame

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the page that the command `loosepin wear` writes: one file, readable without a network."""
        return self.simulation.report(path)

    def __reduce__(self) -> tuple[Any, ...]:
        return pickled("Wear", Wear, self.simulation)

    def __eq__(self, other: object) -> bool:
        """Whether both are of equal runs."""
        return isinstance(other, Wear) and bool(self.simulation == other.simulation)

    def __hash__(self) -> int:
        return hash((Wear, self.simulation))

    def __str__(self) -> str:
        return self.simulation._native.wear_text()

    def _repr_html_(self) -> str:
        return f"<pre>{escape(str(self))}</pre>"

    def __repr__(self) -> str:
        return f"<loosepin.Wear of {self.simulation._native.model!r}, joints {', '.join(self)}; print() shows it>"


def _joint(record: dict[str, Any], life: dict[str, Any] | None) -> JointWear:
    return JointWear(
        joint=record["joint"],
        cycles=float(record["cycles"]),
        friction_path_j=float(record["friction_path_j"]),
        radial_clearance_m=float(record["radial_clearance_m"]),
        surfaces={each["surface"]: _surface(each) for each in record["surfaces"]},
        life={each["surface"]: _life(each) for each in life["surfaces"]} if life else {},
        checks=record["checks"],
    )


def _surface(record: dict[str, Any]) -> SurfaceWear:
    depth_m = numbers(record["depth_m"])
    edges_rad = read_only(np.arange(len(depth_m) + 1, dtype=np.float64) * (2 * np.pi / len(depth_m)))
    return SurfaceWear(
        coefficient_m2_n=float(record["coefficient_m2_n"]),
        volume_m3=float(record["volume_m3"]),
        greatest_depth_m=float(record["greatest_depth_m"]),
        depth_m=depth_m,
        from_rad=edges_rad[:-1],
        to_rad=edges_rad[1:],
    )


def _life(record: dict[str, Any]) -> SurfaceLife:
    depth_m = read_only(np.array([numbers(depths) for depths in record["depth_m"]]))
    return SurfaceLife(numbers(record["volume_m3"]), numbers(record["greatest_depth_m"]), depth_m)
