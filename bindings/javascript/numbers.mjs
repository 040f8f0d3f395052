// SPDX-License-Identifier: Apache-2.0
// Numbers that a caller gives.

/** A list of numbers and nothing else: undefined would become NaN, and null 0. */
export function allNumbers(list, what) {
  if (ArrayBuffer.isView(list)) return list;
  for (let i = 0; i < list.length; ++i) {
    if (typeof list[i] !== 'number') throw new TypeError(`${what}: element ${i} is ${String(list[i])}, not a number`);
  }
  return list;
}
