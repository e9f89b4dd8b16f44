// Asks the server what the texts mean: one look in flight, the newest text next, never a queue.
import type { FromPage, Look, LookAnswer } from '../messages.ts';

const patienceMs = 500;
const settledMs = 250;
/** Positions in a turn, whole degrees apart: the last ones, those of `loosepin motion`, while nothing is moved. */
const choices = [36, 72, 120, 360] as const;
const most = 360;
/** What a look may cost on the server while something is dragged. */
const budgetMs = 12;

interface Flight {
  seq: number;
  version: number;
  positions: number;
}

export class Looker {
  private seq = 0;
  private flight: Flight | null = null;
  /** The one before, where it was passed by a newer one without an answer. */
  private passed: Flight | null = null;
  private isWanted = false;
  private isFine = false;
  /** What a look in rest asks for: less where the analysis took too long. */
  private finest: number = most;
  private cost = 4;
  private positions: number = 120;
  private giveUp = 0;
  private delay = 0;
  private settle = 0;
  private asked = 0;

  constructor(
    private readonly make: () => { look: Omit<Look, 'seq' | 'positions' | 'is_at_rest'>; version: number } | null,
    private readonly send: (look: Extract<FromPage, { kind: 'look' }>) => boolean,
    private readonly hear: (seen: LookAnswer, version: number, isFinest: boolean) => void,
  ) {}

  /** At the next frame: for drags, where each frame counts. */
  now(): void {
    clearTimeout(this.delay);
    this.delay = 0;
    this.isWanted = true;
    this.isFine = false;
    this.waitUntilSettled();
    if (this.asked === 0) {
      this.asked = requestAnimationFrame(() => {
        this.asked = 0;
        this.flush();
      });
    }
  }

  /** Something newer than the last answer is to be looked at. */
  get isWaiting(): boolean {
    return this.isWanted;
  }

  /** When the typing pauses. */
  soon(ms: number): void {
    clearTimeout(this.delay);
    this.delay = window.setTimeout(() => this.now(), ms);
  }

  /** After a lost connection no answer will come. */
  again(): void {
    this.flight = null;
    this.now();
  }

  heard(seen: LookAnswer): void {
    if (seen.is_cut && seen.seq === this.passed?.seq) {
      // The newer one waits for its end: that it was stopped is all that is known yet.
      this.hear(seen, this.passed.version, false);
      this.passed = null;
      return;
    }
    if (seen.seq !== this.flight?.seq) return;
    const { version, positions } = this.flight;
    this.land();
    if (seen.is_cut) this.coarsen(positions);
    else if (positions < this.finest) this.adapt(seen.cost_ms);
    this.hear(seen, version, positions >= this.finest);
    this.flush();
  }

  stop(): void {
    clearTimeout(this.delay);
    clearTimeout(this.settle);
    clearTimeout(this.giveUp);
    cancelAnimationFrame(this.asked);
    // Who comes back looks anew: the answer to this look is for nobody.
    this.flight = null;
    this.passed = null;
    this.asked = 0;
  }

  private land(): void {
    clearTimeout(this.giveUp);
    this.flight = null;
  }

  private adapt(cost: number): void {
    this.cost += 0.3 * (cost - this.cost);
    const coarser = this.coarserThan(this.positions);
    const finer = choices.find((one) => one > this.positions && one < this.finest);
    if (this.cost > budgetMs && coarser !== undefined) this.positions = coarser;
    else if (this.cost < budgetMs / 3 && finer !== undefined) this.positions = finer;
  }

  private coarserThan(positions: number): number | undefined {
    return choices.filter((one) => one < positions).at(-1);
  }

  /** It took too long: fewer positions are tried, until there are no fewer. */
  private coarsen(positions: number): void {
    const coarser = this.coarserThan(positions);
    if (coarser === undefined) return;
    this.finest = Math.min(this.finest, coarser);
    this.positions = Math.min(this.positions, coarser);
    this.isWanted = true;
  }

  private waitUntilSettled(): void {
    clearTimeout(this.settle);
    this.settle = window.setTimeout(() => {
      this.isWanted = true;
      this.isFine = true;
      this.flush();
    }, settledMs);
  }

  private flush(): void {
    if (!this.isWanted || this.flight) return;
    const made = this.make();
    if (!made) return;
    this.seq += 1;
    const positions = this.isFine ? this.finest : Math.min(this.positions, this.finest);
    if (!this.send({ kind: 'look', seq: this.seq, positions, is_at_rest: this.isFine, ...made.look })) return;
    this.isWanted = false;
    this.flight = { seq: this.seq, version: made.version, positions };
    this.giveUp = window.setTimeout(() => {
      // The answer may still come, and is then as good as any: only a newer look may pass it.
      const late = this.flight;
      this.flight = null;
      this.flush();
      if (this.flight) this.passed = late;
      else this.flight = late;
    }, patienceMs);
  }
}
