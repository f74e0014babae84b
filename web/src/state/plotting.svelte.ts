import type { Curve, Plots, Schematic } from '../wasm/cogmap_wasm';
import type { Plotted, View } from '../worker/protocol';

/** The least time between two questions to the laboratory, milliseconds. */
const INTERVAL = 300;

/** The plots, and the places as a schematic: asked for only while the panel is open, and not too often. */
export class Plotting {
  open = $state(false);
  /** Which of the two is shown. */
  page = $state<'curves' | 'places'>('curves');
  plots = $state.raw<Plots>();
  schematic = $state.raw<Schematic>();
  private chosen = $state<View>();
  private asked = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** The question that is not answered yet; a new worker will never answer those to an old one. */
  private asking: symbol | undefined;
  private stale = false;

  /** The mappers that know what a local space is. */
  readonly knowing = $derived<Curve[]>(this.plots?.curves.filter(({ wideness }) => wideness) ?? []);
  /** The one of them whose way and places are shown. */
  readonly shown = $derived<Curve | undefined>(this.knowing.find(({ view }) => view === this.chosen) ?? this.knowing[0]);

  /** `ask` gives the curves and, for a memory, its places; `opening` is called before the panel comes. */
  constructor(
    private readonly ask: (places: View | undefined) => Promise<Plotted | undefined>,
    private readonly opening: () => void,
  ) {}

  toggle = (): void => {
    if (!this.open) this.opening();
    this.open = !this.open;
  };

  close = (): void => {
    this.open = false;
  };

  /** Shows the way and the places of another memory. */
  choose(view: View): void {
    this.chosen = view;
    this.refresh();
  }

  turnTo(page: 'curves' | 'places'): void {
    this.page = page;
    this.refresh();
  }

  /** Asks for what is new as soon as it is time to. */
  refresh(): void {
    this.stale = true;
    if (this.asking || this.timer !== undefined) return;
    this.timer = setTimeout(() => void this.answer(), Math.max(0, this.asked + INTERVAL - performance.now()));
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
    const places = this.page === 'places' ? (this.shown?.view ?? 'first') : undefined;
    const told = await this.ask(places);
    if (this.asking !== asking) return;
    this.asking = undefined;
    this.plots = told?.plots;
    if (places) this.schematic = told?.schematic;
    if (this.stale && this.open) this.refresh();
  }
}
