// SPDX-License-Identifier: Apache-2.0
// The named methods of the installed package, beside the exact answer.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { aabb, circle, ellipse, load, point, rect, segment, VesicaError } from 'vesica';
import { loadMethods, verdicts } from 'vesica/methods';

const vesica = await load(), methods = await loadMethods();
let state = 4711;
const random = () => (state = (state * 1103515245 + 12345) % 2 ** 31) / 2 ** 31;
const place = () => [random() * 4 - 2, random() * 4 - 2];
const make = {
  point: () => point(...place()),
  segment: () => segment(...place(), ...place()),
  circle: () => circle(...place(), random() + 0.1),
  aabb: () => ((x, y) => aabb(x, y, x + random(), y + random()))(...place()),
  rect: () => rect(...place(), random() + 0.2, random() + 0.2, random() * 6),
  ellipse: () => ellipse(...place(), random() + 0.1, random() + 0.1, random() * 6),
};

test('exact methods answer random pairs as the library does', () => {
  const exact = {
    rectEllipseAllFeatures: ['rect', 'ellipse'],
    rectEllipseClosestFeatures: ['rect', 'ellipse'],
    rectEllipseMinkowskiSum: ['rect', 'ellipse'],
    rectRectSeparatingLines: ['rect', 'rect'],
    pointRectFrame: ['point', 'rect'],
    pointAabbIntervals: ['point', 'aabb'],
    aabbAabbIntervals: ['aabb', 'aabb'],
    circleEllipseClosedForm: ['circle', 'ellipse'],
    segmentCircleDivisionFree: ['segment', 'circle'],
  };
  for (const [name, [kindA, kindB]] of Object.entries(exact)) {
    for (let i = 0; i < 200; ++i) {
      const a = make[kindA](), b = make[kindB]();
      assert.equal(methods[name](a, b), vesica.overlap(a, b) ? 'yes' : 'no', name);
    }
  }
});

test('approximate methods are right where they are certain', () => {
  const certain = (name, kinds, ...n) => {
    for (let i = 0; i < 200; ++i) {
      const a = make[kinds[0]](), b = make[kinds[1]](), found = methods[name](a, b, ...n),
        answer = found.answer ?? found;
      assert.ok(verdicts.includes(answer));
      if (answer !== 'uncertain') assert.equal(answer === 'yes', vesica.overlap(a, b), name);
    }
  };
  certain('rectRectBounds', ['rect', 'rect']);
  certain('rectRectSamplePoints', ['rect', 'rect'], 3);
  certain('circleEllipsePolygonalSandwich', ['circle', 'ellipse'], 2);
  certain('circleEllipseCircleApproximation', ['circle', 'ellipse'], 2);
  certain('ellipseEllipseAnyAxes', ['ellipse', 'ellipse'], 2);
});

test('other forms of input', () => {
  const side = { cx: 0, cy: 0, angle: 0, width: 2, height: 2 };
  assert.equal(methods.turnedRectsSeparatingLines(side, { ...side, cx: 1.5, angle: 0.1 }), 'yes');
  assert.equal(methods.turnedRectsSeparatingLines(side, { ...side, cx: 9 }), 'no');
  const round = { cx: 0, cy: 0, wx: 1, wy: 0, ratio: 1 };
  assert.equal(methods.radiusVectorEllipsesAnyAxes(round, { ...round, cx: 1 }, 5).answer, 'yes');
  assert.equal(methods.ellipseEllipseParallelAxes(ellipse(0, 0, 2, 1), ellipse(9, 0, 2, 1), 5).answer, 'no');
  assert.deepEqual(methods.rectCorners(rect(0, 0, 4, 2)), [[-2, -1], [2, -1], [2, 1], [-2, 1]].map(([x, y]) =>
    ({ x, y })));
  const found = methods.rectEllipsePointParallelogramDistance(rect(0, 0, 2, 2), ellipse(3, 0, 1, 1));
  assert.deepEqual([found.answer, found.x, found.cMin], ['no', 1, 3]);
});

test('gradient descent', () => {
  const a = ellipse(0, 0, 2, 1), b = ellipse(5, 0, 2, 1);
  const found = methods.ellipseEllipseDistanceGradientDescent(a, b, { errors: 5 });
  assert.ok(found.success && Math.abs(found.distance - 1) < 1e-9);
  assert.equal(found.errors.length, Math.min(5, found.iterations));
  const printed = methods.ellipseEllipseDistanceGradientDescent(a, b,
    { schedule: 'literal', iterations: 1, rate: 0.01, decay: 0 });
  assert.equal(printed.iterations, 1);
});

test('what is refused says why', () => {
  assert.throws(() => methods.rectRectBounds(circle(0, 0, 1), rect(0, 0, 1, 1)), TypeError);
  assert.throws(() => methods.rectRectBounds(rect(0, 0, -1, 1), rect(0, 0, 1, 1)), (error) =>
    error instanceof VesicaError && error.code === -2);
  assert.throws(() => methods.circleEllipsePolygonalSandwich(circle(0, 0, 1), ellipse(0, 0, 1, 1), 31), { code: -4 });
  assert.throws(() => methods.ellipseEllipseDistanceGradientDescent(ellipse(0, 0, 1, 1), ellipse(3, 0, 1, 1),
    { schedule: 'fast' }), TypeError);
  assert.throws(() => methods.ellipseEllipseDistanceGradientDescent(ellipse(0, 0, 1, 1), ellipse(3, 0, 1, 1),
    { rate: -1 }), { code: -4 });
});
