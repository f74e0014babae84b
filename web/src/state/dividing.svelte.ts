const KEY = 'cogmap-divider';
/** The least share of the room that a view has which is not folded away. */
const LEAST = 0.15;
/** Below this share a view is folded away. */
const FOLD = LEAST / 2;
/** From so many rem on views stand beside each other, and from so many on three of them. */
const [BESIDE, THREE] = [44, 83];

/** Which side of the divider is folded away. */
export type Folded = 'first' | 'others' | undefined;

/** How views stand on the page: the first, the divider, the others. */
export interface Arrangement {
  /** Whether the first stands above the others, not beside them. */
  stacked: boolean;
  /** Of the others. */
  columns: number;
  rows: number;
  /** Under which name the divider's place is kept. */
  key: string;
  /** The first view's share of the room as long as nobody moves the divider: as much as each of the others. */
  share: number;
}

/** The arrangement of so many views where there is room of so many rem. */
export function arrangement(views: number, room: number): Arrangement {
  const others = views - 1;
  const stacked = room < BESIDE;
  const inTwo = others > 2 || (others === 2 && (stacked || room >= THREE));
  const columns = inTwo ? 2 : 1;
  const rows = Math.ceil(others / columns);
  const lines = stacked ? rows : columns;
  return { stacked, columns, rows, key: `${stacked ? 'above' : 'beside'}-${lines}`, share: 1 / (1 + lines) };
}

/** Where the divider between the first view and the others stands; the browser remembers it. */
export class Dividing {
  private shares = $state.raw<Record<string, number>>({});
  private side = $state<Folded>();

  constructor() {
    try {
      const { shares, folded } = JSON.parse(localStorage.getItem(KEY) ?? '{}') as { shares?: object; folded?: unknown };
      const kept = Object.entries(shares ?? {}).filter(([, share]) => share >= LEAST && share <= 1 - LEAST);
      this.shares = Object.fromEntries(kept);
      if (folded === 'first' || folded === 'others') this.side = folded;
    } catch {
      // Whatever else stands there is as good as nothing.
    }
  }

  get folded(): Folded {
    return this.side;
  }

  /** The first view's share of the room, from 0 to 1. */
  share(at: Arrangement): number {
    return this.side === 'first' ? 0 : this.side === 'others' ? 1 : (this.shares[at.key] ?? at.share);
  }

  /** Gives the first view a share of the room; one that is left too little is folded away. */
  move(at: Arrangement, share: number): void {
    this.side = share < FOLD ? 'first' : share > 1 - FOLD ? 'others' : undefined;
    if (!this.side) this.shares = { ...this.shares, [at.key]: Math.min(Math.max(share, LEAST), 1 - LEAST) };
    this.keep();
  }

  /** Moves it by a share; what was folded away comes back. */
  step(at: Arrangement, by: number): void {
    const most = 1 - LEAST;
    const from = this.share(at);
    if ((from === 0 && by < 0) || (from === 1 && by > 0)) return;
    this.move(at, Math.min(Math.max(from + by, LEAST), most));
  }

  fold(side: Folded): void {
    this.side = side;
    this.keep();
  }

  /** Gives all views the same share. */
  reset(at: Arrangement): void {
    this.side = undefined;
    this.shares = Object.fromEntries(Object.entries(this.shares).filter(([key]) => key !== at.key));
    this.keep();
  }

  private keep(): void {
    try {
      localStorage.setItem(KEY, JSON.stringify({ shares: this.shares, folded: this.side }));
    } catch {
      // A browser that keeps nothing forgets it with the tab.
    }
  }
}
