import { editing as words } from '../strings/editing';
import type { Draft, Thing } from '../wasm/cogmap_wasm';
import { History, type Edits } from './history.svelte';
import { freeName, hasName, moved, nth } from './things';

/** A copy lies so far beside what it is a copy of, metres. */
const BESIDE: [number, number] = [0.5, -0.5];

/** The building that is drawn: its edits, what of it is selected, and what happened last, in words. */
export class Document {
  selected = $state<number>();
  /** Which point of the selected thing is pointed out. */
  marked = $state<number>();
  /** What happened last, for whoever hears the page. */
  said = $state('');
  /** A thing as it is while it is being moved. */
  preview = $state.raw<{ index: number; thing: Thing }>();
  private readonly history: History;

  constructor(edits: Edits) {
    this.history = new History(edits);
  }

  /** The building as it is. */
  get draft(): Draft {
    return this.history.present;
  }

  get edits(): Edits {
    return this.history.all;
  }

  get canUndo(): boolean {
    return this.history.canUndo;
  }

  get canRedo(): boolean {
    return this.history.canRedo;
  }

  /** The building as it is seen: with what is just being moved. */
  readonly shown = $derived.by(() => {
    const { preview, draft } = this;
    return preview ? { ...draft, things: draft.things.with(preview.index, preview.thing) } : draft;
  });

  /** The selected thing as it is seen. */
  readonly thing = $derived(this.selected === undefined ? undefined : this.shown.things[this.selected]);

  /** What one of the things is called. */
  called(index: number, draft = this.draft): string {
    const thing = draft.things[index];
    return thing ? words.called(thing, nth(draft, index)) : '';
  }

  select(index: number | undefined): void {
    this.selected = index;
    if (index !== undefined) this.said = words.said.selected(this.called(index));
  }

  /** Puts another building in the place of this one; that can be undone like all else. */
  replace(draft: Draft, said: string): void {
    this.commit(draft, said);
    this.selected = undefined;
  }

  /** Changes name or description. */
  describe(change: Partial<Pick<Draft, 'name' | 'description'>>): void {
    this.commit({ ...this.draft, ...change }, words.said.changed(words.building));
  }

  add(thing: Thing, said: string): void {
    const { things } = this.draft;
    this.commit({ ...this.draft, things: [...things, thing] }, said);
    this.selected = things.length;
  }

  /** Puts another thing in the place of one. */
  change(index: number, thing: Thing, said?: string): void {
    if (JSON.stringify(this.draft.things[index]) === JSON.stringify(thing)) return;
    const draft = { ...this.draft, things: this.draft.things.with(index, thing) };
    this.commit(draft, said ?? words.said.changed(this.called(index, draft)));
  }

  remove(index = this.selected): void {
    if (index === undefined) return;
    if (this.draft.things[index]?.kind === 'start') {
      this.said = words.said.keepsStart;
      return;
    }
    const called = this.called(index);
    const things = this.draft.things.toSpliced(index, 1);
    this.commit({ ...this.draft, things }, words.said.removed(called));
    this.selected = undefined;
  }

  duplicate(index = this.selected): void {
    const thing = index === undefined ? undefined : this.draft.things[index];
    if (!thing || thing.kind === 'start') return;
    const copy = moved(thing, BESIDE);
    if (hasName(copy)) copy.name = freeName(this.draft, copy.kind, words.copyOf(copy.name));
    this.add(copy, '');
    this.said = words.said.duplicated(this.called(this.selected ?? 0));
  }

  undo(): void {
    this.said = this.history.undo() ? words.said.undone : words.said.nothingToUndo;
    this.settle();
  }

  redo(): void {
    this.said = this.history.redo() ? words.said.redone : words.said.nothingToRedo;
    this.settle();
  }

  private commit(draft: Draft, said: string): void {
    this.preview = undefined;
    this.history.commit(draft);
    this.said = said;
  }

  /** What was selected may be no more. */
  private settle(): void {
    this.preview = undefined;
    if (this.selected !== undefined && this.selected >= this.draft.things.length) this.selected = undefined;
  }
}
