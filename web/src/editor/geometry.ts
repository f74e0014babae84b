/** A point of the plane, metres; x to the right, y up. */
export type Point = [number, number];
export type Line = [Point, Point];

export function distance(a: Point, b: Point): number {
  return Math.hypot(b[0] - a[0], b[1] - a[1]);
}

export function plus(a: Point, b: Point): Point {
  return [a[0] + b[0], a[1] + b[1]];
}

export function minus(a: Point, b: Point): Point {
  return [a[0] - b[0], a[1] - b[1]];
}

export function times(a: Point, factor: number): Point {
  return [a[0] * factor, a[1] * factor];
}

export function dot(a: Point, b: Point): number {
  return a[0] * b[0] + a[1] * b[1];
}

/** A point turned about the origin, degrees counter-clockwise. */
export function turned([x, y]: Point, degrees: number): Point {
  const angle = (degrees * Math.PI) / 180;
  const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
  return [x * cos - y * sin, x * sin + y * cos];
}

/** The direction from one point to another, degrees counter-clockwise from x, at least 0 and less than 360. */
export function heading(from: Point, to: Point): number {
  const degrees = (Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI;
  return (degrees + 360) % 360;
}

/** A direction of length 1; nothing where two points are one. */
export function direction(from: Point, to: Point): Point | undefined {
  const length = distance(from, to);
  return length > 1e-9 ? times(minus(to, from), 1 / length) : undefined;
}

/** A number rounded to whole steps, without the crumbs of binary fractions. */
export function rounded(value: number, step: number): number {
  return Number((Math.round(value / step) * step).toFixed(6)) + 0;
}

/** A point rounded to whole steps. */
export function onGrid([x, y]: Point, step: number): Point {
  return [rounded(x, step), rounded(y, step)];
}

/** The point of a line that is nearest to a point. */
export function nearestOn([a, b]: Line, point: Point): Point {
  const along = minus(b, a);
  const length = dot(along, along);
  const share = length > 0 ? Math.min(1, Math.max(0, dot(minus(point, a), along) / length)) : 0;
  return plus(a, times(along, share));
}

/** The lines from each point to the next; `closed` leads back to the first. */
export function lines(points: Point[], closed = false): Line[] {
  const all = closed ? [...points, ...points.slice(0, 1)] : points;
  return all.slice(1).map((to, index) => [all[index] as Point, to]);
}

/** How long a way through points is. */
export function length(points: Point[]): number {
  return lines(points).reduce((sum, [a, b]) => sum + distance(a, b), 0);
}

/** How large the area within an outline is. */
export function area(points: Point[]): number {
  return Math.abs(lines(points, true).reduce((sum, [a, b]) => sum + a[0] * b[1] - b[0] * a[1], 0)) / 2;
}

/** Whether a point lies within an outline: a ray to the right crosses it an odd number of times. */
export function isWithin([x, y]: Point, outline: Point[]): boolean {
  const crossed = ([a, b]: Line) => a[1] > y !== b[1] > y && a[0] + ((b[0] - a[0]) * (y - a[1])) / (b[1] - a[1]) > x;
  return lines(outline, true).filter(crossed).length % 2 === 1;
}
