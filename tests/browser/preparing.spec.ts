import { expect, test, type Page } from '@playwright/test';
import { BenchPage } from './bench';

const cell = {
  name: 'cell.world.json',
  content: JSON.stringify({
    format: 'cogmap-world/1',
    name: 'Cell',
    walls: [[[0, 0], [5, 0], [5, 4], [0, 4], [0, 0]]],
    start: { position: [1, 2] },
  }),
};

/** Opens the page with the engine still on its way; what is returned lets it come. */
async function openSlowly(page: Page): Promise<() => void> {
  let come = (): void => undefined;
  const coming = new Promise<void>((resolve) => (come = resolve));
  await page.route(/\/first-[^/]*\.wasm$/, async (route) => {
    await coming;
    await route.continue();
  });
  await page.goto('./?mappers=consensus');
  await expect(page.getByRole('button', { name: 'Open…' })).toBeEnabled();
  return come;
}

test('a file that is brought while the laboratory is prepared is opened as soon as there is one', async ({ page }) => {
  const bench = new BenchPage(page);
  const come = await openSlowly(page);
  await bench.drop(cell);
  await expect(page.getByText('Reading cell.world.json…')).toBeVisible();
  come();
  await expect(bench.choice).toContainText('Cell');
  await expect.poll(() => bench.surfaces()).toBeGreaterThan(0);
  await expect(page.getByRole('alert')).toBeEmpty();
});

test('a link that is pasted while the laboratory is prepared is opened as soon as there is one', async ({ page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop(cell);
  await expect(bench.choice).toContainText('Cell');
  const link = await bench.link();
  await page.goto('about:blank');
  const come = await openSlowly(page);
  await page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  come();
  await expect(bench.choice).toContainText('Cell');
  await expect(page.getByRole('alert')).toBeEmpty();
});

test('what needs a run cannot be had while the laboratory is prepared, and does no harm by key', async ({ page }) => {
  const bench = new BenchPage(page);
  const errors: Error[] = [];
  page.on('pageerror', (error) => errors.push(error));
  const come = await openSlowly(page);
  for (const name of ['Build', 'Save, share', 'Start over', 'Play', 'Go Home']) {
    await expect(page.getByRole('button', { name, exact: true })).toBeDisabled();
  }
  for (const key of ['r', 'f', 'u', 'h', 'n', '.', 'Space', 'Control+z', 'ArrowUp']) await page.keyboard.press(key);
  await expect(page.getByText('Preparing the laboratory…').first()).toBeVisible();
  await expect(page.getByRole('alert')).toBeEmpty();
  come();
  await expect.poll(() => bench.surfaces()).toBeGreaterThan(0);
  await expect(page.getByRole('alert')).toBeEmpty();
  await bench.takeOver();
  await bench.hold('ArrowUp', 500);
  expect(errors).toEqual([]);
});
