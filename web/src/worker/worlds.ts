const files = import.meta.glob<string>('../../../worlds/*.world.json', {
  query: '?raw',
  import: 'default',
  eager: true,
});

/** A building that comes with the page. */
export interface BundledWorld {
  /** The file's name without its extension. */
  file: string;
  /** What people call it. */
  name: string;
  /** The world file as it was written. */
  text: string;
}

/** The buildings that come with the page, by file name. */
export const worlds: BundledWorld[] = Object.entries(files).map(([path, text]) => ({
  file: path.replace(/^.*\//, '').replace(/\.world\.json$/, ''),
  name: (JSON.parse(text) as { name: string }).name,
  text,
}));
