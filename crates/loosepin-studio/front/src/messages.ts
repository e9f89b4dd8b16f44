// What the studio and its server say to each other, from the types of the server in Rust.
// Not written by hand: `just studio-messages` writes it, and a test of the architecture compares it.

/** Something with a name: `joint.gudgeon`, `body.rod`, or the point `body.rod.points.small_end`. */
export interface Named {
  /** The table that it stands in: `body`, `joint`, `output`, ... */
  table: string;
  /** Its name there. */
  name: string;
  /** A point of this body. */
  point?: string | null;
}

/** An end of a new part. */
export type End =
  /** A point of the model. */
  | {
      at: 'point';
      /** The body; `ground` too. */
      body: string;
      /** The point. */
      point: string;
    }
  /** A new point of a body. */
  | {
      at: 'on';
      /** The body; `ground` too. */
      body: string;
      /** To the right, mm. */
      x: number;
      /** Upwards, mm. */
      y: number;
      /** In the frame of the body, not in that of the ground. */
      is_own?: boolean;
    }
  /** A place that nothing holds. */
  | {
      at: 'free';
      /** To the right, mm. */
      x: number;
      /** Upwards, mm. */
      y: number;
    };

/** How two points are joined. */
export type Joined =
  /** A pin; ideal, or with play as people write it. */
  | {
      as: 'pin';
      /** `0.1 mm`, `0.1..0.5 mm`; ideal where nothing is written. */
      play?: string | null;
    }
  /** The second body slides along a line through the first point, and does not turn against it. */
  | {
      as: 'slider';
      /** Direction of the line from the x axis of the ground, degrees. */
      angle_deg: number;
    }
  /** The second point slides along a line through the first point, and turns there. */
  | {
      as: 'slot';
      /** Direction of the line from the x axis of the ground, degrees. */
      angle_deg: number;
    }
  /** One body of both. */
  | { as: 'rigid' };

/** An axis of the ground. */
export type Axis =
  /** To the right. */
  | 'x'
  /** Upwards. */
  | 'y';

/** The recorded quantity of an output. */
export type Watched =
  /** The path of a point. */
  | {
      of: 'path';
      /** Its body. */
      body: string;
      /** The point. */
      point: string;
    }
  /** A coordinate of a point. */
  | {
      of: 'position';
      /** Its body. */
      body: string;
      /** The point. */
      point: string;
      /** Which coordinate. */
      along: Axis;
    }
  /** The angle of a body. */
  | {
      of: 'angle';
      /** The body. */
      body: string;
    }
  /** The angular velocity of a body. */
  | {
      of: 'angular_velocity';
      /** The body. */
      body: string;
    }
  /** The magnitude of the force in a joint. */
  | {
      of: 'force';
      /** The joint. */
      joint: string;
    };

/** A change of a mechanism. */
export type Edit =
  /** A link between two places. */
  | {
      kind: 'add_link';
      /** Its beginning. */
      from: End;
      /** Its end. */
      to: End;
    }
  /** A further point of a body; where it is one of another body, both are joined by a pin. */
  | {
      kind: 'add_point';
      /** The body. */
      body: string;
      /** The place. */
      to: End;
    }
  /** A joint of two points. */
  | {
      kind: 'join';
      /** Bearing, or guide. */
      first: End;
      /** Journal, or slider. */
      second: End;
      /** Kind of joint. */
      by: Joined;
    }
  /** A block in a guide of the ground, with a pin to what is at its place. */
  | {
      kind: 'add_block';
      /** The pin. */
      on: End;
      /** Direction of the guide, degrees. */
      angle_deg: number;
    }
  /** The one drive turns or pushes this joint. */
  | {
      kind: 'drive';
      /** The joint. */
      joint: string;
    }
  /** An output records something from now on. */
  | {
      kind: 'watch';
      /** It. */
      what: Watched;
    }
  /** Something goes, with all that names it. */
  | {
      kind: 'remove';
      /** It. */
      what: Named;
    }
  /** Another name, wherever the old one stands. */
  | {
      kind: 'rename';
      /** It. */
      what: Named;
      /** The new name. */
      to: string;
    }
  /** Whether dragging may change a number. */
  | {
      kind: 'lock';
      /** Path of the number. */
      path: string;
      /** It may not. */
      is_locked: boolean;
    };

/** The changes of an edit, and notes on them. */
export interface Restructured {
  /** In units of the texts that were sent, in their order. */
  changes: Change[];
  /** Degrees of freedom in words, or what is missing. */
  says: string[];
  /** The mechanism moves as its drives say. */
  is_complete: boolean;
  /** Removed items, in words. */
  gone: string[];
  /** Name of what came. */
  name: string | null;
  /** Poses of new bodies: x and y, mm, and the angle, degrees. */
  poses: NamedPoses;
}

