// What the texts say of how well a number is known, in the short form in which it is typed.
import type { Quantity } from './messages.ts';

const quoted = `"([^"]*)"|'([^']*)'|([-+.\\deE]+)`;

/** The values of a list or behind a key, without their quotes. */
function values(written: string, key: string): string[] {
  const found = new RegExp(`\\b${key}\\s*=\\s*(\\[[^\\]]*\\]|${quoted})`).exec(written)?.[1] ?? '';
  return [...found.matchAll(new RegExp(quoted, 'g'))].map((one) => one[1] ?? one[2] ?? one[3] ?? '');
}

/** `0.1 mm` and `0.5 mm` as `0.1..0.5 mm`: the unit once, where both have the same. */
function joined(list: string[], between: string): string {
  const units = list.map((value) => /^[-+.\d\s]*(.*)$/.exec(value)?.[1] ?? '');
  const isOne = units.every((unit) => unit === units[0]) && units[0] !== '';
  return list.map((value, index) => (isOne && index < list.length - 1 ? value.slice(0, value.length - (units[0]?.length ?? 0)).trim() : value)).join(between);
}

/** The short form of an entry of a study; null where it has none. */
function shortOf(written: string): string | null {
  const interval = values(written, 'interval');
  if (interval.length === 2) return joined(interval, '..');
  const [tolerance, deviation, fit] = ['tolerance', 'standard_deviation', 'fit'].map((key) => values(written, key)[0]);
  if (/\bcpk?\b|\btruncated\b|\bsamples\b|\bevidence\b/.test(written)) return null;
  if (tolerance !== undefined) return tolerance;
  if (/^\s*\{\s*normal\b/.test(written) && deviation !== undefined) return 'sd ' + deviation;
  if (fit !== undefined) return fit;
  const list = values(written, 'any_of');
  return list.length > 1 ? joined(list, ', ') : null;
}

export interface Known {
  kind: 'exact' | 'scatter' | 'unknown';
  /** As it is typed; null where only the text says it. */
  short: string | null;
}

/** How well the number at a path is known; null where there is no such number. */
export function knownOf(path: string, quantities: Quantity[], textOf: (quantity: Quantity) => string): Known | null {
  const own = quantities.filter((quantity) => quantity.path === path);
  const said = own.find((quantity) => quantity.kind !== 'number');
  if (said) return { kind: said.kind === 'unknown' ? 'unknown' : 'scatter', short: shortOf(textOf(said)) };
  const number = own[0];
  return number ? { kind: 'exact', short: textOf(number) } : null;
}
