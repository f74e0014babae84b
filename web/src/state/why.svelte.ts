import type { Explanation, StageReport } from '../wasm/cogmap_wasm';
import type { View } from '../worker/protocol';

/** What the panel asks of the laboratory. */
export interface Explainer {
  /** Takes the latest step of a memory apart and points one of its stages out; without a memory, no longer. */
  explain(view: View | undefined, stage?: StageReport['kind']): Promise<void>;
  /** Goes to the view before or after. */
  toView(by: -1 | 1): Promise<void>;
  /** Stops time for the answer, and makes room for it. */
  opening(): void;
}

/** The step that is taken apart, and how far one has walked through it. */
export class Why {
  /** The memory that it is about. */
  view = $state<View>();
  told = $state.raw<Explanation>();
  at = $state(0);
  /** Which end of the next step to begin with, once it is told. */
  private arriving: 'first' | 'last' | undefined;

  constructor(private readonly explainer: Explainer) {}

  /** Asks why a memory is as it is; asked again, goes on. */
  ask(view: View): void {
    if (this.view === view) return this.close();
    this.explainer.opening();
    this.view = view;
    this.arriving = 'first';
    this.tell(undefined);
  }

  close(): void {
    this.view = undefined;
    this.told = undefined;
    void this.explainer.explain(undefined);
  }

  go(index: number): void {
    this.at = index;
    this.tell(this.told?.stages[index]?.kind);
  }

  /** The next stage; behind the last, the first of the next view. */
  on(): void {
    if (!this.told) return;
    if (this.at + 1 < this.told.stages.length) this.go(this.at + 1);
    else this.leave('first', 1);
  }

  /** The stage before; before the first, the last of the view before. */
  back(): void {
    if (this.at > 0) this.go(this.at - 1);
    else if (this.told && this.told.step > 0) this.leave('last', -1);
  }

  /** Takes in what the laboratory tells; another step shows the same stage again, if it has one. */
  hear(told: Explanation | undefined): void {
    if (!this.view || !told) {
      this.told = undefined;
      return;
    }
    const before = this.told;
    const kind = before?.stages[this.at]?.kind;
    this.told = told;
    // What was on its way of a step that was left meanwhile is no arrival.
    if (before && before.step === told.step && before.mapper === told.mapper) {
      this.at = Math.min(this.at, told.stages.length - 1);
      return;
    }
    if (this.arriving === 'first') this.go(0);
    else if (this.arriving === 'last') this.go(told.stages.length - 1);
    else this.go(Math.max(0, told.stages.findIndex((stage) => stage.kind === kind)));
    this.arriving = undefined;
  }

  private leave(arriving: 'first' | 'last', by: -1 | 1): void {
    this.arriving = undefined;
    const before = this.told?.step;
    void this.explainer.toView(by).then(() => {
      if (this.told?.step === before) this.arriving = arriving;
      else this.go(arriving === 'first' ? 0 : (this.told?.stages.length ?? 1) - 1);
    });
  }

  private tell(stage: StageReport['kind'] | undefined): void {
    void this.explainer.explain(this.view, stage);
  }
}
