// How much of the editor each pane takes, as a share of its width or height: dragged by splitters, and remembered.
import { innerHeight, innerWidth } from 'svelte/reactivity/window';

interface Pane {
  along: 'width' | 'height';
  /** Share of a first visit, and after a double click on the splitter. */
  usual: number;
  most: number;
  /** Narrower than this it cannot be read, px. */
  leastPx: number;
}

export const panes = {
  outline: { along: 'width', usual: 0.13, most: 0.3, leastPx: 150 },
  side: { along: 'width', usual: 0.26, most: 0.5, leastPx: 270 },
  chart: { along: 'height', usual: 0.36, most: 0.75, leastPx: 90 },
  /** Of the side pane, where it shows both texts. */
  study: { along: 'height', usual: 0.5, most: 0.85, leastPx: 90 },
} satisfies Record<string, Pane>;

export type PaneName = keyof typeof panes;

const storedKey = 'loosepin-panes';

function stored(): Partial<Record<PaneName, number>> {
  try {
    const found: unknown = JSON.parse(localStorage.getItem(storedKey) ?? '{}');
    if (typeof found !== 'object' || found === null) return {};
    return Object.fromEntries(Object.entries(found).filter(([name, share]) => name in panes && typeof share === 'number' && Number.isFinite(share)));
  } catch {
    return {};
  }
}

class Shares {
  private shares = $state.raw(stored());

  /** The smallest and the largest share in this window. */
  range(name: PaneName): [number, number] {
    const { along, most, leastPx } = panes[name];
    const size = (along === 'width' ? innerWidth.current : innerHeight.current) ?? 0;
    return [size > 0 ? Math.min(leastPx / size, most) : 0, most];
  }

  of(name: PaneName): number {
    const [least, most] = this.range(name);
    return Math.min(Math.max(this.shares[name] ?? panes[name].usual, least), most);
  }

  set(name: PaneName, share: number): void {
    const [least, most] = this.range(name);
    this.keep({ ...this.shares, [name]: Math.min(Math.max(share, least), most) });
  }

  reset(name: PaneName): void {
    const { [name]: _, ...others } = this.shares;
    this.keep(others);
  }

  private keep(shares: Partial<Record<PaneName, number>>): void {
    this.shares = shares;
    localStorage.setItem(storedKey, JSON.stringify(shares));
  }
}

export const shares = new Shares();
