import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { BenchPage } from './bench';
import { driven } from './desk';

const dialog = (page: Page) => page.getByRole('dialog', { name: 'How large is this floor plan?' });
const field = (page: Page, name: string) => dialog(page).getByLabel(name, { exact: true });
const outcome = (page: Page) => dialog(page).getByRole('status');
const open = (page: Page) => dialog(page).getByRole('button', { name: 'Open the building' });

/** Two rooms of 100 × 60 pixels with a doorway, as a PGM in text. */
function rooms(): string {
  const solid = (x: number, y: number) => x === 0 || y === 0 || x === 99 || y === 59 || (x === 50 && (y < 20 || y > 40));
  const pixels = Array.from({ length: 60 }, (_, y) => Array.from({ length: 100 }, (_, x) => (solid(x, y) ? 0 : 255)).join(' '));
  return `P2\n100 60\n255\n${pixels.join('\n')}\n`;
}

/** How wide and high the walls of the building are that runs, metres. */
async function extent(bench: BenchPage): Promise<[number, number]> {
  const corners = (await driven(bench)).walls.flat();
  const range = (axis: 0 | 1) => Math.max(...corners.map((at) => at[axis])) - Math.min(...corners.map((at) => at[axis]));
  return [range(0), range(1)];
}

test('a dropped plan asks for its scale, and the robot drives in it, also after a reload', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'rooms.pgm', content: rooms() });
  await expect(field(page, 'Metres a pixel')).toHaveValue('0.2');
  await expect(outcome(page)).toContainText('20.0 m by 12.0 m');
  await field(page, 'Metres a pixel').fill('0.1');
  await expect(field(page, 'Width (m)')).toHaveValue('10');
  await expect(field(page, 'Height (m)')).toHaveValue('6');
  await expect(outcome(page)).toContainText('10.0 m by 6.0 m');
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await open(page).click();
  await expect(dialog(page)).toBeHidden();
  await expect(bench.choice).toContainText('rooms');
  await page.getByRole('button', { name: 'Turn left' }).focus();
  await page.keyboard.press('Enter');
  await expect.poll(() => bench.surfaces()).toBeGreaterThan(2);
  const [width, height] = await extent(bench);
  expect([Math.round(width * 10), Math.round(height * 10)]).toEqual([98, 58]);
  const session = (await bench.save('Session')).bytes.toString();

  // Another robot drives in the same building.
  await page.getByRole('combobox', { name: 'Robot' }).selectOption('perfect');
  await expect(page.getByRole('combobox', { name: 'Robot' })).toHaveValue('perfect');
  expect((await extent(bench))[0]).toBeCloseTo(width, 6);

  await bench.drop({ name: 'rooms.session.json', content: session });
  await expect(bench.choice).toContainText('rooms');
  await page.getByRole('button', { name: 'Turn left' }).focus();
  await page.keyboard.press('Enter');
  await expect.poll(() => bench.surfaces()).toBeGreaterThan(2);
  await page.reload();
  await page.getByRole('button', { name: 'Go on', exact: true }).click();
  await expect(bench.choice).toContainText('rooms');
  expect((await extent(bench))[1]).toBeCloseTo(height, 6);
});

test('two points whose distance is known say the scale', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'rooms.pgm', content: rooms() });
  const picture = dialog(page).getByRole('img');
  await expect(outcome(page)).toContainText('m² of floor');
  const { width = 0, height = 0 } = (await picture.boundingBox()) ?? {};
  await picture.click({ position: { x: width * 0.25, y: height * 0.5 } });
  await expect(field(page, 'Between the points (m)')).toBeHidden();
  await picture.click({ position: { x: width * 0.75, y: height * 0.5 } });
  await field(page, 'Between the points (m)').fill('4');
  await expect(outcome(page)).toContainText(/ by 4\.8 m/);
  expect(Number(await field(page, 'Metres a pixel').inputValue())).toBeCloseTo(0.08, 2);
  await field(page, 'Width (m)').fill('12');
  await expect(field(page, 'Metres a pixel')).toHaveValue('0.12');
});

