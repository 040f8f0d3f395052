// SPDX-License-Identifier: Apache-2.0
// The installed package by its public names alone.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { aabb, capsule, circle, ellipse, point, polygon, polyline, rect, roundRect, segment } from 'vesica';
import { constants, fields, kinds, load, relations, VesicaError } from 'vesica';

const vesica = await load();
const a = aabb(0, 0, 2, 2), b = aabb(1, 1, 3, 3), inner = circle(1, 1, 0.5), away = circle(6, 1, 1);

let state = 12345;
const random = () => (state = (state * 1103515245 + 12345) % 2 ** 31) / 2 ** 31;
function randomShape(kind) {
  const [x, y, w, h, angle] = [random() * 2 - 1, random() * 2 - 1, random() + 0.1, random() + 0.1, random() * 6];
  return {
    point: () => point(x, y),
    segment: () => segment(x, y, x + w, y + h),
    circle: () => circle(x, y, w),
    aabb: () => aabb(x, y, x + w, y + h),
    rect: () => rect(x, y, w, h, angle),
    ellipse: () => ellipse(x, y, w, h, angle),
    capsule: () => capsule(x, y, x + w, y + h, w / 4),
    round_rect: () => roundRect(x, y, Math.cos(angle), Math.sin(angle), w, h, w / 4),
    polygon: () => polygon([[x, y], [x + w, y], [x, y + h]]),
    polyline: () => polyline([[x, y], [x + w, y + h]]),
  }[kind]();
}

/** Are some questions not for a kind? */
const isLimited = (kind) => ['capsule', 'round_rect', 'polyline'].includes(kind);

test('known answers', () => {
  assert.equal(vesica.overlap(a, b), true);
  assert.equal(vesica.overlap(a, away), false);
  assert.equal(vesica.relation(a, b), 'cross');
  assert.equal(vesica.contains(a, inner), true);
  assert.equal(vesica.area(a, b), 1);
  assert.equal(vesica.iou(a, b), 1 / 7);
  assert.deepEqual(vesica.nearest(a, away), { distance: 3, ax: 2, ay: 1, bx: 5, by: 1 });
  assert.equal(vesica.boundaryDistance(a, inner).distance, 0.5);
  assert.equal(vesica.depth(a, b).depth, 1);
  assert.equal(vesica.shapeArea(a), 4);
  assert.deepEqual(vesica.bounds(away), aabb(5, 0, 7, 2));
  assert.equal(vesica.crossings(a, b).places.length, 2);
  assert.equal(vesica.crossings(a, a).shared, true);
  assert.match(vesica.version, /^\d+\.\d+\.\d+$/);
});

test('capsules and rounded rectangles', () => {
  const bar = capsule(0, 0, 4, 0, 1), rounded = roundRect(10, 0, 1, 0, 2, 1, 0.5);
  assert.equal(vesica.overlap(bar, point(5, 0)), true);
  assert.equal(vesica.overlap(bar, point(5, 5e-324)), false);
  assert.equal(vesica.nearest(bar, rounded).distance, 2.5);
  assert.equal(vesica.within(bar, rounded, 2.5), 'yes');
  assert.equal(vesica.area(bar, rounded), 0);
  assert.deepEqual(vesica.bounds(rounded), aabb(7.5, -1.5, 12.5, 1.5));
  const bars = vesica.shapes('capsule', [bar, capsule(0, 5, 4, 5, 1)]);
  assert.deepEqual(bars.at(0), bar);
  assert.deepEqual([...vesica.overlap(bars, point(5, 0))], [1, 0]);
  assert.deepEqual(vesica.index(bars).select(point(5, 0)), [0]);
  assert.deepEqual(vesica.crossings(bar, rounded).places, []);
  assert.equal(vesica.contains(rounded, ellipse(10, 0, 1, 1)), true);
  assert.deepEqual(vesica.crossings(rounded, ellipse(10, 0, 1, 1)).places, []);
  assert.equal(vesica.crossings(rounded, ellipse(10, 0, 1, 2)).places.length, 4);
});

