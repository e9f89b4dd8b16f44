// A template that is looked at and edited before anything of it is written: its texts survive a reload in the storage of the tab.
import type { Document, OpenedText, TemplateTexts } from '../messages.ts';
import { Documents } from './documents.svelte.ts';
import { ask } from '../network/wire.ts';

type Texts = Record<Document, string>;

const keyOf = (template: string): string => 'loosepin-try ' + template;

/** A path that no file of the folder has: the server reads no texts below it. */
export function pathOf(template: string): string {
  return `.try/${template}/study.toml`;
}

function stored(template: string): Partial<Texts> {
  try {
    return (JSON.parse(sessionStorage.getItem(keyOf(template)) ?? '{}') ?? {}) as Partial<Texts>;
  } catch {
    return {};
  }
}

export function forget(template: string): void {
  sessionStorage.removeItem(keyOf(template));
}

function keep(template: string, documents: Documents): void {
  const [model, study] = [documents.model?.text, documents.study?.text];
  try {
    if (documents.isUnsaved) sessionStorage.setItem(keyOf(template), JSON.stringify({ model, study }));
    else forget(template);
  } catch {
    // A text that the storage does not take is lost with the tab, as any text that is not saved.
  }
}

export async function openDraft(template: string): Promise<Documents> {
  const texts: Texts = await ask<TemplateTexts>('GET', '/api/template/' + encodeURIComponent(template));
  const opened = (which: Document): OpenedText => ({
    path: pathOf(template).replace('study', which),
    text: texts[which],
    tag: '',
    is_saved_here: false,
  });
  const documents = new Documents(pathOf(template), { model: opened('model'), study: opened('study') }, template);
  const before = stored(template);
  for (const which of ['model', 'study'] as const) {
    const text = before[which];
    if (typeof text === 'string') documents.change(which, { from: 0, to: texts[which].length, insert: text }, { name: 'load', joins: 'never' });
  }
  documents.listen(() => {
    if (documents.template === template) keep(template, documents);
  });
  return documents;
}
