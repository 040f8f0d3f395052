// SPDX-License-Identifier: Apache-2.0
// The named methods: what each says of its first scene, of its examples, and after its sliders were moved.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { closeQuietly, middle, openPlayground } from './browser.mjs';

const told = (page, id) =>
  page.$$eval(`#method-${id} .answers li`, (rows) =>
    Object.fromEntries(
      rows.map((row) => [row.querySelector('.question').textContent, row.querySelector('strong').textContent]),
    ),
  );
const slide = (page, id, value) =>
  page.$eval(
    `#${id}`,
    (input, to) => {
      input.value = to;
      input.dispatchEvent(new Event('input'));
    },
    value,
  );

test('each method beside the exact answer', async () => {
  const page = await openPlayground('#tab=methods');
  await page.waitForSelector('#method-descent');
  assert.deepEqual(await page.$$eval('#panel-methods h2', (all) => all.length), 5);
  for (const id of ['features', 'minkowski', 'sandwich', 'lines', 'descent']) {
    assert.match(
      await page.$eval(`#method-${id}`, (section) => section.textContent),
      /From: .*\(20|From: Rectangle intersection/,
    );
  }
  const features = await told(page, 'features');
  assert.equal(features['Closest features'], features['Vesica, exact']);
  assert.equal(features['All features'], features['Vesica, exact']);

  assert.deepEqual(await told(page, 'minkowski'), {
    'As printed': 'yes',
    'Typing error mended': 'yes',
    Corrected: 'no',
    'Vesica, exact': 'no',
  });
  await page.select('#minkowski-example', 'typo');
  const typo = await told(page, 'minkowski');
  assert.notEqual(typo['As printed'], typo['Vesica, exact']);
  assert.equal(typo['Typing error mended'], typo['Vesica, exact']);
  assert.equal(typo.Corrected, typo['Vesica, exact']);

  assert.equal((await told(page, 'sandwich'))['Polygonal sandwich, n = 1'], 'uncertain');
  await slide(page, 'sandwich-n', 10);
  assert.equal((await told(page, 'sandwich'))['Polygonal sandwich, n = 10'], 'no');
  await page.select('#sandwich-method', 'circleEllipseCircleApproximation');
  assert.equal((await told(page, 'sandwich'))['Circle approximation, n = 10'], 'no');

  const lines = await told(page, 'lines');
  assert.deepEqual([lines['Separating lines'], lines['Vesica, exact']], ['no', 'no']);
  await slide(page, 'lines-k', 20);
  assert.equal((await told(page, 'lines'))['Sample points, k = 20'], 'uncertain');

  const descent = await told(page, 'descent');
  assert.equal(descent['Gradient descent'], descent.Vesica);
  await page.select('#descent-schedule', 'literal');
  await slide(page, 'descent-rate', 1.8);
  assert.notEqual((await told(page, 'descent'))['Gradient descent'], descent.Vesica);
  await closeQuietly(page);
});

test('shapes are dragged: the separating line goes away', async () => {
  const page = await openPlayground('#tab=methods');
  await page.waitForSelector('#method-lines');
  const [x, y] = await middle(page, '#lines-b-move'),
    [toX, toY] = await page.$eval('#lines-a-move', (node) => {
      const { x, y, width, height } = node.getBoundingClientRect();
      return [x + width / 2, y + height / 2];
    });
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(toX + 30, toY, { steps: 5 });
  await page.mouse.up();
  assert.deepEqual(
    (({ 'Separating lines': lines, 'Vesica, exact': exact }) => [lines, exact])(await told(page, 'lines')),
    ['yes', 'yes'],
  );
  await closeQuietly(page);
});
