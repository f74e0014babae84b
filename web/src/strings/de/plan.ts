import type { PlanReport } from '../../wasm/cogmap_wasm';
import { number, whole } from '../words';

/** A floor plan that somebody brought, and its scale. */
export const plan = {
  title: 'Wie groß ist dieser Grundriss?',
  intro: (name: string, width: number, height: number) =>
    `${name}, ${whole(width)} × ${whole(height)} Pixel, sagt es nicht. Was weiß ist, wird Boden, alles andere fest.`,
  picture: 'Der Grundriss, mit dem Roboter im Maßstab dort, wo er beginnen würde',
  resolution: 'Meter je Pixel',
  width: 'Breite (m)',
  height: 'Höhe (m)',
  distance: 'Zwischen den Punkten (m)',
  measure: 'Eine der Zahlen genügt. Oder klicken Sie im Bild zwei Punkte an, deren Abstand Sie kennen, etwa die Seiten einer Tür.',
  measured: 'Sagen Sie, wie weit die Punkte voneinander entfernt sind; ziehen Sie sie dorthin, wo sie hingehören.',
  measuring: 'Der Grundriss wird angesehen …',
  becomes: ({ size: [width, height], floor, left_out }: PlanReport) =>
    `Ein Gebäude von ${number(width, 1)} m mal ${number(height, 1)} m mit ${whole(Math.round(floor))} m² Boden. Der Punkt ist der Roboter im Maßstab.` +
    (left_out >= 1 ? `\n${whole(Math.round(left_out))} m² bleiben weg, weil kein Weg dorthin führt.` : ''),
  cancel: 'Abbrechen',
  open: 'Gebäude öffnen',
  notLoaded: 'Die Frage nach dem Maßstab ließ sich nicht laden. Laden Sie die Seite neu und versuchen Sie es noch einmal.',
} as const;
