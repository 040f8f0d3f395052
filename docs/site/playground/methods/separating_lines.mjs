// SPDX-License-Identifier: Apache-2.0
// Separating lines: is there an edge of one rectangle beyond whose line lie all corners of the other?
import { rect } from '../../vesica/vesica.mjs';
import { slider } from '../element.mjs';
import { draw, grid, polygon } from '../plane.mjs';
import { corners, form } from '../shape.mjs';

const far = 30;

/** The four lines of a's edges, and whether each has all of b beyond it. */
function lines(a, b) {
  const f = form(a);
  return [
    [f.p, f.q],
    [f.q, f.p],
  ].flatMap(([across, along]) =>
    [-1, 1].map((side) => {
      const at = [f.x + side * across[0], f.y + side * across[1]],
        square = across[0] ** 2 + across[1] ** 2;
      const separates = corners(b).every(([x, y]) => side * ((x - f.x) * across[0] + (y - f.y) * across[1]) > square);
      return { separates, ends: [-far, far].map((s) => [at[0] + s * along[0], at[1] + s * along[1]]) };
    }),
  );
}

export const separatingLines = {
  id: 'lines',
  title: 'Separating lines',
  seed: 'Rectangle intersection at 60fps.',
  idea: 'Put one rectangle at the origin along the axes: its edges’ lines are then easy. If all corners of the other lie beyond one of them, that line separates the two. If not, try the other way round. Print’s last step says the opposite of what it must: no such line means that they do intersect.',
  shapes: { a: rect(-1.2, -0.4, 3.2, 1.8, 10, { degrees: true }), b: rect(1.6, 1.1, 2.6, 0.7, -42, { degrees: true }) },
  controls(demo) {
    demo.k = 2;
    return [
      slider('lines-k', 'Sample points k', { min: 0, max: 30, value: 2 }, String, (k) => {
        demo.k = k;
        demo.show();
      }),
    ];
  },
  draw(demo) {
    const { a, b } = demo.shapes,
      { view } = demo.stage,
      all = [...lines(a, b), ...lines(b, a)];
    return [
      grid(view),
      ...all.map(({ separates, ends }) =>
        polygon(view, ends, { class: `line${separates ? ' separates' : ''}` }, false),
      ),
      draw(view, a, { class: 'shape a', 'data-shape': 'a' }),
      draw(view, b, { class: 'shape b', 'data-shape': 'b' }),
    ];
  },
  tell(demo) {
    const { a, b } = demo.shapes,
      count = [...lines(a, b), ...lines(b, a)].filter((line) => line.separates).length;
    return [
      ['Separating lines', demo.methods.rectRectSeparatingLines(a, b), `${count} of 8 lines separate them`],
      ['Bounds', demo.methods.rectRectBounds(a, b), 'a first pass: boxes along the axes'],
      [
        `Sample points, k = ${demo.k}`,
        demo.methods.rectRectSamplePoints(a, b, demo.k),
        'corners, and k points of the middle line: yes or uncertain',
      ],
      demo.exact(a, b),
    ];
  },
};
