"""Identification of the unknowns of a study from readings and motion of a rig."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Generic, TypeVar

from . import _loosepin
from ._objects.arguments import must_be
from ._objects.arrays import NoArray
from ._objects.pickles import pickled
from ._objects.records import Record

StudyT = TypeVar("StudyT")


@dataclass(frozen=True, eq=False, repr=False)
class Unknown(Record):
    """An input of the study before and after an identification, SI."""

    path: str
    """Path in the model."""
    name: str
    """Name in sentences."""
    unit: str
    """SI unit."""
    before: tuple[float, float]
    """Interval of the study."""
    after: tuple[float, float]
    """Interval that is consistent with the measurements; that of the study if no value is."""
    specimen: str | None
    """The mechanism that was measured, where the file says."""

    @property
    def is_narrowed(self) -> bool:
        """Whether either end is narrower than before."""
        return self.after[0] > self.before[0] or self.after[1] < self.before[1]


@dataclass(frozen=True, eq=False, repr=False)
class Posterior(Record):
    """Posterior distribution of an unknown of a motion: prior uniform over the interval of the study."""

    path: str
    """Path in the model."""
    unit: str
    """SI unit."""
    probabilities: tuple[float, ...]
    """Probabilities of cells of equal width over the interval of the study, or of the members of a list in the order of the file."""
    mean: float | None
    """Mean, SI; None for a list, as the two fields that follow."""
    standard_deviation: float | None
    credible: tuple[float, float] | None
    """Credible interval with equal tails, at the requested confidence."""
    specimen: str | None
    """The mechanism that was measured, where the file says."""


class Identification(NoArray, Generic[StudyT]):
    """The answer of `Study.identify`: that of the command `loosepin identify`."""

    def __init__(self, native: _loosepin.Identification, study: Callable[[_loosepin.Study], StudyT]) -> None:
        """Use `Study.identify`."""
        self._native = native
        self._study = study

    @cached_property
    def record(self) -> dict[str, Any]:
        """Everything that was found, as plain values: the JSON of the command `loosepin identify`."""
        record: dict[str, Any] = json.loads(self._native.json())
        return record

    @cached_property
    def unknowns(self) -> tuple[Unknown, ...]:
        """Plays of backlash tests and unknowns of motions before and after, specimen by specimen."""
        found = []
        for specimen in self.record["specimens"]:
            plays = specimen["outcome"].get("consistent", {}).get("plays", [])
            found += [_unknown(play, specimen["name"]) for play in plays]
        for specimen in self.record.get("motion", []):
            found += [_unknown(unknown, specimen["name"]) for unknown in specimen["unknowns"]]
        return tuple(found)

    @cached_property
    def posterior(self) -> tuple[Posterior, ...]:
        """Posterior distributions of the unknowns of motions, specimen by specimen; empty where none was asked for, or none can be
        given: `str()` says why."""
        found = []
        for specimen in self.record.get("motion", []):
            given = (specimen.get("posterior") or {}).get("given")
            for unknown, marginal in zip(specimen["unknowns"], given["marginals"], strict=True) if given else ():
                found.append(_posterior(unknown, marginal, specimen["name"]))
        return tuple(found)

    @cached_property
    def is_misfit(self) -> bool:
        """Whether no values explain the measurements at some specimen."""
        of_readings = ("misfit" in specimen["outcome"] for specimen in self.record["specimens"])
        of_motion = (specimen["misfit"] is not None for specimen in self.record.get("motion", []))
        return any(of_readings) or any(of_motion)

    def narrowed(self) -> StudyT:
        """The study with the narrower intervals: `narrowed().text` is its file. Raises LoosepinError for a misfit.

        With `lengths=True` the text names a file of mechanisms, which the study has in memory."""
        return self._study(_loosepin.Study.from_texts(self._native.narrowed()))

    def report(self, path: str | os.PathLike[str]) -> None:
        """Writes the page."""
        must_be("a path", path=path)
        Path(path).write_text(self._native.page(), encoding="utf-8")

    def __reduce__(self) -> tuple[Any, ...]:
        return pickled("Identification", _restored, *self._content(), self._study)

    def __eq__(self, other: object) -> bool:
        """Whether both are the same answer for the same study."""
        return isinstance(other, Identification) and self._content() == other._content()

    def __hash__(self) -> int:
        return hash(self._native.json())

    def _content(self) -> tuple[str, Any]:
        return self._native.json(), self._native.study_texts()

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        found = ", ".join(unknown.path for unknown in self.unknowns)
        return f"<loosepin.Identification of {self.record['study']!r}: {found or 'no unknowns'}{', a misfit' if self.is_misfit else ''}>"


class MotionPlan(Record):
    """Expected information in features of a motion, before anything is measured: the answer of `Study.plan_motion`."""

    def __init__(self, text: str, record: str) -> None:
        """Use `Study.plan_motion`."""
        self._text = text
        self._record = record

    @cached_property
    def record(self) -> dict[str, Any]:
        """Everything that was found, as plain values."""
        record: dict[str, Any] = json.loads(self._record)
        return record

    @property
    def features(self) -> dict[str, float]:
        """Share of the box that each feature alone would leave, the most telling first."""
        return {feature["name"]: feature["share_of_box"] for feature in self.record["features"]}

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<loosepin.MotionPlan: {len(self.features)} features>"


def _restored(json: str, texts: Any, study: Callable[[_loosepin.Study], StudyT]) -> Identification[StudyT]:
    return Identification(_loosepin.Identification.from_parts(json, texts), study)


def _unknown(record: dict[str, Any], specimen: str | None) -> Unknown:
    before, after = record["before_si"], record["after_si"]
    unit = record["unit"]
    return Unknown(record["path"], record["name"], unit, (before[0], before[1]), (after[0], after[1]), specimen)


def _posterior(unknown: dict[str, Any], marginal: dict[str, Any], specimen: str | None) -> Posterior:
    path, unit, shares = unknown["path"], unknown["unit"], tuple(marginal["shares"])
    known = marginal["summary"]
    if known is None:
        return Posterior(path, unit, shares, None, None, None, specimen)
    low, high = known["credible_si"]
    return Posterior(path, unit, shares, known["mean_si"], known["standard_deviation_si"], (low, high), specimen)
