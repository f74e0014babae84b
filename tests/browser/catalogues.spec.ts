import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { expect, test } from '@playwright/test';
import { fixed } from '../../web/src/strings/rounding';

/** The folder that npm runs this in is `web`. */
const root = resolve('..');

/** What the engine can give as a reason: the patterns in its code. */
function patterns(): Set<string> {
  const crates = ['mapping', 'navigation', 'simulation'].map((name) => join(root, 'crates', name, 'src'));
  const files = crates.flatMap((folder) =>
    readdirSync(folder, { recursive: true, encoding: 'utf8' }).map((name) => join(folder, name)),
  );
  const code = files.filter((name) => name.endsWith('.rs')).map((name) => readFileSync(name, 'utf8').split('#[cfg(test)]')[0]);
  const said = code.join('\n').matchAll(/\bsay\(\s*"((?:[^"\\]|\\.|\\\n)*)"/g);
  return new Set([...said].map(([, pattern = '']) => pattern.replaceAll(/\\\n\s*/g, '')));
}

/** What legends can say: the texts in the code of the scenes, but for titles and the words that only these count. */
function captions(): Set<string> {
  const folder = join(root, 'crates/scene/src');
  const names = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) => /_scene(\.rs$|\/(?!tests))/.test(name));
  const files = [...names.map((name) => join(folder, name)), join(root, 'crates/wasm/src/scenes.rs')];
  const code = files.filter((name) => name.endsWith('.rs')).map((name) => readFileSync(name, 'utf8').split('#[cfg(test)]')[0]);
  const lines = code.join('\n').split('\n').filter((line) => !/^\s*(\/\/|#\[)/.test(line));
  const texts = lines.join('\n').matchAll(/"([a-z][^"·:]*)"/g);
  return new Set([...texts].map(([, text = '']) => text).filter((text) => !['scan', 'surface', 'view'].includes(text)));
}

/** What a part of a catalogue holds. */
function translations(language: string, part: string): Map<string, string> {
  const text = readFileSync(join(root, 'web/src/strings', language, `${part}.ts`), 'utf8');
  const pairs = text.matchAll(/^ {2}'?(.*?)'?:\s+'(.*)',$/gm);
  return new Map([...pairs].map(([, key = '', words = '']) => [key, words]));
}

for (const language of ['de', 'es']) {
  test(`every reason of the engine has words in ${language}, with a place for each number`, () => {
    const known = patterns();
    expect(known.size).toBeGreaterThan(50);
    const words = translations(language, 'reasons');
    expect([...words.keys()].sort()).toEqual([...known].sort());
    for (const [pattern, said] of words) {
      expect(said.split('{}').length, said).toBe(pattern.split('{}').length);
      expect(said).not.toBe(pattern);
    }
  });

  test(`every legend has words in ${language}`, () => {
    const known = captions();
    expect(known.size).toBeGreaterThan(50);
    const words = translations(language, 'legend');
    expect([...words.keys()].sort()).toEqual([...known].sort());
    for (const [text, said] of words) expect(said.split('{}').length, said).toBe(text.split('{}').length);
  });

  test(`what is told of each building of the page is told in ${language}`, () => {
    const worlds = readdirSync(join(root, 'worlds')).flatMap((name) => /^(.*)\.world\.json$/.exec(name)?.[1] ?? []);
    expect([...translations(language, 'worlds').keys()].sort()).toEqual(worlds.sort());
  });
}

for (const [language, go, driven, reason] of [
  ['de', 'Nach Hause', /([\d,]+) m gefahren/, /Nach einem Plan: .*Weg nach Hause.*\d,\d m/],
  ['es', 'Ir a casa', /([\d,]+) m recorridos/, /Según un plan: .*camino a casa .*\d,\d m/],
] as const) {
  test(`the robot gives its reasons in ${language}`, async ({ page }) => {
    await page.goto(`./?mappers=consensus&lang=${language}`);
    await expect(page.getByRole('button', { name: go, exact: true })).toBeEnabled();
    const metres = async () => Number(driven.exec(await page.locator('main').innerText())?.[1]?.replace(',', '.') ?? 0);
    await expect.poll(metres).toBeGreaterThan(3);
    await page.keyboard.press('h');
    const told = page.getByText(reason).first();
    await expect(told).toBeVisible();
    expect(await told.innerText()).not.toMatch(/\b(the|robot goes|home|first it|way)\b/);
  });
}

test('the legends of a view change with the language, and back', async ({ page }) => {
  await page.goto('./?mappers=consensus');
  await expect(page.getByRole('button', { name: 'Go Home', exact: true })).toBeEnabled();
  await page.getByRole('button', { name: 'Pause' }).click();
  await page.getByRole('button', { name: 'Language' }).click();
  await page.getByRole('button', { name: 'English' }).click();
  const legend = async () => {
    const box = await page.locator('canvas').last().boundingBox();
    if (!box) throw new Error('there is no memory');
    const clip = { x: box.x, y: box.y + box.height - 80, width: box.width, height: 80 };
    return (await page.screenshot({ clip })).toString('base64');
  };
  await page.waitForTimeout(500);
  const english = await legend();
  await page.getByRole('button', { name: 'Language' }).click();
  await page.getByRole('button', { name: 'Deutsch' }).click();
  await expect.poll(legend).not.toBe(english);
  await page.getByRole('button', { name: 'Sprache' }).click();
  await page.getByRole('button', { name: 'English' }).click();
  await expect.poll(legend).toBe(english);
});

const rounded: [number, number, string][] = [
  [0.25, 1, '0.2'], [0.75, 1, '0.8'], [-0.25, 1, '-0.2'], [0.35, 1, '0.3'], [0.45, 1, '0.5'], [2.5, 0, '2'], [1.5, 0, '2'],
  [0.125, 2, '0.12'], [0.375, 2, '0.38'], [1.005, 2, '1.00'], [3, 1, '3.0'], [1e6 + 0.5, 0, '1000000'], [NaN, 1, 'NaN'],
];

test('numbers are rounded as the engine rounds them', () => {
  for (const [value, digits, text] of rounded) expect(fixed(value, digits)).toBe(text);
});
