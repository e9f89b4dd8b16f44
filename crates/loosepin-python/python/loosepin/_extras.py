"""Optional packages."""

from __future__ import annotations

import importlib
from typing import Any


def need(package: str, what: str) -> Any:
    """The module `package`, or an ImportError that says what needs it and how to get it."""
    try:
        return importlib.import_module(package)
    except ImportError as error:
        name = package.partition(".")[0]
        raise ImportError(f"{what} needs {name}, which cannot be imported\nhint: pip install {name}") from error
