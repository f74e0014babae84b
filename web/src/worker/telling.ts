import type { Contents, Laboratory, Remembered, StageKind, Told } from '../wasm/cogmap_wasm';
import type { Player } from './player';
import type { Plotted, Target, View } from './protocol';

/** What the page asks about the run and its memories. */
export class Telling {
  /** The view in which something was pointed at last. */
  private view: View | undefined;

  constructor(private readonly player: Player) {}

  private get laboratory(): Laboratory | undefined {
    return this.player.laboratory;
  }

  /** Takes the latest step of a memory apart and points one of its stages out; without a memory, no longer. */
  explain(view: View | undefined, stage: StageKind | undefined): void {
    this.player.explained = view;
    this.laboratory?.point_out(view ?? 'world', stage);
    this.player.refresh();
  }

  /** What can be plotted of the run at hand and, for a memory, its places as a schematic. */
  plots(places: View | undefined): Plotted | undefined {
    return this.laboratory && { plots: this.laboratory.plots(), schematic: places && this.laboratory.schematic(places) };
  }

  /** What a memory holds, with at most so many surfaces of each local space. */
  contents(view: View, most: number): Contents | undefined {
    return this.laboratory?.contents(view, most);
  }

  /** Sets something of a memory off, or nothing any longer, and tells what is known about it. `asked` comes back with all that is told of it later. */
  point(asked: number, view: View, to: Target | undefined): Told | undefined {
    const { laboratory } = this;
    if (!laboratory) return undefined;
    const thing = to && found(laboratory, view, to);
    this.player.asked = asked;
    // Only what it was set off in and is now is painted anew, and of that only what changes all the time.
    if (laboratory.set_off(view, thing)) this.player.repaint(new Set([view, this.view ?? view]));
    this.view = view;
    return thing && laboratory.told();
  }
}

function found(laboratory: Laboratory, view: View, to: Target): Remembered | undefined {
  if ('thing' in to) return to.thing;
  if ('walk' in to) return laboratory.walk(view, laboratory.told()?.thing, to.walk);
  return laboratory.pick(view, to.x, to.y, to.reach);
}
