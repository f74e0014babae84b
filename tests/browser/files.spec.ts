import { expect, test } from '@playwright/test';
import { BenchPage, roomLog } from './bench';

test('a dropped log is mapped', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(40) });
  await expect(page.getByRole('heading', { name: 'The log by its odometry alone' })).toBeVisible();
  await expect(page.getByRole('slider', { name: 'Timeline' })).toHaveValue('40');
  expect(await bench.surfaces()).toBeGreaterThan(0);
});

test('a session and its log come in any order, and nothing that does not belong to the other is left out silently', async ({ page }) => {
  const bench = new BenchPage(page);
  const timeline = page.getByRole('slider', { name: 'Timeline' });
  const log = { name: 'room.log', content: roomLog(20) };
  await bench.open('?mappers=odometry');
  await bench.drop(log);
  await expect(timeline).toHaveValue('20');
  const session = await bench.save('Session');
  const both = [log, { name: session.name, content: session.bytes.toString() }];
  await bench.open();
  await bench.drop(...both);
  await expect(timeline).toHaveValue('20');
  expect((await bench.save('Session')).bytes.equals(session.bytes)).toBe(true);
  await bench.drop(log, { name: 'other.log', content: roomLog(5) });
  await expect(page.getByRole('alert')).toContainText('room.log and other.log do not belong together');
  await bench.drop(...both, log);
  await expect(page.getByRole('alert')).toContainText('These are 3 files.');
  await expect(timeline).toHaveValue('20');
});

test('mapping a log can be cancelled, and the run before it is still there', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.pause();
  const before = await bench.memory.innerText();
  await bench.drop({ name: 'room.log', content: roomLog(75) });
  await expect(page.getByRole('heading', { name: 'The log by its odometry alone' })).toBeVisible();
  await page.getByLabel('Speed').selectOption('1×');
  await page.getByRole('slider', { name: 'Timeline' }).fill('3');
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(page.getByRole('heading', { name: 'The world' })).toBeVisible();
  await expect(bench.memory).toHaveText(before, { useInnerText: true });
});

const hostile: [string, string, string, RegExp][] = [
  ['a session that is cut off', 'cut.json', '{"format":"cogmap-session/1","engine":', /cut\.json/],
  ['a session of nonsense', 'odd.json', '{"format":"cogmap-session/1","seed":"<script>alert(1)</script>"}', /odd\.json/],
  ['a world without a start', 'hut.world.json', '{"format":"cogmap-world/1","name":"Hut"}', /start/],
  ['a log without scans', 'empty.log', '# nothing\nHELLO 1 2 3\n', /empty\.log/],
  ['a picture', 'photo.png', '\u0089PNG\r\n\u001a\n\0\0\0', /photo\.png/],
];

for (const [what, name, content, message] of hostile) {
  test(`${what} gets an answer, and nothing is lost`, async ({ page }) => {
    const bench = new BenchPage(page);
    await bench.open();
    await bench.drop({ name, content });
    await expect(page.getByRole('alert')).toContainText(message);
    expect(await bench.surfaces()).toBeGreaterThan(0);
    await page.getByRole('button', { name: 'Dismiss' }).click();
    await expect(page.getByRole('alert')).toBeEmpty();
  });
}

test('the picture is a PNG of both views', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  const { name, bytes } = await bench.save('Picture');
  expect(name).toMatch(/\.png$/);
  expect(bytes.subarray(1, 4).toString()).toBe('PNG');
  expect(bytes.readUInt32BE(16)).toBeGreaterThan(bytes.readUInt32BE(20));
  const colours = await page.evaluate(async (encoded) => {
    const picture = await createImageBitmap(new Blob([Uint8Array.from(atob(encoded), (byte) => byte.charCodeAt(0))]));
    const halves = [0, picture.width / 2].map((left) => {
      const context = new OffscreenCanvas(picture.width / 2, picture.height).getContext('2d');
      context?.drawImage(picture, -left, 0);
      const { data } = context?.getImageData(0, 0, picture.width / 2, picture.height) ?? { data: new Uint8ClampedArray() };
      return new Set(new Uint32Array(data.buffer)).size;
    });
    return halves;
  }, bytes.toString('base64'));
  // A drawing in each half, smooth lines and all.
  for (const count of colours) expect(count).toBeGreaterThan(50);
});
