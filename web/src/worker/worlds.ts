const files = import.meta.glob<string>('../../../worlds/*.world.json', {
  query: '?raw',
  import: 'default',
  eager: true,
});

/** Everyday buildings first, then those for finding home, the long tours, then the schematic ones; others follow by name. */
const ORDER = [
  'office',
  'small-office',
  'around-a-corner',
  'shortcut',
  'two-shortcuts',
  'box-course',
  'u-trap',
  'long-office',
  'environment-a',
  'environment-b',
  'tour',
  'long-corridor',
  'narrow-passage',
  'no-passage',
];

/** A building that comes with the page. */
export interface BundledWorld {
  /** The file's name without its extension. */
  file: string;
  /** What people call it. */
  name: string;
  /** The world file as it was written. */
  text: string;
}

/** The buildings that come with the page, in the order in which they are offered. */
export const worlds: BundledWorld[] = Object.entries(files)
  .map(([path, text]) => ({
    file: path.replace(/^.*\//, '').replace(/\.world\.json$/, ''),
    name: (JSON.parse(text) as { name: string }).name,
    text,
  }))
  .sort((one, other) => rank(one) - rank(other) || one.name.localeCompare(other.name));

function rank({ file }: BundledWorld): number {
  const rank = ORDER.indexOf(file);
  return rank < 0 ? ORDER.length : rank;
}
