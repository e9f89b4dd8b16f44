"""Python values as the text of a model or study file, so that there is one reader and one set of messages."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any

_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


def to_toml(mapping: Mapping[str, Any]) -> str:
    """The text of a file with these keys: texts, numbers, true and false, lists, and mappings for tables."""
    lines = [f"{_key(name)} = {_value(value, name)}" for name, value in mapping.items() if not _is_table(value)]
    for name, value in mapping.items():
        if _is_table(value):
            lines.append(f"\n[{_key(name)}]")
            lines.extend(f"{_key(key)} = {_value(entry, f'{name}.{key}')}" for key, entry in value.items())
    return "\n".join(lines) + "\n"


def _is_table(value: Any) -> bool:
    return isinstance(value, Mapping)


def _key(name: Any) -> str:
    if not isinstance(name, str):
        raise TypeError(f"a key is {name!r}; must be a str")
    return name if _BARE_KEY.fullmatch(name) else _text(name)


def _text(text: str) -> str:
    # TOML's basic strings are JSON's, but for the delete character.
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: Any, where: str) -> str:
    if hasattr(value, "tolist"):  # NumPy's numbers and arrays
        value = value.tolist()
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, Mapping):
        entries = (f"{_key(key)} = {_value(entry, f'{where}.{key}')}" for key, entry in value.items())
        return "{ " + ", ".join(entries) + " }"
    if isinstance(value, (list, tuple)):
        if value and all(_is_table(entry) for entry in value):
            return "[\n" + "".join(f"  {_value(entry, where)},\n" for entry in value) + "]"
        return "[" + ", ".join(_value(entry, where) for entry in value) + "]"
    raise TypeError(f"{where} is a {type(value).__name__}; must be a str, a number, a bool, a list or a dict")
