// SPDX-License-Identifier: Apache-2.0
// What one takes hold of: where the handles of a shape are, what dragging them and what keys do.
import { beside } from '../number.mjs';
import { isPath, withCorner, withoutCorner } from '../path.mjs';
import { form, middle, moved, numberOf, withNumber } from '../shape.mjs';

const step = 0.05; // of what is seen of the plane, for an arrow key
const turnStep = Math.PI / 180;

/** Of a shape with an axis: the first axis ends at a point. The axis becomes a unit vector. */
function axisTo(shape, [x, y], along, across) {
  const dx = x - shape.cx,
    dy = y - shape.cy,
    length = Math.hypot(dx, dy),
    unit = Math.hypot(shape.ux, shape.uy);
  if (!(length > 0)) return shape;
  return { ...shape, ux: dx / length, uy: dy / length, [along]: length, [across]: shape[across] * unit };
}

function turned(shape, angle) {
  const c = Math.cos(angle),
    s = Math.sin(angle);
  return { ...shape, ux: c * shape.ux - s * shape.uy, uy: s * shape.ux + c * shape.uy };
}

/** The half size across the axis, so that its side goes through a point. */
function across(shape, [x, y], field) {
  const { ux, uy } = shape,
    level = ((y - shape.cy) * ux - (x - shape.cx) * uy) / (ux * ux + uy * uy);
  return { ...shape, [field]: Math.abs(level) };
}

const move = (x, y) => ({ id: 'move', label: 'move', horizontal: x, vertical: y });
const place = (id, label, x, y) => ({
  id,
  label,
  horizontal: [x],
  vertical: [y],
  at: (s) => [s[x], s[y]],
  drag: (s, [px, py]) => ({ ...s, [x]: px, [y]: py }),
});

function turning(along, over) {
  return [
    move(['cx'], ['cy']),
    {
      id: 'along',
      label: 'turn and length',
      horizontal: [along],
      vertical: ['uy'],
      turns: true,
      at: (s) => [form(s).x + form(s).p[0], form(s).y + form(s).p[1]],
      drag: (s, to) => axisTo(s, to, along, over),
    },
    {
      id: 'across',
      label: 'width',
      horizontal: [over],
      vertical: [over],
      at: (s) => [form(s).x + form(s).q[0], form(s).y + form(s).q[1]],
      drag: (s, to) => across(s, to, over),
    },
  ];
}

const corner = (id, label, x, y, bound) => ({
  ...place(id, label, x, y),
  drag: (s, [px, py]) => ({
    ...s,
    [x]: bound(px, s[x.replace(/m../, id === 'low' ? 'max' : 'min')]),
    [y]: bound(py, s[y.replace(/m../, id === 'low' ? 'max' : 'min')]),
  }),
});

/** How far a point is from a shape's core. */
function fromCore(shape, [x, y]) {
  const { x: cx, y: cy, p, q } = form(shape);
  const beyond = ([px, py]) => {
    const half = Math.hypot(px, py);
    return half > 0 ? Math.max(Math.abs(((x - cx) * px + (y - cy) * py) / half) - half, 0) : null;
  };
  const along = beyond(p) ?? beyond([-q[1], q[0]]),
    across = beyond(q) ?? Math.abs((y - cy) * p[0] - (x - cx) * p[1]) / Math.hypot(...p);
  return along === null ? Math.hypot(x - cx, y - cy) : Math.hypot(along, across);
}

const rounding = (label, at) => ({
  id: 'radius',
  label,
  horizontal: ['r'],
  vertical: ['r'],
  at,
  drag: (s, to) => ({ ...s, r: fromCore(s, to) }),
});

/** Beside the middle of a capsule's core. */
function besideCore(s) {
  const { x, y, p } = form(s),
    half = Math.hypot(...p),
    n = half > 0 ? [-p[1] / half, p[0] / half] : [0, 1];
  return [x + s.r * n[0], y + s.r * n[1]];
}

