// SPDX-License-Identifier: Apache-2.0
// The picture of two shapes and of the answers about them.
import { svg } from '../element.mjs';
import { dot, draw, grid, polygon } from '../plane.mjs';
import { form, moved } from '../shape.mjs';
import { found } from './answers.mjs';

const definitions = () =>
  svg(
    'defs',
    {},
    svg(
      'pattern',
      { id: 'hatching', width: 8, height: 8, patternUnits: 'userSpaceOnUse', patternTransform: 'rotate(45)' },
      svg('path', { d: 'M0,0V8', class: 'hatch' }),
    ),
    svg(
      'marker',
      {
        id: 'arrow',
        viewBox: '0 0 10 10',
        refX: 9,
        refY: 5,
        markerWidth: 7,
        markerHeight: 7,
        orient: 'auto-start-reverse',
      },
      svg('path', { d: 'M0,0L10,5L0,10Z', class: 'arrowhead' }),
    ),
  );

/** The area of both: a's, cut by b's outline. */
function sharedArea(view, a, b) {
  return [
    svg('clipPath', { id: 'clip-b' }, draw(view, b, {})),
    draw(view, a, { 'clip-path': 'url(#clip-b)', fill: 'url(#hatching)', class: 'shared' }),
  ];
}

/** Where b would go, and the way there from its centre. */
function wayOut(view, b, { depth, x, y }) {
  const { x: cx, y: cy } = form(b);
  return [
    draw(view, moved(b, depth * x, depth * y), { class: 'ghost' }),
    polygon(
      view,
      [
        [cx, cy],
        [cx + depth * x, cy + depth * y],
      ],
      { class: 'depth', 'marker-end': 'url(#arrow)' },
      false,
    ),
  ];
}

const between = (view, { ax, ay, bx, by }, name) => [
  polygon(
    view,
    [
      [ax, ay],
      [bx, by],
    ],
    { class: name },
    false,
  ),
  dot(view, [ax, ay], { class: `${name} end` }),
  dot(view, [bx, by], { class: `${name} end` }),
];

/** What stands in the SVG: back to front. */
export function picture(view, a, b, answers) {
  const overlap = found(answers, 'overlap'),
    depth = found(answers, 'depth'),
    outlines = found(answers, 'outlines');
  const state = overlap ? 'hit' : 'apart';
  return [
    definitions(),
    grid(view),
    draw(view, a, { class: `shape a ${state}`, 'data-shape': 'a' }),
    draw(view, b, { class: `shape b ${state}`, 'data-shape': 'b' }),
    ...(found(answers, 'area') > 0 ? sharedArea(view, a, b) : []),
    ...(overlap && depth?.depth > 0 ? wayOut(view, b, depth) : []),
    ...(overlap
      ? outlines?.distance > 0
        ? between(view, outlines, 'outlines')
        : []
      : between(view, found(answers, 'nearest'), 'nearest')),
    ...(found(answers, 'crossings')?.places ?? []).map(({ x, y }) => dot(view, [x, y], { class: 'crossing', r: 5 })),
  ];
}
