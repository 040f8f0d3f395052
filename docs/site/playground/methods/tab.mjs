// SPDX-License-Identifier: Apache-2.0
// The named methods, one under the other, each to play with.
import { loadMethods } from '../../vesica/methods.mjs';
import { html } from '../element.mjs';
import { closestFeatures } from './closest_features.mjs';
import { Demo } from './demo.mjs';
import { gradientDescent } from './gradient_descent.mjs';
import { minkowskiSum } from './minkowski_sum.mjs';
import { polygonalSandwich } from './polygonal_sandwich.mjs';
import { separatingLines } from './separating_lines.mjs';

const all = [closestFeatures, minkowskiSum, polygonalSandwich, separatingLines, gradientDescent];

export async function openMethods(vesica) {
  const methods = await loadMethods(),
    demos = all.map((description) => new Demo(vesica, methods, description));
  return {
    element: html(
      'div',
      {},
      html(
        'p',
        { class: 'lead' },
        'The algorithms that people know by name, corrected, beside the exact answer: drag the shapes and see where each stands.',
      ),
      ...demos.map((demo) => demo.element),
    ),
  };
}
