"""Arrays that an object hands out, and objects that are no arrays."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, NoReturn, TypeVar

import numpy as np
from numpy.typing import NDArray

from .errors import refused

NumberT = TypeVar("NumberT", bound=np.generic)


def read_only(array: NDArray[NumberT]) -> NDArray[NumberT]:
    """The same array, which from now on cannot be written: only for arrays that nobody else has."""
    array.flags.writeable = False
    return array


def read_only_copy(array: NDArray[NumberT]) -> NDArray[NumberT]:
    """A copy that cannot be written, contiguous."""
    return read_only(np.array(array, order="C"))


def frozen(value: Any) -> Any:
    """`value`, in which every array cannot be written from now on; lists, tuples and dicts are looked into."""
    if isinstance(value, np.ndarray):
        return read_only(value)
    if isinstance(value, (list, tuple)):
        for each in value:
            frozen(each)
    elif isinstance(value, dict):
        for each in value.values():
            frozen(each)
    return value


def refuse_masked(name: str, value: Any) -> None:
    """Refuses an array with masked values, which would be taken for the numbers under the mask."""
    if np.ma.is_masked(value):
        raise refused(f"{name}: some values are masked; fill them or leave them out", "E0203")


def refuse_taken(name: str, taken: Iterable[str]) -> None:
    """Refuses a second variable of this name in a Dataset."""
    if name in taken:
        raise refused(f"two variables of the Dataset would be called '{name}'\nhint: rename an output", "E0206")


def with_article(name: str) -> str:
    """The name of a class behind "a" or "an"."""
    return f"{'an' if name[0] in 'AEIOUaeiou' else 'a'} {name}"


class NoArray:
    """An object that NumPy must not take for one value of an array of objects."""

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NoReturn:
        raise TypeError(f"{with_article(type(self).__name__)} is not an array\nhint: {self._array_hint()}")

    def _array_hint(self) -> str:
        return "its arrays are read by name, object[name]" if isinstance(self, Mapping) else "its attributes hold its numbers"
