import { strings } from '../strings';
import type { Lab } from '../state/lab.svelte';
import { wholePage } from './address';
import { fromFragment, holdsSituation, LINK_MAX, toFragment } from './link';

/** How long the page says that it has copied a link, milliseconds. */
const SAID = 8_000;

/** What became of a wish for a link. */
export type Shared =
  | { kind: 'copied'; link: string }
  /** The browser does not let the page copy: somebody has to do it by hand. */
  | { kind: 'by_hand'; link: string }
  | { kind: 'too_long'; length: number }
  | { kind: 'log' };

/** Links that hold the whole situation: made, copied, opened. */
export class Sharing {
  /** What became of the last wish for a link, until that is dismissed. */
  shared = $state.raw<Shared>();

  constructor(private readonly lab: Lab) {}

  /** Copies a link to this very moment, or says what to do instead. */
  copy = async (): Promise<void> => {
    if (this.lab.status?.source === 'log') {
      this.shared = { kind: 'log' };
      return;
    }
    const link = await this.link();
    if (link.length > LINK_MAX) {
      this.shared = { kind: 'too_long', length: link.length };
      return;
    }
    const shared: Shared = { kind: (await copied(link)) ? 'copied' : 'by_hand', link };
    this.shared = shared;
    if (shared.kind === 'copied') setTimeout(() => this.shared === shared && this.dismiss(), SAID);
  };

  /** Opens the whole page at this very moment, beside the one that shows only a part of it. */
  openWhole = async (): Promise<void> => {
    const link = this.lab.status?.source === 'world' ? await this.link() : wholePage();
    window.open(link.length > LINK_MAX ? wholePage() : link, '_blank', 'noopener');
  };

  /** Opens what the page's address holds, if it holds anything. */
  openAddress = async (): Promise<void> => {
    if (!holdsSituation(location.hash) || !(await this.lab.begun)) return;
    try {
      await this.lab.resume({ name: strings.link.name, situation: await fromFragment(location.hash) });
    } catch (error) {
      this.lab.refusal = strings.link.refused(error instanceof Error ? error.message : String(error));
    }
  };

  dismiss = (): void => {
    this.shared = undefined;
  };

  private async link(): Promise<string> {
    return `${wholePage()}#${await toFragment(await this.lab.situation())}`;
  }
}

async function copied(link: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(link);
    return true;
  } catch {
    return false;
  }
}
