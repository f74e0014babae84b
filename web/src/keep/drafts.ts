import type { Edits } from '../editor/history.svelte';
import type { Point } from '../editor/geometry';
import type { ToolName } from '../editor/tools';
import { Shelf, type Kept } from './shelf';

/** A building that is being drawn, as it is kept: every edit, and the line that is not yet ended. */
export interface KeptDraft extends Kept, Edits {
  tool: ToolName;
  pending: Point[];
  /** The file of it that was driven in or saved last. */
  done: string | undefined;
  /** Whether it holds what no file and no run does. */
  unfinished: boolean;
}

/** Where drawings are kept. */
export const draftShelf = (): Shelf<KeptDraft> => new Shelf('cogmap-drafts', 'drafts', isDraft);

/** The engine looks at the rest. */
function isDraft(kept: unknown): kept is KeptDraft {
  if (typeof kept !== 'object' || kept === null) return false;
  const { past, present, future, pending, when } = kept as Partial<KeptDraft>;
  return [past, future, pending, present?.things].every(Array.isArray) && Number.isFinite(when);
}
