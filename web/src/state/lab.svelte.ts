import type { Remote } from 'comlink';
import type { Address } from '../keep/address';
import { Keeping } from '../keep/keeping.svelte';
import { Sharing } from '../keep/sharing.svelte';
import { strings } from '../strings';
import type { Bench } from '../worker/bench';
import type { Choice, FileKind, KeptSituation, Notice, Offer, Saved, View } from '../worker/protocol';
import type { Order, Status } from '../wasm/cogmap_wasm';
import { Bringing } from './bringing.svelte';
import { Changing } from './changing.svelte';
import { Dividing } from './dividing.svelte';
import { Editing } from './editing.svelte';
import { opening, OPENING_VIEWS, OPENING_WORLD } from './opening';
import { Pacing } from './pacing.svelte';
import { Plotting } from './plotting.svelte';
import { Pointing } from './pointing.svelte';
import { brought, save } from './save';
import { Showing } from './showing.svelte';
import { TextView } from './text.svelte';
import { Timeline } from './timeline.svelte';
import { Trusting } from './trusting.svelte';
import { Way } from './way.svelte';
import { Why } from './why.svelte';
import { turn } from './turn';
import { isCrash, reason, Workshop } from './workshop';

/** The one owner of what the page shows; the run itself lives in a worker. */
export class Lab {
  offer = $state.raw<Offer>();
  choice = $state.raw<Choice>({ world: OPENING_WORLD, building: 1, robot: '', mappers: [], seed: 1 });
  /** How the robot finds the way when it is told to go home. */
  strategy = $state('');
  status = $state.raw<Status>();
  playing = $state(false);
  /** Whether somebody has driven yet: the invitation to do so has done its work. */
  driven = $state(false);
  /** Name of the file being read. */
  reading = $state<string>();
  /** What went wrong with something that was asked for. */
  refusal = $state<string>();
  /** Why there is no laboratory at all. */
  failure = $state<string>();

  /** How the views show what there is. */
  readonly showing = new Showing(() => this.bench);
  /** How fast the run is played. */
  readonly pacing = new Pacing((pace) => this.bench.setPace(pace));
  /** Where the divider between the views stands. */
  readonly dividing = new Dividing();
  /** Which memory is trusted to lead the robot home. */
  readonly trusting = new Trusting((mapper) => this.trust(mapper));
  /** What the timeline marks. */
  readonly timeline = new Timeline();

  /** Whether the run moves by itself at this moment. */
  readonly running = $derived(this.playing && this.status !== undefined && !this.status.idle);
  /** Whether a log is being mapped. */
  readonly mapping = $derived(
    this.status?.source === 'log' && this.status.position < this.status.end ? this.status : undefined,
  );

  /** The robot on its way home, while it is. */
  readonly going = $derived(this.status?.homing?.ended === undefined ? this.status?.homing : undefined);

  /** The mappers whose memories are shown. */
  readonly mappers = $derived(this.status?.memories.map(({ mapper }) => mapper) ?? []);
  /** The views on the page. */
  readonly views = $derived<View[]>([
    ...(this.showing.world ? (['world'] as const) : []),
    ...this.trusting.views(this.status, this.choice.mappers.length),
  ]);

  /** What was done to the building or the robot just now. */
  readonly changed = $derived(this.status && this.timeline.done(this.status));
  readonly changing = new Changing((alteration) => this.bench.alter(alteration));
  readonly plotting = new Plotting((places) => this.bench.telling.plots(places), () => this.makeRoom());
  readonly text = new TextView((view, most) => this.bench.telling.contents(view, most), () => this.makeRoom());
  readonly pointing = new Pointing((asked, view, to) => this.bench.telling.point(asked, view, to));
  readonly way = new Way((line) => this.bench.follow(line), () => (this.driven = true), () => (this.changing.open = false));
  readonly bringing = new Bringing(this, () => this.bench);

  /** The step that is taken apart. */
  readonly why = new Why({
    explain: (view, stage) => this.bench.telling.explain(view, stage),
    toView: (by) => (by < 0 ? this.bench.previous() : this.bench.next()),
    opening: () => (this.plotting.close(), this.text.close(), void this.bench.play(false)),
  });

  /** Whether the first run has begun, once that is known. */
  begun: Promise<boolean> = Promise.resolve(false);
  /** Counts the workers: each needs canvases of its own, which a page can hand over only once. */
  generation = $state(0);
  /** The files that were opened last. */
  files: File[] = [];
  readonly sharing = new Sharing(this);
  readonly keeping: Keeping;
  readonly editing: Editing;

  private workshop: Workshop;

  constructor(private readonly address: Address) {
    this.keeping = new Keeping(this, !address.embed);
    this.editing = new Editing(this, () => this.bench, !address.embed);
    this.workshop = new Workshop(this.refurnish);
  }

  private get bench(): Remote<Bench> {
    return this.workshop.bench;
  }

  /** Begins the first run, and then what the address or an earlier visit has to offer. */
  async begin(): Promise<void> {
    this.begun = this.first();
    if (!(await this.begun)) return;
    await this.sharing.openAddress();
    await Promise.all([this.keeping.begin(), this.editing.begin()]);
  }