/** A stretch of a text that is replaced. */
export interface Change {
  /** The text. */
  document: Document;
  /** First UTF-16 unit that goes. */
  from: number;
  /** Behind the last UTF-16 unit that goes. */
  to: number;
  /** The replacement. */
  insert: string;
}

/** Which of the two texts. */
export type Document =
  /** The mechanism. */
  | 'model'
  /** Its uncertain inputs and its questions. */
  | 'study';

/** Poses of bodies by their names: x and y of the origin, mm, and the angle, degrees. */
export type NamedPoses = Record<string, [number, number, number]>;

/** Both texts with the values in them. */
export interface AdoptedTexts {
  /** The model. */
  model: string;
  /** The study. */
  study: string | null;
  /** The values, in words. */
  words: string;
  /** Whether the study on the page is another one than the result was made of, but for these values. */
  has_changed: boolean;
}

/** A text that is not saved. */
export interface DraftText {
  /** It. */
  text: string;
  /** Tag of the file from which it began. */
  tag: string;
}

/** The unsaved texts of a path. */
export interface Draft {
  /** When they were kept, ms since 1970. */
  at: number;
  /** The path by which they were opened. */
  path: string;
  /** The model, where it has changed. */
  model: DraftText | null;
  /** The study, where it has changed. */
  study: DraftText | null;
}

/** A template as the page shows it. */
export interface TemplateCard {
  /** Its name, by which it is made. */
  name: string;
  /** What it is, in a few words. */
  title: string;
  /** What is to be seen in it. */
  words: string;
  /** The mechanism, moving; `None` of one in space. */
  drawing: MovingDrawing | null;
  /** The mechanism in space, moving. */
  space: SpaceDrawing | null;
}

/** A drawing of a mechanism for a page that moves it by itself. */
export interface MovingDrawing {
  /** The first pose, as an SVG document that takes its style from the page. Groups with `data-body` move with a body, those with `data-rides` with a point of one. */
  svg: string;
  /** Poses of the bodies. */
  motion: Motion;
}

/** Poses of a mechanism over a turn, for the script that moves its picture. */
export interface Motion {
  /** Angle of the drive at each pose, degrees. */
  angle_deg: (number | null)[];
  magnification: number;
  /** The pose that is shown first. */
  start: number;
  bodies: BodyMotion[];
  bends?: Bend[];
}

/** The bent axis of a flexible body over the poses, for the script that moves it. */
export interface Bend {
  /** The body in whose frame it is drawn. */
  body: number;
  /** Places along the straight axis, mm. */
  places: [number, number][];
  /** Direction to the left of the way from root to tip. */
  normal: [number, number];
  /** Deflection of each shape at each place, mm for each rad. */
  shapes: ((number | null)[])[];
  /** Coordinate of each shape at each pose, rad. */
  turns: ((number | null)[])[];
  /** Magnification of deflections. */
  factor: number;
  /** x and y of places along the axis at each pose, mm, in place of shapes. */
  track?: ([(number | null)[], (number | null)[]])[];
}

/** Ideal pose and actual minus ideal, in mm and degrees, one entry per pose. */
export interface BodyMotion {
  x: (number | null)[];
  y: (number | null)[];
  a: (number | null)[];
  dx: (number | null)[];
  dy: (number | null)[];
  da: (number | null)[];
}

/** A drawing of a mechanism in space for a page that turns and moves it by itself. */
export interface SpaceDrawing {
  /** The first view, as an SVG document that takes its style from the page. */
  svg: string;
  /** What `scripts/space-scene.ts` draws it from, as JSON. */
  scene: string;
}

/** A model or study of the folder as the page shows it. */
export interface OwnCard {
  /** The mechanism, moving; `None` of one in space, or if the model cannot be read. */
  drawing: MovingDrawing | null;
  /** The mechanism in space, moving. */
  space: SpaceDrawing | null;
  /** The first error in the texts. */
  error: string | null;
}

/** A model or a study. */
export interface ListedFile {
  /** Path in the served folder. */
  path: string;
  /** Which of both. */
  kind: Document;
  /** Its name; the path of one that has none. */
  title: string;
  /** Path of the model of a study. */
  model: string | null;
  /** When it was written, milliseconds since 1970. */
  at_ms: number;
  /** The newest result of a study. */
  result: NewestResult | null;
}

/** The newest result of a study: of its texts as they are, where there is one. */
export interface NewestResult {
  /** Path of its folder in the served one. */
  path: string;
  /** Over all requirements. */
  verdict: Verdict | null;
  /** When it was finished, milliseconds since 1970. */
  at_ms: number;
  /** Whether it is one of the texts as they are. */
  texts: TextState;
}

/** Whether texts are those that a result was computed from. */
export type TextState =
  /** Letter for letter, tables too. */
  | 'same'
  /** A text has changed since. */
  | 'changed'
  /** The result does not hold its texts: an older version wrote it. */
  | 'unknown';

