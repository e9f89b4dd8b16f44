// What is said of an error that was caught.
import { words } from '../words.ts';
import { Refusal } from './wire.ts';

export function messageOf(error: unknown): string {
  if (!(error instanceof Refusal)) return words.wire.unknown;
  if (error.status === 0) return words.wire.unreachable;
  return [error.message || words.wire.unknown, error.hint].filter(Boolean).join(' ');
}
