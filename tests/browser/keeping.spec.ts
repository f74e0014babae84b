import AxeBuilder from '@axe-core/playwright';
import { expect, test, type Page } from '@playwright/test';
import { BenchPage, roomLog } from './bench';

/** Drives to the right for a moment and lets the robot come to rest. */
const drive = (bench: BenchPage) => bench.hold('ArrowRight', 400);

/** Opens the page and drives; what the session says then. */
async function driven(page: Page): Promise<{ bench: BenchPage; told: unknown }> {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  await drive(bench);
  return { bench, told: await commands(bench) };
}

/** Waits until the browser has kept the moment that is shown. */
async function untilKept(page: Page): Promise<void> {
  const [minutes = NaN, seconds = NaN] = (await page.locator('output').first().innerText()).split(':').map(Number);
  const kept = () =>
    page.evaluate(async () => {
      const answer = <T>(request: IDBRequest<T>) =>
        new Promise<T>((resolve, reject) => {
          request.onsuccess = () => resolve(request.result);
          request.onerror = () => reject(request.error);
        });
      const database = await answer(indexedDB.open('cogmap'));
      const all: { time?: number; when?: number }[] = await answer(database.transaction('runs').objectStore('runs').getAll());
      database.close();
      return all.sort((one, other) => (other.when ?? 0) - (one.when ?? 0))[0]?.time ?? NaN;
    });
  await expect.poll(async () => Math.abs((await kept()) - 60 * minutes - seconds)).toBeLessThan(0.06);
}

const goOn = (page: Page) => page.getByRole('button', { name: 'Go on', exact: true });

/** The commands of a saved session. */
async function commands(bench: BenchPage): Promise<unknown> {
  const session = JSON.parse((await bench.save('Session')).bytes.toString()) as { source: { commands: unknown } };
  return session.source.commands;
}

test('after a reload the run is offered again, complete to the last command', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  await drive(bench);
  await page.getByRole('button', { name: 'Go Home', exact: true }).click();
  await expect(bench.going).toBeVisible();
  await page.keyboard.press('Space');
  const told = await commands(bench);
  expect(JSON.stringify(told)).toContain('go_home');
  await page.reload();
  await expect(page.getByText(/Go on where you were\? Office/)).toBeVisible();
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await goOn(page).click();
  await expect(bench.going).toBeVisible();
  await expect(goOn(page)).toBeHidden();
  expect(await commands(bench)).toEqual(told);
  await page.getByRole('button', { name: 'Play' }).click();
  await page.getByLabel('Speed').selectOption('Max');
  await expect(page.getByText(/Home: it stopped by itself/).first()).toBeVisible();
});

test('an offer that is dismissed does not come again, and an untouched page offers nothing', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await page.waitForTimeout(2500);
  await bench.open();
  await page.waitForTimeout(500);
  await expect(goOn(page)).toBeHidden();
  await bench.takeOver();
  await drive(bench);
  await bench.open();
  await expect(goOn(page)).toBeVisible();
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await expect(goOn(page)).toBeHidden();
  await bench.open();
  await page.waitForTimeout(500);
  await expect(goOn(page)).toBeHidden();
});

test('steps to the next view are kept, too', async ({ page }) => {
  const bench = new BenchPage(page);
  const timeline = page.getByRole('slider', { name: 'Timeline' });
  await bench.open();
  await bench.pause();
  const paused = Number(await timeline.inputValue());
  await page.keyboard.press('.');
  await expect.poll(async () => Number(await timeline.inputValue())).toBeGreaterThan(paused);
  const stepped = await timeline.inputValue();
  await untilKept(page);
  await page.reload();
  await goOn(page).click();
  await expect(timeline).toHaveValue(stepped);
});

test('a log is kept with its file', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(20) });
  const timeline = page.getByRole('slider', { name: 'Timeline' });
  await expect(timeline).toHaveValue('20');
  const map = (await bench.save('Map')).bytes;
  await timeline.fill('20');
  await untilKept(page);
  await bench.open();
  await expect(page.getByText(/Go on where you were\? room\.log/)).toBeVisible();
  await goOn(page).click();
  await expect(timeline).toHaveValue('20');
  expect((await bench.save('Map')).bytes.equals(map)).toBe(true);
});

