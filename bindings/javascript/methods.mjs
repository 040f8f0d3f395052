// SPDX-License-Identifier: Apache-2.0
// The named methods, by a module of their own: for teaching and comparison. methods.d.ts describes every call.
import { VesicaError } from './library.mjs';
import { exportsOf, refuseUnknown } from './loading.mjs';
import { Memory, Room } from './memory.mjs';
import { numbersOf } from './shapes.mjs';

export const verdicts = Object.freeze(['no', 'yes', 'uncertain']);

const turned = (shape) => [shape.cx, shape.cy, shape.angle, shape.width, shape.height];
const radiusVector = (shape) => [shape.cx, shape.cy, shape.wx, shape.wy, shape.ratio];
const approximation = (view) => ({ outlineError: view.getFloat64(0, true), iterations: view.getInt32(8, true) });
const metricClosest = (view) => ({
  x: view.getFloat64(0, true),
  y: view.getFloat64(8, true),
  cMin: view.getFloat64(16, true),
});

/** name in C; the kinds of its shapes; whether a count follows them; what it writes, and in how many bytes. */
const methods = {
  rectEllipseAllFeatures: { name: 'rect_ellipse_all_features', kinds: ['rect', 'ellipse'] },
  rectEllipseClosestFeatures: { name: 'rect_ellipse_closest_features', kinds: ['rect', 'ellipse'] },
  rectEllipseMinkowskiSum: { name: 'rect_ellipse_minkowski_sum', kinds: ['rect', 'ellipse'] },
  rectEllipsePointParallelogramDistance: {
    name: 'rect_ellipse_point_parallelogram_distance',
    kinds: ['rect', 'ellipse'],
    out: metricClosest,
    size: 24,
  },
  rectRectBounds: { name: 'rect_rect_bounds', kinds: ['rect', 'rect'] },
  rectRectSamplePoints: { name: 'rect_rect_sample_points', kinds: ['rect', 'rect'], count: true },
  rectRectSeparatingLines: { name: 'rect_rect_separating_lines', kinds: ['rect', 'rect'] },
  turnedRectsSeparatingLines: { name: 'turned_rects_separating_lines', kinds: [turned, turned] },
  pointRectFrame: { name: 'point_rect_frame', kinds: ['point', 'rect'] },
  pointAabbIntervals: { name: 'point_aabb_intervals', kinds: ['point', 'aabb'] },
  aabbAabbIntervals: { name: 'aabb_aabb_intervals', kinds: ['aabb', 'aabb'] },
  circleEllipseClosedForm: { name: 'circle_ellipse_closed_form', kinds: ['circle', 'ellipse'] },
  segmentCircleDivisionFree: { name: 'segment_circle_division_free', kinds: ['segment', 'circle'] },
  circleEllipsePolygonalSandwich: {
    name: 'circle_ellipse_polygonal_sandwich',
    kinds: ['circle', 'ellipse'],
    count: true,
    out: approximation,
    size: 16,
  },
  circleEllipseCircleApproximation: {
    name: 'circle_ellipse_circle_approximation',
    kinds: ['circle', 'ellipse'],
    count: true,
    out: approximation,
    size: 16,
  },
  ellipseEllipseParallelAxes: {
    name: 'ellipse_ellipse_parallel_axes',
    kinds: ['ellipse', 'ellipse'],
    count: true,
    out: approximation,
    size: 16,
  },
  ellipseEllipseAnyAxes: {
    name: 'ellipse_ellipse_any_axes',
    kinds: ['ellipse', 'ellipse'],
    count: true,
    out: approximation,
    size: 16,
  },
  radiusVectorEllipsesAnyAxes: {
    name: 'radius_vector_ellipses_any_axes',
    kinds: [radiusVector, radiusVector],
    count: true,
    out: approximation,
    size: 16,
  },
};

const errors = {
  [-1]: 'a pointer is NULL',
  [-2]: 'a shape is invalid',
  [-4]: 'an argument is out of its documented range',
  [-9]: 'a number of the result would be beyond the finite numbers of its type',
};

