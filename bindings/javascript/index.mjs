// SPDX-License-Identifier: Apache-2.0
// All pairs among millions: an index of shapes, joins, windows and nearest shapes.
import * as constants from './constants.mjs';
import { ratioNumber } from './measures.mjs';
import { indexCastFirst, motionOf } from './motion.mjs';
import { aabb, distanceFor, scalars, ShapeArray, shapesSize } from './shapes.mjs';

const queries = {
  overlap: constants.JOIN_OVERLAP,
  bounds: constants.JOIN_BOUNDS,
  contains: constants.JOIN_CONTAINS,
  inside: constants.JOIN_INSIDE,
  interiors: constants.JOIN_INTERIORS,
};
const pairsACall = 1 << 14;

/** A part of a join, as C takes it: BigInt would wrap a number that has no place in 64 bits. */
function partOf(part, parts) {
  for (const number of [part, parts]) {
    if (!Number.isSafeInteger(number)) throw new RangeError(`part and parts are whole numbers, not ${String(number)}`);
  }
  return [BigInt(part), BigInt(parts)];
}

function checkSets(sets, scalar, memory) {
  for (const set of sets) {
    if (!(set instanceof ShapeArray)) throw new TypeError('an index is of arrays of shapes, as shapes() makes them');
    set.addressIn(memory);
    if (set.scalar !== scalar) throw new TypeError('the arrays of an index are all f64 or all f32');
  }
}

/** Made by Vesica.index(...) and Vesica.indexFromBytes(...). */
export class Index {
  #vesica;
  #sets;
  #struct; // the sets' structs, side by side
  #index;
  #size;
  #builds = 0;
  #blocks = [];

  constructor(vesica, sets, bytes = undefined) {
    if (sets.length === 0) throw new TypeError('an index is of one array of shapes or more; an array may be empty');
    checkSets(sets, sets[0]?.scalar, vesica.memory);
    this.#vesica = vesica;
    this.#sets = sets;
    this.scalar = sets[0].scalar;
    this.length = sets.reduce((sum, set) => sum + set.length, 0);
    this.#struct = this.#take(sets.length * shapesSize);
    this.#writeStructs(sets, this.#struct);
    vesica.own(this, this.#blocks);
    try {
      if (bytes === undefined) this.#build();
      else this.#read(bytes);
    } catch (error) {
      this.free();
      throw error;
    }
  }

  /** Memory that is this index's until it is freed or collected. */
  #take(size) {
    const address = this.#vesica.memory.take(size);
    this.#blocks.push([address, size]);
    return address;
  }

  /** Where the index is. */
  get #address() {
    if (this.#index === 0) throw new TypeError('an index was freed');
    return this.#index;
  }

  /** The arguments for the index and its arrays, which a call reads too. */
  #operands() {
    for (const set of this.#sets) set.addressIn(this.#vesica.memory, 'an array of an index');
    return [this.#address, this.#struct, this.#sets.length];
  }

  /** The structs of some arrays, side by side. */
  #writeStructs(sets, to) {
    const bytes = new Uint8Array(this.#vesica.memory.buffer);
    sets.forEach((set, i) => bytes.copyWithin(to + i * shapesSize, set.address, set.address + shapesSize));
  }

  #build() {
    this.#size = this.#vesica.check(this.#vesica.c.vesica_index_size(BigInt(this.length)));
    this.#index = this.#take(this.#size);
    this.#write(this.#size);
    this.#shrink();
  }

