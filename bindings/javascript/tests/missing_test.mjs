// SPDX-License-Identifier: Apache-2.0
// Numbers that are missing, are no numbers or are too many: an error names them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { aabb, capsule, circle, ellipse, fields, load, point, polygon } from 'vesica';
import { polyline, rect, roundRect, segment } from 'vesica';

const vesica = await load();
const constructors = {
  point: [point, ['x', 'y']],
  segment: [segment, ['x0', 'y0', 'x1', 'y1']],
  circle: [circle, ['cx', 'cy', 'r']],
  aabb: [aabb, ['min_x', 'min_y', 'max_x', 'max_y']],
  rect: [rect, ['cx', 'cy', 'width', 'height']],
  ellipse: [ellipse, ['cx', 'cy', 'a', 'b']],
  capsule: [capsule, ['x0', 'y0', 'x1', 'y1', 'r']],
  roundRect: [roundRect, ['cx', 'cy', 'ux', 'uy', 'hx', 'hy', 'r']],
};
const refuses = (call, words) => assert.throws(call, { name: 'TypeError', message: words });

for (const [name, [make, names]] of Object.entries(constructors)) {
  test(`${name}: each argument that is missing or no number, and one too many`, () => {
    const numbers = names.map((_, i) => i + 1);
    assert.equal(make(...numbers).kind, name === 'roundRect' ? 'round_rect' : name);
    for (let count = 0; count < names.length; ++count) {
      refuses(() => make(...numbers.slice(0, count)), `${name}: ${names[count]} is undefined, not a number`);
    }
    for (const wrong of [undefined, null, '1', 1n, [1], Symbol('x')]) {
      names.forEach((field, i) => refuses(() => make(...numbers.map((number, k) => (k === i ? wrong : number))),
        `${name}: ${field} is ${String(wrong)}, not a number`));
    }
    const turned = name === 'rect' || name === 'ellipse', full = turned ? [...numbers, 0, {}] : numbers;
    refuses(() => make(...full, 7), `${name}: too many arguments: 7`);
    if (turned) refuses(() => make(...numbers, { degrees: true }), `${name}: angle is [object Object], not a number`);
    assert.equal(vesica.invalidity(make(...numbers.map(() => NaN))) === null, false);
  });
}

test('a plain object without a field', () => {
  const whole = rect(0, 0, 4, 2);
  for (const name of fields.rect) {
    const { [name]: _, ...rest } = whole;
    const words = new RegExp(`missing: ${name}$`);
    const calls = [() => vesica.overlap(rest, whole), () => vesica.bounds(rest), () => vesica.shapes('rect', [rest])];
    for (const call of calls) {
      assert.throws(call, (error) => error instanceof TypeError && words.test(error.message));
    }
  }
});

test('arrays of numbers with something else among them', () => {
  const words = (what, value, i) => `${what}: element ${i} is ${value}, not a number`;
  refuses(() => vesica.shapes('circle', [0, 0, undefined]), words('numbers of circle shapes', undefined, 2));
  refuses(() => vesica.shapes('circle', [[0, null, 1]]), words('numbers of a circle', null, 1));
  refuses(() => vesica.shapesFromBoxes('rect', [[0, 0, 1, 1, '0']]), words('boxes', 0, 4));
  refuses(() => polygon([0, 0, 1, undefined, 2, 2]), words('vertices of a polygon', undefined, 3));
  refuses(() => polyline([0, 0, 1, null]), words('vertices of a polyline', null, 3));
  refuses(() => vesica.polygons([0, 0, 1, '0', 1, 1], { each: 3 }), words('vertices of polygons', 0, 3));
  const plain = { kind: 'polygon', vertices: [0, 0, 1, null, 2, 2] };
  refuses(() => vesica.bounds(plain), words('vertices of a polygon', null, 3));
  refuses(() => polygon([[0, 0], [1, 0], [0, 1]], [0, 3]), 'polygon: nested coordinates have their rings themselves');
});
