// SPDX-License-Identifier: Apache-2.0
// What calls cost from JavaScript: as bench/hosts/overhead.c does, with the same rectangles.
import { load } from './vesica.mjs';

const vesica = await load(), count = 1_000_000;

function rect(i) {
  const odd = i % 2 === 1;
  return {
    kind: 'rect', cx: ((i * 7919) % 4001) / 1000, cy: ((i * 104729) % 4003) / 1000,
    ux: odd ? 5 / 13 : 0.8, uy: odd ? 12 / 13 : 0.6, hx: 0.5 + (i % 100) / 200, hy: 0.5 + (i % 70) / 140,
  };
}

function least(call, calls, repeats) {
  let best = Infinity;
  for (let repeat = 0; repeat < repeats; ++repeat) {
    const start = performance.now();
    for (let i = 0; i < calls; ++i) call(i);
    best = Math.min(best, ((performance.now() - start) / calls) * 1e6);
  }
  return best;
}

const a = Array.from({ length: 1000 }, (_, i) => rect(i)), b = Array.from({ length: 1000 }, (_, i) => rect(3 * i + 1));
const someA = vesica.shapes('rect', a), someB = vesica.shapes('rect', b);
const allA = vesica.shapes('rect', Array.from({ length: count }, (_, i) => rect(i)));
const allB = vesica.shapes('rect', Array.from({ length: count }, (_, i) => rect(3 * i + 1)));
for (const name of ['overlap', 'nearest', 'iou']) {
  const row = [
    least((i) => vesica[name](a[i % 1000], b[i % 1000]), 1000, 100),
    least(() => vesica[name](someA, someB), 1, 100) / 1000,
    least(() => vesica[name](allA, allB), 1, 7) / count,
  ];
  console.log('JavaScript', name, ...row.map((ns) => ns.toPrecision(4)));
}
