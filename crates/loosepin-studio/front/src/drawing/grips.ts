// What can be taken in a drawing that moves: pins, points that no pin holds, the lines of guides. Each is a button with a name.
import type { Point } from '../editing/drag.ts';
import { element } from './element.ts';
import type { Held, Motion, Outline, DimensionView, JointView } from '../messages.ts';
import { posesAt, worldOf } from './player.ts';
import type { PointName, Target } from './targets.ts';

/** Something that can be taken, with its place in the frame of a body, mm. */
export interface Grippable {
  /** Told from all others by this. */
  key: string;
  held: Held;
  body: number;
  own: Point;
  /** The points that go with it. */
  points: PointName[];
}

const named = (text: string): PointName => {
  const dot = text.indexOf('.');
  return { body: text.slice(0, dot), point: text.slice(dot + 1) };
};

/** Of a joint, where it is a pin. */
export function gripOfJoint({ name, pin, points }: JointView): Grippable | null {
  return pin && { key: 'joint ' + name, held: { take: 'joint', joint: name }, body: pin.body, own: [pin.x, pin.y], points: points.map(named) };
}

/** Of the points that no joint holds. */
export function freeGrips(outline: Outline): Grippable[] {
  const held = new Set(outline.joints.flatMap(({ points }) => points));
  return outline.parts.flatMap((part, body) =>
    part.points
      .filter(({ name }) => !held.has(`${part.name}.${name}`))
      .map(({ name, x, y }): Grippable => ({
        key: `point ${part.name}.${name}`,
        held: { take: 'point', body: part.name, point: name },
        body,
        own: [x, y],
        points: [{ body: part.name, point: name }],
      })),
  );
}

/** Of the line of a guide: taken `far` from its point, mm. */
export function gripOfGuide({ of, body, from, to }: DimensionView, far: number): Grippable {
  const own: Point = [from[0] + (to[0] - from[0]) * far, from[1] + (to[1] - from[1]) * far];
  return { key: 'guide ' + of, held: { take: 'guide', joint: of }, body, own, points: [] };
}

/** Where it is at an angle of the drive, mm. */
export function placeOfGrip({ body, own }: Grippable, motion: Motion, angle: number): Point | null {
  const pose = posesAt(motion, angle)[body];
  return pose ? worldOf(pose, own[0], own[1]) : null;
}

/** Adds a button for each; the player of the drawing moves them with their bodies. */
export function addGrips(layers: DocumentFragment, grips: Grippable[], nameOf: (grip: Grippable) => string): void {
  // y points up in the drawing.
  const upright = element('g', { transform: 'scale(1 -1)', class: 'pins' });
  for (const grip of grips) {
    const button = element('g', { 'data-rides': String(grip.body), 'data-x': String(grip.own[0]), 'data-y': String(grip.own[1]), role: 'button', tabindex: '0', 'aria-label': nameOf(grip) });
    button.classList.add('grip', grip.held.take);
    button.dataset.grip = grip.key;
    if (grip.held.take === 'joint') button.dataset.joint = grip.held.joint;
    // A line without length and with round ends is a disc whose size is in pixels of the screen.
    button.append(element('path', { d: 'M0 0h0', class: 'disc' }));
    if (grip.held.take === 'guide') button.append(element('path', { d: 'M0 0h0', class: 'knob' }));
    upright.append(button);
  }
  layers.append(upright);
}

/** The place of other points that is nearest to `place`, and no farther than `reachMm`; those that go along are no others. */
export function dropAt(place: Point, targets: Target[], own: PointName[], reachMm: number): Target | null {
  const goesAlong = (target: Target): boolean => target.points.some((one) => own.some(({ body, point }) => body === one.body && point === one.point));
  const isOther = (target: Target): boolean => target.points.some(({ body }) => own.some((one) => one.body !== body));
  const far = (target: Target): number => Math.hypot(target.at[0] - place[0], target.at[1] - place[1]);
  const near = targets.filter((target) => far(target) < reachMm && !goesAlong(target) && isOther(target)).sort((a, b) => far(a) - far(b));
  return near[0] ?? null;
}
