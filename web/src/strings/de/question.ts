import { number } from '../words';
import type { Outcome } from '../../state/trusting.svelte';

/** Wonach sich jedes Gedächtnis richtet, kurz gesagt. */
const BY: Record<string, string> = {
  perceptual: 'jede Ansicht an einer wiedererkannten Fläche aufgehängt',
  consensus: 'nach den wiedererkannten Wänden',
  transform: 'jeder Schritt berichtigt, bis die Ansichten passten',
  odometry: 'nur die Räder gezählt',
};

const by = (mapper: string): string => (BY[mapper] === undefined ? mapper : `${mapper}: ${BY[mapper]}`);
const NUMBERS = ['', 'ein', 'zwei', 'drei', 'vier'];

export const question = {
  asked: (memories: number) =>
    `Eine Fahrt, ${NUMBERS[memories] ?? memories} Gedächtnisse. Fahren Sie ein Stück: Welchem würden Sie den Heimweg anvertrauen?`,
  answerHint: (mapper: string) => `Heimfahren nach ${by(mapper)}`,
  answer: (mapper: string) => `${mapper} vertrauen`,
  again: (mapper: string) => `Nun ${mapper} vertrauen`,
  going: (mapper: string) => `Auf dem Heimweg nach ${by(mapper)}.`,
  outcome: ({ by, distance, ended }: Outcome) =>
    ended === 'home'
      ? `Nach ${by} hielt der Roboter ${number(distance, 2)} m von seinem Anfang, sicher, daheim zu sein.`
      : `Nach ${by} gab der Roboter ${number(distance, 2)} m von seinem Anfang auf.`,
  further: 'Kleine Fehler summieren sich: Machen Sie das rückgängig, fahren Sie weiter und fragen Sie noch einmal.',
  led: (mapper: string) =>
    `Vorhin fuhr der Roboter nach ${mapper} heim, und dafür hat eine Fahrt nur ein Gedächtnis: Fangen Sie von vorn an, um einem anderen zu vertrauen.`,
} as const;
