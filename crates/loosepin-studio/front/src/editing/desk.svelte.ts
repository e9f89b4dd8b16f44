// What lies on the desk of the editor: the texts, what the server sees in them, and the play head.
import type { Adoption } from '../results/adoption.ts';
import type { AdoptAnswer, AdoptRequest, CheckAnswer, CurveKey, Document, Draft, Edit, Fix, Held, SetUncertaintyAnswer, SetUncertaintyRequest, Named, NamedPoses, DragResult, RestructureAnswer, RestructureRequest, LookAnswer, DiagnosticView, LimitView, QuantityView, View } from '../messages.ts';
import { Build } from './build.svelte.ts';
import { chosenCurve } from '../charts/chosen_curve.svelte.ts';
import type { Removal } from './edits.ts';
import { messageOf } from '../network/errors.ts';
import type { FieldOf } from '../numbers/groups.ts';
import { differences, Drag, type Point } from './drag.ts';
import { Documents } from './documents.svelte.ts';
import type { Change, Gesture } from './history.ts';
import { Head } from '../drawing/head.svelte.ts';
import { Viewport } from '../drawing/viewport.svelte.ts';
import { Looker } from '../network/looker.ts';
import { posesAt } from '../drawing/player.ts';
import { parsedSpace, type Space } from '../space/space.ts';
import { movedRange } from './ranges.ts';
import { session } from '../network/session.svelte.ts';
import { ask } from '../network/wire.ts';
import { words } from '../words.ts';

const typingPauseMs = 150;
/** A text whose errors are not known after so long is saved as it is: the analysis of a large model must not keep it from the disk. */
const checkPatienceMs = 3000;
/** Texts of the model of which it is remembered where bodies were. */
const mostPoses = 200;

export interface Reveal {
  document: Document;
  from: number;
  to: number;
}

function moveAll<T extends { document: Document | null; from?: number | null; to?: number | null }>(list: T[], which: Document, change: Change): T[] {
  return list.map((item) => {
    if (item.document !== which || item.from == null || item.to == null) return item;
    return { ...item, ...movedRange({ from: item.from, to: item.to }, change) };
  });
}

export class Desk {
  readonly head = new Head();
  /** What the canvas shows. */
  readonly viewport = new Viewport();
  /** The last view of texts that could be read. */
  view = $state.raw<View | null>(null);
  /** The picture of a mechanism in space. */
  space = $state.raw<Space | null>(null);
  /** The view in the panels about the canvas. */
  panels = $state.raw<View | null>(null);
  /** What the last answer to a drag changes beyond the canvas, in the next frame: both together would make one late. */
  private rest: { frame: number; takeIn: () => void } | null = null;
  diagnostics = $state.raw<DiagnosticView[]>([]);
  /** What keeps texts that can be read from running: found while they rest. */
  obstacles = $state.raw<DiagnosticView[]>([]);
  problems = $derived([...this.diagnostics, ...this.obstacles]);
  /** Counts the answers: diagnostics come anew with each. */
  answers = $state(0);
  quantities = $state.raw<QuantityView[]>([]);
  /** Limits of the study, where they are in its text now. */
  limits = $state.raw<LimitView[]>([]);
  isStale = $state(false);
  /** The last look took too long and was stopped. */
  isCut = $state(false);
  /** The view is of the texts as they are, at the most positions. */
  isSettled = $state(false);
  output = $state<string | null>(null);
  /** Points whose paths are drawn although no output is their path: `coupler.tip`. */
  traced = $state.raw<string[]>([]);
  reveal = $state.raw<Reveal | null>(null);
  changedOnDisk = $state.raw<Document[]>([]);
  /** The joint that is looked at. */
  chosen = $state<string | null>(null);
  /** The body or output that is looked at. */
  part = $state.raw<Named | null>(null);
  readonly build = new Build(this);
  /** What the last edit of links and joints says: degrees of freedom, or why it was not made; and the name of what it brought. */
  built = $state.raw<{ words: string[]; isRefused: boolean; name: string | null } | null>(null);
  /** Unsaved texts from before, which began from other files than those on the disk. */
  older = $state.raw<Draft | null>(null);
  /** Unsaved texts of this desk are stored, or were taken from there. */
  hasDraft = false;
  /** What is to be taken out, once that is confirmed. */
  removal = $state.raw<Removal | null>(null);
  /** What is dragged. */
  drag = $state.raw<Drag | null>(null);
  /** What the last drag says: new values, or why there are none. */
  dragged = $state.raw<{ words: string[]; refusal: string | null } | null>(null);
  band = $derived(this.panels?.bands.find((band) => band.output === this.output) ?? this.panels?.bands[0] ?? null);
  private readonly looker: Looker;
  /** Version of the texts that the view is of. */
  private viewed = -1;
  /** A drag writes. */
  private isRewriting = false;
  /** Where bodies are at the start, by name: what does not move yet is drawn there. */
  private poses: NamedPoses = {};
  /** The same by the text of the model. */
  private readonly posesBy = new Map<string, NamedPoses>();
  /** What was tried last, until its look is taken in. */
  private tried: CheckAnswer | null = null;
  /** The look that was taken in last, and the version of the texts with what it has written. */
  private taken: { seq: number; version: number } | null = null;
  /** Version of the texts whose diagnostics are known, and who waits for those of a newer one. */
  private checked = -1;
  private waiting: (() => void)[] = [];
  private confirmed: { answer: RestructureAnswer; version: number } | null = null;

