/** How to use the page. */
export const help = {
  open: 'Tastenkürzel',
  title: 'So benutzen Sie das Labor',
  intro:
    'Links das Gebäude, wie es ist; rechts, was der Roboter davon im Gedächtnis hat, zusammengesetzt aus dem, was sein Laser sieht. Seine Odometrie ist falsch, und niemand sagt ihm je die Wahrheit.',
  pointing:
    'Klicken oder tippen Sie in die Welt, um den Roboter dorthin zu schicken: Er dreht sich, fährt geradeaus und sieht sich um. Ziehen verschiebt alle Ansichten, Scrollen oder Spreizen vergrößert sie.',
  gamepad:
    'Ein Gamepad wird gefunden, sobald Sie eine seiner Tasten drücken: linker Stick oder Steuerkreuz fährt, A fährt heim, B hält an, Start spielt ab und pausiert.',
  keys: 'Tasten',
  single: 'Kürzel aus einem Buchstaben benutzen',
  close: 'Schließen',
  list: [
    { keys: ['↑ ↓ ← →', 'W A S D'], does: 'fahren und drehen' },
    { keys: ['Leertaste'], does: 'abspielen oder pausieren' },
    { keys: ['.'], does: 'weiter zur nächsten Ansicht' },
    { keys: ['F'], does: 'sofort dorthin, wo der Roboter getan hat, was ihm gesagt wurde' },
    { keys: ['H'], does: 'nach Hause' },
    { keys: ['X'], does: 'den Roboter anhalten' },
    { keys: ['R'], does: 'von vorn' },
    { keys: ['[', ']'], does: 'langsamer, schneller' },
    { keys: ['+', '−', '0'], does: 'vergrößern, verkleinern, alles zeigen' },
    { keys: ['C'], does: 'Farbe nach Ansicht, lokalem Raum oder Alter' },
    { keys: ['G'], does: 'die Gedächtnisse von außen, vom Roboter, vom Eingang aus sehen' },
    { keys: ['E', 'N', 'P', 'O'], does: 'Ausgänge, Netz, Pläne, Wahrheit zeigen' },
    { keys: ['<', '>'], does: 'zum vorigen, zum nächsten Ereignis' },
    { keys: ['Strg Z', 'Strg Umschalt Z'], does: 'rückgängig machen, was Sie dem Roboter sagten oder änderten, und es wiederholen' },
    { keys: ['B'], does: 'das Gebäude ändern: Türen, Kisten, Leute, Fehler, wo der Roboter steht' },
    { keys: ['U'], does: 'das Gebäude bearbeiten oder ein neues zeichnen' },
    { keys: ['V'], does: 'hinüber zum anderen Zweig' },
    { keys: ['Y'], does: 'warum? Den letzten Schritt zerlegen' },
    { keys: ['J', 'K'], does: 'vorige, nächste Stufe dieses Schritts' },
    { keys: ['L'], does: 'Diagramme: Weite, Fehler und Flächen im Lauf der Fahrt, und die Räume als Schema' },
    { keys: ['T'], does: 'hell oder dunkel' },
    { keys: ['Esc'], does: 'schließen, was offen ist, oder eine Aufzeichnung abbrechen' },
    { keys: ['?'], does: 'diese Liste' },
  ],
} as const;
