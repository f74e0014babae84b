/** Lets the browser do what waits, input above all, before the page goes on. */
export const turn = (): Promise<void> => new Promise((next) => setTimeout(next));

/** Lets the browser lay the page out, as it does before a frame. */
export const laidOut = (): Promise<void> => new Promise((next) => requestAnimationFrame(() => setTimeout(next)));
