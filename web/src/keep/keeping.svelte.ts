import { strings } from '../strings';
import type { Lab } from '../state/lab.svelte';
import type { Moment } from '../worker/protocol';
import { runShelf, type KeptRun } from './runs';
import type { Left, Shelf } from './shelf';

/** A worker that ends so soon after it was replaced, milliseconds, is ended by the run itself. */
const SOON = 20_000;

/** Sees to it that no run is lost: keeps it as it grows, offers it again, takes it up after a crash. */
export class Keeping {
  /** What is offered again. */
  offer = $state.raw<Left<KeptRun>>();
  /** The run at hand as it was kept last. */
  private latest: KeptRun | undefined;
  private recoveredAt = -Infinity;
  private readonly shelf: Shelf<KeptRun> | undefined;

  /** `lasting`: whether the browser keeps the run beyond this visit. */
  constructor(
    private readonly lab: Lab,
    lasting: boolean,
  ) {
    this.shelf = lasting ? runShelf() : undefined;
  }

  /** Looks for a run that was left behind; older ones wait until the newest is taken up or thrown away. */
  async begin(): Promise<void> {
    this.offer = (await this.shelf?.leftBehind())?.[0];
  }

  /** Keeps the run at hand. */
  keep({ fromLog, ...moment }: Moment): void {
    const log = fromLog ? this.lab.files.at(-1) : undefined;
    const kept = { ...moment, when: Date.now() };
    this.latest = log ? { ...kept, log } : kept;
    void this.shelf?.keep(this.latest);
  }

  /** Goes on with the run that was left behind. */
  takeUp = async (): Promise<void> => {
    if (!this.offer) return;
    const { offer: offered, latest: before } = this;
    this.offer = undefined;
    try {
      await this.lab.resume({ ...offered, name: strings.kept.name });
      this.shelf?.takeOver(offered.visit);
      // It was kept under this visit's name before that, or will be in a moment.
      if (this.latest && this.latest !== before) void this.shelf?.keep(this.latest);
    } catch (error) {
      this.lab.refusal = strings.kept.refused(error instanceof Error ? error.message : String(error));
    }
  };

  dismiss = (): void => {
    if (this.offer) void this.shelf?.discard(this.offer.visit);
    this.offer = undefined;
  };

  /** After a crash: takes the run up again, unless it is the run that brings the worker down. */
  async recover(): Promise<void> {
    const again = performance.now() - this.recoveredAt < SOON;
    this.recoveredAt = performance.now();
    const run = again ? undefined : this.latest;
    try {
      if (run) await this.lab.resume({ ...run, name: strings.kept.name });
      else await this.lab.start();
      this.lab.refusal = run ? strings.kept.recovered : strings.kept.startedOver;
    } catch (error) {
      this.lab.refusal = strings.kept.refused(error instanceof Error ? error.message : String(error));
    }
  }
}
