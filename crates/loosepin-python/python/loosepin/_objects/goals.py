"""Accuracies and budgets as arguments: texts with units, or numbers in SI."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from .arguments import must_be, names_of, texts
from .errors import refused

Accuracy = float | Sequence[str] | Mapping[str, float | str]
"""Largest numerical error: of statistics by name, as texts such as "slider.mean=1 um" or in a mapping; or one number for all."""


def accuracies(accuracy: Sequence[str] | Mapping[str, Any] | Any) -> dict[str, float | str]:
    """The largest error of each name, as a text or as a number in SI."""
    if isinstance(accuracy, Mapping):
        names_of("accuracy", accuracy)
        stated = dict(accuracy)
        for name, most in stated.items():
            if not isinstance(most, str):
                must_be("a number", **{f"accuracy of '{name}'": most})
        return stated
    found: dict[str, float | str] = {}
    for text in texts("accuracy", accuracy):
        name, equals, most = text.partition("=")
        if not equals:
            raise refused(f"accuracy {text!r}; must be a name and the largest error, for example \"slider.mean=1 um\"", "E0407")
        if name.strip() in found:
            raise refused(f"accuracy: '{name.strip()}' is stated twice", "E0409")
        found[name.strip()] = most.strip()
    return found


def stated_accuracies(accuracy: Sequence[str] | Mapping[str, float | str], units: Mapping[str, str]) -> list[str]:
    """Texts such as "slider.mean=1 um"; a number is in the SI unit of its output."""
    if not isinstance(accuracy, Mapping):
        return texts("accuracy", accuracy)
    return [f"{name}={_with_unit(name, most, units)}" for name, most in accuracies(accuracy).items()]


def stated_budget(budget: int | str | None) -> str | None:
    """A text such as "20000 runs"; a number is one of runs."""
    if budget is None or isinstance(budget, str):
        return budget
    must_be("an int or None", budget=budget)
    return f"{int(budget)} runs"


def _with_unit(name: str, most: float | str, units: Mapping[str, str]) -> str:
    """A number as a text with the unit of the output that `name` begins with; of a probability it is a pure number."""
    if isinstance(most, str):
        return most
    output, _, statistic = name.partition(".")
    unit = units.get(output, "1")
    return f"{float(most)!r}" if unit == "1" or statistic.startswith("probability") else f"{float(most)!r} {unit}"


def run_count(budget: int | str | None) -> int | None:
    """A number of runs, which may be stated as "20000 runs"."""
    if isinstance(budget, str):
        counted = re.fullmatch(r"\s*(\d+)\s*runs?\s*", budget)
        if counted is None:
            raise refused(f"budget {budget!r}; must be a number of runs, for example \"20000 runs\" or 20000", "E0301")
        return int(counted[1])
    must_be("an int or None", budget=budget)
    return None if budget is None else int(budget)
