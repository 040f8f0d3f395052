// SPDX-License-Identifier: Apache-2.0
// Whatever is passed, a call returns or throws an Error of JavaScript's; afterwards the module is as it was.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { aabb, capsule, circle, ellipse, fields, kinds, load, point, polygon, polyline } from 'vesica';
import { gaussians, ratios, rect, roundRect, segment } from 'vesica';

const vesica = await load();
const calls = +(process.env.VESICA_CALLS ?? 5000);
let state = (Date.now() % 2 ** 31) | 1;
const seed = state;
const below = (n) => (state = (Math.imul(state, 1103515245) + 12345) >>> 0) % 65521 % n;
const pick = (list) => list[below(list.length)];
const numbers = [0, 1, -1, 0.5, NaN, Infinity, -0, 5e-324, 1.7e308, 1e-200];

function value() {
  const kind = pick(kinds);
  const some = () => Array.from({ length: 14 }, () => pick(numbers));
  // Shapes come often enough that some calls are answered.
  const shape = [
    () => rect(pick(numbers), pick(numbers), pick(numbers), pick(numbers), pick(numbers)),
    () => circle(pick(numbers), pick(numbers), pick(numbers)),
    () => capsule(pick(numbers), pick(numbers), pick(numbers), pick(numbers), pick(numbers)),
    () => roundRect(...some()),
    () => vesica.shapes(kind, some().slice(0, 2 * (fields[kind]?.length ?? 4)), { each: 4 }),
    () => vesica.shapes(kind, 3, { scalar: 'f32' }),
    () => polygon(some(), pick([undefined, [0, 7], [0, 3, 6], some()])),
    () => vesica.polylines(some(), { rings: pick([[0, 7], [0, 3, 6], some()]) }),
    () => vesica.shapes('rect', [rect(0, 0, 2, 1), rect(1, 0, 2, 1)]),
  ];
  return pick([
    ...shape, ...shape, ...shape, ...shape,
    () => ({ kind }), () => kind, () => undefined, () => null, () => pick(numbers), some, () => ({}), () => 7n,
    () => Symbol('x'), () => [pick(numbers), pick(numbers)], () => pick(ratios), () => ({ degrees: true }),
  ])();
}

// Arguments that fit: half of all calls, so that every method is answered now and then.
const some = () => below(9) - 4;
const one = () => pick([
  () => point(some(), some()), () => circle(some(), some(), below(4)), () => aabb(some(), some(), 4, 4),
  () => segment(some(), some(), some(), some()), () => rect(some(), some(), below(4), below(4), some()),
  () => ellipse(some(), some(), below(4), below(4), some()),
  () => polygon([some(), some(), some(), some(), some(), some()]), () => polyline([some(), some(), some(), some()]),
])();
const many = (scalar) =>
  vesica.shapes('rect', Array.from({ length: 2 }, () => rect(some(), some(), 1 + below(3), 2, some())), { scalar });
