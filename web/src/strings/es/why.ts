import type { PlacementKind, StageReport } from '../../wasm/cogmap_wasm';
import { count, number, said } from '../words';
import { reasons } from './reasons';

/** Why a memory is as it is. */
export const why = {
  title: '¿Por qué?',
  ask: '¿Por qué?',
  askHint: (mapper: string) => `Desmontar el último paso de ${mapper}`,
  view: (step: number, mapper: string) => `vista ${step} según ${mapper}`,
  close: 'Cerrar ¿Por qué?',
  walk: 'Recorrer el paso',
  back: 'Fase anterior',
  on: 'Fase siguiente',
  progress: (at: number, of: number) => `${at} de ${of}`,
  stages: {
    scan: 'Barrido',
    surfaces: 'Superficies',
    recognised: 'Reconocidas',
    movement: 'Movimiento',
    reference: 'Referencia',
    together: 'Todas juntas',
    open: 'Dirección abierta',
    lost: 'Perdido',
    found: 'Encontrado',
    placed: 'Colocadas',
    ignored: 'Pasadas por alto',
    wideness: 'Anchura',
    exit: 'Salida',
    new_asr: 'Nuevo espacio local',
    loop_closed: 'Bucle cerrado',
    options: 'Caminos posibles',
    choice: 'Elección',
    forgotten: 'Olvidadas',
  },
  sentence: stageSentence,
  details: {
    pairs: 'Lo bien que encaja cada par',
    pairsHint:
      'd₁ y d₂: cuánto distan sus dos extremos; φ: cuánto está girado; el error es su producto, con un poco añadido a cada uno.',
    pairColumns: ['superficie', 'd₁, m', 'd₂, m', 'φ, °', 'error'],
    candidates: 'Todas las candidatas',
    candidatesHint: 'Una buena referencia es larga, está cerca y se ve de frente; gana la de más calidad.',
    candidateColumns: ['superficie', 'calidad'],
    options: 'Su puntuación',
    optionsHint: 'Numerados como en la memoria. El rodeo se cuenta frente a la línea recta a casa; gana la puntuación más baja.',
    optionColumns: ['camino', 'rodeo, m', 'puntos', ''],
    barred: 'cerrado',
  },
} as const;

/** What a view was placed by, as the end of a sentence. */
const PLACED_BY: Record<PlacementKind, string> = {
  first: 'donde las ve la primera vista, que fija el sistema de coordenadas del mapa',
  reference: 'a la distancia y en el ángulo de la referencia en que se vieron',
  weak_reference: 'a la distancia y en el ángulo de la referencia en que se vieron',
  consensus: 'según todo lo que se reconoció',
  partly_odometry: 'según lo que se reconoció y, en la dirección abierta, según la odometría',
  transform: 'donde las pone el movimiento corregido',
  odometry: 'donde las pone la odometría',
};

