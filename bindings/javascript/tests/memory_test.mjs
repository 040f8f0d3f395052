// SPDX-License-Identifier: Apache-2.0
// Input that views the module's own memory, which may grow meanwhile; what was freed; what another load() made.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { circle, load, point, rect } from 'vesica';
import { load as loadOverlap } from 'vesica/overlap';

const library = await load(), other = await loadOverlap();
const some = [rect(0, 0, 2, 2), rect(1, 0, 2, 2), rect(9, 0, 2, 2)], disc = circle(0, 0, 1);

// ---- Views of the module's memory ----

const pageSize = 65536;

/** Takes all memory that is there: whatever is taken next makes it grow. */
function fill({ memory }) {
  const { buffer } = memory;
  while (memory.buffer === buffer) memory.take(64);
  memory.take(pageSize - 64);
}

/** call(library, made(library), ...lists) answers alike of lists and of views of a memory that grows meanwhile. */
async function viewsAreAsLists(lists, call, made = () => undefined) {
  const vesica = await load(), there = made(vesica), expected = call(vesica, there, ...lists);
  const full = await load(), arrays = lists.map((list) => full.shapes('point', list)), madeThere = made(full);
  fill(full);
  const before = full.c.memory.buffer, views = arrays.map((array) => array.numbers);
  assert.deepEqual(call(full, madeThere, ...views), expected);
  assert.notEqual(full.c.memory.buffer, before);
}

test('numbers and boxes that are views', async () => {
  for (const scalar of ['f64', 'f32']) {
    await viewsAreAsLists([[0, 0, 1, 5, 5, 2]], (vesica, _, view) => vesica.shapes('circle', view, { scalar }).numbers);
    await viewsAreAsLists([[1, 2, 6, 4, 1, 0, 0, 1, 2, 2]], (vesica, _, view) =>
      vesica.shapesFromBoxes('rect', view, { scalar }).numbers);
  }
});

test('numbers that are a view, of a memory as it is', async () => {
  const vesica = await load(), circles = vesica.shapes('circle', Array.from({ length: 1000 }, () => disc));
  for (let i = 0; i < 4; ++i) assert.deepEqual(vesica.shapes('circle', circles.numbers).numbers, circles.numbers);
  fill(vesica);
  const bytes = Buffer.from(vesica.c.memory.buffer, circles.numbers.byteOffset, 300), numbers = [...bytes];
  assert.deepEqual([...vesica.shapes('circle', bytes).numbers], numbers);
});

test('scores and labels that are views', async () => {
  const boxes = (vesica) => vesica.shapes('rect', [...some, some[0]]);
  for (const name of ['nms', 'nmsSoft']) {
    await viewsAreAsLists([[0.5, 0.9, 0.7, 0.6], [1, 1, 1, 2]], (vesica, many, scores, labels) =>
      vesica[name](many, scores, 0.25, { labels }), boxes);
  }
});

test('velocities and turns that are views', async () => {
  const shapes = (vesica) => vesica.shapes('circle', [disc, circle(0, 3, 1)]);
  await viewsAreAsLists([[-1, -2], [0, 1]], (vesica, many, vx, vy) =>
    vesica.cast(many, point(9, 0), [vx, vy]), shapes);
  await viewsAreAsLists([[-1, 0]], (vesica, many, velocity) => vesica.cast(many, point(9, 0), velocity), shapes);
  await viewsAreAsLists([[-4, 0, 1, 0], [0, 0, 0, 0]], (vesica, _, ...turns) => {
    const [a, b] = turns.map((turn) => (Array.isArray(turn) ? turn.slice(0, 3) : turn.subarray(0, 3)));
    return vesica.impactTime(some[2], a, some[0], b, 0.01);
  });
});