test('a picked PNG is a plan too, and can be left without losing the run', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const before = await bench.choice.inputValue();
  const png = await page.evaluate(() => {
    const canvas = Object.assign(document.createElement('canvas'), { width: 400, height: 300 });
    const context = canvas.getContext('2d');
    if (context) [context.lineWidth, context.strokeStyle] = [6, 'black'];
    context?.strokeRect(20, 20, 360, 260);
    return canvas.toDataURL('image/png').split(',')[1] ?? '';
  });
  await page.getByLabel('Open…').first().setInputFiles({ name: 'hall.png', mimeType: 'image/png', buffer: Buffer.from(png, 'base64') });
  await expect(outcome(page)).toContainText('20.0 m by 15.0 m');
  await page.keyboard.press('Escape');
  await expect(dialog(page)).toBeHidden();
  expect(await bench.choice.inputValue()).toBe(before);
  expect(await bench.surfaces()).toBeGreaterThan(0);
});

test('a map_server file and its picture open without a question, in either order', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const yaml = { name: 'floor.yaml', content: 'image: rooms.pgm\nresolution: 0.08\norigin: [0, 0, 0]\n' };
  await bench.drop(yaml, { name: 'rooms.pgm', content: rooms() });
  await expect(bench.choice).toContainText('floor');
  expect((await extent(bench))[0]).toBeCloseTo(7.84, 2);
  await bench.drop({ name: 'rooms.pgm', content: rooms() }, { ...yaml, name: 'again.yaml' });
  await expect(bench.choice).toContainText('again');
  await bench.drop(yaml);
  await expect(page.getByRole('alert')).toContainText('rooms.pgm; bring both files at once');
  await bench.drop(yaml, { name: 'other.pgm', content: rooms() });
  await expect(page.getByRole('alert')).toContainText('not other.pgm');
  await expect(bench.choice).toContainText('again');
});

test('what cannot be a plan gets an answer, and nothing is lost', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  for (const [name, content, answer] of [
    ['cut.pgm', 'P2 30 30 255\n0 0 0\n', /cut\.pgm.*ends|pixel/],
    ['huge.pgm', 'P2 99999 99999 255\n', /99999 by 99999/],
    ['photo.jpg', 'GIF89a', /a GIF picture/],
  ] as const) {
    await bench.drop({ name, content });
    await expect(page.getByRole('alert')).toContainText(answer);
    await expect(dialog(page)).toBeHidden();
    expect(await bench.surfaces()).toBeGreaterThan(0);
  }
  await bench.drop({ name: 'night.pgm', content: `P2 40 40 255\n${'0 '.repeat(1600)}\n` });
  await expect(outcome(page)).toContainText('nowhere in its');
  await expect(open(page)).toBeDisabled();
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await dialog(page).getByRole('button', { name: 'Cancel' }).last().click();
  await expect(page.getByRole('alert')).toBeEmpty();
  expect(await bench.surfaces()).toBeGreaterThan(0);
});

for (const colorScheme of ['light', 'dark'] as const) {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 1024, height: 768 }, { width: 390, height: 844 }]) {
    test.describe(`${colorScheme} at ${viewport.width} × ${viewport.height}`, () => {
      test.use({ colorScheme, viewport });

      test('the question fits, is large enough for fingers, and axe has nothing to object to', async ({ page }) => {
        const bench = new BenchPage(page);
        await bench.open();
        await bench.drop({ name: 'rooms.pgm', content: rooms() });
        await expect(outcome(page)).toContainText('m² of floor');
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        const box = await dialog(page).boundingBox();
        expect((box?.x ?? -1) >= 0 && (box?.y ?? -1) >= 0).toBe(true);
        expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(viewport.width);
        for (const control of await dialog(page).locator('form button, form input').all()) {
          expect((await control.boundingBox())?.height).toBeGreaterThanOrEqual(44);
        }
      });
    });
  }
}
