// SPDX-License-Identifier: Apache-2.0
// What is drawn is what was drawn before: pictures without text, as fonts differ. With VESICA_DRAW=1 docs/pictures is
// written anew.
import assert from 'node:assert/strict';
import { copyFileSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { test } from 'node:test';
import { closeQuietly, open, openPlayground } from './browser.mjs';

const folder = process.env.VESICA_PICTURES;
const pictures = {
  'two.png': ['#tab=two', '#panel-two .picture svg'],
  'edge.png': ['#tab=edge', '#double svg'],
  'crowd.png': ['#tab=crowd', '#panel-crowd canvas'],
  'minkowski.png': ['#tab=methods', '#method-minkowski .picture svg'],
};

/** How many in a thousand pixels differ by more than a little. */
const difference = (page, one, other) =>
  page.evaluate(
    async (...urls) => {
      const [first, second] = await Promise.all(
        urls.map(async (url) => {
          const image = await createImageBitmap(await (await fetch(url)).blob()),
            canvas = new OffscreenCanvas(image.width, image.height);
          const context = canvas.getContext('2d');
          context.drawImage(image, 0, 0);
          return {
            size: [image.width, image.height],
            data: context.getImageData(0, 0, image.width, image.height).data,
          };
        }),
      );
      if (first.size.join() !== second.size.join()) return 1000;
      let count = 0;
      for (let i = 0; i < first.data.length; i += 4) {
        if ([0, 1, 2].some((k) => Math.abs(first.data[i + k] - second.data[i + k]) > 48)) ++count;
      }
      return (4000 * count) / first.data.length;
    },
    one,
    other,
  );

/** Three hundred shapes: few enough to see, and a small file. */
function fewer(input) {
  input.value = 1;
  input.dispatchEvent(new Event('input'));
}

const asUrl = (path) => `data:image/png;base64,${readFileSync(path).toString('base64')}`;

test('pictures', async (t) => {
  const judge = await open('index.html');
  for (const [name, [state, selector]] of Object.entries(pictures)) {
    const page = await openPlayground(state, { width: 800, height: 700 }),
      drawn = `pictures/${name}`;
    if (name === 'edge.png') await page.click('#edge-example');
    if (name === 'crowd.png') await page.$eval('#crowd-count', fewer);
    const element = await page.waitForSelector(selector);
    // Handles and their letters lie above the picture.
    await page.addStyleTag({ content: '.handle { visibility: hidden }' });
    await element.screenshot({ path: drawn });
    if (process.env.VESICA_DRAW) copyFileSync(drawn, `${folder}/${name}`);
    const apart = await difference(judge, asUrl(drawn), asUrl(`${folder}/${name}`));
    t.diagnostic(`${name}: ${apart.toFixed(1)} of 1000 pixels differ`);
    assert.ok(apart < 10, name);
    await closeQuietly(page);
  }
  await closeQuietly(judge);
});

test('the first picture of the README', async () => {
  const page = await openPlayground('#tab=two', { width: 1120, height: 900 });
  const [top, height] = await page.evaluate(() => {
    for (const part of document.querySelectorAll('#panel-two :is(.shapes, .told pre, .told .hint, .told .control)')) part.remove();
    const box = document.querySelector('#panel-two .columns').getBoundingClientRect();
    return [box.top, box.height];
  });
  await page.screenshot({
    path: 'pictures/playground.png',
    clip: { x: 0, y: top - 8, width: 1120, height: height + 16 },
  });
  if (process.env.VESICA_DRAW) copyFileSync('pictures/playground.png', `${folder}/playground.png`);
  await closeQuietly(page);
});

test('all pictures of the repository take 300 kB at most', () => {
  const sizes = readdirSync(folder).map((name) => statSync(`${folder}/${name}`).size);
  assert.ok(sizes.length >= 5 && sizes.every((size) => size > 0));
  assert.ok(sizes.reduce((sum, size) => sum + size) <= 300000, sizes.join());
});
