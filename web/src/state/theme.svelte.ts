import type { Look } from '../wasm/cogmap_wasm';

const KEY = 'cogmap-theme';

/** Light or dark: as the system has it until somebody chooses. */
export class Theme {
  private readonly system = matchMedia('(prefers-color-scheme: dark)');
  private chosen = $state(remembered());
  private systemDark = $state(this.system.matches);

  readonly current = $derived<Look>(this.chosen ?? (this.systemDark ? 'dark' : 'light'));

  constructor() {
    this.system.addEventListener('change', ({ matches }) => (this.systemDark = matches));
  }

  toggle = (): void => {
    this.chosen = this.current === 'dark' ? 'light' : 'dark';
    try {
      localStorage.setItem(KEY, this.chosen);
    } catch {
      // A browser that keeps nothing forgets the choice with the tab.
    }
  };
}

function remembered(): Look | undefined {
  try {
    const kept = localStorage.getItem(KEY);
    return kept === 'light' || kept === 'dark' ? kept : undefined;
  } catch {
    return undefined;
  }
}
