import { expect, test } from '@playwright/test';
import { fitted, panned, toMetres, toPixels, zoomed, type Camera } from '../../web/src/editor/camera';
import { area, isWithin, type Point } from '../../web/src/editor/geometry';
import { snap, type Surroundings } from '../../web/src/editor/snapping';
import { freeName, handles, moved, pulled, thingAt } from '../../web/src/editor/things';
import type { Draft, Thing } from '../../web/src/wasm/cogmap_wasm';

const wall: Thing = { kind: 'wall', points: [[0, 0], [8.42, 0], [8.42, 5]] };
const box: Thing = { kind: 'box', center: [2, 3], size: [2, 1], heading_deg: 90 };
const room: Thing = { kind: 'room', name: 'hall', points: [[0, 0], [8, 0], [8, 5], [0, 5]] };

function drawn(...things: Thing[]): Draft {
  return { schema: undefined, name: 'test', description: '', things };
}

function around(change: Partial<Surroundings> = {}): Surroundings {
  return { draft: drawn(wall, box), before: [], reach: 0.15, walls: true, ...change };
}

test('a point snaps to a corner before a wall, to a wall before the grid, and else to the grid', () => {
  expect(snap([8.35, 0.08], around())).toEqual({ at: [8.42, 0], to: 'corner' });
  expect(snap([4.04, 0.1], around())).toMatchObject({ at: [4, 0], to: 'wall' });
  expect(snap([8.33, 2.22], around())).toMatchObject({ at: [8.42, 2.2], to: 'wall' });
  expect(snap([4.04, 1.37], around())).toEqual({ at: [4, 1.4], to: 'grid' });
  expect(snap([4.04, 0.1], around({ walls: false }))).toEqual({ at: [4, 0.1], to: 'grid' });
});

test('the corners of a turned box are where it is seen, and a thing does not snap to itself', () => {
  expect(snap([1.45, 2.1], around())).toEqual({ at: [1.5, 2], to: 'corner' });
  expect(snap([1.45, 2.1], around({ except: 1 }))).toMatchObject({ to: 'grid' });
});

test('a line keeps to a right angle with the axes and with the line before it', () => {
  const odd: Point = [3.33, 1.21];
  expect(snap([5.02, 1.3], around({ before: [odd] }))).toMatchObject({ at: [5.03, 1.21], to: 'angle' });
  const before: Point[] = [[0, 1], [3, 4]];
  const { at, to } = snap([1.95, 5.1], around({ before }));
  expect(to).toBe('angle');
  expect(at[0] + at[1]).toBeCloseTo(7, 2);
  expect(snap([5.5, 2.5], around({ before: [odd] }))).toMatchObject({ to: 'grid' });
});

test('a line finds back to where it began', () => {
  const before: Point[] = [[1.234, 2.345], [4, 2], [4, 4]];
  expect(snap([1.3, 2.3], around({ before }))).toEqual({ at: [1.234, 2.345], to: 'corner' });
});

test('what is moved and pulled stays what it is', () => {
  expect(moved(box, [0.1, -0.2])).toEqual({ ...box, center: [2.1, 2.8] });
  const corner = handles(box).findIndex(({ at }) => Math.hypot(at[0] - 1.5, at[1] - 4) < 1e-9);
  const larger = pulled(box, corner, [0.5, 5], false);
  expect(larger).toEqual({ ...box, size: [3, 2], center: [1.5, 3.5] });
  expect(pulled(box, 4, [3, 4.1], false)).toMatchObject({ heading_deg: 45 });
  expect(pulled(box, 4, [3, 4], true)).toMatchObject({ heading_deg: 45 });
  const tiny = pulled(box, corner, [2.5, 2], false);
  expect(Math.min(...(tiny.kind === 'box' ? tiny.size : [0]))).toBeGreaterThan(0);
});

test('small things are found before large ones, and the floor of a room only by a click', () => {
  const post: Thing = { kind: 'post', center: [2, 3], radius: 0.05 };
  const draft = drawn(room, wall, box, post);
  expect(thingAt(draft, [2, 3], 0.1, false)).toBe(3);
  expect(thingAt(draft, [1.7, 3.5], 0.1, false)).toBe(2);
  expect(thingAt(draft, [6, 3], 0.1, false)).toBeUndefined();
  expect(thingAt(draft, [6, 3], 0.1, true)).toBe(0);
});

test('new names are free', () => {
  const door = (name: string): Thing => ({ kind: 'door', name, hinge: [0, 0], latch: [1, 0], open: true });
  expect(freeName(drawn(door('door 1'), door('door 3')), 'door', 'door')).toBe('door 2');
  expect(freeName(drawn(room), 'room', 'room')).toBe('room 1');
});

test('areas and outlines are those of geometry', () => {
  const bent: Point[] = [[0, 0], [6, 0], [6, 2], [1, 2], [1, 5], [0, 5]];
  expect(area(bent)).toBeCloseTo(15);
  expect([isWithin([0.5, 4], bent), isWithin([3, 4], bent)]).toEqual([true, false]);
});

test('the camera goes to pixels and back, zooms about a pixel and fits everything', () => {
  const camera: Camera = { center: [2, 1], pixels_per_metre: 50, width: 800, height: 600, density: 1 };
  expect(toMetres(camera, toPixels(camera, [3.3, -1.2]))).toEqual([expect.closeTo(3.3), expect.closeTo(-1.2)]);
  const held = toMetres(camera, [100, 70]);
  expect(toMetres(zoomed(camera, 1.7, [100, 70]), [100, 70])).toEqual(held.map((it) => expect.closeTo(it)));
  expect(toPixels(panned(camera, 10, -5), [2, 1])).toEqual([410, 295]);
  const fit = fitted(camera, [[-20, -3], [30, 40]]);
  for (const corner of [[-20, -3], [30, 40]] as Point[]) {
    const [x, y] = toPixels(fit, corner);
    expect(x > 0 && x < 800 && y > 0 && y < 600).toBe(true);
  }
});
