import type { Moment } from './protocol';

/** Milliseconds between two times at which a run is kept because somebody did something. */
const AFTER_ORDERS = 200;
/** Milliseconds between two times at which it is kept because it grew. */
const AS_IT_GROWS = 2_000;

/** Hands out what is to be kept of a run: with every order, and now and then as it grows. */
export class Keeper {
  private hand: ((moment: Moment) => void) | undefined;
  private handedAt = -Infinity;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private timerAt = 0;
  /** Whether anybody has done anything: nobody misses the scene that the page opens on. */
  private touched = false;

  /** `write` says what is to be kept now. */
  constructor(private readonly write: () => Moment | undefined) {}

  begin(hand: (moment: Moment) => void): void {
    this.hand = hand;
  }

  /** Somebody did something: that is kept at once, or in a moment where much is done. */
  touch(): void {
    this.touched = true;
    this.due(AFTER_ORDERS);
  }

  /** The run has grown. */
  grow(): void {
    if (this.touched) this.due(AS_IT_GROWS);
  }

  /** Sees to it that the run is kept once `interval` has passed since the last time, or before. */
  private due(interval: number): void {
    const now = performance.now();
    const at = this.handedAt + interval;
    if (at <= now) this.keep();
    else if (this.timer === undefined || at < this.timerAt) {
      clearTimeout(this.timer);
      this.timerAt = at;
      this.timer = setTimeout(() => this.keep(), at - now);
    }
  }

  private keep(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const moment = this.write();
    if (!moment) return;
    this.handedAt = performance.now();
    this.hand?.(moment);
  }
}
