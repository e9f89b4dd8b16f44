// What is said between the studio and its server: version 1 of the protocol.

export type Which = 'model' | 'study';
export type Verdict = 'met' | 'not met' | 'undecided' | 'promised';

export interface BodyMotion {
  x: number[];
  y: number[];
  a: number[];
  dx: number[];
  dy: number[];
  da: number[];
}

export interface Motion {
  angle_deg: number[];
  magnification: number;
  start: number;
  bodies: BodyMotion[];
}

export interface Drawing {
  svg: string;
  motion: Motion;
}

export interface Hello {
  version: string;
  folder: string;
  limits: { text_bytes: number };
}

export interface Template {
  name: string;
  title: string;
  words: string;
  drawing: Drawing | null;
}

export interface FileEntry {
  path: string;
  kind: Which;
  title: string;
  model: string | null;
  at_ms?: number;
}

export interface ResultEntry {
  path: string;
  title: string;
  kind: 'study' | 'simulation' | 'motion' | 'sweep';
  verdict: Verdict | null;
  at_ms: number;
}

export interface Folder {
  files: FileEntry[];
  results: ResultEntry[];
  truncated: boolean;
}

export interface DocumentText {
  path: string;
  text: string;
  tag: string;
}

export interface Opened {
  model: DocumentText | null;
  study: DocumentText | null;
}

/** Offsets count UTF-16 units of the document's text. */
export interface Range {
  from: number;
  to: number;
}

/** Where it has a place in a text; the server leaves the four out where it has none. */
export interface Place {
  line?: number | null;
  column?: number | null;
  from?: number | null;
  to?: number | null;
}

export interface Label extends Place {
  document: Which | null;
  text: string;
}

export interface Fix extends Range {
  document: Which;
  insert: string;
  words: string;
}

export interface Complaint extends Place {
  document: Which | null;
  path: string | null;
  code: string;
  severity: 'error' | 'warning';
  message: string;
  hint: string | null;
  labels: Label[];
  fix?: Fix | null;
}

export interface Share {
  name: string;
  kind: 'play' | 'part';
  share: number;
  words: string;
}

export interface Band {
  output: string;
  words: string;
  largest: string;
  figure: string;
  /** In the unit of the figure. */
  largest_value: number;
  unit: string;
  si_per_unit: number;
  /** Whether the band keeps its limits. */
  kept: string[];
  parts: Share[];
}

/** A limit of the study, in its text. */
export interface Limit extends Range {
  output: string;
  within_si: number;
  written: string;
}

/** A pin that can be dragged: its place in the frame of a body of the drawing, mm. */
export interface Pin {
  body: number;
  x: number;
  y: number;
}

export interface JointEntry {
  name: string;
  kind: string;
  play: string | null;
  pin: Pin | null;
  /** The two that it joins: `rod.small_end`, `slider.pin`. */
  points: [string, string];
}

/** A body with its points, in its own frame, mm. */
export interface Part {
  name: string;
  points: { name: string; x: number; y: number }[];
}

/** A dimension of a body, or of the line of a joint: from and to in the frame of a body of the drawing, mm. */
export interface Dimension {
  kind: 'length' | 'angle';
  of: string;
  body: number;
  from: [number, number];
  to: [number, number];
  written: string;
  /** The number behind it, where there is one. */
  path: string | null;
}

/** A spring or a load; its ends are places in frames of bodies of the drawing, mm. */
export interface Force {
  table: 'spring' | 'load';
  name: string;
  kind: string;
  ends: Pin[];
  direction_deg: number | null;
  /** The direction turns with the body. */
  turns: boolean;
}

export interface Outline {
  bodies: string[];
  joints: JointEntry[];
  drives: string[];
  outputs: { name: string; words: string }[];
  forces: Force[];
  /** All bodies, the ground too, in the order of the drawing. */
  parts: Part[];
  dimensions: Dimension[];
}

export interface Quantity extends Range {
  path: string;
  /** The path in words, where the server has them. */
  words?: string;
  document: Which;
  written: string;
  kind: 'number' | 'scatter' | 'unknown';
  /** Dragging leaves it as it is. */
  is_locked: boolean;
}

export interface View {
  title: string;
  mobility: string;
  /** Why it does not move yet: it is drawn where its bodies were put. */
  incomplete: string | null;
  sentences: string[];
  drawing: Drawing | null;
  bands: Band[];
  limits: Limit[];
  outline: Outline;
  quantities: Quantity[];
}

/** A band over the cycle from the runs so far. */
export interface CoarseBand {
  title: string;
  words: string;
  figure: string;
}

export interface Job {
  id: number | string;
  /** A study, or one mechanism by itself. */
  kind: 'study' | 'run';
  /** The study; of a single run the result that it belongs to. */
  study: string;
  title: string;
  state: 'waiting' | 'running' | 'done' | 'failed' | 'stopped';
  finished: number;
  most: number;
  seconds: number;
  words: string[];
  result: string | null;
  verdict: Verdict | null;
  draft?: { words: string[]; bands: CoarseBand[] } | null;
  complaints?: string[];
}

export interface PathAndText {
  path: string;
  text: string;
}

/** What a drag takes. */
export type Held = { take: 'joint' | 'guide'; joint: string } | { take: 'point'; body: string; point: string };

/** A drag; poses are x and y in mm and the angle in degrees of each body. */
export interface Grip {
  held: Held;
  to_mm: [number, number];
  step_mm: number;
  is_free: boolean;
  poses: [number, number, number][];
}

/** What a drag does to the texts of its look. */
export interface Reshaped {
  changes: (Range & { document: Which; insert: string })[];
  words: string[];
  angle_deg: number | null;
  /** Where the bodies are that it has moved, by name. */
  poses: Record<string, [number, number, number]>;
  refusal: string | null;
}

/** What an entry of how well a number is known does to the texts; or why it cannot be read. */
export interface Rewritten {
  changes: Reshaped['changes'];
  refusal: { message: string; hint: string | null } | null;
}

export interface Look {
  kind: 'look';
  seq: number;
  model: PathAndText;
  study: PathAndText | null;
  positions: number;
  grip: Grip | null;
  /** Where bodies were last, by name: what does not move yet is drawn there. */
  poses: Record<string, [number, number, number]> | null;
}

export interface Seen {
  kind: 'seen';
  seq: number;
  complaints: Complaint[];
  view: View | null;
  /** Of a drag: complaints and view are of the texts with its changes. */
  reshaped: Reshaped | null;
  cost_ms: number;
  /** It took too long and was stopped: nothing is known of these texts. */
  is_cut: boolean;
}

export type ToServer = { kind: 'hello'; token: string } | Look | { kind: 'run'; study: string; shown: { model: PathAndText; study: PathAndText } } | { kind: 'simulate'; result: string; witness: number } | { kind: 'stop'; id: Job['id'] };

export type FromServer =
  | { kind: 'hello'; version: string; jobs: Job[] }
  | Seen
  | { kind: 'job'; job: Job }
  | { kind: 'changed'; path: string }
  | { kind: 'refused'; message: string };
