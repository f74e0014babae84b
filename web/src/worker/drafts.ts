import { expose } from 'comlink';
import { Laboratory, type Checked, type Draft, type Frame, type Look } from '../wasm/cogmap_wasm';
import * as engine from './engine';

/** The drawing-room: paints and checks buildings that are being drawn, off the page's main thread. */
export class Drafts {
  private canvas: OffscreenCanvas | undefined;
  private context: OffscreenCanvasRenderingContext2D | undefined;

  /** Loads the engine. */
  async begin(): Promise<void> {
    await engine.begin();
  }

  /** Takes over the canvas of the sheet. */
  mount(canvas: OffscreenCanvas): void {
    this.canvas = canvas;
    this.context = canvas.getContext('2d') ?? undefined;
  }

  blank(name: string): Draft {
    return Laboratory.blank(name);
  }

  /** The building of a world file, whether or not it can be driven in. */
  read(text: string, file: string): Draft {
    return Laboratory.draft(text, file);
  }

  /** What is wrong with a building, and its file. */
  check(draft: Draft): Checked {
    return Laboratory.check(draft);
  }

  paint(draft: Draft, look: Look, frame: Frame): void {
    const { canvas, context } = this;
    if (!canvas || !context) return;
    const [width, height] = [frame.width, frame.height].map((side) => Math.max(1, Math.round(side * frame.density)));
    if (canvas.width !== width) canvas.width = width ?? 1;
    if (canvas.height !== height) canvas.height = height ?? 1;
    Laboratory.paint_draft(draft, context, look, frame);
  }
}

expose(new Drafts());
