// SPDX-License-Identifier: Apache-2.0
// Gradient descent on the landscape of distances between two outlines, over an angle on each.
import { ellipse } from '../../vesica/vesica.mjs';
import { choice, html, slider } from '../element.mjs';
import { short } from '../number.mjs';
import { dot, draw, grid, polygon } from '../plane.mjs';
import { atAngle } from '../shape.mjs';

const steps = 150; // that are drawn
const size = 240; // of the landscape in pixels

/** Distances at each pair of angles as shades: dark is near. */
function landscape(context, a, b) {
  const coarse = 80,
    points = (shape) =>
      Array.from({ length: coarse }, (_, i) => atAngle(shape, (2 * Math.PI * (i + 0.5)) / coarse - Math.PI));
  const [of_a, of_b] = [points(a), points(b)],
    levels = of_b.map(([x, y]) => of_a.map(([z, w]) => Math.hypot(x - z, y - w)));
  const low = Math.min(...levels.flat()),
    high = Math.max(...levels.flat());
  levels.forEach((row, j) =>
    row.forEach((level, i) => {
      const t = (level - low) / (high - low || 1),
        band = Math.floor(t * 18) % 2;
      context.fillStyle = `hsl(${220 + 60 * t} 45% ${18 + 60 * t + 4 * band}%)`;
      context.fillRect((i * size) / coarse, size - ((j + 1) * size) / coarse, size / coarse + 1, size / coarse + 1);
    }),
  );
}

/** Where the descent is after each step: by asking for 1, 2, 3 ... iterations. */
function walk(demo) {
  const { a, b } = demo.shapes,
    path = [];
  for (let iterations = 1; iterations <= steps; ++iterations) {
    const at = demo.methods.ellipseEllipseDistanceGradientDescent(a, b, { ...demo.settings, iterations });
    path.push([at.angleA, at.angleB]);
    if (at.success) break;
  }
  return path;
}

function drawWalk(context, path) {
  const at = ([t, u]) => [((t + Math.PI) / (2 * Math.PI)) * size, size - ((u + Math.PI) / (2 * Math.PI)) * size];
  context.strokeStyle = '#ffd24a';
  context.lineWidth = 2;
  context.beginPath();
  path.forEach((angles, i) => {
    const jump = i > 0 && angles.some((t, k) => Math.abs(t - path[i - 1][k]) > Math.PI); // round the edge
    context[i === 0 || jump ? 'moveTo' : 'lineTo'](...at(angles));
  });
  context.stroke();
  for (const [angles, colour] of [
    [path[0], '#ff5a5f'],
    [path.at(-1), '#5be08f'],
  ]) {
    context.fillStyle = colour;
    context.beginPath();
    context.arc(...at(angles), 5, 0, 2 * Math.PI);
    context.fill();
  }
}

const set = (demo, name) => (value) => {
  demo.settings = { ...demo.settings, [name]: value };
  demo.show();
};

export const gradientDescent = {
  id: 'descent',
  title: 'Gradient descent',
  seed: 'Minimum Distance Between Ellipses (2021).',
  idea: 'The distance of two points, one on each outline, is a landscape over two angles. Walk down it from the line of centres. Printed steps are a rate times the gradient, which fits shapes of one size only; here they are scaled to the pair.',
  shapes: {
    a: ellipse(-1.4, -0.5, 2, 0.5, 60, { degrees: true }),
    b: ellipse(1.2, 0.6, 2, 0.4, 75, { degrees: true }),
  },
  controls(demo) {
    demo.settings = { schedule: 'scale-aware', rate: 1, decay: 0 };
    return [
      choice(
        'descent-schedule',
        'Steps',
        [
          ['scale-aware', 'scaled to the pair'],
          ['literal', 'as printed'],
        ],
        'scale-aware',
        set(demo, 'schedule'),
      ),
      slider(
        'descent-rate',
        'Rate',
        { min: 0.02, max: 1.9, step: 0.02, value: 1 },
        (x) => x.toFixed(2),
        set(demo, 'rate'),
      ),
      slider(
        'descent-decay',
        'Decay',
        { min: 0, max: 0.1, step: 0.002, value: 0 },
        (x) => x.toFixed(3),
        set(demo, 'decay'),
      ),
    ];
  },
  below(demo) {
    demo.canvas = html('canvas', {
      width: size,
      height: size,
      style: 'max-width: 240px; margin-top: 10px; border-radius: 6px',
      role: 'img',
      'aria-label': 'The landscape of distances over the two angles, and the walk down it',
    });
    return [
      demo.canvas,
      html(
        'p',
        { class: 'hint' },
        'Across: the angle on A; up: that on B; dark is near. The walk goes from red to green.',
      ),
    ];
  },
  draw(demo) {
    const { a, b } = demo.shapes,
      { view } = demo.stage,
      context = demo.canvas.getContext('2d'),
      path = walk(demo);
    landscape(context, a, b);
    drawWalk(context, path);
    const ends = path.map(([t, u]) => [atAngle(a, t), atAngle(b, u)]);
    return [
      grid(view),
      draw(view, a, { class: 'shape a', 'data-shape': 'a' }),
      draw(view, b, { class: 'shape b', 'data-shape': 'b' }),
      ...[0, 1].map((k) =>
        polygon(
          view,
          ends.map((pair) => pair[k]),
          { class: 'walk' },
          false,
        ),
      ),
      polygon(view, ends[0], { class: 'line' }, false),
      polygon(view, ends.at(-1), { class: 'nearest' }, false),
      ...ends[0].map((at) => dot(view, at, { class: 'start' })),
      ...ends.at(-1).map((at) => dot(view, at, { class: 'finish' })),
    ];
  },
  tell(demo) {
    const { a, b } = demo.shapes,
      found = demo.methods.ellipseEllipseDistanceGradientDescent(a, b, demo.settings);
    return [
      [
        'Gradient descent',
        short(found.distance),
        found.success
          ? `converged after ${found.iterations} iterations`
          : `not converged after ${found.iterations} iterations: error ${short(found.error, 4)}`,
      ],
      ['Vesica', short(demo.vesica.boundaryDistance(a, b).distance), 'vesica_boundary_distance_f64: the true minimum'],
    ];
  },
};
