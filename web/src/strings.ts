import type { Happening, HomingStatus, PlacementKind, StageReport } from './wasm/cogmap_wasm';

/** What each mapper is, in a line. */
const MAPPERS: Record<string, string> = {
  perceptual: 'Yeap’s perceptual mapping as the thesis programs it, flaws and all',
  consensus: 'Ours: all recognised surfaces together say where the robot is',
  transform: 'The traditional way: views put together by a corrected movement',
  odometry: 'Views put together by what the wheels say, uncorrected',
};

/** What each way of going home is, and whose idea. */
const STRATEGIES: Record<string, string> = {
  recommended: 'Ours: plans a way through what it remembers and what it hopes to be free',
  faithful: 'The thesis to the letter: through the opening that leads straightest home, zigzags and traps included',
  retrace: 'For comparison: back the way it came, waypoint by waypoint; the thesis rejects it',
  'tangent-bug': 'For comparison, from the literature: straight ahead, and round whatever is in the way',
  oracle: 'For comparison: the shortest way, by somebody who sees the building as it is',
};

/** What a view was placed by, as the end of a sentence. */
const PLACED_BY: Record<PlacementKind, string> = {
  first: 'where the first view puts them: it lays down the map’s frame',
  reference: 'at the distance and angle to the reference at which they were seen',
  weak_reference: 'at the distance and angle to the reference at which they were seen',
  consensus: 'relative to all that was recognised',
  partly_odometry: 'relative to what was recognised, and by odometry in the direction left open',
  transform: 'where the corrected movement puts them',
  odometry: 'where odometry puts them',
};

/** A stage of a step in a sentence, in the thesis's terms. */
function stageSentence(stage: StageReport, mapper: string): string {
  switch (stage.kind) {
    case 'scan':
      return stage.beams === undefined
        ? 'The laser looked around the robot: a scan. The robot has looked again since.'
        : `The laser looked around the robot with ${stage.beams} beams: a scan.`;
    case 'surfaces':
      return `Points of the scan that lie in a line became ${count(stage.seen, 'surface', 'surfaces')}. Of the ends, ${stage.true_ends} are where a thing ends, ${stage.occluded} are hidden by something nearer, and ${stage.at_limit} are as far as the laser sees.`;
    case 'recognised': {
      const { length } = stage.pairs;
      if (length === 0) return 'None of them was recognised: nothing known lies where they were seen.';
      const byMap = stage.by_map === 0 ? '' : ` ${stage.by_map} of these only in the map, not in the view before.`;
      return `${length} of ${stage.seen} were recognised: they lie about where odometry, roughly, lets the robot expect known surfaces.${byMap}`;
    }
    case 'movement':
      if (stage.corrected) {
        const { turn_deg, travel, before, after, changes } = stage.corrected;
        return `The robot tried small changes of the measured movement and kept ${changes} that made the views fit better: it turned ${turn_deg.toFixed(1)}° and went ${travel.toFixed(2)} m otherwise than measured. The mean matching error went from ${before.toExponential(1)} to ${after.toExponential(1)}.`;
      }
      return mapper === 'odometry'
        ? 'This mapper takes the movement as the wheels counted it (odometry).'
        : 'No recognised surface says where the robot is, so this one view is placed by odometry, what the wheels counted.';
    case 'reference': {
      const { known, length, range, incidence_deg, along, crossing, candidates } = stage;
      const won = candidates.length === 1 ? 'There was no other candidate' : `It is the best of ${candidates.length} candidates`;
      const seen = `seen ${length.toFixed(2)} m long, ${range.toFixed(1)} m away and ${Math.round(incidence_deg)}° from square on`;
      const place = {
        end: 'One of its true ends fixes the place along it.',
        crossing: `Surface ${crossing ?? 0}, which crosses its line, fixes the place along it.`,
        guess: 'Nothing fixes the place along it, so that is a guess.',
      }[along];
      return `Surface ${known} became the reference target. ${won}: ${seen}. ${place}`;
    }
    case 'together':
      return `All ${stage.surfaces} recognised surfaces together say where the robot is; no single one is the reference.`;
    case 'open':
      return stage.along_deg === undefined
        ? 'They leave more than one direction, or the heading, open; there odometry decides.'
        : `They leave one direction open, as walls of a corridor do; along it odometry decides.`;
    case 'lost':
      return `${Math.round(100 * stage.contradiction)} % of the beams contradict what was seen just before, and only ${Math.round(100 * stage.matched)} % of the view fits: the robot is lost and begins a map of its own.`;
    case 'found':
      return `The robot recognised a place that it knew, followed that guess for ${stage.way.toFixed(1)} m, and now goes on in its coordinates.`;
    case 'placed': {
      if (stage.surfaces.length === 0) return 'Nothing was new: no surface entered the map (MFIS).';
      const to = stage.reference === undefined ? '' : `, surface ${stage.reference}`;
      return `${count(stage.surfaces.length, 'new surface', 'new surfaces')} entered the map (MFIS) ${PLACED_BY[stage.by]}${to}.`;
    }
    case 'ignored': {
      const known = `${count(stage.known, 'surface was', 'surfaces were')} known already: what is stored is never changed, so the new sighting is ignored.`;
      const others = `${count(stage.others, 'surface was', 'surfaces were')} not recognised and yet left out.`;
      return [stage.known > 0 ? known : '', stage.others > 0 ? others : ''].filter(Boolean).join(' ');
    }
    case 'wideness':
      return `From left to right it is ${stage.here.toFixed(2)} m wide here. On the way since the last view it was narrowest at ${stage.least.toFixed(2)} m, of ${count(stage.samples, 'measurement', 'measurements')}.`;
    case 'exit':
      return `The robot went through exit ${stage.exit}${stage.width === undefined ? '' : `, ${stage.width.toFixed(2)} m wide`}: ${stage.why}.`;
    case 'new_asr':
      return `Behind exit ${stage.exit} a new local space (ASR ${stage.asr}) was opened; ${count(stage.moved, 'surface', 'surfaces')} seen through the exit now belong to it.`;
    case 'loop_closed':
      return `A loop is closed: ${Math.round(100 * stage.overlap)} % of ${stage.instead_of === undefined ? 'what lies behind the exit' : `ASR ${stage.instead_of}`} is in ASR ${stage.asr}, so it is the same: ${stage.why}. Only the network changes; the map stays.`;
    case 'options':
      return `Told to go home, the robot weighs ${count(stage.options.length, 'way on', 'ways on')} that it sees to be free.`;
    case 'choice':
      return `${stage.option === undefined ? 'It decided' : `It took way ${stage.option}`} after view ${stage.step + 1}: ${stage.why}.`;
    case 'forgotten': {
      const map = `The map let go of ${count(stage.by_map, 'surface', 'surfaces')}, as the robot has moved on to other spaces.`;
      const home = `On its way home the robot does not trust ${count(stage.by_navigation, 'surface', 'surfaces')} that it has not seen lately; the map keeps them.`;
      return [stage.by_map > 0 ? map : '', stage.by_navigation > 0 ? home : ''].filter(Boolean).join(' ');
    }
  }
}

