import type { Kind } from './things';

/** What can be done on a sheet, in the order of the tools. */
export const TOOLS = ['select', 'wall', 'box', 'post', 'door', 'room', 'start', 'route', 'person'] as const;
export type ToolName = (typeof TOOLS)[number];

/** The key that chooses each tool. */
export const KEYS: Record<ToolName, string> = {
  select: 'v',
  wall: 'w',
  box: 'b',
  post: 'p',
  door: 'd',
  room: 'r',
  start: 's',
  route: 't',
  person: 'n',
};

/** How many points each tool takes: at least, and at most. */
export const POINTS: Record<Exclude<ToolName, 'select'>, [number, number]> = {
  wall: [2, Infinity],
  box: [2, 2],
  post: [1, 1],
  door: [2, 2],
  room: [3, Infinity],
  start: [1, 2],
  route: [1, Infinity],
  person: [2, Infinity],
};

/** The fewest points that a thing keeps when some are taken out. */
export const FEWEST: Partial<Record<Kind, number>> = { wall: 2, room: 3, route: 1, person: 1 };
