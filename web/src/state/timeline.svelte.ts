import type { Landmark } from '../wasm/cogmap_wasm';

/** What stands on the timeline. */
export class Timeline {
  /** What it marks, moment by moment. */
  marks = $state.raw<Landmark[][]>([]);

  /** Takes in the marks; they stay as they are where nothing changed, so that the focus does. */
  hear(marks: Landmark[]): void {
    if (marks.length !== this.marks.flat().length || marks.at(-1)?.position !== this.marks.at(-1)?.[0]?.position) {
      this.marks = byMoment(marks);
    }
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
