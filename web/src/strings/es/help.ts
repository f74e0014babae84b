/** How to use the page. */
export const help = {
  open: 'Atajos de teclado',
  title: 'Cómo se usa el laboratorio',
  intro:
    'A la izquierda, el edificio tal como es; a la derecha, la memoria que el robot tiene de él, compuesta de lo que ve su láser. Su odometría es falsa y nadie le dice nunca la verdad.',
  pointing:
    'Haga clic o toque en el mundo para enviar allí el robot: gira, avanza recto y mira. Arrastre para mover todas las vistas; desplace o separe los dedos para ampliar.',
  gamepad:
    'Un mando se encuentra en cuanto pulsa uno de sus botones: la palanca izquierda o la cruceta conduce, A va a casa, B para, Start reproduce y pausa.',
  keys: 'Teclas',
  single: 'Usar atajos de una sola letra',
  close: 'Cerrar',
  list: [
    { keys: ['↑ ↓ ← →', 'W A S D'], does: 'conducir y girar' },
    { keys: ['Espacio'], does: 'reproducir o pausar' },
    { keys: ['.'], does: 'seguir hasta la vista siguiente' },
    { keys: ['F'], does: 'pasar de inmediato a cuando el robot haya hecho lo que se le dijo' },
    { keys: ['H'], does: 'ir a casa' },
    { keys: ['X'], does: 'parar el robot' },
    { keys: ['R'], does: 'empezar de nuevo' },
    { keys: ['[', ']'], does: 'más despacio, más deprisa' },
    { keys: ['+', '−', '0'], does: 'ampliar, reducir, mostrar todo' },
    { keys: ['C'], does: 'color según vista, espacio local o antigüedad' },
    { keys: ['G'], does: 'ver las memorias desde fuera, desde el robot, desde la entrada' },
    { keys: ['E', 'N', 'P', 'O'], does: 'mostrar salidas, red, planes, verdad' },
    { keys: ['<', '>'], does: 'al suceso anterior, al siguiente' },
    { keys: ['Ctrl Z', 'Ctrl Mayús Z'], does: 'deshacer lo que le dijo al robot o cambió, y rehacerlo' },
    { keys: ['B'], does: 'cambiar el edificio: puertas, cajas, gente, errores, dónde está el robot' },
    { keys: ['U'], does: 'modificar el edificio o dibujar uno nuevo' },
    { keys: ['V'], does: 'pasar a la otra rama' },
    { keys: ['Y'], does: '¿por qué? Desmontar el último paso' },
    { keys: ['J', 'K'], does: 'fase anterior, fase siguiente de ese paso' },
    { keys: ['L'], does: 'gráficas: anchura, errores y superficies a lo largo del recorrido, y los lugares en un esquema' },
    { keys: ['T'], does: 'claro u oscuro' },
    { keys: ['Esc'], does: 'cerrar lo que esté abierto, o cancelar una grabación' },
    { keys: ['?'], does: 'esta lista' },
  ],
} as const;
