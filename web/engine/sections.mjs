// The sections of a WebAssembly module, where Binaryen has no way to leave one out.

/** Numbers of sections, as in the binary format. */
export const DATA = 11;
export const DATA_COUNT = 12;

const HEADER = 8;

/** A module without its sections of these numbers. */
export function without(bytes, numbers) {
  const kept = [bytes.subarray(0, HEADER)];
  for (let at = HEADER; at < bytes.length; ) {
    const [size, body] = number(bytes, at + 1);
    if (!numbers.includes(bytes[at])) kept.push(bytes.subarray(at, body + size));
    at = body + size;
  }
  return Buffer.concat(kept);
}

/** An unsigned LEB128 number, and where it ends. */
function number(bytes, start) {
  let value = 0;
  for (let at = start, shift = 0; ; at += 1, shift += 7) {
    value += (bytes[at] & 0x7f) * 2 ** shift;
    if (bytes[at] < 0x80) return [value, at + 1];
  }
}
