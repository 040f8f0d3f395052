// SPDX-License-Identifier: Apache-2.0
import type { C } from './c.js';
export type { C };

/** Kinds that have as many numbers in every shape. */
export type NumberKind = 'point' | 'segment' | 'circle' | 'aabb' | 'rect' | 'ellipse' | 'capsule' | 'round_rect';
export type Kind = NumberKind | 'polygon' | 'polyline';
/**
 * float64 or float32 numbers. Both are exact; float32 takes half the memory. Beside an array of float32, plain shapes,
 * distances, times, velocities, thresholds and the scores of nmsSoft are rounded to float32 first, and answers are
 * exact of what that gives; what would become infinite is a RangeError.
 */
export type Scalar = 'f64' | 'f32';

/** A location. */
export interface Point { kind: 'point'; x: number; y: number }
/** All points between two ends. */
export interface Segment { kind: 'segment'; x0: number; y0: number; x1: number; y1: number }
/** A disc: centre and radius. */
export interface Circle { kind: 'circle'; cx: number; cy: number; r: number }
/** A box along the axes. */
export interface Aabb { kind: 'aabb'; min_x: number; min_y: number; max_x: number; max_y: number }
/** A turned rectangle: centre, axis (a direction and a unit of length), half sizes along and across it. */
export interface Rect { kind: 'rect'; cx: number; cy: number; ux: number; uy: number; hx: number; hy: number }
/** An ellipse: centre, axis, half axes along and across it. */
export interface Ellipse { kind: 'ellipse'; cx: number; cy: number; ux: number; uy: number; a: number; b: number }
/** All points at most r from a segment. */
export interface Capsule { kind: 'capsule'; x0: number; y0: number; x1: number; y1: number; r: number }
/** All points at most r from a rectangle. hx and hy are the rectangle's, in units of the axis; r is not in those. */
export interface RoundRect {
  kind: 'round_rect'; cx: number; cy: number; ux: number; uy: number; hx: number; hy: number; r: number;
}
/**
 * Vertices x y x y ..., and where each ring begins among them, with the end; one ring if left out. What an odd number
 * of rings go around is inside: a ring inside another is a hole, whatever their order and directions.
 */
export interface Polygon { kind: 'polygon'; vertices: ArrayLike<number>; rings?: ArrayLike<number> }
/** Chains in place of rings: they are not closed, and have no inside. */
export interface Polyline { kind: 'polyline'; vertices: ArrayLike<number>; rings?: ArrayLike<number> }
/**
 * Nearly every call takes any two kinds; others throw a VesicaError. depth, impactTime and the manifold need convex
 * polygons and take no polyline that bends, and so do signedDistance and within where they ask for a depth.
 * intersection needs two straight shapes, or a point or a segment and any shape.
 */
export type Shape = Point | Segment | Circle | Aabb | Rect | Ellipse | Capsule | RoundRect | Polygon | Polyline;

/** A place [x, y]; further numbers are ignored. */
export type Place = readonly number[];
/** A ring or chain; several; or, as of a MultiPolygon, several of several: GeoJSON's coordinates. */
export type Coordinates = readonly Place[] | readonly (readonly Place[])[] | readonly (readonly (readonly Place[])[])[];
/** Where parts of vertices begin: at `each` vertices, or at offsets, with the end, as GeoArrow has them. */
export interface Offsets {
  /** Vertices of each shape: 4 of quads. */
  each?: number;
  /** Where each ring begins among the vertices. */
  rings?: ArrayLike<number>;
  /** Where each polygon begins among the rings; a ring each if left out. */
  polygons?: ArrayLike<number>;
}

interface Angle {
  /** The angle is in degrees; multiples of 90 turn exactly. */
  degrees?: boolean;
}
/** Copies coordinates, or vertices x y x y ... with the offsets of their rings. */
export function polygon(source: Coordinates | ArrayLike<number>, rings?: ArrayLike<number>): Polygon;
export function polyline(source: Coordinates | ArrayLike<number>, chains?: ArrayLike<number>): Polyline;
export function point(x: number, y: number): Point;
export function segment(x0: number, y0: number, x1: number, y1: number): Segment;
export function circle(cx: number, cy: number, r: number): Circle;
export function aabb(min_x: number, min_y: number, max_x: number, max_y: number): Aabb;
/**
 * From centre, whole width and height, and the angle of the width. Sizes are exact: if halving one would round, as of
 * odd multiples of the smallest number, the axis is halved instead, and hx and hy are the whole sizes.
 */
