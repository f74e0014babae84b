import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { BenchPage, roomLog } from './bench';

test.use({ permissions: ['clipboard-read', 'clipboard-write'] });

const cogmap = process.env['COGMAP_BIN'] ?? resolve(__dirname, '../../target/debug/cogmap');

interface World {
  name: string;
  walls: [number, number][][];
  boxes?: { center: [number, number]; size: [number, number]; heading_deg: number }[];
  posts?: { center: [number, number]; radius: number }[];
  doors?: { name: string; hinge: [number, number]; latch: [number, number]; open: boolean }[];
  start: { position: [number, number]; heading_deg: number };
  routes?: Record<string, [number, number][]>;
  rooms?: { name: string; outline: [number, number][] }[];
}

const editor = (page: Page) => page.getByRole('dialog', { name: /^Drawing a building/ });
const sheet = (page: Page) => editor(page).getByRole('application', { name: 'The sheet' });
const said = (page: Page) => editor(page).locator('.line').getByRole('status');
const check = (page: Page) => editor(page).getByRole('region', { name: 'Check' });
const form = (page: Page) => editor(page).getByRole('region', { name: 'Selected' });
const button = (page: Page, name: string) => editor(page).getByRole('button', { name, exact: true });
const chosen = (page: Page) => form(page).getByRole('combobox').locator('option:checked');

/** Opens the page and the editor on an empty sheet or on the building that runs. */
async function open(page: Page, what: 'Edit the building' | 'New building'): Promise<BenchPage> {
  const bench = new BenchPage(page);
  await bench.open();
  await enter(page, what);
  return bench;
}

async function enter(page: Page, what: 'Edit the building' | 'New building'): Promise<void> {
  const fold = page.getByRole('button', { name: 'Set-up' });
  if (await fold.isVisible()) await fold.click();
  await page.getByRole('button', { name: 'Build' }).click();
  await page.getByRole('button', { name: what }).click();
  await expect(sheet(page)).toBeVisible();
  await expect(check(page)).not.toContainText('Looking it through');
}

