// SPDX-License-Identifier: Apache-2.0
// Shapes: plain objects for one, ShapeArray for many of one kind.
import { allNumbers } from './numbers.mjs';
import { pathNames } from './paths.mjs';

/** The numbers of each kind that has as many in every shape, in the library's order. */
export const fields = Object.freeze({
  point: ['x', 'y'],
  segment: ['x0', 'y0', 'x1', 'y1'],
  circle: ['cx', 'cy', 'r'],
  aabb: ['min_x', 'min_y', 'max_x', 'max_y'],
  rect: ['cx', 'cy', 'ux', 'uy', 'hx', 'hy'],
  ellipse: ['cx', 'cy', 'ux', 'uy', 'a', 'b'],
  capsule: ['x0', 'y0', 'x1', 'y1', 'r'],
  round_rect: ['cx', 'cy', 'ux', 'uy', 'hx', 'hy', 'r'],
});
export const kinds = Object.freeze([...Object.keys(fields), ...pathNames]);
/** sizeof(vesica_shapes_f64) in the module, whose pointers have 4 bytes. */
export const shapesSize = 72;
export const scalars = Object.freeze({ f64: Float64Array, f32: Float32Array });

/** Numbers that are rounded to the scalar type of an array: none may become infinite by that. */
export function checkRoom(numbers, scalar) {
  if (scalar !== 'f32') return numbers;
  const far = [].find.call(numbers, (x) => Number.isFinite(x) && !Number.isFinite(Math.fround(x)));
  if (far !== undefined) throw new RangeError(`${far} is above the greatest float32, and the array is of f32`);
  return numbers;
}

/**
 * Cosine and sine of an angle; in degrees, whole quarter turns are taken out first, which is exact. Eighth turns have
 * equal components, as the library's have.
 */
function axis(angle, degrees) {
  const turned = degrees ? angle % 360 : angle, quarters = degrees ? Math.round(turned / 90) : 0;
  const rest = degrees ? ((turned - 90 * quarters) * Math.PI) / 180 : turned;
  let c = Math.cos(rest), s = Math.sin(rest);
  const eighths = Math.abs(rest) / (Math.PI / 4);
  if (eighths === 1 || eighths === 3) [c, s] = [Math.sign(c) * Math.SQRT1_2, Math.sign(s) * Math.SQRT1_2];
  if (!degrees) return [c, s];
  return [[c, s], [0 - s, c], [0 - c, 0 - s], [s, 0 - c]][((quarters % 4) + 4) % 4] ?? [NaN, NaN];
}

/** The arguments of a constructor by their names, all numbers; `more` are arguments that it has no name for. */
function named(constructor, values, more) {
  for (const name in values) {
    if (typeof values[name] === 'number') continue;
    throw new TypeError(`${constructor}: ${name} is ${String(values[name])}, not a number`);
  }
  if (more.length > 0) throw new TypeError(`${constructor}: too many arguments: ${more.map(String).join(', ')}`);
  return values;
}

export const point = (x, y, ...more) => ({ kind: 'point', ...named('point', { x, y }, more) });
export const segment = (x0, y0, x1, y1, ...more) =>
  ({ kind: 'segment', ...named('segment', { x0, y0, x1, y1 }, more) });
export const circle = (cx, cy, r, ...more) => ({ kind: 'circle', ...named('circle', { cx, cy, r }, more) });
export const capsule = (x0, y0, x1, y1, r, ...more) =>
  ({ kind: 'capsule', ...named('capsule', { x0, y0, x1, y1, r }, more) });
export const roundRect = (cx, cy, ux, uy, hx, hy, r, ...more) =>
  ({ kind: 'round_rect', ...named('roundRect', { cx, cy, ux, uy, hx, hy, r }, more) });
export const aabb = (min_x, min_y, max_x, max_y, ...more) =>
  ({ kind: 'aabb', ...named('aabb', { min_x, min_y, max_x, max_y }, more) });

export function rect(cx, cy, width, height, angle = 0, { degrees = false } = {}, ...more) {
  named('rect', { cx, cy, width, height, angle }, more);
  const [ux, uy] = axis(angle, degrees);
  // An odd multiple of the smallest number cannot be halved; the axis, a unit of length, can.
  const halves = 2 * (width / 2) === width && 2 * (height / 2) === height;
  if (halves) return { kind: 'rect', cx, cy, ux, uy, hx: width / 2, hy: height / 2 };
  return { kind: 'rect', cx, cy, ux: ux / 2, uy: uy / 2, hx: width, hy: height };
}

export function ellipse(cx, cy, a, b, angle = 0, { degrees = false } = {}, ...more) {
  named('ellipse', { cx, cy, a, b, angle }, more);
  const [ux, uy] = axis(angle, degrees);
  return { kind: 'ellipse', cx, cy, ux, uy, a, b };
}

/** The number of a kind's name. */
export function kindNumber(kind) {
  const number = kinds.indexOf(kind);
  if (number < 0) throw new TypeError(`kind is one of ${kinds.join(', ')}, not ${JSON.stringify(kind)}`);
  return number;
}

const isHalvedInFloat = (number) => 2 * Math.fround(number / 2) === number;

