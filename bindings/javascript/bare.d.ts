// SPDX-License-Identifier: Apache-2.0
import type { Module, Vesica } from './vesica.js';
export * from './vesica.js';

/** Loads the library by a module of the caller's choice. As no file is named here, a bundle carries that one alone. */
export function load(options: { module: Module }): Promise<Vesica>;
