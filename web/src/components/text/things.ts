import { strings } from '../../strings';
import { number } from '../../strings/words';
import type { Bearing, Occasion, Place, Remembered, SupposedExit } from '../../wasm/cogmap_wasm';

/** What the lines of the text do with the things that they are about. */
export interface Things {
  /** Sets one off in the drawing; `replacing` what is kept there. */
  glance: (thing: Remembered, replacing: boolean) => void;
  /** Sets nothing off any longer. */
  leave: () => void;
  /** Shows the card of one in the drawing, to stay. */
  choose: (thing: Remembered) => void;
  /** Goes to where the run stands at a position. */
  go: (position: number) => void;
}

/** A thing in a table: when it came to be, and what else is said about it. */
export interface Row {
  thing: Remembered;
  born: Occasion;
  cells: string[];
}

/** The exits of a place. */
export function exitRows({ exits }: Place): Row[] {
  return exits.map(({ exit, to, width, lies, made }) => ({
    thing: { kind: 'exit', number: exit },
    born: made,
    cells: [String(to), metres(width), ...lying(lies)],
  }));
}

/** Exits that were only seen. */
export function supposedRows(supposed: SupposedExit[]): Row[] {
  return supposed.map(({ number, width, lies, seen }) => ({
    thing: { kind: 'supposed', number },
    born: seen,
    cells: [metres(width), ...lying(lies)],
  }));
}

/** The surfaces of a place that are nearest. */
export function surfaceRows({ nearest }: Place, most: number): Row[] {
  return nearest.slice(0, most).map(({ surface, length, lies, seen }) => ({
    thing: { kind: 'surface', number: surface },
    born: seen,
    cells: [metres(length), ...lying(lies)],
  }));
}

function lying({ distance, angle_deg }: Bearing): string[] {
  return [metres(distance), strings.text.direction(angle_deg)];
}

function metres(length: number): string {
  return strings.pointed.metres(number(length, 2));
}
