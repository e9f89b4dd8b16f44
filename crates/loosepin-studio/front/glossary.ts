// The terms of the report pages with their sentences, read from its source when the page is built: they are written once.
import { readFileSync } from 'node:fs';
import type { Plugin } from 'vite';

const source = new URL('../../loosepin-report/src/words/glossary.rs', import.meta.url);
const id = 'virtual:glossary';
/** A pair of texts of Rust: `("Term", "Sentence.")`. */
const entry = /\(\s*"((?:[^"\\]|\\.)*)",\s*"((?:[^"\\]|\\[\s\S])*)",?\s*\)/g;

/** As Rust reads it: a line that ends with a backslash goes on at the next letter. */
function text(written: string): string {
  return written.replace(/\\\n\s*/g, '').replace(/\\(.)/g, '$1');
}

/** `Random input` is exported as `randomInput`. */
function nameOf(term: string): string {
  const [first = '', ...others] = term.toLowerCase().match(/[a-z]+/g) ?? [];
  return first + others.map((word) => (word[0] ?? '').toUpperCase() + word.slice(1)).join('');
}

export function glossary(): Plugin {
  return {
    name: 'glossary',
    resolveId: (asked) => (asked === id ? '\0' + id : null),
    load(asked) {
      if (asked !== '\0' + id) return null;
      this.addWatchFile(source.pathname);
      const terms = [...readFileSync(source, 'utf8').matchAll(entry)];
      if (terms.length === 0) this.error(`no terms in ${source.pathname}`);
      return terms.map(([, term = '', sentence = '']) => `export const ${nameOf(text(term))} = ${JSON.stringify(text(sentence))};`).join('\n');
    },
  };
}
