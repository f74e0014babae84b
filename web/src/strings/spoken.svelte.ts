import { en } from './en';
import { locale } from './locale.svelte';
import type { Worded } from './worded';

/** A catalogue: what the English one holds, in any words. */
export type Strings = Worded<typeof en>;

/** The languages of the page, each by its own name. */
export const LANGUAGES = { en: 'English', de: 'Deutsch', es: 'Español' } as const;

export type Language = keyof typeof LANGUAGES;

/** Catalogues that are loaded when somebody wants them. */
const CATALOGUES: Record<Exclude<Language, 'en'>, () => Promise<Strings>> = {
  de: async () => (await import('./de')).de,
  es: async () => (await import('./es')).es,
};

/** The language of what stands in files, and of what is wrong with them. */
export const ENGINE_LANGUAGE = 'en';

const KEY = 'cogmap-language';
let spoken = $state.raw<Strings>(en);

/** Every word on the page, in the language that is spoken. Nothing outside this folder holds text for people. */
export const strings: Strings = new Proxy<Strings>(en, { get: (_, key) => Reflect.get(spoken, key) });

/** Which language is spoken: what somebody chose, what the address asks for, or what the browser prefers. */
export const language = {
  get current(): Language {
    return known(locale.tag) ?? 'en';
  },

  /** Speaks the language to begin with. */
  async begin(asked: string | null): Promise<void> {
    const wanted = [asked, remembered(), ...navigator.languages].map(known).find(Boolean);
    await speak(wanted ?? 'en');
  },

  async choose(chosen: Language): Promise<void> {
    await speak(chosen);
    try {
      localStorage.setItem(KEY, chosen);
    } catch {
      // A browser that keeps nothing forgets the choice with the tab.
    }
  },
};

async function speak(wanted: Language): Promise<void> {
  try {
    spoken = wanted === 'en' ? en : await CATALOGUES[wanted]();
    locale.tag = wanted;
  } catch {
    // A catalogue that does not come leaves the language as it is.
  }
}

/** The language that a tag such as `de-AT` asks for. */
function known(tag: string | null | undefined): Language | undefined {
  const [primary = ''] = (tag ?? '').toLowerCase().split('-');
  return Object.keys(LANGUAGES).find((name): name is Language => name === primary);
}

function remembered(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
