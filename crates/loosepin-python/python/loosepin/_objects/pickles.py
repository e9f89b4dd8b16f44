"""Pickles: an object is made again from its parts, by the version of the package that pickled it.

Whatever a pickle names is called when it is opened, before the version is looked at: they are for processes of one's own, and not to be handed over.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from .. import _loosepin
from .arrays import frozen, with_article


def pickled(what: str, made: Callable[..., Any], *parts: Any) -> tuple[Any, ...]:
    """What `__reduce__` gives for an object that `made(*parts)` makes again; `what` is its name in an error."""
    return unpickled, (_loosepin.__version__, what, made, parts)


def unpickled(version: str, what: str, made: Callable[..., Any], parts: tuple[Any, ...]) -> Any:
    """The object again. Raises ValueError for a pickle of another version."""
    check_version(what, version)
    # A pickled array does not remember that it was read-only.
    return made(*frozen(parts))


def check_version(what: str, version: str) -> None:
    """Refuses what another version of the package pickled."""
    if version != _loosepin.__version__:
        raise ValueError(f"{with_article(what)} of loosepin {version}; this is loosepin {_loosepin.__version__}")
