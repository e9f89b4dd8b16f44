"""Saved surrogates of a study."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _loosepin
from ._objects.arguments import must_be, names_of
from ._objects.arrays import NoArray, read_only
from ._objects.errors import read_text
from ._objects.pickles import pickled
from ._objects.records import Record
from ._records import Array


@dataclass(frozen=True, eq=False, repr=False)
class SurrogateOutput(Record):
    """A number or curve that surrogates predict."""

    output: str
    """Name of the output."""
    of: str
    """Which deviation."""
    unit: str
    """SI unit of its values."""
    places: tuple[str, ...]
    """Places in the cycle; one for a number."""
    pose_rad: Array
    """Angle of the drive at each place, NaN where the cycle is reduced to one number."""
    members: dict[str, float | str]
    """The members of lists that it holds for, by path."""


class Surrogates(NoArray):
    """All surrogates of a study; `Surrogates.load("surrogates.json")` reads it."""

    def __init__(self, native: _loosepin.Surrogates, text: str) -> None:
        """Use `load` or `from_text`."""
        self._native = native
        self._text = text

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Surrogates:
        """Reads `surrogates.json`. Raises LoosepinError for a file that is not there, is not whole or is of another version."""
        must_be("a path", path=path)
        return cls.from_text(read_text(path))

    @classmethod
    def from_text(cls, text: str) -> Surrogates:
        """Reads the text of `surrogates.json`."""
        must_be("a str", text=text)
        return cls(_loosepin.Surrogates(text), text)

    @property
    def study(self) -> str:
        """Name of the study."""
        return self._native.study

    @property
    def inputs(self) -> dict[str, str]:
        """SI unit of each input, by path."""
        return dict(self._native.inputs())

    @property
    def outputs(self) -> tuple[SurrogateOutput, ...]:
        """Outputs that can be predicted; `predict` takes the index in this list."""
        return tuple(
            SurrogateOutput(output, of, unit, tuple(places), read_only(np.array(poses)), members)
            for output, of, unit, places, poses, members in self._native.outputs()
        )

    def predict(self, output: int, values: Mapping[str, float | Array]) -> tuple[Array, Array]:
        """Values and standard deviations of their errors, SI, of output number `output` at these values of the inputs, by path, SI.

        With numbers, both have one entry for each place; with arrays of the same length, a row for each of their entries. Raises
        LoosepinError outside the ranges that were learned: nothing is extrapolated.
        """
        must_be("an int", output=output)
        names_of("values", values)
        paths = list(values)
        given = np.broadcast_arrays(*(np.asarray(values[path], dtype=np.float64) for path in paths)) if paths else []
        shape = given[0].shape if given else ()
        table = np.stack([column.ravel() for column in given], axis=1) if given else np.empty((1, 0))
        predicted, deviations = self._native.predict(output, paths, np.ascontiguousarray(table))
        return predicted.reshape(*shape, -1), deviations.reshape(*shape, -1)

    def to_onnx(self, output: int) -> bytes:
        """Output number `output`, made of neural networks, as an ONNX file in double precision: from `inputs`, a row a point in the order
        of `Surrogates.inputs`, SI, to `values`, a column a place, SI.

        Not-a-number where an input lies outside of what was learned. The standard deviations of `predict`, and what is left of noise, do
        not go along; the metadata of the file hold the ranges and the held-out error. Raises LoosepinError for polynomials and Kriging,
        whose coefficients stand in `surrogates.json`.
        """
        must_be("an int", output=output)
        return self._native.to_onnx(output)

    def __reduce__(self) -> tuple[Any, ...]:
        return pickled("Surrogates", Surrogates.from_text, self._text)

    def __eq__(self, other: object) -> bool:
        """Whether both were read from the same text."""
        return isinstance(other, Surrogates) and self._text == other._text

    def __hash__(self) -> int:
        return hash(self._text)

    def __repr__(self) -> str:
        return f"<loosepin.Surrogates of {self.study!r}: {len(self.outputs)} outputs of {', '.join(self.inputs)}>"
