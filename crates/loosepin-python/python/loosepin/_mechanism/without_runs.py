"""Answers without runs: the ideal motion with worst cases of the play, and the check of a file."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import _loosepin
from .._extras import need
from .._figures import motion_figure, shown
from .._objects.arguments import item_named
from .._objects.arrays import NoArray
from .._objects.pickles import pickled
from .._objects.records import Record
from .._objects.stored import loaded, saved
from .._records import Array, numbers
from .paths import PATH_UNITS, PointPath, point_paths

if TYPE_CHECKING:
    import matplotlib.figure
    import pandas
    import xarray


@dataclass(frozen=True, eq=False, repr=False)
class OutputMotion(Record):
    """An output over the cycle, and what play and scatter do to it without dynamics.

    All arrays have one entry for each of `Motion.drive_angle_rad`, in `unit`; those that do not apply are empty.
    """

    name: str
    """Name of the output."""
    words: str
    """Meaning, for example "x of slider.pin"."""
    unit: str
    """SI unit of the values."""
    value: Array
    """Ideal value; empty for an error of a path, as velocity and acceleration are then."""
    velocity: Array
    """Its time derivative at the speed of the drive."""
    acceleration: Array
    """Its second time derivative."""
    worst_case: Array
    """Largest magnitude of the deviation by play that was found."""
    found: tuple[Array, Array]
    """Lowest and highest deviation by play that were found."""
    proven: tuple[Array, Array]
    """Deviations that no play exceeds; infinite where nothing is proven."""
    first_order: Array
    """Sum of the first-order effects of all joints: a preview of the worst case, which may be larger."""
    disc_standard_deviation: Array
    """Standard deviation with the pins anywhere in their clearances."""
    rim_standard_deviation: Array
    """Standard deviation with the pins on the rims of their bearings."""
    dimensional_standard_deviation: Array
    """Standard deviation by the random inputs of a study; empty without a study."""
    joints: dict[str, Array]
    """Part of each joint with play in `first_order`, by its name."""
    searched: tuple[dict[str, Any], ...]
    """In space, in place of `worst_case`, `found` and `proven`: searches where `first_order` is largest, as in `summary.json`; empty in the plane."""
    dimensions: dict[str, Array]
    """Standard deviation by each random input of a study alone, by its path."""


_PER = {"velocity": "/s", "acceleration": "/s^2"}
"""What the units of derivatives have on top of those of outputs."""


class Motion(NoArray, Mapping[str, OutputMotion]):
    """The ideal motion over one cycle, with the quasi-static effect of play and scatter: `motion["slider"].worst_case`.

    It holds the outputs that are positions or angles, in file order. No run is made.
    """

    def __init__(self, native: _loosepin.Motion) -> None:
        """Use `Model.motion` or `Study.motion`."""
        self._native = native
        self._outputs = {record["name"]: _output(record) for record in self.summary["outputs"]}
        self.drive_angle_rad: Array = numbers(self.summary["drive_angle_rad"])
        """Angle of the drive over the cycle, rad."""
        self.efforts: dict[str, Array] = {each["name"]: numbers(each["value_si"]) for each in self.summary["efforts"]}
        """Torques, forces and powers of drives among the outputs, for the ideal motion, in `units`."""
        self.paths: dict[str, PointPath] = point_paths(self.summary)
        """Paths of points with their zones: of outputs that are paths, then of those asked for."""
        kinematics = self.summary.get("kinematics", {})
        self.transmission_angles_rad: dict[str, Array] = {
            " ".join(each["bodies"]): numbers(each["value_rad"]) for each in kinematics.get("transmission_angles", []) if "value_rad" in each
        }
        """Transmission angle of each loop that a drive at the ground moves, by "coupler rocker"; pressure angle, by "rod slider"."""
        self.mechanical_advantages: dict[str, Array] = {
            each["name"]: numbers(each["value_si"]) for each in kinematics.get("mechanical_advantages", [])
        }
        """Force or torque on each output that balances a unit torque of the drive, in 1/m or 1; infinite in dead centres."""
        self.units: dict[str, str] = {each["name"]: each["unit"] for key in ("outputs", "efforts") for each in self.summary[key]}
        """SI unit of each output."""

    def __getitem__(self, name: str) -> OutputMotion:
        return item_named(self._outputs, name, "position or angle")

    def __iter__(self) -> Iterator[str]:
        return iter(self._outputs)

    def __len__(self) -> int:
        return len(self._outputs)

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The answer as `summary.json` has it; SI. Numbers that are not finite are "inf", "-inf" or "nan"."""
        summary: dict[str, Any] = json.loads(self._native.summary_json())
        return summary

    @property
    def kinematics(self) -> dict[str, Any]:
        """Classes of loops, swings, dead centres, time ratios and transmission angles, as in `summary.json`."""
        kinematics: dict[str, Any] = self.summary.get("kinematics", {})
        return kinematics

    @property
    def requirements(self) -> list[dict[str, Any]]:
        """The requirements of a study with their `verdict`: "met", "not_met_in_the_worst_case", "undecided" or "needs_dynamics"."""
        requirements: list[dict[str, Any]] = self.summary.get("requirements", [])
        return requirements

    @property
    def is_met(self) -> bool:
        """Whether all requirements are met in the worst case, which decides the exit status of the command."""
        return all(requirement["verdict"] == "met" for requirement in self.requirements)

    @property
    def allowances(self) -> list[dict[str, Any]]:
        """What a study may loosen, and how far all requirements are still met, as in `summary.json`."""
        allowances: list[dict[str, Any]] = self.summary.get("allowances", [])
        return allowances

    @property
    def asked(self) -> list[dict[str, Any]]:
        """What joints with play and scattering dimensions contribute at each pose of a requirement or a question of a study, those of requirements
        first, as in `summary.json`. Elsewhere: `joints` and `dimensions` of each output."""
        asked: list[dict[str, Any]] = self.summary.get("asked", [])
        return asked

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with a row for each angle and columns such as `slider worst_case`; those that are empty are left out."""
        pandas_ = need("pandas", "to_pandas()")
        columns = {"drive_angle_rad": self.drive_angle_rad}
        columns |= {f"{name} {what}": values for name, what, values, _ in self._columns()} | self.efforts
        frame: pandas.DataFrame = pandas_.DataFrame(columns)
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """A Dataset over `drive_angle_rad` with variables such as `slider worst_case`; units are in the attributes."""
        xarray_ = need("xarray", "to_xarray()")
        variables = {f"{name} {what}": ("drive_angle_rad", values, {"units": unit}) for name, what, values, unit in self._columns()}
        variables |= {name: ("drive_angle_rad", values, {"units": self.units[name]}) for name, values in self.efforts.items()}
        coordinates = {"drive_angle_rad": ("drive_angle_rad", self.drive_angle_rad, {"units": "rad"})}
        dataset: xarray.Dataset = xarray_.Dataset(variables, coordinates, {"model": self.summary["model"]}).copy(deep=True)
        return dataset

    def _columns(self) -> Iterator[tuple[str, str, Array, str]]:
        """Output, quantity, values and SI unit of everything that an output has over the cycle."""
        for name, output in self.items():
            values = {
                "value": output.value,
                "velocity": output.velocity,
                "acceleration": output.acceleration,
                "worst_case": output.worst_case,
                "lowest": output.found[0],
                "highest": output.found[1],
                "proven_lowest": output.proven[0],
                "proven_highest": output.proven[1],
                "disc_standard_deviation": output.disc_standard_deviation,
                "rim_standard_deviation": output.rim_standard_deviation,
                "dimensional_standard_deviation": output.dimensional_standard_deviation,
            }
            values |= {f"first_order of {joint}": of_joint for joint, of_joint in output.joints.items()}
            values |= {f"standard_deviation of {path}": of_path for path, of_path in output.dimensions.items()}
            for what, each in values.items():
                if len(each):
                    yield name, what, each, output.unit + _PER.get(what, "")
        for path in self.paths.values():
            for what, unit in PATH_UNITS.items():
                each = getattr(path, what)
                if len(each):
                    yield path.name, what, each, unit
        for bodies, each in self.transmission_angles_rad.items():
            yield bodies, "transmission_angle_rad", each, "rad"
        for name, each in self.mechanical_advantages.items():
            yield name, "mechanical_advantage", each, "1" if name in self and self[name].unit == "rad" else "1/m"

    def plot(self, *outputs: str, ax: Any = None) -> matplotlib.figure.Figure:
        """Draws the worst case of the play over the cycle: what was found, and what is proven; all outputs where none is named.

        ax: as for `Simulation.plot`.
        """
        drawn = [(self[name].name, self[name].unit, self[name].found, self[name].proven) for name in outputs or self]
        return motion_figure(self.drive_angle_rad, drawn, self.summary["display_units"], ax)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the page that the command `loosepin motion` writes: one file, readable without a network."""
        self._native.write_page(os.fspath(path))
        return Path(path)

    @classmethod
    def load(cls, folder: str | os.PathLike[str]) -> Motion:
        """Reads the finished motion in a folder of results, which `save` or `loosepin motion --out` wrote. Nothing in it is changed."""
        return cls(loaded(_loosepin.Motion.load, folder))

    def save(self, folder: str | os.PathLike[str], *, force: bool = False) -> Path:
        """Writes the files of `loosepin motion --out` into a folder: motion.csv, summary.json and report.html.

        force: replaces other results there. Raises LoosepinError if the folder holds something else. Returns the folder.
        """
        return saved(self._native, folder, force)

    def __reduce__(self) -> tuple[Any, ...]:
        return pickled("Motion", _restored, self._native.summary_json())

    def __eq__(self, other: object) -> bool:
        """Whether both have the same numbers: those of `summary.json`."""
        return isinstance(other, Motion) and self._native.summary_json() == other._native.summary_json()

    def __hash__(self) -> int:
        return hash((Motion, self.summary["model"], tuple(self)))

    def __str__(self) -> str:
        return self.text()

    def text(self, *, all: bool = False) -> str:
        """What `print` shows: the answer, warnings and main tables; with `all`, every table and how it was computed."""
        return self._native.text(all)

    def __repr__(self) -> str:
        return f"<loosepin.Motion of {self.summary['model']!r}, {len(self.drive_angle_rad)} angles, outputs {', '.join(self)}>"

    def _repr_html_(self) -> str:
        units, rows = self.summary["display_units"], ""
        for name, output in self.items():
            unit, factor = shown(output.unit, units)
            largest = (output.worst_case, output.disc_standard_deviation)
            cells = "".join(f"<td>{f'{values.max() * factor:.4g} {escape(unit)}' if len(values) else ''}</td>" for values in largest)
            rows += f"<tr><td>{escape(name)}</td><td>{escape(output.words)}</td>{cells}</tr>"
        head = "<tr><th>output</th><th>what</th><th>worst case of the play</th><th>standard deviation</th></tr>"
        return f"<p><b>{escape(self.summary['model'])}</b>, without dynamics</p>{self._native.picture()}<table>{head}{rows}</table>"


