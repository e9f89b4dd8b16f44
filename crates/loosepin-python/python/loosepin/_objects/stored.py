"""Results in folders, as the commands write them."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Protocol, TypeVar

from .arguments import must_be

Native = TypeVar("Native")


class _Saves(Protocol):
    def save(self, folder: str, force: bool) -> None: ...


def loaded(load: Callable[[str], Native], folder: str | os.PathLike[str]) -> Native:
    """What `load` reads in a folder."""
    must_be("a path", folder=folder)
    return load(os.fspath(folder))


def saved(native: _Saves, folder: str | os.PathLike[str], force: bool) -> Path:
    """The folder, in which the files of `native` are now."""
    must_be("a path", folder=folder)
    must_be("True or False", force=force)
    native.save(os.fspath(folder), force)
    return Path(folder)
