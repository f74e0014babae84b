import type { Clause, Followed, HomingStatus } from '../../wasm/cogmap_wasm';
import { capital, moment, number, said, whole } from '../words';
import { reasons } from './reasons';
import { worlds } from './worlds';

/** What each way of going home is, and whose idea. */
const STRATEGIES: Record<string, string> = {
  recommended: 'Unsere: plant durch alles, woran er sich erinnert und was er für frei hält',
  faithful: 'Die der Dissertation, wörtlich: durch die Öffnung, die am geradesten heimführt, mit Zickzack und Fallen',
  retrace: 'Zum Vergleich: zurück, wie er kam, Wegpunkt für Wegpunkt; die Dissertation lehnt das ab',
  'tangent-bug': 'Zum Vergleich, aus der Literatur: geradeaus, und um alles herum, was im Weg steht',
  oracle: 'Zum Vergleich: der kürzeste Weg, von jemandem, der das Gebäude sieht, wie es ist',
};

/** What a run is made of and told. */
export const controls = {
  setup: {
    title: 'Aufbau',
    world: 'Welt',
    groups: {
      everyday: 'Alltägliche Gebäude',
      home: 'Zum Heimfinden gemacht',
      thesis: 'Lange Runden, wie in der Dissertation',
      schematic: 'Um eines zu zeigen',
      generated: 'Aus einer Nummer gemacht',
    },
    names: {
      'around-a-corner': 'Um eine Ecke',
      'box-course': 'Kistenparcours',
      'environment-a': 'Umgebung A',
      'environment-b': 'Umgebung B',
      'long-corridor': 'Langer Flur',
      'long-office': 'Langes Büro',
      'narrow-passage': 'Enger Durchgang',
      'no-passage': 'Kein Durchgang',
      office: 'Büro',
      shortcut: 'Abkürzung',
      'small-office': 'Kleines Büro',
      tour: 'Rundgang',
      'two-shortcuts': 'Zwei Abkürzungen',
      'u-trap': 'U-Falle',
    } as Readonly<Record<string, string>>,
    about: worlds,
    generated: 'Ein neues Gebäude',
    generatedHint: 'Eine Büroetage, die niemand gezeichnet hat: Flure, Räume, Türen und Möbel ergeben sich aus ihrer Nummer.',
    building: 'Nummer',
    buildingHint: 'Jede Nummer ist eine andere Büroetage, und immer dieselbe',
    robot: 'Roboter',
    seed: 'Zufallszahl',
  },

  homing: {
    title: 'Heimweg',
    go: 'Nach Hause',
    going: 'Unterwegs …',
    goHint: 'Lässt den Roboter allein dorthin zurückfinden, wo er losfuhr',
    strategy: (name: string) => `Wie er den Weg findet: ${name}`,
    about: (name: string) => STRATEGIES[name] ?? `Wie ${name} es macht`,
    because: (clauses: Clause[]) => `${capital(said(clauses, reasons))}.`,
    looking: 'Er soll nach Hause; zuerst hält er an und sieht sich um.',
    leads: {
      direction: 'Nach seinem Richtungssinn:',
      route: 'Auf dem erinnerten Weg:',
      planning: 'Nach einem Plan:',
    },
    ended: ({ ended, distance, believed, why }: HomingStatus) => {
      const off = `${number(distance, 2)} m von dort, wo er losfuhr`;
      switch (ended) {
        case 'home':
          return `Zu Hause: Er hielt von selbst an, ${off}${believed === undefined ? '' : `; er glaubt ${number(believed, 2)} m`}.`;
        case 'stuck':
          return `Er gab auf, ${off}: ${why ?? 'er hatte nichts gesehen'}.`;
        case 'stopped':
          return `Sie haben übernommen, ${off}.`;
        case undefined:
          return '';
      }
    },
  },

  log: {
    mapping: (name: string, done: number, all: number) =>
      `${name} wird kartiert: ${whole(done)} von ${whole(all)} Scans`,
    cancel: 'Abbrechen',
  },

  transport: {
    title: 'Zeit',
    restart: 'Von vorn',
    play: 'Abspielen',
    pause: 'Pause',
    next: 'Nächste Ansicht',
    finish: 'Bis zum Ende',
    finishHint: 'Sofort dorthin, wo der Roboter getan hat, was ihm gesagt wurde',
    timeline: 'Zeitleiste',
    marks: 'Ereignisse',
    mark: (moment: string, said: string) => `${moment}: ${said}`,
    moment,
    undo: 'Rückgängig',
    redo: 'Wiederholen',
    branch: (others: number) => `Anderer Zweig (${others})`,
    branchHint: 'Hinüber zu dem, was geschehen wäre, wären Sie nicht anders weitergegangen',
    speed: 'Tempo',
    times: (factor: number) => `${factor}×`,
    full: 'Max',
  },

  drive: {
    title: 'Fahren',
    ahead: 'Vorwärts',
    back: 'Rückwärts',
    left: 'Links drehen',
    right: 'Rechts drehen',
    stop: 'Halt',
    stick: 'Schieben Sie den Stick dorthin, wohin der Roboter fahren soll; Loslassen hält ihn an',
  },

  /** A way that is drawn for the robot to follow. */
  way: {
    open: 'Weg zeichnen',
    openHint: 'In die Welt zeichnen, wohin der Roboter fahren soll (Q). Mit der Tastatur: Die Pfeiltasten steuern ihn Schritt für Schritt',
    ofLog: 'Eine Aufzeichnung hat keinen Roboter, den man schicken könnte',
    hint: 'Zeichnen Sie, wohin der Roboter fahren soll; ein Klick schickt ihn geradewegs dorthin. Ohne Zeiger gehen die Pfeiltasten.',
    said: (followed: Followed) => {
      switch (followed.kind) {
        case 'going':
          return `Unterwegs: ${number(followed.metres, 1)} m${followed.around ? ', um das herum, was im Weg ist' : ''}.`;
        case 'no_room':
          return 'Der Roboter bleibt: Nirgends auf dieser Linie ist Platz für ihn.';
        case 'unreachable':
          return 'Der Roboter bleibt: Ein Teil dieser Linie ist von hier nicht zu erreichen.';
        case 'no_line':
          return 'Der Roboter bleibt: Diese Linie führt nicht von ihm weg.';
        case 'no_building':
          return 'Eine Aufzeichnung hat keinen Roboter, den man schicken könnte.';
      }
    },
  },

  gamepad: {
    name: 'Gamepad',
    found: 'Gamepad gefunden: linker Stick oder Steuerkreuz fährt, A fährt heim, B hält an, Start spielt ab und pausiert.',
  },

  invitation: {
    title: 'Übernehmen Sie',
    withKeys: 'drücken Sie eine Pfeiltaste',
    withTouch: 'tippen Sie irgendwo in die Welt',
  },

  theme: { dark: 'Auf dunkel schalten', light: 'Auf hell schalten' },
  language: 'Sprache',
} as const;
