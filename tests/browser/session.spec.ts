import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { expect, test } from '@playwright/test';
import { BenchPage } from './bench';

const cogmap = process.env['COGMAP_BIN'] ?? resolve(__dirname, '../../target/debug/cogmap');

test('a saved session gives the same map again, on the page and on the command line', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  await page.keyboard.press('Digit0');
  await bench.hold('ArrowRight', 700);
  await bench.hold('ArrowUp', 1200);
  const session = await bench.save('Session');
  const map = (await bench.save('Map')).bytes;

  await bench.replay(session.bytes.toString());
  expect((await bench.save('Map')).bytes.equals(map)).toBe(true);

  await test.step('on the command line', () => {
    test.skip(!existsSync(cogmap), `no command line at ${cogmap}`);
    const folder = mkdtempSync(join(tmpdir(), 'cogmap-'));
    writeFileSync(join(folder, session.name), session.bytes);
    execFileSync(cogmap, ['replay', join(folder, session.name), '--out', join(folder, 'out')]);
    expect(readFileSync(join(folder, 'out', 'map.json')).equals(map)).toBe(true);
    rmSync(folder, { recursive: true });
  });
});
