/** What is worth knowing about the page’s buildings, in German. */
export const worlds: Readonly<Record<string, string>> = {
  'around-a-corner':
    'Ein Büro, durch Schränke, Stellwände und Kartons bis auf einen Durchgang im Osten zweigeteilt. Die Fahrt führt 10 m um diese Ecke; von dem, was in der Mitte steht, sieht der Roboter nur die eine Seite, und auch die nur zum Teil.',
  'box-course':
    'Eine Halle und ein Lager, dazwischen eine Engstelle voller Kistenreihen: Die Fahrt ist 50 m lang, und der einzige Weg nach Hause windet sich durch die Kisten.',
  'environment-a':
    'Ein Gebäudeflügel mit großen Räumen und langen Fluren um zwei Höfe. Die Runde ist 120 m lang, hat 98 Schritte und endet, wo sie beginnt. Der Flur links besteht aus 15,5 m glatter Wand: Auf dem Weg hindurch findet der Laser, der 8 m weit sieht, kein Ende.',
  'environment-b':
    'Die Etage eines Instituts: acht Räume und Flure im Kreis um einen Hof. Die Runde ist 90 m lang und hat 106 Schritte; sie verlässt das Sekretariat durch die eine Tür und kommt durch die andere zurück. Zweimal gefahren, als „two-laps“, zeigt sie, welche Karten dieselben Wände noch einmal zeichnen.',
  'long-corridor':
    'Eine Werkstatt und ein Seminarraum, verbunden durch 20 m glatten Flur. In seiner Mitte findet der Laser, der 8 m weit sieht, zwei Wände und kein Ende: Nichts sagt, wie weit der Roboter gekommen ist.',
  'long-office':
    'Ein langes Büro mit Tischen entlang der Fenster. Die Fahrt führt von einem Ende zum anderen und ein Stück zurück: 15 m in 34 Schritten. Eine Karte davon sollte ein schlichtes Rechteck sein.',
  'narrow-passage':
    'Zwei weite Räume, die ein enger Durchgang verbindet: Wer ihn durchquert, kommt an einen anderen Ort. Derselbe Weg ohne Enge ist in „Kein Durchgang“.',
  'no-passage':
    'Ein Raum, dessen Breite sich unterwegs ein wenig ändert: Nichts darin ist eng, also würde ihn niemand zwei Orte nennen. Derselbe Weg mit einem engen Durchgang ist in „Enger Durchgang“.',
  office:
    'Sechs Räume entlang eines Flurs, mit Tischen, Stühlen, Kartons und einem Besprechungsraum, der zwei Türen hat. Die Fahrt ist 15 m lang und hat 34 Schritte; die Schleife kommt durch die zweite Tür in den Flur zurück.',
  shortcut:
    'Zwei Büros neben einem Flur und zwischen ihnen eine Tür, die die Fahrt nicht benutzt: 30 m hin, und durch diese Tür ein Fünftel davon nach Hause.',
  'small-office':
    'Ein Raum mit Tischen und ein Archiv hinter einer offenen Tür: klein genug, um zuzusehen, wie jede Fläche wiedererkannt wird. Die Fahrt ist 6 m lang und hat 8 Schritte.',
  tour:
    'Elf Räume im Kreis. Die Fahrt beginnt in der östlichen Hälfte der Halle und kommt durch deren westliche Tür zurück: Der zwölfte Raum, dem der Roboter begegnet, ist ein Teil des ersten.',
  'two-shortcuts':
    'Drei Hallen hintereinander, an wechselnden Enden verbunden, und in jeder Trennwand ein Durchgang, an dem die Fahrt vorbeiführt: zwei Abkürzungen auf einer Strecke.',
  'u-trap':
    'Eine neun Meter tiefe Nische steht dem Roboter auf dem Heimweg offen und ist am anderen Ende zu, was vom Eingang aus nicht zu sehen ist. Das Zuhause liegt dahinter.',
};