  constructor(readonly documents: Documents) {
    this.looker = new Looker(
      () => this.look(),
      (look) => session.send(look),
      (seen, version, isFinest) => this.hear(seen, version, isFinest),
    );
  }

  /** Begins to listen and to look; stops when the returned function is called. */
  open(): () => void {
    const stops = [
      session.listen({
        seen: (seen) => this.looker.heard(seen),
        tried: (found) => {
          this.tried = found;
          this.takeObstacles();
        },
        changed: (path) => void this.changed(path),
        opened: () => {
          // What a drag has written stays; its last place is lost with the connection.
          this.drag = null;
          this.looker.again();
        },
      }),
      this.documents.listen((step) => {
        this.isSettled = false;
        this.removal = null;
        this.built = null;
        // Whoever else changes a text ends a drag: it would write over that.
        if (!this.isRewriting) {
          this.drag = null;
          this.dragged = null;
        }
        this.quantities = moveAll(this.quantities, step.document, step.change);
        if (step.document === 'study') this.limits = this.limits.map((limit) => ({ ...limit, ...movedRange(limit, step.change) }));
        this.diagnostics = moveAll(this.diagnostics, step.document, step.change);
        this.obstacles = moveAll(this.obstacles, step.document, step.change);
        this.looker.soon(typingPauseMs);
      }),
    ];
    this.looker.now();
    return () => {
      stops.forEach((stop) => stop());
      this.looker.stop();
      this.leaveRest();
      this.drag = null;
      this.head.run(false);
    };
  }

  /** A change whose picture is wanted at once. */
  change(document: Document, change: Change, gesture: Gesture): void {
    this.documents.change(document, change, gesture);
    this.looker.now();
  }

  undo(): void {
    this.documents.undo();
    this.looker.now();
  }

  redo(): void {
    this.documents.redo();
    this.looker.now();
  }

  /** Shows a curve over the angle of the drive, or the band of the deviation. */
  chooseCurve(key: CurveKey | null): void {
    chosenCurve.set(key);
    this.lookAgain();
  }

  /** Draws the path of a point, or does so no more. */
  trace(point: string): void {
    this.traced = this.traced.includes(point) ? this.traced.filter((one) => one !== point) : [...this.traced, point];
    this.lookAgain();
  }

  /** Whether an output is the path of a point. */
  isRecorded(point: string): boolean {
    return this.view?.paths.some((path) => path.output !== null && path.point === point) ?? false;
  }

  /** The texts are the same, and something else of them is wanted. */
  private lookAgain(): void {
    this.isSettled = false;
    this.looker.now();
  }

  mend(fix: Fix): void {
    this.change(fix.document, { from: fix.from, to: fix.to, insert: fix.insert }, { name: 'fix', joins: 'never' });
  }

