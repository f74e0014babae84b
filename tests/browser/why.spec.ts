import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { BenchPage } from './bench';

const panel = (page: Page) => page.getByRole('complementary', { name: /^Why\?/ });
const current = (page: Page) => panel(page).locator('[aria-current="step"]');

/** Opens the page, lets the robot take some views and asks why the memory is as it is. */
async function ask(page: Page): Promise<BenchPage> {
  const bench = new BenchPage(page);
  await bench.open();
  await page.getByRole('button', { name: 'Why?', exact: true }).first().click();
  await expect(current(page)).toHaveText('Scan');
  await expect(page.getByRole('button', { name: 'Play' })).toBeEnabled();
  return bench;
}

test('a step is taken apart in the thesis’s order, forward and back', async ({ page }) => {
  await ask(page);
  await expect(panel(page)).toContainText('by consensus');
  const stages = (await panel(page).getByRole('listitem').getByRole('button').allInnerTexts()).map((text) => text.trim());
  expect(stages.slice(0, 3)).toEqual(['Scan', 'Surfaces', 'Recognised']);
  expect(stages.indexOf('Placed')).toBeGreaterThan(stages.indexOf('Recognised'));
  for (const stage of stages.slice(1)) {
    await panel(page).getByRole('button', { name: 'Next stage' }).click();
    await expect(current(page)).toHaveText(stage);
  }
  await page.keyboard.press('j');
  await expect(current(page)).toHaveText(stages.at(-2) ?? '');
});

test('each stage is pointed out in the memory', async ({ page }) => {
  const bench = await ask(page);
  const pictures = new Set<string>();
  const picture = async () => (await bench.memory.getByRole('img').screenshot()).toString('base64');
  for (let stage = 0; stage < 4; stage += 1) {
    await page.waitForTimeout(400);
    pictures.add(await picture());
    await page.keyboard.press('k');
  }
  expect(pictures.size).toBe(4);
});

test('the figures of the pairs are there on demand', async ({ page }) => {
  await ask(page);
  await panel(page).getByRole('button', { name: 'Recognised' }).click();
  await panel(page).getByText('How well each pair fits').click();
  const rows = panel(page).getByRole('row');
  const [, recognised] = /(\d+) of \d+ were recognised/.exec(await panel(page).innerText()) ?? [];
  expect(await rows.count()).toBe(Number(recognised) + 1);
});

test('the walk goes on into the next view, and back into the one before', async ({ page }) => {
  await ask(page);
  const view = async () => Number(/view (\d+)/.exec(await panel(page).innerText())?.[1]);
  const first = await view();
  await page.keyboard.press('j');
  await expect.poll(view).toBe(first - 1);
  await page.keyboard.press('k');
  await expect.poll(view).toBe(first);
  await expect(current(page)).toHaveText('Scan');
});

test('behind the last stage there is nothing where the robot rests', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  await page.getByRole('button', { name: 'Why?', exact: true }).first().click();
  await expect(current(page)).toHaveText('Scan');
  const stages = panel(page).getByRole('listitem').getByRole('button');
  const last = (await stages.last().innerText()).trim();
  await stages.last().click();
  await expect(current(page)).toHaveText(last);
  for (let press = 0; press < 3; press += 1) await page.keyboard.press('k');
  await page.waitForTimeout(500);
  await expect(current(page)).toHaveText(last);
});

test('the reference target is told with its runners-up', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await page.getByRole('button', { name: 'perceptual', exact: true }).click();
  await page.getByRole('button', { name: 'Why?', exact: true }).nth(1).click();
  await expect(panel(page)).toContainText('by perceptual');
  await panel(page).getByRole('button', { name: 'Reference target' }).click();
  await expect(panel(page)).toContainText(/Surface \d+ became the reference target\./);
  const [, candidates] = /best of (\d+) candidates/.exec(await panel(page).innerText()) ?? [];
  await panel(page).getByText('All candidates').click();
  expect(await panel(page).getByRole('row').count()).toBe(Number(candidates) + 1);
});

test('what does not exist for a mapper is left out', async ({ page }) => {
  await ask(page);
  const titles = () => panel(page).getByRole('listitem').getByRole('button').allInnerTexts();
  await page.getByRole('button', { name: 'transform', exact: true }).click();
  await page.getByRole('button', { name: 'Why?', exact: true }).nth(1).click();
  await expect(panel(page)).toContainText('by transform');
  const stages = (await titles()).map((title) => title.trim());
  expect(stages).toContain('Movement');
  expect(stages).not.toContain('Reference target');
  expect(stages).not.toContain('Wideness');
});

test('on the way home the options are weighed and one is chosen', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await page.getByLabel('Speed').selectOption('Max');
  await expect.poll(() => bench.travelled()).toBeGreaterThan(8);
  await page.getByRole('button', { name: 'recommended' }).click();
  await page.getByRole('button', { name: /^faithful/ }).click();
  await page.getByLabel('Speed').selectOption('2×');
  await page.getByRole('button', { name: 'Go Home', exact: true }).click();
  await expect(page.getByText(/^By its sense of direction: /).first()).toBeVisible();
  await page.getByRole('button', { name: 'Why?', exact: true }).first().click();
  await panel(page).getByRole('button', { name: 'Choice' }).click();
  await expect(panel(page)).toContainText(/It (took way \d+|decided) after view \d+: /);
});

for (const colorScheme of ['light', 'dark'] as const) {
  for (const viewport of [
    { width: 1440, height: 900 },
    { width: 1024, height: 768 },
    { width: 390, height: 844 },
  ]) {
    test.describe(`${colorScheme} at ${viewport.width} × ${viewport.height}`, () => {
      test.use({ colorScheme, viewport });

      test('axe finds nothing to object to in Why?', async ({ page }) => {
        await ask(page);
        for (const presses of [2, 2]) {
          for (let press = 0; press < presses; press += 1) await page.keyboard.press('k');
          await panel(page).getByRole('group').first().waitFor();
          expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        }
        const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        expect(wider).toBeLessThanOrEqual(0);
        await page.keyboard.press('Escape');
        await expect(panel(page)).toHaveCount(0);
      });
    });
  }
}
