import type { PlanReport } from '../../wasm/cogmap_wasm';
import { number, whole } from '../words';

/** A floor plan that somebody brought, and its scale. */
export const plan = {
  title: 'How large is this floor plan?',
  intro: (name: string, width: number, height: number) =>
    `${name}, ${whole(width)} × ${whole(height)} pixels, does not say. What is white in it becomes floor, the rest solid.`,
  picture: 'The floor plan, with the robot to scale where it would begin',
  resolution: 'Metres a pixel',
  width: 'Width (m)',
  height: 'Height (m)',
  distance: 'Between the points (m)',
  measure: 'Say any of these. Or click two points in the picture whose distance you know, such as the sides of a door.',
  measured: 'Say how far the two points are from each other; drag them to where they belong.',
  measuring: 'Looking at the plan…',
  becomes: ({ size: [width, height], floor, left_out }: PlanReport) =>
    `A building of ${number(width, 1)} m by ${number(height, 1)} m with ${whole(Math.round(floor))} m² of floor. The dot is the robot, to scale.` +
    (left_out >= 1 ? `\n${whole(Math.round(left_out))} m² are left out, because no way leads there.` : ''),
  cancel: 'Cancel',
  open: 'Open the building',
  notLoaded: 'The question for the plan’s scale could not be loaded. Reload the page and try again.',
} as const;