  /** Begins the first run, unless there can be none. */
  private async first(): Promise<boolean> {
    try {
      const offer = await this.load();
      const { choice, complaints } = opening(offer, this.address);
      this.showing.layers = offer.choices.layers;
      this.strategy = offer.choices.strategy;
      this.offer = offer;
      await turn();
      await this.start(choice, OPENING_VIEWS);
      if (complaints.length > 0) this.refusal = complaints.join('\n');
      return true;
    } catch (error) {
      this.failure = reason(error);
      return false;
    }
  }

  /** What a link to this moment holds. */
  situation(): Promise<string> {
    return this.bench.situation();
  }

  /** Takes a run up again where it was left; throws what speaks against it. */
  async resume({ log, ...kept }: KeptSituation): Promise<void> {
    const { choice, warnings } = await this.bench.resume(log ? { ...kept, log: await brought(log) } : kept);
    if (log) this.files = [log];
    this.choice = { ...this.choice, ...choice };
    this.driven = this.status?.on_route !== true;
    this.refusal = warnings.length > 0 ? warnings.join('\n') : undefined;
  }

  private load(): Promise<Offer> {
    return this.workshop.begin(
      (notice) => this.hear(notice),
      (moment) => this.keeping.keep(moment),
    );
  }

  /** Puts another worker in the place of one that has ended. */
  private readonly refurnish = async (cause: string): Promise<void> => {
    if (!this.status) {
      this.failure = cause;
      return;
    }
    this.reading = undefined;
    this.workshop = new Workshop(this.refurnish);
    this.generation += 1;
    try {
      await this.load();
    } catch (error) {
      this.failure = reason(error);
      return;
    }
    this.showing.renew();
    this.pacing.renew();
    this.why.close();
    this.pointing.close();
    await this.keeping.recover();
  };

  /** Begins a new run. */
  async start(change: Partial<Choice> = {}, views = 0): Promise<void> {
    this.choice = { ...this.choice, ...change };
    await this.ask(() => this.bench.start(this.choice, views));
  }

  /** Shows another mapper's memory of the same run, or takes it away; one always stays. */
  toggleMapper(name: string): void {
    void this.ask(async () => {
      const mappers = await this.bench.toggleMapper(name);
      this.choice = { ...this.choice, mappers };
    });
  }

  /** Runs the same world or file with another set-up. */
  async change(change: Partial<Choice>): Promise<void> {
    if (!this.status?.foreign) return this.start(change);
    this.choice = { ...this.choice, ...change };
    return this.ask(() => this.bench.reopen(this.choice));
  }

  /** Runs the same thing from the beginning: a world with its route, a file as it is. */
  async restart(): Promise<void> {
    if (this.status?.foreign) await this.ask(() => this.bench.rewind());
    else if (this.status) await this.start();
  }

  /** Opens files that somebody brought. */
  open = (files: File[]): Promise<void> => this.bringing.open(files);

  order(order: Order): void {
    if (this.status?.source !== 'world' || this.editing.open) return;
    this.driven = true;
    void this.bench.order(order);
  }

  /** Sends the robot home; one that is on its way already goes on. */
  goHome(): void {
    if (this.going?.strategy === this.strategy) this.play();
    else this.order({ kind: 'go_home', strategy: this.strategy });
  }

  private trust(mapper: string): void {
    this.driven = true;
    void this.ask(() => this.bench.trust(mapper, this.strategy));
  }

  reach(x: number, y: number): void {
    if (this.status?.source !== 'world') return;
    this.driven = true;
    void this.bench.reach(x, y);
  }

  takeOver(): void {
    this.driven = true;
    void this.bench.takeOver();
  }

  cancel = (): void => void this.bench.cancel();
  play = (): void => void this.bench.play(true);
  toggle = (): void => void this.bench.play(!this.running);
  next = (): void => void this.bench.next();
  finish = (): void => void (this.status && this.bench.finish());
  jump = (position: number): void => void this.bench.jump(position);
  undo = (): void => void this.bench.undo(false);
  redo = (): void => void this.bench.undo(true);
  switchBranch = (): void => void this.bench.switchBranch();

  /** Goes to the next mark of the timeline, or back to the one before. */
  toMark(by: -1 | 1): void {
    const to = this.timeline.mark(by, this.status?.position ?? 0);
    if (to !== undefined) this.jump(to);
  }

  saveFile = (kind: FileKind): Promise<void> => this.keep(() => this.bench[kind]());
  saveMap = (mapper: number): Promise<void> => this.keep(() => this.bench.map(mapper));

  private async keep(make: () => Promise<Saved>): Promise<void> {
    await this.ask(async () => save(await make()));
  }

  /** Does something that may be refused, and says why it was. */
  async ask(work: () => Promise<void>): Promise<void> {
    try {
      await work();
      this.refusal = undefined;
    } catch (error) {
      if (isCrash(error)) this.workshop.end(reason(error));
      else this.refusal = strings.files.refused(reason(error));
    }
  }

  /** Closes the panel that stands beside the views: another one is about to. */
  private makeRoom(): void {
    if (this.why.view) this.why.close();
    this.plotting.close();
    this.text.close();
  }

  private hear({ status, playing, pace, marks, why, pointed }: Notice): void {
    this.timeline.hear(marks);
    this.trusting.hear(status);
    this.status = status;
    if (this.why.view && !status.memories.some(({ view }) => view === this.why.view)) this.why.close();
    this.why.hear(why);
    this.pointing.hear(pointed);
    this.playing = playing;
    this.pacing.hear(pace);
  }
}
