import { spawn, spawnSync, type ChildProcess } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { chromium, test, type Browser, type Page, type Worker } from '@playwright/test';
import { BenchPage, roomLog } from './bench';

/** Surfaces that the memory holds while it is painted. */
const SURFACES = 5000;
/** So often the page is opened to see how long that blocks it. */
const OPENINGS = 7;
/** By then the browser is done with a new window, milliseconds. */
const SETTLED = 3000;
/** By then it has opened, milliseconds; what the service worker fetches later falls into the time of its use. */
const OPENED = 2500;
/** Shares of a run that are gone back to. */
const SCRUBBED = [0.02, 0.1, 0.21];
/** Scans of the log that is scrubbed through. */
const SCANS = 1300;
/** Seconds that frames are counted for. */
const COUNTED = 10;

const say = (what: string, number: string, bar: string): void => {
  console.log(`    ${what.padEnd(75)}${number.padStart(10)}   (${bar})`);
};

const kilobytes = (bytes: number): string => `${(bytes / 1000).toFixed(0)} kB`;

/** What a file takes to come, as servers send it. */
const packed = (bytes: Buffer): number => gzipSync(bytes, { level: 9 }).length;

test('what has to come before the page can be used, and all that can', async ({ browser }) => {
  const context = await browser.newContext({ serviceWorkers: 'block' });
  const page = await context.newPage();
  // It is fetched after the first frame, and only counts among all that can come.
  await context.route('**/rest-*.wasm', (route) => route.abort());
  const sizes: Promise<[string, number]>[] = [];
  context.on('response', (response) => {
    const { pathname } = new URL(response.url());
    if (/\.(js|wasm)$/.test(pathname)) sizes.push(response.body().then((body) => [pathname, packed(body)]));
  });
  await new BenchPage(page).open('');
  const came = await Promise.all(sizes);
  const sum = (kind: RegExp): number => came.reduce((all, [name, size]) => all + (kind.test(name) ? size : 0), 0);
  say('JavaScript before the first frame, gzipped', kilobytes(sum(/js$/)), 'with the wasm at most 400 kB');
  say('wasm before the first frame, gzipped', kilobytes(sum(/wasm$/)), 'with the JavaScript at most 400 kB');
  // The folder that npm runs this in is `web`.
  const dist = resolve('dist');
  const files = readdirSync(dist, { recursive: true, encoding: 'utf8' }).filter((name) => /\.(js|wasm)$/.test(name));
  const all = files.reduce((bytes, name) => bytes + packed(readFileSync(join(dist, name))), 0);
  say('all JavaScript and wasm, gzipped', kilobytes(all), 'at most 1500 kB');
  await context.close();
});

test('how long the main thread is blocked', async ({ browser, page }) => {
  const openings: Task[] = [];
  for (let k = 0; k < OPENINGS; k += 1) {
    const context = await browser.newContext();
    const visited = await context.newPage();
    // A visitor's window has stood open; a new one loads pages of the browser's own meanwhile.
    await visited.waitForTimeout(SETTLED);
    openings.push(await longestTask(browser, visited, () => opened(visited)));
    await test.expect.poll(() => new BenchPage(visited).surfaces()).toBeGreaterThan(0);
    await context.close();
  }
  const sorted = (what: keyof Task): number[] => openings.map((task) => task[what]).sort((a, b) => a - b);
  const spread = (times: number[]): string => [times[(OPENINGS - 1) / 2], times.at(-1)].map((time) => time?.toFixed(0)).join(', ');
  say(`longest block of the main thread while opening, median and worst of ${OPENINGS}`, `${spread(sorted('wall'))} ms`, '50 ms');
  say('… without what it waits for a core or another process', `${spread(sorted('own'))} ms`, 'of those');
  const bench = new BenchPage(page);
  await bench.open('');
  const used = await longestTask(browser, page, () => use(page));
  say('longest block of the main thread while everything is used', `${used.wall.toFixed(0)} ms`, '50 ms');
  say('… without what it waits for a core or another process', `${used.own.toFixed(0)} ms`, 'of those');
});

/** Opens the page and leaves it alone: whoever asks it whether it is there keeps it from its work. */
async function opened(page: Page): Promise<void> {
  await page.goto('./');
  await page.waitForTimeout(OPENED);
}

