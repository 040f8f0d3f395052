// SPDX-License-Identifier: Apache-2.0
// Polygons and polylines: plain objects, arrays, GeoJSON's coordinates.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { aabb, circle, constants, load, point, polygon, polyline, VesicaError } from 'vesica';

const vesica = await load();
const square = (x, y, size) => [[x, y], [x + size, y], [x + size, y + size], [x, y + size]];
const frame = polygon([square(0, 0, 8), square(2, 2, 4)]); // with a hole
const triangle = polygon([0, 0, 4, 0, 0, 3]);

test('one polygon', () => {
  const centre = circle(4, 4, 1), chain = polyline([[-1, 1], [9, 1], [9, 9]]);
  assert.equal(vesica.overlap(frame, centre), false);
  assert.equal(vesica.overlap(frame, chain), true);
  assert.equal(vesica.interiorsOverlap(frame, circle(4, 4, 2)), false);
  assert.equal(vesica.relation(triangle, point(1, 1)), 'contains');
  assert.equal(vesica.contains(frame, circle(1, 1, 1)), true);
  assert.equal(vesica.nearest(frame, centre).distance, 1);
  assert.equal(vesica.boundaryDistance(triangle, circle(1, 1, 0.5)).distance, 0.5);
  assert.equal(vesica.depth(triangle, point(1, 1)).depth, 1);
  assert.equal(vesica.signedDistance(triangle, point(-3, 0)), 3);
  assert.equal(vesica.within(triangle, point(-3, 0), 3), 'yes');
  assert.equal(vesica.area(triangle, aabb(0, 0, 2, 9)), 4.5);
  assert.equal(vesica.iou(frame, aabb(0, 0, 8, 8)), 0.75);
  assert.equal(vesica.ratio('over_first', triangle, aabb(0, 0, 2, 9)), 0.75);
  assert.equal(vesica.shapeArea(frame), 48);
  assert.deepEqual(vesica.bounds(triangle), aabb(0, 0, 4, 3));
  assert.equal(vesica.cast(aabb(0, 0, 4, 3), triangle, [-1, 0]).outcome, 'start');
  assert.equal(vesica.cast(triangle, point(4, 5), [0, -1]).t, 5);
  assert.ok(vesica.sweepBounds(triangle, [1, 0], 2).max_x >= 6);
  assert.equal(vesica.invalidity(frame), null);
});

test("GeoJSON's coordinates", () => {
  const closed = [...square(0, 0, 8), [0, 0]], hole = [...square(2, 2, 4), [2, 2]].reverse();
  assert.equal(vesica.relation(polygon([closed, hole]), frame), 'equal'); // Polygon
  const two = polygon([[closed, hole], [[[3, 3, 100], [5, 3, 100], [5, 5, 100], [3, 3, 100]]]]); // MultiPolygon
  assert.equal(vesica.shapeArea(two), 50);
  const lines = polyline([[[0, 0], [1, 0]], [[5, 5], [6, 6], [7, 5]]]); // MultiLineString
  assert.deepEqual(lines.rings, [0, 2, 5]);
  assert.equal(vesica.overlap(lines, point(6.5, 5.5)), true);
  assert.equal(vesica.overlap(lines, point(3, 3)), false);
});

test('arrays', () => {
  const row = [0, 3, 6].flatMap((x) => square(x, 0, 2).flat());
  for (const scalar of ['f64', 'f32']) {
    const discs = vesica.shapes('circle', [circle(1, 1, 1), circle(4, 1, 1), circle(9, 9, 1)], { scalar });
    const quads = vesica.polygons(row, { each: 4, scalar });
    const ringed = vesica.polygons(Float64Array.from(row), { rings: [0, 4, 8, 12], scalar });
    const nested = vesica.polygons(row, { rings: Int32Array.of(0, 4, 8, 12), polygons: [0, 1, 3], scalar });
    const mixed = vesica.polygons([polygon(row, [4, 8]), square(6, 0, 2), frame], { scalar });
    assert.deepEqual([quads, ringed, nested, mixed].map((many) => many.length), [3, 3, 2, 3]);
    assert.deepEqual([...vesica.overlap(quads, discs)], [1, 1, 0]);
    assert.deepEqual([...vesica.relation(quads, ringed)], [7, 7, 7]);
    assert.deepEqual([...vesica.areaMatrix(nested, quads)], [4, 0, 0, 0, 4, 4]);
    assert.deepEqual([...vesica.overlapMatrix(mixed, discs)], [0, 1, 0, 0, 0, 0, 1, 1, 0]);
    assert.deepEqual([...vesica.boundsMany(nested)], [0, 0, 2, 2, 3, 0, 8, 2]);
    assert.deepEqual([...vesica.nearest(quads, polyline([[0, 5], [9, 5]])).distance], [3, 3, 3]);
    assert.deepEqual([...vesica.contains(frame, discs)], [1, 1, 0]);
    assert.deepEqual(vesica.overlapSelect(polygon([[1, 1], [4, 1], [4, 1.5]]), quads), [0, 1]);
    assert.deepEqual(vesica.nms(quads, [1, 2, 3]), [2, 1, 0]);
    assert.equal(vesica.castFirst(point(9, 1), quads, [-1, 0]).item, 2);

    const index = vesica.index(quads, discs, mixed);
    assert.equal(index.joinCount({ with: vesica.index(ringed) }), 3 + 2 + 5);
    assert.deepEqual(index.select(frame).sort(), [0, 1, 2, 3, 4, 6, 7, 8]);
    assert.deepEqual(index.nearest(polyline([[20, 1], [30, 1]])), { items: [2], distances: [12] });

    assert.deepEqual(mixed.at(-1), frame);
    assert.deepEqual(nested.at(1).rings, [0, 4, 8]);
    assert.deepEqual(ringed.at(1), polygon(square(3, 0, 2)));
    quads.numbers.fill(1);
    assert.deepEqual([...vesica.boundsMany(quads)], Array(12).fill(1));
    assert.equal(vesica.polygons(ringed.numbers, { each: 4, scalar }).at(2).vertices[0], 6);
  }
  const none = vesica.polylines([]);
  assert.deepEqual([none.length, vesica.overlapMatrix(none, vesica.polygons([], { each: 3 })).length], [0, 0]);
});

