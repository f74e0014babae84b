// How the engine's functions are called here: by their Rust names without the hashes that a new compiler or a new
// version of a crate changes. Several functions may share such a name.
import { readFileSync } from 'node:fs';

/** What a list of names calls a function that the module calls `name`. */
export const plain = (name) => name.replace(/\[[0-9a-f]{8,16}\]/g, '').replace(/::h[0-9a-f]{16}/g, '').replace(/\[\d+\]$/, '');

/** The names in a list, which has one in a line. */
export function listed(file) {
  return new Set(readFileSync(file, 'utf8').split('\n').filter((line) => line !== '' && !line.startsWith('#')));
}
