// SPDX-License-Identifier: Apache-2.0
// Polygons and polylines: plain objects of vertices x y x y ..., and where their rings or chains begin.
import { allNumbers } from './numbers.mjs';

export const pathNames = ['polygon', 'polyline'];
export const isPath = (shape) => pathNames.includes(shape?.kind);

const isFlat = (source) => ArrayBuffer.isView(source) || typeof source?.[0] === 'number';
/** Each list of places in nested lists, such as GeoJSON's coordinates. */
function listsOf(source) {
  if (!Array.isArray(source)) throw new TypeError('coordinates are nested arrays, the innermost [x, y]');
  return typeof source[0]?.[0] === 'number' ? [source] : source.flatMap(listsOf);
}

/** Offsets into so many others: whole numbers that ascend. */
function checked(offsets, end, name) {
  if (typeof offsets?.length !== 'number' || offsets.length === 0) {
    throw new TypeError(`${name} are an array of whole numbers, one more than there are parts`);
  }
  let before = 0;
  for (let i = 0; i < offsets.length; ++i) {
    const offset = offsets[i];
    if (!(Number.isInteger(offset) && offset >= before && offset <= end)) {
      throw new RangeError(`${name} ascend from 0 or more to ${end} at most: ${String(offset)} follows ${before}`);
    }
    before = offset;
  }
  return Int32Array.from(offsets);
}

function countOf(kind, vertices) {
  if (vertices.length === 0) throw new RangeError(`a ${kind} has a vertex or more`);
  if (vertices.length % 2 === 0) return vertices.length / 2;
  throw new RangeError(`vertices have two numbers each; ${vertices.length} is odd`);
}

/** From vertices x y x y ... and where rings begin among them, with the end; or from nested coordinates. */
function path(kind, source, rings) {
  if (isFlat(source)) {
    const end = countOf(kind, allNumbers(source, `vertices of a ${kind}`));
    return { kind, vertices: Float64Array.from(source), rings: rings === undefined ? [0, end] : Array.from(rings) };
  }
  if (rings !== undefined) throw new TypeError(`${kind}: nested coordinates have their rings themselves`);
  const lists = listsOf(source), vertices = [], ends = [0];
  for (const places of lists) {
    for (const [x, y] of places) vertices.push(x, y);
    ends.push(vertices.length / 2);
  }
  if (vertices.some((number) => typeof number !== 'number')) throw new TypeError('a vertex is two numbers, [x, y]');
  countOf(kind, vertices);
  return { kind, vertices: Float64Array.from(vertices), rings: ends };
}

export const polygon = (source, rings) => path('polygon', source, rings);
export const polyline = (source, chains) => path('polyline', source, chains);

/** The numbers and offsets of a plain object. */
export function partsOf({ kind, vertices, rings }) {
  if (!isFlat(vertices)) throw new TypeError(`a ${kind} has vertices, numbers x y x y ..., and rings: see ${kind}()`);
  allNumbers(vertices, `vertices of a ${kind}`);
  return { vertices, rings: checked(rings ?? [0, countOf(kind, vertices)], countOf(kind, vertices), 'rings') };
}

/** Vertices and offsets of many: of flat numbers as options say, or of plain objects and nested coordinates. */
export function partsOfMany(kind, source, { each, rings, polygons }) {
  if (isFlat(source)) {
    const end = source.length === 0 ? 0 : countOf(kind, allNumbers(source, `vertices of ${kind}s`));
    if (each !== undefined) {
      const fits = Number.isInteger(each) && each > 0 && end % each === 0;
      if (!fits) throw new RangeError(`${end} vertices are no ${kind}s of ${String(each)} each`);
      return { vertices: source, each, count: end / each };
    }
    const offsets = checked(rings, end, 'rings');
    if (polygons === undefined) return { vertices: source, each: end, rings: offsets, count: offsets.length - 1 };
    const parts = checked(polygons, offsets.length - 1, 'polygons');
    return { vertices: source, each: end, rings: offsets, polygons: parts, count: parts.length - 1 };
  }
  if (!Array.isArray(source)) throw new TypeError(`${kind}s are an array of them, of their coordinates or of numbers`);
  const vertices = [], ends = [0], parts = [0];
  for (const given of source) {
    if (isPath(given) && given.kind !== kind) throw new TypeError(`a ${given.kind} among ${kind}s`);
    const one = partsOf(isPath(given) ? given : path(kind, given)), shift = vertices.length / 2 - one.rings[0];
    for (let i = 2 * one.rings[0]; i < 2 * one.rings.at(-1); ++i) vertices.push(one.vertices[i]);
    for (const end of one.rings.subarray(1)) ends.push(end + shift);
    parts.push(ends.length - 1);
  }
  const offsets = { rings: Int32Array.from(ends), polygons: Int32Array.from(parts) };
  return { vertices, each: vertices.length / 2, ...offsets, count: parts.length - 1, isPlain: true };
}

/** Where the rings of element i of an array begin among all vertices, with the end. */
export const ringsIn = ({ each, rings, polygons }) => (i) => {
  if (rings === undefined) return [i * each, (i + 1) * each];
  return polygons === undefined ? rings.subarray(i, i + 2) : rings.subarray(polygons[i], polygons[i + 1] + 1);
};

/** Writes the struct of one shape, of 24 bytes. */
export function writePath(memory, address, width, vertices, rings, count) {
  new Uint32Array(memory.buffer, address, 4).set([vertices, vertices + width, 2 * width, rings]);
  new BigInt64Array(memory.buffer, address + 16, 1)[0] = BigInt(count);
}

/** Writes the struct of an array. Addresses of absent offsets are 0. */
export function writePaths(memory, address, width, { kind, count, vertices, rings, polygons, each }) {
  const words = new Uint32Array(memory.buffer, address, 18);
  words.fill(0);
  words.set([kind, 0, count], 0);
  words.set([2 * width, vertices, vertices + width], 4);
  words.set([rings, polygons, 0, each], 13);
}
