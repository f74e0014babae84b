import { createStore, del, get, keys, set, type UseStore } from 'idb-keyval';
import { hold } from '../worker/lifeline';

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

/** A run that was left behind, and the visit to the page that left it. */
export interface LeftRun extends KeptRun {
  visit: string;
}

/** Of the runs that were left behind so many are kept. */
const LEFT = 4;
/** How long a page that is just being left may take to let go of its run, milliseconds. */
const PARTING = 500;
/** What the name of a run's log ends with. */
const LOG = '-log';

/**
 * Where the browser keeps runs: one for each visit to the page, so that two windows keep a run each. A browser that
 * keeps nothing, as in some private windows, is no reason to complain: then nothing is found here.
 */
export class Shelf {
  private readonly store: UseStore | undefined = openStore();
  private readonly visit = `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;
  /** The log that lies beside the run at hand. */
  private log: File | undefined;

  constructor() {
    void hold(lockOf(this.visit));
  }

  /** Keeps the run at hand. */
  async keep({ log, ...run }: KeptRun): Promise<void> {
    await this.attempt(async (store) => {
      if (log !== this.log) await (log ? set(this.visit + LOG, log, store) : del(this.visit + LOG, store));
      this.log = log;
      await set(this.visit, run, store);
    });
  }

  /** The newest run of a visit that is over; the others wait until it is taken up or thrown away. */
  async leftBehind(): Promise<LeftRun | undefined> {
    return this.attempt(async (store) => {
      const names = (await keys(store)).filter((key) => typeof key === 'string');
      const visits = names.filter((name) => !name.endsWith(LOG) && name !== this.visit);
      const found = await Promise.all(visits.map((visit) => left(visit, store)));
      const runs = found.filter((run) => run !== undefined).sort((one, other) => other.when - one.when);
      for (const { visit } of runs.slice(LEFT)) await clear(visit, store);
      return runs[0];
    });
  }

  /** Throws away what a visit has left behind. */
  async discard(visit: string): Promise<void> {
    await this.attempt((store) => clear(visit, store));
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

const lockOf = (visit: string): string => `cogmap-run-${visit}`;

/** What a visit has left behind, if it is over. */
async function left(visit: string, store: UseStore): Promise<LeftRun | undefined> {
  const run: unknown = (await isOver(visit)) && (await get(visit, store));
  if (!isRun(run)) return undefined;
  const log: unknown = await get(visit + LOG, store);
  return log instanceof File ? { ...run, visit, log } : { ...run, visit };
}

async function clear(visit: string, store: UseStore): Promise<void> {
  await del(visit, store);
  await del(visit + LOG, store);
}

/** Whether no window shows the run of a visit any more; a browser without locks cannot tell, and offers it. */
async function isOver(visit: string): Promise<boolean> {
  const signal = AbortSignal.timeout(PARTING);
  return navigator.locks?.request(lockOf(visit), { signal }, () => true).catch(() => false) ?? true;
}

/** Another version of the page may have kept something else. */
function isRun(kept: unknown): kept is KeptRun {
  if (typeof kept !== 'object' || kept === null) return false;
  const { situation, name, time, when } = kept as Partial<KeptRun>;
  return [situation, name].every((it) => typeof it === 'string') && [time, when].every(Number.isFinite);
}