export function rect(cx: number, cy: number, width: number, height: number, angle?: number, options?: Angle): Rect;
/** From centre, half axes, and the angle of a. */
export function ellipse(cx: number, cy: number, a: number, b: number, angle?: number, options?: Angle): Ellipse;
export function capsule(x0: number, y0: number, x1: number, y1: number, r: number): Capsule;
/** From the numbers that it has. */
export function roundRect(
  cx: number, cy: number, ux: number, uy: number, hx: number, hy: number, r: number): RoundRect;

export const kinds: readonly Kind[];
/** The names of each kind's numbers, in their order in arrays. Polygons and polylines have any number. */
export const fields: Readonly<Record<NumberKind, readonly string[]>>;
export type Relation =
  | 'disjoint' | 'touch' | 'cross' | 'inside' | 'inside_touch' | 'contains' | 'contains_touch' | 'equal';
/** Names of relations by the numbers that arrays of them have. */
export const relations: readonly Relation[];
/** The constants of vesica.h without their prefix. */
export const constants: Readonly<Record<string, number>>;

/** What the library refuses. After an invalid shape among many, result has the answers of all others. */
export class VesicaError extends Error {
  /** VESICA_E_... */
  readonly code: number;
  readonly result?: unknown;
}

/**
 * Shapes of one kind in the module's memory. Passing them to what another load() made is a TypeError, as is any use
 * once they are freed.
 */
export class ShapeArray<T extends Float64Array | Float32Array = Float64Array | Float32Array> {
  private constructor();
  readonly kind: Kind;
  readonly scalar: Scalar;
  readonly length: number;
  /**
   * The numbers, one shape after the other, of polygons all vertices x y x y ...: a view, whose changes the next call sees. Take it anew after anything that
   * may allocate, as memory that grows detaches older views.
   */
  readonly numbers: T;
  /** Shape i, or -i from the end, as a plain object: a copy. */
  at(i: number): Shape;
  /**
   * Gives the memory back now, not when it is collected. Any use of the array afterwards is a TypeError, also by an
   * index over it. Views of its numbers made before are of memory that others use.
   */
  free(): void;
}

export type Within = 'no' | 'yes' | 'nearly';
/** Names of what `within` answers, by the numbers that arrays have. */
export const withins: readonly Within[];
export interface ClosestPoints<N> { distance: N; ax: N; ay: N; bx: N; by: N }
/** How far, and in which direction (x, y), b must move until it only touches a. */
export interface Penetration<N> { depth: N; x: N; y: N }
export interface Crossings { places: { x: number; y: number }[]; shared: boolean }
export type Numbers = Float64Array | Float32Array;
type Many = ShapeArray | Shape;

/** What a shared area is compared with: IoU, IoF, IoA, IoS, GIoU, DIoU, CIoU. */
export type Ratio =
  | 'over_union' | 'over_first' | 'over_second' | 'over_smaller' | 'generalized' | 'distance' | 'complete';
/** Names of ratios, by their numbers. */
export const ratios: readonly Ratio[];

/** How angles are told: in radians from +x towards +y, unless this says otherwise. */
export interface Angles {
  degrees?: boolean;
  quarters?: boolean;
  /** From +x away from +y. */
  reverse?: boolean;
}

export interface Suppression {
  /**
   * A whole number each, from Number.MIN_SAFE_INTEGER to Number.MAX_SAFE_INTEGER; any other is a TypeError. Only shapes
   * of the same label suppress one another.
   */
  labels?: ArrayLike<number>;
  /** Any but 'over_first' and 'over_second'; 'over_union' if left out. */
  ratio?: Ratio;
  /** Shapes below it are left out. */
  leastScore?: number;
  /** How many are kept at most. */
  most?: number;
}

