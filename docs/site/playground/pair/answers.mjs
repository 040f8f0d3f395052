// SPDX-License-Identifier: Apache-2.0
// Every question about two shapes: its answer in words and in full, and the C call that gives it.
import { short, toHex } from '../number.mjs';
import { isPath } from '../path.mjs';
import { numbers } from '../shape.mjs';

const relationWords = {
  disjoint: 'disjoint',
  touch: 'they touch',
  cross: 'they cross',
  inside: 'A inside B',
  inside_touch: 'A inside B, touching',
  contains: 'B inside A',
  contains_touch: 'B inside A, touching',
  equal: 'equal',
};

/** A place to look for on the picture. */
const place = (x, y) => `(${short(x, 4)}, ${short(y, 4)})`.replaceAll('≈ ', '');
const closest = (found) => ({
  value: short(found.distance),
  exact: `${toHex(found.distance)} between ${place(found.ax, found.ay)} and ${place(found.bx, found.by)}`,
  found,
});

/** id, question, C function, the type of its out, and ask(vesica, a, b) -> { value, exact, found }. */
const questions = [
  {
    id: 'overlap',
    question: 'Do they share a point?',
    name: 'overlap',
    ask: (v, a, b) => {
      const found = v.overlap(a, b);
      return { value: found ? 'yes' : 'no', exact: 'exact', found };
    },
  },
  {
    id: 'relation',
    question: 'How does A relate to B?',
    name: 'relation',
    ask: (v, a, b) => {
      const found = v.relation(a, b);
      return { value: relationWords[found], exact: `exact: VESICA_${found.toUpperCase()}`, found };
    },
  },
  {
    id: 'nearest',
    question: 'How far apart?',
    name: 'nearest',
    out: 'vesica_closest_points_f64',
    ask: (v, a, b) => closest(v.nearest(a, b)),
  },
  {
    id: 'outlines',
    question: 'How far apart are the outlines?',
    name: 'boundary_distance',
    out: 'vesica_closest_points_f64',
    ask: (v, a, b) => closest(v.boundaryDistance(a, b)),
  },
  {
    id: 'depth',
    question: 'How far must B move to part?',
    name: 'depth',
    out: 'vesica_penetration_f64',
    ask: (v, a, b) => {
      const found = v.depth(a, b);
      return { value: short(found.depth), exact: `${toHex(found.depth)} along ${place(found.x, found.y)}`, found };
    },
  },
  {
    id: 'crossings',
    question: 'Where do the outlines meet?',
    name: 'crossings',
    out: 'vesica_point_f64',
    room: 8,
    ask: (v, a, b) => {
      const found = v.crossings(a, b),
        count = found.places.length;
      const also = found.shared ? ' and a shared stretch' : '';
      return {
        value: `${count} place${count === 1 ? '' : 's'}${also}`,
        exact: found.places.map(({ x, y }) => place(x, y)).join(' ') || 'nowhere',
        found,
      };
    },
  },
  {
    id: 'area',
    question: 'What area do they share?',
    name: 'area',
    out: 'double',
    ask: (v, a, b) => {
      const found = v.area(a, b);
      return { value: short(found), exact: toHex(found), found };
    },
  },
  {
    id: 'iou',
    question: 'Intersection over union?',
    name: 'iou',
    out: 'double',
    ask: (v, a, b) => {
      const found = v.iou(a, b);
      return { value: short(found), exact: toHex(found), found };
    },
  },
];

/** A shape as C has it; the calls name a polygon's address. */
export function operand(shape, letter) {
  const list = `{${numbers(shape).map(toHex).join(', ')}}`;
  if (!isPath(shape)) return `const double ${letter}[] = ${list};`;
  const { rings } = shape;
  return [
    `const double ${letter}_xy[] = ${list};`,
    `const int32_t ${letter}_rings[] = {${rings.join(', ')}};`,
    `const vesica_${shape.kind}_f64 ${letter} = {${letter}_xy, ${letter}_xy + 1, 2 * sizeof(double), ${letter}_rings, ${rings.length - 1}};`,
  ].join('\n');
}
export const argument = (shape, letter) => `VESICA_${shape.kind.toUpperCase()}, ${isPath(shape) ? '&' : ''}${letter}`;

/** The C that gives an answer; as it stands it compiles inside a function, after #include <vesica.h>. */
export function callOf({ name, out, room }, a, b) {
  const declared = room === undefined ? [`${out} out;`] : [`${out} out[${room}];`, 'int32_t shared;'];
  return [
    operand(a, 'a'),
    operand(b, 'b'),
    ...(out === undefined ? [] : declared),
    `int32_t answer = ${room === undefined ? '' : '(int32_t)'}${brief({ name, out, room }, a, b)};`,
  ].join('\n');
}

/** The last line of the call, without the shapes' numbers. */
export function brief({ name, out, room }, a, b) {
  const result = out === undefined ? '' : room === undefined ? ', &out' : `, out, ${room}, &shared`;
  return `vesica_${name}_f64(${argument(a, 'a')}, ${argument(b, 'b')}${result})`;
}

/** All answers about a and b. What the library refuses is an answer in its own words. */
export function answersTo(vesica, a, b) {
  return questions.map((question) => {
    try {
      return { ...question, ...question.ask(vesica, a, b) };
    } catch (error) {
      if (error.code === undefined) throw error;
      return { ...question, value: 'none', exact: error.message, found: null };
    }
  });
}

export const found = (answers, id) => answers.find((answer) => answer.id === id).found;
