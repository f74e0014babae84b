import { expect, test, type Page } from '@playwright/test';
import { BenchPage } from './bench';

const panel = (page: Page) => page.getByRole('complementary', { name: 'Text view' });
const heading = (page: Page) => panel(page).getByRole('heading', { name: 'Text view' });
const network = (page: Page) => panel(page).getByRole('region', { name: 'The network of places' });
const surfaces = (page: Page) => panel(page).getByRole('region', { name: /^Surfaces: \d+/ });
const card = (page: Page) => page.getByRole('group', { name: /^(Surface|Exit|Local space) \d+$/ });
const clock = (page: Page) => page.locator('output').first().innerText();

/** What of a map file the text is held against. */
interface MapFile {
  surfaces: { id: number; a: [number, number]; b: [number, number]; step: number; asr: number }[];
  exits: { id: number; between: [number, number] }[];
  asrs: { id: number; exits: number[] }[];
}

async function driveRoute(page: Page): Promise<BenchPage> {
  const bench = new BenchPage(page);
  await bench.open();
  await page.getByRole('button', { name: 'To the end' }).click();
  await expect(page.getByRole('button', { name: 'Play' })).toBeDisabled({ timeout: 50_000 });
  return bench;
}

/** The cells of the rows of a table, the numbers of the things first. */
async function rows(page: Page, table: string): Promise<string[][]> {
  const all = panel(page).getByRole('table', { name: table, exact: true }).locator('tbody tr');
  return all.evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent?.trim() ?? '')));
}

test('it comes when somebody asks for it, takes the focus, and gives it back', async ({ page }) => {
  await driveRoute(page);
  const fetched = () => page.evaluate(() => performance.getEntriesByType('resource').filter(({ name }) => /Contents-.*\.js$/.test(name)).length);
  expect(await fetched()).toBe(0);
  await page.getByRole('button', { name: 'Text view', exact: true }).focus();
  await page.keyboard.press('Enter');
  await expect(heading(page)).toBeFocused();
  await expect(surfaces(page)).toBeVisible();
  expect(await fetched()).toBe(1);
  await page.keyboard.press('Escape');
  await expect(panel(page)).toHaveCount(0);
  await expect(page.getByRole('button', { name: 'Text view', exact: true })).toBeFocused();
  await page.keyboard.press('m');
  await expect(panel(page)).toBeVisible();
  await page.keyboard.press('m');
  await expect(panel(page)).toHaveCount(0);
});

