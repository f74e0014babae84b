import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { BenchPage, roomLog } from './bench';

const sizes = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 390, height: 844 },
];

for (const colorScheme of ['light', 'dark'] as const) {
  for (const viewport of sizes) {
    test.describe(`${colorScheme} at ${viewport.width} × ${viewport.height}`, () => {
      test.use({ colorScheme, viewport });

      test('axe finds nothing to object to', async ({ page }) => {
        const bench = new BenchPage(page);
        await bench.open();
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        await page.keyboard.press('?');
        await expect(page.getByRole('dialog')).toBeVisible();
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        await page.keyboard.press('Escape');
        await bench.drop({ name: 'none.log', content: 'nothing' });
        await expect(page.getByRole('alert')).not.toBeEmpty();
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      });

      test('axe finds nothing to object to in the text view and a card', async ({ page }) => {
        await new BenchPage(page).open();
        await page.keyboard.press('m');
        const surface = page.getByRole('complementary', { name: 'Text view' }).getByRole('button', { name: /^Surface/ }).first();
        await expect(surface).toBeVisible();
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        await surface.click();
        await expect(page.getByRole('group', { name: /^Surface/ })).toBeVisible();
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      });

      test('axe finds nothing to object to in the menus', async ({ page }) => {
        await new BenchPage(page).open();
        // On a phone the files are folded away.
        if (viewport.width < 768) await page.getByRole('button', { name: 'Set-up', exact: true }).click();
        for (const name of ['Build', 'Save, share', 'Language', 'recommended']) {
          await page.getByRole('button', { name, exact: true }).click();
          const choices = page.getByRole('group', { name, exact: true }).getByRole('list');
          await expect(choices).toBeVisible();
          expect((await new AxeBuilder({ page }).analyze()).violations, name).toEqual([]);
          await page.keyboard.press('Escape');
          await expect(choices).toBeHidden();
        }
      });

      test('nothing hangs over the edge', async ({ page }) => {
        await new BenchPage(page).open();
        const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        expect(wider).toBeLessThanOrEqual(0);
      });
    });
  }
}

test('axe finds nothing to object to while a log is mapped', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(60) });
  await expect(page.getByRole('heading', { name: 'The log by its odometry alone' })).toBeVisible();
  await page.getByRole('slider', { name: 'Timeline' }).fill('5');
  await expect(page.getByRole('progressbar')).toBeVisible();
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});

test('every control can be reached by keyboard and shows that it has the focus', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const controls = await page.locator('button:visible:enabled, select:visible, input:visible').count();
  const reached = new Set<string>();
  for (let press = 0; press < controls + 5; press += 1) {
    await page.keyboard.press('Tab');
    const focus = await page.evaluate(() => {
      const element = document.activeElement;
      if (!element || element === document.body) return undefined;
      const all = [...document.querySelectorAll('button, select, input')];
      return { index: String(all.indexOf(element)), outline: getComputedStyle(element).outlineStyle };
    });
    if (!focus) continue;
    expect(focus.outline).not.toBe('none');
    reached.add(focus.index);
  }
  expect(reached.size).toBeGreaterThanOrEqual(controls - 1);
});

test('the theme can be switched by hand and is remembered', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const paper = () => page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  const before = await paper();
  await page.getByRole('button', { name: 'Switch to dark' }).click();
  await expect.poll(paper).not.toBe(before);
  const dark = await paper();
  await bench.open();
  expect(await paper()).toBe(dark);
});
