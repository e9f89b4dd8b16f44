// Unsaved texts, kept by the server until they are saved or taken back: after a reload, a crash, or a start at another port they are there again.
import { messageOf } from '../network/errors.ts';
import type { Document, DraftText, KeepDraftRequest, TakeDraftAnswer, TakeDraftRequest } from '../messages.ts';
import { session } from '../network/session.svelte.ts';
import { tab } from '../network/tab.ts';
import { ask, Refusal } from '../network/wire.ts';

export type UnsavedTexts = Partial<Record<Document, DraftText>>;

/** One after the other: the last one counts. */
let keeping: Promise<unknown> = Promise.resolve();

/** Without a server, or its key, the texts live as long as the page: that is said elsewhere. */
function sayWhy(error: unknown): void {
  if (error instanceof Refusal && error.status !== 0 && error.status !== 401) session.refusal = messageOf(error);
}

/** The unsaved texts of a path that are this tab's, or of none that is open. */
export async function takeDraft(path: string): Promise<TakeDraftAnswer> {
  try {
    return await ask<TakeDraftAnswer>('POST', '/api/draft/take', { tab, path } satisfies TakeDraftRequest);
  } catch (error) {
    sayWhy(error);
    return { draft: null, is_elsewhere: false };
  }
}

/** Keeps unsaved texts; without any, what was kept goes. Of a page that `isLeaving` nothing is waited for. */
export function keepDraft(path: string, texts: UnsavedTexts, isLeaving = false): void {
  const body = { tab, path, model: texts.model ?? null, study: texts.study ?? null } satisfies KeepDraftRequest;
  const keep = (): Promise<void> =>
    ask<null>('PUT', '/api/draft', body, isLeaving).then(() => {}, sayWhy);
  if (isLeaving) void keep();
  else keeping = keeping.then(keep);
}
