import type { Direction } from '../state/held.svelte';

/** What a key does beside driving. */
export type Action =
  | 'toggle'
  | 'next'
  | 'finish'
  | 'home'
  | 'stop'
  | 'restart'
  | 'slower'
  | 'faster'
  | 'in'
  | 'out'
  | 'fit'
  | 'truth'
  | 'exits'
  | 'network'
  | 'plans'
  | 'colours'
  | 'stance'
  | 'theme'
  | 'undo'
  | 'redo'
  | 'branch'
  | 'change'
  | 'way'
  | 'plots'
  | 'text'
  | 'edit'
  | 'why'
  | 'markOn'
  | 'markBack'
  | 'whyOn'
  | 'whyBack'
  | 'help';

const DIRECTIONS: Record<string, Direction> = {
  ArrowUp: 'ahead',
  ArrowDown: 'back',
  ArrowLeft: 'left',
  ArrowRight: 'right',
  KeyW: 'ahead',
  KeyS: 'back',
  KeyA: 'left',
  KeyD: 'right',
};

const ACTIONS: Record<string, Action> = {
  ' ': 'toggle',
  '.': 'next',
  f: 'finish',
  h: 'home',
  x: 'stop',
  r: 'restart',
  '[': 'slower',
  ']': 'faster',
  '+': 'in',
  '=': 'in',
  '-': 'out',
  '−': 'out',
  '0': 'fit',
  o: 'truth',
  e: 'exits',
  n: 'network',
  p: 'plans',
  c: 'colours',
  g: 'stance',
  t: 'theme',
  '>': 'markOn',
  '<': 'markBack',
  v: 'branch',
  b: 'change',
  q: 'way',
  l: 'plots',
  m: 'text',
  u: 'edit',
  y: 'why',
  k: 'whyOn',
  j: 'whyBack',
  '?': 'help',
};

/** The direction that a key drives in; by its place on the keyboard, so that WASD is a cross on every layout. */
export function directionOf(event: KeyboardEvent): Direction | undefined {
  return withModifier(event) ? undefined : DIRECTIONS[event.code];
}

/** What a key does beside driving. */
export function actionOf(event: KeyboardEvent): Action | undefined {
  if ((event.ctrlKey || event.metaKey) && !event.altKey && event.key.toLowerCase() === 'z') {
    return event.shiftKey ? 'redo' : 'undo';
  }
  return withModifier(event) ? undefined : ACTIONS[event.key.toLowerCase()];
}

/** Whether the key belongs to the control that has the focus. */
export function belongsElsewhere(event: KeyboardEvent): boolean {
  const target = event.target;
  if (!(target instanceof Element)) return false;
  if (target instanceof HTMLInputElement && target.type === 'radio') return event.key === ' ' || event.key.startsWith('Arrow');
  if (target.closest('dialog, select, textarea, input')) return true;
  return event.key === ' ' && target.closest('button, summary, a') !== null;
}

/** Whether the key is a single letter, digit or sign rather than an arrow or the space bar. */
export function isCharacter(event: KeyboardEvent): boolean {
  return event.key.length === 1 && event.key !== ' ' && !withModifier(event);
}

function withModifier(event: KeyboardEvent): boolean {
  return event.ctrlKey || event.metaKey || event.altKey;
}
