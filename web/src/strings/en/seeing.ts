import type { Happening } from '../../wasm/cogmap_wasm';
import { changing } from './changing';
import { count, number } from '../words';

/** What each mapper is, in a line. */
const MAPPERS: Record<string, string> = {
  perceptual: 'Yeap’s perceptual mapping as the thesis programs it, flaws and all',
  consensus: 'Ours: all recognised surfaces together say where the robot is',
  transform: 'The traditional way: views put together by a corrected movement',
  odometry: 'Views put together by what the wheels say, uncorrected',
};

/** What is seen of the world and of the memories, and what is said about it. */
export const seeing = {
  world: {
    title: 'The world',
    subtitle: 'as it is',
    picture:
      'The building seen from above, with the robot, its laser and the way it went. Click on a point to send the robot there.',
  },

  memory: {
    title: 'The robot’s memory',
    subtitle: (mapper: string | undefined) => (mapper === undefined ? 'as it believes' : `by ${mapper}`),
    picture:
      'The map in the robot’s memory: every surface drawn where it was placed when it was first seen, the exits between local spaces, and the network that they make.',
  },

  wheels: {
    title: 'The log',
    subtitle: 'by its odometry alone',
    picture: 'The way that the robot’s wheels counted, which the mappers correct.',
  },

  shown: {
    views: 'Show',
    world: 'world',
    mapper: (name: string) => MAPPERS[name] ?? `What ${name} makes of the same run`,
    layers: 'In the memories',
    colours: 'Colour by',
    by: { view: 'view', asr: 'local space', age: 'age' },
    stance: 'Seen from',
    stanceHint:
      'From outside the map stands still; from the robot or from where it entered this local space, that stands still and looks up',
    from: { map: 'outside', robot: 'the robot', entrance: 'the entrance' },
    exits: 'exits',
    exitsHint: 'The narrow places between local spaces, found after the robot went through',
    network: 'network',
    networkHint: 'Local spaces by number, and the ways through exits that join them',
    homing: 'plans',
    homingHint: 'What the robot has in mind on its way home: where it could go, where it goes, and what it no longer goes by',
    truth: 'truth',
    truthHint: 'Lay the world over the memories',
    fit: 'laid by',
    fits: { first_view: 'the first view', best_fit: 'best fit' },
    fitHint:
      'By the first view, what went wrong since is seen where it went wrong; by best fit, the whole path in memory lies as near to the true one as shifting and turning bring it',
  },

  facts: {
    travelled: (metres: number) => `${number(metres, 1)} m driven`,
    collisions: (count: number) => (count === 1 ? '1 bump' : `${count} bumps`),
    memory: ({ surfaces, views, asrs }: { surfaces: number; views: number; asrs: number | undefined }) => [
      `${count(surfaces, 'surface', 'surfaces')} from ${count(views, 'view', 'views')}`,
      ...(asrs === undefined ? [] : [count(asrs, 'local space', 'local spaces')]),
    ],
    off: (metres: number, degrees: number) => `off by ${number(metres, 2)} m, ${Math.round(degrees)}°`,
    home: (metres: number, believed: number | undefined) =>
      `home ${number(metres, 2)} m away${believed === undefined ? '' : `, it believes ${number(believed, 2)} m`}`,
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
    happened: 'What happened',
  },

  /** What happened in a mind; local spaces and exits bear the numbers that they have in the map. */
  happened: (what: Happening) => {
    switch (what.kind) {
      case 'exit':
        return `Went through exit ${what.exit} into local space ${what.asr}`;
      case 'new_asr':
        return `Local space ${what.asr} opened behind exit ${what.exit}`;
      case 'loop_closed':
        return `Back in local space ${what.asr}: a loop is closed`;
      case 'unseen':
        return 'Nothing in view was known: only odometry said where the robot was';
      case 'lost':
        return 'Lost: the robot is not where it believed to be, and begins a map of its own';
      case 'recognised':
        return 'Found: the robot recognised a place that it knew';
      case 'told_home':
        return 'Told to go home';
      case 'kidnapped':
        return 'Picked up and set down elsewhere';
      case 'world_changed':
        return changing.changed[what.change];
    }
  },

  by: (mapper: string, said: string) => `${mapper}: ${said}`,

  divider: {
    name: (view: string) => `Size of “${view}”`,
    share: (percent: number) => `${percent} % of the room`,
    folded: { first: 'folded away', others: 'all of the room' },
    hint: 'Drag to give one side more room, to the edge to fold it away; double-click for equal shares. Keys: arrows, Enter',
  },

  zoom: { title: 'Zoom', in: 'Zoom in', out: 'Zoom out', fit: 'Show everything' },
} as const;