/** Distances of shapes as Gaussian distributions: see vesica_gaussian_distance_f64 of `c`. */
export type Gaussian = 'bhattacharyya' | 'hellinger' | 'kullback_leibler' | 'wasserstein';
/** Names of these distances, by their numbers. */
export const gaussians: readonly Gaussian[];
/** Names of what matchTruths answers for a detection, by their numbers. */
export const outcomes: readonly ('miss' | 'hit' | 'ignored')[];
/** Names of what a truth is to matchTruths, by the numbers of `flags`. */
export const truthFlags: readonly ('counts' | 'crowd' | 'ignored')[];
/** Pair k is item a[k] and item b[k], with values[k]. */
export interface Pairs { a: ArrayLike<number>; b: ArrayLike<number>; values: ArrayLike<number> }
/** Cell (i, j) is the box from (x + i dx, y + j dy) on. x and y are 0 if left out, dx is 1, and dy is dx. */
export interface Grid { x?: number; y?: number; dx?: number; dy?: number; columns: number; rows: number }
/** Place and depth of a contact, and the numbers of the vertices of a and b that name it. */
export interface Contact { x: number; y: number; depth: number; a: number; b: number }
/** At most two contacts, and the unit normal from a to b; without a contact it is (0, 0). */
export interface Manifold { nx: number; ny: number; contacts: Contact[] }
/** Points: what polygon() takes, or a plain polygon or polyline, whose vertices are meant. */
export type Points = Polygon | Polyline | Coordinates | ArrayLike<number>;

export type Velocity = readonly [number, number];
/** One, or two arrays of numbers. */
export type Velocities = Velocity | readonly [ArrayLike<number>, ArrayLike<number>];
/** tEnd is Infinity if left out. */
export interface Until { tEnd?: number }
export type Outcome = 'miss' | 'hit' | 'start';
/** Names of what a cast finds, by its numbers; the last is impactTime's alone. */
export const casts: readonly (Outcome | 'near')[];
/** When and where, and the unit normal there, from a to b. After a miss t is Infinity and the rest NaN. */
export interface Impact<N> { t: N; x: N; y: N; nx: N; ny: N }
/** What a shape does while t runs from 0 to 1: its centre moves by (vx, vy), and it turns about that by an angle. */
export type Turn = readonly [vx: number, vy: number, radians: number];
/** The impact is the place at t: the point of a nearest to b, and the normal that separates them. */
export interface ImpactTime extends Impact<number> {
  outcome: Outcome | 'near';
  /** They are at most so far apart at t. */
  gap: number;
}
export interface FirstImpact extends Impact<number> { item: number }

export type Query = 'overlap' | 'bounds' | 'contains' | 'inside' | 'interiors';
export interface Joining {
  /** Another index, of the same scalar type and load(); this one if left out: then pairs are a < b. */
  with?: Index;
  query?: Query;
  part?: number;
  parts?: number;
}

/**
 * An index over arrays of shapes, laid end to end: item i is shape i of the first array, and so on. All but `bytes`,
 * `order` and `bounds` read the arrays too, and throw a TypeError once one of them is freed.
 */