/** Verdict on a requirement that a share of mechanisms keeps a limit, whatever the epistemic inputs are. */
export type Verdict =
  /** Met for every value of the epistemic inputs, numerical error included. */
  | 'met'
  /** Kept in a stated share of the box of the epistemic inputs, with a stated confidence; not shown for every value. */
  | 'promised'
  /** Not met for at least one value, numerical error included. */
  | 'not_met'
  /** The numerical error reaches over the limit, or the share is unknown: more runs decide. */
  | 'undecided';

/** A finished result. */
export interface ListedResult {
  /** Path of its folder in the served one. */
  path: string;
  /** Its name. */
  title: string;
  /** Kind of the result. */
  kind: ResultKind;
  /** Over all requirements of a study. */
  verdict: Verdict | null;
  /** When it was finished, milliseconds since 1970. */
  at_ms: number;
  /** Whether a study of its name in the folder has its texts; `None` if there is no study of its name. */
  texts: TextState | null;
}

/** A kind of result, which has a folder of its own. */
export type ResultKind =
  /** One dynamic run. */
  | 'simulation'
  /** Ideal motion and quasi-static answer. */
  | 'motion'
  /** An uncertainty study. */
  | 'study'
  /** Runs for many values of a quantity. */
  | 'sweep'
  /** What readings and motion of a rig say of the unknowns. */
  | 'identification'
  /** Neural networks of a study, for other programs. */
  | 'networks';

/** The served folder as the page shows it. */
export interface Listing {
  /** Models and studies, the newest first. */
  files: ListedFile[];
  /** Finished results, the newest first. */
  results: ListedResult[];
  /** Whether the list is truncated. */
  truncated: boolean;
}

/** Available actions on a result. */
export interface ResultActions {
  /** Name of the result. */
  title: string;
  /** Whether it is the result of a study: of others there is nothing to be done. */
  is_study: boolean;
  /** Mechanisms that can be run by themselves. */
  witnesses: Doing[];
  /** Values that can be taken into the model, in the order of the page. */
  known: string[][];
  /** Paths of the studies of this name in the served folder, the newest first. */
  studies: string[];
  /** Whether one of these studies has the texts of the result; `None` if there is none. */
  texts: TextState | null;
}

/** A mechanism that can be run by itself. */
export interface Doing {
  /** Its unknown values. */
  values: string[];
  /** The requirements and bounds that it attains. */
  attains: string[];
  /** The command that runs it. */
  command: string;
}

/** What was moved into the trash. */
export interface Trashed {
  /** Its entry in the trash. */
  entry: string;
  /** The paths that it had. */
  paths: string[];
}

/** A stretch of a text. */
export interface Stretch {
  /** Line, from 1. */
  line: number;
  /** Column in characters, from 1. */
  column: number;
  /** First UTF-16 unit. */
  from: number;
  /** Behind the last UTF-16 unit. */
  to: number;
}

/** A second place that matters to a diagnostic. */
export interface LabelView extends Partial<Stretch> {
  /** The text; `None` if it is none of the two. */
  document: Document | null;
  /** Its text. */
  text: string;
}

/** Something wrong, or worth a warning. */
export interface DiagnosticView extends Partial<Stretch> {
  /** The text at fault; `None` if it is none of the two. */
  document: Document | null;
  /** Path of the file at fault. */
  path: string | null;
  /** For `explain`. */
  code: string;
  /** How grave it is. */
  severity: Severity;
  /** The problem. */
  message: string;
  /** The way out. */
  hint: string | null;
  /** Other places. */
  labels: LabelView[];
  /** A change that mends it, where one is known. */
  fix: Fix | null;
}

/** A change that mends a diagnostic. */
export interface Fix extends Change {
  /** Its effect, in words. */
  words: string;
}

/** How grave a diagnostic is. */
export type Severity =
  /** The file can be used. */
  | 'warning'
  /** The file cannot be used. */
  | 'error';

/** The state of a job. */
export type JobState =
  /** Others are before it. */
  | 'waiting'
  /** The job is running. */
  | 'running'
  /** Its results are there. */
  | 'done'
  /** The job has failed. */
  | 'failed'
  /** Somebody stopped it; its runs are kept. */
  | 'stopped';

/** Kind of a job. */
export type JobKind =
  /** A study. */
  | 'study'
  /** One mechanism by itself. */
  | 'run';

/** A background job. */
export interface Job {
  /** Its number. */
  id: number;
  /** Which of both. */
  kind: JobKind;
  /** The study; of a single run the result that it belongs to. */
  study: string;
  /** Its name. */
  title: string;
  /** Its state. */
  state: JobState;
  /** Finished runs. */
  finished: number;
  /** Upper limit of its runs. */
  most: number;
  /** Since it began to run. */
  seconds: number;
  /** Results, in sentences. */
  words: string[];
  /** Intermediate results before it is finished. */
  draft: JobDraft | null;
  /** Why it failed, in a sentence. */
  reason: string | null;
  /** Errors, if it failed. */
  diagnostics: string[];
  /** Folder of its results, in the served folder. */
  result: string | null;
  /** Over all requirements. */
  verdict: Verdict | null;
}