test('the text says what the engine’s map says', async ({ page }) => {
  const bench = await driveRoute(page);
  const map: MapFile = JSON.parse((await bench.save('Map')).bytes.toString());
  await page.keyboard.press('m');
  await expect(surfaces(page)).toHaveAccessibleName(`Surfaces: ${map.surfaces.length}, nearest first`);
  await expect(network(page).getByRole('listitem')).toHaveCount(map.asrs.length);
  await expect(network(page).getByText('the robot is here')).toHaveCount(1);
  for (const { id, exits } of map.asrs) {
    const own = map.surfaces.filter(({ asr }) => asr === id).length;
    await expect(surfaces(page).getByText(`In local space ${id}: ${own} surfaces`)).toBeVisible();
    const told = (await rows(page, `Exits of local space ${id}`)).map(([exit, to]) => [Number(exit), Number(to)]);
    const known = exits.map((exit) => {
      const between = map.exits.find((other) => other.id === exit)?.between ?? [-1, -1];
      return [exit, between[0] === id ? between[1] : between[0]];
    });
    expect(told).toEqual(known);
  }

  const summary = surfaces(page).locator('details[open] summary');
  await expect(summary).toHaveCount(1);
  const about = await summary.innerText();
  const before = await rows(page, about);
  const away = (row: string[]) => Number.parseFloat(row[2] ?? '');
  expect(before.map(away)).toEqual(before.map(away).sort((a, b) => a - b));
  for (const [id, length] of before) {
    const stored = map.surfaces.find((surface) => surface.id === Number(id));
    if (!stored) throw new Error(`the map holds no surface ${id}`);
    expect(length).toBe(`${Math.hypot(stored.b[0] - stored.a[0], stored.b[1] - stored.a[1]).toFixed(2)}\u00a0m`);
  }
  await surfaces(page).getByRole('button', { name: /^Show more \(6 of/ }).click();
  await expect.poll(async () => (await rows(page, about)).length).toBe(26);

  // Home is where the truth says, but for what the robot is off.
  const [, believed] = /Home, where the run began, is ([\d.]+) m away/.exec(await panel(page).innerText()) ?? [];
  await page.getByRole('button', { name: 'Go Home', exact: true }).click();
  await expect(bench.world).toContainText(/home [\d.]+ m away/);
  const [, home] = /home ([\d.]+) m away/.exec(await bench.world.innerText()) ?? [];
  expect(Math.abs(Number(believed) - Number(home))).toBeLessThan(0.6);
});

test('each line sets its thing off in the drawing, shows its story and goes to its moment', async ({ page }) => {
  const bench = await driveRoute(page);
  await page.keyboard.press('m');
  const picture = async () => (await bench.memory.getByRole('img').screenshot()).toString('base64');
  const names = surfaces(page).getByRole('button', { name: /^Surface \d+$/ });
  await expect(names.first()).toBeVisible();
  const plain = await picture();
  await names.nth(1).focus();
  await expect.poll(picture).not.toBe(plain);
  await expect(card(page)).toHaveCount(0);
  const name = (await names.nth(1).getAttribute('aria-label')) ?? '';
  await page.keyboard.press('Enter');
  await expect(bench.memory.getByRole('group', { name, exact: true })).toBeVisible();
  // As when the window loses the focus and gets it back.
  await names.nth(1).evaluate((line) => {
    line.blur();
    line.focus();
  });
  await page.waitForTimeout(300);
  await expect(bench.memory.getByRole('group', { name, exact: true })).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(card(page)).toHaveCount(0);
  await expect(panel(page)).toBeVisible();
  await expect.poll(picture).toBe(plain);

  const age = surfaces(page).getByRole('row').filter({ has: page.getByRole('button', { name, exact: true }) }).getByRole('button', { name: /Go to view/ });
  const moment = /at ([\d:.]+),/.exec((await age.getAttribute('aria-label')) ?? '')?.[1];
  await age.click();
  await expect.poll(() => clock(page)).toBe(moment);
  await expect(panel(page)).toContainText(`, ${moment}.`);
});

test('the words wait for whoever is at a line of them, and follow otherwise', async ({ page }) => {
  await new BenchPage(page).open();
  await page.keyboard.press('m');
  await page.mouse.move(5, 5);
  const asOf = async () => Number(/As of view (\d+)/.exec(await panel(page).innerText())?.[1]);
  await expect(panel(page)).toContainText('As of view');
  const first = await asOf();
  await expect.poll(asOf).toBeGreaterThan(first);
  await surfaces(page).getByRole('button', { name: /^Surface/ }).first().focus();
  await expect(panel(page)).toContainText('The robot has gone on since');
  const held = await asOf();
  await page.waitForTimeout(2500);
  expect(await asOf()).toBe(held);
  await panel(page).getByRole('button', { name: 'Update' }).click();
  await expect.poll(asOf).toBeGreaterThan(held);
});

for (const [width, height] of [[1440, 900], [1024, 768], [390, 844]] as const) {
  test(`no line moves away under a mouse that came to it at ${width} × ${height}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await new BenchPage(page).open();
    await page.keyboard.press('m');
    await page.mouse.move(5, 5);
    const line = surfaces(page).getByRole('button', { name: /^Surface/ }).first();
    // As it is now: the lines are told anew while the robot drives.
    await line.evaluate((node) => node.scrollIntoView({ block: 'nearest' }));
    const lines = panel(page).getByRole('group', { name: 'What the memory holds' });
    // Where the lines were before the page could answer to the mouse.
    const coming = lines.evaluate((node) => new Promise<number>((resolve) => {
      node.addEventListener('pointerenter', () => resolve(node.getBoundingClientRect().top), { once: true, capture: true });
    }));
    await line.hover();
    const came = await coming;
    await expect(panel(page)).toContainText('The robot has gone on since');
    expect(await lines.evaluate((node) => node.getBoundingClientRect().top)).toBe(came);
  });
}

test('a mapper that knows no places has its surfaces told all the same, and each can be chosen', async ({ page }) => {
  const bench = await driveRoute(page);
  await bench.chip('odometry').click();
  await expect(bench.memory).toHaveCount(2);
  await page.keyboard.press('m');
  await panel(page).getByRole('button', { name: 'odometry', exact: true }).click();
  await expect(panel(page)).toContainText('odometry does not know what a local space is.');
  await expect(surfaces(page).getByText(/^Everywhere: \d+ surfaces$/)).toBeVisible();
  await surfaces(page).getByRole('button', { name: /^Surface/ }).first().click();
  await expect(bench.memory.nth(1).getByRole('group', { name: /^Surface/ })).toContainText('the view before, by odometry');
  await page.getByRole('group', { name: 'Show' }).getByRole('button', { name: 'odometry' }).click();
  await expect(network(page).getByRole('listitem').first()).toBeVisible();
});

test('Why?, the plots and the text take each other’s place', async ({ page }) => {
  await driveRoute(page);
  await page.keyboard.press('m');
  await expect(panel(page)).toBeVisible();
  await page.keyboard.press('l');
  await expect(page.getByRole('complementary', { name: 'Plots' })).toBeVisible();
  await expect(panel(page)).toHaveCount(0);
  await page.keyboard.press('m');
  await expect(page.getByRole('complementary')).toHaveCount(1);
  await expect(panel(page)).toBeVisible();
  await page.keyboard.press('y');
  await expect(page.getByRole('complementary', { name: /^Why\?/ })).toBeVisible();
  await expect(panel(page)).toHaveCount(0);
});

for (const [lang, name] of [['de', 'Textansicht'], ['es', 'Vista de texto']] as const) {
  test(`nothing in it is left in English in ${lang}`, async ({ page }) => {
    await page.goto(`./?lang=${lang}`);
    await page.getByRole('button', { name }).click();
    await expect(page.getByRole('complementary', { name }).locator('tbody tr').first()).toBeVisible();
    await page.getByRole('complementary', { name }).locator('tbody th button').first().click();
    await expect(page.locator('.card')).toBeVisible();
    for (const text of [page.getByRole('complementary', { name }), page.locator('.card')]) {
      expect(await text.innerText()).not.toMatch(/\b(the|of|and|from|view|home|robot’s|surfaces?|exit|left|right|seen)\b/i);
    }
  });
}
