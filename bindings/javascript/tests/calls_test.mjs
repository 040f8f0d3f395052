// SPDX-License-Identifier: Apache-2.0
// The calls that all packages answer alike (bindings/calls/calls.txt), and that wrong answers among them are found. Plain
// objects are double: in float they are arrays of one, and where there are none, functions of the C library.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { casts, constants, fields, kinds, load, ratios, relations, VesicaError, withins } from 'vesica';

const vesica = await load();
const text = readFileSync(new URL('calls.txt', import.meta.url), 'utf8');
const lines = text.split('\n').filter((line) => line && !line.startsWith('#'));
const queries = ['overlap', 'bounds', 'contains', 'inside', 'interiors'];
const columns = {
  nearest: ['distance', 'ax', 'ay', 'bx', 'by'],
  boundary_distance: ['distance', 'ax', 'ay', 'bx', 'by'],
  depth: ['depth', 'x', 'y'],
  cast: ['t', 'x', 'y', 'nx', 'ny'],
  cast_many: ['t', 'x', 'y', 'nx', 'ny'],
  impact_time: ['t', 'x', 'y', 'nx', 'ny', 'gap'],
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

const resultSizes = {
  ...{ overlap: 0, interiors_overlap: 0, relation: 0, contains: 0, check: 0, nearest: 5, boundary_distance: 5, depth: 3 },
  ...{ bounds: 4, area: 1, signed_distance: 1, iou: 1, ratio: 1, shape_area: 1, cast: 5, sweep_bounds: 4 },
  impact_time: 6,
};

/** By the functions of the C library, with memory of this test's own. */
function inC(name, scalar, args) {
  const Numbers = scalar === 'f64' ? Float64Array : Float32Array, width = Numbers.BYTES_PER_ELEMENT;
  return vesica.inRoom((room) => {
    const given = args.flatMap((text) => {
      const numbers = numbersOf(text), address = room.take(numbers.length * width);
      const isShape = kinds.includes(kindOf(text)), isTurn = !isShape && numbers.length === 3 && name === 'impact_time';
      if (!isShape && !isTurn) return numbers;
      new Numbers(vesica.c.memory.buffer, address, numbers.length).set(numbers);
      return isTurn ? [address] : [kinds.indexOf(kindOf(text)), address];
    });
    const size = resultSizes[name], out = room.take(8 + 16 * 8), gap = out + 5 * width, shared = out + 16 * 8;
    const results = size === 0 ? [] : name === 'impact_time' ? [out, gap] : [out];
    if (name === 'crossings') results.push(8n, shared);
    const code = Number(vesica.c[`vesica_${name}_${scalar}`](...given, ...results));
    vesica.check(code);
    if (name !== 'crossings') return [code, Array.from(new Numbers(vesica.c.memory.buffer, out, size))];
    const stretch = new Int32Array(vesica.c.memory.buffer, shared, 1)[0];
    return [code, [stretch, ...new Numbers(vesica.c.memory.buffer, out, 2 * code)]];
  });
}

function misfit(scalar, args) {
  const Numbers = scalar === 'f64' ? Float64Array : Float32Array;
  return vesica.inRoom((room) => {
    const given = args.map(numbersOf), [corners, rect, out] = [64, 48, 8].map((size) => room.take(size));
    new Numbers(vesica.c.memory.buffer, corners, 8).set(given[0]);
    new Numbers(vesica.c.memory.buffer, rect, 6).set(given[1]);
    const code = vesica.check(vesica.c[`vesica_rect_corners_misfit_${scalar}`](corners, rect, out));
    return [code, Array.from(new Numbers(vesica.c.memory.buffer, out, 1))];
  });
}

function constructed(name, scalar, [text]) {
  const Numbers = scalar === 'f64' ? Float64Array : Float32Array;
  return vesica.inRoom((room) => {
    let given = numbersOf(text);
    const size = fields[name.slice(0, name.indexOf('_from_'))].length;
    const out = room.take(8 * size), corners = room.take(64);
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

const impact = ['t', 'x', 'y', 'nx', 'ny'];
const impactOf = (found) => impact.map((field) => found[field]);
const firstOf = (found, none) =>
  found === null ? [none, [Infinity, NaN, NaN, NaN, NaN]] : [found.item, impactOf(found)];

function ofMotion(name, scalar, args) {
  if (name === 'cast_many') {
    const [vx, vy] = [numbersOf(args[2]), numbersOf(args[3])], velocity = vx.length === 1 ? [vx[0], vy[0]] : [vx, vy];
    const found = vesica.cast(...args.slice(0, 2).map(arrayOf(scalar)), velocity, { tEnd: numbersOf(args[4])[0] });
    return [undefined, values(name, found)];
  }
  const of = { cast: 2, cast_first: 2 }[name] ?? 1, [vx, vy, tEnd] = numbersOf(args[of]);
  if (name === 'cast_first') {
    const many = arrayOf(scalar)(args[1]);
    return firstOf(vesica.castFirst(plain(args[0]), many, [vx, vy], { tEnd }), many.length);
  }
  if (name.startsWith('index_')) {
    const index = vesica.index(...args.slice(2).map(arrayOf(scalar)));
    if (name === 'index_cast_first') return firstOf(index.castFirst(plain(args[0]), [vx, vy], { tEnd }), index.length);
    const items = index.cast(plain(args[0]), [vx, vy], { tEnd });
    return [items.length, items];
  }
  if (scalar === 'f32') return inC(name, scalar, args);
  if (name === 'impact_time') {
    const [turnA, turnB, [tolerance]] = [args[1], args[3], args[4]].map(numbersOf);
    const found = vesica.impactTime(plain(args[0]), turnA, plain(args[2]), turnB, tolerance);
    return [casts.indexOf(found.outcome), values(name, found)];
  }
  if (name === 'sweep_bounds') {
    const box = vesica.sweepBounds(plain(args[0]), [vx, vy], tEnd);
    return [0, fields.aabb.map((field) => box[field])];
  }
  const found = vesica.cast(plain(args[0]), plain(args[1]), [vx, vy], { tEnd });
  return [casts.indexOf(found.outcome), impactOf(found)];
}

function ofBoxes(name, scalar, args) {
  const shapes = name.includes('_from_boxes') ? undefined : arrayOf(scalar)(args[0]);
  if (name === 'corners_of_shapes') return [0, Array.from(vesica.corners(shapes))];
  if (name === 'bounds_many') return [0, Array.from(vesica.boundsMany(shapes))];
  const [unit] = numbersOf(args[1]);
  const how = { scalar, degrees: (unit & 3) === 1, quarters: (unit & 3) === 2, reverse: unit >= 4 };
  if (shapes !== undefined) return [0, Array.from(vesica.boxes(shapes, how))];
  return [0, valuesOf(name, vesica.shapesFromBoxes(name.slice(0, name.indexOf('s_')), numbersOf(args[0]), how))];
}

function ofRatios(name, scalar, args) {
  const which = ratios[Number(args[0])], shapes = args.slice(1);
  if (name === 'ratio') {
    return scalar === 'f32' ? inC(name, scalar, args) : [0, [vesica.ratio(which, ...shapes.map(plain))]];
  }
  const call = name === 'ratio_many' ? 'ratio' : 'ratioMatrix';
  return [undefined, Array.from(vesica[call](which, ...shapes.map(arrayOf(scalar))))];
}

function ofTopology(name, scalar, args) {
  if (name === 'de9im_match') return [Number(vesica.de9imMatch(args[0], args[1])), []];
  if (name.startsWith('within_')) {
    const call = name === 'within_many' ? 'within' : 'withinMatrix', shapes = args.slice(0, 2).map(arrayOf(scalar));
    return [undefined, Array.from(vesica[call](...shapes, numbersOf(args[2])[0]))];
  }
  if (name === 'join_within') {
    const slash = args.indexOf('/');
    const [a, b] = [args.slice(1, slash), args.slice(slash + 1)].map((sets) => sets.map(arrayOf(scalar)));
    const index = vesica.index(...a), how = b.length > 0 ? { with: vesica.index(...b) } : {};
    const pairs = index.joinWithin(numbersOf(args[0])[0], how);
    return [pairs.a.length, pairs.a.flatMap((item, i) => [item, pairs.b[i]])];
  }
  if (name === 'suppress_soft') {
    const [which, decay, parameter, leastScore, most] = numbersOf(args[2]);
    const how = { ratio: ratios[which], decay: ['linear', 'gaussian'][decay], leastScore, most };
    if (args.length > 3) how.labels = numbersOf(args[3]);
    const { indices, scores } = vesica.nmsSoft(arrayOf(scalar)(args[0]), numbersOf(args[1]), parameter, how);
    return [0, [...indices, ...scores]];
  }
  if (scalar === 'f32') return topologyInC(name, args);
  const shapes = args.slice(0, 2).map(plain);
  if (name === 'within') return [withins.indexOf(vesica.within(...shapes, numbersOf(args[2])[0])), []];
  if (name === 'de9im') return [0, [...vesica.de9im(...shapes)].map((c) => (c === 'F' ? -1 : Number(c)))];
  const vertices = vesica.intersection(...shapes);
  return [vertices.length, vertices.flatMap(({ x, y }) => [x, y])];
}

/** In float: what plain objects, which are double, do not ask. */
function topologyInC(name, args) {
  return vesica.inRoom((room) => {
    const out = room.take(64), { memory } = vesica.c;
    const operands = args.slice(0, 2).flatMap((text) => {
      const numbers = numbersOf(text), address = room.take(4 * numbers.length);
      new Float32Array(memory.buffer, address, numbers.length).set(numbers);
      return [kinds.indexOf(kindOf(text)), address];
    });
    const last = name === 'within' ? numbersOf(args[2]) : name === 'intersection' ? [out, 8n] : [out];
    const code = vesica.check(Number(vesica.c[`vesica_${name}_f32`](...operands, ...last)));
    if (name === 'within') return [code, []];
    if (name === 'intersection') return [code, Array.from(new Float32Array(memory.buffer, out, 2 * code))];
    const letters = Array.from(new Uint8Array(memory.buffer, out, 9));
    return [code, letters.map((letter) => (letter === 70 ? -1 : letter - 48))];
  });
}

function suppressed(scalar, [boxes, scores, how, labels]) {
  const [which, threshold, leastScore, most] = numbersOf(how);
  const options = { ratio: ratios[which], leastScore, most, labels: labels && numbersOf(labels) };
  return [0, vesica.nms(arrayOf(scalar)(boxes), numbersOf(scores), threshold, options)];
}

/** The numbers of a whole result, of any kind. */
function valuesOf(question, result) {
  if (result.indices) return [...result.indices, ...result.scores];
  if (result.items) return [...result.items, ...result.distances];
  return Array.from(result.numbers ?? values(question, result));
}

function answer(name, scalar, args) {
  if (/_boxes|^boxes_|corners_of|bounds_many/.test(name)) return ofBoxes(name, scalar, args);
  if (/cast|^sweep_bounds$|^impact_time$/.test(name)) return ofMotion(name, scalar, args);
  if (name.startsWith('ratio')) return ofRatios(name, scalar, args);
  if (/^within|^de9im|^intersection$|^join_within$|_soft$/.test(name)) return ofTopology(name, scalar, args);
  if (name === 'suppress') return suppressed(scalar, args);
  if (name.includes('_from_')) return constructed(name, scalar, args);
  if (name === 'rect_corners_misfit') return misfit(scalar, args);
  if (name.startsWith('index_') || name.startsWith('join')) return ofIndexes(name, scalar, args);
  if (name === 'nms') {
    return [0, vesica.nms(arrayOf(scalar)(args[0]), numbersOf(args[1]), numbersOf(args[2])[0])];
  }
  if (name.endsWith('overlap_select')) {
    const found = vesica[camel(name)](plain(args[0]), arrayOf(scalar)(args[1]));
    return [found.length, found];
  }
  const [, question, form] = /^(\w+?)_?(many|matrix)?$/.exec(name);
  if (form === undefined) return ofOneOrTwo(name, scalar, args);
  const call = camel(form === 'many' ? question : name);
  return [undefined, values(form === 'many' ? question : name, vesica[call](...args.map(arrayOf(scalar))))];
}

const same = (given, words) =>
  given.length === words.length && given.every((value, i) => Object.is(value, number(words[i])));

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
    const written = error.result === undefined ? [] : valuesOf(name.replace(/_many$/, ''), error.result);
    return error.code === constants[expected] && (words.length === 0 || same(written, words));
  }
}

test('every call is right', () => {
  assert.ok(lines.length > 700);
  assert.deepEqual(lines.filter((line) => !isRight(line)), []);
});

test('wrong answers are found', () => {
  const first = new Map(lines.map((line) => [line.split(' ')[0], line]).reverse());
  assert.ok(first.size >= 70);
  for (const line of first.values()) {
    const spoilt = `${line.slice(0, line.lastIndexOf(' '))} 7.5`;
    assert.ok(!isRight(spoilt), spoilt);
  }
});
