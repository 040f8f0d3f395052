// SPDX-License-Identifier: Apache-2.0
// Two shapes: dragged, moved by keys, told by a link, and every answer with a program that gives the same.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { closeQuietly, middle, openPlayground, text } from './browser.mjs';
import { languages, printed } from './programs.mjs';

const kinds = ['point', 'segment', 'circle', 'aabb', 'rect', 'ellipse', 'capsule', 'round_rect'];
const paths = ['triangle', 'quad', 'polygon', 'frame', 'polyline'];
const value = (page, id) => text(page, `#answer-${id} strong`);
const number = (page, name, field) => page.$eval(`#number-${name}-${field}`, (input) => Number(input.value));
const choose = (page, name, kind) => page.select(`#kind-${name}`, kind);

test('dragging moves a shape, and the answers follow', async () => {
  const page = await openPlayground();
  assert.equal(await value(page, 'overlap'), 'yes');
  const before = await number(page, 'b', 'cx');
  const [x, y] = await middle(page, '#two-b-move');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 100, y, { steps: 5 });
  await page.mouse.move(x + 200, y - 60, { steps: 5 });
  await page.mouse.up();
  assert.ok((await number(page, 'b', 'cx')) > before + 1);
  assert.equal(await value(page, 'overlap'), 'no');
  assert.equal(await value(page, 'relation'), 'disjoint');
  assert.notEqual(await value(page, 'nearest'), '0');
  assert.equal(await text(page, '.verdict'), 'They do not overlap: disjoint.');
  // What was grabbed stays what keys move, and the mouse is let go.
  await page.mouse.move(x, y);
  const after = await number(page, 'b', 'cx');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'two-b-move');
  await page.mouse.move(x - 50, y);
  assert.equal(await number(page, 'b', 'cx'), after);
  await closeQuietly(page);
});

test('a finger turns a rectangle by its handle', async () => {
  const page = await openPlayground('', {
    before: (page) => page.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'reduce' }]),
  });
  const [ux, hx] = [await number(page, 'a', 'ux'), await number(page, 'a', 'hx')];
  const [x, y] = await middle(page, '#two-a-along');
  await page.touchscreen.touchStart(x, y);
  await page.touchscreen.touchMove(x - 20, y - 60);
  await page.touchscreen.touchMove(x - 40, y - 100);
  await page.touchscreen.touchEnd();
  assert.ok((await number(page, 'a', 'ux')) < ux);
  assert.notEqual(await number(page, 'a', 'hx'), hx);
  await closeQuietly(page);
});

test('handles of a capsule and a rounded rectangle: ends, and the radius', async () => {
  const page = await openPlayground();
  await choose(page, 'a', 'capsule');
  await choose(page, 'b', 'round_rect');
  const drag = async (handle, dx, dy) => {
    const [x, y] = await middle(page, handle);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + dx, y + dy, { steps: 4 });
    await page.mouse.up();
  };
  const [x1, r] = [await number(page, 'a', 'x1'), await number(page, 'a', 'r')];
  await drag('#two-a-end', 60, 0);
  assert.ok((await number(page, 'a', 'x1')) > x1);
  assert.equal(await number(page, 'a', 'r'), r);
  await drag('#two-a-radius', 0, -40);
  assert.ok((await number(page, 'a', 'r')) > r);
  // Towards the core, a corner's radius becomes less, and the core stays.
  const [hx, corner] = [await number(page, 'b', 'hx'), await number(page, 'b', 'r')];
  const [handle, centre] = [await middle(page, '#two-b-radius'), await middle(page, '#two-b-move')];
  await drag('#two-b-radius', (centre[0] - handle[0]) / 10, (centre[1] - handle[1]) / 10);
  assert.ok((await number(page, 'b', 'r')) < corner);
  assert.equal(await number(page, 'b', 'hx'), hx);
  await closeQuietly(page);
});

const drag = async (page, handle, dx, dy) => {
  const [x, y] = await middle(page, handle);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx, y + dy, { steps: 5 });
  await page.mouse.up();
};
const handles = (page, name) => page.$$eval(`#panel-two .handle.${name}`, (all) => all.length);

