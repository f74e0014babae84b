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

/** Every word on the page, in Spanish. */
export const es: Strings = {
  name: 'Cogmap',
  title: 'Cogmap: lo que un robot recuerda de un edificio',
  preparing: 'Preparando el laboratorio…',
  failed: (reason: string) => `El laboratorio no pudo arrancar: ${reason}`,

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
