// SPDX-License-Identifier: Apache-2.0
// All of the package but its WebAssembly modules, which vesica.mjs and overlap.mjs load.
import * as constants from './constants.mjs';
import * as detection from './detection.mjs';
import { Index } from './index.mjs';
import * as measures from './measures.mjs';
import { bytesOf, Memory, Room } from './memory.mjs';
import * as motion from './motion.mjs';
import { isPath, partsOf, partsOfMany, polygon, polyline, ringsIn, writePath, writePaths } from './paths.mjs';
import { checkRoom, distanceFor, fields, flat, kindNumber, kinds, numbersOf, scalars } from './shapes.mjs';
import { aabb, capsule, circle, ellipse, point, rect, roundRect, segment, ShapeArray, shapesSize } from './shapes.mjs';
import * as topology from './topology.mjs';

const { casts } = motion, { ratios } = measures, { withins } = topology;
const { gaussians, outcomes, truthFlags } = detection;
export { aabb, capsule, circle, ellipse, point, polygon, polyline, rect, roundRect, segment };
export { casts, constants, fields, gaussians, Index, kinds, outcomes, ratios, ShapeArray, truthFlags, withins };

/** Names of relations, by the numbers that arrays have. */
export const relations = Object.freeze([
  'disjoint', 'touch', 'cross', 'inside', 'inside_touch', 'contains', 'contains_touch', 'equal',
]);

/** What the library refuses. `code` is its VESICA_E_... number; `result` has the answers of valid shapes in arrays. */
export class VesicaError extends Error {
  constructor(message, code, result) {
    super(message);
    this.name = 'VesicaError';
    this.code = code;
    this.result = result;
  }
}

const isArray = (shapes) => shapes instanceof ShapeArray;

/** The struct of an array is before its numbers, which begin where a block does. */
const structSize = 80;

/** Questions that have no answer for some valid shapes, and the codes that say so; the number there is NaN. */
const unanswered = {
  iou: [constants.E_ARGUMENT],
  ratio: [constants.E_ARGUMENT],
  gaussian_distance: [constants.E_ARGUMENT, constants.E_RANGE],
};

/** Whether numbers of arrays are there. Counts agree, so an argument is wrong only where there is no answer. */
const isWritten = (name, code) =>
  code >= 0 || code === constants.E_SHAPE || (unanswered[name]?.includes(code) ?? false);

export class Vesica {
  #memory;
  #collected;
  #doubles = {}; // functions about single shapes, by the names of their questions

  constructor(exports) {
    this.c = exports;
    this.#memory = new Memory(exports.memory);
    this.#collected = new FinalizationRegistry((blocks) => this.#give(blocks));
  }

  get isa() {
    return this.#string(this.c.vesica_isa_name());
  }

  get version() {
    return [this.c.vesica_version_major(), this.c.vesica_version_minor(), this.c.vesica_version_patch()].join('.');
  }

  // ---- Shapes ----

