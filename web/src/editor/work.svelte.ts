import type { KeptDraft } from '../keep/drafts';
import { save } from '../state/save';
import type { Lab } from '../state/lab.svelte';
import { editing as words } from '../strings/editing';
import type { Checked, Draft } from '../wasm/cogmap_wasm';
import { Document } from './document.svelte';
import { Drawing } from './drawing.svelte';
import type { Engine } from './engine.svelte';

/** Work on a building: what is drawn, with what, and what becomes of it. */
export class Work {
  readonly document: Document;
  readonly drawing: Drawing;
  /** Whether something is under way that has to end first. */
  busy = $state(false);
  /** The building as some file or run holds it, and that file. */
  private done: { draft: Draft | undefined; file: string | undefined };

  constructor(
    private readonly lab: Lab,
    readonly engine: Engine,
    kept: Omit<KeptDraft, 'when'>,
  ) {
    this.document = new Document({ past: kept.past, present: kept.present, future: kept.future });
    this.drawing = new Drawing(this.document);
    this.drawing.tool = kept.tool;
    this.drawing.pending = kept.pending;
    this.done = { draft: kept.unfinished ? undefined : kept.present, file: kept.done };
  }

  /** Keeps all of it for another day. */
  keep(): void {
    const { document, drawing, done } = this;
    const { tool, pending } = drawing;
    const unfinished = document.draft !== done.draft || pending.length > 0;
    this.lab.editing.keep({ ...document.edits, tool, pending, done: done.file, unfinished, when: Date.now() });
  }

  /** Saves the building as a file, unless something has to be put right first. */
  save = (): Promise<void> =>
    this.whenSound(async ({ file, text }) => {
      save({ name: file, blob: new Blob([text], { type: 'application/json' }) });
      this.done = { draft: this.document.draft, file: text };
      this.keep();
      this.document.said = words.said.saved(file);
    });

  /** Begins a run in the building, unless something has to be put right first. */
  drive = (): Promise<void> =>
    this.whenSound(async ({ file, text }) => {
      const { lab } = this;
      const { status, offer } = lab;
      const known = offer?.choices.robots.includes(status?.robot ?? '') && status?.settled;
      if (known && status?.robot) lab.choice = { ...lab.choice, robot: status.robot, seed: status.seed, mappers: lab.mappers };
      await lab.open([new File([text], file)]);
      if (lab.refusal !== undefined) {
        this.document.said = lab.refusal;
        return;
      }
      this.done = { draft: this.document.draft, file: text };
      this.leave();
    });

  /** Puts a world file that somebody brought on the sheet. */
  async bring(brought: File | undefined): Promise<void> {
    if (!brought) return;
    const { document, drawing, engine } = this;
    try {
      const draft = await engine.read(await brought.text(), brought.name);
      document.replace(draft, words.said.over(draft.name));
      drawing.fit();
    } catch (error) {
      document.said = words.refused(error instanceof Error ? error.message : String(error));
    }
  }

  leave = (): void => {
    this.keep();
    this.lab.editing.leave();
  };

  /** Does something with the building's file; leads to the first fault where there is one. */
  private async whenSound(use: (checked: Checked) => Promise<void>): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    const { document, drawing, engine } = this;
    const { draft } = document;
    try {
      const checked = await engine.check(draft);
      const [first] = checked.faults;
      if (first) {
        drawing.show(first.thing);
        document.said = words.first;
      } else {
        await use(checked);
      }
    } catch {
      engine.stopped = true;
    }
    this.busy = false;
  }
}

/** Lays out what the editor was opened for. */
export async function layOut(lab: Lab, engine: Engine): Promise<Work> {
  const { file, kept, goesOn } = lab.editing.beginning ?? { file: undefined, kept: undefined, goesOn: false };
  if (kept && goesOn) {
    // Another version of the page may have kept what this one does not understand.
    await engine.check(kept.present);
    return new Work(lab, engine, kept);
  }
  const present = file === undefined ? await engine.blank(words.newName) : await engine.read(file, words.building);
  const past = kept ? [...kept.past, kept.present] : [];
  const tool = file === undefined ? 'wall' : 'select';
  const unfinished = kept !== undefined;
  const work = new Work(lab, engine, { past, present, future: [], pending: [], tool, done: file, unfinished });
  work.document.said = kept ? words.said.over(present.name) : words.said.opened(present.name);
  return work;
}
