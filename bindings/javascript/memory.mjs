// SPDX-License-Identifier: Apache-2.0
// The memory of the WebAssembly module, given out and taken back. The library itself never allocates in it.

const pageSize = 65536;
const alignment = 64; // what an index needs; every block has it
const scratchSize = 4096; // for the operands and results of calls about single shapes

const rounded = (size) => Math.ceil(Math.max(size, 1) / alignment) * alignment;

const { slice } = Object.getPrototypeOf(Uint8Array).prototype; // of every typed array: Buffer's own copies nothing

/** The bytes of a buffer or of any view, as they are in memory. */
export function bytesOf(given) {
  if (ArrayBuffer.isView(given)) return new Uint8Array(given.buffer, given.byteOffset, given.byteLength);
  if (typeof given?.byteLength === 'number') return new Uint8Array(given);
  throw new TypeError('bytes are an ArrayBuffer or a Uint8Array');
}

/** Blocks of a module's memory: one that is large enough, from where the last was on, else new pages at the end. */
export class Memory {
  #memory;
  #free = []; // [start, end) each, ascending, never side by side
  #from = 0; // where in that list the last block was found
  #doubles = new Float64Array(0);

  #scratch = 0;
  #scratchEnd = 0;

  constructor(memory) {
    this.#memory = memory;
  }

  /** It changes when the memory grows: a view of it is made anew for every use. */
  get buffer() {
    return this.#memory.buffer;
  }

  /**
   * What a call is to copy here, before it takes anything, a room included: a view of this memory would be detached if
   * it grows, so of that a copy.
   */
  apart(source) {
    return source?.buffer === this.buffer ? slice.call(source) : source;
  }

  /** All of it as doubles, for as long as nothing is taken. */
  get doubles() {
    const { buffer } = this.#memory;
    if (this.#doubles.buffer !== buffer) this.#doubles = new Float64Array(buffer);
    return this.#doubles;
  }

  /** From where there is more scratch: a room puts it back when it ends. */
  get scratch() {
    if (this.#scratchEnd === 0) {
      this.#scratch = this.take(scratchSize);
      this.#scratchEnd = this.#scratch + scratchSize;
    }
    return this.#scratch;
  }
  set scratch(address) {
    this.#scratch = address;
  }

  /** The address of `size` bytes of the scratch, or 0 where no more is left. */
  takeScratch(size) {
    const address = this.#scratch, wanted = rounded(size);
    if (wanted > this.#scratchEnd - address) return 0;
    this.#scratch += wanted;
    return address;
  }

  /** The address of `size` bytes. */
  take(size) {
    const wanted = rounded(size);
    let i = this.#find(wanted);
    if (i < 0) i = this.#grow(wanted);
    this.#from = i;
    const block = this.#free[i];
    const address = block[0];
    block[0] += wanted;
    if (block[0] === block[1]) this.#free.splice(i, 1);
    return address;
  }

  /** The place in the list of a block of `wanted` bytes or more, or -1. */
  #find(wanted) {
    const { length } = this.#free;
    for (let n = 0; n < length; ++n) {
      const i = (this.#from + n) % length, [start, end] = this.#free[i];
      if (end - start >= wanted) return i;
    }
    return -1;
  }

  /** How many free blocks begin below an address. */
  #below(address) {
    let low = 0, high = this.#free.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.#free[middle][0] < address) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  give(address, size) {
    const end = address + rounded(size), i = this.#below(address), before = this.#free[i - 1], after = this.#free[i];
    const joinsBefore = before?.[1] === address, joinsAfter = after?.[0] === end;
    if (joinsAfter) after[0] = joinsBefore ? before[0] : address;
    else if (joinsBefore) before[1] = end;
    else this.#free.splice(i, 0, [address, end]);
    if (joinsBefore && joinsAfter) this.#free.splice(i - 1, 1);
  }

  /** Pages for a block of so many bytes; the place of the block in the list. */
  #grow(wanted) {
    const last = this.#free[this.#free.length - 1];
    const length = this.buffer.byteLength;
    const there = last !== undefined && last[1] === length ? length - last[0] : 0;
    const pages = Math.ceil((wanted - there) / pageSize);
    try {
      this.#memory.grow(pages);
    } catch {
      throw new RangeError(`no room for ${wanted} bytes: a WebAssembly module has 4 GiB at most`);
    }
    this.give(length, pages * pageSize);
    return this.#free.length - 1;
  }
}

/** Blocks that are given back together, when a call is over. A room that is made in another one ends before it. */
export class Room {
  #memory;
  #blocks = null;
  #scratch;

  constructor(memory) {
    this.#memory = memory;
    this.#scratch = memory.scratch;
  }

  take(size) {
    const there = this.#memory.takeScratch(size);
    if (there !== 0) return there;
    const address = this.#memory.take(size);
    (this.#blocks ??= []).push([address, size]);
    return address;
  }

  end() {
    this.#memory.scratch = this.#scratch;
    for (const [address, size] of this.#blocks ?? []) this.#memory.give(address, size);
  }
}
