import type { PlacementKind, StageReport } from '../../wasm/cogmap_wasm';
import { capital, count, number, said } from '../words';
import { reasons } from './reasons';

/** Why a memory is as it is. */
export const why = {
  title: 'Warum?',
  ask: 'Warum?',
  askHint: (mapper: string) => `Den letzten Schritt von ${mapper} zerlegen`,
  view: (step: number, mapper: string) => `Ansicht ${step} nach ${mapper}`,
  close: 'Warum? schließen',
  walk: 'Durch den Schritt gehen',
  back: 'Vorige Stufe',
  on: 'Nächste Stufe',
  progress: (at: number, of: number) => `${at} von ${of}`,
  stages: {
    scan: 'Scan',
    surfaces: 'Flächen',
    recognised: 'Wiedererkannt',
    movement: 'Bewegung',
    reference: 'Bezugsfläche',
    together: 'Alle zusammen',
    open: 'Offene Richtung',
    lost: 'Verirrt',
    found: 'Wiedergefunden',
    placed: 'Gesetzt',
    ignored: 'Übergangen',
    wideness: 'Weite',
    exit: 'Ausgang',
    new_asr: 'Neuer lokaler Raum',
    loop_closed: 'Schleife geschlossen',
    options: 'Mögliche Wege',
    choice: 'Wahl',
    forgotten: 'Vergessen',
  },
  sentence: stageSentence,
  details: {
    pairs: 'Wie gut jedes Paar passt',
    pairsHint:
      'd₁ und d₂: wie weit seine beiden Enden auseinanderliegen; φ: wie weit es gedreht ist; der Fehler ist ihr Produkt, zu jedem ein wenig hinzugezählt.',
    pairColumns: ['Fläche', 'd₁, m', 'd₂, m', 'φ, °', 'Fehler'],
    candidates: 'Alle Bewerber',
    candidatesHint: 'Ein guter Bezug ist lang, nah und gerade von vorn gesehen; die höchste Güte gewinnt.',
    candidateColumns: ['Fläche', 'Güte'],
    options: 'Ihre Wertung',
    optionsHint: 'Nummeriert wie im Gedächtnis. Der Umweg zählt gegen die gerade Linie nach Hause; die kleinste Wertung gewinnt.',
    optionColumns: ['Weg', 'Umweg, m', 'Wertung', ''],
    barred: 'gesperrt',
  },
} as const;

/** What a view was placed by, as the end of a sentence. */
const PLACED_BY: Record<PlacementKind, string> = {
  first: 'dort, wo die erste Ansicht sie sieht: Sie legt das Koordinatensystem der Karte fest',
  reference: 'in dem Abstand und Winkel zur Bezugsfläche, in dem sie gesehen wurden',
  weak_reference: 'in dem Abstand und Winkel zur Bezugsfläche, in dem sie gesehen wurden',
  consensus: 'nach allem, was wiedererkannt wurde',
  partly_odometry: 'nach dem, was wiedererkannt wurde, und in der offenen Richtung nach der Odometrie',
  transform: 'dort, wohin die berichtigte Bewegung sie bringt',
  odometry: 'dort, wohin die Odometrie sie bringt',
};