/** Intermediate results of a study. */
export interface JobDraft {
  /** In sentences. */
  words: string[];
  /** Bands over the cycle from the runs so far. */
  bands: DraftBand[];
}

/** The band of one deviation, from the runs so far. */
export interface DraftBand {
  /** Title: `Deviation of slider`. */
  title: string;
  /** Meaning of the band, and its present limits. */
  words: string;
  /** The chart as an SVG document that takes its style from the page. */
  figure: string;
}

/** A text with the path of its file, by which diagnostics name it. */
export interface SentText {
  /** Path in the served folder. */
  path: string;
  /** Its text. */
  text: string;
}

/** A study and its model, as the page shows them. */
export interface Shown {
  /** The model. */
  model: SentText;
  /** The study. */
  study: SentText;
}

/** A request of the page to read its texts. */
export interface Look {
  /** Counts up; comes back with the answer. */
  seq: number;
  /** The model. */
  model: SentText;
  /** The study of it, where there is one. */
  study?: SentText | null;
  /** Positions in a turn. */
  positions: number;
  /** The drag, if any: the texts are read as the drag changes them. */
  grip?: Grip | null;
  /** Previous poses of the bodies: a mechanism that does not move yet is drawn there. */
  poses?: NamedPoses | null;
  /** The curve that is shown, if any. */
  curve?: CurveKey | null;
  /** Points that are traced although no output is their path: `coupler.tip`. Those that the model does not have are left out. */
  traced?: string[];
  /** Nothing changes now: the texts are then also tried as by `loosepin check`, which is told in a [`CheckAnswer`]. */
  is_at_rest?: boolean;
}

/** Identity of a curve. */
export interface CurveKey {
  /** Its quantity. */
  quantity: CurveQuantity;
  /** Name of the output or the point, or both bodies of a transmission angle: `coupler and rocker`. */
  of: string;
}

/** The quantity of a curve. */
export type CurveQuantity =
  /** Position of an output or a point. */
  | 'position'
  /** Its velocity, at the speed of the drive. */
  | 'velocity'
  /** Its acceleration. */
  | 'acceleration'
  /** Force, torque or power of a drive. */
  | 'effort'
  /** Transmission or pressure angle of a loop. */
  | 'transmission_angle'
  /** Mechanical advantage of an output. */
  | 'mechanical_advantage';

/** A drag. */
export interface Grip {
  /** The dragged object. */
  held: Held;
  /** Target of a centre or point, or a place on the line of a guide, mm. */
  to_mm: [number, number];
  /** Written values are rounded to the next round step that is not below this one, mm. */
  step_mm: number;
  /** Values are as they come: no round steps. */
  is_free: boolean;
  /** Pose of each body: x and y of its origin, mm, and its angle, degrees. */
  poses: [number, number, number][];
}

/** The dragged object. */
export type Held =
  /** The centre of a pin. */
  | {
      take: 'joint';
      /** Its name. */
      joint: string;
    }
  /** A point that no pin holds. */
  | {
      take: 'point';
      /** Its body; `ground` too. */
      body: string;
      /** Its name. */
      point: string;
    }
  /** The line of a guide or a slot, which turns about its point. */
  | {
      take: 'guide';
      /** Name of the joint. */
      joint: string;
    };

/** Messages from the page over the live connection. */
export type FromPage =
  /** The first message. */
  | {
      kind: 'hello';
      /** The secret of the address. */
      token: string;
      /** Name of the tab, where it has one. */
      tab?: string | null;
    }
  /** Read these texts. */
  | ({ kind: 'look' } & Look)
  /** Run a study that is saved. */
  | {
      kind: 'run';
      /** Its path in the served folder. */
      study: string;
      /** The texts that the page shows: these are run, whatever is on the disk by then. */
      shown?: Shown | null;
    }
  /** Run the mechanism at a witness of a finished study. */
  | {
      kind: 'simulate';
      /** Path of the result in the served folder. */
      result: string;
      /** Place among the witnesses that it lists. */
      witness: number;
    }
  /** Stop a job, or take it out of the queue. */
  | {
      kind: 'stop';
      /** Its number. */
      id: number;
    };

/** Messages to the page over the live connection. */
export type ToPage =
  /** The token was right. */
  | {
      kind: 'hello';
      /** Version of the program. */
      version: string;
      /** Jobs of this server. */
      jobs: Job[];
    }
  /** What was read. */
  | ({ kind: 'look_answer' } & LookAnswer)
  /** What keeps the texts of a look from running. */
  | ({ kind: 'check_answer' } & CheckAnswer)
  /** How far a job is. */
  | {
      kind: 'job';
      /** It. */
      job: Job;
    }
  /** A file of the last look is not as it was. */
  | {
      kind: 'changed';
      /** Its path. */
      path: string;
    }
  /** A message that is not taken. */
  | {
      kind: 'refused';
      /** Why. */
      message: string;
    };

