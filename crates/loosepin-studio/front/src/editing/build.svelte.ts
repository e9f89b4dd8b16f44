// The tools with which a mechanism is drawn and built on: what a click begins, and what the next one ends.
import type { Edit, End, Joined, Named, View, Watched } from '../messages.ts';
import type { Point } from './drag.ts';
import type { Head } from '../drawing/head.svelte.ts';
import type { Snapped } from '../drawing/snap.ts';
import { endAt, endsAt, isSamePlace, targetsOf, type Place } from '../drawing/targets.ts';
import type { EditTool, ToolOptions } from './toolset.ts';
import { words } from '../words.ts';

/** What a click takes: a place where points are, a body beside its points, or nothing. */
export type Taken = { target: Place } | { body: string; at: Point } | { at: Point; isGround: boolean };

/** What is built on. */
interface Bench {
  readonly head: Head;
  readonly view: View | null;
  /** The body that is looked at. */
  readonly part: Named | null;
  /** What the last edit brought. */
  readonly built: { name: string | null } | null;
  restructure(edit: Edit, name?: string): Promise<string | null>;
  askToRemove(what: Named): Promise<string | null>;
  choose(what: Named | null): void;
}

const ground = 'ground';

export class Build {
  tool = $state<EditTool>('move');
  /** What the first click took, where a second one is due. */
  start = $state.raw<Taken | null>(null);
  /** Where the pointer of the tool is, and what holds it there. */
  aim = $state.raw<Snapped | null>(null);
  options = $state<ToolOptions>({ join: 'pin', angle: 0, play: '', record: 'path' });
  /** Begins where the link before it ended. */
  private isChain = false;
  /** Clicks are worked off one after the other: the next one may build on what this one brings. */
  private last: Promise<void> = Promise.resolve();
  private gestures = 0;

  constructor(private readonly desk: Bench) {}

  get isOn(): boolean {
    return this.tool !== 'move';
  }

  /** Nothing moves yet: the first link begins on the ground. */
  get isEmpty(): boolean {
    return this.desk.view?.outline.bodies.length === 0;
  }

  choose(tool: EditTool): void {
    this.tool = tool;
    this.start = null;
    // Links are drawn where the mechanism starts: there the text says how its loops close.
    this.desk.head.isLocked = tool !== 'move';
    if (tool !== 'move') {
      this.desk.head.run(false);
      this.desk.head.set(this.desk.head.first);
    }
  }

  /** Ends what has begun; where nothing has, the tool is put away. */
  escape(): void {
    if (this.start) this.start = null;
    else this.choose('move');
  }

  /** What is to be done next, in words. */
  get hint(): string {
    const { tool, start } = this;
    if (!start) return tool === 'link' && this.isEmpty ? words.build.first : words.build.hints[tool];
    if (tool === 'link' && this.isChain) return words.build.chain(nameOf(start));
    return words.build.next(tool, (tool === 'plate' || tool === 'record' ? this.bodyOf(start) : null) ?? nameOf(start));
  }

  /** What a click does; it may only begin something. */
  take(taken: Taken): Promise<void> {
    const { tool } = this;
    // A click belongs to the tool with which it was made: where another one was taken meanwhile, it is dropped.
    this.last = this.last.then(() => (this.tool === tool ? this.use(taken) : undefined)).catch((error: unknown) => console.error(error));
    return this.last;
  }

  /** What stands at a typed place: the points that lie there, else the place itself. On the ground only a point of the ground will do. */
  typedAt(at: Point, isGround: boolean): Taken {
    const { view, head } = this.desk;
    const targets = view?.drawing ? targetsOf(view.outline.parts, view.drawing.motion, head.angle) : [];
    const target = targets.find((one) => isSamePlace(one.at, at) && (!isGround || one.points.some(({ body }) => body === ground)));
    return target ? { target } : { at, isGround };
  }

  /** What has begun at a body that is gone, by Undo, begins nowhere. */
  keepTo(bodies: string[]): void {
    const { start } = this;
    const own = start === null || 'isGround' in start ? [] : 'target' in start ? start.target.points.map(({ body }) => body) : [start.body];
    if (own.length > 0 && !own.some((body) => bodies.includes(body))) this.start = null;
  }

