"""Bounds of statistics of any vectorised function, without a mechanism."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _loosepin
from ._extras import need
from ._figures import distribution_figure
from ._inputs import Input
from ._objects.arguments import must_be, names_of, texts
from ._objects.goals import Accuracy, accuracies, run_count
from ._objects.arrays import frozen, read_only
from ._objects.errors import refused
from ._objects.records import Record
from ._objects.scipy_laws import FrozenDistribution, from_scipy
from ._objects.seeds import Seed, seed_number
from ._records import Array, Bound, BoundEnd, selected

if TYPE_CHECKING:
    import matplotlib.figure
    import pandas
    import xarray

Statistic = str | Mapping[str, float]
"""A statistic as study files write it, for example "mean", "cdf", {"quantile": 0.975} or {"probability_above": 0.4}."""


@dataclass(frozen=True, eq=False, repr=False)
class Band(Record):
    """The central 95 % band of an output by one treatment, and the share of it that really stays inside."""

    output: str
    """Name of the output."""
    treatment: str
    """"mixed", "probability_only" (everything taken as random) or "interval_only" (everything taken as unknown)."""
    lower: float
    """Lower end."""
    upper: float
    """Upper end."""
    coverage: tuple[float, float]
    """The least and the largest probability of staying inside, over what is not known."""


@dataclass(frozen=True, eq=False, repr=False)
class Box(Record):
    """Bounds of a distribution function."""

    output: str
    """Name of the output."""
    values: Array
    """Values of the output, increasing."""
    lower: Array
    """The least probability of staying below each value, numerical error included."""
    upper: Array
    """The largest one."""


@dataclass(frozen=True, eq=False, repr=False)
class AccuracyStep(Record):
    """The samples at one step towards an accuracy."""

    runs: int
    """Runs so far."""
    outer: int
    """Values of what is not known."""
    inner: int
    """Samples of the random inputs at each."""
    share: float
    """The largest numerical error over the one that was asked for; 1 or less where all are reached."""


@dataclass(frozen=True, eq=False, repr=False)
class AccuracyReached(Record):
    """How an accuracy was approached."""

    stop: str
    """"reached", "budget" or "exhausted" (more runs are not possible, or do not help)."""
    steps: tuple[AccuracyStep, ...]
    """One for each size of the samples."""


class FunctionBounds(Record):
    """Result of `bounds`: `result.bounds` holds one `Bound` for each statistic of each output. All arrays are read-only."""

    def __init__(self, record: dict[str, Any], outputs: Sequence[str], seed: int | None = None) -> None:
        """Use `bounds`."""
        self.seed: int | None = seed
        """Seed of the random samples: `bounds(..., seed=result.seed)` makes the same ones. None for `Study.bounds`, whose study has it."""
        self.bounds: tuple[Bound, ...] = _bounds(record["bounds"], outputs)
        """Bounds of each statistic over everything that is not known."""
        self.cuts: tuple[tuple[float, tuple[Bound, ...]], ...] = tuple(
            (alpha, _bounds(each, outputs)) for alpha, each in record["cuts"]
        )
        """Bounds at each degree of possibility, where an input is fuzzy."""
        self.boxes: tuple[Box, ...] = tuple(Box(outputs[each[0]], *frozen(each[1:])) for each in record["boxes"])
        """One for each "cdf" that was asked for."""
        self.bands: tuple[Band, ...] = tuple(
            Band(outputs[column], treatment, lower, upper, (least, most))
            for column, treatment, lower, upper, least, most in record["bands"]
        )
        """The 95 % band of each output by three treatments."""
        self.runs, self.failed_runs, self.rounds = record["runs"]
        self.gaps: tuple[float, float] | None = record["gaps"]
        """How finely the box of the intervals was seen: the largest cube of it without a value at which statistics were estimated, and
        without any run, as shares of its volume. A peak within a gap may have been missed, whatever its height."""
        reached = record.get("accuracy")
        self.accuracy: AccuracyReached | None = (
            None if reached is None else AccuracyReached(reached[0], tuple(AccuracyStep(*step) for step in reached[1]))
        )
        """Where an accuracy was asked for: whether it was reached, and how."""
        self.inputs: dict[str, Array] = {column.name: frozen(column.values) for column in record["inputs"]}
        """Every value of each input that the function was given."""
        self.outputs: dict[str, Array] = {column.name: frozen(column.values) for column in record["outputs"]}
        """Every value that it returned."""
        self.purpose: NDArray[np.str_] = read_only(np.array(record["purpose"]))
        """Purpose of each run: "mixed", "probability_only" or "interval_only"."""

    def select(self, **properties: Any) -> list[Bound]:
        """The bounds with these properties: found.select(output="y", statistic="quantile", parameter=0.975)."""
        return selected(self.bounds, properties)

    def to_xarray(self) -> xarray.Dataset:
        """A Dataset with a variable for each bound, over the dimension `end`: `y_mean`, `y_quantile_0.975`; numerical error included.

        A distribution function `y_cdf` has the dimensions (y, end), the values of the output `y` being a coordinate.
        """
        xarray_ = need("xarray", "to_xarray()")
        variables: dict[str, Any] = {}
        coordinates: dict[str, Any] = {"end": ["lower", "upper"]}
        for bound in self.bounds:
            parameter = "" if bound.parameter is None else f"_{bound.parameter:.6g}"
            attributes = {"guarantee": bound.guarantee}
            variables[f"{bound.output}_{bound.statistic}{parameter}"] = ("end", np.array(bound.widened), attributes)
        for box in self.boxes:
            coordinates[box.output] = (box.output, box.values)
            variables[f"{box.output}_cdf"] = ((box.output, "end"), np.stack([box.lower, box.upper], axis=1))
        dataset: xarray.Dataset = xarray_.Dataset(variables, coordinates)
        return dataset

    def plot(self, *outputs: str, ax: Any = None) -> matplotlib.figure.Figure:
        """Draws the bounds of outputs (all of them where none is named) as bounds of its distribution function, numerical error included.

        "cdf" is a band, a quantile a bar at its probability, a probability a bar at its limit, the mean a vertical band. ax: axes
        of matplotlib to draw into, one for each output; a new figure if omitted. Raises ValueError where nothing can be drawn.
        """
        for name in outputs:
            if name not in self.outputs:
                raise KeyError(f"there is no output {name!r}; must be one of {', '.join(self.outputs)}")
        boxes = {box.output: (box.values, box.lower, box.upper) for box in self.boxes}
        return distribution_figure([(name, boxes.get(name), self.select(output=name)) for name in outputs or self.outputs], ax)

    def to_pandas(self) -> pandas.DataFrame:
        """One bound a row."""
        pandas_ = need("pandas", "to_pandas()")
        rows = [
            {
                "output": bound.output,
                "statistic": bound.statistic,
                "parameter": bound.parameter,
                "lower": bound.lower.value,
                "lower_widened": bound.lower.widened,
                "upper": bound.upper.value,
                "upper_widened": bound.upper.widened,
                "guarantee": bound.guarantee,
            }
            for bound in self.bounds
        ]
        frame: pandas.DataFrame = pandas_.DataFrame(rows)
        return frame

    def _hash_key(self) -> Hashable:
        return self.runs, *self.bounds

    def __str__(self) -> str:
        return "\n".join(str(bound) for bound in self.bounds)

    def __repr__(self) -> str:
        return f"<loosepin.FunctionBounds: {len(self.bounds)} bounds from {self.runs} runs>\n{self}"


def bounds(
    function: Callable[..., Any],
    inputs: Mapping[str, Input | FrozenDistribution],
    statistics: Sequence[Statistic] = ("mean", "standard_deviation"),
    *,
    outputs: Sequence[str] = ("y",),
    correlation: Mapping[tuple[str, str], float] | None = None,
    reading: str = "fixed",
    outer: int = 64,
    inner: int = 256,
    replicates: int = 8,
    mixture: int = 1024,
    extreme: int = 128,
    seed: Seed = 1,
    confidence: float = 0.99,
    accuracy: Accuracy | None = None,
    budget: int | str | None = None,
) -> FunctionBounds:
    """Bounds of statistics of a function's values, over everything about its inputs that is not known.

        lp.bounds(lambda x, u: x + u, {"x": lp.Normal(0, 1), "u": lp.Interval(-1, 1)}, ["mean", {"quantile": 0.975}])

    function: is called with one NumPy array for each input, by its name as a keyword, each with one entry for each run; it returns
    an array with one entry for each run, or one row for each run and one column for each of `outputs`. A number that is
    not finite, or is masked, is a run that failed: it widens bounds of quantiles and probabilities; the mean and the standard deviation are
    those of the finished runs. What the function raises comes out unchanged.
    inputs: what is known of each, a distribution such as `Normal` or a kind of ignorance such as `Interval`. A frozen distribution of
    SciPy, scipy.stats.norm(3, 1), is taken as its counterpart; one without a counterpart is refused, none is approximated.
    correlation: rank correlations of random inputs, {("x", "y"): 0.6}.
    reading: meaning of an interval: "fixed" (one value, unknown), "unknown-distribution" or "random-set".
    outer, inner: values of what is not known, and samples of the random inputs for each; `outer * inner + mixture + extreme` runs at
    most. replicates: independent parts of the samples, which must divide `inner` and `mixture`. confidence: of sampling errors.
    seed: a whole number, a `numpy.random.Generator` (its next number is the seed), a `SeedSequence`, or None for a seed from the
    operating system; `result.seed` tells it.
    accuracy: the largest numerical error of the bounds, one number for all, or one for each output or statistic by name:
    {"y": 0.01, "y.mean": 0.002}. The samples grow until it is reached, or `budget` runs are made (100 times those without it if omitted).
    """
    must_be("a function", function=function)
    names_of("inputs", inputs)
    must_be("a str", reading=reading)
    must_be("an int", outer=outer, inner=inner, replicates=replicates, mixture=mixture, extreme=extreme)
    must_be("a number", confidence=confidence)
    names = texts("outputs", outputs)
    if len(set(names)) < len(names):
        raise refused(f"outputs: two have the same name, {', '.join(names)}", "E0206")
    asked = requests(statistics, len(names))
    stated = [(name, from_scipy(name, known)) for name, known in inputs.items()]
    ordered = sorted(stated, key=lambda item: _is_unknown(item[1]))
    keywords = [name for name, _ in ordered]

    def evaluate(columns: list[Array]) -> Array:
        # Those beyond the keywords are uncertain parameters of distributions, which the function does not see.
        given = dict(zip(random_names + unknown_names, columns))
        return table(function(**{name: given[name] for name in keywords}), len(columns[0]) if columns else 0, names)

    random_names, unknown_names = _loosepin.input_names(ordered)
    ranks = _ranks({} if correlation is None else correlation)
    runs: dict[str, Any] = {
        "outer": outer,
        "inner": inner,
        "replicates": replicates,
        "mixture": mixture,
        "extreme": extreme,
        "seed": seed_number(seed),
        "confidence": confidence,
    }
    for name, number in runs.items():
        if number < 0:
            raise refused(f"{name} {number}; must be >= 0")
    limits = growth(accuracy, budget, asked, names)
    return FunctionBounds(_loosepin.evaluate(evaluate, ordered, names, asked, ranks, reading, runs, limits), names, runs["seed"])


def growth(
    accuracy: Accuracy | None,
    budget: int | str | None,
    asked: list[tuple[int, str, float | None]],
    outputs: list[str],
) -> dict[str, Any]:
    """How far the samples may grow: the largest numerical error of each statistic, and the largest number of runs."""
    budget = run_count(budget)
    accuracy = _as_numbers(accuracy)
    if budget is not None and accuracy is None:
        raise refused("budget without accuracy; samples grow towards an accuracy only", "E0205")
    if budget is not None and budget < 0:
        raise refused(f"budget {budget}; must be >= 0")
    return {"most": _errors_allowed(accuracy, asked, outputs), "budget": budget}


def _as_numbers(accuracy: Accuracy | None) -> float | Mapping[str, float] | None:
    """An accuracy whose texts are read: a function has no units, so they are pure numbers."""
    if not isinstance(accuracy, (list, tuple, Mapping)):
        return accuracy  # type: ignore[return-value]
    numbers: dict[str, Any] = {}
    for name, most in accuracies(accuracy).items():
        try:
            numbers[name] = float(most) if isinstance(most, str) else most
        except ValueError:
            raise refused(f"accuracy of '{name}' is {most!r}; must be a number, since a function has no units", "E0301") from None
    return numbers


def _errors_allowed(
    accuracy: float | Mapping[str, float] | None, asked: list[tuple[int, str, float | None]], outputs: list[str]
) -> list[float | None]:
    """The largest numerical error of each statistic, None if none is stated."""
    if accuracy is None:
        return [None] * len(asked)
    if isinstance(accuracy, Mapping):
        names_of("accuracy", accuracy)
        stated = dict(accuracy)
    else:
        must_be("a number", accuracy=accuracy)
        stated = dict.fromkeys(outputs, accuracy)
    for name, most in stated.items():
        must_be("a number", **{f"accuracy of '{name}'": most})
    for name, most in stated.items():
        if not 0 < most < float("inf"):
            raise refused(f"accuracy {most} of '{name}'; must be a number above 0")
    of_each = [(f"{outputs[column]}.{statistic}", outputs[column]) for column, statistic, _ in asked]
    known = {name for names in of_each for name in names}
    strangers = [name for name in stated if name not in known]
    if strangers:
        raise refused(f"accuracy of '{strangers[0]}'; must be of {', '.join(sorted(known))}", "E0405")
    return [stated.get(own, stated.get(output)) for own, output in of_each]


def _ranks(correlation: Mapping[tuple[str, str], float]) -> list[tuple[str, str, float]]:
    must_be("a mapping", correlation=correlation)
    for pair, rank in correlation.items():
        if not isinstance(pair, tuple) or [type(name) for name in pair] != [str, str]:
            raise TypeError(f"correlation: a pair is {pair!r}; must be two names of inputs, ('x', 'y')")
        must_be("a number", **{f"correlation of {pair}": rank})
    return [(first, second, float(rank)) for (first, second), rank in correlation.items()]


def _is_unknown(known: Input) -> bool:
    from ._inputs import Evidence, Fuzzy, Interval, OneOf, Periodic

    return isinstance(known, (Interval, Periodic, OneOf, Evidence, Fuzzy))


def requests(statistics: Sequence[Statistic], outputs: int) -> list[tuple[int, str, float | None]]:
    """Each statistic of each output: number of the output, name, and the number that goes with it."""
    if isinstance(statistics, (str, Mapping)) or not isinstance(statistics, Sequence):
        raise TypeError(f"statistics is a {type(statistics).__name__}; must be a list such as ['mean', {{'quantile': 0.975}}]")
    asked: list[tuple[str, float | None]] = []
    for statistic in statistics:
        if isinstance(statistic, str):
            asked.append((statistic, None))
        elif not isinstance(statistic, Mapping):
            raise TypeError(f"statistics holds a {type(statistic).__name__}; must be a list such as ['mean', {{'quantile': 0.975}}]")
        elif len(statistic) == 1:
            for name, parameter in statistic.items():
                must_be("a number", **{f"statistic '{name}'": parameter})
            asked.extend((name, float(parameter)) for name, parameter in statistic.items())
        else:
            raise refused(f"statistic {dict(statistic)!r}; must be one name with one number, such as {{'quantile': 0.975}}", "E0203")
    return [(column, *request) for column in range(outputs) for request in asked]


def table(returned: Any, rows: int, outputs: list[str]) -> Array:
    """Return value of a function, as one row for each run and one column for each output."""
    given = np.asarray(np.ma.filled(returned, np.nan) if np.ma.is_masked(returned) else returned)
    if given.dtype.kind not in "biuf":
        raise TypeError(f"function has returned {given.dtype} in place of numbers; must be an array of numbers, one for each run")
    values = given.astype(np.float64, copy=False)
    if values.ndim == 1:
        values = values[:, np.newaxis]
    if values.shape != (rows, len(outputs)):
        raise refused(
            f"the function returned an array of shape {values.shape} for {rows} runs; must be ({rows}, {len(outputs)}), one "
            f"column for each of outputs={outputs}"
        )
    return np.ascontiguousarray(values)


def _bounds(records: list[dict[str, Any]], outputs: Sequence[str]) -> tuple[Bound, ...]:
    return tuple(
        Bound(
            output=outputs[record["column"]],
            of="value",
            at="whole",
            pose_rad=None,
            reduction=None,
            statistic=record["statistic"],
            parameter=record["parameter"],
            treatment="mixed",
            reading="",
            unit="1",
            lower=BoundEnd(**record["lower"]),
            upper=BoundEnd(**record["upper"]),
            guarantee=record["guarantee"],
            confidence=record["confidence"],
        )
        for record in records
    )
