import { createStore, del, get, set, type UseStore } from 'idb-keyval';

/** A run as it is kept. */
export interface KeptRun {
  situation: string;
  /** What was driven through or mapped, for people. */
  name: string;
  /** Seconds of the run at the moment that was shown. */
  time: number;
  /** When it was kept, milliseconds since 1970. */
  when: number;
  /** The log that it was made from. */
  log?: File;
}

/** The run at hand, and the one before the page was opened. */
type Slot = 'now' | 'before';

/**
 * Where the browser keeps runs. A browser that keeps nothing, as in some private windows, is no reason to
 * complain: then nothing is found here.
 */
export class Shelf {
  private readonly store: UseStore | undefined = openStore();
  /** The log that lies beside the run at hand. */
  private log: File | undefined;

  /** Keeps the run at hand. */
  async keep({ log, ...run }: KeptRun): Promise<void> {
    await this.attempt(async (store) => {
      if (log !== this.log) await (log ? set('now-log', log, store) : del('now-log', store));
      this.log = log;
      await set('now', run, store);
    });
  }

  /** Puts the run that was at hand when the page was left aside, and returns it. */
  async putAside(): Promise<KeptRun | undefined> {
    return this.attempt(async (store) => {
      const left = await this.take('now', store);
      if (left) {
        const { log, ...run } = left;
        await set('before', run, store);
        await (log ? set('before-log', log, store) : del('before-log', store));
        await this.clear('now', store);
      }
      return this.take('before', store);
    });
  }

  /** Throws away the run that was put aside. */
  async discard(): Promise<void> {
    await this.attempt((store) => this.clear('before', store));
  }

  private async take(slot: Slot, store: UseStore): Promise<KeptRun | undefined> {
    const run: unknown = await get(slot, store);
    if (!isRun(run)) return undefined;
    const log: unknown = await get(`${slot}-log`, store);
    return log instanceof File ? { ...run, log } : run;
  }

  private async clear(slot: Slot, store: UseStore): Promise<void> {
    await del(slot, store);
    await del(`${slot}-log`, store);
  }

  private async attempt<T>(work: (store: UseStore) => Promise<T>): Promise<T | undefined> {
    try {
      return this.store && (await work(this.store));
    } catch {
      return undefined;
    }
  }
}

function openStore(): UseStore | undefined {
  try {
    return createStore('cogmap', 'runs');
  } catch {
    return undefined;
  }
}

/** Another version of the page may have kept something else. */
function isRun(kept: unknown): kept is KeptRun {
  if (typeof kept !== 'object' || kept === null) return false;
  const { situation, name, time, when } = kept as Partial<KeptRun>;
  return [situation, name].every((it) => typeof it === 'string') && [time, when].every(Number.isFinite);
}
