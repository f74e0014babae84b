import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { button, check, chosen, click, drag, drawWalls, editor, form, open, press, said, sheet } from './desk';

test('what is wrong is told at once and where it is, and keeps the building from being driven in', async ({ page }) => {
  await open(page, 'New building');
  await drawWalls(page);
  await page.keyboard.press('w');
  await sheet(page).focus();
  await form(page).getByRole('combobox').selectOption('Start');
  await sheet(page).focus();
  await page.keyboard.press('Enter');
  await press(page, 'Shift+ArrowRight');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('1 thing to put right first');
  await expect(check(page)).toContainText('is 0.00 m from a solid');
  await expect(editor(page).locator('svg .bad')).toHaveCount(1);
  await button(page, 'Drive here').click();
  await expect(said(page)).toHaveText('Put right first what the check lists.');
  await expect(editor(page)).toBeVisible();
  await check(page).getByRole('button', { name: /^Start/ }).click();
  await expect(chosen(page)).toHaveText('Start');
  await form(page).getByRole('spinbutton', { name: 'x, m' }).fill('-1');
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('Everything is in order');

  await sheet(page).focus();
  await page.keyboard.press('d');
  await drag(page, [0.3, 0.1], [0.4, 0.1]);
  await drag(page, [0.6, 0.1], [0.7, 0.1]);
  await form(page).getByRole('textbox', { name: 'Name' }).fill('door 1');
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('another door is called "door 1" too');
  await form(page).getByRole('textbox', { name: 'Name' }).fill('second');
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('Everything is in order');
  await form(page).getByRole('group', { name: 'Latch' }).getByRole('spinbutton', { name: 'x, m' }).fill(
    await form(page).getByRole('group', { name: 'Hinge' }).getByRole('spinbutton', { name: 'x, m' }).inputValue(),
  );
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('Door “second”, latch');
  await page.keyboard.press('Control+z');
  await expect(check(page)).toContainText('Everything is in order');

  await page.keyboard.press('Escape');
  await expect(sheet(page)).toBeFocused();
  await page.keyboard.press('t');
  await click(page, 0.97, 0.5);
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('Route “route 1”, point 1');
  await expect(check(page)).toContainText('cannot be reached');
  await page.keyboard.press('Delete');
  await expect(check(page)).toContainText('Everything is in order');

  await page.keyboard.press('r');
  for (const [x, y] of [[0.2, 0.2], [0.5, 0.5], [0.5, 0.2], [0.2, 0.5]] as const) await click(page, x, y);
  await page.keyboard.press('Enter');
  await expect(check(page)).toContainText('Worth a look');
  await expect(check(page)).toContainText('crosses itself');
  await expect(check(page)).toContainText('Everything is in order');
});

for (const colorScheme of ['light', 'dark'] as const) {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 1024, height: 768 }, { width: 390, height: 844 }]) {
    test.describe(`${colorScheme} at ${viewport.width} × ${viewport.height}`, () => {
      test.use({ colorScheme, viewport, hasTouch: viewport.width < 500 });

      test('the editor has nothing to object to, and fits', async ({ page }) => {
        await open(page, 'Edit the building');
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        for (const name of ['Wall 1', 'Box 1', 'Start', 'Door “kitchen”']) {
          const options = await form(page).getByRole('option').allInnerTexts();
          if (options.includes(name)) await form(page).getByRole('combobox').selectOption(name);
        }
        await sheet(page).focus();
        await page.keyboard.press('s');
        await click(page, 0.02, 0.02);
        await page.keyboard.press('?');
        await expect(check(page)).toContainText('to put right first');
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        const wider = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        expect(wider).toBeLessThanOrEqual(0);
      });
    });
  }
}
