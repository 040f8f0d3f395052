// SPDX-License-Identifier: Apache-2.0
// Motion: the way is dragged and moved by keys, told by a link, and the answer is that of the programs to copy.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { closeQuietly, middle, openPlayground, text } from './browser.mjs';
import { languages, printed } from './programs.mjs';

const answer = (page) => text(page, '#motion-answer strong');
const hex = (page, id) => text(page, `#motion-${id} .exact`);
/** A disc of radius 1, and a point 5 to the left of its centre that moves by (8, 0); it may turn. */
const link = (shape, angle = '0x0p+0') =>
  `#tab=motion&a=circle,0x0p+0,0x0p+0,0x1p+0&b=${shape}&motion=0x1p+3,0x0p+0,${angle}`;
const ray = link('point,-0x1.4p+2,0x0p+0'),
  bar = link('rect,-0x1.4p+2,0x0p+0,0x1p+0,0x0p+0,0x1p+0,0x1p-4', '0x1.9p+3'),
  capsule = 'capsule,-0x1.4p+2,-0x1p+0,-0x1.4p+2,0x1p+0,0x1p-1',
  card = 'round_rect,-0x1.4p+2,0x0p+0,0x1p+0,0x0p+0,0x1p-1,0x1p+0,0x1p-2';

test('a point at a disc: time, place and normal', async () => {
  const page = await openPlayground(ray);
  assert.equal(await answer(page), 'hit');
  assert.equal(await hex(page, 't'), '0x1p-1');
  assert.equal(await hex(page, 'place'), '-0x1p+0 0x0p+0');
  assert.equal(await hex(page, 'normal'), '-0x1p+0 0x0p+0');
  assert.equal(await text(page, '#panel-motion .verdict'), 'B touches A on its way.');
  await closeQuietly(page);
});

test('a capsule comes with its side, and turning with its end', async () => {
  const still = await openPlayground(link(capsule));
  assert.equal(await answer(still), 'hit');
  assert.equal(await hex(still, 't'), '0x1.cp-2');
  const turning = await openPlayground(link(capsule, '0x1.9p+3'));
  assert.equal(await answer(turning), 'hit');
  assert.ok(Number(await text(turning, '#motion-t strong').then((t) => t.replace('≈ ', ''))) < 0.4375);
  await closeQuietly(still);
  await closeQuietly(turning);
});

test('the goal is dragged, and the answer follows', async () => {
  const page = await openPlayground(ray);
  const [x, y] = await middle(page, '#motion-v-move');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 150, { steps: 5 });
  await page.mouse.up();
  assert.equal(await answer(page), 'miss');
  assert.equal(await text(page, '#motion-t strong'), 'none');
  assert.equal(await page.$('#panel-motion .arrived'), null);
  await closeQuietly(page);
});

test('keys alone: from the tab to a shorter way', async () => {
  const page = await openPlayground(ray);
  await page.focus('#tab-motion');
  for (let i = 0; i < 50 && (await page.evaluate(() => document.activeElement.id)) !== 'motion-v-move'; ++i)
    await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'motion-v-move');
  let presses = 0;
  while ((await answer(page)) === 'hit' && ++presses < 200) await page.keyboard.press('ArrowLeft');
  assert.equal(await answer(page), 'miss');
  assert.ok(presses > 5);
  await page.focus('#motion-turn');
  await page.keyboard.press('ArrowRight');
  assert.match(await text(page, '#panel-motion output'), /^5°$/);
  assert.match(await text(page, '#motion-call .call'), /vesica_impact_time\(/);
  await closeQuietly(page);
});

test('a link holds every bit of the motion', async () => {
  const page = await openPlayground(ray);
  await page.focus('#motion-v-move');
  await page.keyboard.press('ArrowUp');
  await page.waitForFunction(() => !location.hash.endsWith('motion=0x1p+3,0x0p+0,0x0p+0'));
  const told = await page.$$eval('#panel-motion .exact', (all) => all.map((one) => one.textContent));
  const again = await openPlayground(await page.evaluate(() => location.hash));
  assert.deepEqual(await again.$$eval('#panel-motion .exact', (all) => all.map((one) => one.textContent)), told);
  await closeQuietly(page);
  await closeQuietly(again);
});

test('it opens on an example that hits on its way, turning or not', async () => {
  const page = await openPlayground('#tab=motion');
  assert.equal(await answer(page), 'hit');
  const t = Number((await text(page, '#motion-t strong')).replace('≈ ', ''));
  assert.ok(t > 0.1 && t < 0.9, `t = ${t}`);
  assert.notEqual(await page.$('#panel-motion .arrived'), null);
  const still = await hex(page, 't');
  await page.focus('#motion-turn');
  for (let i = 0; i < 12; ++i) await page.keyboard.press('ArrowRight');
  assert.equal(await text(page, '#panel-motion output'), '60°');
  assert.equal(await answer(page), 'hit');
  assert.notEqual(await hex(page, 't'), still);
  await closeQuietly(page);
});

test('shapes that were changed stay in all tabs, the example does not', async () => {
  const page = await openPlayground();
  const start = () => page.$eval('#number-b-cx', ({ value }) => Number(value));
  const before = await start();
  await page.click('#tab-motion');
  await page.waitForSelector('#motion-call');
  assert.equal(await answer(page), 'hit');
  await page.click('#tab-two');
  assert.equal(await start(), before);
  await page.focus('#two-b-move');
  await page.keyboard.press('ArrowRight');
  const changed = await start();
  await page.click('#tab-motion');
  assert.equal(await answer(page), 'start');
  assert.equal(await start(), changed);
  await page.click('#motion-example');
  assert.equal(await answer(page), 'hit');
  await closeQuietly(page);
});

test('the programs to copy say what the page says, in four languages', async () => {
  const told = [],
    programs = Object.fromEntries(languages.map((language) => [language, []]));
  const rounded = [link(capsule), link(capsule, '0x1.9p+3'), link(card), link(card, '0x1.9p+3')];
  for (const scene of [ray, bar, '#tab=motion', ...rounded]) {
    const page = await openPlayground(scene);
    told.push(await hex(page, 't'));
    for (const language of languages) {
      await page.$eval(`#motion-in-${language}`, (input) => input.click());
      programs[language].push(await page.$eval('#motion-call .copy', ({ dataset }) => dataset.program));
    }
    await closeQuietly(page);
  }
  // What the page says in hexadecimal, as C prints it in decimal.
  const expected = told.map((t) => {
    const [, digits, power] = /^0x([\d.a-f]+)p([+-]\d+)$/.exec(t),
      [whole, fraction = ''] = digits.split('.');
    return Number.parseInt(whole + fraction, 16) * 2 ** (Number(power) - 4 * fraction.length);
  });
  for (const language of languages) assert.deepEqual(printed(language, programs[language]).map(Number), expected, language);
});
