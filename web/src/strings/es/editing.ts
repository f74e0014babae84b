import type { Kind } from '../../editor/things';
import type { Catch } from '../../editor/snapping';
import type { ToolName } from '../../editor/tools';
import type { Thing } from '../../wasm/cogmap_wasm';
import { count, number } from '../words';

const metres = (long: number) => `${number(long, long % 0.1 < 0.001 || long % 0.1 > 0.099 ? 1 : 2)} m`;
const quoted = (name: string) => (name.trim() === '' ? 'sin nombre' : `«${name}»`);

const KINDS: Record<Kind, string> = {
  wall: 'Pared',
  box: 'Caja',
  post: 'Poste',
  door: 'Puerta',
  person: 'Persona',
  start: 'Comienzo',
  route: 'Ruta',
  room: 'Sala',
};

/** The place of a file that a message speaks of, as the editor calls it: it counts from 1. */
const LISTS: [RegExp, string][] = [
  [/\bboxes\[(\d+)\]/g, 'caja'],
  [/\bposts\[(\d+)\]/g, 'poste'],
  [/\bwalls\[(\d+)\]/g, 'pared'],
  [/\bdoors\[(\d+)\]/g, 'puerta'],
];

/** The editor of buildings; loaded with it. */
export const editing = {
  title: 'Dibujar un edificio',
  back: 'Volver',
  backHint: 'Volver al recorrido; lo dibujado se conserva',
  save: 'Guardar el mundo',
  saveHint: 'Guardarlo como archivo de mundo, que abren la página y la línea de órdenes',
  drive: 'Conducir aquí',
  driveHint: 'Empezar un recorrido en este edificio, con el robot, los cartógrafos y la semilla elegidos',
  undo: 'Deshacer',
  redo: 'Rehacer',
  zoomIn: 'Ampliar',
  zoomOut: 'Reducir',
  fit: 'Mostrar todo',
  snap: 'Ajustar',
  snapHint: 'Lleva los puntos a esquinas, paredes, ángulos rectos y la cuadrícula de 0,1 m (G); con Alt pulsada no',
  preparing: 'Preparando la hoja…',
  refused: (reason: string) => `No se pudo abrir el edificio. ${reason}`,
  stopped: 'El motor del editor se detuvo de improviso. Vuelva y abra otra vez el edificio: no se ha perdido nada.',

  toolsTitle: 'Herramientas',
  tools: {
    select: 'Elegir',
    wall: 'Pared',
    box: 'Caja',
    post: 'Poste',
    door: 'Puerta',
    room: 'Sala',
    start: 'Comienzo',
    route: 'Ruta',
    person: 'Persona',
  } satisfies Record<ToolName, string>,
  hints: {
    select: 'Haga clic en algo para elegirlo, arrástrelo para moverlo. Arrastre el suelo para ver otra parte.',
    wall: 'Haga clic esquina a esquina. Doble clic o Intro termina la pared.',
    box: 'Arrastre de esquina a esquina.',
    post: 'Haga clic donde haya una pata o un pilar.',
    door: 'Arrastre de la bisagra al pestillo. Se abre en sentido contrario a las agujas del reloj.',
    room: 'Haga clic alrededor de la sala, esquina a esquina. Doble clic o Intro la termina.',
    start: 'Pulse donde deba empezar el robot y arrastre hacia donde mira.',
    route: 'Haga clic punto a punto por donde deba ir el robot. Doble clic o Intro la termina.',
    person: 'Haga clic punto a punto por donde alguien vaya y venga. Doble clic o Intro termina el camino.',
  } satisfies Record<ToolName, string>,
  going: (points: number, of: number) =>
    of === 2
      ? 'Ahora el otro extremo. Esc lo abandona.'
      : `${count(points, 'punto', 'puntos')}. Doble clic o Intro lo termina, Esc lo abandona.`,
  done: 'Listo',
  abandon: 'Abandonar',
  moving: 'Las flechas lo mueven, Intro lo deja, Esc lo devuelve a su sitio.',

  sheet: 'La hoja',
  sheetHint:
    'Las flechas mueven el cursor 0,1 m, con Mayús 1 m, con Alt 1 cm; Intro pone un punto o elige lo que haya. V, W, B, P, D, R, S y T eligen una herramienta.',
  cursor: (x: number, y: number, on: string | undefined) =>
    `${number(x, 2)}, ${number(y, 2)} m${on === undefined ? '' : `, ${on}`}`,
  snapped: { corner: 'esquina', wall: 'pared', angle: 'ángulo recto', grid: 'cuadrícula' } satisfies Record<Catch, string>,

  panel: 'Lo dibujado',
  building: 'Edificio',
  name: 'Nombre',
  description: 'Descripción',
  selected: 'Elegido',
  nothing: 'nada',
  none: 'Elija algo para ver sus números y cambiarlos.',
  fields: {
    x: 'x, m',
    y: 'y, m',
    length: 'Largo, m',
    width: 'Ancho, m',
    heading: 'Rumbo, °',
    radius: 'Radio, m',
    speed: 'Velocidad, m/s',
    hinge: 'Bisagra',
    latch: 'Pestillo',
    open: 'Abierta al principio',
    corner: (nth: number) => `Esquina ${nth}`,
    point: (nth: number) => `Punto ${nth}`,
  },
  takeCorner: (nth: number) => `Quitar el punto ${nth}`,
  addCorner: 'Añadir un punto',
  duplicate: 'Duplicar',
  remove: 'Borrar',
  kinds: KINDS,
  stems: { door: 'puerta', room: 'sala', route: 'ruta' },
  copyOf: (name: string) => `${name} copia`,
  newName: 'Edificio nuevo',

  checks: 'Revisión',
  sound: 'Todo está en orden: se puede conducir en él y guardarlo.',
  checking: 'Revisando…',
  faults: (faults: number) => `Por corregir antes: ${faults}`,
  remarks: 'Vale la pena mirar:',
  first: 'Corrija antes lo que enumera la revisión.',
  message: (message: string) => LISTS.reduce((text, [list, word]) => text.replace(list, (_, index) => `${word} ${Number(index) + 1}`), message),

  keysTitle: 'Teclas',
  keys: [
    { keys: ['V', 'W', 'B', 'P', 'D', 'R', 'S', 'T', 'N'], does: 'elegir, pared, caja, poste, puerta, sala, comienzo, ruta, persona' },
    { keys: ['↑ ↓ ← →'], does: 'mover el cursor 0,1 m (Mayús 1 m, Alt 1 cm)' },
    { keys: ['Intro'], does: 'poner un punto, terminar en el último, elegir o tomar lo que haya' },
    { keys: ['Esc'], does: 'abandonar, devolver, no elegir nada' },
    { keys: ['Supr', 'Ctrl D'], does: 'borrar, duplicar' },
    { keys: ['Ctrl Z', 'Ctrl Mayús Z'], does: 'deshacer, rehacer' },
    { keys: ['G', 'Alt'], does: 'ajuste sí o no; pulsada lo deja de lado' },
    { keys: ['+', '−', '0'], does: 'ampliar, reducir, mostrar todo' },
    { keys: ['Espacio'], does: 'mantener y arrastrar para ver otra parte' },
    { keys: ['?'], does: 'esta lista' },
  ],

  /** What a thing is called; `nth` of its kind. */
  called: (thing: Thing, nth: number) => {
    if (thing.kind === 'start') return KINDS.start;
    return 'name' in thing ? `${KINDS[thing.kind]} ${quoted(thing.name)}` : `${KINDS[thing.kind]} ${nth}`;
  },
  /** The same at one of its points. */
  at: (called: string, thing: Thing, point: number) => {
    if (thing.kind === 'door') return `${called}, ${point === 0 ? 'bisagra' : 'pestillo'}`;
    return 'points' in thing ? `${called}, punto ${point + 1}` : called;
  },

  /** What happened, for the one line that tells it. */
  said: {
    wall: (corners: number, long: number) => `Añadida una pared de ${count(corners, 'esquina', 'esquinas')} y ${metres(long)} de largo.`,
    box: (long: number, wide: number) => `Añadida una caja de ${metres(long)} por ${metres(wide)}.`,
    post: (x: number, y: number) => `Añadido un poste en ${number(x, 2)}; ${number(y, 2)}.`,
    door: (name: string, wide: number) => `Añadida la puerta ${quoted(name)}, de ${metres(wide)} de ancho.`,
    room: (name: string, corners: number, large: number) =>
      `Añadida la sala ${quoted(name)} de ${count(corners, 'esquina', 'esquinas')}, ${number(large, 1)} m².`,
    start: (x: number, y: number, heading: number) =>
      `El robot empieza en ${number(x, 2)}; ${number(y, 2)}, mirando a ${number(heading, 0)}°.`,
    route: (name: string, points: number) => `Añadida la ruta ${quoted(name)} por ${count(points, 'punto', 'puntos')}.`,
    person: (long: number) => `Añadida una persona que va y viene ${metres(long)}.`,
    point: (nth: number, x: number, y: number) => `Punto ${nth} en ${number(x, 2)}; ${number(y, 2)}.`,
    pointTaken: (left: number) => `Quitado el último punto; quedan ${left}.`,
    tooFew: (least: number) => `Hacen falta al menos ${least} puntos.`,
    tooSmall: 'Es demasiado pequeño: dibújelo más grande.',
    abandoned: 'Abandonado.',
    putBack: 'Devuelto a su sitio.',
    tool: (name: string, hint: string) => `${name}. ${hint}`,
    selected: (called: string) => `Elegido: ${called}.`,
    nothingThere: 'Ahí no hay nada.',
    taken: (called: string) => `Tomado: ${called}.`,
    changed: (called: string) => `Cambiado: ${called}.`,
    moved: (called: string) => `Movido: ${called}.`,
    removed: (called: string) => `Borrado: ${called}.`,
    keepsStart: 'Todo edificio necesita un comienzo: muévalo en su lugar.',
    duplicated: (called: string) => `${called} es la copia.`,
    undone: 'Deshecho.',
    redone: 'Rehecho.',
    nothingToUndo: 'No queda nada que deshacer.',
    nothingToRedo: 'No queda nada que rehacer.',
    snapping: (on: boolean) => (on ? 'Los puntos se ajustan.' : 'Los puntos no se ajustan.'),
    saved: (file: string) => `Guardado como ${file}.`,
    opened: (name: string) => `${name} está en la hoja.`,
    over: (name: string) => `${name} está en la hoja. Lo dibujado antes vuelve con Deshacer.`,
  },
} as const;
