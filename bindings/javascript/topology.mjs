// SPDX-License-Identifier: Apache-2.0
// How the parts of two single shapes meet, and soft suppression. For Vesica, whose methods these are.
import * as constants from './constants.mjs';
import { labelNumbers, oneEach, ratioNumber } from './measures.mjs';
import { checkRoom, scalars, ShapeArray } from './shapes.mjs';

/** Names of what `within` answers, by the numbers that arrays have. */
export const withins = Object.freeze(['no', 'yes', 'nearly']);

/** call(operands, room) of two plain objects, in double. */
const ofTwo = (vesica, a, b, call) =>
  vesica.inRoom((room) => call([...vesica.record(a, room), ...vesica.record(b, room)], room));

export function de9im(vesica, a, b) {
  return ofTwo(vesica, a, b, (operands, room) => {
    const out = room.take(10);
    vesica.check(vesica.c.vesica_de9im_f64(...operands, out));
    return String.fromCharCode(...new Uint8Array(vesica.memory.buffer, out, 9));
  });
}

export function de9imMatch(vesica, matrix, pattern) {
  for (const text of [matrix, pattern]) {
    if (typeof text !== 'string') throw new TypeError('a matrix and a pattern are strings of nine characters');
    if (!/^[\x01-\x7f]*$/.test(text)) throw new RangeError('their characters are F, 0, 1, 2, T and *');
  }
  return vesica.inRoom((room) => {
    const places = [matrix, pattern].map((text) => {
      const size = text.length + 1, address = room.take(size);
      const bytes = new Uint8Array(vesica.memory.buffer, address, size);
      bytes.set([...text].map((letter) => letter.charCodeAt(0)));
      bytes[text.length] = 0;
      return address;
    });
    return vesica.check(vesica.c.vesica_de9im_match(...places)) === 1;
  });
}

export function intersection(vesica, a, b) {
  return vesica.inRoom((room) => vesica.pointsOf('intersection', a, b, room));
}

/** Contacts from a struct: eight numbers, then five whole ones. An error in place of the count is null. */
function contactsAt(vesica, scalar, address) {
  const Numbers = scalars[scalar], numbers = new Numbers(vesica.memory.buffer, address, 8);
  const wholes = new BigInt64Array(vesica.memory.buffer, address + numbers.byteLength, 5), [nx, ny] = numbers;
  const count = Number(wholes[4]);
  if (count < 0) return null;
  const contacts = Array.from({ length: count }, (_, i) => {
    const [x, y, depth] = numbers.subarray(2 + 3 * i);
    return { x, y, depth, a: Number(wholes[2 * i]), b: Number(wholes[2 * i + 1]) };
  });
  return { nx, ny, contacts };
}

export function manifold(vesica, a, b) {
  if (!(a instanceof ShapeArray || b instanceof ShapeArray)) {
    return ofTwo(vesica, a, b, (operands, room) => {
      const out = room.take(104);
      vesica.check(vesica.c.vesica_manifold_f64(...operands, out));
      return contactsAt(vesica, 'f64', out);
    });
  }
  return vesica.inRoom((room) => {
    const { scalar, a: first, b: second, counts } = vesica.operands(a, b, room);
    const count = vesica.inStep(counts), size = 8 * scalars[scalar].BYTES_PER_ELEMENT + 40;
    const out = room.take(size * count);
    const code = Number(vesica.c[`vesica_manifold_many_${scalar}`](first, second, out));
    const codes = [constants.E_SHAPE, constants.E_RANGE, constants.E_NOT_CONVEX];
    if (code < 0 && !codes.includes(code)) return vesica.check(code);
    const manifolds = Array.from({ length: count }, (_, i) => contactsAt(vesica, scalar, out + i * size));
    return vesica.finish(code, manifolds, true);
  });
}

const decays = { linear: constants.DECAY_LINEAR, gaussian: constants.DECAY_GAUSSIAN };

export function nmsSoft(vesica, boxes, scores, parameter = 0.5, options = {}) {
  const { decay = 'linear', ratio = 'over_union', leastScore = 0, most = boxes?.length } = options;
  if (!(boxes instanceof ShapeArray)) throw new TypeError('boxes are an array of shapes, as shapes() makes it');
  if (!Object.hasOwn(decays, decay)) throw new TypeError(`decay is one of ${Object.keys(decays).join(', ')}`);
  const n = boxes.length, Scores = scalars[boxes.scalar], which = ratioNumber(ratio);
  const shapes = boxes.addressIn(vesica.memory, 'the array of boxes');
  oneEach('scores', scores, boxes);
  if (![parameter, leastScore].every((x) => typeof x === 'number')) {
    throw new TypeError('parameter and leastScore are numbers');
  }
  checkRoom([parameter, leastScore], boxes.scalar);
  const given = vesica.memory.apart(checkRoom(scores, boxes.scalar)), labels = labelNumbers(options.labels, boxes);
  if (!(Number.isInteger(most) && most >= 0)) throw new RangeError(`most is a whole number, not ${String(most)}`);
  return vesica.inRoom((room) => {
    const size = vesica.check(vesica.c.vesica_suppress_soft_scratch(BigInt(n))), { memory } = vesica;
    const width = n * Scores.BYTES_PER_ELEMENT;
    const sizes = [width, 4 * n, size, 8 * n, width, 8];
    const [at, labelsAt, scratch, keep, left, kept] = sizes.map((bytes) => room.take(bytes));
    new Scores(memory.buffer, at, n).set(given);
    if (labels !== undefined) new Int32Array(memory.buffer, labelsAt, n).set(labels);
    new BigInt64Array(memory.buffer, kept, 1)[0] = 0n;
    const code = vesica.c[`vesica_suppress_soft_${boxes.scalar}`](
      ...[shapes, at, labels === undefined ? 0 : labelsAt, which, decays[decay], parameter, leastScore],
      ...[BigInt(Math.min(most, n)), scratch, BigInt(size), keep, left, kept],
    );
    const count = Number(new BigInt64Array(memory.buffer, kept, 1)[0]);
    return vesica.finish(code, {
      indices: Array.from(new BigInt64Array(memory.buffer, keep, count), Number),
      scores: Array.from(new Scores(memory.buffer, left, count)),
    });
  });
}
