// Round numbers: 1, 2 and 5 times powers of ten.

/** The least of them that is not below `least`. */
export function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least) + 1e-9);
  return [1, 2, 5, 10].map((first) => first * power).find((step) => step >= least * (1 - 1e-9)) ?? least;
}

/** The largest of them that is not above `most`. */
export function roundBelow(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most) + 1e-9);
  return [5, 2, 1].map((first) => first * power).find((step) => step <= most * (1 + 1e-9)) ?? most;
}
