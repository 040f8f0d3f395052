// SPDX-License-Identifier: Apache-2.0
// vectors.mjs FILE: the shared vectors (bindings/vectors) by vesica.mjs. Exit status 0 when all answers are right.
import { readFileSync } from 'node:fs';
import { constants, kinds, nearest, overlap, overlapMany, VesicaError } from './vesica.mjs';

let calls = 0;
const batch = [];

function check(line, answer, expected) {
  if (answer === expected) return;
  console.log(`line ${line}: ${answer}, not ${expected}`);
  process.exitCode = 1;
}

/** What the call returns, or the code of its error. */
function answer(call) {
  try {
    return Number(call());
  } catch (error) {
    if (error instanceof VesicaError) return error.code;
    throw error;
  }
}

const numbers = (words) => words.map((word) => Buffer.from(word, 'hex').readDoubleBE());

readFileSync(process.argv[2], 'utf8').split('\n').forEach((text, index) => {
  if (text === '' || text.startsWith('#')) return;
  const words = text.split(' ');
  const what = words[0], [expected, kindA] = words.slice(1, 3).map(Number), kindB = Number(words[9]);
  const a = numbers(words.slice(3, 9)), b = numbers(words.slice(10));
  if (what === 'many') {
    batch.push({ line: index + 1, expected, a, b });
  } else {
    const Numbers = what === 'f64' ? Float64Array : Float32Array;
    check(index + 1, answer(() => overlap(kindA, new Numbers(a), kindB, new Numbers(b))), expected);
    ++calls;
  }
});

const rects = new Float64Array(batch.flatMap((row) => row.a));
const ellipses = new Float64Array(batch.flatMap((row) => row.b));
const out = new Uint8Array(batch.length);
const many = (end) => overlapMany(kinds.rect, rects.subarray(0, end), kinds.ellipse, ellipses.subarray(0, end), out);
const valid = batch.findIndex((row) => row.expected < 0);
check('count', many(6 * valid), batch.slice(0, valid).filter((row) => row.expected === 1).length);
// With an invalid element, an error: and yet every valid one has its answer.
check('error', answer(many), -2);
batch.forEach((row, i) => check(row.line, out[i], Math.max(row.expected, 0)));
// In float, as the scalar calls are.
const narrow = (numbers) => new Float32Array(numbers.subarray(0, 6 * valid));
const floats = [narrow(rects), narrow(ellipses)];
overlapMany(kinds.rect, floats[0], kinds.ellipse, floats[1], out);
for (let i = 0; i < valid; ++i) {
  const [a, b] = floats.map((numbers) => numbers.subarray(6 * i, 6 * i + 6));
  check(`float ${i}`, out[i], Number(overlap(kinds.rect, a, kinds.ellipse, b)));
}

try {
  overlap(kinds.point, new Float64Array([NaN, 0]), kinds.circle, new Float64Array([0, 0, 1]));
} catch (error) {
  console.log(`NaN: ${error}`);
}
const { distance, ax, ay, bx, by } = nearest(
  constants.AABB, new Float64Array([0, 0, 2, 2]), constants.CIRCLE, new Float64Array([6, 1, 1]));
if (`${[distance, ax, ay, bx, by]}` === '3,2,1,5,1') console.log('nearest: as in C');
console.log(`${calls} calls, ${batch.length} in a batch`);
