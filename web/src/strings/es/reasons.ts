import type { Reasons } from '../reasons';

/** What the engine gives as reasons, in Spanish. */
export const reasons: Reasons = {
  '{} % of ASR {} lies over ASR {}: the robot is back':
    'el {} % de ASR {} queda sobre ASR {}: el robot ha vuelto',
  'the robot knew this exit: it leads back into ASR {}':
    'el robot conocía esta salida: lleva de vuelta a ASR {}',
  '{} % of what is behind the exit belongs to ASR {}: the robot is back':
    'el {} % de lo que hay tras la salida pertenece a ASR {}: el robot ha vuelto',
  '{} m wide and wider on both sides of it along the way':
    'con {} m, más estrecha que el camino antes y después',
  'walls go on beside {} of its jambs':
    'la pared continúa junto a {} de sus jambas',
  'something is close before it, so it stands still and looks':
    'tiene algo muy cerca delante, así que se para y mira',
  'first it turns {}° right and looks':
    'primero gira {}° a la derecha y mira',
  'first it turns {}° left and looks':
    'primero gira {}° a la izquierda y mira',
  'it goes only {} cm on, for something is near':
    'avanza solo {} cm, porque hay algo cerca',
  'it goes only {} m on, for something is near':
    'avanza solo {} m, porque hay algo cerca',
  'it goes {} cm on':
    'avanza {} cm',
  'it goes {} m on':
    'avanza {} m',
  'it turns {}° right and goes {} cm on':
    'gira {}° a la derecha y avanza {} cm',
  'it turns {}° right and goes {} m on':
    'gira {}° a la derecha y avanza {} m',
  'it turns {}° left and goes {} cm on':
    'gira {}° a la izquierda y avanza {} cm',
  'it turns {}° left and goes {} m on':
    'gira {}° a la izquierda y avanza {} m',
  'the straight way home, {} m, is seen to be free':
    'el camino recto a casa, de {} m, se ve libre',
  'of the straight way home, {} m, the robot sees {} m to be free and hopes for the rest':
    'del camino recto a casa, de {} m, el robot ve libres {} m y confía en que el resto también lo esté',
  'one way on is open: {} m that the robot sees to be free, then it hopes for {} m straight home, {} m more than the beeline':
    'hay un camino abierto: {} m que el robot ve libres, y después confía en otros {} m en línea recta hasta casa, en total {} m más que la línea recta desde aquí',
  'of {} ways on that are open this one makes the straightest way home: {} m that the robot sees to be free, then it hopes for {} m straight home, {} m more than the beeline':
    'de {} caminos abiertos, este es el más recto a casa: {} m que el robot ve libres, y después confía en otros {} m en línea recta hasta casa, en total {} m más que la línea recta desde aquí',
  'the robot has lost the thread: nothing that it knows links this place with home':
    'el robot ha perdido el hilo: nada de lo que sabe une este lugar con su casa',
  'the way that seemed to lead home is closed, now that the robot sees it':
    'el camino que parecía llevar a casa está cerrado, ahora que el robot lo ve',
  'there is a way on toward home again, so the remembered route is left':
    'vuelve a haber un camino hacia casa, así que deja la ruta recordada',
  'no free way leads on toward home':
    'ningún camino libre lleva hacia casa',
  'the last decisions led nowhere':
    'las últimas decisiones no llevaron a nada',
  'no way on, and the way that the robot came is blocked too':
    'no hay por dónde seguir, y el camino por el que vino el robot también está cortado',
  'back along the way that the robot came, until a way on toward home comes into sight: the next of {} waypoints is {} m away':
    'de vuelta por donde vino el robot, hasta que se vea un camino hacia casa: el siguiente de {} puntos de paso está a {} m',
  'no way on, and no remembered route leads home':
    'no hay por dónde seguir, y ninguna ruta recordada lleva a casa',
  'home is believed to be {} m away and no way leads nearer':
    'cree que su casa está a {} m, y ningún camino lleva más cerca',
  'somebody is walking by, so it waits':
    'alguien pasa caminando, así que espera',
  'the robot has lost its way: nothing that it sees tells it where home is':
    'el robot se ha perdido: nada de lo que ve le dice dónde está su casa',
  'home itself cannot be reached: {} m is as near as the robot gets':
    'no se puede llegar a la propia casa: el robot no puede acercarse a menos de {} m',
  'the way that the robot had in mind is closed':
    'el camino que el robot tenía en mente está cerrado',
  'a shorter way has come to light':
    'ha aparecido un camino más corto',
  'plans have got the robot nowhere, so it goes by its eyes and the way that it came alone: {} m home':
    'los planes no han llevado al robot a ninguna parte, así que se fía solo de sus ojos y del camino por el que vino: {} m a casa',
  'the best way home that the robot can think of is {} m long, {} m of it through places that it has not seen free, and through where it saw a wall long ago, which it hopes is gone':
    'el mejor camino a casa que se le ocurre al robot mide {} m, {} m de ellos por sitios que no ha visto libres, y pasa por donde hace tiempo vio una pared que espera que ya no esté',
  'the best way home that the robot can think of is {} m long, {} m of it through places that it has not seen but hopes to be free':
    'el mejor camino a casa que se le ocurre al robot mide {} m, {} m de ellos por sitios que no ha visto, pero que espera que estén libres',
  'the best way home that the robot can think of is {} m long, all of it through places that it has seen free':
    'el mejor camino a casa que se le ocurre al robot mide {} m, y lo ha visto libre entero',
  'the robot has come on again and plans as before':
    'el robot ha vuelto a avanzar y planea como antes',
  'the robot has not come on for {} decisions':
    'el robot lleva {} decisiones sin avanzar',
  'the fail-safe has been called {} times in vain':
    'se ha recurrido {} veces en vano al modo de seguridad',
  'the robot has gone many times its way out without coming home':
    'el robot ha recorrido varias veces la longitud del camino de ida sin llegar a casa',
  'every way home that the robot knows or can think of is closed':
    'todos los caminos a casa que el robot conoce o se imagina están cerrados',
  'what the robot remembers leaves no way: it trusts its eyes alone':
    'lo que el robot recuerda no deja ningún camino: se fía solo de sus ojos',
  'every way home that the robot knows or can think of seems closed':
    'todos los caminos a casa que el robot conoce o se imagina parecen cerrados',
  'no remembered way leads home':
    'ningún camino recordado lleva a casa',
  'something stands in the way that the robot came':
    'hay algo en el camino por el que vino el robot',
  'the robot goes back the way that it came: the next of {} waypoints is {} m away':
    'el robot vuelve por donde vino: el siguiente de {} puntos de paso está a {} m',
  'home is believed to be {} m away, which is near enough to stop':
    'cree que su casa está a {} m, lo bastante cerca para parar',
  'the robot does not know where home is':
    'el robot no sabe dónde está su casa',
  'home is {} m away, and the robot sees nothing in between':
    'su casa está a {} m, y el robot no ve nada en medio',
  'home is {} m away with something in between: the robot goes for the end of it that makes the shortest way, {} m':
    'su casa está a {} m y hay algo en medio: el robot va hacia el extremo que da el camino más corto, de {} m',
  'the robot sees a place that is nearer to home than all that it went along, and goes there':
    'el robot ve un sitio más cerca de casa que todo lo que ha bordeado, y va hacia él',
  'no way on leads nearer to home, so the robot goes along what is in its way until it sees a place that is less than {} m from home':
    'ningún camino lleva más cerca de casa, así que el robot bordea lo que le corta el paso hasta ver un sitio a menos de {} m de casa',
  'the robot has gone round what is in its way without finding a gap':
    'el robot ha dado la vuelta a lo que le corta el paso sin encontrar un hueco',
  'one who sees the building leads the way: the start is {} m off':
    'alguien que ve el edificio marca el camino: el comienzo está a {} m',
  'the start is {} m away':
    'el comienzo está a {} m',
  'no way leads back':
    'ningún camino lleva de vuelta',
  'something stands in the way':
    'hay algo en el camino',
  'after {} decisions the robot is not home':
    'tras {} decisiones el robot no está en casa',
  'the robot has not seen anything yet':
    'el robot aún no ha visto nada',
};
