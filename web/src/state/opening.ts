import type { Address } from '../keep/address';
import type { Choice, Offer } from '../worker/protocol';

/** The building that the page opens on. */
export const OPENING_WORLD = 'office';
/** The mapper whose memory stands beside the first one's when the page opens: which of them is to be trusted? */
const OPENING_RIVAL = 'odometry';
/** How many views of it the robot has taken when the page opens: enough to see what a memory is. */
export const OPENING_VIEWS = 6;

/** What the page opens on, and what there is to say about what its address asks for in vain. */
export function opening(offer: Offer, address: Address): { choice: Partial<Choice>; complaints: string[] } {
  const { robot, mapper, seed } = offer.choices;
  const world = offer.worlds.find(({ file }) => file === OPENING_WORLD) ?? offer.worlds[0];
  const mappers = address.embed ? [mapper] : [mapper, OPENING_RIVAL];
  const { asked, complaints } = address.choice(offer);
  return { choice: { world: world?.file ?? '', robot, mappers, seed, ...asked }, complaints };
}