/** A stage of a step in a sentence, in the thesis's terms. */
function stageSentence(stage: StageReport, mapper: string): string {
  switch (stage.kind) {
    case 'scan':
      return stage.beams === undefined
        ? 'El láser miró alrededor del robot: un barrido. Desde entonces el robot ha vuelto a mirar.'
        : `El láser miró alrededor del robot con ${stage.beams} rayos: un barrido.`;
    case 'surfaces':
      return `Los puntos del barrido que están en línea formaron ${count(stage.seen, 'superficie', 'superficies')}. De los extremos, ${stage.true_ends} están donde acaba una cosa, ${stage.occluded} quedan ocultos por algo más cercano y ${stage.at_limit} están donde acaba la vista del láser.`;
    case 'recognised': {
      const { length } = stage.pairs;
      if (length === 0) return 'No se reconoció ninguna: donde se vieron no hay nada conocido.';
      const byMap = stage.by_map === 0 ? '' : ` ${stage.by_map} de ellas, solo en el mapa, no en la vista anterior.`;
      return `Se reconocieron ${length} de ${stage.seen}: están más o menos donde la odometría, a grandes rasgos, hace esperar superficies conocidas.${byMap}`;
    }
    case 'movement':
      if (stage.corrected) {
        const { turn_deg, travel, before, after, changes } = stage.corrected;
        return `El robot probó pequeños cambios del movimiento medido y se quedó con ${changes} que hacían encajar mejor las vistas: giró ${number(turn_deg, 1)}° y avanzó ${number(travel, 2)} m de otro modo que lo medido. El error medio de los pares pasó de ${before.toExponential(1)} a ${after.toExponential(1)}.`;
      }
      return mapper === 'odometry'
        ? 'Este cartógrafo toma el movimiento tal como lo contaron las ruedas (odometría).'
        : 'Ninguna superficie reconocida dice dónde está el robot, así que esta vista se coloca por la odometría, lo que contaron las ruedas.';
    case 'reference': {
      const { known, length, range, incidence_deg, along, crossing, candidates } = stage;
      const won = candidates.length === 1 ? 'No había otra candidata' : `Es la mejor de ${candidates.length} candidatas`;
      const seen = `vista con ${number(length, 2)} m de largo, a ${number(range, 1)} m y a ${Math.round(incidence_deg)}° de la perpendicular`;
      const place = {
        end: 'Uno de sus verdaderos extremos fija el lugar a lo largo de ella.',
        crossing: `La superficie ${crossing ?? 0}, que cruza su línea, fija el lugar a lo largo de ella.`,
        guess: 'Nada fija el lugar a lo largo de ella, así que es una suposición.',
      }[along];
      return `La superficie ${known} pasó a ser la referencia. ${won}: ${seen}. ${place}`;
    }
    case 'together':
      return `Todas las superficies reconocidas (${stage.surfaces}) dicen juntas dónde está el robot; ninguna por sí sola es la referencia.`;
    case 'open':
      return stage.along_deg === undefined
        ? 'Dejan abierta más de una dirección, o el giro; ahí decide la odometría.'
        : 'Dejan abierta una dirección, como las paredes de un pasillo; en ella decide la odometría.';
    case 'lost':
      return `El ${Math.round(100 * stage.contradiction)} % de los rayos contradice lo que se acababa de ver, y solo encaja el ${Math.round(100 * stage.matched)} % de la vista: el robot está perdido y empieza un mapa propio.`;
    case 'found':
      return `El robot reconoció un lugar que conocía, siguió esa conjetura durante ${number(stage.way, 1)} m y continúa ahora en las coordenadas de ese lugar.`;
    case 'placed': {
      if (stage.surfaces.length === 0) return 'Nada era nuevo: ninguna superficie entró en el mapa (MFIS).';
      const to = stage.reference === undefined ? '' : `, la superficie ${stage.reference}`;
      return `${count(stage.surfaces.length, 'superficie nueva entró', 'superficies nuevas entraron')} en el mapa (MFIS) ${PLACED_BY[stage.by]}${to}.`;
    }
    case 'ignored': {
      const known = `${count(stage.known, 'superficie ya era conocida', 'superficies ya eran conocidas')}: lo guardado nunca cambia, así que lo visto de nuevo se pasa por alto.`;
      const others = `${count(stage.others, 'superficie no se reconoció', 'superficies no se reconocieron')} y aun así no entraron en el mapa.`;
      return [stage.known > 0 ? known : '', stage.others > 0 ? others : ''].filter(Boolean).join(' ');
    }
    case 'wideness':
      return `De izquierda a derecha hay aquí ${number(stage.here, 2)} m de ancho. En el camino desde la última vista lo más estrecho fueron ${number(stage.least, 2)} m, de ${count(stage.samples, 'medición', 'mediciones')}.`;
    case 'exit':
      return `El robot pasó por la salida ${stage.exit}${stage.width === undefined ? '' : `, de ${number(stage.width, 2)} m de ancho`}: ${said(stage.why, reasons)}.`;
    case 'new_asr':
      return `Tras la salida ${stage.exit} se abrió un nuevo espacio local (ASR ${stage.asr}); ${count(stage.moved, 'superficie vista a través de la salida le pertenece', 'superficies vistas a través de la salida le pertenecen')} ahora.`;
    case 'loop_closed':
      return `Se ha cerrado un bucle: el ${Math.round(100 * stage.overlap)} % de ${stage.instead_of === undefined ? 'lo que hay tras la salida' : `ASR ${stage.instead_of}`} está en ASR ${stage.asr}, así que es el mismo: ${said(stage.why, reasons)}. Solo cambia la red; el mapa se queda.`;
    case 'options':
      return `Camino de casa, el robot sopesa ${count(stage.options.length, 'camino que ve libre', 'caminos que ve libres')}.`;
    case 'choice':
      return `${stage.option === undefined ? 'Decidió' : `Tomó el camino ${stage.option}`} tras la vista ${stage.step + 1}: ${said(stage.why, reasons)}.`;
    case 'forgotten': {
      const map = `El mapa soltó ${count(stage.by_map, 'superficie', 'superficies')}, porque el robot ha pasado a otros espacios.`;
      const home = `Camino de casa el robot no se fía de ${count(stage.by_navigation, 'superficie', 'superficies')} que no ha visto últimamente; el mapa las conserva.`;
      return [stage.by_map > 0 ? map : '', stage.by_navigation > 0 ? home : ''].filter(Boolean).join(' ');
    }
  }
}
