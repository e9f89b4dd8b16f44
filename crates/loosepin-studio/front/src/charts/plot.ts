// Where the angles and values of a chart stand in it, as the server says in `data-plot`, `data-x` and `data-y`.
import { pointIn } from '../drawing/screen.ts';

export interface Plot {
  left: number;
  top: number;
  width: number;
  height: number;
  first: number;
  last: number;
  /** Values at the foot and at the head. */
  low: number;
  high: number;
}

export function plotOf(svg: SVGSVGElement): Plot | null {
  const [left, top, width, height] = (svg.dataset.plot ?? '').split(/\s+/).map(Number);
  const [first, last] = (svg.dataset.x ?? '').split(/\s+/).map(Number);
  const [low, high] = (svg.dataset.y ?? '').split(/\s+/).map(Number);
  if (left === undefined || top === undefined || !width || !height || first === undefined || last === undefined || first === last) return null;
  if (low === undefined || high === undefined || low === high) return null;
  return [left, top, width, height, first, last, low, high].every(Number.isFinite) ? { left, top, width, height, first, last, low, high } : null;
}

export function yAt(plot: Plot, value: number): number {
  return plot.top + ((plot.high - value) / (plot.high - plot.low)) * plot.height;
}

/** The value at a place of the screen; beyond the frame it goes on. */
export function valueAt(plot: Plot, svg: SVGSVGElement, clientX: number, clientY: number): number | null {
  const at = pointIn(svg, clientX, clientY);
  if (!at) return null;
  return plot.high - ((at.y - plot.top) / plot.height) * (plot.high - plot.low);
}

export function xAt(plot: Plot, angle: number): number {
  return plot.left + ((angle - plot.first) / (plot.last - plot.first)) * plot.width;
}

export function angleAt(plot: Plot, svg: SVGSVGElement, clientX: number, clientY: number): number | null {
  const at = pointIn(svg, clientX, clientY);
  if (!at) return null;
  const share = (at.x - plot.left) / plot.width;
  return plot.first + Math.min(Math.max(share, 0), 1) * (plot.last - plot.first);
}

export interface LegendEntry {
  /** The meaning of its colour, such as `random` or `mixed`. */
  role: string;
  words: string;
}

const roles = ['mixed', 'random', 'worst', 'nominal', 'mean', 'probability', 'limit'];

/** Takes the legend out of a chart: beside it the words can wrap, and keep their size in a narrow window. */
export function takeLegend(svg: SVGSVGElement): LegendEntry[] {
  const key = svg.querySelector('.key');
  key?.remove();
  const texts = [...(key?.querySelectorAll('text') ?? [])];
  // Before each text stands the line of its entry.
  return texts.map((text) => ({
    role: roles.find((role) => text.previousElementSibling?.classList.contains(role)) ?? '',
    words: text.textContent ?? '',
  }));
}