/** Where shares of the sheet are on the page. */
async function at(page: Page, right: number, down: number): Promise<[number, number]> {
  const { x, y, width, height } = (await sheet(page).boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
  return [x + width * right, y + height * down];
}

const click = async (page: Page, right: number, down: number) => page.mouse.click(...(await at(page, right, down)));

async function drag(page: Page, from: [number, number], to: [number, number]): Promise<void> {
  await page.mouse.move(...(await at(page, ...from)));
  await page.mouse.down();
  await page.mouse.move(...(await at(page, (from[0] + to[0]) / 2, (from[1] + to[1]) / 2)));
  await page.mouse.move(...(await at(page, ...to)));
  await page.mouse.up();
}

/** Presses a key some times. */
async function press(page: Page, key: string, times = 1): Promise<void> {
  for (let time = 0; time < times; time += 1) await page.keyboard.press(key);
}

async function save(page: Page): Promise<{ name: string; text: string; world: World }> {
  const saving = page.waitForEvent('download');
  await button(page, 'Save the world').click();
  const download = await saving;
  const text = (await readFile(await download.path())).toString();
  return { name: download.suggestedFilename(), text, world: JSON.parse(text) as World };
}

/** The world of the session that runs. */
async function driven(bench: BenchPage): Promise<World> {
  const session = JSON.parse((await bench.save('Session')).bytes.toString()) as { source: { world: World } };
  return session.source.world;
}

/** Draws a room of four walls, of which the last ends where the first began. */
async function drawWalls(page: Page): Promise<void> {
  await page.keyboard.press('w');
  for (const [x, y] of [[0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9], [0.103, 0.103]] as const) await click(page, x, y);
  await expect(said(page)).toHaveText(/^Wall of 5 corners, \d+\.\d+ m long, added\.$/);
}

test('a building is drawn from an empty sheet by mouse, undone, done again, saved, read back and driven in', async ({ page }) => {
  const bench = await open(page, 'New building');
  await drawWalls(page);
  await page.keyboard.press('b');
  await drag(page, [0.2, 0.2], [0.3, 0.3]);
  await expect(said(page)).toHaveText(/^Box of \d+\.\d+ m by \d+\.\d+ m added\.$/);
  await page.keyboard.press('p');
  await click(page, 0.4, 0.25);
  await expect(said(page)).toHaveText(/^Post added at/);
  await page.keyboard.press('d');
  await drag(page, [0.9, 0.3], [0.9, 0.45]);
  await expect(said(page)).toHaveText(/^Door “door 1”, \d+\.\d+ m wide, added\.$/);
  await page.keyboard.press('r');
  for (const [x, y] of [[0.1, 0.1], [0.9, 0.1], [0.9, 0.9], [0.1, 0.9]] as const) await click(page, x, y);
  await page.mouse.dblclick(...(await at(page, 0.1, 0.9)));
  await expect(said(page)).toHaveText(/^Room “room 1” of 4 corners, \d+\.\d m², added\.$/);
  await page.keyboard.press('s');
  await drag(page, [0.3, 0.6], [0.3, 0.4]);
  await expect(said(page)).toHaveText(/^The robot begins at .*, looking to 90°\.$/);
  await page.keyboard.press('t');
  await click(page, 0.6, 0.6);
  await click(page, 0.7, 0.4);
  await page.keyboard.press('Enter');
  await expect(said(page)).toHaveText('Route “route 1” through 2 points added.');
  await expect(check(page)).toContainText('Everything is in order');

  const whole = await save(page);
  expect(whole.name).toBe('new-building.world.json');
  const { walls, boxes, posts, doors, rooms, routes, start } = whole.world;
  expect(walls).toHaveLength(1);
  expect(walls[0]?.[4]).toEqual(walls[0]?.[0]);
  expect([boxes?.length, posts?.length, rooms?.[0]?.outline.length, routes?.['route 1']?.length]).toEqual([1, 1, 4, 2]);
  expect(start.heading_deg).toBe(90);
  expect(doors?.[0]?.hinge[0], 'the door is in the wall').toBe(walls[0]?.[1]?.[0]);
  for (const number of walls.flat(2)) expect(Math.abs(number * 10 - Math.round(number * 10)), 'on the grid').toBeLessThan(1e-9);

  await press(page, 'Control+z', 8);
  await expect(said(page)).toHaveText('Nothing is left to undo.');
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start']);
  await press(page, 'Control+Shift+Z', 7);
  expect((await save(page)).text).toBe(whole.text);

  await test.step('on the command line', () => {
    test.skip(!existsSync(cogmap), `no command line at ${cogmap}`);
    const folder = mkdtempSync(join(tmpdir(), 'cogmap-'));
    writeFileSync(join(folder, whole.name), whole.text);
    expect(execFileSync(cogmap, ['check', join(folder, whole.name)]).toString()).toContain('a world, "New building"');
    rmSync(folder, { recursive: true });
  });

  await button(page, 'Drive here').click();
  await expect(editor(page)).toBeHidden();
  await expect(bench.choice).toContainText('New building');
  await expect(page.getByText('Go on drawing?')).toBeHidden();
  expect(await driven(bench)).toEqual(whole.world);
  await bench.drop({ name: whole.name, content: whole.text });
  await enter(page, 'Edit the building');
  expect((await save(page)).text, 'the same bytes').toBe(whole.text);
});

test('a building is drawn and driven in by keyboard alone', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await page.getByRole('button', { name: 'Build' }).focus();
  await page.keyboard.press('Enter');
  await press(page, 'Tab', 2);
  await page.keyboard.press('Enter');
  await expect(sheet(page)).toBeFocused();
  await page.keyboard.press('w');
  await expect(said(page)).toHaveText(/^Wall\. Click corner by corner/);
  await press(page, 'Shift+ArrowLeft', 2);
  await press(page, 'Shift+ArrowDown', 2);
  await expect(said(page)).toHaveText('-2.00, -2.00 m');
  await page.keyboard.press('Enter');
  for (const [key, times] of [['ArrowRight', 5], ['ArrowUp', 4], ['ArrowLeft', 5], ['ArrowDown', 4]] as const) {
    await press(page, `Shift+${key}`, times);
    await page.keyboard.press('Enter');
  }
  await expect(said(page)).toHaveText('Wall of 5 corners, 18.0 m long, added.');

  await page.keyboard.press('b');
  await press(page, 'Shift+ArrowRight', 4);
  await press(page, 'ArrowUp', 3);
  await page.keyboard.press('Enter');
  await press(page, 'ArrowRight', 6);
  await press(page, 'ArrowUp', 4);
  await page.keyboard.press('Enter');
  await expect(said(page)).toHaveText('Box of 0.6 m by 0.4 m added.');

  await page.keyboard.press('v');
  await press(page, 'ArrowLeft', 3);
  await press(page, 'ArrowDown', 2);
  await page.keyboard.press('Enter');
  await expect(said(page)).toHaveText(/^Box 1 taken up\./);
  await press(page, 'Shift+ArrowUp');
  await press(page, 'Alt+ArrowUp');
  await page.keyboard.press('Enter');
  await expect(said(page)).toHaveText('Box 1 moved.');

  await page.keyboard.press('t');
  await press(page, 'Shift+ArrowDown');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  await expect(said(page)).toHaveText('Route “route 1” through 1 point added.');
  await expect(check(page)).toContainText('Everything is in order');
  await button(page, 'Drive here').focus();
  await page.keyboard.press('Enter');
  await expect(editor(page)).toBeHidden();
  const world = await driven(bench);
  expect(world.walls).toEqual([[[-2, -2], [3, -2], [3, 2], [-2, 2], [-2, -2]]]);
  expect(world.boxes).toMatchObject([{ center: [2.3, -0.49], size: [0.6, 0.4] }]);
});

