import type { Draft, Thing } from '../wasm/cogmap_wasm';
import { distance, heading, isWithin, lines, minus, nearestOn, onGrid, plus, rounded, times, turned, type Line, type Point } from './geometry';

export type Kind = Thing['kind'];
/** A thing of one kind. */
export type Of<K extends Kind> = Extract<Thing, { kind: K }>;

/** Numbers in a file are whole millimetres. */
const MILLIMETRE = 0.001;
/** Nothing is drawn smaller, metres. */
export const SMALLEST = 0.05;
/** The robot's radius, metres: as far as this from the start counts as on it. */
const ROBOT = 0.25;
/** How far from its middle a start has the handle that turns it, metres. */
const HANDLE = 0.6;
/** Directions are rounded to this, degrees. */
const TURN = 15;

/** Something that can be taken hold of: a corner, an end, or what turns or sizes a thing. */
export interface Handle {
  at: Point;
  does: 'point' | 'size' | 'turn';
}

/** Whether a thing is a list of points. */
export function hasPoints(thing: Thing): thing is Of<'wall' | 'room' | 'route' | 'person'> {
  return 'points' in thing;
}

/** Whether a thing has a name. */
export function hasName(thing: Thing): thing is Of<'door' | 'room' | 'route'> {
  return 'name' in thing;
}

/** The corners of a box, counter-clockwise from the one behind on the right. */
export function corners({ center, size, heading_deg }: Of<'box'>): Point[] {
  const [x, y] = times(size, 0.5);
  const all: Point[] = [[-x, -y], [x, -y], [x, y], [-x, y]];
  return all.map((corner) => plus(center, turned(corner, heading_deg)));
}

/** Where the leaf of a door ends as it stands. */
function leafEnd({ hinge, latch, open }: Of<'door'>): Point {
  return open ? plus(hinge, turned(minus(latch, hinge), 90)) : latch;
}

/** The point that a thing is moved by. */
export function anchor(thing: Thing): Point {
  switch (thing.kind) {
    case 'box':
    case 'post':
      return thing.center;
    case 'door':
      return thing.hinge;
    case 'start':
      return thing.position;
    default:
      return thing.points[0] ?? [0, 0];
  }
}

/** What can be taken hold of, beside the thing itself; points first and in order. */
export function handles(thing: Thing): Handle[] {
  const point = (at: Point): Handle => ({ at, does: 'point' });
  switch (thing.kind) {
    case 'box': {
      const { center, size, heading_deg } = thing;
      const ahead = plus(center, turned([size[0] / 2 + HANDLE / 2, 0], heading_deg));
      return [...corners(thing).map((at): Handle => ({ at, does: 'size' })), { at: ahead, does: 'turn' }];
    }
    case 'post':
      return [];
    case 'door':
      return [point(thing.hinge), point(thing.latch)];
    case 'start':
      return [{ at: plus(thing.position, turned([HANDLE, 0], thing.heading_deg)), does: 'turn' }];
    default:
      return thing.points.map(point);
  }
}

/** Every point at which others may begin or end, for snapping, and all that has to be in the picture. */
export function points(thing: Thing): Point[] {
  switch (thing.kind) {
    case 'box':
      return corners(thing);
    case 'post':
      return [thing.center];
    case 'door':
      return [thing.hinge, thing.latch];
    case 'start':
      return [thing.position];
    default:
      return thing.points;
  }
}

/** The lines of a thing as it is drawn. */
export function edges(thing: Thing): Line[] {
  switch (thing.kind) {
    case 'box':
      return lines(corners(thing), true);
    case 'door':
      return [[thing.hinge, thing.latch], [thing.hinge, leafEnd(thing)]];
    case 'post':
    case 'start':
      return [];
    default:
      return lines(thing.points, thing.kind === 'room');
  }
}