  /** Takes something in the drawing, to be moved in steps of the screen. */
  take(held: Held, start: Point, stepMm: number, name: string): void {
    const model = this.documents.textOf('model');
    const motion = this.view?.drawing?.motion;
    if (!model || !motion || this.isStale) return;
    this.head.run(false);
    this.dragged = null;
    this.drag = new Drag(held, { model, study: this.documents.textOf('study') }, posesAt(motion, this.head.angle), start, stepMm, name);
  }

  moveDrag(to: Point, isFree: boolean): void {
    this.drag?.move(to, isFree);
    this.looker.now();
  }

  /** Lets go; what is done `then` belongs to the same step to undo. */
  endDrag(then: Edit | null = null): void {
    if (!this.drag) return;
    this.drag.isEnding = true;
    this.drag.then = then;
    this.looker.now();
  }

  /** The texts are again as they were before the drag. */
  cancelDrag(): void {
    const { drag } = this;
    if (!drag) return;
    this.drag = null;
    this.dragged = null;
    this.rewrite('model', drag.base.model.text, drag.name);
    if (drag.base.study) this.rewrite('study', drag.base.study.text, drag.name);
    this.looker.now();
  }

  private rewrite(which: Document, text: string | null, name: string): void {
    const now = this.documents.sheet(which)?.text;
    if (text === null || now === undefined) return;
    this.isRewriting = true;
    differences(now, text).forEach((change) => this.documents.change(which, change, { name, joins: 'always' }));
    this.isRewriting = false;
  }

  private follow(drag: Drag, reshaped: DragResult, mayEnd: boolean): void {
    this.dragged = { words: reshaped.words, refusal: reshaped.refusal };
    if (reshaped.refusal === null) {
      for (const which of ['model', 'study'] as const) this.rewrite(which, drag.textOf(which, reshaped), drag.name);
    }
    if (mayEnd && drag.isEnding && !this.looker.isWaiting) {
      this.drag = null;
      if (drag.then && reshaped.refusal === null) {
        void this.restructure(drag.then, drag.name, reshaped.poses);
      } else this.looker.now();
    }
  }

  /** A limit of the study with another value; one name is one step to undo. */
  changeLimit(limit: LimitView, insert: string, name: string): void {
    const place = this.limits.indexOf(limit);
    const share = parseFloat(insert) / parseFloat(limit.written);
    this.documents.change('study', { from: limit.from, to: limit.to, insert }, { name, joins: 'always' });
    const moved = { ...limit, written: insert, to: limit.from + insert.length, within_si: limit.within_si * share };
    this.limits = this.limits.map((one, index) => (index === place ? moved : one));
    this.looker.now();
  }

  /** Requires an output to stay within a limit, at the end of the study. */
  addLimit(output: string, within: string): void {
    const text = this.documents.study?.text;
    if (text === undefined) return;
    // A path has its parts under one name: `tracer x` is the part x of tracer.
    const [, path, part] = / /.test(output) ? (/^(.*) (x|y|along|normal|magnitude|contour)$/.exec(output) ?? []) : [];
    const named = `output = ${JSON.stringify(path ?? output)}${part === undefined ? '' : `\ncomponent = "${part}"`}`;
    const insert = `${text.endsWith('\n') || text === '' ? '' : '\n'}\n[[require]]\n${named}\nof = "total"\nwithin = "${within}"\nover = "cycle"\nprobability_at_least = 0.95\n`;
    this.change('study', { from: text.length, to: text.length, insert }, { name: 'add limit', joins: 'never' });
  }

  textAt(quantity: QuantityView): string {
    return this.documents.sheet(quantity.document)?.text.slice(quantity.from, quantity.to) ?? '';
  }

  /** The error that stands at a field, with its way out. */
  messageAt(field: FieldOf): string | null {
    const found = this.diagnostics.find(
      ({ document, severity, from, to }) =>
        document === field.quantity.document && severity === 'error' && from != null && to != null && from <= field.to && to >= field.from && to - from < 400,
    );
    return found ? [found.message, found.hint].filter(Boolean).join(': ') : null;
  }

