import { editing as words } from '../strings/editing';
import type { Draft, Thing } from '../wasm/cogmap_wasm';
import { area, distance, heading, length, rounded, type Point } from './geometry';
import { freeName, SMALLEST } from './things';
import { POINTS, type ToolName } from './tools';

/** A post that nobody said the size of, metres. */
const RADIUS = 0.05;

/** How somebody walks whom nobody said more of: a stroll, metres a second, and feet, metres. */
const STROLL = { speed: 0.8, radius: 0.25 };

/** What a tool makes of points, and how to say so; or what speaks against it. */
export type Made = { thing: Thing; said: string } | { objection: string };

/** Makes something of the points that were placed with a tool. */
export function make(tool: Exclude<ToolName, 'select'>, placed: Point[], draft: Draft): Made {
  const points = placed.filter((point, index) => index === 0 || distance(point, placed[index - 1] as Point) > 1e-9);
  const [least] = POINTS[tool];
  if (points.length < least) return { objection: tool === 'box' || tool === 'door' ? words.said.tooSmall : words.said.tooFew(least) };
  const [first, second] = points as [Point, Point];
  switch (tool) {
    case 'wall':
      return { thing: { kind: 'wall', points }, said: words.said.wall(points.length, length(points)) };
    case 'box':
      return box(first, second);
    case 'post':
      return { thing: { kind: 'post', center: first, radius: RADIUS }, said: words.said.post(...first) };
    case 'door':
      return door(first, second, freeName(draft, 'door', words.stems.door));
    case 'room': {
      const name = freeName(draft, 'room', words.stems.room);
      return { thing: { kind: 'room', name, points }, said: words.said.room(name, points.length, area(points)) };
    }
    case 'start':
      return start(first, second, draft);
    case 'route': {
      const name = freeName(draft, 'route', words.stems.route);
      return { thing: { kind: 'route', name, points }, said: words.said.route(name, points.length) };
    }
    case 'person':
      return { thing: { kind: 'person', points, ...STROLL }, said: words.said.person(length(points)) };
  }
}

function box([x, y]: Point, [to_x, to_y]: Point): Made {
  const size: Point = [rounded(Math.abs(to_x - x), 0.001), rounded(Math.abs(to_y - y), 0.001)];
  if (Math.min(...size) < SMALLEST) return { objection: words.said.tooSmall };
  const center: Point = [rounded((x + to_x) / 2, 0.001), rounded((y + to_y) / 2, 0.001)];
  return { thing: { kind: 'box', center, size, heading_deg: 0 }, said: words.said.box(...size) };
}

function door(hinge: Point, latch: Point, name: string): Made {
  const wide = distance(hinge, latch);
  if (wide < SMALLEST) return { objection: words.said.tooSmall };
  return { thing: { kind: 'door', name, hinge, latch, open: true }, said: words.said.door(name, wide) };
}

/** Without a second point the robot looks where it looked before. */
function start(position: Point, toward: Point | undefined, { things }: Draft): Made {
  const before = things.find((thing) => thing.kind === 'start');
  const heading_deg = toward ? rounded(heading(position, toward), 15) % 360 : (before?.heading_deg ?? 0);
  return { thing: { kind: 'start', position, heading_deg }, said: words.said.start(...position, heading_deg) };
}
