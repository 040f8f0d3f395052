// SPDX-License-Identifier: Apache-2.0
// Whatever is passed, a call returns or throws an Error of JavaScript's; afterwards the module is as it was.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { circle, kinds, load, ratios, rect } from 'vesica';

const vesica = await load();
const calls = +(process.env.VESICA_CALLS ?? 5000);
let state = (Date.now() % 2 ** 31) | 1;
const seed = state;
const below = (n) => (state = (Math.imul(state, 1103515245) + 12345) >>> 0) % 65521 % n;
const pick = (list) => list[below(list.length)];
const numbers = [0, 1, -1, 0.5, NaN, Infinity, -0, 5e-324, 1.7e308, 1e-200];

function value() {
  const kind = pick(kinds);
  const some = () => Array.from({ length: 12 }, () => pick(numbers));
  // Shapes come often enough that some calls are answered.
  const shape = [
    () => rect(pick(numbers), pick(numbers), pick(numbers), pick(numbers), pick(numbers)),
    () => circle(pick(numbers), pick(numbers), pick(numbers)),
    () => vesica.shapes(kind, some().slice(0, { point: 4, segment: 8, aabb: 8 }[kind] ?? 12)),
    () => vesica.shapes(kind, 3, { scalar: 'f32' }),
    () => vesica.shapes('rect', [rect(0, 0, 2, 1), rect(1, 0, 2, 1)]),
  ];
  return pick([
    ...shape, ...shape, ...shape, ...shape,
    () => ({ kind }), () => kind, () => undefined, () => null, () => pick(numbers), some, () => ({}), () => 7n,
    () => Symbol('x'), () => [pick(numbers), pick(numbers)], () => pick(ratios), () => ({ degrees: true }),
  ])();
}

test(`${calls} calls, seed ${seed}`, () => {
  const own = /^(constructor|c|version|isa|memory|own|release|within|check|finish|record|operands|inStep|inRoom)$/;
  const methods = Object.getOwnPropertyNames(Object.getPrototypeOf(vesica))
    .filter((name) => !own.test(name));
  let answered = 0;
  for (let i = 0; i < calls; ++i) {
    const name = pick(methods), given = Array.from({ length: 1 + below(4) }, value);
    try {
      const result = vesica[name](...given);
      if (name === 'index') result.join(), result.cast(...given);
      ++answered;
    } catch (error) {
      assert.ok(error instanceof Error, `${name}: ${String(error)}`);
      assert.ok(!(error instanceof WebAssembly.RuntimeError), `${name} traps: ${error.stack}`);
    }
  }
  assert.ok(answered > calls / 100);
  assert.equal(vesica.overlap(circle(0, 0, 1), circle(2, 0, 1)), true);
});
