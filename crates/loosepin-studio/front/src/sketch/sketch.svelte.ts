// A mechanism that is drawn from nothing: pins and links, with undo. The server makes a model of it.
import type { DrawnPin } from '../messages.ts';

export interface Drawn {
  pins: DrawnPin[];
  /** The pins of each link. */
  links: number[][];
  motor: number | null;
}

const empty: Drawn = { pins: [], links: [], motor: null };
const mostKept = 200;
/** Where a drawing is kept over a reload of the page, until a model is made of it. */
const storageKey = 'loosepin-sketch';

interface KeptSketch {
  name: string;
  drawn: Drawn;
  past: Drawn[];
  future: Drawn[];
}

/** Without a pin; what loses too many of its pins goes too. */
function withoutPin(drawn: Drawn, pin: number): Drawn {
  const after = (index: number): number => (index > pin ? index - 1 : index);
  const links = drawn.links.map((link) => link.filter((one) => one !== pin).map(after)).filter((link) => link.length > 1);
  const motor = drawn.motor === null || drawn.motor === pin ? null : after(drawn.motor);
  return { pins: drawn.pins.filter((_, index) => index !== pin), links, motor };
}

export class Sketch {
  drawn = $state.raw<Drawn>(empty);
  canUndo = $state(false);
  canRedo = $state(false);
  /** Counts the times at which pins or links went: their numbers are others since. */
  losses = $state(0);
  private past: Drawn[] = [];
  private future: Drawn[] = [];

  constructor(public name: string) {}

  /** The drawing as it was before the page was loaded again, or an empty one. */
  static restored(name: string): Sketch {
    const sketch = new Sketch(name);
    try {
      const kept = JSON.parse(sessionStorage.getItem(storageKey) ?? 'null') as KeptSketch | null;
      if (kept) {
        sketch.name = kept.name;
        [sketch.past, sketch.future] = [kept.past, kept.future];
        sketch.show(kept.drawn);
      }
    } catch {
      // Without storage, or with one that holds something else, a drawing begins empty.
    }
    return sketch;
  }

  keep(): void {
    const { name, drawn, past, future } = this;
    try {
      sessionStorage.setItem(storageKey, JSON.stringify({ name, drawn, past, future } satisfies KeptSketch));
    } catch {
      // A full storage, or none: the drawing lives as long as the page.
    }
  }

  /** A model was made of it. */
  static forget(): void {
    try {
      sessionStorage.removeItem(storageKey);
    } catch {
      // None was kept.
    }
  }

  /** One step that can be undone. */
  change(drawn: Drawn): void {
    this.past.push(this.drawn);
    if (this.past.length > mostKept) this.past.shift();
    this.future = [];
    this.show(drawn);
  }

  undo(): void {
    const before = this.past.pop();
    if (!before) return;
    this.future.push(this.drawn);
    this.show(before);
  }

  redo(): void {
    const after = this.future.pop();
    if (!after) return;
    this.past.push(this.drawn);
    this.show(after);
  }

  private show(drawn: Drawn): void {
    if (drawn.pins.length < this.drawn.pins.length || drawn.links.length < this.drawn.links.length) this.losses += 1;
    this.drawn = drawn;
    this.canUndo = this.past.length > 0;
    this.canRedo = this.future.length > 0;
  }

  addPin(pin: DrawnPin): number {
    this.change({ ...this.drawn, pins: [...this.drawn.pins, pin] });
    return this.drawn.pins.length - 1;
  }

  addLink(from: number, to: number): void {
    if (from === to || !this.drawn.pins[from] || !this.drawn.pins[to] || this.drawn.links.some((link) => link.length === 2 && link.includes(from) && link.includes(to))) return;
    this.change({ ...this.drawn, links: [...this.drawn.links, [from, to]] });
  }

  /** A link and its new end, as one step. */
  addLinkTo(from: number, pin: DrawnPin): void {
    const { pins, links } = this.drawn;
    if (pins[from]) this.change({ ...this.drawn, pins: [...pins, pin], links: [...links, [from, pins.length]] });
  }

  /** A further pin of a link, which becomes a plate. */
  addToLink(link: number, pin: number | DrawnPin): void {
    const { pins, links } = this.drawn;
    const index = typeof pin === 'number' ? pin : pins.length;
    if (links[link]?.includes(index)) return;
    const grown = links.map((one, place) => (place === link ? [...one, index] : one));
    this.change({ ...this.drawn, pins: typeof pin === 'number' ? pins : [...pins, pin], links: grown });
  }

  setPin(pin: number, part: Partial<DrawnPin>): void {
    this.change(this.withPin(pin, part));
  }

  /** While it is dragged: the step was made where the drag began. */
  movePin(pin: number, x: number, y: number): void {
    this.show(this.withPin(pin, { x, y }));
  }

  /** The step that a drag is. */
  begin(): void {
    this.change(this.drawn);
  }

  setMotor(motor: number | null): void {
    this.change({ ...this.drawn, motor });
  }

  removePin(pin: number): void {
    this.change(withoutPin(this.drawn, pin));
  }

  removeLink(link: number): void {
    this.change({ ...this.drawn, links: this.drawn.links.filter((_, index) => index !== link) });
  }

  private withPin(pin: number, part: Partial<DrawnPin>): Drawn {
    return { ...this.drawn, pins: this.drawn.pins.map((one, index) => (index === pin ? { ...one, ...part } : one)) };
  }
}