export class Index {
  private constructor();
  readonly scalar: Scalar;
  readonly length: number;
  /** Whether invalid shapes were left out. */
  readonly incomplete?: boolean;
  /** A copy of the bytes, to be saved or sent: the same on every machine of this byte order. */
  readonly bytes: Uint8Array;
  /** All pairs for which the query holds, each once. */
  join(options?: Joining): { a: number[]; b: number[] };
  /** The same, pair by pair, without arrays of them. `found` may not rebuild an index of the two. */
  forEachPair(found: (a: number, b: number) => void, options?: Joining): void;
  joinCount(options?: Joining): number;
  /** All pairs at most `distance` apart; if it is negative, those that overlap at least that deep. Of ellipses also those too near to it to tell. */
  joinWithin(distance: number, options?: Omit<Joining, 'query'>): { a: number[]; b: number[] };
  /**
   * All pairs that overlap and whose ratio is at least the threshold, with the ratio: a sparse matrix. At threshold 0,
   * that left out, each pair that overlaps and has a ratio.
   */
  joinRatio(
    ratio: Ratio,
    threshold?: number,
    options?: Omit<Joining, 'query'>,
  ): { a: number[]; b: number[]; values: number[] };
  /** The items that a shape overlaps. */
  select(shape: Shape): number[];
  /** The k nearest items within a distance, nearest first; at equal distances by number. */
  nearest(shape: Shape, options?: { k?: number; within?: number }): { items: number[]; distances: number[] };
  /** Builds the index anew from its arrays, whose shapes may have moved. From the second time on it takes no memory. */
  rebuild(): void;
  /**
   * Of each shape of some arrays the k nearest items: rows of k, one after the other, filled up by -1 at distance
   * Infinity. After a VesicaError of an invalid shape its result has all other rows.
   */
  nearestOfEach(
    sets: readonly ShapeArray[],
    options?: { k?: number; within?: number },
  ): { items: number[]; distances: Numbers };
  /** The items that a moving shape touches. */
  cast(shape: Shape, velocity: Velocity, options?: Until): number[];
  /** The item that it touches first, the lowest of several, or null. */
  castFirst(shape: Shape, velocity: Velocity, options?: Until): FirstImpact | null;
  /** The items in spatial order: arrays that are laid so are joined quicker. */
  order(): number[];
  /** A box around all valid shapes. */
  bounds(): Aabb;
  /** Gives the memory back now, not when it is collected. Any use of the index afterwards is a TypeError. */
  free(): void;
}

/**
 * The library. Two plain objects give one answer, in double; if one operand is an array, an array of answers comes, in
 * step, with one shape repeated. Touching counts as overlap. Yes or no, relations and counts are exact for every valid
 * input, beside arrays of float32 as it is rounded: see Scalar. An invalid shape is a VesicaError. What is given to be
 * read, such as numbers or scores, may be a view of the module's memory.
 */
export class Vesica {
  private constructor();
  /** The C library; lengths and counts are bigint, pointers are addresses in c.memory. */
  readonly c: C;
  readonly version: string;
  /** What batches run on: 'simd128' or 'portable'. Answers never depend on it. */
  readonly isa: string;

  /**
   * An array from numbers one after the other, from plain objects of that kind, or of a count, with all numbers 0. Of a
   * plain rectangle in float32 the whole sizes are rounded to float32; if halving one would round again, the axis is
   * halved instead, as by rect(). Numbers that are not of plain objects are as in a Float32Array: infinite where
   * float32 has none so great, and then the shape is invalid.
   */
  shapes(
    kind: NumberKind,
    source: ArrayLike<number> | readonly (Shape | readonly number[])[] | number,
    options?: { scalar?: Scalar },
  ): ShapeArray;
  shapes(
    kind: 'polygon' | 'polyline',
    source: ArrayLike<number> | readonly (Polygon | Polyline | Coordinates)[],
    options?: Offsets & { scalar?: Scalar },
  ): ShapeArray;
  /** An array from vertices x y x y ..., and each or rings; or from plain objects or coordinates. */
  polygons(
    source: ArrayLike<number> | readonly (Polygon | Coordinates)[],
    options?: Offsets & { scalar?: Scalar },
  ): ShapeArray;
  polylines(
    source: ArrayLike<number> | readonly (Polyline | Coordinates)[],
    options?: Offsets & { scalar?: Scalar },
  ): ShapeArray;
  /**
   * Rectangles from boxes, or the ellipses that touch their sides in the middle. A box is five numbers: centre x, y,
   * width along the angle, height across it, angle. Quarter turns are exact. Of an invalid box all numbers are NaN, and
   * it is a VesicaError, whose result is the array.
   */
  shapesFromBoxes(
    kind: 'rect' | 'ellipse',
    boxes: ArrayLike<number> | readonly (readonly number[])[],
    options?: Angles & { scalar?: Scalar },
  ): ShapeArray;
  /** The way back: five numbers of each rectangle, or of the box about each ellipse, one after the other. */
  boxes(shapes: Many, options?: Angles): Numbers;
  /** x0 y0 ... x3 y3 of each rectangle, or of the box about each ellipse. */
  corners(shapes: Many): Numbers;
  /** min_x min_y max_x max_y of each shape: boxes that surely contain them. */
  boundsMany(shapes: Many): Numbers;

