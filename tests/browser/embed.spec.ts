import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { BenchPage } from './bench';

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(colorScheme, () => {
    test.use({ colorScheme, viewport: { width: 640, height: 420 } });

    test('an embedded page shows world, memory, play and Go Home, and nothing hangs over its edge', async ({ page }) => {
      const bench = new BenchPage(page);
      await bench.open('?embed&world=small-office&lesson=exits');
      await expect(bench.world).toBeVisible();
      await expect(page.getByRole('banner')).toBeHidden();
      await expect(page.getByRole('slider')).toBeHidden();
      await expect(page.getByRole('alert')).toBeEmpty();
      await page.getByRole('button', { name: 'Pause' }).click();
      await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
      await page.getByRole('button', { name: 'Go Home', exact: true }).click();
      await expect(bench.going).toBeVisible();
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      const over = await page.evaluate(() => [
        document.documentElement.scrollWidth - innerWidth,
        document.documentElement.scrollHeight - innerHeight,
      ]);
      expect(Math.max(...over)).toBeLessThanOrEqual(0);
    });
  });
}

test('a lesson of another site embeds the page, and its keys drive what has the focus', async ({ page, baseURL }) => {
  const lesson = createServer((_, response) => {
    response.setHeader('Content-Type', 'text/html; charset=utf-8');
    response.end(`<h1>Lesson</h1><iframe title="Cogmap" width="640" height="420" src="${baseURL}/?embed&world=small-office"></iframe>`);
  });
  await new Promise<void>((listening) => lesson.listen(0, 'localhost', listening));
  await page.goto(`http://localhost:${(lesson.address() as AddressInfo).port}`);
  const frame = page.frameLocator('iframe');
  const home = frame.getByRole('button', { name: 'Go Home', exact: true });
  await expect(home).toBeVisible();
  await page.getByRole('heading', { name: 'Lesson' }).click();
  await page.keyboard.press('h');
  await frame.getByRole('button', { name: 'Pause' }).click();
  await expect(home, 'a key pressed in the lesson is none for the robot').toBeVisible();
  await page.keyboard.press('h');
  await expect(frame.getByRole('button', { name: 'Going home…' })).toBeVisible();
  await expect(frame.getByText(/Home: it stopped by itself/).first()).toBeVisible();
  await page.goto('about:blank');
  lesson.close();
});

test('the whole page opens at the very moment that the embedded one shows', async ({ page, context }) => {
  const bench = new BenchPage(page);
  await bench.open('?embed&world=tour&seed=3');
  await page.getByRole('button', { name: 'Pause' }).click();
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
  const driven = await bench.travelled();
  const opening = context.waitForEvent('page');
  await page.getByRole('link', { name: 'Open the whole page' }).click();
  const whole = new BenchPage(await opening);
  await expect(whole.choice).toHaveValue('tour');
  await expect(whole.page.getByLabel('Seed')).toHaveValue('3');
  await expect.poll(() => whole.travelled()).toBe(driven);
  expect(new URL(whole.page.url()).search).toBe('');
});

test('an embedded page neither keeps a run nor offers one', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open('?embed');
  await page.keyboard.press('h');
  await expect(bench.going).toBeVisible();
  await page.waitForTimeout(500);
  await bench.open();
  await page.waitForTimeout(500);
  await expect(page.getByRole('button', { name: 'Go on', exact: true })).toBeHidden();
});

test('the address chooses world, number and seed', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open('?world=generated&number=7&seed=12');
  await expect(bench.choice).toHaveValue('generated');
  await expect(page.getByLabel('Number')).toHaveValue('7');
  await expect(page.getByLabel('Seed')).toHaveValue('12');
});

test('an address that asks for what there is not is told what there is', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open('?world=<script>alert(1)</script>&seed=-1');
  await expect(page.getByRole('alert')).toContainText('no world called “<script>');
  await expect(page.getByRole('alert')).toContainText('small-office');
  await expect(page.getByRole('alert')).toContainText('“-1” is no seed');
  await expect(bench.choice).toHaveValue('office');
});
