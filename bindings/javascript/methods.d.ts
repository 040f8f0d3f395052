// SPDX-License-Identifier: Apache-2.0
// vesica_methods.h says what each method is, what it costs and where it may err.
import type { Aabb, Circle, Ellipse, Module, Point, Rect, Segment } from './vesica.js';

export type Verdict = 'no' | 'yes' | 'uncertain';
export const verdicts: readonly Verdict[];

export interface TurnedRect { cx: number; cy: number; angle: number; width: number; height: number }
export interface RadiusVectorEllipse { cx: number; cy: number; wx: number; wy: number; ratio: number }
/** An answer, and how far the method went for it. */
export interface Approximation { answer: Verdict; outlineError: number; iterations: number }
export interface Descent {
  /** 'scale-aware' unless said otherwise; 'literal' has the steps as printed. */
  schedule?: 'scale-aware' | 'literal';
  tolerance?: number;
  rate?: number;
  decay?: number;
  iterations?: number;
  /** How many iterations' errors are wanted. */
  errors?: number;
}

export class Methods {
  private constructor();
  rectEllipseAllFeatures(rect: Rect, ellipse: Ellipse): Verdict;
  rectEllipseClosestFeatures(rect: Rect, ellipse: Ellipse): Verdict;
  rectEllipseMinkowskiSum(rect: Rect, ellipse: Ellipse): Verdict;
  rectEllipsePointParallelogramDistance(
    rect: Rect,
    ellipse: Ellipse,
  ): { answer: Verdict; x: number; y: number; cMin: number };
  rectRectBounds(a: Rect, b: Rect): Verdict;
  rectRectSamplePoints(a: Rect, b: Rect, k: number): Verdict;
  rectRectSeparatingLines(a: Rect, b: Rect): Verdict;
  turnedRectsSeparatingLines(a: TurnedRect, b: TurnedRect): Verdict;
  rectCorners(rect: Rect): { x: number; y: number }[];
  pointRectFrame(point: Point, rect: Rect): Verdict;
  pointAabbIntervals(point: Point, box: Aabb): Verdict;
  aabbAabbIntervals(a: Aabb, b: Aabb): Verdict;
  circleEllipseClosedForm(circle: Circle, ellipse: Ellipse): Verdict;
  segmentCircleDivisionFree(segment: Segment, circle: Circle): Verdict;
  circleEllipsePolygonalSandwich(circle: Circle, ellipse: Ellipse, n: number): Approximation;
  circleEllipseCircleApproximation(circle: Circle, ellipse: Ellipse, n: number): Approximation;
  ellipseEllipseParallelAxes(a: Ellipse, b: Ellipse, n: number): Approximation;
  ellipseEllipseAnyAxes(a: Ellipse, b: Ellipse, n: number): Approximation;
  radiusVectorEllipsesAnyAxes(a: RadiusVectorEllipse, b: RadiusVectorEllipse, n: number): Approximation;
  /** The distance of the outlines, as far as the descent went. */
  ellipseEllipseDistanceGradientDescent(a: Ellipse, b: Ellipse, settings?: Descent): {
    angleA: number;
    angleB: number;
    distance: number;
    error: number;
    iterations: number;
    success: boolean;
    errors: number[];
  };
}

/** Loads the named methods: vesica-methods.wasm beside this file, or `module`. */
export function loadMethods(options?: { module?: Module }): Promise<Methods>;
