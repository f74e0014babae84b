import type { Laboratory, SourceKind, View } from '../wasm/cogmap_wasm';
import { Clock } from './clock';
import { Easel } from './easel';
import * as engine from './engine';
import { Keeper } from './keeper';
import type { LegendWords, Moment, Notice, Pace } from './protocol';
import { momentOf } from './saving';

/** How often the page is told what happens, milliseconds. */
const NOTICE_INTERVAL = 40;

/** Plays the run at hand: lets time pass, shows it, tells the page of it, and has it kept. */
export class Player {
  laboratory: Laboratory | undefined;
  source: SourceKind = 'world';
  /** Set while a run is gone through again that was left somewhere: nobody is at the controls then. */
  resuming = false;
  /** The memory whose latest step is taken apart. */
  explained: View | undefined;
  /** The number of the latest question about what is pointed at. */
  asked = 0;
  readonly easel = new Easel();
  /** What the legends say, by what the engine says. */
  private legend: LegendWords | undefined;
  private readonly clock = new Clock((elapsed, now) => this.turn(elapsed, now));
  private readonly keeper = new Keeper(() => (this.resuming ? undefined : this.laboratory && momentOf(this.laboratory)));
  private listen: (notice: Notice) => void = () => undefined;
  private noticed = 0;
  /** Whether there is something that the page has not been told. */
  private news = false;
  /** Whether something was painted. */
  private shown = false;
  private playing = true;
  /** Set while the run hurries to its end. */
  private hurry: symbol | undefined;
  /** Drives are watched, logs are mapped as fast as it goes, until somebody wants it otherwise. */
  private readonly paces: Record<SourceKind, Pace> = { world: 2, log: 'full' };

  /** `listen` hears what happens; `keep` gets what is to be kept. */
  begin(listen: (notice: Notice) => void, keep: (moment: Moment) => void): void {
    this.listen = listen;
    this.keeper.begin(keep);
  }

  /** Plays another run, and returns the one that was played. */
  use(laboratory: Laboratory): Laboratory | undefined {
    const left = this.laboratory;
    this.laboratory = laboratory;
    this.source = laboratory.status().source;
    for (const [view, { width, height }] of this.easel.views) laboratory.resize(view, width, height);
    if (this.legend) word(laboratory, this.legend);
    this.play(true);
    return left;
  }

  /** Words the legends, which a laboratory that is told nothing has in English. */
  setLegend(legend: LegendWords): void {
    if (!this.legend && Object.keys(legend).length === 0) return;
    this.legend = legend;
    if (this.laboratory) word(this.laboratory, legend);
    this.paint();
  }

  /** Somebody did something that is to be kept. */
  touch(): void {
    this.keeper.touch();
  }

  play(playing: boolean): void {
    this.rest();
    this.playing = playing;
    this.refresh();
  }

  setPace(pace: Pace): void {
    this.paces[this.source] = pace;
    this.refresh();
  }

  /** Hurries no longer. */
  rest(): void {
    this.hurry = undefined;
  }

  /** Takes turns, unseen and as fast as it goes, until there are no more or something else is wanted. */
  async rush(turn: () => boolean): Promise<void> {
    this.play(false);
    const hurry = (this.hurry = Symbol('hurry'));
    while (this.hurry === hurry && this.clock.rush(turn)) {
      this.notify(performance.now());
      await new Promise((heard) => setTimeout(heard));
    }
    if (this.hurry === hurry) this.hurry = undefined;
    this.refresh();
  }

  /** Something has changed: it is shown, and the page is told. */
  refresh(): void {
    this.news = true;
    this.easel.stale = true;
    this.clock.wake();
  }

  /** The same is shown from elsewhere, of which the page is told only if a card moves along. */
  look(): void {
    if (this.laboratory?.told()) this.news = true;
    this.easel.stale = true;
    this.clock.wake();
  }

  paint(): void {
    if (this.laboratory) this.easel.paintNow(this.laboratory);
  }

  /** Paints some of the views at once, unless all are about to be painted. */
  repaint(views: Set<View>): void {
    if (this.laboratory && !this.easel.stale && this.easel.paintOnly(this.laboratory, views)) this.refresh();
  }

  /** One turn of the clock: time passes, and what changed is shown. */
  private turn(elapsed: number, now: number): boolean {
    const laboratory = this.laboratory;
    if (!laboratory) return false;
    const moved = this.playing && this.clock.pass(laboratory, elapsed, this.paces[this.source]);
    if (moved) {
      this.easel.stale = true;
      this.keeper.grow();
    }
    const painted = this.easel.paint(laboratory, now);
    if (painted && !this.shown) void engine.complete();
    this.shown ||= painted;
    const ended = this.playing && !moved && laboratory.idle;
    if (ended && this.source === 'log') this.playing = false;
    if (moved || ended) this.news = true;
    if (this.news && (!this.playing || ended || now - this.noticed > NOTICE_INTERVAL)) this.notify(now);
    return (this.playing && !ended) || !painted;
  }

  private notify(now: number): void {
    if (!this.laboratory) return;
    this.noticed = now;
    this.news = false;
    const status = this.laboratory.status();
    const why = this.explained && this.laboratory.explain(this.explained);
    const pointed = { asked: this.asked, told: this.laboratory.told() };
    const playing = this.playing || this.hurry !== undefined;
    const marks = this.laboratory.landmarks();
    this.listen({ status, playing, pace: this.paces[status.source], marks, why, pointed });
  }
}

const word = (laboratory: Laboratory, legend: LegendWords): void =>
  laboratory.word_legend(Object.keys(legend), Object.values(legend));