test('corners of a polygon are dragged, added and taken away', async () => {
  const page = await openPlayground();
  await choose(page, 'b', 'frame');
  assert.equal(await handles(page, 'b'), 9);
  const [x3, x4] = [await number(page, 'b', 'x3'), await number(page, 'b', 'x4')];
  await drag(page, '#two-b-corner-3', -50, 0);
  assert.ok((await number(page, 'b', 'x3')) < x3);
  assert.equal(await number(page, 'b', 'x4'), x4);
  // On the edge between the first two corners, by the mouse.
  await middle(page, '#two-b-move');
  const [from, to] = await page.$$eval('#two-b-corner-0, #two-b-corner-1', (all) =>
    all.map((one) => one.getBoundingClientRect()).map(({ x, y, width, height }) => [x + width / 2, y + height / 2]),
  );
  await page.mouse.click(from[0] * 0.3 + to[0] * 0.7, from[1] * 0.3 + to[1] * 0.7, { clickCount: 2 });
  assert.equal(await handles(page, 'b'), 10);
  const [x0, x1, x2] = await Promise.all(['x0', 'x1', 'x2'].map((field) => number(page, 'b', field)));
  assert.ok(Math.abs(x1 - (0.3 * x0 + 0.7 * x2)) < 0.05);
  await page.mouse.click(...(await middle(page, '#two-b-corner-1')), { clickCount: 2 });
  assert.equal(await handles(page, 'b'), 9);
  // By keys; three corners stay.
  await choose(page, 'b', 'quad');
  await page.focus('#two-b-corner-0');
  await page.keyboard.press('Insert');
  assert.equal(await handles(page, 'b'), 6);
  for (const [key, count] of [
    ['Delete', 5],
    ['Backspace', 4],
    ['Delete', 4],
  ]) {
    await page.focus('#two-b-corner-1');
    await page.keyboard.press(key);
    assert.equal(await handles(page, 'b'), count);
  }
  await closeQuietly(page);
});

test('a hole goes with its third last corner', async () => {
  const page = await openPlayground();
  await choose(page, 'a', 'frame');
  for (const count of [8, 5]) {
    await page.focus('#two-a-corner-7, #two-a-corner-6');
    await page.keyboard.press('Delete');
    assert.equal(await handles(page, 'a'), count);
  }
  assert.equal(await page.$eval('#kind-a', ({ value }) => value), 'quad');
  await closeQuietly(page);
});

test('a polygon whose edges cross is not taken, and its answers are those before', async () => {
  const page = await openPlayground();
  await choose(page, 'a', 'quad');
  const x2 = await number(page, 'a', 'x2');
  await page.$eval('#number-a-x2', (input) => (input.value = ''));
  await page.type('#number-a-x2', '-100\n');
  assert.match(await text(page, '#panel-two .error'), /edges of a polygon cross/);
  assert.equal(await page.evaluate(() => location.hash.includes('-0x1.9p+6')), false);
  await page.focus('#tab-two');
  await page.focus('#two-a-move');
  await page.keyboard.press('ArrowUp');
  assert.equal(await number(page, 'a', 'x2'), x2);
  await closeQuietly(page);
});

test('a link holds a polygon with a hole, and a polyline', async () => {
  const page = await openPlayground();
  await choose(page, 'a', 'frame');
  await choose(page, 'b', 'polyline');
  await page.waitForFunction(() => /a=polygon,[^&]*;[^&]*&b=polyline,/.test(location.hash));
  const told = (one) => one.$$eval('.answers .exact', (all) => all.map(({ textContent }) => textContent));
  const again = await openPlayground(await page.evaluate(() => location.hash));
  assert.equal(await handles(again, 'a'), 9);
  assert.equal(await handles(again, 'b'), 5);
  assert.deepEqual(await told(again), await told(page));
  await closeQuietly(page);
  await closeQuietly(again);
});

test('keys alone: from the first tab to one last-place unit', async () => {
  const page = await openPlayground();
  await page.focus('#tab-two');
  for (let i = 0; i < 50 && (await page.evaluate(() => document.activeElement.id)) !== 'two-b-move'; ++i)
    await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'two-b-move');
  const before = await number(page, 'b', 'cx');
  await page.keyboard.press('ArrowRight');
  const moved = await number(page, 'b', 'cx');
  assert.ok(moved > before);
  await page.keyboard.down('Shift');
  await page.keyboard.press('ArrowRight');
  assert.equal(await number(page, 'b', 'cx'), moved + 2 ** (Math.floor(Math.log2(moved)) - 52));
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.up('Shift');
  assert.equal(await number(page, 'b', 'cx'), moved);
  await page.focus('#number-a-hx');
  await page.keyboard.press('ArrowUp');
  assert.ok((await number(page, 'a', 'hx')) > 2);
  await page.focus('#tab-two');
  await page.keyboard.press('ArrowRight');
  await page.waitForSelector('#panel-edge:not([hidden]) .strip');
  await closeQuietly(page);
});

