import type { PlacementKind, Place, RememberedKind, Whereabouts } from '../../wasm/cogmap_wasm';
import { count, moment, number } from '../words';

/** A direction seen from the robot. */
function direction(degrees: number): string {
  const turned = Math.round(Math.abs(degrees));
  if (turned < 5) return 'geradeaus';
  if (turned > 175) return 'genau hinten';
  return `${turned}° ${degrees > 0 ? 'links' : 'rechts'}`;
}

/** The way to the moment in which a thing came to be. */
const to = (what: string) => (view: number, t: number) => `Zu Ansicht ${view} bei ${moment(t)}, ${what}`;

const titles: Record<RememberedKind, (number: number) => string> = {
  surface: (number) => `Fläche ${number}`,
  exit: (number) => `Ausgang ${number}`,
  supposed: (number) => `Vermuteter Ausgang ${number}`,
  asr: (number) => `Lokaler Raum ${number}`,
};

const go: Record<RememberedKind, (view: number, t: number) => string> = {
  surface: to('als sie zuerst gesehen wurde'),
  exit: to('als er gefunden wurde'),
  supposed: to('als er zuerst gesehen wurde'),
  asr: to('als er angelegt wurde'),
};

const rules: Record<PlacementKind, string> = {
  first: 'die erste Ansicht legt das Bezugssystem der Karte fest',
  reference: 'ein Bezugsziel bestimmt die Ansicht',
  weak_reference: 'ein Bezugsziel, seine Lage auf der eigenen Linie geraten',
  consensus: 'alle erkannten Flächen zusammen bestimmen die Ansicht',
  partly_odometry: 'alle erkannten Flächen, und die Odometrie in einer Richtung, die sie offenlassen',
  transform: 'die Bewegung, berichtigt, bis die Ansichten passen',
  odometry: 'was die Räder sagen, unberichtigt',
};

const relative: Record<PlacementKind, (recognised: number) => string> = {
  first: () => 'nichts: Die Karte beginnt damit',
  reference: () => 'Bezugsziel',
  weak_reference: () => 'Bezugsziel',
  consensus: (recognised) => count(recognised, 'erkannte Fläche', 'erkannte Flächen'),
  partly_odometry: (recognised) => `${count(recognised, 'erkannte Fläche', 'erkannte Flächen')} und Odometrie`,
  transform: () => 'vorige Ansicht, über die Bewegung',
  odometry: () => 'vorige Ansicht, über die Odometrie',
};

