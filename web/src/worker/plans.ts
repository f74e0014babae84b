import { expose } from 'comlink';
import { FloorPlan, type PlanReport } from '../wasm/cogmap_wasm';
import * as engine from './engine';
import type { Brought } from './protocol';

/** Pixels to a side that are shown of a floor plan at most. */
const SHOWN = 1200;

/** A floor plan as the page shows it. */
export interface Pictured {
  /** Of the file, pixels. */
  width: number;
  height: number;
  /** Pixels in a row of what is shown. */
  columns: number;
  /** From 0, black, to 255, row by row. */
  shades: Uint8Array;
}

/** Looks at a floor plan whose scale is not known yet. It has a worker of its own, so that the run does not wait. */
export class Plans {
  private plan: FloorPlan | undefined;

  async look({ name, bytes }: Brought): Promise<Pictured> {
    await engine.begin();
    this.plan = new FloorPlan(name, bytes, SHOWN);
    const { width, height, columns, shades } = this.plan;
    return { width, height, columns, shades };
  }

  /** What becomes of it where a pixel is so many metres; throws what speaks against it. */
  measure(resolution: number): PlanReport | undefined {
    return this.plan?.measure(resolution);
  }
}

expose(new Plans());