test('both modules say the same', async () => {
  const plain = await load({ simd: false });
  assert.deepEqual([vesica.isa, plain.isa], ['simd128', 'portable']);
  for (const scalar of ['f64', 'f32']) {
    for (const kind of ['circle', 'aabb', 'rect', 'ellipse', 'capsule', 'round_rect', 'polygon']) {
      const shapes = Array.from({ length: 100 }, () => randomShape(kind));
      const [fast, slow] = [vesica, plain].map((library) => library.shapes(kind, shapes, { scalar }));
      for (const name of ['overlapMatrix', 'relationMatrix', 'iouMatrix']) {
        assert.deepEqual(vesica[name](fast, fast), plain[name](slow, slow));
      }
      assert.deepEqual(vesica.depth(fast, fast.at(0)), plain.depth(slow, slow.at(0)));
      assert.deepEqual(vesica.index(fast).bytes, plain.index(slow).bytes);
    }
  }
});

test('an older module is refused', async () => {
  // A module whose vesica_version() is 99.
  const name = [...'vesica_version'].map((letter) => letter.charCodeAt(0));
  const module = new Uint8Array([
    0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 5, 1, 0x60, 0, 1, 0x7f, 3, 2, 1, 0,
    7, 18, 1, 14, ...name, 0, 0, 10, 7, 1, 5, 0, 0x41, 0xe3, 0, 0x0b,
  ]);
  await assert.rejects(load({ module }), /vesica 99 is older than \d+, which this package needs: load the module/);
});

test('quarter turns in degrees are exact', () => {
  for (const [angle, ux, uy] of [[0, 1, 0], [90, 0, 1], [180, -1, 0], [270, 0, -1], [-90, 0, -1], [810, 0, 1]]) {
    const turned = rect(0, 0, 4, 2, angle, { degrees: true });
    assert.ok(turned.ux === ux && turned.uy === uy, `${angle}`);
  }
  assert.ok(Math.abs(rect(0, 0, 4, 2, 30, { degrees: true }).uy - 0.5) < 1e-15);
});

test('an angle and its complement mirror each other', () => {
  const axis = (angle, degrees) => Object.values(rect(0, 0, 4, 2, angle, { degrees })).slice(3, 5);
  for (let angle = -360; angle <= 360; angle += 2.5) {
    assert.deepEqual(axis(90 - angle, true), axis(angle, true).reverse(), `${angle}`);
  }
  for (const eighths of [-3, -1, 1, 3]) {
    const [ux, uy] = axis((eighths * Math.PI) / 4, false).map(Math.abs);
    assert.equal(ux, uy);
  }
});

const smallest = { f64: 5e-324, f32: 2 ** -149 };

test('sizes that cannot be halved are kept', () => {
  assert.deepEqual(rect(1, 2, 5e-324, 3), { kind: 'rect', cx: 1, cy: 2, ux: 0.5, uy: 0, hx: 5e-324, hy: 3 });
  assert.deepEqual(rect(1, 2, 1e-323, 3), { kind: 'rect', cx: 1, cy: 2, ux: 1, uy: 0, hx: 5e-324, hy: 1.5 });
  const thrice = 3 * smallest.f32, largest = 2 ** 127 * (2 - 2 ** -23); // of floats
  for (const scalar of ['f64', 'f32']) {
    const tiny = smallest[scalar], halved = [[tiny, 1], [1, tiny], [2 * tiny, 3 * tiny], [0, tiny], [thrice, largest]];
    for (const [width, height] of [...halved, [2 * tiny, 1], [4, 2], [0, 0]]) {
      const made = vesica.shapes('rect', [rect(1, 2, width, height)], { scalar });
      assert.deepEqual(made.numbers, rectInC(scalar, 1, 2, 0, width, height), `${scalar} ${width} ${height}`);
    }
  }
});

function rectInC(scalar, ...given) {
  const Numbers = scalar === 'f64' ? Float64Array : Float32Array;
  return vesica.inRoom((room) => {
    const out = room.take(48);
    vesica.check(vesica.c[`vesica_rect_from_angle_${scalar}`](...given, out));
    return new Numbers(vesica.c.memory.buffer, out, 6).slice();
  });
}

