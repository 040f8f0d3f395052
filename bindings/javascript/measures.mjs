// SPDX-License-Identifier: Apache-2.0
// Boxes by centre, size and angle, corners and bounds of arrays, and suppression. For Vesica, whose methods these are.
import * as constants from './constants.mjs';
import { allNumbers } from './numbers.mjs';
import { isPath, polygon } from './paths.mjs';
import { fields, scalars, ShapeArray } from './shapes.mjs';

/** Names of ratios, by their numbers. */
export const ratios = Object.freeze([
  'over_union', 'over_first', 'over_second', 'over_smaller', 'generalized', 'distance', 'complete',
]);

export function ratioNumber(ratio) {
  const number = ratios.indexOf(ratio);
  if (number < 0) throw new TypeError(`a ratio is one of ${ratios.join(', ')}, not ${String(ratio)}`);
  return number;
}

function angleUnit({ degrees = false, quarters = false, reverse = false } = {}) {
  if (degrees && quarters) throw new TypeError('angles are in degrees or in quarter turns, not both');
  const unit = degrees ? constants.ANGLE_DEGREES : quarters ? constants.ANGLE_QUARTERS : constants.ANGLE_RADIANS;
  return reverse ? unit + constants.ANGLE_REVERSED : unit;
}

/** Five numbers a box, one after the other. */
function boxRows(source) {
  const rows = ArrayBuffer.isView(source) || !Array.isArray(source?.[0]) ? source : source.flat();
  if (typeof rows?.length !== 'number' || rows.length % 5 !== 0) {
    throw new RangeError('boxes have five numbers each: centre x, centre y, width, height, angle');
  }
  return allNumbers(rows, 'boxes');
}

export function shapesFromBoxes(vesica, kind, source, options = {}) {
  if (kind !== 'rect' && kind !== 'ellipse') throw new TypeError(`boxes give 'rect' or 'ellipse', not ${String(kind)}`);
  const rows = vesica.memory.apart(boxRows(source)), count = rows.length / 5;
  const scalar = options.scalar ?? 'f64', angle = angleUnit(options);
  const shapes = vesica.shapes(kind, count, { scalar });
  const Numbers = scalars[scalar], width = Numbers.BYTES_PER_ELEMENT;
  const code = vesica.inRoom((room) => {
    const address = room.take(rows.length * width);
    new Numbers(vesica.memory.buffer, address, rows.length).set(rows);
    const call = vesica.c[`vesica_${kind}s_from_boxes_${scalar}`];
    return Number(call(address, BigInt(count), 5 * width, angle, shapes.base));
  });
  return vesica.finish(code, shapes, code === constants.E_SHAPE || code === constants.E_RANGE);
}

/** `width` numbers of each shape, by a function of arrays. */
function rowsOf(vesica, name, width, shapes, ...options) {
  return vesica.inRoom((room) => {
    const { scalar, a } = vesica.operands(shapes, shapes, room);
    const Numbers = scalars[scalar], count = width * (shapes instanceof ShapeArray ? shapes.length : 1);
    const out = room.take(count * Numbers.BYTES_PER_ELEMENT);
    const code = Number(vesica.c[`vesica_${name}_${scalar}`](a, ...options, out));
    const written = code >= 0 || code === constants.E_SHAPE || code === constants.E_RANGE;
    return vesica.finish(code, written ? new Numbers(vesica.memory.buffer, out, count).slice() : undefined, written);
  });
}

export const boxes = (vesica, shapes, options) => rowsOf(vesica, 'boxes_from_shapes', 5, shapes, angleUnit(options));
export const corners = (vesica, shapes) => rowsOf(vesica, 'corners_of_shapes', 8, shapes);
export const boundsMany = (vesica, shapes) => rowsOf(vesica, 'bounds_many', fields.aabb.length, shapes);

/** The address of the struct of points: a polygon's or polyline's vertices, or what polygon() takes. */
function pointsIn(vesica, points, room) {
  const path = isPath(points) ? points : polygon(points);
  return [vesica.record(path, room)[1], path.vertices.length / 2];
}

export function convexHull(vesica, points) {
  return vesica.inRoom((room) => {
    const [address, most] = pointsIn(vesica, points, room), out = room.take(16 * most);
    const count = vesica.check(vesica.c.vesica_convex_hull_f64(address, out, BigInt(most)));
    return polygon(new Float64Array(vesica.memory.buffer, out, 2 * count));
  });
}

export function rectAbout(vesica, name, points) {
  if (points instanceof ShapeArray) {
    const { length, scalar } = points, address = points.addressIn(vesica.memory);
    const rects = vesica.shapes('rect', length, { scalar });
    const code = Number(vesica.c[`vesica_${name}_many_${scalar}`](address, rects.base));
    return vesica.finish(code, rects, code === constants.E_SHAPE || code === constants.E_RANGE);
  }
  return vesica.inRoom((room) => {
    const [address] = pointsIn(vesica, points, room), out = room.take(48);
    vesica.check(vesica.c[`vesica_${name}_f64`](address, out));
    const numbers = new Float64Array(vesica.memory.buffer, out, 6);
    return { kind: 'rect', ...Object.fromEntries(fields.rect.map((field, i) => [field, numbers[i]])) };
  });
}

