// SPDX-License-Identifier: Apache-2.0
// Boxes, ratios, suppression and casts by numbers that are known, and what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { aabb, circle, ellipse, load, point, rect, segment, VesicaError } from 'vesica';

const vesica = await load();
const disc = circle(0, 0, 1), wall = aabb(10, -5, 12, 5);

test('casts', () => {
  assert.deepEqual(vesica.cast(wall, disc, [3, 0]), { outcome: 'hit', t: 3, x: 10, y: 0, nx: -1, ny: 0 });
  assert.equal(vesica.cast(wall, disc, [3, 0], { tEnd: 2.5 }).outcome, 'miss');
  assert.equal(vesica.cast(wall, point(11, 0), [1, 0]).outcome, 'start');
  for (const scalar of ['f64', 'f32']) {
    const walls = vesica.shapes('aabb', [aabb(20, -5, 22, 5), wall, aabb(10, -1, 11, 1)], { scalar });
    assert.deepEqual([...vesica.cast(walls, disc, [2, 0]).t], [9.5, 4.5, 4.5]);
    assert.deepEqual([...vesica.cast(walls, disc, [[1, -1, 2], [0, 0, 0]], { tEnd: 30 }).t], [19, Infinity, 4.5]);
    assert.deepEqual(vesica.castFirst(disc, walls, [2, 0]), { item: 1, t: 4.5, x: 10, y: 0, nx: -1, ny: 0 });
    assert.equal(vesica.castFirst(disc, walls, [-2, 0]), null);
    const index = vesica.index(walls);
    assert.deepEqual(index.cast(disc, [1, 0], { tEnd: 9 }).sort(), [1, 2]);
    assert.equal(index.castFirst(disc, [1, 0]).item, 1);
    assert.equal(index.castFirst(disc, [0, 1]), null);
  }
  assert.equal(vesica.contains(vesica.sweepBounds(disc, [0, 3], 2), aabb(-1, -1, 1, 7)), true);
});

test('shapes that turn', () => {
  const bar = segment(-1, 0, 1, 0), speck = circle(0, 0.5, 1e-8), still = [0, 0, 0];
  const hit = vesica.impactTime(bar, [0, 0, Math.PI], speck, still, 1e-7);
  assert.equal(hit.outcome, 'hit');
  assert.ok(hit.t <= 0.5 && hit.t > 0.499999 && hit.gap <= 1e-7);
  const miss = vesica.impactTime(bar, [0, 0, 1.57], speck, new Float32Array(3), 1e-7);
  assert.deepEqual(miss, { outcome: 'miss', t: Infinity, x: NaN, y: NaN, nx: NaN, ny: NaN, gap: NaN });
  // Without area contact is never proved.
  assert.equal(vesica.impactTime(bar, [0, 0, Math.PI], point(0, 0.5), still, 1e-7).outcome, 'near');
  const start = vesica.impactTime(wall, [1, 2, 3], wall, [3, 2, 1], 1);
  assert.deepEqual([start.outcome, start.t, start.gap], ['start', 0, 0]);
});

test('boxes there and back', () => {
  const rows = [1, 2, 6, 4, 90, 3, 4, 5, 2, -30];
  const rects = vesica.shapesFromBoxes('rect', rows, { degrees: true });
  assert.deepEqual(rects.at(0), { kind: 'rect', cx: 1, cy: 2, ux: 0, uy: 1, hx: 3, hy: 2 });
  assert.deepEqual([...vesica.boxes(rects, { degrees: true })].slice(0, 5), rows.slice(0, 5));
  assert.deepEqual([...vesica.boxes(rects.at(0), { quarters: true, reverse: true })], [1, 2, 6, 4, -1]);
  const turned = vesica.shapesFromBoxes('rect', [[3, 4, 5, 2, 30]], { degrees: true, reverse: true });
  assert.deepEqual(turned.at(0), rects.at(1));
  assert.deepEqual([...vesica.corners(rect(0, 0, 4, 2))], [-2, -1, 2, -1, 2, 1, -2, 1]);
  assert.deepEqual([...vesica.boundsMany(vesica.shapes('circle', [disc, circle(4, 5, 2)]))],
    [-1, -1, 1, 1, 2, 3, 6, 7]);
  const refused = () => vesica.shapesFromBoxes('rect', [1, 2, -6, 4, 0, 0, 0, 4, 2, 0]);
  assert.throws(refused, (error) => error instanceof VesicaError && error.result.at(1).hx === 2);
});

