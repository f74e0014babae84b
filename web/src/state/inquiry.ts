/** Asks a question over and over, though not too often, and takes in the answers. */
export class Inquiry<Answer> {
  private asked = -Infinity;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** The question that is not answered yet; a new worker will never answer those to an old one. */
  private asking: symbol | undefined;
  private stale = false;

  /** At least `interval` milliseconds lie between two questions; `wanted` says whether anybody still wants to know. */
  constructor(
    private readonly interval: number,
    private readonly ask: () => Promise<Answer>,
    private readonly take: (answer: Answer) => void,
    private readonly wanted: () => boolean,
  ) {}

  /** Asks for what is new as soon as it is time to. */
  refresh(): void {
    this.stale = true;
    if (this.asking || this.timer !== undefined) return;
    this.timer = setTimeout(() => void this.answer(), Math.max(0, this.asked + this.interval - performance.now()));
  }

  /** Asks another worker. */
  renew(): void {
    this.asking = undefined;
    this.refresh();
  }

  private async answer(): Promise<void> {
    this.timer = undefined;
    this.stale = false;
    this.asked = performance.now();
    const asking = (this.asking = Symbol('asking'));
    const told = await this.ask();
    if (this.asking !== asking) return;
    this.asking = undefined;
    this.take(told);
    if (this.stale && this.wanted()) this.refresh();
  }
}
