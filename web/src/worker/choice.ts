import type { Status } from '../wasm/cogmap_wasm';
import { GENERATED, type Choice } from './protocol';
import { worlds, type BundledWorld } from './worlds';

/** What of a run the page could have chosen itself. */
export function chosen(building: string | undefined, { robot, seed, memories, foreign }: Status): Partial<Choice> {
  const mappers = memories.map(({ mapper }) => mapper);
  if (building === undefined || foreign || robot === undefined) return { mappers };
  const [world = building, number] = building.split(':');
  return { world, robot, seed, mappers, ...(number === undefined ? {} : { building: Number(number) }) };
}

/** The building of a choice: one that comes with the page, or one that its number makes. */
export function building({ world, building }: Choice): Pick<BundledWorld, 'file' | 'text'> {
  if (world === GENERATED) return { file: `${GENERATED}-${building}`, text: `${GENERATED}:${building}` };
  const bundled = worlds.find(({ file }) => file === world);
  if (!bundled) throw new Error(`There is no world called ${world}.`);
  return bundled;
}
