import type { PlacementKind, Place, RememberedKind, Whereabouts } from '../../wasm/cogmap_wasm';
import { count, moment, number } from '../words';

/** A direction seen from the robot. */
function direction(degrees: number): string {
  const turned = Math.round(Math.abs(degrees));
  if (turned < 5) return 'delante';
  if (turned > 175) return 'detrás';
  return `${turned}° a la ${degrees > 0 ? 'izquierda' : 'derecha'}`;
}

/** The way to the moment in which a thing came to be. */
const to = (what: string) => (view: number, t: number) => `Ir a la vista ${view}, a los ${moment(t)}, cuando ${what}`;

const titles: Record<RememberedKind, (number: number) => string> = {
  surface: (number) => `Superficie ${number}`,
  exit: (number) => `Salida ${number}`,
  supposed: (number) => `Salida supuesta ${number}`,
  asr: (number) => `Espacio local ${number}`,
};

const go: Record<RememberedKind, (view: number, t: number) => string> = {
  surface: to('se vio por primera vez'),
  exit: to('se encontró'),
  supposed: to('se vio por primera vez'),
  asr: to('se abrió'),
};

const rules: Record<PlacementKind, string> = {
  first: 'la primera vista fija el marco del mapa',
  reference: 'un objetivo de referencia sitúa la vista',
  weak_reference: 'un objetivo de referencia, con su lugar a lo largo de su línea adivinado',
  consensus: 'todas las superficies reconocidas juntas sitúan la vista',
  partly_odometry: 'todas las superficies reconocidas, y la odometría en una dirección que dejan abierta',
  transform: 'el movimiento, corregido hasta que las vistas encajan',
  odometry: 'lo que dicen las ruedas, sin corregir',
};

const relative: Record<PlacementKind, (recognised: number) => string> = {
  first: () => 'nada: el mapa empieza con ella',
  reference: () => 'el objetivo de referencia',
  weak_reference: () => 'el objetivo de referencia',
  consensus: (recognised) => count(recognised, 'superficie reconocida', 'superficies reconocidas'),
  partly_odometry: (recognised) => `${count(recognised, 'superficie reconocida', 'superficies reconocidas')} y la odometría`,
  transform: () => 'la vista anterior, por el movimiento',
  odometry: () => 'la vista anterior, por la odometría',
};

/** What is told about the things that a memory holds. */
export const telling = {
  pointed: {
    walk: 'Recorrer la memoria: ← → más antiguas y más nuevas, ↑ ↓ superficies, salidas y espacios locales, Intro conserva la ficha',
    keep: 'Haga clic para conservar esta ficha.',
    keepByKey: 'Intro conserva esta ficha, Escape la quita.',
    close: 'Cerrar la ficha',
    titles,
    go,
    labels: {
      seen: 'Vista por primera vez',
      last: 'Vista por última vez',
      relative: 'Situada respecto a',
      rule: 'Según la regla',
      length: 'Longitud',
      belongs: 'Pertenece a',
      width: 'Anchura',
      joins: 'Une',
      made: 'Encontrada',
      through: 'Atravesada',
      from: 'Vista desde',
      robot: 'El robot',
      opened: 'Abierto',
      entered: 'Visitado',
      area: 'Suelo visto',
      surfaces: 'Superficies',
      exits: 'Salidas',
      loops: 'Bucles cerrados',
      merged: 'Fue también',
    },
    view: (view: number, t: number) => `vista ${view}, ${moment(t)}`,
    once: 'solo entonces',
    sightings: (views: number) => `en ${count(views, 'vista', 'vistas')}`,
    relative,
    rules,
    metres: (length: string) => `${length}\u00a0m`,
    squareMetres: (area: string) => `${area}\u00a0m²`,
    through: (times: number, last: string) => (times <= 1 ? `una vez, ${last}` : `${times} veces, la última en ${last}`),
    looped: 'uno, al atravesarla',
    supposed: 'aún no: solo se ha visto',
    began: 'aquí se encontró el robot',
    entrance: (exit: number) => `tras la salida ${exit}`,
    entries: (times: number, last: string) => (times <= 1 ? `una vez, ${last}` : `${times} veces, la última en ${last}`),
    here: 'cree estar aquí',
    none: 'ninguno',
  },

  text: {
    title: 'Vista de texto',
    openHint: 'Qué contiene la memoria, en palabras y tablas: dónde cree estar el robot, lugares, salidas y superficies',
    close: 'Cerrar la vista de texto',
    loading: 'Trayendo la vista de texto…',
    failed: 'No se pudo traer la vista de texto. Ciérrela e inténtelo de nuevo.',
    waiting: 'Todavía no se ha visto nada.',
    whose: 'Memoria de',
    whoseHint: 'De quién es la memoria que se cuenta',
    lines: 'Qué contiene la memoria',
    chooseHint: 'Mostrar su historia en el dibujo',
    robot: 'Dónde cree estar el robot',
    whereabouts: ({ asr, home, turned_deg }: Whereabouts) => [
      ...(asr === undefined ? [] : [`En el espacio local ${asr}.`]),
      ...(home === undefined
        ? ['No sabe hacia dónde queda su casa.']
        : home.distance < 0.05
          ? ['En casa, donde empezó el recorrido.']
          : [`Su casa, donde empezó el recorrido, está a ${number(home.distance, 1)} m, ${direction(home.angle_deg)}.`]),
      Math.abs(turned_deg) < 0.5
        ? 'Mira hacia donde miraba al empezar.'
        : `Desde entonces ha girado ${Math.round(Math.abs(turned_deg))}° a la ${turned_deg > 0 ? 'izquierda' : 'derecha'}.`,
    ],
    asOf: (view: number, t: number) => `Según la vista ${view}, ${moment(t)}.`,
    behind: 'El robot ha seguido desde entonces; las palabras esperan mientras esté en una línea.',
    update: 'Actualizar',
    network: 'La red de lugares',
    noPlaces: (mapper: string) => `${mapper} no sabe qué es un espacio local.`,
    place: ({ current, surfaces }: Place, area: string) =>
      `${current ? 'aquí está el robot; ' : ''}${count(surfaces, 'superficie', 'superficies')}, ${area} m² de suelo vistos`,
    exitsOf: (asr: number) => `Salidas del espacio local ${asr}`,
    supposed: 'Salidas vistas, no atravesadas',
    surfaces: (all: number) => `Superficies: ${all}, primero las más cercanas`,
    surfacesOf: (asr: number | undefined, surfaces: number) =>
      `${asr === undefined ? 'En todas partes' : `En el espacio local ${asr}`}: ${count(surfaces, 'superficie', 'superficies')}`,
    more: (shown: number, all: number) => `Mostrar más (${shown} de ${all})`,
    columns: {
      exits: ['salida', 'al espacio', 'anchura', 'distancia', 'dirección'],
      supposed: ['salida', 'anchura', 'distancia', 'dirección'],
      surfaces: ['superficie', 'longitud', 'distancia', 'dirección'],
      age: 'edad',
    },
    direction,
    age: (seconds: number) => (seconds < 99.5 ? `${Math.round(seconds)}\u00a0s` : `${Math.round(seconds / 60)}\u00a0min`),
  },
} as const;