  /** Writes how well a number is known into both texts, as one step to undo; says why, where that cannot be. */
  async setUncertainty(path: string, text: string): Promise<string | null> {
    const { documents } = this;
    const { version } = documents;
    const model = documents.textOf('model');
    if (!model) return words.editor.noModel;
    const body = { model, study: documents.textOf('study'), path, text } satisfies SetUncertaintyRequest;
    let answer: SetUncertaintyAnswer;
    try {
      answer = await ask<SetUncertaintyAnswer>('POST', '/api/set-uncertainty', body);
    } catch (error) {
      return messageOf(error);
    }
    const { changes, refusal } = answer;
    if (refusal) return [refusal.message, refusal.hint].filter(Boolean).join(': ');
    // The texts went on meanwhile: the places of the answer are old.
    if (documents.version !== version) return this.setUncertainty(path, text);
    this.apply(changes, `know ${path} ${version}`);
    return null;
  }

  /** Takes values of a result into both texts, as one step to undo; says what was done, and whether it was. */
  async adopt({ result, place }: Adoption): Promise<{ words: string; isDone: boolean }> {
    const { documents } = this;
    const { version } = documents;
    const model = documents.textOf('model');
    if (!model) return { words: words.editor.noModel, isDone: false };
    const body = { model, study: documents.textOf('study'), path: result, place } satisfies AdoptRequest;
    let answer: AdoptAnswer;
    try {
      answer = await ask<AdoptAnswer>('POST', '/api/adopt', body);
    } catch (error) {
      return { words: messageOf(error), isDone: false };
    }
    const { adopted, refusal } = answer;
    if (!adopted) return { words: [refusal?.message, refusal?.hint].filter(Boolean).join(': '), isDone: false };
    // The texts went on meanwhile: the answer is of old ones.
    if (documents.version !== version) return this.adopt({ study: documents.opened, result, place });
    const name = `adopt ${result} ${version}`;
    for (const which of ['model', 'study'] as const) this.rewrite(which, adopted[which], name);
    this.looker.now();
    return { words: words.adopted(adopted.words, adopted.has_changed), isDone: true };
  }

  /** Changes of both texts as one step to undo. */
  private apply(changes: DragResult['changes'], name: string): void {
    // From the end, so that the places before stay; what is put in at one place keeps its order.
    for (const change of [...changes].reverse()) this.documents.change(change.document, change, { name, joins: 'always' });
    this.looker.now();
  }

  /** Changes links, joints or names, as one step to undo. Says why, where that cannot be. */
  async restructure(edit: Edit, name: string | null = null, poses: NamedPoses = {}): Promise<string | null> {
    const { version } = this.documents;
    const answer = await this.asked(edit, poses);
    if (typeof answer === 'string') return this.refuse(answer);
    // The texts went on meanwhile: the places of the answer are old.
    if (this.documents.version !== version) return this.restructure(edit, name, poses);
    // What no longer moves is drawn where it was left.
    this.poses = { ...this.poses, ...poses };
    this.takeOver(answer, name ?? `${edit.kind} ${version}`);
    return null;
  }

  /** Asks what goes with something; where anything does, that is shown and confirmed before. */
  async askToRemove(what: Named): Promise<string | null> {
    const { version } = this.documents;
    const answer = await this.asked({ kind: 'remove', what });
    if (typeof answer === 'string') return this.refuse(answer);
    if (this.documents.version !== version) return this.askToRemove(what);
    this.confirmed = { answer, version };
    const gone = answer.gone ?? [];
    if (gone.length > 1) this.removal = { what, gone: gone.slice(1), says: answer.says ?? [] };
    else this.confirmRemoval();
    return null;
  }

  confirmRemoval(): void {
    const { confirmed } = this;
    this.removal = null;
    this.confirmed = null;
    // Another change has come between: the question is no longer the same.
    if (!confirmed || confirmed.version !== this.documents.version) return;
    this.takeOver(confirmed.answer, `remove ${confirmed.version}`);
    this.chosen = null;
    this.part = null;
  }

