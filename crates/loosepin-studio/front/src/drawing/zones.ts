// The zone in which play and scatter let a point be: about each place of its path, in the directions in which the server records reaches.
import type { LivePath } from '../messages.ts';
import type { Point } from '../editing/drag.ts';
import { roundBelow } from '../numbers/rounds.ts';

/** Directions of the recorded reaches, in half a turn: a zone by play reaches as far in the opposite direction. */
const directions = 16;
const corner = Array.from({ length: 2 * directions + 1 }, (_, side) => (Math.PI * side) / directions).map((angle): Point => [Math.cos(angle), Math.sin(angle)]);
/** As in the pictures of `loosepin motion`: the widest zone is about this share of the size of what fills the picture, which is the mechanism here, and the path there. */
const visibleShare = 0.08;
/** Pieces of which a drawn zone consists, at most. */
const mostPieces = 120;

/** A path with its places, mm; one for each pose. */
export interface Zoned {
  path: LivePath;
  places: Point[];
}

export const hasZone = (path: LivePath): boolean => path.play_reach_mm.length > 0 || path.scatter.length > 0;

function between(reaches: (pose: number) => number[], pose: number): number[] {
  const index = Math.floor(pose);
  const share = pose - index;
  const first = reaches(index);
  if (share === 0) return first;
  const second = reaches(index + 1);
  return first.map((reach, direction) => reach + share * ((second[direction] ?? reach) - reach));
}

/** Reach of the play alone, mm, at a pose or between two. */
export function playReach({ play_reach_mm: reaches }: LivePath, pose: number): number[] {
  return between((index) => reaches.slice(directions * index, directions * (index + 1)), pose);
}

/** Reach of play and scatter together, mm: h + √(a² cos² φ + b² sin² φ), the angle φ from the larger semi-axis. */
export function zoneReach(path: LivePath, pose: number): number[] {
  return between((index) => {
    const [major, minor, degrees] = path.scatter[index] ?? [0, 0, 0];
    const turned = (degrees * Math.PI) / 180;
    return Array.from({ length: directions }, (_, direction) => {
      const angle = (Math.PI * direction) / directions - turned;
      return (path.play_reach_mm[directions * index + direction] ?? 0) + Math.hypot(major * Math.cos(angle), minor * Math.sin(angle));
    });
  }, pose);
}

/** Larger and smaller semi-axis, mm, and the angle of the larger one, degrees, at the nearest pose; null where nothing scatters. */
export function ellipseAt(path: LivePath, pose: number): [number, number, number] | null {
  return path.scatter[Math.round(pose)] ?? null;
}

/** Corners of the least polygon with sides in these directions that holds the zone, mm from the middle, against the clock. */
export function cornersOf(reach: number[]): Point[] {
  const sine = Math.sin(Math.PI / directions);
  return Array.from({ length: 2 * directions }, (_, side): Point => {
    const [own, next] = [reach[side % directions] ?? 0, reach[(side + 1) % directions] ?? 0];
    const [[cosine, sin], [nextCosine, nextSine]] = [corner[side] ?? [1, 0], corner[side + 1] ?? [1, 0]];
    return [(own * nextSine - next * sin) / sine, (next * cosine - own * nextCosine) / sine];
  });
}

/** How many times as large as they are zones are drawn in a picture of a size, mm. */
export function magnificationOf(zones: Zoned[], sizeMm: number): number {
  let largest = 1e-9 * sizeMm;
  for (const { path, places } of zones) {
    places.forEach((_, pose) => cornersOf(zoneReach(path, pose)).forEach(([x, y]) => (largest = Math.max(largest, Math.hypot(x, y)))));
  }
  return zones.length > 0 && largest > 0 ? Math.max(roundBelow((visibleShare * sizeMm) / largest), 1) : 1;
}

/** A closed line through corners about a place, each `factor` times as far from it. */
export function about([x, y]: Point, corners: Point[], factor: number): Point[] {
  return corners.map(([dx, dy]) => [x + factor * dx, y + factor * dy]);
}

export function outline(points: Point[]): string {
  return 'M' + points.map(([x, y]) => x.toFixed(4) + ' ' + y.toFixed(4)).join('L') + 'Z';
}

/** The zone over all places: the hulls of neighbouring ones, all turned the same way round, so that they leave no hole. */
export function swept({ path, places }: Zoned, factor: number): string {
  const at = (pose: number): Point[] => about(places[pose] ?? [0, 0], cornersOf(zoneReach(path, pose)), factor);
  const step = Math.max(Math.ceil((places.length - 1) / mostPieces), 1);
  const pieces: string[] = [];
  let last = at(0);
  for (let pose = 0; pose + 1 < places.length; ) {
    pose = Math.min(pose + step, places.length - 1);
    const next = at(pose);
    pieces.push(outline(hull([...last, ...next])));
    last = next;
  }
  return pieces.join('');
}

/** The convex hull, by Andrew's chain. */
export function hull(points: Point[]): Point[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (all: Point[]): Point[] => {
    const chain: Point[] = [];
    for (const point of all) {
      for (;;) {
        const [a, b] = [chain.at(-2), chain.at(-1)];
        if (!a || !b || (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]) > 0) break;
        chain.pop();
      }
      chain.push(point);
    }
    chain.pop();
    return chain;
  };
  return [...half(sorted), ...half(sorted.reverse())];
}