  /** Builds into `room` bytes at the index's place. */
  #write(room) {
    const vesica = this.#vesica, { c } = vesica, size = vesica.check(c.vesica_index_scratch(BigInt(this.length)));
    const code = vesica.inRoom((scratch) => {
      const [memory, with_] = [[this.#index, BigInt(room)], [scratch.take(size), BigInt(size)]];
      return Number(c[`vesica_index_build_${this.scalar}`](this.#struct, this.#sets.length, ...memory, ...with_));
    });
    /** Whether invalid shapes were left out. */
    this.incomplete = code === constants.E_SHAPE;
    if (!this.incomplete) vesica.check(code);
  }

  /** Gives back what the index does not use. */
  #shrink() {
    const vesica = this.#vesica, used = vesica.check(vesica.c.vesica_index_bytes(this.#index));
    if (used < this.#size) vesica.memory.give(this.#index + used, this.#size - used);
    this.#blocks[1][1] = this.#size = used;
  }

  /** The index of the arrays as they are now, in the place of this one: from the second time on no memory is taken. */
  rebuild() {
    this.#operands();
    ++this.#builds;
    const vesica = this.#vesica, size = vesica.check(vesica.c.vesica_index_size(BigInt(this.length)));
    if (this.#size < size) {
      const [, block] = this.#blocks, place = vesica.memory.take(size);
      vesica.memory.give(...block);
      block.splice(0, 2, place, size);
      this.#index = place;
      this.#size = size;
    }
    this.#write(size);
  }

  #read(bytes) {
    const vesica = this.#vesica;
    this.#size = bytes.length;
    this.#index = this.#take(this.#size);
    new Uint8Array(vesica.memory.buffer, this.#index, this.#size).set(bytes);
    vesica.check(vesica.c.vesica_index_check(this.#index, BigInt(this.#size)));
    const built = vesica.check(vesica.c.vesica_index_count(this.#index));
    if (built !== this.length) throw new RangeError(`an index of ${built} shapes cannot be that of ${this.length}`);
  }

  /** A copy of the bytes, to be saved or sent. */
  get bytes() {
    const address = this.#address, size = this.#vesica.check(this.#vesica.c.vesica_index_bytes(address));
    return new Uint8Array(this.#vesica.memory.buffer, address, size).slice();
  }

  /** Gives the memory back now, not when it is collected. Whatever uses it afterwards throws a TypeError. */
  free() {
    this.#vesica.release(this, this.#blocks);
    this.#blocks = [];
    this.#index = 0;
  }

  order() {
    return this.#vesica.inRoom((room) => {
      const out = room.take(8 * this.length);
      const count = this.#vesica.check(this.#vesica.c.vesica_index_order(this.#address, out, BigInt(this.length)));
      return Array.from(new BigInt64Array(this.#vesica.memory.buffer, out, count), Number);
    });
  }

  bounds() {
    return this.#vesica.inRoom((room) => {
      const out = room.take(32);
      this.#vesica.check(this.#vesica.c.vesica_index_bounds(this.#address, out));
      return aabb(...new Float64Array(this.#vesica.memory.buffer, out, 4));
    });
  }

  join(options) {
    const pairs = { a: [], b: [] };
    this.forEachPair((a, b) => {
      pairs.a.push(a);
      pairs.b.push(b);
    }, options);
    return pairs;
  }

  forEachPair(found, { with: other = this, query = 'overlap', part = 0, parts = 1 } = {}) {
    if (typeof found !== 'function') throw new TypeError('what is to be called for each pair is a function');
    this.#vesica.inRoom((room) => {
      this.#eachPair(this.#joining(other, query, part, parts, room), room, (a, b) => found(a, b), other);
    });
  }

  joinWithin(distance, { with: other = this, part = 0, parts = 1 } = {}) {
    const pairs = { a: [], b: [] }, far = distanceFor(distance, this.scalar), asked = partOf(part, parts);
    this.#vesica.inRoom((room) => {
      const ask = this.#vesica.c[`vesica_join_within_${this.scalar}`];
      const call = (...output) => ask(...this.#both(other), far, ...asked, ...output);
      const add = (a, b) => {
        pairs.a.push(a);
        pairs.b.push(b);
      };
      this.#eachPair(call, room, add, other);
    });
    return pairs;
  }

  joinRatio(ratio, threshold = 0, { with: other = this, part = 0, parts = 1 } = {}) {
    const least = distanceFor(threshold, this.scalar, 'a threshold'), which = ratioNumber(ratio);
    const pairs = { a: [], b: [], values: [] }, asked = partOf(part, parts), Numbers = scalars[this.scalar];
    this.#vesica.inRoom((room) => {
      const vesica = this.#vesica, size = vesica.check(vesica.c.vesica_join_scratch()), scratch = room.take(size);
      const ask = vesica.c[`vesica_join_ratio_${this.scalar}`], values = room.take(8 * pairsACall);
      const call = (a, b, ...output) =>
        ask(which, least, ...this.#both(other), ...asked, scratch, BigInt(size), a, b, values, ...output);
      let found = []; // the values of one call, once memory no longer grows
      const add = (a, b, i) => {
        if (found.buffer !== vesica.memory.buffer) found = new Numbers(vesica.memory.buffer, values, pairsACall);
        pairs.a.push(a);
        pairs.b.push(b);
        pairs.values.push(found[i]);
      };
      this.#eachPair(call, room, add, other);
    });
    return pairs;
  }

  /**
   * found(a, b, place in this call's output) for each pair that a join writes in as many calls as it takes. As `found`
   * may free what is joined, or build it anew, each call makes sure that it is there and is what it was.
   */
  #eachPair(call, room, found, other) {
    this.#both(other); // before it is asked for its number
    const { memory } = this.#vesica, built = this.#builds, builtOther = other.#builds;
    const [a, b, state] = [8 * pairsACall, 8 * pairsACall, 32].map((size) => room.take(size));
    new BigInt64Array(memory.buffer, state, 4).fill(0n);
    while (new BigInt64Array(memory.buffer, state, 1)[0] !== -1n) {
      if (this.#builds !== built || other.#builds !== builtOther) {
        throw new TypeError('an index was built anew while its pairs were handed out');
      }
      const count = this.#vesica.check(call(a, b, BigInt(pairsACall), state));
      // Items are below 2^31, and WebAssembly is little-endian: the lower halves are the items. A copy, as `found` may
      // make the memory grow.
      const lower = (address) => new Int32Array(memory.buffer, address, 2 * count).slice();
      const first = lower(a), second = lower(b);
      for (let i = 0; i < count; ++i) found(first[2 * i], second[2 * i], i);
    }
  }

  /** The arguments for this index and another. */
  #both(other) {
    if (!(other instanceof Index)) throw new TypeError('an index is joined with an index');
    if (other.scalar !== this.scalar) {
      throw new TypeError(`this index is of ${this.scalar}, the other of ${other.scalar}`);
    }
    if (other.#vesica !== this.#vesica) throw new TypeError('the other index is of another load()');
    return [this, other].flatMap((index) => index.#operands());
  }

  joinCount({ with: other = this, query = 'overlap', part = 0, parts = 1 } = {}) {
    return this.#vesica.inRoom((room) =>
      this.#vesica.check(this.#joining(other, query, part, parts, room)(0, 0, 0n, 0)));
  }

  #joining(other, query, part, parts, room) {
    if (!Object.hasOwn(queries, query)) throw new TypeError(`query is one of ${Object.keys(queries).join(', ')}`);
    const vesica = this.#vesica, size = vesica.check(vesica.c.vesica_join_scratch()), scratch = room.take(size);
    const how = [...partOf(part, parts), scratch, BigInt(size)];
    const ask = vesica.c[`vesica_join_${this.scalar}`];
    return (...output) => ask(queries[query], ...this.#both(other), ...how, ...output);
  }

  select(shape) {
    return this.#items('select', shape);
  }

  cast(shape, velocity, options) {
    return this.#items('cast', shape, ...motionOf(velocity, options, this.scalar));
  }

  castFirst(shape, velocity, options) {
    const motion = motionOf(velocity, options, this.scalar);
    return this.#ofShape(shape, (operands, room) => {
      const call = this.#vesica.c[`vesica_index_cast_first_${this.scalar}`];
      const ask = (out) => call(...operands, ...motion, out);
      return indexCastFirst(this.#vesica, this.scalar, room, this.length, ask);
    });
  }

  /** All items of a question, which is put twice: how many, and which. */
  #items(name, shape, ...asked) {
    return this.#ofShape(shape, (operands, room) => {
      const call = this.#vesica.c[`vesica_index_${name}_${this.scalar}`];
      const ask = (...output) => this.#vesica.check(call(...operands, ...asked, ...output));
      const count = ask(0, 0n, 0), out = room.take(8 * count), state = room.take(32);
      new BigInt64Array(this.#vesica.memory.buffer, state, 4).fill(0n);
      if (count > 0) ask(out, BigInt(count), state);
      return Array.from(new BigInt64Array(this.#vesica.memory.buffer, out, count), Number);
    });
  }

  nearest(shape, { k = 1, within = Infinity } = {}) {
    if (!(Number.isInteger(k) && k >= 0)) throw new RangeError(`k is a whole number, not ${k}`);
    const far = distanceFor(within, this.scalar);
    return this.#ofShape(shape, (operands, room) => {
      if (k === 0) return { items: [], distances: [] };
      const Numbers = scalars[this.scalar], out = room.take(8 * k), distance = room.take(8 * k);
      const call = this.#vesica.c[`vesica_index_nearest_${this.scalar}`];
      const found = this.#vesica.check(call(...operands, BigInt(k), far, out, distance));
      return {
        items: Array.from(new BigInt64Array(this.#vesica.memory.buffer, out, found), Number),
        distances: Array.from(new Numbers(this.#vesica.memory.buffer, distance, found)),
      };
    });
  }

  nearestOfEach(sets, { k = 1, within = Infinity } = {}) {
    if (!(Number.isInteger(k) && k >= 1)) throw new RangeError(`k is a whole number from 1 on, not ${k}`);
    checkSets(sets, this.scalar, this.#vesica.memory);
    const far = distanceFor(within, this.scalar);
    return this.#vesica.inRoom((room) => {
      const Numbers = scalars[this.scalar], count = k * sets.reduce((sum, set) => sum + set.length, 0);
      const asked = room.take(sets.length * shapesSize), out = room.take(8 * count), distance = room.take(8 * count);
      this.#writeStructs(sets, asked);
      const code = this.#vesica.c[`vesica_join_nearest_${this.scalar}`](
        ...[asked, sets.length, ...this.#operands()],
        ...[BigInt(k), far, 0n, 1n, out, distance],
      );
      return this.#vesica.finish(Number(code), {
        items: Array.from(new BigInt64Array(this.#vesica.memory.buffer, out, count), Number),
        distances: new Numbers(this.#vesica.memory.buffer, distance, count).slice(),
      });
    });
  }

  /** call(arguments for the index and the shape, room). */
  #ofShape(shape, call) {
    const one = this.#vesica.shapes(shape?.kind, [shape], { scalar: this.scalar });
    try {
      return this.#vesica.inRoom((room) => call([...this.#operands(), one.address], room));
    } finally {
      one.free();
    }
  }
}
