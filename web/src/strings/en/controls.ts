import type { Clause, Followed, HomingStatus } from '../../wasm/cogmap_wasm';
import { moment, number, said, whole } from '../words';

/** What each way of going home is, and whose idea. */
const STRATEGIES: Record<string, string> = {
  recommended: 'Ours: plans a way through what it remembers and what it hopes to be free',
  faithful: 'The thesis to the letter: through the opening that leads straightest home, zigzags and traps included',
  retrace: 'For comparison: back the way it came, waypoint by waypoint; the thesis rejects it',
  'tangent-bug': 'For comparison, from the literature: straight ahead, and round whatever is in the way',
  oracle: 'For comparison: the shortest way, by somebody who sees the building as it is',
};

/** What a run is made of and told. */
export const controls = {
  setup: {
    title: 'Set-up',
    world: 'World',
    groups: {
      everyday: 'Everyday buildings',
      home: 'Made for finding home',
      thesis: 'Long loops, as in the thesis',
      schematic: 'To show one thing',
      generated: 'Made from a number',
    },
    /** What a world is called where that is not what its file says. */
    names: {} as Readonly<Record<string, string>>,
    /** What is worth knowing about it, likewise. */
    about: {} as Readonly<Record<string, string>>,
    generated: 'A new building',
    generatedHint: 'An office floor that nobody drew: corridors, rooms, doors and furniture come from its number.',
    building: 'Number',
    buildingHint: 'Each number is another office floor, and always the same one',
    robot: 'Robot',
    seed: 'Seed',
  },

  homing: {
    title: 'Way home',
    go: 'Go Home',
    going: 'Going home…',
    goHint: 'Let the robot find the way back to where it began, alone',
    strategy: (name: string) => `How it finds the way: ${name}`,
    about: (name: string) => STRATEGIES[name] ?? `As ${name} does it`,
    because: (clauses: Clause[]) => `${said(clauses)}.`,
    looking: 'Told to go home, it comes to rest and looks first.',
    leads: {
      direction: 'By its sense of direction:',
      route: 'Along the remembered route:',
      planning: 'By a plan:',
    },
    ended: ({ ended, distance, believed, why }: HomingStatus) => {
      const off = `${number(distance, 2)} m from where it began`;
      switch (ended) {
        case 'home':
          return `Home: it stopped by itself ${off}${believed === undefined ? '' : `; it believes ${number(believed, 2)} m`}.`;
        case 'stuck':
          return `It gave up, ${off}: ${why ?? 'it had seen nothing'}.`;
        case 'stopped':
          return `You took over ${off}.`;
        case undefined:
          return '';
      }
    },
  },

  log: {
    mapping: (name: string, done: number, all: number) =>
      `Mapping ${name}: ${whole(done)} of ${whole(all)} scans`,
    cancel: 'Cancel',
  },

  transport: {
    title: 'Time',
    restart: 'Start over',
    play: 'Play',
    pause: 'Pause',
    next: 'Next view',
    finish: 'To the end',
    finishHint: 'Go on at once to where the robot has done what it was told',
    timeline: 'Timeline',
    marks: 'Events',
    mark: (moment: string, said: string) => `${moment}: ${said}`,
    moment,
    undo: 'Undo',
    redo: 'Redo',
    branch: (others: number) => `Other branch (${others})`,
    branchHint: 'Go over to what would have happened had you not gone on otherwise',
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
    stick: 'Push the stick to where the robot should go; let go to stop',
  },

  /** A way that is drawn for the robot to follow. */
  way: {
    open: 'Draw a way',
    openHint: 'Draw into the world where the robot is to go (Q). By keyboard: the arrow keys drive it step by step',
    ofLog: 'A recorded log has no robot that could be sent anywhere',
    hint: 'Draw where the robot is to go; a click sends it straight there. The arrow keys do without a pointer.',
    said: (followed: Followed) => {
      switch (followed.kind) {
        case 'going':
          return `On its way: ${number(followed.metres, 1)} m${followed.around ? ', around what is in the way' : ''}.`;
        case 'no_room':
          return 'The robot stays: nowhere along that line is there room for it.';
        case 'unreachable':
          return 'The robot stays: a part of that line cannot be reached from here.';
        case 'no_line':
          return 'The robot stays: that line does not lead away from it.';
        case 'no_building':
          return 'A recorded log has no robot that could be sent anywhere.';
      }
    },
  },

  gamepad: {
    name: 'Gamepad',
    found: 'Gamepad found: its left stick or cross drives, A goes home, B stops, Start plays and pauses.',
  },

  invitation: {
    title: 'Take the controls',
    withKeys: 'press an arrow key',
    withTouch: 'tap anywhere in the world',
  },

  theme: { dark: 'Switch to dark', light: 'Switch to light' },
  language: 'Language',
} as const;
