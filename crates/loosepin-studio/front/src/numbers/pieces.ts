// The values inside what is written: `{ interval = ["0.1 mm", "0.5 mm"] }` has two, each with a field of its own.

export interface Piece {
  /** The key it stands under, or the end of an interval that it is; empty for a value that stands alone. */
  name: string;
  from: number;
  to: number;
}

const token = /([A-Za-z_][\w-]*)\s*=|"((?:[^"\\]|\\.)*)"|'([^']*)'|([-+]?\d[\w.+-]*)/g;

export function piecesOf(written: string, ends: { lower: string; upper: string }): Piece[] {
  if (!/^\s*[{[]/.test(written)) return [{ name: '', from: 0, to: written.length }];
  const pieces: Piece[] = [];
  let key = '';
  let isFirst = true;
  for (const found of written.matchAll(token)) {
    if (found[1] !== undefined) {
      key = found[1];
      isFirst = true;
      continue;
    }
    const isQuoted = found[4] === undefined;
    const isInterval = key === 'interval' || key === '';
    const name = isInterval ? (isFirst ? ends.lower : ends.upper) : key.replaceAll('_', ' ');
    const from = found.index + (isQuoted ? 1 : 0);
    pieces.push({ name, from, to: found.index + found[0].length - (isQuoted ? 1 : 0) });
    isFirst = false;
  }
  return pieces.length > 0 ? pieces : [{ name: '', from: 0, to: written.length }];
}
