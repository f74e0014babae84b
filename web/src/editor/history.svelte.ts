import type { Draft } from '../wasm/cogmap_wasm';

/** How many edits are remembered. */
const MOST = 200;

/** What was drawn, and what it was before each edit. */
export interface Edits {
  past: Draft[];
  present: Draft;
  future: Draft[];
}

/** A draft and its edits, which can be undone and done again. */
export class History {
  private edits = $state.raw<Edits>() as Edits;

  constructor(edits: Edits) {
    this.edits = edits;
  }

  get present(): Draft {
    return this.edits.present;
  }

  get all(): Edits {
    return this.edits;
  }

  readonly canUndo = $derived(this.edits.past.length > 0);
  readonly canRedo = $derived(this.edits.future.length > 0);

  commit(present: Draft): void {
    const past = [...this.edits.past, this.edits.present].slice(-MOST);
    this.edits = { past, present, future: [] };
  }

  undo(): boolean {
    const { past, present, future } = this.edits;
    const before = past.at(-1);
    if (before) this.edits = { past: past.slice(0, -1), present: before, future: [present, ...future] };
    return before !== undefined;
  }

  redo(): boolean {
    const { past, present, future } = this.edits;
    const [after, ...rest] = future;
    if (after) this.edits = { past: [...past, present], present: after, future: rest };
    return after !== undefined;
  }
}
