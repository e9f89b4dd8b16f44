// A dimension with how well it is known: `260 mm`, `260 mm ± 0.05 mm`, `100..140 mm`.
import type { Desk } from '../editing/desk.svelte.ts';
import { knownOf } from './knowledge.ts';
import type { DimensionView } from '../messages.ts';

export function lengthOf(desk: Desk, { path, written }: DimensionView): string {
  const known = path === null ? null : knownOf(path, desk.quantities, (quantity) => desk.textAt(quantity));
  if (known?.short == null) return written;
  // A deviation alone does not say of what.
  return known.kind === 'scatter' && !/\d\s*\S*\s*[±+]/.test(known.short) ? `${written}, ${known.short}` : known.short;
}
