// SPDX-License-Identifier: Apache-2.0
// A file server, and chromium on a page of it. Whatever a page says on the console is kept, and fails the test.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { after } from 'node:test';
import puppeteer from 'puppeteer-core';

const site = process.env.VESICA_SITE;
const types = {
  '.html': 'text/html',
  '.mjs': 'text/javascript',
  '.css': 'text/css',
  '.js': 'text/javascript',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.wasm': 'application/wasm',
};

/** What was asked for, the type that .wasm files are sent with, and a path that is not found. */
export const served = { paths: [], wasm: 'application/wasm', absent: null };

const server = createServer(async (request, response) => {
  const { pathname } = new URL(request.url, 'http://site');
  const path = pathname.endsWith('/') ? `${pathname}index.html` : pathname;
  served.paths.push(path);
  try {
    if (path === served.absent) throw new Error(`${path} is absent`);
    const body = await readFile(join(site, path));
    response.writeHead(200, {
      'content-type': extname(path) === '.wasm' ? served.wasm : (types[extname(path)] ?? 'application/octet-stream'),
    });
    response.end(body);
  } catch {
    response.writeHead(404);
    response.end();
  }
});
await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
export const address = `http://127.0.0.1:${server.address().port}/`;

const browser = await puppeteer.launch({
  executablePath: process.env.VESICA_CHROMIUM,
  // No sandbox in a container; WebGL by the processor.
  args: [
    '--no-sandbox',
    '--use-gl=angle',
    '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader',
    '--force-device-scale-factor=1',
    '--hide-scrollbars',
  ],
});
after(async () => {
  const gone = new Promise((exits) => browser.process().once('exit', exits));
  // All of its processes: one that has still to draw would be waited for, up to a minute.
  process.kill(-browser.process().pid, 'SIGKILL');
  await gone;
  server.close();
});

/** A page of the site. { width, height, dark, still, before }: before(page) is called ahead of loading it. */
export async function open(
  path,
  { width = 1200, height = 900, dark = false, still = true, before = async () => {} } = {},
) {
  const page = await browser.newPage();
  // What the processor has still to draw of a page before delays the next one by up to half a minute.
  page.setDefaultTimeout(180000);
  page.messages = [];
  page.on('console', (message) => page.messages.push(message.text()));
  page.on('pageerror', (error) => page.messages.push(String(error)));
  page.on('requestfailed', (request) => page.messages.push(`failed: ${request.url()}`));
  await page.setViewport({ width, height });
  await page.emulateMediaFeatures([
    { name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' },
    { name: 'prefers-reduced-motion', value: still ? 'reduce' : 'no-preference' },
  ]);
  await before(page);
  await page.goto(address + path);
  return page;
}

/** The playground, when the library is loaded and the tab is there. If either cannot be, it says why. */
export async function openPlayground(state = '', options = {}) {
  const page = await open(`playground/${state}`, options);
  const shown = await page.waitForFunction(
    () => {
      const notice = document.getElementById('notice').textContent;
      if (notice.includes('could not be loaded')) return notice;
      return document.querySelector('html[data-ready] [role=tabpanel]:not([hidden]) > *') !== null;
    },
    { polling: 'mutation' },
  );
  const failure = await shown.jsonValue();
  if (failure === true) return page;
  const said = [failure, ...page.messages].join('\n');
  await page.close();
  throw new Error(said);
}

/** Nothing was said on the console. */
export async function closeQuietly(page) {
  assert.deepEqual(page.messages, []);
  await page.close();
}

export const text = (page, selector) => page.$eval(selector, (node) => node.textContent);

/** The middle of an element, in the window. */
export async function middle(page, selector) {
  const handle = await page.$(selector);
  await handle.evaluate((node) => node.scrollIntoView({ block: 'center' }));
  const { x, y, width, height } = await handle.boundingBox();
  return [x + width / 2, y + height / 2];
}
