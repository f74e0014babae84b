import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { BenchPage } from './bench';

test.describe('in a browser that prefers German', () => {
  test.use({ locale: 'de-AT' });

  test('the page speaks German, and writes numbers as Germans do', async ({ page }) => {
    await page.goto('./');
    await expect(page.getByRole('button', { name: 'Nach Hause', exact: true })).toBeEnabled();
    await expect(page.locator('html')).toHaveAttribute('lang', 'de');
    await expect(page).toHaveTitle(/Roboter/);
    await expect(page.getByText(/\d,\d m gefahren/)).toBeVisible();
    await expect(page.getByRole('combobox', { name: /^Welt/ }).locator('option', { hasText: 'Kleines Büro' })).toHaveCount(1);
    await page.keyboard.press('?');
    await expect(page.getByRole('heading', { name: 'So benutzen Sie das Labor' })).toBeVisible();
  });

  test('nothing but the names of programs is left in English', async ({ page }) => {
    await page.goto('./');
    await expect(page.getByRole('button', { name: 'Nach Hause', exact: true })).toBeEnabled();
    const text = await page.evaluate(() => {
      const foreign = document.querySelectorAll('[lang="en"]');
      foreign.forEach((element) => element.remove());
      return document.body.innerText;
    });
    expect(text).not.toMatch(/\b(the|of|and|from|view|home|robot’s|driven|surfaces)\b/);
  });

  test('an address that asks for another language gets it', async ({ page }) => {
    await page.goto('./?lang=es');
    await expect(page.getByRole('button', { name: 'Ir a casa', exact: true })).toBeEnabled();
    await expect(page.locator('html')).toHaveAttribute('lang', 'es');
  });
});

test('the language changes while a run goes on, which stays, and is remembered', async ({ page }) => {
  const bench = new BenchPage(page);
  const asked: string[] = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  await bench.open();
  await bench.takeOver();
  const catalogues = () => asked.filter((path) => /\/(de|es)-[^/]*\.js$/.test(path)).length;
  expect(catalogues()).toBe(0);
  const driven = await bench.travelled();

  await page.getByRole('button', { name: 'Language' }).click();
  await page.getByRole('button', { name: 'Español' }).click();
  await expect(page.getByRole('button', { name: 'Ir a casa', exact: true })).toBeEnabled();
  await expect(page.getByText(`${driven.toFixed(1).replace('.', ',')} m recorridos`)).toBeVisible();
  expect(catalogues()).toBe(1);

  await page.reload();
  await expect(page.getByRole('button', { name: 'Ir a casa', exact: true })).toBeVisible();
  await expect(page.getByText(/Oficina, .* recorrido/)).toBeVisible();
  await page.getByRole('button', { name: 'Idioma' }).click();
  await page.getByRole('button', { name: 'English' }).click();
  await expect(page.getByRole('button', { name: 'Go Home', exact: true })).toBeVisible();
});

for (const [lang, why] of [['de', 'Warum?'], ['es', '¿Por qué?']] as const) {
  for (const colorScheme of ['light', 'dark'] as const) {
    test(`axe finds nothing in ${lang}, ${colorScheme}, Why? open`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.goto(`./?lang=${lang}`);
      await page.getByRole('button', { name: why }).first().click();
      await expect(page.getByRole('heading', { name: why })).toBeVisible();
      const { violations } = await new AxeBuilder({ page }).analyze();
      expect(violations).toEqual([]);
    });
  }
}
