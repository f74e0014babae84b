import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { BenchPage } from './bench';

const clock = (page: Page) => page.locator('output').first().innerText();
const commands = async (bench: BenchPage) =>
  (JSON.parse((await bench.save('Session')).bytes.toString()) as { source: { commands: unknown[] } }).source.commands;

test('what was told can be undone and done again', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  await bench.step('Turn left');
  await bench.step('Drive ahead');
  const [both, end] = [await commands(bench), await clock(page)];
  await page.keyboard.press('Control+z');
  await expect.poll(async () => (await commands(bench)).length).toBe(both.length - 1);
  await page.keyboard.press('Control+Shift+Z');
  await expect.poll(() => commands(bench)).toEqual(both);
  await expect.poll(() => clock(page)).toBe(end);
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(async () => (await commands(bench)).length).toBe(both.length - 2);
});

test('going on from an earlier moment keeps the other future, and leads back to it', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  await bench.step('Turn left');
  await bench.step('Drive ahead');
  const old = await commands(bench);
  const slider = page.getByRole('slider', { name: 'Timeline' });
  await slider.fill(String(Math.round(Number(await slider.getAttribute('max')) / 2)));
  await expect(page.getByRole('button', { name: 'Play' })).toBeEnabled();
  await bench.step('Turn right');
  const other = page.getByRole('button', { name: 'Other branch (1)' });
  await expect(other).toBeVisible();
  const fresh = await commands(bench);
  expect(fresh).not.toEqual(old);
  await other.click();
  await expect.poll(() => commands(bench)).toEqual(old);
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await page.keyboard.press('v');
  await expect.poll(() => commands(bench)).toEqual(fresh);
});