/** What `loosepin check` finds in the texts of a look that has a view. */
export interface CheckAnswer {
  /** Sequence number of the look. */
  seq: number;
  /** What keeps them from running; none where they run. */
  diagnostics: DiagnosticView[];
}

/** The answer to a look. */
export interface LookAnswer {
  /** Sequence number of the look. */
  seq: number;
  /** Everything wrong, and warnings. */
  diagnostics: DiagnosticView[];
  /** The mechanism; `None` if the model cannot be read, or does not move. */
  view: View | null;
  /** Effect of a drag: `diagnostics` and `view` are of the texts with its changes. */
  reshaped: DragResult | null;
  /** How long it took. */
  cost_ms: number;
  /** The look took too long and was stopped: these texts were not read. */
  is_cut: boolean;
}

/** Effect of a drag on the sent texts. */
export interface DragResult {
  /** The changes, all in units of the texts that were sent, in their order. */
  changes: Change[];
  /** The new values, in words. */
  words: string[];
  /** The angle of the drive at which the joints lie where the drag left them. */
  angle_deg: number | null;
  /** Poses of the dragged bodies, by name: for drawing a mechanism that does not move yet. */
  poses: NamedPoses;
  /** Why nothing can be changed. */
  refusal: string | null;
}

/** The mechanism that was read. */
export interface View {
  /** Its name, or that of the study. */
  title: string;
  /** Degrees of freedom and drives, in words. */
  mobility: string;
  /** Why it does not move yet; what is drawn is where its bodies were put. */
  incomplete: string | null;
  /** Quasi-static effects of play and scatter, in sentences. */
  sentences: string[];
  /** The mechanism, moving; `None` of one in space. */
  drawing: MovingDrawing | null;
  /** The mechanism in space, moving. */
  space: SpaceDrawing | null;
  /** The band of each output that has one. */
  bands: LiveBand[];
  /** The paths of output points and of traced points, with their zones. */
  paths: LivePath[];
  /** Curves that there are. */
  curves: CurveChoice[];
  /** The wanted one, or the first of its quantity. */
  curve: LiveCurve | null;
  /** The angles between which the drive can turn, degrees, where it cannot go through its whole turn. */
  drive_range_deg: [number, number] | null;
  /** The limits among them. */
  limits: LimitView[];
  /** Its parts. */
  outline: Outline;
  /** Its numbers. */
  quantities: QuantityView[];
}

/** A curve that there is. */
export interface CurveChoice {
  /** Its identity. */
  key: CurveKey;
  /** Whose it is, in words. */
  words: string;
}

/** A limit of the study that is a line in the chart of a band. */
export interface LimitView {
  /** Name of the output. */
  output: string;
  /** The limit, SI. */
  within_si: number;
  /** As the study has it, quotes left out. */
  written: string;
  /** First UTF-16 unit of it. */
  from: number;
  /** Behind the last one. */
  to: number;
}

/** The band of one output. */
export interface LiveBand {
  /** Name of the output. */
  output: string;
  /** Description. */
  words: string;
  /** How wide the band is where it is widest, in a sentence. */
  largest: string;
  /** The chart as an SVG document that takes its style from the page. `data-plot` has left, top, width and height of the frame of its curves in units of the picture, `data-x` the angles at its ends, degrees, `data-y` the values at its foot and head. */
  figure: string;
  /** Half the width of the outer band where it is widest, in the unit of the figure. */
  largest_value: number;
  /** The unit of the figure, in a file. */
  unit: string;
  /** SI units in a unit of the figure. */
  si_per_unit: number;
  /** Whether the band keeps each limit of its output, in a sentence. */
  kept: string[];
  /** The place that the parts are at, in words: the first pose of a requirement or a question, else where the band is widest. */
  parts_at: string;
  /** Parts of the band there, the largest first. */
  parts: BandPart[];
}

/** The share of one joint or one dimension in a band. */
export interface BandPart {
  /** Joint, or path of the dimension. */
  name: string;
  /** Its source. */
  kind: PartKind;
  /** Share of the outer band, 0 to 1. */
  share: number;
  /** Its share, with the unit. */
  words: string;
}

/** The source of a part of a band. */
export type PartKind =
  /** The play of a joint. */
  | 'play'
  /** The scatter of a dimension. */
  | 'part';

/** A curve with its numbers. */
export interface LiveCurve {
  /** Its identity. */
  key: CurveKey;
  /** The chart as an SVG document, with `data-plot`, `data-x` and `data-y` as those of a band. */
  figure: string;
  /** Unit of the values, as it is shown. */
  unit: string;
  /** Angle of the drive at each value, degrees; where the time is the input the time, s. */
  at: number[];
  /** The lines of the chart, in their order. */
  lines: CurveLine[];
}