test('numbers that are none, or make no shape, are not taken', async () => {
  const page = await openPlayground();
  for (const [wrong, why] of [
    ['four', 'no number'],
    ['-1', 'negative'],
    ['1e999', 'infinite'],
  ]) {
    await page.$eval('#number-a-hx', (input) => (input.value = ''));
    await page.type('#number-a-hx', wrong);
    await page.keyboard.press('Enter');
    await page.$eval('#number-a-hx', (input) => input.blur());
    assert.match(await text(page, '#panel-two .error'), new RegExp(why));
    assert.match(await text(page, '#answer-relation strong'), /cross/);
  }
  await page.$eval('#number-a-hx', (input) => (input.value = ''));
  await page.type('#number-a-hx', '0x1.8p+0\n');
  assert.equal(await page.$eval('#number-a-hx + code', (code) => code.textContent), '0x1.8p+0');
  await closeQuietly(page);
});

test('a link holds every bit', async () => {
  const page = await openPlayground();
  await choose(page, 'a', 'circle');
  await page.$eval('#number-a-r', (input) => (input.value = ''));
  await page.type('#number-a-r', '0.1\n');
  await page.waitForFunction(() => location.hash.includes('0x1.999999999999ap-4'));
  const link = await page.evaluate(() => location.hash),
    answers = await page.$$eval('.answers .exact', (all) => all.map((one) => one.textContent));
  const again = await openPlayground(link);
  assert.deepEqual(await again.$$eval('.answers .exact', (all) => all.map((one) => one.textContent)), answers);
  // And a link followed on the open page.
  await again.evaluate(() => (location.hash = '#tab=two&a=point,0x1p+0,0x0p+0&b=circle,0x0p+0,0x0p+0,0x1p+0'));
  await again.waitForFunction(
    () => document.querySelector('#answer-relation strong').textContent === 'A inside B, touching',
  );
  await closeQuietly(page);
  await closeQuietly(again);
});

test('huge and tiny scenes are shown', async () => {
  for (const e of [1000, -1000]) {
    const page = await openPlayground(`#a=circle,0x0p+0,0x0p+0,0x1p${e}&b=circle,0x1p${e},0x0p+0,0x1p${e}`);
    assert.equal(await value(page, 'overlap'), 'yes');
    assert.equal(
      await page.$eval(
        '#two-b-move',
        ({ style }) => Number.parseFloat(style.left) > 0 && Number.parseFloat(style.left) < 100,
      ),
      true,
    );
    await closeQuietly(page);
  }
});

/** The programs that the page offers, and what it says of each question. */
const offered = (page) =>
  page.$$eval('#panel-two .answers li', (rows) =>
    rows.map((row) => ({
      id: row.id.replace('answer-', ''),
      program: row.querySelector('.copy').dataset.program,
      value: row.querySelector('strong').textContent,
      detail: row.querySelector('.detail').textContent,
      exact: row.querySelector('.exact').textContent,
    })),
  );

const relations = ['DISJOINT', 'TOUCH', 'CROSS', 'INSIDE', 'INSIDE_TOUCH', 'CONTAINS', 'CONTAINS_TOUCH', 'EQUAL'];

/** A double as C's %a writes it. */
function ofHex(text) {
  const [, sign, digits, power] = /^(-?)0x([\d.a-f]+)p([+-]\d+)$/.exec(text),
    [whole, fraction = ''] = digits.split('.');
  return Number(`${sign}1`) * Number.parseInt(whole + fraction, 16) * 2 ** (Number(power) - 4 * fraction.length);
}

/** Whether a program printed what the page says. Python has words of its own for a refusal, C++ returns NaN or none. */
function agrees(line, language, { id, value, detail, exact }) {
  if (value === 'none' && language === 'cpp') return true;
  if (value === 'none') return language === 'python' ? / /.test(line) && Number.isNaN(Number(line)) : line.includes(detail);
  if (id === 'overlap') return { yes: ['1', 'True', 'true'], no: ['0', 'False', 'false'] }[value].includes(line);
  if (id === 'relation') {
    const name = detail.replace('exact: ', '');
    return [String(relations.indexOf(name)), name, name.toLowerCase()].includes(line);
  }
  if (id === 'crossings') return line === value.split(' ')[0];
  return Number(line) === ofHex(exact);
}

function allAgree(language, all) {
  const lines = printed(
    language,
    all.map(({ program }) => program),
  );
  assert.equal(lines.length, all.length);
  all.forEach((one, i) => assert.ok(agrees(lines[i], language, one), `${lines[i]}, not ${one.value}:\n${one.program}`));
}

