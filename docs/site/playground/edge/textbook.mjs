// SPDX-License-Identifier: Apache-2.0
// Overlap as textbooks have it: right formulas in rounded arithmetic, without a bound on the error. Double or float.
import { isPath, rings } from '../path.mjs';

/** Arithmetic that rounds to a type after each operation, as a program in that type does. */
const rounding = (round) => ({
  of: round,
  add: (x, y) => round(x + y),
  sub: (x, y) => round(x - y),
  mul: (x, y) => round(x * y),
  div: (x, y) => round(x / y),
  root: (x) => round(Math.sqrt(x)),
});
export const double = rounding((x) => x);
export const float = rounding(Math.fround);

const dot = (m, [ax, ay], [bx, by]) => m.add(m.mul(ax, bx), m.mul(ay, by));
const cross = (m, [ax, ay], [bx, by]) => m.sub(m.mul(ax, by), m.mul(ay, bx));
const minus = (m, [ax, ay], [bx, by]) => [m.sub(ax, bx), m.sub(ay, by)];
const times = (m, s, [x, y]) => [m.mul(s, x), m.mul(s, y)];

/** Centre and half axes p, q in the type's own numbers. */
function form(m, shape) {
  const n = Object.fromEntries(
    Object.entries(shape)
      .filter(([name]) => name !== 'kind')
      .map(([name, x]) => [name, m.of(x)]),
  );
  const half = (x, y) => m.mul(0.5, m.sub(y, x)),
    middle = (x, y) => m.mul(0.5, m.add(x, y));
  switch (shape.kind) {
    case 'point':
      return { c: [n.x, n.y], p: [0, 0], q: [0, 0] };
    case 'segment':
      return { c: [middle(n.x0, n.x1), middle(n.y0, n.y1)], p: [half(n.x0, n.x1), half(n.y0, n.y1)], q: [0, 0] };
    case 'circle':
      return { c: [n.cx, n.cy], p: [n.r, 0], q: [0, n.r], r: n.r };
    case 'aabb':
      return {
        c: [middle(n.min_x, n.max_x), middle(n.min_y, n.max_y)],
        p: [half(n.min_x, n.max_x), 0],
        q: [0, half(n.min_y, n.max_y)],
      };
    case 'capsule':
      return {
        c: [middle(n.x0, n.x1), middle(n.y0, n.y1)],
        p: [half(n.x0, n.x1), half(n.y0, n.y1)],
        q: [0, 0],
        r: n.r,
      };
    case 'rect':
    case 'round_rect':
      return { c: [n.cx, n.cy], p: times(m, n.hx, [n.ux, n.uy]), q: times(m, n.hy, [-n.uy, n.ux]), r: n.r ?? 0 };
    default:
      return { c: [n.cx, n.cy], p: times(m, n.a, [n.ux, n.uy]), q: times(m, n.b, [-n.uy, n.ux]) };
  }
}

/** Separating axes: those of both boxes, and for boxes without a width the directions across and between. */
function boxes(m, a, b) {
  const d = minus(m, b.c, a.c),
    perp = ([x, y]) => [-y, x];
  const axes = [a.p, a.q, b.p, b.q, perp(a.p), perp(b.p), d].filter(([x, y]) => x !== 0 || y !== 0);
  const reach = (box, axis) => m.add(Math.abs(dot(m, box.p, axis)), Math.abs(dot(m, box.q, axis)));
  return axes.every((axis) => Math.abs(dot(m, d, axis)) <= m.add(reach(a, axis), reach(b, axis)));
}

/** A point as the ellipse sees it: where the ellipse is the unit disc about 0. */
function toDisc(m, { p, q }) {
  const det = cross(m, p, q);
  return (v) => [m.div(cross(m, v, q), det), m.div(cross(m, p, v), det)];
}

/** The box in the measure of the ellipse: does a side come within 1 of the centre, or does it hold the centre? */
function boxAndEllipse(m, box, ellipse) {
  const seen = toDisc(m, ellipse),
    at = minus(m, box.c, ellipse.c);
  const corner = (s, t) =>
    seen([
      m.add(at[0], m.add(m.mul(s, box.p[0]), m.mul(t, box.q[0]))),
      m.add(at[1], m.add(m.mul(s, box.p[1]), m.mul(t, box.q[1]))),
    ]);
  const corners = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
  const turns = corners.map((here, i) => cross(m, minus(m, corners[(i + 1) % 4], here), times(m, -1, here)));
  const flat = turns.every((turn) => turn === 0);
  if (!flat && (turns.every((turn) => turn >= 0) || turns.every((turn) => turn <= 0))) return true;
  return corners.some((here, i) => {
    const side = minus(m, corners[(i + 1) % 4], here),
      length = dot(m, side, side);
    const t = length === 0 ? 0 : Math.min(1, Math.max(0, m.div(m.mul(-1, dot(m, here, side)), length)));
    const nearest = [m.add(here[0], m.mul(t, side[0])), m.add(here[1], m.mul(t, side[1]))];
    return dot(m, nearest, nearest) <= 1;
  });
}