test('what is wrong is told at once and where it is, and keeps the building from being driven in', async ({ page }) => {
  await open(page, 'New building');
  await drawWalls(page);
  await page.keyboard.press('w');
  await sheet(page).focus();
  await form(page).getByRole('combobox').selectOption('Start');
  await sheet(page).focus();
  await page.keyboard.press('Enter');
  await press(page, 'Shift+ArrowRight');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('1 thing to put right first');
  await expect(check(page)).toContainText('is 0.00 m from a solid');
  await expect(editor(page).locator('svg .bad')).toHaveCount(1);
  await button(page, 'Drive here').click();
  await expect(said(page)).toHaveText('Put right first what the check lists.');
  await expect(editor(page)).toBeVisible();
  await check(page).getByRole('button', { name: /^Start/ }).click();
  await expect(chosen(page)).toHaveText('Start');
  await form(page).getByRole('spinbutton', { name: 'x, m' }).fill('-1');
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('Everything is in order');

  await sheet(page).focus();
  await page.keyboard.press('d');
  await drag(page, [0.3, 0.1], [0.4, 0.1]);
  await drag(page, [0.6, 0.1], [0.7, 0.1]);
  await form(page).getByRole('textbox', { name: 'Name' }).fill('door 1');
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('another door is called "door 1" too');
  await form(page).getByRole('textbox', { name: 'Name' }).fill('second');
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('Everything is in order');
  await form(page).getByRole('group', { name: 'Latch' }).getByRole('spinbutton', { name: 'x, m' }).fill(
    await form(page).getByRole('group', { name: 'Hinge' }).getByRole('spinbutton', { name: 'x, m' }).inputValue(),
  );
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('Door “second”, latch');
  await page.keyboard.press('Control+z');
  await expect(check(page)).toContainText('Everything is in order');

  await page.keyboard.press('Escape');
  await expect(sheet(page)).toBeFocused();
  await page.keyboard.press('t');
  await click(page, 0.97, 0.5);
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('Route “route 1”, point 1');
  await expect(check(page)).toContainText('cannot be reached');
  await page.keyboard.press('Delete');
  await expect(check(page)).toContainText('Everything is in order');

  await page.keyboard.press('r');
  for (const [x, y] of [[0.2, 0.2], [0.5, 0.5], [0.5, 0.2], [0.2, 0.5]] as const) await click(page, x, y);
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('Worth a look');
  await expect(check(page)).toContainText('crosses itself');
  await expect(check(page)).toContainText('Everything is in order');
});

