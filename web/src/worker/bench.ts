import init, {
  Laboratory,
  type Layers,
  type Look,
  type Order,
  type SourceKind,
  type StageKind,
  type Status,
} from '../wasm/cogmap_wasm';
import { building, chosen } from './choice';
import { Clock } from './clock';
import { Easel } from './easel';
import { Keeper } from './keeper';
import { hold } from './lifeline';
import type { Brought, Choice, Moment, Notice, Offer, Pace, Resumable, Resumed, Saved, View } from './protocol';
import { asJson, momentOf } from './saving';
import { worlds } from './worlds';

/** How often the page is told what happens, milliseconds. */
const NOTICE_INTERVAL = 40;

/** The bench on which the laboratory stands: everything here happens off the page's main thread. */
export class Bench {
  private laboratory: Laboratory | undefined;
  /** The run to go back to when mapping a log is cancelled. */
  private before: Laboratory | undefined;
  /** The files that were opened last. */
  private brought: Brought[] = [];
  private readonly easel = new Easel();
  private readonly clock = new Clock((elapsed, now) => this.turn(elapsed, now));
  private readonly keeper = new Keeper(() => (this.resuming ? undefined : this.laboratory && momentOf(this.laboratory)));
  /** Set while a run is gone through again that was left somewhere: nobody is at the controls then. */
  private resuming = false;
  private listen: (notice: Notice) => void = () => undefined;
  private noticed = 0;
  private playing = true;
  /** Set while the run hurries to its end. */
  private hurry: symbol | undefined;
  /** Drives are watched, logs are mapped as fast as it goes, until somebody wants it otherwise. */
  private readonly paces: Record<SourceKind, Pace> = { world: 2, log: 'full' };
  private source: SourceKind = 'world';
  private layers: Layers | undefined;
  /** The memory whose latest step is taken apart. */
  private explained: View | undefined;

  /** Loads the engine. `name` is held for as long as the worker lives; `keep` gets what is to be kept. */
  async begin(name: string, listen: (notice: Notice) => void, keep: (moment: Moment) => void): Promise<Offer> {
    await Promise.all([init(), hold(name)]);
    this.listen = listen;
    this.keeper.begin(keep);
    const choices = Laboratory.choices();
    this.layers = choices.layers;
    return { choices, worlds: worlds.map(({ text: _, ...world }) => world) };
  }

  /** Takes over the canvas of a view that has come to the page. */
  mount(view: View, canvas: OffscreenCanvas): void {
    this.easel.take(view, canvas);
    this.refresh();
  }

  /** Forgets a view that has left the page. */
  unmount(view: View): void {
    this.easel.release(view);
    this.laboratory?.close(view);
    this.refresh();
  }

  /**
   * Begins a run in one of the page's buildings, the robot about to follow the building's route, or
   * `views` views on its way already.
   */
  start(choice: Choice, views = 0): void {
    const { robot, mappers, seed } = choice;
    const { file, text } = building(choice);
    const laboratory = new Laboratory({ world: text, file: `${file}.world.json`, robot, mappers, seed });
    for (let view = 0; view < views; view += 1) laboratory.advance_to_next_view();
    this.replace(laboratory);
    if (views === 0) this.keeper.touch();
  }

  /** Takes a run up again where it was left: all that happened until then happens once more, unseen. */
  async resume({ name, situation, log }: Resumable): Promise<Resumed> {
    const buildings = worlds.map(({ file, text }) => ({ file, text }));
    const laboratory = Laboratory.resume({ name, situation, buildings }, log?.bytes);
    const { building, warnings } = laboratory;
    this.brought = log ? [log] : [];
    this.replace(laboratory);
    this.resuming = true;
    await this.rush(() => laboratory.resume_turn());
    this.resuming = false;
    this.keeper.touch();
    return { choice: chosen(building, laboratory.status()), warnings };
  }

  /** What a link to this moment holds. */
  situation(): string {
    return this.mounted().situation();
  }

  /** Opens what somebody brought; the run at hand stays if it cannot be read. */
  open(files: Brought[], choice: Choice): void {
    this.read(files, choice);
    this.brought = files;
  }

  /** Opens the same files with another set-up. */
  reopen(choice: Choice): void {
    this.read(this.brought, choice);
  }

  /** Shows the same run to other mappers: a drive goes on where it is, a log is mapped again. */
  remap(mappers: string[]): void {
    this.mounted().remap(mappers);
    this.keeper.touch();
    if (this.source === 'log') this.play(true);
    else this.refresh();
  }

  /** Goes back to the run before the log. */
  cancel(): void {
    if (!this.before) return;
    const before = this.before;
    this.before = undefined;
    this.use(before);
    this.play(false);
  }

  /** Tells the robot what to do. */
  order(order: Order): void {
    if (this.resuming) return;
    this.laboratory?.order(order);
    this.keeper.touch();
    this.play(true);
  }

  /** Sends the robot to the place that is seen at a point of the view of the world. */
  reach(x: number, y: number): void {
    if (this.resuming || !this.laboratory?.reach(x, y)) return;
    this.keeper.touch();
    this.play(true);
  }

  /** Ends the playing of the route; from here on the robot waits for orders. */
  takeOver(): void {
    if (this.resuming) return;
    this.hurry = undefined;
    this.laboratory?.take_over();
    this.keeper.touch();
    this.refresh();
  }

  play(playing: boolean): void {
    this.hurry = undefined;
    this.playing = playing;
    this.refresh();
  }

