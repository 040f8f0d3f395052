// SPDX-License-Identifier: Apache-2.0
// Vesica for JavaScript, by WebAssembly: for browsers, Node and Deno. vesica.d.ts describes every call.
import { hasVectors, libraryOf } from './loading.mjs';
export * from './library.mjs';

/** Loads vesica-simd.wasm, or vesica.wasm where there are no vectors: that beside this file, or `module`. */
export const load = async ({ module, simd = hasVectors() } = {}) =>
  libraryOf(module, () =>
    simd ? new URL('./vesica-simd.wasm', import.meta.url) : new URL('./vesica.wasm', import.meta.url));
