import type { Changed, Objection } from '../../wasm/cogmap_wasm';
import { day, plain } from '../words';

/** What is changed in a building while the robot is in it. */
export const changing = {
  changing: {
    open: 'Ändern',
    openHint: 'Das Gebäude ändern, während der Roboter darin ist: Türen, Kisten, Leute, die Fehler des Roboters, wo er steht (B)',
    ofLog: 'Zu einer Aufzeichnung gibt es kein Gebäude, das sich ändern ließe',
    title: 'Das Gebäude ändern',
    close: 'Schließen',
    toolsTitle: 'Was geändert wird',
    tools: { door: 'Tür', drop: 'Kiste abstellen', remove: 'Wegnehmen', carry: 'Wegtragen', person: 'Jemand', noise: 'Rauschen' },
    hints: {
      door: 'Klicken Sie auf eine Tür, um sie zu schließen oder zu öffnen.',
      drop: 'Klicken Sie dorthin, wo eine Kiste stehen soll.',
      remove: 'Klicken Sie auf die Kiste oder das Möbel, das weg soll.',
      carry: 'Klicken Sie dorthin, wo der Roboter abgesetzt wird. Seine Odometrie merkt davon nichts.',
      person: 'Klicken Sie dorthin, wo jemand auf und ab gehen soll.',
      noise: '1 × ist das des Roboters. Es gilt von jetzt an; die Karten erfahren davon nichts.',
    },
    noDoors: 'Dieses Gebäude hat keine Türen.',
    noBoxes: 'Hier steht nichts, was man wegnehmen könnte.',
    which: 'Welche Tür',
    door: (name: string, open: boolean) => `${name} (${open ? 'offen' : 'zu'})`,
    swing: (open: boolean) => (open ? 'Schließen' : 'Öffnen'),
    ahead: '1 m voraus',
    aheadHint: 'Stellt sie 1 m vor dem Roboter ab',
    nearest: 'Das Nächste',
    nearestHint: 'Nimmt weg, was dem Roboter am nächsten steht',
    come: '2 m voraus',
    comeHint: 'Lässt jemanden 2 m vor dem Roboter auftauchen',
    noise: { odometry: 'Odometrie', laser: 'Laser' },
    noiseHints: {
      odometry: 'Wie falsch die Räder zählen, als Vielfaches der eigenen Fehler des Roboters',
      laser: 'Wie sehr die Entfernungen streuen, als Vielfaches der eigenen Fehler des Lasers',
    },
    times: (times: number) => `${plain(times)} ×`,
    where: 'Wohin',
    start: 'Wo er losfuhr',
    setDown: 'Absetzen',
    objection: (objection: Objection) => {
      switch (objection.kind) {
        case 'no_building':
          return 'Zu einer Aufzeichnung gibt es kein Gebäude, das sich ändern ließe.';
        case 'no_door':
          return 'Dort ist keine Tür.';
        case 'no_box':
          return 'Dort steht nichts, was man wegnehmen könnte.';
        case 'no_place':
          return 'In diesem Raum ist kein Platz frei.';
        case 'drop':
          return `Es wurde keine Kiste abgestellt: ${objection.reason}.`;
        case 'door':
          return `Die Tür „${objection.name}“ bleibt, wie sie ist: ${objection.reason}.`;
        case 'person':
          return `Niemand kam: ${objection.reason}.`;
        case 'carry':
          return `Der Roboter bleibt, wo er ist: ${objection.reason}.`;
      }
    },
  },

  /** The ways into the editor of buildings, whose own words are loaded with it. */
  drafts: {
    open: 'Bauen',
    openHint: 'Das Gebäude oder ein neues zeichnen: Wände, Kisten, Türen, Räume, den Start und Routen (U)',
    edit: { name: 'Gebäude bearbeiten', hint: 'das, in dem der Roboter ist, wie es jetzt ist' },
    blank: { name: 'Neues Gebäude', hint: 'ein leeres Blatt mit einem Start' },
    ofLog: 'Zu einer Aufzeichnung gibt es kein Gebäude zu bearbeiten. Zeichnen Sie ein neues.',
    offer: (name: string, when: number) => `Weiterzeichnen? ${name}, verlassen am ${day(when)}.`,
    goOn: 'Weiterzeichnen',
    loading: 'Der Editor wird geöffnet …',
    notLoaded: 'Der Editor ließ sich nicht laden. Laden Sie die Seite neu und versuchen Sie es noch einmal: Nichts ist verloren.',
  },

  /** What was changed around the robot. */
  changed: {
    door_opened: 'Eine Tür wurde geöffnet',
    door_shut: 'Eine Tür wurde geschlossen',
    box_dropped: 'Eine Kiste wurde abgestellt',
    box_moved: 'Eine Kiste wurde verschoben',
    box_removed: 'Eine Kiste wurde weggenommen',
    somebody_came: 'Jemand kam herein',
    noise_changed: 'Die Fehler des Roboters wurden geändert',
  } satisfies Record<Changed, string>,
} as const;
