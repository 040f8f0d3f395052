// SPDX-License-Identifier: Apache-2.0
// What goes wrong around the playground: spoilt links, a server that does not know .wasm, an engine without vectors.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { closeQuietly, openPlayground, served, text } from './browser.mjs';

const scene = (page) =>
  page.evaluate(() => [...document.querySelectorAll('.number input')].map((input) => input.value).join());

test('a spoilt link shows what is wrong, and the default scene', async () => {
  const plain = await openPlayground(),
    usual = await scene(plain);
  await closeQuietly(plain);
  const b = '&b=circle,0x0p+0,0x0p+0,0x1p+0';
  for (const [link, why] of [
    [`#a=square,0x0p+0${b}`, 'no known kind'],
    [`#a=circle,0x0p+0,0x0p+0${b}`, 'has 2 numbers; a circle has 3'],
    [`#a=circle,0x0p+0,0x0p+0,banana${b}`, 'no hexadecimal number'],
    [`#a=circle,0x0p+0,0x0p+0,0x1p+9999${b}`, 'no hexadecimal number'],
    [`#a=circle,0x0p+0,0x0p+0,-0x1p+0${b}`, 'invalid: a size is negative'],
    [`#a=rect,0x0p+0,0x0p+0,0x0p+0,0x0p+0,0x1p+0,0x1p+0${b}`, 'invalid: the axis is (0, 0)'],
    [`#a=polygon,0x0p+0,0x0p+0,0x1p+0${b}`, 'a corner of a has one number'],
    [`#a=polygon,0x0p+0,0x0p+0;${b}`, 'a corner of a is no hexadecimal number'],
    [`#a=polygon,0x0p+0,0x0p+0,0x1p+0,0x1p+0,0x1p+0,0x0p+0,0x0p+0,0x1p+0${b}`, 'invalid: edges of a polygon cross'],
    ['#a=point,0x0p+0,0x0p+0', 'one of the two shapes is missing'],
    ['#tab=nowhere', 'no tab'],
    ['#tab=motion&motion=0x1p+0,0x0p+0', 'has 3 numbers, not 2'],
    ['#tab=motion&motion=0x1p+0,0x0p+0,fast', 'not of hexadecimal numbers'],
    ['#tab=motion&motion=0x1p+0,0x0p+0,0x1p+21', 'turns by more than 2^20'],
    ['#x=1', 'means nothing'],
    ['#a=%E0%A4%A', 'spoilt'],
  ]) {
    const page = await openPlayground(link);
    assert.ok((await text(page, '#notice')).includes(why), `${link}: ${await text(page, '#notice')}`);
    assert.equal(await scene(page), usual);
    // A good link afterwards takes the notice away.
    await page.evaluate((rest) => (location.hash = `#a=point,0x0p+0,0x0p+0${rest}`), b);
    await page.waitForSelector('#notice', { hidden: true });
    await closeQuietly(page);
  }
});

test('a server that sends .wasm as text', async () => {
  served.wasm = 'text/plain';
  const page = await openPlayground('#tab=methods');
  await page.waitForSelector('#method-features');
  served.wasm = 'application/wasm';
  await closeQuietly(page);
});

test('a tab or a library that cannot be loaded is told at once', async () => {
  for (const [absent, why] of [
    ['/playground/motion/tab.mjs', /This part could not be loaded/],
    ['/vesica/vesica-simd.wasm', /The library could not be loaded: .*vesica-simd.wasm: 404/],
  ]) {
    served.absent = absent;
    const start = performance.now();
    await assert.rejects(openPlayground('#tab=motion'), why);
    served.absent = null;
    assert.ok(performance.now() - start < 25_000);
  }
});

test('vectors where the engine has them, and the plain module elsewhere', async () => {
  served.paths.length = 0;
  const page = await openPlayground();
  assert.match(await text(page, '#module'), /with vectors/);
  assert.deepEqual(
    served.paths.filter((path) => path.endsWith('.wasm')),
    ['/vesica/vesica-simd.wasm'],
  );
  const answers = await text(page, '.answers');
  await closeQuietly(page);
  served.paths.length = 0;
  const without = await openPlayground('', {
    before: (page) => page.evaluateOnNewDocument(() => (WebAssembly.validate = () => false)),
  });
  assert.match(await text(without, '#module'), /without vectors/);
  assert.deepEqual(
    served.paths.filter((path) => path.endsWith('.wasm')),
    ['/vesica/vesica.wasm'],
  );
  assert.equal(await text(without, '.answers'), answers);
  await closeQuietly(without);
});
