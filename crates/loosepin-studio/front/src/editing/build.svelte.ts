// The tools with which a mechanism that is there already is built on: what a click begins, and what the next one ends.
import type { Edit, End, Joined, Named, View } from '../messages.ts';
import type { Point } from './drag.ts';
import type { Head } from '../drawing/head.svelte.ts';
import { endAt, endsAt, type Target } from '../drawing/targets.ts';
import type { EditTool } from './toolset.ts';
import { words } from '../words.ts';

/** What a click takes: a place where points are, a body beside its points, or nothing. */
export type Taken = { target: Target } | { body: string; at: Point } | { at: Point; isGround: boolean };

/** What is built on. */
interface Bench {
  readonly head: Head;
  readonly view: View | null;
  restructure(edit: Edit): Promise<string | null>;
  askToRemove(what: Named): Promise<string | null>;
}

export class Build {
  tool = $state<EditTool>('move');
  /** What the first click took, where a second one is due. */
  start = $state.raw<Taken | null>(null);

  constructor(private readonly desk: Bench) {}

  get isOn(): boolean {
    return this.tool !== 'move';
  }

  choose(tool: EditTool): void {
    this.tool = tool;
    this.start = null;
    // Links are drawn where the mechanism starts: there the text says how its loops close.
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
    if (start) return words.build.next(tool, (tool === 'plate' ? bodyOf(start) : null) ?? nameOf(start));
    return words.build.hints[tool];
  }

  /** What a click does; null where it only begins. */
  take(taken: Taken): void {
    const { start, tool } = this;
    if (tool === 'link' || tool === 'join' || tool === 'plate') {
      if (!start) {
        if (tool === 'plate' && bodyOf(taken) === null) return;
        if (tool === 'join' && !('target' in taken)) return;
        this.start = taken;
        return;
      }
      const edit = tool === 'link' ? link(start, taken) : tool === 'join' ? join(start, taken, { as: 'pin' }) : plate(start, taken);
      // A plate takes one point after the other.
      if (tool !== 'plate') this.start = null;
      if (edit) void this.desk.restructure(edit);
    } else if (tool === 'delete') this.remove(taken);
    else {
      const edit = this.single(taken);
      if (edit) void this.desk.restructure(edit);
    }
  }

  private single(taken: Taken): Edit | null {
    const { tool } = this;
    if (tool === 'slider') {
      if ('target' in taken) return { kind: 'add_block', on: endAt(taken.target, 'ground'), angle_deg: 0 };
      return 'body' in taken ? { kind: 'add_block', on: onBody(taken), angle_deg: 0 } : null;
    }
    if (tool === 'ground') {
      if (!('target' in taken)) return null;
      const [x, y] = taken.target.at;
      const second = endAt(taken.target, 'ground');
      const onGround = taken.target.points.find(({ body }) => body === 'ground');
      const first: End = onGround ? { at: 'point', ...onGround } : { at: 'on', body: 'ground', x, y };
      return { kind: 'join', first, second, by: { as: 'pin' } };
    }
    if (tool === 'motor' && 'target' in taken) {
      const joint = this.jointsAt(taken.target)[0];
      return joint === undefined ? null : { kind: 'drive', joint };
    }
    return null;
  }

  private jointsAt(target: Target): string[] {
    const names = target.points.map(({ body, point }) => `${body}.${point}`);
    return (this.desk.view?.outline.joints ?? []).filter(({ points }) => points.every((point) => names.includes(point))).map(({ name }) => name);
  }

  private remove(taken: Taken): void {
    if ('target' in taken) {
      const [joint] = this.jointsAt(taken.target);
      const [point] = taken.target.points;
      if (joint !== undefined) void this.desk.askToRemove({ table: 'joint', name: joint });
      else if (point) void this.desk.askToRemove({ table: 'body', name: point.body, point: point.point });
    } else if ('body' in taken) void this.desk.askToRemove({ table: 'body', name: taken.body });
  }
}

export function nameOf(taken: Taken): string {
  if ('target' in taken) return taken.target.points.map(({ body, point }) => `${body}.${point}`).join(' = ');
  return 'body' in taken ? taken.body : words.draw.at(round(taken.at[0]), round(taken.at[1]));
}

function round(value: number): number {
  return Math.round(value * 1000) / 1000;
}

/** The link that is meant: at a pin of two links none is. */
function bodyOf(taken: Taken): string | null {
  if ('body' in taken) return taken.body;
  const moving = 'target' in taken ? taken.target.points.filter(({ body }) => body !== 'ground') : [];
  return moving.length === 1 ? (moving[0]?.body ?? null) : null;
}

function onBody({ body, at: [x, y] }: { body: string; at: Point }): End {
  return { at: 'on', body, x, y };
}

function endOf(taken: Taken, not: string | null = null): End {
  if ('target' in taken) return endAt(taken.target, not);
  if ('body' in taken) return onBody(taken);
  const [x, y] = taken.at;
  return taken.isGround ? { at: 'on', body: 'ground', x, y } : { at: 'free', x, y };
}

/** Ends of two different bodies, where the places have such. */
function pair(first: Taken, second: Taken): [End, End] {
  if ('target' in first && 'target' in second) return endsAt(first.target, second.target);
  const bodyAt = (taken: Taken): string | null => ('body' in taken ? taken.body : 'isGround' in taken && taken.isGround ? 'ground' : null);
  return [endOf(first, bodyAt(second)), endOf(second, bodyAt(first))];
}

function link(first: Taken, second: Taken): Edit {
  const [from, to] = pair(first, second);
  return { kind: 'add_link', from, to };
}

function join(first: Taken, second: Taken, by: Joined): Edit | null {
  if (!('target' in second)) return null;
  const [one, other] = pair(first, second);
  return { kind: 'join', first: one, second: other, by };
}

function plate(first: Taken, second: Taken): Edit | null {
  const body = bodyOf(first);
  return body === null ? null : { kind: 'add_point', body, to: endOf(second, body) };
}
