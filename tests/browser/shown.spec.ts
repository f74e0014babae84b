import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { BenchPage, roomLog } from './bench';

test('another mapper’s memory of the same moment is a click away', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await expect(bench.memory).toHaveCount(1);
  await expect(bench.chip('consensus')).toHaveAttribute('aria-pressed', 'true');
  await bench.pause();
  const moment = await page.locator('output').innerText();
  await bench.chip('perceptual').click();
  await expect(page.getByRole('heading', { name: 'The robot’s memory by perceptual' })).toBeVisible();
  await expect(bench.memory).toHaveCount(2);
  expect(await page.locator('output').innerText()).toBe(moment);
  await bench.chip('consensus').click();
  await expect(bench.memory).toHaveCount(1);
  await expect(bench.chip('perceptual')).toBeDisabled();
});

test('all four mappers can be shown on one drive, with and without the world', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  for (const mapper of ['perceptual', 'transform', 'odometry']) await bench.chip(mapper).click();
  await expect(bench.memory).toHaveCount(4);
  await expect(bench.world).toBeVisible();
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await bench.chip('world').click();
  await expect(bench.world).toBeHidden();
  await bench.chip('world').click();
  await expect(bench.world).toBeVisible();
  await page.keyboard.press('KeyW');
  await expect(page.getByText(/^consensus View \d+/)).toBeVisible();
});

test('clicks that come faster than the page hears of them all count', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const click = () =>
    page.evaluate(() => {
      const chips = [...document.querySelectorAll('button')];
      for (const name of ['perceptual', 'transform', 'odometry']) {
        chips.find(({ innerText }) => innerText.trim() === name)?.click();
      }
    });
  await click();
  await expect(bench.memory).toHaveCount(4);
  await click();
  await expect(bench.memory).toHaveCount(1);
  await expect(bench.chip('consensus')).toHaveAttribute('aria-pressed', 'true');
});

test('what a memory shows can be chosen by mouse and by key', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.pause();
  const picture = () => bench.memory.getByRole('img').screenshot();
  let before = await picture();
  const changed = async () => {
    await expect.poll(async () => (await picture()).equals(before)).toBe(false);
    before = await picture();
  };
  await page.getByLabel('Colour by').selectOption('local space');
  await changed();
  await page.getByLabel('Colour by').selectOption('age');
  await changed();
  for (const from of ['the robot', 'the entrance', 'outside']) {
    await page.getByRole('combobox', { name: 'Seen from' }).selectOption(from);
    await changed();
  }
  await bench.chip('truth').click();
  await changed();
  await page.getByRole('heading', { level: 1 }).click();
  await page.keyboard.press('g');
  await expect(page.getByRole('combobox', { name: 'Seen from' })).toHaveValue('robot');
  for (const [key, chip] of [['n', 'network'], ['e', 'exits'], ['o', 'truth']] as const) {
    const pressed = await bench.chip(chip).getAttribute('aria-pressed');
    await page.keyboard.press(key);
    await expect(bench.chip(chip)).toHaveAttribute('aria-pressed', pressed === 'true' ? 'false' : 'true');
  }
  await page.keyboard.press('c');
  await expect(page.getByLabel('Colour by')).toHaveValue('view');
});

test('going through an exit is said and heard', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await page.getByLabel('Speed').selectOption('4×');
  const said = page.getByText(/local space \d/i);
  await expect(bench.memory.getByText(/exit \d/).first()).toBeVisible({ timeout: 50_000 });
  await expect(page.getByRole('status', { name: 'What happened' })).toHaveText(/local space \d/i);
  expect(await said.count()).toBeGreaterThan(0);
});

test('a log is mapped again when another mapper is chosen', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(40) });
  await expect(page.getByRole('slider', { name: 'Timeline' })).toHaveValue('40');
  await bench.chip('odometry').click();
  await expect(bench.memory).toHaveCount(2);
  await expect(page.getByRole('slider', { name: 'Timeline' })).toHaveValue('40');
  const saving = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save, share' }).click();
  await page.getByRole('button', { name: /^Map by odometry/ }).click();
  expect((await saving).suggestedFilename()).toBe('room.map.odometry.json');
});
