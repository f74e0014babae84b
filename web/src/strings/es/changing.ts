import type { Changed, Objection } from '../../wasm/cogmap_wasm';
import { day, plain } from '../words';

/** What is changed in a building while the robot is in it. */
export const changing = {
  changing: {
    open: 'Cambiar',
    openHint: 'Cambiar el edificio con el robot dentro: puertas, cajas, gente, los errores del robot, dónde está (B)',
    ofLog: 'Una grabación no tiene edificio que se pueda cambiar',
    title: 'Cambiar el edificio',
    close: 'Cerrar',
    toolsTitle: 'Qué se cambia',
    tools: { door: 'Puerta', drop: 'Dejar una caja', remove: 'Quitar', carry: 'Llevarse', person: 'Alguien', noise: 'Ruido' },
    hints: {
      door: 'Haga clic en una puerta para cerrarla o abrirla.',
      drop: 'Haga clic donde deba quedar una caja.',
      remove: 'Haga clic en la caja o el mueble que haya que quitar.',
      carry: 'Haga clic donde haya que dejar el robot. Su odometría no se dará cuenta.',
      person: 'Haga clic donde alguien deba pasear de un lado a otro.',
      noise: '1 × es el del propio robot. Vale desde ahora; los mapas no se enteran.',
    },
    noDoors: 'Este edificio no tiene puertas.',
    noBoxes: 'Aquí no hay nada que se pueda quitar.',
    which: 'Qué puerta',
    door: (name: string, open: boolean) => `${name} (${open ? 'abierta' : 'cerrada'})`,
    swing: (open: boolean) => (open ? 'Cerrarla' : 'Abrirla'),
    ahead: '1 m delante',
    aheadHint: 'La deja 1 m delante del robot',
    nearest: 'Lo más cercano',
    nearestHint: 'Quita lo que esté más cerca del robot',
    come: '2 m delante',
    comeHint: 'Hace aparecer a alguien 2 m delante del robot',
    noise: { odometry: 'odometría', laser: 'láser' },
    noiseHints: {
      odometry: 'Cuánto se equivocan las ruedas al contar, en múltiplos de los errores propios del robot',
      laser: 'Cuánto se dispersan las distancias, en múltiplos de los errores propios del láser',
    },
    times: (times: number) => `${plain(times)} ×`,
    where: 'Adónde',
    start: 'Donde empezó',
    setDown: 'Dejarlo allí',
    objection: (objection: Objection) => {
      switch (objection.kind) {
        case 'no_building':
          return 'Una grabación no tiene edificio que se pueda cambiar.';
        case 'no_door':
          return 'Ahí no hay ninguna puerta.';
        case 'no_box':
          return 'Ahí no hay nada que se pueda quitar.';
        case 'no_place':
          return 'En esa sala no queda sitio libre.';
        case 'drop':
          return `No se dejó ninguna caja: ${objection.reason}.`;
        case 'door':
          return `La puerta «${objection.name}» se queda como está: ${objection.reason}.`;
        case 'person':
          return `No vino nadie: ${objection.reason}.`;
        case 'carry':
          return `El robot se queda donde está: ${objection.reason}.`;
      }
    },
  },

  /** The ways into the editor of buildings, whose own words are loaded with it. */
  drafts: {
    open: 'Construir',
    openHint: 'Dibujar el edificio, o uno nuevo: paredes, cajas, puertas, salas, el comienzo y rutas (U)',
    edit: { name: 'Modificar el edificio', hint: 'aquel en el que está el robot, tal como está ahora' },
    blank: { name: 'Edificio nuevo', hint: 'una hoja en blanco con un comienzo' },
    ofLog: 'Una grabación no tiene edificio que modificar. Dibuje uno nuevo.',
    offer: (name: string, when: number) => `¿Seguir dibujando? ${name}, dejado el ${day(when)}.`,
    goOn: 'Seguir dibujando',
    loading: 'Abriendo el editor…',
    notLoaded: 'El editor no se pudo cargar. Vuelva a cargar la página e inténtelo de nuevo: no se ha perdido nada.',
  },

  /** What was changed around the robot. */
  changed: {
    door_opened: 'Se abrió una puerta',
    door_shut: 'Se cerró una puerta',
    box_dropped: 'Se dejó una caja',
    box_moved: 'Se movió una caja',
    box_removed: 'Se quitó una caja',
    somebody_came: 'Entró alguien',
    noise_changed: 'Se cambiaron los errores del robot',
  } satisfies Record<Changed, string>,
} as const;
