import type { PlacementKind, Place, RememberedKind, Whereabouts } from '../../wasm/cogmap_wasm';
import { count, moment, number } from '../words';

/** A direction seen from the robot. */
function direction(degrees: number): string {
  const turned = Math.round(Math.abs(degrees));
  if (turned < 5) return 'straight ahead';
  if (turned > 175) return 'straight behind';
  return `${turned}° ${degrees > 0 ? 'left' : 'right'}`;
}

/** The way to the moment in which a thing came to be. */
const to = (what: string) => (view: number, t: number) => `Go to view ${view} at ${moment(t)}, when it was ${what}`;

const titles: Record<RememberedKind, (number: number) => string> = {
  surface: (number) => `Surface ${number}`,
  exit: (number) => `Exit ${number}`,
  supposed: (number) => `Supposed exit ${number}`,
  asr: (number) => `Local space ${number}`,
};

const go: Record<RememberedKind, (view: number, t: number) => string> = {
  surface: to('first seen'),
  exit: to('found'),
  supposed: to('first seen'),
  asr: to('opened'),
};

const rules: Record<PlacementKind, string> = {
  first: 'the first view lays down the map’s frame',
  reference: 'a reference target places the view',
  weak_reference: 'a reference target, its place along its own line a guess',
  consensus: 'all recognised surfaces together place the view',
  partly_odometry: 'all recognised surfaces, and odometry along a direction that they leave open',
  transform: 'the movement, corrected until the views fit',
  odometry: 'what the wheels say, uncorrected',
};

const relative: Record<PlacementKind, (recognised: number) => string> = {
  first: () => 'nothing: the map begins with it',
  reference: () => 'the reference target',
  weak_reference: () => 'the reference target',
  consensus: (recognised) => count(recognised, 'recognised surface', 'recognised surfaces'),
  partly_odometry: (recognised) => `${count(recognised, 'recognised surface', 'recognised surfaces')} and odometry`,
  transform: () => 'the view before, by movement',
  odometry: () => 'the view before, by odometry',
};

/** What is told about the things that a memory holds. */
export const telling = {
  pointed: {
    walk: 'Walk through the memory: ← → older and newer, ↑ ↓ surfaces, exits and local spaces, Enter keeps the card',
    keep: 'Click to keep this card.',
    keepByKey: 'Enter keeps this card, Escape takes it away.',
    close: 'Close the card',
    titles,
    go,
    labels: {
      seen: 'First seen',
      last: 'Last seen',
      relative: 'Placed relative to',
      rule: 'By the rule',
      length: 'Length',
      belongs: 'Belongs to',
      width: 'Width',
      joins: 'Joins',
      made: 'Found',
      through: 'Gone through',
      from: 'Seen from',
      robot: 'The robot',
      opened: 'Opened',
      entered: 'Entered',
      area: 'Floor seen',
      surfaces: 'Surfaces',
      exits: 'Exits',
      loops: 'Loops closed',
      merged: 'Was also',
    },
    view: (view: number, t: number) => `view ${view}, ${moment(t)}`,
    once: 'only then',
    sightings: (views: number) => `in ${count(views, 'view', 'views')}`,
    relative,
    rules,
    metres: (length: string) => `${length}\u00a0m`,
    squareMetres: (area: string) => `${area}\u00a0m²`,
    through: (times: number, last: string) => (times <= 1 ? `once, ${last}` : `${times} times, last in ${last}`),
    looped: 'one, by going through',
    supposed: 'not yet: it was only seen',
    began: 'the robot came to be here',
    entrance: (exit: number) => `behind exit ${exit}`,
    entries: (times: number, last: string) => (times <= 1 ? `once, ${last}` : `${times} times, last in ${last}`),
    here: 'believes to be here',
    none: 'none',
  },

  text: {
    title: 'Text view',
    openHint: 'What the memory holds, in words and tables: where the robot believes to be, places, exits and surfaces',
    close: 'Close the text view',
    loading: 'Fetching the text view…',
    failed: 'The text view could not be fetched. Close it and try again.',
    waiting: 'Nothing has been seen yet.',
    whose: 'Memory of',
    whoseHint: 'Whose memory is told',
    lines: 'What the memory holds',
    chooseHint: 'Show its story in the drawing',
    robot: 'Where the robot believes to be',
    whereabouts: ({ asr, home, turned_deg }: Whereabouts) => [
      ...(asr === undefined ? [] : [`In local space ${asr}.`]),
      ...(home === undefined
        ? ['It does not know how home lies.']
        : home.distance < 0.05
          ? ['At home, where the run began.']
          : [`Home, where the run began, is ${number(home.distance, 1)} m away, ${direction(home.angle_deg)}.`]),
      Math.abs(turned_deg) < 0.5
        ? 'It looks as it did when the run began.'
        : `It has turned ${Math.round(Math.abs(turned_deg))}° to the ${turned_deg > 0 ? 'left' : 'right'} since then.`,
    ],
    asOf: (view: number, t: number) => `As of view ${view}, ${moment(t)}.`,
    behind: 'The robot has gone on since; the words wait while you are at a line.',
    update: 'Update',
    network: 'The network of places',
    noPlaces: (mapper: string) => `${mapper} does not know what a local space is.`,
    place: ({ current, surfaces }: Place, area: string) =>
      `${current ? 'the robot is here; ' : ''}${count(surfaces, 'surface', 'surfaces')}, ${area} m² of floor seen`,
    exitsOf: (asr: number) => `Exits of local space ${asr}`,
    supposed: 'Exits that were seen, not gone through',
    surfaces: (all: number) => `Surfaces: ${all}, nearest first`,
    surfacesOf: (asr: number | undefined, surfaces: number) =>
      `${asr === undefined ? 'Everywhere' : `In local space ${asr}`}: ${count(surfaces, 'surface', 'surfaces')}`,
    more: (shown: number, all: number) => `Show more (${shown} of ${all})`,
    columns: {
      exits: ['exit', 'to space', 'width', 'away', 'direction'],
      supposed: ['exit', 'width', 'away', 'direction'],
      surfaces: ['surface', 'length', 'away', 'direction'],
      age: 'age',
    },
    direction,
    age: (seconds: number) => (seconds < 99.5 ? `${Math.round(seconds)}\u00a0s` : `${Math.round(seconds / 60)}\u00a0min`),
  },
} as const;