  /** What a joint or a body is looked at; null puts it away. */
  choose(what: Named | null): void {
    this.chosen = what?.table === 'joint' ? what.name : null;
    this.part = what && what.table !== 'joint' ? what : null;
  }

  private async asked(edit: Edit, poses: NamedPoses = {}): Promise<RestructureAnswer | string> {
    const { documents } = this;
    const model = documents.textOf('model');
    if (!model) return words.editor.noModel;
    const body = { model, study: documents.textOf('study'), edit, poses: { ...this.poses, ...poses } } satisfies RestructureRequest;
    try {
      const answer = await ask<RestructureAnswer>('POST', '/api/restructure', body);
      return answer.refusal ? [answer.refusal.message, answer.refusal.hint].filter(Boolean).join(': ') : answer;
    } catch (error) {
      return messageOf(error);
    }
  }

  private refuse(words: string): string {
    this.built = { words: [words], isRefused: true, name: null };
    return words;
  }

  private takeOver(answer: RestructureAnswer, name: string): void {
    this.poses = { ...this.poses, ...(answer.poses ?? {}) };
    this.apply(answer.changes ?? [], name);
    this.built = { words: answer.says ?? [], isRefused: false, name: answer.name ?? null };
  }

  /** Remembers where the bodies are at the start. */
  private keepPoses(view: View): void {
    const motion = view.drawing?.motion;
    const first = motion?.angle_deg[0];
    if (!motion || first == null) return;
    const poses = posesAt(motion, first);
    const named = view.outline.parts.flatMap(({ name }, body) => {
      const pose = poses[body];
      return pose ? [[name, pose] as const] : [];
    });
    this.poses = { ...this.poses, ...Object.fromEntries(named) };
    const text = this.documents.model?.text;
    if (text === undefined) return;
    // The newest last: the oldest are forgotten.
    this.posesBy.delete(text);
    this.posesBy.set(text, this.poses);
    if (this.posesBy.size > mostPoses) this.posesBy.delete(this.posesBy.keys().next().value ?? '');
  }

  /** The first error of the texts as they are now; null where there is none, or where the server does not say in time. */
  async firstError(): Promise<DiagnosticView | null> {
    if (this.checked !== this.documents.version) {
      this.looker.now();
      await new Promise<void>((resolve) => {
        this.waiting.push(resolve);
        window.setTimeout(resolve, checkPatienceMs);
      });
    }
    if (this.checked !== this.documents.version) return null;
    return this.diagnostics.find(({ severity }) => severity === 'error') ?? null;
  }

  private check(version: number): void {
    this.checked = version;
    if (version !== this.documents.version) return;
    this.waiting.forEach((resolve) => resolve());
    this.waiting = [];
  }

  show(document: Document, from: number, to: number): void {
    this.reveal = { document, from, to };
  }

  /** Where a table begins, such as `[joint.gudgeon]`. */
  showTable(table: string, name: string): void {
    const text = this.documents.model?.text ?? '';
    const pattern = new RegExp('^[ \\t]*\\[' + table + '\\.["\']?' + name.replace(/[^\w]/g, '\\$&') + '["\']?\\]', 'm');
    const found = pattern.exec(text);
    if (found) this.show('model', found.index, found.index + found[0].length);
  }

  /** Where the bodies of a model were last; a step to undo takes them back too. */
  private posesOf(model: string): NamedPoses {
    return this.posesBy.get(model) ?? this.poses;
  }

  private look() {
    const { drag } = this;
    const { version } = this.documents;
    const wanted = { curve: chosenCurve.key, traced: this.traced };
    if (drag) return { look: { ...drag.base, grip: drag.grip, poses: this.posesOf(drag.base.model.text), ...wanted }, version };
    const model = this.documents.textOf('model');
    if (!model) return null;
    return { look: { model, study: this.documents.textOf('study'), grip: null, poses: this.posesOf(model.text), ...wanted }, version };
  }

  private leaveRest(): void {
    if (this.rest) cancelAnimationFrame(this.rest.frame);
    this.rest = null;
  }