test('large shapes', () => {
  const n = 20_000, round = Array.from({ length: n }, (_, i) => [Math.cos(i / n * 7), Math.sin(i / n * 7)]);
  const spiral = polyline(round);
  assert.equal(vesica.overlap(spiral, spiral), true);
  assert.equal(vesica.nearest(spiral, point(2, 0)).distance, 1);
});

test('wrong ones', () => {
  const refused = (call, type, words) =>
    assert.throws(call, (error) => error instanceof type && words.test(error.message), String(words));
  refused(() => polygon([]), RangeError, /a polygon has a vertex or more/);
  refused(() => polygon([1, 2, 3]), RangeError, /3 is odd/);
  refused(() => polygon('x'), TypeError, /nested arrays/);
  refused(() => polyline([[0, 0], [1, 'x']]), TypeError, /two numbers/);
  refused(() => polyline([[0, 0], [1]]), TypeError, /two numbers/);
  const ringed = (rings) => vesica.shapeArea(polygon([0, 0, 1, 0, 0, 1], rings));
  refused(() => ringed([0, 4]), RangeError, /rings ascend from 0 or more to 3 at most: 4 follows 0/);
  refused(() => ringed([-1, 3]), RangeError, /-1 follows 0/);
  refused(() => ringed([0, 2, 1]), RangeError, /1 follows 2/);
  refused(() => ringed([0, 1.5]), RangeError, /1.5 follows 0/);
  refused(() => ringed([]), TypeError, /one more than there are parts/);
  refused(() => vesica.shapeArea({ kind: 'polygon' }), TypeError, /has vertices/);
  refused(() => vesica.polygons([0, 0, 1, 1]), TypeError, /rings are an array of whole numbers/);
  refused(() => vesica.polygons([0, 0, 1, 1, 2, 2], { each: 2 }), RangeError, /3 vertices are no polygons of 2 each/);
  refused(() => vesica.polygons([0, 0, 1, 1], { each: 0 }), RangeError, /of 0 each/);
  refused(() => vesica.polygons([0, 0, 1, 1], { rings: [0, 2], polygons: [0, 2] }), RangeError, /polygons ascend/);
  refused(() => vesica.polygons(5), TypeError, /polygons are an array/);
  refused(() => vesica.polylines([frame]), TypeError, /a polygon among polylines/);
  refused(() => vesica.polygons([[[0, 0], [1e300, 0]]], { scalar: 'f32' }), RangeError, /greatest float32/);
  refused(() => vesica.depth(frame, point(1, 1)), VesicaError, /convex/);
  refused(() => vesica.overlap(polygon([NaN, 0, 1, 1]), frame), VesicaError, /invalid/);
  assert.match(vesica.invalidity(polygon([0, 0, 4, 4, 4, 0, 0, 4])), /cross/);
  const quads = vesica.polygons([...square(0, 0, 2), ...square(NaN, 0, 2), ...square(6, 0, 2)].flat(), { each: 4 });
  assert.throws(() => vesica.overlap(quads, point(1, 1)), ({ code, result }) => {
    assert.equal(code, constants.E_SHAPE);
    assert.deepEqual([...result], [1, 0, 0]);
    return true;
  });
  quads.free();
  refused(() => vesica.overlap(quads, frame), TypeError, /freed/);
  refused(() => quads.at(0), TypeError, /freed/);
});
