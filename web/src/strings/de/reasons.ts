import type { Reasons } from '../reasons';

/** What the engine gives as reasons, in German. */
export const reasons: Reasons = {
  '{} % of ASR {} lies over ASR {}: the robot is back':
    '{} % von ASR {} liegen über ASR {}: Der Roboter ist zurück',
  'the robot knew this exit: it leads back into ASR {}':
    'der Roboter kannte diesen Ausgang: Er führt zurück in ASR {}',
  '{} % of what is behind the exit belongs to ASR {}: the robot is back':
    '{} % von dem, was hinter dem Ausgang liegt, gehören zu ASR {}: Der Roboter ist zurück',
  '{} m wide and wider on both sides of it along the way':
    'mit {} m schmaler als der Weg davor und dahinter',
  'walls go on beside {} of its jambs':
    'auf {} seiner beiden Seiten geht die Wand weiter',
  'something is close before it, so it stands still and looks':
    'dicht vor ihm ist etwas, also bleibt er stehen und schaut',
  'first it turns {}° right and looks':
    'erst dreht er sich {}° nach rechts und schaut',
  'first it turns {}° left and looks':
    'erst dreht er sich {}° nach links und schaut',
  'it goes only {} cm on, for something is near':
    'er fährt nur {} cm weiter, denn es ist etwas in der Nähe',
  'it goes only {} m on, for something is near':
    'er fährt nur {} m weiter, denn es ist etwas in der Nähe',
  'it goes {} cm on':
    'er fährt {} cm weiter',
  'it goes {} m on':
    'er fährt {} m weiter',
  'it turns {}° right and goes {} cm on':
    'er dreht sich {}° nach rechts und fährt {} cm weiter',
  'it turns {}° right and goes {} m on':
    'er dreht sich {}° nach rechts und fährt {} m weiter',
  'it turns {}° left and goes {} cm on':
    'er dreht sich {}° nach links und fährt {} cm weiter',
  'it turns {}° left and goes {} m on':
    'er dreht sich {}° nach links und fährt {} m weiter',
  'the straight way home, {} m, is seen to be free':
    'der gerade Weg nach Hause, {} m, ist erkennbar frei',
  'of the straight way home, {} m, the robot sees {} m to be free and hopes for the rest':
    'vom geraden Weg nach Hause, {} m, sieht der Roboter {} m frei und hofft, dass es auch der Rest ist',
  'one way on is open: {} m that the robot sees to be free, then it hopes for {} m straight home, {} m more than the beeline':
    'ein Weg ist offen: {} m, die der Roboter frei sieht, dann hofft er auf weitere {} m geradewegs nach Hause, insgesamt {} m mehr als die Luftlinie',
  'of {} ways on that are open this one makes the straightest way home: {} m that the robot sees to be free, then it hopes for {} m straight home, {} m more than the beeline':
    'von {} offenen Wegen führt dieser am geradesten nach Hause: {} m, die der Roboter frei sieht, dann hofft er auf weitere {} m geradewegs nach Hause, insgesamt {} m mehr als die Luftlinie',
  'the robot has lost the thread: nothing that it knows links this place with home':
    'der Roboter hat den Faden verloren: Nichts, was er weiß, verbindet diesen Ort mit dem Zuhause',
  'the way that seemed to lead home is closed, now that the robot sees it':
    'der Weg, der nach Hause zu führen schien, ist zu, wie der Roboter jetzt sieht',
  'there is a way on toward home again, so the remembered route is left':
    'es gibt wieder einen Weg Richtung Zuhause, also wird die erinnerte Route verlassen',
  'no free way leads on toward home':
    'kein freier Weg führt weiter Richtung Zuhause',
  'the last decisions led nowhere':
    'die letzten Entscheidungen führten zu nichts',
  'no way on, and the way that the robot came is blocked too':
    'es geht nicht weiter, und auch der Weg, den der Roboter kam, ist versperrt',
  'back along the way that the robot came, until a way on toward home comes into sight: the next of {} waypoints is {} m away':
    'zurück auf dem Weg, den der Roboter kam, bis ein Weg Richtung Zuhause in Sicht kommt: Der nächste von {} Wegpunkten ist {} m entfernt',
  'no way on, and no remembered route leads home':
    'es geht nicht weiter, und keine erinnerte Route führt nach Hause',
  'home is believed to be {} m away and no way leads nearer':
    'das Zuhause ist vermutlich {} m entfernt, und kein Weg führt näher heran',
  'somebody is walking by, so it waits':
    'jemand geht vorbei, also wartet der Roboter',
  'the robot has lost its way: nothing that it sees tells it where home is':
    'der Roboter hat sich verirrt: Nichts, was er sieht, sagt ihm, wo das Zuhause ist',
  'home itself cannot be reached: {} m is as near as the robot gets':
    'das Zuhause selbst ist nicht zu erreichen: Näher als {} m kommt der Roboter nicht heran',
  'the way that the robot had in mind is closed':
    'der Weg, den der Roboter im Sinn hatte, ist zu',
  'a shorter way has come to light':
    'ein kürzerer Weg hat sich gezeigt',
  'plans have got the robot nowhere, so it goes by its eyes and the way that it came alone: {} m home':
    'Pläne haben den Roboter nicht weitergebracht, also verlässt er sich allein auf seine Augen und den Weg, den er kam: {} m nach Hause',
  'the best way home that the robot can think of is {} m long, {} m of it through places that it has not seen free, and through where it saw a wall long ago, which it hopes is gone':
    'der beste Weg nach Hause, der dem Roboter einfällt, ist {} m lang, davon {} m, die er nicht frei gesehen hat, und führt dort hindurch, wo er vor Langem eine Wand sah, die hoffentlich weg ist',
  'the best way home that the robot can think of is {} m long, {} m of it through places that it has not seen but hopes to be free':
    'der beste Weg nach Hause, der dem Roboter einfällt, ist {} m lang, davon {} m, die er nicht gesehen hat, aber für frei hält',
  'the best way home that the robot can think of is {} m long, all of it through places that it has seen free':
    'der beste Weg nach Hause, der dem Roboter einfällt, ist {} m lang, und er hat ihn überall frei gesehen',
  'the robot has come on again and plans as before':
    'der Roboter ist wieder vorangekommen und plant wie zuvor',
  'the robot has not come on for {} decisions':
    'der Roboter ist {} Entscheidungen lang nicht vorangekommen',
  'the fail-safe has been called {} times in vain':
    'die Absicherung hat {} Mal vergeblich eingegriffen',
  'the robot has gone many times its way out without coming home':
    'der Roboter ist ein Vielfaches seines Hinwegs gefahren, ohne nach Hause zu kommen',
  'every way home that the robot knows or can think of is closed':
    'jeder Weg nach Hause, den der Roboter kennt oder der ihm einfällt, ist zu',
  'what the robot remembers leaves no way: it trusts its eyes alone':
    'was der Roboter im Gedächtnis hat, lässt keinen Weg offen: Er traut nur seinen Augen',
  'every way home that the robot knows or can think of seems closed':
    'jeder Weg nach Hause, den der Roboter kennt oder der ihm einfällt, scheint zu',
  'no remembered way leads home':
    'kein erinnerter Weg führt nach Hause',
  'something stands in the way that the robot came':
    'auf dem Weg, den der Roboter kam, steht etwas',
  'the robot goes back the way that it came: the next of {} waypoints is {} m away':
    'der Roboter fährt den Weg zurück, den er kam: Der nächste von {} Wegpunkten ist {} m entfernt',
  'home is believed to be {} m away, which is near enough to stop':
    'das Zuhause ist vermutlich {} m entfernt: nah genug, um anzuhalten',
  'the robot does not know where home is':
    'der Roboter weiß nicht, wo das Zuhause ist',
  'home is {} m away, and the robot sees nothing in between':
    'das Zuhause ist {} m entfernt, und der Roboter sieht nichts dazwischen',
  'home is {} m away with something in between: the robot goes for the end of it that makes the shortest way, {} m':
    'das Zuhause ist {} m entfernt, und etwas steht dazwischen: Der Roboter fährt auf das Ende davon zu, das den kürzesten Weg ergibt, {} m',
  'the robot sees a place that is nearer to home than all that it went along, and goes there':
    'der Roboter sieht eine Stelle, die näher am Zuhause liegt als alles, woran er entlangfuhr, und fährt hin',
  'no way on leads nearer to home, so the robot goes along what is in its way until it sees a place that is less than {} m from home':
    'kein Weg führt näher ans Zuhause, also fährt der Roboter an dem entlang, was im Weg steht, bis er eine Stelle sieht, die weniger als {} m vom Zuhause entfernt ist',
  'the robot has gone round what is in its way without finding a gap':
    'der Roboter ist um das herumgefahren, was im Weg steht, ohne eine Lücke zu finden',
  'one who sees the building leads the way: the start is {} m off':
    'jemand, der das Gebäude sieht, weist den Weg: Der Start ist {} m entfernt',
  'the start is {} m away':
    'der Start ist {} m entfernt',
  'no way leads back':
    'kein Weg führt zurück',
  'something stands in the way':
    'etwas steht im Weg',
  'after {} decisions the robot is not home':
    'nach {} Entscheidungen ist der Roboter noch nicht zu Hause',
  'the robot has not seen anything yet':
    'der Roboter hat noch nichts gesehen',
};
