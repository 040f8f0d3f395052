// SPDX-License-Identifier: Apache-2.0
// The same package by smaller modules, which only answer which shapes meet. overlap.d.ts says what they have.
import { hasVectors, libraryOf, refuseUnknown } from './loading.mjs';
export * from './library.mjs';

/** Loads vesica-overlap-simd.wasm, or vesica-overlap.wasm where there are no vectors, or `module`. */
export const load = async ({ module, simd = hasVectors(), ...others } = {}) => {
  refuseUnknown(others, 'module and simd');
  return libraryOf(module, () =>
    simd ? new URL('./vesica-overlap-simd.wasm', import.meta.url) : new URL('./vesica-overlap.wasm', import.meta.url));
};
