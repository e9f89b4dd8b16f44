// What is typed into a field where a number with its unit stood.

/** A number by itself, with a point or a comma: `80`, `80,5`, `-.5`. */
const bare = /^[-+−]?(?:\d+(?:[.,]\d*)?|[.,]\d+)$/;
/** A number with one unit behind it: `80 mm`, `3000 rpm`, `1.2e-3 kg m^2`. */
const withUnit = /^[-+−]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?\s+([^\s\d+*(/-].*)$/;
/** A comma before three digits may separate thousands. */
const thousands = /,\d{3}$/;

/**
 * What a person means who types `typed` where `before` stood: a number by itself keeps the unit that stood there, and a decimal comma is a
 * point. All else stays as it is typed, and the server says what is wrong with it.
 */
export function meant(typed: string, before: string): string {
  const number = typed.trim();
  const [, unit] = withUnit.exec(before.trim()) ?? [];
  if (unit === undefined || !bare.test(number) || thousands.test(number)) return typed;
  return `${number.replace(',', '.').replace('−', '-')} ${unit}`;
}
