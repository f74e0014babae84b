import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { BenchPage } from './bench';

const question = (page: Page) => page.getByText('which of them would you trust to go home?');

test('a newcomer meets one bad robot, two memories of its drive, one question and one thing to do', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open('');
  await expect(page.getByRole('combobox', { name: 'Robot' })).toHaveValue('bad');
  await expect(bench.memory).toHaveCount(2);
  await expect(page.getByRole('heading', { name: 'The robot’s memory by consensus' })).toBeVisible();
  await expect(page.getByRole('heading', { name: 'The robot’s memory by odometry' })).toBeVisible();
  await expect(question(page)).toBeVisible();
  await expect(page.getByRole('button', { name: 'Take the controls' })).toBeVisible();
});

test('within three actions a newcomer drives, and the map grows', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open('');
  await page.getByRole('button', { name: 'Take the controls' }).click();
  await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled();
  const [driven, surfaces] = [await bench.travelled(), await bench.surfaces()];
  await page.keyboard.down('ArrowUp');
  await expect.poll(() => bench.travelled()).toBeGreaterThan(driven + 1);
  await expect.poll(() => bench.surfaces()).toBeGreaterThan(surfaces);
  await page.keyboard.up('ArrowUp');
});

test('whichever memory is trusted leads the robot home, and then the other from the same place', async ({ page }) => {
  test.setTimeout(120_000);
  const bench = new BenchPage(page);
  await bench.open('');
  const end = page.getByRole('button', { name: 'To the end' });
  await end.click();
  await expect.poll(() => bench.travelled()).toBeGreaterThan(15);
  await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled();
  const driven = await bench.travelled();
  await page.getByRole('button', { name: 'Trust odometry' }).click();
  await expect(page.getByText('On its way home by odometry: it only counts its wheels.')).toBeVisible();
  // Whom one trusts does not change its place.
  await expect(page.getByRole('heading', { level: 2 })).toContainText(['The world', 'consensus', 'odometry']);
  await end.click();
  const odometry = page.getByText(/By odometry the robot (gave up|stopped) [\d.]+ m from where it began/);
  await expect(odometry).toBeVisible();
  await page.getByRole('button', { name: 'Now trust consensus' }).click();
  await expect(page.getByText('On its way home by consensus')).toBeVisible();
  expect(await bench.travelled()).toBeLessThan(driven + 3);
  await end.click();
  const consensus = page.getByText(/By consensus the robot stopped ([\d.]+) m from where it began, sure to be home/);
  await expect(consensus).toBeVisible();
  await expect(odometry).toBeVisible();
  await expect(page.getByText('drive further, and ask again')).toBeVisible();
  // A run that goes on after a way home keeps the memory that led it.
  await page.keyboard.press('ArrowUp');
  await expect(page.getByText('start over to trust another')).toBeVisible();
  await expect(page.getByRole('button', { name: 'Trust consensus' })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Trust odometry' })).toHaveCount(0);
});

test('the question can be put away, and is not asked about a single memory', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await expect(question(page)).toHaveCount(0);
  await bench.chip('odometry').click();
  await expect(question(page)).toBeVisible();
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await expect(question(page)).toHaveCount(0);
});

test('the address says which memories the page opens on, and hears of those that there are not', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open('?mappers=perceptual,transform,odometry');
  await expect(bench.memory).toHaveCount(3);
  await bench.open('?mappers=perceptual,telepathy');
  await expect(page.getByRole('alert')).toContainText('There is no mapper called “telepathy”');
  await expect(bench.memory).toHaveCount(2);
});

for (const colorScheme of ['light', 'dark'] as const) {
  for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]] as const) {
    test.describe(`${colorScheme} at ${width} × ${height}`, () => {
      test.use({ colorScheme, viewport: { width, height } });

      test('the first scene fits, and axe has nothing to object to', async ({ page }) => {
        await new BenchPage(page).open('');
        await expect(question(page)).toBeVisible();
        const over = await page.evaluate(() => {
          const { scrollWidth, scrollHeight } = document.documentElement;
          return [scrollWidth - innerWidth, scrollHeight - innerHeight];
        });
        expect(Math.max(...over)).toBeLessThanOrEqual(0);
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      });
    });
  }
}
