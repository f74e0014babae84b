import type { Laboratory } from '../wasm/cogmap_wasm';
import type { Moment, Saved } from './protocol';

/** What a laboratory writes, as a file of some kind that is called after the run. */
export function asJson(laboratory: Laboratory, kind: string, write: (laboratory: Laboratory) => string): Saved {
  const blob = new Blob([write(laboratory)], { type: 'application/json' });
  return { name: `${laboratory.status().stem}.${kind}.json`, blob };
}

/** What is to be kept of a run at this moment. */
export function momentOf(laboratory: Laboratory): Moment {
  const { name, time, source } = laboratory.status();
  return { situation: laboratory.situation(), name, time, fromLog: source === 'log' };
}
