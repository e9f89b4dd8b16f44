// Every key of the studio, in one table: handlers ask it, and the list of keys shows it in the same order.

export const groups = ['canvas', 'parts', 'tools', 'texts', 'panes', 'pages'] as const;
export type KeyGroup = (typeof groups)[number];

interface Binding {
  group: KeyGroup;
  /** As events name them, with Ctrl (or Cmd) and Shift before; none where keys are held during another gesture, or belong to a field. */
  keys: readonly string[];
}

export const bindings = {
  play: { group: 'canvas', keys: [' '] },
  back: { group: 'canvas', keys: ['['] },
  forth: { group: 'canvas', keys: [']'] },
  zoomIn: { group: 'canvas', keys: ['+', '='] },
  zoomOut: { group: 'canvas', keys: ['-'] },
  fit: { group: 'canvas', keys: ['0'] },
  pan: { group: 'canvas', keys: [] },
  drag: { group: 'canvas', keys: [] },
  nudge: { group: 'parts', keys: [] },
  choose: { group: 'parts', keys: [] },
  trace: { group: 'parts', keys: ['t'] },
  remove: { group: 'parts', keys: [] },
  free: { group: 'parts', keys: [] },
  cancel: { group: 'tools', keys: ['Escape'] },
  save: { group: 'texts', keys: ['Ctrl+s'] },
  undo: { group: 'texts', keys: ['Ctrl+z'] },
  redo: { group: 'texts', keys: ['Ctrl+Shift+z', 'Ctrl+y'] },
  step: { group: 'texts', keys: [] },
  nextProblem: { group: 'texts', keys: [] },
  resize: { group: 'panes', keys: [] },
  reset: { group: 'panes', keys: [] },
  close: { group: 'panes', keys: ['Escape'] },
  help: { group: 'pages', keys: ['?'] },
  find: { group: 'pages', keys: ['/'] },
} as const satisfies Record<string, Binding>;

export type KeyName = keyof typeof bindings;

/** Whether an event is a key of this name. Shift counts where a letter is meant: signs need it on some keyboards and not on others. */
export function isKey(event: KeyboardEvent, name: KeyName): boolean {
  const isLetter = /^[a-z]$/i.test(event.key);
  const pressed = (event.ctrlKey || event.metaKey ? 'Ctrl+' : '') + (isLetter && event.shiftKey ? 'Shift+' : '') + (isLetter ? event.key.toLowerCase() : event.key);
  return (bindings[name].keys as readonly string[]).includes(pressed);
}