def _restored(summary: str) -> Motion:
    return Motion(_loosepin.Motion.from_json(summary))


def _output(record: dict[str, Any]) -> OutputMotion:
    clearance = record["clearance"]
    return OutputMotion(
        name=record["name"],
        words=record["words"],
        unit=record["unit"],
        value=numbers(record["value_si"]),
        velocity=numbers(record["velocity_si"]),
        acceleration=numbers(record["acceleration_si"]),
        worst_case=numbers(clearance["worst_case_si"]),
        found=(numbers(clearance["lowest_si"]), numbers(clearance["highest_si"])),
        proven=(numbers(clearance["proven_lowest_si"]), numbers(clearance["proven_highest_si"])),
        first_order=numbers(clearance["first_order_si"]),
        disc_standard_deviation=numbers(clearance["disc_standard_deviation_si"]),
        rim_standard_deviation=numbers(clearance["rim_standard_deviation_si"]),
        dimensional_standard_deviation=numbers(record["dimensional_standard_deviation_si"]),
        joints={each["joint"]: numbers(each["first_order_si"]) for each in clearance["contributors"]},
        searched=tuple(clearance.get("searched", [])),
        dimensions={each["path"]: numbers(each["standard_deviation_si"]) for each in record["dimensional_contributors"]},
    )


