// SPDX-License-Identifier: Apache-2.0
// Loads and compiles WebAssembly modules, in browsers, Node and Deno.
import * as constants from './constants.mjs';
import { Vesica } from './library.mjs';

const isResponse = (given) => typeof Response !== 'undefined' && given instanceof Response;

async function bytesAt(url) {
  if (url.protocol !== 'file:') return bytesOfAnswer(await fetch(url), url);
  // No bundler may look for Node's module: the name is not a literal, and the comments speak to those that ask.
  const files = 'node:fs/promises';
  const { readFile } = await import(/* webpackIgnore: true */ /* turbopackIgnore: true */ /* @vite-ignore */ files);
  return readFile(url);
}

async function bytesOfAnswer(answer, url = answer.url) {
  const advice = 'load({ module }) takes the address of the module, or its bytes';
  if (!answer.ok) throw new Error(`${url}: ${answer.status} ${answer.statusText}; ${advice}`);
  const bytes = await answer.arrayBuffer();
  // Development servers send a page in place of a file that is not there.
  const isModule = bytes.byteLength >= 4 && new DataView(bytes).getUint32(0) === 0x0061736d;
  if (!isModule) throw new Error(`${url}: this is no WebAssembly module; ${advice}`);
  return bytes;
}

/**
 * The exports of a module: `given`, if it is not undefined, else that at beside(). beside() has to hold a literal name
 * and import.meta.url, side by side: bundlers search the text for these, and put the file into what they make.
 */
export async function exportsOf(given, beside) {
  const source = await (given ?? address(beside));
  const compiled = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(await bytesFrom(source));
  return (await WebAssembly.instantiate(compiled)).exports;
}

function address(beside) {
  try {
    return beside();
  } catch {
    const words = 'the address of this script is unknown, so the module beside it cannot be found';
    throw new Error(`${words}: bundle as an ES module, or give load({ module }) its address or bytes`);
  }
}

function bytesFrom(source) {
  if (isResponse(source)) return bytesOfAnswer(source);
  if (typeof source === 'string') return bytesAt(new URL(source, globalThis.document?.baseURI));
  return source instanceof URL ? bytesAt(source) : source;
}

/** Refuses options that load() does not have: a misspelt one would be ignored. */
export function refuseUnknown(options, names) {
  const [name] = Object.keys(options);
  if (name !== undefined) throw new TypeError(`load() has no option '${name}', only ${names}`);
}

// A module whose only function makes a vector: () -> v128, i8x16.splat of 0.
const vectorModule = new Uint8Array([
  0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, // magic, version
  1, 5, 1, 0x60, 0, 1, 0x7b, // types
  3, 2, 1, 0, // functions
  10, 8, 1, 6, 0, 0x41, 0, 0xfd, 0x0f, 0x0b, // code
]);

export const hasVectors = () => WebAssembly.validate(vectorModule);

/** The exports of a module that may have some of the library's functions only: others throw, and say so. */
const withWords = (exports) =>
  Object.setPrototypeOf({ ...exports }, new Proxy(Object.prototype, {
    get(target, name) {
      if (typeof name !== 'string' || !name.startsWith('vesica_')) return target[name];
      throw new Error(`this module does not have ${name}: load() of 'vesica' has all functions`);
    },
  }));

/** The library by a module: `given`, or that at beside(). */
export async function libraryOf(given, beside) {
  const exports = await exportsOf(given, beside), version = exports.vesica_version();
  if (version < constants.VERSION) {
    const words = `vesica ${version} is older than ${constants.VERSION}, which this package needs`;
    throw new Error(`${words}: load the module that came with it`);
  }
  return new Vesica(withWords(exports));
}