/** A stage of a step in a sentence, in the thesis's terms. */
function stageSentence(stage: StageReport, mapper: string): string {
  switch (stage.kind) {
    case 'scan':
      return stage.beams === undefined
        ? 'Der Laser tastete die Umgebung ab: ein Scan. Seitdem hat der Roboter wieder hingesehen.'
        : `Der Laser tastete die Umgebung mit ${stage.beams} Strahlen ab: ein Scan.`;
    case 'surfaces':
      return `Punkte des Scans, die auf einer Linie liegen, wurden zu Flächen: ${stage.seen}. Von deren Enden sind ${stage.true_ends} dort, wo ein Ding endet, ${stage.occluded} von Näherem verdeckt und ${stage.at_limit} so weit weg, wie der Laser sieht.`;
    case 'recognised': {
      const { length } = stage.pairs;
      if (length === 0) return 'Keine wurde wiedererkannt: Wo sie gesehen wurden, liegt nichts Bekanntes.';
      const byMap = stage.by_map === 0 ? '' : ` ${stage.by_map} davon nur in der Karte, nicht in der Ansicht davor.`;
      return `${length} von ${stage.seen} wurden wiedererkannt: Sie liegen etwa dort, wo die Odometrie, grob, bekannte Flächen erwarten lässt.${byMap}`;
    }
    case 'movement':
      if (stage.corrected) {
        const { turn_deg, travel, before, after, changes } = stage.corrected;
        return `Der Roboter probierte kleine Änderungen der gemessenen Bewegung und behielt ${changes}, nach denen die Ansichten besser passten: Er drehte ${number(turn_deg, 1)}° und fuhr ${number(travel, 2)} m anders als gemessen. Der mittlere Fehler der Paare ging von ${before.toExponential(1)} auf ${after.toExponential(1)}.`;
      }
      return mapper === 'odometry'
        ? 'Dieser Kartierer nimmt die Bewegung, wie die Räder sie zählten (Odometrie).'
        : 'Keine wiedererkannte Fläche sagt, wo der Roboter ist; diese eine Ansicht wird deshalb nach der Odometrie gesetzt, nach dem, was die Räder zählten.';
    case 'reference': {
      const { known, length, range, incidence_deg, along, crossing, candidates } = stage;
      const won = candidates.length === 1 ? 'Es gab keine andere Bewerberin' : `Sie ist die beste von ${candidates.length}`;
      const seen = `${number(length, 2)} m lang gesehen, ${number(range, 1)} m entfernt und ${Math.round(incidence_deg)}° schräg`;
      const place = {
        end: 'Eines ihrer wahren Enden legt die Lage in ihrer Richtung fest.',
        crossing: `Fläche ${crossing ?? 0}, die ihre Linie kreuzt, legt die Lage in ihrer Richtung fest.`,
        guess: 'Nichts legt die Lage in ihrer Richtung fest; sie ist geraten.',
      }[along];
      return `Fläche ${known} wurde zur Bezugsfläche. ${won}: ${seen}. ${place}`;
    }
    case 'together':
      return `Alle wiedererkannten Flächen (${stage.surfaces}) zusammen sagen, wo der Roboter ist; keine einzelne ist der Bezug.`;
    case 'open':
      return stage.along_deg === undefined
        ? 'Sie lassen mehr als eine Richtung oder die Drehung offen; dort entscheidet die Odometrie.'
        : 'Sie lassen eine Richtung offen, wie die Wände eines Flurs; in ihr entscheidet die Odometrie.';
    case 'lost':
      return `${Math.round(100 * stage.contradiction)} % der Strahlen widersprechen dem, was eben noch gesehen wurde, und nur ${Math.round(100 * stage.matched)} % der Ansicht passen: Der Roboter hat sich verirrt und beginnt eine eigene Karte.`;
    case 'found':
      return `Der Roboter erkannte einen Ort, den er kannte, folgte dieser Vermutung ${number(stage.way, 1)} m weit und rechnet nun in dessen Koordinaten weiter.`;
    case 'placed': {
      if (stage.surfaces.length === 0) return 'Nichts war neu: Keine Fläche kam in die Karte (MFIS).';
      const to = stage.reference === undefined ? '' : `, Fläche ${stage.reference}`;
      return `In die Karte (MFIS) ${stage.surfaces.length === 1 ? 'kam 1 neue Fläche' : `kamen ${stage.surfaces.length} neue Flächen`}, ${PLACED_BY[stage.by]}${to}.`;
    }
    case 'ignored': {
      const known = `${count(stage.known, 'Fläche war', 'Flächen waren')} schon bekannt: Was gespeichert ist, wird nie geändert, also wird der neue Anblick übergangen.`;
      const others = `${count(stage.others, 'Fläche wurde', 'Flächen wurden')} nicht wiedererkannt und doch weggelassen.`;
      return [stage.known > 0 ? known : '', stage.others > 0 ? others : ''].filter(Boolean).join(' ');
    }
    case 'wideness':
      return `Von links nach rechts ist es hier ${number(stage.here, 2)} m weit. Auf dem Weg seit der letzten Ansicht war es an der engsten Stelle ${number(stage.least, 2)} m, nach ${count(stage.samples, 'Messung', 'Messungen')}.`;
    case 'exit':
      return `Der Roboter fuhr durch Ausgang ${stage.exit}${stage.width === undefined ? '' : `, ${number(stage.width, 2)} m breit`}: ${capital(said(stage.why, reasons))}.`;
    case 'new_asr':
      return `Hinter Ausgang ${stage.exit} wurde ein neuer lokaler Raum angelegt (ASR ${stage.asr}); ${count(stage.moved, 'Fläche, die durch den Ausgang gesehen wurde, gehört', 'Flächen, die durch den Ausgang gesehen wurden, gehören')} nun zu ihm.`;
    case 'loop_closed':
      return `Eine Schleife ist geschlossen: ${Math.round(100 * stage.overlap)} % von ${stage.instead_of === undefined ? 'dem, was hinter dem Ausgang liegt,' : `ASR ${stage.instead_of}`} liegen in ASR ${stage.asr}, also ist es derselbe: ${capital(said(stage.why, reasons))}. Nur das Netz ändert sich; die Karte bleibt.`;
    case 'options':
      return `Auf dem Heimweg wägt der Roboter ${count(stage.options.length, 'Weg', 'Wege')} ab, die er frei sieht.`;
    case 'choice':
      return `${stage.option === undefined ? 'Er entschied' : `Er nahm Weg ${stage.option}`} nach Ansicht ${stage.step + 1}: ${capital(said(stage.why, reasons))}.`;
    case 'forgotten': {
      const map = `Die Karte ließ ${count(stage.by_map, 'Fläche', 'Flächen')} los, weil der Roboter in andere Räume weitergezogen ist.`;
      const home = `Auf dem Heimweg traut der Roboter ${count(stage.by_navigation, 'Fläche', 'Flächen')} nicht, die er zuletzt nicht gesehen hat; die Karte behält sie.`;
      return [stage.by_map > 0 ? map : '', stage.by_navigation > 0 ? home : ''].filter(Boolean).join(' ');
    }
  }
}
