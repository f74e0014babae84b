import { expect, test, type Page } from '@playwright/test';
import { BenchPage } from './bench';

/** A gamepad as a browser tells of it: at rest, and found by the page at once. */
async function plugIn(page: Page): Promise<void> {
  await page.evaluate(() => {
    const buttons = Array.from({ length: 17 }, () => ({ pressed: false, touched: false, value: 0 }));
    const pad = { index: 0, id: 'Pad', mapping: 'standard', connected: true, axes: [0.04, -0.05, 0, 0], buttons };
    Object.assign(window, { pad });
    navigator.getGamepads = () => [pad as unknown as Gamepad];
    dispatchEvent(Object.assign(new Event('gamepadconnected'), { gamepad: pad }));
  });
}

/** Moves the left stick, or presses or lets go of a button. */
async function hold(page: Page, change: { axes?: [number, number]; button?: number; pressed?: boolean }): Promise<void> {
  await page.evaluate(({ axes, button, pressed }) => {
    const { pad } = window as unknown as { pad: { axes: number[]; buttons: { pressed: boolean }[] } };
    if (axes) pad.axes.splice(0, 2, ...axes);
    const held = button === undefined ? undefined : pad.buttons[button];
    if (held) held.pressed = pressed ?? true;
  }, change);
}

test.describe('a gamepad', () => {
  test('is found, drives, stops and goes home', async ({ page }) => {
    const bench = new BenchPage(page);
    await bench.open();
    await bench.takeOver();
    await plugIn(page);
    await expect(page.getByRole('status', { name: 'Gamepad' })).toContainText('left stick');
    const before = await bench.travelled();
    await hold(page, { axes: [-0.3, -1] });
    await expect.poll(() => bench.travelled()).toBeGreaterThan(before + 0.5);
    await hold(page, { axes: [0.02, 0.03] });
    await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled();
    const driven = await bench.travelled();
    await page.waitForTimeout(500);
    expect(await bench.travelled()).toBe(driven);

    // Back where it came from, for there is room; where it looks once it has stopped on its way home, there may be none.
    await hold(page, { button: 13 });
    await expect.poll(() => bench.travelled()).toBeGreaterThan(driven + 0.2);
    await hold(page, { button: 13, pressed: false });
    await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled();
    await hold(page, { button: 0 });
    await expect(bench.going).toBeVisible();
    await hold(page, { button: 0, pressed: false });
    await hold(page, { button: 1 });
    await expect(bench.going).toBeHidden();
    await hold(page, { button: 1, pressed: false });
  });

  test('that is pulled out lets the robot stop', async ({ page }) => {
    const bench = new BenchPage(page);
    await bench.open();
    await bench.takeOver();
    await plugIn(page);
    const before = await bench.travelled();
    await hold(page, { axes: [0, -1] });
    await expect.poll(() => bench.travelled()).toBeGreaterThan(before + 0.3);
    await page.evaluate(() => {
      const { pad } = window as unknown as { pad: object };
      dispatchEvent(Object.assign(new Event('gamepaddisconnected'), { gamepad: pad }));
    });
    await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled();
    await expect(page.getByRole('status', { name: 'Gamepad' })).toBeEmpty();
  });
});

test.describe('fingers', () => {
  test.use({ hasTouch: true, isMobile: true, viewport: { width: 390, height: 844 } });

  test('push the stick, and the robot goes there until they let go', async ({ page }) => {
    const bench = new BenchPage(page);
    await bench.open();
    await bench.takeOver();
    const stick = page.getByTitle('Push the stick');
    const box = await stick.boundingBox();
    if (!box) throw new Error('there is no stick');
    expect(Math.min(box.width, box.height)).toBeGreaterThanOrEqual(88);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const touch = await page.context().newCDPSession(page);
    const at = async (type: 'touchStart' | 'touchMove' | 'touchEnd', point?: { x: number; y: number }) =>
      touch.send('Input.dispatchTouchEvent', { type, touchPoints: point ? [point] : [] });
    const before = await bench.travelled();
    await at('touchStart', { x, y });
    await at('touchMove', { x: x - 8, y: y - 40 });
    await expect.poll(() => bench.travelled()).toBeGreaterThan(before + 0.4);
    await at('touchEnd');
    await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled();
    expect(await bench.memory.first().innerText()).toMatch(/surfaces/);
  });
});
