// SPDX-License-Identifier: Apache-2.0
// The calls that all packages answer alike (tests/ffi/calls.txt), and that wrong answers among them are found. Plain
// objects are double: in float they are arrays of one, and where there are none, functions of the C library.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { constants, fields, kinds, load, relations, VesicaError } from 'vesica';

const vesica = await load();
const lines = readFileSync(new URL('calls.txt', import.meta.url), 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
const queries = ['overlap', 'bounds', 'contains', 'inside'];
const columns = {
  nearest: ['distance', 'ax', 'ay', 'bx', 'by'],
  boundary_distance: ['distance', 'ax', 'ay', 'bx', 'by'],
  depth: ['depth', 'x', 'y'],
};
const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());

/** A hexadecimal float of C's, or whatever JavaScript reads. */
function number(word) {
  if (/nan$/.test(word)) return NaN;
  if (/inf$/.test(word)) return word.startsWith('-') ? -Infinity : Infinity;
  const hex = /^(-?)0x([0-9a-f])\.?([0-9a-f]*)p([-+]\d+)$/.exec(word);
  if (hex === null) return Number(word);
  const [, sign, whole, fraction, exponent] = hex;
  const value = parseInt(whole + fraction, 16) * 2 ** (Number(exponent) - 4 * fraction.length);
  return sign === '-' ? -value : value;
}

const numbersOf = (text) => text.split(' ').filter((word) => word !== '' && !kinds.includes(word)).map(number);
const kindOf = (text) => text.split(' ')[0];
const arrayOf = (scalar) => (text) => vesica.shapes(kindOf(text), numbersOf(text), { scalar });

function plain(text) {
  const numbers = numbersOf(text);
  return { kind: kindOf(text), ...Object.fromEntries(fields[kindOf(text)].map((name, i) => [name, numbers[i]])) };
}

/** An answer's numbers, of one or of arrays, in the order of the library's columns. */
function values(name, answer) {
  const parts = name in columns ? columns[name].map((column) => answer[column]) : [answer];
  return parts.flatMap((part) => (typeof part === 'number' ? [part] : Array.from(part)));
}

/** [result or undefined, values]: a call that gives an array does not tell how many of it hold. */
function ofOneOrTwo(name, scalar, args) {
  if (scalar === 'f32' || name === 'check') return inC(name, scalar, args);
  const shapes = args.map(plain);
  const answer = vesica[camel(name)](...shapes);
  if (name === 'relation') return [relations.indexOf(answer), []];
  if (typeof answer === 'boolean') return [Number(answer), []];
  if (name === 'bounds') return [0, fields.aabb.map((field) => answer[field])];
  if (name === 'crossings') {
    return [answer.places.length, [Number(answer.shared), ...answer.places.flatMap(({ x, y }) => [x, y])]];
  }
  return [0, values(name, answer)];
}

const resultSizes = { overlap: 0, relation: 0, contains: 0, check: 0, nearest: 5, boundary_distance: 5, depth: 3, bounds: 4, area: 1, iou: 1, shape_area: 1 };

/** By the functions of the C library, with memory of this test's own. */
function inC(name, scalar, args) {
  const Numbers = scalar === 'f64' ? Float64Array : Float32Array, width = Numbers.BYTES_PER_ELEMENT;
  return vesica.within((room) => {
    const given = args.flatMap((text) => {
      const numbers = numbersOf(text), address = room.take(numbers.length * width);
      new Numbers(vesica.c.memory.buffer, address, numbers.length).set(numbers);
      return [kinds.indexOf(kindOf(text)), address];
    });
    const size = resultSizes[name], out = room.take(8 + 16 * 8);
    const code = vesica.c[`vesica_${name}_${scalar}`](...given, ...(size === 0 ? [] : [out]));
    vesica.check(code);
    if (name !== 'crossings') return [code, Array.from(new Numbers(vesica.c.memory.buffer, out, size))];
    const shared = new Int32Array(vesica.c.memory.buffer, out, 2)[1], places = new Numbers(vesica.c.memory.buffer, out + 8, 16);
    return [code, [shared, ...Array.from({ length: code }, (_, i) => [places[i], places[8 + i]]).flat()]];
  });
}