test('the present building is edited as it is now, and driven in again', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  await page.getByRole('button', { name: 'Change', exact: true }).click();
  await page.getByRole('radio', { name: 'Drop a box' }).check();
  await page.getByRole('button', { name: '1 m ahead' }).click();
  await expect(bench.world).toContainText('A box was set down');
  const before = (await driven(bench)).boxes?.length ?? 0;
  await page.getByRole('heading', { level: 1 }).click();
  await page.keyboard.press('u');
  await expect(sheet(page)).toBeFocused();
  await expect(check(page), 'the box stands in the way').toContainText('2 things to put right first');
  for (const route of ['loop', 'tour']) {
    await check(page).getByRole('button', { name: new RegExp(`^Route “${route}”`) }).click();
    await button(page, 'Delete').click();
  }
  await expect(check(page)).toContainText('Everything is in order');
  expect((await save(page)).world.boxes?.length).toBe(before + 1);
  await form(page).getByRole('combobox').selectOption(`Box ${before + 1}`);
  await button(page, 'Duplicate').click();
  await expect(said(page)).toHaveText(`Box ${before + 2} is the copy.`);
  await form(page).getByRole('spinbutton', { name: 'Heading, °' }).fill('30');
  await page.keyboard.press('Enter');
  await button(page, 'Drive here').click();
  await expect(editor(page)).toBeHidden();
  await expect(bench.choice).toContainText('Office');
  const world = await driven(bench);
  expect(world.boxes?.length).toBe(before + 2);
  expect(world.boxes?.at(-1)?.heading_deg).toBe(30);
  const link = await bench.link();
  await page.goto('about:blank');
  await page.goto(link);
  await expect(bench.choice).toContainText('Office');
  await expect.poll(async () => (await driven(bench)).boxes?.length).toBe(before + 2);
});

test('Back loses nothing, and after driving the edits can still be undone', async ({ page }) => {
  const bench = await open(page, 'New building');
  await drawWalls(page);
  const before = await bench.memory.first().innerText();
  await button(page, 'Back').click();
  await expect(editor(page)).toBeHidden();
  await expect(page.getByRole('button', { name: 'Build' })).toBeFocused();
  expect(await bench.memory.first().innerText()).toBe(before);
  await page.getByRole('button', { name: 'Go on drawing' }).click();
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start', 'Wall 1']);
  await button(page, 'Drive here').click();
  await expect(editor(page)).toBeHidden();
  await enter(page, 'Edit the building');
  await button(page, 'Undo').click();
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start']);
});

test('what was drawn is offered again after a reload, the wall that was not ended with it', async ({ page }) => {
  await open(page, 'New building');
  await drawWalls(page);
  await page.keyboard.press('w');
  await click(page, 0.5, 0.2);
  await click(page, 0.5, 0.4);
  await expect(said(page)).toHaveText(/^Point 2 at/);
  await page.waitForTimeout(300);
  await page.reload();
  await expect(page.getByText(/Go on drawing\? New building/)).toBeVisible();
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await page.getByRole('button', { name: 'Go on drawing' }).click();
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start', 'Wall 1']);
  await click(page, 0.6, 0.4);
  await page.keyboard.press('Enter');
  await expect(said(page)).toHaveText(/^Wall of 3 corners/);
  await press(page, 'Control+z', 2);
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start']);
});

test('an empty sheet in place of an unfinished drawing is an edit that can be undone', async ({ page }) => {
  await open(page, 'New building');
  await drawWalls(page);
  await button(page, 'Back').click();
  await enter(page, 'New building');
  await expect(said(page)).toHaveText('New building is on the sheet. What was drawn before comes back with Undo.');
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start']);
  await button(page, 'Undo').click();
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start', 'Wall 1']);
  await button(page, 'Back').click();
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await page.reload();
  await page.waitForTimeout(1000);
  await expect(page.getByText('Go on drawing?')).toBeHidden();
});

