import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { expect, test } from '@playwright/test';
import { BenchPage } from './bench';
import { at, button, check, click, drag, drawWalls, driven, editor, enter, form, open, press, said, save, sheet } from './desk';

const cogmap = process.env['COGMAP_BIN'] ?? resolve(__dirname, '../../target/debug/cogmap');

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
  await page.keyboard.press('n');
  await click(page, 0.5, 0.75);
  await click(page, 0.7, 0.75);
  await page.keyboard.press('Enter');
  await expect(said(page)).toHaveText(/^Somebody who walks \d+\.\d+ m to and fro added\.$/);
  await expect(check(page)).toContainText('Everything is in order');

  const whole = await save(page);
  expect(whole.name).toBe('new-building.world.json');
  const { walls, boxes, posts, doors, people, rooms, routes, start } = whole.world;
  expect(walls).toHaveLength(1);
  expect(walls[0]?.[4]).toEqual(walls[0]?.[0]);
  expect([boxes?.length, posts?.length, rooms?.[0]?.outline.length, routes?.['route 1']?.length]).toEqual([1, 1, 4, 2]);
  expect(people).toMatchObject([{ speed: 0.8, radius: 0.25 }]);
  expect(start.heading_deg).toBe(90);
  expect(doors?.[0]?.hinge[0], 'the door is in the wall').toBe(walls[0]?.[1]?.[0]);
  for (const number of walls.flat(2)) expect(Math.abs(number * 10 - Math.round(number * 10)), 'on the grid').toBeLessThan(1e-9);

  await press(page, 'Control+z', 9);
  await expect(said(page)).toHaveText('Nothing is left to undo.');
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start']);
  await press(page, 'Control+Shift+Z', 8);
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
