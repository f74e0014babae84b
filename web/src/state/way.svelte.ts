import type { Point } from '../input/gestures';
import type { Followed } from '../wasm/cogmap_wasm';

/** A way that somebody draws into the world, for the robot to follow. */
export class Way {
  /** Whether a pointer draws in the world instead of moving it. */
  open = $state(false);
  /** What is being drawn, in pixels of the view. */
  line = $state.raw<readonly Point[]>([]);
  /** What became of the line before. */
  followed = $state.raw<Followed>();

  /** `follow` sends the robot along points, x and y in turns; `begun` hears that it goes, `taken` that the tool is. */
  constructor(
    private readonly follow: (line: Float64Array) => Promise<Followed | undefined>,
    private readonly begun: () => void,
    private readonly taken: () => void,
  ) {}

  toggle = (): void => {
    this.open = !this.open;
    this.line = [];
    this.followed = undefined;
    if (this.open) this.taken();
  };

  /** Takes the line as it grows; once it is done, the robot follows it. */
  draw(line: readonly Point[], done: boolean): void {
    this.followed = undefined;
    this.line = done ? [] : line;
    if (done) void this.send(line);
  }

  private async send(line: readonly Point[]): Promise<void> {
    this.followed = await this.follow(Float64Array.from(line.flatMap(({ x, y }) => [x, y])));
    if (this.followed?.kind === 'going') this.begun();
  }
}
