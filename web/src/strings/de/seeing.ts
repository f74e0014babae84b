import type { Happening } from '../../wasm/cogmap_wasm';
import { count, number } from '../words';
import { changing } from './changing';

/** What each mapper is, in a line. */
const MAPPERS: Record<string, string> = {
  perceptual: 'Yeaps Kartieren nach der Wahrnehmung, wie die Dissertation es programmiert, mit allen Schwächen',
  consensus: 'Unserer: Alle wiedererkannten Flächen zusammen sagen, wo der Roboter ist',
  transform: 'Auf herkömmliche Art: Ansichten, nach einer berichtigten Bewegung zusammengesetzt',
  odometry: 'Ansichten, zusammengesetzt nach dem, was die Räder sagen, unberichtigt',
};

/** What is seen of the world and of the memories, and what is said about it. */
export const seeing = {
  world: {
    title: 'Die Welt',
    subtitle: 'wie sie ist',
    picture:
      'Das Gebäude von oben, mit dem Roboter, seinem Laser und seinem Weg. Klicken Sie auf einen Punkt, um den Roboter dorthin zu schicken.',
  },

  memory: {
    title: 'Das Gedächtnis des Roboters',
    subtitle: (mapper: string | undefined) => (mapper === undefined ? 'wie er sie sich denkt' : `nach ${mapper}`),
    picture:
      'Die Karte im Gedächtnis des Roboters: jede Fläche dort gezeichnet, wohin sie gesetzt wurde, als sie zum ersten Mal gesehen wurde, die Ausgänge zwischen lokalen Räumen und das Netz, das sie bilden.',
  },

  wheels: {
    title: 'Die Aufzeichnung',
    subtitle: 'allein nach der Odometrie',
    picture: 'Der Weg, wie ihn die Räder des Roboters zählten; die Kartierer berichtigen ihn.',
  },

  shown: {
    views: 'Zeigen',
    world: 'Welt',
    mapper: (name: string) => MAPPERS[name] ?? `Was ${name} aus derselben Fahrt macht`,
    layers: 'In den Gedächtnissen',
    colours: 'Farbe nach',
    by: { view: 'Ansicht', asr: 'lokalem Raum', age: 'Alter' },
    stance: 'Gesehen von',
    stanceHint:
      'Von außen steht die Karte still; vom Roboter aus oder von dort, wo er diesen lokalen Raum betrat, steht dieser Punkt still und blickt nach oben',
    from: { map: 'außen', robot: 'dem Roboter', entrance: 'dem Eingang' },
    exits: 'Ausgänge',
    exitsHint: 'Die engen Stellen zwischen lokalen Räumen, gefunden, nachdem der Roboter hindurchfuhr',
    network: 'Netz',
    networkHint: 'Lokale Räume nach Nummer und die Wege durch Ausgänge, die sie verbinden',
    homing: 'Pläne',
    homingHint: 'Was der Roboter auf dem Heimweg vorhat: wohin er könnte, wohin er fährt und wonach er nicht mehr geht',
    truth: 'Wahrheit',
    truthHint: 'Legt die Welt über die Gedächtnisse',
    fit: 'gelegt nach',
    fits: { first_view: 'erster Ansicht', best_fit: 'bester Passung' },
    fitHint:
      'Nach der ersten Ansicht sieht man Fehler dort, wo sie entstanden; nach bester Passung liegt der ganze erinnerte Weg so nah am wahren, wie Schieben und Drehen ihn bringen',
  },

  facts: {
    travelled: (metres: number) => `${number(metres, 1)} m gefahren`,
    collisions: (bumps: number) => count(bumps, 'Stoß', 'Stöße'),
    memory: ({ surfaces, views, asrs }: { surfaces: number; views: number; asrs: number | undefined }) => [
      `${count(surfaces, 'Fläche', 'Flächen')} aus ${count(views, 'Ansicht', 'Ansichten')}`,
      ...(asrs === undefined ? [] : [count(asrs, 'lokaler Raum', 'lokale Räume')]),
    ],
    off: (metres: number, degrees: number) => `${number(metres, 2)} m und ${Math.round(degrees)}° daneben`,
    home: (metres: number, believed: number | undefined) =>
      `${number(metres, 2)} m bis nach Hause${believed === undefined ? '' : `, er glaubt ${number(believed, 2)} m`}`,
    offHint: 'Wie weit der Roboter von dort weg ist, wo er zu sein glaubt',
  },

  story: {
    waiting: 'Noch wurde nichts gesehen.',
    view: (step: number, seen: number, recognised: number) =>
      `Ansicht ${step}: ${count(seen, 'Fläche', 'Flächen')} gesehen, ${recognised} wiedererkannt`,
    first: 'die erste Ansicht legt das Koordinatensystem der Karte fest',
    reference: (known: number) => `Bezug: Fläche ${known}`,
    weak_reference: (known: number) => `Bezug: Fläche ${known}, ihr Platz längs der Wand geraten`,
    consensus: 'alle zusammen sagen, wo der Roboter ist',
    partly_odometry: 'sie lassen eine Richtung offen, in der die Odometrie entscheidet',
    transform: 'die Bewegung berichtigt, bis die Ansichten passten',
    odometry: 'nach der Odometrie gesetzt',
    placed: (surfaces: number) =>
      surfaces === 0 ? 'nichts Neues' : `${count(surfaces, 'neue Fläche', 'neue Flächen')} gesetzt`,
    label: 'Was der Roboter eben tat',
    happened: 'Was geschah',
  },

  /** What happened in a mind; local spaces and exits bear the numbers that they have in the map. */
  happened: (what: Happening) => {
    switch (what.kind) {
      case 'exit':
        return `Durch Ausgang ${what.exit} in den lokalen Raum ${what.asr} gefahren`;
      case 'new_asr':
        return `Lokaler Raum ${what.asr} hinter Ausgang ${what.exit} angelegt`;
      case 'loop_closed':
        return `Wieder im lokalen Raum ${what.asr}: Eine Schleife ist geschlossen`;
      case 'unseen':
        return 'Nichts im Blick war bekannt: Nur die Odometrie sagte, wo der Roboter war';
      case 'lost':
        return 'Verirrt: Der Roboter ist nicht, wo er zu sein glaubte, und beginnt eine eigene Karte';
      case 'recognised':
        return 'Wiedergefunden: Der Roboter erkannte einen Ort, den er kannte';
      case 'told_home':
        return 'Nach Hause geschickt';
      case 'kidnapped':
        return 'Aufgehoben und anderswo abgesetzt';
      case 'world_changed':
        return changing.changed[what.change];
    }
  },

  by: (mapper: string, said: string) => `${mapper}: ${said}`,

  divider: {
    name: (view: string) => `Größe von „${view}“`,
    share: (percent: number) => `${percent} % des Platzes`,
    folded: { first: 'eingeklappt', others: 'der ganze Platz' },
    hint: 'Ziehen gibt einer Seite mehr Platz, bis an den Rand klappt es sie ein; ein Doppelklick teilt gleich. Tasten: Pfeile, Eingabe',
  },

  zoom: { title: 'Vergrößerung', in: 'Vergrößern', out: 'Verkleinern', fit: 'Alles zeigen' },
} as const;
