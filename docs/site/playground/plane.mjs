// SPDX-License-Identifier: Apache-2.0
// A drawing of shapes: x to the right and y up, from numbers of any size to a picture of a fixed one.
import { svg } from './element.mjs';
import { form, outlines, reach } from './shape.mjs';

export const width = 800,
  height = 520;

const path = (points, closed = true) =>
  `M${points.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(' ')}${closed ? 'Z' : ''}`;

/** Which part of the plane is seen. */
export class View {
  constructor() {
    Object.assign(this, { x: 0, y: 0, scale: 80 });
  }

  /** All of some shapes, with room around them. */
  fit(shapes) {
    const boxes = shapes.map((shape) => {
      const { x, y } = form(shape),
        [w, h] = reach(shape);
      return [x - w, x + w, y - h, y + h];
    });
    const [left, right, low, high] = [Math.min, Math.max, Math.min, Math.max].map((of, i) =>
      of(...boxes.map((box) => box[i])),
    );
    const scale = 0.62 * Math.min(width / (right - left), height / (high - low));
    this.x = left / 2 + right / 2;
    this.y = low / 2 + high / 2;
    this.scale = scale > 0 && Number.isFinite(scale) ? scale : 80;
  }

  to([x, y]) {
    const clamp = (v) => Math.max(-1e4, Math.min(1e4, v)) || 0;
    return [width / 2 + clamp((x - this.x) * this.scale), height / 2 - clamp((y - this.y) * this.scale)];
  }

  from([px, py]) {
    return [this.x + (px - width / 2) / this.scale, this.y - (py - height / 2) / this.scale];
  }

  /** The point of the plane under a pointer. */
  under(event, board) {
    const box = board.getBoundingClientRect();
    return this.from([
      ((event.clientX - box.left) / box.width) * width,
      ((event.clientY - box.top) / box.height) * height,
    ]);
  }
}

/** An SVG of the view's size. What it shows is told by a text beside it. */
export const board = (label) => svg('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': label });

/** Lines of a grid, ten units of a power of ten or more apart, about as many as fit. */
export function grid(view) {
  const unit = 10 ** Math.ceil(Math.log10(40 / view.scale)),
    lines = [];
  const [left, high] = view.from([0, 0]),
    [right, low] = view.from([width, height]);
  if (!(unit > 0) || !Number.isFinite(right - left) || (right - left) / unit > 100) return svg('g');
  for (let i = Math.ceil(left / unit); i * unit <= right; ++i)
    lines.push([view.to([i * unit, high]), view.to([i * unit, low])]);
  for (let i = Math.ceil(low / unit); i * unit <= high; ++i)
    lines.push([view.to([left, i * unit]), view.to([right, i * unit])]);
  return svg('path', { class: 'grid', d: lines.map((line) => path(line, false)).join('') });
}

/** A shape's outline; a point is a small dot. */
export function draw(view, shape, attributes) {
  if (shape.kind === 'point') return dot(view, [shape.x, shape.y], { r: 5, ...attributes });
  const closed = shape.kind !== 'polyline',
    lines = outlines(shape).map((points) =>
      path(
        points.map((point) => view.to(point)),
        closed,
      ),
    );
  const line = closed ? {} : { style: 'fill: none' };
  return svg('path', { d: lines.join(''), 'fill-rule': 'evenodd', 'clip-rule': 'evenodd', ...line, ...attributes });
}

export function dot(view, at, attributes) {
  const [cx, cy] = view.to(at);
  return svg('circle', { cx, cy, r: 4, ...attributes });
}

export const polygon = (view, points, attributes, closed = true) =>
  svg('path', {
    d: path(
      points.map((point) => view.to(point)),
      closed,
    ),
    ...attributes,
  });

export function text(view, at, words, attributes = {}) {
  const [x, y] = view.to(at);
  return svg('text', { x, y, ...attributes }, words);
}
