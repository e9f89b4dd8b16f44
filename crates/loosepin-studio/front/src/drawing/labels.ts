// Names on the canvas: of one size whatever the zoom, each where it hides neither links nor pins nor another name.
import type { BodyView, Motion } from '../messages.ts';
import { element } from './element.ts';
import { posesAt, worldOf } from './player.ts';
import type { Viewport } from './viewport.svelte.ts';

export type LabelKind = 'output' | 'of-drive' | 'play-of';

export interface Label {
  kind: LabelKind;
  text: string;
  title: string;
  /** The body that carries its point, and the point in its frame, mm. */
  body: number;
  own: [number, number];
}

/** A rectangle, px. */
interface Area {
  left: number;
  top: number;
  right: number;
  bottom: number;
}
type Px = [number, number];

export const labelPx = 12.5;
/** Mean width of a letter, and height of a line, as shares of the size. */
const letter = [0.6, 1.2] as const;
const barPx = 4;
const clearPx = 2;
/** Distances from the point at which a name is tried, px beyond the sign at the point. */
const reachesPx = [3, 12, 24, 40, 60, 84];
/** Directions in which it is tried, the best first, degrees. */
const directionsDeg = [45, 135, 0, 180, 90, -45, -135, -90, 22, 158, -22, -158, 67, 113, -67, -113];
/** From this place on, a line leads to the name. */
const farFrom = 2 * directionsDeg.length;
/** Poses at which places are compared while the mechanism runs. */
const posesWhileRunning = 24;
/** Costs of what a name hides. */
const costs = { bar: 4, pin: 6, name: 40, edge: 25, far: 0.02 };

/** The names that the picture of the server has; they are taken out of it. */
export function takeLabels(svg: SVGSVGElement): Label[] {
  const signs = svg.querySelector('.signs');
  const found = [...(signs?.querySelectorAll<SVGElement>('g[data-rides]') ?? [])].flatMap((group): Label[] => {
    const named = group.querySelector<SVGElement>('.output, .of-drive, .play-of');
    const kind = (['output', 'of-drive', 'play-of'] as const).find((one) => named?.classList.contains(one));
    const text = group.querySelector('text')?.textContent ?? '';
    const own: [number, number] = [Number(group.dataset.x), Number(group.dataset.y)];
    return kind && text ? [{ kind, text, title: group.querySelector('title')?.textContent ?? text, body: Number(group.dataset.rides), own }] : [];
  });
  signs?.remove();
  return found;
}

/** A shape that is drawn of a body: its corners in the frame of the body, mm. A name inside one with an area hides it, too. */
export interface Shape {
  body: number;
  corners: [number, number][];
}

/** The bars, plates and blocks of the picture. */
export function shapesOf(svg: SVGSVGElement): Shape[] {
  return [...svg.querySelectorAll<SVGElement>('.body[data-body] :is(.bar, .plate, rect.block)')].map((drawn) => ({
    body: Number(drawn.closest<SVGElement>('.body')?.dataset.body),
    corners: drawn.matches('rect') ? cornersOf(drawn) : pointsOf(drawn.getAttribute('d') ?? ''),
  }));
}

/** Of a path of straight lines. */
function pointsOf(d: string): [number, number][] {
  return [...d.matchAll(/[ML]\s*(\S+)\s+(\S+)/g)].map(([, x, y]) => [Number(x), Number(y)]);
}

/** Of a rectangle that may be turned about a point. */
function cornersOf(rect: SVGElement): [number, number][] {
  const [x = 0, y = 0, width = 0, height = 0] = ['x', 'y', 'width', 'height'].map((name) => Number(rect.getAttribute(name)));
  const [degrees = 0, aboutX = 0, aboutY = 0] = (/rotate\(([^)]*)\)/.exec(rect.getAttribute('transform') ?? '')?.[1] ?? '').split(/\s+/).map(Number);
  const corners = [[x, y], [x + width, y], [x + width, y + height], [x, y + height]] as [number, number][];
  return corners.map(([ownX, ownY]) => worldOf([aboutX, aboutY, degrees], ownX - aboutX, ownY - aboutY));
}

/** Radius of a drawn pin, mm: signs at points are multiples of it. */
export function pinMm(svg: SVGSVGElement): number {
  return Number(svg.querySelector('circle.pin, circle.journal')?.getAttribute('r') ?? 0) || 1;
}

