import { changing } from './changing';
import { controls } from './controls';
import { help } from './help';
import { keeping } from './keeping';
import { plan } from './plan';
import { plots } from './plots';
import { question } from './question';
import { seeing } from './seeing';
import { telling } from './telling';
import { why } from './why';

/** Every word on the page, in English: what the other catalogues are written after. */
export const en = {
  name: 'Cogmap',
  title: 'Cogmap: what a robot remembers of a building',
  preparing: 'Preparing the laboratory…',
  failed: (reason: string) => `The laboratory could not start: ${reason}`,

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
  /** What the legends say where that is not what the engine says. */
  legend: {} as Readonly<Record<string, string>>,
} as const;
