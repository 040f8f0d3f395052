// SPDX-License-Identifier: Apache-2.0
// Polygons inside and around an ellipse, ever finer, until one of them decides; and the same with arcs of circles.
import { circle, ellipse } from '../../vesica/vesica.mjs';
import { choice, slider } from '../element.mjs';
import { short } from '../number.mjs';
import { draw, grid, polygon } from '../plane.mjs';
import { form } from '../shape.mjs';

const most = 12;
const names = {
  circleEllipsePolygonalSandwich: 'Polygonal sandwich',
  circleEllipseCircleApproximation: 'Circle approximation',
};

/** Corners on the outline, and where the tangents there meet. */
function polygons(shape, n) {
  const sides = 4 * 2 ** n,
    step = (2 * Math.PI) / sides,
    f = form(shape);
  const at = (t, grow) => [
    f.x + grow * (Math.cos(t) * f.p[0] + Math.sin(t) * f.q[0]),
    f.y + grow * (Math.cos(t) * f.p[1] + Math.sin(t) * f.q[1]),
  ];
  const all = Array.from({ length: sides }, (_, i) => i);
  return {
    inner: all.map((i) => at(i * step, 1)),
    outer: all.map((i) => at((i + 0.5) * step, 1 / Math.cos(step / 2))),
  };
}

export const polygonalSandwich = {
  id: 'sandwich',
  title: 'Polygonal sandwich, circle approximation',
  seed: 'Olli Niemitalo, Ellipse–circle and ellipse–ellipse collision detection (2012).',
  idea: 'A circle that reaches the inner polygon overlaps the ellipse; one that misses the outer polygon does not; between them nobody knows, and n more halvings may tell. Out of iterations print says no. Here the answer is uncertain, with the bound on the error that was reached.',
  shapes: { a: ellipse(-0.3, -0.2, 2, 1.1), b: circle(1.706, 0.912, 0.6) },
  controls(demo) {
    Object.assign(demo, { n: 1, method: 'circleEllipsePolygonalSandwich' });
    return [
      choice('sandwich-method', 'Method', Object.entries(names), demo.method, (method) => {
        demo.method = method;
        demo.show();
      }),
      slider(
        'sandwich-n',
        'Iterations n',
        { min: 0, max: most, value: demo.n },
        (n) => `${n}: ${4 * 2 ** n} sides`,
        (n) => {
          demo.n = n;
          demo.show();
        },
      ),
    ];
  },
  draw(demo) {
    const { a, b } = demo.shapes,
      { view } = demo.stage,
      { inner, outer } = polygons(a, Math.min(demo.n, 7));
    return [
      grid(view),
      polygon(view, outer, { class: 'outer' }),
      polygon(view, inner, { class: 'inner' }),
      draw(view, a, { class: 'plain', 'data-shape': 'a' }),
      draw(view, b, { class: 'shape b', 'data-shape': 'b' }),
    ];
  },
  tell(demo) {
    const { a, b } = demo.shapes,
      found = demo.methods[demo.method](b, a, demo.n);
    return [
      [
        `${names[demo.method]}, n = ${demo.n}`,
        found.answer,
        `${found.iterations} iterations done; the outline's error is below ${short(found.outlineError, 4)}`,
      ],
      [
        'As printed, out of iterations',
        found.answer === 'uncertain' ? 'no' : found.answer,
        'print has no third answer',
      ],
      ['Closed form', demo.methods.circleEllipseClosedForm(b, a), 'the root of a quartic, in rounded arithmetic'],
      demo.exact(a, b),
    ];
  },
};
