import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { chromium, expect, test, type CDPSession, type Page } from '@playwright/test';
import type { Order, Status } from '../../web/src/wasm/cogmap_wasm';
import type { Choice } from '../../web/src/worker/protocol';
import { BenchPage } from './bench';

/** What an episode is made of and how it ends when it is driven natively; `tests/tests/soak.rs` writes it. */
interface Episode {
  world: string;
  building: number;
  robot: string;
  strategy: string;
  seed: number;
  ended: string;
  position: number;
  decisions: number;
  pose: [number, number, number];
  distance: number;
  believed: number | null;
}

/** As much of the worker's protocol as an episode takes. */
interface Protocol {
  start(choice: Choice): Promise<void>;
  order(order: Order): Promise<void>;
  finish(): Promise<Status>;
}

declare global {
  interface Window {
    /** The page's worker. */
    soaked: Worker;
    /** The protocol that the page speaks with it; kept, for a worker stops listening when nobody holds it. */
    protocol: Protocol | undefined;
    Comlink: { wrap(worker: Worker): Protocol };
  }
}

/** The longest first: WebAssembly's memory never shrinks, so that only later ones can show what is left behind. */
const episodes = readFileSync(resolve(__dirname, '../goldens/soak.jsonl'), 'utf8')
  .trim()
  .split('\n')
  .map((line) => JSON.parse(line) as Episode)
  .sort((one, other) => other.position - one.position);

/** After so many episodes everything that is made once has been made. */
const WARM = 20;
/** Share by which memory may have grown since. */
const GROWTH = 0.1;

// A trace of so long a test would take more memory and time than the test itself.
test.use({ trace: 'off' });

/**
 * Drives episodes on the page, through the worker's protocol, and tells how each ended. They are driven at one call:
 * what the browser's inspector keeps of each call is not the page's.
 */
function drive(page: Page, episodes: Episode[]): Promise<Episode[]> {
  return page.evaluate(async (episodes) => {
    const bench = (window.protocol ??= window.Comlink.wrap(window.soaked));
    const driven: Episode[] = [];
    for (const { world, building, robot, seed, strategy } of episodes) {
      await bench.start({ world, building, robot, mappers: ['consensus'], seed });
      await bench.finish();
      await bench.order({ kind: 'go_home', strategy });
      const { position, pose, homing } = await bench.finish();
      if (!pose || !homing) throw new Error('The robot did not go home.');
      const { ended, decisions, distance, believed } = homing;
      const told = { ended: ended ?? '', position, decisions, pose, distance, believed: believed ?? null };
      driven.push({ world, building, robot, seed, strategy, ...told });
    }
    return driven;
  }, episodes);
}

/** Asks a worker through the page's session. */
class WorkerSession {
  private asked = 0;
  private constructor(
    private readonly cdp: CDPSession,
    private readonly sessionId: string,
  ) {}

  static async of(cdp: CDPSession): Promise<WorkerSession> {
    const attached = new Promise<string>((found) => {
      cdp.on('Target.attachedToTarget', ({ sessionId, targetInfo }) => {
        if (targetInfo.type === 'worker') found(sessionId);
      });
    });
    await cdp.send('Target.setAutoAttach', { autoAttach: true, waitForDebuggerOnStart: false, flatten: false });
    return new WorkerSession(cdp, await attached);
  }

  async send<T>(method: string, params: object = {}): Promise<T> {
    const id = (this.asked += 1);
    const { cdp, sessionId } = this;
    const answer = new Promise<T>((answered, failed) => {
      const hear = (event: { sessionId: string; message: string }) => {
        const { id: of, result, error } = JSON.parse(event.message);
        if (event.sessionId !== sessionId || of !== id) return;
        cdp.off('Target.receivedMessageFromTarget', hear);
        if (error) failed(new Error(error.message));
        else answered(result);
      };
      cdp.on('Target.receivedMessageFromTarget', hear);
    });
    await cdp.send('Target.sendMessageToTarget', { sessionId, message: JSON.stringify({ id, method, params }) });
    return answer;
  }

  /** Bytes of the engine's memory. */
  async wasmBytes(): Promise<number> {
    const { result } = await this.send<{ result: { value: number } }>('Runtime.evaluate', {
      expression: 'globalThis.memory.buffer.byteLength',
    });
    return result.value;
  }
}

/** Goes before a worker's script: where the engine's memory can be looked at. */
const REMEMBER = `{ const instantiate = WebAssembly.instantiate;
WebAssembly.instantiate = async (...given) => {
  const instance = await instantiate(...given);
  globalThis.memory = instance.exports.memory;
  return instance;
}; }\n`;

/** Bytes in use after everything that nobody holds is gone: on the page, in its worker, and in the engine. */
async function memory(cdp: CDPSession, worker: WorkerSession): Promise<Record<string, number>> {
  await cdp.send('HeapProfiler.collectGarbage');
  await worker.send('HeapProfiler.collectGarbage');
  const page = await cdp.send('Runtime.getHeapUsage');
  const inWorker = await worker.send<{ usedSize: number }>('Runtime.getHeapUsage');
  return { page: page.usedSize, worker: inWorker.usedSize, wasm: await worker.wasmBytes() };
}

/**
 * What V8 learns about the page's script, and what it makes of what it learned, is memory too: it is to learn at
 * once, to make nothing of it, and to forget nothing.
 */
const LEARNED = '--js-flags=--no-lazy-feedback-allocation --no-flush-bytecode --no-sparkplug --no-maglev --no-turbofan';

test('two hundred ways home leave nothing behind, and end as they do natively', async ({ baseURL, launchOptions }) => {
  test.setTimeout(600_000);
  const browser = await chromium.launch({ ...launchOptions, args: [...(launchOptions.args ?? []), LEARNED] });
  const context = await browser.newContext({ baseURL: baseURL ?? '', serviceWorkers: 'block' });
  await context.route('**/*.js', async (route) => {
    const response = await route.fetch();
    const script = await response.text();
    await route.fulfill({ response, body: script.includes('WebAssembly.instantiate') ? REMEMBER + script : script });
  });
  const page = await context.newPage();
  await page.addInitScript({ path: resolve(__dirname, '../../web/node_modules/comlink/dist/umd/comlink.js') });
  await page.addInitScript(() => {
    const Native = Worker;
    window.Worker = class extends Native {
      constructor(...made: ConstructorParameters<typeof Native>) {
        super(...made);
        window.soaked = this;
      }
    };
  });
  await new BenchPage(page).open();
  const cdp = await context.newCDPSession(page);
  const worker = await WorkerSession.of(cdp);
  expect(episodes.length).toBe(200);
  const [first, rest] = [episodes.slice(0, WARM), episodes.slice(WARM)];
  expect(await drive(page, first)).toEqual(first);
  const warm = await memory(cdp, worker);
  expect(await drive(page, rest)).toEqual(rest);
  const now = await memory(cdp, worker);
  await browser.close();
  for (const [what, bytes] of Object.entries(now)) {
    expect(bytes, `${what}, from ${JSON.stringify(warm)} to ${JSON.stringify(now)}`).toBeLessThanOrEqual(
      (1 + GROWTH) * (warm[what] ?? 0),
    );
  }
});