/** A line of a chart. */
export interface CurveLine {
  /** Its name: `x`, `magnitude`, `ideal velocity`. */
  words: string;
  /** Class of its colour. */
  role: string;
  /** Its values in the unit of the chart, to six digits, `None` if it is not finite. */
  values: (number | null)[];
}

/** The path of a point and the zone about it. */
export interface LivePath {
  /** The output that is this path, if any. */
  output: string | null;
  /** The point: `coupler.tip`. */
  point: string;
  /** Reach of the play, mm: 16 numbers for each pose of the drawing, for the directions 0°, 11.25°, ... 168.75° from the x axis. Empty if play does not move the point. */
  play_reach_mm: number[];
  /** The 95 % ellipse of the scatter at each pose: larger and smaller semi-axis, mm, and the angle of the larger one from the x axis, degrees. Empty if nothing scatters. */
  scatter: [number, number, number][];
}

/** Parts of the mechanism. */
export interface Outline {
  /** Bodies that move. */
  bodies: string[];
  /** Joints. */
  joints: JointView[];
  /** Drives. */
  drives: string[];
  /** Outputs. */
  outputs: OutputView[];
  /** Springs and loads. */
  forces: ForceView[];
  /** All bodies with their points, in the order of the drawing. */
  parts: BodyView[];
  /** Dimensions of bodies and joints. */
  dimensions: DimensionView[];
  /** Four-bars and slider-cranks through the ground with their classes, in words, where it moves. */
  loops: string[];
}

/** A body with its points; the ground too. */
export interface BodyView {
  /** Its name. */
  name: string;
  /** Its points. */
  points: PointView[];
}

/** A point of a body. */
export interface PointView {
  /** Its name. */
  name: string;
  /** x in the frame of its body, mm. */
  x: number;
  /** y in it, mm. */
  y: number;
}

/** A dimension of a body or a joint. */
export interface DimensionView {
  /** Its kind. */
  kind: DimensionKind;
  /** Name of the body, or of the joint whose line it is. */
  of: string;
  /** Index of the body that it moves with, in the drawing. */
  body: number;
  /** Its beginning in the frame of that body, mm. */
  from: [number, number];
  /** Its end; for a line, a millimetre along it. */
  to: [number, number];
  /** With its unit. */
  written: string;
  /** The number behind it, where there is one. */
  path: string | null;
}

/** Kind of a dimension. */
export type DimensionKind =
  /** Length of a body. */
  | 'length'
  /** Angle of the line of a joint. */
  | 'angle';

/** A spring or a load, with where it stands in the drawing. */
export interface ForceView {
  /** Which of both. */
  table: ForceTable;
  /** Its name. */
  name: string;
  /** Its kind, in words. */
  kind: string;
  /** Both ends of a spring along a line; the one place of all others; empty if no point says where. */
  ends: PinView[];
  /** Direction of a force from the x axis of the body at `ends`, or from that of the ground, degrees. */
  direction_deg: number | null;
  /** The direction turns with the body. */
  turns: boolean;
}

/** Tables of what acts on bodies. */
export type ForceTable =
  /** Springs and dampers. */
  | 'spring'
  /** Forces and torques. */
  | 'load';

/** A pin and its position. */
export interface PinView {
  /** Index of a body that carries it, in the drawing. */
  body: number;
  /** x in the frame of that body, mm. */
  x: number;
  /** y in it, mm. */
  y: number;
}

/** A joint in the outline. */
export interface JointView {
  /** Its name. */
  name: string;
  /** Its kind, in words. */
  kind: string;
  /** Its play, where it has any. */
  play: string | null;
  /** Whether it can have play. */
  takes_play: boolean;
  /** Its centre, where it is a pin that can be dragged. */
  pin: PinView | null;
  /** The points that it joins: `rod.small_end`, `slider.pin`. */
  points: [string, string];
}

/** An output in the outline. */
export interface OutputView {
  /** Its name. */
  name: string;
  /** Its description, in words. */
  words: string;
}

/** A number of the texts. */
export interface QuantityView {
  /** Path in the file: `joint.gudgeon.radial_clearance`. */
  path: string;
  /** In words. */
  words: string;
  /** The text. */
  document: Document;
  /** The written text, without quotes. */
  written: string;
  /** First UTF-16 unit. */
  from: number;
  /** Behind the last UTF-16 unit. */
  to: number;
  /** Its kind. */
  kind: QuantityKind;
  /** Dragging leaves it as it is. */
  is_locked: boolean;
}

/** Kind of a written number. */
export type QuantityKind =
  /** Its value in the model. */
  | 'number'
  /** How it scatters. */
  | 'scatter'
  /** What is unknown of it. */
  | 'unknown';

/** Why nothing comes of a request, or of what somebody typed or drew. */
export interface Refused {
  /** What is wrong. */
  message: string;
  /** The way out, where one is known. */
  hint: string | null;
}