test('ratios and suppression', () => {
  const a = aabb(0, 0, 2, 2), b = aabb(1, 1, 3, 3), both = vesica.shapes('aabb', [a, b]);
  assert.equal(vesica.ratio('over_first', a, b), 1 / 4);
  assert.deepEqual([...vesica.ratioMatrix('over_union', both, both)], [1, 1 / 7, 1 / 7, 1]);
  assert.deepEqual([...vesica.depthMatrix(both, both)], [2, 1, 1, 2]);
  assert.deepEqual([...vesica.nearestMatrix(both, vesica.shapes('circle', [circle(6, 1, 1)]))], [3, 2]);
  const boxes = vesica.shapes('aabb', [[0, 0, 4, 4], [0, 0, 2, 2], [0, 0, 4, 3], [9, 9, 10, 10]]),
    scores = [4, 3, 2, 1];
  assert.deepEqual(vesica.nms(boxes, scores), [0, 1, 3]);
  assert.deepEqual(vesica.nms(boxes, scores, 0.5, { ratio: 'over_smaller' }), [0, 3]);
  assert.deepEqual(vesica.nms(boxes, scores, 0.5, { labels: [0, 0, 7, 0] }), [0, 1, 2, 3]);
  assert.deepEqual(vesica.nms(boxes, scores, 0.5, { leastScore: 2, most: 1 }), [0]);
});

test('labels are equal or not, however large', () => {
  const boxes = vesica.shapes('aabb', [[0, 0, 4, 4], [0, 0, 4, 4]]), scores = [2, 1];
  const kept = (labels) => {
    const { indices } = vesica.nmsSoft(boxes, scores, 0.5, { labels, leastScore: 0.5 });
    assert.deepEqual(vesica.nms(boxes, scores, 0.5, { labels }), indices);
    return indices.length;
  };
  const [least, most] = [Number.MIN_SAFE_INTEGER, Number.MAX_SAFE_INTEGER];
  for (const labels of [[1, 2 ** 32 + 1], [0, 2 ** 32], [-1, 2 ** 32 - 1], [least, most], [0, -(2 ** 31)]]) {
    assert.equal(kept(labels), 2, `${labels}`);
  }
  for (const labels of [[0, -0], [most, most], [2 ** 32 + 1, 2 ** 32 + 1], new Uint8Array([7, 7])]) {
    assert.equal(kept(labels), 1, `${labels}`);
  }
  const noNumbers = [['car', 'person'], ['1', '1'], [1n, 1n], [1, undefined]];
  for (const labels of [[1, 1.5], [1, NaN], [1, Infinity], [1, 2 ** 53], ...noNumbers]) {
    assert.throws(() => vesica.nms(boxes, scores, 0.5, { labels }), /a label is a whole number/);
    assert.throws(() => vesica.nmsSoft(boxes, scores, 0.5, { labels }), TypeError);
  }
});