  private async use(taken: Taken): Promise<void> {
    const { start, tool } = this;
    if (tool === 'link') await this.link(start, taken);
    else if (tool === 'plate') await this.plate(start, taken);
    else if (tool === 'join') await this.join(start, taken);
    else if (tool === 'record') await this.record(start, taken);
    else if (tool === 'delete') await this.remove(taken);
    else {
      const edit = this.single(taken);
      if (edit) await this.desk.restructure(edit);
    }
  }

  private async link(start: Taken | null, taken: Taken): Promise<void> {
    if (!start) {
      this.isChain = false;
      this.start = this.isEmpty && 'isGround' in taken ? { ...taken, isGround: true } : taken;
      return;
    }
    if (isSamePlace(placeOf(start), placeOf(taken)) || isSamePoint(start, taken)) {
      // A second click on the end of the last link pins it to the ground.
      const isEnd = this.isChain && 'target' in start;
      this.start = null;
      if (isEnd) await this.desk.restructure(pinToGround(start.target));
      return;
    }
    this.start = null;
    if ((await this.desk.restructure(linkOf(start, taken))) !== null) {
      if (this.tool === 'link' && this.start === null) this.start = start;
      return;
    }
    const link = this.desk.built?.name ?? null;
    if (link === null) return;
    this.desk.choose({ table: 'body', name: link });
    // The next one begins at a free end, unless another tool was taken meanwhile.
    if (this.tool !== 'link' || !('isGround' in taken) || taken.isGround) return;
    this.isChain = true;
    this.start = { target: { points: [{ body: link, point: 'b' }], at: taken.at } };
  }

  private async plate(start: Taken | null, taken: Taken): Promise<void> {
    const body = this.bodyOf(start ?? taken);
    if (body === null) return;
    // One point after the other.
    if (!start) this.start = taken;
    else await this.desk.restructure({ kind: 'add_point', body, to: endOf(taken, body) });
  }

  private async join(start: Taken | null, taken: Taken): Promise<void> {
    if (!start) {
      // A slider or a slot may begin on the ground beside all points.
      if ('target' in taken || this.options.join !== 'pin') this.start = taken;
      return;
    }
    if (!('target' in taken)) return;
    this.start = null;
    const onGround: Taken = 'isGround' in start ? { ...start, isGround: true } : start;
    const [first, second] = pair(onGround, taken);
    await this.desk.restructure({ kind: 'join', first, second, by: this.joined });
  }

  private get joined(): Joined {
    const { join, angle, play } = this.options;
    if (join === 'pin') return { as: 'pin', play };
    return join === 'rigid' ? { as: 'rigid' } : { as: join, angle_deg: angle };
  }

  /** An output of what is clicked; of a point that is new, where a link and then a place are. */
  private async record(start: Taken | null, taken: Taken): Promise<void> {
    const gesture = `record ${(this.gestures += 1)}`;
    const isPoint = ['path', 'x', 'y'].includes(this.options.record);
    if (isPoint && (start || !('target' in taken))) {
      const body = this.bodyOf(start ?? taken);
      if (body === null || body === ground) return;
      if (!start) {
        this.start = taken;
        return;
      }
      this.start = null;
      const [x, y] = placeOf(taken);
      if ((await this.desk.restructure({ kind: 'add_point', body, to: { at: 'on', body, x, y } }, gesture)) !== null) return;
      const point = this.desk.built?.name?.slice(body.length + 1);
      if (point !== undefined) await this.watch(this.watchedPoint(body, point), gesture);
      return;
    }
    const what = this.watched(taken);
    if (what) await this.watch(what, gesture);
  }

  private async watch(what: Watched, gesture: string): Promise<void> {
    await this.desk.restructure({ kind: 'watch', what }, gesture);
  }

  private watchedPoint(body: string, point: string): Watched {
    const { record } = this.options;
    return record === 'x' || record === 'y' ? { of: 'position', body, point, along: record } : { of: 'path', body, point };
  }

