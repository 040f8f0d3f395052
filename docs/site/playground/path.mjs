// SPDX-License-Identifier: Apache-2.0
// Polygons and polylines: { kind, vertices, rings }, vertices x y x y ... and where each ring begins, with the end.

export const isPath = ({ kind }) => kind === 'polygon' || kind === 'polyline';

/** Where rings begin among the vertices, with the end. */
const ends = (shape) => shape.rings ?? [0, shape.vertices.length / 2];

/** The rings, or chains, as points in order. */
export function rings(shape) {
  const of = ends(shape),
    at = (i) => [shape.vertices[2 * i], shape.vertices[2 * i + 1]];
  return of.slice(1).map((end, j) => Array.from({ length: end - of[j] }, (_, i) => at(of[j] + i)));
}

const made = (kind, lists) => ({
  kind,
  vertices: lists.flat(2),
  rings: lists.reduce((all, list) => [...all, all.at(-1) + list.length], [0]),
});

/** Left, right, low, high. */
export function sides({ vertices }) {
  const of = (axis) => vertices.filter((_, i) => i % 2 === axis);
  return [0, 1].flatMap((axis) => [Math.min(...of(axis)), Math.max(...of(axis))]);
}

/** The middle of the corners of the first ring. */
export function middleOf(shape) {
  const [ring] = rings(shape);
  return [0, 1].map((axis) => ring.reduce((sum, point) => sum + point[axis] / ring.length, 0));
}

export const shifted = (shape, dx, dy) => ({ ...shape, vertices: shape.vertices.map((v, i) => v + (i % 2 ? dy : dx)) });

/** Turned about a point. */
export function turnedAbout(shape, [x, y], angle) {
  const c = Math.cos(angle),
    s = Math.sin(angle);
  const lists = rings(shape).map((ring) =>
    ring.map(([px, py]) => [x + c * (px - x) - s * (py - y), y + s * (px - x) + c * (py - y)]),
  );
  return made(shape.kind, lists);
}

const square = (size) => [
  [-size, -size],
  [size, -size],
  [size, size],
  [-size, size],
];
// In units of a box's half axes.
const samples = {
  triangle: [[[-1, -1], [1, -1], [0.2, 1]]],
  quad: [[[-1, -1], [1, -0.7], [0.8, 1], [-0.7, 0.8]]],
  polygon: [[[-1, -1], [1, -1], [1, 1], [0.2, 0.45], [-0.8, 0.9]]],
  frame: [square(1), square(0.45)],
  polyline: [[[-1, -0.7], [-0.3, 0.8], [0.3, -0.6], [1, 0.8]]],
};

/** A polygon or polyline of that sort in the place of a box with axis u. */
export function bent(sort, x, y, [ux, uy], a, b) {
  const at = ([s, t]) => [x + s * a * ux - t * b * uy, y + s * a * uy + t * b * ux];
  return made(
    sort === 'polyline' ? sort : 'polygon',
    samples[sort].map((ring) => ring.map(at)),
  );
}

// ---- Corners ----

/** Which ring a corner is in, and its place there. */
function placeOf(shape, i) {
  const of = ends(shape),
    j = of.findIndex((end) => end > i) - 1;
  return [j, i - of[j]];
}

const withRing = (shape, j, ring) => made(shape.kind, rings(shape).flatMap((old, k) => (k === j ? ring : [old])));

/** Without a corner; a hole's third last takes the hole away. null if it would be no such shape any more. */
export function withoutCorner(shape, i) {
  const [j, at] = placeOf(shape, i),
    ring = rings(shape)[j],
    least = shape.kind === 'polygon' ? 3 : 2;
  if (ring.length > least) return withRing(shape, j, [ring.toSpliced(at, 1)]);
  return rings(shape).length > 1 ? withRing(shape, j, []) : null;
}

/** With a corner more, on the way from one to the next; by default in its middle. */
export function withCorner(shape, i, point) {
  const [j, at] = placeOf(shape, i),
    ring = rings(shape)[j],
    next = ring[(at + 1) % ring.length];
  const middle = [0, 1].map((axis) => ring[at][axis] / 2 + next[axis] / 2);
  return withRing(shape, j, [ring.toSpliced(at + 1, 0, point ?? middle)]);
}

/** The corner after which the edge nearest to a point begins. */
export function edgeNear(shape, [x, y]) {
  let best = 0,
    least = Infinity,
    i = 0;
  for (const ring of rings(shape)) {
    ring.forEach(([px, py], k) => {
      const last = k + 1 === ring.length;
      if (!last || shape.kind === 'polygon') {
        const [qx, qy] = ring[last ? 0 : k + 1],
          square = (qx - px) ** 2 + (qy - py) ** 2,
          t = Math.max(0, Math.min(1, ((x - px) * (qx - px) + (y - py) * (qy - py)) / square || 0));
        const distance = Math.hypot(x - px - t * (qx - px), y - py - t * (qy - py));
        if (distance < least) [best, least] = [i, distance];
      }
      ++i;
    });
  }
  return best;
}
