import { createStore, del, get, keys, set, type UseStore } from 'idb-keyval';
import { isOver, stay, visit as present } from './visit';

/** What lies on a shelf: when it was kept, milliseconds since 1970, and for a run the log that it was made from. */
export interface Kept {
  when: number;
  log?: File;
}

/** What was left behind, and the visit to the page that left it. */
export type Left<T> = T & { visit: string };

/** Of what was left behind so much is kept. */
const LEFT = 4;
/** What the name of a log ends with. */
const LOG = '-log';

/**
 * Where the browser keeps something for each visit to the page, so that two windows keep theirs each. A browser that
 * keeps nothing, as in some private windows, is no reason to complain: then nothing is found here.
 */
export class Shelf<T extends Kept> {
  private readonly store: UseStore | undefined;
  /** The log that lies there already. */
  private log: File | undefined;
  /** The visit whose thing is at hand now. */
  private taken: string | undefined;

  /** `sound` looks whether this version of the page understands what another one may have kept. */
  constructor(
    database: string,
    name: string,
    private readonly sound: (kept: unknown) => kept is T,
  ) {
    stay();
    this.store = opened(database, name);
  }

  /** Keeps what is at hand; what was taken over for it is let go only then. */
  async keep({ log, ...kept }: T): Promise<void> {
    await this.attempt(async (store) => {
      if (log !== this.log) await (log ? set(present + LOG, log, store) : del(present + LOG, store));
      this.log = log;
      await set(present, kept, store);
      const { taken } = this;
      this.taken = undefined;
      if (taken !== undefined) await clear(taken, store);
    });
  }

  /** Takes over what a visit has left behind: it is thrown away there once something is kept here. */
  takeOver(visit: string): void {
    this.taken = visit;
  }

  /** What visits that are over have left behind, newest first. */
  async leftBehind(): Promise<Left<T>[]> {
    const found = await this.attempt(async (store) => {
      const names = (await keys(store)).filter((key) => typeof key === 'string');
      const visits = names.filter((name) => !name.endsWith(LOG) && name !== present);
      const found = await Promise.all(visits.map((visit) => this.left(visit, store)));
      const all = found.filter((left) => left !== undefined).sort((one, other) => other.when - one.when);
      for (const { visit } of all.slice(LEFT)) await clear(visit, store);
      return all.slice(0, LEFT);
    });
    return found ?? [];
  }

  /** Throws away what a visit has left behind. */
  async discard(visit: string): Promise<void> {
    await this.attempt((store) => clear(visit, store));
  }

  /** Throws away what this visit has kept and taken over. */
  async empty(): Promise<void> {
    const { taken } = this;
    this.log = this.taken = undefined;
    await this.discard(present);
    if (taken !== undefined) await this.discard(taken);
  }

  private async left(visit: string, store: UseStore): Promise<Left<T> | undefined> {
    const kept: unknown = (await isOver(visit)) && (await get(visit, store));
    if (!this.sound(kept)) return undefined;
    const log: unknown = await get(visit + LOG, store);
    return log instanceof File ? { ...kept, visit, log } : { ...kept, visit };
  }

  private async attempt<R>(work: (store: UseStore) => Promise<R>): Promise<R | undefined> {
    try {
      return this.store && (await work(this.store));
    } catch {
      return undefined;
    }
  }
}

function opened(database: string, name: string): UseStore | undefined {
  try {
    return createStore(database, name);
  } catch {
    return undefined;
  }
}

async function clear(visit: string, store: UseStore): Promise<void> {
  await del(visit, store);
  await del(visit + LOG, store);
}
