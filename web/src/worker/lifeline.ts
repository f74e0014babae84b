/** Holds on to a name for as long as this worker lives, however it ends. */
export async function hold(name: string): Promise<void> {
  await new Promise<void>((held) => {
    // Without secure context or storage there are no locks; then the end of a worker passes unnoticed.
    const request = navigator.locks?.request(name, () => {
      held();
      return new Promise<never>(() => undefined);
    });
    if (request) request.catch(() => held());
    else held();
  });
}

/** Calls `ended` once nobody holds the name any more. */
export function whenReleased(name: string, signal: AbortSignal, ended: () => void): void {
  navigator.locks?.request(name, { signal }, ended).catch(() => undefined);
}