test('things are moved, turned, abandoned and put back by hand', async ({ page }) => {
  await open(page, 'New building');
  await page.keyboard.press('b');
  await drag(page, [0.2, 0.2], [0.3, 0.3]);
  await page.keyboard.press('v');
  await drag(page, [0.25, 0.25], [0.35, 0.35]);
  await expect(said(page)).toHaveText('Box 1 moved.');
  await drag(page, [0.4, 0.4], [0.45, 0.5]);
  await expect(said(page)).toHaveText('Box 1 moved.');
  const { boxes } = (await save(page)).world;
  const area = (boxes?.[0]?.size[0] ?? 0) * (boxes?.[0]?.size[1] ?? 0);
  await page.keyboard.press('Control+z');
  const smaller = (await save(page)).world.boxes?.[0]?.size ?? [0, 0];
  expect(area).toBeGreaterThan(smaller[0] * smaller[1]);

  await sheet(page).focus();
  await page.keyboard.press('w');
  await click(page, 0.6, 0.6);
  await click(page, 0.7, 0.6);
  await page.keyboard.press('Backspace');
  await expect(said(page)).toHaveText('The last point is taken back, 1 left.');
  await page.keyboard.press('Escape');
  await expect(said(page)).toHaveText('Abandoned.');
  const before = (await save(page)).text;
  expect(before).not.toContain('"walls": [\n    [');

  await sheet(page).focus();
  await page.keyboard.press('v');
  await page.mouse.move(...(await at(page, 0.35, 0.35)));
  await page.mouse.down();
  await page.mouse.move(...(await at(page, 0.6, 0.6)));
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await expect(said(page)).toHaveText('Put back.');
  expect((await save(page)).text).toBe(before);
});

test('what is held is let go when something else is done with it', async ({ page }) => {
  await open(page, 'New building');
  await page.keyboard.press('p');
  await click(page, 0.3, 0.3);
  await page.keyboard.press('v');
  await page.keyboard.press('Enter');
  await expect(said(page)).toHaveText(/^Post 1 taken up/);
  await page.keyboard.press('Delete');
  await expect(said(page)).toHaveText('Post 1 deleted.');
  await press(page, 'ArrowUp', 2);
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start']);
  await page.keyboard.press('Control+z');
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start', 'Post 1']);
  await form(page).getByRole('combobox').selectOption('Start');
  await sheet(page).focus();
  await page.keyboard.press('Delete');
  await expect(said(page)).toHaveText('Every building needs a start: move it instead.');

  await page.keyboard.press('b');
  await page.mouse.move(...(await at(page, 0.5, 0.3)));
  await page.mouse.down();
  await page.mouse.move(...(await at(page, 0.6, 0.4)));
  await page.keyboard.press('Escape');
  await page.mouse.move(...(await at(page, 0.7, 0.5)));
  await page.mouse.up();
  await expect(said(page)).toHaveText('Abandoned.');
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start', 'Post 1']);
});

test('without snapping a point stays where it was pressed', async ({ page }) => {
  await open(page, 'New building');
  await page.keyboard.press('g');
  await expect(said(page)).toHaveText('Points do not snap.');
  await page.keyboard.press('p');
  await click(page, 0.3117, 0.2931);
  await page.keyboard.press('g');
  await page.keyboard.down('Alt');
  await click(page, 0.4117, 0.2931);
  await page.keyboard.up('Alt');
  await click(page, 0.5117, 0.2931);
  const posts = (await save(page)).world.posts ?? [];
  const offGrid = posts.map(({ center }) => center.some((it) => Math.abs(it * 10 - Math.round(it * 10)) > 1e-6));
  expect(offGrid).toEqual([true, true, false]);
});

test('the sheet is moved and zoomed, and shows everything again', async ({ page }) => {
  await open(page, 'Edit the building');
  const bar = () => editor(page).locator('svg .grid').getAttribute('d');
  const first = await bar();
  await page.mouse.move(...(await at(page, 0.5, 0.5)));
  await page.mouse.wheel(0, -400);
  await expect.poll(bar).not.toBe(first);
  const near = await bar();
  await page.keyboard.down('Space');
  await drag(page, [0.5, 0.5], [0.55, 0.6]);
  await page.keyboard.up('Space');
  await expect.poll(bar).not.toBe(near);
  await page.keyboard.press('0');
  await expect.poll(bar).toBe(first);
  await page.mouse.move(...(await at(page, 0.5, 0.5)));
  await page.mouse.down({ button: 'middle' });
  await page.mouse.move(...(await at(page, 0.53, 0.57)));
  await page.mouse.up({ button: 'middle' });
  await expect.poll(bar).not.toBe(first);
  await page.keyboard.press('0');
  await expect.poll(bar).toBe(first);
  await expect(button(page, 'Undo')).toBeDisabled();
});

