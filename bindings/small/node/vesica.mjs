// SPDX-License-Identifier: Apache-2.0
// Vesica for Node, by koffi: copy this file and capi/vesica.cdef beside it. `c` has every function, `constants` every
// constant. Shapes are their numbers in a Float64Array (or Float32Array), which is never copied.
import { readFileSync } from 'node:fs';
import koffi from 'koffi';

/** What this file was written to. */
const version = 100;
export const kinds = { point: 0, segment: 1, circle: 2, aabb: 3, rect: 4, ellipse: 5, capsule: 6, round_rect: 7 };

const library = koffi.load('libvesica.so.0');
const loaded = library.func('int32_t vesica_version()')();
if (loaded < version) throw new Error(`vesica ${loaded} is older than ${version}`);

const cdef = readFileSync(new URL('vesica.cdef', import.meta.url), 'utf8').replace(/\/\*[^]*?\*\//g, '');
export const constants = Object.fromEntries(
  [...cdef.matchAll(/\bVESICA_(\w+) = (-?\d+)/g)].map(([, name, value]) => [name, Number(value)]));
/** The functions as in vesica.h. What a pointer points to is a typed array or a Buffer. */
export const c = Object.fromEntries(
  [...cdef.matchAll(/^[^\n;{}]*?\b(vesica_\w+)\([^;]*\);/gm)].map(([prototype, name]) => {
    // Of structs koffi need not know, of an array as a parameter it wants the pointer that it is.
    const known = prototype.slice(0, -1).replace(/\bvesica_\w+ \*/g, 'void *').replace(/ptrdiff_t/g, 'intptr_t');
    return [name, library.func(known.replace(/\b(double|float) (\w+)\[\d+\]/g, '$1 *$2'))];
  }));
const { vesica_strerror: strerror, vesica_field_count: fieldCount } = c;
const functions = (suffix) => ({
  overlap: c[`vesica_overlap_${suffix}`],
  nearest: c[`vesica_nearest_${suffix}`],
  // A vesica_shapes is filled in and read by the library alone: here, 112 bytes.
  shapes: c[`vesica_shapes_from_records_${suffix}`],
  overlapMany: c[`vesica_overlap_many_${suffix}`],
});
const byArray = new Map([[Float64Array, functions('f64')], [Float32Array, functions('f32')]]);

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

/** How far apart are two shapes, and which of their points are closest? */
export function nearest(kindA, a, kindB, b) {
  const { nearest } = functionsFor(a, b);
  if (a.length < fieldCount(kindA) || b.length < fieldCount(kindB)) throw new RangeError('too few numbers for a shape');
  const out = new a.constructor(5);
  checked(nearest(kindA, a, kindB, b, out));
  const [distance, ax, ay, bx, by] = out;
  return { distance, ax, ay, bx, by };
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
  const bytes = Buffer.alloc(112);
  checked(shapes(kind, count, numbers, fields * numbers.BYTES_PER_ELEMENT, bytes));
  bytes.numbers = numbers; // which the view only points to: so they live as long
  return [count, bytes];
}
