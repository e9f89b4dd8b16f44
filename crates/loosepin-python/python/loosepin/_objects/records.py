"""Objects that are their values: pickled and copied by them, equal where they are equal."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from functools import cached_property
from typing import Any

import numpy as np

from .arrays import NoArray
from .pickles import pickled


class Record(NoArray):
    """An object that consists of its attributes.

    Two of one class are equal if all attributes are, arrays by their numbers, not-a-number with itself. A pickle or a copy holds the
    attributes; arrays are read-only in it as well.
    """

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and are_same(_attributes(self), _attributes(other))

    def __hash__(self) -> int:
        return hash((type(self).__name__, self._hash_key()))

    def __reduce__(self) -> tuple[Any, ...]:
        return pickled(type(self).__name__, _restored, type(self), _attributes(self))

    def __repr__(self) -> str:
        """The attributes, arrays by their shape and their first and last number."""
        return f"{type(self).__name__}({', '.join(f'{name}={_short(value)}' for name, value in _attributes(self).items())})"

    def _hash_key(self) -> Hashable:
        """A part of what makes two objects equal that has a hash: the texts."""
        return tuple(value for value in _attributes(self).values() if isinstance(value, str))


# Entries of a list or a mapping that are shown.
_SHOWN = 4


def _short(value: Any) -> str:
    if isinstance(value, np.ndarray):
        if value.size <= _SHOWN:
            return repr(value)
        return f"<array of {' x '.join(map(str, value.shape))}, {value.flat[0]:.6g} ... {value.flat[-1]:.6g}>"
    if isinstance(value, Mapping):
        entries = [f"{key!r}: {_short(each)}" for key, each in list(value.items())[:_SHOWN]]
        return f"{{{', '.join(entries + _rest(value))}}}"
    if type(value) in (list, tuple):
        entries = [_short(each) for each in value[:_SHOWN]] + _rest(value)
        inside = ", ".join(entries)
        return f"[{inside}]" if isinstance(value, list) else f"({inside}{',' if len(entries) == 1 else ''})"
    return repr(value)


def _rest(values: Any) -> list[str]:
    return [f"... ({len(values)} in all)"] if len(values) > _SHOWN else []


def _attributes(record: Record) -> dict[str, Any]:
    """Everything but what is computed once from the rest."""
    of_class = type(record)
    return {name: value for name, value in vars(record).items() if not isinstance(getattr(of_class, name, None), cached_property)}


def _restored(of_class: type[Record], attributes: dict[str, Any]) -> Record:
    record = object.__new__(of_class)
    vars(record).update(attributes)
    return record


def are_same(one: Any, other: Any) -> bool:
    """Whether both hold the same values: arrays by their numbers, where not-a-number is the same as itself; the rest by `==`."""
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        return _are_same_arrays(np.asarray(one), np.asarray(other))
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return list(one) == list(other) and all(are_same(one[key], other[key]) for key in one)
    if isinstance(one, (list, tuple)) and isinstance(other, (list, tuple)):
        return len(one) == len(other) and all(are_same(*pair) for pair in zip(one, other))
    if isinstance(one, float) and isinstance(other, float):
        return one == other or (one != one and other != other)
    return bool(one == other)


def _are_same_arrays(one: Any, other: Any) -> bool:
    if one.shape != other.shape or one.dtype != other.dtype:
        return False
    return bool(np.array_equal(one, other, equal_nan=one.dtype.kind == "f"))