  /** Do a and b share a point? */
  overlap(a: Shape, b: Shape): boolean;
  overlap(a: ShapeArray, b: Many, options?: { out?: Uint8Array }): Uint8Array;
  overlap(a: Many, b: ShapeArray, options?: { out?: Uint8Array }): Uint8Array;
  /** Do the insides of a and b share a point? Touching does not count. */
  interiorsOverlap(a: Shape, b: Shape): boolean;
  interiorsOverlap(a: ShapeArray, b: Many, options?: { out?: Uint8Array }): Uint8Array;
  interiorsOverlap(a: Many, b: ShapeArray, options?: { out?: Uint8Array }): Uint8Array;
  /** How does a relate to b? Arrays have numbers: see `relations`. */
  relation(a: Shape, b: Shape): Relation;
  relation(a: ShapeArray, b: Many, options?: { out?: Uint8Array }): Uint8Array;
  relation(a: Many, b: ShapeArray, options?: { out?: Uint8Array }): Uint8Array;
  /** Does a hold all of b? */
  contains(a: Shape, b: Shape): boolean;
  contains(a: ShapeArray, b: Many, options?: { out?: Uint8Array }): Uint8Array;
  contains(a: Many, b: ShapeArray, options?: { out?: Uint8Array }): Uint8Array;
  /** How far apart are the solid shapes, and which points are closest? */
  nearest(a: Shape, b: Shape): ClosestPoints<number>;
  nearest(a: ShapeArray, b: Many): ClosestPoints<Numbers>;
  nearest(a: Many, b: ShapeArray): ClosestPoints<Numbers>;
  /** The same between outlines, of nested shapes too. */
  boundaryDistance(a: Shape, b: Shape): ClosestPoints<number>;
  boundaryDistance(a: ShapeArray, b: Many): ClosestPoints<Numbers>;
  boundaryDistance(a: Many, b: ShapeArray): ClosestPoints<Numbers>;
  depth(a: Shape, b: Shape): Penetration<number>;
  depth(a: ShapeArray, b: Many): Penetration<Numbers>;
  depth(a: Many, b: ShapeArray): Penetration<Numbers>;
  /** The area that both share. */
  area(a: Shape, b: Shape): number;
  area(a: ShapeArray, b: Many): Numbers;
  area(a: Many, b: ShapeArray): Numbers;
  /** Intersection over union. */
  iou(a: Shape, b: Shape): number;
  iou(a: ShapeArray, b: Many): Numbers;
  iou(a: Many, b: ShapeArray): Numbers;

  /** The distance or, below 0, how deep they overlap. */
  signedDistance(a: Shape, b: Shape): number;
  signedDistance(a: ShapeArray, b: Many): Numbers;
  signedDistance(a: Many, b: ShapeArray): Numbers;
  /**
   * Are they at most `distance` apart? Exactly so far counts. With a negative distance: do they overlap at least that
   * deep? Exact, but with ellipses it may be 'nearly', where that is too near the one asked for to decide. Arrays have
   * numbers: see `withins`.
   */
  within(a: Shape, b: Shape, distance: number): Within;
  within(a: ShapeArray, b: Many, distance: number, options?: { out?: Uint8Array }): Uint8Array;
  within(a: Many, b: ShapeArray, distance: number, options?: { out?: Uint8Array }): Uint8Array;
  /** The nine-intersection matrix, as geographic systems have it, such as 'FF2F11212'. */
  de9im(a: Shape, b: Shape): string;
  /** Does such a matrix fit a pattern of F, 0, 1, 2, T (any of 0, 1 and 2) and * (anything)? */
  de9imMatch(matrix: string, pattern: string): boolean;
  /** The vertices of the region shared by points, segments, aabbs, rects and convex polygons, or by a segment and
   * anything. Of a segment and a polygon or a polyline two for each piece, in order along the segment. */
  intersection(a: Shape, b: Shape): { x: number; y: number }[];
  /** What share of one shape the other covers, and other ratios by which detections are compared: see `ratios`. */
  ratio(which: Ratio, a: Shape, b: Shape): number;
  ratio(which: Ratio, a: ShapeArray, b: Many): Numbers;
  ratio(which: Ratio, a: Many, b: ShapeArray): Numbers;

