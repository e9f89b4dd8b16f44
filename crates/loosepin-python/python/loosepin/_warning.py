"""Warnings about a file, as Python warnings."""

from __future__ import annotations

import warnings
from collections.abc import Iterable

from ._loosepin import Diagnostic
from ._objects.logs import LOGGER


class LoosepinWarning(UserWarning):
    """A likely oversight in a valid model or study; the log `loosepin` gets its text as well."""


def warn(diagnostics: Iterable[Diagnostic], stacklevel: int = 3) -> None:
    """Shows each diagnostic at the line that called the function which calls this one."""
    for diagnostic in diagnostics:
        LOGGER.warning("%s", diagnostic)
        warnings.warn(str(diagnostic), LoosepinWarning, stacklevel=stacklevel)
