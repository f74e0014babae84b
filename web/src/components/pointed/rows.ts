import { strings } from '../../strings';
import { number } from '../../strings/words';
import type { AsrFacts, ExitFacts, Facts, Occasion, Remembered, SupposedFacts, SurfaceFacts } from '../../wasm/cogmap_wasm';

/** A line of a card: what it is about, what it says, and what it leads to. */
export interface Row {
  name: string;
  says: string;
  leads?: Remembered[];
}

/** The lines of a card. */
export function rowsOf(facts: Facts): Row[] {
  switch (facts.kind) {
    case 'surface':
      return ofSurface(facts);
    case 'exit':
      return ofExit(facts);
    case 'supposed':
      return ofSupposed(facts);
    case 'asr':
      return ofAsr(facts);
  }
}

/** The view in which a thing came to be. */
export function beginning(facts: Facts): Occasion {
  switch (facts.kind) {
    case 'exit':
      return facts.made;
    case 'asr':
      return facts.opened;
    default:
      return facts.seen;
  }
}

function ofSurface({ seen, last, sightings, by, relative_to, recognised, length, asr }: SurfaceFacts): Row[] {
  const { labels, relative, rules, metres } = strings.pointed;
  return [
    { name: labels.seen, says: when(seen) },
    { name: labels.last, says: sightings === 1 ? strings.pointed.once : `${when(last)}; ${strings.pointed.sightings(sightings)}` },
    relative_to === undefined
      ? { name: labels.relative, says: relative[by](recognised) }
      : { name: labels.relative, says: '', leads: [{ kind: 'surface', number: relative_to }] },
    { name: labels.rule, says: rules[by] },
    { name: labels.length, says: metres(number(length, 2)) },
    ...(asr === undefined ? [] : [{ name: labels.belongs, says: '', leads: [place(asr)] }]),
  ];
}

function ofExit({ width, between, made, crossings, last, closed_loop }: ExitFacts): Row[] {
  const { labels, metres, through, looped } = strings.pointed;
  return [
    { name: labels.width, says: metres(number(width, 2)) },
    { name: labels.joins, says: '', leads: [...new Set(between)].map(place) },
    { name: labels.made, says: when(made) },
    { name: labels.through, says: through(crossings, when(last)) },
    ...(closed_loop ? [{ name: labels.loops, says: looped }] : []),
  ];
}

function ofSupposed({ width, within, seen, views }: SupposedFacts): Row[] {
  const { labels, metres, supposed, sightings } = strings.pointed;
  return [
    { name: labels.width, says: metres(number(width, 2)) },
    ...(within === undefined ? [] : [{ name: labels.from, says: '', leads: [place(within)] }]),
    { name: labels.seen, says: `${when(seen)}; ${sightings(views)}` },
    { name: labels.through, says: supposed },
  ];
}

function ofAsr({ area, surfaces, exits, opened, behind, entered, last, loops, merged, current }: AsrFacts): Row[] {
  const { labels, squareMetres, began, entrance, entries, here } = strings.pointed;
  const came = behind === undefined ? began : entrance(behind);
  return [
    ...(current ? [{ name: labels.robot, says: here }] : []),
    { name: labels.opened, says: `${when(opened)}; ${came}` },
    ...(last ? [{ name: labels.entered, says: entries(entered, when(last)) }] : []),
    { name: labels.area, says: squareMetres(number(area, 1)) },
    { name: labels.surfaces, says: String(surfaces) },
    { name: labels.exits, says: exits.length === 0 ? strings.pointed.none : '', leads: exits.map(({ exit }) => ({ kind: 'exit', number: exit })) },
    { name: labels.loops, says: loops === 0 ? strings.pointed.none : String(loops) },
    ...(merged.length === 0 ? [] : [{ name: labels.merged, says: merged.join(', ') }]),
  ];
}

function place(asr: number): Remembered {
  return { kind: 'asr', number: asr };
}

function when({ step, t }: Occasion): string {
  return strings.pointed.view(step + 1, t);
}
