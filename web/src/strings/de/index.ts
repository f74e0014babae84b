import type { Strings } from '../spoken.svelte';
import { changing } from './changing';
import { controls } from './controls';
import { help } from './help';
import { keeping } from './keeping';
import { legend } from './legend';
import { plan } from './plan';
import { plots } from './plots';
import { question } from './question';
import { seeing } from './seeing';
import { telling } from './telling';
import { why } from './why';

/** Every word on the page, in German. */
export const de: Strings = {
  name: 'Cogmap',
  title: 'Cogmap: was sich ein Roboter von einem Gebäude merkt',
  preparing: 'Das Labor wird vorbereitet …',
  failed: (reason: string) => `Das Labor konnte nicht starten: ${reason}`,

  ...controls,
  ...seeing,
  ...changing,
  why,
  plan,
  plots,
  question,
  ...telling,
  ...keeping,
  help,
  legend,
};
