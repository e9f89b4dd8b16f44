// Unsaved texts, kept over a reload of the page and a crash of the browser until they are saved or taken back.
import type { Document } from '../messages.ts';

/** A text that was not saved, and the tag of the file from which it began. */
export interface DraftText {
  text: string;
  tag: string;
}

export interface Draft {
  /** When it was kept, ms since 1970. */
  at: number;
  texts: Partial<Record<Document, DraftText>>;
}

const prefix = 'loosepin-draft ';

/** One browser may have seen several folders at one address. */
const keyOf = (folder: string, path: string): string => `${prefix}${folder} ${path}`;

const isText = (value: unknown): value is DraftText =>
  typeof value === 'object' && value !== null && typeof (value as DraftText).text === 'string' && typeof (value as DraftText).tag === 'string';

/** The unsaved texts of a path; null where there are none, or where what is stored is something else. */
export function draftOf(folder: string, path: string): Draft | null {
  try {
    const found = JSON.parse(localStorage.getItem(keyOf(folder, path)) ?? 'null') as Partial<Draft> | null;
    if (typeof found?.at !== 'number' || typeof found.texts !== 'object') return null;
    const texts = Object.fromEntries((['model', 'study'] as const).flatMap((which) => (isText(found.texts?.[which]) ? [[which, found.texts[which]]] : [])));
    return Object.keys(texts).length > 0 ? { at: found.at, texts } : null;
  } catch {
    return null;
  }
}

/** Keeps unsaved texts; without any, what was kept goes. */
export function keepDraft(folder: string, path: string, texts: Draft['texts']): void {
  try {
    if (Object.keys(texts).length === 0) localStorage.removeItem(keyOf(folder, path));
    else localStorage.setItem(keyOf(folder, path), JSON.stringify({ at: Date.now(), texts } satisfies Draft));
  } catch {
    // A full storage, or none: the texts live as long as the page.
  }
}
