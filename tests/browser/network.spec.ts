import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { chromium, expect, test } from '@playwright/test';
import { BenchPage, roomLog } from './bench';

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
  const page = await browser.newPage({ baseURL: baseURL ?? '' });
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(20) });
  await expect(page.getByRole('slider', { name: 'Timeline' })).toHaveValue('20');
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
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(20) });
  await expect(page.getByRole('slider', { name: 'Timeline' })).toHaveValue('20');
});

test('the policy allows nothing inline, and the page keeps to it', async ({ page }) => {
  const complaints: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  const response = await page.goto('./');
  const header = response?.headers()['content-security-policy'] ?? '';
  const declared = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content');
  for (const policy of [header, declared ?? '']) {
    expect(policy).not.toContain("'unsafe-inline'");
    expect(policy).not.toContain("'unsafe-eval'");
  }
  expect(declared).toContain("default-src 'self'");
  const bench = new BenchPage(page);
  await bench.open();
  await page.keyboard.press('?');
  await page.keyboard.press('Escape');
  await bench.takeOver();
  expect(complaints).toEqual([]);
  expect(await page.locator('style, script:not([src]), [style*=":"]').count()).toBe(0);
});
