/**
 * A number with so many digits behind the point, as the engine writes it: one that lies just between two becomes the
 * even one, where the browser takes the one farther from zero.
 */
export function fixed(value: number, digits: number): string {
  const lower = Math.floor(value * 10 ** digits);
  const even = lower % 2 === 0 ? lower : lower + 1;
  return (liesBetween(value, digits) ? even / 10 ** digits : value).toFixed(digits);
}

/** Whether a number lies just between two with so many digits: halves, quarters and so on alone can, and are exact. */
function liesBetween(value: number, digits: number): boolean {
  return Number.isInteger(value * 2 ** (digits + 1)) && !Number.isInteger(value * 2 ** digits);
}