/** The address of a grid's struct, and how many cells it has. */
function gridIn(vesica, { x = 0, y = 0, dx = 1, dy = dx, columns, rows } = {}, room) {
  allNumbers([x, y, dx, dy], 'x, y, dx and dy of a grid');
  if (![columns, rows].every((count) => Number.isSafeInteger(count) && count >= 0)) {
    throw new TypeError('a grid has columns and rows, whole numbers from 0 on');
  }
  const address = room.take(48);
  new Float64Array(vesica.memory.buffer, address, 4).set([x, y, dx, dy]);
  new BigInt64Array(vesica.memory.buffer, address + 32, 2).set([BigInt(columns), BigInt(rows)]);
  return [address, columns * rows];
}

export function coverage(vesica, shape, grid) {
  return vesica.inRoom((room) => {
    const [address, cells] = gridIn(vesica, grid, room), operand = vesica.record(shape, room);
    const out = room.take(8 * cells);
    vesica.check(vesica.c.vesica_coverage_f64(...operand, address, out, grid.columns));
    return new Float64Array(vesica.memory.buffer, out, cells).slice();
  });
}

export function coverageCells(vesica, shape, grid) {
  return vesica.inRoom((room) => {
    const [address] = gridIn(vesica, grid, room), operand = vesica.record(shape, room);
    const ask = (cells, shares, most) =>
      vesica.check(vesica.c.vesica_coverage_cells_f64(...operand, address, cells, shares, BigInt(most)));
    const count = ask(0, 0, 0), cells = room.take(8 * count), shares = room.take(8 * count);
    ask(cells, shares, count);
    return {
      cells: Array.from(new BigInt64Array(vesica.memory.buffer, cells, count), Number),
      shares: new Float64Array(vesica.memory.buffer, shares, count).slice(),
    };
  });
}

export function oneEach(name, values, boxes) {
  if (values?.length === boxes.length) return;
  throw new RangeError(`${boxes.length} boxes need as many ${name}, not ${values?.length}`);
}

/** Numbers in place of labels, equal where those are: not every label fits into the 32 bits that the library has. */
export function labelNumbers(labels, boxes) {
  if (labels === undefined) return undefined;
  oneEach('labels', labels, boxes);
  const numbers = new Map();
  return Int32Array.from({ length: boxes.length }, (_, i) => {
    const label = labels[i];
    if (!Number.isSafeInteger(label)) throw new TypeError(`a label is a whole number, not ${String(label)}`);
    if (!numbers.has(label)) numbers.set(label, numbers.size);
    return numbers.get(label);
  });
}

/**
 * Scores and the least one, or where the boxes' type would round any of them, their ranks: so unequal scores stay
 * unequal. What is below the least one comes below all ranks.
 */
function inOrder(scores, least, scalar) {
  const values = Float64Array.from(scores), isKept = (x) => Number.isNaN(x) || Math.fround(x) === x;
  if (scalar === 'f64' || Number.isNaN(least) || (isKept(least) && values.every(isKept))) return [values, least];
  const sorted = Float64Array.from(new Set(values.filter((x) => !Number.isNaN(x)))).sort();
  const rank = new Map(Array.from(sorted, (value, i) => [value, i]));
  return [values.map((x) => (Number.isNaN(x) ? NaN : x < least ? -Infinity : rank.get(x))), -1];
}

export function nms(vesica, boxes, scores, threshold = 0.5, options = {}) {
  const { ratio = 'over_union', leastScore = -Infinity, most = boxes?.length } = options;
  if (!(boxes instanceof ShapeArray)) throw new TypeError('boxes are an array of shapes, as shapes() makes it');
  const n = boxes.length, Scores = scalars[boxes.scalar], which = ratioNumber(ratio);
  const shapes = boxes.addressIn(vesica.memory, 'the array of boxes');
  oneEach('scores', scores, boxes);
  if (![threshold, leastScore].every((x) => typeof x === 'number')) {
    throw new TypeError('threshold and leastScore are numbers');
  }
  const [given, least] = inOrder(scores, leastScore, boxes.scalar), labels = labelNumbers(options.labels, boxes);
  if (!(Number.isInteger(most) && most >= 0)) throw new RangeError(`most is a whole number, not ${String(most)}`);
  return vesica.inRoom((room) => {
    const size = vesica.check(vesica.c.vesica_nms_scratch(BigInt(n))), { memory } = vesica;
    const [at, labelsAt, scratch, keep, kept] = [n * Scores.BYTES_PER_ELEMENT, 4 * n, size, 8 * n, 8].map((bytes) =>
      room.take(bytes));
    new Scores(memory.buffer, at, n).set(given);
    if (labels !== undefined) new Int32Array(memory.buffer, labelsAt, n).set(labels);
    new BigInt64Array(memory.buffer, kept, 1)[0] = 0n;
    const code = vesica.c[`vesica_suppress_${boxes.scalar}`](
      ...[shapes, at, labels === undefined ? 0 : labelsAt, which, threshold, least],
      ...[BigInt(Math.min(most, n)), scratch, BigInt(size), keep, kept],
    );
    const count = Number(new BigInt64Array(memory.buffer, kept, 1)[0]);
    return vesica.finish(code, Array.from(new BigInt64Array(memory.buffer, keep, count), Number));
  });
}

