// What the server is asked to do to a mechanism, and its answer. The same as in `src/edit/structure/edit.rs`.
import type { Reshaped } from './messages.ts';

export interface Named {
  table: string;
  name: string;
  /** A point of this body. */
  point?: string;
}

/** Where something begins or ends; x and y in mm. */
export type End =
  | { at: 'point'; body: string; point: string }
  | { at: 'on'; body: string; x: number; y: number; is_own?: boolean }
  | { at: 'free'; x: number; y: number };

export type Joined = { as: 'pin'; play?: string } | { as: 'slider' | 'slot'; angle_deg: number } | { as: 'rigid' };

/** What an output records. */
export type Watched =
  | { of: 'path'; body: string; point: string }
  | { of: 'position'; body: string; point: string; along: 'x' | 'y' }
  | { of: 'angle' | 'angular_velocity'; body: string }
  | { of: 'force'; joint: string };

export type Edit =
  | { kind: 'add_link'; from: End; to: End }
  | { kind: 'add_point'; body: string; to: End }
  | { kind: 'join'; first: End; second: End; by: Joined }
  | { kind: 'add_block'; on: End; angle_deg: number }
  | { kind: 'drive'; joint: string }
  | { kind: 'watch'; what: Watched }
  | { kind: 'remove'; what: Named }
  | { kind: 'rename'; what: Named; to: string }
  | { kind: 'lock'; path: string; is_locked: boolean };

/** Poses of bodies by name: x and y of the origin, mm, and the angle, degrees. */
export type Poses = Record<string, [number, number, number]>;

export interface Restructured {
  changes?: Reshaped['changes'];
  says?: string[];
  is_complete?: boolean;
  gone?: string[];
  name?: string | null;
  poses?: Poses;
  refusal: { message: string; hint: string | null } | null;
}

/** What comes of something that is taken out, before it is. */
export interface Removal {
  what: Named;
  gone: string[];
  says: string[];
}

export const wordsOf = ({ table, name, point }: Named): string => (point === undefined ? `${table} '${name}'` : `point '${name}.${point}'`);
