import type { Lab } from './lab.svelte';

/** The four things that a person holds down to drive. */
export type Direction = 'ahead' | 'back' | 'left' | 'right';

/** Which directions are held down, by keys or by buttons, and what that tells the robot. */
export class Held {
  private held = $state<readonly Direction[]>([]);

  constructor(private readonly lab: Lab) {}

  has(direction: Direction): boolean {
    return this.held.includes(direction);
  }

  press(direction: Direction): void {
    if (this.has(direction)) return;
    this.held = [...this.held, direction];
    this.steer();
  }

  release(direction: Direction): void {
    if (!this.has(direction)) return;
    this.held = this.held.filter((other) => other !== direction);
    this.steer();
  }

  /** Lets go of everything: the window lost its keyboard, or somebody said stop. */
  releaseAll(): void {
    if (this.held.length === 0) return;
    this.held = [];
    this.steer();
  }

  private steer(): void {
    const value = (plus: Direction, minus: Direction): number =>
      Number(this.has(plus)) - Number(this.has(minus));
    const [ahead, left] = [value('ahead', 'back'), value('left', 'right')];
    if (this.held.length === 0) this.lab.order({ kind: 'stop' });
    else this.lab.order({ kind: 'steer', ahead, left });
  }
}
