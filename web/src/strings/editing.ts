import { editing as en } from './en/editing';
import { language } from './spoken.svelte';
import type { Worded } from './worded';

type Editing = Worded<typeof en>;

let spoken: Editing = en;

/** Every word of the editor of buildings, which comes with it. */
export const editing: Editing = new Proxy<Editing>(en, { get: (_, key) => Reflect.get(spoken, key) });

/** Lets the editor speak as the page does; to be awaited before it opens. */
export async function speakWhileEditing(): Promise<void> {
  const catalogues = {
    en: () => Promise.resolve(en),
    de: async (): Promise<Editing> => (await import('./de/editing')).editing,
    es: async (): Promise<Editing> => (await import('./es/editing')).editing,
  };
  spoken = await catalogues[language.current]();
}