  /** A distance of circles, boxes, rectangles or ellipses as Gaussian distributions. */
  gaussianDistance(which: Gaussian, a: Shape, b: Shape): number;
  gaussianDistance(which: Gaussian, a: ShapeArray, b: Many): Numbers;
  gaussianDistance(which: Gaussian, a: Many, b: ShapeArray): Numbers;
  gaussianDistanceMatrix(which: Gaussian, a: ShapeArray, b: ShapeArray): Numbers;
  /** Where do two convex shapes press on each other, and how deep? In arrays a pair with an error has null. */
  manifold(a: Shape, b: Shape): Manifold;
  manifold(a: ShapeArray, b: Many): (Manifold | null)[];
  manifold(a: Many, b: ShapeArray): (Manifold | null)[];

  /** The smallest convex polygon that contains points, exact, counter-clockwise where y points up. */
  convexHull(points: Points): Polygon;
  /** The rectangle of the least area that contains points, or those about each polygon or polyline of an array. */
  minAreaRect(points: Points): Rect;
  minAreaRect(points: ShapeArray): ShapeArray;
  /** The rectangle of the least perimeter, likewise. */
  minPerimeterRect(points: Points): Rect;
  minPerimeterRect(points: ShapeArray): ShapeArray;
  /** The share of each cell that a shape covers, from 0 to 1: element j * columns + i is that of cell (i, j). */
  coverage(shape: Shape, grid: Grid): Float64Array;
  /** The cells, as j * columns + i, of which it covers more than nothing, in no particular order. */
  coverageCells(shape: Shape, grid: Grid): { cells: number[]; shares: Float64Array };

  /** Every pair: the answer for a[i] and b[j] is element i * b.length + j. */
  overlapMatrix(a: ShapeArray, b: ShapeArray): Uint8Array;
  interiorsOverlapMatrix(a: ShapeArray, b: ShapeArray): Uint8Array;
  relationMatrix(a: ShapeArray, b: ShapeArray): Uint8Array;
  containsMatrix(a: ShapeArray, b: ShapeArray): Uint8Array;
  areaMatrix(a: ShapeArray, b: ShapeArray): Numbers;
  iouMatrix(a: ShapeArray, b: ShapeArray): Numbers;
  ratioMatrix(which: Ratio, a: ShapeArray, b: ShapeArray): Numbers;
  /** Distances and depths alone, without points or directions. */
  nearestMatrix(a: ShapeArray, b: ShapeArray): Numbers;
  boundaryDistanceMatrix(a: ShapeArray, b: ShapeArray): Numbers;
  depthMatrix(a: ShapeArray, b: ShapeArray): Numbers;
  signedDistanceMatrix(a: ShapeArray, b: ShapeArray): Numbers;
  withinMatrix(a: ShapeArray, b: ShapeArray, distance: number): Uint8Array;

  /**
   * Does b touch a while it is moved by t * velocity, t from 0 to tEnd, when first, and where? Whether it does is
   * exact, and t is rounded down. A ray is a point that moves. Of arrays a velocity may be two numbers, or two arrays.
   */
  cast(a: Shape, b: Shape, velocity: Velocity, options?: Until): Impact<number> & { outcome: Outcome };
  cast(a: ShapeArray, b: Many, velocity: Velocities, options?: Until): Impact<Numbers>;
  cast(a: Many, b: ShapeArray, velocity: Velocities, options?: Until): Impact<Numbers>;
  /** Which of many shapes at rest does one moving shape touch first? The lowest of several, or null. */
  castFirst(one: Shape, many: ShapeArray, velocity: Velocity, options?: Until): FirstImpact | null;
  /**
   * When do two shapes that move and turn touch first, t from 0 to 1? Proved: there is no contact before t, however
   * thin they are and however fast they turn. Angles are at most 2^20, from +x towards +y. The gap is at most the
   * tolerance, a length above 0, but for rounding and very long searches (see vesica_impact_time_f64 of `c`).
   *
   * 'miss': proved, no contact from 0 to 1; t is Infinity, the rest NaN. 'hit': proved, contact after t. 'near': they
   * come as near as the gap; there may be contact after t. 'start': they overlap at t = 0, exactly; the gap is 0.
   */
  impactTime(a: Shape, turnA: Turn, b: Shape, turnB: Turn, tolerance: number): ImpactTime;
  /** A box that holds a shape throughout its motion. */
  sweepBounds(shape: Shape, velocity: Velocity, tEnd: number): Aabb;

