/** Metres a pixel that robots' maps mostly have. */
const USUAL = 0.05;
/** A building is hardly shorter or longer than this, metres. */
const [SHORT, LONG] = [6, 250];
/** How long a building may be taken to be of which nothing is known, metres. */
const LIKELY = 30;

/** A point of a picture, in its pixels from the upper left corner. */
export interface Point {
  x: number;
  y: number;
}

/** The scale to begin with: the usual one, or a round one that makes a building of a likely length. */
export function suggested(width: number, height: number): number {
  const longest = Math.max(width, height);
  if (longest * USUAL >= SHORT && longest * USUAL <= LONG) return USUAL;
  const exact = LIKELY / longest;
  const power = 10 ** Math.floor(Math.log10(exact));
  const digit = [5, 2, 1].find((digit) => digit * power <= exact) ?? 1;
  return rounded(digit * power);
}

/** How far two points are from each other, pixels. */
export const apart = (one: Point, other: Point): number => Math.hypot(one.x - other.x, one.y - other.y);

/** A number as exactly as people write it. */
export const rounded = (value: number): number => Number(value.toPrecision(4));
