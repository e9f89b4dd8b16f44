"""Paths of points over the cycle, with the zone in which play and scatter let each be."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from .._figures import path_figure
from .._objects.arrays import read_only
from .._objects.errors import refused
from .._objects.records import Record
from .._records import Array, numbers

if TYPE_CHECKING:
    import matplotlib.figure


@dataclass(frozen=True, eq=False, repr=False)
class PointPath(Record):
    """The ideal path of a point, and how far play and scatter take it off, to first order.

    All arrays have one entry for each of `Motion.drive_angle_rad`, unless said otherwise; those that do not apply are empty.
    """

    name: str
    """Name of the output that is the path, or of the point."""
    point: str
    """The point in words, for example "coupler.tool"."""
    x_m: Array
    y_m: Array
    z_m: Array
    """Empty in the plane, as all that is along z."""
    velocity_x_m_s: Array
    """At the speed of the drive."""
    velocity_y_m_s: Array
    velocity_z_m_s: Array
    acceleration_x_m_s2: Array
    """At the speed of the drive."""
    acceleration_y_m_s2: Array
    acceleration_z_m_s2: Array
    tangent_x: Array
    """Unit vectors along the motion; zero where the point stands still."""
    tangent_y: Array
    tangent_z: Array
    play_reach_m: Array
    """Furthest displacement by play in the directions 0°, 11.25°, ... 168.75° from the x axis, to either side; shape (angles, 16), in space (0, 16)."""
    play_along_m: Array
    """Furthest displacement by play along the motion, to either side; where the point stands still, in any direction."""
    play_across_m: Array
    """Furthest displacement by play across the motion, to either side; where the point stands still, in any direction."""
    play_longest_m: Array
    """In space: the furthest displacement by play in any direction."""
    scatter_major_m: Array
    """Larger semi-axis of the ellipse that holds 95 % of the scatter, for the random inputs of a study."""
    scatter_minor_m: Array
    """Its smaller semi-axis."""
    scatter_angle_rad: Array
    """Angle of its larger semi-axis from the x axis."""
    _display_units: dict[str, Any]

    @property
    def speed_m_s(self) -> Array:
        """Magnitude of the velocity."""
        in_plane = np.hypot(self.velocity_x_m_s, self.velocity_y_m_s)
        return read_only(np.hypot(in_plane, self.velocity_z_m_s) if len(self.velocity_z_m_s) else in_plane)

    @cached_property
    def zone_m(self) -> Array:
        """Corners of the zone about each position, m: the polygon with 32 sides about play and scatter together; shape (angles, 32, 2).
        Empty in space, where `play_along_m`, `play_across_m` and `play_longest_m` say how far it reaches.

        Its sides touch the zone. Two neighbouring ones, n·d = h and n'·d = h' with normals turned by δ, meet in (h n'⊥ - h' n⊥)/sin δ.
        """
        directions = np.pi * np.arange(16) / 16
        reach = np.concatenate([self.play_reach_m, self.play_reach_m], axis=1)
        normals = np.concatenate([directions, directions + np.pi])
        if len(self.scatter_major_m):
            turned = normals[np.newaxis, :] - self.scatter_angle_rad[:, np.newaxis]
            major, minor = self.scatter_major_m[:, np.newaxis], self.scatter_minor_m[:, np.newaxis]
            reach = reach + np.hypot(major * np.cos(turned), minor * np.sin(turned))
        following, further = np.roll(reach, -1, axis=1), np.roll(normals, -1)
        step = np.sin(np.pi / 16)
        x = (reach * np.sin(further) - following * np.sin(normals)) / step
        y = (following * np.cos(normals) - reach * np.cos(further)) / step
        return read_only(np.stack([x, y], axis=2))

    def plot(self, *, magnification: float | None = None, ax: Any = None) -> matplotlib.figure.Figure:
        """Draws the path with its zone.

        magnification: of the zone; where it is None, a round number by which the widest zone is about 8 % of the size of the path. ax: as
        for `Simulation.plot`. A path in space is on the page that `Motion.report` writes.
        """
        if len(self.z_m):
            raise refused("a path in space has no figure here; Motion.report() draws it", "E0207")
        return path_figure(self.point, (self.x_m, self.y_m), self.zone_m, magnification, self._display_units, ax)


PATH_UNITS = {
    "x_m": "m",
    "y_m": "m",
    "z_m": "m",
    "velocity_x_m_s": "m/s",
    "velocity_y_m_s": "m/s",
    "velocity_z_m_s": "m/s",
    "acceleration_x_m_s2": "m/s^2",
    "acceleration_y_m_s2": "m/s^2",
    "acceleration_z_m_s2": "m/s^2",
    "play_along_m": "m",
    "play_across_m": "m",
    "play_longest_m": "m",
    "scatter_major_m": "m",
    "scatter_minor_m": "m",
    "scatter_angle_rad": "rad",
}
"""SI unit of each array of a path that tables hold."""


def point_paths(summary: dict[str, Any]) -> dict[str, PointPath]:
    """The paths of a `summary.json`, by name."""
    return {record["name"]: _path(record, summary["display_units"]) for record in summary.get("paths", [])}


_LISTS = [name for name, kind in PointPath.__annotations__.items() if kind == "Array" and name != "play_reach_m"]


def _path(record: dict[str, Any], display_units: dict[str, Any]) -> PointPath:
    lists = {name: numbers(record.get(name, [])) for name in _LISTS}
    reach = read_only(numbers(record.get("play_reach_m", [])).reshape(-1, 16))
    return PointPath(name=record["name"], point=record["point"], play_reach_m=reach, _display_units=display_units, **lists)
