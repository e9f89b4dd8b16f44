"""Progress of a study: a line in a terminal, a line that changes in a notebook."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

Listener = Callable[[int, int], object]
"""Called with the number of finished runs and the largest number of runs."""

_WIDTH = 30
_EVERY_S = 0.25


def listener(progress: bool | Listener, counted: str = "runs") -> _Line | _Callable | None:
    """Listener for the progress of `Study.run`, or of other work that is `counted` otherwise."""
    if callable(progress):
        return _Callable(progress)
    if not isinstance(progress, (bool, np.bool_)) and progress is not None:
        raise TypeError(f"progress is a {type(progress).__name__}; must be True, False or a function")
    if not progress:
        return None
    show = _notebook_line() or _terminal_line()
    return None if show is None else _Line(show, counted)


class _Callable:
    def __init__(self, notify: Listener) -> None:
        self._notify = notify
        self._last = (-1, -1)

    def __call__(self, finished: int, most: int) -> None:
        if (finished, most) != self._last:
            self._last = (finished, most)
            self._notify(finished, most)

    def close(self) -> None:
        """Nothing is left to do."""


class _Line:
    def __init__(self, show: Callable[[str], None], counted: str) -> None:
        self._show = show
        self._counted = counted
        self._began = time.monotonic()
        self._next = self._began

    def __call__(self, finished: int, most: int) -> None:
        now = time.monotonic()
        if now < self._next:
            return
        self._next = now + _EVERY_S
        bar = ("=" * (_WIDTH * finished // most)).ljust(_WIDTH)
        if finished:
            left = f"at most {_duration((now - self._began) / finished * (most - finished))} left"
        else:
            left = "the first runs have started"
        self._show(f"[{bar}] {finished} of at most {most} {self._counted}, {left}")

    def close(self) -> None:
        """Removes the line."""
        self._show("")


def _terminal_line() -> Callable[[str], None] | None:
    stream = sys.stderr
    if stream is None or not stream.isatty():
        return None

    def show(text: str) -> None:
        stream.write("\r\x1b[K" + text)
        stream.flush()

    return show


def _notebook_line() -> Callable[[str], None] | None:
    ipython = sys.modules.get("IPython")
    shell: Any = ipython.get_ipython() if ipython is not None else None
    if shell is None or not hasattr(shell, "kernel"):
        return None
    from IPython.display import Pretty, display

    handle = display(_Plain(""), display_id=True)

    def show(text: str) -> None:
        if handle is not None:
            handle.update(Pretty(text))

    return show


class _Plain:
    def __init__(self, text: str) -> None:
        self._text = text

    def __repr__(self) -> str:
        return self._text


def _duration(seconds: float) -> str:
    if seconds < 1:
        return "a second"
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"
