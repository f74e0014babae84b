import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { BenchPage, roomLog } from './bench';

const panel = (page: Page) => page.getByRole('complementary', { name: 'Plots' });
const reader = (page: Page) => panel(page).getByRole('slider', { name: 'Moment in the plots' });
const chart = (page: Page, caption: string) => panel(page).getByRole('figure').filter({ hasText: caption });
const places = (page: Page) => panel(page).getByRole('toolbar', { name: 'Places' }).getByRole('button');
const clock = (page: Page) => page.locator('output').first().innerText();

/** Opens the page on its two memories and lets the robot drive its whole route. */
async function driveRoute(page: Page, address = ''): Promise<BenchPage> {
  const bench = new BenchPage(page);
  await bench.open(address);
  await expect(bench.memory).toHaveCount(2);
  await page.getByRole('button', { name: 'To the end' }).click();
  await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled({ timeout: 50_000 });
  return bench;
}

/** What the table says of a mapper under a heading. */
async function value(page: Page, mapper: string, heading: string): Promise<number> {
  const table = panel(page).getByRole('table');
  const headings = await table.getByRole('columnheader').allInnerTexts();
  const row = table.getByRole('row').filter({ hasText: mapper });
  return Number(await row.getByRole('cell').nth(headings.indexOf(heading) - 1).innerText());
}

/** Seconds of a moment as the page writes it. */
function seconds(text: string): number {
  const [, minutes, rest] = /(\d+):([\d.]+)/.exec(text) ?? [];
  return Number(minutes) * 60 + Number(rest);
}

test('the plots come only when somebody asks for them, and end in what the page tells', async ({ page }) => {
  const bench = await driveRoute(page);
  const fetched = () =>
    page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name).filter((name) => /Panel-.*\.(js|css)$/.test(name)).length);
  expect(await fetched()).toBe(0);
  await page.keyboard.press('l');
  await expect(reader(page)).toBeVisible();
  await expect(panel(page).locator('.uplot')).toHaveCount(3);
  expect(await fetched()).toBeGreaterThan(0);
  for (const [index, mapper] of ['consensus', 'odometry'].entries()) {
    const told = await bench.memory.nth(index).innerText();
    const [, surfaces] = /(\d+) surfaces/.exec(told) ?? [];
    const [, metres, degrees] = /off by ([\d.]+) m, (\d+)°/.exec(told) ?? [];
    await expect.poll(() => value(page, mapper, 'surfaces')).toBe(Number(surfaces));
    expect(await value(page, mapper, 'off, m')).toBeCloseTo(Number(metres), 1);
    expect(Math.abs((await value(page, mapper, 'turned, °')) - Number(degrees))).toBeLessThan(1);
  }
  await page.keyboard.press('l');
  await expect(panel(page)).toHaveCount(0);
  await page.getByRole('button', { name: 'Plots', exact: true }).click();
  await expect(panel(page)).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(panel(page)).toHaveCount(0);
});

test('a click on a point leads to its moment, and the curves go on beyond it', async ({ page }) => {
  await driveRoute(page);
  const end = seconds(await clock(page));
  await page.keyboard.press('l');
  const over = chart(page, 'Surfaces in the memory').locator('.u-over');
  const box = await over.boundingBox();
  if (!box) throw new Error('there is no chart');
  await over.click({ position: { x: box.width / 2, y: box.height / 2 } });
  await expect.poll(async () => Math.abs(seconds(await clock(page)) - end / 2)).toBeLessThan(2);
  await page.mouse.move(0, 0);
  await expect(reader(page)).toContainText('now');
  expect(Math.abs(seconds(await reader(page).innerText()) - seconds(await clock(page)))).toBeLessThan(1);
  // What lies ahead is still there to click on.
  await over.click({ position: { x: box.width * 0.9, y: box.height / 2 } });
  await expect.poll(async () => Math.abs(seconds(await clock(page)) - 0.9 * end)).toBeLessThan(2);
});

test('arrows walk from view to view and Enter goes there, without driving the robot', async ({ page }) => {
  const bench = await driveRoute(page);
  const driven = await bench.travelled();
  await page.keyboard.press('l');
  await reader(page).focus();
  const last = Number(await reader(page).getAttribute('aria-valuemax'));
  await page.keyboard.press('Home');
  await expect(reader(page)).toHaveAttribute('aria-valuenow', '0');
  await expect(reader(page)).toHaveAttribute('aria-valuetext', /0:00\.0\. .*consensus: view 1, off by 0\.00 metres and 0\.0 degrees, \d+ surfaces/);
  await page.keyboard.press('PageUp');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowLeft');
  await expect(reader(page)).toHaveAttribute('aria-valuenow', '10');
  const moment = /[\d:.]+/.exec(await reader(page).innerText())?.[0];
  await page.keyboard.press('Enter');
  await expect.poll(() => clock(page)).toBe(moment);
  expect(last).toBeGreaterThan(10);
  await page.getByRole('button', { name: 'To the end' }).click();
  await expect.poll(() => bench.travelled()).toBe(driven);
});

