import type { Kind } from '../../editor/things';
import type { Catch } from '../../editor/snapping';
import type { ToolName } from '../../editor/tools';
import type { Thing } from '../../wasm/cogmap_wasm';
import { count, number } from '../words';

const metres = (long: number) => `${number(long, long % 0.1 < 0.001 || long % 0.1 > 0.099 ? 1 : 2)} m`;
const quoted = (name: string) => (name.trim() === '' ? 'ohne Namen' : `„${name}“`);

const KINDS: Record<Kind, string> = {
  wall: 'Wand',
  box: 'Kiste',
  post: 'Pfosten',
  door: 'Tür',
  person: 'Person',
  start: 'Start',
  route: 'Route',
  room: 'Raum',
};

/** The place of a file that a message speaks of, as the editor calls it: it counts from 1. */
const LISTS: [RegExp, string][] = [
  [/\bboxes\[(\d+)\]/g, 'Kiste'],
  [/\bposts\[(\d+)\]/g, 'Pfosten'],
  [/\bwalls\[(\d+)\]/g, 'Wand'],
  [/\bdoors\[(\d+)\]/g, 'Tür'],
];

/** The editor of buildings; loaded with it. */
export const editing = {
  title: 'Ein Gebäude zeichnen',
  back: 'Zurück',
  backHint: 'Zurück zur Fahrt; das Gezeichnete bleibt erhalten',
  save: 'Welt sichern',
  saveHint: 'Als Weltdatei sichern, die Seite und Kommandozeile öffnen',
  drive: 'Hier fahren',
  driveHint: 'Eine Fahrt in diesem Gebäude beginnen, mit dem gewählten Roboter, den Kartierern und der Zufallszahl',
  undo: 'Rückgängig',
  redo: 'Wiederholen',
  zoomIn: 'Vergrößern',
  zoomOut: 'Verkleinern',
  fit: 'Alles zeigen',
  snap: 'Einrasten',
  snapHint: 'Zieht Punkte an Ecken, Wände, rechte Winkel und das Raster von 0,1 m (G); Alt halten lässt es aus',
  preparing: 'Das Blatt wird ausgelegt …',
  refused: (reason: string) => `Das Gebäude ließ sich nicht öffnen. ${reason}`,
  stopped: 'Die Rechenmaschine des Editors blieb unerwartet stehen. Gehen Sie zurück und öffnen Sie das Gebäude noch einmal: Nichts ist verloren.',

  toolsTitle: 'Werkzeuge',
  tools: {
    select: 'Wählen',
    wall: 'Wand',
    box: 'Kiste',
    post: 'Pfosten',
    door: 'Tür',
    room: 'Raum',
    start: 'Start',
    route: 'Route',
    person: 'Person',
  } satisfies Record<ToolName, string>,
  hints: {
    select: 'Klicken Sie etwas an, um es zu wählen, ziehen Sie es, um es zu verschieben. Am Boden ziehen zeigt anderes.',
    wall: 'Klicken Sie Ecke für Ecke. Doppelklick oder Eingabe beendet die Wand.',
    box: 'Ziehen Sie von Ecke zu Ecke.',
    post: 'Klicken Sie dorthin, wo ein Bein oder ein Pfeiler steht.',
    door: 'Ziehen Sie vom Scharnier zum Schloss. Sie öffnet gegen den Uhrzeigersinn.',
    room: 'Klicken Sie rund um den Raum, Ecke für Ecke. Doppelklick oder Eingabe beendet ihn.',
    start: 'Drücken Sie, wo der Roboter beginnen soll, und ziehen Sie dorthin, wohin er blickt.',
    route: 'Klicken Sie Punkt für Punkt, wohin der Roboter fahren soll. Doppelklick oder Eingabe beendet sie.',
    person: 'Klicken Sie Punkt für Punkt, wo jemand hin und her geht. Doppelklick oder Eingabe beendet den Weg.',
  } satisfies Record<ToolName, string>,
  going: (points: number, of: number) =>
    of === 2
      ? 'Nun das andere Ende. Esc verwirft es.'
      : `${count(points, 'Punkt', 'Punkte')}. Doppelklick oder Eingabe beendet, Esc verwirft.`,
  done: 'Fertig',
  abandon: 'Verwerfen',
  moving: 'Pfeiltasten bewegen es, Eingabe setzt es ab, Esc stellt es zurück.',

  sheet: 'Das Blatt',
  sheetHint:
    'Pfeiltasten bewegen die Marke um 0,1 m, mit Umschalt um 1 m, mit Alt um 1 cm; Eingabe setzt einen Punkt oder wählt, was dort ist. V, W, B, P, D, R, S und T wählen ein Werkzeug.',
  cursor: (x: number, y: number, on: string | undefined) =>
    `${number(x, 2)}, ${number(y, 2)} m${on === undefined ? '' : `, ${on}`}`,
  snapped: { corner: 'Ecke', wall: 'Wand', angle: 'rechter Winkel', grid: 'Raster' } satisfies Record<Catch, string>,

  panel: 'Was gezeichnet ist',
  building: 'Gebäude',
  name: 'Name',
  description: 'Beschreibung',
  selected: 'Gewählt',
  nothing: 'nichts',
  none: 'Wählen Sie etwas, um seine Zahlen zu sehen und zu ändern.',
  fields: {
    x: 'x, m',
    y: 'y, m',
    length: 'Länge, m',
    width: 'Breite, m',
    heading: 'Richtung, °',
    radius: 'Radius, m',
    speed: 'Tempo, m/s',
    hinge: 'Scharnier',
    latch: 'Schloss',
    open: 'Anfangs offen',
    corner: (nth: number) => `Ecke ${nth}`,
    point: (nth: number) => `Punkt ${nth}`,
  },
  takeCorner: (nth: number) => `Punkt ${nth} herausnehmen`,
  addCorner: 'Punkt anfügen',
  duplicate: 'Verdoppeln',
  remove: 'Löschen',
  kinds: KINDS,
  stems: { door: 'Tür', room: 'Raum', route: 'Route' },
  copyOf: (name: string) => `${name} Kopie`,
  newName: 'Neues Gebäude',

  checks: 'Prüfung',
  sound: 'Alles ist in Ordnung: Es lässt sich befahren und sichern.',
  checking: 'Wird durchgesehen …',
  faults: (faults: number) => `Zuerst zu berichtigen: ${faults}`,
  remarks: 'Einen Blick wert:',
  first: 'Berichtigen Sie zuerst, was die Prüfung aufzählt.',
  message: (message: string) => LISTS.reduce((text, [list, word]) => text.replace(list, (_, index) => `${word} ${Number(index) + 1}`), message),

  keysTitle: 'Tasten',
  keys: [
    { keys: ['V', 'W', 'B', 'P', 'D', 'R', 'S', 'T', 'N'], does: 'wählen, Wand, Kiste, Pfosten, Tür, Raum, Start, Route, Person' },
    { keys: ['↑ ↓ ← →'], does: 'die Marke um 0,1 m bewegen (Umschalt 1 m, Alt 1 cm)' },
    { keys: ['Eingabe'], does: 'einen Punkt setzen, am letzten enden, wählen oder aufnehmen, was dort ist' },
    { keys: ['Esc'], does: 'verwerfen, zurückstellen, nichts wählen' },
    { keys: ['Entf', 'Strg D'], does: 'löschen, verdoppeln' },
    { keys: ['Strg Z', 'Strg Umschalt Z'], does: 'rückgängig, wiederholen' },
    { keys: ['G', 'Alt'], does: 'Einrasten an oder aus; halten lässt es aus' },
    { keys: ['+', '−', '0'], does: 'vergrößern, verkleinern, alles zeigen' },
    { keys: ['Leertaste'], does: 'halten und ziehen, um anderes zu sehen' },
    { keys: ['?'], does: 'diese Liste' },
  ],

  /** What a thing is called; `nth` of its kind. */
  called: (thing: Thing, nth: number) => {
    if (thing.kind === 'start') return KINDS.start;
    return 'name' in thing ? `${KINDS[thing.kind]} ${quoted(thing.name)}` : `${KINDS[thing.kind]} ${nth}`;
  },
  /** The same at one of its points. */
  at: (called: string, thing: Thing, point: number) => {
    if (thing.kind === 'door') return `${called}, ${point === 0 ? 'Scharnier' : 'Schloss'}`;
    return 'points' in thing ? `${called}, Punkt ${point + 1}` : called;
  },

  /** What happened, for the one line that tells it. */
  said: {
    wall: (corners: number, long: number) => `Wand mit ${count(corners, 'Ecke', 'Ecken')}, ${metres(long)} lang, hinzugefügt.`,
    box: (long: number, wide: number) => `Kiste von ${metres(long)} mal ${metres(wide)} hinzugefügt.`,
    post: (x: number, y: number) => `Pfosten bei ${number(x, 2)} / ${number(y, 2)} hinzugefügt.`,
    door: (name: string, wide: number) => `Tür ${quoted(name)}, ${metres(wide)} breit, hinzugefügt.`,
    room: (name: string, corners: number, large: number) =>
      `Raum ${quoted(name)} mit ${count(corners, 'Ecke', 'Ecken')}, ${number(large, 1)} m², hinzugefügt.`,
    start: (x: number, y: number, heading: number) =>
      `Der Roboter beginnt bei ${number(x, 2)} / ${number(y, 2)} und blickt nach ${number(heading, 0)}°.`,
    route: (name: string, points: number) => `Route ${quoted(name)} durch ${count(points, 'Punkt', 'Punkte')} hinzugefügt.`,
    person: (long: number) => `Jemand hinzugefügt, der ${metres(long)} hin und her geht.`,
    point: (nth: number, x: number, y: number) => `Punkt ${nth} bei ${number(x, 2)} / ${number(y, 2)}.`,
    pointTaken: (left: number) => `Der letzte Punkt ist zurückgenommen, es bleiben ${left}.`,
    tooFew: (least: number) => `Das braucht mindestens ${least} Punkte.`,
    tooSmall: 'Das ist zu klein: Zeichnen Sie es größer.',
    abandoned: 'Verworfen.',
    putBack: 'Zurückgestellt.',
    tool: (name: string, hint: string) => `${name}. ${hint}`,
    selected: (called: string) => `${called} gewählt.`,
    nothingThere: 'Dort ist nichts.',
    taken: (called: string) => `${called} aufgenommen.`,
    changed: (called: string) => `${called} geändert.`,
    moved: (called: string) => `${called} verschoben.`,
    removed: (called: string) => `${called} gelöscht.`,
    keepsStart: 'Jedes Gebäude braucht einen Start: Verschieben Sie ihn stattdessen.',
    duplicated: (called: string) => `${called} ist die Kopie.`,
    undone: 'Rückgängig gemacht.',
    redone: 'Wiederholt.',
    nothingToUndo: 'Nichts mehr rückgängig zu machen.',
    nothingToRedo: 'Nichts mehr zu wiederholen.',
    snapping: (on: boolean) => (on ? 'Punkte rasten ein.' : 'Punkte rasten nicht ein.'),
    saved: (file: string) => `Gesichert als ${file}.`,
    opened: (name: string) => `${name} ist auf dem Blatt.`,
    over: (name: string) => `${name} ist auf dem Blatt. Was vorher gezeichnet war, kommt mit Rückgängig wieder.`,
  },
} as const;
