import type { Choices, Explanation, Landmark, Plots, Remembered, Schematic, Status, Told, Walk } from '../wasm/cogmap_wasm';

export type { Layers, View } from '../wasm/cogmap_wasm';

/** How fast time passes: a factor of real time, or as fast as the machine goes. */
export type Pace = number | 'full';

/** The world that is no file: an office floor made from a number. */
export const GENERATED = 'generated';

/** What the buildings that come with the page are for. */
export const WORLD_GROUPS = ['everyday', 'home', 'thesis', 'schematic'] as const;
export type WorldGroup = (typeof WORLD_GROUPS)[number];

/** A run in a building that comes with the page, or in one made from a number. */
export interface Choice {
  world: string;
  /** Which floor, where the world is `GENERATED`. */
  building: number;
  robot: string;
  /** Each shows its memory; the first tells the story. */
  mappers: string[];
  seed: number;
}

/** What legends say in another language, by what they say in English. */
export type LegendWords = Readonly<Record<string, string>>;

/** A file that somebody brought. */
export interface Brought {
  name: string;
  bytes: Uint8Array;
  /** Metres a pixel, of a floor plan that does not say it. */
  resolution?: number;
}

/** What is to be kept of a run at a moment. */
export interface Moment {
  situation: string;
  /** What is driven through or mapped, for people. */
  name: string;
  /** Seconds of the run. */
  time: number;
  /** Whether it cannot be taken up again without the log that was brought. */
  fromLog: boolean;
}

/** A run that is to be taken up again. */
export interface KeptSituation {
  /** Where it came from, for messages. */
  name: string;
  situation: string;
  /** The log that it was made from. */
  log?: File;
}

/** The same with the log's content. */
export type Resumable = Omit<KeptSituation, 'log'> & { log?: Brought };

/** What the page learns of a run that was taken up again. */
export interface Resumed {
  /** What of it the page could have chosen itself. */
  choice: Partial<Choice>;
  warnings: string[];
}

/** What the page learns while the laboratory works. */
export interface Notice {
  status: Status;
  playing: boolean;
  /** What the timeline marks. */
  marks: Landmark[];
  /** The step that is taken apart, where one is. */
  why: Explanation | undefined;
  /** What is known about what is pointed at, and the number of the question that it answers. */
  pointed: { asked: number; told: Told | undefined };
  pace: Pace;
}

/** What of a memory is pointed at: what lies at a place of its view, a thing, or what a walk leads to. */
export type Target = { x: number; y: number; reach: number } | { thing: Remembered } | { walk: Walk };

/** What is plotted of a run. */
export interface Plotted {
  plots: Plots;
  /** The places of the memory that was asked for, if it has any. */
  schematic: Schematic | undefined;
}

/** What there is to choose from, and what is chosen at first. */
export interface Offer {
  choices: Choices;
  worlds: { file: string; name: string; group: WorldGroup; description: string }[];
}

/** What there is one file of for the whole run. */
export type FileKind = 'picture' | 'drawing' | 'session' | 'table' | 'everything';

/** A file that is ready to be saved. */
export interface Saved {
  name: string;
  blob: Blob;
}
