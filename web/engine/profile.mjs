// Finds out what of the engine the page needs until somebody drives, and writes it into `first.txt`.
//
// npm --prefix web run profile, after `cargo xtask demo --build-only`. Every function of the whole engine tells when
// it is called first, while the page is opened and a robot is driven in a browser (CHROMIUM_PATH chooses which).
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import binaryen from 'binaryen';
import { preview } from 'vite';
import { plain } from './names.mjs';

const folder = join(import.meta.dirname, '../src/wasm');
const list = join(import.meta.dirname, 'first.txt');
/** Milliseconds that are watched once the robot drives by itself, and while somebody holds each key. */
const WATCHED = [2000, 1200];

/** Tells the module's functions apart by numbers, and the worker which of them were called. */
const HEAD = `{ globalThis.touched = new Set();
const instantiate = WebAssembly.instantiate;
WebAssembly.instantiate = (module, imports) =>
  instantiate(module, { ...imports, profile: { touch: (k) => globalThis.touched.add(k) } }); }\n`;

const [engine, names] = telling(readFileSync(join(folder, 'engine.wasm')));
const server = await preview({ preview: { port: 0, host: '127.0.0.1' } });
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM_PATH ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
const context = await browser.newContext({ serviceWorkers: 'block', viewport: { width: 1440, height: 900 } });
await context.route('**/first-*.wasm', (route) => route.fulfill({ body: engine, contentType: 'application/wasm' }));
await context.route('**/*.js', async (route) => {
  const response = await route.fetch();
  const body = await response.text();
  await route.fulfill({ response, body: body.includes('WebAssembly.') ? HEAD + body : body });
});
const page = await context.newPage();
const address = `http://127.0.0.1:${server.httpServer.address().port}/`;
// In another language the legends are worded, too.
await page.goto(`${address}?lang=de`);
await drivenOn();
const inGerman = await told();
await page.goto(address);
await drivenOn();
await page.waitForTimeout(WATCHED[0]);
for (const key of ['ArrowUp', 'ArrowLeft', 'ArrowUp', 'ArrowRight']) {
  await page.keyboard.down(key);
  if (key === 'ArrowUp') await drivenOn();
  await page.waitForTimeout(WATCHED[1]);
  await page.keyboard.up(key);
}
const touched = [...inGerman, ...(await told())];
await browser.close();
await server.close();

const called = [...new Set(touched.map((k) => plain(names[k])))].sort();
if (called.length === 0) throw new Error('the engine told of no function: has the page been built?');
writeFileSync(list, `# What the page calls until somebody drives; written by engine/profile.mjs.\n${called.join('\n')}\n`);
console.log(`${called.length} names in ${list}: build the page again`);

/** The numbers of the functions that the page's workers called. */
async function told() {
  const each = page.workers().map((worker) => worker.evaluate(() => [...(globalThis.touched ?? [])]));
  return (await Promise.all(each)).flat();
}

/** Waits until the robot has driven farther, however long that takes. */
async function drivenOn() {
  const before = await driven();
  while ((await driven()) <= before) await page.waitForTimeout(200);
}

/** Metres driven, as the page tells it. */
async function driven() {
  const words = await page.evaluate(() => document.body.innerText);
  return Number(/([\d.,]+) m (?:driven|gefahren)/.exec(words)?.[1].replace(',', '.') ?? 0);
}

/** The engine with a call at the beginning of each function, and the functions' names by their numbers. */
function telling(bytes) {
  const module = binaryen.readBinary(bytes);
  const functions = Array.from({ length: module.getNumFunctions() }, (_, k) => module.getFunctionByIndex(k));
  module.addFunctionImport('touch', 'profile', 'touch', binaryen.i32, binaryen.none);
  const names = [];
  for (const it of functions) {
    const { name, module: from, body, results } = binaryen.getFunctionInfo(it);
    if (from !== '') continue;
    const tell = module.call('touch', [module.i32.const(names.push(name) - 1)], binaryen.none);
    binaryen.Function.setBody(it, module.block(null, [tell, body], results));
  }
  return [Buffer.from(module.emitBinary()), names];
}
