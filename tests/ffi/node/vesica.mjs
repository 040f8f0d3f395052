// SPDX-License-Identifier: Apache-2.0
// Vesica for Node, by koffi. Shapes are their numbers in a Float64Array (or Float32Array), which is never copied.
import koffi from 'koffi';

/** What this file was written to. */
const version = 100;
export const kinds = { point: 0, segment: 1, circle: 2, aabb: 3, rect: 4, ellipse: 5 };

const library = koffi.load('libvesica.so.0');
const loaded = library.func('int32_t vesica_version()')();
if (loaded < version) throw new Error(`vesica ${loaded} is older than ${version}`);

const strerror = library.func('const char *vesica_strerror(int32_t)');
const fieldCount = library.func('int32_t vesica_field_count(int32_t)');
const functions = (suffix, scalar) => ({
  overlap: library.func(`int32_t vesica_overlap_${suffix}(int32_t, const ${scalar} *, int32_t, const ${scalar} *)`),
  // A vesica_shapes is filled in and read by the library alone: here, 72 bytes.
  shapes: library.func(
    `int32_t vesica_shapes_from_records_${suffix}(int32_t, int64_t, const void *, intptr_t, void *)`),
  overlapMany: library.func(`int64_t vesica_overlap_many_${suffix}(const void *, const void *, uint8_t *)`),
});
const byArray = new Map([[Float64Array, functions('f64', 'double')], [Float32Array, functions('f32', 'float')]]);

/** An error of the library: its meaning is the message. */
export class VesicaError extends Error {
  constructor(code) {
    super(strerror(code));
    this.name = 'VesicaError';
    this.code = code;
  }
}

function checked(answer) {
  if (answer < 0) throw new VesicaError(Number(answer));
  return Number(answer);
}

function functionsFor(a, b) {
  const found = byArray.get(a.constructor);
  if (!found || a.constructor !== b.constructor) throw new TypeError('not two Float64Arrays or two Float32Arrays');
  return found;
}

/** Do two shapes share a point? Touching counts. */
export function overlap(kindA, a, kindB, b) {
  const { overlap } = functionsFor(a, b);
  if (a.length < fieldCount(kindA) || b.length < fieldCount(kindB)) throw new RangeError('too few numbers for a shape');
  return checked(overlap(kindA, a, kindB, b)) === 1;
}

/**
 * Two arrays of shapes in step, their numbers one after the other; an array of one shape is repeated. out, a
 * Uint8Array, gets 1 where they overlap, else 0; returns how many do. Where a shape is invalid, out has 0 for it and
 * every other answer, and the error is thrown.
 */
export function overlapMany(kindA, a, kindB, b, out) {
  const { shapes, overlapMany } = functionsFor(a, b);
  const [countA, viewA] = view(shapes, kindA, a);
  const [countB, viewB] = view(shapes, kindB, b);
  if (!(out instanceof Uint8Array)) throw new TypeError('out must be a Uint8Array');
  if (out.length < (countA && countB && Math.max(countA, countB))) throw new RangeError('out is too short');
  return checked(overlapMany(viewA, viewB, out));
}

function view(shapes, kind, numbers) {
  const fields = checked(fieldCount(kind));
  const count = numbers.length / fields;
  if (!Number.isInteger(count)) throw new RangeError(`shapes of kind ${kind} have ${fields} numbers each`);
  const bytes = Buffer.alloc(72);
  checked(shapes(kind, count, numbers, fields * numbers.BYTES_PER_ELEMENT, bytes));
  bytes.numbers = numbers; // which the view only points to: so they live as long
  return [count, bytes];
}
