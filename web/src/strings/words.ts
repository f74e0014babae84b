import type { Clause } from '../wasm/cogmap_wasm';
import { locale } from './locale.svelte';
import { fixed } from './rounding';

/** What stands between a whole number and its digits behind the point. */
const point = (): string => (locale.tag === 'en' ? '.' : ',');

/** For long numbers alone: the first one takes the browser as long as a part of the page. */
let grouping: Intl.NumberFormat | undefined;

/** A number with so many digits behind the point. */
export const number = (value: number, digits: number): string => fixed(value, digits).replace('.', point());

/** A number with no more digits than it needs, two at most. */
export const plain = (value: number): string => String(Number(fixed(value, 2))).replace('.', point());

/** A whole number, its thousands set apart. */
export function whole(value: number): string {
  if (Math.abs(value) < 999.5) return fixed(value, 0);
  if (grouping?.resolvedOptions().locale !== locale.tag) {
    grouping = new Intl.NumberFormat(locale.tag, { maximumFractionDigits: 0 });
  }
  return grouping.format(value);
}

/** The engine's reason for something: in the words of a catalogue, or in its own. */
export function said(clauses: Clause[], reasons: Record<string, string> = {}): string {
  return clauses.map(({ pattern, numbers }) => filled(reasons[pattern] ?? pattern, numbers)).join('; ');
}

/** A sentence, as it begins after a colon where that takes a capital. */
export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

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
