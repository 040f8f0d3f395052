// SPDX-License-Identifier: Apache-2.0
// Every way to give a module, and what is no module.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { circle, load } from 'vesica';
import { load as loadBare } from 'vesica/bare';
import { load as loadOverlap } from 'vesica/overlap';
import { loadMethods } from 'vesica/methods';

const file = pathToFileURL(createRequire(import.meta.url).resolve('vesica/vesica.wasm')), bytes = await readFile(file);
const server = createServer((request, response) => {
  const bodies = { '/module': bytes, '/page': '<!doctype html>', '/short': 'ab' }, body = bodies[request.url];
  response.writeHead(body === undefined ? 404 : 200);
  response.end(body);
});
await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
after(() => server.close());
const at = (path) => `http://127.0.0.1:${server.address().port}/${path}`;

test('a module is an address, an answer, bytes or compiled', async () => {
  const compiled = await WebAssembly.compile(bytes);
  const modules = [
    file, file.href, at('module'), new URL(at('module')), () => fetch(at('module')), await fetch(at('module')), bytes,
    new Uint8Array(bytes).buffer, compiled,
  ];
  for (const module of modules) {
    for (const by of [load, loadBare, loadOverlap]) {
      if (module instanceof Response && by !== load) continue; // It is read once.
      const vesica = await by({ module: typeof module === 'function' ? module() : module });
      assert.equal(vesica.isa, 'portable');
      assert.equal(vesica.area(circle(0, 0, 1), circle(0, 0, 1)) > 3, true);
    }
  }
});

test('an option that is not there is refused', async () => {
  for (const by of [load, loadBare, loadOverlap, loadMethods]) {
    await assert.rejects(by({ module: bytes, only: 'overlap' }), /TypeError: load\(\) has no option 'only', only module/);
  }
});

test('what is no module is an error that says where it was', async () => {
  for (const by of [load, loadOverlap, loadBare, loadMethods]) {
    await assert.rejects(by({ module: at('absent') }), /absent: 404 Not Found; load\(\{ module \}\) takes/);
    await assert.rejects(by({ module: fetch(at('page')) }), /page: this is no WebAssembly module; load/);
    await assert.rejects(by({ module: at('short') }), /short: this is no WebAssembly module; load/);
    await assert.rejects(by({ module: 7 }), TypeError);
  }
  await assert.rejects(loadBare(), /'vesica\/bare' needs a module: load\(\{ module \}\)/);
});
