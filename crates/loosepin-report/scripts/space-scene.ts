// The picture of a mechanism in space: what is drawn is projected, sorted by depth and drawn as in src/spatial/placed.rs and drawing.rs. Pages turn it
// by space.ts, the studio by its own canvas.

type SpacePoint = [number, number, number];
type SpaceFlat = [number, number];
/** x, y, z, mm, and w, x, y, z of the quaternion. */
type SpacePose = [number, number, number, number, number, number, number];

interface SpacePart {
  kind: 'line' | 'face' | 'solid' | 'hull' | 'ball';
  class: string;
  body: number;
  points: SpacePoint[];
  radius?: number;
  lift: number;
}

interface SpaceName {
  text: string;
  body: number;
  at: SpacePoint;
  side: SpaceFlat;
  anchor: string;
  play: boolean;
}

/** What comes with the picture: `SpaceData` of src/spatial/figure.rs. */
interface SpaceData {
  inputs: number[];
  is_angle: boolean;
  is_turn: boolean;
  start: number;
  azimuth: number;
  elevation: number;
  centre: SpacePoint;
  radius: number;
  outer: SpacePoint[];
  half: SpaceFlat;
  font: number;
  triad: SpaceFlat;
  parts: SpacePart[];
  names: SpaceName[];
  poses: SpacePose[][];
}

interface SpaceScene {
  /** Draws the mechanism at a place between two positions, seen from a side, degrees. */
  draw(pose: number, azimuth: number, elevation: number): void;
  /** The input at a place between two positions. */
  inputAt(pose: number): number;
  /** The place at which the input is this one, or its end. */
  poseAt(input: number): number;
}

interface Window {
  spaceScene(svg: SVGSVGElement, data: SpaceData): SpaceScene;
}

