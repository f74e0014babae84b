import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { click, clickAt, latest, look, opener, palette, rooms, session, surfacesAt, take, told, tool, word } from './altering';
import { BenchPage, roomLog } from './bench';

test.use({ permissions: ['clipboard-read', 'clipboard-write'] });

test('a box that is dropped by a click is seen by the laser, taken away and undone', async ({ page }) => {
  const bench = await rooms(page);
  const empty = await session(bench);
  await look(bench);
  expect(await surfacesAt(bench, [2.5, 2.9])).toBe(0);
  await page.keyboard.press('Control+z');
  await clickAt(bench, 'Drop a box', [2.5, 2.9]);
  await expect.poll(() => latest(bench)).toMatchObject({ do: 'change', what: 'add_box' });
  const [x, y] = (await latest(bench))?.center ?? [0, 0];
  expect(Math.hypot(x - 2.5, y - 2.9)).toBeLessThan(0.1);
  await expect(bench.world).toContainText('A box was set down');
  await expect(page.getByRole('status', { name: 'What happened' })).toContainText('A box was set down.');
  await expect(page.getByRole('toolbar', { name: 'Events' }).getByRole('button', { name: /A box was set down/ })).toBeVisible();
  await look(bench);
  expect(await surfacesAt(bench, [2.5, 2.9])).toBeGreaterThan(0);

  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect.poll(() => session(bench)).toBe(empty);
  await look(bench);
  expect(await surfacesAt(bench, [2.5, 2.9])).toBe(0);

  await clickAt(bench, 'Drop a box', [2.5, 2.9]);
  await clickAt(bench, 'Take away', [2.5, 2.9]);
  await expect.poll(() => latest(bench)).toMatchObject({ do: 'change', what: 'remove_box' });
  await click(bench, 0, 0);
  await expect(word(page)).toHaveText('Nothing stands there that could be taken away.');
});

test('a door is shut and opened by keyboard alone, and that is undone', async ({ page }) => {
  const bench = await rooms(page);
  await page.keyboard.press('b');
  await expect(tool(page, 'Door')).toBeFocused();
  await page.keyboard.press('Tab');
  await expect(palette(page).getByRole('combobox', { name: 'Which door' })).toBeFocused();
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await expect(palette(page).getByRole('button', { name: 'Open it' })).toBeFocused();
  await expect(bench.world).toContainText('A door was shut');
  await page.keyboard.press('Enter');
  await expect(bench.world).toContainText('A door was opened');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect(palette(page).getByRole('button', { name: 'Shut it' })).toBeVisible();
  await expect(bench.world).not.toContainText('A door was');
  await page.keyboard.press('Control+Shift+Z');
  await expect(palette(page).getByRole('button', { name: 'Open it' })).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(palette(page)).toBeHidden();
  await expect(opener(page)).toBeFocused();
  expect(await latest(bench)).toMatchObject({ do: 'change', what: 'door', open: false });
});

test('a click shuts a door, and one beside it has an answer', async ({ page }) => {
  const bench = await rooms(page);
  await clickAt(bench, 'Door', [4, 2.4]);
  await expect.poll(() => latest(bench)).toMatchObject({ what: 'door', open: false });
  const before = await session(bench);
  await clickAt(bench, 'Door', [1, 4]);
  await expect(word(page)).toHaveText('There is no door there.');
  expect(await session(bench)).toBe(before);
});

test('the robot is carried off, by a click and to a room, and brought back', async ({ page }) => {
  const bench = await rooms(page);
  await clickAt(bench, 'Carry off', [6, 3]);
  await expect.poll(() => latest(bench)).toMatchObject({ do: 'kidnap' });
  await expect(bench.world).toContainText('Picked up and set down elsewhere');
  await expect(bench.memory).toContainText(/off by [45]\.\d\d m/);
  expect(await bench.travelled()).toBe(0);
  await page.keyboard.press('Control+z');
  await expect(bench.memory).toContainText('off by 0.00 m');
  await palette(page).getByRole('combobox', { name: 'Where to' }).selectOption('East');
  await palette(page).getByRole('button', { name: 'Set it down' }).click();
  await expect(bench.memory).toContainText(/off by [45]\.\d\d m/);
});

