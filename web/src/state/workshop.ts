import { proxy, wrap, type Remote } from 'comlink';
import type { Bench } from '../worker/bench';
import { whenReleased } from '../worker/lifeline';
import type { Moment, Notice, Offer } from '../worker/protocol';

/** The worker with the bench in it, and the news of its end. */
export class Workshop {
  readonly bench: Remote<Bench>;
  private readonly worker = new Worker(new URL('../worker/index.ts', import.meta.url), { type: 'module' });
  private readonly closing = new AbortController();

  /** `ended` is called once if the worker ends by itself: it crashed, or the browser ended it. */
  constructor(private readonly ended: (reason: string) => void) {
    const { signal } = this.closing;
    this.worker.addEventListener('error', ({ message }) => this.end(message), { signal });
    addEventListener('unhandledrejection', ({ reason }) => isCrash(reason) && this.end(String(reason)), { signal });
    this.bench = wrap<Bench>(this.worker);
  }

  /** Loads the engine; `listen` hears what happens, `keep` gets what is to be kept. */
  async begin(listen: (notice: Notice) => void, keep: (moment: Moment) => void): Promise<Offer> {
    const name = `cogmap-worker-${crypto.getRandomValues(new Uint32Array(2)).join('-')}`;
    const offer = await this.bench.begin(name, proxy(listen), proxy(keep));
    const granted = navigator.locks?.query().then(({ held }) => held?.some((lock) => lock.name === name));
    // Where the worker could not get hold of the name, its release says nothing.
    if (await granted?.catch(() => false)) whenReleased(name, this.closing.signal, () => this.end(''));
    return offer;
  }

  /** Ends the worker. */
  close(): void {
    this.closing.abort();
    this.worker.terminate();
  }

  /** Takes note of the end. */
  end(reason: string): void {
    if (this.closing.signal.aborted) return;
    this.close();
    this.ended(reason);
  }
}

/** Whether an error is the engine's end and not an answer: after a trap nothing in it can be trusted. */
export function isCrash(error: unknown): boolean {
  return error instanceof Error && error.name === 'RuntimeError';
}

/** What an error says. */
export function reason(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
