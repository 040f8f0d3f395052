// SPDX-License-Identifier: Apache-2.0
// Sparse ratios, assignment, fusion, matching, average precision, Gaussian distances; hulls, coverage, manifolds:
// beside what their definitions give, by other calls or by loops.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { aabb, circle, ellipse, gaussians, load, outcomes, point } from 'vesica';
import { polygon, rect, truthFlags, VesicaError } from 'vesica';

const vesica = await load();
let state = 7;
const random = () => (state = (Math.imul(state, 1103515245) + 12345) >>> 0) / 2 ** 32;
const near = (a, b, error = 1e-12) => assert.ok(Math.abs(a - b) <= error, `${a} is not ${b}`);

for (const scalar of ['f64', 'f32']) {
  test(`joinRatio, ${scalar}: as the matrix`, () => {
    const many = (count) => vesica.shapes('rect', Array.from({ length: count }, () =>
      rect(random() * 20, random() * 20, 1 + random() * 4, 1 + random() * 4, random())), { scalar });
    const a = many(200), b = many(150);
    for (const ratio of ['over_union', 'generalized']) {
      const matrix = vesica.ratioMatrix(ratio, a, b), overlap = vesica.overlapMatrix(a, b);
      for (const threshold of [0, 0.3]) {
        const { a: first, b: second, values } = vesica.index(a).joinRatio(ratio, threshold, { with: vesica.index(b) });
        const found = new Map(values.map((value, k) => [first[k] * b.length + second[k], value]));
        const least = scalar === 'f32' ? Math.fround(threshold) : threshold;
        const wanted = [...matrix].filter((value, k) => overlap[k] && value >= least).length;
        assert.ok(wanted > 3);
        assert.deepEqual([found.size, values.length], [wanted, wanted]);
        for (const [k, value] of found) assert.equal(value, matrix[k]);
      }
    }
    const self = vesica.index(a).joinRatio('over_union'), parts = [0, 1].map((part) =>
      vesica.index(a).joinRatio('over_union', 0, { part, parts: 2 }).values.length);
    assert.equal(parts[0] + parts[1], self.values.length);
    assert.ok(self.a.every((i, k) => i < self.b[k]));
  });
}

test('joinRatio, more pairs than a call writes', () => {
  const a = vesica.shapes('circle', Array.from({ length: 200 }, (_, i) => circle(i / 1000, 0, 1)));
  const { a: first, b: second, values } = vesica.index(a).joinRatio('over_union');
  assert.equal(values.length, (200 * 199) / 2);
  const matrix = vesica.iouMatrix(a, a);
  values.forEach((value, k) => assert.equal(value, matrix[first[k] * 200 + second[k]]));
});

test('assignGreedy: the definition, by a loop', () => {
  for (let round = 0; round < 50; ++round) {
    const count = Math.floor(random() * 30), item = () => Math.floor(random() * 8);
    const pairs = { a: [], b: [], values: [] };
    for (let k = 0; k < count; ++k) {
      pairs.a.push(item());
      pairs.b.push(item());
      pairs.values.push(random() < 0.1 ? NaN : Math.floor(random() * 5));
    }
    const { a, b, values } = pairs, left = new Set([...values.keys()].filter((k) => !Number.isNaN(values[k])));
    const wanted = [];
    while (left.size > 0) {
      const [best] = [...left].sort((i, j) => values[j] - values[i] || a[i] - a[j] || b[i] - b[j] || i - j);
      wanted.push(best);
      for (const k of left) if (a[k] === a[best] || b[k] === b[best]) left.delete(k);
    }
    assert.deepEqual(vesica.assignGreedy(pairs), wanted);
  }
  assert.throws(() => vesica.assignGreedy({ a: [0], b: [-1], values: [1] }), /b of pairs are whole numbers/);
  assert.throws(() => vesica.assignGreedy({ a: [0], b: [], values: [1] }), /as many a, b and values, not 1, 0 and 1/);
  assert.throws(() => vesica.assignGreedy(), TypeError);
});

