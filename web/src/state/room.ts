import { MediaQuery } from 'svelte/reactivity';

/** Whether the page is wide enough for words on all buttons of its top. */
export const wide = new MediaQuery('width >= 75rem');

/** Whether there is room for words beside the set-up: on a wide page, and on a narrow one, where it is folded up. */
export const wordy = new MediaQuery('(width >= 75rem) or (width < 62rem)');

/** Whether panels and cards are sheets over the page, as on a phone. */
export const phone = new MediaQuery('width < 48rem');

/** Tells how large an element is, pixels, whenever that changes; it waits for the browser to lay the page out. */
export const measured =
  (tell: (width: number, height: number) => void) =>
  (node: HTMLElement): (() => void) => {
    const observer = new ResizeObserver(() => tell(node.clientWidth, node.clientHeight));
    observer.observe(node);
    return () => observer.disconnect();
  };
