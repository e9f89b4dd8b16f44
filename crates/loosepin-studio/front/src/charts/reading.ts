// The values of a curve where the drive stands.

/** Digits of a value, as on the pages. */
const digits = 4;
/** Beside the largest value of a line, less than this is round-off. */
const roundOff = 1e-9;
/** Outside of these, powers of ten are written. */
const plain = [1e-5, 1e7] as const;

/** Between two poses on the straight line between them; null where one of both has no value. */
export function valueAtPose(values: readonly (number | null)[], pose: number): number | null {
  const index = Math.floor(pose);
  const first = values[index] ?? null;
  const share = pose - index;
  if (share === 0) return first;
  const second = values[index + 1] ?? null;
  return first === null || second === null ? null : first + share * (second - first);
}

/** A value of a line to four digits. */
export function reading(value: number, values: readonly (number | null)[]): string {
  const largest = values.reduce((most: number, one) => Math.max(most, Math.abs(one ?? 0)), 0);
  const size = Math.abs(value);
  if (size <= roundOff * largest) return '0';
  const text = value.toPrecision(digits);
  const written = size >= plain[0] && size < plain[1] ? (text.includes('e') ? Number(text).toFixed(0) : text) : value.toExponential(digits - 1).replace('e', ' · 10^').replace('+', '');
  return written.replaceAll('-', '−');
}