test('fuse: weighted means', () => {
  for (const scalar of ['f64', 'f32']) {
    const given = vesica.shapes('aabb', [aabb(0, 0, 4, 4), aabb(0.5, 0, 4.5, 4), aabb(20, 0, 24, 4)], { scalar });
    const fused = vesica.fuse(given, [0.75, 0.25, 0.5]);
    assert.deepEqual(fused.clusters, [0, 0, 1]);
    assert.deepEqual([...fused.boxes.numbers], [0.125, 0, 4.125, 4, 20, 0, 24, 4]);
    assert.deepEqual([...fused.scores], [0.5, 0.5]);
    assert.equal(fused.boxes.kind, 'aabb');
    assert.equal(vesica.fuse(given, [0.75, 0.25, 0.5], 0.5, { score: 'max' }).scores[0], 0.75);
    assert.equal(vesica.fuse(given, [0.5, 0.5, 0.5], 0.5, { weights: [3, 1, 1] }).boxes.at(0).min_x, 0.125);
    assert.deepEqual(vesica.fuse(given, [0.75, 0.25, 0.5], 0.5, { labels: [1, 2, 1] }).clusters, [0, 2, 1]);
    assert.equal(vesica.fuse(vesica.shapes('rect', [], { scalar }), []).boxes.length, 0);
    const broken = vesica.shapes('aabb', [aabb(0, 0, 4, 4), aabb(1, 0, 0, 4)], { scalar });
    assert.throws(() => vesica.fuse(broken, [1, 1]), (error) => error instanceof VesicaError &&
      error.result.clusters.join() === '0,-1' && error.result.boxes.length === 1);
    assert.throws(() => vesica.fuse(given, [1]), /3 boxes need as many scores/);
    assert.throws(() => vesica.fuse(given, [1, 1, 1], 0.5, { score: 'sum' }), /score is one of mean, max/);
  }
});

test('matchTruths and averagePrecision', () => {
  // Detection 1 takes truth 0 before detection 0; detection 2 has truth 1 above 0.5 alone; truth 2 is never found.
  const pairs = { a: [0, 1, 2], b: [0, 0, 1], values: [0.9, 0.8, 0.6] }, scores = [0.5, 0.9, 0.7];
  const { outcomes: found, taken } = vesica.matchTruths(pairs, scores, 3, { thresholds: [0.5, 0.75] });
  const names = [...found].map((number) => outcomes[number]);
  assert.deepEqual(names, ['miss', 'hit', 'hit', 'miss', 'hit', 'miss']);
  assert.deepEqual(taken, [-1, 0, 1, -1, 0, -1]);
  const flags = [0, truthFlags.indexOf('ignored'), 0];
  assert.deepEqual([...vesica.matchTruths(pairs, scores, 3, { flags }).outcomes], [0, 1, 2]);
  // Two hits in front: precision 1 up to a recall of 2/3, then 0.
  near(vesica.averagePrecision(scores, found.subarray(0, 3), 3, { rule: 'voc2010' }), 2 / 3);
  near(vesica.averagePrecision(scores, found.subarray(0, 3), 3), 67 / 101);
  near(vesica.averagePrecision(scores, found.subarray(0, 3), 3, { rule: 'voc2007' }), 7 / 11);
  assert.equal(vesica.averagePrecision([], [], 0), NaN);
  assert.throws(() => vesica.averagePrecision(scores, [1], 3), /3 scores need as many outcomes, not 1/);
  assert.throws(() => vesica.averagePrecision(scores, found.subarray(0, 3), 1), VesicaError);
  assert.throws(() => vesica.matchTruths(pairs, scores, 3, { flags: [0] }), /3 truths need as many flags, not 1/);
  assert.throws(() => vesica.matchTruths(pairs, scores, 1), VesicaError);
});

test('Gaussian distances of discs, by their formulas', () => {
  // A disc of radius r has the variance r^2 / 4 each way.
  const formulas = {
    bhattacharyya: (d, v, w) => (d * d) / (4 * (v + w)) + Math.log((v + w) / 2 / Math.sqrt(v * w)),
    hellinger: (...of) => Math.sqrt(1 - Math.exp(-formulas.bhattacharyya(...of))),
    kullback_leibler: (d, v, w) => ((2 * v) / w - 2 + (d * d) / w + 2 * Math.log(w / v)) / 2,
    wasserstein: (d, v, w) => d * d + 2 * (Math.sqrt(v) - Math.sqrt(w)) ** 2,
  };
  assert.deepEqual(Object.keys(formulas), [...gaussians]);
  const a = circle(1, 2, 3), b = circle(4, 6, 2);
  for (const which of gaussians) {
    const wanted = formulas[which](5, 9 / 4, 1);
    const [one, two] = [[a], [b, a]].map((circles) => vesica.shapes('circle', circles));
    near(vesica.gaussianDistance(which, a, b), wanted, 1e-13 * Math.max(1, wanted));
    assert.deepEqual([...vesica.gaussianDistance(which, a, two)], [vesica.gaussianDistance(which, a, b), 0]);
    assert.deepEqual(vesica.gaussianDistanceMatrix(which, one, two), vesica.gaussianDistance(which, one, two));
  }
  const flat = vesica.shapes('rect', [rect(0, 0, 2, 0), rect(0, 0, 2, 1)]);
  assert.throws(() => vesica.gaussianDistance('hellinger', flat, a), (error) => error instanceof VesicaError &&
    Number.isNaN(error.result[0]) && error.result[1] > 0);
  assert.throws(() => vesica.gaussianDistance('iou', a, b), /a distance is one of bhattacharyya, .*not iou/);
});