/** The middle of a rounded corner. */
function atCorner(s) {
  const { x, y, p, q } = form(s),
    unit = Math.SQRT1_2 / Math.hypot(s.ux, s.uy);
  return [
    x + p[0] + q[0] + s.r * unit * (s.ux - s.uy),
    y + p[1] + q[1] + s.r * unit * (s.uy + s.ux),
  ];
}

const handles = {
  point: [move(['x'], ['y'])],
  segment: [
    move(['x0', 'x1'], ['y0', 'y1']),
    place('start', 'first end', 'x0', 'y0'),
    place('end', 'second end', 'x1', 'y1'),
  ],
  circle: [
    move(['cx'], ['cy']),
    {
      id: 'radius',
      label: 'radius',
      horizontal: ['r'],
      vertical: ['r'],
      at: (s) => [s.cx + s.r, s.cy],
      drag: (s, [x, y]) => ({ ...s, r: Math.hypot(x - s.cx, y - s.cy) }),
    },
  ],
  aabb: [
    move(['min_x', 'max_x'], ['min_y', 'max_y']),
    corner('low', 'lower left corner', 'min_x', 'min_y', Math.min),
    corner('high', 'upper right corner', 'max_x', 'max_y', Math.max),
  ],
  rect: turning('hx', 'hy'),
  ellipse: turning('a', 'b'),
  capsule: [
    move(['x0', 'x1'], ['y0', 'y1']),
    place('start', 'first end', 'x0', 'y0'),
    place('end', 'second end', 'x1', 'y1'),
    rounding('radius', besideCore),
  ],
  round_rect: [...turning('hx', 'hy'), rounding('corner radius', atCorner)],
};

/** All of a polygon, and each corner. */
function cornersOf(shape) {
  const names = (axis, count) => Array.from({ length: count }, (_, i) => `${axis}${i}`),
    count = shape.vertices.length / 2;
  return [
    move(names('x', count), names('y', count)),
    ...Array.from({ length: count }, (_, i) => ({
      id: `corner-${i}`,
      label: `corner ${i + 1}`,
      horizontal: [`x${i}`],
      vertical: [`y${i}`],
      at: (s) => [s.vertices[2 * i], s.vertices[2 * i + 1]],
      drag: (s, [x, y]) => withNumber(withNumber(s, `x${i}`, x), `y${i}`, y),
      remove: (s) => withoutCorner(s, i),
      add: (s) => withCorner(s, i),
    })),
  ];
}

/** { id, label, at(shape), drag(shape, to, from) } each; `from` is where the pointer was before. */
export const handlesOf = (shape) =>
  (isPath(shape) ? cornersOf(shape) : handles[shape.kind]).map((handle) => ({
    at: middle,
    drag: (s, to, from) => moved(s, to[0] - from[0], to[1] - from[1]),
    ...handle,
  }));

const arrows = {
  ArrowLeft: ['horizontal', -1],
  ArrowRight: ['horizontal', 1],
  ArrowUp: ['vertical', 1],
  ArrowDown: ['vertical', -1],
};

/** The shape after a key, or null if the key means nothing. With Shift, numbers change by one last-place unit. */
export function afterKey(shape, handle, event, unit) {
  const [way, sign] = arrows[event.key] ?? [];
  if (event.key === 'Delete' || event.key === 'Backspace') return handle.remove?.(shape) ?? null;
  if (event.key === 'Insert' || event.key === '+') return handle.add?.(shape) ?? null;
  if (way === undefined || event.ctrlKey || event.altKey || event.metaKey) return null;
  if (handle.turns && way === 'vertical' && !event.shiftKey) return turned(shape, sign * turnStep);
  const change = event.shiftKey ? (x) => beside(x, sign) : (x) => x + sign * step * unit;
  return handle[way].reduce((s, name) => withNumber(s, name, change(numberOf(shape, name))), shape);
}
