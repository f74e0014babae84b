import { deflateRawSync, deflateSync } from 'node:zlib';
import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { BenchPage } from './bench';

test.use({ permissions: ['clipboard-read', 'clipboard-write'] });

const fragment = (text: string | Buffer): string => `#1.${deflateSync(text, { level: 9 }).toString('base64url')}`;

test('a link opens exactly the same moment of the same run', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.chip('odometry').click();
  await bench.takeOver();
  await bench.hold('ArrowRight', 500);
  const timeline = page.getByRole('slider', { name: 'Timeline' });
  const position = String(Math.floor(Number(await timeline.getAttribute('max')) / 2));
  await timeline.fill(position);
  const session = (await bench.save('Session')).bytes;
  const map = (await bench.save('Map by odometry')).bytes;
  const link = await bench.link();
  expect(link).toContain('#1.');

  await page.goto('about:blank');
  await page.goto(link);
  await expect(timeline).toHaveValue(position);
  expect((await bench.save('Session')).bytes.equals(session)).toBe(true);
  expect((await bench.save('Map by odometry')).bytes.equals(map)).toBe(true);
  await expect(bench.choice).toHaveValue('office');
  expect(await page.getByRole('button', { name: 'odometry', exact: true }).getAttribute('aria-pressed')).toBe('true');
});

test('a route that was being driven is driven on', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.pause();
  const link = await bench.link();
  const timeline = page.getByRole('slider', { name: 'Timeline' });
  const before = Number(await timeline.inputValue());
  await page.goto('about:blank');
  await page.goto(link);
  await expect(timeline).toHaveValue(String(before));
  await page.getByRole('button', { name: 'Play' }).click();
  await expect.poll(async () => Number(await timeline.getAttribute('max'))).toBeGreaterThan(before + 100);
});

test('a link can be pasted while the page is open, and holds a world of somebody’s own', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const world = {
    format: 'cogmap-world/1',
    name: '<img src=x onerror=alert(1)>',
    walls: [[[0, 0], [5, 0], [5, 4], [0, 4], [0, 0]]],
    start: { position: [1, 2] },
  };
  await bench.drop({ name: 'mine.world.json', content: JSON.stringify(world) });
  await expect(bench.choice).toContainText(world.name);
  const session = (await bench.save('Session')).bytes;
  const link = await bench.link();
  await bench.choice.selectOption('tour');
  await page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  await expect(bench.choice).toContainText(world.name);
  await expect.poll(async () => (await bench.save('Session')).bytes.equals(session)).toBe(true);
  expect(await page.locator('img').count()).toBe(0);
});

test.describe('where the newest version is published', () => {
  // A service worker would answer with the page as it is.
  test.use({ serviceWorkers: 'block' });

  test('links lead to the folder that it stays in', async ({ page }) => {
    const bench = new BenchPage(page);
    await bench.open('');
    const asItIs = await page.evaluate(async () => (await fetch('./')).text());
    const meta = '<meta name="cogmap-stays-in" content="v1.2.3/" />';
    const body = asItIs.replace('<head>', `<head>${meta}`);
    await page.route('./', (route) => route.fulfill({ contentType: 'text/html; charset=utf-8', body }));
    await bench.open('');
    expect(new URL(await bench.link()).pathname).toMatch(/\/v1\.2\.3\/$/);
  });
});

test('a run too long for a link offers the session file instead', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const walls = Array.from({ length: 900 }, (_, n) => {
    const [x, y] = [20 + Math.random() * 50, Math.random() * 50 + n / 1000];
    return [[x, y], [x + Math.random(), y + Math.random()]];
  });
  const world = { format: 'cogmap-world/1', name: 'Maze', walls, start: { position: [1, 2] } };
  await bench.drop({ name: 'maze.world.json', content: JSON.stringify(world) });
  await expect(bench.choice).toContainText('Maze');
  await bench.share('Copy link');
  await expect(page.getByText(/too long for a link/)).toBeVisible();
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  const saving = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save session' }).click();
  expect((await saving).suggestedFilename()).toBe('maze.session.json');
});

test('where the browser does not let the page copy, the link is there to be copied by hand', async ({ page }) => {
  await page.addInitScript(() => {
    navigator.clipboard.writeText = () => Promise.reject(new Error('no'));
  });
  const bench = new BenchPage(page);
  await bench.open();
  await bench.share('Copy link');
  await expect(page.getByRole('textbox', { name: 'Link' })).toHaveValue(/#1\./);
});

const situation = {
  engine: '0.1.0',
  source: { from: 'world', world: { named: 'office', digest: '0' }, robot: 'bad', commands: [], ticks: 9 },
  mappers: ['consensus'],
  seed: 1,
  at: 9,
  live: true,
  on_route: false,
};
const hostile: [string, string, RegExp][] = [
  ['of another version', '#2.abcdef', /another version/],
  ['with letters of no alphabet', '#1.%3Cscript%3Ealert(1)%3C/script%3E', /damaged/],
  ['that is cut off', fragment(JSON.stringify(situation)).slice(0, -12), /damaged/],
  ['that is empty', '#1.', /damaged/],
  ['without a checksum', `#1.${deflateRawSync('{}').toString('base64url')}`, /damaged/],
  ['that unpacks to far too much', fragment(Buffer.alloc(64 << 20)), /far more/],
  ['that holds no situation', fragment('[1, 2'), /The link/],
  ['with a script in its strings', fragment(JSON.stringify({ ...situation, mappers: ['<script>alert(1)</script>'] })), /The link/],
  ['to a building that is not here', fragment(JSON.stringify(situation).replace('office', 'castle')), /castle/],
  ['to a building that has changed', fragment(JSON.stringify(situation)), /office/],
  ['to a building with no number', fragment(JSON.stringify(situation).replace('office', 'generated:-1')), /generated:-1/],
];

for (const [what, hash, message] of hostile) {
  test(`a link ${what} gets an answer, and the page its first scene`, async ({ page }) => {
    const failures: string[] = [];
    page.on('pageerror', (error) => failures.push(error.message));
    page.on('dialog', (dialog) => failures.push(dialog.message()));
    const bench = new BenchPage(page);
    await bench.open(hash);
    await expect(page.getByRole('alert')).toContainText(message);
    await expect(page.getByRole('alert')).toContainText('first scene');
    await expect(bench.choice).toHaveValue('office');
    expect(await page.locator('script:not([src])').count()).toBe(0);
    expect(failures).toEqual([]);
  });
}

test('a run that would take a day to go through again can be left', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const own = { format: 'cogmap-world/1', name: 'Cell', walls: [[[0, 0], [5, 0], [5, 4]]], start: { position: [1, 2] } };
  const commands = [{ tick: 0, do: 'drive', linear: 0, angular: 1 }];
  const source = { from: 'world', world: own, robot: 'bad', commands, ticks: 4_000_000 };
  const day = { ...situation, source, at: 4_000_000 };
  await page.evaluate((hash) => (location.hash = hash), fragment(JSON.stringify(day)));
  await expect(bench.choice).toContainText('Cell');
  await bench.choice.selectOption('tour');
  await expect(page.getByRole('heading', { name: 'The world' })).toBeVisible();
  await expect.poll(() => bench.travelled()).toBeGreaterThan(0);
});
