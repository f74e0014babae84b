import type { Schematic, SchematicPlace } from '../../wasm/cogmap_wasm';
import { count, moment, number } from '../words';

/** What is plotted of a run, and the places as a schematic. */
export const plots = {
  title: 'Gráficas',
  openHint: 'Anchura, errores y superficies a lo largo del recorrido, y los lugares en un esquema',
  close: 'Cerrar las gráficas',
  loading: 'Trayendo las gráficas…',
  failed: 'No se pudieron traer las gráficas. Ciérrelas e inténtelo de nuevo.',
  pages: 'Qué se muestra',
  curves: 'Durante el recorrido',
  places: 'Lugares',
  whose: 'Camino y lugares según',
  whoseHint: 'De quién son el camino y los lugares que se muestran',
  waiting: 'Todavía no se ha visto nada.',
  moment,

  reader: 'Momento en las gráficas',
  exitsHint: 'Un punto es una salida; su número, el espacio local que hay detrás.',
  readerHint: 'Haga clic en un momento para ir a él, o use las flechas e Intro en la barra de arriba.',
  now: 'ahora',
  at: (moment: string) => `a los ${moment}`,
  /** The values at a moment in a sentence each. */
  spoken: (moment: string, wide: number | undefined, mappers: { mapper: string; view: number; off: [number, number] | undefined; surfaces: number }[]) =>
    [
      moment,
      ...(wide === undefined ? [] : [`${number(wide, 2)} metros de ancho`]),
      ...mappers.map(({ mapper, view, off, surfaces }) => {
        const wrong = off ? [`desviado ${number(off[0], 2)} metros y ${number(off[1], 1)} grados`] : [];
        return [`${mapper}: vista ${view}`, ...wrong, count(surfaces, 'superficie', 'superficies')].join(', ');
      }),
    ].join('. '),
  values: 'Valores en ese momento',
  columns: { mapper: 'cartógrafo', view: 'vista', metres: 'desvío, m', degrees: 'giro, °', surfaces: 'superficies' },

  wideness: 'Qué anchura hay por el camino',
  widenessUnit: 'm',
  widenessHint:
    'De la superficie de la izquierda a la de la derecha, cada 0,1 m. Un punto es un lugar estrecho que pasó a ser salida; el número de encima es el del espacio local que hay detrás. Un punto hueco es una salida que el robot ya conocía.',
  wide: (metres: number) => `${number(metres, 2)} m de ancho`,
  noWideness: (mappers: string) => `${mappers} no conoce espacios locales, así que no mira qué anchura hay.`,
  error: 'Cuánto se desvía el robot',
  errorHint:
    'A qué distancia está el robot de donde cree estar, con la verdad y el mapa superpuestos en la primera vista, como lo miden los estudios',
  errorIn: 'Unidad del error',
  units: { metres: 'm', degrees: '°' },
  noError: 'Una grabación no dice dónde estaba de verdad el robot, así que no se sabe nada de los errores.',
  surfaces: 'Superficies en la memoria',

  /** A space as the schematic names it. */
  place: ({ asr, current, behind }: SchematicPlace) =>
    `Espacio local ${asr}${behind === undefined ? '' : `, tras la salida ${behind}`}${current ? ', donde está el robot' : ''}`,
  noPlaces: 'Ninguno de estos cartógrafos sabe qué es un espacio local. Muestre perceptual o consensus.',
  legend: 'A la izquierda empezó el robot; cada línea pasa por una salida, y el número que lleva es su anchura en metros.',
  times: (exits: number) => `${exits} salidas`,
  loops: 'Una línea doble cerró un bucle.',
  choose: 'Elija un lugar para leer su historia.',
  /** What is known about a place, sentence by sentence. */
  story: ({ asr, area, surfaces, behind, exits, merged, step, current }: SchematicPlace, { exits: all }: Schematic) => {
    const width = (exit: number) => all.find((other) => other.exit === exit)?.width ?? 0;
    const opened =
      behind === undefined
        ? asr === 0 ? 'El robot empezó aquí.' : `El robot llegó aquí en la vista ${step + 1}.`
        : `Abierto en la vista ${step + 1}, cuando el robot hubo pasado por la salida ${behind}, de ${number(width(behind), 2)} m de ancho.`;
    const ways = [...new Set(exits.map(({ asr }) => asr))].map((to) => {
      const through = exits.filter(({ asr }) => asr === to).map(({ exit }) => exit);
      return `al espacio ${to} por ${through.length === 1 ? 'la salida' : 'las salidas'} ${through.join(', ')}`;
    });
    return [
      `${current ? 'El robot está aquí. ' : ''}${opened}`,
      `${number(area, 1)} m² de suelo vistos, ${count(surfaces, 'superficie', 'superficies')}.`,
      ways.length === 0 ? 'Todavía no se ha pasado por ninguna salida.' : `Lleva ${ways.join('; ')}.`,
      ...(merged.length === 0
        ? []
        : [`${merged.length === 1 ? 'El espacio' : 'Los espacios'} ${merged.join(', ')} ${merged.length === 1 ? 'resultó' : 'resultaron'} ser este: se cerró un bucle.`]),
    ];
  },
  storyTitle: (asr: number) => `Espacio local ${asr}`,
  toOpening: (moment: string) => `Ir a ${moment}, cuando se abrió`,
} as const;
