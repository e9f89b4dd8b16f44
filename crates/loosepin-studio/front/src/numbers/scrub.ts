// Changes the leading number of a written value by steps, and leaves all else as it is written.

export type Scale = 'coarse' | 'usual' | 'fine';

interface Leading {
  before: string;
  digits: string;
  after: string;
}

function leading(written: string): Leading | null {
  const found = /^(\s*(?:±\s*)?)([-+−]?\d+(?:\.\d*)?|[-+−]?\.\d+)(.*)$/s.exec(written);
  if (!found) return null;
  const [, before = '', digits = '', after = ''] = found;
  // `1/2 in` is one number, and `2 * length` an expression: neither is moved by its first digits.
  if (/^\s*[/*^]/.test(after)) return null;
  return { before, digits, after };
}

export function canStep(written: string): boolean {
  return leading(written) !== null;
}

function decimalsOf(digits: string): number {
  return digits.split('.')[1]?.length ?? 0;
}

/** About a hundredth of the value, as 1, 2 or 5 times a power of ten: [its first digit, that power]. */
function stepOf(value: number): [number, number] {
  if (value === 0) return [1, -1];
  const rough = Math.abs(value) / 100;
  const power = Math.floor(Math.log10(rough) + 1e-9);
  const share = rough / 10 ** power;
  return [share < 1.5 ? 1 : share < 3.5 ? 2 : 5, power];
}

/**
 * The value that is so many tenths of a usual step from what is written, as a multiple of the step of this scale: so a drag may change
 * its scale on the way. Null where there is no number to step.
 */
export function stepped(written: string, tenths: number, scale: Scale): string | null {
  const parts = leading(written);
  if (!parts) return null;
  if (Math.trunc(tenths) === 0) return written;
  const value = Number(parts.digits.replace('−', '-'));
  const [first, usualPower] = stepOf(value);
  const power = usualPower + (scale === 'coarse' ? 1 : scale === 'fine' ? -1 : 0);
  const step = first * 10 ** power;
  const aim = value + Math.trunc(tenths) * first * 10 ** (usualPower - 1);
  // Towards where it comes from, so that a short drag does not jump.
  const next = (tenths > 0 ? Math.floor(aim / step + 1e-9) : Math.ceil(aim / step - 1e-9)) * step;
  if ((next - value) * tenths <= 0) return written;
  const decimals = Math.min(Math.max(decimalsOf(parts.digits), -power, 0), 12);
  const digits = next.toFixed(decimals);
  return parts.before + (Number(digits) === 0 ? digits.replace('-', '') : digits) + parts.after;
}

export function scaleOf(event: { shiftKey: boolean; altKey: boolean }): Scale {
  return event.shiftKey ? 'coarse' : event.altKey ? 'fine' : 'usual';
}

/** A step of each scale in tenths of a usual one. */
export const tenthsOf: Record<Scale, number> = { coarse: 100, usual: 10, fine: 1 };
