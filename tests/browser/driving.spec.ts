import { expect, test } from '@playwright/test';
import { BenchPage } from './bench';

test('the page opens on a robot under way, and its memory grows', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const before = await bench.surfaces();
  await expect.poll(() => bench.surfaces()).toBeGreaterThan(before);
  await expect(page.getByText(/^View \d+: \d+ surfaces seen, \d+ recognised/).first()).toBeVisible();
});

test('arrow keys drive the robot and the memory takes in what it sees', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  const [way, surfaces] = [await bench.travelled(), await bench.surfaces()];
  await page.keyboard.down('ArrowLeft');
  await page.waitForTimeout(1500);
  await page.keyboard.up('ArrowLeft');
  await page.keyboard.down('KeyW');
  await expect.poll(() => bench.travelled()).toBeGreaterThan(way + 0.3);
  await page.keyboard.up('KeyW');
  await expect.poll(() => bench.surfaces()).toBeGreaterThan(surfaces);
  await expect(page.getByRole('button', { name: /take the controls/i })).toBeHidden();
});

test('the buttons drive by mouse, and step by keyboard', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  const turn = page.getByRole('button', { name: 'Turn left' });
  const clock = page.locator('output');
  await bench.step('Turn left');
  const box = await turn.boundingBox();
  expect(box?.width).toBeGreaterThanOrEqual(44);
  expect(box?.height).toBeGreaterThanOrEqual(44);
  const rested = await clock.innerText();
  await turn.hover();
  await page.mouse.down();
  await expect(clock).not.toHaveText(rested);
  await page.mouse.up();
});

test('a click in the world sends the robot there', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  const clock = page.locator('output');
  const before = await clock.innerText();
  await bench.world.getByRole('img').click({ position: { x: 200, y: 200 } });
  await expect(clock).not.toHaveText(before);
});

test('time can be stopped, stepped through and gone back in', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await page.keyboard.press('Space');
  await expect(page.getByRole('button', { name: 'Play' })).toBeEnabled();
  const views = async () => Number(/from (\d+) view/.exec(await bench.memory.innerText())?.[1]);
  const before = await views();
  await page.keyboard.press('.');
  await expect.poll(views).toBe(before + 1);
  await page.getByRole('slider', { name: 'Timeline' }).fill('0');
  await expect.poll(views).toBe(1);
});

test('another seed is another run', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await page.getByLabel('Seed').fill('7');
  await page.getByLabel('Seed').press('Enter');
  await expect.poll(async () => JSON.parse((await bench.save('Session')).bytes.toString()).seed).toBe(7);
});

test('a building made from a number is driven through at once, and is the same another time', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const end = async () => {
    await page.getByRole('button', { name: 'To the end' }).click();
    await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled();
    return bench.travelled();
  };
  await page.getByRole('combobox', { name: 'World' }).selectOption('A new building');
  await page.getByRole('spinbutton', { name: 'Number' }).fill('60');
  await page.getByRole('spinbutton', { name: 'Number' }).press('Enter');
  await expect(page.getByText(/An office floor that nobody drew/).filter({ visible: true })).toBeVisible();
  await expect.poll(() => bench.travelled()).toBeLessThan(5);
  const way = await end();
  expect(way).toBeGreaterThan(8);
  await page.getByRole('button', { name: 'Start over' }).click();
  await expect.poll(() => bench.travelled()).toBeLessThan(5);
  expect(await end()).toBe(way);
});

test('going to the end stops at any other word', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  // Too long a way to be at its end before anybody says a word.
  const ends = [[27, 1.5], [1.5, 1.5]];
  const world = {
    format: 'cogmap-world/1',
    name: 'To and fro',
    walls: [[[0, 0], [30, 0], [30, 3], [0, 3], [0, 0]]],
    start: { position: [1.5, 1.5] },
    routes: { 'to and fro': Array.from({ length: 200 }, (_, turn) => ends[turn % 2]) },
  };
  await bench.drop({ name: 'fro.world.json', content: JSON.stringify(world) });
  await expect.poll(() => bench.travelled()).toBeLessThan(1);
  await page.getByRole('heading', { level: 1 }).click();
  await page.keyboard.press('f');
  await expect.poll(() => bench.travelled()).toBeGreaterThan(5);
  await bench.pause();
  const stopped = await bench.travelled();
  expect(stopped).toBeLessThan(4000);
  // The next view may come by a turn on the spot, which makes the way no longer.
  const moment = async () => Number(await page.getByRole('slider', { name: 'Timeline' }).inputValue());
  const paused = await moment();
  await page.keyboard.press('.');
  await expect.poll(moment).toBeGreaterThan(paused);
  expect(await bench.travelled()).toBeLessThan(stopped + 3);
});
