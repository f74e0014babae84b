import type { Lab } from './lab.svelte';

/** A deflection below this share means nothing: no stick rests exactly in its middle. */
const DEAD = 0.15;
/** So many steps are told apart from the middle to the rim … */
const STEPS = 8;
/** … and so many milliseconds lie between two orders at least: a run remembers every one of them. */
const INTERVAL = 100;

/** A stick that is pushed, on the screen or on a gamepad, and what that tells the robot. */
export class Stick {
  private wanted = { ahead: 0, left: 0 };
  private told = this.wanted;
  private pause: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly lab: Pick<Lab, 'order'>) {}

  /** Pushed so far, from −1, back or right, to 1, ahead or left. */
  point(ahead: number, left: number): void {
    const pushed = this.isPushed(ahead, left);
    this.wanted = pushed ? { ahead: stepped(ahead), left: stepped(left) } : { ahead: 0, left: 0 };
    if (pushed && this.pause !== undefined) return;
    clearTimeout(this.pause);
    this.pause = undefined;
    this.tell();
  }

  /** Whether that is a push. */
  isPushed(ahead: number, left: number): boolean {
    return Math.hypot(ahead, left) >= DEAD;
  }

  /** Let go. */
  release(): void {
    this.point(0, 0);
  }

  private tell(): void {
    const { ahead, left } = this.wanted;
    if (ahead === this.told.ahead && left === this.told.left) return;
    this.told = this.wanted;
    this.lab.order(ahead === 0 && left === 0 ? { kind: 'stop' } : { kind: 'steer', ahead, left });
    this.pause = setTimeout(() => {
      this.pause = undefined;
      this.tell();
    }, INTERVAL);
  }
}

function stepped(share: number): number {
  return Math.round(Math.max(-1, Math.min(1, share)) * STEPS) / STEPS;
}
