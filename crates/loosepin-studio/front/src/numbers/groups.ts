// Sorts the numbers of the texts into groups, and names them.
import type { QuantityView } from '../messages.ts';
import { piecesOf } from './pieces.ts';
import { words } from '../words.ts';

export interface FieldOf {
  /** Stays the same while the texts change. */
  key: string;
  label: string;
  quantity: QuantityView;
  from: number;
  to: number;
}

export interface Entry {
  key: string;
  label: string;
  /** One field for a number; one for each value of a distribution or an interval. */
  fields: FieldOf[];
}

export interface Group {
  name: string;
  entries: Entry[];
}

const order = ['unknown', 'scatter', 'parameter', 'joint', 'drive', 'contact', 'body', 'other'];

function groupOf(quantity: QuantityView): string {
  if (quantity.kind !== 'number') return quantity.kind;
  const first = quantity.path.split('.')[0] ?? '';
  return order.includes(first) ? first : 'other';
}

function labelOf(quantity: QuantityView): string {
  // The heading of the group says what it is a part of.
  if (quantity.words) return quantity.words.replace(/^[a-z]+ '([^']+)'/, '$1');
  const parts = quantity.path.split('.').map((part) => part.replaceAll('_', ' '));
  return (parts.length > 1 ? parts.slice(1) : parts).join(', ');
}

export function groupsOf(quantities: QuantityView[], textOf: (quantity: QuantityView) => string, sought: string): Group[] {
  const needle = sought.trim().toLowerCase();
  const groups = new Map<string, Entry[]>(order.map((name) => [name, []]));
  const seen = new Map<string, number>();
  for (const quantity of quantities) {
    const label = labelOf(quantity);
    const name = quantity.document + ':' + quantity.path;
    const times = seen.get(name) ?? 0;
    seen.set(name, times + 1);
    if (needle !== '' && !label.toLowerCase().includes(needle) && !quantity.path.toLowerCase().includes(needle)) continue;
    const key = name + ':' + times;
    const fields = piecesOf(textOf(quantity), words.numbers).map((piece, index) => ({
      key: key + ':' + index,
      label: piece.name,
      quantity,
      from: quantity.from + piece.from,
      to: quantity.from + piece.to,
    }));
    groups.get(groupOf(quantity))?.push({ key, label, fields });
  }
  return [...groups].map(([name, entries]) => ({ name, entries })).filter((group) => group.entries.length > 0);
}
