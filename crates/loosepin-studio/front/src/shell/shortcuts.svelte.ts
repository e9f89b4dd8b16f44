// Keys of one letter: they can be switched off, since speech input may type them by accident.

const storedKey = 'loosepin-single-keys';

class Shortcuts {
  isOn = $state(localStorage.getItem(storedKey) !== 'off');

  set(isOn: boolean): void {
    this.isOn = isOn;
    localStorage.setItem(storedKey, isOn ? 'on' : 'off');
  }

  /** Whether this key is meant for the page, not for what has the focus. */
  takes(event: KeyboardEvent): boolean {
    if (!this.isOn || event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return false;
    const target = event.target instanceof Element ? event.target : null;
    if (target?.closest('input:not([type="range"]), textarea, select, [contenteditable="true"]')) return false;
    // Space presses what has the focus.
    return !(event.key === ' ' && target?.closest('button, a, summary, input'));
  }
}

export const shortcuts = new Shortcuts();
