// One stack of undo entries over both texts. An entry is a gesture: a drag, a field, half a second of typing.
import type { Range } from './place.ts';
import type { Document } from '../messages.ts';

export interface Change extends Range {
  insert: string;
}

export interface Step {
  document: Document;
  change: Change;
  removed: string;
}

export interface Gesture {
  name: string;
  /** With the entry before it, if that has the same name: always (one drag), soon (typing), or never. */
  joins: 'always' | 'soon' | 'never';
}

interface Entry {
  name: string;
  at: number;
  steps: Step[];
}

const soonMs = 500;
const mostEntries = 500;

export function applied(text: string, change: Change): string {
  return text.slice(0, change.from) + change.insert + text.slice(change.to);
}

function inverse(step: Step): Step {
  const { from, insert } = step.change;
  return { document: step.document, change: { from, to: from + insert.length, insert: step.removed }, removed: insert };
}

/** Two steps as one, where the second only rewrites or goes on with what the first wrote. */
function merged(first: Step, second: Step): Step | null {
  const end = first.change.from + first.change.insert.length;
  if (first.document !== second.document) return null;
  if (second.change.from < first.change.from || second.change.to > end) return null;
  const start = second.change.from - first.change.from;
  const insert =
    first.change.insert.slice(0, start) + second.change.insert + first.change.insert.slice(second.change.to - first.change.from);
  return { document: first.document, change: { ...first.change, insert }, removed: first.removed };
}

export class History {
  private past: Entry[] = [];
  private future: Entry[] = [];

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  record(step: Step, gesture: Gesture, now: number): void {
    this.future = [];
    const last = this.past.at(-1);
    const isSame = last?.name === gesture.name && (gesture.joins === 'always' || (gesture.joins === 'soon' && now - last.at <= soonMs));
    if (!last || !isSame) {
      this.past.push({ name: gesture.name, at: now, steps: [step] });
      if (this.past.length > mostEntries) this.past.shift();
      return;
    }
    last.at = now;
    const before = last.steps.at(-1);
    const both = before && merged(before, step);
    if (both) last.steps[last.steps.length - 1] = both;
    else last.steps.push(step);
  }

  /** The steps that take the last entry back, in their order. */
  undo(): Step[] {
    const entry = this.past.pop();
    if (!entry) return [];
    this.future.push(entry);
    return [...entry.steps].reverse().map(inverse);
  }

  redo(): Step[] {
    const entry = this.future.pop();
    if (!entry) return [];
    // What comes next is an entry of its own.
    this.past.push({ ...entry, at: -Infinity, name: entry.name + ' again' });
    return entry.steps;
  }
}
