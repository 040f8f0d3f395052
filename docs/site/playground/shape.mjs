// SPDX-License-Identifier: Apache-2.0
// Shapes as outlines to draw, and as the two forms that formulas use: boxes and ellipses.
import { fields } from '../vesica/vesica.mjs';

export const nameOf = {
  point: 'point',
  segment: 'segment',
  circle: 'circle',
  aabb: 'box',
  rect: 'rectangle',
  ellipse: 'ellipse',
};

/** The kinds that the playground draws. */
export const kinds = Object.keys(nameOf);

export const numbers = (shape) => fields[shape.kind].map((name) => shape[name]);
export const withNumbers = (kind, values) => ({
  kind,
  ...Object.fromEntries(fields[kind].map((name, i) => [name, values[i]])),
});
export const isRound = (shape) => shape.kind === 'circle' || shape.kind === 'ellipse';

/** The centre, and two half axes as vectors: a box is all C + s P + t Q with |s|, |t| <= 1. */
export function form(shape) {
  switch (shape.kind) {
    case 'point':
      return { x: shape.x, y: shape.y, p: [0, 0], q: [0, 0] };
    case 'segment': {
      const { x0, y0, x1, y1 } = shape;
      return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, p: [(x1 - x0) / 2, (y1 - y0) / 2], q: [0, 0] };
    }
    case 'circle':
      return { x: shape.cx, y: shape.cy, p: [shape.r, 0], q: [0, shape.r] };
    case 'aabb': {
      const { min_x, min_y, max_x, max_y } = shape;
      return {
        x: (min_x + max_x) / 2,
        y: (min_y + max_y) / 2,
        p: [(max_x - min_x) / 2, 0],
        q: [0, (max_y - min_y) / 2],
      };
    }
    default: {
      const { cx, cy, ux, uy } = shape,
        [a, b] = shape.kind === 'rect' ? [shape.hx, shape.hy] : [shape.a, shape.b];
      return { x: cx, y: cy, p: [a * ux, a * uy], q: [-b * uy, b * ux] };
    }
  }
}

const corner = ({ x, y, p, q }, s, t) => [x + s * p[0] + t * q[0], y + s * p[1] + t * q[1]];

/** Corners in the order of C - P - Q, C + P - Q, C + P + Q, C - P + Q. */
export function corners(shape) {
  const f = form(shape);
  return [corner(f, -1, -1), corner(f, 1, -1), corner(f, 1, 1), corner(f, -1, 1)];
}

/** The point of a round shape's outline at an angle. */
export const atAngle = (shape, t) => corner(form(shape), Math.cos(t), Math.sin(t));

/** The outline as points in order. */
export function outline(shape, count = 96) {
  if (!isRound(shape)) return corners(shape);
  return Array.from({ length: count }, (_, i) => atAngle(shape, (2 * Math.PI * i) / count));
}

/** Half the width and half the height of the box around a shape. */
export function reach(shape) {
  const { p, q } = form(shape),
    join = isRound(shape) ? Math.hypot : (a, b) => Math.abs(a) + Math.abs(b);
  return [join(p[0], q[0]), join(p[1], q[1])];
}

/** Shapes that mean about the same in another kind: centre, size and turn stay where the kind has them. */
export function asKind(shape, kind) {
  const { x, y, p, q } = form(shape);
  const a = Math.hypot(...p) || 1,
    b = Math.hypot(...q) || a / 2,
    u = Math.hypot(...p) > 0 ? [p[0] / a, p[1] / a] : [1, 0];
  return {
    point: () => withNumbers('point', [x, y]),
    segment: () => withNumbers('segment', [x - a * u[0], y - a * u[1], x + a * u[0], y + a * u[1]]),
    circle: () => withNumbers('circle', [x, y, a]),
    aabb: () => withNumbers('aabb', [x - a, y - b, x + a, y + b]),
    rect: () => withNumbers('rect', [x, y, ...u, a, b]),
    ellipse: () => withNumbers('ellipse', [x, y, ...u, a, b]),
  }[kind]();
}

/** The shape with every point moved. */
export function moved(shape, dx, dy) {
  const shift = {
    x: dx,
    cx: dx,
    x0: dx,
    x1: dx,
    min_x: dx,
    max_x: dx,
    y: dy,
    cy: dy,
    y0: dy,
    y1: dy,
    min_y: dy,
    max_y: dy,
  };
  return withNumbers(
    shape.kind,
    fields[shape.kind].map((name) => shape[name] + (shift[name] ?? 0)),
  );
}