/** Description of the server. */
export interface HelloAnswer {
  /** Version of the program. */
  version: string;
  /** Path of the served folder. */
  folder: string;
  /** Its limits. */
  limits: Limits;
}

/** Limits of the server. */
export interface Limits {
  /** Largest text, bytes. */
  text_bytes: number;
}

/** A file to be opened. */
export interface OpenRequest {
  /** Path in the served folder. */
  path: string;
}

/** A model, or a study with its model. */
export interface OpenAnswer {
  /** `None` if the model of the study cannot be read. */
  model: OpenedText | null;
  /** `None` if a model was asked for. */
  study: OpenedText | null;
}

/** A text of the served folder. */
export interface OpenedText {
  /** Its path. */
  path: string;
  /** Its text. */
  text: string;
  /** Tag by which it is recognised when it is saved. */
  tag: string;
  /** Whether it is what this server has saved there last: no other program has changed it since. */
  is_saved_here: boolean;
}

/** A text to be saved. */
export interface SaveRequest {
  /** Path in the served folder. */
  path: string;
  /** Its text. */
  text: string;
  /** Tag of the text that it changes; `None` for a new one. */
  tag?: string | null;
}

/** A text was saved. */
export interface SaveAnswer {
  /** Tag of the present text. */
  tag: string;
}

/** How well a number is known, to be written into both texts. */
export interface SetUncertaintyRequest {
  /** The model. */
  model: SentText;
  /** The study of it, where there is one. */
  study?: SentText | null;
  /** Path of the number. */
  path: string;
  /** As it is typed. */
  text: string;
}

/** Effect on the texts of an entry of a number's uncertainty. What somebody types is no fault of the page: a refusal is an answer. */
export interface SetUncertaintyAnswer {
  /** In units of the texts that were sent, in their order. */
  changes: Change[];
  /** Why there are none. */
  refusal: Refused | null;
}

/** A change of the mechanism. */
export interface RestructureRequest {
  /** The model. */
  model: SentText;
  /** The study of it, where there is one. */
  study?: SentText | null;
  /** The requested change. */
  edit: Edit;
  /** Displayed poses of the bodies. */
  poses?: NamedPoses;
}

/** Effect of a change of the mechanism, or why there is none. */
export interface RestructureAnswer extends Partial<Restructured> {
  /** Why not. */
  refusal: Refused | null;
}

/** Unsaved texts of a tab, to be kept in place of those before. */
export interface KeepDraftRequest {
  /** Name of the tab: 32 hexadecimal digits. */
  tab: string;
  /** The path by which they were opened. */
  path: string;
  /** The model, where it has changed. */
  model?: DraftText | null;
  /** The study, where it has changed. */
  study?: DraftText | null;
}

/** A path whose unsaved texts a tab asks for. */
export interface TakeDraftRequest {
  /** Name of the tab. */
  tab: string;
  /** The path. */
  path: string;
}

/** Unsaved texts that belong to the tab from now on. */
export interface TakeDraftAnswer {
  /** They, where there are any. */
  draft: Draft | null;
  /** Another tab that is open has unsaved texts of the path. */
  is_elsewhere: boolean;
}

/** A template, or two texts, to be made a mechanism of one's own. */
export interface NewRequest {
  /** Name of the template; `None` where both texts are given. */
  template?: string | null;
  /** Text of the model. */
  model?: string | null;
  /** Text of the study. */
  study?: string | null;
  /** Name of the new folder. */
  folder: string;
}

/** A model and a study were written. */
export interface NewAnswer {
  /** Path of the model. */
  model: string;
  /** Path of the study. */
  study: string;
  /** Tag of the text of the model. */
  model_tag: string;
  /** Tag of the text of the study. */
  study_tag: string;
}

/** Both texts of a template, or of an empty sheet. */
export interface TemplateTexts {
  /** The model. */
  model: string;
  /** The study. */
  study: string;
}

/** A model, a study or a result that goes into the trash. */
export interface TrashRequest {
  /** Path of the file, or of the folder of the result. */
  path: string;
}

/** What was deleted, to be moved back. */
export interface RestoreRequest {
  /** Its entry in the trash. */
  entry: string;
  /** The paths that it had. */
  paths: string[];
}

/** What was deleted is back. */
export interface RestoreAnswer {
  /** Number of files and folders. */
  restored: number;
}

/** A model or a study, with its model, to be copied. */
export interface DuplicateRequest {
  /** Its path. */
  path: string;
}

/** Paths of a copy. */
export interface DuplicateAnswer {
  /** The model. */
  model: string | null;
  /** The study. */
  study: string | null;
}

/** Destination of a drawing in the DXF format. */
export interface ImportRequest {
  /** Path of the new folder. */
  folder: string;
  /** Name of the mechanism. */
  title: string;
  /** Unit of the drawing, where it names none itself. */
  unit?: string | null;
}

