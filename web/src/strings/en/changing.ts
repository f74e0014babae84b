import type { Changed, Objection } from '../../wasm/cogmap_wasm';
import { day, plain } from '../words';

/** What is changed in a building while the robot is in it. */
export const changing = {
  changing: {
    open: 'Change',
    openHint: 'Change the building while the robot is in it: doors, boxes, people, the robot’s errors, where it stands (B)',
    ofLog: 'A recorded log has no building that could be changed',
    title: 'Change the building',
    close: 'Close',
    toolsTitle: 'What to change',
    tools: { door: 'Door', drop: 'Drop a box', remove: 'Take away', carry: 'Carry off', person: 'Somebody', noise: 'Noise' },
    hints: {
      door: 'Click a door to shut or open it.',
      drop: 'Click where a box is to stand.',
      remove: 'Click the box or the furniture to take away.',
      carry: 'Click where to set the robot down. Its odometry will not notice.',
      person: 'Click where somebody is to come and walk to and fro.',
      noise: '1 × is the robot’s own. It holds from now on; the maps are not told.',
    },
    noDoors: 'This building has no doors.',
    noBoxes: 'Nothing stands here that could be taken away.',
    which: 'Which door',
    door: (name: string, open: boolean) => `${name} (${open ? 'open' : 'shut'})`,
    swing: (open: boolean) => (open ? 'Shut it' : 'Open it'),
    ahead: '1 m ahead',
    aheadHint: 'Drop it 1 m ahead of the robot',
    nearest: 'The nearest',
    nearestHint: 'Take away what is nearest to the robot',
    come: '2 m ahead',
    comeHint: 'Lets somebody come 2 m ahead of the robot',
    noise: { odometry: 'odometry', laser: 'laser' },
    noiseHints: {
      odometry: 'How wrong the wheels count, in multiples of the robot’s own errors',
      laser: 'How much the ranges scatter, in multiples of the laser’s own errors',
    },
    times: (times: number) => `${plain(times)} ×`,
    where: 'Where to',
    start: 'Where it began',
    setDown: 'Set it down',
    objection: (objection: Objection) => {
      switch (objection.kind) {
        case 'no_building':
          return 'A recorded log has no building that could be changed.';
        case 'no_door':
          return 'There is no door there.';
        case 'no_box':
          return 'Nothing stands there that could be taken away.';
        case 'no_place':
          return 'No place in that room is free.';
        case 'drop':
          return `No box was dropped: ${objection.reason}.`;
        case 'door':
          return `The door “${objection.name}” stays as it is: ${objection.reason}.`;
        case 'person':
          return `Nobody came: ${objection.reason}.`;
        case 'carry':
          return `The robot stays where it is: ${objection.reason}.`;
      }
    },
  },

  /** The ways into the editor of buildings, whose own words are loaded with it. */
  drafts: {
    open: 'Build',
    openHint: 'Draw the building, or a new one: walls, boxes, doors, rooms, the start and routes (U)',
    edit: { name: 'Edit the building', hint: 'the one that the robot is in, as it is now' },
    blank: { name: 'New building', hint: 'an empty sheet with a start' },
    ofLog: 'A recorded log has no building that could be edited. Draw a new one instead.',
    offer: (name: string, when: number) =>
      `Go on drawing? ${name}, left ${day(when)}.`,
    goOn: 'Go on drawing',
    loading: 'Opening the editor…',
    notLoaded: 'The editor could not be loaded. Reload the page and try again: nothing is lost.',
  },

  /** What was changed around the robot. */
  changed: {
    door_opened: 'A door was opened',
    door_shut: 'A door was shut',
    box_dropped: 'A box was set down',
    box_moved: 'A box was moved',
    box_removed: 'A box was taken away',
    somebody_came: 'Somebody came',
    noise_changed: 'The robot’s errors were changed',
  } satisfies Record<Changed, string>,
} as const;
