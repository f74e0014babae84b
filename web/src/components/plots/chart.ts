import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Narrow } from '../../wasm/cogmap_wasm';

/** Room for the numbers beside and below a chart, pixels. */
const [BESIDE, BELOW] = [40, 22];
/** Radius of the sign of a place, as in the map, pixels. */
const SIGN = 7.5;
/** So many local spaces have colours of their own. */
const PLACE_COLOURS = 8;
/** How far above its narrow place it stands, pixels. */
const ABOVE = 14;

/** What a chart shows. */
export interface Content {
  /** From where to where the moments go, seconds of the run. */
  span: [number, number];
  times: ArrayLike<number>;
  lines: ArrayLike<number | null | undefined>[];
  /** Narrow places that are exits. */
  exits: Narrow[];
}

export interface Make {
  /** The token of each line's colour. */
  colours: string[];
  /** The scale of the values goes at least so far. */
  least: number;
  /** Whether values jump from one view to the next rather than glide. */
  stepped: boolean;
  /** Whether the moments are written below. */
  labelled: boolean;
  /** A moment of the run as people read it. */
  moment: (t: number) => string;
  /** The pointer is over a moment, or has gone. */
  onmove: (t: number | undefined) => void;
  /** A moment was clicked. */
  onchoose: (t: number) => void;
}

/** A chart on the page: lines over the moments of a run. */
export class Chart {
  private readonly plot: uPlot;
  private readonly now = document.createElement('div');
  private exits: Narrow[] = [];
  private span: [number, number] = [0, 1];
  private present = 0;
  private pointed: number | undefined;

  constructor(
    private readonly node: HTMLElement,
    { colours, least, stepped, labelled, moment, onmove, onchoose }: Make,
  ) {
    const colour = (token: string): string => resolved(node, token);
    const lines = colours.map((token) => colour(token));
    const quiet = { stroke: colour('--muted'), font: '11px system-ui, sans-serif', ticks: { show: false } };
    const grid = { stroke: colour('--line'), width: 1 };
    const width = stepped ? { paths: uPlot.paths.stepped?.({ align: 1 }) as uPlot.Series.PathBuilder } : {};
    const places = Array.from({ length: PLACE_COLOURS }, (_, number) => colour(`--series-${number}`));
    const sign = { ink: colour('--ink'), ground: colour('--raised'), muted: colour('--muted'), places };
    this.plot = new uPlot(
      {
        ...this.size(),
        legend: { show: false },
        padding: [6, 8, labelled ? 0 : 6, 0],
        scales: { x: { time: false, range: () => this.span }, y: { range: (_, __, max) => [0, 1.08 * Math.max(least, max ?? 0)] } },
        axes: [
          { ...quiet, grid, show: labelled, size: BELOW, gap: 6, space: 64, values: (_, splits) => splits.map((t) => moment(t)) },
          { ...quiet, grid, size: BESIDE, gap: 4, space: 22 },
        ],
        series: [{}, ...lines.map((stroke) => ({ stroke, width: 1.5, spanGaps: true, points: { show: false }, ...width }))],
        cursor: { y: false, dataIdx: ({ data }, line, index) => valued(data[line], index), drag: { x: false, y: false }, points: { size: 7 } },
        hooks: {
          draw: [(plot) => drawExits(plot, this.exits, sign), () => this.tell(this.present), () => this.point(this.pointed)],
          setCursor: [({ cursor }) => onmove((cursor.left ?? -1) < 0 ? undefined : this.timeAt(cursor.left ?? 0))],
        },
      },
      [[], ...lines.map(() => [])],
      node,
    );
    this.now.className = 'now';
    this.plot.over.append(this.now);
    this.plot.over.addEventListener('click', ({ offsetX }) => onchoose(this.timeAt(offsetX)));
  }

  show({ span, times, lines, exits }: Content): void {
    this.span = span;
    this.exits = exits;
    this.plot.setData([times, ...lines] as unknown as uPlot.AlignedData);
  }

  /** Draws a line at the present moment. */
  tell(present: number): void {
    this.present = present;
    const left = this.plot.valToPos(present, 'x');
    this.now.hidden = !Number.isFinite(left) || left < 0 || left > this.plot.bbox.width / devicePixelRatio + 1;
    if (!this.now.hidden) this.now.style.translate = `${left}px`;
  }

  /** Points at a moment, or at none. */
  point(t: number | undefined): void {
    this.pointed = t;
    const left = t === undefined ? -10 : this.plot.valToPos(t, 'x');
    if (Number.isFinite(left)) this.plot.setCursor({ left, top: t === undefined ? -10 : 0 }, false);
  }

  resize(): void {
    const size = this.size();
    if (size.width !== this.plot.width || size.height !== this.plot.height) this.plot.setSize(size);
  }

  destroy(): void {
    this.plot.destroy();
  }

  private size(): { width: number; height: number } {
    return { width: Math.max(120, this.node.clientWidth), height: Math.max(48, this.node.clientHeight) };
  }

  private timeAt(left: number): number {
    return this.plot.posToVal(left, 'x');
  }
}

/** Where a line has a value at a moment, or had its last before. */
function valued(line: ArrayLike<unknown> | undefined, index: number): number {
  let at = index;
  while (at > 0 && (line?.[at] ?? null) === null) at -= 1;
  return at;
}

/** The colour that a token stands for at this place of the page. */
function resolved(node: HTMLElement, token: string): string {
  node.style.color = `var(${token})`;
  const { color } = getComputedStyle(node);
  node.style.color = '';
  return color;
}

interface SignColours {
  ink: string;
  ground: string;
  muted: string;
  /** Of the local spaces. */
  places: string[];
}

/** Marks the narrow places: a dot on each, and above those that were found there the sign of the place behind. */
function drawExits(plot: uPlot, exits: Narrow[], sign: SignColours): void {
  const { ctx } = plot;
  const density = devicePixelRatio;
  let free = -Infinity;
  ctx.save();
  ctx.lineWidth = 1.5 * density;
  ctx.textAlign = 'center';
  ctx.textBaseline = 'middle';
  ctx.font = `600 ${10 * density}px system-ui, sans-serif`;
  for (const { t, metres, asr, found } of exits) {
    const [x, y] = [plot.valToPos(t, 'x', true), plot.valToPos(metres, 'y', true)];
    disc(ctx, [x, y], 2.5 * density, found ? sign.ink : sign.ground, found ? sign.ink : sign.muted);
    if (!found || x < free) continue;
    free = x + 2 * SIGN * density;
    disc(ctx, [x, y - ABOVE * density], SIGN * density, sign.ground, sign.places[asr % PLACE_COLOURS] ?? sign.ink);
    ctx.fillStyle = sign.ink;
    ctx.fillText(String(asr), x, y - (ABOVE - 0.5) * density);
  }
  ctx.restore();
}

function disc(ctx: CanvasRenderingContext2D, [x, y]: [number, number], radius: number, fill: string, edge: string): void {
  ctx.beginPath();
  ctx.arc(x, y, radius, 0, 2 * Math.PI);
  ctx.fillStyle = fill;
  ctx.strokeStyle = edge;
  ctx.fill();
  ctx.stroke();
}
