import type { Laboratory, Look } from '../wasm/cogmap_wasm';
import type { View } from './protocol';

/** Painting may take this share of the time; the rest is the run's. */
const PAINTING_SHARE = 0.4;
/** Side of one view in a saved picture, in pixels of which each is `density` pixels of the file. */
const PICTURE = { side: 900, density: 2 };

interface Sheet {
  canvas: OffscreenCanvas;
  context: OffscreenCanvasRenderingContext2D;
}

interface Size {
  width: number;
  height: number;
}

/** Holds the canvases of the views and paints on them. */
export class Easel {
  look: Look = 'light';
  /** Whether the canvases show something older than the run. */
  stale = true;
  private readonly sheets = new Map<View, Sheet>();
  private readonly sizes = new Map<View, Size>();
  private density = 1;
  private rested = 0;

  /** Takes over the canvas of a view that has come to the page. */
  take(view: View, canvas: OffscreenCanvas): void {
    this.sheets.set(view, sheet(canvas));
  }

  /** Lets go of the canvas of a view that has left the page. */
  release(view: View): void {
    this.sheets.delete(view);
    this.sizes.delete(view);
  }

  /** The views on the page, in pixels of the page. */
  get views(): Iterable<[View, Size]> {
    return this.sizes;
  }

  /** `width` and `height` in pixels of the page, of which each has `density` pixels of the screen. */
  resize(view: View, width: number, height: number, density: number): void {
    this.sizes.set(view, { width, height });
    this.density = density;
    this.stale = true;
  }

  /** Paints what is stale unless painting has had its share; returns whether nothing is stale any more. */
  paint(laboratory: Laboratory, now: number): boolean {
    if (this.stale && now >= this.rested) this.paintNow(laboratory);
    return !this.stale;
  }

  paintNow(laboratory: Laboratory): void {
    const begun = performance.now();
    if (this.paintAll(laboratory)) this.paintAll(laboratory);
    const spent = performance.now() - begun;
    this.rested = begun + spent / PAINTING_SHARE - spent;
    this.stale = false;
  }

  /** Paints every view; returns whether one of them needed more room than those before it were given. */
  private paintAll(laboratory: Laboratory): boolean {
    return this.paintOnly(laboratory, new Set(this.sheets.keys()));
  }

  /** The same with some of the views. */
  paintOnly(laboratory: Laboratory, views: Set<View>): boolean {
    let moved = false;
    for (const [view, { canvas, context }] of this.sheets) {
      if (!views.has(view)) continue;
      const size = this.sizes.get(view);
      if (size) fit(canvas, size, this.density);
      moved = laboratory.paint(view, context, this.look, this.density) || moved;
    }
    return moved;
  }

  /** The world and every memory with titles and legends, side by side. */
  async picture(laboratory: Laboratory): Promise<Blob> {
    const { side, density } = PICTURE;
    const views = 1 + laboratory.status().memories.length;
    const canvas = new OffscreenCanvas(views * side * density, side * density);
    laboratory.picture(sheet(canvas).context, this.look, side, density);
    return canvas.convertToBlob({ type: 'image/png' });
  }
}

/** Gives a canvas its size just before it is painted: a new size empties it, and nobody shall see it empty. */
function fit(canvas: OffscreenCanvas, size: Size, density: number): void {
  const [width, height] = [size.width, size.height].map((pixels) => Math.max(1, Math.round(pixels * density)));
  if (width !== undefined && canvas.width !== width) canvas.width = width;
  if (height !== undefined && canvas.height !== height) canvas.height = height;
}

function sheet(canvas: OffscreenCanvas): Sheet {
  const context = canvas.getContext('2d');
  if (!context) throw new Error('This browser cannot draw off the main thread.');
  return { canvas, context };
}
