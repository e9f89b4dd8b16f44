// Pictures of one's own models: asked for as they come into view, few at a time, and remembered until a text changes.
import { messageOf } from '../network/errors.ts';
import type { OwnCard } from '../messages.ts';
import type { Entry } from './shelf.ts';
import { ask } from '../network/wire.ts';

const mostKept = 200;
const mostAtOnce = 2;
const kept = new Map<string, Promise<OwnCard>>();
const waiting: (() => void)[] = [];
let running = 0;

async function inTurn<T>(work: () => Promise<T>): Promise<T> {
  if (running >= mostAtOnce) await new Promise<void>((resolve) => waiting.push(resolve));
  running += 1;
  try {
    return await work();
  } finally {
    running -= 1;
    waiting.shift()?.();
  }
}

export function pictureOf({ file, atMs }: Entry): Promise<OwnCard> {
  const key = `${atMs} ${file.path}`;
  const known = kept.get(key);
  if (known) return known;
  const asked = inTurn(() => ask<OwnCard>('GET', '/api/card?path=' + encodeURIComponent(file.path))).catch((error: unknown) => {
    kept.delete(key);
    return { drawing: null, space: null, error: messageOf(error) };
  });
  kept.set(key, asked);
  if (kept.size > mostKept) kept.delete(kept.keys().next().value ?? '');
  return asked;
}
