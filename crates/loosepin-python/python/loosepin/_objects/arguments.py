"""Types of arguments: what is wrong is said by the name of the argument, before anything is done with it."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from .errors import refused

if TYPE_CHECKING:
    from .. import _loosepin


def _is_truth(value: Any) -> bool:
    return isinstance(value, (bool, np.bool_))


def _is_single(value: Any, method: str) -> bool:
    return hasattr(value, method) and getattr(value, "ndim", 0) == 0 and not _is_truth(value)


# Whole numbers from here on are none of the compiled part.
_BEYOND = 2**63

_KINDS: dict[str, Callable[[Any], bool]] = {
    "a str": lambda value: isinstance(value, str),
    "a number": lambda value: _is_single(value, "__float__"),
    "an int": lambda value: _is_single(value, "__index__"),
    "True or False": _is_truth,
    "a path": lambda value: isinstance(value, (str, os.PathLike)),
    "a function": callable,
    "a mapping": lambda value: hasattr(value, "items"),
}


ValueT = TypeVar("ValueT")


def item_named(values: Mapping[str, ValueT], name: object, what: str) -> ValueT:
    """The value with this name. Raises KeyError with the names that there are."""
    if isinstance(name, str) and name in values:
        return values[name]
    raise KeyError(f"there is no {what} {name!r}; must be one of {', '.join(values)}")


def must_be(due: str, **arguments: Any) -> None:
    """Raises TypeError for the first of the arguments that is not `due`: one of "a str", "a number", "an int", "True or False",
    "a path", "a function" and "a mapping", or of these with " or None".
    """
    kind = due.removesuffix(" or None")
    for name, value in arguments.items():
        if not (_KINDS[kind](value) or (value is None and due != kind)):
            raise TypeError(f"{name} is {_what(value)}; must be {due}")
        if kind == "an int" and value is not None and abs(int(value)) >= _BEYOND:
            raise refused(f"{name} is too large")


def texts(name: str, value: Sequence[str]) -> list[str]:
    """The texts of a list or tuple."""
    if isinstance(value, str) or not isinstance(value, Sequence):
        raise TypeError(f"{name} is {_what(value)}; must be a list of str")
    for each in value:
        if not isinstance(each, str):
            raise TypeError(f"{name} holds {_what(each)}; must be a list of str")
    return list(value)


def names_of(name: str, value: Mapping[Any, Any]) -> None:
    """Checks that the keys of a mapping are texts."""
    must_be("a mapping", **{name: value})
    for key in value:
        if not isinstance(key, str):
            raise TypeError(f"{name}: a name is {key!r}; must be a str")


def file_paths(name: str, value: Sequence[str | os.PathLike[str]]) -> list[str]:
    """The paths of a list or tuple."""
    if isinstance(value, str) or not isinstance(value, Sequence):
        raise TypeError(f"{name} is {_what(value)}; must be a list of paths")
    for each in value:
        if not _KINDS["a path"](each):
            raise TypeError(f"{name} holds {_what(each)}; must be a list of paths")
    return [os.fspath(path) for path in value]


def settings(name: str, value: Mapping[str, str | float] | None, native: _loosepin.Model) -> list[str]:
    """Values of a model by their path, as texts path=value; none for None. A number is SI."""
    if value is None:
        return []
    names_of(name, value)
    for path, stated in value.items():
        if not (isinstance(stated, str) or _KINDS["a number"](stated)):
            raise TypeError(f"{name}: '{path}' is {_what(stated)}; must be a str with a unit or a number")
        if not isinstance(stated, str) and native.is_path_of_law(path):
            raise TypeError(f"{name}: '{path}' is {_what(stated)}; must be the name of a contact law")
        if not isinstance(stated, str) and not _is_finite(stated):
            raise refused(f"{name}: '{path}' is {stated}; must be finite", "E0308")
    return [f"{path}={stated if isinstance(stated, str) else native.text_of_value(name, path, float(stated))}" for path, stated in value.items()]


def _is_finite(number: Any) -> bool:
    try:
        return math.isfinite(number)
    except OverflowError:
        return False


def _what(value: Any) -> str:
    return "None" if value is None else f"a {type(value).__name__}"
