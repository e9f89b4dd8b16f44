"""HTML for notebooks, without network and scripts."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import Any

import numpy as np

from ._figures import INK, RANDOM, UNKNOWN, shown
from ._records import Array, Curve, Extreme

_STYLE = """<style>
.loosepin { max-width: 60em; } .loosepin table { border-collapse: collapse; margin: 0.6em 0; }
.loosepin th, .loosepin td { text-align: left; padding: 0.15em 0.7em; border-bottom: 1px solid #8884; vertical-align: top; }
.loosepin .number { text-align: right; font-variant-numeric: tabular-nums; } .loosepin figcaption { font-size: 0.9em; }
.loosepin .quiet { display: block; opacity: 0.75; font-size: 0.9em; } .loosepin svg { max-width: 100%; height: auto; }
</style>"""


def study_html(name: str, excerpt: str, curves: Sequence[Curve], display_units: dict[str, Any]) -> str:
    """The answer, the key table, and the curves of a study."""
    figures = "".join(_curve_figure(curve, *shown(curve.unit, display_units)) for curve in curves)
    return f'<div class="loosepin">{_STYLE}<h3>{escape(name)}</h3>{excerpt}{figures}</div>'


def simulation_html(title: str, counts: str, extremes: Sequence[Extreme], picture: str, display_units: dict[str, Any]) -> str:
    """The mechanism, and the least and largest value of each output of a run over time, and of its deviation."""
    furthest = {each.output: max(abs(each.minimum.value), abs(each.maximum.value)) for each in extremes if each.of != "value"}
    rows = []
    for each in extremes:
        if each.of != "value":
            continue
        unit, factor = shown(each.unit, display_units)
        cells = [each.minimum.value * factor, each.maximum.value * factor]
        if each.output in furthest:
            cells.append(furthest[each.output] * factor)
        numbers = "".join(f'<td class="number">{cell:.6g} {escape(unit if unit != "1" else "")}</td>' for cell in cells)
        rows.append(f"<tr><td>{escape(each.output)}</td>{numbers}</tr>")
    head = "<tr><th>output, over time</th><th>least</th><th>largest</th><th>furthest from the ideal motion</th></tr>"
    heading = f"<h3>{escape(title)}</h3><p>{counts}</p>"
    return f'<div class="loosepin">{_STYLE}{heading}<table>{head}{"".join(rows)}</table>{picture}</div>'


def evaluation_html(counts: str, outputs: Iterable[tuple[str, str, Array]], reasons: Sequence[str]) -> str:
    """The least and largest value of each output of an evaluation: its name, SI unit and values; and why runs failed."""
    rows = []
    for name, unit, values in outputs:
        finite = values[np.isfinite(values)]
        cells = (f"{end:.6g}" if len(finite) else "" for end in ((finite.min(), finite.max()) if len(finite) else ("", "")))
        numbers = "".join(f'<td class="number">{cell} {escape(unit if unit != "1" else "")}</td>' for cell in cells)
        rows.append(f"<tr><td>{escape(name)}</td><td>{escape(str(values.shape))}</td>{numbers}</tr>")
    head = "<tr><th>output</th><th>shape</th><th>least</th><th>largest</th></tr>"
    first = f"<p>first reason: {escape(reasons[0])}</p>" if reasons else ""
    return f'<div class="loosepin">{_STYLE}<p>{escape(counts)}</p>{first}<table>{head}{"".join(rows)}</table></div>'


_WIDTH, _HEIGHT, _LEFT, _BOTTOM = 640, 220, 64, 34


def _curve_figure(curve: Curve, unit: str, factor: float) -> str:
    """The bands of a deviation over the cycle as SVG."""
    angle = np.degrees(curve.pose_rad)
    ends = [end * factor for end in (*curve.mixed, *curve.random, curve.nominal)]
    finite = np.concatenate([end[np.isfinite(end)] for end in ends])
    if len(angle) < 2 or not len(finite):
        return ""
    low, high = float(min(finite.min(), 0)), float(max(finite.max(), 0))
    span = (high - low) or 1.0

    def x(values: Array) -> Array:
        return _LEFT + (_WIDTH - _LEFT - 8) / float(angle.max() - angle.min()) * (values - float(angle.min()))

    def y(values: Array) -> Array:
        return 8 + (_HEIGHT - _BOTTOM - 8) / span * (high - values)

    def points(along: Array, values: Array) -> str:
        return " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x(along), y(values)) if np.isfinite(b))

    def band(of: Sequence[Array], colour: str, opacity: float) -> str:
        outline = f"{points(angle, of[1] * factor)} {points(angle[::-1], of[0][::-1] * factor)}"
        return f'<polygon points="{outline}" fill="{colour}" fill-opacity="{opacity}"/>'

    lines = f'<polyline points="{points(angle, curve.nominal * factor)}" fill="none" stroke="{INK}" stroke-width="1"/>'
    for value in (low, 0.0, high):
        height = float(y(np.array([value]))[0])
        lines += f'<line x1="{_LEFT}" x2="{_WIDTH - 8}" y1="{height:.1f}" y2="{height:.1f}" stroke="#8886" stroke-width="0.7"/>'
        lines += f'<text x="{_LEFT - 6}" y="{height + 4:.1f}" text-anchor="end">{value:.3g}</text>'
    for value, at, anchor in ((angle[0], _LEFT, "start"), (angle[-1], _WIDTH - 8, "end")):
        lines += f'<text x="{at}" y="{_HEIGHT - 14}" text-anchor="{anchor}">{value:.4g}°</text>'
    share = f"{100 * (curve.probabilities[1] - curve.probabilities[0]):.3g} %"
    words = f"{curve.output}, {curve.of} deviation over the angle of the drive{'' if unit == '1' else ', ' + unit}"
    caption = (
        f'{escape(words)}: <span style="color:{UNKNOWN}">&#9632;</span> {share} of mechanisms for every unknown value, '
        f'<span style="color:{RANDOM}">&#9632;</span> with unknown values in the middle, line: nominal'
    )
    label = escape(words, quote=True)
    picture = f'<svg viewBox="0 0 {_WIDTH} {_HEIGHT}" width="{_WIDTH}" role="img" aria-label="{label}" font-size="11" fill="currentColor">'
    bands = band(curve.mixed, UNKNOWN, 0.45) + band(curve.random, RANDOM, 0.7)
    return f"<figure>{picture}{bands}{lines}</svg><figcaption>{caption}</figcaption></figure>"
