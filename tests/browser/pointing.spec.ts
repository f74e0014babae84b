import { expect, test, type Page } from '@playwright/test';
import { BenchPage } from './bench';

test.describe.configure({ timeout: 180_000 });

const card = (page: Page) => page.getByRole('group', { name: /^(Surface|Exit|Supposed exit|Local space) \d+$/ });
const going = (page: Page) => card(page).getByRole('button', { name: /^Go to view/ });
const walker = (page: Page) => page.getByRole('button', { name: /^Walk through the memory/ });
const picture = (bench: BenchPage) => bench.memory.getByRole('img');
const clock = (page: Page) => page.locator('output').first().innerText();

/** What a card says under a name. */
async function says(page: Page, name: string): Promise<string> {
  return card(page).locator('dt', { hasText: name }).locator('xpath=following-sibling::dd[1]').innerText();
}

/** Opens the page and lets the robot drive its whole route. */
async function driveRoute(page: Page): Promise<BenchPage> {
  const bench = new BenchPage(page);
  await bench.open();
  await page.getByRole('button', { name: 'To the end' }).click();
  await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled({ timeout: 50_000 });
  return bench;
}

/** Walks by keys to the surface that was placed last, which has that number. */
async function walkToNewest(page: Page, number: number): Promise<void> {
  await walker(page).focus();
  await page.keyboard.press('ArrowRight');
  await expect(card(page)).toHaveAccessibleName(/^Surface/);
  await page.keyboard.press('End');
  await expect(card(page)).toHaveAccessibleName(`Surface ${number}`);
}

/**
 * Moves over the memory until a card tells of such a thing; returns where that was. Only the latest point is
 * answered for: where nothing was found, answers may take longer than they were waited for, and the next try waits.
 */
async function sweep(bench: BenchPage, name: RegExp, reach: (x: number, y: number) => Promise<void>): Promise<[number, number]> {
  const box = await picture(bench).boundingBox();
  if (!box) throw new Error('there is no memory');
  for (const patience of [50, 1000]) {
    for (let row = 0.25; row < 0.8; row += 0.04) {
      for (let column = 0.1; column < 0.9; column += 0.02) {
        const [x, y] = [box.x + column * box.width, box.y + row * box.height];
        await reach(x, y);
        await bench.page.waitForTimeout(patience);
        if ((await card(bench.page).count()) > 0 && name.test(await card(bench.page).innerText())) return [x, y];
      }
    }
  }
  throw new Error(`nothing on the way is ${name}`);
}

test('a mouse over a surface shows its story, a click keeps it, and its moment can be gone to', async ({ page }) => {
  const bench = await driveRoute(page);
  const plain = (await picture(bench).screenshot()).toString('base64');
  const [x, y] = await sweep(bench, /^Surface/, (x, y) => page.mouse.move(x, y));
  expect((await picture(bench).screenshot()).toString('base64')).not.toBe(plain);
  await expect(card(page)).toContainText('Click to keep this card');
  await expect(going(page)).toHaveCount(0);
  const name = await card(page).getAttribute('aria-label');

  await page.mouse.click(x, y);
  await expect(going(page)).toBeVisible();
  await page.mouse.move(5, 5);
  await expect(card(page)).toHaveAccessibleName(name ?? '');

  // What it says is what the map says.
  const map = JSON.parse((await bench.save('Map')).bytes.toString());
  const stored = map.surfaces.find(({ id }: { id: number }) => `Surface ${id}` === name);
  expect(await says(page, 'Length')).toBe(`${Math.hypot(stored.b[0] - stored.a[0], stored.b[1] - stored.a[1]).toFixed(2)}\u00a0m`);
  expect(await says(page, 'Belongs to')).toBe(`Local space ${stored.asr}`);
  const [, view, moment] = /^view (\d+), ([\d:.]+)$/.exec(await says(page, 'First seen')) ?? [];
  expect(Number(view)).toBe(stored.step + 1);

  await going(page).click();
  await expect.poll(() => clock(page)).toBe(moment);
  await expect(card(page)).toHaveAccessibleName(name ?? '');
  expect(await says(page, 'Last seen')).toBe('only then');
  await page.keyboard.press('Escape');
  await expect(card(page)).toHaveCount(0);
});

test('a click beside everything, and a run that does not hold the thing yet, take the card away', async ({ page }) => {
  const bench = await driveRoute(page);
  const [x, y] = await sweep(bench, /^Surface/, (x, y) => page.mouse.move(x, y));
  await page.mouse.click(x, y);
  await expect(going(page)).toBeVisible();
  const box = await picture(bench).boundingBox();
  await page.mouse.click((box?.x ?? 0) + 20, (box?.y ?? 0) + 60);
  await expect(card(page)).toHaveCount(0);

  const map = JSON.parse((await bench.save('Map')).bytes.toString());
  await walkToNewest(page, map.surfaces.at(-1).id);
  await page.keyboard.press('Enter');
  await expect(going(page)).toBeVisible();
  await page.getByRole('slider', { name: 'Timeline' }).fill('0');
  await expect(card(page)).toHaveCount(0);
});