window.spaceScene = (() => {
  const levels = 8;
  const depthShare = 0.75;
  const sameDepth = 1e-4;
  const rimPoints = 20;
  const axisLetters = 2.6;
  const radPerDeg = Math.PI / 180;

  /** Directions right, up and toward the reader. */
  function viewAxes(azimuthDeg: number, elevationDeg: number): [SpacePoint, SpacePoint, SpacePoint] {
    const [sine, cosine] = [Math.sin(azimuthDeg * radPerDeg), Math.cos(azimuthDeg * radPerDeg)];
    const [rise, level] = [Math.sin(elevationDeg * radPerDeg), Math.cos(elevationDeg * radPerDeg)];
    return [[cosine, sine, 0], [-sine * rise, cosine * rise, level], [sine * level, -cosine * level, rise]];
  }

  function dot(a: SpacePoint, b: SpacePoint): number {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  /** A point of a body in the ground: s + 2 v × (v × s + w s) + r. */
  function inGround(pose: SpacePose | undefined, [a, b, c]: SpacePoint): SpacePoint {
    if (!pose) return [a, b, c];
    const [x, y, z, w, p, q, r] = pose;
    const [i, j, k] = [q * c - r * b + w * a, r * a - p * c + w * b, p * b - q * a + w * c];
    return [a + 2 * (q * k - r * j) + x, b + 2 * (r * i - p * k) + y, c + 2 * (p * j - q * i) + z];
  }

  /** Between two poses: the shorter way round. */
  function betweenPoses(first: SpacePose, second: SpacePose, share: number): SpacePose {
    const sign = first[3] * second[3] + first[4] * second[4] + first[5] * second[5] + first[6] * second[6] < 0 ? -1 : 1;
    const mixed = first.map((own, k) => own + share * ((k < 3 ? 1 : sign) * (second[k] ?? 0) - own)) as SpacePose;
    const size = Math.hypot(mixed[3], mixed[4], mixed[5], mixed[6]);
    return mixed.map((own, k) => k < 3 ? own : own / size) as SpacePose;
  }

  /** Corners of the convex hull (Andrew's monotone chain). */
  function hull(points: SpaceFlat[]): SpaceFlat[] {
    const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    if (sorted.length < 3) return sorted;
    const half = (ordered: SpaceFlat[]): SpaceFlat[] => {
      const chain: SpaceFlat[] = [];
      for (const point of ordered) {
        for (;;) {
          const [before, last] = [chain[chain.length - 2], chain[chain.length - 1]];
          if (!before || !last) break;
          const turn = (last[0] - before[0]) * (point[1] - before[1]) - (last[1] - before[1]) * (point[0] - before[0]);
          if (turn > 0) break;
          chain.pop();
        }
        chain.push(point);
      }
      chain.pop();
      return chain;
    };
    return [...half(sorted), ...half([...sorted].reverse())];
  }

  function partOf(svg: SVGSVGElement, selector: string): SVGElement {
    const found = svg.querySelector<SVGElement>(selector);
    if (!found) throw new Error('the picture is not whole');
    return found;
  }

  function node(name: string, attributes: Record<string, string>): SVGElement {
    const made = document.createElementNS('http://www.w3.org/2000/svg', name);
    Object.entries(attributes).forEach(([attribute, value]) => made.setAttribute(attribute, value));
    return made;
  }

  return (svg: SVGSVGElement, data: SpaceData): SpaceScene => {
    const [scene, triad] = [partOf(svg, '.scene'), partOf(svg, '.triad')];
    const names = [...svg.querySelectorAll<SVGElement>('.names text')];
    const bar = svg.querySelector<SVGElement>('.scale path');
    const barText = svg.querySelector<SVGElement>('.scale text');
    const { inputs } = data;
    const count = inputs.length;
    const places = Math.max(0, Math.min(12, 5 - Math.floor(Math.log10(data.radius))));
    const first = viewAxes(data.azimuth, data.elevation);
    const [middleX, middleY] = [dot(first[0], data.centre), -dot(first[1], data.centre)];
    const barPath = bar?.getAttribute('d') ?? '';
    const barLength = Number(/M[^M]*M[^M]*h([\d.]+)/.exec(barPath)?.[1] ?? 0);
    const barTextAt = Number(barText?.getAttribute('x') ?? 0);

    /** Poses of the bodies at a place between two positions. */
    function posesAt(pose: number): SpacePose[] {
      const index = Math.min(Math.floor(pose), count - 1);
      const [before, after] = [data.poses[index] ?? [], data.poses[Math.min(index + 1, count - 1)] ?? []];
      const share = pose - index;
      return share === 0 ? before : before.map((own, body) => betweenPoses(own, after[body] ?? own, share));
    }

    function draw(pose: number, azimuth: number, elevation: number): void {
      const poses = posesAt(pose);
      const axes = viewAxes(azimuth, elevation);
      const centre = axes.map((axis) => dot(axis, data.centre));
      const [centreX = 0, centreY = 0, centreDepth = 0] = centre;
      // A steep view may be higher than the picture: it is made smaller.
      const room = data.outer.reduce((least, point) => Math.min(least,
        data.half[0] / Math.max(Math.abs(dot(axes[0], point) - centreX), 1e-9),
        data.half[1] / Math.max(Math.abs(dot(axes[1], point) - centreY), 1e-9)), 1);
      const seen = (point: SpacePoint): SpacePoint => [
        middleX + room * (dot(axes[0], point) - centreX), middleY - room * (dot(axes[1], point) - centreY), dot(axes[2], point)];
      const text = (value: number): string => value.toFixed(places);
      const path = (points: SpaceFlat[], isClosed: boolean): string =>
        points.map(([x, y], k) => (k ? 'L' : 'M') + text(x) + ' ' + text(y)).join('') + (isClosed ? 'Z' : '');
      const mean = (points: SpacePoint[]): number => points.reduce((sum, point) => sum + point[2], 0) / Math.max(points.length, 1);
      const step = (depth: number): number => Math.floor(depth / (sameDepth * data.radius) + 0.5);
      const placed = data.parts.map((part) => {
        const points = part.points.map((point) => seen(inGround(poses[part.body], point)));
        return { part, points, depth: mean(points) + part.lift };
      }).sort((a, b) => step(a.depth) - step(b.depth));
      scene.replaceChildren(...placed.flatMap(({ part, points, depth }) => {
        const own = (depth - centreDepth) / (depthShare * data.radius);
        const level = Math.min(levels - 1, Math.max(0, Math.floor(0.5 * (own + 1) * levels)));
        const named = part.class + ' d' + level;
        const flat = points.map(([x, y]): SpaceFlat => [x, y]);
        const drawn = (style: string, d: string): SVGElement => node('path', { class: style, d });
        if (part.kind === 'line') {
          const line = path(flat, false);
          const role = part.class.split(' ')[0] ?? '';
          const edge = ['axis', 'hatch', 'trace'].includes(role) ? [] : [drawn(role === 'bar' ? 'halo wide' : 'halo', line)];
          return [...edge, drawn(named, line)];
        }
        if (part.kind === 'face') return [drawn(named, path(flat, true))];
        if (part.kind === 'hull') return [drawn(named, path(hull(flat), true))];
        if (part.kind === 'solid') {
          const isSecond = mean(points.slice(rimPoints)) > mean(points.slice(0, rimPoints));
          const rim = isSecond ? flat.slice(rimPoints) : flat.slice(0, rimPoints);
          return [drawn(named, path(hull(flat), true)), drawn(named + ' end', path(rim, true))];
        }
        return flat.map(([x, y]) => node('circle', { class: named, cx: text(x), cy: text(y), r: text(room * (part.radius ?? 0)) }));
      }));
      data.names.forEach((name, k) => {
        const [x, y] = seen(inGround(poses[name.body], name.at));
        names[k]?.setAttribute('x', (x + name.side[0] * data.font).toFixed(places + 1));
        names[k]?.setAttribute('y', (y + name.side[1] * data.font).toFixed(places + 1));
      });
      drawTriad(axes);
      bar?.setAttribute('d', barPath.replace(/h[\d.]+/, 'h' + (room * barLength).toFixed(places + 1)));
      barText?.setAttribute('x', (barTextAt + (room - 1) * barLength).toFixed(places + 1));
    }

    function drawTriad(axes: [SpacePoint, SpacePoint, SpacePoint]): void {
      const [x, y] = [middleX + data.triad[0], middleY + data.triad[1]];
      const length = axisLetters * data.font;
      const letters = ['x', 'y', 'z'].map((letter, k) => ({ letter, right: axes[0][k] ?? 0, down: -(axes[1][k] ?? 0), depth: axes[2][k] ?? 0 }));
      const at = (value: number): string => value.toFixed(places + 1);
      const arrows = letters.sort((a, b) => a.depth - b.depth).filter(({ right, down }) => Math.hypot(right, down) > 0.1);
      triad.replaceChildren(...arrows.flatMap(({ letter, right, down }) => {
        const arrow = node('path', { class: letter, d: 'M' + at(x) + ' ' + at(y) + 'L' + at(x + length * right) + ' ' + at(y + length * down) });
        const beside = node('text', {
          'text-anchor': 'middle', x: at(x + 1.32 * length * right), y: at(y + 1.32 * length * down + 0.35 * data.font) });
        beside.textContent = letter;
        return [arrow, beside];
      }));
    }

    function inputAt(pose: number): number {
      const index = Math.min(Math.floor(pose), count - 1);
      const [before = 0, after = before] = [inputs[index], inputs[Math.min(index + 1, count - 1)]];
      return before + (pose - index) * (after - before);
    }

    function poseAt(input: number): number {
      const sign = (inputs[count - 1] ?? 0) < (inputs[0] ?? 0) ? -1 : 1;
      const above = inputs.findIndex((own) => sign * (own - input) >= 0);
      if (above <= 0) return above < 0 ? count - 1 : 0;
      const [low = 0, high = 1] = [inputs[above - 1], inputs[above]];
      return above - 1 + (high === low ? 0 : (input - low) / (high - low));
    }

    return { draw, inputAt, poseAt };
  };
})();