/** What is told about the things that a memory holds. */
export const telling = {
  pointed: {
    walk: 'Durch das Gedächtnis gehen: ← → älter und neuer, ↑ ↓ Flächen, Ausgänge und lokale Räume, Eingabetaste behält die Karte',
    keep: 'Ein Klick behält diese Karte.',
    keepByKey: 'Die Eingabetaste behält diese Karte, Esc nimmt sie weg.',
    close: 'Karte schließen',
    titles,
    go,
    labels: {
      seen: 'Zuerst gesehen',
      last: 'Zuletzt gesehen',
      relative: 'Eingetragen bezüglich',
      rule: 'Nach der Regel',
      length: 'Länge',
      belongs: 'Gehört zu',
      width: 'Breite',
      joins: 'Verbindet',
      made: 'Gefunden',
      through: 'Durchfahren',
      from: 'Gesehen von',
      robot: 'Der Roboter',
      opened: 'Angelegt',
      entered: 'Betreten',
      area: 'Boden gesehen',
      surfaces: 'Flächen',
      exits: 'Ausgänge',
      loops: 'Schleifen geschlossen',
      merged: 'War auch',
    },
    view: (view: number, t: number) => `Ansicht ${view}, ${moment(t)}`,
    once: 'nur damals',
    sightings: (views: number) => `in ${count(views, 'Ansicht', 'Ansichten')}`,
    relative,
    rules,
    metres: (length: string) => `${length}\u00a0m`,
    squareMetres: (area: string) => `${area}\u00a0m²`,
    through: (times: number, last: string) => (times <= 1 ? `einmal, ${last}` : `${times}-mal, zuletzt ${last}`),
    looped: 'eine, beim Durchfahren',
    supposed: 'noch nicht: nur gesehen',
    began: 'hier fand sich der Roboter vor',
    entrance: (exit: number) => `hinter Ausgang ${exit}`,
    entries: (times: number, last: string) => (times <= 1 ? `einmal, ${last}` : `${times}-mal, zuletzt ${last}`),
    here: 'glaubt, hier zu sein',
    none: 'keine',
  },

  text: {
    title: 'Textansicht',
    openHint: 'Was das Gedächtnis enthält, in Worten und Tabellen: wo der Roboter zu sein glaubt, Räume, Ausgänge und Flächen',
    close: 'Textansicht schließen',
    loading: 'Die Textansicht wird geholt …',
    failed: 'Die Textansicht ließ sich nicht holen. Schließen Sie sie und versuchen Sie es noch einmal.',
    waiting: 'Noch wurde nichts gesehen.',
    whose: 'Gedächtnis von',
    whoseHint: 'Wessen Gedächtnis erzählt wird',
    lines: 'Was das Gedächtnis enthält',
    chooseHint: 'Ihre Geschichte in der Zeichnung zeigen',
    robot: 'Wo der Roboter zu sein glaubt',
    whereabouts: ({ asr, home, turned_deg }: Whereabouts) => [
      ...(asr === undefined ? [] : [`Im lokalen Raum ${asr}.`]),
      ...(home === undefined
        ? ['Er weiß nicht, wie sein Zuhause liegt.']
        : home.distance < 0.05
          ? ['Zu Hause, wo die Fahrt begann.']
          : [`Zuhause, wo die Fahrt begann, ist ${number(home.distance, 1)} m entfernt, ${direction(home.angle_deg)}.`]),
      Math.abs(turned_deg) < 0.5
        ? 'Er schaut wie zu Beginn der Fahrt.'
        : `Seitdem hat er sich um ${Math.round(Math.abs(turned_deg))}° nach ${turned_deg > 0 ? 'links' : 'rechts'} gedreht.`,
    ],
    asOf: (view: number, t: number) => `Stand: Ansicht ${view}, ${moment(t)}.`,
    behind: 'Der Roboter ist seitdem weitergefahren; die Worte warten, solange Sie bei einer Zeile sind.',
    update: 'Erneuern',
    network: 'Das Netz der Räume',
    noPlaces: (mapper: string) => `${mapper} weiß nicht, was ein lokaler Raum ist.`,
    place: ({ current, surfaces }: Place, area: string) =>
      `${current ? 'hier ist der Roboter; ' : ''}${count(surfaces, 'Fläche', 'Flächen')}, ${area} m² Boden gesehen`,
    exitsOf: (asr: number) => `Ausgänge des lokalen Raums ${asr}`,
    supposed: 'Ausgänge, die nur gesehen wurden',
    surfaces: (all: number) => `Flächen: ${all}, die nächsten zuerst`,
    surfacesOf: (asr: number | undefined, surfaces: number) =>
      `${asr === undefined ? 'Überall' : `Im lokalen Raum ${asr}`}: ${count(surfaces, 'Fläche', 'Flächen')}`,
    more: (shown: number, all: number) => `Mehr zeigen (${shown} von ${all})`,
    columns: {
      exits: ['Ausgang', 'in Raum', 'Breite', 'entfernt', 'Richtung'],
      supposed: ['Ausgang', 'Breite', 'entfernt', 'Richtung'],
      surfaces: ['Fläche', 'Länge', 'entfernt', 'Richtung'],
      age: 'Alter',
    },
    direction,
    age: (seconds: number) => (seconds < 99.5 ? `${Math.round(seconds)}\u00a0s` : `${Math.round(seconds / 60)}\u00a0min`),
  },
} as const;
