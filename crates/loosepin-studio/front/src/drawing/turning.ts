// A link that is taken turns the mechanism, as a finger turns a model of cardboard: only the play head moves.
import type { Point } from '../editing/drag.ts';
import type { Motion } from '../messages.ts';
import { posesAt, worldOf } from './player.ts';

/** So many degrees to either side are looked at: a slider is at each place twice in a turn. */
const reachDeg = 60;
const stepDeg = 1;

/** The angle of the drive, near to where it is, at which a point of a body is nearest to a place. */
export function angleNear(motion: Motion, body: number, own: Point, to: Point, now: number): number {
  const [first, last] = [motion.angle_deg[0] ?? 0, motion.angle_deg.at(-1) ?? 0];
  const [low, high] = [Math.min(first, last), Math.max(first, last)];
  const isFull = high - low >= 359;
  const folded = (angle: number): number => (isFull ? low + ((((angle - low) % 360) + 360) % 360) : Math.min(Math.max(angle, low), high));
  const distance = (angle: number): number => {
    const pose = posesAt(motion, folded(angle))[body];
    if (!pose) return Infinity;
    const [x, y] = worldOf(pose, own[0], own[1]);
    return (x - to[0]) ** 2 + (y - to[1]) ** 2;
  };
  let best = now;
  for (const step of [stepDeg, stepDeg / 10]) {
    const reach = step === stepDeg ? reachDeg : stepDeg;
    const middle = best;
    let least = distance(middle);
    for (let by = -reach; by <= reach; by += step) {
      const found = distance(middle + by);
      if (found < least) [least, best] = [found, middle + by];
    }
  }
  return folded(best);
}
