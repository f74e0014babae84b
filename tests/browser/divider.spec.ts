import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { BenchPage } from './bench';

test.describe.configure({ timeout: 120_000 });

const divider = (page: Page) => page.getByRole('separator', { name: 'Size of “The world”' });
const value = async (page: Page) => Number(await divider(page).getAttribute('aria-valuenow'));

/** Drags the divider by so many pixels, in steps as a hand does. */
async function drag(page: Page, right: number, down: number): Promise<void> {
  const { x = 0, y = 0, width = 0, height = 0 } = (await divider(page).boundingBox()) ?? {};
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + right, y + height / 2 + down, { steps: 12 });
  await page.mouse.up();
}

/** Whether the canvas of a view has a pixel for each of the screen's. */
async function sharp(page: Page, view: string): Promise<boolean> {
  const picture = page.locator(`#${view}-view .picture`);
  const { width = 0, height = 0 } = (await picture.boundingBox()) ?? {};
  return page.evaluate(
    async ([view, width, height]) => {
      const canvas = document.querySelector(`#${view}-view canvas`);
      const image = canvas instanceof HTMLCanvasElement ? await createImageBitmap(canvas) : undefined;
      return Math.abs((image?.width ?? 0) - width) <= 1 && Math.abs((image?.height ?? 0) - height) <= 1;
    },
    [view, width, height] as const,
  );
}

const wide = async (page: Page, view: string) => (await page.locator(`#${view}-view`).boundingBox())?.width ?? 0;
const high = async (page: Page, view: string) => (await page.locator(`#${view}-view`).boundingBox())?.height ?? 0;

test.describe('side by side', () => {
  test.use({ viewport: { width: 1440, height: 900 } });

  test('the divider is dragged, the pictures stay sharp, and a reload keeps its place', async ({ page }) => {
    const bench = new BenchPage(page);
    await bench.open();
    await expect(divider(page)).toHaveAttribute('aria-orientation', 'vertical');
    expect(await value(page)).toBe(50);
    const before = await wide(page, 'world');
    await drag(page, -300, 0);
    expect(Math.abs((await wide(page, 'world')) - (before - 300))).toBeLessThan(4);
    for (const view of ['world', 'first']) await expect.poll(() => sharp(page, view)).toBe(true);
    const moved = await value(page);
    await page.reload();
    await expect.poll(() => bench.surfaces()).toBeGreaterThan(0);
    expect(await value(page)).toBe(moved);
    await divider(page).dblclick();
    expect(await value(page)).toBe(50);
  });

  test('dragged to the edge it folds a view away, and a drag or Enter brings it back', async ({ page }) => {
    const bench = new BenchPage(page);
    await bench.open();
    await drag(page, 800, 0);
    await expect(bench.memory).toBeHidden();
    await expect(divider(page)).toHaveAttribute('aria-valuenow', '100');
    await expect.poll(() => sharp(page, 'world')).toBe(true);
    await page.reload();
    await expect(bench.world).toContainText('m driven');
    await expect(bench.memory).toBeHidden();
    await drag(page, -400, 0);
    await expect(bench.memory).toBeVisible();
    await expect.poll(() => sharp(page, 'first')).toBe(true);
    await drag(page, -1200, 0);
    await expect(bench.world).toBeHidden();
    // To change the building it has to be seen.
    await page.keyboard.press('b');
    await expect(bench.world).toBeVisible();
  });

  test('all of it can be done by keyboard, which then does not drive', async ({ page }) => {
    const bench = new BenchPage(page);
    await bench.open();
    await bench.takeOver();
    const driven = await bench.travelled();
    await divider(page).focus();
    await page.keyboard.press('ArrowLeft');
    expect(await value(page)).toBe(48);
    await page.keyboard.press('Shift+ArrowRight');
    expect(await value(page)).toBe(58);
    await page.keyboard.press('Enter');
    await expect(bench.world).toBeHidden();
    await expect(divider(page)).toHaveAttribute('aria-valuetext', 'folded away');
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await page.keyboard.press('Enter');
    expect(await value(page)).toBe(58);
    await page.keyboard.press('End');
    await expect(bench.memory).toBeHidden();
    await page.keyboard.press('ArrowLeft');
    expect(await value(page)).toBe(85);
    await page.keyboard.press('Home');
    await expect(bench.world).toBeHidden();
    await page.keyboard.press('ArrowRight');
    expect(await value(page)).toBe(15);
    expect(await bench.travelled()).toBe(driven);
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  });

  test('among more views it stands between the world and the memories', async ({ page }) => {
    const bench = new BenchPage(page);
    await bench.open();
    for (const [index, mapper] of ['perceptual', 'transform', 'odometry'].entries()) {
      await bench.chip(mapper).click();
      await expect(bench.memory).toHaveCount(index + 2);
      const before = await wide(page, 'world');
      await drag(page, 120, 0);
      expect((await wide(page, 'world')) - before).toBeGreaterThan(100);
      const [world, first] = [await page.locator('#world-view').boundingBox(), await page.locator('#first-view').boundingBox()];
      expect((first?.x ?? 0) - (world?.x ?? 0) - (world?.width ?? 0)).toBeCloseTo(10.5, 0);
      await page.keyboard.press('Escape');
      await divider(page).dblclick();
    }
    await expect(bench.memory).toHaveCount(4);
    await divider(page).focus();
    await page.keyboard.press('Enter');
    await expect(bench.world).toBeHidden();
    await expect(bench.memory).toHaveCount(4);
    expect(Math.abs((await wide(page, 'first')) - (await wide(page, 'second')))).toBeLessThan(2);
    await bench.chip('world').click();
    for (const mapper of ['perceptual', 'transform', 'odometry']) await bench.chip(mapper).click();
    await expect(page.getByRole('separator')).toHaveCount(0);
    await expect(bench.memory).toBeVisible();
  });
});

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(`stacked on a phone, ${colorScheme}`, () => {
    test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, colorScheme });

    test('a finger drags it', async ({ page }) => {
      const bench = new BenchPage(page);
      await bench.open();
      await expect(divider(page)).toHaveAttribute('aria-orientation', 'horizontal');
      const grip = await divider(page).locator('.grip').boundingBox();
      expect(Math.min(grip?.width ?? 0, grip?.height ?? 0)).toBeGreaterThanOrEqual(44);
      const before = await high(page, 'world');
      const [x, y] = [(grip?.x ?? 0) + 22, (grip?.y ?? 0) + 30];
      const touch = await page.context().newCDPSession(page);
      await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x, y }] });
      for (const down of [20, 50, 80]) {
        await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [{ x, y: y + down }] });
      }
      await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
      await expect.poll(async () => Math.round((await high(page, 'world')) - before)).toBe(80);
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      expect(wider).toBeLessThanOrEqual(0);
    });
  });
}
