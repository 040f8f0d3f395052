// SPDX-License-Identifier: Apache-2.0
import type { Module, Vesica } from './vesica.js';
export * from './vesica.js';

/**
 * Loads the library by vesica-overlap-simd.wasm or vesica-overlap.wasm, which have little more than a third of the
 * size: `overlap`, `interiorsOverlap`, `relation`, `contains`, their matrices and selections, `bounds`, `boundsMany`,
 * and an index with `join` and `select`. All else throws an Error.
 */
export function load(options?: { module?: Module; simd?: boolean }): Promise<Vesica>;
