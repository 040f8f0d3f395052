// SPDX-License-Identifier: Apache-2.0
// Every page that is not doxygen's: quiet, without a violation of axe-core's rules, and no wider than a phone.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { closeQuietly, open, openPlayground } from './browser.mjs';

const axe = readFileSync(new URL('./node_modules/axe-core/axe.min.js', import.meta.url), 'utf8');
const pages = readdirSync(process.env.VESICA_SITE).filter((name) => name.endsWith('.html'));

async function look(page, where) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  const found = violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(' | ')}`);
  assert.deepEqual(found, [], where);
  const [wide, window] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  assert.ok(wide <= window, `${where} is ${wide} pixels wide in a window of ${window}`);
  await closeQuietly(page);
}

const looks = [
  { dark: false, width: 1200 },
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

test('the reference has every function, each once', async () => {
  const description = JSON.parse(readFileSync(`${process.env.VESICA_PICTURES}/../../capi/vesica.json`, 'utf8'));
  const text = [...new Set(description.functions.map(({ header }) => header.replaceAll('_', '__').replace('.h', '_8h')))]
    .map((page) => readFileSync(`${process.env.VESICA_SITE}/reference/${page}.html`, 'utf8'))
    .join();
  for (const { name } of description.functions) assert.equal(text.split(`</span>${name}()</h2>`).length, 2, name);
  assert.equal(text.split('The rules here hold for every function').length, 2);
  await closeQuietly(await open('reference/index.html'));
});
