import { Shelf, type Kept } from './shelf';

/** A run as it is kept. */
export interface KeptRun extends Kept {
  situation: string;
  /** What was driven through or mapped, for people. */
  name: string;
  /** Seconds of the run at the moment that was shown. */
  time: number;
}

/** Where runs are kept. */
export const runShelf = (): Shelf<KeptRun> => new Shelf('cogmap', 'runs', isRun);

function isRun(kept: unknown): kept is KeptRun {
  if (typeof kept !== 'object' || kept === null) return false;
  const { situation, name, time, when } = kept as Partial<KeptRun>;
  return [situation, name].every((it) => typeof it === 'string') && [time, when].every(Number.isFinite);
}
