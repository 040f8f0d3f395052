// SPDX-License-Identifier: Apache-2.0
// The crowd: 200 frames; the pairs are those of asking every pair; and what a frame's query takes, which is printed.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { closeQuietly, openPlayground, text } from './browser.mjs';

const asNumber = (words) => Number(words.replaceAll(',', ''));

test('with reduced motion nothing moves until it is asked to', async () => {
  const page = await openPlayground('#tab=crowd');
  assert.equal(await text(page, '#crowd-run'), 'Play');
  // Figures from the first frame; tests a second are those of the query's own time.
  assert.equal(await page.$eval('#panel-crowd > div', ({ dataset }) => dataset.frames), '1');
  const figures = await page.evaluate(() =>
    ['query', 'tests', 'pairs', 'exact'].map((id) => document.getElementById(`crowd-${id}`).textContent),
  );
  const [query, tests, pairs] = figures.map(asNumber);
  assert.ok(query > 0 && pairs > 1000 && tests >= pairs, figures.join());
  const [, amount, unit] = /^([\d.]+)([KM])$/.exec(figures[3]),
    said = Number(amount) * { K: 1e3, M: 1e6 }[unit];
  assert.ok(Math.abs(said / ((1000 * tests) / query) - 1) < 0.06, `${said} tests a second`);
  for (const count of [0, 6]) {
    await page.$eval(
      '#crowd-count',
      (input, value) => {
        input.value = value;
        input.dispatchEvent(new Event('input'));
      },
      count,
    );
  }
  assert.match(await text(page, '#panel-crowd output'), /100,000 shapes/);
  assert.ok(asNumber(await text(page, '#crowd-pairs')) > 10000);
  await closeQuietly(page);
});

test('the pairs are those of asking every pair', async () => {
  const page = await openPlayground();
  const [by_join, by_all, marked] = await page.evaluate(async () => {
    const { load } = await import('../vesica/vesica.mjs'),
      { Crowd } = await import('./crowd/motion.mjs');
    const vesica = await load(),
      crowd = new Crowd(vesica, 300, 7);
    for (let i = 0; i < 20; ++i) crowd.move(0.1);
    const pairs = crowd.collide(),
      shapes = Array.from({ length: 300 }, (_, i) => crowd.at(i));
    let all = 0;
    const touched = new Uint8Array(300);
    shapes.forEach((a, i) =>
      shapes.forEach((b, j) => {
        if (j > i && vesica.overlap(a, b)) touched[i] = touched[j] = ++all && 1;
      }),
    );
    return [pairs, all, touched.every((mark, i) => mark === crowd.touched[i])];
  });
  assert.ok(by_all > 20);
  assert.equal(by_join, by_all);
  assert.ok(marked);
  await closeQuietly(page);
});

test('what the query takes, with vectors and without', async (t) => {
  const page = await openPlayground();
  const lines = await page.evaluate(async () => {
    const { load } = await import('../vesica/vesica.mjs'),
      { Crowd } = await import('./crowd/motion.mjs'),
      said = [];
    const modules = { simd: await load(), plain: await load({ simd: false }) };
    for (const n of [1000, 10000, 100000]) {
      const crowds = Object.entries(modules).map(([name, vesica]) => ({
        name,
        crowd: new Crowd(vesica, n),
        times: [],
      }));
      let pairs;
      for (let frame = 0; frame < (n < 100000 ? 60 : 20); ++frame) {
        for (const { crowd, times } of crowds) {
          crowd.move(1 / 60);
          const start = performance.now();
          pairs = crowd.collide();
          times.push(performance.now() - start);
        }
      }
      const [simd, plain] = crowds.map(({ times }) => times.sort((x, y) => x - y)[times.length >> 1]);
      said.push(
        `${n} shapes, ${pairs} pairs: ${simd.toFixed(2)} ms of query a frame with vectors, ${plain.toFixed(2)} without (medians)`,
      );
      for (const { crowd } of crowds) crowd.free();
    }
    return said;
  });
  assert.equal(lines.length, 3);
  for (const line of lines) t.diagnostic(line);
  await closeQuietly(page);
});

// The last: what the processor has still to draw goes with the browser.
test('200 frames of ten thousand shapes', async (t) => {
  const page = await openPlayground('#tab=crowd', { still: false, width: 500 });
  await page.waitForFunction(() => Number(document.querySelector('#panel-crowd > div').dataset.frames) >= 200, {
    timeout: 120000,
  });
  assert.ok(asNumber(await text(page, '#crowd-pairs')) > 1000);
  assert.ok(Number(await text(page, '#crowd-query')) > 0);
  assert.match(await text(page, '#crowd-exact'), /^[\d.]+[KM]$/);
  t.diagnostic(
    `as drawn by the processor: ${await text(page, '#crowd-query')} ms of query a frame, ${await text(page, '#crowd-exact')} tests a second`,
  );
  await page.click('#crowd-run');
  const frames = await page.$eval('#panel-crowd > div', ({ dataset }) => dataset.frames);
  await new Promise((done) => setTimeout(done, 300));
  assert.equal(await page.$eval('#panel-crowd > div', ({ dataset }) => dataset.frames), frames);
  await closeQuietly(page);
});
