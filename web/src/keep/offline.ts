/** So long somebody who has just come is left alone with the page, milliseconds. */
const AT_EASE = 2000;

/**
 * Keeps the page's own files, so that it opens without a network from the second visit on. All of them are fetched for
 * that, which can wait until the page has opened.
 */
export function keepOffline(): void {
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
  setTimeout(() => void navigator.serviceWorker.register('./sw.js'), AT_EASE);
}