test('a rectangle with a size that floats cannot halve', () => {
  const thin = rect(0, 0, smallest.f32, 2), many = vesica.shapes('point', [0, 0.5], { scalar: 'f32' });
  const half = { kind: 'rect', cx: 0, cy: 0, ux: 0.5, uy: 0, hx: smallest.f32, hy: 2 };
  const lines = [thin, half].map((shape) => vesica.shapes('rect', [shape], { scalar: 'f32' }));
  assert.deepEqual(lines[0].at(0), half);
  assert.equal(relations[vesica.relation(...lines)[0]], 'equal');
  assert.equal(relations[vesica.relation(thin, lines[1])[0]], 'equal'); // one that a call takes in
  assert.equal(relations[vesica.relation(many, thin)[0]], 'inside');
  // What is no such size, and an axis that cannot be halved, stay as they are.
  for (const shape of [{ ...thin, hx: 0.25 }, { ...thin, ux: smallest.f32 }, { ...thin, hy: 2 ** 127 }]) {
    const [cx, cy, ux, uy, hx, hy] = vesica.shapes('rect', [shape], { scalar: 'f32' }).numbers;
    assert.deepEqual({ kind: 'rect', cx, cy, ux, uy, hx, hy }, { ...shape, hx: Math.fround(shape.hx) });
  }
});

test('arrays say what single shapes say', () => {
  for (const kindA of kinds) {
    for (const kindB of kinds) {
      const first = Array.from({ length: 9 }, () => randomShape(kindA)),
        second = Array.from({ length: 9 }, () => randomShape(kindB));
      const many = [vesica.shapes(kindA, first), vesica.shapes(kindB, second)];
      const hasAll = !isLimited(kindA) && !isLimited(kindB);
      const hits = vesica.overlap(...many), matrix = vesica.overlapMatrix(...many);
      const near = vesica.nearest(...many), depths = vesica.depth(...many);
      const codes = vesica.relation(...many), held = vesica.containsMatrix(...many);
      const outlines = vesica.boundaryDistance(...many), areas = hasAll && vesica.area(...many);
      first.forEach((one, i) => {
        assert.equal(hits[i] === 1, vesica.overlap(one, second[i]));
        assert.equal(relations[codes[i]], vesica.relation(one, second[i]));
        assert.equal(near.distance[i], vesica.nearest(one, second[i]).distance);
        assert.equal(outlines.bx[i], vesica.boundaryDistance(one, second[i]).bx);
        assert.equal(depths.depth[i], vesica.depth(one, second[i]).depth);
        if (hasAll) assert.equal(areas[i], vesica.area(one, second[i]));
        second.forEach((other, j) => {
          assert.equal(matrix[i * 9 + j] === 1, vesica.overlap(one, other));
          assert.equal(held[i * 9 + j] === 1, vesica.contains(one, other));
        });
        const row = [...vesica.overlap(one, many[1])];
        assert.deepEqual(vesica.overlapSelect(one, many[1]), row.flatMap((hit, j) => (hit ? [j] : [])));
      });
      many.forEach((shapes) => shapes.free());
    }
  }
});

test('arrays: sources, views, scalars, outputs', () => {
  const flat = vesica.shapes('circle', [0, 0, 1, 5, 5, 1]), rows = vesica.shapes('circle', [[0, 0, 1], [5, 5, 1]]);
  assert.deepEqual([...flat.numbers], [...rows.numbers]);
  assert.deepEqual(flat.at(-1), circle(5, 5, 1));
  flat.numbers[3] = 0.5;
  flat.numbers[4] = 0;
  assert.deepEqual([...vesica.overlap(flat, point(0.5, 0))], [1, 1]);
  const half = vesica.shapes('circle', new Float32Array([0, 0, 1]), { scalar: 'f32' });
  assert.ok(vesica.area(half, half) instanceof Float32Array);
  assert.throws(() => vesica.overlap(flat, half), TypeError);
  const out = new Uint8Array(4).fill(7);
  assert.equal(vesica.overlap(flat, point(0, 0), { out }), out);
  assert.deepEqual([...out], [1, 1, 7, 7]);
  assert.throws(() => vesica.overlap(flat, point(0, 0), { out: new Uint8Array(1) }), RangeError);
  assert.equal(vesica.overlap(vesica.shapes('rect', 0), point(0, 0)).length, 0);
  assert.throws(() => vesica.overlap(flat, vesica.shapes('point', 3)), RangeError);
});

test('a count gives zeros, in memory that was used too', () => {
  vesica.shapes('circle', new Float64Array(300).fill(7)).free();
  assert.ok(vesica.shapes('circle', 100).numbers.every((number) => number === 0));
});