/** The squared distance from 0 to a solid ellipse: the nearest point of the outline is a root, found by halving. */
function squaredDistance(m, { c, p, q }) {
  // Half axes at right angles: the eigenvectors of P P' + Q Q'.
  const xx = m.add(m.mul(p[0], p[0]), m.mul(q[0], q[0])),
    yy = m.add(m.mul(p[1], p[1]), m.mul(q[1], q[1]));
  const xy = m.add(m.mul(p[0], p[1]), m.mul(q[0], q[1])),
    h = m.mul(0.5, m.sub(xx, yy)),
    s = m.mul(0.5, m.add(xx, yy));
  const root = m.root(m.add(m.mul(h, h), m.mul(xy, xy)));
  const large = m.add(s, root),
    small = Math.max(0, m.sub(s, root));
  let axis = h >= 0 ? [m.add(h, root), xy] : [xy, m.sub(root, h)];
  const length = m.root(dot(m, axis, axis));
  axis = length === 0 ? [1, 0] : [m.div(axis[0], length), m.div(axis[1], length)];
  const x = Math.abs(dot(m, c, axis)),
    y = Math.abs(cross(m, axis, c));
  const level = (t) => {
    const u = m.div(m.mul(m.root(large), x), m.add(large, t)),
      v = m.div(m.mul(m.root(small), y), m.add(small, t));
    return m.sub(m.add(m.mul(u, u), m.mul(v, v)), 1);
  };
  if (!(level(0) > 0)) return 0;
  let low = 0,
    high = m.add(m.mul(m.root(large), x), m.mul(m.root(small), y));
  for (let i = 0; i < 80; ++i) {
    const t = m.mul(0.5, m.add(low, high));
    if (level(t) > 0) low = t;
    else high = t;
  }
  const dx = m.mul(high, m.div(x, m.add(large, high))),
    dy = m.mul(high, m.div(y, m.add(small, high)));
  return m.add(m.mul(dx, dx), m.mul(dy, dy));
}

function ellipses(m, a, b) {
  const d = minus(m, b.c, a.c);
  if (a.r !== undefined && b.r !== undefined) return dot(m, d, d) <= m.mul(m.add(a.r, b.r), m.add(a.r, b.r));
  if (b.r !== undefined) return squaredDistance(m, { ...a, c: minus(m, a.c, b.c) }) <= m.mul(b.r, b.r);
  if (a.r !== undefined) return squaredDistance(m, { ...b, c: d }) <= m.mul(a.r, a.r);
  const seen = toDisc(m, a);
  return squaredDistance(m, { c: seen(d), p: seen(b.p), q: seen(b.q) }) <= 1;
}

const corners = (m, { c, p, q }) => {
  const plus = ([ax, ay], [bx, by]) => [m.add(ax, bx), m.add(ay, by)];
  return [
    minus(m, minus(m, c, p), q),
    minus(m, plus(c, p), q),
    plus(plus(c, p), q),
    plus(minus(m, c, p), q),
  ];
};
const edges = (m, box) => corners(m, box).map((from, i, all) => [from, all[(i + 1) % 4]]);

/** The squared distance of a point from the segment between two others. */
function fromEdge(m, x, [from, to]) {
  const edge = minus(m, to, from),
    square = dot(m, edge, edge),
    share = square > 0 ? Math.max(0, Math.min(1, m.div(dot(m, minus(m, x, from), edge), square))) : 0;
  const d = minus(m, minus(m, x, from), times(m, share, edge));
  return dot(m, d, d);
}

/** Two boxes with radii: by the distance of the boxes. */
function boxesWithRadii(m, a, b) {
  if (boxes(m, a, b)) return true;
  const toward = (x, y) => corners(m, x).flatMap((at) => edges(m, y).map((edge) => fromEdge(m, at, edge)));
  const sum = m.add(a.r ?? 0, b.r ?? 0);
  return Math.min(...toward(a, b), ...toward(b, a)) <= m.mul(sum, sum);
}

