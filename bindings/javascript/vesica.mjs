// SPDX-License-Identifier: Apache-2.0
// Vesica for JavaScript, by WebAssembly: for browsers, Node and Deno. vesica.d.ts describes every call.
import { hasVectors, libraryOf, refuseUnknown } from './loading.mjs';
export * from './library.mjs';

/** Loads vesica-simd.wasm, or vesica.wasm where there are no vectors: that beside this file, or `module`. */
export const load = async ({ module, simd = hasVectors(), ...others } = {}) => {
  refuseUnknown(others, 'module and simd');
  return libraryOf(module, () =>
    simd ? new URL('./vesica-simd.wasm', import.meta.url) : new URL('./vesica.wasm', import.meta.url));
};