function meets(a: Area, b: Area): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/** Whether any of a line lies in a rectangle (Liang and Barsky's clipping). */
function crosses({ left, right, top, bottom }: Area, a: Px, b: Px): boolean {
  let [from, to] = [0, 1];
  for (const [change, near, far] of [
    [b[0] - a[0], left - a[0], right - a[0]],
    [b[1] - a[1], top - a[1], bottom - a[1]],
  ] as const) {
    if (change === 0) {
      if (near > 0 || far < 0) return false;
    } else {
      from = Math.max(from, Math.min(near / change, far / change));
      to = Math.min(to, Math.max(near / change, far / change));
    }
  }
  return from < to;
}

interface Scene {
  bars: [Px, Px][];
  /** Filled outlines of plates: a name inside hides them as well. */
  plates: Px[][];
  pins: { at: Px; radius: number }[];
}

/** Whether a point lies in a convex outline, whichever way that goes round. */
function inside(point: Px, corners: Px[]): boolean {
  const sides = corners.map((a, index) => {
    const b = corners[(index + 1) % corners.length] as Px;
    return (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
  });
  return sides.every((side) => side >= 0) || sides.every((side) => side <= 0);
}

/** What names may hide. */
export interface Surroundings {
  parts: BodyView[];
  shapes: Shape[];
  motion: Motion;
  /** Radius of a pin, mm. */
  pinMm: number;
}

function sceneAt(view: Viewport, { parts, shapes, motion }: Surroundings, angle: number, pinPx: number): Scene {
  const poses = posesAt(motion, angle);
  const scene: Scene = { bars: [], plates: [], pins: [] };
  parts.forEach((part, index) => {
    const pose = poses[index];
    if (!pose) return;
    const points = part.points.map(({ x, y }) => view.pixels(worldOf(pose, x, y)));
    // Supports and blocks reach farther than a pin.
    points.forEach((at) => scene.pins.push({ at, radius: (index === 0 ? 3.6 : 1.6) * pinPx }));
  });
  for (const { body, corners } of shapes) {
    const pose = poses[body];
    if (!pose) continue;
    const outline = corners.map(([x, y]) => view.pixels(worldOf(pose, x, y)));
    outline.forEach((corner, place) => {
      const next = outline[(place + 1) % outline.length];
      if (next && (outline.length > 2 || place === 0)) scene.bars.push([corner, next]);
    });
    if (outline.length > 2) scene.plates.push(outline);
  }
  return scene;
}

function areaOf(label: Label, at: Px, direction: number, reach: number): Area {
  const [width, height] = [letter[0] * labelPx * label.text.length, letter[1] * labelPx];
  const [dx, dy] = [Math.cos(direction), -Math.sin(direction)];
  // The nearest corner or side of the text is `reach` away.
  const middle: Px = [at[0] + dx * (reach + width / 2) + (Math.abs(dx) < 0.5 ? 0 : (Math.sign(dx) - dx) * width * 0.5), at[1] + dy * (reach + height / 2)];
  return { left: middle[0] - width / 2, right: middle[0] + width / 2, top: middle[1] - height / 2, bottom: middle[1] + height / 2 };
}

const grown = ({ left, top, right, bottom }: Area, by: number): Area => ({ left: left - by, top: top - by, right: right + by, bottom: bottom + by });

/** What a name at a place hides. */
function hidden(area: Area, scene: Scene, view: Viewport): number {
  const near = grown(area, barPx / 2 + clearPx);
  const corners: Px[] = [[area.left, area.top], [area.right, area.top], [area.right, area.bottom], [area.left, area.bottom]];
  let cost = 0;
  for (const [a, b] of scene.bars) if (crosses(near, a, b)) cost += costs.bar;
  for (const plate of scene.plates) if (corners.some((corner) => inside(corner, plate))) cost += costs.bar;
  for (const { at, radius } of scene.pins) {
    const square = { left: at[0] - radius, right: at[0] + radius, top: at[1] - radius, bottom: at[1] + radius };
    if (meets(area, square)) cost += costs.pin;
  }
  if (area.left < 2 || area.top < 2 || area.right > view.width - 2 || area.bottom > view.height - 2) cost += costs.edge;
  return cost;
}

/** A name stays where it stands unless it hides so much there. */
const staying = 0.9;

/** Where a name stands, from its point, px; y points down. */
export interface Placed {
  label: Label;
  middle: Px;
  /** Which of the places around its point it has. */
  place: number;
  /** The end of the line from the point to the name, where it stands away. */
  line: Px | null;
}

/** Places for all names: where they hide the least, at one angle or over the whole motion. */
export function placeLabels(labels: Label[], view: Viewport, surroundings: Surroundings, angle: number, isRunning: boolean, before: ReadonlyMap<string, Placed>): Placed[] {
  const { motion } = surroundings;
  const pinPx = surroundings.pinMm * view.scale;
  const span = motion.angle_deg.length - 1;
  const angles = isRunning ? Array.from({ length: posesWhileRunning }, (_, index) => motion.angle_deg[Math.round((index * span) / posesWhileRunning)] ?? 0) : [angle];
  const scenes = angles.map((at) => ({ scene: sceneAt(view, surroundings, at, pinPx), poses: posesAt(motion, at) }));
  const taken: Area[][] = scenes.map(() => []);
  // Outputs first: they are what one looks for.
  const order = [...labels].sort((a, b) => Number(b.kind === 'output') - Number(a.kind === 'output'));
  return order.flatMap((label): Placed[] => {
    const own = { output: 2, 'of-drive': 6.2, 'play-of': 3.2 }[label.kind] * pinPx;
    const known = before.get(label.kind + label.title)?.place;
    let best: { cost: number; offset: Px; areas: Area[]; place: number } | null = null;
    for (const [rank, reach] of reachesPx.entries()) {
      for (const [turn, degrees] of directionsDeg.entries()) {
        const place = rank * directionsDeg.length + turn;
        let cost = costs.far * place - (place === known ? staying : 0);
        let offset: Px = [0, 0];
        const areas: Area[] = [];
        for (const [index, { scene, poses }] of scenes.entries()) {
          const pose = poses[label.body];
          if (!pose) continue;
          const at = view.pixels(worldOf(pose, label.own[0], label.own[1]));
          const area = areaOf(label, at, (degrees * Math.PI) / 180, own + reach);
          areas.push(area);
          offset = [(area.left + area.right) / 2 - at[0], (area.top + area.bottom) / 2 - at[1]];
          cost += hidden(area, scene, view) / scenes.length;
          for (const other of taken[index] ?? []) if (meets(grown(area, clearPx), other)) cost += costs.name / scenes.length;
          if (best && cost >= best.cost) break;
        }
        if (!best || cost < best.cost) best = { cost, offset, areas, place };
      }
    }
    if (!best) return [];
    best.areas.forEach((area, index) => taken[index]?.push(area));
    return [{ label, middle: best.offset, line: best.place >= farFrom ? best.offset : null, place: best.place }];
  });
}

/** Draws them; the player carries them with their bodies. All lengths are pixels at this scale. */
export function drawLabels(layer: SVGElement, placed: Placed[], scale: number): void {
  const mm = (px: number): string => (px / scale).toFixed(4);
  // The style of drawings takes the size of letters from their group.
  layer.style.fontSize = mm(labelPx) + 'px';
  layer.replaceChildren(
    ...placed.map(({ label, middle, line }) => {
      const rider = element('g', { 'data-rides': String(label.body), 'data-x': String(label.own[0]), 'data-y': String(label.own[1]), class: label.kind });
      const upright = element('g', { transform: 'scale(1 -1)' });
      if (line) {
        // It ends before the letters.
        const far = Math.hypot(line[0], line[1]);
        const share = Math.max(far - 0.5 * labelPx - Math.abs(line[0] / far) * 0.5 * letter[0] * labelPx * label.text.length, 0) / far;
        upright.append(element('path', { d: `M0 0L${mm(line[0] * share)} ${mm(line[1] * share)}`, class: 'leader' }));
      }
      if (label.kind === 'output') upright.append(element('circle', { r: mm(4), class: 'mark' }));
      const text = element('text', { x: mm(middle[0]), y: mm(middle[1]), 'text-anchor': 'middle', 'dominant-baseline': 'central' });
      text.textContent = label.text;
      const title = element('title', {});
      title.textContent = label.title;
      upright.append(title, text);
      rider.append(upright);
      return rider;
    }),
  );
}
