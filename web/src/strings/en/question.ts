import { number } from '../words';
import type { Outcome } from '../../state/trusting.svelte';

/** What each memory goes by, in few words. */
const BY: Record<string, string> = {
  perceptual: 'each view hung on one surface that it recognised',
  consensus: 'it goes by the walls that it recognised',
  transform: 'each step corrected until the views fitted',
  odometry: 'it only counts its wheels',
};

const by = (mapper: string): string => (BY[mapper] === undefined ? mapper : `${mapper}: ${BY[mapper]}`);
const NUMBERS = ['', 'one', 'two', 'three', 'four'];

/** The question that the page opens with, and what came of the answers. */
export const question = {
  asked: (memories: number) =>
    `One drive, ${NUMBERS[memories] ?? memories} memories. Drive on for a while: which of them would you trust to go home?`,
  answerHint: (mapper: string) => `Go home by ${by(mapper)}`,
  answer: (mapper: string) => `Trust ${mapper}`,
  again: (mapper: string) => `Now trust ${mapper}`,
  going: (mapper: string) => `On its way home by ${by(mapper)}.`,
  outcome: ({ by, distance, ended }: Outcome) =>
    ended === 'home'
      ? `By ${by} the robot stopped ${number(distance, 2)} m from where it began, sure to be home.`
      : `By ${by} the robot gave up ${number(distance, 2)} m from where it began.`,
  further: 'Small errors add up: undo that, drive further, and ask again.',
  led: (mapper: string) =>
    `Before, this run went home by ${mapper}, and a run has one memory for that: start over to trust another.`,
} as const;
