import { Laboratory, type Status } from '../wasm/cogmap_wasm';
import { GENERATED, type Brought, type Choice } from './protocol';
import { textOf } from './worlds';

/** What of a run the page could have chosen itself. */
export function chosen(building: string | undefined, { robot, seed, memories, foreign }: Status): Partial<Choice> {
  const mappers = memories.map(({ mapper }) => mapper);
  if (building === undefined || foreign || robot === undefined) return { mappers };
  const [world = building, number] = building.split(':');
  return { world, robot, seed, mappers, ...(number === undefined ? {} : { building: Number(number) }) };
}

/** A run of a choice, `views` views on its way. */
export async function begun(choice: Choice, views: number): Promise<Laboratory> {
  const { robot, mappers, seed } = choice;
  const { file, text } = await building(choice);
  const laboratory = new Laboratory({ world: text, file: `${file}.world.json`, robot, mappers, seed });
  for (let view = 0; view < views; view += 1) laboratory.advance_to_next_view();
  return laboratory;
}

/** A run of what somebody brought: one file, or two that belong together. */
export function opened({ robot, mappers, seed }: Choice, file: Brought, other: Brought | undefined): Laboratory {
  const { name, bytes, resolution } = file;
  const scale = resolution === undefined ? {} : { resolution };
  const beside = other ? { beside: other.name } : {};
  return Laboratory.open({ name, robot, mappers, seed, ...scale, ...beside }, bytes, other?.bytes);
}

/** The building of a choice: one that comes with the page, or one that its number makes. */
async function building({ world, building }: Choice): Promise<{ file: string; text: string }> {
  if (world === GENERATED) return { file: `${GENERATED}-${building}`, text: `${GENERATED}:${building}` };
  const text = await textOf(world);
  if (text === undefined) throw new Error(`There is no world called ${world}.`);
  return { file: world, text };
}