test('near, deep, and how they meet', () => {
  const a = aabb(0, 0, 2, 2), b = aabb(1, 1, 3, 3), disc = circle(6, 1, 1);
  assert.equal(vesica.within(a, disc, 3), 'yes');
  assert.equal(vesica.within(a, disc, 2.999), 'no');
  assert.equal(vesica.within(point(0, 0), ellipse(5, 0, 2, 1), 3), 'yes');
  assert.equal(vesica.within(ellipse(-2, 0, 2, 1), ellipse(5, 0, 2, 1), 3), 'nearly');
  const boxes = vesica.shapes('aabb', [a, b, aabb(5, 0, 6, 2)]);
  assert.deepEqual([...vesica.within(boxes, disc, 2)], [0, 1, 1]);
  assert.deepEqual([...vesica.withinMatrix(boxes, vesica.shapes('aabb', [a]), 2)], [1, 1, 0]);
  assert.deepEqual([...vesica.signedDistance(boxes, a)], [-2, -1, 3]);
  assert.equal(vesica.index(boxes).joinWithin(2).a.length, 2);
  assert.equal(vesica.de9im(a, aabb(2, 0, 4, 2)), 'FF2F11212');
  assert.equal(vesica.de9imMatch('FF2F11212', 'FF*FT****'), true);
  assert.deepEqual(vesica.intersection(a, b)[0], { x: 1, y: 1 });
  assert.deepEqual(vesica.intersection(a, aabb(5, 5, 6, 6)), []);
  const soft = vesica.shapes('aabb', [[0, 0, 4, 4], [0, 0, 4, 3], [9, 9, 10, 10]]);
  assert.deepEqual(vesica.nmsSoft(soft, [1, 0.75, 0.5]), { indices: [0, 2, 1], scores: [1, 0.5, 0.1875] });
  assert.deepEqual(vesica.nmsSoft(soft, [1, 0.75, 0.5], 0.5, { labels: [1, 2, 1], most: 2 }).indices, [0, 1]);
});

test('what is refused', () => {
  const walls = vesica.shapes('aabb', [wall, wall]), freed = vesica.shapes('aabb', [wall]);
  freed.free();
  for (const [error, call] of [
    [TypeError, () => vesica.cast(wall, disc, 3)],
    [TypeError, () => vesica.cast(walls, disc, [[1], [0]])],
    [TypeError, () => vesica.cast(freed, disc, [1, 0])],
    [TypeError, () => vesica.impactTime(wall, [1, 2], disc, [0, 0, 0], 1)],
    [TypeError, () => vesica.impactTime(wall, [1, 2, 3], disc, [0, 0, 0])],
    [TypeError, () => vesica.impactTime(walls, [1, 2, 3], disc, [0, 0, 0], 1)],
    [TypeError, () => vesica.ratio('iou', wall, wall)],
    [TypeError, () => vesica.shapesFromBoxes('circle', [1, 2, 3, 4, 5])],
    [TypeError, () => vesica.boxes(walls, { degrees: true, quarters: true })],
    [TypeError, () => vesica.within(wall, disc, '3')],
    [TypeError, () => vesica.de9imMatch(1, 'T')],
    [TypeError, () => vesica.nmsSoft(walls, [1, 2], 0.5, { decay: 'cubic' })],
    [TypeError, () => vesica.index(walls).joinWithin()],
    [VesicaError, () => vesica.within(walls, disc, NaN)],
    [VesicaError, () => vesica.de9imMatch('FF2F11212', 'T*')],
    [VesicaError, () => vesica.intersection(wall, disc)],
    [RangeError, () => vesica.shapesFromBoxes('rect', [1, 2, 3])],
    [RangeError, () => vesica.cast(walls, disc, [1, 0], { tEnd: -1 })],
    [RangeError, () => vesica.nms(walls, [1, 2], 0.5, { labels: [1] })],
    [RangeError, () => vesica.nms(walls, [1, 2], 0.5, { most: -1 })],
    [VesicaError, () => vesica.cast(wall, disc, [Infinity, 0])],
    [VesicaError, () => vesica.impactTime(wall, [1, 2, 3], disc, [0, 0, 0], 0)],
    [VesicaError, () => vesica.impactTime(wall, [1, 2, 2e6], disc, [0, 0, 0], 1)],
    [VesicaError, () => vesica.boxes(disc)],
  ]) {
    assert.throws(call, error);
  }
});
