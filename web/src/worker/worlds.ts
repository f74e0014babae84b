import { WORLD_GROUPS, type WorldGroup } from './protocol';

const names = import.meta.glob<string>('../../../worlds/*.world.json', { import: 'name', eager: true });
const descriptions = import.meta.glob<string>('../../../worlds/*.world.json', { import: 'description', eager: true });
const texts = import.meta.glob<string>('../../../worlds/*.world.json', { query: '?raw', import: 'default' });

/** What there is, in the order in which it is offered. */
const GROUPS = {
  everyday: ['office', 'small-office', 'long-office'],
  home: ['around-a-corner', 'shortcut', 'two-shortcuts', 'u-trap', 'box-course'],
  thesis: ['environment-a', 'environment-b', 'tour'],
  schematic: ['long-corridor', 'narrow-passage', 'no-passage'],
} as const;

/** A building that comes with the page. */
export interface BundledWorld {
  /** The file's name without its extension. */
  file: string;
  /** What people call it. */
  name: string;
  /** Among which it is offered. */
  group: WorldGroup;
  /** What is worth knowing about it, a sentence or two. */
  description: string;
}

/** The buildings that come with the page, in the order in which they are offered. */
export const worlds: BundledWorld[] = Object.entries(names)
  .map(([path, name]) => {
    const file = fileOf(path);
    return { file, name, group: groupOf(file), description: descriptions[path] ?? '' };
  })
  .sort((one, other) => rank(one) - rank(other) || one.name.localeCompare(other.name));

/** A building's world file as it was written, if the page has such a building; it comes when it is needed. */
export async function textOf(file: string): Promise<string | undefined> {
  const [, load] = Object.entries(texts).find(([path]) => fileOf(path) === file) ?? [];
  return load?.();
}

/** All of them. */
export function everyText(): Promise<{ file: string; text: string }[]> {
  return Promise.all(Object.entries(texts).map(async ([path, load]) => ({ file: fileOf(path), text: await load() })));
}

function fileOf(path: string): string {
  return path.replace(/^.*\//, '').replace(/\.world\.json$/, '');
}

/** A world that is in none of the groups is one of every day. */
function groupOf(file: string): WorldGroup {
  const found = WORLD_GROUPS.find((group) => (GROUPS[group] as readonly string[]).includes(file));
  return found ?? 'everyday';
}

function rank({ file }: BundledWorld): number {
  const order: readonly string[] = Object.values(GROUPS).flat();
  const rank = order.indexOf(file);
  return rank < 0 ? order.length : rank;
}