/** Made by loadMethods(). */
export class Methods {
  #memory;

  constructor(exports) {
    this.c = exports;
    this.#memory = new Memory(exports.memory);
  }

  rectCorners(rect) {
    return this.#within((room) => {
      const out = room.take(64);
      this.#check(this.c.vesica_method_rect_corners_f64(this.#record('rect', rect, room), out));
      const numbers = new Float64Array(this.#memory.buffer, out, 8);
      return [0, 2, 4, 6].map((i) => ({ x: numbers[i], y: numbers[i + 1] }));
    });
  }

  ellipseEllipseDistanceGradientDescent(a, b, { schedule = 'scale-aware', errors: most = 0, ...changes } = {}) {
    const schedules = ['scale-aware', 'literal'];
    if (!schedules.includes(schedule)) throw new TypeError(`schedule is one of ${schedules.join(', ')}`);
    return this.#within((room) => {
      const ellipses = [a, b].map((shape) => this.#record('ellipse', shape, room));
      const settings = room.take(32),
        out = room.take(40),
        list = room.take(8 * most);
      this.#check(this.c.vesica_method_descent_settings_f64(schedules.indexOf(schedule), settings));
      const given = new DataView(this.#memory.buffer, settings, 32);
      ['tolerance', 'rate', 'decay'].forEach(
        (name, i) => name in changes && given.setFloat64(8 * i, changes[name], true),
      );
      if ('iterations' in changes) given.setInt32(24, changes.iterations, true);
      this.#check(
        this.c.vesica_method_ellipse_ellipse_distance_gradient_descent_f64(...ellipses, settings, out, list, most),
      );
      const view = new DataView(this.#memory.buffer, out, 40),
        number = (i) => view.getFloat64(8 * i, true);
      const iterations = view.getInt32(32, true);
      return {
        angleA: number(0),
        angleB: number(1),
        distance: number(2),
        error: number(3),
        iterations,
        success: view.getInt32(36, true) === 1,
        errors: Array.from(new Float64Array(this.#memory.buffer, list, Math.min(most, iterations))),
      };
    });
  }

  /** vesica_method_<name>_f64 of two shapes. */
  ask({ name, kinds, count = false, out, size = 0 }, [a, b, n]) {
    return this.#within((room) => {
      const shapes = [a, b].map((shape, i) => this.#record(kinds[i], shape, room)),
        result = room.take(size);
      const rest = [...(count ? [n] : []), ...(out === undefined ? [] : [result])];
      const answer = verdicts[this.#check(this.c[`vesica_method_${name}_f64`](...shapes, ...rest))];
      return out === undefined ? answer : { answer, ...out(new DataView(this.#memory.buffer, result, size)) };
    });
  }

  /** The address of a shape's numbers. */
  #record(kind, shape, room) {
    if (typeof kind === 'string' && shape?.kind !== kind)
      throw new TypeError(`here a ${kind} is wanted, not ${JSON.stringify(shape?.kind)}`);
    const numbers = typeof kind === 'string' ? numbersOf(shape) : kind(shape),
      address = room.take(8 * numbers.length);
    new Float64Array(this.#memory.buffer, address, numbers.length).set(numbers);
    return address;
  }

  #within(call) {
    const room = new Room(this.#memory);
    try {
      return call(room);
    } finally {
      room.end();
    }
  }

  #check(code) {
    if (code < 0) throw new VesicaError(errors[code] ?? 'unknown error', code);
    return code;
  }
}

for (const [name, method] of Object.entries(methods)) {
  Methods.prototype[name] = function (...given) {
    return this.ask(method, given);
  };
}

/** Loads vesica-methods.wasm beside this file, or `module`. */
export const loadMethods = async ({ module, ...others } = {}) => {
  refuseUnknown(others, 'module');
  return new Methods(await exportsOf(module, () => new URL('./vesica-methods.wasm', import.meta.url)));
};
