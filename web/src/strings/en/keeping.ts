import { day, moment, whole } from '../words';

/** What is opened, saved, shared and kept. */
export const keeping = {
  files: {
    open: 'Open…',
    openHint: 'Open a recorded log (CARMEN), a session, a world or a floor plan (PNG or PGM, also with its map_server YAML). Dropping a file on the page does the same.',
    save: 'Save, share',
    link: { name: 'Copy link', hint: 'opening it gives exactly this moment of this run' },
    picture: { name: 'Picture', hint: 'the world and the memories with their legends, as a PNG' },
    drawing: { name: 'Drawing', hint: 'the same as an SVG, to be enlarged, edited or printed' },
    session: { name: 'Session', hint: 'opening it gives exactly this run again' },
    map: {
      name: 'Map',
      of: (mapper: string) => `Map by ${mapper}`,
      hint: 'surfaces, exits, local spaces and the path, as JSON',
    },
    table: { name: 'Table', hint: 'where the robot was and where it believed to be, view by view, as CSV' },
    everything: { name: 'Everything', hint: 'session, maps, drawing, table, trajectories (TUM) and pose graphs (g2o), in a ZIP archive' },
    drop: 'Drop it here',
    dropHint: 'A recorded log (CARMEN, gzipped or not), a session, a world or a floor plan (PNG, PGM)',
    reading: (name: string) => `Reading ${name}…`,
    refused: (reason: string) => `That did not work. ${reason}`,
    tooMany: (number: number) => `These are ${number} files. Bring one, or two that belong together: a session with its log, or a floor plan’s picture with its YAML.`,
    dismiss: 'Dismiss',
  },

  link: {
    name: 'The link',
    label: 'Link',
    copied: 'The link to exactly this moment is copied: paste it wherever you like.',
    byHand: 'Your browser does not let the page copy. This is the link to exactly this moment:',
    tooLong: (length: number) =>
      `This run is too long for a link: it would have ${whole(length)} characters, and many programs cut such a link off. Save the session as a file and send that.`,
    ofLog: 'A recorded log does not fit into a link. Save the session and send it together with the log.',
    saveSession: 'Save session',
    refused: (reason: string) => `The link could not be opened. ${reason}\nThe page shows its usual first scene instead.`,
    broken: 'It is damaged: something is missing from it or was changed on the way. Ask for it anew, or for the session file.',
    huge: 'It holds far more than any link of this page does, so it was not unpacked.',
    version: 'It was made by another version of this page, which writes links otherwise. Open it with that version.',
  },

  kept: {
    name: 'The kept run',
    offer: ({ name, time, when }: { name: string; time: number; when: number }) =>
      `Go on where you were? ${name}, ${moment(time)} into the run, left ${day(when)}.`,
    takeUp: 'Go on',
    refused: (reason: string) => `The run that was kept cannot be taken up again. ${reason}`,
    recovered:
      'The laboratory’s engine stopped unexpectedly. It was started anew, and your run was taken up where it was.',
    startedOver: 'The laboratory’s engine stopped unexpectedly. It was started anew, and the run with it.',
  },

  address: {
    world: (name: string, known: string[]) =>
      `There is no world called “${name}” here. Those that there are: ${known.join(', ')}.`,
    number: (key: string, written: string) =>
      `“${written}” is no ${key}: it takes a whole number, as in ${key}=7.`,
    mappers: (unknown: string[], known: string[]) =>
      `There is no mapper called ${unknown.map((name) => `“${name}”`).join(' or ')}. Those that there are: ${known.join(', ')}; up to four can stand side by side, as in mappers=consensus,odometry.`,
  },

  embed: { whole: 'Open the whole page' },
} as const;
