import { proxy } from 'comlink';
import { Laboratory, type Alteration, type Followed, type Layers, type Look, type Objection, type Order, type Status } from '../wasm/cogmap_wasm';
import { begun, chosen, opened } from './choice';
import * as engine from './engine';
import { hold } from './lifeline';
import { toggleMapper, trust } from './minds';
import { Player } from './player';
import type { Brought, Choice, LegendWords, Moment, Notice, Offer, Pace, Resumable, Resumed, Saved, View } from './protocol';
import { archive, drawingOf, mapOf, sessionOf, tableOf } from './saving';
import { follow, reach } from './sending';
import { Telling } from './telling';
import { everyText, worlds } from './worlds';

/** The bench on which the laboratory stands: everything here happens off the page's main thread. */
export class Bench {
  /** The run to go back to when mapping a log is cancelled. */
  private before: Laboratory | undefined;
  /** The files that were opened last. */
  private brought: Brought[] = [];
  /** Which run is to begin, of those that were wished for. */
  private wish: symbol | undefined;
  private readonly player = new Player();
  /** What is asked about the run. */
  readonly telling = proxy(new Telling(this.player));
  private layers: Layers | undefined;

  /** Loads the engine. `name` is held for as long as the worker lives; `keep` gets what is to be kept. */
  async begin(name: string, listen: (notice: Notice) => void, keep: (moment: Moment) => void): Promise<Offer> {
    await Promise.all([engine.begin(), hold(name)]);
    this.player.begin(listen, keep);
    const choices = Laboratory.choices();
    this.layers = choices.layers;
    return { choices, worlds };
  }

  private get laboratory(): Laboratory | undefined {
    return this.player.laboratory;
  }

  /** Takes over the canvas of a view that has come to the page. */
  mount(view: View, canvas: OffscreenCanvas): void {
    this.player.easel.take(view, canvas);
    this.player.refresh();
  }

  /** Forgets a view that has left the page. */
  unmount(view: View): void {
    this.player.easel.release(view);
    this.laboratory?.close(view);
    this.player.refresh();
  }

  /**
   * Begins a run in one of the page's buildings, the robot about to follow the building's route, or
   * `views` views on its way already.
   */
  async start(choice: Choice, views = 0): Promise<void> {
    const wish = (this.wish = Symbol('start'));
    const laboratory = await begun(choice, views);
    // Somebody may have wished for another building while this one came.
    if (this.wish !== wish) return laboratory.free();
    this.replace(laboratory);
    if (views === 0) this.player.touch();
  }

  /** Takes a run up again where it was left: all that happened until then happens once more, unseen. */
  async resume({ name, situation, log }: Resumable): Promise<Resumed> {
    const buildings = await everyText();
    const laboratory = Laboratory.resume({ name, situation, buildings }, log?.bytes);
    const { building, warnings } = laboratory;
    this.brought = log ? [log] : [];
    this.replace(laboratory);
    this.player.resuming = true;
    await this.player.rush(() => laboratory.resume_turn());
    this.player.resuming = false;
    this.player.touch();
    return { choice: chosen(building, laboratory.status()), warnings };
  }

  /** What a link to this moment holds. */
  situation(): string {
    return this.mounted().situation();
  }

  /** The building as it is now, as a world file; a log has none. */
  worldFile = (): string | undefined => this.laboratory?.world_file();

  /** Opens what somebody brought; the run at hand stays if it cannot be read. */
  open(files: Brought[], choice: Choice): void {
    this.read(files, choice);
    this.brought = files;
  }

  /** Opens the same files with another set-up. */
  reopen(choice: Choice): void {
    this.read(this.brought, choice);
  }

  /** Shows the same run to one mapper more or less, and returns all that are left. */
  toggleMapper = (name: string): string[] => toggleMapper(this.player, name);

  /** Sends the robot home by what one of the memories says, from where it was told to go home last if it was. */
  trust(mapper: string, strategy: string): void {
    trust(this.player, mapper);
    this.order({ kind: 'go_home', strategy });
  }

  /** Goes back to the run before the log. */
  cancel(): void {
    if (!this.before) return;
    const before = this.before;
    this.before = undefined;
    this.use(before)?.free();
    this.player.play(false);
  }

  /** Tells the robot what to do. */
  order(order: Order): void {
    if (this.player.resuming) return;
    this.laboratory?.order(order);
    this.player.touch();
    this.player.play(true);
  }

  /** Sends the robot to a point of the view of the world, or along a line. */
  reach = (x: number, y: number): void => reach(this.player, x, y);
  follow = (line: Float64Array): Followed | undefined => follow(this.player, line);

