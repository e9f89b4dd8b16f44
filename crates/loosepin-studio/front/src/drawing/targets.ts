// What a tool can take on a drawing: places where points of bodies are, each a button with a name.
import type { End, Motion, BodyView } from '../messages.ts';
import type { Point } from '../editing/drag.ts';
import { element } from './element.ts';
import { posesAt, worldOf } from './player.ts';
import { roundStep } from '../numbers/rounds.ts';

export interface PointName {
  body: string;
  point: string;
}

/** Points of different bodies at one place, mm. */
export interface Place {
  points: PointName[];
  at: Point;
}

export interface Target extends Place {
  /** Index of the body that carries the first of them, and where it is in its frame, mm. */
  body: number;
  own: Point;
}

const samePlaceMm = 1e-3;

/** Whether two places are one to the thousandth of a millimetre to which drawings are written. */
export const isSamePlace = (one: Point, other: Point): boolean => Math.hypot(one[0] - other[0], one[1] - other[1]) < samePlaceMm;

/** The places of all points at an angle of the drive. */
export function targetsOf(parts: BodyView[], motion: Motion, angle: number): Target[] {
  const poses = posesAt(motion, angle);
  const targets: Target[] = [];
  parts.forEach((part, body) => {
    const pose = poses[body];
    if (!pose) return;
    for (const { name, x, y } of part.points) {
      const at = worldOf(pose, x, y);
      const known = targets.find((one) => isSamePlace(one.at, at));
      if (known) known.points.push({ body: part.name, point: name });
      else targets.push({ points: [{ body: part.name, point: name }], body, own: [x, y], at });
    }
  });
  return targets;
}

/** Adds a button for each of them; the player of the drawing moves them with their bodies. */
export function addTargets(layers: DocumentFragment, targets: Target[], nameOf: (target: Target) => string): void {
  const upright = element('g', { transform: 'scale(1 -1)', class: 'targets' });
  targets.forEach((target, index) => {
    const [x, y] = target.own;
    const button = element('g', { 'data-rides': String(target.body), 'data-x': String(x), 'data-y': String(y), 'data-target': String(index) });
    button.classList.add('grip', 'target');
    button.setAttribute('tabindex', '0');
    button.setAttribute('role', 'button');
    button.setAttribute('aria-label', nameOf(target));
    button.append(element('path', { d: 'M0 0h0', class: 'disc' }), element('path', { d: 'M0 0h0', class: 'dot' }));
    upright.append(button);
  });
  layers.append(upright);
}

/** An end at a target: of a body other than `not`, where there is one. */
export function endAt(target: Place, not: string | null = null): End {
  const found = target.points.find(({ body }) => body !== not) ?? target.points[0];
  return found ? { at: 'point', ...found } : { at: 'free', x: target.at[0], y: target.at[1] };
}

/** Ends at two targets, of two bodies where that can be. */
export function endsAt(first: Place, second: Place): [End, End] {
  for (const one of first.points) {
    const other = second.points.find(({ body }) => body !== one.body);
    if (other) return [{ at: 'point', ...one }, { at: 'point', ...other }];
  }
  return [endAt(first), endAt(second)];
}

const barPx = 70;

/** Length of the bar of a scale, mm: the shortest round one that is long enough on the screen. */
export function barLength(pxPerMm: number): number {
  return roundStep(barPx / pxPerMm);
}
