// SPDX-License-Identifier: Apache-2.0
// What a program in TypeScript may write, and what it may not: read by tsc, never run.
import { capsule, circle, ellipse, load, polygon, polyline, rect, roundRect } from 'vesica';
import type { Crossings, FirstImpact, ImpactTime, Outcome, Relation, Shape, ShapeArray, Within } from 'vesica';
import { load as loadBare } from 'vesica/bare';
import { loadMethods } from 'vesica/methods';
import { load as loadOverlap } from 'vesica/overlap';

const vesica = await load();
const car = rect(0, 0, 4, 2, 30, { degrees: true });
const hit: boolean = vesica.overlap(car, circle(1, 1, 1));
const relation: Relation = vesica.relation(car, car);
const places: Crossings = vesica.crossings(car, car);
const cars: ShapeArray = vesica.shapes('rect', [car, car], { scalar: 'f32' });
const hits: Uint8Array = vesica.overlap(cars, car);
const distance: number = vesica.nearest(car, car).distance;
const distances: Float64Array | Float32Array = vesica.nearest(cars, cars).distance;
const { a, b }: { a: number[]; b: number[] } = vesica.index(cars).join({ query: 'contains' });
const raw: number = vesica.c.vesica_version();
const count: bigint = vesica.c.vesica_index_size(1n);
vesica.index(cars).forEachPair((first: number, second: number) => first + second, { query: 'bounds' });
const rounded: number = vesica.nearest(capsule(0, 0, 1, 0, 1), roundRect(9, 0, 1, 0, 2, 1, 0.5)).distance;
const near: Within = vesica.within(car, car, 2);
const matrix: boolean = vesica.de9imMatch(vesica.de9im(car, car), 'T********');
const left: number[] = vesica.nmsSoft(cars, [1, 2], 0.5, { decay: 'gaussian' }).scores;
const corners: { x: number; y: number }[] = vesica.intersection(car, car);
const signed: Float64Array | Float32Array = vesica.signedDistance(cars, car);
const zone = polygon([[[0, 0], [9, 0], [9, 9]], [[1, 1], [2, 1], [2, 2]]]), street = polyline([0, 0, 9, 9]);
const zones: ShapeArray = vesica.polygons([zone, [[0, 0], [1, 0], [0, 1]]], { scalar: 'f32' });
const quads: ShapeArray = vesica.shapes('polygon', new Float64Array(16), { each: 4 });
const crossed: Uint8Array = vesica.overlap(vesica.polylines([0, 0, 1, 1], { rings: Int32Array.of(0, 2) }), street);
const inZone: boolean = vesica.contains(zone, car);
const small: boolean = (await loadOverlap({ simd: false })).overlap(car, car);
const other: number = (await loadBare({ module: fetch('/vesica.wasm') })).area(car, car);
const sparse: number[] = vesica.index(cars).joinRatio('over_union', 0.5, { part: 0, parts: 1 }).values;
const hull: number = vesica.shapeArea(vesica.convexHull([[0, 0], [1, 0], [0, 1]]));
const boxes: ShapeArray = vesica.minAreaRect(zones);
const shares: Float64Array = vesica.coverage(car, { columns: 4, rows: 3 });
const pressed: number = vesica.manifold(car, car).contacts[0].depth;
const fused: ShapeArray = vesica.fuse(cars, [1, 2], 0.5, { score: 'max' }).boxes;
const methods = await loadMethods({ module: new URL('https://example.org/vesica-methods.wasm') });
const bound: number = methods.ellipseEllipseAnyAxes(ellipse(0, 0, 2, 1), ellipse(1, 0, 2, 1), 3).outlineError;
const turned: ShapeArray = vesica.shapesFromBoxes('ellipse', [[0, 0, 4, 2, 1]], { quarters: true });
const overSmaller: number = vesica.ratio('over_smaller', car, car);
const kept: number[] = vesica.nms(cars, [1, 2], 0.5, { labels: [0, 1], ratio: 'generalized', most: 1 });
const impact: FirstImpact | null = vesica.castFirst(car, cars, [1, 0], { tEnd: 3 });
const times: Float64Array | Float32Array = vesica.cast(cars, car, [[1, 2], [0, 0]]).t;
const outcome: Outcome = vesica.cast(car, car, [1, 0]).outcome;
const turning: ImpactTime = vesica.impactTime(car, [0, 0, 1], car, [1, 0, -1], 1e-6);

/** An array beside what may be an array or a shape gives arrays, in either place. */
function ofEither(some: ShapeArray | Shape): Uint8Array[] {
  vesica.cast(cars, some, [1, 0]).t, vesica.cast(some, cars, [1, 0]).t;
  return [vesica.overlap(some, cars), vesica.overlap(cars, some), vesica.within(some, cars, 1)];
}

// @ts-expect-error: two shapes give one answer, and take no array to put it in
vesica.overlap(car, car, { out: new Uint8Array(1) });
// @ts-expect-error: two shapes have one velocity
vesica.cast(car, car, [[1], [0]]);
// @ts-expect-error: whether an array is among these is not known, nor what the answer is
(some: ShapeArray | Shape) => vesica.overlap(some, some);
// @ts-expect-error: no such kind
vesica.shapes('square', 1);
// @ts-expect-error: circles have no rings
vesica.shapes('circle', [0, 0, 1], { rings: [0, 1] });
// @ts-expect-error: not a shape
vesica.overlap({ kind: 'circle', x: 1 }, car);
// @ts-expect-error: no such query
vesica.index(cars).join({ query: 'near' });
// @ts-expect-error: arrays of answers are not one answer
const wrong: boolean = vesica.overlap(cars, car);

// @ts-expect-error: no such ratio
vesica.ratio('iou', car, car);
// @ts-expect-error: a label is a number
vesica.nms(cars, [1, 2], 0.5, { labels: ['car', 'person'] });
// @ts-expect-error: a velocity has two numbers
vesica.cast(car, car, 1);
// @ts-expect-error: a turn has three numbers
vesica.impactTime(car, [0, 0], car, [1, 0], 1e-6);

export { a, b, bound, count, distance, distances, hit, hits, places, raw, relation, wrong };
export { crossed, inZone, quads, zones };
export { corners, impact, left, matrix, near, rounded, signed };
export { kept, ofEither, outcome, overSmaller, times, turned, turning };
// @ts-expect-error: it names no module
await loadBare();
// @ts-expect-error: a circle has three numbers
circle(0, 0);
