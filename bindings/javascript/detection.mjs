// SPDX-License-Identifier: Apache-2.0
// Assignment, fusion, matching and average precision of detections. For Vesica, whose methods these are.
import * as constants from './constants.mjs';
import { labelNumbers, oneEach } from './measures.mjs';
import { allNumbers } from './numbers.mjs';
import { checkRoom, fields, scalars, ShapeArray } from './shapes.mjs';

/** Names of distances of Gaussian distributions, by their numbers. */
export const gaussians = Object.freeze(['bhattacharyya', 'hellinger', 'kullback_leibler', 'wasserstein']);
/** Names of what matchTruths answers, and of what a truth is, by their numbers. */
export const outcomes = Object.freeze(['miss', 'hit', 'ignored']);
export const truthFlags = Object.freeze(['counts', 'crowd', 'ignored']);
const fusedScores = ['mean', 'max'], matchRules = ['voc', 'coco'], precisionRules = ['voc2007', 'voc2010', 'coco'];

export function numberOf(names, name, what) {
  const number = names.indexOf(name);
  if (number < 0) throw new TypeError(`${what} is one of ${names.join(', ')}, not ${String(name)}`);
  return number;
}

/** A copy of a list of numbers. */
function doubles(list, what) {
  if (typeof list?.length !== 'number') throw new TypeError(`${what} are an array of numbers`);
  return Float64Array.from(allNumbers(list, what));
}

function wholes(Numbers, list, what) {
  const numbers = doubles(list, what), wrong = numbers.find((x) => !(Number.isSafeInteger(x) && x >= 0));
  if (wrong !== undefined) throw new TypeError(`${what} are whole numbers from 0 on, not ${wrong}`);
  return Numbers === BigInt64Array ? BigInt64Array.from(numbers, BigInt) : Numbers.from(numbers);
}

/** Pairs as index.joinRatio() gives them. */
function pairsOf(pairs) {
  const values = doubles(pairs?.values, 'values of pairs');
  const [a, b] = ['a', 'b'].map((name) => wholes(BigInt64Array, pairs[name], `${name} of pairs`));
  if (a.length === values.length && b.length === values.length) return { a, b, values };
  throw new RangeError(`pairs have as many a, b and values, not ${a.length}, ${b.length} and ${values.length}`);
}

/** The address of a copy of a typed array. */
function put(vesica, room, array) {
  const address = room.take(array.byteLength);
  new array.constructor(vesica.memory.buffer, address, array.length).set(array);
  return address;
}

/** Scratch of `size` bytes: its address and size, two arguments of a call. */
function scratchOf(vesica, room, size) {
  const bytes = vesica.check(size);
  return [room.take(bytes), BigInt(bytes)];
}

const itemsAt = (vesica, address, count) =>
  Array.from(new BigInt64Array(vesica.memory.buffer, address, count), Number);

export function assignGreedy(vesica, pairs) {
  const { a, b, values } = pairsOf(pairs);
  const end = (items) => items.reduce((most, item) => (item >= most ? item + 1n : most), 0n);
  const counts = [BigInt(values.length), end(a), end(b)];
  return vesica.inRoom((room) => {
    const scratch = scratchOf(vesica, room, vesica.c.vesica_assign_greedy_scratch(...counts));
    const given = [a, b, values].map((array) => put(vesica, room, array)), chosen = room.take(8 * values.length);
    const count = vesica.check(vesica.c.vesica_assign_greedy_f64(...given, ...counts, ...scratch, chosen));
    return itemsAt(vesica, chosen, count);
  });
}

