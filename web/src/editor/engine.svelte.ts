import { transfer, wrap, type Remote } from 'comlink';
import type { Checked, Draft, Frame, Look } from '../wasm/cogmap_wasm';
import type { Drafts } from '../worker/drafts';

/** A building is looked through when nothing was changed for so long, milliseconds. */
const PAUSE = 200;

/** The worker that paints and checks what is drawn. */
export class Engine {
  /** What the check said of the building that it looked at last. */
  checked = $state.raw<Checked>();
  /** Whether the building has changed since. */
  checking = $state(true);
  /** Whether the worker has ended by itself. */
  stopped = $state(false);
  private readonly worker = new Worker(new URL('../worker/drafts.ts', import.meta.url), { type: 'module' });
  private readonly drafts: Remote<Drafts> = wrap<Drafts>(this.worker);
  private readonly ready = this.drafts.begin();
  private painting = false;
  private next: [Draft, Look, Frame] | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    this.worker.addEventListener('error', () => (this.stopped = true));
  }

  mount(canvas: HTMLCanvasElement): void {
    const handed = canvas.transferControlToOffscreen();
    void this.drafts.mount(transfer(handed, [handed]));
  }

  async blank(name: string): Promise<Draft> {
    await this.ready;
    return this.drafts.blank(name);
  }

  async read(text: string, file: string): Promise<Draft> {
    await this.ready;
    return this.drafts.read(text, file);
  }

  /** What is wrong with a building, now. */
  async check(draft: Draft): Promise<Checked> {
    await this.ready;
    return this.drafts.check(draft);
  }

  /** Looks a building through in a moment, unless it changes before. */
  checkSoon(draft: Draft): void {
    this.checking = true;
    clearTimeout(this.timer);
    this.timer = setTimeout(async () => {
      const timer = this.timer;
      const checked = await this.check(draft).catch(() => undefined);
      if (timer !== this.timer) return;
      this.stopped ||= checked === undefined;
      this.checked = checked;
      this.checking = false;
    }, PAUSE);
  }

  /** Paints a building; of several that come while one is being painted the last. */
  paint(draft: Draft, look: Look, frame: Frame): void {
    this.next = [draft, look, frame];
    if (!this.painting) void this.paintAll();
  }

  close(): void {
    clearTimeout(this.timer);
    this.worker.terminate();
  }

  private async paintAll(): Promise<void> {
    this.painting = true;
    try {
      await this.ready;
      while (this.next) {
        const next = this.next;
        this.next = undefined;
        await this.drafts.paint(...next);
      }
    } catch {
      this.stopped = true;
    }
    this.painting = false;
  }
}
