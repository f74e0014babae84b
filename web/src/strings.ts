/** Every word on the page. Nothing else under `src` holds text for people. */
export const strings = {
  name: 'Cogmap',
  tagline: 'What a robot remembers of a building',
  preparing: 'Preparing the laboratory…',
  failed: (reason: string) => `The laboratory could not start: ${reason}`,

  setup: {
    title: 'Set-up',
    world: 'World',
    robot: 'Robot',
    mapper: 'Mapper',
    seed: 'Seed',
  },

  files: {
    open: 'Open…',
    openHint: 'Open a recorded log (CARMEN), a session or a world. Dropping a file on the page does the same.',
    save: 'Save',
    picture: { name: 'Picture', hint: 'both views with their legends, as a PNG' },
    session: { name: 'Session', hint: 'opening it gives exactly this run again' },
    map: { name: 'Map', hint: 'every surface and the path, as JSON' },
    drop: 'Drop it here',
    dropHint: 'A recorded log (CARMEN, gzipped or not), a session or a world',
    reading: (name: string) => `Reading ${name}…`,
    refused: (reason: string) => `That did not work. ${reason}`,
    dismiss: 'Dismiss',
  },

  world: {
    title: 'The world',
    subtitle: 'as it is',
    picture:
      'The building seen from above, with the robot, its laser and the way it went. Click on a point to send the robot there.',
  },
  memory: {
    title: 'The robot’s memory',
    subtitle: 'as it believes',
    picture:
      'The map in the robot’s memory: every surface drawn where it was placed when it was first seen, coloured by the view that first saw it.',
  },
  rival: {
    title: (mapper: string) => `The same log by ${mapper}`,
    subtitle: 'for comparison',
    picture: 'What another mapper makes of the same recorded log.',
  },

  facts: {
    travelled: (metres: number) => `${metres.toFixed(1)} m driven`,
    collisions: (count: number) => (count === 1 ? '1 bump' : `${count} bumps`),
    memory: (surfaces: number, views: number) =>
      `${count(surfaces, 'surface', 'surfaces')} from ${count(views, 'view', 'views')}`,
    off: (metres: number, degrees: number) => `off by ${metres.toFixed(2)} m, ${Math.round(degrees)}°`,
    offHint: 'How far the robot is from where it believes it is',
  },

  story: {
    waiting: 'Nothing has been seen yet.',
    view: (step: number, seen: number, recognised: number) =>
      `View ${step}: ${count(seen, 'surface', 'surfaces')} seen, ${recognised} recognised`,
    first: 'the first view lays down the map’s frame',
    reference: (known: number) => `reference: surface ${known}`,
    weak_reference: (known: number) => `reference: surface ${known}, its place along the wall a guess`,
    consensus: 'all of them together say where the robot is',
    partly_odometry: 'they leave a direction open, where odometry decides',
    transform: 'the movement corrected until the views fit',
    odometry: 'placed by odometry',
    placed: (surfaces: number) =>
      surfaces === 0 ? 'nothing new' : `${count(surfaces, 'new surface', 'new surfaces')} placed`,
    label: 'What the robot just did',
  },

  log: {
    mapping: (name: string, done: number, all: number) =>
      `Mapping ${name}: ${done.toLocaleString('en')} of ${all.toLocaleString('en')} scans`,
    cancel: 'Cancel',
  },

  transport: {
    title: 'Time',
    restart: 'Start over',
    play: 'Play',
    pause: 'Pause',
    next: 'Next view',
    timeline: 'Timeline',
    moment: (seconds: number) => `${Math.floor(seconds / 60)}:${(seconds % 60).toFixed(1).padStart(4, '0')}`,
    speed: 'Speed',
    times: (factor: number) => `${factor}×`,
    full: 'Max',
  },

  drive: {
    title: 'Drive',
    ahead: 'Drive ahead',
    back: 'Drive back',
    left: 'Turn left',
    right: 'Turn right',
    stop: 'Stop',
  },

  invitation: {
    title: 'Take the controls',
    withKeys: 'press an arrow key',
    withTouch: 'tap anywhere in the world',
  },

  truth: 'Lay the truth over the memory',

  zoom: { title: 'Zoom', in: 'Zoom in', out: 'Zoom out', fit: 'Show everything' },

  theme: { dark: 'Switch to dark', light: 'Switch to light' },

  help: {
    open: 'Keyboard shortcuts',
    title: 'How to use the laboratory',
    intro:
      'On the left the building as it is; on the right the robot’s memory of it, put together from what its laser sees. Its odometry is wrong, and nothing ever tells it the truth.',
    pointing:
      'Click or tap in the world to send the robot there: it turns, drives straight and takes a view. Drag to move both views, scroll or pinch to zoom.',
    keys: 'Keys',
    single: 'Use single-letter shortcuts',
    close: 'Close',
    list: [
      { keys: ['↑ ↓ ← →', 'W A S D'], does: 'drive and turn' },
      { keys: ['Space'], does: 'play or pause' },
      { keys: ['.'], does: 'go on to the next view' },
      { keys: ['X'], does: 'stop the robot' },
      { keys: ['R'], does: 'start over' },
      { keys: ['[', ']'], does: 'slower, faster' },
      { keys: ['+', '−', '0'], does: 'zoom in, zoom out, show everything' },
      { keys: ['O'], does: 'lay the truth over the memory' },
      { keys: ['T'], does: 'light or dark' },
      { keys: ['Esc'], does: 'close what is open, or cancel a log' },
      { keys: ['?'], does: 'this list' },
    ],
  },
} as const;

function count(number: number, one: string, many: string): string {
  return `${number.toLocaleString('en')} ${number === 1 ? one : many}`;
}
