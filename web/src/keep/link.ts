import { strings } from '../strings';

/** What the fragment of a link begins with: the way in which the rest is written. */
const VERSION = '1.';
/** An address longer than this is cut off by some of the programs that people send it with. */
export const LINK_MAX = 8_000;
/** No situation that fits into a link is longer than this, bytes; what claims to be is no link of ours. */
const SITUATION_MAX = 1 << 20;

/** The fragment that holds a situation: compressed, with a checksum, in letters that no program changes. */
export async function toFragment(situation: string): Promise<string> {
  const squeezed = new Blob([situation]).stream().pipeThrough(new CompressionStream('deflate'));
  const bytes = new Uint8Array(await new Response(squeezed).arrayBuffer());
  let letters = '';
  for (const byte of bytes) letters += String.fromCharCode(byte);
  return VERSION + btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** Whether an address's fragment is meant to hold a situation. */
export function holdsSituation(fragment: string): boolean {
  return /^#?\d+\./.test(fragment);
}

/** The situation that a fragment holds; throws what is wrong with it, in words for people. */
export async function fromFragment(fragment: string): Promise<string> {
  const written = fragment.replace(/^#/, '');
  if (!written.startsWith(VERSION)) throw new Error(strings.link.version);
  try {
    return await unpack(written.slice(VERSION.length));
  } catch (error) {
    throw error instanceof RangeError ? new Error(strings.link.huge) : new Error(strings.link.broken);
  }
}

async function unpack(letters: string): Promise<string> {
  const plain = atob(letters.replaceAll('-', '+').replaceAll('_', '/'));
  const bytes = Uint8Array.from(plain, (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new TextDecoder('utf-8', { fatal: true }).decode(await atMost(SITUATION_MAX, stream));
}

/** Everything that comes out of a stream; stops where more comes than there may be. */
async function atMost(limit: number, stream: ReadableStream<Uint8Array>): Promise<Uint8Array> {
  const reader = stream.getReader();
  const pieces: Uint8Array[] = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > limit) {
      void reader.cancel();
      throw new RangeError('too much');
    }
    pieces.push(value);
  }
  const whole = new Uint8Array(length);
  let filled = 0;
  for (const piece of pieces) {
    whole.set(piece, filled);
    filled += piece.length;
  }
  return whole;
}