/**
 * The numbers of a rectangle that are to be stored as floats. As rect() does in double: where a whole size, rounded to
 * float, cannot be halved, the axis is, unless that cannot be halved either.
 */
function rectInFloat(numbers) {
  const [cx, cy, ux, uy, hx, hy] = numbers, sizes = [Math.fround(2 * hx), Math.fround(2 * hy)];
  if (sizes.every(isHalvedInFloat) || !sizes.every(Number.isFinite)) return numbers;
  const unit = Math.fround(Math.max(Math.abs(ux), Math.abs(uy)));
  return isHalvedInFloat(unit) ? [cx, cy, ux / 2, uy / 2, ...sizes] : numbers;
}

/** The numbers of a shape that is a plain object, for an array of a scalar type. */
export function numbersOf(shape, scalar = 'f64') {
  const names = fields[kinds[kindNumber(shape?.kind)]];
  const numbers = names.map((name) => shape[name]);
  if (numbers.every((number) => typeof number === 'number')) {
    return checkRoom(scalar === 'f32' && shape.kind === 'rect' ? rectInFloat(numbers) : numbers, scalar);
  }
  const missing = names.filter((_, i) => typeof numbers[i] !== 'number');
  throw new TypeError(`a ${shape.kind} has numbers ${names.join(', ')}; missing: ${missing.join(', ')}`);
}

/** A distance, or another number, beside shapes of a scalar type. */
export function distanceFor(distance, scalar, name = 'a distance') {
  if (typeof distance !== 'number') throw new TypeError(`${name} is a number, which may be infinite`);
  checkRoom([distance], scalar);
  return distance;
}

/** All numbers of some shapes, one after the other, from any way to give them, for an array of a scalar type. */
export function flat(kind, source, scalar) {
  const count = fields[kinds[kindNumber(kind)]].length;
  if (typeof source !== 'object' || !Number.isInteger(source?.length)) {
    throw new TypeError('shapes are a count, or an array of numbers, of plain objects or of arrays of numbers');
  }
  if (ArrayBuffer.isView(source) || typeof source[0] === 'number' || source.length === 0) {
    if (source.length % count === 0) return allNumbers(source, `numbers of ${kind} shapes`);
    throw new RangeError(`${kind} shapes have ${count} numbers each; ${source.length} is no multiple of that`);
  }
  return Array.from(source).flatMap((shape) => {
    if (shape?.kind === kind) return numbersOf(shape, scalar);
    if (Array.isArray(shape) && shape.length === count) return allNumbers(shape, `numbers of a ${kind}`);
    const wanted = `${count} numbers (${fields[kind].join(', ')})`;
    throw new TypeError(`a ${kind} is an object of that kind or an array of ${wanted}`);
  });
}

/**
 * Shapes of one kind in the module's memory. `numbers` is a view: what is written there the next call sees. Take it
 * anew after anything that may allocate, as memory that grows detaches older views.
 */
export class ShapeArray {
  #memory;
  #length;
  #free;
  #width; // how many numbers there are
  #ringsOf; // a function: where the rings of polygon i begin among all vertices, with the end

  /** Made by Vesica.shapes(). free: what gives the memory back. width: how many numbers. ringsOf(i): of a path. */
  constructor(memory, kind, scalar, count, address, base, free, width, ringsOf) {
    this.#memory = memory;
    this.#width = width;
    this.#ringsOf = ringsOf;
    this.base = base; // of the numbers
    this.#free = free;
    this.kind = kind;
    this.scalar = scalar;
    this.#length = count;
    this.address = address; // of the vesica_shapes struct
  }

  /** The address of its struct, for a call of the module whose memory is given. */
  addressIn(memory, name = 'an array of shapes') {
    if (this.address === 0) throw new TypeError(`${name} was freed`);
    // In another module's memory the address would be that of something else.
    if (this.#memory !== memory) throw new TypeError(`${name} is of another load()`);
    return this.address;
  }

  get length() {
    return this.#length;
  }

  get numbers() {
    if (this.address === 0) throw new TypeError('an array of shapes was freed');
    return new scalars[this.scalar](this.#memory.buffer, this.base, this.#width);
  }

  /** Shape i as a plain object: a copy. */
  at(i) {
    const all = this.numbers, index = i < 0 ? this.length + i : i;
    const isThere = Number.isInteger(index) && index >= 0 && index < this.length;
    if (!isThere) throw new RangeError(`shape ${i} of ${this.length}`);
    if (this.#ringsOf !== undefined) {
      const ends = this.#ringsOf(index), first = ends[0];
      const vertices = Float64Array.from(all.subarray(2 * first, 2 * ends.at(-1)));
      return { kind: this.kind, vertices, rings: Array.from(ends, (end) => end - first) };
    }
    const names = fields[this.kind];
    const numbers = all.subarray(index * names.length, (index + 1) * names.length);
    return { kind: this.kind, ...Object.fromEntries(names.map((name, k) => [name, numbers[k]])) };
  }

  /** Gives the memory back now, not when it is collected. Whatever uses it afterwards throws a TypeError. */
  free() {
    this.#length = 0;
    this.address = 0;
    this.#free();
  }
}
