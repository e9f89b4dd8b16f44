// What the texts say of how well a number is known, in the short form in which it is typed.
import type { QuantityView } from '../messages.ts';

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

/** The short form of an entry of a study, where that says all of it; `nominal` is the value of the model. */
function shortOf(written: string, kind: 'scatter' | 'unknown', nominal: string | null): string | null {
  const only = (key: string, rest = ''): boolean => new RegExp(`^\\s*\\{\\s*${key}\\s*=\\s*(${quoted}|\\[[^\\]{}]*\\])\\s*${rest}\\}\\s*$`).test(written);
  if (kind === 'unknown') {
    if (only('interval')) return joined(values(written, 'interval'), '..');
    if (only('any_of')) return joined(values(written, 'any_of'), ', ');
    return only('fit', `,\\s*diameter\\s*=\\s*(${quoted})\\s*`) ? (values(written, 'fit')[0] ?? null) : null;
  }
  if (only('tolerance')) return values(written, 'tolerance')[0] ?? null;
  const normal = new RegExp(`^\\s*\\{\\s*normal\\s*=\\s*\\{\\s*(?:mean\\s*=\\s*(?:${quoted})\\s*,\\s*)?standard_deviation\\s*=\\s*(${quoted})\\s*\\}\\s*\\}\\s*$`);
  if (!normal.test(written)) return null;
  // A mean that is left out is that of the model; another one would be lost.
  if ((values(written, 'mean')[0] ?? nominal) !== nominal) return null;
  return 'sd ' + (values(written, 'standard_deviation')[0] ?? '');
}

export interface Known {
  kind: 'exact' | 'scatter' | 'unknown';
  /** As it is typed; null where only the text says it. */
  short: string | null;
}

/** How well the number at a path is known; null where there is no such number. */
export function knownOf(path: string, quantities: QuantityView[], textOf: (quantity: QuantityView) => string): Known | null {
  const own = quantities.filter((quantity) => quantity.path === path);
  const said = own.find((quantity) => quantity.kind !== 'number');
  const number = own.find((quantity) => quantity.kind === 'number');
  if (said) {
    const kind = said.kind === 'unknown' ? 'unknown' : 'scatter';
    return { kind, short: shortOf(textOf(said), kind, number ? textOf(number) : null) };
  }
  return number ? { kind: 'exact', short: textOf(number) } : null;
}

/** The number that is the play of a joint, and how well it is known; null where it has none yet. */
export function playOf(joint: string, quantities: QuantityView[], textOf: (quantity: QuantityView) => string): { path: string; isDiametral: boolean; known: Known | null } {
  const [radial, diametral] = ['radial', 'diametral'].map((which) => `joint.${joint}.${which}_clearance`) as [string, string];
  const isDiametral = quantities.some(({ path }) => path === diametral);
  const path = isDiametral ? diametral : radial;
  return { path, isDiametral, known: knownOf(path, quantities, textOf) };
}
