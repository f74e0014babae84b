import type { Alteration, Objection, Tool } from '../wasm/cogmap_wasm';

/** What can be done to a building, in the order of the palette. */
export const TOOLS: Tool[] = ['door', 'drop', 'remove', 'carry', 'person', 'noise'];

/** What a person changes in the building while the robot is in it. */
export class Changing {
  /** Whether the palette is open: a click in the world is then its tool's. */
  open = $state(false);
  tool = $state<Tool>('door');
  /** Why what was wanted last was not done. */
  objection = $state.raw<Objection>();

  /** `alter` changes something, and answers what speaks against it. */
  constructor(private readonly alter: (alteration: Alteration) => Promise<Objection | undefined>) {}

  toggle = (): void => {
    this.objection = undefined;
    this.open = !this.open;
  };

  choose(tool: Tool): void {
    this.objection = undefined;
    this.tool = tool;
  }

  /** Uses the tool at a point of the view of the world. */
  point(x: number, y: number): void {
    if (this.tool === 'noise') return;
    void this.change({ kind: 'at', tool: this.tool, x, y });
  }

  async change(alteration: Alteration): Promise<void> {
    this.objection = undefined;
    this.objection = await this.alter(alteration);
  }
}
