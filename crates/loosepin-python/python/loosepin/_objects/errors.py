"""Errors that are also exceptions of Python; the compiled part chooses among them by code."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from typing import Any

from .._loosepin import LoosepinError, refusal


class LoosepinValueError(LoosepinError, ValueError):
    """Something is wrong with a text, a file or a value that was given: a `LoosepinError` and a `ValueError`."""

    __module__ = "loosepin"


class LoosepinFileNotFoundError(LoosepinError, FileNotFoundError):
    """There is no such file: a `LoosepinError` and a `FileNotFoundError`, with `errno` and `filename`."""

    __module__ = "loosepin"

    def __init__(self, text: str, filename: str | None = None, errno_: int | None = None) -> None:
        """text: the whole message; filename: path as it was given; errno_: ENOENT if omitted."""
        super().__init__(text)
        self.filename = filename
        self.errno = errno.ENOENT if errno_ is None else errno_
        self.strerror = os.strerror(self.errno)

    def __new__(cls, text: str, filename: str | None = None, errno_: int | None = None) -> LoosepinFileNotFoundError:
        # An OSError with several arguments would make a text of its own.
        return super().__new__(cls, text)

    def __str__(self) -> str:
        return str(self.args[0])

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.args[0], self.filename, self.errno), self.__dict__


def read_text(path: str | os.PathLike[str]) -> str:
    """The text of the UTF-8 file `path`. Raises LoosepinFileNotFoundError where there is none."""
    try:
        return Path(path).read_text(encoding="utf-8")
    except FileNotFoundError as error:
        name = os.fspath(path)
        refused = LoosepinFileNotFoundError(f"cannot read {name}: there is no such file", name, error.errno)
        refused.code, refused.diagnostics = "E0101", ()
        raise refused from None


def refused(message: str, code: str = "E0501") -> Exception:
    """The `LoosepinValueError` for an argument with an impossible value; a line "hint: ..." of the message is its hint."""
    text, _, hint = message.partition("\nhint: ")
    return refusal(code, text, hint or None)
