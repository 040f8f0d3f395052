// SPDX-License-Identifier: Apache-2.0
// From two shapes to their contact: the last of neighbouring numbers at which they still touch, and those beside it.
import { beside, besideFloat, between, betweenFloats } from '../number.mjs';
import { fieldsOf, numberOf, numbers, withNumber } from '../shape.mjs';

export const neighbours = 65; // each side

export const steppings = {
  double: { beside, between, round: (x) => x },
  float: { beside: besideFloat, between: betweenFloats, round: Math.fround },
};

/** Whether the two overlap when b's number is so; null where b is invalid then. */
const asked = (vesica, a, b, field) => (value) => {
  const shape = withNumber(b, field, value);
  return Number.isFinite(value) && vesica.invalidity(shape) === null ? vesica.overlap(a, shape) : null;
};

/** A value of b's number where the answer is another than now, by ever longer steps both ways; null if none is found. */
function other(ask, start, size) {
  const now = ask(start);
  for (let step = size / 64; step < size * 2 ** 40; step *= 1.25) {
    for (const value of [start + step, start - step]) {
      if (ask(value) === !now) return value;
    }
  }
  return null;
}

/** b's number at contact: they overlap, and at the next number on the one side they do not. */
function lastTouching(ask, stepping, inside, outside) {
  for (;;) {
    const middle = stepping.between(inside, outside);
    if (middle === inside || middle === outside) return inside;
    if (ask(middle)) inside = middle;
    else outside = middle;
  }
}

/**
 * { value, b, cells }: b at contact, and 131 cells { value, exact } about it, by ascending number. null if no value of
 * that number changes the answer. With float all numbers of both shapes are rounded to float first.
 */
export function contact(vesica, a, b, field, type) {
  const stepping = steppings[type],
    rounded = (shape, name) => withNumber(shape, name, stepping.round(numberOf(shape, name)));
  const [first, second] = [a, b].map((shape) => fieldsOf(shape).reduce(rounded, shape));
  const ask = asked(vesica, first, second, field),
    start = numberOf(second, field);
  const size = Math.max(...[first, second].flatMap(numbers).map(Math.abs));
  const far = ask(start) === null ? null : other(ask, start, size);
  if (far === null) return null;
  const ends = [start, stepping.round(far)],
    [inside, outside] = ask(start) ? ends : ends.reverse();
  if (ask(inside) !== true || ask(outside) !== false) return null;
  const value = lastTouching(ask, stepping, inside, outside),
    cells = [];
  for (let i = -neighbours; i <= neighbours; ++i) {
    const here = stepping.beside(value, i);
    cells.push({ value: here, exact: ask(here) });
  }
  return { value, a: first, b: withNumber(second, field, value), cells };
}