test('what cannot be has one sentence, and changes nothing', async ({ page }) => {
  const bench = await rooms(page);
  const before = await session(bench);
  await clickAt(bench, 'Drop a box', [1, 2.5]);
  await expect(word(page)).toHaveText('No box was dropped: the robot stands there.');
  await clickAt(bench, 'Carry off', [4, 1]);
  await expect(word(page)).toHaveText('The robot stays where it is: something stands there.');
  expect(await session(bench)).toBe(before);
  await clickAt(bench, 'Carry off', [4, 2.5]);
  await expect.poll(() => latest(bench)).toMatchObject({ do: 'kidnap' });
  await take(page, 'Door');
  await palette(page).getByRole('button', { name: 'Shut it' }).click();
  await expect(word(page)).toHaveText('The door “between” stays as it is: the robot stands there.');
});

test('a change at an earlier moment makes a branch', async ({ page }) => {
  const bench = await rooms(page);
  await look(bench);
  const old = await session(bench);
  const slider = page.getByRole('slider', { name: 'Timeline' });
  await slider.fill(String(Math.round(Number(await slider.getAttribute('max')) / 2)));
  await take(page, 'Drop a box');
  await palette(page).getByRole('button', { name: '1 m ahead' }).click();
  await page.getByRole('button', { name: 'Other branch (1)' }).click();
  await expect.poll(() => session(bench)).toBe(old);
});

test('a link holds the changed building', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  await take(page, 'Drop a box');
  await palette(page).getByRole('button', { name: '1 m ahead' }).click();
  await take(page, 'Door');
  await palette(page).getByRole('combobox').selectOption({ index: 1 });
  await palette(page).locator('.by-name').getByRole('button').click();
  await expect.poll(async () => (await told(bench)).filter((command) => command.do === 'change').length).toBe(2);
  await look(bench);
  const doors = await palette(page).getByRole('option').allInnerTexts();
  const [saved, map] = [await session(bench), (await bench.save('Map')).bytes.toString()];
  const link = await bench.link();
  await page.goto('about:blank');
  await page.goto(link);
  await expect(bench.choice).toHaveValue('office');
  await expect.poll(() => session(bench)).toBe(saved);
  expect((await bench.save('Map')).bytes.toString()).toBe(map);
  await take(page, 'Door');
  expect(await palette(page).getByRole('option').allInnerTexts()).toEqual(doors);
});

test('a log has no building to change', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(10) });
  await expect(page.getByRole('heading', { name: 'The log by its odometry alone' })).toBeVisible();
  await expect(opener(page)).toBeDisabled();
  await expect(opener(page)).toHaveAttribute('title', /no building/);
  await page.keyboard.press('b');
  await expect(palette(page)).toBeHidden();
});

for (const colorScheme of ['light', 'dark'] as const) {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 390, height: 844 }]) {
    test.describe(`${colorScheme} at ${viewport.width} × ${viewport.height}`, () => {
      test.use({ colorScheme, viewport });

      test('the palette has nothing to object to, is large enough for fingers, and fits', async ({ page }) => {
        const bench = new BenchPage(page);
        await bench.open();
        for (const name of ['Door', 'Drop a box', 'Take away', 'Carry off']) {
          await take(page, name);
          expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        }
        for (const control of await palette(page).locator('button, select, input').all()) {
          const box = await control.boundingBox();
          expect(Math.min(box?.width ?? 0, box?.height ?? 0)).toBeGreaterThanOrEqual(44);
        }
        await click(bench, -0.5 + 1e-3, -0.3);
        await take(page, 'Door');
        await click(bench, -0.49, 0.3);
        await expect(word(page)).toHaveText('There is no door there.');
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        expect(wider).toBeLessThanOrEqual(0);
      });
    });
  }
}
