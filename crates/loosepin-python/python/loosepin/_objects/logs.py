"""The log of the package: `logging.getLogger("loosepin")`, which is silent until a program gives it a handler."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Protocol

LOGGER = logging.getLogger("loosepin")
LOGGER.addHandler(logging.NullHandler())

# s; how often the log tells how far a long run is.
_EVERY_S = 10.0


class ProgressListener(Protocol):
    """A listener of progress that is closed in the end."""

    def __call__(self, finished: int, most: int) -> None: ...
    def close(self) -> None: ...


@contextmanager
def long_run(what: str, notify: ProgressListener | None) -> Iterator[Callable[[int, int], None] | None]:
    """Writes to the log when `what` begins, how far it is, and how it ends; gives the listener to call, and closes `notify`."""
    began_s = time.monotonic()
    LOGGER.info("%s begins", what)
    try:
        yield _Logged(what, notify) if LOGGER.isEnabledFor(logging.INFO) else notify
    except BaseException as error:
        LOGGER.info("%s ended after %.1f s by %s", what, time.monotonic() - began_s, type(error).__name__)
        raise
    else:
        LOGGER.info("%s is finished after %.1f s", what, time.monotonic() - began_s)
    finally:
        if notify is not None:
            notify.close()


class _Logged:
    def __init__(self, what: str, notify: ProgressListener | None) -> None:
        self._what = what
        self._notify = notify
        self._next_s = time.monotonic() + _EVERY_S

    def __call__(self, finished: int, most: int) -> None:
        if self._notify is not None:
            self._notify(finished, most)
        now_s = time.monotonic()
        if now_s >= self._next_s:
            self._next_s = now_s + _EVERY_S
            LOGGER.info("%s: %d of at most %d finished", self._what, finished, most)
