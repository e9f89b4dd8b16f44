// Paths of points over the motion: what linkage designers call the coupler curve.
import type { Point } from '../editing/drag.ts';
import type { LivePath, Motion } from '../messages.ts';
import { element } from './element.ts';
import { poseAt, posesAt, worldOf } from './player.ts';
import { about, cornersOf, ellipseAt, hasZone, outline, playReach, swept, zoneReach, type Zoned } from './zones.ts';

/** A point whose path is drawn. */
export interface Traced {
  body: number;
  own: Point;
  kind: 'output' | 'traced' | 'pointed';
  /** The path with its zone, where the server has it. */
  path: LivePath | null;
}

/** A path with where its point is at each pose, mm. */
export interface Trace extends Traced {
  places: Point[];
}

export function tracesOf(motion: Motion, traced: Traced[]): Trace[] {
  const poses = motion.angle_deg.flatMap((angle) => (angle === null ? [] : [posesAt(motion, angle)]));
  return traced.map((one) => ({
    ...one,
    places: poses.flatMap((bodies) => {
      const pose = bodies[one.body];
      return pose ? [worldOf(pose, one.own[0], one.own[1])] : [];
    }),
  }));
}

/** Those with a zone. */
export function zonesOf(traces: Trace[]): Zoned[] {
  return traces.flatMap(({ path, places }) => (path && hasZone(path) && places.length > 0 ? [{ path, places }] : []));
}

/** Draws paths under the mechanism, and the zones over all their places. */
export function drawTraces(layer: SVGElement, traces: Trace[], factor: number): void {
  const zones = zonesOf(traces).map((zone) => element('path', { d: swept(zone, factor), class: 'zone-of-path', 'data-point': zone.path.point }));
  const lines = traces.map(({ kind, places }) => {
    const d = 'M' + places.map(([x, y]) => x.toFixed(4) + ' ' + y.toFixed(4)).join('L');
    return element('path', { d, class: 'trace ' + kind });
  });
  layer.replaceChildren(...zones, ...lines);
}

/** Draws where each traced point is at an angle of the drive, and its zone there: of play and scatter, of the play alone, and the ellipse of the scatter alone. */
export function drawZonesNow(layer: SVGElement, motion: Motion, traces: Trace[], factor: number, angle: number): void {
  const pose = poseAt(motion.angle_deg, angle);
  const bodies = posesAt(motion, angle);
  layer.replaceChildren(
    ...traces.flatMap(({ body, own, kind, path }) => {
      const at = bodies[body];
      if (!at || kind === 'pointed') return [];
      const place = worldOf(at, own[0], own[1]);
      const [x, y] = place.map((value) => value.toFixed(4));
      const drawn: SVGElement[] = [];
      if (path && hasZone(path)) {
        const around = (reach: number[], name: string): SVGElement => element('path', { d: outline(about(place, cornersOf(reach), factor)), class: name });
        drawn.push(around(zoneReach(path, pose), 'zone'));
        const ellipse = ellipseAt(path, pose);
        if (ellipse && path.play_reach_mm.length > 0) drawn.push(around(playReach(path, pose), 'play'));
        if (ellipse) drawn.push(element('ellipse', { rx: (factor * ellipse[0]).toFixed(4), ry: (factor * ellipse[1]).toFixed(4), transform: `translate(${x} ${y}) rotate(${ellipse[2]})`, class: 'scatter' }));
      }
      if (drawn.length === 0 && kind === 'traced') drawn.push(element('path', { d: `M${x} ${y}h0`, class: 'spot' }));
      drawn.forEach((one) => path && (one.dataset.point = path.point));
      return drawn;
    }),
  );
}
