import { transfer, type Remote } from 'comlink';
import type { Bench } from '../worker/bench';
import type { Lab } from './lab.svelte';
import { brought } from './save';

/** How the files begin that are pictures and may be floor plans: PNG, PGM in text and in bytes. */
const PICTURES = ['\u0089PNG', 'P2', 'P5'];

/** Opens what somebody brings. */
export class Bringing {
  /** A floor plan whose scale has to be asked for. */
  plan = $state.raw<File>();

  constructor(
    private readonly lab: Lab,
    private readonly bench: () => Remote<Bench>,
  ) {}

  /** Opens files; `resolution` is the scale of a floor plan that does not say it, metres a pixel. */
  async open(files: File[], resolution?: number): Promise<void> {
    const [first, second] = files;
    const { lab } = this;
    if (!first || lab.reading) return;
    lab.refusal = undefined;
    this.plan = undefined;
    if (!second && resolution === undefined && (await isPicture(first))) {
      this.plan = first;
      return;
    }
    lab.reading = first.name;
    await lab.ask(async () => {
      const opened = files.slice(0, 2);
      const contents = await Promise.all(opened.map(brought));
      const buffers = contents.map(({ bytes }) => bytes.buffer);
      const said = resolution === undefined ? contents : contents.map((content) => ({ ...content, resolution }));
      const before = lab.files;
      lab.files = opened;
      try {
        await this.bench().open(transfer(said, buffers), lab.choice);
      } catch (error) {
        lab.files = before;
        throw error;
      }
      lab.driven = true;
    });
    lab.reading = undefined;
  }
}

async function isPicture(file: File): Promise<boolean> {
  const beginning = String.fromCharCode(...new Uint8Array(await file.slice(0, 4).arrayBuffer()));
  return PICTURES.some((magic) => beginning.startsWith(magic));
}
