import { hold } from '../worker/lifeline';

/** How long a page that is just being left may take to let go of what is its own, milliseconds. */
const PARTING = 500;

/** The name of this visit to the page: other windows, and the same one after a reload, have others. */
export const visit = `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;

let staying = false;

/** Lets other windows know that this visit lasts. */
export function stay(): void {
  if (!staying) void hold(lockOf(visit));
  staying = true;
}

/** Whether a visit is over; a browser without locks cannot tell, and takes it to be. */
export async function isOver(visit: string): Promise<boolean> {
  const signal = AbortSignal.timeout(PARTING);
  return navigator.locks?.request(lockOf(visit), { signal }, () => true).catch(() => false) ?? true;
}

const lockOf = (visit: string): string => `cogmap-visit-${visit}`;
