// SPDX-License-Identifier: Apache-2.0
// vesica_test.mjs MODULE MAP DESCRIPTION VECTORS: the module, by its binding, under Node.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { kinds, load, VesicaError } from './vesica.mjs';

const [modulePath, mapPath, descriptionPath, vectorsPath] = process.argv.slice(2);
const bytes = readFileSync(modulePath);
const module = new WebAssembly.Module(bytes);
const vesica = await load(bytes);

const unitSquare = [0, 0, 1, 0, 1, 1], farSquare = [9, 0, 1, 0, 1, 1], noSquare = [NaN, 0, 1, 0, 1, 1];
const disc = [2, 0, 1];

// What the module wants and gives.
{
  assert.deepEqual(WebAssembly.Module.imports(module), []);
  const listed = [...readFileSync(mapPath, 'utf8').matchAll(/^ +(vesica_\w+);/gm)].map((match) => match[1]);
  const exported = WebAssembly.Module.exports(module).map((entry) => entry.name);
  assert.ok(listed.length > 100);
  assert.deepEqual(exported.sort(), ['memory', ...listed].sort());
}

// An array of shapes has another layout than on 64-bit machines: that of its types, with pointers of 4 bytes.
for (const scalar of ['f64', 'f32']) {
  const sizes = { int32_t: 4, int64_t: 8, ptrdiff_t: 4 };
  const struct = JSON.parse(readFileSync(descriptionPath)).structs.find((s) => s.name === `vesica_shapes_${scalar}`);
  const offsets = {};
  let end = 0;
  for (const { name, type, count = 1 } of struct.fields) {
    const size = type.endsWith('*') ? 4 : sizes[type];
    offsets[name] = Math.ceil(end / size) * size;
    end = offsets[name] + size * count;
  }
  assert.deepEqual(offsets, { kind: 0, reserved: 4, count: 8, stride: 16, field: 20, rings: 52, polygons: 56, each: 64 });
  assert.equal(Math.ceil(end / 8) * 8, 72);

  const address = vesica.reserve(80), view = new DataView(vesica.c.memory.buffer, address, 80);
  new Uint8Array(vesica.c.memory.buffer, address, 80).fill(0xaa);
  assert.equal(vesica.c[`vesica_shapes_from_records_${scalar}`](kinds.circle, 5n, 4096, -40, address), 0);
  assert.equal(view.getInt32(offsets.kind, true), kinds.circle);
  assert.equal(view.getInt32(offsets.reserved, true), 0);
  assert.equal(view.getBigInt64(offsets.count, true), 5n);
  assert.equal(view.getInt32(offsets.stride, true), -40);
  const step = scalar === 'f64' ? 8 : 4;
  const fields = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => view.getUint32(offsets.field + 4 * k, true));
  assert.deepEqual(fields, [4096, 4096 + step, 4096 + 2 * step, 0, 0, 0, 0, 0]);
  for (const unused of [offsets.rings, offsets.polygons, offsets.each, offsets.each + 4]) {
    assert.equal(view.getUint32(unused, true), 0);
  }
  assert.equal(view.getUint32(72, true), 0xaaaaaaaa);

  // Four gigabytes of shapes are beyond the address space, which has 32 bits here.
  const many = vesica.c[`vesica_overlap_many_${scalar}`];
  vesica.c[`vesica_shapes_from_records_${scalar}`](kinds.circle, 1n << 28n, 4096, 16, address);
  assert.equal(many(address, address, 4096), -4n);
}

// Scalar calls, and errors as exceptions.
assert.equal(vesica.overlap(kinds.rect, unitSquare, kinds.circle, disc), true);
assert.equal(vesica.overlap(kinds.circle, [2 + 2 ** -51, 0, 1], kinds.rect, unitSquare), false);
const invalid = { name: 'VesicaError', code: -2, message: /^a shape is invalid/ };
assert.throws(() => vesica.overlap(kinds.rect, noSquare, kinds.circle, disc), invalid);
const isKindError = (error) => error instanceof VesicaError && error.code === -3;
assert.throws(() => vesica.overlap(8, [], kinds.circle, disc), isKindError);
assert.throws(() => vesica.overlap(kinds.rect, disc, kinds.circle, disc), RangeError);
assert.equal(vesica.c.vesica_overlap_f64(kinds.rect, 0, kinds.circle, 0), -1);

