"""Laws as functions: what every distribution can do besides being an input."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _loosepin
from .records import Record

Array = NDArray[np.float64]


class Law(Record):
    """A distribution whose parameters are numbers has `cdf` and `ppf`, the names that SciPy uses."""

    @overload
    def cdf(self, x: float) -> float: ...
    @overload
    def cdf(self, x: ArrayLike) -> float | Array: ...
    def cdf(self, x: Any) -> Any:
        """Probability of a value of at most `x`: a float for a number, an array of the same shape for an array.

        Raises ValueError where a parameter is unknown (epistemic), and LoosepinValueError where the parameters make no distribution.
        """
        return _at_each(_loosepin.law_cdf, self, x, "x")

    @overload
    def ppf(self, q: float) -> float: ...
    @overload
    def ppf(self, q: ArrayLike) -> float | Array: ...
    def ppf(self, q: Any) -> Any:
        """The least value that is not exceeded with probability `q`, the inverse of `cdf`: NaN outside of 0 to 1.

        A float for a number, an array of the same shape for an array; errors as for `cdf`.
        """
        return _at_each(_loosepin.law_ppf, self, q, "q")

    def _array_hint(self) -> str:
        return "its method ppf gives values at probabilities"


def _at_each(function: Callable[[Any, Array], Array], law: Law, values: Any, name: str) -> Any:
    array = np.asarray(values)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} is {_kind(values, array)}; must be a number or an array of numbers")
    found = function(law, np.ascontiguousarray(array.reshape(-1), dtype=np.float64)).reshape(array.shape)
    return float(found) if array.ndim == 0 else found


def _kind(values: Any, array: NDArray[Any]) -> str:
    return f"an array of {array.dtype}" if array.ndim else f"a {type(values).__name__}"


def fixed(values: Any) -> Any:
    """A list or an array as a tuple, so that nobody can change it later; whatever else was given as it is."""
    if hasattr(values, "tolist"):  # NumPy's arrays and numbers
        values = values.tolist()
    return tuple(fixed(each) for each in values) if isinstance(values, (list, tuple)) else values
