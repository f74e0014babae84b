/** What is worth knowing about the page’s buildings, in Spanish. */
export const worlds: Readonly<Record<string, string>> = {
  'around-a-corner':
    'Una oficina que armarios, biombos y cajas dividen en dos, salvo un paso al este. El recorrido dobla esa esquina en 10 m; de lo que hay en medio el robot solo ve un lado, y aun ese en parte.',
  'box-course':
    'Una sala y un almacén, y entre ellos un estrechamiento lleno de filas de cajas de cartón: el recorrido es de 50 m, y el único camino a casa serpentea entre las cajas.',
  'environment-a':
    'Un ala con salas grandes y pasillos largos en torno a dos patios. La vuelta es de 120 m en 98 pasos y acaba donde empieza. El pasillo de la izquierda son 15,5 m de pared lisa: al recorrerlo, el láser, que ve 8 m, no encuentra ningún final.',
  'environment-b':
    'La planta de un instituto: ocho salas y pasillos en anillo en torno a un patio. La vuelta es de 90 m en 106 pasos; sale de la secretaría por una puerta y vuelve por la otra. Recorrida dos veces, como «two-laps», muestra qué mapas dibujan otra vez las mismas paredes.',
  'long-corridor':
    'Un taller y un aula, unidos por 20 m de pasillo liso. En medio, el láser, que ve 8 m, encuentra dos paredes y ningún final: nada dice cuánto ha avanzado el robot.',
  'long-office':
    'Una oficina larga con mesas junto a las ventanas. El recorrido va de un extremo al otro y vuelve un poco: 15 m en 34 pasos. Su mapa debería ser un simple rectángulo.',
  'narrow-passage':
    'Dos espacios amplios unidos por un paso estrecho: cruzarlo es entrar en otro lugar. El mismo recorrido sin nada estrecho está en «Sin paso».',
  'no-passage':
    'Un solo espacio cuya anchura cambia un poco por el camino: nada en él es estrecho, así que nadie lo llamaría dos lugares. El mismo recorrido con un paso estrecho está en «Paso estrecho».',
  office:
    'Seis salas a lo largo de un pasillo, con mesas, sillas, cajas y una sala de reuniones que tiene dos puertas. El recorrido es de 15 m en 34 pasos; el bucle vuelve al pasillo por la segunda puerta.',
  shortcut:
    'Dos oficinas junto a un pasillo, y entre ellas una puerta que el recorrido no usa: 30 m de ida, y por esa puerta la quinta parte hasta casa.',
  'small-office':
    'Una sala con mesas y un archivo tras una puerta abierta: lo bastante pequeño para ver cómo se reconoce cada superficie. El recorrido es de 6 m en 8 pasos.',
  tour:
    'Once salas en anillo. El recorrido empieza en la mitad este de la sala grande y vuelve a ella por su puerta oeste: el duodécimo espacio que encuentra es parte del primero.',
  'two-shortcuts':
    'Tres salas en fila, unidas por extremos alternos, y en cada pared divisoria un hueco por el que el recorrido pasa de largo: dos atajos en una misma ruta.',
  'u-trap':
    'Un entrante de nueve metros de fondo queda abierto hacia el robot en su camino a casa y está cerrado al final, lo que no se ve desde la entrada. Casa está detrás.',
};
