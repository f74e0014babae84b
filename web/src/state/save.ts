import type { Saved } from '../worker/protocol';

/** How long a browser may take to fetch what it saves, milliseconds. */
const PATIENCE = 60_000;

/** Saves a file the way the browser saves downloads. */
export function save({ name, blob }: Saved): void {
  const address = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), PATIENCE);
}

/** A file with its content. */
export async function brought(file: File): Promise<{ name: string; bytes: Uint8Array<ArrayBuffer> }> {
  return { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) };
}
