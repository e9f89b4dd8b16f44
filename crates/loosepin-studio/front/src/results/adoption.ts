// Values of a result that the editor is to take into its texts as soon as they are there.

export interface Adoption {
  /** The study to be opened. */
  study: string;
  result: string;
  place: number;
}

let waiting: Adoption | null = null;

export function adoptNext(adoption: Adoption): void {
  waiting = adoption;
}

/** The values that wait for this study; they are given once. */
export function takeAdoption(study: string): Adoption | null {
  const found = waiting?.study === study ? waiting : null;
  waiting = null;
  return found;
}