  /** Changes something in the building, or carries the robot off; what is answered says why nothing was changed. */
  alter(alteration: Alteration): Objection | undefined {
    if (this.player.resuming) return undefined;
    this.player.rest();
    const objection = this.laboratory?.alter(alteration);
    if (!objection) this.player.touch();
    this.player.refresh();
    return objection;
  }

  /** Ends the playing of the route; from here on the robot waits for orders. */
  takeOver(): void {
    if (this.player.resuming) return;
    this.player.rest();
    this.laboratory?.take_over();
    this.player.touch();
    this.player.refresh();
  }

  play(playing: boolean): void {
    this.player.play(playing);
  }

  setPace(pace: Pace): void {
    this.player.setPace(pace);
  }

  /** Goes on until the next view is taken, then pauses. */
  next(): void {
    this.player.play(false);
    this.laboratory?.advance_to_next_view();
    this.player.touch();
  }

  /** Takes back what a person did last, or does it again. */
  undo(again: boolean): void {
    if (this.player.resuming) return;
    this.player.play(false);
    if (again) this.laboratory?.redo();
    else this.laboratory?.undo();
    this.player.touch();
  }

  /** Goes over to another future that was left. */
  switchBranch(): void {
    if (this.player.resuming) return;
    this.player.play(false);
    this.laboratory?.switch_branch();
    this.player.touch();
  }

  /** Goes back to when the view before the latest was taken. */
  previous(): void {
    this.player.play(false);
    this.laboratory?.back_to_previous_view();
    this.player.touch();
  }

  /**
   * Lets the run go on, unseen and as fast as it goes, until nothing is left to happen; whatever else
   * is wanted meanwhile ends it.
   */
  async finish(): Promise<Status> {
    await this.player.rush(() => this.mounted().advance());
    this.player.touch();
    return this.mounted().status();
  }

  /** Goes to any moment of the run. */
  jump(position: number): void {
    this.player.play(false);
    this.laboratory?.jump(position);
    this.player.touch();
  }

  /** Runs what was brought from its beginning. */
  rewind(): void {
    this.laboratory?.jump(0);
    this.player.play(true);
  }

  resize(view: View, width: number, height: number, density: number): void {
    this.player.easel.resize(view, width, height, density);
    this.laboratory?.resize(view, width, height);
    this.player.refresh();
  }

  setLook(look: Look): void {
    this.player.easel.look = look;
    this.player.paint();
  }

  setLegend = (legend: LegendWords): void => this.player.setLegend(legend);

  show(layers: Layers): void {
    this.layers = layers;
    this.laboratory?.show(layers);
    this.player.refresh();
  }

  drag(x: number, y: number, view: View): void {
    this.laboratory?.drag(x, y, view);
    this.player.look();
  }

  zoom(factor: number, view?: View, x?: number, y?: number): void {
    this.laboratory?.zoom(factor, view ?? 'world', x, y);
    this.player.look();
  }

  fit(): void {
    this.laboratory?.fit();
    this.player.look();
  }

  /** The world and every memory as one picture. */
  async picture(): Promise<Saved> {
    const blob = await this.player.easel.picture(this.mounted());
    return { name: `${this.mounted().status().stem}.png`, blob };
  }

  /** The world and every memory as one drawing. */
  drawing(): Saved {
    return drawingOf(this.mounted(), this.player.easel.look);
  }

  /** The whole session as a file. */
  session(): Saved {
    return sessionOf(this.mounted());
  }

  /** The map of one of the mappers, counted from 0, as a file. */
  map(mapper: number): Saved {
    return mapOf(this.mounted(), mapper);
  }

  /** Where the robot was and where each mapper believed it to be, as a table. */
  table(): Saved {
    return tableOf(this.mounted());
  }

  /** Everything that can be saved, in one archive. */
  everything(): Promise<Saved> {
    return archive(this.mounted(), this.drawing());
  }

  private mounted(): Laboratory {
    if (!this.laboratory) throw new Error('Nothing is running yet.');
    return this.laboratory;
  }

  private read([first, second]: Brought[], choice: Choice): void {
    if (!first) return;
    const left = this.use(opened(choice, first, second));
    if (left && !this.before) this.before = left;
    else left?.free();
    this.player.touch();
  }

  /** Puts another run in the place of this one, for good. */
  private replace(laboratory: Laboratory): void {
    this.use(laboratory)?.free();
    this.before?.free();
    this.before = undefined;
  }

  /** Plays another run, and returns the one that was played. */
  private use(laboratory: Laboratory): Laboratory | undefined {
    if (this.layers) laboratory.show(this.layers);
    return this.player.use(laboratory);
  }
}
