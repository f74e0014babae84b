import { editing as words } from '../strings/editing';
import type { Thing } from '../wasm/cogmap_wasm';
import { fitted, showing, type Camera } from './camera';
import type { Document } from './document.svelte';
import { distance, minus, onGrid, plus, type Point } from './geometry';
import { make } from './making';
import { GRID, snap, unsnapped, type Snap } from './snapping';
import { anchor, handles, moved, points, pulled, thingAt } from './things';
import { POINTS, type ToolName } from './tools';

/** What is no farther than this from where a mouse or a finger points is meant, pixels. */
const [MOUSE, FINGER] = [9, 22];
/** Two points nearer than this are one, metres. */
const SAME = 0.0005;

/** Where somebody points. */
export interface Pointer {
  /** Metres. */
  at: Point;
  /** Whether nothing is to be snapped to. */
  free: boolean;
  touch: boolean;
}

/** A thing that is being moved, as a whole or by one of its handles. */
interface Held {
  index: number;
  handle: number | undefined;
  thing: Thing;
  /** Where it was taken hold of. */
  from: Point;
}

/** A tool at work on a document. */
export class Drawing {
  tool = $state<ToolName>('select');
  /** The points of what is not yet ended. */
  pending = $state.raw<Point[]>([]);
  /** Where the next point would be, by mouse or by keys. */
  aim = $state.raw<Snap>();
  /** Where the keyboard is. */
  cursor = $state.raw<Point>([0, 0]);
  /** Whether the keyboard moved last. */
  byKeys = $state(false);
  snapping = $state(true);
  held = $state.raw<Held>();
  /** Whether what a hand draws along is meant: not after somebody has abandoned it. */
  private begun = false;
  camera = $state.raw<Camera>({ center: [0, 0], pixels_per_metre: 60, width: 1, height: 1, density: 1 });

  constructor(private readonly document: Document) {}

  choose(tool: ToolName): void {
    this.letGo();
    this.pending = [];
    this.aim = undefined;
    this.tool = tool;
    this.document.said = words.said.tool(words.tools[tool], words.hints[tool]);
  }

  /** Notes where the pointer is. */
  hover(pointer: Pointer): void {
    this.byKeys = false;
    this.aim = this.tool === 'select' ? undefined : this.snapped(pointer.at, pointer);
  }

  /** Takes hold of what is there; `false` if there is nothing to be held. */
  press(pointer: Pointer): boolean {
    this.begun = true;
    if (this.tool !== 'select') return true;
    this.held = this.grip(pointer.at, this.reach(pointer.touch));
    return this.held !== undefined;
  }

  /** Draws what is held, or a line, box or door from where it was pressed. */
  drag(from: Point, pointer: Pointer): void {
    if (!this.begun) return;
    if (this.held) this.pull(pointer.at, pointer);
    else if (this.tool !== 'select') {
      if (this.twoPoints && this.pending.length === 0) this.pending = [this.snapped(from, pointer).at];
      this.aim = this.snapped(pointer.at, pointer);
    }
  }

  /** Sets down what was drawn. */
  drop(pointer: Pointer): void {
    if (!this.begun) return;
    if (this.held) this.setDown();
    else if (this.tool !== 'select') this.place(this.snapped(pointer.at, pointer).at, true);
  }

  click(pointer: Pointer, twice: boolean): void {
    this.letGo();
    if (this.tool === 'select') {
      this.document.select(thingAt(this.document.draft, pointer.at, this.reach(pointer.touch), true));
      this.cursor = onGrid(pointer.at, GRID);
    } else if (twice && !this.twoPoints && this.pending.length > 0) this.finish();
    else this.place(this.snapped(pointer.at, pointer).at);
  }

  /** Moves the keyboard's cursor, and what it holds. */
  step(by: Point, step: number): void {
    this.byKeys = true;
    this.cursor = onGrid(plus(this.cursor, by), this.snapping ? Math.min(step, GRID) : 0.001);
    this.camera = showing(this.camera, this.cursor);
    if (this.held) this.pull(this.cursor, { free: true, touch: false });
    this.aim = this.atCursor();
    const { to } = this.aim;
    this.document.said = words.cursor(...this.cursor, to && to !== 'grid' ? words.snapped[to] : undefined);
  }

  /** What was begun with a hand is not meant: a second finger came. */
  cancel(): void {
    this.begun = false;
    this.letGo();
    this.aim = undefined;
    if (this.twoPoints && this.pending.length === 1) this.pending = [];
  }

  /** What Enter does: places a point, ends at the last one, selects or takes up what is there. */
  enter(): void {
    const last = this.pending.at(-1);
    this.byKeys = true;
    if (this.held) this.setDown();
    else if (this.tool === 'select') this.takeUp();
    else if (last && !this.twoPoints && distance(last, this.cursor) < SAME) this.finish();
    else this.place(this.cursor);
  }

  /** Ends what is being drawn. */
  finish(): void {
    const { tool, document } = this;
    if (tool === 'select') return;
    const made = make(tool, this.pending, document.draft);
    this.pending = [];
    if ('objection' in made) document.said = made.objection;
    else if (made.thing.kind === 'start') {
      const index = document.draft.things.findIndex(({ kind }) => kind === 'start');
      document.change(index, made.thing, made.said);
      document.selected = index;
    } else document.add(made.thing, made.said);
  }

  /** Abandons what is being drawn, puts back what is held, selects nothing; `false` if there is nothing of that. */
  abandon(): boolean {
    if (this.pending.length > 0) this.document.said = words.said.abandoned;
    else if (this.held) this.document.said = words.said.putBack;
    else if (this.document.selected === undefined) return false;
    else this.document.selected = undefined;
    this.pending = [];
    this.begun = false;
    this.letGo();
    return true;
  }

