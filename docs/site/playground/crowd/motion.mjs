// SPDX-License-Identifier: Apache-2.0
// Many shapes of mixed kinds that move and turn in a box, and the pairs of them that touch, asked anew each frame.
import { fields } from '../../vesica/vesica.mjs';

const kinds = [...Object.keys(fields), 'polygon'];

export const box = { width: 1.6, height: 1 }; // of the world, about the origin
export const perInstance = 8; // floats to draw a shape: centre, half axis, other half size, round (1) or a dart (2), touched, radius of corners

/** The same numbers from the same seed. */
export function random(seed) {
  let state = seed >>> 0;
  return () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}

const writers = {
  point: (n, i, x, y) => ((n[i] = x), (n[i + 1] = y)),
  segment: (n, i, x, y, c, s, a) => (
    (n[i] = x - a * c),
    (n[i + 1] = y - a * s),
    (n[i + 2] = x + a * c),
    (n[i + 3] = y + a * s)
  ),
  circle: (n, i, x, y, c, s, a) => ((n[i] = x), (n[i + 1] = y), (n[i + 2] = a)),
  aabb: (n, i, x, y, c, s, a, b) => ((n[i] = x - a), (n[i + 1] = y - b), (n[i + 2] = x + a), (n[i + 3] = y + b)),
  rect: (n, i, x, y, c, s, a, b) => (
    (n[i] = x),
    (n[i + 1] = y),
    (n[i + 2] = c),
    (n[i + 3] = s),
    (n[i + 4] = a),
    (n[i + 5] = b)
  ),
};
// A dart, as an arrow's head: the points of `dart` in units of the half axes.
export const dart = [
  [-1, -1],
  [1, 0],
  [-1, 1],
  [-1 / 3, 0],
];
writers.polygon = (n, i, x, y, c, s, a, b) =>
  dart.forEach(([along, across], k) => {
    n[i + 2 * k] = x + along * a * c - across * b * s;
    n[i + 2 * k + 1] = y + along * a * s + across * b * c;
  });
writers.ellipse = writers.rect;
writers.capsule = (n, i, x, y, c, s, a, b, r) => (writers.segment(n, i, x, y, c, s, a - r), (n[i + 4] = r));
writers.round_rect = (n, i, x, y, c, s, a, b, r) => (writers.rect(n, i, x, y, c, s, a - r, b - r), (n[i + 6] = r));

export class Crowd {
  #vesica;
  #sets; // an array of shapes a kind
  #index;
  #state; // of each shape: x, y, velocity, angle, spin, half sizes
  #first = []; // the number of the first shape of each kind

  constructor(vesica, count, seed = 1) {
    this.#vesica = vesica;
    this.count = count;
    this.instances = new Float32Array(count * perInstance);
    this.touched = new Uint8Array(count);
    this.#state = new Float32Array(count * 8);
    const next = random(seed),
      size = 0.42 * Math.sqrt((box.width * box.height) / count);
    for (let i = 0; i < count; ++i) {
      const speed = 0.04 + 0.08 * next(),
        way = 2 * Math.PI * next();
      this.#state.set(
        [
          (next() - 0.5) * box.width,
          (next() - 0.5) * box.height,
          speed * Math.cos(way),
          speed * Math.sin(way),
          2 * Math.PI * next(),
          (next() - 0.5) * 3,
          size * (0.5 + next()),
          size * (0.3 + 0.5 * next()),
        ],
        8 * i,
      );
    }
    const bounds = kinds.map((_, k) => Math.floor((k * count) / kinds.length));
    this.#first = [...bounds, count];
    this.#sets = kinds.map((kind, k) => {
      const of = this.#first[k + 1] - this.#first[k];
      if (kind !== 'polygon') return vesica.shapes(kind, of, { scalar: 'f32' });
      return vesica.polygons(new Float32Array(2 * dart.length * of), { each: dart.length, scalar: 'f32' });
    });
    this.move(0);
    this.#index = vesica.index(...this.#sets);
  }

  /** All shapes so many seconds on; at the box's sides they turn back. */
  move(seconds) {
    const state = this.#state,
      out = this.instances;
    kinds.forEach((kind, k) => {
      const numbers = this.#sets[k].numbers,
        write = writers[kind],
        width = numbers.length / (this.#first[k + 1] - this.#first[k]) || 0;
      const flat = kind === 'point' || kind === 'segment',
        round = kind === 'circle' || kind === 'ellipse' || kind === 'point' ? 1 : kind === 'polygon' ? 2 : 0;
      for (let i = this.#first[k], at = 0; i < this.#first[k + 1]; ++i, at += width) {
        const s = 8 * i;
        state[s] += seconds * state[s + 2];
        state[s + 1] += seconds * state[s + 3];
        if (Math.abs(state[s]) > box.width / 2) state[s + 2] = -Math.sign(state[s]) * Math.abs(state[s + 2]);
        if (Math.abs(state[s + 1]) > box.height / 2) state[s + 3] = -Math.sign(state[s + 1]) * Math.abs(state[s + 3]);
        state[s + 4] += seconds * state[s + 5];
        const angle = kind === 'aabb' ? 0 : state[s + 4],
          c = Math.cos(angle),
          sine = Math.sin(angle);
        const a = kind === 'point' ? 0 : state[s + 6],
          b = flat ? 0 : kind === 'circle' ? a : kind === 'capsule' ? Math.min(a, state[s + 7]) / 2 : state[s + 7];
        const r = kind === 'capsule' ? b : kind === 'round_rect' ? b / 2 : 0;
        write(numbers, at, state[s], state[s + 1], c, sine, a, b, r);
        const o = perInstance * i;
        out[o] = state[s];
        out[o + 1] = state[s + 1];
        out[o + 2] = a * c;
        out[o + 3] = a * sine;
        out[o + 4] = b;
        out[o + 5] = round;
        out[o + 7] = r;
      }
    });
  }

  /** The query: all pairs that touch. Marks their shapes; returns how many pairs there are. */
  collide() {
    const { touched } = this;
    let pairs = 0;
    touched.fill(0);
    this.#index.rebuild();
    this.#index.forEachPair((a, b) => {
      touched[a] = touched[b] = 1;
      ++pairs;
    });
    return pairs;
  }

  /** Marks in what is drawn. */
  paint() {
    for (let i = 0; i < this.count; ++i) this.instances[perInstance * i + 6] = this.touched[i];
  }

  /** How many pairs a frame are asked exactly: those whose bounds meet. */
  candidates() {
    return this.#index.joinCount({ query: 'bounds' });
  }

  /** Shape i as a plain object. */
  at(i) {
    const k = kinds.findIndex((_, j) => i < this.#first[j + 1]);
    return this.#sets[k].at(i - this.#first[k]);
  }

  free() {
    this.#index.free();
    for (const set of this.#sets) set.free();
  }
}
