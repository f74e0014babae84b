import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { BenchPage } from './bench';

const cogmap = process.env['COGMAP_BIN'] ?? resolve(__dirname, '../../target/debug/cogmap');

/** How the page says that a robot is home, with the two distances in metres. */
const HOME = /Home: it stopped by itself (\d+\.\d\d) m from where it began; it believes (\d+\.\d\d) m\./;

/** Opens the page and lets the robot drive part of its route as fast as it goes. */
async function driveOut(bench: BenchPage): Promise<void> {
  await bench.open();
  await bench.page.getByLabel('Speed').selectOption('Max');
  await expect.poll(() => bench.travelled()).toBeGreaterThan(8);
}

/** Tells a robot that has driven out to go home, slowly enough to watch. */
async function goHome(bench: BenchPage): Promise<void> {
  await driveOut(bench);
  await bench.page.getByLabel('Speed').selectOption('2×');
  await bench.page.getByRole('button', { name: 'Go Home', exact: true }).click();
  await expect(bench.going).toBeVisible();
}

async function untilHome(bench: BenchPage): Promise<{ off: number; believed: number }> {
  await bench.page.getByLabel('Speed').selectOption('Max');
  const said = bench.page.getByText(HOME).first();
  await expect(said).toBeVisible({ timeout: 50_000 });
  const [, off, believed] = HOME.exec(await said.innerText()) ?? [];
  return { off: Number(off), believed: Number(believed) };
}

test('a robot that is told to go home goes there, says why, and how it ended', async ({ page }) => {
  const bench = new BenchPage(page);
  await goHome(bench);
  await expect(page.getByText(/^By a plan: the best way home/).first()).toBeVisible();
  await expect(bench.world.getByText(/^home [\d.]+ m away, it believes [\d.]+ m$/)).toBeVisible();
  const { off, believed } = await untilHome(bench);
  expect(believed).toBeLessThanOrEqual(0.35);
  expect(off).toBeLessThan(1);
  await expect(page.getByRole('status', { name: 'What happened' })).toContainText(HOME);
  await expect(page.getByRole('button', { name: 'Go Home', exact: true })).toBeVisible();
});

test('the way home is the same on the command line', async ({ page }) => {
  const bench = new BenchPage(page);
  await goHome(bench);
  const { believed } = await untilHome(bench);
  const session = await bench.save('Session');
  const map = (await bench.save('Map')).bytes;
  test.skip(!existsSync(cogmap), `no command line at ${cogmap}`);
  const folder = mkdtempSync(join(tmpdir(), 'cogmap-'));
  writeFileSync(join(folder, session.name), session.bytes);
  execFileSync(cogmap, ['replay', join(folder, session.name), '--out', join(folder, 'out')]);
  expect(readFileSync(join(folder, 'out', 'map.json')).equals(map)).toBe(true);
  const events = readFileSync(join(folder, 'out', 'events.jsonl'), 'utf8').trim().split('\n');
  const kinds = events.map((line) => JSON.parse(line) as { kind: string; strategy?: string; distance?: number });
  expect(kinds.find(({ kind }) => kind === 'go_home')?.strategy).toBe('recommended');
  expect(kinds.find(({ kind }) => kind === 'home')?.distance?.toFixed(2)).toBe(believed.toFixed(2));
  rmSync(folder, { recursive: true });
});

test('it can be stopped on its way, driven elsewhere, and sent home again', async ({ page }) => {
  const bench = new BenchPage(page);
  await goHome(bench);
  await page.getByRole('button', { name: 'Stop' }).click();
  await expect(page.getByText(/You took over [\d.]+ m from where it began\./).first()).toBeVisible();
  await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled();
  await page.getByRole('button', { name: 'Turn left' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByText(/You took over/)).toHaveCount(0);
  await page.getByRole('button', { name: 'Go Home', exact: true }).click();
  expect((await untilHome(bench)).off).toBeLessThan(1);
});

test('the thesis’s way home shows its options, and the plans can be hidden', async ({ page }) => {
  const bench = new BenchPage(page);
  await driveOut(bench);
  await page.getByLabel('Speed').selectOption('2×');
  await page.getByRole('button', { name: 'recommended' }).click();
  await expect(page.getByRole('button', { name: /^recommended Ours/ })).toHaveAttribute('aria-current', 'true');
  await page.getByRole('button', { name: /^faithful The thesis to the letter/ }).click();
  await expect(page.getByRole('button', { name: 'faithful' })).toBeFocused();
  await page.getByRole('button', { name: 'Go Home', exact: true }).click();
  await expect(page.getByText(/^By its sense of direction: /).first()).toBeVisible();
  await bench.pause();
  const picture = () => bench.memory.getByRole('img').screenshot();
  const before = await picture();
  await page.getByRole('heading', { level: 1 }).click();
  await page.keyboard.press('p');
  await expect(bench.chip('plans')).toHaveAttribute('aria-pressed', 'false');
  await expect.poll(async () => (await picture()).equals(before)).toBe(false);
});

test('from load to home by keyboard alone', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  for (let presses = 0; presses < 8; presses += 1) await page.keyboard.press(']');
  await expect.poll(() => bench.travelled()).toBeGreaterThan(8);
  for (let presses = 0; presses < 5; presses += 1) await page.keyboard.press('[');
  await page.keyboard.press('h');
  await expect(bench.going).toBeVisible();
  await page.keyboard.press('x');
  await expect(page.getByText(/You took over/).first()).toBeVisible();
  const button = page.getByRole('button', { name: 'Go Home', exact: true });
  for (let presses = 0; presses < 60; presses += 1) {
    if (await button.evaluate((node) => node === document.activeElement)) break;
    await page.keyboard.press('Tab');
  }
  await expect(button).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(bench.going).toBeFocused();
  for (let presses = 0; presses < 8; presses += 1) await page.keyboard.press(']');
  await expect(page.getByText(HOME).first()).toBeVisible();
});

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(colorScheme, () => {
    test.use({ colorScheme });

    test('axe finds nothing to object to on the way and at home', async ({ page }) => {
      test.slow();
      const bench = new BenchPage(page);
      await driveOut(bench);
      await page.getByLabel('Speed').selectOption('2×');
      await page.getByRole('button', { name: 'recommended' }).click();
      await expect(page.getByRole('button', { name: /^oracle/ })).toBeVisible();
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      await page.keyboard.press('Escape');
      await page.getByRole('button', { name: 'Go Home', exact: true }).click();
      await expect(page.getByText(/^By a plan: /).first()).toBeVisible();
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      await untilHome(bench);
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    });
  });
}

test('Go Home and Stop are as large as a finger on a phone', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await new BenchPage(page).open();
  for (const name of ['Go Home', 'Stop', 'recommended']) {
    const box = await page.getByRole('button', { name }).boundingBox();
    expect(box?.width, name).toBeGreaterThanOrEqual(44);
    expect(box?.height, name).toBeGreaterThanOrEqual(44);
  }
});
