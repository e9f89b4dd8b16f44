// What is changed of a mechanism, in words.
import type { Named } from '../messages.ts';

/** What comes of something that is taken out, before it is. */
export interface Removal {
  what: Named;
  gone: string[];
  says: string[];
}

export const wordsOf = ({ table, name, point }: Named): string => (point == null ? `${table} '${name}'` : `point '${name}.${point}'`);
