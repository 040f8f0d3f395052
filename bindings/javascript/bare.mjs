// SPDX-License-Identifier: Apache-2.0
// The same package for bundles that carry one module: it names none, and load({ module }) says which. See bare.d.ts.
import { libraryOf, refuseUnknown } from './loading.mjs';
export * from './library.mjs';

/** Loads `module`. */
export const load = async ({ module, ...others } = {}) => {
  refuseUnknown(others, 'module');
  if (module === undefined) throw new TypeError("load() of 'vesica/bare' needs a module: load({ module })");
  return libraryOf(module);
};
