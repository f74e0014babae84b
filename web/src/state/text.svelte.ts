import type { Contents } from '../wasm/cogmap_wasm';
import type { View } from '../worker/protocol';
import { Inquiry } from './inquiry';

/** The least time between two questions to the laboratory, milliseconds: whoever reads wants the words to stand still. */
const INTERVAL = 1000;
/** So many surfaces of a place are told at first … */
const FEW = 6;
/** … and so many more each time that somebody asks. */
const MORE = 20;

/** What a memory holds, in words: asked for only while the panel is open, and not while somebody is at a line of it. */
export class TextView {
  open = $state(false);
  contents = $state.raw<Contents>();
  /** Whether the run has gone on since, while somebody was at a line. */
  behind = $state(false);
  /** Whose memory is told. */
  view = $state<View>('first');
  /** Whether somebody is at a line: what they read stays. */
  private held = false;
  /** Whether what comes next is told all the same: somebody asked for it. */
  private due = false;
  /** What had the focus before the panel took it. */
  private before: Element | null = null;
  private most = $state<Record<string, number>>({});
  private readonly inquiry: Inquiry<Contents | undefined>;

  /** `ask` tells what a memory holds, with so many surfaces of each place; `opening` is called before the panel comes. */
  constructor(
    ask: (view: View, most: number) => Promise<Contents | undefined>,
    private readonly opening: () => void,
  ) {
    const question = () => ask(this.view, Math.max(FEW, ...Object.values(this.most)));
    this.inquiry = new Inquiry(INTERVAL, question, (contents) => this.take(contents), () => this.open && !this.held);
  }

  toggle = (): void => {
    if (!this.open) {
      this.opening();
      this.before = document.activeElement;
    }
    this.open = !this.open;
  };

  /** Gives the focus back, unless it has gone elsewhere. */
  giveBack(): void {
    if (document.activeElement === document.body && this.before instanceof HTMLElement) this.before.focus();
  }

  close = (): void => {
    this.open = false;
  };

  /** Tells another memory. */
  choose(view: View): void {
    this.view = view;
    this.contents = undefined;
    this.most = {};
    this.update();
  }

  /** How many surfaces of a place are told. */
  shown(asr: number | undefined): number {
    return this.most[String(asr)] ?? FEW;
  }

  /** Tells more surfaces of a place. */
  more(asr: number | undefined): void {
    this.most = { ...this.most, [String(asr)]: this.shown(asr) + MORE };
    this.update();
  }

  /** Something happened in the run: it is told, unless somebody is at a line. */
  refresh(): void {
    if (this.held) this.behind = true;
    else this.inquiry.refresh();
  }

  /** Tells what there is now, whoever reads. */
  update = (): void => {
    this.due = true;
    this.inquiry.renew();
  };

  /** Asks another worker. */
  renew = (): void => this.inquiry.renew();

  /** Somebody came to a line, or left them all. */
  hold(held: boolean): void {
    this.held = held;
    if (!held && this.behind) this.update();
  }

  private take(contents: Contents | undefined): void {
    if (this.held && !this.due) {
      this.behind = true;
      return;
    }
    this.due = this.behind = false;
    this.contents = contents;
  }
}