test('hulls and smallest rectangles', () => {
  const hull = vesica.convexHull([[0, 0], [4, 0], [2, 1], [4, 2], [2, 2], [0, 2], [2, 0]]);
  assert.deepEqual(hull, polygon([0, 0, 4, 0, 4, 2, 0, 2]));
  assert.deepEqual(vesica.convexHull([1, 1, 1, 1]).vertices, Float64Array.of(1, 1));
  const turned = vesica.corners(rect(1, 2, 4, 2, 30, { degrees: true }));
  for (const name of ['minAreaRect', 'minPerimeterRect']) {
    const found = vesica[name](turned);
    near(vesica.shapeArea(found), 8, 1e-13);
    near(vesica.iou(found, rect(1, 2, 4, 2, 30, { degrees: true })), 1, 1e-13);
    for (const scalar of ['f64', 'f32']) {
      const many = vesica.polygons([polygon(turned), polygon([0, 0, 4, 0, 0, 4])], { scalar });
      const rects = vesica[name](many);
      assert.deepEqual([rects.kind, rects.scalar, rects.length], ['rect', scalar, 2]);
      if (scalar === 'f64') assert.deepEqual(rects.at(0), found);
      near(vesica.shapeArea(rects.at(1)), 16, 1e-5);
    }
    assert.throws(() => vesica[name]([0, 0, NaN, 1]), VesicaError);
    assert.throws(() => vesica[name](vesica.shapes('circle', [circle(0, 0, 1)])), VesicaError);
  }
  assert.throws(() => vesica.convexHull([]), /a polygon has a vertex or more/);
});

test('coverage: areas shared with each cell', () => {
  const shape = ellipse(3, 2, 2.5, 1.2, 0.4), grid = { x: -1, y: 0, dx: 0.5, dy: 0.75, columns: 14, rows: 5 };
  const shares = vesica.coverage(shape, grid), { cells, shares: some } = vesica.coverageCells(shape, grid);
  const sparse = new Float64Array(shares.length);
  cells.forEach((cell, k) => (sparse[cell] = some[k]));
  assert.deepEqual(sparse, shares);
  assert.ok(cells.length > 20 && cells.length < shares.length);
  for (let j = 0; j < grid.rows; ++j) {
    for (let i = 0; i < grid.columns; ++i) {
      const [x, y] = [grid.x + i * grid.dx, grid.y + j * grid.dy];
      const wanted = vesica.area(shape, aabb(x, y, x + grid.dx, y + grid.dy)) / (grid.dx * grid.dy);
      near(shares[j * grid.columns + i], wanted, 1e-13);
    }
  }
  assert.deepEqual(vesica.coverage(rect(1, 1, 1, 2), { columns: 2, rows: 2 }), Float64Array.of(0.5, 0.5, 0.5, 0.5));
  assert.throws(() => vesica.coverage(shape, { columns: 2 }), /a grid has columns and rows/);
  assert.throws(() => vesica.coverage(shape), /a grid has columns and rows/);
  assert.throws(() => vesica.coverage(shape, { columns: 2, rows: 2, dx: 0 }), VesicaError);
});

test('manifolds', () => {
  const a = aabb(0, 0, 4, 2), b = aabb(1, 1.5, 3, 4), { nx, ny, contacts } = vesica.manifold(a, b);
  assert.deepEqual([nx, ny], [0, 1]);
  assert.deepEqual(contacts.map(({ x, y, depth }) => [x, y, depth]).sort(), [[1, 1.75, 0.5], [3, 1.75, 0.5]]);
  assert.deepEqual(vesica.manifold(a, point(9, 9)), { nx: 0, ny: 0, contacts: [] });
  for (const scalar of ['f64', 'f32']) {
    const many = vesica.shapes('aabb', [b, aabb(9, 9, 10, 10), aabb(1, 0, 0, 1)], { scalar });
    assert.throws(() => vesica.manifold(a, many), (error) => {
      assert.deepEqual(error.result, [vesica.manifold(a, b), { nx: 0, ny: 0, contacts: [] }, null]);
      return error instanceof VesicaError;
    });
    assert.deepEqual(vesica.manifold(vesica.shapes('aabb', [a], { scalar }), b), [vesica.manifold(a, b)]);
  }
});
