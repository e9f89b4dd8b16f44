"""The standard figures, drawn with matplotlib."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ._extras import need
from ._records import Array, Bound, Curve

if TYPE_CHECKING:
    import matplotlib.figure

Axes = Any
"""Axes of matplotlib, a list of them, or None."""

RANDOM = "#1f6f8b"
"""Colour of random scatter."""
UNKNOWN = "#d98324"
"""Colour of unknown inputs."""
INK = "#333333"


def shown(unit: str, display_units: dict[str, Any]) -> tuple[str, float]:
    """The display unit for an SI unit, and the number of display units in one SI unit."""
    display = display_units.get(unit)
    return (unit, 1.0) if display is None else (display["symbol"], float(display["per_si"]))


@dataclass(frozen=True, eq=False, repr=False)
class Line:
    """An output of a run, or its deviation, over the angle of the drive."""

    name: str
    """Name of the output."""
    label: str
    """Label of the axis."""
    unit: str
    """SI unit of the values."""
    values: Array
    ideal: Array | None
    """Values without play, if they are drawn too."""
    has_legend: bool


def simulation_figure(
    drive_angle_rad: Array, lines: Sequence[Line], display_units: dict[str, Any], ax: Axes = None
) -> matplotlib.figure.Figure:
    """Outputs, or their deviations, over the angle of the drive."""
    figure, axes = _panels([line.label for line in lines], ax)
    angle = np.degrees(drive_angle_rad)
    for axis, line in zip(axes, lines):
        unit, factor = shown(line.unit, display_units)
        if line.ideal is not None:
            axis.plot(angle, line.ideal * factor, color=INK, lw=0.8, ls="--", label="ideal")
        axis.plot(angle, line.values * factor, color=RANDOM, lw=1.2, label=line.name)
        axis.set_ylabel(f"{line.label}{_in(unit)}")
        if line.has_legend:
            axis.legend(frameon=False)
    if lines:
        axes[-1].set_xlabel("angle of the drive [deg]")
    return figure


def study_figure(
    name: str,
    curves: Sequence[Curve],
    summary: Mapping[str, Any],
    kind: str | None,
    output: str | None,
    of: str | None,
    ax: Axes = None,
) -> matplotlib.figure.Figure:
    """One of the standard figures of a study; the first kind that there is, where none is named."""
    drawn: dict[str, Callable[[Any, Any, dict[str, Any]], None]] = {"curves": _curves, "box": _boxes, "contributors": _contributors}
    holds = {"curves": "curves", "box": "boxes", "contributors": "contributors"}
    if kind is None:
        kind = next((kind for kind in drawn if summary[holds[kind]]), "curves")
    if kind not in drawn:
        raise ValueError(f"kind {kind!r}; must be 'curves', 'box' or 'contributors'")

    def is_wanted(item: Any) -> bool:
        own = (item["output"], item["of"]) if isinstance(item, dict) else (item.output, item.of)
        return all(wanted is None or wanted == found for wanted, found in zip((output, of), own))

    items = [item for item in (curves if kind == "curves" else summary[holds[kind]]) if is_wanted(item)]
    if not items:
        raise ValueError(f"the study {name!r} has no {kind} of output={output!r}, of={of!r}\nhint: an [[ask]] of the study makes them")
    drawn_items = [f"{item['output']} {item['of']}" if isinstance(item, dict) else f"{item.output} {item.of}" for item in items]
    figure, axes = _panels(drawn_items, ax)
    for axis, item in zip(axes, items):
        drawn[kind](axis, item, summary["display_units"])
    return figure


def motion_figure(
    drive_angle_rad: Array,
    outputs: Sequence[tuple[str, str, tuple[Array, Array], tuple[Array, Array]]],
    display_units: dict[str, Any],
    ax: Axes = None,
) -> matplotlib.figure.Figure:
    """Deviations of outputs by play over the cycle: name, SI unit, the ends that were found, those that are proven."""
    figure, axes = _panels([name for name, *_ in outputs], ax)
    angle = np.degrees(drive_angle_rad)
    for axis, (name, symbol, found, proven) in zip(axes, outputs):
        unit, factor = shown(symbol, display_units)
        axis.fill_between(angle, *(end * factor for end in found), color=UNKNOWN, alpha=0.35, lw=0, label="all positions of the pins")
        for end, label in zip(proven, ("proven limit", None)):
            axis.plot(angle, end * factor, color=INK, lw=0.8, ls=":", label=label)
        axis.set_ylabel(f"{name}, deviation by play{_in(unit)}")
        axis.legend(frameon=False, fontsize="small")
    axes[-1].set_xlabel("angle of the drive [deg]")
    return figure


def path_figure(
    point: str,
    path_m: tuple[Array, Array],
    zone_m: Array,
    magnification: float | None,
    display_units: dict[str, Any],
    ax: Axes = None,
) -> matplotlib.figure.Figure:
    """The path of a point, and about it its zone, magnified: corners about each position, shape (positions, corners, 2)."""
    figure, (axis,) = _panels([point], ax)
    unit, factor = shown("m", display_units)
    x_m, y_m = path_m
    widest = np.hypot(zone_m[:, :, 0], zone_m[:, :, 1]).max()
    if magnification is None:
        magnification = _round_down(0.08 * np.hypot(np.ptp(x_m), np.ptp(y_m)) / widest) if widest > 0 else 1.0
    # Matplotlib is there: the axes are its own.
    collections = need("matplotlib.collections", "plot()")
    corners = factor * (np.stack([x_m, y_m], axis=1)[:, np.newaxis, :] + magnification * zone_m)
    if widest > 0:
        axis.add_collection(collections.PolyCollection(corners, facecolor="#f0cda5", edgecolor="none"))
        axis.plot([], [], color="#f0cda5", lw=6, label=f"zone, magnified {magnification:g} times")
    axis.plot(x_m * factor, y_m * factor, color=INK, lw=1.2, label="ideal path")
    axis.set(xlabel=f"x of {point}{_in(unit)}", ylabel=f"y{_in(unit)}", aspect="equal")
    axis.legend(frameon=False, fontsize="small")
    return figure


def _round_down(value: float) -> float:
    """1, 2 or 5 times a power of ten, at most `value`; at least 1."""
    if value < 1:
        return 1.0
    power = 10.0 ** np.floor(np.log10(value))
    return float(next(step * power for step in (5, 2, 1) if step * power <= value * (1 + 1e-9)))


def sweep_figure(
    over: tuple[str, str, Array], outputs: Sequence[tuple[str, str, Array]], display_units: dict[str, Any], ax: Axes = None
) -> matplotlib.figure.Figure:
    """Deviations of outputs once a turn, with the shape (values, turns), over a quantity: each has name, SI unit and values."""
    figure, axes = _panels([name for name, *_ in outputs], ax)
    path, symbol, values_si = over
    unit, factor = shown(symbol, display_units)
    for axis, (name, output_symbol, sections_si) in zip(axes, outputs):
        output_unit, output_factor = shown(output_symbol, display_units)
        axis.plot(values_si * factor, sections_si * output_factor, ls="", marker=".", ms=1.5, color=RANDOM)
        axis.set_ylabel(f"{name}, deviation once a turn{_in(output_unit)}")
    axes[-1].set_xlabel(f"{path}{_in(unit)}")
    return figure


def distribution_figure(
    outputs: Sequence[tuple[str, tuple[Array, Array, Array] | None, Sequence[Bound]]], ax: Axes = None
) -> matplotlib.figure.Figure:
    """Bounds of distribution functions: name of an output, values with both ends of its function, and bounds of other statistics."""
    figure, axes = _panels([name for name, _, _ in outputs], ax)
    for axis, (name, box, bounds) in zip(axes, outputs):
        drawn = [_distribution_mark(axis, each) for each in bounds]
        if box is not None:
            values, lower, upper = box
            axis.fill_between(values, lower, upper, color=UNKNOWN, alpha=0.35, lw=0)
        elif not any(drawn):
            raise ValueError(f"no bound of '{name}' is drawn\nhint: ask for \"cdf\", \"mean\", a quantile or a probability")
        axis.set(xlabel=name, ylabel="probability to stay below", ylim=(0, 1))
    return figure


def _distribution_mark(axis: Any, bound: Bound) -> bool:
    """Draws a bound into the picture of a distribution function; False for a statistic that has no place there."""
    lower, upper = bound.widened
    if bound.statistic == "mean":
        axis.axvspan(lower, upper, color=RANDOM, alpha=0.3, lw=0)
    elif bound.statistic == "quantile":
        axis.plot([lower, upper], [bound.parameter, bound.parameter], color=INK, marker="|")
    elif bound.statistic == "probability_below":
        axis.plot([bound.parameter, bound.parameter], [lower, upper], color=INK, marker="_")
    elif bound.statistic == "probability_above":
        axis.plot([bound.parameter, bound.parameter], [1 - upper, 1 - lower], color=INK, marker="_")
    else:
        return False
    return True


def _curves(axis: Any, curve: Curve, units: dict[str, Any]) -> None:
    unit, factor = shown(curve.unit, units)
    angle = np.degrees(curve.pose_rad)
    share = 100 * (curve.probabilities[1] - curve.probabilities[0])
    axis.fill_between(angle, *(end * factor for end in curve.mixed), color=UNKNOWN, alpha=0.35, lw=0, label=f"{share:.3g} %, all unknown values")
    axis.fill_between(angle, *(end * factor for end in curve.random), color=RANDOM, alpha=0.6, lw=0, label=f"{share:.3g} %, unknown values in the middle")
    axis.plot(angle, curve.nominal * factor, color=INK, lw=0.9, label="nominal")
    axis.set(xlabel="angle of the drive [deg]", ylabel=f"{curve.output}, {curve.of}{_in(unit)}")
    axis.legend(frameon=False, fontsize="small")


def _boxes(axis: Any, box: dict[str, Any], units: dict[str, Any]) -> None:
    unit, factor = shown(box["unit"], units)
    values = np.array(box["value_si"], dtype=float) * factor
    lower, upper, only = (np.array(box[key], dtype=float) for key in ("lower", "upper", "probability_only"))
    axis.fill_between(values, lower, upper, color=UNKNOWN, alpha=0.35, lw=0, label="all unknown values")
    axis.plot(values, only, color=RANDOM, lw=1.2, label="unknown values taken as random")
    if box["limit_si"] is not None:
        axis.axvline(float(box["limit_si"]) * factor, color=INK, lw=0.8, ls=":")
    at = box["at"].get("reduction", "").replace("_", " ")
    axis.set(xlabel=f"{box['output']}, {box['of']} {at}{_in(unit)}", ylabel="probability to stay below", ylim=(0, 1))
    axis.legend(frameon=False, fontsize="small")


def _contributors(axis: Any, record: dict[str, Any], _units: dict[str, Any]) -> None:
    bars = [(" + ".join(each["paths"]), each["band_share"], each["band_share"], RANDOM) for each in record["random"]]
    measurable = [each for each in record["epistemic"] if each.get("can_be_measured", True)]
    bars += [(each["path"], *each["band_share"], UNKNOWN) for each in measurable]
    bars.sort(key=lambda bar: float(bar[2]))
    # Nobody can do anything about these: they stand below all others.
    others = [each for each in record["epistemic"] if each not in measurable]
    bars = [("where the pins sit (not measurable)", *each["band_share"], UNKNOWN) for each in others] + bars
    # A share that nobody knows has no bar.
    bars = [bar for bar in bars if np.isfinite(float(bar[2]))]
    for row, (_, low, high, colour) in enumerate(bars):
        axis.barh(row, 100 * float(high), color=colour, alpha=0.55)
        axis.barh(row, 100 * float(low), color=colour)
    axis.set_yticks(range(len(bars)), [bar[0] for bar in bars])
    axis.set_xlabel("% by which the band becomes narrower")
    pose = record["at"].get("pose_rad")
    at = record["at"].get("reduction", record["at"]["kind"]).replace("_", " ") if pose is None else f"at {np.degrees(float(pose)):.6g}°"
    axis.set_title(f"{record['output']}, {record['of']} {at}: held fixed (blue), known (orange)", fontsize="medium")


def _panels(drawn: Sequence[str], ax: Axes) -> tuple[matplotlib.figure.Figure, list[Any]]:
    """Axes for each of `drawn`: those that were given, which stay open, or those of a new figure."""
    count = len(drawn)
    if count == 0:
        raise ValueError("there is nothing to draw")
    if ax is not None:
        return _given(drawn, ax)
    pyplot = need("matplotlib.pyplot", "plot()")
    figure, axes = pyplot.subplots(count, 1, figsize=(8, 1 + 3 * count), squeeze=False, layout="constrained")
    # A notebook shows the figure that is returned; one that pyplot knows as well would be shown twice.
    pyplot.close(figure)
    return figure, list(axes[:, 0])


def _given(drawn: Sequence[str], ax: Any) -> tuple[matplotlib.figure.Figure, list[Any]]:
    axes = list(ax.flat) if hasattr(ax, "flat") else list(ax) if isinstance(ax, Sequence) else [ax]
    for axis in axes:
        if not hasattr(axis, "set_xlabel"):
            raise TypeError(f"ax is a {type(axis).__name__}; must be axes of matplotlib, or a list of them")
    if len(axes) != len(drawn):
        raise ValueError(f"ax: {len(axes)} axes; must be {len(drawn)}, for {', '.join(drawn)}")
    return axes[0].get_figure(), axes


def _in(unit: str) -> str:
    return "" if unit == "1" else f" [{unit}]"