test('keys walk through surfaces, exits and places, keep a card and go to its moment, and drive nothing', async ({ page }) => {
  const bench = await driveRoute(page);
  const driven = await bench.travelled();
  await walker(page).focus();
  await expect(walker(page)).toBeVisible();
  await page.keyboard.press('ArrowRight');
  await expect(card(page)).toHaveAccessibleName(/^Surface \d+$/);
  const number = async () => Number(/\d+$/.exec((await card(page).getAttribute('aria-label')) ?? '')?.[0]);
  const first = await number();
  await page.keyboard.press('ArrowLeft');
  await expect.poll(number).toBeLessThan(first);
  await page.keyboard.press('ArrowRight');
  await expect.poll(number).toBe(first);
  const spoken = bench.memory.locator('.spoken[aria-live="polite"]');
  await expect(spoken).toContainText(`Surface ${first}. First seen: view`);

  await page.keyboard.press('ArrowDown');
  await expect(card(page)).toHaveAccessibleName(/^Exit \d+$/);
  expect(await says(page, 'Gone through')).toMatch(/^(once|\d+ times)/);
  expect(await says(page, 'Joins')).toMatch(/^Local space \d+\s+Local space \d+$/);
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowUp');
  await expect(card(page)).toHaveAccessibleName(/^Local space \d+$/);
  expect(await says(page, 'Floor seen')).toMatch(/^[\d.]+\u00a0m²$/);
  expect(await says(page, 'Opened')).toMatch(/^view \d+, [\d:.]+; /);

  await page.keyboard.press('Enter');
  await expect(going(page)).toBeFocused();
  const moment = /at ([\d:.]+),/.exec(await going(page).innerText())?.[1];
  await page.keyboard.press('Enter');
  await expect.poll(() => clock(page)).toBe(moment);
  await page.keyboard.press('Escape');
  await expect(card(page)).toHaveCount(0);
  await page.getByRole('button', { name: 'To the end' }).click();
  await expect.poll(() => bench.travelled()).toBe(driven);
});

test('what a card leads to is shown in its place', async ({ page }) => {
  await driveRoute(page);
  await walker(page).focus();
  await page.keyboard.press('ArrowRight');
  await expect(card(page)).toBeVisible();
  await page.keyboard.press('ArrowUp');
  await expect(card(page)).toHaveAccessibleName(/^Local space/);
  const place = (await card(page).getAttribute('aria-label')) ?? '';
  await page.keyboard.press('Enter');
  await card(page).getByRole('button', { name: /^Exit \d+$/ }).first().click();
  await expect(card(page)).toHaveAccessibleName(/^Exit/);
  await card(page).getByRole('button', { name: place, exact: true }).click();
  await expect(card(page)).toHaveAccessibleName(place);
});

test('the thesis’s mapper tells relative to which surface it placed one', async ({ page }) => {
  const bench = await driveRoute(page);
  await bench.chip('perceptual').click();
  await expect(bench.memory).toHaveCount(2);
  await bench.chip('consensus').click();
  await expect(bench.memory).toHaveCount(1);
  await expect(bench.memory).toContainText('by perceptual');
  const map = JSON.parse((await bench.save('Map')).bytes.toString());
  expect(map.mapper).toBe('perceptual');
  const last = map.surfaces.at(-1);
  await walkToNewest(page, last.id);
  await expect.poll(() => says(page, 'Placed relative to')).toMatch(/^Surface \d+$/);
  expect(await says(page, 'By the rule')).toMatch(/reference target/);
  const reference = Number(/\d+/.exec(await says(page, 'Placed relative to'))?.[0]);
  expect(map.surfaces.find(({ id }: { id: number }) => id === reference).step).toBeLessThan(last.step);
});

test('another run takes the card away', async ({ page }) => {
  const bench = await driveRoute(page);
  const [x, y] = await sweep(bench, /^Surface/, (x, y) => page.mouse.move(x, y));
  await page.mouse.click(x, y);
  await expect(going(page)).toBeVisible();
  await page.getByRole('combobox', { name: /^World/ }).selectOption({ index: 1 });
  await expect(card(page)).toHaveCount(0);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true });

  test('a finger near a thing brings its card up as a sheet', async ({ page }) => {
    const bench = await driveRoute(page);
    await sweep(bench, /^(Surface|Exit|Local)/, (x, y) => page.touchscreen.tap(x, y));
    const box = await card(page).boundingBox();
    expect(Math.round((box?.y ?? 0) + (box?.height ?? 0))).toBe(844);
    expect(box?.width).toBe(390);
    await expect(going(page)).toBeVisible();
    await card(page).getByRole('button', { name: 'Close the card' }).click();
    await expect(card(page)).toHaveCount(0);
  });
});
