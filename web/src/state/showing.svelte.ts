import { transfer, type Remote } from 'comlink';
import type { Look } from '../wasm/cogmap_wasm';
import type { Bench } from '../worker/bench';
import type { Layers, LegendWords, View } from '../worker/protocol';

/** What surfaces can be coloured by. */
export const COLOURS: Layers['colours'][] = ['view', 'asr', 'age'];

/** From where memories can be looked at. */
export const STANCES: Layers['stance'][] = ['map', 'robot', 'entrance'];

/** What the world can be laid over the memories by. */
export const FITS: Layers['fit'][] = ['first_view', 'best_fit'];

/** How the views show what there is: their canvases, place and colours, and what is left out. */
export class Showing {
  /** What is shown of the memories. */
  layers = $state.raw<Layers>();
  /** Whether the world is shown beside the memories. */
  world = $state(true);
  private look: Look = 'light';
  private legend: LegendWords = {};

  constructor(private readonly bench: () => Remote<Bench>) {}

  /** Hands the canvas of a view to the worker. */
  mount(view: View, canvas: HTMLCanvasElement): void {
    const handed = canvas.transferControlToOffscreen();
    void this.bench().mount(view, transfer(handed, [handed]));
  }

  unmount(view: View): void {
    void this.bench().unmount(view);
  }

  toggleWorld = (): void => {
    this.world = !this.world;
  };

  /** Shows more or less of the memories. */
  show(change: Partial<Layers>): void {
    if (!this.layers) return;
    this.layers = { ...this.layers, ...change };
    void this.bench().show(this.layers);
  }

  /** Colours the surfaces by the next thing that there is to colour them by. */
  nextColours(): void {
    const next = COLOURS.indexOf(this.layers?.colours ?? 'view') + 1;
    this.show({ colours: COLOURS[next % COLOURS.length] ?? 'view' });
  }

  /** Looks at the memories from the next place that there is to look from. */
  nextStance(): void {
    const next = STANCES.indexOf(this.layers?.stance ?? 'map') + 1;
    this.show({ stance: STANCES[next % STANCES.length] ?? 'map' });
  }

  zoom(factor: number, view?: View, x?: number, y?: number): void {
    void this.bench().zoom(factor, view, x, y);
  }

  resize(view: View, width: number, height: number, density: number): void {
    void this.bench().resize(view, width, height, density);
  }

  drag = (x: number, y: number, view: View): void => void this.bench().drag(x, y, view);
  fit = (): void => void this.bench().fit();

  setLook(look: Look): void {
    this.look = look;
    void this.bench().setLook(look);
  }

  /** What the legends say in the language that is spoken. */
  setLegend(legend: LegendWords): void {
    this.legend = legend;
    void this.bench().setLegend(legend);
  }

  /** Shows the same on another bench. */
  renew(): void {
    this.setLook(this.look);
    this.setLegend(this.legend);
    if (this.layers) this.show(this.layers);
  }
}
