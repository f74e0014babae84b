import { strings } from '../strings';
import { GENERATED, type Choice, type Offer } from '../worker/protocol';

/**
 * What the address asks for: `?embed`, `?world=NAME`, `&number=N` (of a generated building), `&seed=N`,
 * `&mappers=NAME,NAME`, `&lang=de`.
 * `?lesson=` is reserved: nothing reads it yet, and nothing complains about it.
 */
export class Address {
  private readonly query: URLSearchParams;

  constructor(address: Pick<Location, 'search'>) {
    this.query = new URLSearchParams(address.search);
  }

  /** Whether the page stands in a frame of another one. */
  get embed(): boolean {
    return this.query.has('embed');
  }

  /** The language that is asked for. */
  get language(): string | null {
    return this.query.get('lang');
  }

  /** The choice that is asked for, and what there is to say about the parts that cannot be had. */
  choice({ worlds, choices }: Offer): { asked: Partial<Choice>; complaints: string[] } {
    const asked: Partial<Choice> = {};
    const complaints: string[] = [];
    const world = this.query.get('world');
    if (world !== null) {
      const known = [...worlds.map(({ file }) => file), GENERATED];
      if (known.includes(world)) asked.world = world;
      else complaints.push(strings.address.world(world, known));
    }
    for (const [key, part] of [['number', 'building'], ['seed', 'seed']] as const) {
      const written = this.query.get(key);
      if (written === null) continue;
      const number = /^\d+$/.test(written) ? Number(written) : NaN;
      if (Number.isSafeInteger(number)) asked[part] = number;
      else complaints.push(strings.address.number(key, written));
    }
    const mappers = [...new Set(this.query.get('mappers')?.split(',') ?? [])];
    const unknown = mappers.filter((name) => !choices.mappers.includes(name));
    if (unknown.length > 0) complaints.push(strings.address.mappers(unknown, choices.mappers));
    else if (mappers.length > 0) asked.mappers = mappers;
    return { asked, complaints };
  }
}

/**
 * Where the whole page is, without what the address asks for. Where the newest version is published at the
 * root, it names the folder that this version will stay in: a link keeps the engine that made it.
 */
export function wholePage(): string {
  const folder = document.querySelector<HTMLMetaElement>('meta[name="cogmap-stays-in"]')?.content ?? '';
  return new URL(folder, location.origin + location.pathname).href;
}
