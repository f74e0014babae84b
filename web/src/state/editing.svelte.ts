import type { Remote } from 'comlink';
import { draftShelf, type KeptDraft } from '../keep/drafts';
import type { Shelf } from '../keep/shelf';
import { strings } from '../strings';
import type { Bench } from '../worker/bench';
import type { Lab } from './lab.svelte';

/** What the editor begins with. */
export interface Beginning {
  /** The world file that is to be edited; without one, an empty sheet or what was kept. */
  file: string | undefined;
  /** What was drawn before: gone on with, or found again by undoing. */
  kept: KeptDraft | undefined;
  /** Whether to go on with what was drawn before. */
  goesOn: boolean;
}

/** The way into the editor of buildings and back; the editor itself is loaded when somebody goes there. */
export class Editing {
  /** What the editor began with, while it is open. */
  beginning = $state.raw<Beginning>();
  /** What was drawn last. */
  private kept = $state.raw<KeptDraft>();
  private dismissed = $state(false);
  private readonly shelf: Shelf<KeptDraft> | undefined;
  /** A drawing that is offered to go on with. */
  readonly offer = $derived(this.kept?.unfinished && !this.beginning && !this.dismissed ? this.kept : undefined);

  /** `lasting`: whether the browser keeps what is drawn beyond this visit. */
  constructor(
    private readonly lab: Lab,
    private readonly bench: () => Remote<Bench>,
    lasting: boolean,
  ) {
    this.shelf = lasting ? draftShelf() : undefined;
  }

  get open(): boolean {
    return this.beginning !== undefined;
  }

  /** Looks for a drawing that was left behind, rather for one that holds what nothing else does. */
  async begin(): Promise<void> {
    const all = (await this.shelf?.leftBehind()) ?? [];
    const newest = all.find(({ unfinished }) => unfinished) ?? all[0];
    if (!newest || this.kept) return;
    const { visit, ...kept } = newest;
    this.kept = kept;
    this.shelf?.takeOver(visit);
  }

  /** Opens the building that the robot is in, as it is at this moment. */
  edit = async (): Promise<void> => {
    if (!this.lab.status) return;
    await this.bench().play(false);
    const file = await this.bench().worldFile();
    if (file === undefined) this.lab.refusal = strings.drafts.ofLog;
    else this.enter(file, file === this.kept?.done && !this.kept.unfinished);
  };

  /** Opens an empty sheet. */
  blank = (): void => this.enter(undefined, false);

  /** Goes on with what was drawn last. */
  goOn = (): void => this.enter(undefined, true);

  dismiss = (): void => {
    this.dismissed = true;
    this.kept = undefined;
    void this.shelf?.empty();
  };

  /** Keeps what is drawn. */
  keep(kept: KeptDraft): void {
    this.kept = kept;
    void this.shelf?.keep(kept);
  }

  /** Leaves the editor; what was drawn stays. */
  leave = (): void => {
    this.beginning = undefined;
  };

  private enter(file: string | undefined, goesOn: boolean): void {
    void this.bench().play(false);
    this.lab.changing.open = false;
    this.dismissed = false;
    const worthKeeping = goesOn || this.kept?.unfinished;
    this.beginning = { file, goesOn: goesOn && this.kept !== undefined, kept: worthKeeping ? this.kept : undefined };
  }
}
