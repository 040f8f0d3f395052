// SPDX-License-Identifier: Apache-2.0
// The Minkowski sum of rectangle and ellipse: as printed, with its typing error mended, and corrected.
import { ellipse, rect } from '../../vesica/vesica.mjs';
import { choice } from '../element.mjs';
import { draw, grid, polygon, text } from '../plane.mjs';
import { corners, form } from '../shape.mjs';

/** The ellipse's farthest point from its centre along a direction. */
function farthest({ p, q }, [x, y]) {
  const s = p[0] * x + p[1] * y,
    t = q[0] * x + q[1] * y,
    length = Math.hypot(s, t) || 1;
  return [(s * p[0] + t * q[0]) / length, (s * p[1] + t * q[1]) / length];
}

/** The outline of the sum: sums of farthest points all round. */
function grown(a, b) {
  const f = form(a),
    e = form(b),
    sign = (v) => (v < 0 ? -1 : 1);
  return Array.from({ length: 360 }, (_, i) => {
    const t = (2 * Math.PI * (i + 0.5)) / 360,
      along = [Math.cos(t), Math.sin(t)],
      [ex, ey] = farthest(e, along);
    const s = sign(f.p[0] * along[0] + f.p[1] * along[1]),
      r = sign(f.q[0] * along[0] + f.q[1] * along[1]);
    return [f.x + s * f.p[0] + r * f.q[0] + ex, f.y + s * f.p[1] + r * f.q[1] + ey];
  });
}

/**
 * The test of section 5: one corner, chosen by the signs of the centre's coordinates. `typo` uses the first half size
 * for both, as printed. Axes are unit vectors here.
 */
function asPrinted(a, b, typo) {
  const e = form(b),
    k = [b.cx - a.cx, b.cy - a.cy],
    axes = [
      [a.ux, a.uy],
      [-a.uy, a.ux],
    ],
    half = [a.hx, a.hy];
  const dot = ([x, y], [z, w]) => x * z + y * w;
  const xi = axes.map((axis) => dot(axis, k)),
    reach = axes.map((axis) => Math.hypot(dot(axis, e.p), dot(axis, e.q)));
  if (xi.some((x, i) => Math.abs(x) > half[i] + reach[i])) return { answer: 'no' };
  const s = xi.map((x) => (x >= 0 ? 1 : -1)),
    used = [half[0], typo ? half[0] : half[1]];
  const corner = [0, 1].map((i) => s[0] * used[0] * axes[0][i] + s[1] * used[1] * axes[1][i]),
    delta = [k[0] - corner[0], k[1] - corner[1]];
  // M delta, where the ellipse is |D V' x| <= 1.
  const pp = dot(e.p, e.p),
    qq = dot(e.q, e.q),
    mp = dot(e.p, delta) / (pp * pp),
    mq = dot(e.q, delta) / (qq * qq);
  const md = [mp * e.p[0] + mq * e.q[0], mp * e.p[1] + mq * e.q[1]],
    at = [a.cx + corner[0], a.cy + corner[1]];
  if (axes.some((axis, i) => s[i] * dot(axis, md) <= 0)) return { answer: 'yes', at };
  return { answer: dot(delta, md) <= 1 ? 'yes' : 'no', at };
}

const examples = {
  sign: {
    a: rect(0, 0, 0.5, 1.75),
    b: { kind: 'ellipse', cx: -1.25, cy: -0.375, ux: 8 / 17, uy: 15 / 17, a: 3, b: 0.125 },
  },
  typo: { a: rect(0, 0, 2, 1), b: ellipse(1.5, 1, 1, 0.5, -30, { degrees: true }) },
};

export const minkowskiSum = {
  id: 'minkowski',
  title: 'Minkowski sum',
  seed: 'David Eberly, Intersection of Rectangle and Ellipse (2015), section 5.',
  idea: 'Shrink the ellipse to its centre and grow the rectangle by it: do they overlap? The same as: is the centre in the grown rectangle? Print looks at one corner (red), chosen by the signs of the centre’s coordinates, which for a small rectangle and a skewed ellipse is the wrong one.',
  shapes: examples.sign,
  controls: (demo) => [
    choice(
      'minkowski-example',
      'Example',
      [
        ['sign', 'the wrong corner'],
        ['typo', 'the typing error'],
      ],
      'sign',
      (name) => {
        demo.shapes = examples[name];
        demo.stage.fit();
        demo.show();
      },
    ),
  ],
  draw(demo) {
    const { a, b } = demo.shapes,
      { view } = demo.stage,
      { at } = asPrinted(a, b, false);
    const arcs = corners(a).map(([x, y]) =>
      draw(
        view,
        { ...b, cx: x, cy: y },
        { class: `wedge${at && Math.hypot(x - at[0], y - at[1]) < 1e-9 ? '' : ' right'}` },
      ),
    );
    return [
      grid(view),
      polygon(view, grown(a, b), { class: 'grown' }),
      ...arcs,
      draw(view, a, { class: 'shape a', 'data-shape': 'a' }),
      draw(view, b, { class: 'shape b', 'data-shape': 'b' }),
      text(view, [b.cx, b.cy], 'K', { dx: 16, dy: 5 }),
    ];
  },
  tell(demo) {
    const { a, b } = demo.shapes;
    return [
      ['As printed', asPrinted(a, b, true).answer, 'the first half size stands where the second must'],
      ['Typing error mended', asPrinted(a, b, false).answer, 'still the corner by signs'],
      [
        'Corrected',
        demo.methods.rectEllipseMinkowskiSum(a, b),
        'vesica_method_rect_ellipse_minkowski_sum_f64: extreme points tell which corner',
      ],
      demo.exact(a, b),
    ];
  },
};
