import type { PlanReport } from '../../wasm/cogmap_wasm';
import { number, whole } from '../words';

/** A floor plan that somebody brought, and its scale. */
export const plan = {
  title: '¿Qué tamaño tiene este plano?',
  intro: (name: string, width: number, height: number) =>
    `${name}, de ${whole(width)} × ${whole(height)} píxeles, no lo dice. Lo blanco será suelo; lo demás, sólido.`,
  picture: 'El plano, con el robot a escala donde empezaría',
  resolution: 'Metros por píxel',
  width: 'Anchura (m)',
  height: 'Altura (m)',
  distance: 'Entre los puntos (m)',
  measure: 'Basta uno de estos números. O haga clic en dos puntos de la imagen cuya distancia conozca, como los lados de una puerta.',
  measured: 'Diga a qué distancia están los dos puntos; arrástrelos adonde deban estar.',
  measuring: 'Examinando el plano…',
  becomes: ({ size: [width, height], floor, left_out }: PlanReport) =>
    `Un edificio de ${number(width, 1)} m por ${number(height, 1)} m con ${whole(Math.round(floor))} m² de suelo. El punto es el robot, a escala.` +
    (left_out >= 1 ? `\n${whole(Math.round(left_out))} m² quedan fuera, porque ningún camino lleva allí.` : ''),
  cancel: 'Cancelar',
  open: 'Abrir el edificio',
  notLoaded: 'No se pudo cargar la pregunta por la escala del plano. Recargue la página e inténtelo de nuevo.',
} as const;