test('another branch has other curves', async ({ page }) => {
  await driveRoute(page);
  await page.keyboard.press('l');
  await reader(page).focus();
  const last = async () => Number(await reader(page).getAttribute('aria-valuemax'));
  const all = await last();
  await page.keyboard.press('Home');
  for (let press = 0; press < 3; press += 1) await page.keyboard.press('PageUp');
  await page.keyboard.press('Enter');
  await page.keyboard.press('x');
  await expect.poll(last).toBeLessThan(all / 2);
  await page.getByRole('button', { name: /^Other branch/ }).click();
  await page.getByRole('button', { name: 'To the end' }).click();
  await expect.poll(last).toBe(all);
});

test('the places stand as a schematic, and each tells its story', async ({ page }) => {
  const bench = await driveRoute(page);
  await page.keyboard.press('l');
  await panel(page).getByRole('button', { name: 'Places' }).click();
  const [, count] = /(\d+) local spaces/.exec(await bench.memory.first().innerText()) ?? [];
  await expect(places(page)).toHaveCount(Number(count));
  await expect(panel(page).getByRole('button', { name: /where the robot is$/ })).toHaveCount(1);
  await places(page).first().focus();
  await page.keyboard.press('ArrowRight');
  await expect(places(page).nth(1)).toBeFocused();
  await page.keyboard.press('Enter');
  const story = panel(page).getByRole('status');
  await expect(story).toContainText(/Opened in view \d+, once the robot had gone through exit \d+, \d\.\d\d m wide\./);
  await expect(story).toContainText(/m² of floor seen, \d+ surfaces\./);
  await expect(story).toContainText(/Leads to space 0 through exit \d+/);
  const going = panel(page).getByRole('button', { name: /^Go to .*, when it was opened$/ });
  const moment = /Go to ([\d:.]+),/.exec(await going.innerText())?.[1];
  await going.click();
  await expect.poll(() => clock(page)).toBe(moment);
  await expect(places(page)).toHaveCount(2);
});

test('Why? and the plots take each other’s place', async ({ page }) => {
  await driveRoute(page);
  await page.keyboard.press('l');
  await expect(panel(page)).toBeVisible();
  await page.keyboard.press('y');
  await expect(page.getByRole('complementary', { name: /^Why\?/ })).toBeVisible();
  await expect(panel(page)).toHaveCount(0);
  await page.keyboard.press('l');
  await expect(panel(page)).toBeVisible();
  await expect(page.getByRole('complementary', { name: /^Why\?/ })).toHaveCount(0);
});

test('a log has no truth, so nothing is said about errors', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(40) });
  await expect(page.getByRole('slider', { name: 'Timeline' })).toHaveValue('40');
  await page.keyboard.press('l');
  await expect(panel(page)).toContainText('A log does not say where the robot truly was');
  await expect(panel(page).locator('.uplot')).toHaveCount(2);
  await expect(panel(page).getByRole('columnheader', { name: 'off, m' })).toHaveCount(0);
  expect(await value(page, 'consensus', 'surfaces')).toBe(await bench.surfaces());
});

test('who knows no local spaces has no wideness and no places', async ({ page }) => {
  const bench = await driveRoute(page);
  await page.keyboard.press('l');
  await bench.chip('consensus').click();
  await expect(panel(page)).toContainText('odometry knows no local spaces');
  await panel(page).getByRole('button', { name: 'Places' }).click();
  await expect(panel(page)).toContainText('None of these mappers knows what a local space is.');
});

test('the plots keep to the policy', async ({ page }) => {
  const complaints: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  const bench = await driveRoute(page);
  await page.keyboard.press('l');
  await expect(panel(page).locator('.uplot')).toHaveCount(3);
  await page.getByRole('button', { name: 'Switch to dark' }).click();
  await bench.chip('perceptual').click();
  await panel(page).getByRole('button', { name: 'perceptual', exact: true }).click();
  await panel(page).getByRole('button', { name: '°', exact: true }).click();
  await page.getByRole('button', { name: 'Go Home', exact: true }).click();
  await page.getByLabel('Speed').selectOption('Max');
  await expect(page.getByText(/Home: it stopped by itself/).first()).toBeVisible();
  await panel(page).getByRole('button', { name: 'Places' }).click();
  await places(page).first().click();
  expect(complaints).toEqual([]);
});

for (const colorScheme of ['light', 'dark'] as const) {
  for (const viewport of [
    { width: 1440, height: 900 },
    { width: 1024, height: 768 },
    { width: 390, height: 844 },
  ]) {
    test.describe(`${colorScheme} at ${viewport.width} × ${viewport.height}`, () => {
      test.use({ colorScheme, viewport });

      test('axe finds nothing to object to in the plots', async ({ page }) => {
        await driveRoute(page);
        await page.getByRole('button', { name: 'Plots', exact: true }).click();
        await expect(panel(page).locator('.uplot')).toHaveCount(3);
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        await panel(page).getByRole('button', { name: 'Places' }).click();
        await places(page).nth(1).click();
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        expect(wider).toBeLessThanOrEqual(0);
        if (viewport.width > 700) {
          // Nothing that the robot is told with lies below the panel.
          const right = await panel(page).boundingBox();
          const told = await page.getByRole('button', { name: 'Go Home', exact: true }).boundingBox();
          expect((right?.y ?? 0) + (right?.height ?? 0)).toBeLessThanOrEqual(told?.y ?? 0);
        }
      });
    });
  }
}