  shapes(kind, source, { scalar = 'f64', ...offsets } = {}) {
    const isScalar = scalar === 'f64' || scalar === 'f32';
    if (!isScalar) throw new TypeError(`scalar is 'f64' or 'f32', not ${JSON.stringify(scalar)}`);
    if (isPath({ kind })) return this.#paths(kind, source, scalar, offsets);
    const numbers = typeof source === 'number' ? null : this.#memory.apart(flat(kind, source, scalar));
    const width = fields[kinds[kindNumber(kind)]].length;
    const count = numbers === null ? source : numbers.length / width;
    if (!(Number.isInteger(count) && count >= 0)) throw new RangeError(`a count is a whole number, not ${source}`);
    const stride = width * scalars[scalar].BYTES_PER_ELEMENT;
    const size = structSize + count * stride, address = this.#memory.take(size), base = address + structSize;
    const blocks = [[address, size]];
    this.check(this.c[`vesica_shapes_from_records_${scalar}`](kindNumber(kind), BigInt(count), base, stride, address));
    const free = () => this.release(made, blocks);
    const made = new ShapeArray(this.#memory, kind, scalar, count, address, base, free, count * width);
    this.own(made, blocks);
    if (numbers === null) made.numbers.fill(0); // memory that was given back has what was there
    else made.numbers.set(numbers);
    return made;
  }

  /** Polygons or polylines: their struct, vertices and offsets in one block. */
  #paths(kind, source, scalar, offsets) {
    const parts = partsOfMany(kind, this.#memory.apart(source), offsets), { count, each, isPlain } = parts;
    const vertices = isPlain ? checkRoom(parts.vertices, scalar) : this.#memory.apart(parts.vertices);
    const Numbers = scalars[scalar], width = Numbers.BYTES_PER_ELEMENT, { rings = [], polygons = [] } = parts;
    const at = structSize + vertices.length * width, size = at + 4 * (rings.length + polygons.length);
    const address = this.#memory.take(size), base = address + structSize, ends = address + at;
    const blocks = [[address, size]], free = () => this.release(made, blocks);
    new Numbers(this.#memory.buffer, base, vertices.length).set(vertices);
    new Int32Array(this.#memory.buffer, ends, rings.length).set(rings);
    new Int32Array(this.#memory.buffer, ends + 4 * rings.length, polygons.length).set(polygons);
    const places = { rings: rings.length && ends, polygons: polygons.length && ends + 4 * rings.length };
    writePaths(this.#memory, address, width, { kind: kindNumber(kind), count, vertices: base, each, ...places });
    const length = vertices.length, ringsOf = ringsIn(parts);
    const made = new ShapeArray(this.#memory, kind, scalar, count, address, base, free, length, ringsOf);
    this.own(made, blocks);
    return made;
  }

  polygons(source, options) {
    return this.shapes('polygon', source, options);
  }
  polylines(source, options) {
    return this.shapes('polyline', source, options);
  }

  shapesFromBoxes(kind, boxes, options) {
    return measures.shapesFromBoxes(this, kind, boxes, options);
  }
  boxes(shapes, options) {
    return measures.boxes(this, shapes, options);
  }
  corners(shapes) {
    return measures.corners(this, shapes);
  }
  boundsMany(shapes) {
    return measures.boundsMany(this, shapes);
  }

  // ---- Questions ----

  overlap(a, b, options) {
    return this.#codes('overlap', a, b, options, (code) => code === 1);
  }
  interiorsOverlap(a, b, options) {
    return this.#codes('interiors_overlap', a, b, options, (code) => code === 1);
  }
  relation(a, b, options) {
    return this.#codes('relation', a, b, options, (code) => relations[code]);
  }
  contains(a, b, options) {
    return this.#codes('contains', a, b, options, (code) => code === 1);
  }
  nearest(a, b) {
    return this.#numbers('nearest', ['distance', 'ax', 'ay', 'bx', 'by'], a, b);
  }
  boundaryDistance(a, b) {
    return this.#numbers('boundary_distance', ['distance', 'ax', 'ay', 'bx', 'by'], a, b);
  }
  depth(a, b) {
    return this.#numbers('depth', ['depth', 'x', 'y'], a, b);
  }
  area(a, b) {
    return this.#numbers('area', ['area'], a, b);
  }
  iou(a, b) {
    return this.#numbers('iou', ['iou'], a, b);
  }
  within(a, b, distance, options) {
    const far = distanceFor(distance, [a, b].find(isArray)?.scalar);
    return this.#codes('within', a, b, options, (code) => topology.withins[code], far);
  }
  withinMatrix(a, b, distance) {
    return this.#matrix('within', Uint8Array, a, b, [], [distanceFor(distance, a?.scalar)]);
  }
  signedDistance(a, b) {
    return this.#numbers('signed_distance', ['distance'], a, b);
  }
  signedDistanceMatrix(a, b) {
    return this.#matrix('signed_distance', scalars[a?.scalar], a, b);
  }
  de9im(a, b) {
    return topology.de9im(this, a, b);
  }
  de9imMatch(matrix, pattern) {
    return topology.de9imMatch(this, matrix, pattern);
  }
  intersection(a, b) {
    return topology.intersection(this, a, b);
  }
  nmsSoft(boxes, scores, parameter, options) {
    return topology.nmsSoft(this, boxes, scores, parameter, options);
  }
  fuse(boxes, scores, threshold, options) {
    return detection.fuse(this, boxes, scores, threshold, options);
  }
  assignGreedy(pairs) {
    return detection.assignGreedy(this, pairs);
  }
  matchTruths(pairs, scores, truths, options) {
    return detection.matchTruths(this, pairs, scores, truths, options);
  }
  averagePrecision(scores, given, truths, options) {
    return detection.averagePrecision(this, scores, given, truths, options);
  }
  manifold(a, b) {
    return topology.manifold(this, a, b);
  }
  convexHull(points) {
    return measures.convexHull(this, points);
  }
  minAreaRect(points) {
    return measures.rectAbout(this, 'min_area_rect', points);
  }
  minPerimeterRect(points) {
    return measures.rectAbout(this, 'min_perimeter_rect', points);
  }
  coverage(shape, grid) {
    return measures.coverage(this, shape, grid);
  }
  coverageCells(shape, grid) {
    return measures.coverageCells(this, shape, grid);
  }
  ratio(which, a, b) {
    return this.#numbers('ratio', ['ratio'], a, b, measures.ratioNumber(which));
  }
  overlapMatrix(a, b) {
    return this.#matrix('overlap', Uint8Array, a, b);
  }
  interiorsOverlapMatrix(a, b) {
    return this.#matrix('interiors_overlap', Uint8Array, a, b);
  }
  relationMatrix(a, b) {
    return this.#matrix('relation', Uint8Array, a, b);
  }
  containsMatrix(a, b) {
    return this.#matrix('contains', Uint8Array, a, b);
  }
  areaMatrix(a, b) {
    return this.#matrix('area', scalars[a?.scalar], a, b);
  }
  iouMatrix(a, b) {
    return this.#matrix('iou', scalars[a?.scalar], a, b);
  }

  ratioMatrix(which, a, b) {
    return this.#matrix('ratio', scalars[a?.scalar], a, b, [measures.ratioNumber(which)]);
  }
  gaussianDistance(which, a, b) {
    const number = detection.numberOf(gaussians, which, 'a distance');
    return this.#numbers('gaussian_distance', ['distance'], a, b, number);
  }
  gaussianDistanceMatrix(which, a, b) {
    const number = detection.numberOf(gaussians, which, 'a distance');
    return this.#matrix('gaussian_distance', scalars[a?.scalar], a, b, [number]);
  }
  nearestMatrix(a, b) {
    return this.#matrix('nearest', scalars[a?.scalar], a, b);
  }
  boundaryDistanceMatrix(a, b) {
    return this.#matrix('boundary_distance', scalars[a?.scalar], a, b);
  }
  depthMatrix(a, b) {
    return this.#matrix('depth', scalars[a?.scalar], a, b);
  }

  cast(a, b, velocity, options) {
    return motion.cast(this, a, b, velocity, options);
  }
  castFirst(one, many, velocity, options) {
    return motion.castFirst(this, one, many, velocity, options);
  }
  impactTime(a, turnA, b, turnB, tolerance) {
    return motion.impactTime(this, a, turnA, b, turnB, tolerance);
  }
  sweepBounds(shape, velocity, tEnd) {
    return motion.sweepBounds(this, shape, velocity, tEnd);
  }

  overlapSelect(one, many) {
    return this.#selected('overlap', one, many);
  }
  interiorsOverlapSelect(one, many) {
    return this.#selected('interiors_overlap', one, many);
  }
  #selected(name, one, many) {
    return this.inRoom((room) => {
      const { scalar, a, b } = this.operands(one, many, room);
      if (!isArray(many)) throw new TypeError('many is an array of shapes, as shapes() makes it');
      const out = room.take(8 * many.length + 8);
      const code = Number(this.c[`vesica_${name}_select_${scalar}`](a, b, out, BigInt(many.length)));
      const indices = Array.from(new BigInt64Array(this.#memory.buffer, out, many.length), Number);
      // With an invalid shape, which is never selected, -1 follows the others.
      return this.#answer(code, indices.slice(0, code < 0 ? indices.indexOf(-1) : code));
    });
  }

  crossings(a, b) {
    return this.inRoom((room) => {
      const shared = room.take(8);
      const places = this.pointsOf('crossings', a, b, room, shared);
      return { places, shared: new Int32Array(this.#memory.buffer, shared, 1)[0] === 1 };
    });
  }

  shapeArea(shape) {
    return this.#ofOne('shape_area', 1, shape)[0];
  }

  bounds(shape) {
    return aabb(...this.#ofOne('bounds', 4, shape));
  }

  /** Why a shape is invalid, or null. */
  invalidity(shape) {
    return this.inRoom((room) => {
      const [kind, address] = this.record(shape, room);
      const code = this.c.vesica_check_f64(kind, address);
      return code < 0 ? this.#text(code) : null;
    });
  }

  nms(boxes, scores, threshold, options) {
    return measures.nms(this, boxes, scores, threshold, options);
  }

  index(...sets) {
    return new Index(this, sets);
  }

  indexFromBytes(bytes, ...sets) {
    return new Index(this, sets, this.#memory.apart(bytesOf(bytes)));
  }

  // ---- For this module and its index: memory and errors ----

  get memory() {
    return this.#memory;
  }

  /** Gives blocks of memory back when an object is collected, or by release(). */
  own(object, blocks) {
    this.#collected.register(object, blocks, object);
  }
  release(object, blocks) {
    if (this.#collected.unregister(object)) this.#give(blocks);
  }

  /** call(room), whose memory is given back afterwards. */
  inRoom(call) {
    const room = new Room(this.#memory);
    try {
      return call(room);
    } finally {
      room.end();
    }
  }

  /** The answer, if it is one. */
  check(code) {
    return this.#answer(Number(code), Number(code), false);
  }

  /** A result, unless its code is an error, which has the result if it was written. */
  finish(code, result, written) {
    return this.#answer(code, result, written);
  }

  #answer(code, result, written = code === constants.E_SHAPE) {
    if (code >= 0) return result;
    throw new VesicaError(this.#text(code), code, written ? result : undefined);
  }

  #text(code) {
    return this.#string(this.c.vesica_strerror(code));
  }

  #string(address) {
    const bytes = new Uint8Array(this.#memory.buffer, address);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }

  #give(blocks) {
    for (const [address, size] of blocks) this.#memory.give(address, size);
  }

  /** [kind, address of its struct] of a plain object. */
  record(shape, room) {
    if (isPath(shape)) return [kindNumber(shape.kind), this.#path(shape, 'f64', room)];
    const numbers = numbersOf(shape), address = room.take(8 * numbers.length), { doubles } = this.#memory;
    for (let i = 0; i < numbers.length; ++i) doubles[address / 8 + i] = numbers[i];
    return [kindNumber(shape.kind), address];
  }

  /** Two operands of a batch, one of which may be a plain object. */
  operands(a, b, room) {
    const scalar = [a, b].find(isArray)?.scalar ?? 'f64';
    const address = (shape, name) => {
      if (!isArray(shape)) return this.#struct(shape, scalar, room);
      if (shape.scalar !== scalar) throw new TypeError(`a is of ${a.scalar} and b of ${b.scalar}: they must be alike`);
      return shape.addressIn(this.#memory, name);
    };
    const count = [a, b].map((shape) => (isArray(shape) ? shape.length : 1));
    const operands = { scalar, a: address(a, 'a'), b: address(b, 'b'), counts: count };
    return operands;
  }

  /** The struct of one polygon or polyline, its vertices and offsets. */
  #path(shape, scalar, room) {
    const { vertices, rings } = partsOf(shape), Numbers = scalars[scalar], width = Numbers.BYTES_PER_ELEMENT;
    const [base, ends, address] = [width * vertices.length, 4 * rings.length, 24].map((size) => room.take(size));
    new Numbers(this.#memory.buffer, base, vertices.length).set(checkRoom(vertices, scalar));
    new Int32Array(this.#memory.buffer, ends, rings.length).set(rings);
    writePath(this.#memory, address, width, base, ends, rings.length - 1);
    return address;
  }

  #struct(shape, scalar, room) {
    if (isPath(shape)) return this.#structOfPath(shape, scalar, room);
    const numbers = numbersOf(shape, scalar), Numbers = scalars[scalar];
    const base = room.take(8 * numbers.length), address = room.take(shapesSize);
    new Numbers(this.#memory.buffer, base, numbers.length).set(numbers);
    const stride = numbers.length * Numbers.BYTES_PER_ELEMENT;
    this.check(this.c[`vesica_shapes_from_records_${scalar}`](kindNumber(shape.kind), 1n, base, stride, address));
    return address;
  }

  /** An array of one struct. */
  #structOfPath(shape, scalar, room) {
    const of = this.#path(shape, scalar, room), address = room.take(shapesSize);
    this.check(this.c[`vesica_shapes_from_records_${scalar}`](kindNumber(shape.kind), 1n, of, 24, address));
    return address;
  }

  /** How many results two operands in step have. */
  inStep([a, b]) {
    if (a !== b && a !== 1 && b !== 1) throw new RangeError(`a has ${a} shapes and b ${b}: as many, or one of either`);
    return a === 0 || b === 0 ? 0 : Math.max(a, b);
  }

  /** last: arguments after the shapes. */
  #codes(name, a, b, { out = undefined } = {}, meaning, ...last) {
    if (!isArray(a) && !isArray(b)) {
      return this.inRoom((room) => {
        const [kindA, numbersA] = this.record(a, room), [kindB, numbersB] = this.record(b, room);
        return meaning(this.check(this.#inDouble(name)(kindA, numbersA, kindB, numbersB, ...last)));
      });
    }
    return this.inRoom((room) => {
      const { scalar, a: first, b: second, counts } = this.operands(a, b, room);
      const count = this.inStep(counts), address = room.take(count);
      const code = Number(this.c[`vesica_${name}_many_${scalar}`](first, second, ...last, address));
      const bytes = new Uint8Array(this.#memory.buffer, address, count);
      if (code < 0 && code !== constants.E_SHAPE) return this.check(code);
      if (out === undefined) return this.#answer(code, bytes.slice());
      if (!(out instanceof Uint8Array && out.length >= count)) {
        throw new RangeError(`out is a Uint8Array of ${count} or more`);
      }
      out.set(bytes);
      return this.#answer(code, out);
    });
  }

  /** leading: arguments before the shapes. */
  #numbers(name, names, a, b, ...leading) {
    const named = (columns) => {
      if (columns.length === 1) return columns[0];
      const result = {};
      for (let i = 0; i < names.length; ++i) result[names[i]] = columns[i];
      return result;
    };
    if (!isArray(a) && !isArray(b)) {
      return this.#single(name, 8 * names.length, a, b, (out) => named(this.#read(out, names.length)), ...leading);
    }
    return this.inRoom((room) => {
      const { scalar, a: first, b: second, counts } = this.operands(a, b, room);
      const Numbers = scalars[scalar], count = this.inStep(counts);
      const columns = names.map(() => room.take(count * Numbers.BYTES_PER_ELEMENT));
      const code = Number(this.c[`vesica_${name}_many_${scalar}`](...leading, first, second, ...columns));
      if (!isWritten(name, code)) return this.check(code);
      const arrays = columns.map((address) => new Numbers(this.#memory.buffer, address, count).slice());
      return this.#answer(code, named(arrays), true);
    });
  }

  /** One call for two plain objects, in double. */
  #single(name, size, a, b, read, ...leading) {
    return this.inRoom((room) => {
      const [kindA, numbersA] = this.record(a, room), [kindB, numbersB] = this.record(b, room), out = room.take(size);
      this.check(this.#inDouble(name)(...leading, kindA, numbersA, kindB, numbersB, out));
      return read(out);
    });
  }

  /** The points that a function of two shapes writes. Only paths have more than 12, and then it is asked again. */
  pointsOf(name, a, b, room, ...more) {
    const operands = [...this.record(a, room), ...this.record(b, room)];
    let most = 12, out = room.take(16 * most);
    const ask = () => this.check(Number(this.#inDouble(name)(...operands, out, BigInt(most), ...more)));
    let count = ask();
    if (count > most) {
      most = count;
      out = room.take(16 * most);
      count = ask();
    }
    const numbers = this.#read(out, 2 * count);
    return Array.from({ length: count }, (_, i) => ({ x: numbers[2 * i], y: numbers[2 * i + 1] }));
  }

  #inDouble(name) {
    return (this.#doubles[name] ??= this.c[`vesica_${name}_f64`]);
  }

  /** Numbers at an address. */
  #read(address, count) {
    const { doubles } = this.#memory, numbers = [];
    for (let i = 0; i < count; ++i) numbers.push(doubles[address / 8 + i]);
    return numbers;
  }

  #ofOne(name, count, shape) {
    return this.inRoom((room) => {
      const operands = this.record(shape, room), out = room.take(8 * count);
      this.check(this.#inDouble(name)(...operands, out));
      return this.#read(out, count);
    });
  }

  /** Rows one after the other: element [i * b.length + j] is of a[i] and b[j]. */
  #matrix(name, Numbers, a, b, leading = [], last = []) {
    if (!isArray(a) || !isArray(b)) throw new TypeError('a matrix is of two arrays of shapes, as shapes() makes them');
    return this.inRoom((room) => {
      const { scalar, a: first, b: second } = this.operands(a, b, room);
      const count = a.length * b.length, address = room.take(count * Numbers.BYTES_PER_ELEMENT);
      const operands = [...leading, first, second, ...last, address, b.length];
      const code = Number(this.c[`vesica_${name}_matrix_${scalar}`](...operands));
      if (!isWritten(name, code)) return this.check(code);
      return this.#answer(code, new Numbers(this.#memory.buffer, address, count).slice(), true);
    });
  }
}
