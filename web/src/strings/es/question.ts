import { number } from '../words';
import type { Outcome } from '../../state/trusting.svelte';

/** Por qué se guía cada memoria, en pocas palabras. */
const BY: Record<string, string> = {
  perceptual: 'cada vista colgada de una superficie reconocida',
  consensus: 'por las paredes reconocidas',
  transform: 'cada paso corregido hasta que las vistas encajaron',
  odometry: 'solo por sus ruedas',
};

const by = (mapper: string): string => (BY[mapper] === undefined ? mapper : `${mapper}: ${BY[mapper]}`);
const NUMBERS = ['', 'una', 'dos', 'tres', 'cuatro'];

export const question = {
  asked: (memories: number) =>
    `Un recorrido, ${NUMBERS[memories] ?? memories} memorias. Conduzca un poco: ¿de cuál se fiaría para volver a casa?`,
  answerHint: (mapper: string) => `Volver a casa según ${by(mapper)}`,
  answer: (mapper: string) => `Fiarse de ${mapper}`,
  again: (mapper: string) => `Ahora fiarse de ${mapper}`,
  going: (mapper: string) => `Camino a casa según ${by(mapper)}.`,
  outcome: ({ by, distance, ended }: Outcome) =>
    ended === 'home'
      ? `Según ${by} el robot se detuvo a ${number(distance, 2)} m de donde empezó, seguro de estar en casa.`
      : `Según ${by} el robot se rindió a ${number(distance, 2)} m de donde empezó.`,
  further: 'Los errores pequeños se suman: deshaga eso, conduzca más lejos y pregunte otra vez.',
  led: (mapper: string) =>
    `Antes el robot volvió a casa según ${mapper}, y para eso cada recorrido tiene una sola memoria: empiece de nuevo para fiarse de otra.`,
} as const;
