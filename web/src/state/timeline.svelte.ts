import type { Happening, Landmark, Status } from '../wasm/cogmap_wasm';

/** Seconds of the run for which a word about something stands. */
export const STANDING = 8;
/** What is done to the building or the robot, and does not happen in a mind. */
const DONE: Happening['kind'][] = ['world_changed', 'kidnapped'];

/** What stands on the timeline. */
export class Timeline {
  /** What it marks, moment by moment. */
  marks = $state.raw<Landmark[][]>([]);

  /** Takes in the marks; they stay as they are where nothing changed, so that the focus does. */
  hear(marks: Landmark[]): void {
    if (JSON.stringify(marks) !== JSON.stringify(this.marks.flat())) this.marks = byMoment(marks);
  }

  /** What was done to the building or the robot last, if that was not long ago. */
  done({ position, time }: Status): Happening | undefined {
    const last = this.marks.flat().findLast((mark) => mark.position <= position && DONE.includes(mark.what.kind));
    return last && time - last.t <= STANDING ? last.what : undefined;
  }

  /** The position of the next mark, or of the one before. */
  mark(by: -1 | 1, here: number): number | undefined {
    const moments = this.marks.map(([mark]) => mark?.position ?? 0);
    return by > 0 ? moments.find((position) => position > here) : moments.findLast((position) => position < here);
  }
}

/** What happened at the same moment together. */
function byMoment(marks: Landmark[]): Landmark[][] {
  const moments: Landmark[][] = [];
  for (const mark of marks) {
    const last = moments.at(-1);
    if (last?.[0]?.position === mark.position) last.push(mark);
    else moments.push([mark]);
  }
  return moments;
}
