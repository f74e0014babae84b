import { readFile } from 'node:fs/promises';
import { expect, type Page } from '@playwright/test';

/** What can be saved of a run, as the page calls it. */
type Savable = 'Picture' | 'Drawing' | 'Session' | 'Map' | 'Map by odometry' | 'Table' | 'Everything';

/** The page as its tests see it. */
export class BenchPage {
  constructor(readonly page: Page) {}

  /** Opens the page, on one memory unless the address says otherwise, and waits until the robot is under way. */
  async open(address = '?mappers=consensus'): Promise<void> {
    await this.page.goto(`./${address}`);
    await expect.poll(() => this.surfaces()).toBeGreaterThan(0);
  }

  get memory() {
    return this.page.getByRole('region', { name: /memory/i });
  }

  get world() {
    return this.page.getByRole('region', { name: 'The world' });
  }

  /** Where the world is chosen. */
  get choice() {
    return this.page.getByRole('combobox', { name: /^World/ });
  }

  /** What stands in place of Go Home while the robot is on its way. */
  get going() {
    return this.page.getByRole('button', { name: 'Going home…' });
  }

  /** How many surfaces the memory holds, as the page tells it. */
  async surfaces(): Promise<number> {
    const text = await this.memory.first().innerText({ timeout: 20_000 });
    return Number(/([\d,]+) surfaces?/.exec(text)?.[1]?.replaceAll(',', '') ?? 0);
  }

  /** One of the chips that say what is shown. */
  chip(name: string) {
    return this.page.getByRole('button', { name, exact: true });
  }

  /** Metres driven, as the page tells it. */
  async travelled(): Promise<number> {
    const text = await this.world.innerText();
    return Number(/([\d.]+) m driven/.exec(text)?.[1] ?? 0);
  }

  /** Stops the run; what the page tells of it then stays. */
  async pause(): Promise<void> {
    await this.page.getByRole('button', { name: 'Pause' }).click();
    await expect(this.page.getByRole('button', { name: 'Play' })).toBeEnabled();
  }

  /** Ends the route and lets the robot come to rest. */
  async takeOver(): Promise<void> {
    await this.page.getByRole('button', { name: /take the controls/i }).click();
    await expect(this.page.getByRole('button', { name: 'Play' })).toBeDisabled();
  }

  /** Does something that makes a resting robot move, and lets it come to rest again. */
  async moves(act: () => Promise<void>): Promise<void> {
    const clock = this.page.locator('output').first();
    const before = await clock.innerText();
    await act();
    // A robot that has not yet heard of it rests as well.
    await expect(clock).not.toHaveText(before);
    await expect(this.page.getByRole('button', { name: 'Play' })).toBeDisabled();
  }

  /** Drives while a key is held down, so many milliseconds. */
  hold(key: string, duration: number): Promise<void> {
    return this.moves(async () => {
      await this.page.keyboard.down(key);
      await this.page.waitForTimeout(duration);
      await this.page.keyboard.up(key);
    });
  }

  /** Drives by one press on one of the buttons for it. */
  step(name: string): Promise<void> {
    return this.moves(() => this.page.getByRole('button', { name }).press('Enter'));
  }

  /** Drops the session of one of the page's own worlds on it, and lets it run to its end. */
  async replay(content: string): Promise<void> {
    await expect(this.choice).not.toHaveValue('');
    await this.drop({ name: 'again.session.json', content });
    // It is none of the worlds to choose from: what rests now is no longer the run before it.
    await expect(this.choice).toHaveValue('');
    await this.page.getByLabel('Speed').selectOption('Max');
    await expect(this.page.getByRole('button', { name: 'Play' })).toBeDisabled();
  }

  /** Drops files on the page. */
  async drop(...files: { name: string; content: string }[]): Promise<void> {
    const transfer = await this.page.evaluateHandle((files) => {
      const data = new DataTransfer();
      for (const { name, content } of files) data.items.add(new File([content], name));
      return data;
    }, files);
    await this.page.dispatchEvent('body', 'drop', { dataTransfer: transfer });
  }

  /** Chooses one of the things that can be saved or shared. */
  async share(what: string): Promise<void> {
    await this.page.getByRole('button', { name: 'Save, share' }).click();
    await this.page.getByRole('button', { name: new RegExp(`^${what}`) }).click();
  }

  /** Copies a link to this moment. */
  async link(): Promise<string> {
    await this.share('Copy link');
    await expect(this.page.getByText('is copied')).toBeVisible();
    return this.page.evaluate(() => navigator.clipboard.readText());
  }

  /** Saves one of the things that the page offers and returns it. */
  async save(what: Savable): Promise<{ name: string; bytes: Buffer }> {
    const saving = this.page.waitForEvent('download');
    await this.share(what);
    const download = await saving;
    return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
  }
}

/** A CARMEN log: a robot drives along a rectangular room, straight ahead unless told how far it is at each scan. */
export function roomLog(scans: number, along = (scan: number): number => scan * 0.1): string {
  const beams = 180;
  const [width, length] = [4, 9];
  const lines = ['# made for a test', 'PARAM robot_front_laser_max 20.0 robot 0'];
  for (let scan = 0; scan < scans; scan += 1) {
    const x = 1 + along(scan);
    const ranges = Array.from({ length: beams }, (_, beam) => {
      const bearing = ((beam - 89.5) * Math.PI) / 180;
      const sideways = width / 2 / Math.abs(Math.sin(bearing));
      const ahead = (length - x) / Math.cos(bearing);
      return Math.min(sideways, ahead).toFixed(3);
    });
    const pose = `${x.toFixed(3)} 0 0`;
    const t = (scan * 0.2).toFixed(2);
    lines.push(`ODOM ${pose} 0.5 0 0 ${t} robot ${t}`);
    lines.push(`FLASER ${beams} ${ranges.join(' ')} ${pose} ${pose} ${t} robot ${t}`);
  }
  return `${lines.join('\n')}\n`;
}
