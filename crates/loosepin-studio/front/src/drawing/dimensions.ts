// Dimensions of what is chosen, on the drawing: a line with its ends, and the length with its tolerance.
import type { BodyView, DimensionView, PinView } from '../messages.ts';
import { element } from './element.ts';

/** The side of a line on which a body has less: 1 is to the left of it. */
function freeSide({ from, to }: DimensionView, part: BodyView | undefined): 1 | -1 {
  const across = (part?.points ?? []).reduce((sum, { x, y }) => sum + (to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0]), 0);
  return across > 0 ? -1 : 1;
}

/** Adds the dimensions; the player moves them with their bodies. `fontMm` is the size of the letters. */
export function addDimensions(svg: SVGSVGElement, dimensions: DimensionView[], parts: BodyView[], textOf: (dimension: DimensionView) => string, fontMm: number): void {
  const upright = element('g', { transform: 'scale(1 -1)', class: 'dimensions' });
  upright.style.fontSize = (1.1 * fontMm).toFixed(4) + 'px';
  for (const dimension of dimensions) {
    const { kind, body, from } = dimension;
    const [dx, dy] = [dimension.to[0] - from[0], dimension.to[1] - from[1]];
    const length = Math.hypot(dx, dy);
    if (length === 0) continue;
    const [ux, uy] = [dx / length, dy / length];
    const size = 1.1 * fontMm;
    // An angle is that of a line without end: a stretch of it is drawn.
    const reach = kind === 'angle' ? 6 * size : length;
    const side = freeSide(dimension, parts[body]);
    const aside = kind === 'angle' ? 0 : 1.6 * size * side;
    const at = (along: number, across: number): [number, number] => [from[0] + ux * along - uy * across, from[1] + uy * along + ux * across];
    const path = (points: [number, number][]): string => 'M' + points.map((point) => point.map((value) => value.toFixed(4)).join(' ')).join('L');
    const start = kind === 'angle' ? -reach : 0;
    const lines = [path([at(start, aside), at(reach, aside)])];
    if (kind === 'length') lines.push(path([at(0, 0.3 * size * side), at(0, aside + 0.4 * size * side)]), path([at(reach, 0.3 * size * side), at(reach, aside + 0.4 * size * side)]));
    const moving = element('g', { 'data-body': String(body) });
    moving.append(element('path', { d: lines.join(''), class: 'dimension' }));
    const [x, y] = at(kind === 'angle' ? reach : reach / 2, aside + 0.9 * size * side);
    const rider = element('g', { 'data-rides': String(body), 'data-x': String(x), 'data-y': String(y) });
    const text = element('text', { class: 'dimension', transform: 'scale(1 -1)', 'text-anchor': 'middle', 'dominant-baseline': 'middle' });
    text.textContent = textOf(dimension);
    if (dimension.path !== null) makeEditable(text, dimension.path);
    rider.append(text);
    upright.append(moving, rider);
  }
  svg.append(upright);
}

/** A button of the canvas: the number is edited where it stands. */
function makeEditable(text: SVGElement, path: string): void {
  text.classList.add('editable');
  text.dataset.path = path;
  Object.entries({ role: 'button', tabindex: '0' }).forEach(([name, value]) => text.setAttribute(name, value));
}

/** Adds the play of a pin beside it, or that it has none yet. */
export function addPlay(svg: SVGSVGElement, { body, x, y }: PinView, path: string, written: string, fontMm: number): void {
  const size = 1.1 * fontMm;
  const upright = element('g', { transform: 'scale(1 -1)', class: 'dimensions' });
  upright.style.fontSize = size.toFixed(4) + 'px';
  const rider = element('g', { 'data-rides': String(body), 'data-x': String(x), 'data-y': String(y) });
  const text = element('text', { class: 'dimension', transform: 'scale(1 -1)', x: (1.4 * size).toFixed(4), y: (1.9 * size).toFixed(4), 'dominant-baseline': 'middle' });
  text.textContent = written;
  makeEditable(text, path);
  rider.append(text);
  upright.append(rider);
  svg.append(upright);
}
