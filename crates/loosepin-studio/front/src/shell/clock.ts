// One frame loop for everything that moves by itself.

type Tick = (seconds: number) => void;

const ticks = new Set<Tick>();
let last = 0;
let isAsked = false;

function frame(now: number): void {
  isAsked = false;
  // After a hidden tab or a long pause, go on where it stood.
  const seconds = last === 0 ? 0 : Math.min((now - last) / 1000, 0.1);
  last = ticks.size === 0 ? 0 : now;
  ticks.forEach((tick) => tick(seconds));
  request();
}

function request(): void {
  if (isAsked || ticks.size === 0) {
    if (ticks.size === 0) last = 0;
    return;
  }
  isAsked = true;
  requestAnimationFrame(frame);
}

export function eachFrame(tick: Tick): () => void {
  ticks.add(tick);
  request();
  return () => ticks.delete(tick);
}

export function isMotionWelcome(): boolean {
  return !matchMedia('(prefers-reduced-motion: reduce)').matches;
}

const secondsPerTurn = 4;

/** The angle after this time; at the end of what is drawn it begins again. Other inputs say how many turns they are. */
export function advanced(angle: number, first: number, last: number, seconds: number, wholeTurns?: number): number {
  const span = last - first;
  if (span === 0) return first;
  const turns = wholeTurns ?? Math.max(Math.abs(span) / 360, 0.05);
  const share = (angle - first) / span + seconds / secondsPerTurn / turns;
  return first + (share - Math.floor(share)) * span;
}
