// What holds the pointer of a tool: points, their horizontals and verticals, lengths of other links, round numbers.
import type { Point } from '../editing/drag.ts';
import { roundStep } from '../numbers/rounds.ts';
import type { Target } from './targets.ts';

export interface Snapped {
  at: Point;
  /** Index of the target that holds it, where one does. */
  target: number | null;
  /** What holds it: another target on the same horizontal or vertical. */
  along: ('x' | 'y')[];
  /** The link that is as long as the new one. */
  equal: string | null;
}

/** Where a new link begins, and the lengths of those that are there, mm. */
export interface Begun {
  from: Point;
  lengths: { of: string; mm: number }[];
}

const [nearPx, alignedPx, stepPx] = [12, 5, 4];

/** The distance of the round places that a pointer takes on a free place, mm. */
export const roundPlace = (mmPerPx: number): number => roundStep(stepPx * mmPerPx);

/** A place, held by a target near it, else by the horizontals and verticals of targets and by equal lengths, else by round numbers. */
export function snapped(place: Point, targets: Target[], mmPerPx: number, isFree: boolean, begun: Begun | null = null): Snapped {
  const near = targets
    .map((target, index) => ({ index, far: Math.hypot(target.at[0] - place[0], target.at[1] - place[1]) }))
    .filter(({ far }) => far < nearPx * mmPerPx)
    .sort((a, b) => a.far - b.far)[0];
  const held = near && targets[near.index];
  if (near && held) return { at: held.at, target: near.index, along: [], equal: null };
  if (isFree) return { at: place, target: null, along: [], equal: null };
  const step = roundPlace(mmPerPx);
  const along: Snapped['along'] = [];
  const at = ([0, 1] as const).map((axis) => {
    const line = targets.map((target) => target.at[axis]).find((value) => Math.abs(value - place[axis]) < alignedPx * mmPerPx);
    if (line !== undefined) along.push(axis === 0 ? 'x' : 'y');
    return line ?? Math.round(place[axis] / step) * step;
  }) as Point;
  const equal = begun && asLong(place, at, along, begun, alignedPx * mmPerPx);
  return equal ? { at: equal.at, target: null, along, equal: equal.of } : { at, target: null, along, equal: null };
}

/** The place at which the new link is as long as another one: on its own direction, or on the horizontal or vertical that holds it. */
function asLong(place: Point, at: Point, along: Snapped['along'], { from, lengths }: Begun, reachMm: number): { at: Point; of: string } | null {
  const way: Point = along.length === 0 ? [place[0] - from[0], place[1] - from[1]] : [at[0] - from[0], at[1] - from[1]];
  const far = Math.hypot(...way);
  const length = lengths.find(({ mm }) => Math.abs(mm - far) < reachMm);
  if (!length || far === 0) return null;
  const isOnAxis = along.length === 1 && (along[0] === 'x' ? way[0] === 0 : way[1] === 0);
  if (along.length > 0 && !isOnAxis) return null;
  const share = length.mm / far;
  return { at: [from[0] + way[0] * share, from[1] + way[1] * share], of: length.of };
}
