/** What fingers, mice and wheels do to a view; points are in pixels from the view's upper left corner. */
export interface Gestures {
  drag: (x: number, y: number) => void;
  zoom: (factor: number, x: number, y: number) => void;
  /** `coarse` where a finger did it. */
  tap?: (x: number, y: number, coarse: boolean) => void;
  /** A pointer passes over the view with nothing pressed … */
  hover?: (x: number, y: number) => void;
  /** … and has gone. */
  leave?: () => void;
  /** Whether a pointer draws just now instead of moving the picture. */
  draws?: () => boolean;
  /** The line so far, `done` once the pointer lets go; an empty line was given up. */
  draw?: (line: readonly Point[], done: boolean) => void;
}

/** A pointer that moved less than this, in pixels, has tapped. */
const TAP_DISTANCE = 6;
/** A drawn line has a point each so many pixels. */
const STRIDE = 4;
/** Zoom of one wheel pixel. */
const WHEEL_STEP = 0.0016;
/** Pixels of a wheel that counts in lines. */
const LINE = 24;

/** A point of a view, in pixels from its upper left corner. */
export interface Point {
  x: number;
  y: number;
}

/** Listens to an element for gestures, for as long as it is on the page. */
export function gestures(take: Gestures): (node: HTMLElement) => () => void {
  return (node) => {
    const hands = new Hands(node, take);
    const abort = new AbortController();
    const options = { signal: abort.signal };
    node.addEventListener('pointerdown', (event) => hands.down(event), options);
    node.addEventListener('pointermove', (event) => hands.move(event), options);
    node.addEventListener('pointerup', (event) => hands.up(event, true), options);
    node.addEventListener('pointercancel', (event) => hands.up(event, false), options);
    node.addEventListener('pointerleave', () => take.leave?.(), options);
    node.addEventListener('wheel', (event) => hands.wheel(event), { ...options, passive: false });
    return () => abort.abort();
  };
}

class Hands {
  private readonly pointers = new Map<number, Point>();
  private travelled = 0;
  /** What is being drawn. */
  private line: Point[] | undefined;

  constructor(
    private readonly node: HTMLElement,
    private readonly take: Gestures,
  ) {}

  down(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.node.setPointerCapture(event.pointerId);
    if (this.pointers.size === 0) {
      this.travelled = 0;
      this.line = this.take.draws?.() ? [this.point(event)] : undefined;
    } else this.endLine(false);
    this.pointers.set(event.pointerId, this.point(event));
  }

  move(event: PointerEvent): void {
    const from = this.pointers.get(event.pointerId);
    const to = this.point(event);
    if (!from) {
      if (event.buttons === 0 && event.pointerType !== 'touch') this.take.hover?.(to.x, to.y);
      return;
    }
    const [dx, dy] = [to.x - from.x, to.y - from.y];
    this.travelled += Math.abs(dx) + Math.abs(dy);
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    this.pointers.set(event.pointerId, to);
    if (other) this.pinch(other, from, to);
    else if (this.line) this.extend(this.line, to);
    else if (this.travelled > TAP_DISTANCE) this.take.drag(dx, dy);
  }

  up(event: PointerEvent, done: boolean): void {
    if (!this.pointers.delete(event.pointerId)) return;
    if (this.pointers.size > 0) {
      this.travelled = Infinity;
      return;
    }
    const { x, y } = this.point(event);
    this.endLine(done && this.travelled > TAP_DISTANCE);
    if (done && this.travelled <= TAP_DISTANCE) this.take.tap?.(x, y, event.pointerType === 'touch');
  }

  private extend(line: Point[], to: Point): void {
    const last = line.at(-1);
    if (last && Math.hypot(to.x - last.x, to.y - last.y) < STRIDE) return;
    line.push(to);
    if (this.travelled > TAP_DISTANCE) this.take.draw?.([...line], false);
  }

  private endLine(done: boolean): void {
    if (this.line) this.take.draw?.(done ? this.line : [], done);
    this.line = undefined;
  }

  wheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * LINE : event.deltaY;
    const { x, y } = this.point(event);
    this.take.zoom(Math.exp(-pixels * WHEEL_STEP), x, y);
  }

  private pinch(held: Point, from: Point, to: Point): void {
    const before = Math.hypot(from.x - held.x, from.y - held.y);
    const after = Math.hypot(to.x - held.x, to.y - held.y);
    this.take.drag((to.x - from.x) / 2, (to.y - from.y) / 2);
    if (before > 0 && after > 0) this.take.zoom(after / before, (held.x + to.x) / 2, (held.y + to.y) / 2);
  }

  private point(event: MouseEvent): Point {
    const { left, top } = this.node.getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  }
}
