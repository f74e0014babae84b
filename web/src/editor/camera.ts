import type { Frame } from '../wasm/cogmap_wasm';
import type { Point } from './geometry';

/** Which part of the plane a sheet shows, and how large it is. */
export type Camera = Frame;

/** The scales that make sense, pixels to the metre. */
const [SMALLEST, LARGEST] = [2, 2000];
/** A small building does not fill the sheet: at most so many pixels to the metre at first. */
const CLOSEST = 100;
/** Pixels kept free around everything, and below it for the scale bar. */
const [AROUND, BELOW] = [36, 24];
/** What an empty sheet shows, metres to each side of its middle. */
const EMPTY = 4;

export function toPixels({ center, pixels_per_metre, width, height }: Camera, [x, y]: Point): Point {
  return [width / 2 + (x - center[0]) * pixels_per_metre, height / 2 - (y - center[1]) * pixels_per_metre];
}

export function toMetres({ center, pixels_per_metre, width, height }: Camera, [x, y]: Point): Point {
  return [center[0] + (x - width / 2) / pixels_per_metre, center[1] - (y - height / 2) / pixels_per_metre];
}

/** The same with what it shows drawn along by so many pixels. */
export function panned(camera: Camera, x: number, y: number): Camera {
  const [east, north] = camera.center;
  return { ...camera, center: [east - x / camera.pixels_per_metre, north + y / camera.pixels_per_metre] };
}

/** The same nearer or farther; what lies at a pixel stays there. */
export function zoomed(camera: Camera, factor: number, pixel: Point): Camera {
  const scale = Math.min(LARGEST, Math.max(SMALLEST, camera.pixels_per_metre * factor));
  const held = toMetres(camera, pixel);
  const next = { ...camera, pixels_per_metre: scale };
  const [x, y] = toPixels(next, held);
  return panned(next, pixel[0] - x, pixel[1] - y);
}

/** The same with all points in view. */
export function fitted(camera: Camera, points: Point[]): Camera {
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const few = points.length < 2;
  const center: Point = points.length > 0 ? [(left + right) / 2, (low + high) / 2] : [0, 0];
  const [wide, tall] = few ? [2 * EMPTY, 2 * EMPTY] : [Math.max(right - left, 1), Math.max(high - low, 1)];
  const scale = Math.min((camera.width - 2 * AROUND) / wide, (camera.height - 2 * AROUND - BELOW) / tall, CLOSEST);
  const pixels_per_metre = Math.max(SMALLEST, scale);
  return { ...camera, pixels_per_metre, center: [center[0], center[1] - BELOW / 2 / pixels_per_metre] };
}

/** The same moved no farther than it takes to show a point. */
export function showing(camera: Camera, point: Point): Camera {
  const [x, y] = toPixels(camera, point);
  const into = (value: number, size: number) => Math.min(size - AROUND, Math.max(AROUND, value)) - value;
  return panned(camera, into(x, camera.width), into(y, camera.height));
}
