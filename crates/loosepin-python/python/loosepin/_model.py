"""A mechanism with its nominal values, and one run of it."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _loosepin
from ._design import InputReader, split_laws
from ._evaluation import Evaluation, evaluated
from ._extras import need
from ._figures import Line, simulation_figure
from ._notebook.html import simulation_html
from ._notebook.display import Figure, NotebookDisplay
from ._objects.arguments import file_paths, item_named, must_be, settings, texts
from ._objects.arrays import NoArray, frozen, refuse_taken
from ._objects.errors import refused
from ._objects.pickles import check_version, pickled
from ._objects.records import Record
from ._objects.stored import loaded, saved
from ._progress import Listener
from ._questions import Question, named, questions_toml
from ._records import Array, Extreme, extreme
from ._mechanism.many_runs import Simulations, simulated
from ._mechanism.run_records import STATE_UNITS, BodyStates, Lyapunov, MeasuredCurve, Orbit, Spectrum, body_states, lyapunov, measured_curves, spectra
from ._mechanism.sweep import Sweep, swept
from ._toml import to_toml
from ._warning import warn
from ._mechanism.wear import Wear
from ._mechanism.without_runs import Check, Motion

if TYPE_CHECKING:
    import matplotlib.figure
    import pandas
    import xarray

# Compiled models that are kept for the next call, which may have the same inputs and outputs.
_EVALUATORS = 4


@dataclass(frozen=True, eq=False, repr=False)
class Output(Record):
    """An output of a model: a number that every run gives at each time."""

    name: str
    """Its name in the model."""
    words: str
    """Meaning, for example "x of slider.pin"."""
    unit: str
    """SI unit of its values."""


@dataclass(frozen=True, eq=False, repr=False)
class Parameter(Record):
    """A number of a model that `simulate` and `evaluate` can set."""

    name: str
    """Its path, for example "joint.gudgeon.radial_clearance"."""
    unit: str
    """SI unit of its value; "1" for a pure number."""
    nominal: float
    """Its value in the model, SI."""


class Model(NoArray):
    """A checked mechanism with its nominal values; `Model.load("model.toml")` reads one."""

    def __init__(self, native: _loosepin.Model) -> None:
        """Use `load`, `from_text` or `from_dict`."""
        self._native = native

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Model:
        """Reads a model file. Raises LoosepinError with everything that is wrong with it."""
        must_be("a path", path=path)
        native = _loosepin.Model.load(os.fspath(path))
        warn(native.warnings)
        return cls(native)

    @classmethod
    def from_text(cls, text: str, name: str = "model") -> Model:
        """Reads a model from the text of a model file; messages call it `name`, and tables that it names are looked for beside it."""
        must_be("a str", text=text, name=name)
        native = _loosepin.Model.from_text(text, name)
        warn(native.warnings)
        return cls(native)

    @classmethod
    def from_dict(cls, mapping: Mapping[str, Any], name: str = "model") -> Model:
        """Reads a model from a dict with the keys of a model file: values with units are texts, as in the file."""
        must_be("a mapping", mapping=mapping)
        must_be("a str", name=name)
        native = _loosepin.Model.from_text(to_toml(mapping), name)
        warn(native.warnings)
        return cls(native)

    @property
    def name(self) -> str:
        """Its name."""
        return self._native.name

    @property
    def text(self) -> str:
        """The text that it was read from."""
        return self._native.text

    @cached_property
    def outputs(self) -> tuple[Output, ...]:
        """Its outputs in file order; a path in the plane is two of them, a path in space is one."""
        return tuple(Output(*output) for output in self._native.outputs())

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """Every number that can be set, in the order of the file; contact laws can be set as well, by `contact.NAME.law`."""
        return tuple(Parameter(*parameter) for parameter in self._native.parameters())

    def simulate(
        self,
        *,
        turns: float | None = None,
        transient: float | None = None,
        samples: int | None = None,
        tolerance: str = "1e-9 m",
        states: bool = False,
        second_run: bool = True,
        set: Mapping[str, str | float] | None = None,
        integrator: str = "explicit",
        lyapunov: int | None = None,
        measured: Sequence[str | os.PathLike[str]] = (),
        start: Simulation | None = None,
        paths: Sequence[str] = (),
    ) -> Simulation:
        """Runs the model once.

        turns, transient: turns that are recorded, and turns that are run before them; samples: rows for each turn; by default
        as the model file says. tolerance: a step may err by 0.5 % of it; impacts amplify errors. states: whether the motion of every
        body is recorded. second_run: whether a second run shows how long the positions can be trusted. set: values by
        their path in the model, texts with units or numbers in SI, {"joint.gudgeon.radial_clearance": 3e-4}; a law by its name. The witness
        of a bound is such a mapping.
        integrator: "explicit", or "implicit" for flexible bodies in absolute nodal coordinates. lyapunov: turns, at least 20, over which
        the largest Lyapunov exponent is measured by runs of their own. measured: CSV files of curves that are compared with the outputs,
        with a header such as "angle [deg], slider [mm]"; angles are moved by whole turns into the recorded ones, times count from the
        start of the run, before its transient. start: a run from whose end this one continues, without a transient unless one is given;
        its time goes on. paths: points "body.point" whose path, velocity and acceleration are recorded besides the outputs.

        The rows include the end of the last turn; `evaluate` leaves it out. A run that came to its end and counts as failed (E0820, E0821) is the attribute `simulation` of the `LoosepinError`.
        """
        _check_run(turns, transient, samples, tolerance)
        must_be("True or False", states=states, second_run=second_run)
        must_be("a str", integrator=integrator)
        must_be("an int or None", lyapunov=lyapunov)
        _check_start(start)
        simulation = Simulation(
            self._native.simulate(
                turns, transient, samples, tolerance, states, second_run, self._settings(set), integrator, lyapunov,
                file_paths("measured", measured), None if start is None else start._native, texts("paths", paths),
            )
        )
        warn(simulation._native.warnings)
        failure = simulation._native.failure()
        if failure is not None:
            failure.simulation = simulation
            raise failure
        return simulation

    def simulate_many(
        self,
        inputs: Mapping[str, Any],
        *,
        turns: float | None = None,
        transient: float | None = None,
        samples: int | None = None,
        tolerance: str = "1e-9 m",
        states: bool = False,
        second_run: bool = False,
        set: Mapping[str, str | float] | None = None,
        integrator: str = "explicit",
        lyapunov: int | None = None,
        measured: Sequence[str | os.PathLike[str]] = (),
        start: Simulation | None = None,
        paths: Sequence[str] = (),
        threads: int | None = None,
        progress: bool | Listener = True,
    ) -> Simulations[Simulation]:
        """Makes a recorded run, as by `simulate`, for each row of `inputs`; `evaluate` is much quicker where numbers will do.

            runs = model.simulate_many({"joint.gudgeon.radial_clearance": np.linspace(1e-4, 5e-4, 20)}, turns=2)
            runs[3]["slider"], runs.to_xarray()["slider_deviation"]

        inputs: as for `evaluate`. turns to paths: as for `simulate`, the same for all runs. threads, progress: as for `Study.run`. The runs
        are the same for any number of threads. A value that breaks a rule of the model raises LoosepinValueError with its run, before any
        run is made; a run that fails is None, with its reason in `reasons`.
        """
        _check_run(turns, transient, samples, tolerance)
        must_be("True or False", states=states, second_run=second_run)
        must_be("a str", integrator=integrator)
        must_be("an int or None", threads=threads, lyapunov=lyapunov)
        _check_start(start)
        numbers, laws = split_laws(self._native, inputs)
        names = tuple(numbers)
        table = InputReader(self._native, names, {}).read(numbers) if numbers else np.empty((1, 0))
        known = {parameter.name: parameter.unit for parameter in self.parameters}
        shared = dict(set or {}) | laws
        for name in shared:
            if name in numbers or (name in laws and set is not None and name in set):
                raise refused(f"set: '{name}' is one of the inputs as well", "E0409")
        self._native.check_rows(list(names), table, self._settings(shared), texts("paths", paths))
        sets = [
            shared | {name: self._native.text_of_value("inputs", name, value) for name, value in zip(names, row, strict=True)}
            for row in table.tolist()
        ]
        files = file_paths("measured", measured)

        def run(row: int) -> Simulation:
            return self.simulate(
                turns=turns, transient=transient, samples=samples, tolerance=tolerance, states=states, second_run=second_run,
                set=sets[row], integrator=integrator, lyapunov=lyapunov, measured=files, start=start, paths=paths,
            )

        columns = {name: table[:, place] for place, name in enumerate(names)}
        return simulated(run, len(table), columns, {name: known.get(name, "1") for name in names}, threads, progress)

    def motion(self, *, set: Mapping[str, str | float] | None = None, paths: Sequence[str] = ()) -> Motion:
        """The ideal motion over a cycle, and the quasi-static effect of play on it: the answer of `loosepin motion`, without any run.

            motion = model.motion()
            motion["slider"].worst_case.max(), motion["slider"].proven
            model.motion(paths=["rod.centre"]).paths["rod.centre"].plot()

        set: as for `simulate`. paths: points "body.point" whose paths are given besides those of outputs. Raises LoosepinError for a mechanism that its drives do not move alone.
        """
        settings = self._settings(set)
        warn(self._native.warnings_of_settings(settings))
        return Motion(self._native.motion(settings, texts("paths", paths)))

    def sweep(
        self,
        over: str,
        *,
        between: tuple[str | float, str | float] | None = None,
        values: Any = None,
        points: int = 200,
        transient: int = 200,
        turns: int = 64,
        tolerance: str = "1e-8 m",
        set: Mapping[str, str | float] | None = None,
        threads: int | None = None,
        progress: bool | Listener = True,
    ) -> Sweep:
        """Runs the model for many values of one quantity, and gives its motion once a turn: the answer of `loosepin sweep`.

            model.sweep("joint.gudgeon.radial_clearance", between=("0.05 mm", "0.5 mm"), points=400)
            model.sweep("joint.gudgeon.radial_clearance", values=np.geomspace(5e-5, 5e-4, 50))

        over: path of the quantity. between: its first and last value, texts with units or numbers in SI; `points` values are equally
        spaced between them, both included. values: an array of values in SI instead. transient, turns: turns before those that are
        examined, and these. tolerance, set: as for `simulate`. threads, progress: as for `Study.run`.

        A run that fails is NaN, with its reason in `reasons`. The result is the same for any number of threads. Ctrl-C ends it soon;
        nothing is kept. Raises LoosepinError if all runs fail.
        """
        must_be("a str", over=over, tolerance=tolerance)
        must_be("an int", points=points, transient=transient, turns=turns)
        must_be("an int or None", threads=threads)
        numbers_of_turns = (transient, turns)
        made, warnings_ = swept(
            self._native, over, between, values, points, numbers_of_turns, tolerance, self._settings(set), threads, progress
        )
        warn(warnings_)
        return made

    def wear(
        self,
        *,
        turns: float | None = None,
        transient: float | None = None,
        samples: int | None = None,
        tolerance: str = "1e-9 m",
        set: Mapping[str, str | float] | None = None,
    ) -> Wear[Simulation]:
        """Runs a cycle, and gives the wear of the joints with `[joint.NAME.wear]` after the cycles of `[wear]`: `loosepin wear`.

        turns: in one cycle. transient: before it. samples: rows for each turn; all as the model file says by default. tolerance, set: as for `simulate`, with
        {"wear.cycles": "1e6"}. Raises LoosepinError where no joint wears.
        """
        self._native.demand_wear()
        simulation = self.simulate(turns=turns, transient=transient, samples=samples, tolerance=tolerance, set=set)
        return Wear(simulation)

    def check(self) -> Check:
        """Moves the mechanism for the first time, and describes it: bodies, joints, mobility, start, first steps, as `loosepin check`.

        Raises LoosepinError with what keeps it from running.
        """
        return Check(self._native.check())

    def evaluate(
        self,
        inputs: Mapping[str, Any],
        outputs: Question | Sequence[str] | Mapping[str, Question],
        *,
        turns: float | None = None,
        transient: float | None = None,
        samples: int | None = None,
        tolerance: str = "1e-8 m",
        threads: int | None = None,
        progress: bool | Listener = True,
    ) -> Evaluation:
        """Makes runs with other values of some parameters, and gives outputs of each as arrays.

            model.evaluate({"joint.gudgeon.radial_clearance": np.linspace(1e-4, 5e-4, 200)}, ["slider clearance maximum_absolute"])

        inputs: by their paths in the model, as for `set` of `simulate`: for each one number, a text with its unit, or an array with one
        dimension, SI; one value stands for all runs. The law of a contact is its name. What is not named is as in the model.
        outputs: names as results have them (`Study.recorded`): an output of the model, the deviation ("value", "dimensional",
        "clearance" or "total"), and behind them a reduction ("maximum", "rms", ...), an angle ("at 1.5 rad"), or nothing for the whole
        curve. Or a mapping from names of your own to such names or to dicts with the keys of `[[ask]]` without statistics: `output`,
        `component`, `of`, and one of `at`, `poses` and `reduce`; the angles of `poses` are a curve.
        turns, transient, samples: as for `simulate`. tolerance: as in `[sampling]` of a study. A curve has an entry for each sample but the
        end of the last turn, at the angles `pose_rad`, which count from the start angle of the drive; the rows of `simulate` include that
        end, and their angles count on through the transient.

        The ideal motion that "total" and "dimensional" are measured from is that of the model as it is, whatever the inputs; "clearance" is
        measured from the same lengths without play. The runs are those of a study: the same engine, and so are threads, progress, failed
        runs, Ctrl-C and errors, see `Study.evaluate`.
        """
        _check_run(turns, transient, samples, tolerance)
        must_be("an int or None", threads=threads)
        numbers, laws = split_laws(self._native, inputs)
        questions = named(outputs)
        key = (tuple(numbers), tuple(laws.items()), questions_toml(self._native, questions), turns, transient, samples, tolerance)
        native = self._evaluators.get(key)
        if native is None:
            native = _loosepin.Evaluator.of_model(self._native, list(key[0]), list(key[1]), *key[2:])
            while len(self._evaluators) >= _EVALUATORS:
                del self._evaluators[next(iter(self._evaluators))]
            self._evaluators[key] = native
        table = InputReader(self._native, key[0], {}).read(numbers) if numbers else np.empty((1, 0))
        recorded = {}
        for (name, question), (own, unit, poses, columns) in zip(questions.items(), native.asked(), strict=True):
            is_single = isinstance(question, str) and len(columns) == 1
            recorded[name] = (own, unit, None if is_single else poses, columns)
        units = dict(zip(key[0], native.input_units(), strict=True))
        return evaluated(native, (key[0], units, table), recorded, threads, progress, lambda warning: warnings.warn(warning, stacklevel=4))

    @cached_property
    def _evaluators(self) -> dict[Any, _loosepin.Evaluator]:
        return {}

    def _settings(self, set: Mapping[str, str | float] | None) -> list[str]:
        return settings("set", set, self._native)

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (_loosepin.__version__, self._native.texts())

    def __eq__(self, other: object) -> bool:
        """Whether both were read from the same texts, tables included; the names of their files do not count."""
        return isinstance(other, Model) and self._content() == other._content()

    def __hash__(self) -> int:
        return hash(self.text)

    def _content(self) -> tuple[str, list[str]]:
        (_, model), tables = self._native.texts()
        return model, [table for _, table in tables]

    def __repr__(self) -> str:
        return f"<loosepin.Model {self.name!r}>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td><code>{escape(each.name)}</code></td><td>{escape(each.words)}</td><td>{escape(each.unit)}</td></tr>"
            for each in self.outputs
        )
        head = "<tr><th>output</th><th>what</th><th>SI unit</th></tr>"
        return f"<p><b>{escape(self.name)}</b>, a mechanism</p><table>{head}{rows}</table>"


def _check_start(start: Any) -> None:
    if start is not None and not isinstance(start, Simulation):
        raise TypeError(f"start is a {type(start).__name__}; must be a loosepin.Simulation or None")


def _check_run(turns: float | None, transient: float | None, samples: int | None, tolerance: str) -> None:
    must_be("a number or None", turns=turns, transient=transient)
    must_be("an int or None", samples=samples)
    must_be("a str", tolerance=tolerance)


def _unpickled(version: str, texts: Any) -> Model:
    """The model that was pickled by its texts: that of its file, and the tables that it names."""
    check_version("model", version)
    return Model(_loosepin.Model.from_texts(texts))


class Simulation(NotebookDisplay, NoArray, Mapping[str, Array]):
    """One run: `simulation["slider"]` holds the values of an output at `simulation.time_s`, SI.

    All arrays have one entry for each row of `history.csv`, and are read-only.
    """

    def __init__(self, native: _loosepin.Simulation) -> None:
        """Use `Model.simulate`."""
        self._native = native
        history = native.history()
        ideal, deviation = native.ideal_and_deviation()
        for column in (*history, *ideal, *deviation):
            frozen(column.values)
        self.history: dict[str, Array] = {column.name: column.values for column in history}
        """The columns of `history.csv` by name, units in the names: `time_s`, the angle of the drive, outputs, states."""
        self.time_s: Array = history[0].values
        """Times of the rows since the start of the run, s."""
        self.drive_angle_rad: Array = history[1].values
        """Angle of the drive, continuous over turns, rad."""
        outputs = native.outputs()
        self._values: dict[str, Array] = {
            name: column.values for (name, _), column in zip(outputs, history[2:])
        }
        self.ideal: dict[str, Array] = {column.name: column.values for column in ideal}
        """Each output of the mechanism with the same values, those of `set` included, but without play; in its SI unit."""
        self.deviation: dict[str, Array] = {column.name: column.values for column in deviation}
        """Each output minus `ideal`, in its SI unit: of the same lengths without play, values of `set` included.

        This is what `Model.evaluate` and a study call "clearance"; without `set` it is "total" as well. The summary calls it "total".
        """
        self.units: dict[str, str] = dict(outputs)
        """SI unit of each output."""

    @classmethod
    def load(cls, folder: str | os.PathLike[str]) -> Simulation:
        """Reads the finished run in a folder of results, which `save` or `loosepin simulate --out` wrote. Nothing in it is changed.

        Raises LoosepinError if the folder holds no finished run, or one of its files is not as it was written.
        """
        return cls(loaded(_loosepin.Simulation.load, folder))

    def save(self, folder: str | os.PathLike[str], *, force: bool = False) -> Path:
        """Writes the files of `loosepin simulate --out` into a folder: summary.json, history.csv, impacts.csv, report.html and so on.

        force: replaces other results there. Raises LoosepinError if the folder holds something else. Returns the folder.
        """
        return saved(self._native, folder, force)

    def __getitem__(self, name: str) -> Array:
        return item_named(self._values, name, "output")

    def __iter__(self) -> Any:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The run as `summary.json` has it: settings, extremes, joints, impacts, energy, counters; SI."""
        summary: dict[str, Any] = json.loads(self._native.summary_json())
        return summary

    @cached_property
    def states(self) -> dict[str, BodyStates]:
        """Motion of each body by its name, if `states=True` was asked for."""
        return body_states(self.history, 2 + len(self) + len(self.ideal) + len(self.deviation))

    @cached_property
    def orbits(self) -> dict[str, Orbit]:
        """Path of each pin in its clearance, by the name of its joint."""
        return {orbit[0]: Orbit(*frozen(orbit)) for orbit in self._native.orbits()}

    @cached_property
    def contact_forces_n(self) -> dict[str, Array]:
        """Normal force of each contact, 0 in free flight: by the name of the joint, for a corner of a block `guide (upper front)`."""
        forces: dict[str, Array] = frozen(dict(self._native.contact_forces()))
        return forces

    @cached_property
    def spectra(self) -> dict[str, Spectrum]:
        """The columns of `spectrum.csv`: by the name of each output, and `gudgeon.contact_force` for the force of a contact.

        Empty where no drive turns at constant speed, or less than a turn was recorded.
        """
        return spectra(self._native.spectra())

    @cached_property
    def lyapunov(self) -> Lyapunov | None:
        """The largest Lyapunov exponent, if it was asked for."""
        return lyapunov(self.summary["lyapunov"])

    @cached_property
    def measured(self) -> tuple[MeasuredCurve, ...]:
        """The measured curves beside the computed ones, in the order of the files and of their columns."""
        return measured_curves(self.summary.get("measured", ()))

    @property
    def impacts(self) -> list[dict[str, Any]]:
        """Every impact in the order of time: `time_s`, `joint`, `speed_m_s`, `duration_s`, `peak_force_n`, ..."""
        impacts: list[dict[str, Any]] = self.summary["impacts"]
        return impacts

    @cached_property
    def extremes(self) -> tuple[Extreme, ...]:
        """The smallest and the largest value of each output, then of each deviation, over the recorded time, with their times.

        They are found on the motion itself, between the rows as well: np.max(simulation["slider"]) is the largest value at the rows, and
        misses a peak between two of them.
        """
        return tuple(extreme(record) for record in self.summary["extremes"])

    def series(self) -> dict[str, tuple[Array, str]]:
        """Each history with its SI unit, by the name that it has in `to_xarray`."""
        found: dict[str, tuple[Array, str]] = {}

        def add(name: str, values: Array, unit: str) -> None:
            refuse_taken(name, [*found, "time_s", "drive_angle_rad"])
            found[name] = (values, unit)

        for suffix, columns in (("", self._values), ("_ideal", self.ideal), ("_deviation", self.deviation)):
            for name, values in columns.items():
                add(name + suffix, values, self.units[name])
        for joint, orbit in self.orbits.items():
            add(f"{joint}.orbit_x", orbit.x_m, "m")
            add(f"{joint}.orbit_y", orbit.y_m, "m")
        for contact, force_n in self.contact_forces_n.items():
            add(f"{contact}.contact_force", force_n, "N")
        for body, states in self.states.items():
            for what, unit in STATE_UNITS.items():
                add(f"{body}.{what}", getattr(states, what), unit)
        return found

    def to_pandas(self) -> pandas.DataFrame:
        """The history as a DataFrame with the columns of `history.csv`."""
        pandas_ = need("pandas", "to_pandas()")
        frame: pandas.DataFrame = pandas_.DataFrame(self.history)
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """All histories over `time_s` as a Dataset; units in the attributes.

        The outputs are `slider`, `slider_ideal`, `slider_deviation`; the path of a pin in its bearing `gudgeon.orbit_x` and
        `gudgeon.orbit_y`; the normal force of a contact `gudgeon.contact_force`; states of bodies, if they were recorded, `rod.x_m` and so on.
        """
        xarray_ = need("xarray", "to_xarray()")
        variables: dict[str, Any] = {name: ("time_s", values, {"units": unit}) for name, (values, unit) in self.series().items()}
        coordinates = {
            "time_s": ("time_s", self.time_s, {"units": "s"}),
            "drive_angle_rad": ("time_s", self.drive_angle_rad, {"units": "rad"}),
        }
        dataset: xarray.Dataset = xarray_.Dataset(variables, coordinates, {"model": self._native.model}).copy(deep=True)
        return dataset

    def plot(self, *outputs: str, deviation: bool = False, ax: Any = None) -> matplotlib.figure.Figure:
        """Draws outputs over the angle of the drive (all of them where none is named), or their deviations from the ideal motion.

        ax: axes of matplotlib to draw into, one for each output; a new figure if omitted. Returns the figure. It is not shown, and
        figures of the caller stay open. Raises KeyError for an output that the run does not have.
        """
        lines = [self._line(name, deviation) for name in outputs or self if not deviation or name in self.deviation]
        return simulation_figure(self.drive_angle_rad, lines, self.summary["display_units"], ax)

    def _line(self, name: str, is_deviation: bool) -> Line:
        if is_deviation:
            return Line(name, f"{name}, deviation", self.units[name], self.deviation[name], None, has_legend=False)
        return Line(name, name, self.units[name], self[name], self.ideal.get(name), has_legend=True)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Writes the page that the command `loosepin simulate` writes: one file, readable without a network."""
        must_be("a path", path=path)
        path = Path(path)
        path.write_text(self._native.page(), encoding="utf-8", newline="\n")
        return path

    def __reduce__(self) -> tuple[Any, ...]:
        return pickled("Simulation", _restored, self._native.parts())

    def __eq__(self, other: object) -> bool:
        """Whether both have the same numbers: histories, impacts and summary."""
        return isinstance(other, Simulation) and self._native.parts() == other._native.parts()

    def __hash__(self) -> int:
        return hash((self._native.model, len(self.time_s), tuple(self)))

    def __str__(self) -> str:
        return self.text()

    def text(self, *, all: bool = False) -> str:
        """What `print` shows: the answer, warnings and main tables; with `all`, every table and how it was computed."""
        return self._native.text(all)

    def __repr__(self) -> str:
        return f"<loosepin.Simulation of {self._native.model!r}, {len(self.time_s)} rows, outputs {', '.join(self)}>"

    def _repr_html_(self) -> str:
        counts = f"{len(self.time_s)} rows, {len(self.impacts)} impacts"
        return simulation_html(self._native.model, counts, self.extremes, self._native.excerpt(), self.summary["display_units"])

    def _figure(self) -> Figure:
        return Figure(self._native.model, *self._native.frame())


def _restored(parts: Any) -> Simulation:
    return Simulation(_loosepin.Simulation.from_parts(parts))
