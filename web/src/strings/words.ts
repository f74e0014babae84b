import type { Clause } from '../wasm/cogmap_wasm';
import { locale } from './locale.svelte';

/** Making one takes a while, so each is made once. */
const formats = new Map<string, Intl.NumberFormat>();

function format(value: number, name: string, options: Intl.NumberFormatOptions): string {
  const key = `${locale.tag} ${name}`;
  let format = formats.get(key);
  if (!format) {
    format = new Intl.NumberFormat(locale.tag, options);
    formats.set(key, format);
  }
  return format.format(value);
}

/** A number with so many digits behind the point. */
export function number(value: number, digits: number): string {
  const digital = { minimumFractionDigits: digits, maximumFractionDigits: digits, useGrouping: false };
  return format(value, `${digits}`, digital);
}

/** A number with no more digits than it needs. */
export const plain = (value: number): string => format(value, 'plain', { maximumFractionDigits: 2 });

/** A whole number, its thousands set apart. */
export const whole = (value: number): string => format(value, 'whole', { maximumFractionDigits: 0 });

/** The engine's reason for something: in the words of a catalogue, or in its own. */
export function said(clauses: Clause[], reasons: Record<string, string> = {}): string {
  return clauses.map(({ pattern, numbers }) => filled(reasons[pattern] ?? pattern, numbers)).join('; ');
}

/** A pattern with the numbers, each with its decimals, in the places of its `{}`. */
function filled(pattern: string, numbers: Clause['numbers']): string {
  const [first, ...rest] = pattern.split('{}');
  const at = (k: number): string => (numbers[k] ? number(...numbers[k]) : '{}');
  return rest.reduce((text, after, k) => text + at(k) + after, first ?? '');
}

/** A moment of a run, as minutes and seconds. */
export function moment(seconds: number): string {
  return `${Math.floor(seconds / 60)}:${(seconds % 60 < 10 ? '0' : '') + number(seconds % 60, 1)}`;
}

/** A day and an hour, given in milliseconds since 1970. */
export function day(when: number): string {
  return new Date(when).toLocaleString(locale.tag, { dateStyle: 'medium', timeStyle: 'short' });
}

/** So many of something. */
export function count(number: number, one: string, many: string): string {
  return `${whole(number)} ${number === 1 ? one : many}`;
}
