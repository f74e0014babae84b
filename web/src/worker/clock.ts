import type { Laboratory } from '../wasm/cogmap_wasm';
import type { Pace } from './protocol';

/** Milliseconds of computing a frame may take. */
const BUDGET = 12;
/** Milliseconds of computing before somebody else may have a word, where nothing is shown. */
const RUSH = 100;
/** Longer gaps between frames, in milliseconds, count as this much: a tab that slept does not race. */
const LONGEST_FRAME = 100;

/** Lets time pass in a run, frame by frame, for as long as there is something to do. */
export class Clock {
  private frame = 0;
  private last: number | undefined;
  /** Seconds of the run that are due but have not passed. */
  private owed = 0;

  /** `turn` is called once a frame with the milliseconds since the last; it returns whether to go on. */
  constructor(private readonly turn: (elapsed: number, now: number) => boolean) {}

  /** Sees to it that the next frame comes. */
  wake(): void {
    if (this.frame === 0) this.frame = requestAnimationFrame((now) => this.strike(now));
  }

  /** Lets a run go on by what `elapsed` milliseconds are worth; returns whether anything happened. */
  pass(laboratory: Laboratory, elapsed: number, pace: Pace): boolean {
    const deadline = performance.now() + BUDGET;
    if (pace === 'full') this.owed = Infinity;
    else this.owed = Math.min((Number.isFinite(this.owed) ? this.owed : 0) + (elapsed * pace) / 1000, pace);
    let moved = false;
    while (this.owed > 0) {
      const before = laboratory.time;
      if (!laboratory.advance()) {
        this.owed = 0;
        break;
      }
      moved = true;
      this.owed -= laboratory.time - before;
      if (performance.now() > deadline) break;
    }
    return moved;
  }

  /** Takes turn after turn for a while at once; returns whether something may be left to happen. */
  rush(turn: () => boolean): boolean {
    const deadline = performance.now() + RUSH;
    while (performance.now() < deadline) {
      if (!turn()) return false;
    }
    return true;
  }

  private strike(now: number): void {
    this.frame = 0;
    const elapsed = Math.min(now - (this.last ?? now), LONGEST_FRAME);
    this.last = now;
    if (this.turn(elapsed, now)) this.wake();
    else this.last = undefined;
  }
}