/** How far a point is from a thing, metres; 0 on it. The floor of a room is not the room. */
export function away(thing: Thing, point: Point): number {
  switch (thing.kind) {
    case 'post':
      return Math.max(0, distance(thing.center, point) - thing.radius);
    case 'start':
      return Math.max(0, distance(thing.position, point) - ROBOT);
    case 'box':
      if (isWithin(point, corners(thing))) return 0;
  }
  const from = edges(thing).map((edge) => distance(nearestOn(edge, point), point));
  return Math.min(...from, ...points(thing).map((corner) => distance(corner, point)));
}

/** Small things before large ones: the order in which they are looked for. */
const RANKS: Record<Kind, number> = { start: 0, post: 1, door: 2, person: 3, box: 4, wall: 5, route: 6, room: 7 };

/** Which thing lies under a point, to within `reach` metres; `floors`: a room also by its floor. */
export function thingAt({ things }: Draft, point: Point, reach: number, floors: boolean): number | undefined {
  const found = things.map((thing, index) => ({ index, rank: RANKS[thing.kind], away: away(thing, point) }));
  const near = found.filter((it) => it.away <= reach).sort((a, b) => a.rank - b.rank || a.away - b.away)[0];
  if (near || !floors) return near?.index;
  const under = (thing: Thing) => thing.kind === 'room' && isWithin(point, thing.points);
  const floor = things.findIndex(under);
  return floor < 0 ? undefined : floor;
}

/** The same thing elsewhere. */
export function moved(thing: Thing, by: Point): Thing {
  const to = (point: Point) => onGrid(plus(point, by), MILLIMETRE);
  switch (thing.kind) {
    case 'box':
    case 'post':
      return { ...thing, center: to(thing.center) };
    case 'door':
      return { ...thing, hinge: to(thing.hinge), latch: to(thing.latch) };
    case 'start':
      return { ...thing, position: to(thing.position) };
    default:
      return { ...thing, points: thing.points.map(to) };
  }
}

/** The same thing with one of its handles drawn elsewhere; `free`: turned to any direction. */
export function pulled(thing: Thing, handle: number, to: Point, free: boolean): Thing {
  const at = onGrid(to, MILLIMETRE);
  switch (thing.kind) {
    case 'box':
      if (handle < 4) return sized(thing, corners(thing)[(handle + 2) % 4] as Point, at);
      return { ...thing, heading_deg: facing(thing.center, to, free) };
    case 'door':
      return handle === 0 ? { ...thing, hinge: at } : { ...thing, latch: at };
    case 'start':
      return { ...thing, heading_deg: facing(thing.position, to, free) };
    case 'post':
      return thing;
    default:
      return { ...thing, points: thing.points.map((point, index) => (index === handle ? at : point)) };
  }
}

/** A box that reaches from a corner that stays to the one opposite. */
function sized(box: Of<'box'>, stays: Point, to: Point): Thing {
  const across = turned(minus(to, stays), -box.heading_deg);
  const size = across.map((side) => Math.max(SMALLEST, rounded(Math.abs(side), MILLIMETRE))) as Point;
  const half: Point = [(Math.sign(across[0]) || 1) * size[0] / 2, (Math.sign(across[1]) || 1) * size[1] / 2];
  return { ...box, size, center: onGrid(plus(stays, turned(half, box.heading_deg)), MILLIMETRE) };
}

function facing(from: Point, to: Point, free: boolean): number {
  return rounded(heading(from, to), free ? 0.1 : TURN) % 360;
}

/** How manieth of its kind a thing is, from 1. */
export function nth({ things }: Draft, index: number): number {
  const { kind } = things[index] ?? {};
  return things.slice(0, index + 1).filter((thing) => thing.kind === kind).length;
}

/** A name such as `stem 2` that no other thing of that kind has. */
export function freeName({ things }: Draft, kind: Kind, stem: string): string {
  const taken = new Set(things.flatMap((thing) => (thing.kind === kind && hasName(thing) ? [thing.name] : [])));
  let number = 1;
  while (taken.has(`${stem} ${number}`)) number += 1;
  return `${stem} ${number}`;
}
