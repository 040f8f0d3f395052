// SPDX-License-Identifier: Apache-2.0
// Shapes as outlines to draw, and as the forms that formulas use: boxes, ellipses, and boxes with a radius.
import { fields, rect } from '../vesica/vesica.mjs';
import { bent, isPath, middleOf, rings, shifted, sides } from './path.mjs';

export const nameOf = {
  point: 'point',
  segment: 'segment',
  circle: 'circle',
  aabb: 'box',
  rect: 'rectangle',
  ellipse: 'ellipse',
  capsule: 'capsule',
  round_rect: 'rounded rectangle',
  polygon: 'polygon',
  polyline: 'polyline',
};

/** The kinds that the playground draws. */
export const kinds = Object.keys(nameOf);

/** What one chooses from: kinds, and polygons of several sorts. */
const { polygon, polyline, ...others } = nameOf;
export const choices = {
  ...others,
  triangle: 'triangle',
  quad: 'quadrilateral',
  polygon,
  frame: 'polygon with a hole',
  polyline,
};

/** Which of the choices a shape is. */
export function choiceOf(shape) {
  if (shape.kind !== 'polygon') return shape.kind;
  if (rings(shape).length > 1) return 'frame';
  return { 6: 'triangle', 8: 'quad' }[shape.vertices.length] ?? 'polygon';
}

/** The names of its numbers, one of them, and the shape with another one. */
export const fieldsOf = (shape) =>
  isPath(shape) ? shape.vertices.map((_, i) => `${'xy'[i % 2]}${i >> 1}`) : fields[shape.kind];
const place = (field) => 2 * Number(field.slice(1)) + 'xy'.indexOf(field[0]);
export const numberOf = (shape, field) => (isPath(shape) ? shape.vertices[place(field)] : shape[field]);
export const withNumber = (shape, field, value) =>
  isPath(shape) ? { ...shape, vertices: shape.vertices.with(place(field), value) } : { ...shape, [field]: value };

/** What a number of a shape is. */
const words = {
  x0: 'first end x',
  y0: 'first end y',
  x1: 'second end x',
  y1: 'second end y',
  cx: 'centre x',
  cy: 'centre y',
  r: 'radius',
  min_x: 'left',
  min_y: 'bottom',
  max_x: 'right',
  max_y: 'top',
  ux: 'axis x',
  uy: 'axis y',
  hx: 'half length',
  hy: 'half width',
  a: 'half axis along',
  b: 'half axis across',
};
export const wordsOf = (shape, field) => (isPath(shape) ? field : (words[field] ?? field));

/** The axis of a shape that has one, in degrees, else null; and the shape turned to an angle. */
export const angleOf = (shape) => ('ux' in shape ? (Math.atan2(shape.uy, shape.ux) * 180) / Math.PI : null);
export function withAngle(shape, degrees) {
  const { ux, uy } = rect(0, 0, 1, 1, degrees, { degrees: true });
  return { ...shape, ux, uy };
}

export const numbers = (shape) => (isPath(shape) ? shape.vertices : fields[shape.kind].map((name) => shape[name]));
export const withNumbers = (kind, values) => ({
  kind,
  ...Object.fromEntries(fields[kind].map((name, i) => [name, values[i]])),
});
export const isRound = (shape) => shape.kind === 'circle' || shape.kind === 'ellipse';
/** The radius about a core: of a capsule or a rounded rectangle; 0 of others. */
export const radius = (shape) => (shape.kind === 'capsule' || shape.kind === 'round_rect' ? shape.r : 0);

/** The centre, and two half axes as vectors: a box is all C + s P + t Q with |s|, |t| <= 1. Of the core, without its radius. */
export function form(shape) {
  if (isPath(shape)) {
    const [left, right, low, high] = sides(shape);
    return {
      x: left / 2 + right / 2,
      y: low / 2 + high / 2,
      p: [right / 2 - left / 2, 0],
      q: [0, high / 2 - low / 2],
    };
  }
  switch (shape.kind) {
    case 'point':
      return { x: shape.x, y: shape.y, p: [0, 0], q: [0, 0] };
    case 'segment':
    case 'capsule': {
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
        [a, b] = shape.kind === 'ellipse' ? [shape.a, shape.b] : [shape.hx, shape.hy];
      return { x: cx, y: cy, p: [a * ux, a * uy], q: [-b * uy, b * ux] };
    }
  }
}