  setPace(pace: Pace): void {
    this.paces[this.source] = pace;
    this.refresh();
  }

  /** Goes on until the next view is taken, then pauses. */
  next(): void {
    this.play(false);
    this.laboratory?.advance_to_next_view();
  }

  /** Takes back what a person did last, or does it again. */
  undo(again: boolean): void {
    if (this.resuming) return;
    this.play(false);
    if (again) this.laboratory?.redo();
    else this.laboratory?.undo();
    this.keeper.touch();
  }

  /** Goes over to another future that was left. */
  switchBranch(): void {
    if (this.resuming) return;
    this.play(false);
    this.laboratory?.switch_branch();
    this.keeper.touch();
  }

  /** Goes back to when the view before the latest was taken. */
  previous(): void {
    this.play(false);
    this.laboratory?.back_to_previous_view();
    this.keeper.touch();
  }

  /** Takes the latest step of a memory apart and points one of its stages out; without a memory, no longer. */
  explain(view: View | undefined, stage: StageKind | undefined): void {
    this.explained = view;
    this.laboratory?.point_out(view ?? 'world', stage);
    this.refresh();
  }

  /**
   * Lets the run go on, unseen and as fast as it goes, until nothing is left to happen; whatever else
   * is wanted meanwhile ends it.
   */
  async finish(): Promise<Status> {
    await this.rush(() => this.mounted().advance());
    return this.mounted().status();
  }

  private async rush(turn: () => boolean): Promise<void> {
    this.play(false);
    const hurry = (this.hurry = Symbol('hurry'));
    while (this.hurry === hurry && this.clock.rush(turn)) {
      this.notify(performance.now());
      await new Promise((heard) => setTimeout(heard));
    }
    if (this.hurry === hurry) this.hurry = undefined;
    this.refresh();
  }

  /** Goes to any moment of the run. */
  jump(position: number): void {
    this.play(false);
    this.laboratory?.jump(position);
    this.keeper.touch();
  }

  /** Runs what was brought from its beginning. */
  rewind(): void {
    this.laboratory?.jump(0);
    this.play(true);
  }

  resize(view: View, width: number, height: number, density: number): void {
    this.easel.resize(view, width, height, density);
    this.laboratory?.resize(view, width, height);
    this.paint();
  }

  setLook(look: Look): void {
    this.easel.look = look;
    this.paint();
  }

  show(layers: Layers): void {
    this.layers = layers;
    this.laboratory?.show(layers);
    this.refresh();
  }

  drag(x: number, y: number): void {
    this.laboratory?.drag(x, y);
    this.refresh();
  }

  zoom(factor: number, view?: View, x?: number, y?: number): void {
    this.laboratory?.zoom(factor, view ?? 'world', x, y);
    this.refresh();
  }

  fit(): void {
    this.laboratory?.fit();
    this.refresh();
  }

  /** The world and every memory as one picture. */
  async picture(): Promise<Saved> {
    const blob = await this.easel.picture(this.mounted());
    return { name: `${this.mounted().status().stem}.png`, blob };
  }

  /** The whole session as a file. */
  session(): Saved {
    return asJson(this.mounted(), 'session', (laboratory) => laboratory.save_session());
  }

  /** The map of one of the mappers, counted from 0, as a file. */
  map(mapper: number): Saved {
    const { memories } = this.mounted().status();
    const kind = memories.length > 1 ? `map.${memories[mapper]?.mapper}` : 'map';
    return asJson(this.mounted(), kind, (laboratory) => laboratory.map_json(mapper));
  }

  private mounted(): Laboratory {
    if (!this.laboratory) throw new Error('Nothing is running yet.');
    return this.laboratory;
  }

  private read([first, second]: Brought[], choice: Choice): void {
    if (!first) return;
    const { robot, mappers, seed } = choice;
    const opened = Laboratory.open({ name: first.name, robot, mappers, seed }, first.bytes, second?.bytes);
    const left = this.laboratory;
    this.laboratory = undefined;
    this.use(opened);
    if (left && !this.before) this.before = left;
    else left?.free();
    this.keeper.touch();
  }

  /** Puts another run in the place of this one, for good. */
  private replace(laboratory: Laboratory): void {
    this.use(laboratory);
    this.before?.free();
    this.before = undefined;
  }

  private use(laboratory: Laboratory): void {
    this.laboratory?.free();
    this.laboratory = laboratory;
    if (this.layers) laboratory.show(this.layers);
    this.source = laboratory.status().source;
    for (const [view, { width, height }] of this.easel.views) laboratory.resize(view, width, height);
    this.play(true);
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
    const ended = this.playing && !moved && laboratory.idle;
    if (ended && this.source === 'log') this.playing = false;
    if (!this.playing || ended || now - this.noticed > NOTICE_INTERVAL) this.notify(now);
    return (this.playing && !ended) || !painted;
  }

  private refresh(): void {
    this.easel.stale = true;
    this.clock.wake();
  }

  private paint(): void {
    if (this.laboratory) this.easel.paintNow(this.laboratory);
  }

  private notify(now: number): void {
    if (!this.laboratory) return;
    this.noticed = now;
    const status = this.laboratory.status();
    const why = this.explained && this.laboratory.explain(this.explained);
    const playing = this.playing || this.hurry !== undefined;
    const marks = this.laboratory.landmarks();
    this.listen({ status, playing, pace: this.paces[status.source], marks, why });
  }
}
