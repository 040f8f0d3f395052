// SPDX-License-Identifier: Apache-2.0
// near_tie_hash.mjs PROGRAM: runs tests/batch/near_tie_hash, built for WASI; exit status as there.
import { readFileSync } from 'node:fs';
import { WASI } from 'node:wasi';

const wasi = new WASI({ version: 'preview1', returnOnExit: true });
const imports = { wasi_snapshot_preview1: wasi.wasiImport };
const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), imports);
process.exitCode = wasi.start(instance);