/** A box with a radius and an ellipse: the least distance of the ellipse from a point that moves along an edge. */
function boxWithRadiusAndEllipse(m, box, ellipse) {
  if (boxAndEllipse(m, box, ellipse)) return true;
  const square = m.mul(box.r, box.r);
  return edges(m, box).some(([from, to]) => {
    const edge = minus(m, to, from);
    const at = (share) => {
      const c = minus(m, minus(m, ellipse.c, from), times(m, share, edge));
      return squaredDistance(m, { ...ellipse, c });
    };
    let low = 0,
      high = 1;
    for (let i = 0; i < 40; ++i) {
      const third = m.div(m.sub(high, low), 3),
        x = m.add(low, third),
        y = m.sub(high, third);
      if (at(x) < at(y)) high = y;
      else low = x;
    }
    return Math.min(at(0), at(low), at(1)) <= square;
  });
}

const isInflated = (kind) => kind === 'capsule' || kind === 'round_rect';
/** A circle is a point with a radius. */
const core = (kind, f) => (kind === 'circle' ? { ...f, p: [0, 0], q: [0, 0] } : f);

/** The edges of a polygon or a polyline, each a segment. */
const edgesOf = (path) =>
  rings(path).flatMap((ring) =>
    ring.slice(path.kind === 'polygon' ? 0 : 1).map(([x1, y1], i) => {
      const [x0, y0] = ring.at(path.kind === 'polygon' ? i - 1 : i);
      return { kind: 'segment', x0, y0, x1, y1 };
    }),
  );

/** The even-odd rule: how many edges are to the right. */
function isInside(m, polygon, [x, y]) {
  let inside = false;
  for (const edge of edgesOf(polygon)) {
    const [x0, y0, x1, y1] = [edge.x0, edge.y0, edge.x1, edge.y1].map(m.of);
    if (y0 > y === y1 > y) continue;
    if (x < m.add(x0, m.div(m.mul(m.sub(y, y0), m.sub(x1, x0)), m.sub(y1, y0)))) inside = !inside;
  }
  return inside;
}

/** Does an edge meet the shape, or is a point of it inside? */
function pathAnd(m, path, shape) {
  if (edgesOf(path).some((edge) => overlap(m, edge, shape))) return true;
  const point = isPath(shape) ? rings(shape)[0][0].map(m.of) : form(m, shape).c;
  return path.kind === 'polygon' && isInside(m, path, point);
}

/** Do two shapes overlap, as far as arithmetic m can tell? */
export function overlap(m, a, b) {
  if (isPath(a)) return pathAnd(m, a, b);
  if (isPath(b)) return pathAnd(m, b, a);
  const isRound = ({ kind }) => kind === 'circle' || kind === 'ellipse',
    fa = form(m, a),
    fb = form(m, b);
  if (isInflated(a.kind) || isInflated(b.kind)) {
    if (a.kind === 'ellipse') return boxWithRadiusAndEllipse(m, fb, fa);
    if (b.kind === 'ellipse') return boxWithRadiusAndEllipse(m, fa, fb);
    return boxesWithRadii(m, core(a.kind, fa), core(b.kind, fb));
  }
  if (isRound(a) && isRound(b)) return ellipses(m, fa, fb);
  if (isRound(b)) return boxAndEllipse(m, fa, fb);
  if (isRound(a)) return boxAndEllipse(m, fb, fa);
  return boxes(m, fa, fb);
}

/** In words, what overlap() does with two kinds. */
export function recipe(a, b) {
  if (isPath({ kind: a }) || isPath({ kind: b })) return 'each edge as a segment, and the even-odd rule';
  const isRound = (kind) => kind === 'circle' || kind === 'ellipse';
  if (isInflated(a) || isInflated(b)) {
    return a === 'ellipse' || b === 'ellipse'
      ? 'the ellipse’s least distance along each edge, found by thirds'
      : 'the squared distance of corners and edges against the squared sum of radii';
  }
  if (!isRound(a) && !isRound(b)) return 'separating axes';
  if (!isRound(a) || !isRound(b)) return 'the box’s nearest side in the ellipse’s measure';
  if (a === 'circle' && b === 'circle') return 'squared distance against the squared sum of radii';
  return 'the ellipse’s nearest point, as a root found by halving';
}
