"""The argument `outputs` of `Model.evaluate`, as the text of a file: the keys of a question are those of `[[ask]]`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from numbers import Real
from typing import Any

from . import _loosepin
from ._objects.errors import refused
from ._toml import to_toml

Question = str | Mapping[str, Any]
"""The name that results have for a number or a curve, "slider total maximum_absolute", or a dict with the keys of a question."""


def named(outputs: Question | Sequence[str] | Mapping[str, Question]) -> dict[str, Question]:
    """What is asked for, by name: a text, or each of several, is its own name."""
    if isinstance(outputs, str):
        return {outputs: outputs}
    if isinstance(outputs, Mapping):
        questions = dict(outputs)
    elif isinstance(outputs, Sequence) and all(isinstance(name, str) for name in outputs):
        questions = {name: name for name in outputs}
    else:
        raise TypeError("outputs must be a text, a list of texts, or a mapping from names to texts or dicts")
    if not questions:
        raise refused("outputs is empty; give at least one", "E0203")
    for name, question in questions.items():
        if not isinstance(name, str) or not isinstance(question, (str, Mapping)):
            raise TypeError(
                f"outputs: {name!r} is a {type(question).__name__}; must be a text or a dict with the keys output, of, and at, poses or reduce"
            )
    return questions


def questions_toml(model: _loosepin.Model, questions: Mapping[str, Question]) -> str:
    """The questions as a table `outputs`."""
    return to_toml({"outputs": {name: _keys(model, question) for name, question in questions.items()}})


def _keys(model: _loosepin.Model, question: Question) -> dict[str, Any]:
    if isinstance(question, str):
        output, component, of, (key, word, angle_rad) = model.question_of(question)
        place: Any = word if angle_rad is None else {word: [f"{angle_rad!r} rad"]}
        return {"output": output, "of": of, key: place} | ({} if component is None else {"component": component})
    keys = dict(question)
    if isinstance(keys.get("poses"), Mapping):
        keys["poses"] = {drive: [_angle(angle) for angle in _listed(angles)] for drive, angles in keys["poses"].items()}
    return keys


def _listed(angles: Any) -> list[Any]:
    angles = angles.tolist() if hasattr(angles, "tolist") else angles
    return list(angles) if isinstance(angles, (list, tuple)) else [angles]


def _angle(angle: Any) -> Any:
    """An angle with its unit: a number is one in rad, as everywhere in Python."""
    return f"{float(angle)!r} rad" if isinstance(angle, Real) and not isinstance(angle, bool) else angle