@dataclass(frozen=True, eq=False, repr=False)
class CheckSection(Record):
    """What a check says of one subject."""

    name: str
    """Short name that does not change with the numbers: "bodies", "joints", "mobility", "start", ..."""
    heading: str
    """Heading; empty where there is none."""
    facts: tuple[tuple[str, tuple[str, ...]], ...]
    """Names with what is said of each, line by line. The name of a sentence is empty."""


class Check(Record, Mapping[str, CheckSection]):
    """Description of a model or a study before it runs: `print(model.check())` shows what `loosepin check` prints."""

    def __init__(self, native: _loosepin.Check) -> None:
        """Use `Model.check` or `Study.check`."""
        self.title: str = native.title
        """Name of the model or the study, and what it is."""
        self.text: str = native.text()
        """The whole description, as on a terminal."""
        self.sections: tuple[CheckSection, ...] = tuple(
            CheckSection(name, heading, tuple((subject, tuple(lines)) for subject, lines in facts))
            for name, heading, facts in native.sections()
        )
        """Its sections in their order."""

    def __getitem__(self, name: str) -> CheckSection:
        """The section of this name."""
        return item_named({section.name: section for section in self.sections}, name, "section")

    def __iter__(self) -> Iterator[str]:
        return iter(dict.fromkeys(section.name for section in self.sections))

    def __len__(self) -> int:
        return len(dict.fromkeys(section.name for section in self.sections))

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<loosepin.Check {self.title!r}: {', '.join(section.name for section in self.sections)}; print() shows it>"

    def _repr_html_(self) -> str:
        return f"<pre>{escape(self.text)}</pre>"
