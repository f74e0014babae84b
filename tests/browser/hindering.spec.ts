import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { clickAt, latest, palette, rooms, take, told, word } from './altering';

test('somebody comes where one clicks, or ahead of the robot, and walks', async ({ page }) => {
  const bench = await rooms(page);
  await clickAt(bench, 'Somebody', [4, 0.5]);
  await expect(word(page)).toContainText('Nobody came: there is no room');
  await clickAt(bench, 'Somebody', [6, 2.5]);
  await expect.poll(async () => (await latest(bench))?.what).toBe('add_person');
  const { path } = (await latest(bench)) as unknown as { path: [number, number][] };
  expect(Math.hypot((path[0]?.[0] ?? 0) - 6, (path[0]?.[1] ?? 0) - 2.5)).toBeLessThan(0.05);
  expect(path.every(([x, y]) => x > 1 && x < 8 && y > 0 && y < 5)).toBe(true);
  await expect(page.getByRole('status', { name: 'What happened' })).toContainText('Somebody came');

  await palette(page).getByRole('button', { name: '2 m ahead' }).click();
  await expect.poll(async () => (await told(bench)).filter(({ what }) => what === 'add_person').length).toBe(2);
});

test('the robot’s errors are set by keyboard, hold from then on, and are undone', async ({ page }) => {
  const bench = await rooms(page);
  await take(page, 'Noise');
  const slider = palette(page).getByRole('slider', { name: 'odometry' });
  await expect(slider).toHaveAttribute('aria-valuetext', '1 ×');
  await slider.focus();
  for (const times of ['2 ×', '3 ×', '5 ×']) {
    await page.keyboard.press('ArrowRight');
    await expect(slider).toHaveAttribute('aria-valuetext', times);
  }
  expect(await latest(bench)).toMatchObject({ do: 'change', what: 'noise', odometry: 5, laser: 1 });
  await expect(page.getByRole('status', { name: 'What happened' })).toContainText('errors were changed');
  await page.getByRole('heading', { level: 1 }).click();
  await page.keyboard.press('Control+z');
  await expect(slider).toHaveAttribute('aria-valuetext', '3 ×');
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
});
