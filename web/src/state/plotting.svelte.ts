import type { Curve, Plots, Schematic } from '../wasm/cogmap_wasm';
import type { Plotted, View } from '../worker/protocol';
import { Inquiry } from './inquiry';

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
  private readonly inquiry: Inquiry<{ places: View | undefined; told: Plotted | undefined }>;

  /** The mappers that know what a local space is. */
  readonly knowing = $derived<Curve[]>(this.plots?.curves.filter(({ wideness }) => wideness) ?? []);
  /** The one of them whose way and places are shown. */
  readonly shown = $derived<Curve | undefined>(this.knowing.find(({ view }) => view === this.chosen) ?? this.knowing[0]);

  /** `ask` gives the curves and, for a memory, its places; `opening` is called before the panel comes. */
  constructor(
    ask: (places: View | undefined) => Promise<Plotted | undefined>,
    private readonly opening: () => void,
  ) {
    const question = async () => {
      const places = this.page === 'places' ? (this.shown?.view ?? 'first') : undefined;
      return { places, told: await ask(places) };
    };
    const take = ({ places, told }: { places: View | undefined; told: Plotted | undefined }) => {
      this.plots = told?.plots;
      if (places) this.schematic = told?.schematic;
    };
    this.inquiry = new Inquiry(INTERVAL, question, take, () => this.open);
  }

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
  refresh = (): void => this.inquiry.refresh();

  /** Asks another worker. */
  renew = (): void => this.inquiry.renew();
}
