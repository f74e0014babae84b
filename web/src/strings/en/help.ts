/** How to use the page. */
export const help = {
  open: 'Keyboard shortcuts',
  title: 'How to use the laboratory',
  intro:
    'On the left the building as it is; on the right the robot’s memory of it, put together from what its laser sees. Its odometry is wrong, and nothing ever tells it the truth.',
  pointing:
    'Click or tap in the world to send the robot there: it turns, drives straight and takes a view. Drag to move all views, scroll or pinch to zoom.',
  gamepad:
    'A gamepad is found once you press one of its buttons: the left stick or the cross drives, A goes home, B stops, Start plays and pauses.',
  keys: 'Keys',
  single: 'Use single-letter shortcuts',
  close: 'Close',
  list: [
    { keys: ['↑ ↓ ← →', 'W A S D'], does: 'drive and turn' },
    { keys: ['Space'], does: 'play or pause' },
    { keys: ['.'], does: 'go on to the next view' },
    { keys: ['F'], does: 'go on at once to where the robot has done what it was told' },
    { keys: ['H'], does: 'go home' },
    { keys: ['X'], does: 'stop the robot' },
    { keys: ['R'], does: 'start over' },
    { keys: ['[', ']'], does: 'slower, faster' },
    { keys: ['+', '−', '0'], does: 'zoom in, zoom out, show everything' },
    { keys: ['C'], does: 'colour by view, local space or age' },
    { keys: ['G'], does: 'see the memories from outside, from the robot, from the entrance' },
    { keys: ['E', 'N', 'P', 'O'], does: 'show exits, the network, plans, the truth' },
    { keys: ['<', '>'], does: 'to the event before, to the next event' },
    { keys: ['Ctrl Z', 'Ctrl Shift Z'], does: 'undo what you told the robot or changed, and redo it' },
    { keys: ['B'], does: 'change the building: doors, boxes, people, errors, where the robot stands' },
    { keys: ['U'], does: 'edit the building, or draw a new one' },
    { keys: ['V'], does: 'over to the other branch' },
    { keys: ['Y'], does: 'why? Take the latest step apart' },
    { keys: ['J', 'K'], does: 'stage before, next stage of that step' },
    { keys: ['L'], does: 'plots: wideness, errors and surfaces along the run, and the places as a schematic' },
    { keys: ['T'], does: 'light or dark' },
    { keys: ['Esc'], does: 'close what is open, or cancel a log' },
    { keys: ['?'], does: 'this list' },
  ],
} as const;
