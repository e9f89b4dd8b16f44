// Something that is dragged: the texts from which it began, where it is to be, and what the server makes of both.
import { applied, type Change } from './history.ts';
import type { Document, Edit, Grip, Held, DragResult, SentText } from '../messages.ts';

export type Point = [number, number];

export class Drag {
  private to: Point;
  private isFree = false;
  /** It was let go: the answer to its last place ends it. */
  isEnding = false;
  /** What is done when it has ended, as a part of it. */
  then: Edit | null = null;

  constructor(
    private readonly held: Held,
    readonly base: { model: SentText; study: SentText | null },
    private readonly poses: Grip['poses'],
    start: Point,
    private readonly stepMm: number,
    /** Of the one entry that it makes in the list of what can be undone. */
    readonly name: string,
  ) {
    this.to = start;
  }

  move(to: Point, isFree: boolean): void {
    this.to = to;
    this.isFree = isFree;
  }

  get grip(): Grip {
    return { held: this.held, to_mm: this.to, step_mm: this.stepMm, is_free: this.isFree, poses: this.poses };
  }

  /** What a text of the drag becomes. */
  textOf(which: Document, reshaped: DragResult): string | null {
    const text = this.base[which]?.text;
    if (text === undefined) return null;
    // From the end, so that the places before stay; what is put in at one place keeps its order.
    const changes = reshaped.changes.filter((change) => change.document === which).reverse();
    return changes.reduce((changed, change) => applied(changed, change), text);
  }
}

/** The stretch in which two texts differ, as the change from one to the other; null where they are the same. */
function difference(before: string, after: string): Change | null {
  if (before === after) return null;
  const shorter = Math.min(before.length, after.length);
  let from = 0;
  while (from < shorter && before[from] === after[from]) from += 1;
  let behind = 0;
  while (behind < shorter - from && before[before.length - 1 - behind] === after[after.length - 1 - behind]) behind += 1;
  return { from, to: before.length - behind, insert: after.slice(from, after.length - behind) };
}

/**
 * The changes from one text to another, from the end to the beginning: one for each line where both have as many lines, so that what stands
 * between two changed numbers stays what it is.
 */
export function differences(before: string, after: string): Change[] {
  const [old, now] = [before.split('\n'), after.split('\n')];
  if (old.length !== now.length) return [difference(before, after)].filter((change) => change !== null);
  let start = 0;
  const changes: Change[] = [];
  old.forEach((line, index) => {
    const change = difference(line, now[index] ?? '');
    if (change) changes.unshift({ ...change, from: change.from + start, to: change.to + start });
    start += line.length + 1;
  });
  return changes;
}
