// A template or an empty sheet that is looked at and edited before anything of it is written.
import type { Document, OpenedText, TemplateTexts } from '../messages.ts';
import { Documents } from './documents.svelte.ts';
import { ask } from '../network/wire.ts';
import { words } from '../words.ts';

/** Name of the folder into which it is written, or the next one that is free; `null` is an empty sheet. */
const folderOf = (template: string | null): string => template ?? words.gallery.blank;

/** A path that no file of the folder has: the server reads no texts below it. */
export function pathOf(template: string | null): string {
  return `${template === null ? '.draw' : '.try'}/${folderOf(template)}/study.toml`;
}

export async function openUnwritten(template: string | null): Promise<Documents> {
  const texts: Record<Document, string> = await ask<TemplateTexts>('GET', template === null ? '/api/blank' : '/api/template/' + encodeURIComponent(template));
  const opened = (which: Document): OpenedText => ({
    path: pathOf(template).replace('study.toml', which + '.toml'),
    text: texts[which],
    tag: '',
    is_saved_here: false,
  });
  const place = { folder: folderOf(template), words: template === null ? words.shelf.blank : words.shelf.draft(template) };
  return new Documents(pathOf(template), { model: opened('model'), study: opened('study') }, place);
}
