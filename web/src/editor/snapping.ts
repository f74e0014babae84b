import type { Draft } from '../wasm/cogmap_wasm';
import { direction, distance, dot, minus, nearestOn, onGrid, plus, rounded, times, type Line, type Point } from './geometry';
import { edges, points } from './things';

/** The grid, metres. */
export const GRID = 0.1;
/** What is not snapped is still a whole number of these, metres. */
const FINEST = 0.001;

/** What a point was drawn to. */
export type Catch = 'corner' | 'wall' | 'angle' | 'grid';

/** A point as it is meant. */
export interface Snap {
  at: Point;
  /** What it was drawn to; nothing where it stays where it was. */
  to?: Catch;
  /** The line that it was drawn to. */
  guide?: Line;
}

/** What a point can be drawn to. */
export interface Surroundings {
  draft: Draft;
  /** The thing that is being changed, which does not draw itself. */
  except?: number | undefined;
  /** The points that were placed before, of which the last is the one that the next line begins at. */
  before: Point[];
  /** From how far a point is drawn to something, metres. */
  reach: number;
  /** Whether it is drawn to walls beside their corners. */
  walls: boolean;
}

/**
 * Where a point is meant to be: at a corner that is near, else on a wall, else at a right angle to the line
 * before, else on the grid.
 */
export function snap(raw: Point, around: Surroundings): Snap {
  return toCorner(raw, around) ?? toWall(raw, around) ?? toAngle(raw, around) ?? { at: onGrid(raw, GRID), to: 'grid' };
}

/** A point that is drawn to nothing. */
export function unsnapped(raw: Point): Snap {
  return { at: onGrid(raw, FINEST) };
}

/** The thing of some that is nearest to a point, if it is within reach. */
function nearest<T>(all: T[], where: (one: T) => Point, raw: Point, reach: number): T | undefined {
  let [found, least]: [T | undefined, number] = [undefined, reach];
  for (const one of all) {
    const away = distance(where(one), raw);
    if (away <= least) [found, least] = [one, away];
  }
  return found;
}

function toCorner(raw: Point, { draft, except, before, reach }: Surroundings): Snap | undefined {
  const others = draft.things.filter((thing, index) => index !== except && thing.kind !== 'start');
  const corners = [...others.flatMap(points), ...before.slice(0, -1)];
  const at = nearest(corners, (corner) => corner, raw, reach);
  return at && { at, to: 'corner' };
}

function toWall(raw: Point, { draft, except, walls, reach }: Surroundings): Snap | undefined {
  if (!walls) return undefined;
  const others = draft.things.filter((thing, index) => index !== except && thing.kind === 'wall');
  const guide = nearest(others.flatMap(edges), (edge) => nearestOn(edge, raw), raw, reach);
  const along = guide && direction(...guide);
  if (!along) return undefined;
  // Where the wall runs along the grid, so does the place on it.
  const [from] = guide;
  const on = (far: number) => plus(from, times(along, far));
  const near = onGrid(nearestOn(guide, raw), GRID);
  const far = dot(minus(near, from), along);
  return { at: onGrid(nearestOn(guide, on(far)), FINEST), to: 'wall', guide };
}

function toAngle(raw: Point, { before, reach }: Surroundings): Snap | undefined {
  const [last, previous] = [before.at(-1), before.at(-2)];
  if (!last || distance(last, raw) < reach) return undefined;
  const ahead = previous && direction(previous, last);
  const ways: Point[] = [[1, 0], [0, 1], ...(ahead ? [ahead, [-ahead[1], ahead[0]] as Point] : [])];
  const on = (way: Point) => plus(last, times(way, rounded(dot(minus(raw, last), way), GRID)));
  const beside = (way: Point) => Math.abs(way[0] * (raw[1] - last[1]) - way[1] * (raw[0] - last[0]));
  const best = ways.reduce((one, other) => (beside(other) < beside(one) - 1e-9 ? other : one));
  if (beside(best) > reach) return undefined;
  const at = onGrid(on(best), FINEST);
  return { at, to: 'angle', guide: [last, at] };
}
