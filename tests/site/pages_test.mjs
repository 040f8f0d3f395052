// SPDX-License-Identifier: Apache-2.0
// Every page: quiet, without a violation of axe-core's rules, and no wider than a phone; the start page, and the reference.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { closeQuietly, open, openPlayground, text } from './browser.mjs';

const axe = readFileSync(new URL('./node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');
const pages = readdirSync(process.env.VESICA_SITE).filter((name) => name.endsWith('.html'));

/** rules: those of axe-core that are asked; by default all. */
async function look(page, where, rules) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate((runOnly) => globalThis.axe.run(runOnly && { runOnly }), rules);
  const found = violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(' | ')}`);
  assert.deepEqual(found, [], where);
  const [wide, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.ok(wide <= window, `${where} is ${wide} pixels wide in a window of ${window}`);
  await closeQuietly(page);
}

const looks = [
  { dark: false, width: 1280, height: 800 },
  { dark: true, width: 360 },
];

test('pages', async () => {
  assert.ok(pages.length >= 8);
  for (const name of pages) {
    for (const how of looks) await look(await open(name, how), `${name} ${JSON.stringify(how)}`);
  }
});

test('tabs of the playground', async () => {
  for (const tab of ['two', 'edge', 'motion', 'crowd', 'methods']) {
    for (const how of looks) await look(await openPlayground(`#tab=${tab}`, how), `${tab} ${JSON.stringify(how)}`);
  }
});

test('the start page says for whom, how fast and where from above the fold', async () => {
  const page = await open('index.html', { width: 1280, height: 800 });
  for (const id of ['whom', 'speed', 'source']) {
    const [top, bottom] = await page.$eval(`#${id}`, (part) => {
      const box = part.getBoundingClientRect();
      return [box.top, box.bottom];
    });
    assert.ok(top > 0 && bottom <= 800, `${id}: ${top} to ${bottom}`);
  }
  // Each figure is one of the page that has them all.
  const told = await text(page, '#speed'),
    measured = readFileSync(`${process.env.VESICA_SITE}/benchmarks.html`, 'utf8').replace(/<[^>]*>/g, ' ');
  const figures = told.match(/[\d.,]+ (?=ns)/g);
  assert.ok(figures.length >= 4);
  for (const figure of figures) assert.ok(measured.includes(figure.trim()), figure);
  assert.match(told, /AMD EPYC.*\.\/run bench/s);
  assert.match(await text(page, '#source'), /git clone \S+/);
  await closeQuietly(page);
});

test('one program at a time, in eight languages, by keys', async () => {
  const page = await open('index.html');
  const shown = () =>
    page.$$eval('.languages pre', (all) => all.filter((one) => one.offsetParent !== null).map((one) => one.textContent));
  await page.focus('#in-c');
  const programs = [];
  for (let i = 0; i < 8; ++i) {
    programs.push(...(await shown()));
    await page.keyboard.press('ArrowRight');
  }
  assert.equal(new Set(programs).size, 8);
  for (const [i, idiom] of [/vesica_overlap\(&car/, /vesica::overlap/, /rects\(.*degrees=True/, /load\(\)/, /use vesica::/].entries())
    assert.match(programs[i], idiom);
  await closeQuietly(page);
});

test('on a phone the picture comes before all links but one row', async () => {
  for (const page of [await open('index.html', { width: 400 }), await openPlayground('#tab=two', { width: 400 })]) {
    const [head, picture, links] = await page.evaluate(() =>
      ['header.site', '.opening img, #panel-two .picture', '#pages'].map((name) =>
        document.querySelector(name).getBoundingClientRect(),
      ).map(({ top, height }) => [top, height]),
    );
    assert.ok(head[1] < 60, `${head[1]} pixels of head`);
    assert.ok(picture[0] < 400, `the picture begins at ${picture[0]}`);
    assert.ok(picture[0] + picture[1] <= links[0]);
    await closeQuietly(page);
  }
});

test('tables have the width of the page', async () => {
  const page = await open('functions.html', { width: 1280 });
  for (const cut of await page.$$eval('.scroll', (all) => all.map((one) => one.scrollWidth - one.clientWidth)))
    assert.equal(cut, 0);
  await closeQuietly(page);
});

test('the reference has the colours of the site, light and dark, and fits a phone', async () => {
  for (const name of ['index', 'vesica_8h', 'vesica__motion_8h', 'files', 'structvesica__rect__f64', 'namespacevesica']) {
    for (const how of looks) {
      const page = await open(`reference/${name}.html`, how);
      const paper = await page.$eval('body', (body) => getComputedStyle(body).backgroundColor);
      assert.equal(paper, how.dark ? 'rgb(22, 23, 27)' : 'rgb(253, 253, 251)');
      await look(page, `${name} ${JSON.stringify(how)}`, ['color-contrast', 'label', 'link-name', 'list']);
    }
  }
});

test('the reference is searched within names', async () => {
  const page = await open('reference/index.html');
  await page.focus('#MSearchField');
  await page.keyboard.type('overlap_sel');
  const results = await page.waitForFrame((frame) => frame.url().includes('overlap_sel'));
  await results.waitForFunction(() => document.querySelector('.SRResult[style*=block]') !== null);
  const found = await results.$$eval('.SRResult', (all) =>
    all.filter(({ style }) => style.display === 'block').map((one) => one.querySelector('.SRSymbol').textContent),
  );
  assert.ok(found.includes('vesica_overlap_select_f64'));
  assert.ok(found.every((name) => name.includes('overlap_sel')), found.join());
  await Promise.all([page.waitForNavigation(), results.click('.SRResult[style*=block] a')]);
  assert.match(page.url(), /reference\/vesica_8h\.html#/);
  await page.close();
});

test('the reference has every function, each once', async () => {
  const description = JSON.parse(readFileSync(`${process.env.VESICA_PICTURES}/../../capi/vesica.json`, 'utf8'));
  const whole = [...new Set(description.functions.map(({ header }) => header.replaceAll('_', '__').replace('.h', '_8h')))]
    .map((page) => readFileSync(`${process.env.VESICA_SITE}/reference/${page}.html`, 'utf8'))
    .join();
  for (const { name } of description.functions) assert.equal(whole.split(`</span>${name}()</h2>`).length, 2, name);
  assert.equal(whole.split('The rules here hold for every function').length, 2);
  await closeQuietly(await open('reference/index.html'));
});
