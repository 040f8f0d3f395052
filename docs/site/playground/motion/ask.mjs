// SPDX-License-Identifier: Apache-2.0
// The questions of motion, and the C that asks them.
import { toHex } from '../number.mjs';
import { argument, operand } from '../pair/answers.mjs';

/** How near is near, where B turns. */
export const tolerance = 1e-6;

/** What happens while B moves by (vx, vy) and turns by an angle: { outcome, t, x, y, nx, ny }; if it turns, gap too. */
export function firstContact(vesica, a, b, { vx, vy, angle }) {
  if (angle === 0) return vesica.cast(a, b, [vx, vy], { tEnd: 1 });
  return vesica.impactTime(a, [0, 0, 0], b, [vx, vy, angle], tolerance);
}

/** As it stands it compiles inside a function, after #include <vesica.h>. */
export function callOf(a, b, { vx, vy, angle }) {
  const shapes = [operand(a, 'a'), operand(b, 'b'), 'vesica_impact_f64 out;'];
  if (angle === 0) {
    const call = `vesica_cast_f64(${argument(a, 'a')}, ${argument(b, 'b')}, ${toHex(vx)}, ${toHex(vy)}, 1, &out)`;
    return [...shapes, `int32_t answer = ${call};`].join('\n');
  }
  const turns = [
    'const vesica_turn_f64 still = {0, 0, 0};',
    `const vesica_turn_f64 turn = {${[vx, vy, angle].map(toHex).join(', ')}};`,
    'double gap;',
  ];
  const call = `vesica_impact_time_f64(${argument(a, 'a')}, &still, ${argument(b, 'b')}, &turn, ${toHex(tolerance)}, &out, &gap)`;
  return [...shapes, ...turns, `int32_t answer = ${call};`].join('\n');
}
