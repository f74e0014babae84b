import type { Clause, Followed, HomingStatus } from '../../wasm/cogmap_wasm';
import { moment, number, said, whole } from '../words';
import { reasons } from './reasons';
import { worlds } from './worlds';

/** What each way of going home is, and whose idea. */
const STRATEGIES: Record<string, string> = {
  recommended: 'La nuestra: planea a través de lo que recuerda y de lo que espera que esté libre',
  faithful: 'La de la tesis, al pie de la letra: por la abertura que lleva más recto a casa, con sus zigzags y trampas',
  retrace: 'Para comparar: de vuelta por donde vino, punto por punto; la tesis lo rechaza',
  'tangent-bug': 'Para comparar, de la bibliografía: todo recto, rodeando lo que estorbe',
  oracle: 'Para comparar: el camino más corto, de quien ve el edificio como es',
};

/** What a run is made of and told. */
export const controls = {
  setup: {
    title: 'Preparación',
    world: 'Mundo',
    groups: {
      everyday: 'Edificios corrientes',
      home: 'Hechos para encontrar el camino a casa',
      thesis: 'Vueltas largas, como en la tesis',
      schematic: 'Para mostrar una sola cosa',
      generated: 'Hechos a partir de un número',
    },
    names: {
      'around-a-corner': 'Al doblar la esquina',
      'box-course': 'Pista de cajas',
      'environment-a': 'Entorno A',
      'environment-b': 'Entorno B',
      'long-corridor': 'Pasillo largo',
      'long-office': 'Oficina larga',
      'narrow-passage': 'Paso estrecho',
      'no-passage': 'Sin paso',
      office: 'Oficina',
      shortcut: 'Atajo',
      'small-office': 'Oficina pequeña',
      tour: 'Recorrido',
      'two-shortcuts': 'Dos atajos',
      'u-trap': 'Trampa en U',
    } as Readonly<Record<string, string>>,
    about: worlds,
    generated: 'Un edificio nuevo',
    generatedHint: 'Una planta de oficinas que nadie dibujó: pasillos, salas, puertas y muebles salen de su número.',
    building: 'Número',
    buildingHint: 'Cada número es otra planta de oficinas, y siempre la misma',
    robot: 'Robot',
    seed: 'Semilla',
  },

  homing: {
    title: 'Camino a casa',
    go: 'Ir a casa',
    going: 'De camino…',
    goHint: 'Deja que el robot encuentre solo el camino de vuelta a donde empezó',
    strategy: (name: string) => `Cómo encuentra el camino: ${name}`,
    about: (name: string) => STRATEGIES[name] ?? `Como lo hace ${name}`,
    because: (clauses: Clause[]) => `${said(clauses, reasons)}.`,
    looking: 'Se le ha dicho que vaya a casa; primero se detiene y mira.',
    leads: {
      direction: 'Por su sentido de la dirección:',
      route: 'Por el camino recordado:',
      planning: 'Según un plan:',
    },
    ended: ({ ended, distance, believed, why }: HomingStatus) => {
      const off = `a ${number(distance, 2)} m de donde empezó`;
      switch (ended) {
        case 'home':
          return `En casa: se detuvo por sí mismo ${off}${believed === undefined ? '' : `; él cree que a ${number(believed, 2)} m`}.`;
        case 'stuck':
          return `Se rindió, ${off}: ${why ?? 'no había visto nada'}.`;
        case 'stopped':
          return `Usted tomó el mando, ${off}.`;
        case undefined:
          return '';
      }
    },
  },

  log: {
    mapping: (name: string, done: number, all: number) =>
      `Haciendo el mapa de ${name}: ${whole(done)} de ${whole(all)} barridos`,
    cancel: 'Cancelar',
  },

  transport: {
    title: 'Tiempo',
    restart: 'Empezar de nuevo',
    play: 'Reproducir',
    pause: 'Pausa',
    next: 'Vista siguiente',
    finish: 'Hasta el final',
    finishHint: 'Pasar de inmediato a cuando el robot haya hecho lo que se le dijo',
    timeline: 'Línea de tiempo',
    marks: 'Sucesos',
    mark: (moment: string, said: string) => `${moment}: ${said}`,
    moment,
    undo: 'Deshacer',
    redo: 'Rehacer',
    branch: (others: number) => `Otra rama (${others})`,
    branchHint: 'Pasar a lo que habría ocurrido si usted no hubiera seguido de otro modo',
    speed: 'Velocidad',
    times: (factor: number) => `${factor}×`,
    full: 'Máx.',
  },

  drive: {
    title: 'Conducir',
    ahead: 'Avanzar',
    back: 'Retroceder',
    left: 'Girar a la izquierda',
    right: 'Girar a la derecha',
    stop: 'Alto',
    stick: 'Empuje la palanca hacia donde deba ir el robot; suéltela para pararlo',
  },

  /** A way that is drawn for the robot to follow. */
  way: {
    open: 'Trazar camino',
    openHint: 'Trazar en el mundo por dónde ha de ir el robot (Q). Con el teclado: las flechas lo conducen paso a paso',
    ofLog: 'Una grabación no tiene un robot al que enviar',
    hint: 'Trace por dónde ha de ir el robot; un clic lo envía derecho a ese punto. Sin puntero sirven las flechas.',
    said: (followed: Followed) => {
      switch (followed.kind) {
        case 'going':
          return `En camino: ${number(followed.metres, 1)} m${followed.around ? ', rodeando lo que estorba' : ''}.`;
        case 'no_room':
          return 'El robot se queda: en ningún punto de esa línea hay sitio para él.';
        case 'unreachable':
          return 'El robot se queda: a una parte de esa línea no se puede llegar desde aquí.';
        case 'no_line':
          return 'El robot se queda: esa línea no lo aleja de donde está.';
        case 'no_building':
          return 'Una grabación no tiene un robot al que enviar.';
      }
    },
  },

  gamepad: {
    name: 'Mando',
    found: 'Mando encontrado: la palanca izquierda o la cruceta conduce, A va a casa, B para, Start reproduce y pausa.',
  },

  invitation: {
    title: 'Tome los mandos',
    withKeys: 'pulse una flecha del teclado',
    withTouch: 'toque en cualquier punto del mundo',
  },

  theme: { dark: 'Cambiar a oscuro', light: 'Cambiar a claro' },
  language: 'Idioma',
} as const;
