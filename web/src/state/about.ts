import { strings } from '../strings';
import { GENERATED } from '../worker/protocol';
import type { Lab } from './lab.svelte';

/** What is worth knowing about the building of the page's that the robot is in. */
export function aboutOf({ status, choice, offer }: Lab): string | undefined {
  if (!status || status.foreign) return undefined;
  if (choice.world === GENERATED) return strings.setup.generatedHint;
  const written = offer?.worlds.find(({ file }) => file === choice.world);
  return written && (strings.setup.about[written.file] ?? written.description);
}
