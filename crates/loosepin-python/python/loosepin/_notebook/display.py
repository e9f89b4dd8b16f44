"""Objects that a notebook shows as a live figure."""

from __future__ import annotations

import importlib.util
from abc import abstractmethod
from typing import TYPE_CHECKING, Any, NamedTuple

from .._extras import need
from .kernel import has_kernel

if TYPE_CHECKING:
    from .widget import FigureWidget


class Figure(NamedTuple):
    """What a widget shows."""

    title: str
    document: str
    drive_angle_rad: float | None
    """Angle of the drive at the cursor, rad; None without a drawing of the mechanism."""


class NotebookDisplay:
    """A run or a study. As the last line of a cell it is a widget; without a front end for widgets, a still figure."""

    def widget(self) -> FigureWidget:
        """The mechanism and its chart in a notebook, with one cursor, which `drive_angle_rad` of the widget reads and sets.

            figure = run.widget()
            figure.observe(lambda change: print(change["new"]), "drive_angle_rad")
            figure

        Needs anywidget. Each call makes a widget of its own. Where nothing shows widgets, the figure stands still.
        """
        need("anywidget", "widget()")
        from .widget import FigureWidget

        title, document, drive_angle_rad = self._figure()
        return FigureWidget(title, document, drive_angle_rad, self._repr_html_())

    @abstractmethod
    def _figure(self) -> Figure:
        """The live figure."""

    @abstractmethod
    def _repr_html_(self) -> str:
        """The still figure, without scripts."""

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        bundle: dict[str, Any] = {"text/plain": repr(self), "text/html": self._repr_html_()}
        if has_kernel() and importlib.util.find_spec("anywidget") is not None:
            data = self._own_widget()._repr_mimebundle_()
            bundle = {**(data[0] if isinstance(data, tuple) else data), **bundle}
        return bundle

    def _own_widget(self) -> FigureWidget:
        """The one that the object itself shows, however often."""
        widget: FigureWidget | None = self.__dict__.get("_displayed_widget")
        if widget is None or widget.comm is None:
            widget = self.__dict__["_displayed_widget"] = self.widget()
        return widget
