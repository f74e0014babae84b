import { expect, test, type Page } from '@playwright/test';
import { BenchPage } from './bench';

const marks = (page: Page) => page.getByRole('toolbar', { name: 'Events' }).getByRole('button');
const clock = (page: Page) => page.locator('output').first().innerText();

/** Opens the page and lets the robot drive its whole route. */
async function driveRoute(page: Page): Promise<BenchPage> {
  const bench = new BenchPage(page);
  await bench.open();
  await page.getByRole('button', { name: 'To the end' }).click();
  await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled({ timeout: 50_000 });
  await expect(marks(page).first()).toBeVisible();
  return bench;
}

test('events stand on the timeline under their names, and lead back to their moment', async ({ page }) => {
  await driveRoute(page);
  const names = await marks(page).evaluateAll((all) => all.map((mark) => mark.getAttribute('aria-label') ?? ''));
  expect(names.filter((name) => /Local space \d+ opened behind exit \d+/.test(name)).length).toBeGreaterThan(1);
  const [first] = names;
  await marks(page).first().focus();
  await page.keyboard.press('Enter');
  await expect.poll(() => clock(page)).toBe(first?.split(': ')[0]);
  expect(await marks(page).count()).toBe(names.length);
});

test('arrows walk along the events, and keys jump from one to the next', async ({ page }) => {
  await driveRoute(page);
  await marks(page).first().focus();
  await page.keyboard.press('ArrowRight');
  await expect(marks(page).nth(1)).toBeFocused();
  await page.keyboard.press('Enter');
  const second = (await marks(page).nth(1).getAttribute('aria-label'))?.split(': ')[0];
  await expect.poll(() => clock(page)).toBe(second);
  await page.keyboard.press('<');
  await expect.poll(() => clock(page)).not.toBe(second);
  await page.keyboard.press('>');
  await expect.poll(() => clock(page)).toBe(second);
});

test('going home is marked', async ({ page }) => {
  await driveRoute(page);
  await page.getByRole('button', { name: 'Go Home', exact: true }).click();
  await expect(page.getByRole('button', { name: /: .*Told to go home/ })).toBeVisible();
});