async function use(page: Page): Promise<void> {
  await page.getByLabel('Speed').selectOption('16×');
  await page.waitForTimeout(3000);
  await page.getByRole('button', { name: 'Go Home', exact: true }).click();
  await page.getByRole('button', { name: 'Why?' }).first().click();
  for (let k = 0; k < 6; k += 1) await page.getByRole('button', { name: 'Next stage' }).click();
  await page.getByRole('slider', { name: 'Timeline' }).fill('40');
  await page.getByRole('button', { name: 'transform' }).click();
  await page.waitForTimeout(3000);
}

/** What a trace of Chromium tells of something that happened; times in microseconds. */
interface TraceEvent {
  name: string;
  pid: number;
  tid: number;
  dur?: number;
  /** Without the time in which the thread waited for a core. */
  tdur?: number;
}

/** The longest that a task of the main thread took, and the most that one worked, milliseconds. */
interface Task {
  wall: number;
  own: number;
}

/** What the page's main thread is known by in a trace; the browser has pages of its own. */
const MARK = 'the page under test';

async function longestTask(browser: Browser, page: Page, work: () => Promise<void>): Promise<Task> {
  await browser.startTracing(page, { categories: ['toplevel', 'blink.user_timing'] });
  await work();
  await page.evaluate((mark) => performance.mark(mark), MARK);
  const trace = JSON.parse((await browser.stopTracing()).toString()) as { traceEvents: TraceEvent[] };
  const here = trace.traceEvents.find(({ name }) => name === MARK);
  if (!here) throw new Error('the trace does not hold the mark of the page');
  const tasks = trace.traceEvents.filter(
    ({ pid, tid, name }) => pid === here.pid && tid === here.tid && name.endsWith('RunTask'),
  );
  const most = (times: (number | undefined)[]): number => Math.max(0, ...times.map((time) => (time ?? 0) / 1000));
  return { wall: most(tasks.map(({ dur }) => dur)), own: most(tasks.map(({ tdur }) => tdur)) };
}

test('how long a frame takes to paint', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'jagged.log', content: jaggedLog() });
  await test.expect.poll(() => bench.surfaces(), { timeout: 120_000 }).toBeGreaterThanOrEqual(SURFACES);
  await page.getByRole('button', { name: 'Pause' }).click({ timeout: 1000 }).catch(() => undefined);
  const worker = page.workers()[0];
  const box = await page.locator('canvas').last().boundingBox();
  if (!worker || !box) throw new Error('the page has no worker or no memory');
  await timeFrames(worker);
  const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  await page.mouse.move(middle.x, middle.y);
  await page.mouse.down();
  for (let k = 0; k < 60; k += 1) await page.mouse.move(middle.x + 2 * k, middle.y + k);
  await page.mouse.up();
  say(`painting ${await bench.surfaces()} surfaces while panning`, await frames(worker), '95th percentile at most 8 ms');
  for (let k = 0; k < 60; k += 1) {
    await page.mouse.wheel(0, k < 30 ? -60 : 60);
    await page.waitForTimeout(16);
  }
  say('… while zooming', await frames(worker), '95th percentile at most 8 ms');
});

/** Times what the worker does in each frame. */
const timeFrames = (worker: Worker): Promise<void> =>
  worker.evaluate(() => {
    const times: number[] = [];
    const next = self.requestAnimationFrame.bind(self);
    Object.assign(self, {
      times,
      requestAnimationFrame: (turn: FrameRequestCallback) =>
        next((now) => {
          const begin = performance.now();
          turn(now);
          times.push(performance.now() - begin);
        }),
    });
  });

/** The 95th percentile of the frames since it was asked last. */
async function frames(worker: Worker): Promise<string> {
  const times = await worker.evaluate(() => (self as unknown as { times: number[] }).times.splice(0));
  times.sort((a, b) => a - b);
  return `${(times[Math.floor(0.95 * times.length)] ?? NaN).toFixed(1)} ms`;
}

