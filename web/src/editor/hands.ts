import type { Point } from './geometry';

/** What hands do on a sheet; points are in pixels from its upper left corner. */
export interface Uses {
  hover: (at: Point, event: PointerEvent) => void;
  /** Something is pressed; `false` if there is nothing to hold, so that drawing along moves the sheet. */
  press: (at: Point, event: PointerEvent) => boolean;
  drag: (from: Point, at: Point, event: PointerEvent) => void;
  drop: (at: Point, event: PointerEvent) => void;
  click: (at: Point, event: PointerEvent, twice: boolean) => void;
  pan: (x: number, y: number) => void;
  zoom: (factor: number, at: Point) => void;
  /** What was begun is not meant. */
  cancel: () => void;
}

/** A pointer that moved less than this, in pixels, has clicked; a finger is less steady than a mouse. */
const [STILL, STILL_FINGER] = [4, 8];
/** Two clicks within so many milliseconds and pixels are one double click. */
const [DOUBLE_TIME, DOUBLE_DISTANCE] = [400, 12];
/** Zoom of one wheel pixel, and pixels of a wheel that counts in lines. */
const [WHEEL_STEP, LINE] = [0.0016, 24];

/** Listens to hands on a sheet for as long as it is on the page; `panning` says whether a hand moves the sheet itself. */
export function hands(uses: Uses, panning: () => boolean): (node: HTMLElement) => () => void {
  return (node) => {
    const own = new Hands(node, uses, panning);
    const abort = new AbortController();
    const options = { signal: abort.signal };
    node.addEventListener('pointerdown', (event) => own.down(event), options);
    node.addEventListener('pointermove', (event) => own.move(event), options);
    node.addEventListener('pointerup', (event) => own.up(event, true), options);
    node.addEventListener('pointercancel', (event) => own.up(event, false), options);
    node.addEventListener('wheel', (event) => own.wheel(event), { ...options, passive: false });
    return () => abort.abort();
  };
}

class Hands {
  private readonly pointers = new Map<number, Point>();
  private from: Point = [0, 0];
  private does: 'hold' | 'pan' | 'drag' | 'nothing' = 'nothing';
  private last: { at: Point; time: number; clicks: number } | undefined;

  constructor(
    private readonly node: HTMLElement,
    private readonly uses: Uses,
    private readonly panning: () => boolean,
  ) {}

  down(event: PointerEvent): void {
    if (event.button > 1) return;
    // The sheet keeps the keyboard, and a middle button scrolls nothing.
    event.preventDefault();
    this.node.focus({ preventScroll: true });
    this.node.setPointerCapture(event.pointerId);
    const at = this.point(event);
    this.pointers.set(event.pointerId, at);
    if (this.pointers.size > 1) {
      this.uses.cancel();
      this.from = [-Infinity, -Infinity];
      this.does = 'pan';
      return;
    }
    this.from = at;
    const held = event.button === 0 && !this.panning() && this.uses.press(at, event);
    this.does = held ? 'hold' : 'pan';
    if (held && event.pointerType !== 'mouse') this.uses.hover(at, event);
  }

  move(event: PointerEvent): void {
    const at = this.point(event);
    const before = this.pointers.get(event.pointerId);
    if (!before) {
      if (event.pointerType === 'mouse') this.uses.hover(at, event);
      return;
    }
    this.pointers.set(event.pointerId, at);
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (other) this.pinch(other, before, at);
    else if (this.does === 'pan') this.uses.pan(at[0] - before[0], at[1] - before[1]);
    else if (this.does === 'drag' || (this.does === 'hold' && !this.isStill(at, event))) {
      this.does = 'drag';
      this.uses.drag(this.from, at, event);
    }
  }

  up(event: PointerEvent, done: boolean): void {
    if (!this.pointers.delete(event.pointerId)) return;
    const at = this.point(event);
    const { does } = this;
    if (this.pointers.size > 0) return;
    this.does = 'nothing';
    if (!done) this.uses.cancel();
    else if (does === 'drag') this.uses.drop(at, event);
    else if (event.button === 0 && !this.panning() && this.isStill(at, event)) {
      const soon = this.last && event.timeStamp - this.last.time < DOUBLE_TIME && apart(this.last.at, at) < DOUBLE_DISTANCE;
      const clicks = soon && this.last ? this.last.clicks + 1 : 1;
      this.last = { at, time: event.timeStamp, clicks };
      // A third click is the second of somebody who was in doubt.
      if (clicks <= 2) this.uses.click(at, event, clicks === 2);
    }
  }

  wheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * LINE : event.deltaY;
    this.uses.zoom(Math.exp(-pixels * WHEEL_STEP), this.point(event));
  }

  private isStill(at: Point, event: PointerEvent): boolean {
    return apart(this.from, at) <= (event.pointerType === 'mouse' ? STILL : STILL_FINGER);
  }

  private pinch(held: Point, from: Point, to: Point): void {
    const [before, after] = [apart(from, held), apart(to, held)];
    this.uses.pan((to[0] - from[0]) / 2, (to[1] - from[1]) / 2);
    if (before > 0 && after > 0) this.uses.zoom(after / before, [(held[0] + to[0]) / 2, (held[1] + to[1]) / 2]);
  }

  private point(event: MouseEvent): Point {
    const { left, top } = this.node.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }
}

function apart(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}