  private watched(taken: Taken): Watched | null {
    const { record } = this.options;
    if (record === 'force') {
      const joint = 'target' in taken ? this.jointsAt(taken.target)[0] : undefined;
      return joint === undefined ? null : { of: 'force', joint };
    }
    if (record === 'angle' || record === 'angular_velocity') {
      const body = this.bodyOf(taken);
      return body === null ? null : { of: record, body };
    }
    const point = 'target' in taken ? taken.target.points.find(({ body }) => body !== ground) : undefined;
    return point ? this.watchedPoint(point.body, point.point) : null;
  }

  private single(taken: Taken): Edit | null {
    const { tool, options } = this;
    if (tool === 'slider') {
      if ('target' in taken) return { kind: 'add_block', on: endAt(taken.target, ground), angle_deg: options.angle };
      return 'body' in taken ? { kind: 'add_block', on: onBody(taken), angle_deg: options.angle } : null;
    }
    if (tool === 'ground') return 'target' in taken ? pinToGround(taken.target) : null;
    if (tool === 'motor' && 'target' in taken) {
      const joint = this.jointsAt(taken.target)[0];
      return joint === undefined ? null : { kind: 'drive', joint };
    }
    return null;
  }

  /** The link that is meant: at a pin of two links the one that is looked at, else none. */
  private bodyOf(taken: Taken): string | null {
    if ('body' in taken) return taken.body;
    const moving = 'target' in taken ? taken.target.points.filter(({ body }) => body !== ground) : [];
    const meant = moving.length === 1 ? moving[0] : moving.find(({ body }) => body === this.desk.part?.name);
    return meant?.body ?? null;
  }

  private jointsAt(target: Place): string[] {
    const names = target.points.map(({ body, point }) => `${body}.${point}`);
    return (this.desk.view?.outline.joints ?? []).filter(({ points }) => points.every((point) => names.includes(point))).map(({ name }) => name);
  }

  private async remove(taken: Taken): Promise<void> {
    if ('target' in taken) {
      const [joint] = this.jointsAt(taken.target);
      const [point] = taken.target.points;
      if (joint !== undefined) await this.desk.askToRemove({ table: 'joint', name: joint });
      else if (point) await this.desk.askToRemove({ table: 'body', name: point.body, point: point.point });
    } else if ('body' in taken) await this.desk.askToRemove({ table: 'body', name: taken.body });
  }
}

export function nameOf(taken: Taken): string {
  if ('target' in taken) return taken.target.points.map(({ body, point }) => `${body}.${point}`).join(' = ');
  return 'body' in taken ? taken.body : words.build.at(taken.at);
}

/** Whether both are at the same point of a body. */
function isSamePoint(one: Taken, other: Taken): boolean {
  if (!('target' in one) || !('target' in other)) return false;
  return one.target.points.some(({ body, point }) => other.target.points.some((own) => own.body === body && own.point === point));
}

export const placeOf = (taken: Taken): Point => ('target' in taken ? taken.target.at : taken.at);

function onBody({ body, at: [x, y] }: { body: string; at: Point }): End {
  return { at: 'on', body, x, y };
}

function endOf(taken: Taken, not: string | null = null): End {
  if ('target' in taken) return endAt(taken.target, not);
  if ('body' in taken) return onBody(taken);
  const [x, y] = taken.at;
  return taken.isGround ? { at: 'on', body: ground, x, y } : { at: 'free', x, y };
}

/** Ends of two different bodies, where the places have such. */
function pair(first: Taken, second: Taken): [End, End] {
  if ('target' in first && 'target' in second) return endsAt(first.target, second.target);
  const bodyAt = (taken: Taken): string | null => ('body' in taken ? taken.body : 'isGround' in taken && taken.isGround ? ground : null);
  return [endOf(first, bodyAt(second)), endOf(second, bodyAt(first))];
}

function linkOf(first: Taken, second: Taken): Edit {
  const [from, to] = pair(first, second);
  return { kind: 'add_link', from, to };
}

function pinToGround(target: Place): Edit {
  const [x, y] = target.at;
  const onGround = target.points.find(({ body }) => body === ground);
  const first: End = onGround ? { at: 'point', ...onGround } : { at: 'on', body: ground, x, y };
  return { kind: 'join', first, second: endAt(target, ground), by: { as: 'pin' } };
}
