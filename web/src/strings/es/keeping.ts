import { day, moment, whole } from '../words';

/** What is opened, saved, shared and kept. */
export const keeping = {
  files: {
    open: 'Abrir…',
    openHint: 'Abrir una grabación (CARMEN), una sesión, un mundo o un plano (PNG o PGM, también con su YAML de map_server). Soltar un archivo sobre la página hace lo mismo.',
    save: 'Guardar, compartir',
    link: { name: 'Copiar enlace', hint: 'al abrirlo se llega exactamente a este momento de este recorrido' },
    picture: { name: 'Imagen', hint: 'el mundo y las memorias con sus leyendas, como PNG' },
    drawing: { name: 'Dibujo', hint: 'lo mismo como SVG, para ampliar, retocar o imprimir' },
    session: { name: 'Sesión', hint: 'al abrirla se repite exactamente este recorrido' },
    map: {
      name: 'Mapa',
      of: (mapper: string) => `Mapa según ${mapper}`,
      hint: 'superficies, salidas, espacios locales y el camino, como JSON',
    },
    table: { name: 'Tabla', hint: 'dónde estaba el robot y dónde creía estar, vista por vista, como CSV' },
    everything: { name: 'Todo', hint: 'sesión, mapas, dibujo, tabla, trayectorias (TUM) y grafos de poses (g2o), en un archivo ZIP' },
    drop: 'Suéltelo aquí',
    dropHint: 'Una grabación (CARMEN, comprimida o no), una sesión, un mundo o un plano (PNG, PGM)',
    reading: (name: string) => `Leyendo ${name}…`,
    refused: (reason: string) => `No ha sido posible. ${reason}`,
    tooMany: (number: number) => `Son ${number} archivos. Puede ser uno, o dos que van juntos: una sesión con su grabación, o la imagen de un plano con su YAML.`,
    dismiss: 'Cerrar',
  },

  link: {
    name: 'El enlace',
    label: 'Enlace',
    copied: 'El enlace a este preciso momento está copiado: péguelo donde quiera.',
    byHand: 'Su navegador no deja que la página copie. Este es el enlace a este preciso momento:',
    tooLong: (length: number) =>
      `Este recorrido es demasiado largo para un enlace: tendría ${whole(length)} caracteres, y muchos programas cortan enlaces así. Guarde la sesión como archivo y envíela.`,
    ofLog: 'Una grabación no cabe en un enlace. Guarde la sesión y envíela junto con la grabación.',
    saveSession: 'Guardar sesión',
    refused: (reason: string) => `El enlace no se pudo abrir. ${reason}\nLa página muestra en su lugar la escena con la que suele empezar.`,
    broken: 'Está dañado: le falta algo o cambió por el camino. Pídalo de nuevo, o pida el archivo de la sesión.',
    huge: 'Contiene mucho más que cualquier enlace de esta página, así que no se desempaquetó.',
    version: 'Lo hizo otra versión de esta página, que escribe los enlaces de otro modo. Ábralo con esa versión.',
  },

  kept: {
    name: 'El recorrido guardado',
    offer: ({ name, time, when }: { name: string; time: number; when: number }) =>
      `¿Seguir donde estaba? ${name}, a los ${moment(time)} del recorrido, dejado el ${day(when)}.`,
    takeUp: 'Seguir',
    refused: (reason: string) => `El recorrido guardado no se puede retomar. ${reason}`,
    recovered:
      'El motor del laboratorio se detuvo de improviso. Se ha vuelto a poner en marcha y su recorrido sigue donde estaba.',
    startedOver: 'El motor del laboratorio se detuvo de improviso. Se ha vuelto a poner en marcha, y con él el recorrido.',
  },

  address: {
    world: (name: string, known: string[]) => `Aquí no hay ningún mundo llamado «${name}». Los que hay: ${known.join(', ')}.`,
    number: (key: string, written: string) =>
      `«${written}» no vale para ${key}: hace falta un número entero, como en ${key}=7.`,
    mappers: (unknown: string[], known: string[]) =>
      `No hay ningún método llamado ${unknown.map((name) => `«${name}»`).join(' o ')}. Los que hay: ${known.join(', ')}; caben hasta cuatro, como en mappers=consensus,odometry.`,
  },

  embed: { whole: 'Abrir la página completa' },
} as const;
