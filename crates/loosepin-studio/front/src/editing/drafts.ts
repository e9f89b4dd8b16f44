// Unsaved texts, kept by the server until they are saved or taken back: after a reload, a crash, or a start at another port they are there again.
import { messageOf } from '../network/errors.ts';
import type { Document, DraftText, KeepDraftRequest, TakeDraftAnswer, TakeDraftRequest } from '../messages.ts';
import { session } from '../network/session.svelte.ts';
import { tab } from '../network/tab.ts';
import { ask, Refusal } from '../network/wire.ts';

export interface Draft {
  /** When it was kept, ms since 1970. */
  at: number;
  texts: Partial<Record<Document, DraftText>>;
}

export interface TakenDraft {
  draft: Draft | null;
  /** Another tab that is open has unsaved texts of the path. */
  isElsewhere: boolean;
}

/** One after the other: the last one counts. */
let keeping: Promise<unknown> = Promise.resolve();

/** The unsaved texts of a path that are this tab's, or of none that is open. A folder that cannot be read has none. */
export async function takeDraft(path: string): Promise<TakenDraft> {
  try {
    const { draft, is_elsewhere } = await ask<TakeDraftAnswer>('POST', '/api/draft/take', { tab, path } satisfies TakeDraftRequest);
    if (draft?.at == null) return { draft: null, isElsewhere: is_elsewhere };
    const texts = { ...(draft.model && { model: draft.model }), ...(draft.study && { study: draft.study }) };
    return { draft: { at: draft.at, texts }, isElsewhere: is_elsewhere };
  } catch {
    return { draft: null, isElsewhere: false };
  }
}

/** Keeps unsaved texts; without any, what was kept goes. Of a page that `isLeaving` nothing is waited for. */
export function keepDraft(path: string, texts: Draft['texts'], isLeaving = false): void {
  const body = { tab, path, model: texts.model ?? null, study: texts.study ?? null } satisfies KeepDraftRequest;
  const keep = (): Promise<void> =>
    ask<null>('PUT', '/api/draft', body, isLeaving).then(
      () => {},
      (error: unknown) => {
        // Without a server, or its key, the texts live as long as the page: that is said elsewhere.
        if (error instanceof Refusal && error.status !== 0 && error.status !== 401) session.refusal = messageOf(error);
      },
    );
  if (isLeaving) void keep();
  else keeping = keeping.then(keep);
}
