import { expect, type Page } from '@playwright/test';
import { BenchPage } from './bench';

export interface Told {
  do: string;
  what?: string;
  open?: boolean;
  center?: [number, number];
  position?: [number, number];
}

export interface RememberedMap {
  frames: { id: number; map_from_frame: [number, number, number] }[];
  surfaces: { frame: number; a: [number, number]; b: [number, number] }[];
}

/** Two rooms and a door between them; the robot waits in the first. */
export const ROOMS = {
  format: 'cogmap-world/1',
  name: 'Rooms',
  walls: [
    [[0, 0], [8, 0], [8, 5], [0, 5], [0, 0]],
    [[4, 0], [4, 2]],
    [[4, 3], [4, 5]],
  ],
  doors: [{ name: 'between', hinge: [4, 3], latch: [4, 2], open: true }],
  rooms: [
    { name: 'West', outline: [[0, 0], [4, 0], [4, 5], [0, 5]] },
    { name: 'East', outline: [[4, 0], [8, 0], [8, 5], [4, 5]] },
  ],
  start: { position: [1, 2.5] },
};

export const palette = (page: Page) => page.getByRole('toolbar', { name: 'Change the building' });
export const tool = (page: Page, name: string) => palette(page).getByRole('radio', { name });
export const word = (page: Page) => palette(page).getByRole('status');
export const opener = (page: Page) => page.getByRole('button', { name: 'Change', exact: true });

export const session = async (bench: BenchPage) => (await bench.save('Session')).bytes.toString();
export const told = async (bench: BenchPage) =>
  (JSON.parse(await session(bench)) as { source: { commands: Told[] } }).source.commands;
export const latest = async (bench: BenchPage) => (await told(bench)).at(-1);

/** Opens the page on the two rooms. */
export async function rooms(page: Page): Promise<BenchPage> {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'rooms.world.json', content: JSON.stringify(ROOMS) });
  await expect(bench.choice).toContainText('Rooms');
  await page.getByRole('heading', { level: 1 }).click();
  return bench;
}

/** Opens the palette with one of its tools. */
export async function take(page: Page, name: string): Promise<void> {
  if (await palette(page).isHidden()) await opener(page).click();
  await tool(page, name).check();
}

/** Turns the robot by a nudge, so that it takes a view. */
export const look = (bench: BenchPage) => bench.step('Turn left');

/** Clicks in the view of the world, at shares of its size from its middle. */
export async function click(bench: BenchPage, right: number, down: number): Promise<void> {
  const picture = bench.world.getByRole('img');
  const { width, height } = (await picture.boundingBox()) ?? { width: 0, height: 0 };
  await picture.click({ position: { x: width * (0.5 + right), y: height * (0.5 + down) } });
}

/** Finds where points of the world are in its view, as shares of its size from its middle: two boxes tell, and are undone. */
export async function shares(bench: BenchPage): Promise<(at: [number, number]) => [number, number]> {
  const { page } = bench;
  await take(page, 'Drop a box');
  const seen: [number, number][] = [];
  const before = (await told(bench)).length;
  for (const share of [-0.1, 0.1]) {
    await click(bench, share, share);
    await expect.poll(async () => (await told(bench)).length).toBe(before + 1);
    seen.push((await latest(bench))?.center ?? [0, 0]);
    await page.keyboard.press('Control+z');
    await expect.poll(async () => (await told(bench)).length).toBe(before);
  }
  const [low, high] = seen as [[number, number], [number, number]];
  const share = (axis: 0 | 1, metres: number) => -0.1 + (0.2 * (metres - low[axis])) / (high[axis] - low[axis]);
  return ([x, y]) => [share(0, x), share(1, y)];
}

/** Clicks with a tool at a point of the world. */
export async function clickAt(bench: BenchPage, name: string, at: [number, number]): Promise<void> {
  const [right, down] = (await shares(bench))(at);
  await take(bench.page, name);
  await click(bench, right, down);
}

/** How many remembered surfaces have both ends at a box of 0.4 m. */
export async function surfacesAt(bench: BenchPage, [x, y]: [number, number]): Promise<number> {
  const map = JSON.parse((await bench.save('Map')).bytes.toString()) as RememberedMap;
  const frames = new Map(map.frames.map(({ id, map_from_frame }) => [id, map_from_frame]));
  const [left, below] = ROOMS.start.position as [number, number];
  const near = (frame: number, [u, v]: [number, number]) => {
    const [right, up, turned] = frames.get(frame) ?? [0, 0, 0];
    const [sin, cos] = [Math.sin(turned), Math.cos(turned)];
    return Math.hypot(left + right + cos * u - sin * v - x, below + up + sin * u + cos * v - y) < 0.4;
  };
  return map.surfaces.filter(({ frame, a, b }) => near(frame, a) && near(frame, b)).length;
}
