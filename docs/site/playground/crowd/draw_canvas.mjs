// SPDX-License-Identifier: Apache-2.0
// Where there is no WebGL: one path for the shapes of each colour.
import { box, dart, perInstance } from './motion.mjs';

const square = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
];

function add(path, [x, y, px, py, b, round, , r], scale, to) {
  const a = Math.hypot(px, py),
    [ux, uy] = a > 0 ? [px / a, py / a] : [1, 0],
    least = 0.75 / scale;
  const along = Math.max(a, least),
    across = Math.max(b, least),
    [cx, cy] = to(x, y);
  if (round === 1) {
    path.moveTo(cx + along * scale * ux, cy - along * scale * uy);
    path.ellipse(cx, cy, along * scale, across * scale, -Math.atan2(uy, ux), 0, 2 * Math.PI);
    return;
  }
  const corner = (s, t) => to(x + s * along * ux - t * across * uy, y + s * along * uy + t * across * ux);
  if (r > 0) {
    const turn = -Math.atan2(uy, ux);
    [
      [1, 1],
      [-1, 1],
      [-1, -1],
      [1, -1],
    ].forEach(([s, t], i) => {
      const [ex, ey] = corner(s * (1 - r / along), t * (1 - r / across));
      path[i === 0 ? 'moveTo' : 'lineTo'](
        ex + r * scale * Math.cos(turn - (i * Math.PI) / 2),
        ey + r * scale * Math.sin(turn - (i * Math.PI) / 2),
      );
      path.arc(ex, ey, r * scale, turn - (i * Math.PI) / 2, turn - ((i + 1) * Math.PI) / 2, true);
    });
    path.closePath();
    return;
  }
  const [first, ...others] = round === 2 ? dart : square;
  path.moveTo(...corner(...first));
  for (const at of others) path.lineTo(...corner(...at));
  path.closePath();
}

/** draw(instances, count, colours), as that of WebGL. */
export function flatCanvas(canvas) {
  const context = canvas.getContext('2d'),
    css = (colour, alpha) => `rgb(${colour.map((part) => 255 * part).join(' ')} / ${alpha})`;
  return (data, count, { paper, calm, hit }) => {
    const scale = canvas.width / box.width,
      to = (x, y) => [canvas.width / 2 + x * scale, canvas.height / 2 - y * scale];
    const paths = [new Path2D(), new Path2D()];
    for (let i = 0; i < count; ++i) {
      const instance = data.subarray(perInstance * i, perInstance * i + 8);
      add(paths[instance[6] > 0 ? 1 : 0], instance, scale, to);
    }
    context.fillStyle = css(paper, 1);
    context.fillRect(0, 0, canvas.width, canvas.height);
    [
      [calm, 0.5],
      [hit, 0.85],
    ].forEach(([colour, alpha], i) => {
      context.fillStyle = css(colour, alpha);
      context.fill(paths[i]);
    });
  };
}