  /** Puts back what is held. */
  letGo(): void {
    this.held = undefined;
    this.document.preview = undefined;
  }

  /** Takes back the last point of what is being drawn; `false` if nothing is. */
  takeBack(): boolean {
    if (this.pending.length === 0) return false;
    this.pending = this.pending.slice(0, -1);
    this.document.said = words.said.pointTaken(this.pending.length);
    return true;
  }

  toggleSnapping(): void {
    this.snapping = !this.snapping;
    this.document.said = words.said.snapping(this.snapping);
  }

  /** Shows everything. */
  fit(): void {
    this.camera = fitted(this.camera, this.document.draft.things.flatMap(points));
  }

  /** Selects something and shows it. */
  show(index: number | undefined): void {
    this.document.select(index);
    const thing = index === undefined ? undefined : this.document.draft.things[index];
    if (!thing) return;
    this.cursor = anchor(thing);
    this.camera = showing(this.camera, this.cursor);
  }

  /** Whether what is being drawn could end here. */
  get ends(): boolean {
    return this.tool !== 'select' && !this.twoPoints && this.pending.length >= POINTS[this.tool][0];
  }

  private get twoPoints(): boolean {
    return this.tool !== 'select' && POINTS[this.tool][1] === 2;
  }

  private reach(touch: boolean): number {
    return (touch ? FINGER : MOUSE) / this.camera.pixels_per_metre;
  }

  private place(at: Point, dragged = false): void {
    const { tool } = this;
    if (tool === 'select') return;
    const [first] = this.pending;
    const outline = tool === 'wall' || tool === 'room';
    const closes = outline && first && this.pending.length > 2 && distance(first, at) < SAME;
    // A room ends where it began; a wall has a corner there too.
    if (!closes || tool === 'wall') this.pending = [...this.pending, at];
    this.cursor = at;
    const [, most] = POINTS[tool];
    if (closes || this.pending.length >= most || (tool === 'start' && !dragged)) this.finish();
    else this.document.said = words.said.point(this.pending.length, ...at);
  }

  private snapped(at: Point, { free, touch }: Omit<Pointer, 'at'>, except?: number, before = this.pending): Snap {
    if (free || !this.snapping) return unsnapped(at);
    const walls = except === undefined ? this.tool !== 'box' && this.tool !== 'post' : true;
    return snap(at, { draft: this.document.draft, except, before, reach: this.reach(touch), walls });
  }

  /** What the cursor is on; it is moved to nothing. */
  private atCursor(): Snap {
    const around = { draft: this.document.draft, except: this.held?.index, before: this.held ? [] : this.pending };
    const { to, guide } = snap(this.cursor, { ...around, reach: SAME, walls: true });
    return { at: this.cursor, ...(to ? { to } : {}), ...(guide ? { guide } : {}) };
  }

  /** Takes up what is selected, if it is at the cursor, else selects what is there. */
  private takeUp(): void {
    const { document } = this;
    const reach = this.reach(false);
    const there = this.grip(this.cursor, reach);
    if (there && there.index === document.selected) {
      this.held = there;
      document.said = `${words.said.taken(document.called(there.index))} ${words.moving}`;
      return;
    }
    document.select(thingAt(document.draft, this.cursor, reach, true));
    if (document.selected === undefined) document.said = words.said.nothingThere;
  }

  /** What would be held at a place: a handle of what is selected, else the thing that is there. */
  private grip(at: Point, reach: number): Held | undefined {
    const { draft, selected } = this.document;
    const chosen = selected === undefined ? undefined : draft.things[selected];
    const near = chosen ? handles(chosen).findIndex((handle) => distance(handle.at, at) <= reach) : -1;
    const index = near < 0 ? thingAt(draft, at, reach, false) : selected;
    const thing = index === undefined ? undefined : draft.things[index];
    return index !== undefined && thing ? { index, thing, from: at, handle: near < 0 ? undefined : near } : undefined;
  }

  private pull(at: Point, pointer: Omit<Pointer, 'at'>): void {
    if (!this.held) return;
    const { index, handle, thing, from } = this.held;
    const whole = handle === undefined;
    const begun = whole ? anchor(thing) : (handles(thing)[handle]?.at ?? from);
    const turns = !whole && handles(thing)[handle]?.does === 'turn';
    const to = plus(begun, minus(at, from));
    const meant = turns ? unsnapped(at) : this.snapped(to, pointer, index, neighbours(thing, handle));
    this.aim = turns ? undefined : meant;
    const now = whole ? moved(thing, minus(meant.at, begun)) : pulled(thing, handle, meant.at, pointer.free);
    this.document.selected = index;
    this.document.preview = { index, thing: now };
  }

  private setDown(): void {
    const { document } = this;
    const { preview } = document;
    this.held = undefined;
    this.aim = undefined;
    document.preview = undefined;
    if (preview) document.change(preview.index, preview.thing, words.said.moved(document.called(preview.index)));
  }

}

/** The corner beside one that is pulled, which may want a right angle. */
function neighbours(thing: Thing, handle: number | undefined): Point[] {
  if (handle === undefined) return [];
  if (thing.kind === 'door') return [handle === 0 ? thing.latch : thing.hinge];
  const beside = 'points' in thing ? (thing.points[handle - 1] ?? thing.points[handle + 1]) : undefined;
  return beside ? [beside] : [];
}