test('two windows keep a run each, and each is offered once its window is gone', async ({ page, context }) => {
  const one = new BenchPage(page);
  await one.open();
  await one.drop({ name: 'room.log', content: roomLog(20) });
  await expect(page.getByRole('slider', { name: 'Timeline' })).toHaveValue('20');
  const other = new BenchPage(await context.newPage());
  await other.open();
  await other.page.waitForTimeout(1000);
  await expect(goOn(other.page)).toBeHidden();
  await other.takeOver();
  await drive(other);
  const told = await commands(other);
  await page.close();
  await other.page.close();
  const third = new BenchPage(await context.newPage());
  await third.open();
  await goOn(third.page).click();
  await expect(goOn(third.page)).toBeHidden();
  expect(await commands(third)).toEqual(told);
  const fourth = await context.newPage();
  await new BenchPage(fourth).open();
  await expect(fourth.getByText(/Go on where you were\? room\.log/)).toBeVisible();
  await goOn(fourth).click();
  await expect(fourth.getByRole('slider', { name: 'Timeline' })).toHaveValue('20');
});

const ends: [string, () => void][] = [
  ['is ended without a word', () => self.close()],
  ['traps', () => void setTimeout(() => { throw new WebAssembly.RuntimeError('unreachable'); })],
];

for (const [how, end] of ends) {
  test(`when the worker ${how}, the run goes on in another one`, async ({ page }) => {
    const { bench, told } = await driven(page);
    const worker = page.workers().find((worker) => worker.url().startsWith('http'));
    await worker?.evaluate(end).catch(() => undefined);
    await expect(page.getByRole('alert')).toContainText('stopped unexpectedly');
    await expect(page.getByRole('alert')).toContainText('taken up where it was');
    expect(await commands(bench)).toEqual(told);
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await page.keyboard.down('ArrowUp');
    await expect.poll(() => commands(bench)).not.toEqual(told);
    await page.keyboard.up('ArrowUp');
  });
}

test('after the worker was killed and the page reloaded, the run is offered again, complete', async ({ page }) => {
  const { bench, told } = await driven(page);
  const worker = page.workers().find((worker) => worker.url().startsWith('http'));
  await worker?.evaluate(() => self.close()).catch(() => undefined);
  await expect(page.getByRole('alert')).toContainText('taken up where it was');
  await page.reload();
  await goOn(page).click();
  await expect(goOn(page)).toBeHidden();
  expect(await commands(bench)).toEqual(told);
});

test('a worker that ends again at once is not given the same run again', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  for (const message of ['taken up where it was', 'and the run with it']) {
    await page.workers().at(-1)?.evaluate(() => self.close()).catch(() => undefined);
    await expect(page.getByRole('alert')).toContainText(message);
  }
  await expect.poll(() => bench.surfaces()).toBeGreaterThan(0);
});

const closed: [string, () => void][] = [
  ['no database', () => Object.defineProperty(globalThis, 'indexedDB', { value: undefined })],
  ['a database that refuses', () => {
    indexedDB.open = () => {
      throw new DOMException('denied', 'SecurityError');
    };
  }],
  ['a full database', () => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException('full', 'QuotaExceededError');
    };
  }],
  ['no locks', () => Object.defineProperty(Navigator.prototype, 'locks', { value: undefined })],
];

for (const [what, close] of closed) {
  test(`a browser with ${what} can be used all the same`, async ({ page }) => {
    const failures: string[] = [];
    page.on('pageerror', (error) => failures.push(error.message));
    await page.addInitScript(close);
    const bench = new BenchPage(page);
    await bench.open();
    await bench.takeOver();
    await drive(bench);
    await expect(page.getByRole('alert')).toBeEmpty();
    expect(failures).toEqual([]);
  });
}
