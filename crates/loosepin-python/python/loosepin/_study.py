"""A study: the uncertain inputs of a model, and the questions."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

from . import _loosepin
from ._cluster import run_provider
from ._design import InputReader, StudyInput, read_points, study_inputs
from ._evaluation import Evaluation, evaluated
from ._function_bounds import FunctionBounds, Statistic, growth, requests, table
from ._identification import Identification, MotionPlan
from ._model import Model
from ._objects.arguments import must_be, settings, texts
from ._objects.arrays import NoArray
from ._objects.errors import refused
from ._objects.goals import Accuracy, stated_accuracies, stated_budget
from ._objects.logs import long_run
from ._objects.pickles import check_version
from ._objects.seeds import seed_number
from ._progress import Listener, listener
from ._records import Array
from ._result import StudyResult
from ._toml import to_toml
from ._warning import warn
from ._mechanism.without_runs import Check, Motion


class Study(NoArray):
    """A checked study; `Study.load("study.toml")` reads one with its model."""

    def __init__(self, native: _loosepin.Study) -> None:
        """Use `load`, `from_text` or `from_dict`."""
        self._native = native

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Study:
        """Reads a study file and the model that it names. Raises LoosepinError with everything that is wrong with either."""
        must_be("a path", path=path)
        native = _loosepin.Study.load(os.fspath(path))
        warn(native.warnings)
        return cls(native)

    @classmethod
    def from_text(cls, text: str, model: Model | None = None, name: str = "study") -> Study:
        """Reads a study from the text of a study file, of `model` or else of the model file that its key `model` names.

        The key must be there in any case; where a `model` is given, its value is not looked at.
        Messages call the text `name`; files that it names are looked for beside it.
        """
        must_be("a str", text=text, name=name)
        _check_model(model)
        native = _loosepin.Study.from_text(text, name, None if model is None else model._native)
        warn(native.warnings)
        return cls(native)

    @classmethod
    def from_dict(cls, mapping: Mapping[str, Any], model: Model | None = None, name: str = "study") -> Study:
        """Reads a study from a dict with the keys of a study file. Its key `model` may hold a `Model` instead of a path,
        its key `seed` also a `numpy.random.Generator`, a `SeedSequence`, or None for a seed from the operating system."""
        must_be("a mapping", mapping=mapping)
        must_be("a str", name=name)
        _check_model(model)
        mapping = dict(mapping)
        if "seed" in mapping:
            mapping["seed"] = seed_number(mapping["seed"])
        if isinstance(mapping.get("model"), Model):
            model = mapping["model"]
        if model is not None:
            mapping["model"] = model.name
        native = _loosepin.Study.from_text(to_toml(mapping), name, None if model is None else model._native)
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

    @property
    def model(self) -> Model:
        """Its model, with the values of the model file."""
        return Model(self._native.model)

    @property
    def most_runs(self) -> int:
        """How many runs it comes to at most."""
        return self._native.most_runs()

    def run(
        self,
        folder: str | os.PathLike[str] | None = None,
        *,
        resume: bool = False,
        force: bool = False,
        threads: int | None = None,
        progress: bool | Listener = True,
        accuracy: Sequence[str] | Mapping[str, float | str] = (),
        budget: int | str | None = None,
        client: Any = None,
        paths: Sequence[str] = (),
    ) -> StudyResult:
        """Runs the study on all cores, without the lock of the interpreter. The numbers are the same for any number of threads.

        folder: where the files of the results go, those of the command `loosepin study`, and where finished runs are kept within a
        second, so that nothing is lost; nothing is written where it is left out. A folder that holds the finished result already gives it at once.
        resume: goes on with the runs that an interrupted call left in the folder; force: replaces what is there.
        progress: True shows a line in a terminal or a notebook; a callable gets (finished, at most) runs.
        accuracy, budget: in addition to those of the study, for example accuracy=["slider.mean=1 um"] or
        {"slider.mean": 1e-6} in SI, budget="20000 runs" or 20000.
        client: a `distributed.Client`: the runs are made by the workers of its Dask cluster, which have the same version of loosepin
        installed; the numbers are the same. Rounds, folder and bounds stay here, on `threads` threads.
        paths: points "body.point" whose paths the report shows besides those of outputs, each with the zone in which play and scatter let it
        be without dynamics.

        Ctrl-C ends it after the runs under way. Raises LoosepinError where the study cannot be run.
        """
        must_be("a path or None", folder=folder)
        must_be("True or False", resume=resume, force=force)
        must_be("an int or None", threads=threads)
        if resume and force:
            raise refused("resume and force exclude each other: one keeps the runs in the folder, the other replaces them", "E0205")
        if resume and folder is None:
            raise refused("resume needs the folder with the runs", "E0205")
        # Only numbers without a unit need that of their output.
        units = {output.name: output.unit for output in self.model.outputs} if accuracy else {}
        stated = stated_accuracies(accuracy, units)
        most = stated_budget(budget)
        place = None if folder is None else os.fspath(folder)
        with long_run(f"study {self.name!r}", listener(progress)) as notify:
            made = None if client is None else run_provider(client, self._native, tuple(stated), most)
            native = self._native.run(place, resume, force, threads, notify, stated, most, made, texts("paths", paths))
        return StudyResult(native)

    def motion(self, *, set: Mapping[str, str | float] | None = None, paths: Sequence[str] = ()) -> Motion:
        """The ideal motion, the quasi-static effect of play and of the random inputs on it, and what of `[[require]]` and `[allow]` can be
        judged without dynamics: the answer of `loosepin motion`.

        Clearances that are uncertain are taken where there is most play. set: as for `Model.simulate`. paths: as for `Model.motion`.
        """
        given = settings("set", set, self.model._native)
        warn(self._native.warnings_of_settings(given))
        return Motion(self._native.motion(given, texts("paths", paths)))

    def check(self) -> Check:
        """Describes the study and its mechanism before anything runs: inputs, questions, number of runs, time, as `loosepin check`.

        Raises LoosepinError with what keeps it from running.
        """
        return Check(self._native.check())

    def identify(
        self,
        *,
        points: int = 400,
        confidence: float = 0.99,
        specimen: str | None = None,
        posterior: bool = False,
        lengths: bool = False,
        threads: int | None = None,
        progress: bool | Listener = True,
    ) -> Identification[Study]:
        """Which values of the unknowns are consistent with the `[[measured]]` tables: the answer of `loosepin identify`.

        points: values of the unknowns at which a motion is tested, about at most. confidence: probability with which all bounds of a
        specimen hold together. specimen: the one whose readings and features count; all, each by itself, where it is left out.
        posterior: whether the posterior distribution of the unknowns of a motion is given as well, by the same runs.
        lengths: whether mechanisms whose lengths agree with the motion are drawn; `narrowed` then is a study of these.
        progress: as for `run`; a callable gets (finished, at most) values.

        Ctrl-C ends it when the runs of the present values are finished. Raises LoosepinError where nothing can be identified.
        """
        must_be("an int", points=points)
        must_be("a number", confidence=confidence)
        must_be("a str or None", specimen=specimen)
        must_be("True or False", posterior=posterior, lengths=lengths)
        must_be("an int or None", threads=threads)
        with long_run(f"identification of study {self.name!r}", listener(progress, "values")) as notify:
            return Identification(self._native.identify(points, confidence, specimen, posterior, lengths, threads, notify), Study)

    def plan_motion(
        self,
        *,
        confidence: float = 0.99,
        specimen: str | None = None,
        threads: int | None = None,
        progress: bool | Listener = True,
    ) -> MotionPlan:
        """What features of the motion would tell, before anything is measured."""
        must_be("a number", confidence=confidence)
        must_be("a str or None", specimen=specimen)
        must_be("an int or None", threads=threads)
        with long_run(f"plan of a motion of study {self.name!r}", listener(progress, "values")) as notify:
            record, text = self._native.plan_motion(confidence, specimen, threads, notify)
        return MotionPlan(text, record)

    @cached_property
    def recorded(self) -> dict[str, str]:
        """SI unit of everything that each run records, by the name under which `bounds` hands it to a function."""
        return {name: unit for name, unit, _ in self._native.recorded()}

    @cached_property
    def inputs(self) -> tuple[StudyInput, ...]:
        """Its uncertain inputs in the order of the columns of a design: random ones, then unknown ones, each kind in file order."""
        return study_inputs(self._native)

    def design(self, points: Any) -> Array:
        """The inputs at points of the unit cube, SI: a design for `evaluate`, of the same shape.

        points: a row for each run and a column for each of `inputs`, between 0 and 1, both excluded. A random input takes the value of
        its distribution at that probability, correlations of the study included. An unknown input is taken as uniform over its range, a
        list as equally probable, as in the treatment `probability_only`.
        """
        return self._evaluator.inputs_at(read_points(points, [each.name for each in self.inputs]))

    def evaluate(self, inputs: Any, *, threads: int | None = None, progress: bool | Listener = True) -> Evaluation:
        """Makes a run for each row of `inputs`, and gives everything that the study records of each, as arrays.

        inputs: an array of the shape (runs, inputs), its columns in the order of `Study.inputs`; or a mapping (or a DataFrame) that has
        for each input one number or an array with one dimension; one number stands for all runs. SI; a text has its unit, the law of a
        contact is its name. The values may lie anywhere, also outside of the distribution or the interval that the study states.

        Columns, deviations, turns and tolerance are those of the study; its samples, statistics and requirements play no part. All
        cores run without the lock of the interpreter. A run has the same bits whatever stands in the other rows, for any number of threads,
        and those that it has in `Study.run`. A run that fails is not-a-number, with its reason in `reasons`.

        progress: as for `run`. Ctrl-C ends it after the runs under way; nothing is kept. Raises ValueError, TypeError or LoosepinError
        for an argument that is wrong, with its name.
        """
        must_be("an int or None", threads=threads)
        names = [each.name for each in self.inputs]
        laws = {each.name: each.laws for each in self.inputs if each.laws is not None}
        table = InputReader(self._native.model, names, laws).read(inputs)
        recorded = {output[0]: output for output in self._evaluator.recorded()}
        units = {each.name: each.unit for each in self.inputs}
        return evaluated(self._evaluator, (names, units, table), recorded, threads, progress, lambda warning: warnings.warn(warning, stacklevel=4))

    @cached_property
    def _evaluator(self) -> _loosepin.Evaluator:
        return _loosepin.Evaluator.of_study(self._native)

    def bounds(
        self,
        function: Callable[[dict[str, Array]], Any],
        statistics: Sequence[Statistic] = ("mean", "standard_deviation"),
        *,
        outputs: Sequence[str] = ("y",),
        accuracy: Accuracy | None = None,
        budget: int | str | None = None,
        threads: int | None = None,
        progress: bool | Listener = True,
        client: Any = None,
    ) -> FunctionBounds:
        """Bounds of a further output: any function of what the runs of the study record, over the same inputs.

            study.bounds(lambda run: np.ptp(run["slider total"], axis=1), ["mean", {"quantile": 0.975}])

        function: is called with a dict that holds a NumPy array for each uncertain input under its path, and for each name of
        `recorded`: of a number one entry for each run, of a curve a row for each run and a column for each pose; SI, and not-a-number
        for runs that failed. It returns an array with an entry for each run, or a row, with a column for each of `outputs`;
        not-a-number is a run that failed. statistics, accuracy, budget: as for `loosepin.bounds`. The numbers of samples are those that the
        study states, and grow where there is an accuracy; runs are made anew and not kept, by the workers of a Dask cluster where there is a `client`; the function is called here.
        """
        must_be("a function", function=function)
        must_be("an int or None", threads=threads)
        names = texts("outputs", outputs)
        asked = requests(statistics, len(names))
        limits = growth(accuracy, budget, asked, names)

        def evaluate(run: dict[str, Array], rows: int) -> Array:
            return table(function(run), rows, names)

        with long_run(f"bounds of a function of study {self.name!r}", listener(progress)) as notify:
            made = None if client is None else run_provider(client, self._native, (), None)
            record = self._native.bounds(evaluate, names, asked, limits, threads, notify, made)
        return FunctionBounds(record, names)

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled, (_loosepin.__version__, self._native.texts())

    def __eq__(self, other: object) -> bool:
        """Whether both were read from the same texts, model and tables included; the names of their files do not count."""
        return isinstance(other, Study) and self._content() == other._content()

    def __hash__(self) -> int:
        return hash(self.text)

    def _content(self) -> tuple[str, str, list[str]]:
        (_, study), (_, model), _, tables = self._native.texts()
        return study, model, [table for _, table in tables]

    def __repr__(self) -> str:
        return f"<loosepin.Study {self.name!r} of the model {self._native.model_name!r}>"


def _check_model(model: Any) -> None:
    if model is not None and not isinstance(model, Model):
        raise TypeError(f"model is a {type(model).__name__}; must be a loosepin.Model or None")


def _unpickled(version: str, texts: Any) -> Study:
    """The study that was pickled by its texts: study, model, and the tables that they name."""
    check_version("study", version)
    return Study(_loosepin.Study.from_texts(texts))
