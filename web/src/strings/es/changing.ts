import type { Changed, Objection } from '../../wasm/cogmap_wasm';

/** What is changed in a building while the robot is in it. */
export const changing = {
  changing: {
    open: 'Cambiar',
    openHint: 'Cambiar el edificio con el robot dentro: puertas, cajas, dónde está el robot (B)',
    ofLog: 'Una grabación no tiene edificio que se pueda cambiar',
    title: 'Cambiar el edificio',
    close: 'Cerrar',
    toolsTitle: 'Qué se cambia',
    tools: { door: 'Puerta', drop: 'Dejar una caja', remove: 'Quitar', carry: 'Llevarse' },
    hints: {
      door: 'Haga clic en una puerta para cerrarla o abrirla.',
      drop: 'Haga clic donde deba quedar una caja.',
      remove: 'Haga clic en la caja o el mueble que haya que quitar.',
      carry: 'Haga clic donde haya que dejar el robot. Su odometría no se dará cuenta.',
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
        case 'carry':
          return `El robot se queda donde está: ${objection.reason}.`;
      }
    },
  },

  /** What was changed around the robot. */
  changed: {
    door_opened: 'Se abrió una puerta',
    door_shut: 'Se cerró una puerta',
    box_dropped: 'Se dejó una caja',
    box_moved: 'Se movió una caja',
    box_removed: 'Se quitó una caja',
    somebody_came: 'Entró alguien',
  } satisfies Record<Changed, string>,
} as const;
