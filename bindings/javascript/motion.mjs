// SPDX-License-Identifier: Apache-2.0
// Shapes that move, for Vesica and Index, whose methods these are.
import * as constants from './constants.mjs';
import { aabb, checkRoom, scalars, ShapeArray } from './shapes.mjs';

/** Names of what a cast finds, by its numbers; the last is impactTime's alone. */
export const casts = Object.freeze(['miss', 'hit', 'start', 'near']);

const impactFields = ['t', 'x', 'y', 'nx', 'ny'];
const impactOf = (numbers) => Object.fromEntries(impactFields.map((field, i) => [field, numbers[i]]));

/** Numbers, as many as there are names. */
function named(what, given, names) {
  if (given?.length === names.length && names.every((_, i) => typeof given[i] === 'number')) return given;
  throw new TypeError(`a ${what} is an array of ${names.length} numbers, [${names.join(', ')}]`);
}

const pair = (velocity, scalar) => checkRoom(named('velocity', velocity, ['vx', 'vy']), scalar);

function time(tEnd, scalar) {
  if (typeof tEnd === 'number') return checkRoom([tEnd], scalar)[0];
  throw new TypeError('tEnd is a number, which may be Infinity');
}

/** call(place of an impact, and one number after it) gives a code; [code, these six numbers], or the error. */
function withImpact(vesica, room, scalar, call) {
  const Numbers = scalars[scalar], out = room.take(6 * Numbers.BYTES_PER_ELEMENT);
  return [vesica.check(call(out)), Array.from(new Numbers(vesica.memory.buffer, out, 6))];
}

export function cast(vesica, a, b, velocity, { tEnd = Infinity } = {}) {
  if (a instanceof ShapeArray || b instanceof ShapeArray) return castMany(vesica, a, b, velocity, time(tEnd));
  const [vx, vy] = pair(velocity);
  return vesica.inRoom((room) => {
    const shapes = [...vesica.record(a, room), ...vesica.record(b, room)];
    const call = (out) => vesica.c.vesica_cast_f64(...shapes, vx, vy, time(tEnd), out);
    const [code, numbers] = withImpact(vesica, room, 'f64', call);
    return { outcome: casts[code], ...impactOf(numbers) };
  });
}

export function impactTime(vesica, a, turnA, b, turnB, tolerance) {
  const turns = [turnA, turnB].map((turn) => vesica.memory.apart(named('turn', turn, ['vx', 'vy', 'angle'])));
  if (typeof tolerance !== 'number') throw new TypeError('a tolerance is a number above 0');
  return vesica.inRoom((room) => {
    const moving = [a, b].map((shape, i) => {
      const address = room.take(24);
      new Float64Array(vesica.memory.buffer, address, 3).set(turns[i]);
      return [...vesica.record(shape, room), address];
    });
    const call = (out) => vesica.c.vesica_impact_time_f64(...moving.flat(), tolerance, out, out + 40);
    const [code, numbers] = withImpact(vesica, room, 'f64', call);
    return { outcome: casts[code], ...impactOf(numbers), gap: numbers[5] };
  });
}

/** The addresses of vx and vy, and the bytes from one velocity to the next. */
function velocities(vesica, [vx, vy], scalar, count, room) {
  const Numbers = scalars[scalar], width = Numbers.BYTES_PER_ELEMENT;
  const single = typeof vx === 'number' && typeof vy === 'number', length = single ? 1 : count;
  if (!single && !(vx?.length === count && vy?.length === count)) {
    throw new TypeError(`a velocity is two numbers, or two arrays of ${count} numbers`);
  }
  const addresses = [vx, vy].map((numbers) => {
    const address = room.take(length * width);
    new Numbers(vesica.memory.buffer, address, length).set(checkRoom(single ? [numbers] : numbers, scalar));
    return address;
  });
  return [...addresses, single ? 0 : width];
}

function castMany(vesica, a, b, velocity, tEnd) {
  if (!(tEnd >= 0)) throw new RangeError(`tEnd is ${tEnd}, not 0 or more`);
  const [vx, vy] = velocity ?? [], given = [vx, vy].map((numbers) => vesica.memory.apart(numbers));
  return vesica.inRoom((room) => {
    const { scalar, a: first, b: second, counts } = vesica.operands(a, b, room);
    const Numbers = scalars[scalar], count = vesica.inStep(counts);
    const moving = velocities(vesica, given, scalar, count, room), until = time(tEnd, scalar);
    const columns = impactFields.map(() => room.take(count * Numbers.BYTES_PER_ELEMENT));
    const code = Number(vesica.c[`vesica_cast_many_${scalar}`](first, second, ...moving, until, ...columns));
    const arrays = columns.map((address) => new Numbers(vesica.memory.buffer, address, count).slice());
    const written = [constants.E_SHAPE, constants.E_ARGUMENT, constants.E_RANGE].includes(code);
    return vesica.finish(code, impactOf(arrays), written);
  });
}

/** What a cast at many found: an item and its impact, or null. */
const firstOf = ([item, numbers], none) => (item === none ? null : { item, ...impactOf(numbers) });

export function castFirst(vesica, one, many, velocity, { tEnd = Infinity } = {}) {
  if (!(many instanceof ShapeArray)) throw new TypeError('many is an array of shapes, as shapes() makes it');
  const [vx, vy] = pair(velocity, many.scalar);
  return vesica.inRoom((room) => {
    const { scalar, a, b } = vesica.operands(one, many, room);
    const call = (out) => vesica.c[`vesica_cast_first_${scalar}`](a, b, vx, vy, time(tEnd, scalar), out);
    return firstOf(withImpact(vesica, room, scalar, call), many.length);
  });
}

export function sweepBounds(vesica, shape, velocity, tEnd) {
  const [vx, vy] = pair(velocity);
  return vesica.inRoom((room) => {
    const operand = vesica.record(shape, room), out = room.take(32);
    vesica.check(vesica.c.vesica_sweep_bounds_f64(...operand, vx, vy, time(tEnd), out));
    return aabb(...new Float64Array(vesica.memory.buffer, out, 4));
  });
}

/** The arguments of a cast after the moving shape. */
export const motionOf = (velocity, { tEnd = Infinity } = {}, scalar) =>
  [...pair(velocity, scalar), time(tEnd, scalar)];

export function indexCastFirst(vesica, scalar, room, length, call) {
  return firstOf(withImpact(vesica, room, scalar, call), length);
}
