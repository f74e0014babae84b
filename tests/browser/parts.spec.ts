import { expect, test } from '@playwright/test';
import { BenchPage } from './bench';

const REST = '**/rest-*.wasm';

test.use({ serviceWorkers: 'block' });

test('the first part of the engine is enough to open the page and to drive', async ({ page }) => {
  const wanted: string[] = [];
  await page.route(REST, (route) => {
    wanted.push(route.request().resourceType());
    return route.abort();
  });
  const bench = new BenchPage(page);
  await bench.open();
  for (const key of ['ArrowUp', 'ArrowRight']) {
    await page.keyboard.down(key);
    await page.waitForTimeout(1000);
    await page.keyboard.up(key);
  }
  const driven = await bench.travelled();
  await page.keyboard.down('ArrowUp');
  await expect.poll(() => bench.travelled()).toBeGreaterThan(driven);
  await page.keyboard.up('ArrowUp');
  expect(wanted, 'the rest is not waited for; if it is: npm --prefix web run profile').toEqual(['fetch']);
});

test('the rest is waited for when something of it is called that has not come', async ({ page }) => {
  const wanted: string[] = [];
  await page.route(REST, (route) => {
    wanted.push(route.request().resourceType());
    return wanted.length === 1 ? route.abort() : route.continue();
  });
  const bench = new BenchPage(page);
  await bench.open();
  await page.getByRole('button', { name: 'Go Home', exact: true }).click();
  await expect(page.getByText(/^Home:/).first()).toBeVisible({ timeout: 60_000 });
  expect(wanted).toEqual(['fetch', 'xhr']);
});
