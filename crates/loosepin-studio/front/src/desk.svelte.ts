// What lies on the desk of the editor: the texts, what the server sees in them, and the play head.
import { Documents } from './documents.svelte.ts';
import type { Change, Gesture } from './history.ts';
import { Head } from './head.svelte.ts';
import { Looker } from './looker.ts';
import type { Complaint, Fix, Quantity, Seen, View, Which } from './messages.ts';
import { movedRange } from './ranges.ts';
import { session } from './session.svelte.ts';

const typingPauseMs = 150;

export interface Reveal {
  document: Which;
  from: number;
  to: number;
}

function moveAll<T extends { document: Which | null; from?: number | null; to?: number | null }>(list: T[], which: Which, change: Change): T[] {
  return list.map((item) => {
    if (item.document !== which || item.from == null || item.to == null) return item;
    return { ...item, ...movedRange({ from: item.from, to: item.to }, change) };
  });
}

export class Desk {
  readonly head = new Head();
  /** The last view of texts that could be read. */
  view = $state.raw<View | null>(null);
  complaints = $state.raw<Complaint[]>([]);
  /** Counts the answers: complaints come anew with each. */
  answers = $state(0);
  quantities = $state.raw<Quantity[]>([]);
  isStale = $state(false);
  /** The view is of the texts as they are, at the most positions. */
  isSettled = $state(false);
  output = $state<string | null>(null);
  reveal = $state.raw<Reveal | null>(null);
  changedOnDisk = $state.raw<Which[]>([]);
  band = $derived(this.view?.bands.find((band) => band.output === this.output) ?? this.view?.bands[0] ?? null);
  private readonly looker: Looker;

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
        changed: (path) => void this.changed(path),
        opened: () => this.looker.again(),
      }),
      this.documents.listen((step) => {
        this.isSettled = false;
        this.quantities = moveAll(this.quantities, step.document, step.change);
        this.complaints = moveAll(this.complaints, step.document, step.change);
        this.looker.soon(typingPauseMs);
      }),
    ];
    this.looker.now();
    return () => {
      stops.forEach((stop) => stop());
      this.looker.stop();
      this.head.run(false);
    };
  }

  /** A change whose picture is wanted at once. */
  change(document: Which, change: Change, gesture: Gesture): void {
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

  mend(fix: Fix): void {
    this.change(fix.document, { from: fix.from, to: fix.to, insert: fix.insert }, { name: 'fix', joins: 'never' });
  }

  show(document: Which, from: number, to: number): void {
    this.reveal = { document, from, to };
  }

  /** Where a table begins, such as `[joint.gudgeon]`. */
  showTable(table: string, name: string): void {
    const text = this.documents.model?.text ?? '';
    const pattern = new RegExp('^[ \\t]*\\[' + table + '\\.["\']?' + name.replace(/[^\w]/g, '\\$&') + '["\']?\\]', 'm');
    const found = pattern.exec(text);
    if (found) this.show('model', found.index, found.index + found[0].length);
  }

  private look() {
    const model = this.documents.textOf('model');
    if (!model) return null;
    const study = this.documents.textOf('study');
    return { look: { model, study, output: this.output, at_deg: null }, version: this.documents.version };
  }

  private hear(seen: Seen, version: number, isFinest: boolean): void {
    const { documents } = this;
    this.isSettled = isFinest && version === documents.version;
    this.complaints = seen.complaints.map((complaint) => {
      const { document, from, to } = complaint;
      const fix = complaint.fix && documents.moved(complaint.fix.document, complaint.fix, version);
      if (document === null || from == null || to == null) return { ...complaint, fix };
      return { ...documents.moved(document, { ...complaint, from, to }, version), fix };
    });
    this.isStale = seen.view === null;
    if (seen.view) {
      this.view = seen.view;
      this.quantities = seen.view.quantities.map((quantity) => documents.moved(quantity.document, quantity, version));
      if (seen.view.drawing) this.head.follow(seen.view.drawing.motion);
    }
    this.answers += 1;
  }

  private async changed(path: string): Promise<void> {
    const which = this.documents.whichOf(path);
    if (!which || this.changedOnDisk.includes(which)) return;
    // Our own saving is told too where it crosses the server's look at the disk.
    const isSame = await this.documents.isSameOnDisk(which).catch(() => false);
    if (!isSame && !this.changedOnDisk.includes(which)) this.changedOnDisk = [...this.changedOnDisk, which];
  }
}