function constructed(name, scalar, [text]) {
  const Numbers = scalar === 'f64' ? Float64Array : Float32Array;
  return vesica.within((room) => {
    let given = numbersOf(text);
    const size = name.startsWith('aabb') ? 4 : 6, out = room.take(8 * size), corners = room.take(64);
    if (name === 'rect_from_corners') {
      new Numbers(vesica.c.memory.buffer, corners, 8).set(given);
      given = [corners];
    }
    const code = vesica.check(vesica.c[`vesica_${name}_${scalar}`](...given, out));
    return [code, Array.from(new Numbers(vesica.c.memory.buffer, out, size))];
  });
}

function ofIndexes(name, scalar, args) {
  const leading = { index_nearest: 2, index_select: 1, join: 1, join_nearest: 1 }[name] ?? 0;
  const rest = args.slice(leading), slash = rest.includes('/') ? rest.indexOf('/') : rest.length;
  const setsA = rest.slice(0, slash).map(arrayOf(scalar)), setsB = rest.slice(slash + 1).map(arrayOf(scalar));
  const a = vesica.indexFromBytes(vesica.index(...setsA).bytes, ...setsA);
  const b = setsB.length > 0 ? vesica.index(...setsB) : a;
  if (name === 'index_select') {
    const found = a.select(plain(args[0]));
    return [found.length, found];
  }
  if (name === 'index_nearest') {
    const [k, within] = numbersOf(args[1]);
    const { items, distances } = a.nearest(plain(args[0]), { k, within });
    return [items.length, [...items, ...distances]];
  }
  if (name === 'join') {
    const how = { with: b, query: queries[Number(args[0])] };
    const pairs = a.join(how);
    return [a.joinCount(how), pairs.a.flatMap((item, i) => [item, pairs.b[i]])];
  }
  if (name === 'index_bounds') {
    const box = a.bounds();
    return [0, fields.aabb.map((field) => box[field])];
  }
  if (name === 'index_order') {
    const items = a.order();
    return [items.length, items];
  }
  const [k, within] = numbersOf(args[0]);
  const { items, distances } = b.nearestOfEach(setsA, { k, within });
  return [items.filter((item) => item >= 0).length, [...items, ...distances]];
}

function answer(name, scalar, args) {
  if (name.includes('_from_')) return constructed(name, scalar, args);
  if (name.startsWith('index_') || name.startsWith('join')) return ofIndexes(name, scalar, args);
  if (name === 'nms') {
    return [0, vesica.nms(arrayOf(scalar)(args[0]), numbersOf(args[1]), numbersOf(args[2])[0])];
  }
  if (name === 'overlap_select') {
    const found = vesica.overlapSelect(plain(args[0]), arrayOf(scalar)(args[1]));
    return [found.length, found];
  }
  const [, question, form] = /^(\w+?)_?(many|matrix)?$/.exec(name);
  if (form === undefined) return ofOneOrTwo(name, scalar, args);
  const call = camel(form === 'many' ? question : name);
  return [undefined, values(question, vesica[call](...args.map(arrayOf(scalar))))];
}

const same = (given, words) => given.length === words.length && given.every((value, i) => Object.is(value, number(words[i])));

function isRight(line) {
  const [left, right] = line.split(' = ');
  const [head, ...args] = left.split(' | ');
  const [name, scalar] = head.split(' ');
  const [expected, ...words] = right.split(' ');
  try {
    const given = answer(name, scalar, args);
    return (given[0] === undefined || String(given[0]) === expected) && same(given[1], words);
  } catch (error) {
    if (!(error instanceof VesicaError)) throw error;
    const question = name.replace(/_many$/, '');
    const { items, distances } = error.result ?? {};
    const written = items ? [...items, ...distances] : typeof error.result === 'object' ? values(question, error.result) : [];
    return error.code === constants[expected] && (words.length === 0 || same(written, words));
  }
}

test('every call is right', () => {
  assert.ok(lines.length > 400);
  assert.deepEqual(lines.filter((line) => !isRight(line)), []);
});

test('wrong answers are found', () => {
  const first = new Map(lines.map((line) => [line.split(' ')[0], line]).reverse());
  for (const line of first.values()) {
    const spoilt = `${line.slice(0, line.lastIndexOf(' '))} 7.5`;
    assert.ok(!isRight(spoilt), spoilt);
  }
});
