import { locale } from './locale.svelte';

const formats = new Map<string, Intl.NumberFormat>();

/** A number with so many digits behind the point. */
export function number(value: number, digits: number): string {
  const key = `${locale.tag} ${digits}`;
  let format = formats.get(key);
  if (!format) {
    format = new Intl.NumberFormat(locale.tag, {
      minimumFractionDigits: digits,
      maximumFractionDigits: digits,
      useGrouping: false,
    });
    formats.set(key, format);
  }
  return format.format(value);
}

/** A number with no more digits than it needs. */
export function plain(value: number): string {
  return value.toLocaleString(locale.tag, { maximumFractionDigits: 2 });
}

/** A whole number, its thousands set apart. */
export function whole(value: number): string {
  return value.toLocaleString(locale.tag);
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