test('what is refused says why', () => {
  assert.throws(() => vesica.overlap({ kind: 'square' }, a), /kind is one of point/);
  assert.throws(() => vesica.overlap({ kind: 'circle', cx: 1 }, a), /missing: cy, r/);
  assert.throws(() => vesica.overlap(undefined, a), TypeError);
  assert.throws(() => vesica.shapes('rect', [1, 2, 3]), /6 numbers each/);
  const noLists = [null, undefined, {}, new Set(), new Map([[1, 2]]), 'ab', '', 7n, Symbol('x'), () => 1];
  for (const source of [...noLists, new ArrayBuffer(16), new DataView(new ArrayBuffer(16)), { length: NaN }]) {
    const refused = { name: 'TypeError', message: /^(shapes are a count, or an array|a point is an object)/ };
    assert.throws(() => vesica.shapes('point', source), refused, String(source));
  }
  assert.deepEqual([...vesica.shapes('point', { length: 1, 0: point(1, 2) }).numbers], [1, 2]);
  assert.throws(() => vesica.shapes('rect', [[1, 2]]), /array of 6 numbers \(cx, cy/);
  assert.throws(() => vesica.shapes('rect', [circle(0, 0, 1)]), /a rect is/);
  for (const scalar of ['f16', 'toString', ['f64']]) {
    assert.throws(() => vesica.shapes('rect', 1, { scalar }), /scalar is 'f64' or 'f32', not ["[]/);
    assert.throws(() => vesica.shapesFromBoxes('rect', [1, 2, 3, 4, 5], { scalar }), TypeError);
  }
  assert.throws(() => vesica.overlap(circle(NaN, 0, 1), a), { name: 'VesicaError', code: -2 });
  assert.match(vesica.invalidity(circle(0, 0, -1)), /negative/);
  assert.equal(vesica.invalidity(a), null);
  const bad = vesica.shapes('circle', [0, 0, 1, 0, 0, -1, 1, 1, 1]);
  assert.throws(() => vesica.overlap(bad, a), (error) => error instanceof VesicaError &&
    [...error.result].join() === '1,0,1');
  assert.throws(() => vesica.overlapSelect(a, bad), (error) => error.result.join() === '0,2');
  assert.throws(() => vesica.nms(bad, [1, 2]), RangeError);
  bad.free();
  assert.throws(() => vesica.overlap(bad, a), /freed/);
});

test('suppression', () => {
  const boxes = vesica.shapes('rect', [rect(0, 0, 2, 2), rect(0.1, 0, 2, 2), rect(5, 0, 2, 2)]);
  assert.deepEqual(vesica.nms(boxes, [0.5, 0.9, 0.1], 0.5), [1, 2]);
  assert.deepEqual([...vesica.iouMatrix(boxes, boxes)].map((x) => x > 0.5),
    [true, true, false, true, true, false, false, false, true]);
});

test('index and join', () => {
  const shapes = kinds.map((kind) => Array.from({ length: 60 }, () => randomShape(kind)).map((shape) =>
    ({ ...shape })));
  const sets = kinds.map((kind, k) => vesica.shapes(kind, shapes[k])), all = shapes.flat();
  const index = vesica.index(...sets);
  const expected = [];
  all.forEach((one, i) => all.forEach((other, j) => i < j && vesica.overlap(one, other) && expected.push(`${i} ${j}`)));
  const { a: first, b: second } = index.join();
  assert.deepEqual(first.map((i, p) => `${i} ${second[p]}`).sort(), expected.sort());
  assert.equal(index.joinCount(), expected.length);
  const probe = circle(0.2, 0.1, 0.3);
  assert.deepEqual(index.select(probe).sort((x, y) => x - y),
    all.flatMap((shape, i) => (vesica.overlap(shape, probe) ? [i] : [])));
  const far = point(9, 9), { items, distances } = index.nearest(far, { k: 4 });
  const order = all.map((shape, i) => [vesica.nearest(shape, far).distance, i]).sort((x, y) => x[0] - y[0] ||
    x[1] - y[1]);
  assert.deepEqual(items.map((item, i) => [distances[i], item]), order.slice(0, 4));
  const again = vesica.indexFromBytes(index.bytes, ...sets);
  assert.deepEqual(again.join(), index.join());
  const damaged = index.bytes;
  damaged[100] ^= 1;
  assert.throws(() => vesica.indexFromBytes(damaged, ...sets), { name: 'VesicaError', code: -10 });
  assert.throws(() => vesica.indexFromBytes(index.bytes, sets[0]), RangeError);
  for (const query of ['near', 'toString', '__proto__']) {
    assert.throws(() => index.join({ query }), TypeError);
    assert.throws(() => index.joinCount({ query }), TypeError);
    assert.throws(() => index.forEachPair(() => {}, { query }), TypeError);
  }
  for (const bytes of [undefined, null, 5, 'bytes']) {
    assert.throws(() => vesica.indexFromBytes(bytes, ...sets), TypeError);
  }
  assert.throws(() => vesica.index(), TypeError);
  assert.throws(() => index.nearest(far, { within: -1 }), VesicaError);
  const more = vesica.shapes('circle', Array.from({ length: 300 }, () => circle(1, 1, 1)));
  assert.equal(vesica.index(more).join().a.length, (300 * 299) / 2);
});

test('an index of shapes that move', () => {
  const shapes = Array.from({ length: 300 }, () => randomShape('ellipse')), many = vesica.shapes('ellipse', shapes);
  const index = vesica.index(many), pairs = (of) => {
    const list = [];
    of.forEachPair((a, b) => list.push(`${a} ${b}`));
    return list;
  };
  let pages;
  for (let frame = 0; frame < 5; ++frame) {
    const { numbers } = many;
    for (let i = 0; i < numbers.length; i += 6) numbers[i] += random() - 0.5;
    index.rebuild();
    const fresh = vesica.index(many);
    assert.deepEqual(index.bytes, fresh.bytes);
    assert.deepEqual(pairs(index), pairs(fresh));
    assert.equal(pairs(index).length, index.joinCount());
    fresh.free();
    pages ??= vesica.c.memory.buffer.byteLength;
  }
  assert.equal(vesica.c.memory.buffer.byteLength, pages);
  assert.throws(() => index.forEachPair(), TypeError);
  const before = pairs(index), during = [];
  index.forEachPair((a, b) => {
    if (during.length === 0) vesica.shapes('rect', 100000).free(); // the memory grows while pairs are handed out
    during.push(`${a} ${b}`);
  });
  assert.deepEqual(during, before);
  many.numbers[0] = NaN;
  index.rebuild();
  assert.equal(index.incomplete, true);
  assert.ok(!pairs(index).some((pair) => pair.startsWith('0 ')));
  index.free();
  assert.throws(() => index.rebuild(), TypeError);
});

test('rooms: one in another, and one that takes more than there is', () => {
  vesica.inRoom((outer) => {
    const kept = outer.take(8), before = vesica.memory.scratch;
    vesica.memory.doubles[kept / 8] = 7;
    vesica.inRoom((inner) => {
      const places = [8, 5000, 100_000, 8].map((size) => inner.take(size));
      for (const place of places) vesica.memory.doubles[place / 8] = 9;
      assert.equal(new Set([kept, ...places]).size, 5);
    });
    assert.equal(vesica.memory.scratch, before);
    assert.equal(vesica.overlap(circle(0, 0, 1), circle(2, 0, 1)), true);
    assert.equal(vesica.memory.doubles[kept / 8], 7);
  });
});

test('memory is given back', () => {
  const pages = () => vesica.c.memory.buffer.byteLength;
  const work = () => {
    const many = vesica.shapes('rect', Array.from({ length: 20000 }, () => randomShape('rect'))),
      index = vesica.index(many);
    vesica.overlap(many, a);
    index.free();
    index.free();
    many.free();
  };
  work();
  const before = pages();
  for (let i = 0; i < 20; ++i) work();
  assert.equal(pages(), before);
});

test('the vectors that every host answers', () => {
  const view = new DataView(new ArrayBuffer(8));
  let calls = 0;
  for (const line of readFileSync(new URL('./vectors.txt', import.meta.url), 'utf8').split('\n')) {
    const [what, expected, ...words] = line.split(' ');
    if (!/^(f64|f32|many)$/.test(what)) continue;
    const shape = (at) => {
      const kind = kinds[+words[at]];
      const numbers = words.slice(at + 1, at + 7).map((word) =>
        (view.setBigUint64(0, BigInt('0x' + word)), view.getFloat64(0)));
      return kind && { kind, numbers: numbers.slice(0, fields[kind].length) };
    };
    const [first, second] = [shape(0), shape(7)];
    if (!first || !second) continue; // an unknown kind: there are no such shapes here
    const scalar = what === 'f32' ? 'f32' : 'f64';
    const [one, other] = [first, second].map(({ kind, numbers }) => vesica.shapes(kind, numbers, { scalar }));
    let answer;
    try {
      answer = vesica.overlap(one, other)[0];
    } catch (error) {
      answer = error.code;
    }
    assert.equal(answer, +expected, line);
    ++calls;
  }
  assert.ok(calls > 150);
});

test('scores of float32 boxes are ranked as they are', () => {
  const boxes = [aabb(0, 0, 2, 2), aabb(0, 0, 2, 2), aabb(9, 0, 10, 1)];
  for (const scalar of ['f64', 'f32']) {
    const many = vesica.shapes('aabb', boxes, { scalar }), scores = [0.9, 0.9 + 1e-12, 0.1];
    assert.deepEqual(vesica.nms(many, scores), [1, 2]);
    assert.deepEqual(vesica.nms(many, scores, 0.5, { leastScore: 0.9 + 1e-13 }), [1]);
    assert.deepEqual(vesica.nms(many, [0.5, 0.25, 0.5], 0.5, { leastScore: 0.5 + 1e-12 }), []);
    assert.deepEqual(vesica.nms(many, [-0, 0, 1e-50]), [2, 0]);
    for (const wrong of [{ leastScore: NaN }, { leastScore: null }]) {
      assert.throws(() => vesica.nms(many, scores, 0.5, wrong), scalar);
    }
    assert.throws(() => vesica.nms(many, [0.9, NaN, 0.1]), { code: constants.E_SHAPE });
    assert.throws(() => vesica.nms(many, scores, null), /numbers/);
  }
});

test('what float32 has no number for, beside an array of it', () => {
  const discs = vesica.shapes('circle', [circle(0, 0, 1)], { scalar: 'f32' }), index = vesica.index(discs);
  const calls = [
    () => vesica.overlap(discs, point(1e39, 0)),
    () => vesica.within(discs, point(0, 0), 5e38),
    () => vesica.withinMatrix(discs, discs, 5e38),
    () => index.select(point(0, -1e39)),
    () => index.nearest(point(0, 0), { within: 5e38 }),
    () => index.nearestOfEach([discs], { within: 5e38 }),
    () => index.joinWithin(5e38),
    () => vesica.shapes('point', [point(1e39, 0)], { scalar: 'f32' }),
    () => vesica.shapes('rect', [rect(0, 0, 1e39, 1)], { scalar: 'f32' }),
    () => vesica.cast(discs, point(9, 0), [-1e39, 0]),
    () => vesica.cast(discs, point(9, 0), [[-1], { length: 1, 0: 1e39 }]),
    () => vesica.cast(discs, point(9, 0), [-1, 0], { tEnd: 1e39 }),
    () => vesica.castFirst(point(9, 0), discs, [0, 1e39]),
    () => vesica.castFirst(point(9, 0), discs, [-1, 0], { tEnd: 1e39 }),
    () => index.cast(point(9, 0), [0, 1e39]),
    () => index.castFirst(point(9, 0), [-1, 0], { tEnd: 1e39 }),
    () => vesica.nmsSoft(discs, [1e39]),
    () => vesica.nmsSoft(discs, [1], 1e39, { decay: 'gaussian' }),
    () => vesica.nmsSoft(discs, [1], 0.5, { leastScore: 1e39 }),
  ];
  for (const call of calls) assert.throws(call, { name: 'RangeError', message: /above the greatest float32/ });
  assert.deepEqual([...vesica.within(discs, point(1e9, 0), Infinity)], [1]);
  assert.throws(() => index.nearest(point(0, 0), { within: null }), TypeError);
  assert.throws(() => index.select(null), TypeError);
  assert.deepEqual([...vesica.cast(discs, point(9, 0), [-1, 0], { tEnd: Infinity }).t], [8]);
  for (const wrong of [[null], [0.5, { leastScore: null }]]) {
    assert.throws(() => vesica.nmsSoft(discs, [1], ...wrong), { name: 'TypeError', message: /are numbers/ });
  }
});

test('parts that have no place in 64 bits', () => {
  const index = vesica.index(vesica.shapes('circle', [circle(0, 0, 1), circle(1, 0, 1)]));
  for (const how of [{ parts: 2 ** 64 + 4096 }, { part: 2 ** 64 }, { part: 0.5 }, { parts: null }]) {
    for (const call of [() => index.join(how), () => index.joinCount(how), () => index.joinWithin(1, how)]) {
      assert.throws(call, { name: 'RangeError', message: /whole numbers/ });
    }
  }
  assert.throws(() => vesica.index(vesica.shapes('point', 1)).join({ part: 1 }), { code: constants.E_ARGUMENT });
  const array = vesica.shapes('point', 3);
  assert.throws(() => (array.length = 5), TypeError);
  assert.equal(array.length, 3);
});