  private hear(seen: LookAnswer, version: number, isFinest: boolean): void {
    const { drag, rest } = this;
    this.leaveRest();
    // An answer that brings nothing new does not replace what the one before it left to do.
    if (seen.is_cut || seen.view === null || seen.reshaped?.refusal) rest?.takeIn();
    this.isCut = seen.is_cut;
    if (seen.is_cut) {
      // Nothing is known of these texts: what was seen last stays, and is of other ones unless they were looked at before.
      this.isStale = this.viewed !== version;
      if (drag?.isEnding) this.drag = null;
      this.answers += 1;
      return;
    }
    // The answer to a drag that is over.
    if (seen.reshaped && !drag) return;
    if (seen.reshaped && drag && !drag.isEnding && seen.view) {
      this.showCanvas(seen.view, seen.reshaped.angle_deg ?? null);
      const takeIn = (): void => {
        this.rest = null;
        if (this.drag === drag) this.takeIn(seen, version, isFinest, false);
      };
      this.rest = { frame: requestAnimationFrame(takeIn), takeIn };
    } else this.takeIn(seen, version, isFinest, true);
  }

  private takeIn(seen: LookAnswer, version: number, isFinest: boolean, mayEnd: boolean): void {
    const { documents, drag } = this;
    if (seen.reshaped && drag) {
      this.follow(drag, seen.reshaped, mayEnd);
      // Places are in the texts as they are now.
      version = documents.version;
    }
    this.isSettled = isFinest && version === documents.version;
    this.diagnostics = seen.diagnostics.map((diagnostic) => {
      const { document, from, to } = diagnostic;
      const fix = diagnostic.fix && documents.moved(diagnostic.fix.document, diagnostic.fix, version);
      if (document === null || from == null || to == null) return { ...diagnostic, fix };
      return { ...documents.moved(document, { ...diagnostic, from, to }, version), fix };
    });
    // These are not tried until they can be read.
    if (seen.view === null || seen.view.incomplete !== null || this.diagnostics.some(({ severity }) => severity === 'error')) this.obstacles = [];
    this.check(version);
    this.isStale = seen.view === null;
    if (seen.view) {
      const isFirst = this.view === null;
      this.showCanvas(seen.view, seen.reshaped?.angle_deg ?? null);
      if (version === documents.version) this.build.keepTo(seen.view.outline.parts.map(({ name }) => name));
      // On an empty sheet there is nothing to do but to draw.
      if (isFirst && this.build.isEmpty) this.build.choose('link');
      this.viewed = version;
      this.panels = seen.view;
      this.limits = seen.view.limits.map((limit) => documents.moved('study', limit, version));
      this.quantities = seen.view.quantities.map((quantity) => documents.moved(quantity.document, quantity, version));
      if (version === documents.version) this.keepPoses(seen.view);
      if (this.build.isOn) {
        this.head.run(false);
        this.head.set(this.head.first);
      }
    }
    this.taken = { seq: seen.seq, version };
    this.takeObstacles();
    this.answers += 1;
  }

  /** A check may be heard before its look, and is of the texts that a drag has written with it. Of older texts it says nothing. */
  private takeObstacles(): void {
    if (this.tried === null || this.tried.seq !== this.taken?.seq) return;
    if (this.taken.version === this.documents.version) this.obstacles = this.tried.diagnostics;
    this.tried = null;
  }

  private showCanvas(view: View, angle: number | null): void {
    this.view = view;
    this.isStale = false;
    this.space = view.space && parsedSpace(view.space);
    if (view.drawing) this.head.follow(view.drawing.motion);
    else if (this.space) this.head.follow({ angle_deg: this.space.data.inputs, start: this.space.data.start }, this.space.data.is_angle);
    if (angle !== null) this.head.set(angle);
  }

  private async changed(path: string): Promise<void> {
    const which = this.documents.whichOf(path);
    if (!which || this.changedOnDisk.includes(which)) return;
    // Our own saving is told too where it crosses the server's look at the disk.
    const isSame = await this.documents.isSameOnDisk(which).catch(() => false);
    if (!isSame && !this.changedOnDisk.includes(which)) this.changedOnDisk = [...this.changedOnDisk, which];
  }
}
