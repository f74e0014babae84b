import { strings } from '../../strings';
import { number } from '../../strings/words';
import type { Schematic, SchematicPlace } from '../../wasm/cogmap_wasm';

/** A place on a sheet, pixels. */
export type Point = [number, number];

/** A line of the schematic: the exit on the tree between two places, or all others between them together. */
export interface Line {
  name: string;
  between: [number, number];
  /** As SVG has it. */
  path: string;
  /** Where the sign of the exit stands. */
  at: Point;
  /** Whether going through closed a loop. */
  looped: boolean;
  /** What is written at the sign. */
  says: string;
}

/** The lines of a schematic whose places stand there. */
export function linesOf({ exits, places }: Schematic, middle: (place: SchematicPlace) => Point): Line[] {
  const groups = new Map<string, typeof exits>();
  for (const exit of exits) {
    const name = `${Math.min(exit.from, exit.to)} ${Math.max(exit.from, exit.to)} ${exit.on_tree}`;
    groups.set(name, [...(groups.get(name) ?? []), exit]);
  }
  return [...groups].flatMap(([name, group]) => {
    const [first] = group;
    const [one, other] = [first?.from, first?.to].map((asr) => places.find((place) => place.asr === asr));
    if (!first || !one || !other) return [];
    const looped = group.some(({ closed_loop }) => closed_loop);
    const says = group.length === 1 ? number(first.width, 1) : strings.plots.times(group.length);
    return [{ name, between: [one.asr, other.asr], looped, says, ...lineOf(middle(one), middle(other), first.on_tree) }];
  });
}

/** The line from one place to another as an SVG path, and where the sign of its exit stands. */
function lineOf([x1, y1]: Point, [x2, y2]: Point, onTree: boolean): { path: string; at: Point } {
  const [x, y] = [(x1 + x2) / 2, (y1 + y2) / 2];
  const length = Math.hypot(x2 - x1, y2 - y1);
  // Both sides of an exit may have turned out to be one place.
  if (length === 0) return { path: `M${x1 - 8} ${y1} C${x1 - 26} ${y1 - 34} ${x1 + 26} ${y1 - 34} ${x1 + 8} ${y1}`, at: [x1, y1 - 25] };
  if (onTree) return { path: `M${x1} ${y1} C${x} ${y1} ${x} ${y2} ${x2} ${y2}`, at: [x, y] };
  // Beside what stands between the two.
  const aside = 18 + 0.22 * length;
  const at: Point = [x + (aside * Math.abs(y2 - y1)) / length, y + (aside * Math.abs(x2 - x1)) / length];
  return { path: `M${x1} ${y1} Q${2 * at[0] - x} ${2 * at[1] - y} ${x2} ${y2}`, at };
}
