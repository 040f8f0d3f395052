// SPDX-License-Identifier: Apache-2.0
// The questions of motion, and the calls that ask them.
import { list } from '../program.mjs';

/** How near is near, where B turns. */
export const tolerance = 1e-6;

/** What happens while B moves by (vx, vy) and turns by an angle: { outcome, t, x, y, nx, ny }; if it turns, gap too. */
export function firstContact(vesica, a, b, { vx, vy, angle }) {
  if (angle === 0) return vesica.cast(a, b, [vx, vy], { tEnd: 1 });
  return vesica.impactTime(a, [0, 0, 0], b, [vx, vy, angle], tolerance);
}

/** What each language calls. */
export function callsOf({ vx, vy, angle }) {
  const way = list([vx, vy]);
  if (angle === 0) {
    const cpp = `vesica::cast(a, b, ${way}, 1)`,
      python = `vesica.cast(a, b, (${way}), 1)`,
      javascript = `vesica.cast(a, b, [${way}], { tEnd: 1 })`;
    return {
      c: {
        before: ['vesica_impact_f64 out;'],
        call: `vesica_cast(&a, &b, ${way}, 1, &out)`,
        print: '"%.17g\\n", out.t',
      },
      cpp: { call: cpp, print: `"%.17g\\n", ${cpp}.t` },
      python: { call: python, print: `${python}[1].t` },
      javascript: { call: javascript, print: `${javascript}.t` },
    };
  }
  const turn = list([vx, vy, angle]),
    turns = (type) => [`const ${type} still = {0, 0, 0};`, `const ${type} turn = {${turn}};`];
  const cpp = `vesica::impact_time(a, still, b, turn, ${tolerance})`,
    python = `vesica.impact_time(a, (0, 0, 0), b, (${turn}), ${tolerance})`,
    javascript = `vesica.impactTime(a, [0, 0, 0], b, [${turn}], ${tolerance})`;
  return {
    c: {
      before: ['vesica_impact_f64 out;', ...turns('vesica_turn_f64'), 'double gap;'],
      call: `vesica_impact_time(&a, &still, &b, &turn, ${tolerance}, &out, &gap)`,
      print: '"%.17g\\n", out.t',
    },
    cpp: { before: turns('vesica::Turn<double>'), call: cpp, print: `"%.17g\\n", ${cpp}.impact.t` },
    python: { call: python, print: `${python}[1].t` },
    javascript: { call: javascript, print: `${javascript}.t` },
  };
}
