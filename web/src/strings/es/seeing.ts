import type { Happening } from '../../wasm/cogmap_wasm';
import { count, number } from '../words';
import { changing } from './changing';

/** What each mapper is, in a line. */
const MAPPERS: Record<string, string> = {
  perceptual: 'El mapa perceptivo de Yeap como lo programa la tesis, con todos sus defectos',
  consensus: 'El nuestro: todas las superficies reconocidas dicen juntas dónde está el robot',
  transform: 'A la manera tradicional: vistas unidas por un movimiento corregido',
  odometry: 'Vistas unidas según lo que dicen las ruedas, sin corregir',
};

/** What is seen of the world and of the memories, and what is said about it. */
export const seeing = {
  world: {
    title: 'El mundo',
    subtitle: 'tal como es',
    picture:
      'El edificio visto desde arriba, con el robot, su láser y el camino que hizo. Haga clic en un punto para enviar allí el robot.',
  },

  memory: {
    title: 'La memoria del robot',
    subtitle: (mapper: string | undefined) => (mapper === undefined ? 'tal como lo cree' : `según ${mapper}`),
    picture:
      'El mapa en la memoria del robot: cada superficie dibujada donde se puso al verla por primera vez, las salidas entre espacios locales y la red que forman.',
  },

  wheels: {
    title: 'La grabación',
    subtitle: 'solo por su odometría',
    picture: 'El camino que contaron las ruedas del robot y que los cartógrafos corrigen.',
  },

  shown: {
    views: 'Mostrar',
    world: 'mundo',
    mapper: (name: string) => MAPPERS[name] ?? `Lo que ${name} saca del mismo recorrido`,
    layers: 'En las memorias',
    colours: 'Color según',
    by: { view: 'vista', asr: 'espacio local', age: 'antigüedad' },
    stance: 'Visto desde',
    stanceHint:
      'Desde fuera el mapa está quieto; desde el robot, o desde donde entró en este espacio local, ese punto está quieto y mira hacia arriba',
    from: { map: 'fuera', robot: 'el robot', entrance: 'la entrada' },
    exits: 'salidas',
    exitsHint: 'Los lugares estrechos entre espacios locales, hallados después de que el robot los cruzara',
    network: 'red',
    networkHint: 'Los espacios locales por su número y los caminos por las salidas que los unen',
    homing: 'planes',
    homingHint: 'Lo que el robot piensa camino de casa: adónde podría ir, adónde va y qué ya no tiene en cuenta',
    truth: 'verdad',
    truthHint: 'Poner el mundo sobre las memorias',
    fit: 'según',
    fits: { first_view: 'la primera vista', best_fit: 'el mejor ajuste' },
    fitHint:
      'Según la primera vista, los errores se ven donde surgieron; según el mejor ajuste, todo el camino recordado queda tan cerca del verdadero como permiten desplazar y girar',
  },

  facts: {
    travelled: (metres: number) => `${number(metres, 1)} m recorridos`,
    collisions: (bumps: number) => count(bumps, 'choque', 'choques'),
    memory: ({ surfaces, views, asrs }: { surfaces: number; views: number; asrs: number | undefined }) => [
      `${count(surfaces, 'superficie', 'superficies')} de ${count(views, 'vista', 'vistas')}`,
      ...(asrs === undefined ? [] : [count(asrs, 'espacio local', 'espacios locales')]),
    ],
    off: (metres: number, degrees: number) => `desviado ${number(metres, 2)} m, ${Math.round(degrees)}°`,
    home: (metres: number, believed: number | undefined) =>
      `casa a ${number(metres, 2)} m${believed === undefined ? '' : `, él cree que a ${number(believed, 2)} m`}`,
    offHint: 'A qué distancia está el robot de donde cree estar',
  },

  story: {
    waiting: 'Todavía no se ha visto nada.',
    view: (step: number, seen: number, recognised: number) =>
      `Vista ${step}: ${count(seen, 'superficie vista', 'superficies vistas')}, ${count(recognised, 'reconocida', 'reconocidas')}`,
    first: 'la primera vista fija el sistema de coordenadas del mapa',
    reference: (known: number) => `referencia: superficie ${known}`,
    weak_reference: (known: number) => `referencia: superficie ${known}, su lugar a lo largo de la pared es una suposición`,
    consensus: 'todas juntas dicen dónde está el robot',
    partly_odometry: 'dejan abierta una dirección, en la que decide la odometría',
    transform: 'el movimiento, corregido hasta que las vistas encajan',
    odometry: 'colocada por la odometría',
    placed: (surfaces: number) =>
      surfaces === 0 ? 'nada nuevo' : count(surfaces, 'superficie nueva colocada', 'superficies nuevas colocadas'),
    label: 'Lo que el robot acaba de hacer',
    happened: 'Lo que ocurrió',
  },

  /** What happened in a mind; local spaces and exits bear the numbers that they have in the map. */
  happened: (what: Happening) => {
    switch (what.kind) {
      case 'exit':
        return `Pasó por la salida ${what.exit} al espacio local ${what.asr}`;
      case 'new_asr':
        return `Espacio local ${what.asr} abierto tras la salida ${what.exit}`;
      case 'loop_closed':
        return `De vuelta en el espacio local ${what.asr}: se ha cerrado un bucle`;
      case 'unseen':
        return 'Nada a la vista era conocido: solo la odometría decía dónde estaba el robot';
      case 'lost':
        return 'Perdido: el robot no está donde creía y empieza un mapa propio';
      case 'recognised':
        return 'Encontrado: el robot reconoció un lugar que conocía';
      case 'told_home':
        return 'Enviado a casa';
      case 'kidnapped':
        return 'Levantado y dejado en otro sitio';
      case 'world_changed':
        return changing.changed[what.change];
    }
  },

  by: (mapper: string, said: string) => `${mapper}: ${said}`,

  divider: {
    name: (view: string) => `Tamaño de «${view}»`,
    share: (percent: number) => `${percent} % del espacio`,
    folded: { first: 'plegado', others: 'todo el espacio' },
    hint: 'Arrastre para dar más espacio a un lado, hasta el borde para plegarlo; doble clic para partes iguales. Teclas: flechas, Intro',
  },

  zoom: { title: 'Ampliación', in: 'Ampliar', out: 'Reducir', fit: 'Mostrar todo' },
} as const;
