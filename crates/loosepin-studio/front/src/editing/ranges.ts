// Places in a text that stay at their words while the text is changed.
import type { Range } from './place.ts';
import type { Change } from './history.ts';

/** A range grows with what is written at its ends: the field of an emptied number still knows where it was. */
export function movedRange(range: Range, change: Change): Range {
  const shift = change.insert.length - (change.to - change.from);
  const from = range.from <= change.from ? range.from : range.from >= change.to ? range.from + shift : change.from;
  const to = range.to < change.from ? range.to : range.to >= change.to ? range.to + shift : change.from + change.insert.length;
  return { from, to: Math.max(from, to) };
}
