// The two texts: the only truth of the editor. All edits pass through here, whoever makes them.
import type { UnsavedTexts } from './drafts.ts';
import { applied, History, type Change, type Gesture, type Step } from './history.ts';
import type { Range } from './place.ts';
import { firstFree } from '../gallery/templates.ts';
import type { Document, Draft, NewAnswer, NewRequest, OpenAnswer, OpenedText, SaveAnswer, SaveRequest, SentText } from '../messages.ts';
import { movedRange } from './ranges.ts';
import { ask } from '../network/wire.ts';

export interface Sheet {
  path: string;
  text: string;
  savedText: string;
  tag: string;
}

/** Texts of which nothing is written yet. */
export interface Unwritten {
  /** Name of the folder into which they go. */
  folder: string;
  /** What they are, in words. */
  words: string;
}

export type Listener = (step: Step, source: unknown) => void;

const mostLogged = 5000;

function sheetOf(document: OpenedText | null): Sheet | null {
  return document && { path: document.path, text: document.text, savedText: document.text, tag: document.tag };
}

export class Documents {
  /** The path by which they were opened; once they are written for the first time, the path of the study. */
  opened: string;
  /** Where they will stand, while nothing of them is written. */
  unwritten = $state.raw<Unwritten | null>(null);
  model = $state.raw<Sheet | null>(null);
  study = $state.raw<Sheet | null>(null);
  canUndo = $state(false);
  canRedo = $state(false);
  isUnsaved = $derived([this.model, this.study].some((sheet) => sheet !== null && sheet.text !== sheet.savedText));
  /** Counts the changes: a look remembers it, so that its places can be moved to where they are now. */
  version = 0;
  private log: { version: number; document: Document; change: Change }[] = [];
  private readonly history = new History();
  private readonly listeners = new Set<Listener>();

  constructor(opened: string, documents: OpenAnswer, unwritten: Unwritten | null = null) {
    this.opened = opened;
    this.unwritten = unwritten;
    this.model = sheetOf(documents.model);
    this.study = sheetOf(documents.study);
  }

  sheet(which: Document): Sheet | null {
    return which === 'model' ? this.model : this.study;
  }

  textOf(which: Document): SentText | null {
    const sheet = this.sheet(which);
    return sheet && { path: sheet.path, text: sheet.text };
  }

  whichOf(path: string): Document | null {
    if (this.model?.path === path) return 'model';
    return this.study?.path === path ? 'study' : null;
  }

  listen(listener: Listener): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  change(document: Document, change: Change, gesture: Gesture, source: unknown = null): void {
    const sheet = this.sheet(document);
    if (!sheet) return;
    const removed = sheet.text.slice(change.from, change.to);
    if (removed === change.insert) return;
    const step: Step = { document, change, removed };
    this.history.record(step, gesture, performance.now());
    this.apply(step, source);
  }

  undo(): void {
    this.history.undo().forEach((step) => this.apply(step, null));
  }

  redo(): void {
    this.history.redo().forEach((step) => this.apply(step, null));
  }

  /** Where this range of an older version is now. */
  moved<T extends Range>(document: Document, range: T, version: number): T {
    let place: Range = range;
    for (const entry of this.log) {
      if (entry.version > version && entry.document === document) place = movedRange(place, entry.change);
    }
    return { ...range, from: place.from, to: place.to };
  }

  /** The texts that are not saved, each with the tag of the file from which it began. */
  get unsaved(): UnsavedTexts {
    const texts = (['model', 'study'] as const).flatMap((which) => {
      const sheet = this.sheet(which);
      return sheet && sheet.text !== sheet.savedText ? [[which, { text: sheet.text, tag: sheet.tag }] as const] : [];
    });
    return Object.fromEntries(texts);
  }

  /** Takes unsaved texts over, as one step to undo. */
  takeDraft(draft: Draft): void {
    for (const which of ['model', 'study'] as const) {
      const [sheet, kept] = [this.sheet(which), draft[which]];
      if (sheet && kept) this.change(which, { from: 0, to: sheet.text.length, insert: kept.text }, { name: `draft ${draft.at}`, joins: 'always' });
    }
  }

  /** Whether unsaved texts began from the files as they are on the disk. */
  isOfFiles(draft: Draft): boolean {
    return (['model', 'study'] as const).every((which) => draft[which] === null || draft[which].tag === this.sheet(which)?.tag);
  }

  async save(): Promise<void> {
    if (this.unwritten !== null) return this.write(this.unwritten);
    for (const which of ['model', 'study'] as const) {
      const sheet = this.sheet(which);
      if (sheet && sheet.text !== sheet.savedText) await this.put(which, sheet.tag);
    }
  }

  /** Writes both texts for the first time, into a new folder: the one that is named, or the next one that is free. */
  private async write({ folder: name }: Unwritten): Promise<void> {
    const [model, study] = [this.model?.text ?? '', this.study?.text ?? ''];
    const written = await firstFree(name, (folder) => ask<NewAnswer>('POST', '/api/new', { folder, model, study } satisfies NewRequest));
    this.keep('model', { path: written.model, savedText: model, tag: written.model_tag });
    this.keep('study', { path: written.study, savedText: study, tag: written.study_tag });
    this.opened = written.study;
    this.unwritten = null;
  }

  /** Writes this text over whatever is on disk. */
  async overwrite(which: Document): Promise<void> {
    const onDisk = await this.onDisk(which);
    await this.put(which, onDisk?.tag ?? null);
  }

  async load(which: Document): Promise<void> {
    const onDisk = await this.onDisk(which);
    const sheet = this.sheet(which);
    if (!onDisk || !sheet) return;
    this.change(which, { from: 0, to: sheet.text.length, insert: onDisk.text }, { name: 'load', joins: 'never' });
    this.keep(which, { savedText: onDisk.text, tag: onDisk.tag });
  }

  async isSameOnDisk(which: Document): Promise<boolean> {
    return (await this.onDisk(which))?.tag === this.sheet(which)?.tag;
  }

  /** Whether what is on the disk was saved by another page of this studio. */
  async isSavedInAnotherTab(which: Document): Promise<boolean> {
    return (await this.onDisk(which))?.is_saved_here ?? false;
  }

  private async onDisk(which: Document): Promise<OpenedText | null> {
    const path = this.sheet(which)?.path ?? '';
    const opened = await ask<OpenAnswer>('GET', '/api/open?path=' + encodeURIComponent(path));
    return which === 'model' ? opened.model : opened.study;
  }

  private async put(which: Document, tag: string | null): Promise<void> {
    const sheet = this.sheet(which);
    if (!sheet) return;
    const { path, text } = sheet;
    const answer = await ask<SaveAnswer>('PUT', '/api/file', { path, text, tag } satisfies SaveRequest);
    this.keep(which, { savedText: text, tag: answer.tag });
  }

  private keep(which: Document, part: Partial<Sheet>): void {
    const sheet = this.sheet(which);
    if (!sheet) return;
    if (which === 'model') this.model = { ...sheet, ...part };
    else this.study = { ...sheet, ...part };
  }

  private apply(step: Step, source: unknown): void {
    const sheet = this.sheet(step.document);
    if (!sheet) return;
    this.version += 1;
    this.log.push({ version: this.version, document: step.document, change: step.change });
    if (this.log.length > mostLogged) this.log.splice(0, mostLogged / 2);
    this.keep(step.document, { text: applied(sheet.text, step.change) });
    this.canUndo = this.history.canUndo;
    this.canRedo = this.history.canRedo;
    this.listeners.forEach((listener) => listener(step, source));
  }
}
