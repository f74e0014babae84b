import type { Curve, Plots } from '../../wasm/cogmap_wasm';

/** A mapper's curve laid over the moments of all: which view was its latest at each, −1 before its first. */
export interface Laid {
  curve: Curve;
  views: Int32Array;
}

/** The moments at which any of the mappers took a view. */
export interface Moments {
  /** Seconds of the run, in order. */
  times: Float64Array;
  /** Where the run stands at each. */
  positions: Float64Array;
  laid: Laid[];
}

/** Puts the views of all mappers in order. */
export function momentsOf({ curves }: Plots): Moments {
  const next = curves.map(() => 0);
  const most = curves.reduce((sum, { times }) => sum + times.length, 0);
  const [times, positions] = [new Float64Array(most), new Float64Array(most)];
  const laid = curves.map((curve) => ({ curve, views: new Int32Array(most) }));
  let count = 0;
  for (; ; count += 1) {
    const due = curves.map(({ times }, index) => times[next[index] ?? 0] ?? Infinity);
    const t = Math.min(...due);
    if (t === Infinity) break;
    times[count] = t;
    due.forEach((at, index) => {
      const taken = next[index] ?? 0;
      if (at === t) {
        positions[count] = curves[index]?.positions[taken] ?? 0;
        next[index] = taken + 1;
      }
      const views = laid[index]?.views;
      if (views) views[count] = (next[index] ?? 0) - 1;
    });
  }
  return {
    times: times.subarray(0, count),
    positions: positions.subarray(0, count),
    laid: laid.map(({ curve, views }) => ({ curve, views: views.subarray(0, count) })),
  };
}

/** What a mapper has at each moment at which it took a view; nothing at others. */
export function valuesAt({ views }: Laid, values: Float64Array): (number | null)[] {
  return Array.from(views, (view, moment) => (view < 0 || view === views[moment - 1] ? null : (values[view] ?? null)));
}

/** The index of the one that is nearest to a time, in a list that is in order. */
export function nearest(times: Float64Array, t: number): number {
  const after = firstAfter(times, t);
  if (after === 0) return 0;
  if (after === times.length) return times.length - 1;
  return (times[after] ?? 0) - t < t - (times[after - 1] ?? 0) ? after : after - 1;
}

/** The index of the last that is not later than a time, 0 where all are. */
export function latest(times: Float64Array, t: number): number {
  return Math.max(0, firstAfter(times, t) - 1);
}

function firstAfter(times: Float64Array, t: number): number {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((times[middle] ?? 0) <= t) low = middle + 1;
    else high = middle;
  }
  return low;
}