const corner = ({ x, y, p, q }, s, t) => [x + s * p[0] + t * q[0], y + s * p[1] + t * q[1]];

/** Corners, of the core, in the order of C - P - Q, C + P - Q, C + P + Q, C - P + Q. */
export function corners(shape) {
  const f = form(shape);
  return [corner(f, -1, -1), corner(f, 1, -1), corner(f, 1, 1), corner(f, -1, 1)];
}

/** The point of a round shape's outline at an angle. */
export const atAngle = (shape, t) => corner(form(shape), Math.cos(t), Math.sin(t));

/** The point of a shape with a radius that is farthest along an angle. */
function farthest(shape, t) {
  const f = form(shape),
    r = radius(shape),
    n = [Math.cos(t), Math.sin(t)],
    side = (v) => (v[0] * n[0] + v[1] * n[1] < 0 ? -1 : 1);
  const [x, y] = corner(f, side(f.p), side(f.q));
  return [x + r * n[0], y + r * n[1]];
}

/** A point to hold it by: the centre, or of a polygon the middle of its corners. */
export function middle(shape) {
  if (isPath(shape)) return middleOf(shape);
  const { x, y } = form(shape);
  return [x, y];
}

/** Outlines, closed or not, as points in order. */
export const outlines = (shape) => (isPath(shape) ? rings(shape) : [outline(shape)]);

/** The outline as points in order. */
export function outline(shape, count = 96) {
  if (radius(shape) > 0)
    return Array.from({ length: 2 * count }, (_, i) => farthest(shape, (Math.PI * (i + 0.5)) / count));
  if (!isRound(shape)) return corners(shape);
  return Array.from({ length: count }, (_, i) => atAngle(shape, (2 * Math.PI * i) / count));
}

/** Half the width and half the height of the box around a shape. */
export function reach(shape) {
  const { p, q } = form(shape),
    join = isRound(shape) ? Math.hypot : (a, b) => Math.abs(a) + Math.abs(b);
  return [join(p[0], q[0]) + radius(shape), join(p[1], q[1]) + radius(shape)];
}

/** Shapes that mean about the same in another kind: centre, size and turn stay where the kind has them. */
export function asKind(shape, kind) {
  const { x, y, p, q } = form(shape);
  const a = Math.hypot(...p) + radius(shape) || 1,
    b = Math.hypot(...q) + radius(shape) || a / 2,
    length = Math.hypot(...p),
    end = a - Math.min(b, a / 2),
    r = Math.min(a, b) / 3,
    u = length > 0 ? [p[0] / length, p[1] / length] : [1, 0];
  return {
    point: () => withNumbers('point', [x, y]),
    segment: () => withNumbers('segment', [x - a * u[0], y - a * u[1], x + a * u[0], y + a * u[1]]),
    circle: () => withNumbers('circle', [x, y, a]),
    aabb: () => withNumbers('aabb', [x - a, y - b, x + a, y + b]),
    rect: () => withNumbers('rect', [x, y, ...u, a, b]),
    ellipse: () => withNumbers('ellipse', [x, y, ...u, a, b]),
    capsule: () => withNumbers('capsule', [x - end * u[0], y - end * u[1], x + end * u[0], y + end * u[1], a - end]),
    round_rect: () => withNumbers('round_rect', [x, y, ...u, a - r, b - r, r]),
  }[kind]?.() ?? bent(kind, x, y, u, a, b);
}

/** The shape with every point moved. */
export function moved(shape, dx, dy) {
  if (isPath(shape)) return shifted(shape, dx, dy);
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
