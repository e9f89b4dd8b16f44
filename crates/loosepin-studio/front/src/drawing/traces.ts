// Paths of points over the motion: what linkage designers call the coupler curve.
import type { Point } from '../editing/drag.ts';
import type { Motion } from '../messages.ts';
import { element } from './element.ts';
import { posesAt, worldOf } from './player.ts';
import { roundBelow } from '../numbers/rounds.ts';

/** A point whose path is drawn. */
export interface Traced {
  body: number;
  own: Point;
  kind: 'output' | 'pointed';
  /** How far the point strays across its path, mm, at each pose. */
  across?: (number | null)[];
}

/** The path of a point, mm. */
export function pathOf(motion: Motion, { body, own }: Traced): Point[] {
  return motion.angle_deg.flatMap((angle) => {
    const pose = angle === null ? undefined : posesAt(motion, angle)[body];
    return pose ? [worldOf(pose, own[0], own[1])] : [];
  });
}

/** Half the width of a drawn zone where it is widest, px, at most. */
const zonePx = 14;

/** How many times as wide as they are zones are drawn: a round number at which the widest is well seen, and at least 1. */
export function zoneFactor(across: (number | null)[][], pxPerMm: number): number {
  const widest = Math.max(...across.flat().map((value) => value ?? 0), 0);
  if (widest <= 0) return 1;
  return Math.max(roundBelow(zonePx / (widest * pxPerMm)), 1);
}

/** Both edges of the zone about a path: so far to either side of it, across the motion. */
export function zoneOf(path: Point[], across: (number | null)[], factor: number): string {
  const edge = (side: 1 | -1): Point[] =>
    path.map(([x, y], index) => {
      const before: Point = path[Math.max(index - 1, 0)] ?? [x, y];
      const after: Point = path[Math.min(index + 1, path.length - 1)] ?? [x, y];
      const [dx, dy] = [after[0] - before[0], after[1] - before[1]];
      const share = (side * factor * (across[index] ?? 0)) / Math.max(Math.hypot(dx, dy), 1e-12);
      return [x - dy * share, y + dx * share];
    });
  const drawn = (points: Point[]): string => points.map(([x, y]) => x.toFixed(4) + ' ' + y.toFixed(4)).join('L');
  return 'M' + drawn(edge(1)) + 'L' + drawn(edge(-1).reverse()) + 'Z';
}

/** Draws paths under the mechanism, and the zones about them. */
export function drawTraces(layer: SVGElement, motion: Motion, traced: Traced[], factor: number): void {
  layer.replaceChildren(
    ...traced.flatMap((one) => {
      const path = pathOf(motion, one);
      const d = 'M' + path.map(([x, y]) => x.toFixed(4) + ' ' + y.toFixed(4)).join('L');
      const line = element('path', { d, class: 'trace ' + one.kind });
      return one.across ? [element('path', { d: zoneOf(path, one.across, factor), class: 'zone-of-path' }), line] : [line];
    }),
  );
}
