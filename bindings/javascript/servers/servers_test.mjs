// SPDX-License-Identifier: Apache-2.0
// The package as it is installed, under development servers and in production builds. In chromium a program loads the
// modules and asks them something.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { after, test } from 'node:test';
import esbuild from 'esbuild';
import puppeteer from 'puppeteer-core';
import * as vite from 'vite';
import webpack from 'webpack';
import WebpackDevServer from 'webpack-dev-server';

const browser = await puppeteer.launch({ executablePath: process.env.VESICA_CHROMIUM, args: ['--no-sandbox'] });
after(() => browser.close());

const host = '127.0.0.1';
const page = '<!doctype html><link rel="icon" href="data:,"><body><script type="module" src="./main.js"></script>';
const area = "const answer = vesica.area(rect(0, 0, 4, 2), rect(1, 0, 2, 2));";
const bare = (module) => `import { load, rect } from 'vesica/bare';
  import module from '${module}';
  const vesica = await load({ module });
  ${area}`;
const programs = {
  vesica: `import { load, rect } from 'vesica';
    const vesica = await load();
    ${area}`,
  overlap: `import { circle, load, rect } from 'vesica/overlap';
    const vesica = await load();
    const answer = vesica.overlap(rect(0, 0, 4, 2), circle(3, 0, 1));`,
  methods: `import { loadMethods } from 'vesica/methods';
    const box = { kind: 'rect', cx: 0, cy: 0, ux: 1, uy: 0, hx: 1, hy: 1 };
    const answer = (await loadMethods()).pointRectFrame({ kind: 'point', x: 0, y: 0 }, box);`,
  bareVite: bare('vesica/vesica-simd.wasm?url'),
  bareEsbuild: bare('vesica/vesica-simd.wasm'),
};
const all = ['vesica', 'overlap', 'methods'], allSay = '4 true yes';

/** A folder with a page and its program, main.js, which loads some of the programs above. */
function project(...names) {
  const folder = mkdtempSync(join(import.meta.dirname, 'project-'));
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  writeFileSync(join(folder, 'index.html'), page);
  names.forEach((name) => writeFileSync(join(folder, `${name}.js`), `${programs[name]}\nexport default answer;\n`));
  const imports = names.map((name) => `import ${name} from './${name}.js';\n`).join('');
  writeFileSync(join(folder, 'main.js'), `${imports}document.body.textContent = [${names}].join(' ');\n`);
  return folder;
}

/** What a page says at its end, and the modules that it fetched. */
async function shown(address) {
  const tab = await browser.newPage(), said = [], fetched = [];
  tab.on('console', (message) => /error|warn/.test(message.type()) && said.push(message.text()));
  tab.on('pageerror', (error) => said.push(String(error)));
  tab.on('requestfailed', (request) => said.push(`failed: ${request.url()}`));
  tab.on('response', (response) => /\.wasm/.test(response.url()) && fetched.push(response.url()));
  await tab.goto(address);
  const ended = tab.waitForFunction(() => document.body.textContent !== '', { timeout: 60000 });
  await ended.catch((error) => said.push(String(error)));
  const text = await tab.evaluate(() => document.body.textContent);
  await tab.close();
  assert.deepEqual(said, [], `${text} ${fetched}`);
  return { text, fetched: fetched.length };
}

/** The modules in a folder, by their names without the hashes that tools add. */
const modulesIn = (folder) =>
  readdirSync(folder, { recursive: true })
    .filter((file) => file.endsWith('.wasm'))
    .map((file) => /vesica(-overlap|-methods)?(-simd)?/.exec(basename(file))?.[0])
    .sort();

test('Vite, development', async () => {
  const server = await vite.createServer({ root: project(...all), server: { host, port: 0 }, logLevel: 'warn' });
  await server.listen();
  const said = await shown(server.resolvedUrls.local[0]).finally(() => server.close());
  assert.deepEqual(said, { text: allSay, fetched: 3 });
});

for (const [name, answer, modules] of [
  ['vesica', '4', ['vesica', 'vesica-simd']],
  ['overlap', 'true', ['vesica-overlap', 'vesica-overlap-simd']],
  ['methods', 'yes', ['vesica-methods']],
  ['bareVite', '4', ['vesica-simd']],
]) {
  test(`Vite, production, ${name}: the bundle has the modules that it may load, and fetches one`, async () => {
    const root = project(name), settings = { root, logLevel: 'warn', build: { target: 'esnext' } };
    await vite.build(settings);
    assert.deepEqual(modulesIn(join(root, 'dist')), modules);
    const server = await vite.preview({ ...settings, preview: { host, port: 0 } });
    const said = await shown(server.resolvedUrls.local[0]).finally(() => server.close());
    assert.deepEqual(said, { text: answer, fetched: 1 });
  });
}

test('webpack-dev-server', async () => {
  const root = project(...all);
  const settings = { mode: 'development', context: root, entry: './main.js', infrastructureLogging: { level: 'warn' } };
  const compiler = webpack({ ...settings, output: { filename: 'main.js', publicPath: '/' }, stats: 'errors-warnings' });
  const server = new WebpackDevServer({ static: root, host, port: 'auto' }, compiler);
  await server.start();
  const { port } = server.server.address();
  const said = await shown(`http://${host}:${port}/`).finally(() => server.stop());
  assert.deepEqual(said, { text: allSay, fetched: 3 });
});

test('esbuild, development and production', async () => {
  const root = project('bareEsbuild'), outdir = join(root, 'out');
  mkdirSync(outdir);
  writeFileSync(join(outdir, 'index.html'), page);
  const entryPoints = [join(root, 'main.js')], loader = { '.wasm': 'file' };
  const settings = { entryPoints, bundle: true, format: 'esm', outdir, loader };
  const context = await esbuild.context(settings);
  const { port } = await context.serve({ host, servedir: outdir });
  const said = await shown(`http://${host}:${port}/`).finally(() => context.dispose());
  assert.deepEqual(said, { text: '4', fetched: 1 });
  await esbuild.build({ ...settings, minify: true });
  assert.deepEqual(modulesIn(outdir), ['vesica-simd']);
  const size = statSync(join(outdir, 'main.js')).size;
  assert.ok(size < 60000, `main.js has ${size} bytes`);
});
