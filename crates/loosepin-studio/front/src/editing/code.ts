// CodeMirror for one text. A chunk of its own: it is as large as all the rest.
import { defaultKeymap } from '@codemirror/commands';
import { StreamLanguage, bracketMatching, syntaxHighlighting } from '@codemirror/language';
import { toml } from '@codemirror/legacy-modes/mode/toml';
import { lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import { Annotation, EditorState } from '@codemirror/state';
import { EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers } from '@codemirror/view';
import { classHighlighter } from '@lezer/highlight';
import type { Change } from './history.ts';
import type { Fix, DiagnosticView } from '../messages.ts';

export interface Code {
  apply(change: Change): void;
  report(found: DiagnosticView[], mend: (fix: Fix) => void): void;
  reveal(from: number, to: number): void;
  measure(): void;
  destroy(): void;
}

interface Options {
  parent: HTMLElement;
  text: string;
  label: string;
  nonce: string;
  /** Changes in the order in which they can be applied one after the other. */
  changed: (changes: Change[]) => void;
}

const fromOutside = Annotation.define<boolean>();

const theme = EditorView.theme({
  '&': { height: '100%', color: 'var(--text)', backgroundColor: 'var(--page)', fontSize: '0.8125rem' },
  '&.cm-focused': { outline: '2px solid var(--link)', outlineOffset: '-2px' },
  '.cm-scroller': { fontFamily: 'ui-monospace, "Cascadia Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace', lineHeight: '1.55' },
  '.cm-content': { caretColor: 'var(--text)' },
  '.cm-cursor': { borderLeftColor: 'var(--text)' },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': { background: 'var(--random-fill)' },
  '.cm-gutters': { backgroundColor: 'var(--raised)', color: 'var(--quiet)', borderRight: '1px solid var(--rule)' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'var(--body-fill)' },
  '.cm-tooltip': { backgroundColor: 'var(--raised)', color: 'var(--text)', border: '1px solid var(--rule)' },
  '.cm-diagnostic': { fontFamily: 'system-ui, sans-serif', padding: '0.4rem 0.6rem' },
  '.cm-diagnostic-error': { borderLeftColor: 'var(--not-met)' },
  '.cm-diagnostic-warning': { borderLeftColor: 'var(--undecided)' },
  '.cm-diagnosticAction': { backgroundColor: 'var(--link)', color: 'var(--page)', minHeight: '24px' },
  '.cm-lintRange-error': { backgroundImage: 'none', textDecoration: 'underline wavy var(--not-met) 1.5px', textUnderlineOffset: '3px' },
  '.cm-lintRange-warning': { backgroundImage: 'none', textDecoration: 'underline dotted var(--undecided) 2px', textUnderlineOffset: '3px' },
});

function diagnosticOf(one: DiagnosticView, length: number, mend: (fix: Fix) => void): Diagnostic[] {
  if (one.from == null || one.to == null) return [];
  const from = Math.min(one.from, length);
  const { fix } = one;
  return [{
    from,
    to: Math.min(Math.max(one.to, from), length),
    severity: one.severity,
    source: one.code,
    message: [one.message, one.hint].filter(Boolean).join('\n'),
    actions: fix ? [{ name: fix.words, apply: () => mend(fix) }] : [],
  }];
}

export function codeIn({ parent, text, label, nonce, changed }: Options): Code {
  const view = new EditorView({
    parent,
    state: EditorState.create({
      doc: text,
      extensions: [
        EditorView.cspNonce.of(nonce),
        // The server counts in the text as it is on disk.
        EditorState.lineSeparator.of('\n'),
        lineNumbers(),
        // A long line goes on below: a pane beside the canvas is narrow.
        EditorView.lineWrapping,
        highlightActiveLine(),
        highlightActiveLineGutter(),
        drawSelection(),
        bracketMatching(),
        StreamLanguage.define(toml),
        syntaxHighlighting(classHighlighter),
        lintGutter(),
        keymap.of([...lintKeymap, ...defaultKeymap]),
        EditorView.contentAttributes.of({ 'aria-label': label, tabindex: '0', spellcheck: 'false', autocapitalize: 'off' }),
        theme,
        EditorView.updateListener.of((update) => {
          if (!update.docChanged || update.transactions.some((transaction) => transaction.annotation(fromOutside))) return;
          const changes: Change[] = [];
          update.changes.iterChanges((from, to, _newFrom, _newTo, inserted) => changes.push({ from, to, insert: inserted.toString() }));
          // From the end, so that none moves the place of another.
          changed(changes.reverse());
        }),
      ],
    }),
  });
  return {
    apply(change) {
      view.dispatch({ changes: change, annotations: fromOutside.of(true) });
    },
    report(found, mend) {
      const diagnostics = found.flatMap((one) => diagnosticOf(one, view.state.doc.length, mend));
      view.dispatch(setDiagnostics(view.state, diagnostics));
    },
    reveal(from, to) {
      const length = view.state.doc.length;
      const [anchor, head] = [Math.min(from, length), Math.min(to, length)];
      view.dispatch({ selection: { anchor, head }, effects: EditorView.scrollIntoView(anchor, { y: 'center' }) });
      view.focus();
    },
    measure: () => view.requestMeasure(),
    destroy: () => view.destroy(),
  };
}
