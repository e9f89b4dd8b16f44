// The play head: one angle of the drive for the drawing and the band.
import { advanced, eachFrame, isMotionWelcome } from '../shell/clock.ts';
import type { Motion } from '../messages.ts';

export class Head {
  angle = $state(0);
  first = $state(0);
  last = $state(360);
  isRunning = $state(false);
  /** The input is an angle, degrees; else the time, s. */
  isAngle = $state(true);
  /** A tool is on: the mechanism stands at its start, where its text says how its loops close. */
  isLocked = false;
  private isPlaced = false;
  private stopTicks: (() => void) | null = null;

  /** Takes over the range of a motion; the angle stays where it is, as far as it is in it. */
  follow(motion: Pick<Motion, 'angle_deg' | 'start'>, isAngle = true): void {
    const angles = motion.angle_deg;
    this.isAngle = isAngle;
    this.first = angles[0] ?? 0;
    this.last = angles.at(-1) ?? 0;
    if (this.isPlaced) return this.set(this.angle);
    this.isPlaced = true;
    this.angle = angles[motion.start] ?? this.first;
    if (isMotionWelcome()) this.run(true);
  }

  set(angle: number): void {
    const [low, high] = [Math.min(this.first, this.last), Math.max(this.first, this.last)];
    this.angle = this.isLocked ? this.first : Math.min(Math.max(angle, low), high);
  }

  /** Turns by whole degrees, or hundredths of the time; past the end of a full turn it begins again. */
  step(steps: number): void {
    this.run(false);
    const [low, high] = [Math.min(this.first, this.last), Math.max(this.first, this.last)];
    if (!this.isAngle) return this.set(this.angle + steps * this.stepSize);
    const next = Math.round(this.angle) + steps;
    const isFull = high - low >= 359;
    this.set(isFull && next > high ? next - 360 : isFull && next < low ? next + 360 : next);
  }

  /** A degree, or a hundredth of the time. */
  get stepSize(): number {
    return this.isAngle ? 1 : Math.abs(this.last - this.first) / 100;
  }

  run(isRunning: boolean): void {
    this.stopTicks?.();
    this.stopTicks = null;
    this.isRunning = isRunning && !this.isLocked && this.first !== this.last;
    if (this.isRunning) {
      this.stopTicks = eachFrame((seconds) => {
        this.angle = advanced(this.angle, this.first, this.last, seconds, this.isAngle ? undefined : 1);
      });
    }
  }
}
