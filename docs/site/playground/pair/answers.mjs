// SPDX-License-Identifier: Apache-2.0
// Every question about two shapes: its answer in words and in full, and the call that gives it.
import { short, toHex } from '../number.mjs';
import { isPath } from '../path.mjs';
import { camel } from '../program.mjs';

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
/** A direction as an angle. */
const degrees = (x, y) => `${short((Math.atan2(y, x) * 180) / Math.PI, 4)}°`.replace('≈ ', '');
const closest = (found) => ({
  value: short(found.distance),
  detail: `between ${place(found.ax, found.ay)} and ${place(found.bx, found.by)}`,
  exact: toHex(found.distance),
  found,
});

/**
 * id, question, C function, the type of its out, the part of it that is shown, and ask(vesica, a, b) -> { value, detail in
 * words, exact in hexadecimal, found }.
 */
const questions = [
  {
    id: 'overlap',
    question: 'Do they share a point?',
    name: 'overlap',
    ask: (v, a, b) => {
      const found = v.overlap(a, b);
      return { value: found ? 'yes' : 'no', detail: 'exact', found };
    },
  },
  {
    id: 'relation',
    question: 'How does A relate to B?',
    name: 'relation',
    ask: (v, a, b) => {
      const found = v.relation(a, b);
      return { value: relationWords[found], detail: `exact: ${found.toUpperCase()}`, found };
    },
  },
  {
    id: 'nearest',
    question: 'How far apart?',
    name: 'nearest',
    out: 'vesica_closest_points_f64',
    part: '.distance',
    ask: (v, a, b) => closest(v.nearest(a, b)),
  },
  {
    id: 'outlines',
    question: 'How far apart are the outlines?',
    name: 'boundary_distance',
    out: 'vesica_closest_points_f64',
    part: '.distance',
    ask: (v, a, b) => closest(v.boundaryDistance(a, b)),
  },
  {
    id: 'depth',
    question: 'How far must B move to part?',
    name: 'depth',
    out: 'vesica_penetration_f64',
    part: '.depth',
    ask: (v, a, b) => {
      const found = v.depth(a, b);
      const detail = found.depth > 0 ? `towards ${degrees(found.x, found.y)}, along ${place(found.x, found.y)}` : '';
      return { value: short(found.depth), detail, exact: toHex(found.depth), found };
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
        detail: found.places.map(({ x, y }) => place(x, y)).join(' ') || 'nowhere',
        exact: found.places.map(({ x, y }) => `${toHex(x)} ${toHex(y)}`).join(', '),
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
      return { value: short(found), detail: `${(100 * found).toFixed(1)}% of both together`, exact: toHex(found), found };
    },
  },
];

/** What each language calls for a question, and what of the answer its program prints. */
export function callsOf({ name, out, room, part = '' }, a, b) {
  const result = out === undefined ? '' : room === undefined ? ', &out' : `, out, ${room}, &shared`,
    call = `vesica_${name}(&a, &b${result})`;
  const plain = `vesica::${name}(a, b)`,
    python = `vesica.${name}(a, b)`,
    javascript = `vesica.${camel(name)}(a, b)`;
  if (room !== undefined) {
    const pathInCpp = isPath(a) || isPath(b),
      checked = `vesica::${name}_or_error(a, b, out, ${room}, shared)`;
    return {
      c: { before: [`${out} out[${room}];`, 'int32_t shared;'], type: 'int64_t', call, print: '"%d\\n", (int)answer' },
      cpp: pathInCpp
        ? {
            before: [`vesica::Point<double> out[${room}];`, 'bool shared;'],
            call: checked,
            print: `"%d\\n", static_cast<int>(${checked})`,
          }
        : { call: plain, print: `"%d\\n", ${plain}.count` },
      python: { call: python, print: `len(${python}.places)` },
      javascript: { call: javascript, print: `${javascript}.places.length` },
    };
  }
  if (out === undefined) {
    return {
      c: { call, print: '"%d\\n", answer' },
      cpp: { call: plain, print: `"%d\\n", static_cast<int>(${plain})` },
      python: { call: python, print: name === 'relation' ? `${python}.name` : python },
      javascript: { call: javascript, print: javascript },
    };
  }
  return {
    c: { before: [`${out} out;`], call, print: `"%.17g\\n", out${part}` },
    cpp: { call: plain, print: `"%.17g\\n", ${plain}${part}` },
    python: { call: python, print: `${python}${part}` },
    javascript: { call: javascript, print: `${javascript}${part}` },
  };
}

/** All answers about a and b. What the library refuses is an answer in its own words. */
export function answersTo(vesica, a, b) {
  return questions.map((question) => {
    try {
      return { ...question, ...question.ask(vesica, a, b) };
    } catch (error) {
      if (error.code === undefined) throw error;
      return { ...question, value: 'none', detail: error.message, found: null };
    }
  });
}

export const found = (answers, id) => answers.find((answer) => answer.id === id).found;
