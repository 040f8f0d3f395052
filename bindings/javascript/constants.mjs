// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.

export const VERSION_MAJOR = 0;
export const VERSION_MINOR = 1;
export const VERSION_PATCH = 0;
/** of this header: major * 10000 + minor * 100 + patch */
export const VERSION = 100;
/** x y */
export const POINT = 0;
/** x0 y0 x1 y1 */
export const SEGMENT = 1;
/** cx cy r */
export const CIRCLE = 2;
/** min_x min_y max_x max_y */
export const AABB = 3;
/** cx cy ux uy hx hy */
export const RECT = 4;
/** cx cy ux uy a b */
export const ELLIPSE = 5;
/** a and b have no common point */
export const DISJOINT = 0;
/** they have common points, but their insides have none */
export const TOUCH = 1;
/** their insides meet, and neither shape contains the other */
export const CROSS = 2;
/** b contains a, and a has no point of b's outline */
export const INSIDE = 3;
/** b contains a, and a has points of b's outline */
export const INSIDE_TOUCH = 4;
/** a contains b, and b has no point of a's outline */
export const CONTAINS = 5;
/** a contains b, and b has points of a's outline */
export const CONTAINS_TOUCH = 6;
/** a and b are the same set of points */
export const EQUAL = 7;
/** a pointer is NULL */
export const E_NULL = -1;
/** a shape is invalid; vesica_check_f64 or _f32 says why */
export const E_SHAPE = -2;
/** a kind is not one of the six */
export const E_KIND = -3;
/** another argument is out of its documented range */
export const E_ARGUMENT = -4;
/** a number is NaN or infinite */
export const E_NOT_FINITE = -5;
/** a radius, half extent or half length is negative */
export const E_NEGATIVE_SIZE = -6;
/** the axis (ux, uy) is (0, 0) */
export const E_ZERO_AXIS = -7;
/** an AABB's min exceeds its max */
export const E_INVERTED = -8;
/** a number of the result would overflow its type */
export const E_RANGE = -9;
/** bytes are not an index of this version, or are damaged */
export const E_INDEX = -10;
export const ANGLE_RADIANS = 0;
export const ANGLE_DEGREES = 1;
/** quarter turns */
export const ANGLE_QUARTERS = 2;
/** added to a unit: angles turn the other way, from +x towards -y */
export const ANGLE_REVERSED = 4;
/** a and b overlap, as by vesica_overlap_f64 */
export const JOIN_OVERLAP = 0;
/** their bounds in the indexes do: all pairs that overlap, and some that do not */
export const JOIN_BOUNDS = 1;
/** a contains b, as by vesica_contains_f64 */
export const JOIN_CONTAINS = 2;
/** b contains a */
export const JOIN_INSIDE = 3;
/** shared area / area of the union of a and b (IoU) */
export const RATIO_OVER_UNION = 0;
/** shared area / area of a (IoF) */
export const RATIO_OVER_FIRST = 1;
/** shared area / area of b (IoA) */
export const RATIO_OVER_SECOND = 2;
/** shared area / the smaller of the areas (IoS) */
export const RATIO_OVER_SMALLER = 3;
/** IoU - (area of the hull that neither covers / area of the hull) (GIoU) */
export const RATIO_GENERALIZED = 4;
/** IoU - (distance of the centres / diagonal of the hull)^2 (DIoU) */
export const RATIO_DISTANCE = 5;
/** DIoU - v^2 / (1 - IoU + v), v = (difference of angles / 90 degrees)^2 (CIoU) */
export const RATIO_COMPLETE = 6;
/** they are farther apart */
export const WITHIN_NO = 0;
/** they are at most that far apart */
export const WITHIN_YES = 1;
/** only with an ellipse: their distance is too close to the one asked for to tell */
export const WITHIN_NEARLY = 2;
/** score * (1 - r) if r exceeds the parameter, a threshold from 0 to 1 */
export const DECAY_LINEAR = 0;
/** score * exp(-r^2 / parameter) if r > 0; the parameter is at least 2^-100 */
export const DECAY_GAUSSIAN = 1;
/** no contact from 0 to t_end */
export const CAST_MISS = 0;
/** contact, the first after t = 0 */
export const CAST_HIT = 1;
/** the shapes overlap at t = 0, as vesica_overlap_f64 tells */
export const CAST_START = 2;
/** only from vesica_impact_time_f64: none before t, and perhaps none later */
export const CAST_NEAR = 3;
/** characters of a nine-intersection matrix with its final NUL */
export const DE9IM_SIZE = 10;
/** vertices of a shared region, at most */
export const MOST_VERTICES = 8;