test('all pairs of kinds: programs of C, Python and JavaScript say what the page says', async () => {
  const page = await openPlayground(),
    all = { c: [], python: [], javascript: [] };
  for (const a of [...kinds, ...paths]) {
    await choose(page, 'a', a);
    for (const b of [...kinds, ...paths]) {
      await choose(page, 'b', b);
      for (const [language, list] of Object.entries(all)) {
        await page.$eval(`#two-in-${language}`, (input) => input.click());
        list.push(...(await offered(page)));
      }
    }
  }
  for (const [language, list] of Object.entries(all)) {
    assert.equal(list.length, 169 * 8);
    allAgree(language, list);
  }
  await closeQuietly(page);
});

test('programs of C++ say what the page says', async () => {
  const page = await openPlayground(),
    all = [];
  await page.$eval('#two-in-cpp', (input) => input.click());
  for (const [a, b] of [
    ['rect', 'ellipse'],
    ['capsule', 'round_rect'],
    ['polygon', 'circle'],
  ]) {
    await choose(page, 'a', a);
    await choose(page, 'b', b);
    all.push(...(await offered(page)));
  }
  allAgree('cpp', all);
  await closeQuietly(page);
});

test('numbers that are hard to write come back: -0, beyond 2^63, the least', async () => {
  const page = await openPlayground('#a=circle,-0x0p+0,0x1p+70,0x1p-1074&b=circle,0x1p+40,0x1p+70,0x1.999999999999ap-4');
  for (const language of languages.filter((name) => name !== 'cpp')) {
    await page.$eval(`#two-in-${language}`, (input) => input.click());
    allAgree(language, await offered(page));
  }
  assert.match(await text(page, '#panel-two pre'), /-0\.0/);
  await closeQuietly(page);
});

test('the language of the calls, which wrap', async () => {
  const page = await openPlayground('', { width: 400 });
  for (const [language, call] of [
    ['c', 'vesica_boundary_distance(&a, &b, &out)'],
    ['cpp', 'vesica::boundary_distance(a, b)'],
    ['python', 'vesica.boundary_distance(a, b)'],
    ['javascript', 'vesica.boundaryDistance(a, b)'],
  ]) {
    await page.click(`label[for=two-in-${language}]`);
    assert.equal(await text(page, '#answer-outlines .call'), call);
    const cut = await page.$$eval('.answers .call, #panel-two pre', (all) =>
      all.map((one) => one.scrollWidth - one.clientWidth).filter((beyond) => beyond > 0),
    );
    assert.deepEqual(cut, []);
  }
  // The tab of motion has the same.
  await page.click('#tab-motion');
  await page.waitForSelector('#motion-call');
  assert.match(await text(page, '#motion-call .call'), /^vesica\.cast\(a, b, \[/);
  await closeQuietly(page);
});

test('an axis has its angle in degrees, which can be typed', async () => {
  const page = await openPlayground();
  assert.equal(await page.$eval('#number-a-angle', ({ value }) => value), '20');
  assert.equal(await page.$eval('#number-b-angle', ({ value }) => value), '-35');
  assert.equal(await text(page, 'label[for=number-a-angle]'), 'angle in °');
  await page.$eval('#number-a-angle', (input) => (input.value = ''));
  await page.type('#number-a-angle', '90\n');
  assert.deepEqual([await number(page, 'a', 'ux'), await number(page, 'a', 'uy')], [0, 1]);
  await page.keyboard.press('ArrowDown');
  assert.equal(await page.$eval('#number-a-angle', ({ value }) => value), '89');
  await choose(page, 'a', 'circle');
  assert.equal(await page.$('#number-a-angle'), null);
  assert.equal(await text(page, 'label[for=number-a-cx]'), 'centre x');
  await closeQuietly(page);
});

test('hexadecimal numbers are behind a switch', async () => {
  const page = await openPlayground();
  const seen = () =>
    page.$$eval('#panel-two code, #panel-two span', (all) =>
      all.some((one) => one.offsetParent !== null && /\b0x[01]/.test(one.textContent)),
    );
  assert.equal(await seen(), false);
  await page.click('#two-hex');
  assert.equal(await seen(), true);
  await page.click('#two-hex');
  assert.equal(await seen(), false);
  await closeQuietly(page);
});

test('copying puts the call on the clipboard, or says that there is none', async () => {
  const page = await openPlayground();
  await page.click('#answer-nearest .copy');
  await page.waitForFunction(() =>
    /copied|no clipboard/.test(document.querySelector('#answer-nearest .copy').textContent),
  );
  await closeQuietly(page);
});

test('the page fetches nothing from elsewhere', () => {
  const site = process.env.VESICA_SITE;
  for (const file of ['playground/index.html', 'playground/playground.css', 'site.css', 'index.html']) {
    assert.ok(!/(?:src|href|url\()=?["']?https?:/.test(readFileSync(`${site}/${file}`, 'utf8')), file);
  }
});
