import { readFile } from 'node:fs/promises';
import { expect, type Page } from '@playwright/test';
import { BenchPage } from './bench';

/** What the tests read of a world file. */
export interface World {
  name: string;
  walls: [number, number][][];
  boxes?: { center: [number, number]; size: [number, number]; heading_deg: number }[];
  posts?: { center: [number, number]; radius: number }[];
  doors?: { name: string; hinge: [number, number]; latch: [number, number]; open: boolean }[];
  people?: { path: [number, number][]; speed: number; radius: number }[];
  start: { position: [number, number]; heading_deg: number };
  routes?: Record<string, [number, number][]>;
  rooms?: { name: string; outline: [number, number][] }[];
}

export const editor = (page: Page) => page.getByRole('dialog', { name: /^Drawing a building/ });
export const sheet = (page: Page) => editor(page).getByRole('application', { name: 'The sheet' });
export const said = (page: Page) => editor(page).locator('.line').getByRole('status');
export const check = (page: Page) => editor(page).getByRole('region', { name: 'Check' });
export const form = (page: Page) => editor(page).getByRole('region', { name: 'Selected' });
export const button = (page: Page, name: string) => editor(page).getByRole('button', { name, exact: true });
export const chosen = (page: Page) => form(page).getByRole('combobox').locator('option:checked');

/** Opens the page and the editor on an empty sheet or on the building that runs. */
export async function open(page: Page, what: 'Edit the building' | 'New building'): Promise<BenchPage> {
  const bench = new BenchPage(page);
  await bench.open();
  await enter(page, what);
  return bench;
}

export async function enter(page: Page, what: 'Edit the building' | 'New building'): Promise<void> {
  const fold = page.getByRole('button', { name: 'Set-up' });
  if (await fold.isVisible()) await fold.click();
  await page.getByRole('button', { name: 'Build' }).click();
  await page.getByRole('button', { name: what }).click();
  await expect(sheet(page)).toBeVisible();
  await expect(check(page)).not.toContainText('Looking it through');
}

/** Where shares of the sheet are on the page. */
export async function at(page: Page, right: number, down: number): Promise<[number, number]> {
  const { x, y, width, height } = (await sheet(page).boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  return [x + width * right, y + height * down];
}

export const click = async (page: Page, right: number, down: number) => page.mouse.click(...(await at(page, right, down)));

export async function drag(page: Page, from: [number, number], to: [number, number]): Promise<void> {
  await page.mouse.move(...(await at(page, ...from)));
  await page.mouse.down();
  await page.mouse.move(...(await at(page, (from[0] + to[0]) / 2, (from[1] + to[1]) / 2)));
  await page.mouse.move(...(await at(page, ...to)));
  await page.mouse.up();
}

/** Presses a key some times. */
export async function press(page: Page, key: string, times = 1): Promise<void> {
  for (let time = 0; time < times; time += 1) await page.keyboard.press(key);
}

export async function save(page: Page): Promise<{ name: string; text: string; world: World }> {
  const saving = page.waitForEvent('download');
  await button(page, 'Save the world').click();
  const download = await saving;
  const text = (await readFile(await download.path())).toString();
  return { name: download.suggestedFilename(), text, world: JSON.parse(text) as World };
}

/** The world of the session that runs. */
export async function driven(bench: BenchPage): Promise<World> {
  const session = JSON.parse((await bench.save('Session')).bytes.toString()) as { source: { world: World } };
  return session.source.world;
}

/** Draws a room of four walls, of which the last ends where the first began. */
export async function drawWalls(page: Page): Promise<void> {
  await page.keyboard.press('w');
  for (const [x, y] of [[0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9], [0.103, 0.103]] as const) await click(page, x, y);
  await expect(said(page)).toHaveText(/^Wall of 5 corners, \d+\.\d+ m long, added\.$/);
}
