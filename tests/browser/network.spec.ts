import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { chromium, expect, test } from '@playwright/test';
import { BenchPage, roomLog } from './bench';
import { button, enter } from './desk';

test.use({ serviceWorkers: 'allow' });

/** Whom Chromium itself asks for the time, updates and accounts, whatever page it shows. */
const ofTheBrowser = /^(https?:\/\/)?(clients2\.google\.com|update\.googleapis\.com|accounts\.google\.com)[/:]/;

/** A proxy that notes who is asked for and lets nobody through. */
async function trap(): Promise<{ server: Server; address: string; caught: string[] }> {
  const caught: string[] = [];
  const server = createServer((request, response) => {
    caught.push(request.url ?? '');
    response.writeHead(502).end();
  });
  server.on('connect', (request, socket) => {
    caught.push(request.url ?? '');
    socket.end('HTTP/1.1 502 Bad Gateway\r\n\r\n');
  });
  await new Promise<void>((listening) => server.listen(0, '127.0.0.1', listening));
  return { server, address: `http://127.0.0.1:${(server.address() as AddressInfo).port}`, caught };
}

test('neither page nor workers ask any other host for anything', async ({ baseURL, launchOptions }) => {
  const { server, address, caught } = await trap();
  const browser = await chromium.launch({ ...launchOptions, proxy: { server: address, bypass: '127.0.0.1' } });
  const page = await browser.newPage({ baseURL: baseURL ?? '', serviceWorkers: 'allow' });
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(20) });
  await expect(page.getByRole('slider', { name: 'Timeline' })).toHaveValue('20');
  await page.keyboard.press('l');
  await expect(page.getByRole('complementary', { name: 'Plots' }).getByRole('figure').first()).toBeVisible();
  await page.keyboard.press('m');
  await expect(page.getByRole('complementary', { name: 'Text view' })).toContainText('As of view');
  await bench.save('Picture');
  await bench.save('Everything');
  await enter(page, 'New building');
  await button(page, 'Back').click();
  await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
  const foreign = caught.filter((url) => !ofTheBrowser.test(url));
  // A page without the policy does get caught: the trap is set.
  const empty = await browser.newPage();
  await empty.goto('data:text/html,<title>empty</title>');
  await empty.evaluate(() => fetch('http://somewhere.test/', { mode: 'no-cors' }).catch(() => undefined));
  await expect.poll(() => caught.some((url) => url.includes('somewhere.test'))).toBe(true);
  await browser.close();
  server.close();
  expect(foreign).toEqual([]);
});

test('the second visit needs no network', async ({ page, context }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  await context.setOffline(true);
  await bench.open('?embed&world=tour');
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(20) });
  await expect(page.getByRole('slider', { name: 'Timeline' })).toHaveValue('20');
  // What is loaded when somebody asks for it comes, too.
  await page.keyboard.press('l');
  await expect(page.getByRole('complementary', { name: 'Plots' }).locator('.uplot')).not.toHaveCount(0);
  await page.keyboard.press('m');
  await expect(page.getByRole('complementary', { name: 'Text view' })).toContainText('As of view');
  await enter(page, 'New building');
});

test('the policy allows nothing inline, and a whole drive keeps to it', async ({ page }) => {
  const complaints: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  await page.addInitScript(() => {
    document.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) =>
      console.error(`policy: ${violatedDirective} ${blockedURI}`),
    );
  });
  const response = await page.goto('./');
  const header = response?.headers()['content-security-policy'] ?? '';
  const declared = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content');
  for (const policy of [header, declared ?? '']) {
    expect(policy).not.toContain("'unsafe-inline'");
    expect(policy).not.toContain("'unsafe-eval'");
  }
  expect(declared).toContain("default-src 'self'");
  expect(header).toBe(`${declared}; frame-ancestors *`);
  const bench = new BenchPage(page);
  await bench.open();
  await page.keyboard.press('?');
  await page.keyboard.press('Escape');
  await bench.takeOver();
  await page.getByRole('button', { name: 'Switch to dark' }).click();
  await bench.chip('odometry').click();
  await page.keyboard.down('ArrowUp');
  await page.waitForTimeout(500);
  await page.keyboard.up('ArrowUp');
  await page.getByRole('slider', { name: 'Timeline' }).fill('20');
  await bench.save('Picture');
  await bench.share('Copy link');
  await page.keyboard.press('h');
  await page.getByLabel('Speed').selectOption('Max');
  await expect(page.getByText(/Home: it stopped by itself/).first()).toBeVisible();
  // What is kept as the run grows is kept every two seconds.
  await page.waitForTimeout(2500);
  await bench.open();
  await page.getByRole('button', { name: 'Go on', exact: true }).click();
  await expect(page.getByText(/Home: it stopped by itself/).first()).toBeVisible();
  expect(complaints).toEqual([]);
  // Where a mark stands on the timeline and how the views share their room is set by script, which the policy allows.
  expect(await page.locator('style, script:not([src]), [style*=":"]:not(.marks > button, .views)').count()).toBe(0);
  // The page would have been told: the ear is open.
  await page.evaluate(() => document.body.append(Object.assign(document.createElement('script'), { text: '1' })));
  await expect.poll(() => complaints.some((text) => text.includes('script-src'))).toBe(true);
});

test('whatever is served carries the policy, and what is missing is said to be', async ({ page, request }) => {
  await new BenchPage(page).open();
  const names = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
  const script = names.find((name) => name.endsWith('.js')) ?? '';
  for (const address of ['./', script, './icon.svg', './sw.js']) {
    const answer = await request.get(address);
    expect(answer.status(), address).toBe(200);
    expect(answer.headers()['content-security-policy'], address).toContain("script-src 'self' 'wasm-unsafe-eval'");
    expect(answer.headers()['x-content-type-options'], address).toBe('nosniff');
  }
  for (const missing of ['./missing', './missing.js', './..%2f..%2fpackage.json', './%2e%2e/package.json']) {
    expect((await request.get(missing)).status(), missing).toBe(404);
  }
});

test('the page can be installed', async ({ page, request }) => {
  await new BenchPage(page).open();
  const address = await page.locator('link[rel="manifest"]').getAttribute('href');
  const manifestUrl = new URL(address ?? '', page.url()).href;
  const manifest = (await (await request.get(manifestUrl)).json()) as {
    name: string;
    display: string;
    start_url: string;
    icons: { src: string; sizes: string; type: string; purpose?: string }[];
  };
  expect(manifest.name).toBe('Cogmap');
  expect(manifest.display).toBe('standalone');
  expect((await request.get(new URL(manifest.start_url, manifestUrl).href)).status()).toBe(200);
  const png = manifest.icons.filter(({ type }) => type === 'image/png');
  expect(png.map(({ sizes }) => sizes)).toEqual(expect.arrayContaining(['192x192', '512x512']));
  expect(png.some(({ purpose }) => purpose?.includes('maskable'))).toBe(true);
  for (const { src, sizes, type } of manifest.icons) {
    const icon = await request.get(new URL(src, manifestUrl).href);
    expect(icon.headers()['content-type']).toContain(type);
    if (type === 'image/png') {
      const bytes = await icon.body();
      expect(`${bytes.readUInt32BE(16)}x${bytes.readUInt32BE(20)}`).toBe(sizes);
    }
  }
});
