import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { opener, palette, rooms, session, shares, told } from './altering';
import { BenchPage, roomLog } from './bench';

test.use({ permissions: ['clipboard-read', 'clipboard-write'] });
test.describe.configure({ timeout: 120_000 });

const tool = (page: Page) => page.getByRole('button', { name: 'Draw a way' });
const word = (bench: BenchPage) => bench.world.locator('.hint');
const resting = (page: Page) => expect(page.getByRole('button', { name: 'Play' })).toBeDisabled({ timeout: 40_000 });

type Point = [number, number];
/** Pixels from the middle of the view of the world, of a point of the world. */
type Where = (at: Point) => Point;

/** Draws through points of the world, as a hand does. */
async function draw(bench: BenchPage, where: Where, line: Point[]): Promise<void> {
  const { x = 0, y = 0, width = 0, height = 0 } = (await bench.world.getByRole('img').boundingBox()) ?? {};
  const { mouse } = bench.page;
  for (const [index, at] of line.entries()) {
    const [right, down] = where(at);
    await mouse.move(x + width / 2 + right, y + height / 2 + down, { steps: index === 0 ? 1 : 12 });
    if (index === 0) await mouse.down();
  }
  await mouse.up();
}

/** Opens the two rooms with the tool in hand. */
async function begin(page: Page): Promise<[BenchPage, Where]> {
  const bench = await rooms(page);
  // From here on the middle of the view stays where it is, whatever room the palette takes.
  await page.keyboard.press('-');
  const share = await shares(bench);
  const { width = 0, height = 0 } = (await bench.world.getByRole('img').boundingBox()) ?? {};
  const where: Where = (at) => {
    const [right, down] = share(at);
    return [right * width, down * height];
  };
  await tool(page).click();
  await expect(palette(page)).toBeHidden();
  await expect(word(bench)).toContainText('Draw where the robot is to go');
  return [bench, where];
}

/** Where the robot took its last scan, by the table of its way. */
async function end(bench: BenchPage): Promise<[number, number]> {
  const last = (await bench.save('Table')).bytes.toString().trim().split('\r\n').at(-1);
  const [, x = NaN, y = NaN] = last?.split(',').map(Number) ?? [];
  return [x, y];
}

test('the robot follows a drawn line through the door; a link and undoing know it', async ({ page }) => {
  const [bench, where] = await begin(page);
  const before = await session(bench);
  await draw(bench, where, [[1, 2.5], [3, 2.6], [5, 2.4], [6.5, 3.6]]);
  await expect(word(bench)).toHaveText(/^On its way: [56]\.\d m\.$/);
  await page.getByLabel('Speed').selectOption('16×');
  await resting(page);
  await expect(word(bench)).toContainText('Draw where the robot is to go');
  const [x, y] = await end(bench);
  expect(Math.hypot(x - 6.5, y - 3.6)).toBeLessThan(0.6);
  const driven = await session(bench);
  const commands = await told(bench);
  expect(commands.length).toBeGreaterThanOrEqual(3);
  expect(commands.every(({ do: what }) => what === 'step' || what === 'stop')).toBe(true);
  const link = await bench.link();
  await page.keyboard.press('Control+z');
  await expect.poll(() => session(bench)).toBe(before);
  await page.keyboard.press('Control+Shift+Z');
  await expect.poll(() => session(bench)).toBe(driven);
  await page.goto('about:blank');
  await page.goto(link);
  await expect.poll(() => session(bench)).toBe(driven);
});

test('a line through a wall is driven around it, and what cannot be is said', async ({ page }) => {
  const [bench, where] = await begin(page);
  const before = await session(bench);
  await draw(bench, where, [[8, 0], [8, 2]]);
  await expect(word(bench)).toHaveText('The robot stays: nowhere along that line is there room for it.');
  await draw(bench, where, [[1, 4], [8.7, 4]]);
  await expect(word(bench)).toHaveText('The robot stays: a part of that line cannot be reached from here.');
  expect(await session(bench)).toBe(before);
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await draw(bench, where, [[1, 4], [6.5, 4]]);
  await expect(word(bench)).toHaveText(/^On its way: \d+\.\d m, around what is in the way\.$/);
  await page.getByLabel('Speed').selectOption('16×');
  await resting(page);
  expect((await end(bench))[0]).toBeGreaterThan(6);
  expect(await bench.world.getByText(/bump/).count()).toBe(0);
});

test('the tool is taken up and laid down by key, and leaves clicks and the palette what is theirs', async ({ page }) => {
  const [bench, where] = await begin(page);
  await page.keyboard.press('Escape');
  await expect(tool(page)).toHaveAttribute('aria-pressed', 'false');
  const still = await session(bench);
  await draw(bench, where, [[1, 3.5], [1.2, 3.5]]);
  expect(await session(bench)).toBe(still);
  await page.keyboard.press('q');
  await expect(tool(page)).toHaveAttribute('aria-pressed', 'true');
  const picture = bench.world.getByRole('img');
  const { width = 0, height = 0 } = (await picture.boundingBox()) ?? {};
  const [right, down] = where([2.5, 2.5]);
  await picture.click({ position: { x: width / 2 + right, y: height / 2 + down } });
  await expect.poll(async () => (await told(bench)).map(({ do: what }) => what)).toEqual(['step']);
  await opener(page).click();
  await expect(palette(page)).toBeVisible();
  await expect(tool(page)).toHaveAttribute('aria-pressed', 'false');
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog')).toContainText('draw a way for the robot with the pointer; without one, the arrow keys drive it');
});

test('a log has no robot to be sent along a way', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(10) });
  await expect(page.getByRole('heading', { name: 'The log by its odometry alone' })).toBeVisible();
  await expect(tool(page)).toBeDisabled();
  await page.keyboard.press('q');
  await expect(tool(page)).toHaveAttribute('aria-pressed', 'false');
});

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(`on a phone, ${colorScheme}`, () => {
    test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, colorScheme });

    test('a finger draws, and a second one gives the line up', async ({ page }) => {
      const bench = new BenchPage(page);
      await bench.open();
      await bench.takeOver();
      await tool(page).tap();
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      const button = await tool(page).boundingBox();
      expect(Math.min(button?.width ?? 0, button?.height ?? 0)).toBeGreaterThanOrEqual(44);
      const { x = 0, y = 0, width = 0, height = 0 } = (await bench.world.getByRole('img').boundingBox()) ?? {};
      const touch = await page.context().newCDPSession(page);
      const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', touchPoints: { x: number; y: number }[]) =>
        touch.send('Input.dispatchTouchEvent', { type, touchPoints });
      const at = (right: number, down: number) => ({ x: x + width * right, y: y + height * down });
      await send('touchStart', [at(0.5, 0.6)]);
      for (const right of [0.52, 0.56, 0.6]) await send('touchMove', [at(right, 0.6)]);
      await expect(bench.world.locator('polyline')).toHaveCount(2);
      await send('touchStart', [at(0.6, 0.6), at(0.3, 0.3)]);
      await expect(bench.world.locator('polyline')).toHaveCount(0);
      await send('touchEnd', []);
      await expect(word(bench)).toContainText('Draw where the robot is to go');
      await send('touchStart', [at(0.48, 0.6)]);
      for (const right of [0.47, 0.45, 0.43]) await send('touchMove', [at(right, 0.5)]);
      await send('touchEnd', []);
      await expect(word(bench)).toHaveText(/^(On its way|The robot stays)/);
    });
  });
}
