import type { Remembered, Told, Walk } from '../wasm/cogmap_wasm';
import type { Target, View } from '../worker/protocol';

/** So many pixels beside a thing still mean it: with a mouse, and with a finger. */
const REACH = { fine: 7, coarse: 20 };

/** What of a memory is pointed at: by a mouse that passes, by a click or a tap, by keys, or from its text. */
export class Pointing {
  /** The view that shows it. */
  view = $state<View>();
  /** What is known about it. */
  told = $state.raw<Told>();
  /** Whether its card is to stay. */
  pinned = $state(false);
  /** Whether it has a card; what the text points at is only set off. */
  carded = $state(false);
  /** Whether keys led there, so that it is spoken. */
  walked = $state(false);
  /** Counts the questions; what is told about earlier ones comes too late. */
  private asked = 0;
  private passing: { view: View; x: number; y: number } | undefined;

  constructor(private readonly ask: (asked: number, view: View, to: Target | undefined) => Promise<Told | undefined>) {}

  /** A mouse passes over a memory; it is asked once a frame what lies there. */
  hover(view: View, x: number, y: number): void {
    if (this.pinned) return;
    if (!this.passing) requestAnimationFrame(() => void this.pass());
    this.passing = { view, x, y };
  }

  /** The mouse, the focus or the finger is no longer there. */
  leave(): void {
    this.passing = undefined;
    if (this.view && !this.pinned) this.close();
  }

  /** A click keeps the card of what lies there; beside everything it takes the card away. */
  async tap(view: View, x: number, y: number, coarse: boolean): Promise<void> {
    await this.keep(view, { x, y, reach: coarse ? REACH.coarse : REACH.fine });
  }

  /** Keeps the card of a thing. */
  async choose(view: View, thing: Remembered): Promise<void> {
    await this.keep(view, { thing });
  }

  /** Sets a thing off; a card that is to stay stays, unless this is meant to replace it by that of another thing. */
  async glance(view: View, thing: Remembered, replacing: boolean): Promise<void> {
    if (this.pinned && (!replacing || this.shows(view, thing))) return;
    this.pinned = false;
    await this.point(view, { thing }, false);
  }

  /** Goes from thing to thing by keys. */
  async walk(view: View, walk: Walk): Promise<void> {
    await this.point(view, { walk });
    this.walked = true;
  }

  pin(): void {
    this.pinned = this.told !== undefined;
  }

  close = (): void => {
    const { view } = this;
    this.passing = undefined;
    this.clear();
    if (view) void this.ask((this.asked += 1), view, undefined);
  };

  /** Takes in what is known now. */
  hear({ asked, told }: { asked: number; told: Told | undefined }): void {
    if (asked !== this.asked || !this.view) return;
    if (told) this.told = told;
    else this.clear();
  }

  private async pass(): Promise<void> {
    const { passing } = this;
    this.passing = undefined;
    if (passing && !this.pinned) await this.point(passing.view, { ...passing, reach: REACH.fine });
  }

  /** Keeps what lies there, from before it is known: what passes under a mouse that stands still does not come between. */
  private async keep(view: View, to: Target): Promise<void> {
    this.pinned = true;
    await this.point(view, to);
  }

  private async point(view: View, to: Target, carded = true): Promise<void> {
    const asked = (this.asked += 1);
    const told = await this.ask(asked, view, to);
    if (asked !== this.asked) return;
    if (!told) return this.clear();
    this.view = view;
    this.told = told;
    this.carded = carded;
    this.walked = false;
  }

  private shows(view: View, { kind, number }: Remembered): boolean {
    return this.view === view && this.told?.thing.kind === kind && this.told.thing.number === number;
  }

  private clear(): void {
    this.view = undefined;
    this.told = undefined;
    this.pinned = false;
    this.walked = false;
  }
}