  /** The indices of those of many that overlap one. */
  overlapSelect(one: Shape, many: ShapeArray): number[];
  /** The indices of those of many whose insides share a point with that of one. */
  interiorsOverlapSelect(one: Shape, many: ShapeArray): number[];
  /** Where outlines meet, in order along a's. */
  crossings(a: Shape, b: Shape): Crossings;
  shapeArea(shape: Shape): number;
  /** The smallest box that surely contains a shape. */
  bounds(shape: Shape): Aabb;
  /** Why a shape is invalid, or null. */
  invalidity(shape: Shape): string | null;
  /** Greedy suppression: the indices kept, best score first. Scores are not rounded, also beside f32 boxes. */
  nms(boxes: ShapeArray, scores: ArrayLike<number>, threshold?: number, options?: Suppression): number[];
  /**
   * Soft suppression: the indices as they are taken, and the scores that were left then. What has a ratio r with one
   * taken keeps its score times 1 - r where r is above the parameter, or times exp(-r^2 / parameter).
   */
  nmsSoft(
    boxes: ShapeArray,
    scores: ArrayLike<number>,
    parameter?: number,
    options?: Suppression & { decay?: 'linear' | 'gaussian' },
  ): { indices: number[]; scores: number[] };

  /**
   * Weighted boxes fusion of aabbs or rects: the mean of each cluster with its score, and the cluster of each box. A
   * box joins the cluster of its label whose mean it has the highest IoU with, if that exceeds the threshold, 0.55 if
   * left out. Scores are the `mean` of a cluster's, or the `max`. See vesica_fuse_f64 of `c`.
   */
  fuse(
    boxes: ShapeArray,
    scores: ArrayLike<number>,
    threshold?: number,
    options?: { weights?: ArrayLike<number>; labels?: ArrayLike<number>; score?: 'mean' | 'max' },
  ): { boxes: ShapeArray; scores: Numbers; clusters: number[] };
  /**
   * Greedy assignment: the pairs k that are taken, the best value first, while both items are free. The sum of their
   * values may be less than the largest possible one.
   */
  assignGreedy(pairs: Pairs): number[];
  /**
   * Which detections hit a truth, at each threshold? Pairs are of a detection and a truth, with their IoU at the lowest
   * threshold or below. Element t * detections + i is of detection i at threshold t: its outcome (see `outcomes`), and
   * the truth that it takes, or -1. Thresholds are [0.5] if left out. See vesica_match_truths_f64 of `c`.
   */
  matchTruths(
    pairs: Pairs,
    scores: ArrayLike<number>,
    truths: number,
    options?: { thresholds?: ArrayLike<number>; rule?: 'voc' | 'coco'; flags?: ArrayLike<number> },
  ): { outcomes: Uint8Array; taken: number[] };
  /** Average precision of detections of one class, from their outcomes at one threshold; NaN without truths. */
  averagePrecision(
    scores: ArrayLike<number>,
    outcomes: ArrayLike<number>,
    truths: number,
    options?: { rule?: 'voc2007' | 'voc2010' | 'coco' },
  ): number;

  index(...sets: ShapeArray[]): Index;
  /** An index whose bytes were saved, over the same arrays. Damaged bytes are a VesicaError. */
  indexFromBytes(bytes: ArrayBuffer | Uint8Array, ...sets: ShapeArray[]): Index;
}

/** A module: its address, an answer of fetch, bytes, or a compiled module. A string is relative to the page. */
export type Module = string | URL | Response | Promise<Response> | BufferSource | WebAssembly.Module;

/**
 * Loads the library: vesica-simd.wasm beside this file, or vesica.wasm where the engine has no vectors or `simd` is
 * false; or `module`.
 */
export function load(options?: { module?: Module; simd?: boolean }): Promise<Vesica>;
