import type { HomingStatus, Status } from '../wasm/cogmap_wasm';
import type { View } from '../worker/protocol';

/** The views that memories can have. */
const MEMORIES: View[] = ['first', 'second', 'third', 'fourth'];

/** How a way home ended by which memory. */
export type Outcome = Pick<HomingStatus, 'by' | 'distance'> & { ended: 'home' | 'stuck' };

/** Which of several memories of one drive is to be trusted: the question, and what came of each answer. */
export class Trusting {
  /** Whether the question is on the page. */
  open = $state(true);
  /** How the ways home from one and the same place ended. */
  outcomes = $state.raw<Outcome[]>([]);
  /** The mappers as their memories stand on the page: one that is trusted does not change its place. */
  private order: string[] = [];

  /** `trust` sends the robot home by one of the memories. */
  constructor(readonly trust: (mapper: string) => void) {}

  dismiss = (): void => void (this.open = false);

  hear({ homing, memories }: Status): void {
    const names = memories.map(({ mapper }) => mapper);
    if (names.length !== this.order.length || !names.every((name) => this.order.includes(name))) this.order = names;
    if (!homing) this.outcomes = [];
    if (homing?.ended !== 'home' && homing?.ended !== 'stuck') return;
    const { by, distance, ended } = homing;
    this.outcomes = [...this.outcomes.filter((outcome) => outcome.by !== by), { by, distance, ended }];
  }

  /** The views of the memories; before a run begins, of as many as it will have, or one. */
  views(status: Status | undefined, awaited: number): View[] {
    if (!status) return MEMORIES.slice(0, Math.max(awaited, 1));
    return this.arranged(status.memories).map(({ view }) => view);
  }

  /** The memories in the order in which they stand on the page. */
  arranged<Of extends { mapper: string }>(memories: Of[]): Of[] {
    return memories.toSorted((one, other) => this.order.indexOf(one.mapper) - this.order.indexOf(other.mapper));
  }
}