const scalar = () => pick(['f64', 'f32']);
const oneOrMany = () => pick([one, () => many('f64')])();
const bothMany = (given = scalar()) => [many(given), many(given)];
const velocity = () => [some(), some()], turn = () => [some(), some(), some()];
const boxes = () => [[some(), some(), below(4), below(4), some()]];
const angles = () => ({ [pick(['degrees', 'quarters', 'reverse'])]: true });
const pairs = () => ({ a: [0, 1, below(2)], b: [0, below(3), 1], values: [pick([0.5, NaN]), 0.7, 0.9] });
const corners = () => [0, 0, some(), some(), some(), 1];
const points = () => pick([corners, () => vesica.polygons(corners(), { each: 3 })])();
const grid = () => ({ x: some(), dx: 1 + below(3), columns: below(5), rows: 4 });
const fitting = {
  gaussianDistance: () => [pick(gaussians), oneOrMany(), rect(some(), some(), 2, 1, some())],
  gaussianDistanceMatrix: () => [pick(gaussians), ...bothMany()],
  convexHull: () => [Array.from({ length: 2 * below(6) }, some)],
  minAreaRect: () => [points()],
  minPerimeterRect: () => [points()],
  coverage: () => [one(), grid()],
  coverageCells: () => [one(), grid()],
  fuse: () => [many(scalar()), [0.5, below(2)], 0.1, { weights: velocity(), score: pick(['mean', 'max']) }],
  assignGreedy: () => [pairs()],
  matchTruths: () => [pairs(), [0.9, 0.8], 3, { thresholds: [0.5], rule: pick(['voc', 'coco']), flags: [0, 1, 2] }],
  averagePrecision: () => [[0.9, 0.8, 0.7], [1, below(3), 0], below(3)],
  shapes: () => ['point', [some(), some()], { scalar: scalar() }],
  shapesFromBoxes: () => [pick(['rect', 'ellipse']), boxes(), angles()],
  polygons: () => [[one(), [[some(), some()]]].slice(below(2)), { scalar: scalar() }],
  polylines: () => [velocity(), { rings: [0, below(2)] }],
  boxes: () => [many(scalar()), angles()],
  corners: () => [many(scalar())],
  within: () => [oneOrMany(), oneOrMany(), below(4)],
  withinMatrix: () => [...bothMany(), below(4)],
  de9imMatch: () => [vesica.de9im(one(), one()), pick(['T*F**FFF*', 'FF*FF****', '012******', 'T*'])],
  intersection: () => [rect(0, 0, 2, 1, some()), aabb(some(), some(), 4, 4)],
  nms: () => [many(scalar()), velocity(), 0.5, { labels: [0, below(2)], most: below(4) }],
  nmsSoft: () => [many(scalar()), velocity(), 0.5, { decay: pick(['linear', 'gaussian']), most: below(4) }],
  ratio: () => [pick(ratios), oneOrMany(), oneOrMany()],
  ratioMatrix: () => [pick(ratios), ...bothMany()],
  cast: () => [oneOrMany(), oneOrMany(), velocity(), { tEnd: pick(numbers) }],
  castFirst: () => [one(), many(scalar()), velocity(), { tEnd: pick(numbers) }],
  impactTime: () => [one(), turn(), one(), turn(), pick(numbers)],
  sweepBounds: () => [one(), velocity(), pick(numbers)],
  overlapSelect: () => [one(), many(scalar())],
  index: () => [...bothMany()],
  indexFromBytes: () => {
    const sets = bothMany(), { bytes } = vesica.index(...sets);
    if (below(4) === 0) bytes[below(bytes.length)] ^= 1 << below(8);
    return [bytes, ...sets];
  },
};
const argumentsOf = (name) => {
  if (below(2) === 0) return Array.from({ length: 1 + below(5) }, value);
  if (name in fitting) return fitting[name]();
  return name.endsWith('Matrix') ? bothMany() : [oneOrMany(), oneOrMany()];
};

function askIndex(index) {
  index.join(), index.joinWithin(below(4)), index.joinRatio(pick(ratios), 0.1);
  const name = pick(['cast', 'castFirst', 'select', 'nearest', 'nearestOfEach', 'join', 'joinCount', 'joinWithin']);
  index[name](...(below(2) === 0 ? [one(), velocity()] : [value(), value()]));
}

test(`${calls} calls, seed ${seed}`, () => {
  const own = /^(constructor|c|version|isa|memory|own|release|check|finish|record|operands|inStep|inRoom|pointsOf)$/;
  const methods = Object.getOwnPropertyNames(Object.getPrototypeOf(vesica))
    .filter((name) => !own.test(name));
  const answered = Object.fromEntries(methods.map((name) => [name, 0]));
  for (let i = 0; i < calls; ++i) {
    const name = pick(methods);
    try {
      const given = argumentsOf(name), result = vesica[name](...given);
      if (name === 'index') askIndex(result);
      ++answered[name];
    } catch (error) {
      assert.ok(error instanceof Error, `${name}: ${String(error)}`);
      assert.ok(!(error instanceof WebAssembly.RuntimeError), `${name} traps: ${error.stack}`);
    }
  }
  if (calls >= 5000) assert.deepEqual(methods.filter((name) => answered[name] === 0), []);
  assert.equal(vesica.overlap(circle(0, 0, 1), circle(2, 0, 1)), true);
});
