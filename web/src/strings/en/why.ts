import type { PlacementKind, StageReport } from '../../wasm/cogmap_wasm';
import { count, number, said } from '../words';

/** Why a memory is as it is. */
export const why = {
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
} as const;

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
        return `The robot tried small changes of the measured movement and kept ${changes} that made the views fit better: it turned ${number(turn_deg, 1)}° and went ${number(travel, 2)} m otherwise than measured. The mean matching error went from ${before.toExponential(1)} to ${after.toExponential(1)}.`;
      }
      return mapper === 'odometry'
        ? 'This mapper takes the movement as the wheels counted it (odometry).'
        : 'No recognised surface says where the robot is, so this one view is placed by odometry, what the wheels counted.';
    case 'reference': {
      const { known, length, range, incidence_deg, along, crossing, candidates } = stage;
      const won = candidates.length === 1 ? 'There was no other candidate' : `It is the best of ${candidates.length} candidates`;
      const seen = `seen ${number(length, 2)} m long, ${number(range, 1)} m away and ${Math.round(incidence_deg)}° from square on`;
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
      return `The robot recognised a place that it knew, followed that guess for ${number(stage.way, 1)} m, and now goes on in its coordinates.`;
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
      return `From left to right it is ${number(stage.here, 2)} m wide here. On the way since the last view it was narrowest at ${number(stage.least, 2)} m, of ${count(stage.samples, 'measurement', 'measurements')}.`;
    case 'exit':
      return `The robot went through exit ${stage.exit}${stage.width === undefined ? '' : `, ${number(stage.width, 2)} m wide`}: ${said(stage.why)}.`;
    case 'new_asr':
      return `Behind exit ${stage.exit} a new local space (ASR ${stage.asr}) was opened; ${count(stage.moved, 'surface', 'surfaces')} seen through the exit now belong to it.`;
    case 'loop_closed':
      return `A loop is closed: ${Math.round(100 * stage.overlap)} % of ${stage.instead_of === undefined ? 'what lies behind the exit' : `ASR ${stage.instead_of}`} is in ASR ${stage.asr}, so it is the same: ${said(stage.why)}. Only the network changes; the map stays.`;
    case 'options':
      return `Told to go home, the robot weighs ${count(stage.options.length, 'way on', 'ways on')} that it sees to be free.`;
    case 'choice':
      return `${stage.option === undefined ? 'It decided' : `It took way ${stage.option}`} after view ${stage.step + 1}: ${said(stage.why)}.`;
    case 'forgotten': {
      const map = `The map let go of ${count(stage.by_map, 'surface', 'surfaces')}, as the robot has moved on to other spaces.`;
      const home = `On its way home the robot does not trust ${count(stage.by_navigation, 'surface', 'surfaces')} that it has not seen lately; the map keeps them.`;
      return [stage.by_map > 0 ? map : '', stage.by_navigation > 0 ? home : ''].filter(Boolean).join(' ');
    }
  }
}
