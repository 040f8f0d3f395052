// SPDX-License-Identifier: Apache-2.0
// The questions of motion, and the C that asks them.
import { constants, fields, kinds } from '../../vesica/vesica.mjs';
import { toHex } from '../number.mjs';
import { numbers } from '../shape.mjs';

/** How near is near, where B turns. */
export const tolerance = 1e-6;

const answers = {
  [constants.CAST_MISS]: 'miss',
  [constants.CAST_HIT]: 'hit',
  [constants.CAST_START]: 'start',
  [constants.CAST_NEAR]: 'near',
};

/** call(room, put) with put(numbers) -> their address; then { answer, t, x, y, nx, ny, gap }. */
function ask(vesica, call) {
  return vesica.inRoom((room) => {
    const put = (values) => {
      const address = room.take(8 * values.length);
      new Float64Array(vesica.memory.buffer, address, values.length).set(values);
      return address;
    };
    const out = put([0, 0, 0, 0, 0, 0]);
    const code = vesica.check(call(put, out));
    const [t, x, y, nx, ny, gap] = new Float64Array(vesica.memory.buffer, out, 6);
    return { answer: answers[code], t, x, y, nx, ny, gap };
  });
}

const shapeOf = (put, shape) => [kinds.indexOf(shape.kind), put(fields[shape.kind].map((name) => shape[name]))];

/** What happens while B moves by (vx, vy) and turns by an angle, if that is not 0. */
export function firstContact(vesica, a, b, { vx, vy, angle }) {
  if (angle === 0) {
    return ask(vesica, (put, out) =>
      vesica.c.vesica_cast_f64(...shapeOf(put, a), ...shapeOf(put, b), vx, vy, 1, out),
    );
  }
  return ask(vesica, (put, out) =>
    vesica.c.vesica_impact_time_f64(
      ...shapeOf(put, a),
      put([0, 0, 0]),
      ...shapeOf(put, b),
      put([vx, vy, angle]),
      tolerance,
      out,
      out + 40,
    ),
  );
}

const constant = (kind) => `VESICA_${kind.toUpperCase()}`;
const operand = (shape, letter) => `const double ${letter}[] = {${numbers(shape).map(toHex).join(', ')}};`;

/** As it stands it compiles inside a function, after #include <vesica.h>. */
export function callOf(a, b, { vx, vy, angle }) {
  const shapes = [operand(a, 'a'), operand(b, 'b'), 'vesica_impact_f64 out;'];
  if (angle === 0) {
    const call = `vesica_cast_f64(${constant(a.kind)}, a, ${constant(b.kind)}, b, ${toHex(vx)}, ${toHex(vy)}, 1, &out)`;
    return [...shapes, `int32_t answer = ${call};`].join('\n');
  }
  const turns = [
    'const vesica_turn_f64 still = {0, 0, 0};',
    `const vesica_turn_f64 turn = {${[vx, vy, angle].map(toHex).join(', ')}};`,
    'double gap;',
  ];
  const call = `vesica_impact_time_f64(${constant(a.kind)}, a, &still, ${constant(b.kind)}, b, &turn, ${toHex(tolerance)}, &out, &gap)`;
  return [...shapes, ...turns, `int32_t answer = ${call};`].join('\n');
}
