// Paths of points over the motion: what linkage designers call the coupler curve.
import type { Point } from '../editing/drag.ts';
import type { Motion } from '../messages.ts';
import { element } from './element.ts';
import { posesAt, worldOf } from './player.ts';

/** A point whose path is drawn. */
export interface Traced {
  body: number;
  own: Point;
  kind: 'output' | 'pointed';
}

/** The path of a point, mm. */
export function pathOf(motion: Motion, { body, own }: Traced): Point[] {
  return motion.angle_deg.flatMap((angle) => {
    const pose = angle === null ? undefined : posesAt(motion, angle)[body];
    return pose ? [worldOf(pose, own[0], own[1])] : [];
  });
}

/** Draws paths under the mechanism. */
export function drawTraces(layer: SVGElement, motion: Motion, traced: Traced[]): void {
  layer.replaceChildren(
    ...traced.map((one) => {
      const d = 'M' + pathOf(motion, one).map(([x, y]) => x.toFixed(4) + ' ' + y.toFixed(4)).join('L');
      return element('path', { d, class: 'trace ' + one.kind });
    }),
  );
}