test('a world that is dropped on the sheet is drawn there, and what is none has an answer', async ({ page }) => {
  const bench = await open(page, 'New building');
  await drawWalls(page);
  const before = (await save(page)).text;
  await bench.drop({ name: 'hut.world.json', content: '{"format":"cogmap-world/1","name":"Hut","wals":[]}' });
  await expect(said(page)).toContainText('did you mean `walls`?');
  const walledIn = { format: 'cogmap-world/1', name: 'Cell', walls: [[[0, 0], [1, 0]]], start: { position: [0.5, 0.1] } };
  await bench.drop({ name: 'cell.world.json', content: JSON.stringify(walledIn) });
  await expect(said(page)).toHaveText(/^Cell is on the sheet\./);
  await expect(check(page)).toContainText('1 thing to put right first');
  await page.keyboard.press('Control+z');
  expect((await save(page)).text).toBe(before);
});

test('a recorded log has no building to edit, and says so', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(10) });
  await expect(page.getByRole('heading', { name: 'The log by its odometry alone' })).toBeVisible();
  await page.getByRole('button', { name: 'Build' }).click();
  await page.getByRole('button', { name: /^Edit the building A recorded log has no building/ }).click();
  await expect(page.getByRole('alert')).toContainText('A recorded log has no building');
  await expect(editor(page)).toBeHidden();
});

test('the robot hears nothing while somebody draws', async ({ page }) => {
  const bench = await open(page, 'Edit the building');
  await press(page, 'ArrowUp', 5);
  await page.keyboard.press('h');
  await button(page, 'Back').click();
  await expect(page.getByRole('button', { name: 'Go Home', exact: true })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
  const session = JSON.parse((await bench.save('Session')).bytes.toString()) as { source: { commands: { do: string }[] } };
  expect(session.source.commands.filter((command) => command.do !== 'step')).toEqual([]);
});

for (const colorScheme of ['light', 'dark'] as const) {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 1024, height: 768 }, { width: 390, height: 844 }]) {
    test.describe(`${colorScheme} at ${viewport.width} × ${viewport.height}`, () => {
      test.use({ colorScheme, viewport, hasTouch: viewport.width < 500 });

      test('the editor has nothing to object to, and fits', async ({ page }) => {
        await open(page, 'Edit the building');
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        for (const name of ['Wall 1', 'Box 1', 'Start', 'Door “kitchen”']) {
          const options = await form(page).getByRole('option').allInnerTexts();
          if (options.includes(name)) await form(page).getByRole('combobox').selectOption(name);
        }
        await sheet(page).focus();
        await page.keyboard.press('s');
        await click(page, 0.02, 0.02);
        await page.keyboard.press('?');
        await expect(check(page)).toContainText('to put right first');
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        expect(wider).toBeLessThanOrEqual(0);
      });
    });
  }
}

test.describe('on a telephone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });

  test('fingers draw a wall and end it, and everything is large enough for them', async ({ page }) => {
    await open(page, 'New building');
    for (const [x, y] of [[0.2, 0.2], [0.8, 0.2], [0.8, 0.7]] as const) await page.touchscreen.tap(...(await at(page, x, y)));
    await button(page, 'Done').click();
    await expect(said(page)).toHaveText(/^Wall of 3 corners/);

    const grid = editor(page).locator('svg .grid');
    const before = await grid.getAttribute('d');
    const hand = await page.context().newCDPSession(page);
    const touch = async (type: 'touchStart' | 'touchMove' | 'touchEnd', ...shares: [number, number][]) => {
      const places = await Promise.all(shares.map((share) => at(page, ...share)));
      const touchPoints = places.map(([x, y], id) => ({ x, y, id }));
      await hand.send('Input.dispatchTouchEvent', { type, touchPoints });
    };
    await touch('touchStart', [0.4, 0.5]);
    await touch('touchStart', [0.4, 0.5], [0.6, 0.5]);
    await touch('touchMove', [0.3, 0.5], [0.7, 0.5]);
    await touch('touchEnd');
    await expect.poll(() => grid.getAttribute('d')).not.toBe(before);
    await expect(said(page), 'two fingers draw nothing').toHaveText(/^Wall of 3 corners/);

    for (const control of await editor(page).locator('button:visible, select:visible, input:visible, summary').all()) {
      const box = await control.boundingBox();
      expect(Math.min(box?.width ?? 0, box?.height ?? 0), await control.innerText()).toBeGreaterThanOrEqual(44);
    }
  });
});