/** Every word on the page. Nothing else under `src` holds text for people. */
export const strings = {
  name: 'Cogmap',
  tagline: 'What a robot remembers of a building',
  preparing: 'Preparing the laboratory…',
  failed: (reason: string) => `The laboratory could not start: ${reason}`,

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
    generated: 'A new building',
    generatedHint: 'An office floor that nobody drew: corridors, rooms, doors and furniture come from its number.',
    building: 'Number',
    buildingHint: 'Each number is another office floor, and always the same one',
    robot: 'Robot',
    seed: 'Seed',
  },

  files: {
    open: 'Open…',
    openHint: 'Open a recorded log (CARMEN), a session or a world. Dropping a file on the page does the same.',
    save: 'Save, share',
    link: { name: 'Copy link', hint: 'opening it gives exactly this moment of this run' },
    picture: { name: 'Picture', hint: 'the world and the memories with their legends, as a PNG' },
    session: { name: 'Session', hint: 'opening it gives exactly this run again' },
    map: {
      name: 'Map',
      of: (mapper: string) => `Map by ${mapper}`,
      hint: 'surfaces, exits, local spaces and the path, as JSON',
    },
    drop: 'Drop it here',
    dropHint: 'A recorded log (CARMEN, gzipped or not), a session or a world',
    reading: (name: string) => `Reading ${name}…`,
    refused: (reason: string) => `That did not work. ${reason}`,
    dismiss: 'Dismiss',
  },

  link: {
    name: 'The link',
    label: 'Link',
    copied: 'The link to exactly this moment is copied: paste it wherever you like.',
    byHand: 'Your browser does not let the page copy. This is the link to exactly this moment:',
    tooLong: (length: number) =>
      `This run is too long for a link: it would have ${length.toLocaleString('en')} characters, and many programs cut such a link off. Save the session as a file and send that.`,
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
      `Go on where you were? ${name}, ${moment(time)} into the run, left ${new Date(when).toLocaleString('en', { dateStyle: 'medium', timeStyle: 'short' })}.`,
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
  },

  embed: { whole: 'Open the whole page' },

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
    exits: 'exits',
    exitsHint: 'The narrow places between local spaces, found after the robot went through',
    network: 'network',
    networkHint: 'Local spaces by number, and the ways through exits that join them',
    homing: 'plans',
    homingHint: 'What the robot has in mind on its way home: where it could go, where it goes, and what it no longer goes by',
    truth: 'truth',
    truthHint: 'Lay the world over the memories',
  },

  facts: {
    travelled: (metres: number) => `${metres.toFixed(1)} m driven`,
    collisions: (count: number) => (count === 1 ? '1 bump' : `${count} bumps`),
    memory: ({ surfaces, views, asrs }: { surfaces: number; views: number; asrs: number | undefined }) => [
      `${count(surfaces, 'surface', 'surfaces')} from ${count(views, 'view', 'views')}`,
      ...(asrs === undefined ? [] : [count(asrs, 'local space', 'local spaces')]),
    ],
    off: (metres: number, degrees: number) => `off by ${metres.toFixed(2)} m, ${Math.round(degrees)}°`,
    home: (metres: number, believed: number | undefined) =>
      `home ${metres.toFixed(2)} m away${believed === undefined ? '' : `, it believes ${believed.toFixed(2)} m`}`,
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
        return 'Something in the world was changed';
    }
  },
  by: (mapper: string, said: string) => `${mapper}: ${said}`,

  why: {
    title: 'Why?',
    ask: 'Why?',
    askHint: (mapper: string) => `Take the latest step of ${mapper} apart`,
    view: (step: number, mapper: string) => `view ${step} by ${mapper}`,
    close: 'Close Why?',
    walk: 'Walk through the step',
    back: 'Stage before',
    on: 'Next stage',
    progress: (at: number, of: number) => `${at} of ${of}`,
    stages: {
      scan: 'Scan',
      surfaces: 'Surfaces',
      recognised: 'Recognised',
      movement: 'Movement',
      reference: 'Reference target',
      together: 'All together',
      open: 'Direction left open',
      lost: 'Lost',
      found: 'Found',
      placed: 'Placed',
      ignored: 'Ignored',
      wideness: 'Wideness',
      exit: 'Exit',
      new_asr: 'New local space',
      loop_closed: 'Loop closed',
      options: 'Ways on',
      choice: 'Choice',
      forgotten: 'Forgotten',
    },
    sentence: stageSentence,
    details: {
      pairs: 'How well each pair fits',
      pairsHint: 'd₁ and d₂: how far its two ends lie apart; φ: how much it is turned; the error is their product, each with a little added.',
      pairColumns: ['surface', 'd₁, m', 'd₂, m', 'φ, °', 'error'],
      candidates: 'All candidates',
      candidatesHint: 'A good reference is long, near and seen squarely; the highest quality wins.',
      candidateColumns: ['surface', 'quality'],
      options: 'Their scores',
      optionsHint: 'Numbered in the memory. The detour is against the straight line home; the lowest score wins.',
      optionColumns: ['way', 'detour, m', 'score', ''],
      barred: 'barred',
    },
  },

  homing: {
    title: 'Way home',
    go: 'Go Home',
    going: 'Going home…',
    goHint: 'Let the robot find the way back to where it began, alone',
    strategy: (name: string) => `How it finds the way: ${name}`,
    about: (name: string) => STRATEGIES[name] ?? `As ${name} does it`,
    looking: 'Told to go home, it comes to rest and looks first.',
    leads: {
      direction: 'By its sense of direction:',
      route: 'Along the remembered route:',
      planning: 'By a plan:',
    },
    ended: ({ ended, distance, believed, why }: HomingStatus) => {
      const off = `${distance.toFixed(2)} m from where it began`;
      switch (ended) {
        case 'home':
          return `Home: it stopped by itself ${off}${believed === undefined ? '' : `; it believes ${believed.toFixed(2)} m`}.`;
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
      `Mapping ${name}: ${done.toLocaleString('en')} of ${all.toLocaleString('en')} scans`,
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
  },

  invitation: {
    title: 'Take the controls',
    withKeys: 'press an arrow key',
    withTouch: 'tap anywhere in the world',
  },

  zoom: { title: 'Zoom', in: 'Zoom in', out: 'Zoom out', fit: 'Show everything' },

  theme: { dark: 'Switch to dark', light: 'Switch to light' },

  help: {
    open: 'Keyboard shortcuts',
    title: 'How to use the laboratory',
    intro:
      'On the left the building as it is; on the right the robot’s memory of it, put together from what its laser sees. Its odometry is wrong, and nothing ever tells it the truth.',
    pointing:
      'Click or tap in the world to send the robot there: it turns, drives straight and takes a view. Drag to move all views, scroll or pinch to zoom.',
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
      { keys: ['E', 'N', 'P', 'O'], does: 'show exits, the network, plans, the truth' },
      { keys: ['<', '>'], does: 'to the event before, to the next event' },
      { keys: ['Ctrl Z', 'Ctrl Shift Z'], does: 'undo what you told the robot, and redo it' },
      { keys: ['V'], does: 'over to the other branch' },
      { keys: ['Y'], does: 'why? Take the latest step apart' },
      { keys: ['J', 'K'], does: 'stage before, next stage of that step' },
      { keys: ['T'], does: 'light or dark' },
      { keys: ['Esc'], does: 'close what is open, or cancel a log' },
      { keys: ['?'], does: 'this list' },
    ],
  },
} as const;

function moment(seconds: number): string {
  return `${Math.floor(seconds / 60)}:${(seconds % 60).toFixed(1).padStart(4, '0')}`;
}

function count(number: number, one: string, many: string): string {
  return `${number.toLocaleString('en')} ${number === 1 ? one : many}`;
}
