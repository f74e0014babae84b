import type { Schematic, SchematicPlace } from '../../wasm/cogmap_wasm';
import { count, moment, number } from '../words';

/** What is plotted of a run, and the places as a schematic. */
export const plots = {
  title: 'Diagramme',
  openHint: 'Weite, Fehler und Flächen im Lauf der Fahrt, und die Räume als Schema',
  close: 'Diagramme schließen',
  loading: 'Die Diagramme werden geholt …',
  failed: 'Die Diagramme ließen sich nicht holen. Schließen Sie sie und versuchen Sie es noch einmal.',
  pages: 'Was gezeigt wird',
  curves: 'Im Lauf der Fahrt',
  places: 'Räume',
  whose: 'Weg und Räume nach',
  whoseHint: 'Wessen Weg und Räume gezeigt werden',
  waiting: 'Noch wurde nichts gesehen.',
  moment,

  reader: 'Augenblick in den Diagrammen',
  exitsHint: 'Ein Punkt ist ein Ausgang, seine Nummer der lokale Raum dahinter.',
  readerHint: 'Klicken Sie auf einen Augenblick, um dorthin zu gehen, oder nehmen Sie Pfeiltasten und Eingabetaste auf der Leiste darüber.',
  now: 'jetzt',
  at: (moment: string) => `bei ${moment}`,
  /** The values at a moment in a sentence each. */
  spoken: (moment: string, wide: number | undefined, mappers: { mapper: string; view: number; off: [number, number] | undefined; surfaces: number }[]) =>
    [
      moment,
      ...(wide === undefined ? [] : [`${number(wide, 2)} Meter weit`]),
      ...mappers.map(({ mapper, view, off, surfaces }) => {
        const wrong = off ? [`${number(off[0], 2)} Meter und ${number(off[1], 1)} Grad daneben`] : [];
        return [`${mapper}: Ansicht ${view}`, ...wrong, count(surfaces, 'Fläche', 'Flächen')].join(', ');
      }),
    ].join('. '),
  values: 'Werte in diesem Augenblick',
  columns: { mapper: 'Kartierer', view: 'Ansicht', metres: 'daneben, m', degrees: 'verdreht, °', surfaces: 'Flächen' },

  wideness: 'Wie weit es unterwegs ist',
  widenessUnit: 'm',
  widenessHint:
    'Von der Fläche links zu der rechts, alle 0,1 m. Ein Punkt ist eine enge Stelle, die zum Ausgang wurde; die Nummer darüber ist die des lokalen Raums dahinter. Ein hohler Punkt ist ein Ausgang, den der Roboter kannte.',
  wide: (metres: number) => `${number(metres, 2)} m weit`,
  noWideness: (mappers: string) => `${mappers} kennt keine lokalen Räume und achtet deshalb nicht darauf, wie weit es ist.`,
  error: 'Wie weit der Roboter danebenliegt',
  errorHint:
    'Wie weit der Roboter von dort weg ist, wo er zu sein glaubt; Wahrheit und Karte liegen in der ersten Ansicht aufeinander, wie es die Studien messen',
  errorIn: 'Einheit des Fehlers',
  units: { metres: 'm', degrees: '°' },
  noError: 'Eine Aufzeichnung sagt nicht, wo der Roboter wirklich war; über Fehler ist deshalb nichts bekannt.',
  surfaces: 'Flächen im Gedächtnis',

  /** A space as the schematic names it. */
  place: ({ asr, current, behind }: SchematicPlace) =>
    `Lokaler Raum ${asr}${behind === undefined ? '' : `, hinter Ausgang ${behind}`}${current ? ', hier ist der Roboter' : ''}`,
  noPlaces: 'Keiner dieser Kartierer weiß, was ein lokaler Raum ist. Zeigen Sie perceptual oder consensus.',
  legend: 'Links begann der Roboter; jede Linie führt durch einen Ausgang, und die Zahl daran ist seine Breite in Metern.',
  times: (exits: number) => `${exits} Ausgänge`,
  loops: 'Eine doppelte Linie schloss eine Schleife.',
  choose: 'Wählen Sie einen Raum, um seine Geschichte zu lesen.',
  /** What is known about a place, sentence by sentence. */
  story: ({ asr, area, surfaces, behind, exits, merged, step, current }: SchematicPlace, { exits: all }: Schematic) => {
    const width = (exit: number) => all.find((other) => other.exit === exit)?.width ?? 0;
    const opened =
      behind === undefined
        ? asr === 0 ? 'Der Roboter begann hier.' : `Der Roboter kam in Ansicht ${step + 1} hierher.`
        : `Angelegt in Ansicht ${step + 1}, nachdem der Roboter durch Ausgang ${behind} gefahren war, ${number(width(behind), 2)} m breit.`;
    const ways = [...new Set(exits.map(({ asr }) => asr))].map((to) => {
      const through = exits.filter(({ asr }) => asr === to).map(({ exit }) => exit);
      return `in den Raum ${to} durch ${through.length === 1 ? 'Ausgang' : 'die Ausgänge'} ${through.join(', ')}`;
    });
    return [
      `${current ? 'Der Roboter ist hier. ' : ''}${opened}`,
      `${number(area, 1)} m² Boden gesehen, ${count(surfaces, 'Fläche', 'Flächen')}.`,
      ways.length === 0 ? 'Noch wurde kein Weg hinaus genommen.' : `Führt ${ways.join('; ')}.`,
      ...(merged.length === 0
        ? []
        : [`${merged.length === 1 ? 'Raum' : 'Die Räume'} ${merged.join(', ')} ${merged.length === 1 ? 'erwies' : 'erwiesen'} sich als dieser: Eine Schleife wurde geschlossen.`]),
    ];
  },
  storyTitle: (asr: number) => `Lokaler Raum ${asr}`,
  toOpening: (moment: string) => `Zu ${moment}, als er angelegt wurde`,
} as const;
