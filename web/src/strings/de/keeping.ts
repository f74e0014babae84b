import { day, moment, whole } from '../words';

/** What is opened, saved, shared and kept. */
export const keeping = {
  files: {
    open: 'Öffnen …',
    openHint: 'Eine Aufzeichnung (CARMEN), eine Sitzung, eine Welt oder einen Grundriss (PNG oder PGM, auch mit seiner map_server-YAML) öffnen. Eine Datei auf die Seite zu ziehen wirkt ebenso.',
    save: 'Sichern, teilen',
    link: { name: 'Link kopieren', hint: 'öffnet genau diesen Augenblick dieser Fahrt' },
    picture: { name: 'Bild', hint: 'die Welt und die Gedächtnisse mit ihren Legenden, als PNG' },
    drawing: { name: 'Zeichnung', hint: 'dasselbe als SVG, zum Vergrößern, Bearbeiten oder Drucken' },
    session: { name: 'Sitzung', hint: 'öffnet wieder genau diese Fahrt' },
    map: {
      name: 'Karte',
      of: (mapper: string) => `Karte nach ${mapper}`,
      hint: 'Flächen, Ausgänge, lokale Räume und der Weg, als JSON',
    },
    table: { name: 'Tabelle', hint: 'wo der Roboter war und wo er zu sein glaubte, Ansicht für Ansicht, als CSV' },
    everything: { name: 'Alles', hint: 'Sitzung, Karten, Zeichnung, Tabelle, Bahnen (TUM) und Posengraphen (g2o) in einem ZIP-Archiv' },
    drop: 'Hier ablegen',
    dropHint: 'Eine Aufzeichnung (CARMEN, auch gezippt), eine Sitzung, eine Welt oder ein Grundriss (PNG, PGM)',
    reading: (name: string) => `${name} wird gelesen …`,
    refused: (reason: string) => `Das ging nicht. ${reason}`,
    tooMany: (number: number) => `Das sind ${number} Dateien. Es geht eine, oder zwei, die zusammengehören: eine Sitzung mit ihrer Aufzeichnung oder das Bild eines Grundrisses mit seiner YAML-Datei.`,
    dismiss: 'Schließen',
  },

  link: {
    name: 'Der Link',
    label: 'Link',
    copied: 'Der Link zu genau diesem Augenblick ist kopiert: Fügen Sie ihn ein, wo Sie wollen.',
    byHand: 'Ihr Browser lässt die Seite nicht kopieren. Dies ist der Link zu genau diesem Augenblick:',
    tooLong: (length: number) =>
      `Diese Fahrt ist zu lang für einen Link: Er hätte ${whole(length)} Zeichen, und viele Programme schneiden so einen Link ab. Sichern Sie die Sitzung als Datei und verschicken Sie die.`,
    ofLog: 'Eine Aufzeichnung passt nicht in einen Link. Sichern Sie die Sitzung und verschicken Sie sie mit der Aufzeichnung.',
    saveSession: 'Sitzung sichern',
    refused: (reason: string) => `Der Link ließ sich nicht öffnen. ${reason}\nDie Seite zeigt stattdessen, womit sie sonst beginnt.`,
    broken: 'Er ist beschädigt: Etwas fehlt oder wurde unterwegs verändert. Bitten Sie noch einmal um ihn oder um die Sitzungsdatei.',
    huge: 'Er enthält weit mehr als jeder Link dieser Seite und wurde deshalb nicht ausgepackt.',
    version: 'Er stammt von einer anderen Version dieser Seite, die Links anders schreibt. Öffnen Sie ihn mit jener.',
  },

  kept: {
    name: 'Die aufbewahrte Fahrt',
    offer: ({ name, time, when }: { name: string; time: number; when: number }) =>
      `Dort weitermachen, wo Sie waren? ${name}, ${moment(time)} nach Beginn, verlassen am ${day(when)}.`,
    takeUp: 'Weitermachen',
    refused: (reason: string) => `Die aufbewahrte Fahrt lässt sich nicht wieder aufnehmen. ${reason}`,
    recovered:
      'Die Rechenmaschine des Labors blieb unerwartet stehen. Sie wurde neu gestartet und Ihre Fahrt dort wieder aufgenommen, wo sie war.',
    startedOver: 'Die Rechenmaschine des Labors blieb unerwartet stehen. Sie wurde neu gestartet, und die Fahrt mit ihr.',
  },

  address: {
    world: (name: string, known: string[]) =>
      `Eine Welt namens „${name}“ gibt es hier nicht. Es gibt: ${known.join(', ')}.`,
    number: (key: string, written: string) =>
      `„${written}“ taugt nicht für ${key}: Es braucht eine ganze Zahl, wie in ${key}=7.`,
    mappers: (unknown: string[], known: string[]) =>
      `Ein Verfahren namens ${unknown.map((name) => `„${name}“`).join(' oder ')} gibt es nicht. Es gibt: ${known.join(', ')}; bis zu vier stehen nebeneinander, wie in mappers=consensus,odometry.`,
  },

  embed: { whole: 'Die ganze Seite öffnen' },
} as const;