// A batch over views of the module's memory, nothing copied; an invalid shape costs no other its answer.
{
  const squares = vesica.shapes(kinds.rect, 3), probe = vesica.shapes(kinds.circle, 1), out = vesica.answers(3);
  squares.numbers.set([...unitSquare, ...farSquare, ...unitSquare]);
  probe.numbers.set(disc);
  assert.equal(vesica.overlapMany(squares, probe, out), 2);
  assert.deepEqual([...out], [1, 0, 1]);
  squares.numbers.set(noSquare, 0);
  assert.throws(() => vesica.overlapMany(probe, squares, out), invalid);
  assert.deepEqual([...out], [0, 0, 1]);
  assert.equal(vesica.overlapMany(vesica.shapes(kinds.rect, 0), probe, out), 0);
  assert.throws(() => vesica.overlapMany(squares, probe, new Uint8Array(3)), RangeError);
  assert.throws(() => vesica.overlapMany(squares, probe, vesica.answers(2)), RangeError);
  assert.throws(() => vesica.shapes(kinds.rect, 1 << 20), RangeError);
}

// The vectors that every host has to answer; ../../vectors/vectors.txt says what a line is.
function readShape([kind, ...words]) {
  const view = new DataView(new ArrayBuffer(8));
  const numbers = words.map((word) => (view.setBigUint64(0, BigInt('0x' + word)), view.getFloat64(0)));
  return { kind: +kind, numbers: numbers.slice(0, Math.max(vesica.c.vesica_field_count(+kind), 0)) };
}

function readVectors(text) {
  return text.split('\n').flatMap((line, i) => {
    const [what, expected, ...words] = line.split(' ');
    if (!/^(f64|f32|many)$/.test(what)) return [];
    return [{ line: i + 1, what, expected: +expected, a: readShape(words.slice(0, 7)), b: readShape(words.slice(7)) }];
  });
}

function answer({ what, a, b }) {
  try {
    return Number(vesica.overlap(a.kind, a.numbers, b.kind, b.numbers, what));
  } catch (error) {
    return error.code;
  }
}

function answerBatch(vectors) {
  const [a, b] = ['a', 'b'].map((side) => vesica.shapes(vectors[0][side].kind, vectors.length));
  a.numbers.set(vectors.flatMap((vector) => vector.a.numbers));
  b.numbers.set(vectors.flatMap((vector) => vector.b.numbers));
  const out = vesica.answers(vectors.length);
  assert.throws(() => vesica.overlapMany(a, b, out), invalid);
  return out;
}

/** The lines whose answers are not the expected ones. */
function wrongLines(text) {
  const vectors = readVectors(text), batch = vectors.filter(({ what }) => what === 'many');
  const calls = vectors.filter(({ what }) => what !== 'many');
  assert.ok(calls.length > 100 && batch.length > 30);
  const out = answerBatch(batch);
  const wrong = calls.filter((vector) => answer(vector) !== vector.expected);
  wrong.push(...batch.filter(({ expected }, i) => out[i] !== Math.max(expected, 0)));
  return wrong.map(({ line }) => line);
}

{
  const text = readFileSync(vectorsPath, 'utf8');
  assert.deepEqual(wrongLines(text), []);
  // And every kind of answer that is made wrong is found.
  const spoilt = [], seen = new Set();
  const wrong = text.split('\n').map((line, i) => {
    const [what, expected, ...words] = line.split(' '), key = `${what} ${expected}`;
    if (!/^(f64|f32|many) (1|0|-2|-3)$/.test(key) || key === 'many -2' || seen.has(key)) return line;
    seen.add(key);
    spoilt.push(i + 1);
    return [what, expected === '1' ? 0 : 1, ...words].join(' ');
  });
  assert.equal(spoilt.length, 10);
  assert.deepEqual(wrongLines(wrong.join('\n')), spoilt);
}

// A library that is older than its binding: a module whose only export says that it is of version 99.
{
  const text = 'vesica_version', name = [text.length, ...Buffer.from(text)];
  const older = new Uint8Array([
    0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, // magic, version
    1, 5, 1, 0x60, 0, 1, 0x7f, // types: () -> i32
    3, 2, 1, 0, // functions
    7, name.length + 3, 1, ...name, 0, 0, // exports
    10, 7, 1, 5, 0, 0x41, 0xe3, 0, 0x0b, // code: i32.const 99
  ]);
  await assert.rejects(load(older), { message: 'vesica 99 is older than 100' });
}
