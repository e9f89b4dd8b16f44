"""Progress of a study: a line in a terminal, a bar in a notebook."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from html import escape
from typing import Any, TextIO

import numpy as np

from ._notebook.kernel import has_kernel

Listener = Callable[[int, int], object]
"""Called with the number of finished runs and the largest number of runs."""

_WIDTH = 30
_EVERY_S = 0.25


def listener(progress: bool | Listener, counted: str = "runs") -> _ProgressDisplay | _Callable | None:
    """Listener for the progress of `Study.run`, or of other work that is `counted` otherwise."""
    if callable(progress):
        return _Callable(progress)
    if not isinstance(progress, (bool, np.bool_)) and progress is not None:
        raise TypeError(f"progress is a {type(progress).__name__}; must be True, False or a function")
    if not progress:
        return None
    if has_kernel():
        return _ProgressDisplay(_Notebook(), counted)
    stream = sys.stderr
    return _ProgressDisplay(_Terminal(stream), counted) if stream is not None and stream.isatty() else None


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


class _ProgressDisplay:
    """Shows the progress now and then, with the time that is left."""

    def __init__(self, place: _Terminal | _Notebook, counted: str) -> None:
        self._place = place
        self._counted = counted
        self._began = time.monotonic()
        self._next = self._began

    def __call__(self, finished: int, most: int) -> None:
        now = time.monotonic()
        if now < self._next:
            return
        self._next = now + _EVERY_S
        if finished:
            left = f"at most {_duration((now - self._began) / finished * (most - finished))} left"
        else:
            left = "the first runs have started"
        self._place.show(finished, most, f"{finished} of at most {most} {self._counted}, {left}")

    def close(self) -> None:
        """Removes what is shown."""
        self._place.clear()


class _Terminal:
    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def show(self, finished: int, most: int, words: str) -> None:
        self._write(f"[{_bar(finished, most)}] {words}")

    def clear(self) -> None:
        self._write("")

    def _write(self, text: str) -> None:
        self._stream.write("\r\x1b[K" + text)
        self._stream.flush()


class _Notebook:
    """One output of the cell, which is changed in place and is empty in the end."""

    def __init__(self) -> None:
        self._handle: Any = None

    def show(self, finished: int, most: int, words: str) -> None:
        bar = f'<progress value="{finished}" max="{most}" aria-label="progress" style="width: 16em; vertical-align: middle"></progress>'
        self._display({"text/plain": f"[{_bar(finished, most)}] {words}", "text/html": f"{bar} {escape(words)}"})

    def clear(self) -> None:
        if self._handle is not None:
            self._display({"text/plain": "", "text/html": ""})

    def _display(self, data: dict[str, str]) -> None:
        from IPython.display import display

        if self._handle is None:
            self._handle = display(data, raw=True, display_id=True)
        else:
            self._handle.update(data, raw=True)


def _bar(finished: int, most: int) -> str:
    return ("=" * (_WIDTH * finished // most)).ljust(_WIDTH)


def _duration(seconds: float) -> str:
    if seconds < 1:
        return "a second"
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"
