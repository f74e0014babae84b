import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { BenchPage } from './bench';

test('the truth can be laid over the memory by its first view and by best fit', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.chip('odometry').click();
  await bench.chip('consensus').click();
  await page.getByRole('button', { name: 'To the end' }).click();
  await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled({ timeout: 40_000 });
  const choice = page.getByRole('combobox', { name: 'laid by' });
  await expect(choice).toBeHidden();
  await bench.chip('truth').click();
  await expect(choice).toHaveValue('first_view');
  const drawing = async () => (await bench.save('Drawing')).bytes.toString();
  const first = await drawing();
  await choice.selectOption('best fit');
  await expect.poll(drawing).not.toBe(first);
  expect(await drawing()).toContain('the world, as the whole path fits best');
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await choice.selectOption('the first view');
  await expect.poll(drawing).toBe(first);
});
