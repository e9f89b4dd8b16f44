"""The widget of a run or a study. It needs anywidget: this module is imported where one is made."""

from __future__ import annotations

import math
from typing import Any

import anywidget
import traitlets

from .._loosepin import widget_script


class FigureWidget(anywidget.AnyWidget):
    """The mechanism and its chart in a notebook, with one cursor: the first screen of the page that `report` writes.

    It is an ipywidgets widget: it can be observed, linked with other widgets, and put into a layout.
    """

    _esm = widget_script()
    _document = traitlets.Unicode().tag(sync=True)
    _title = traitlets.Unicode().tag(sync=True)
    drive_angle_rad = traitlets.Float(
        None, allow_none=True, help="Angle of the drive at the cursor, rad, as in `Simulation.drive_angle_rad`; None without a mechanism."
    ).tag(sync=True)

    def __init__(self, title: str, document: str, drive_angle_rad: float | None, static_html: str) -> None:
        """Use `Simulation.widget` or `StudyResult.widget`."""
        self._static_html = static_html
        super().__init__(_title=title, _document=document, drive_angle_rad=drive_angle_rad)

    @traitlets.validate("drive_angle_rad")
    def _check_angle(self, proposal: Any) -> float | None:
        angle: float | None = proposal["value"]
        if angle is not None and not math.isfinite(angle):
            raise traitlets.TraitError(f"drive_angle_rad is {angle}; must be finite")
        return angle

    def _repr_mimebundle_(self, **options: Any) -> Any:
        """The view, and the still figure where there is no front end for it."""
        bundle = super()._repr_mimebundle_(**options)
        # Some versions give the metadata as well.
        data = bundle[0] if isinstance(bundle, tuple) else bundle
        if data is not None:
            data["text/html"] = self._static_html
        return bundle

    def __repr__(self) -> str:
        return f"<loosepin.FigureWidget of {self._title!r}, drive_angle_rad={self.drive_angle_rad}>"
