"""Tables of inputs: a row for each run, a column for each input, SI."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any

import numpy as np

from . import _loosepin
from ._objects.arrays import refuse_masked
from ._objects.errors import refused
from ._objects.records import Record
from ._records import Array


@dataclass(frozen=True, eq=False, repr=False)
class StudyInput(Record):
    """An input of a study: one column of a design."""

    name: str
    """Its path in the model, for example "joint.gudgeon.radial_clearance"."""
    unit: str
    """SI unit of its values; "1" for a pure number and for a law."""
    kind: str
    """"random" (a known distribution) or "unknown" (an interval, a list or another description)."""
    words: str
    """The distribution, or what is known of it, in words."""
    lower: float
    """Least possible value, SI; -inf where a distribution has none."""
    upper: float
    """Greatest possible value, SI; inf where a distribution has none."""
    nominal: float | None
    """Value in the model, SI; None for a law and for a parameter of a distribution, which no run sees."""
    laws: tuple[str, ...] | None
    """The names of its values where it is the law of a contact: its column then holds their places, 0, 1, ..."""


def study_inputs(native: _loosepin.Study) -> tuple[StudyInput, ...]:
    """The inputs of a study, random ones before unknown ones, each kind in the order of the file."""
    return tuple(
        StudyInput(name, unit, "random" if is_random else "unknown", words, lower, upper, nominal, None if laws is None else tuple(laws))
        for name, unit, is_random, words, lower, upper, nominal, laws in native.inputs()
    )


class InputReader:
    """Reads the argument `inputs` of an evaluation."""

    def __init__(self, model: _loosepin.Model, names: Sequence[str], laws: Mapping[str, tuple[str, ...]]) -> None:
        """model: whose rules the values keep; names: the columns; laws: the words of those columns that are laws."""
        self._model = model
        self._names = list(names)
        self._laws = laws

    def read(self, inputs: Any) -> Array:
        """The table of `inputs`: an array with two dimensions, or a mapping with a number, a text or an array for each input."""
        table = self._of_mapping(inputs) if hasattr(inputs, "items") else self._of_array(inputs)
        if not len(table):
            raise refused("inputs: the design has no runs; give at least one row", "E0203")
        if not np.isfinite(table).all():
            run, column = (int(place) for place in np.argwhere(~np.isfinite(table))[0])
            raise refused(f"inputs: '{self._names[column]}' is {table[run, column]} in run {run}; must be finite", "E0308")
        for name, words in self._laws.items():
            self._check_places(name, words, table[:, self._names.index(name)])
        return table

    def _of_array(self, inputs: Any) -> Array:
        array = _numbers(inputs, "inputs")
        wanted = len(self._names)
        if array.ndim == 1 and len(array) == wanted:
            raise refused(f"inputs: shape {array.shape}; must be (runs, {wanted})\nhint: for one run write inputs[np.newaxis]", "E0203")
        if array.ndim != 2 or array.shape[1] != wanted:
            hint = f"the columns are {', '.join(self._names)}"
            raise refused(f"inputs: shape {array.shape}; must be (runs, {wanted}), a column for each input\nhint: {hint}", "E0203")
        return np.ascontiguousarray(array)

    def _of_mapping(self, inputs: Any) -> Array:
        given = dict(inputs.items())
        for name in given:
            if name not in self._names:
                raise refused(f"inputs: there is no input {name!r}\nhint: {self._meant(name)}", "E0405")
        missing = [name for name in self._names if name not in given]
        if missing:
            raise refused(f"inputs: {', '.join(repr(name) for name in missing)} missing\nhint: one number stands for all runs", "E0202")
        columns = {name: self._column(name, given[name]) for name in self._names}
        lengths = {name: len(column) for name, column in columns.items() if column.ndim}
        first = next(iter(lengths), None)
        for name, length in lengths.items():
            if first is not None and length != lengths[first]:
                raise refused(
                    f"inputs: '{name}' has {length} values, but '{first}' has {lengths[first]}; must be as many, or one number"
                )
        table = np.empty((lengths[first] if first is not None else 1, len(self._names)))
        for place, column in enumerate(columns.values()):
            table[:, place] = column
        return table

    def _column(self, name: str, value: Any) -> Array:
        what = f"inputs: '{name}'"
        words = self._laws.get(name)
        if isinstance(value, str):
            return np.array(self._place(name, value) if words is not None else self._model.value_of(name, value), dtype=float)
        if words is not None and _is_texts(value):
            return np.array([self._place(name, word) for word in value], dtype=float)
        column = _numbers(value, what)
        if column.ndim > 1:
            raise refused(f"{what}: shape {column.shape}; must be one number, or an array with one dimension", "E0203")
        if not column.ndim and words is None and np.isfinite(column):
            self._model.check_value(name, float(column))
        return column

    def _place(self, name: str, word: str) -> int:
        words = self._laws[name]
        if word not in words:
            raise refused(f"inputs: '{name}' is {word!r}; must be {_one_of(words)}", "E0204")
        return words.index(word)

    def _check_places(self, name: str, words: tuple[str, ...], column: Array) -> None:
        wrong = ~np.isin(column, range(len(words)))
        if wrong.any():
            run = int(np.argmax(wrong))
            places = ", ".join(f"{place} for {word}" for place, word in enumerate(words))
            raise refused(f"inputs: '{name}' is {column[run]:g} in run {run}; must be {places}", "E0204")

    def _meant(self, name: Any) -> str:
        near = get_close_matches(str(name), self._names, n=1)
        return f"did you mean '{near[0]}'?" if near else f"the inputs are {', '.join(self._names)}"


def read_points(points: Any, names: Sequence[str]) -> Array:
    """Points of the unit cube, a row for each run and a column for each input."""
    array = _numbers(points, "points")
    if array.ndim != 2 or array.shape[1] != len(names):
        raise refused(f"points: shape {array.shape}; must be (runs, {len(names)}), a column for each input", "E0203")
    if not len(array) or not ((array > 0) & (array < 1)).all():
        raise refused("points: must be at least one row of numbers between 0 and 1, both excluded")
    return np.ascontiguousarray(array)


def split_laws(model: _loosepin.Model, inputs: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, str]]:
    """Inputs that are numbers, and laws by the path of their contact, from the argument `inputs` of `Model.evaluate`."""
    if not hasattr(inputs, "items"):
        raise TypeError(f"inputs is a {type(inputs).__name__}; must be a mapping from paths in the model to values")
    given = dict(inputs.items())
    for path in given:
        if not isinstance(path, str):
            raise TypeError(f"inputs: a path is {path!r}; must be a str")
    laws = {path: value for path, value in given.items() if model.is_path_of_law(path)}
    for path, law in laws.items():
        if not isinstance(law, str):
            raise TypeError(f"inputs: '{path}' is a {type(law).__name__}; must be the name of a contact law, the same for all runs")
    return {path: value for path, value in given.items() if path not in laws}, laws


def _numbers(value: Any, what: str) -> Array:
    refuse_masked(what, value)
    try:
        array = np.asarray(value)
    except ValueError as error:
        raise refused(f"{what}: {error}", "E0203") from error
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{what}: {_dtype_words(array)}; must be numbers in SI units")
    return array.astype(np.float64, copy=False)


def _dtype_words(array: Any) -> str:
    return {"U": "texts", "S": "texts", "b": "truth values", "c": "complex numbers"}.get(array.dtype.kind, f"values of type {array.dtype}")


def _is_texts(value: Any) -> bool:
    return not hasattr(value, "dtype") and isinstance(value, Sequence) and all(isinstance(each, str) for each in value)


def _one_of(words: Sequence[str]) -> str:
    return " or ".join(f"'{word}'" for word in words)
