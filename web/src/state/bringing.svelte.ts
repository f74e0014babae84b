import { transfer, type Remote } from 'comlink';
import type { Bench } from '../worker/bench';
import { strings } from '../strings';
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
    const { lab } = this;
    const [first, , third] = files;
    if (!first || lab.reading) return;
    lab.refusal = undefined;
    this.plan = undefined;
    if (third) {
      lab.refusal = strings.files.tooMany(files.length);
      return;
    }
    lab.reading = first.name;
    // What somebody brings before there is a laboratory waits for it.
    if (await lab.begun) await lab.ask(() => this.read(files, resolution));
    lab.reading = undefined;
  }

  private async read(files: File[], resolution: number | undefined): Promise<void> {
    const { lab } = this;
    const opened = await inOrder(files);
    const [only, second] = opened;
    if (only && !second && resolution === undefined && (await isPicture(only))) {
      this.plan = only;
      return;
    }
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
  }
}

/** How a file begins, each byte a character. */
async function beginning(file: File): Promise<string> {
  return String.fromCharCode(...new Uint8Array(await file.slice(0, 4).arrayBuffer()));
}

async function isPicture(file: File): Promise<boolean> {
  const begins = await beginning(file);
  return PICTURES.some((magic) => begins.startsWith(magic));
}

/** A session, which is JSON, goes before the log that it was made from, in whatever order they come. */
async function inOrder(files: File[]): Promise<File[]> {
  if (files.length !== 2) return files;
  const begins = await Promise.all(files.map(beginning));
  const [first, second] = begins.map((text) => text.trimStart().startsWith('{'));
  return second && !first ? files.toReversed() : files;
}
