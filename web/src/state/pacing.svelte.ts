import type { Pace } from '../worker/protocol';

/** Speeds to choose from. */
export const PACES: Pace[] = [1, 2, 4, 8, 16, 32, 'full'];

/** How fast a run is played. */
export class Pacing {
  pace = $state<Pace>(2);
  /** The latest choice, until the player has heard of it. */
  private unheard: symbol | undefined;

  /** `send` tells the player, and is done once it has heard. */
  constructor(private readonly send: (pace: Pace) => Promise<void>) {}

  choose(pace: Pace): void {
    this.pace = pace;
    const choice = (this.unheard = Symbol('choice'));
    void this.send(pace).finally(() => {
      if (this.unheard === choice) this.renew();
    });
  }

  /** The next faster or slower speed. */
  shift(by: 1 | -1): void {
    const pace = PACES[PACES.indexOf(this.pace) + by];
    if (pace !== undefined) this.choose(pace);
  }

  /** Takes in what the player plays at, unless that is older than what was chosen last. */
  hear(pace: Pace): void {
    if (!this.unheard) this.pace = pace;
  }

  /** There is another player, or none that has yet to hear. */
  renew(): void {
    this.unheard = undefined;
  }
}
