// SPDX-License-Identifier: Apache-2.0
// Vesica in JavaScript, by WebAssembly: for Node, browsers and every other host of modules. Copy this file beside
// vesica.wasm; it needs nothing else.
//
// The module has one memory, and no function of the library allocates in it or keeps anything. So the host adds pages
// once, at load, and gives them out itself: its arrays are views of that memory, which calls read and write in place,
// and no view is ever detached, for the memory does not grow again.

/** Kinds, in the order of shapes. */
export const kinds = { point: 0, segment: 1, circle: 2, aabb: 3, rect: 4, ellipse: 5, capsule: 6, round_rect: 7 };

/** What this file is written to: VESICA_VERSION of its vesica.h. */
const version = 100;
const pageSize = 65536;
/** The most numbers that a shape has. */
const mostFields = 7;
/** sizeof(vesica_shapes_f64) here: pointers and ptrdiff_t have 4 bytes, not 8 as in capi/vesica.json. */
const shapesSize = 72;
const arrayTypes = { f64: Float64Array, f32: Float32Array };

/** An error code of the library; what it means is the message. */
export class VesicaError extends Error {
  constructor(message, code) {
    super(message);
    this.name = 'VesicaError';
    this.code = code;
  }
}

/** Loads the module from its bytes. room: bytes of memory for arrays and answers. */
export async function load(bytes, room = 1 << 20) {
  const { instance } = await WebAssembly.instantiate(bytes);
  const found = instance.exports.vesica_version();
  if (found < version) throw new Error(`vesica ${found} is older than ${version}`);
  return new Vesica(instance.exports, room);
}

class Vesica {
  #free;
  #end;
  #scratch;

  constructor(exports, room) {
    this.c = exports; // every function of vesica.h by its name: an int64_t is a BigInt, a pointer an address
    const scratchSize = 2 * mostFields * 8;
    const pages = Math.ceil((room + scratchSize) / pageSize);
    this.#free = exports.memory.grow(pages) * pageSize;
    this.#end = this.#free + pages * pageSize;
    this.#scratch = this.reserve(scratchSize);
  }

  /** The address of `size` bytes of the module's memory, aligned to 16. They are never given back. */
  reserve(size) {
    const address = this.#free;
    if (!(size >= 0 && size <= this.#end - address)) throw new RangeError(`no room for ${size} bytes: load with more`);
    this.#free = address + Math.ceil(size / 16) * 16;
    return address;
  }

  /** An array of shapes. Write them to its `numbers`, one after the other; they may change between calls. */
  shapes(kind, count, scalar = 'f64') {
    const fields = this.#check(this.c.vesica_field_count(kind));
    const stride = fields * arrayTypes[scalar].BYTES_PER_ELEMENT;
    const base = this.reserve(count * stride), address = this.reserve(shapesSize);
    this.#check(this.c[`vesica_shapes_from_records_${scalar}`](kind, BigInt(count), base, stride, address));
    return { scalar, count, address, numbers: new arrayTypes[scalar](this.c.memory.buffer, base, count * fields) };
  }

  /** `length` bytes for answers. */
  answers(length) {
    return new Uint8Array(this.c.memory.buffer, this.reserve(length), length);
  }

  /** Do two shapes, given as arrays of their numbers, share a point? Touching counts. */
  overlap(kindA, a, kindB, b, scalar = 'f64') {
    const numbers = new arrayTypes[scalar](this.c.memory.buffer, this.#scratch, 2 * mostFields);
    numbers.set(this.#fitting(kindA, a), 0);
    numbers.set(this.#fitting(kindB, b), mostFields);
    const second = this.#scratch + mostFields * numbers.BYTES_PER_ELEMENT;
    return this.#check(this.c[`vesica_overlap_${scalar}`](kindA, this.#scratch, kindB, second)) === 1;
  }

  /**
   * Overlap of two arrays of shapes in step, an array of one repeated: out[i] is 1 or 0. Returns how many are 1. Where
   * a shape is invalid it throws, with every other answer in `out` all the same.
   */
  overlapMany(a, b, out) {
    const count = a.count === 1 ? b.count : a.count;
    if (out.length < count || out.buffer !== this.c.memory.buffer) throw new RangeError('no such room for answers');
    if (a.scalar !== b.scalar) throw new TypeError('arrays of one scalar type');
    return this.#check(Number(this.c[`vesica_overlap_many_${a.scalar}`](a.address, b.address, out.byteOffset)));
  }

  #fitting(kind, numbers) {
    const wanted = this.#check(this.c.vesica_field_count(kind));
    if (numbers.length !== wanted) throw new RangeError(`a shape of kind ${kind} has ${wanted} numbers`);
    return numbers;
  }

  #check(answer) {
    if (answer >= 0) return answer;
    throw new VesicaError(this.#text(this.c.vesica_strerror(answer)), answer);
  }

  #text(address) {
    const bytes = new Uint8Array(this.c.memory.buffer, address);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }
}
