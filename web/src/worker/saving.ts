import type { Laboratory } from '../wasm/cogmap_wasm';
import type { Moment, Saved } from './protocol';

/** What a laboratory writes, as a file whose name is the run's and this ending. */
export function asText(laboratory: Laboratory, ending: string, type: string, text: string): Saved {
  return { name: `${laboratory.status().stem}.${ending}`, blob: new Blob([text], { type }) };
}

/** Every text file of a run, with the drawing and the table, in one archive. */
export async function archive(laboratory: Laboratory, drawing: Saved): Promise<Saved> {
  const { strToU8, zipSync } = await import('fflate');
  const { stem } = laboratory.status();
  const files = laboratory.text_files().map(({ name, text }) => [`${stem}/${name}`, strToU8(text)] as const);
  const drawn = [`${stem}/views.svg`, new Uint8Array(await drawing.blob.arrayBuffer())] as const;
  const zip = zipSync(Object.fromEntries([...files, drawn]));
  return { name: `${stem}.zip`, blob: new Blob([zip], { type: 'application/zip' }) };
}

/** What is to be kept of a run at this moment. */
export function momentOf(laboratory: Laboratory): Moment {
  const { name, time, source } = laboratory.status();
  return { situation: laboratory.situation(), name, time, fromLog: source === 'log' };
}
