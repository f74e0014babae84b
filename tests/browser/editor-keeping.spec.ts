import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '@playwright/test';
import { BenchPage, roomLog } from './bench';
import { button, check, click, drawWalls, driven, editor, enter, form, open, press, said, save, sheet } from './desk';

test.use({ permissions: ['clipboard-read', 'clipboard-write'] });

test('the present building is edited as it is now, and driven in again', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.takeOver();
  await page.getByRole('button', { name: 'Change', exact: true }).click();
  await page.getByRole('radio', { name: 'Drop a box' }).check();
  await page.getByRole('button', { name: '1 m ahead' }).click();
  await expect(bench.world).toContainText('A box was set down');
  const before = (await driven(bench)).boxes?.length ?? 0;
  await page.getByRole('heading', { level: 1 }).click();
  await page.keyboard.press('u');
  await expect(sheet(page)).toBeFocused();
  await expect(check(page), 'the box stands in the way').toContainText('2 things to put right first');
  for (const route of ['loop', 'tour']) {
    await check(page).getByRole('button', { name: new RegExp(`^Route “${route}”`) }).click();
    await button(page, 'Delete').click();
  }
  await expect(check(page)).toContainText('Everything is in order');
  expect((await save(page)).world.boxes?.length).toBe(before + 1);
  await form(page).getByRole('combobox').selectOption(`Box ${before + 1}`);
  await button(page, 'Duplicate').click();
  await expect(said(page)).toHaveText(`Box ${before + 2} is the copy.`);
  await form(page).getByRole('spinbutton', { name: 'Heading, °' }).fill('30');
  await page.keyboard.press('Enter');
  await button(page, 'Drive here').click();
  await expect(editor(page)).toBeHidden();
  await expect(bench.choice).toContainText('Office');
  const world = await driven(bench);
  expect(world.boxes?.length).toBe(before + 2);
  expect(world.boxes?.at(-1)?.heading_deg).toBe(30);
  const link = await bench.link();
  await page.goto('about:blank');
  await page.goto(link);
  await expect(bench.choice).toContainText('Office');
  await expect.poll(async () => (await driven(bench)).boxes?.length).toBe(before + 2);
});

test('Back loses nothing, and after driving the edits can still be undone', async ({ page }) => {
  const bench = await open(page, 'New building');
  await drawWalls(page);
  const before = await bench.memory.first().innerText();
  await button(page, 'Back').click();
  await expect(editor(page)).toBeHidden();
  await expect(page.getByRole('button', { name: 'Build' })).toBeFocused();
  expect(await bench.memory.first().innerText()).toBe(before);
  await page.getByRole('button', { name: 'Go on drawing' }).click();
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start', 'Wall 1']);
  await button(page, 'Drive here').click();
  await expect(editor(page)).toBeHidden();
  await enter(page, 'Edit the building');
  await button(page, 'Undo').click();
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start']);
});

test('what was drawn is offered again after a reload, the wall that was not ended with it', async ({ page }) => {
  await open(page, 'New building');
  await drawWalls(page);
  await page.keyboard.press('w');
  await click(page, 0.5, 0.2);
  await click(page, 0.5, 0.4);
  await expect(said(page)).toHaveText(/^Point 2 at/);
  await page.waitForTimeout(300);
  await page.reload();
  await expect(page.getByText(/Go on drawing\? New building/)).toBeVisible();
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await page.getByRole('button', { name: 'Go on drawing' }).click();
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start', 'Wall 1']);
  await click(page, 0.6, 0.4);
  await page.keyboard.press('Enter');
  await expect(said(page)).toHaveText(/^Wall of 3 corners/);
  await press(page, 'Control+z', 2);
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start']);
});

test('two windows keep a drawing each, and each is offered once its window is gone', async ({ context }) => {
  const windows = [await context.newPage(), await context.newPage()] as const;
  for (const page of windows) await open(page, 'New building');
  await drawWalls(windows[0]);
  await drawWalls(windows[1]);
  await windows[1].keyboard.press('Control+z');
  await expect(form(windows[1]).getByRole('option')).toHaveText(['nothing', 'Start']);
  await windows[1].keyboard.press('w');
  await click(windows[1], 0.5, 0.2);
  await expect(said(windows[1])).toHaveText(/^Point 1 at/);
  await windows[0].waitForTimeout(300);
  for (const page of windows) await page.close();

  for (const things of [['nothing', 'Start'], ['nothing', 'Start', 'Wall 1']]) {
    const page = await context.newPage();
    await new BenchPage(page).open();
    await page.getByRole('button', { name: 'Go on drawing' }).click();
    await expect(form(page).getByRole('option')).toHaveText(things);
    // Leaving the editor keeps it under the new window's name.
    await button(page, 'Back').click();
    await page.waitForTimeout(300);
  }
  const last = await context.newPage();
  await new BenchPage(last).open();
  await last.waitForTimeout(1000);
  await expect(last.getByText('Go on drawing?')).toBeHidden();
});

test('an empty sheet in place of an unfinished drawing is an edit that can be undone', async ({ page }) => {
  await open(page, 'New building');
  await drawWalls(page);
  await button(page, 'Back').click();
  await enter(page, 'New building');
  await expect(said(page)).toHaveText('New building is on the sheet. What was drawn before comes back with Undo.');
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start']);
  await button(page, 'Undo').click();
  await expect(form(page).getByRole('option')).toHaveText(['nothing', 'Start', 'Wall 1']);
  await button(page, 'Back').click();
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await page.reload();
  await page.waitForTimeout(1000);
  await expect(page.getByText('Go on drawing?')).toBeHidden();
});

test('a world that is dropped on the sheet is drawn there, and what is none has an answer', async ({ page }) => {
  const bench = await open(page, 'New building');
  await drawWalls(page);
  const before = (await save(page)).text;
  await bench.drop({ name: 'hut.world.json', content: '{"format":"cogmap-world/1","name":"Hut","wals":[]}' });
  await expect(said(page)).toContainText('did you mean `walls`?');
  const walledIn = { format: 'cogmap-world/1', name: 'Cell', walls: [[[0, 0], [1, 0]]], start: { position: [0.5, 0.1] } };
  await bench.drop({ name: 'cell.world.json', content: JSON.stringify(walledIn) });
  await expect(said(page)).toHaveText(/^Cell is on the sheet\./);
  await expect(check(page)).toContainText('1 thing to put right first');
  await page.keyboard.press('Control+z');
  expect((await save(page)).text).toBe(before);
});

test('a recorded log has no building to edit, and says so', async ({ page }) => {
  const bench = new BenchPage(page);
  await bench.open();
  await bench.drop({ name: 'room.log', content: roomLog(10) });
  await expect(page.getByRole('heading', { name: 'The log by its odometry alone' })).toBeVisible();
  await page.getByRole('button', { name: 'Build' }).click();
  await page.getByRole('button', { name: /^Edit the building A recorded log has no building/ }).click();
  await expect(page.getByRole('alert')).toContainText('A recorded log has no building');
  await expect(editor(page)).toBeHidden();
});

test('the robot hears nothing while somebody draws', async ({ page }) => {
  const bench = await open(page, 'Edit the building');
  await press(page, 'ArrowUp', 5);
  await page.keyboard.press('h');
  await button(page, 'Back').click();
  await expect(page.getByRole('button', { name: 'Go Home', exact: true })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Play' })).toBeVisible();
  const session = JSON.parse((await bench.save('Session')).bytes.toString()) as { source: { commands: { do: string }[] } };
  expect(session.source.commands.filter((command) => command.do !== 'step')).toEqual([]);
});
