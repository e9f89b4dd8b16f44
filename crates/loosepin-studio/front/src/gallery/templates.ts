// Makes folders with the first name that is free.
import type { ImportAnswer, ImportRequest } from '../messages.ts';
import { ask, Refusal } from '../network/wire.ts';

const mostTried = 100;

/** Tries `name`, `name-2`, and so on, until the server finds one that is not there already. */
export async function firstFree<T>(name: string, make: (free: string) => Promise<T>): Promise<T> {
  for (let number = 1; ; number += 1) {
    try {
      return await make(number === 1 ? name : `${name}-${number}`);
    } catch (error) {
      if (!(error instanceof Refusal) || error.status !== 409 || number >= mostTried) throw error;
    }
  }
}

/** A folder with the skeleton of a model from a drawing. */
export async function importDrawing(file: File, unit: string): Promise<ImportAnswer> {
  const title = file.name.replace(/\.[^.]*$/, '');
  const name = title.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-+|-+$/g, '').slice(0, 50) || 'drawing';
  const drawing = await file.arrayBuffer();
  return firstFree(name, (folder) => {
    const query = new URLSearchParams({ folder, title, unit } satisfies ImportRequest);
    return ask<ImportAnswer>('POST', '/api/import?' + query.toString(), drawing);
  });
}
