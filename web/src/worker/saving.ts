import type { Laboratory, Look } from '../wasm/cogmap_wasm';
import type { Moment, Saved } from './protocol';

const JSON_TYPE = 'application/json';

/** The whole session as a file. */
export function sessionOf(laboratory: Laboratory): Saved {
  return asText(laboratory, 'session.json', JSON_TYPE, laboratory.save_session());
}

/** The map of one of the mappers, counted from 0, as a file. */
export function mapOf(laboratory: Laboratory, mapper: number): Saved {
  const { memories } = laboratory.status();
  const kind = memories.length > 1 ? `map.${memories[mapper]?.mapper}` : 'map';
  return asText(laboratory, `${kind}.json`, JSON_TYPE, laboratory.map_json(mapper));
}

/** The world and every memory as one drawing. */
export function drawingOf(laboratory: Laboratory, look: Look): Saved {
  return asText(laboratory, 'svg', 'image/svg+xml', laboratory.drawing(look));
}

/** Where the robot was and where each mapper believed it to be, as a table. */
export function tableOf(laboratory: Laboratory): Saved {
  return asText(laboratory, 'csv', 'text/csv', laboratory.table());
}

/** What a laboratory writes, as a file whose name is the run's and this ending. */
function asText(laboratory: Laboratory, ending: string, type: string, text: string): Saved {
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
