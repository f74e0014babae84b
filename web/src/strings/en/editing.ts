import type { Kind } from '../../editor/things';
import type { Catch } from '../../editor/snapping';
import type { ToolName } from '../../editor/tools';
import type { Thing } from '../../wasm/cogmap_wasm';
import { count, number } from '../words';

const metres = (long: number) => `${number(long, long % 0.1 < 0.001 || long % 0.1 > 0.099 ? 1 : 2)} m`;
const quoted = (name: string) => (name.trim() === '' ? 'without a name' : `“${name}”`);

const KINDS: Record<Kind, string> = {
  wall: 'Wall',
  box: 'Box',
  post: 'Post',
  door: 'Door',
  person: 'Person',
  start: 'Start',
  route: 'Route',
  room: 'Room',
};

/** The place of a file that a message speaks of, as the editor calls it: it counts from 1. */
const LISTS: [RegExp, string][] = [
  [/\bboxes\[(\d+)\]/g, 'box'],
  [/\bposts\[(\d+)\]/g, 'post'],
  [/\bwalls\[(\d+)\]/g, 'wall'],
  [/\bdoors\[(\d+)\]/g, 'door'],
];

/** The editor of buildings; loaded with it. */
export const editing = {
  title: 'Drawing a building',
  back: 'Back',
  backHint: 'Back to the run; what is drawn is kept',
  save: 'Save the world',
  saveHint: 'Save it as a world file, which the page and the command line open',
  drive: 'Drive here',
  driveHint: 'Begin a run in this building, with the robot, mappers and seed chosen',
  undo: 'Undo',
  redo: 'Redo',
  zoomIn: 'Zoom in',
  zoomOut: 'Zoom out',
  fit: 'Show everything',
  snap: 'Snap',
  snapHint: 'Draw points to corners, walls, right angles and the grid of 0.1 m (G); hold Alt to leave it out',
  preparing: 'Laying out the sheet…',
  refused: (reason: string) => `The building could not be opened. ${reason}`,
  stopped: 'The editor’s engine stopped unexpectedly. Go back and open the building again: nothing is lost.',

  toolsTitle: 'Tools',
  tools: {
    select: 'Select',
    wall: 'Wall',
    box: 'Box',
    post: 'Post',
    door: 'Door',
    room: 'Room',
    start: 'Start',
    route: 'Route',
    person: 'Person',
  } satisfies Record<ToolName, string>,
  hints: {
    select: 'Click something to select it, drag it to move it. Drag the floor to look elsewhere.',
    wall: 'Click corner by corner. A double click or Enter ends the wall.',
    box: 'Drag from corner to corner.',
    post: 'Click where a leg or a pillar stands.',
    door: 'Drag from the hinge to the latch. It opens counter-clockwise.',
    room: 'Click round the room, corner by corner. A double click or Enter ends it.',
    start: 'Press where the robot is to begin, drag to where it looks.',
    route: 'Click point by point where the robot is to go. A double click or Enter ends it.',
    person: 'Click point by point where somebody walks to and fro. A double click or Enter ends it.',
  } satisfies Record<ToolName, string>,
  going: (points: number, of: number) =>
    of === 2
      ? 'Now the other end. Esc abandons it.'
      : `${count(points, 'point', 'points')}. A double click or Enter ends it, Esc abandons it.`,
  done: 'Done',
  abandon: 'Abandon',
  moving: 'Arrow keys move it, Enter sets it down, Esc puts it back.',

  sheet: 'The sheet',
  sheetHint:
    'Arrow keys move the cursor by 0.1 m, with Shift by 1 m, with Alt by 1 cm; Enter places a point or selects what is there. V, W, B, P, D, R, S and T choose a tool.',
  cursor: (x: number, y: number, on: string | undefined) =>
    `${number(x, 2)}, ${number(y, 2)} m${on === undefined ? '' : `, ${on}`}`,
  snapped: { corner: 'corner', wall: 'wall', angle: 'right angle', grid: 'grid' } satisfies Record<Catch, string>,

  panel: 'What is drawn',
  building: 'Building',
  name: 'Name',
  description: 'Description',
  selected: 'Selected',
  nothing: 'nothing',
  none: 'Select something to see its numbers and to change them.',
  fields: {
    x: 'x, m',
    y: 'y, m',
    length: 'Length, m',
    width: 'Width, m',
    heading: 'Heading, °',
    radius: 'Radius, m',
    speed: 'Speed, m/s',
    hinge: 'Hinge',
    latch: 'Latch',
    open: 'Open at first',
    corner: (nth: number) => `Corner ${nth}`,
    point: (nth: number) => `Point ${nth}`,
  },
  takeCorner: (nth: number) => `Take out point ${nth}`,
  addCorner: 'Add a point',
  duplicate: 'Duplicate',
  remove: 'Delete',
  kinds: KINDS,
  stems: { door: 'door', room: 'room', route: 'route' },
  copyOf: (name: string) => `${name} copy`,
  newName: 'New building',

  checks: 'Check',
  sound: 'Everything is in order: it can be driven in and saved.',
  checking: 'Looking it through…',
  faults: (faults: number) => `${count(faults, 'thing', 'things')} to put right first:`,
  remarks: 'Worth a look:',
  first: 'Put right first what the check lists.',
  message: (message: string) => LISTS.reduce((text, [list, word]) => text.replace(list, (_, index) => `${word} ${Number(index) + 1}`), message),

  keysTitle: 'Keys',
  keys: [
    { keys: ['V', 'W', 'B', 'P', 'D', 'R', 'S', 'T', 'N'], does: 'select, wall, box, post, door, room, start, route, person' },
    { keys: ['↑ ↓ ← →'], does: 'move the cursor by 0.1 m (Shift 1 m, Alt 1 cm)' },
    { keys: ['Enter'], does: 'place a point, end at the last one, select or take up what is there' },
    { keys: ['Esc'], does: 'abandon, put back, select nothing' },
    { keys: ['Delete', 'Ctrl D'], does: 'delete, duplicate' },
    { keys: ['Ctrl Z', 'Ctrl Shift Z'], does: 'undo, redo' },
    { keys: ['G', 'Alt'], does: 'snapping on or off; hold to leave it out' },
    { keys: ['+', '−', '0'], does: 'zoom in, zoom out, show everything' },
    { keys: ['Space'], does: 'hold it and drag to look elsewhere' },
    { keys: ['?'], does: 'this list' },
  ],

  /** What a thing is called; `nth` of its kind. */
  called: (thing: Thing, nth: number) => {
    if (thing.kind === 'start') return KINDS.start;
    return 'name' in thing ? `${KINDS[thing.kind]} ${quoted(thing.name)}` : `${KINDS[thing.kind]} ${nth}`;
  },
  /** The same at one of its points. */
  at: (called: string, thing: Thing, point: number) => {
    if (thing.kind === 'door') return `${called}, ${point === 0 ? 'hinge' : 'latch'}`;
    return 'points' in thing ? `${called}, point ${point + 1}` : called;
  },

  /** What happened, for the one line that tells it. */
  said: {
    wall: (corners: number, long: number) => `Wall of ${count(corners, 'corner', 'corners')}, ${metres(long)} long, added.`,
    box: (long: number, wide: number) => `Box of ${metres(long)} by ${metres(wide)} added.`,
    post: (x: number, y: number) => `Post added at ${number(x, 2)}, ${number(y, 2)}.`,
    door: (name: string, wide: number) => `Door ${quoted(name)}, ${metres(wide)} wide, added.`,
    room: (name: string, corners: number, large: number) =>
      `Room ${quoted(name)} of ${count(corners, 'corner', 'corners')}, ${number(large, 1)} m², added.`,
    start: (x: number, y: number, heading: number) =>
      `The robot begins at ${number(x, 2)}, ${number(y, 2)}, looking to ${number(heading, 0)}°.`,
    route: (name: string, points: number) => `Route ${quoted(name)} through ${count(points, 'point', 'points')} added.`,
    person: (long: number) => `Somebody who walks ${metres(long)} to and fro added.`,
    point: (nth: number, x: number, y: number) => `Point ${nth} at ${number(x, 2)}, ${number(y, 2)}.`,
    pointTaken: (left: number) => `The last point is taken back, ${left} left.`,
    tooFew: (least: number) => `That takes at least ${least} points.`,
    tooSmall: 'That is too small: draw it larger.',
    abandoned: 'Abandoned.',
    putBack: 'Put back.',
    tool: (name: string, hint: string) => `${name}. ${hint}`,
    selected: (called: string) => `${called} selected.`,
    nothingThere: 'Nothing is there.',
    taken: (called: string) => `${called} taken up.`,
    changed: (called: string) => `${called} changed.`,
    moved: (called: string) => `${called} moved.`,
    removed: (called: string) => `${called} deleted.`,
    keepsStart: 'Every building needs a start: move it instead.',
    duplicated: (called: string) => `${called} is the copy.`,
    undone: 'Undone.',
    redone: 'Redone.',
    nothingToUndo: 'Nothing is left to undo.',
    nothingToRedo: 'Nothing is left to redo.',
    snapping: (on: boolean) => (on ? 'Points snap.' : 'Points do not snap.'),
    saved: (file: string) => `Saved as ${file}.`,
    opened: (name: string) => `${name} is on the sheet.`,
    over: (name: string) => `${name} is on the sheet. What was drawn before comes back with Undo.`,
  },
} as const;