test('bytes that are a view', async () => {
  const vesica = await load(), many = vesica.shapes('rect', some), { bytes } = vesica.index(many);
  const place = vesica.memory.take(bytes.length);
  new Uint8Array(vesica.c.memory.buffer, place).set(bytes);
  fill(vesica);
  for (const View of [Uint8Array, Buffer.from, Float64Array]) {
    const length = View === Float64Array ? bytes.length / 8 : bytes.length, { buffer } = vesica.c.memory;
    const view = View === Buffer.from ? Buffer.from(buffer, place, length) : new View(buffer, place, length);
    assert.deepEqual(vesica.indexFromBytes(view, many).bytes, bytes);
    fill(vesica);
  }
});

// ---- What was freed, and what another load() made ----

/** All that takes an array. */
const usesOfArrays = (vesica, live, index) => ({
  overlap: (many) => vesica.overlap(many, disc),
  relation: (many) => vesica.relation(disc, many),
  contains: (many) => vesica.contains(live, many),
  overlapMatrix: (many) => vesica.overlapMatrix(live, many),
  areaMatrix: (many) => vesica.areaMatrix(many, live),
  withinMatrix: (many) => vesica.withinMatrix(many, many, 1),
  nearest: (many) => vesica.nearest(many, live),
  ratio: (many) => vesica.ratio('over_union', many, disc),
  overlapSelect: (many) => vesica.overlapSelect(disc, many),
  cast: (many) => vesica.cast(many, disc, [1, 0]),
  castFirst: (many) => vesica.castFirst(disc, many, [1, 0]),
  boxes: (many) => vesica.boxes(many),
  corners: (many) => vesica.corners(many),
  boundsMany: (many) => vesica.boundsMany(many),
  nms: (many) => vesica.nms(many, Array(many.length).fill(1)),
  nmsSoft: (many) => vesica.nmsSoft(many, Array(many.length).fill(1)),
  index: (many) => vesica.index(many),
  indexOfTwo: (many) => vesica.index(live, many),
  indexFromBytes: (many) => vesica.indexFromBytes(index.bytes, many),
  nearestOfEach: (many) => index.nearestOfEach([live, many]),
});

const questions = {
  join: (index) => index.join(),
  joinCount: (index) => index.joinCount(),
  joinWithin: (index) => index.joinWithin(1),
  forEachPair: (index) => index.forEachPair(() => {}),
  select: (index) => index.select(disc),
  nearest: (index) => index.nearest(disc),
  nearestOfNone: (index) => index.nearest(disc, { k: 0 }),
  nearestOfEach: (index) => index.nearestOfEach([library.shapes('point', 1)]),
  cast: (index) => index.cast(disc, [1, 0]),
  castFirst: (index) => index.castFirst(disc, [1, 0]),
  rebuild: (index) => index.rebuild(),
};
const ownMatters = {
  order: (index) => index.order(),
  bounds: (index) => index.bounds(),
  bytes: (index) => index.bytes,
};
const joins = (live) => ({
  join: (index) => live.join({ with: index }),
  joinCount: (index) => live.joinCount({ with: index }),
  joinWithin: (index) => live.joinWithin(1, { with: index }),
  forEachPair: (index) => live.forEachPair(() => {}, { with: index }),
});

/** All calls answer for `sound`, and for `refused` they throw a TypeError that says so. */
function areRefused(calls, sound, refused, message) {
  for (const [name, call] of Object.entries(calls)) {
    call(sound);
    assert.throws(() => call(refused), (error) => error instanceof TypeError && message.test(error.message), name);
  }
}

const live = library.shapes('rect', some), liveIndex = library.index(live);

test('a freed array', () => {
  const many = library.shapes('rect', some);
  many.free();
  areRefused(usesOfArrays(library, live, liveIndex), live, many, /freed/);
  areRefused({ numbers: (array) => array.numbers, at: (array) => array.at(0) }, live, many, /freed/);
});

test('a freed index', () => {
  const index = library.index(live);
  index.free();
  areRefused({ ...questions, ...ownMatters, ...joins(liveIndex) }, liveIndex, index, /freed/);
});

