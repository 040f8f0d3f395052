// SPDX-License-Identifier: Apache-2.0
// The knife's edge: its 131 exact answers are the oracle's, in double and float, for many pairs of kinds.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { closeQuietly, openPlayground, text } from './browser.mjs';

const kinds = ['point', 'segment', 'circle', 'aabb', 'rect', 'ellipse', 'capsule', 'round_rect'];
const fields = { point: 2, segment: 4, circle: 3, aabb: 4, rect: 6, ellipse: 6, capsule: 5, round_rect: 7 };

/** The shapes at contact, asked of the page's own modules; the strips' answers. */
const shown = (page) =>
  page.evaluate(async () => {
    const { fields } = await import('../vesica/vesica.mjs'),
      { beside, besideFloat, fromHex, toHex } = await import('./number.mjs');
    const { fromAddress } = await import('./address.mjs'),
      state = fromAddress(location.hash, ['edge']);
    const strips = document.querySelector('.strips'),
      { field, first, type } = strips.dataset,
      step = type === 'float' ? besideFloat : beside;
    const round = type === 'float' ? Math.fround : (x) => x,
      numbers = (shape) => fields[shape.kind].map((name) => toHex(round(shape[name])));
    return {
      a: [state.a.kind, numbers(state.a)],
      b: Array.from({ length: 131 }, (_, i) => [
        state.b.kind,
        numbers({ ...state.b, [field]: step(fromHex(first), i) }),
      ]),
      answers: ['exact', 'double', 'float'].map((id) =>
        [...document.querySelectorAll(`#${id} [data-answer]`)].map((cell) => +cell.dataset.answer),
      ),
    };
  });

/** Zeros up to seven numbers, which the oracle's program reads. */
const line = ([kind, numbers]) =>
  [kinds.indexOf(kind), ...numbers, ...Array(7 - fields[kind]).fill('0x0p+0')].join(' ');

function asOracle({ a, b, answers: [exact] }) {
  const lines = execFileSync(process.env.VESICA_ORACLE, {
    input: b.map((shape) => `${line(a)} ${line(shape)}\n`).join(''),
    encoding: 'utf8',
  });
  assert.deepEqual(exact, lines.trim().split('\n').map(Number));
  assert.equal(exact.length, 131);
  assert.ok(exact.includes(0) && exact.includes(1));
}

test("exact answers are the oracle's", async () => {
  const page = await openPlayground();
  await page.click('#tab-edge');
  await page.waitForSelector('.strips');
  let asked = 0;
  for (const kindA of kinds.slice(1)) {
    for (const kindB of kinds) {
      await page.select('#kind-a', kindA);
      await page.select('#kind-b', kindB);
      for (const type of ['double', 'float']) {
        await page.select('#edge-type', type);
        if ((await page.$('.strips')) === null) continue; // no value of that number parts them
        await page.click('#to-contact');
        await page.waitForFunction(
          () => new Promise((done) => setTimeout(() => done(location.hash.includes('tab=edge')), 250)),
        );
        asOracle(await shown(page));
        ++asked;
      }
    }
  }
  assert.ok(asked > 80, `${asked} contacts`);
  await closeQuietly(page);
});

test('polygons: the exact strip turns once, and textbooks are right away from contact', async () => {
  const page = await openPlayground();
  for (const [a, b] of [
    ['polygon', 'triangle'],
    ['frame', 'ellipse'],
    ['polyline', 'circle'],
    ['quad', 'rect'],
  ]) {
    await page.click('#tab-two');
    await page.select('#kind-a', a);
    await page.select('#kind-b', b);
    await page.click('#tab-edge');
    await page.waitForSelector('.strips');
    const exact = await page.$$eval('#exact [data-answer]', (all) => all.map(({ dataset }) => dataset.answer));
    assert.equal(exact.length, 131);
    assert.equal(exact.filter((answer, i) => i > 0 && answer !== exact[i - 1]).length, 1, `${a} ${b}`);
  }
  const wrong = await page.evaluate(async () => {
    const { load } = await import('../vesica/vesica.mjs'),
      { double, float, overlap } = await import('./edge/textbook.mjs'),
      { asKind, choices } = await import('./shape.mjs'),
      { random } = await import('./crowd/motion.mjs');
    const vesica = await load(),
      next = random(3),
      sorts = Object.keys(choices).filter((sort) => sort !== 'point');
    const shape = () =>
      asKind(
        { kind: 'rect', cx: 8 * next(), cy: 8 * next(), ux: 1, uy: next(), hx: 2, hy: 1 },
        sorts[Math.floor(sorts.length * next())],
      );
    let differ = 0;
    for (let i = 0; i < 3000; ++i) {
      const [a, b] = [shape(), shape()];
      for (const arithmetic of [double, float]) differ += overlap(arithmetic, a, b) !== vesica.overlap(a, b);
    }
    return differ;
  });
  assert.equal(wrong, 0);
  await closeQuietly(page);
});

test('the example: textbooks fail in double and in float', async () => {
  const page = await openPlayground('#tab=edge');
  // It opens on the example, with both shapes drawn.
  await page.waitForFunction(() => /\b[1-9]\d* of 131 wrong/.test(document.querySelector('#double').textContent));
  assert.equal(await page.$$eval('#panel-edge .picture .shape', (all) => all.length), 2);
  assert.match(await text(page, '#panel-edge [role=status]'), /^At centre x ≈ 0\.0354/);
  await page.click('#edge-example');
  await page.waitForFunction(() => /\b[1-9]\d* of 131 wrong/.test(document.querySelector('#double').textContent));
  await page.waitForFunction(() => new Promise((done) => setTimeout(() => done(true), 250)));
  const found = await shown(page),
    wrong = (row) => row.filter((answer, i) => answer !== found.answers[0][i]).length;
  asOracle(found);
  assert.ok(wrong(found.answers[1]) >= 5, 'in double');
  assert.ok(wrong(found.answers[2]) >= 60, 'in float');
  assert.equal(await page.$eval('#edge-field', ({ value }) => value), 'cx');
  await page.select('#edge-field', 'a');
  await page.waitForFunction(
    () =>
      /No value of half axis along/.test(document.querySelector('#panel-edge .result').textContent) ||
      document.querySelector('#exact') !== null,
  );
  await closeQuietly(page);
});
