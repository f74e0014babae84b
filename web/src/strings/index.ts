import { changing } from './changing';
import { controls } from './controls';
import { help } from './help';
import { keeping } from './keeping';
import { plots } from './plots';
import { seeing } from './seeing';
import { why } from './why';

/** Every word on the page. Nothing outside this folder holds text for people. */
export const strings = {
  name: 'Cogmap',
  tagline: 'What a robot remembers of a building',
  preparing: 'Preparing the laboratory…',
  failed: (reason: string) => `The laboratory could not start: ${reason}`,

  ...controls,
  ...seeing,
  ...changing,
  why,
  plots,
  ...keeping,
  help,
} as const;
