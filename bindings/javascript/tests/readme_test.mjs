// SPDX-License-Identifier: Apache-2.0
// The README's example runs, and gives what its comments say.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';

test('the example of the README', async () => {
  const [, example] = /```js\n([^]*?)```/.exec(readFileSync(new URL('README.md', import.meta.url), 'utf8'));
  // What a comment says in so many words is asserted; the rest must run.
  const lines = example.split('\n').map((line) => {
    const [, code, said] = /^(vesica\..*?\));\s*\/\/ (true|'cross'|Uint8Array \[1, 0\])$/.exec(line) ?? [];
    if (/throws VesicaError/.test(line)) return `throws(() => ${line.split(';')[0]}, VesicaError);`;
    return code === undefined ? line : `same(${code}, ${said.replace(/Uint8Array (.*)/, 'Uint8Array.from($1)')});`;
  });
  const asserts = lines.filter((line) => /^(same|throws)\(/.test(line)).length;
  const imports = ["{ VesicaError } from 'vesica'", "{ deepEqual as same, throws } from 'node:assert/strict'"];
  const head = imports.map((each) => `import ${each};\n`).join('');
  const file = new URL('example.mjs', import.meta.url);
  writeFileSync(file, head + lines.join('\n'));
  await import(file);
  assert.ok(asserts >= 4);
});