export function fuse(vesica, boxes, scores, threshold = 0.55, { weights, labels, score = 'mean' } = {}) {
  if (!(boxes instanceof ShapeArray)) throw new TypeError('boxes are an array of shapes, as shapes() makes it');
  if (typeof threshold !== 'number') throw new TypeError('a threshold is a number from 0 to 1');
  const { length, kind, scalar } = boxes, Scores = scalars[scalar], which = numberOf(fusedScores, score, 'score');
  if (weights !== undefined) oneEach('weights', weights, boxes);
  oneEach('scores', scores, boxes);
  const given = [scores, weights].map((list, i) =>
    list === undefined ? undefined : Scores.from(checkRoom(doubles(list, i === 0 ? 'scores' : 'weights'), scalar)));
  given.push(labelNumbers(labels, boxes));
  const shapes = boxes.addressIn(vesica.memory, 'the array of boxes'), n = BigInt(length);
  return vesica.inRoom((room) => {
    const scratch = scratchOf(vesica, room, vesica.c.vesica_fuse_scratch(n));
    const places = given.map((array) => (array === undefined ? 0 : put(vesica, room, array)));
    const sizes = [6 * 8 * length, Scores.BYTES_PER_ELEMENT * length, 8 * length, 8];
    const [fused, fusedScoresAt, clusters, count] = sizes.map((size) => room.take(size));
    new BigInt64Array(vesica.memory.buffer, count, 1)[0] = 0n;
    const code = Number(vesica.c[`vesica_fuse_${scalar}`](
      ...[shapes, ...places, threshold, which, ...scratch, fused, fusedScoresAt, clusters, count]));
    if (code < 0 && code !== constants.E_SHAPE) return vesica.check(code);
    const [found] = itemsAt(vesica, count, 1), width = fields[kind].length;
    const numbers = new Scores(vesica.memory.buffer, fused, found * width).slice();
    const result = {
      scores: new Scores(vesica.memory.buffer, fusedScoresAt, found).slice(),
      clusters: itemsAt(vesica, clusters, length),
    };
    return vesica.finish(code, { boxes: vesica.shapes(kind, numbers, { scalar }), ...result });
  });
}

export function matchTruths(vesica, pairs, scores, truths, { thresholds = [0.5], rule = 'coco', flags } = {}) {
  const which = numberOf(matchRules, rule, 'rule'), { a, b, values } = pairsOf(pairs);
  const given = doubles(scores, 'scores'), limits = doubles(thresholds, 'thresholds');
  if (!(Number.isSafeInteger(truths) && truths >= 0)) throw new RangeError(`truths are a count, not ${String(truths)}`);
  const marks = flags === undefined ? undefined : wholes(Uint8Array, flags, 'flags');
  if (marks !== undefined && marks.length !== truths) {
    throw new RangeError(`${truths} truths need as many flags, not ${marks.length}`);
  }
  const counts = [values.length, given.length, truths].map(BigInt), results = given.length * limits.length;
  return vesica.inRoom((room) => {
    const scratch = scratchOf(vesica, room, vesica.c.vesica_match_truths_scratch(...counts));
    const lists = [a, b, values].map((array) => put(vesica, room, array));
    const [scoresAt, limitsAt] = [given, limits].map((array) => put(vesica, room, array));
    const flagsAt = marks === undefined ? 0 : put(vesica, room, marks);
    const outcome = room.take(results), taken = room.take(8 * results);
    vesica.check(vesica.c.vesica_match_truths_f64(
      ...[which, ...lists, counts[0], scoresAt, counts[1], flagsAt, counts[2], limitsAt, BigInt(limits.length)],
      ...[...scratch, outcome, taken],
    ));
    return {
      outcomes: new Uint8Array(vesica.memory.buffer, outcome, results).slice(),
      taken: itemsAt(vesica, taken, results),
    };
  });
}

export function averagePrecision(vesica, scores, given, truths, { rule = 'coco' } = {}) {
  const which = numberOf(precisionRules, rule, 'rule'), values = doubles(scores, 'scores');
  const answers = wholes(Uint8Array, given, 'outcomes'), count = BigInt(values.length);
  if (answers.length !== values.length) {
    throw new RangeError(`${values.length} scores need as many outcomes, not ${answers.length}`);
  }
  if (!(Number.isSafeInteger(truths) && truths >= 0)) throw new RangeError(`truths are a count, not ${String(truths)}`);
  return vesica.inRoom((room) => {
    const scratch = scratchOf(vesica, room, vesica.c.vesica_average_precision_scratch(count));
    const [scoresAt, answersAt] = [values, answers].map((array) => put(vesica, room, array)), out = room.take(8);
    const operands = [scoresAt, answersAt, count, BigInt(truths), ...scratch, out];
    vesica.check(vesica.c.vesica_average_precision_f64(which, ...operands));
    return vesica.memory.doubles[out / 8];
  });
}
