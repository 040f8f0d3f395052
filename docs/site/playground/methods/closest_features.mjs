// SPDX-License-Identifier: Apache-2.0
// Closest features: the nine regions about a rectangle, and what is tried in the one that holds the ellipse's centre.
import { ellipse, rect } from '../../vesica/vesica.mjs';
import { draw, polygon, text } from '../plane.mjs';
import { corners, form } from '../shape.mjs';

const far = 40; // how far a region is drawn, in half sizes of the rectangle

/** Where a point is along the rectangle's axes, in its half sizes. */
function inFrame(shape, [x, y]) {
  const f = form(shape),
    dx = x - f.x,
    dy = y - f.y;
  return [f.p, f.q].map((axis) => (dx * axis[0] + dy * axis[1]) / (axis[0] ** 2 + axis[1] ** 2));
}

const side = (level) => (level < -1 ? -1 : level > 1 ? 1 : 0);
const limits = { [-1]: [-far, -1], 0: [-1, 1], 1: [1, far] };

function regionOutline(shape, i, j) {
  const f = form(shape),
    at = (s, t) => [f.x + s * f.p[0] + t * f.q[0], f.y + s * f.p[1] + t * f.q[1]];
  const [x0, x1] = limits[i],
    [y0, y1] = limits[j];
  return [at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)];
}

/** Corners are A B C D in the order of corners(): numbers of edges' ends, and of vertices, to try in a region. */
function features(i, j) {
  const index = (s, t) => (t < 0 ? (s < 0 ? 0 : 1) : s < 0 ? 3 : 2);
  if (i === 0 && j === 0) return { edges: [], vertices: [] };
  if (i !== 0 && j !== 0) {
    const here = index(i, j),
      beside = index(-i, j),
      below = index(i, -j);
    return {
      edges: [
        [here, beside],
        [here, below],
      ],
      vertices: [here, beside, below],
    };
  }
  const ends = i !== 0 ? [index(i, -1), index(i, 1)] : [index(-1, j), index(1, j)];
  return { edges: [ends], vertices: ends };
}

const here = ({ shapes: { a, b } }) => inFrame(a, [b.cx, b.cy]).map(side);

export const closestFeatures = {
  id: 'features',
  title: 'Closest features',
  seed: 'David Eberly, Intersection of Rectangle and Ellipse (2015), section 3.',
  idea: 'Which of nine regions about the rectangle holds the ellipse’s centre? It names the few edges and vertices that are worth a test: two edges and three vertices at most.',
  shapes: { a: rect(-0.4, 0, 3, 1.8, 16, { degrees: true }), b: ellipse(1.35, 1.85, 1.2, 0.5, -35, { degrees: true }) },
  draw(demo) {
    const { a, b } = demo.shapes,
      { view } = demo.stage,
      [i, j] = here(demo),
      all = corners(a),
      { edges, vertices } = features(i, j);
    const regions = [-1, 0, 1].flatMap((m) =>
      [-1, 0, 1].map((n) =>
        polygon(view, regionOutline(a, m, n), {
          class: `region${m !== 0 && n !== 0 ? ' corner' : ''}${m === i && n === j ? ' here' : ''}`,
        }),
      ),
    );
    return [
      ...regions,
      draw(view, a, { class: 'shape a', 'data-shape': 'a' }),
      draw(view, b, { class: 'shape b', 'data-shape': 'b' }),
      ...edges.map(([p, q]) => polygon(view, [all[p], all[q]], { class: 'feature' }, false)),
      ...vertices.map((p) =>
        draw(view, { kind: 'point', x: all[p][0], y: all[p][1] }, { class: 'feature vertex', r: 6 }),
      ),
      ...all.map((at, p) => text(view, at, 'ABCD'[p], { dx: 9, dy: -9 })),
    ];
  },
  tell(demo) {
    const { a, b } = demo.shapes,
      [i, j] = here(demo),
      { edges, vertices } = features(i, j),
      name = (p) => 'ABCD'[p];
    const tried =
      edges.length === 0
        ? 'the centre is in the rectangle: nothing to try'
        : `try ${edges.map(([p, q]) => `edge ${name(p)}${name(q)}`).join(', ')}; vertices ${vertices.map(name).join(', ')}`;
    return [
      ['Closest features', demo.methods.rectEllipseClosestFeatures(a, b), tried],
      ['All features', demo.methods.rectEllipseAllFeatures(a, b), 'four edges and four vertices'],
      demo.exact(a, b),
    ];
  },
};
