import { expect, test } from '@playwright/test';
import { strFromU8, unzipSync } from 'fflate';
import { BenchPage } from './bench';

test('the drawing holds the world and the memory, and a browser shows it', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const { name, bytes } = await bench.save('Drawing');
  expect(name).toMatch(/\.svg$/);
  const shown = await page.evaluate(async (text) => {
    const problem = new DOMParser().parseFromString(text, 'image/svg+xml').querySelector('parsererror');
    const address = URL.createObjectURL(new Blob([text], { type: 'image/svg+xml' }));
    const image = new Image();
    image.src = address;
    await image.decode();
    URL.revokeObjectURL(address);
    return { problem: problem?.textContent, width: image.naturalWidth, height: image.naturalHeight };
  }, bytes.toString());
  expect(shown).toMatchObject({ problem: undefined, width: 1600 });
  expect(shown.height).toBeGreaterThan(300);
  for (const heading of ['The world', 'memory: ']) expect(bytes.toString()).toContain(heading);
});

test('the table has a row for each scan, and starts where the robot started', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const { name, bytes } = await bench.save('Table');
  expect(name).toMatch(/\.csv$/);
  const [head, ...rows] = bytes.toString().trimEnd().split('\r\n');
  expect(head).toBe(
    't,truth x,truth y,truth heading,odometry x,odometry y,odometry heading,estimate x,estimate y,estimate heading',
  );
  expect(rows.length).toBeGreaterThan(5);
  const numbers = rows.map((row) => row.split(',').map(Number));
  expect(numbers.every((row) => row.length === 10 && row.every(Number.isFinite))).toBe(true);
  expect(numbers[0]?.slice(4, 10)).toEqual([0, 0, 0, 0, 0, 0]);
});

test('everything comes in one archive, each file as if saved alone, and its session opens', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  const map = await bench.save('Map');
  const session = await bench.save('Session');
  const table = await bench.save('Table');
  const drawing = await bench.save('Drawing');
  const { name, bytes } = await bench.save('Everything');
  const stem = name.replace(/\.zip$/, '');
  const files = unzipSync(bytes);
  const text = (file: string) => strFromU8(files[`${stem}/${file}`] ?? new Uint8Array());
  expect(Object.keys(files).map((file) => file.slice(stem.length + 1)).sort()).toEqual([
    'estimate.tum',
    'events.jsonl',
    'map.json',
    'network.g2o',
    'odometry.tum',
    'report.json',
    'session.json',
    'table.csv',
    'truth.tum',
    'views.svg',
  ]);
  expect(text('map.json')).toBe(map.bytes.toString());
  expect(text('session.json')).toBe(session.bytes.toString());
  expect(text('table.csv')).toBe(table.bytes.toString());
  expect(text('views.svg')).toBe(drawing.bytes.toString());
  const poses = (file: string) => text(file).trimEnd().split('\n').map((row) => row.split(' ').map(Number));
  for (const file of ['truth.tum', 'odometry.tum', 'estimate.tum']) {
    expect(poses(file).every((row) => row.length === 8 && row.every(Number.isFinite)), file).toBe(true);
    expect(poses(file).length, file).toBe(poses('truth.tum').length);
  }
  // The trajectories are those of the table: when, where, and turned by so much.
  const [, ...rows] = text('table.csv').trimEnd().split('\r\n').map((row) => row.split(',').map(Number));
  for (const [index, file] of ['truth.tum', 'odometry.tum', 'estimate.tum'].entries()) {
    expect(poses(file).length).toBe(rows.length);
    for (const [row, [t = NaN, x = NaN, y = NaN, z, , , sine = NaN, cosine = NaN]] of poses(file).entries()) {
      const [at = NaN, left = NaN, up = NaN, heading = NaN] = [rows[row]?.[0], ...(rows[row]?.slice(1 + 3 * index, 4 + 3 * index) ?? [])];
      expect(t).toBeCloseTo(at, 3);
      expect([x, y, z]).toEqual([expect.closeTo(left, 3), expect.closeTo(up, 3), 0]);
      expect(Math.cos(2 * Math.atan2(sine, cosine) - heading)).toBeCloseTo(1, 3);
    }
  }
  const times = poses('truth.tum').map(([t = NaN]) => t);
  expect(times).toEqual([...times].sort((one, other) => one - other));
  for (const line of text('events.jsonl').trimEnd().split('\n')) expect(JSON.parse(line)).toHaveProperty('kind');
  expect(text('network.g2o')).toMatch(/^VERTEX_SE2 /m);
  expect(JSON.parse(text('report.json'))).toHaveProperty('format');

  const surfaces = await bench.surfaces();
  await bench.replay(text('session.json'));
  expect(await bench.surfaces()).toBe(surfaces);
});

test('two memories are drawn side by side and have their columns', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.chip('odometry').click();
  await expect(bench.memory).toHaveCount(2);
  expect((await bench.save('Drawing')).bytes.toString()).toContain('memory: odometry');
  const head = (await bench.save('Table')).bytes.toString().split('\r\n')[0];
  expect(head).toContain('estimate-odometry heading');
});
