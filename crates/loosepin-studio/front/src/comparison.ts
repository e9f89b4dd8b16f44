// What the server says of two results, and of what can be done with one.
import type { Verdict } from './messages.ts';

export interface ComparedEnd {
  values: [string, string];
  difference: string;
  weight: 'none' | 'within_errors' | 'beyond_errors';
}

export interface ChangedInput {
  place: 'uncertain' | 'model' | 'study' | 'table' | 'command';
  path: string;
  words: string;
  before: string | null;
  after: string | null;
}

/** Both bands of an output over the cycle. */
export interface ComparedBand {
  title: string;
  words: string;
  figure: string;
  angle_deg: number[];
  /** From where to where A and B reach at each angle. */
  reaches: [string, string][];
}

export interface Comparison {
  headline: string;
  sides: [ComparedSide, ComparedSide];
  warnings: string[];
  left_out: string[];
  requirements: {
    what: string;
    required: [string | null, string | null];
    kept: [string | null, string | null];
    verdicts: [Verdict | null, Verdict | null];
  }[];
  bands: ComparedBand[];
  statistics: { response: string; statistic: string; ends: [ComparedEnd, ComparedEnd] }[];
  inputs: ChangedInput[];
}

export interface ComparedSide {
  name: string;
  model: string;
  verdict: Verdict | null;
  words: string[];
}

/** What can be done with a result. */
export interface Doings {
  title: string;
  /** Of others there is nothing to be done. */
  is_study: boolean;
  witnesses: { values: string[]; attains: string[]; command: string }[];
  /** Values that can be taken into the model, in the order of the page. */
  known: string[][];
  /** Paths of the studies of this name, the newest first. */
  studies: string[];
}

/** Both texts with the values of a result in them; or why they do not take them. */
export interface AdoptedAnswer {
  adopted: { model: string; study: string | null; words: string; has_changed: boolean } | null;
  refusal: { message: string; hint: string | null } | null;
}
