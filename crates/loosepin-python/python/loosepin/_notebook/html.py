"""HTML for notebooks, without network and scripts."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import Any

import numpy as np

from .._figures import shown
from .._records import Array, Extreme

_STYLE = """<style>
.loosepin { max-width: 60em; } .loosepin table { border-collapse: collapse; margin: 0.6em 0; }
.loosepin th, .loosepin td { text-align: left; padding: 0.15em 0.7em; border-bottom: 1px solid #8884; vertical-align: top; }
.loosepin .number { text-align: right; font-variant-numeric: tabular-nums; }
.loosepin .quiet { display: block; opacity: 0.75; font-size: 0.9em; } .loosepin img { display: block; margin: 0.6em 0; }
</style>"""


def study_html(name: str, excerpt: str) -> str:
    """The answer, the mechanism, the curves and the key table of a study."""
    return f'<div class="loosepin">{_STYLE}<h3>{escape(name)}</h3>{excerpt}</div>'


def simulation_html(title: str, counts: str, extremes: Sequence[Extreme], figures: str, display_units: dict[str, Any]) -> str:
    """The mechanism with its chart, and the least and largest value of each output of a run over time, and of its deviation."""
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
    return f'<div class="loosepin">{_STYLE}{heading}<table>{head}{"".join(rows)}</table>{figures}</div>'


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
