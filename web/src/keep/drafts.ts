import { createStore, del, get, set, type UseStore } from 'idb-keyval';
import type { Edits } from '../editor/history.svelte';
import type { Point } from '../editor/geometry';
import type { ToolName } from '../editor/tools';

/** A building that is being drawn, as it is kept: every edit, and the line that is not yet ended. */
export interface KeptDraft extends Edits {
  tool: ToolName;
  pending: Point[];
  /** The file of it that was driven in or saved last. */
  done: string | undefined;
  /** Whether it holds what no file and no run does. */
  unfinished: boolean;
  /** When it was kept, milliseconds since 1970. */
  when: number;
}

const KEY = 'draft';
let opened: UseStore | undefined;

/** Keeps a draft. A browser that keeps nothing is no reason to complain. */
export async function keepDraft(draft: KeptDraft): Promise<void> {
  await attempt((store) => set(KEY, draft, store));
}

/** The draft that was left behind. */
export async function keptDraft(): Promise<KeptDraft | undefined> {
  const kept: unknown = await attempt((store) => get(KEY, store));
  return isDraft(kept) ? kept : undefined;
}

/** Throws the kept draft away. */
export async function discardDraft(): Promise<void> {
  await attempt((store) => del(KEY, store));
}

async function attempt<T>(work: (store: UseStore) => Promise<T>): Promise<T | undefined> {
  try {
    opened ??= createStore('cogmap-drafts', 'drafts');
    return await work(opened);
  } catch {
    return undefined;
  }
}

/** Another version of the page may have kept something else; the engine looks at the rest. */
function isDraft(kept: unknown): kept is KeptDraft {
  if (typeof kept !== 'object' || kept === null) return false;
  const { past, present, future, pending, when } = kept as Partial<KeptDraft>;
  return [past, future, pending, present?.things].every(Array.isArray) && Number.isFinite(when);
}