test('an index over a freed array', () => {
  const many = library.shapes('rect', some), index = library.index(live, many), { bytes } = index;
  many.free();
  library.shapes('rect', 3).numbers.fill(7);
  areRefused({ ...questions, ...joins(liveIndex) }, liveIndex, index, /freed/);
  assert.deepEqual(index.bytes, bytes);
  index.free();
});

test('what is freed while pairs are handed out', () => {
  const over = (what) => {
    const many = library.shapes('circle', Array.from({ length: 300 }, () => disc)), index = library.index(many);
    let pairs = 0;
    assert.throws(() => index.forEachPair(() => ++pairs === 1 && { many, index }[what].free()), /freed/);
    assert.ok(pairs > 1 && pairs < (300 * 299) / 2, `${pairs} pairs`);
  };
  over('many');
  over('index');
});

test('an index that is built anew while pairs are handed out', () => {
  const many = library.shapes('circle', Array.from({ length: 300 }, () => disc)), index = library.index(many);
  const others = library.index(many);
  for (const rebuilt of [index, others]) {
    let pairs = 0;
    assert.throws(() => index.forEachPair(() => ++pairs === 1 && rebuilt.rebuild(), { with: others }), /built anew/);
    assert.ok(pairs > 1 && pairs < 300 * 300, `${pairs} pairs`);
  }
  assert.equal(index.joinCount(), (300 * 299) / 2);
});

test('a join with what is no index says so', () => {
  for (const none of [null, {}, live, 5]) {
    areRefused(joins(liveIndex), liveIndex, none, /an index is joined with an index/);
  }
});

test('what does not fit takes nothing, and small blocks are found again', async () => {
  const vesica = await load();
  vesica.shapes('point', 1);
  const before = vesica.c.memory.buffer.byteLength;
  for (let i = 0; i < 5000; ++i) assert.throws(() => vesica.shapes('point', 2 ** 40), /no room/);
  assert.equal(vesica.c.memory.buffer.byteLength, before);
  const many = Array.from({ length: 3000 }, (_, i) => vesica.shapes('point', 1 + (i % 7)));
  many.forEach((array, i) => i % 2 === 0 && array.free());
  const { byteLength } = vesica.c.memory.buffer;
  const again = many.map((array, i) => (i % 2 === 0 ? vesica.shapes('point', 1 + (i % 7)) : array));
  again.forEach((array, i) => array.numbers.fill(i));
  again.forEach((array, i) => assert.ok(array.numbers.every((number) => number === i)));
  assert.equal(vesica.c.memory.buffer.byteLength, byteLength);
  again.forEach((array) => array.free());
  assert.ok(byteLength < 40 * 65536, `${byteLength} bytes`);
});

test('blocks that are given back in any order are one again', async () => {
  const { memory } = await load();
  for (const step of [1, 7, 500, 501, 999, 1000]) {
    const places = Array.from({ length: 1001 }, () => memory.take(64)), { buffer } = memory, given = new Set();
    for (let i = 0; given.size < 1001; i = (i + step) % 1001) {
      while (given.has(i)) i = (i + 1) % 1001;
      given.add(i);
      memory.give(places[i], 64);
    }
    assert.equal(memory.take(64 * 1001), places[0]);
    assert.equal(memory.buffer, buffer);
    memory.give(places[0], 64 * 1001);
  }
});

test('an array or an index of another load()', () => {
  const foreign = other.shapes('rect', some);
  areRefused(usesOfArrays(library, live, liveIndex), live, foreign, /another load/);
  areRefused(joins(liveIndex), liveIndex, other.index(foreign), /another load/);
  const own = other.shapes('rect', some), calls = usesOfArrays(other, own, other.index(own));
  areRefused({ overlap: calls.overlap, contains: calls.contains, index: calls.index }, own, live, /another load/);
});

test('a plain object is of no scalar type', () => {
  const box = { ...some[0], scalar: 'toString' };
  assert.deepEqual(library.corners(box), library.corners(some[0]));
});
