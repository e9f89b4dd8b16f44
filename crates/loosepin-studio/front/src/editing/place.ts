// Places in a text.
import type { Stretch } from '../messages.ts';

/** Offsets count UTF-16 units of the document's text. */
export interface Range {
  from: number;
  to: number;
}

/** Where it has a place in a text; the server leaves the four out where it has none. */
export type Place = Partial<Stretch>;
