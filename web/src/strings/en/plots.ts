import type { Schematic, SchematicPlace } from '../../wasm/cogmap_wasm';
import { count, moment, number } from '../words';

/** What is plotted of a run, and the places as a schematic. */
export const plots = {
  title: 'Plots',
  openHint: 'Wideness, errors and surfaces along the run, and the places as a schematic',
  close: 'Close the plots',
  loading: 'Fetching the plots…',
  failed: 'The plots could not be fetched. Close them and try again.',
  pages: 'What is plotted',
  curves: 'Along the run',
  places: 'Places',
  whose: 'Way and places by',
  whoseHint: 'Whose way and places are shown',
  waiting: 'Nothing has been seen yet.',
  moment,

  reader: 'Moment in the plots',
  exitsHint: 'A dot is an exit, its number the local space behind it.',
  readerHint: 'Click a moment to go there, or use arrow keys and Enter on the bar above.',
  now: 'now',
  at: (moment: string) => `at ${moment}`,
  /** The values at a moment in a sentence each. */
  spoken: (moment: string, wide: number | undefined, mappers: { mapper: string; view: number; off: [number, number] | undefined; surfaces: number }[]) =>
    [
      moment,
      ...(wide === undefined ? [] : [`${number(wide, 2)} metres wide`]),
      ...mappers.map(({ mapper, view, off, surfaces }) => {
        const wrong = off ? [`off by ${number(off[0], 2)} metres and ${number(off[1], 1)} degrees`] : [];
        return [`${mapper}: view ${view}`, ...wrong, count(surfaces, 'surface', 'surfaces')].join(', ');
      }),
    ].join('. '),
  values: 'Values at that moment',
  columns: { mapper: 'mapper', view: 'view', metres: 'off, m', degrees: 'turned, °', surfaces: 'surfaces' },

  wideness: 'How wide it is on the way',
  widenessUnit: 'm',
  widenessHint:
    'From the surface on the left to the one on the right, each 0.1 m. A dot is a narrow place that became an exit; the number above it is that of the local space behind. A hollow dot is an exit that the robot knew.',
  wide: (metres: number) => `${number(metres, 2)} m wide`,
  noWideness: (mappers: string) => `${mappers} knows no local spaces, so it does not look how wide it is.`,
  error: 'How far off the robot is',
  errorHint:
    'How far the robot is from where it believes it is, truth and map laid upon each other at the first view, as the studies measure it',
  errorIn: 'Unit of the error',
  units: { metres: 'm', degrees: '°' },
  noError: 'A log does not say where the robot truly was, so nothing is known about errors.',
  surfaces: 'Surfaces in the memory',

  /** A space as the schematic names it. */
  place: ({ asr, current, behind }: SchematicPlace) =>
    `Local space ${asr}${behind === undefined ? '' : `, behind exit ${behind}`}${current ? ', where the robot is' : ''}`,
  noPlaces: 'None of these mappers knows what a local space is. Show perceptual or consensus.',
  legend: 'Left is where the robot began; each line leads through an exit, and the number on it is its width in metres.',
  times: (exits: number) => `${exits} exits`,
  loops: 'A double line closed a loop.',
  choose: 'Choose a place to read its story.',
  /** What is known about a place, sentence by sentence. */
  story: ({ asr, area, surfaces, behind, exits, merged, step, current }: SchematicPlace, { exits: all }: Schematic) => {
    const width = (exit: number) => all.find((other) => other.exit === exit)?.width ?? 0;
    const opened =
      behind === undefined
        ? `The robot ${asr === 0 ? 'began here' : `came here in view ${step + 1}`}.`
        : `Opened in view ${step + 1}, once the robot had gone through exit ${behind}, ${number(width(behind), 2)} m wide.`;
    const ways = [...new Set(exits.map(({ asr }) => asr))].map((to) => {
      const through = exits.filter(({ asr }) => asr === to).map(({ exit }) => exit);
      return `to space ${to} through ${through.length === 1 ? 'exit' : 'exits'} ${through.join(', ')}`;
    });
    return [
      `${current ? 'The robot is here. ' : ''}${opened}`,
      `${number(area, 1)} m² of floor seen, ${count(surfaces, 'surface', 'surfaces')}.`,
      ways.length === 0 ? 'No way out has been gone through yet.' : `Leads ${ways.join('; ')}.`,
      ...(merged.length === 0
        ? []
        : [`${merged.length === 1 ? 'Space' : 'Spaces'} ${merged.join(', ')} turned out to be this one: a loop was closed.`]),
    ];
  },
  storyTitle: (asr: number) => `Local space ${asr}`,
  toOpening: (moment: string) => `Go to ${moment}, when it was opened`,
} as const;
