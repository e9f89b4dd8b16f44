// One's own work: what stands on the shelf, copies of it, what goes into the trash and comes back.
import type { DuplicateAnswer, DuplicateRequest, ListedFile, Listing, RestoreAnswer, RestoreRequest, Trashed, TrashRequest } from '../messages.ts';
import { ask } from '../network/wire.ts';

/** A study with its model, or a model that no study names. */
export interface Entry {
  file: ListedFile;
  /** When one of both was changed last. */
  atMs: number;
}

/** What stands on the shelf, the last changed first. */
export function entriesOf({ files }: Listing): Entry[] {
  const byPath = new Map(files.map((file) => [file.path, file]));
  const named = new Set(files.map((file) => file.model));
  return files
    .filter((file) => file.kind === 'study' || !named.has(file.path))
    .map((file) => ({ file, atMs: Math.max(file.at_ms, byPath.get(file.model ?? '')?.at_ms ?? 0) }))
    .sort((one, other) => other.atMs - one.atMs);
}

/** Copies a study with its model beside them; gives the path of the copy. */
export async function duplicate(path: string): Promise<string> {
  const { model, study } = await ask<DuplicateAnswer>('POST', '/api/duplicate', { path } satisfies DuplicateRequest);
  return study ?? model ?? path;
}

export async function moveToTrash(path: string): Promise<Trashed> {
  return ask<Trashed>('POST', '/api/trash', { path } satisfies TrashRequest);
}

export async function restore({ entry, paths }: Trashed): Promise<void> {
  await ask<RestoreAnswer>('POST', '/api/restore', { entry, paths } satisfies RestoreRequest);
}
