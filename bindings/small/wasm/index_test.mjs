// SPDX-License-Identifier: Apache-2.0
// index_test.mjs MODULE: index and join in the module: the bytes and pairs of tests/index/same_bytes_test.cpp.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { kinds, load } from './vesica.mjs';

const mask = (1n << 64n) - 1n;
const descriptorSize = 72;

/** Rectangles, circles and points over 20 scales, many of which touch. */
function touching(count, seed) {
  const draw = (below) => {
    seed = (seed * 6364136223846793005n + 1442695040888963407n) & mask;
    return Number((seed >> 33n) % BigInt(below));
  };
  const rects = [], circles = [], points = [];
  for (let i = 0; i < count; i++) {
    const unit = i % 7 === 0 ? 2 ** -draw(20) : 1;
    const x = draw(60) * unit, y = draw(60) * unit;
    if (i % 5 === 0) circles.push(x, y, unit / 2);
    else if (i % 5 === 1) points.push(x + unit / 2, y);
    else rects.push(x, y, i % 2, 1 - (i % 3) / 4, unit / 2, unit / 4);
  }
  return [[kinds.rect, rects], [kinds.circle, circles], [kinds.point, points]];
}

function fnv(numbers) {
  let hash = 0xcbf29ce484222325n;
  for (const number of numbers) hash = ((hash ^ BigInt(number)) * 0x100000001b3n) & mask;
  return hash;
}

const library = await load(readFileSync(process.argv[2]), 16 << 20);
const { c } = library;
const memory = () => c.memory.buffer;
const lines = (size) => Math.ceil(library.reserve(Number(size) + 64) / 64) * 64;

/** Sets side by side, as the index takes them, and their index. */
function build(sets) {
  const descriptors = library.reserve(sets.length * descriptorSize);
  let items = 0;
  sets.forEach(([kind, numbers], i) => {
    const count = numbers.length / c.vesica_field_count(kind);
    const shapes = library.shapes(kind, count);
    shapes.numbers.set(numbers);
    const end = shapes.address + descriptorSize;
    new Uint8Array(memory()).copyWithin(descriptors + i * descriptorSize, shapes.address, end);
    items += count;
  });
  const size = c.vesica_index_size(BigInt(items)), scratchSize = c.vesica_index_scratch(BigInt(items));
  const index = lines(size), scratch = lines(scratchSize);
  const bytes = c.vesica_index_build_f64(descriptors, sets.length, index, size, scratch, scratchSize);
  assert.ok(bytes > 0n);
  assert.equal(c.vesica_index_check(index, bytes), 0);
  return { descriptors, count: sets.length, index, bytes: Number(bytes) };
}

function join(a, b) {
  const room = 4096, scratchSize = c.vesica_join_scratch();
  const scratch = lines(scratchSize), first = library.reserve(8 * room), second = library.reserve(8 * room);
  const state = new BigInt64Array(memory(), library.reserve(32), 4);
  const pairs = [];
  while (state[0] !== -1n) {
    const found = Number(c.vesica_join_f64(0, a.index, a.descriptors, a.count, b.index, b.descriptors, b.count, 0n, 1n,
      scratch, scratchSize, first, second, BigInt(room), state.byteOffset));
    assert.ok(found >= 0);
    const [of_a, of_b] = [first, second].map((at) => new BigInt64Array(memory(), at, found));
    of_a.forEach((item, i) => pairs.push(item, of_b[i]));
  }
  return pairs;
}

const a = build(touching(9000, 1n)), b = build(touching(7000, 2n));
assert.equal(fnv(new Uint8Array(memory(), a.index, a.bytes)), 14017431053294008823n);
assert.equal(fnv(join(a, b)), 9459960488521776375n);
assert.equal(fnv(join(a, a)), 12175247251169411526n);
new Uint8Array(memory())[a.index + 100] ^= 1;
assert.equal(c.vesica_index_check(a.index, BigInt(a.bytes)), -10);
console.log('index: as in C');
