// A limit as it is written, with another value.
import type { LimitView } from '../messages.ts';
import { roundStep } from '../numbers/rounds.ts';

export function rounded(value: number, step: number): string {
  const decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  return (Math.round(value / step) * step).toFixed(Math.min(decimals, 12));
}

/** The text of a limit with the value `si`, in its own unit, in steps that are seen; null where it is no number with a unit. */
export function limitText(limit: LimitView, si: number, stepSi: number): string | null {
  const found = /^(\d+(?:\.\d*)?)(\s*\S+.*)$/.exec(limit.written);
  const number = Number(found?.[1]);
  if (!found || !(number > 0)) return null;
  const siPerUnit = limit.within_si / number;
  const step = roundStep(stepSi / siPerUnit);
  return rounded(Math.max(si / siPerUnit, step), step) + (found[2] ?? '');
}