/** Result of an import of a drawing in the DXF format. */
export interface ImportAnswer {
  /** Path of the model. */
  model: string;
  /** Findings in the drawing, and omitted parts. */
  notes: string[];
}

/** Meaning of a code of a diagnostic. */
export interface ExplainAnswer {
  /** The code. */
  code: string;
  /** In a few words. */
  title: string;
  /** In whole. */
  text: string;
}

/** A report to be shown. */
export interface ViewRequest {
  /** Path of the folder of the result. */
  path: string;
}

/** Address at which a report is shown once. */
export interface ViewAnswer {
  /** Its address. */
  address: string;
}

/** Two studies to be shown beside each other. */
export interface CompareRequest {
  /** Path of the result A. */
  before: string;
  /** Path of the result B. */
  after: string;
}

/** Both studies beside each other. */
export type CompareAnswer = Comparison;

/** Two studies beside each other. */
export interface Comparison {
  /** How much smaller or larger the main answer is in B. */
  headline: string;
  /** The studies, A first. */
  sides: [ComparedSide, ComparedSide];
  /** Reasons why the numbers are less comparable. */
  warnings: string[];
  /** Parts that are not compared, with the reasons. */
  left_out: string[];
  /** Requirements with both verdicts. */
  requirements: ComparedRequirement[];
  /** Both bands of an output in one picture. */
  bands: ComparedBand[];
  /** Bounds of single statistics with their differences. */
  statistics: ComparedStatistic[];
  /** Differences of the inputs, uncertain ones first. */
  inputs: ChangedInput[];
}

/** An input that two studies have differently. */
export interface ChangedInput {
  /** Place of the input. */
  place: InputPlace;
  /** Its path: `joint.gudgeon.radial_clearance`. */
  path: string;
  /** The same in words. */
  words: string;
  /** Entry of A, with its unit; `None` if it has no such entry. */
  before: string | null;
  /** Entry of B. */
  after: string | null;
}

/** Place of an input of a study. */
export type InputPlace =
  /** An uncertain input. */
  | 'uncertain'
  /** In the model. */
  | 'model'
  /** In the study. */
  | 'study'
  /** In a table of numbers that the study names. */
  | 'table'
  /** In the command. */
  | 'command';

/** Both bands of an output over the cycle. */
export interface ComparedBand {
  /** Title: `Deviation of slider`. */
  title: string;
  /** How far each band reaches, in a sentence. */
  words: string;
  /** The chart as an SVG document that takes its style from the page. */
  figure: string;
  /** Angles of the chart, degrees. */
  angle_deg: number[];
  /** From where to where A and B reach at each of them, with units. */
  reaches: [string, string][];
}

/** A requirement on one number, as each study has it. */
export interface ComparedRequirement {
  /** On what: `deviation of slider over the whole cycle`. */
  what: string;
  /** The limits and the required share in A and in B, in words; `None` if the study does not require it. */
  required: [string | null, string | null];
  /** Bounds of the share that keeps the limits. */
  kept: [string | null, string | null];
  /** The verdicts. */
  verdicts: [Verdict | null, Verdict | null];
}

/** One of the two studies. */
export interface ComparedSide {
  /** Name of the study. */
  name: string;
  /** Name of the model. */
  model: string;
  /** Over all requirements. */
  verdict: Verdict | null;
  /** The answer in sentences. */
  words: string[];
}

/** A statistic that both studies bound. */
export interface ComparedStatistic {
  /** The response: `slider (x of slider.pin): deviation, largest absolute value in the cycle`. */
  response: string;
  /** Which one, and by which treatment where it is not the mixed one. */
  statistic: string;
  /** The smallest and the largest value that it may have. */
  ends: [ComparedEnd, ComparedEnd];
}

/** One end of a bound in both studies. */
export interface ComparedEnd {
  /** The value found with its numerical error, in A and in B: bounds hold their errors, so a difference of them is none of the statistics. */
  values: [string, string];
  /** B minus A of the values found, with sign and unit. */
  difference: string;
  /** The same in SI. */
  difference_si: number;
  /** Whether it means anything. */
  weight: Weight;
}

/** A difference against the numerical errors of what is compared. */
export type Weight =
  /** There is none. */
  | 'none'
  /** The difference is not larger than both errors together: it may be numerical alone. */
  | 'within_errors'
  /** The difference is larger. */
  | 'beyond_errors';

/** A result of which it is asked what can be done with it. */
export interface ResultRequest {
  /** Path of its folder. */
  path: string;
}

/** Values of a result to be taken into the texts of the page. */
export interface AdoptRequest {
  /** The model. */
  model: SentText;
  /** The study of it, where there is one. */
  study?: SentText | null;
  /** Path of the folder of the result. */
  path: string;
  /** Place among the values that it lists. */
  place: number;
}

/** Both texts with the values of a result in them, or why they do not take them. */
export interface AdoptAnswer {
  /** They. */
  adopted: AdoptedTexts | null;
  /** Why not. */
  refusal: Refused | null;
}