test('how long scrubbing takes', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open('?mappers=consensus&world=tour');
  await page.getByRole('button', { name: 'To the end' }).click();
  await test.expect(page.getByRole('button', { name: 'Play' })).toBeDisabled({ timeout: 60_000 });
  say(`scrubbing through a drive of ${await views(bench)} views, worst of ${SCRUBBED.length}`, await scrubbed(page), 'at most 100 ms');
  await bench.drop({ name: 'room.log', content: roomLog(SCANS, (scan) => 0.1 * Math.abs((scan % 120) - 60)) });
  await test.expect.poll(() => views(bench), { timeout: 120_000 }).toBe(SCANS);
  say(`… through a log of ${SCANS}, 1,000 of them back and more`, await scrubbed(page), 'at most 100 ms');
});

/** Views that the first memory was made from, as the page tells it. */
async function views(bench: BenchPage): Promise<number> {
  return Number(/from ([\d,]+) views/.exec(await bench.memory.first().innerText())?.[1]?.replaceAll(',', '') ?? 0);
}

/** The longest that the page takes from the end of a run to show an earlier moment of it, painted. */
async function scrubbed(page: Page): Promise<string> {
  const slider = page.getByRole('slider', { name: 'Timeline' });
  const times: number[] = [];
  for (const share of SCRUBBED) {
    times.push(await slider.evaluate(scrub, share));
    await slider.evaluate(scrub, 1);
  }
  return `${Math.max(...times).toFixed(0)} ms`;
}

/** Milliseconds until the page tells another moment, of which it hears once it is painted. */
const scrub = (slider: HTMLElement | SVGElement, share: number): Promise<number> =>
  new Promise((done) => {
    const input = slider as HTMLInputElement;
    const begin = performance.now();
    const told = new MutationObserver(() => {
      told.disconnect();
      requestAnimationFrame(() => done(performance.now() - begin));
    });
    told.observe(document.querySelector('output') ?? input, { characterData: true, childList: true, subtree: true });
    input.value = String(Math.round(Number(input.max) * share));
    input.dispatchEvent(new Event('input', { bubbles: true }));
  });

test('frames on half a core', async ({ baseURL }) => {
  if (spawnSync('cpulimit', ['--help']).error) {
    console.log('    frames on half a core are not counted: cpulimit is missing');
    return;
  }
  const server = await chromium.launchServer({ ...test.info().project.use.launchOptions });
  const browser = await chromium.connect(server.wsEndpoint());
  const page = await browser.newPage(baseURL === undefined ? {} : { baseURL });
  await new BenchPage(page).open();
  const limit = confine(server.process());
  await page.waitForTimeout(3000);
  const shown = await count(page.workers()[0]);
  say('frames a second that the worker paints, Chromium on half a core', shown.toFixed(0), 'above 30');
  limit.kill();
  await browser.close();
  await server.close();
});

/** Lets a process and its children have half a core. */
const confine = (process: ChildProcess): ChildProcess =>
  spawn('cpulimit', ['--limit', '50', '--include-children', '--pid', String(process.pid)], { stdio: 'ignore' });

/** Frames a second in a worker. */
async function count(worker: Worker | undefined): Promise<number> {
  const painted = await worker?.evaluate(
    (seconds) =>
      new Promise<number>((done) => {
        let frames = 0;
        const next = self.requestAnimationFrame.bind(self);
        const end = performance.now() + 1000 * seconds;
        const turn = (): void => {
          frames += 1;
          if (performance.now() < end) next(turn);
          else done(frames);
        };
        next(turn);
      }),
    COUNTED,
  );
  return (painted ?? NaN) / COUNTED;
}

/** A log whose scans see walls in steps, each elsewhere, so that a memory grows large soon. */
function jaggedLog(): string {
  const lines = ['PARAM robot_front_laser_max 20.0 robot 0'];
  for (let scan = 0; scan < 290; scan += 1) {
    const ranges = Array.from({ length: 181 }, (_, beam) => {
      const bearing = ((beam - 90) * Math.PI) / 180;
      const wall = Math.floor(beam / 10) % 2 === 0 ? 2.4 : 3.2;
      return (wall / Math.max(Math.abs(Math.sin(bearing)), Math.abs(Math.cos(bearing)))).toFixed(3);
    });
    const pose = `${(7 * (scan % 25)).toFixed(2)} ${(7 * Math.floor(scan / 25)).toFixed(2)} 0`;
    const t = (scan * 0.2).toFixed(2);
    lines.push(`FLASER 181 ${ranges.join(' ')} ${pose} ${pose} ${t} robot ${t}`);
  }
  return `${lines.join('\n')}\n`;
}
