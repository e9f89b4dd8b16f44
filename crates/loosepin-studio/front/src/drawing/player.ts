// Moves a drawing through its poses. Knows nothing of the page around it.
import type { BodyMotion, Motion } from '../messages.ts';

/** Numbers that are not finite have no form in JSON. */
type Numbers = (number | null)[];

function between(list: Numbers, index: number, share: number): number {
  const first = list[index] ?? 0;
  const second = list[Math.min(index + 1, list.length - 1)] ?? first;
  return first + share * (second - first);
}

interface Pose {
  x: number;
  y: number;
  a: number;
}

/** x, y in mm and angle in degrees; the deviation by play is drawn so many times as large. */
function placed(body: BodyMotion | undefined, index: number, share: number, factor: number): Pose {
  if (!body) return { x: 0, y: 0, a: 0 };
  const at = (list: Numbers, difference: Numbers): number => between(list, index, share) + factor * between(difference, index, share);
  return { x: at(body.x, body.dx), y: at(body.y, body.dy), a: at(body.a, body.da) };
}

function transform(pose: Pose): string {
  return 'translate(' + pose.x.toFixed(4) + ' ' + pose.y.toFixed(4) + ') rotate(' + pose.a.toFixed(5) + ')';
}

/** The pose, between two of the stored ones, where the drive has this angle. */
export function poseAt(angles: Numbers, angle: number): number {
  const last = angles.length - 1;
  const sign = (angles[last] ?? 0) < (angles[0] ?? 0) ? -1 : 1;
  let [low, high] = [0, Math.max(last, 0)];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (sign * ((angles[middle] ?? 0) - angle) <= 0) low = middle;
    else high = middle;
  }
  const [start, end] = [angles[low] ?? 0, angles[high] ?? 0];
  return low + (end === start ? 0 : Math.min(Math.max((angle - start) / (end - start), 0), 1)) * (high - low);
}

/** Where all bodies are, without play: x and y in mm, angle in degrees. */
export function posesAt(motion: Motion, angle: number): [number, number, number][] {
  const pose = poseAt(motion.angle_deg, angle);
  const index = Math.floor(pose);
  return motion.bodies.map((body) => {
    const { x, y, a } = placed(body, index, pose - index, 0);
    return [x, y, a];
  });
}

/** Where a point of a body is. */
export function worldOf([x, y, degrees]: [number, number, number], ownX: number, ownY: number): [number, number] {
  const [sine, cosine] = [Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];
  return [x + cosine * ownX - sine * ownY, y + sine * ownX + cosine * ownY];
}

export class Player {
  private bodies: SVGElement[] = [];
  private ghosts: SVGElement[] = [];
  private riders: SVGElement[] = [];
  /** From (0, 0) to (1, 0) in their own frames. */
  private spans: SVGElement[] = [];

  constructor(
    private readonly svg: SVGSVGElement,
    private readonly motion: Motion,
  ) {
    this.collect();
  }

  /** Something in the drawing was put in or taken out. */
  collect(): void {
    const { svg } = this;
    this.bodies = [...svg.querySelectorAll<SVGElement>('[data-body]')];
    this.ghosts = [...svg.querySelectorAll<SVGElement>('[data-ghost]')];
    this.riders = [...svg.querySelectorAll<SVGElement>('[data-rides]')];
    this.spans = [...svg.querySelectorAll<SVGElement>('[data-from]')];
  }

  show(angle: number): void {
    const pose = poseAt(this.motion.angle_deg, angle);
    const index = Math.floor(pose);
    const share = pose - index;
    const at = (body: string | undefined, factor: number): Pose => placed(this.motion.bodies[Number(body)], index, share, factor);
    const { magnification } = this.motion;
    this.bodies.forEach((group) => group.setAttribute('transform', transform(at(group.dataset.body, magnification))));
    this.ghosts.forEach((group) => group.setAttribute('transform', transform(at(group.dataset.ghost, 0))));
    this.riders.forEach((group) => {
      const { x, y, a } = at(group.dataset.rides, magnification);
      const [worldX, worldY] = worldOf([x, y, a], Number(group.dataset.x), Number(group.dataset.y));
      group.setAttribute('transform', 'translate(' + worldX.toFixed(4) + ' ' + worldY.toFixed(4) + ')');
    });
    const end = (text: string | undefined): [number, number] => {
      const [body = '0', ownX, ownY] = (text ?? '').split(' ');
      const { x, y, a } = at(body, magnification);
      return worldOf([x, y, a], Number(ownX), Number(ownY));
    };
    this.spans.forEach((group) => {
      const [from, to] = [end(group.dataset.from), end(group.dataset.to)];
      const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
      const across = Number(group.dataset.across) / Math.max(Math.hypot(dx, dy), 1e-9);
      group.setAttribute('transform', 'matrix(' + [dx, dy, -dy * across, dx * across, from[0], from[1]].map((value) => value.toFixed(4)).join(' ') + ')');
    });
  }
}
