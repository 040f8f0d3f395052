// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
package vesica;

/** The functions of the C library, with their texts. Object is an array or a direct buffer. */
final class Native {
  /**
   * of this header: major * 10000 + minor * 100 + patch
   */
  static final int VERSION = 100;

  private Native() {}

  static {
    Library.load();
  }

  /**
   * Version of the loaded library. If it is below VESICA_VERSION, the library is older than the header.
   *
   * <p>Since: 0.1.
   */
  static native int version();

  /**
   * VESICA_VERSION_MAJOR of the loaded library.
   *
   * <p>Since: 0.1.
   */
  static native int versionMajor();

  /**
   * VESICA_VERSION_MINOR of the loaded library.
   *
   * <p>Since: 0.1.
   */
  static native int versionMinor();

  /**
   * VESICA_VERSION_PATCH of the loaded library.
   *
   * <p>Since: 0.1.
   */
  static native int versionPatch();

  /**
   * What an error code means, as one English phrase without a full stop.
   *
   * <p>Returns: static text, never NULL: "success" for answers (&gt;= 0), "unknown error" for unknown codes.
   *
   * <p>Since: 0.1.
   */
  static native String strerror(int code);

  /**
   * How many numbers does a shape of this kind have?
   *
   * <p>Returns: 2, 4, 3, 4, 6, 6 for VESICA_POINT ... VESICA_ELLIPSE.
   *
   * <p>Errors: VESICA_E_KIND.
   *
   * <p>Since: 0.1.
   */
  static native int fieldCount(int kind);

  /**
   * Name of a kind.
   *
   * <p>Returns: static text: "point", "segment", "circle", "aabb", "rect" or "ellipse"; NULL for an unknown kind.
   *
   * <p>Since: 0.1.
   */
  static native String kindName(int kind);

  /**
   * Is a shape valid, and if not, which rule does it break?
   *
   * <p>Returns: 0 for a valid shape, else the first rule broken: VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE,
   * VESICA_E_ZERO_AXIS or VESICA_E_INVERTED.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND.
   *
   * <p>Cost: a few ns.
   *
   * <p>Since: 0.1.
   */
  static native int checkF64(int kind, Object numbers);

  /**
   * Do two shapes share a point? Touching counts.
   *
   * <p>Returns: 1 if they do, 0 if not.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Cost: about 2 ns more than the function named after the two kinds.
   *
   * <p>Since: 0.1.
   */
  static native int overlapF64(int kindA, Object numbersA, int kindB, Object numbersB);

  /**
   * How does a relate to b? The answer is one of the eight relations of the region connection calculus (RCC-8).
   *
   * <p>The outline of a shape with area is the curve around it. The outline of a segment, or of a shape with one size
   * zero, is its two end points. A point, or a shape without any size, has no outline. The inside is the shape without
   * its outline. If several relations fit, VESICA_EQUAL comes first, then those of containment, then VESICA_CROSS. So a
   * segment that ends on the middle of another touches it; two segments on one line that overlap in part cross; a point
   * on the rim of a disc is VESICA_INSIDE_TOUCH. Exchanging the shapes always gives the converse relation.
   *
   * <p>Returns: VESICA_DISJOINT ... VESICA_EQUAL. Equal sets are VESICA_EQUAL, whatever kinds and numbers describe
   * them.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Cost: up to twice that of vesica_overlap_f64; 0.1 to 8 us if shapes touch or are equal; at worst 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int relationF64(int kindA, Object numbersA, int kindB, Object numbersB);

  /**
   * Does a contain all of b? A shape contains itself, and whatever touches its outline from inside.
   *
   * <p>Returns: 1 if vesica_relation_f64 is VESICA_CONTAINS, VESICA_CONTAINS_TOUCH or VESICA_EQUAL, else 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Cost: that of vesica_relation_f64.
   *
   * <p>Since: 0.1.
   */
  static native int containsF64(int kindA, Object numbersA, int kindB, Object numbersB);

  /**
   * Where do the outlines of two shapes meet? Touching counts.
   *
   * <p>The outline of a shape with area is the curve around it. A segment, a point and a shape without area are their
   * own outlines. A contact counts as one place, however closely the curves touch there. If straight outlines share a
   * stretch, its two end points are places, and out-&gt;shared is 1; so equal boxes meet at their four corners. Two
   * equal curves meet everywhere: then the count is 0 and out-&gt;shared is 1. Places come in order along a's outline,
   * counter-clockwise in the frame of its axis. The start is a box's corner C - hx u - hy perp(u), an ellipse's point C
   * + a u (one without area begins as a box), a circle's point C + (r, 0), or a segment's first end.
   *
   * <p>Returns: the number of places, 0 to 8.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the number is exact. A place is right to 4 u times the largest coordinate or size of either shape,
   * even where the outlines nearly coincide. Places closer to one another than that may come in either order or be
   * equal. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest
   * of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of at most 4
   * u times the scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: 1 to 10 us; at worst 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int crossingsF64(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * How far apart are two solid shapes, and which of their points are closest?
   *
   * <p>If the shapes overlap (as vesica_overlap_f64 tells), the distance is 0 and both points are one common point. If
   * not, the distance is &gt; 0. Exchanging the shapes exchanges the points and changes no bit. Moving both shapes
   * alike changes no bit of the distance if no coordinate is rounded.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the distance is right to 4 u scale at any aspect ratio; the largest error seen was 1 u scale, and 3.3
   * u beside the ends of the thinnest ellipses. Its relative error is at most 2 u above 1e-10 scale (aspect ratios up
   * to 1e6) or 1e-14 scale (up to 1000). Closest points are right to 4 u scale, and a common point to 8 u scale, before
   * they are rounded. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is
   * the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error
   * of at most 4 u times the scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: 100 to 250 ns for disjoint shapes, 450 ns for a point and an ellipse, 500 ns for the thinnest ellipses; 50
   * ns if a shape holds the other's centre; 0.3 to 3 us for shapes that cross, near-ties and magnitudes above 2^40 or
   * below 2^-40; at worst 25 us.
   *
   * <p>Since: 0.1.
   */
  static native int nearestF64(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * How far apart are the outlines of two shapes, and where do they come closest?
   *
   * <p>The outline of a shape with area is the curve around it. A point, a segment and a shape with a zero size are
   * their own outlines. If outlines meet, the distance is 0 and (ax, ay) = (bx, by) is a point of both. If shapes are
   * disjoint, the result is that of vesica_nearest_f64. If one is strictly inside the other, the distance is the least
   * over the whole outline, never a local minimum. Which case holds is decided exactly. Exchanging the shapes exchanges
   * the points and changes no bit. Moving both shapes alike changes no bit of the distance if no coordinate is rounded.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: at aspect ratios up to 1e6 the distance is right to 4 u scale, and the points are that far apart to 16
   * u scale. At any ratio it is above 0 unless outlines meet, and points are on them to 12 u scale before they are
   * rounded. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest
   * of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of at most 4
   * u times the scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: that of vesica_nearest_f64 for disjoint shapes; 0.1 to 0.5 us for nested ones, for a few 1 us more; 0.4 to
   * 0.8 us if outlines meet, for thin shapes as vesica_crossings_f64; up to 5 us more for near-ties; at worst 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int boundaryDistanceF64(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * Penetration depth: how far and which way must b be moved until the two shapes only touch?
   *
   * <p>Moving b by out-&gt;depth along the unit vector (x, y) is the shortest translation after which a line separates
   * the shapes: a on one side, b on the other, where both may touch the line. For disjoint shapes all three numbers are
   * 0. Overlapping shapes always get a direction. Their depth is 0 if such a line exists without a move: if they touch
   * from outside, if a point lies on an outline, or if points and segments lie along one line. Otherwise the depth is
   * &gt; 0. Exchanging the shapes reverses the direction and changes no other bit, except for two equal shapes in one
   * place. Moving both shapes alike changes no bit if no coordinate is rounded.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: at aspect ratios up to 1e6 the depth is right to 4 u scale; for circles and points, to its last place.
   * The length of (x, y) is 1 to 3 u. After the move at most 8 u scale of overlap is left. Whether the depth is 0 is
   * exact at any ratio; beyond 1e6 no bound on its error is stated. In bounds on errors u is 2^-53, half a unit in the
   * last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
   * lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter
   * size.
   *
   * <p>Cost: about 150 ns for points, segments and boxes; 0.5 us with an ellipse, for a few 1 us more; up to 5 us if
   * only exact arithmetic can tell the depth from 0; at worst 25 us.
   *
   * <p>Since: 0.1.
   */
  static native int depthF64(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the double nearest to the true area; a tiny area becomes subnormal or 0. So a shape inside another
   * never has the greater area, and equal shapes have equal areas, whatever kinds and numbers describe them.
   *
   * <p>Cost: about 20 ns.
   *
   * <p>Since: 0.1.
   */
  static native int shapeAreaF64(int kind, Object numbers, Object out);

  /**
   * Area of the intersection of two shapes.
   *
   * <p>It is exactly 0 if shapes are disjoint, if they only touch, or if one has no area. If one contains the other, it
   * is the vesica_shape_area_f64 of the inner one. It is never more than the area of either, and more than 0 if the
   * insides of shapes with area meet, unless that underflows. Exchanging the shapes changes no bit. Scaling both by a
   * power of two scales the area by its square.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: right to 64 u times the smaller shape's area times the larger aspect ratio, at aspect ratios up to
   * 10^4, even if the outlines nearly touch or coincide and whatever the sizes are. Beyond 10^4 no bound is stated;
   * what is said above holds at any ratio. In bounds on errors u is 2^-53, half a unit in the last place of 1. The
   * scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u
   * scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: about 50 ns for two boxes, 150 ns for an ellipse and a box, 0.6 us for two ellipses; up to 10 us if
   * outlines nearly touch or coincide, or if one shape is far larger; at worst 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int areaF64(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
   *
   * <p>It is exactly 1 for equal shapes and exactly 0 for shapes that share no area. Intermediate results never
   * overflow or underflow. Exchanging the shapes, or scaling both by a power of two, changes no bit.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (neither shape has an area).
   *
   * <p>Accuracy: the bound of vesica_area_f64, divided by the area of the union.
   *
   * <p>Cost: that of vesica_area_f64 and of vesica_shape_area_f64 twice.
   *
   * <p>Since: 0.1.
   */
  static native int iouF64(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * Smallest box of representable numbers that contains a shape.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: each side is the true extreme of the shape, rounded outward once. So a representable box is exact.
   *
   * <p>Cost: up to 80 ns; 1 to 3 us for magnitudes above 2^400 or below 2^-400, and for an ellipse with an oblique axis
   * and representable sides; at worst 6 us.
   *
   * <p>Since: 0.1.
   */
  static native int boundsF64(int kind, Object numbers, Object out);

  /**
   * Box with two opposite corners, in any order.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Since: 0.1.
   */
  static native int aabbFromCornersF64(double x0, double y0, double x1, double y1, Object out);

  /**
   * Rectangle from centre, angle and full size: width along the angle, height across it.
   *
   * <p>Requires: the angle in radians, counter-clockwise from +x if y points up; width, height &gt;= 0.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
   *
   * <p>Accuracy: the axis is (cos, sin), each right to 1 unit in the last place. No double is exactly pi/2, so a
   * quarter turn has an exact axis only by vesica_rects_from_boxes_f64, which takes degrees too. Sizes are exact: if
   * halving one would round (an odd multiple of the smallest subnormal number), the axis is halved instead.
   *
   * <p>Cost: about 40 ns.
   *
   * <p>Since: 0.1.
   */
  static native int rectFromAngleF64(double cx, double cy, double angle, double width, double height, Object out);

  /**
   * Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
   *
   * <p>Corners that are not exactly a rectangle's give a rectangle near them, which need not contain them. The centre
   * is the mean of the corners. The axis is a unit vector along the edge from corner 0 to corner 1, and hx belongs to
   * that edge. Opposite edges are averaged; the longer pair gives the direction, and the shorter pair counts by its
   * part across it. Two or four equal corners are legal: they give a segment, or a point with axis (1, 0).
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_RANGE (a half extent overflows).
   *
   * <p>Accuracy: half extents, and the axis times the longer one, are right to 8 units in the last place of the longer
   * one; the centre is right to 1 unit in its own. Both errors may grow by 2^-98 times the largest coordinate. A
   * rectangle along the coordinate axes is found exactly if its centre and half extents are representable.
   *
   * <p>Cost: about 110 ns.
   *
   * <p>Since: 0.1.
   */
  static native int rectFromCornersF64(Object corners, Object out);

  /**
   * Ellipse from centre, angle and half lengths: a along the angle, b across it.
   *
   * <p>Requires: the angle in radians, counter-clockwise from +x if y points up; a, b &gt;= 0.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
   *
   * <p>Accuracy: the axis is that of vesica_rect_from_angle_f64; half lengths are exact.
   *
   * <p>Cost: about 40 ns.
   *
   * <p>Since: 0.1.
   */
  static native int ellipseFromAngleF64(double cx, double cy, double angle, double a, double b, Object out);

  /**
   * Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
   *
   * <p>A zero vector gives the point (cx, cy).
   *
   * <p>Requires: ratio &gt;= 0.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Since: 0.1.
   */
  static native int ellipseFromRadiusVectorF64(double cx, double cy, double wx, double wy, double ratio, Object out);

  /**
   * Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
   *
   * <p>A singular covariance, or k = 0, gives a segment or a point. The result has a &gt;= b. Its axis is a unit vector
   * with x &gt;= 0, or (1, 0) for equal variances without correlation.
   *
   * <p>Requires: the covariance cxx, cxy, cyy (units squared) positive semidefinite: cxy^2 &lt;= cxx cyy as stored; k
   * &gt;= 0.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE (k &lt; 0), VESICA_E_ARGUMENT (not a
   * covariance), VESICA_E_RANGE (a half length overflows).
   *
   * <p>Accuracy: half lengths and both components of the axis are right to 8 units in their own last place, even if the
   * matrix is nearly singular or nearly a circle's.
   *
   * <p>Cost: about 90 ns.
   *
   * <p>Since: 0.1.
   */
  static native int ellipseFromCovarianceF64(double meanX, double meanY, double cxx, double cxy, double cyy, double k,
      Object out);

  /**
   * Ellipse of the points X with (X - C) . M (X - C) &lt;= 1, where M is symmetric with entries mxx, mxy, myy.
   *
   * <p>The result is that of vesica_ellipse_from_covariance_f64 for the inverse of M and k = 1.
   *
   * <p>Requires: M positive definite as stored.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (not positive definite).
   *
   * <p>Accuracy: that of vesica_ellipse_from_covariance_f64. No half length overflows.
   *
   * <p>Cost: about 90 ns.
   *
   * <p>Since: 0.1.
   */
  static native int ellipseFromMatrixF64(double cx, double cy, double mxx, double mxy, double myy, Object out);

  /**
   * Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f64.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many are 1.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: in cache, from columns, with AVX-512: 0.5 to 2 ns a pair in double, 0.3 to 0.8 ns in float; about half of
   * that if one array is a single shape.
   *
   * <p>Since: 0.1.
   */
  static native long overlapManyF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out);

  /**
   * How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f64.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many are not VESICA_DISJOINT.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long relationManyF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out);

  /**
   * Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f64.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many are 1.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long containsManyF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out);

  /**
   * How far apart are a[i] and b[i], and where? The columns are the fields of vesica_nearest_f64's result.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many pairs overlap (distance 0).
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long nearestManyF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object distance, Object ax, Object ay, Object bx, Object by);

  /**
   * How far apart are the outlines of a[i] and b[i]? The columns are the fields of vesica_boundary_distance_f64's
   * result.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many pairs of outlines meet (distance 0).
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long boundaryDistanceManyF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object distance, Object ax, Object ay, Object bx, Object by);

  /**
   * How deep do a[i] and b[i] overlap? The columns are the fields of vesica_depth_f64's result.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many depths are &gt; 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long depthManyF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object depth, Object x, Object y);

  /**
   * What area do a[i] and b[i] share? out[i] is the result of vesica_area_f64.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many areas are &gt; 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long areaManyF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind, long bCount,
      long bStride, long bStep, Object bBase, Object out);

  /**
   * Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f64.
   *
   * <p>If neither of a pair has an area, out[i] is NaN, and the call returns VESICA_E_ARGUMENT unless a shape is
   * invalid.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many are &gt; 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long iouManyF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind, long bCount,
      long bStride, long bStep, Object bBase, Object out);

  /**
   * Do a[i] and b[j] share a point? Answers as of vesica_overlap_f64; much quicker if both arrays are in spatial order.
   *
   * <p>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride counts elements
   * of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run backwards in memory.
   *
   * <p>Returns: how many are 1.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that
   * exceed the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
   *
   * <p>Since: 0.1.
   */
  static native long overlapMatrixF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * How does a[i] relate to b[j]? The elements of out are answers of vesica_relation_f64.
   *
   * <p>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride counts elements
   * of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run backwards in memory.
   *
   * <p>Returns: how many are not VESICA_DISJOINT.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that
   * exceed the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
   *
   * <p>Since: 0.1.
   */
  static native long relationMatrixF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * Does a[i] contain all of b[j]? The elements of out are answers of vesica_contains_f64.
   *
   * <p>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride counts elements
   * of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run backwards in memory.
   *
   * <p>Returns: how many are 1.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that
   * exceed the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
   *
   * <p>Since: 0.1.
   */
  static native long containsMatrixF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * What area do a[i] and b[j] share? The elements of out are results of vesica_area_f64.
   *
   * <p>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride counts elements
   * of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run backwards in memory.
   *
   * <p>Returns: how many are &gt; 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that
   * exceed the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
   *
   * <p>Since: 0.1.
   */
  static native long areaMatrixF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * Intersection over union of a[i] and b[j]. The elements of out are results of vesica_iou_f64.
   *
   * <p>If neither of a pair has an area, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
   *
   * <p>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride counts elements
   * of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run backwards in memory.
   *
   * <p>Returns: how many are &gt; 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that
   * exceed the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
   *
   * <p>Since: 0.1.
   */
  static native long iouMatrixF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * Which of many shapes overlap one? Their indices are written to out[0], out[1] ..., in ascending order.
   *
   * <p>Requires: one, an array of count 1, which is looked at unless many is empty; capacity, how many indices out has
   * room for. It may be 0, and out then NULL.
   *
   * <p>Returns: how many there are, even if that exceeds the capacity. If room is left, the entry after the last is -1.
   *
   * <p>Errors: VESICA_E_SHAPE if a shape is invalid: it is not selected, and the others are written as usual, up to the
   * -1 or the capacity. Before anything is written: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (one's count is not
   * 1, a negative capacity, and as vesica_overlap_many_f64).
   *
   * <p>Accuracy: every answer is that of vesica_overlap_f64.
   *
   * <p>Cost: that of vesica_overlap_many_f64.
   *
   * <p>Since: 0.1.
   */
  static native long overlapSelectF64(int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      int manyKind, long manyCount, long manyStride, long manyStep, Object manyBase, Object out, long capacity);

  /**
   * How many bytes of scratch do vesica_nms_f64, vesica_suppress_f64 and their float forms need for `count` shapes?
   *
   * <p>Returns: 0.4 MB, and for each shape at most 140 bytes, about 97 from 10,000 shapes on.
   *
   * <p>Errors: VESICA_E_ARGUMENT (a negative count, or one above 2147483647).
   *
   * <p>Since: 0.1.
   */
  static native long nmsScratch(long count);

  /**
   * Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one whose
   * vesica_iou_f64 with every shape kept before is at most the threshold.
   *
   * <p>Of equal scores the lower index comes first. Infinite scores are legal. At threshold 1 all shapes are kept.
   * Shapes without an area suppress none and are not suppressed.
   *
   * <p>Requires: shapes, of a kind from VESICA_CIRCLE to VESICA_ELLIPSE; scores, one for each; threshold from 0 to
   * 1; scratch, of vesica_nms_scratch bytes or more, with any alignment and content; keep, with room for all indices.
   *
   * <p>Returns: 0, with *kept set to how many are kept. keep has their indices in the order of their scores; the rest
   * of keep is not written.
   *
   * <p>Errors: VESICA_E_SHAPE if a shape is invalid or its score is NaN: it is left out, and the result of the others
   * is written. Before anything is written: VESICA_E_NULL (with count 0 all but shapes and kept may be NULL),
   * VESICA_E_KIND (points and segments too), VESICA_E_ARGUMENT (the array as vesica_overlap_many_f64, threshold, too
   * little scratch).
   *
   * <p>Cost: 0.3 to 1.2 us a shape; in a crowd, that of vesica_iou_many_f64 for each pair of a shape and one that is
   * kept near it: 20,000 in one place, nearly all kept, took 0.5 to 1 ms a shape.
   *
   * <p>Since: 0.1.
   */
  static native int nmsF64(int shapesKind, long shapesCount, long shapesStride, long shapesStep, Object shapesBase,
      Object scores, double threshold, Object scratch, long scratchSize, Object keep, Object kept);

  /**
   * Is a shape valid, and if not, which rule does it break?
   *
   * <p>Returns: 0 for a valid shape, else the first rule broken: VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE,
   * VESICA_E_ZERO_AXIS or VESICA_E_INVERTED.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND.
   *
   * <p>Cost: a few ns.
   *
   * <p>Since: 0.1.
   */
  static native int checkF32(int kind, Object numbers);

  /**
   * Do two shapes share a point? Touching counts.
   *
   * <p>Returns: 1 if they do, 0 if not.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Cost: about 2 ns more than the function named after the two kinds.
   *
   * <p>Since: 0.1.
   */
  static native int overlapF32(int kindA, Object numbersA, int kindB, Object numbersB);

  /**
   * How does a relate to b? The answer is one of the eight relations of the region connection calculus (RCC-8).
   *
   * <p>The outline of a shape with area is the curve around it. The outline of a segment, or of a shape with one size
   * zero, is its two end points. A point, or a shape without any size, has no outline. The inside is the shape without
   * its outline. If several relations fit, VESICA_EQUAL comes first, then those of containment, then VESICA_CROSS. So a
   * segment that ends on the middle of another touches it; two segments on one line that overlap in part cross; a point
   * on the rim of a disc is VESICA_INSIDE_TOUCH. Exchanging the shapes always gives the converse relation.
   *
   * <p>Returns: VESICA_DISJOINT ... VESICA_EQUAL. Equal sets are VESICA_EQUAL, whatever kinds and numbers describe
   * them.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Cost: up to twice that of vesica_overlap_f32; 0.1 to 8 us if shapes touch or are equal; at worst 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int relationF32(int kindA, Object numbersA, int kindB, Object numbersB);

  /**
   * Does a contain all of b? A shape contains itself, and whatever touches its outline from inside.
   *
   * <p>Returns: 1 if vesica_relation_f32 is VESICA_CONTAINS, VESICA_CONTAINS_TOUCH or VESICA_EQUAL, else 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Cost: that of vesica_relation_f32.
   *
   * <p>Since: 0.1.
   */
  static native int containsF32(int kindA, Object numbersA, int kindB, Object numbersB);

  /**
   * Where do the outlines of two shapes meet? Touching counts.
   *
   * <p>The outline of a shape with area is the curve around it. A segment, a point and a shape without area are their
   * own outlines. A contact counts as one place, however closely the curves touch there. If straight outlines share a
   * stretch, its two end points are places, and out-&gt;shared is 1; so equal boxes meet at their four corners. Two
   * equal curves meet everywhere: then the count is 0 and out-&gt;shared is 1. Places come in order along a's outline,
   * counter-clockwise in the frame of its axis. The start is a box's corner C - hx u - hy perp(u), an ellipse's point C
   * + a u (one without area begins as a box), a circle's point C + (r, 0), or a segment's first end.
   *
   * <p>Returns: the number of places, 0 to 8.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the number is exact. A place is right to 4 u times the largest coordinate or size of either shape,
   * even where the outlines nearly coincide. Places closer to one another than that may come in either order or be
   * equal. Each number is computed in double, within these bounds, and then rounded to float once. In bounds on errors
   * u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
   * their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
   * aspect ratio is longer over shorter size.
   *
   * <p>Cost: 1 to 10 us; at worst 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int crossingsF32(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * How far apart are two solid shapes, and which of their points are closest?
   *
   * <p>If the shapes overlap (as vesica_overlap_f32 tells), the distance is 0 and both points are one common point. If
   * not, the distance is &gt; 0. Exchanging the shapes exchanges the points and changes no bit. Moving both shapes
   * alike changes no bit of the distance if no coordinate is rounded.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the distance is right to 4 u scale at any aspect ratio; the largest error seen was 1 u scale, and 3.3
   * u beside the ends of the thinnest ellipses. Its relative error is at most 2 u above 1e-10 scale (aspect ratios up
   * to 1e6) or 1e-14 scale (up to 1000). Closest points are right to 4 u scale, and a common point to 8 u scale, before
   * they are rounded. Each number is computed in double, within these bounds, and then rounded to float once. In bounds
   * on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy|
   * between their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the
   * scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: 100 to 250 ns for disjoint shapes, 450 ns for a point and an ellipse, 500 ns for the thinnest ellipses; 50
   * ns if a shape holds the other's centre; 0.3 to 3 us for shapes that cross, near-ties and magnitudes above 2^40 or
   * below 2^-40; at worst 25 us.
   *
   * <p>Since: 0.1.
   */
  static native int nearestF32(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * How far apart are the outlines of two shapes, and where do they come closest?
   *
   * <p>The outline of a shape with area is the curve around it. A point, a segment and a shape with a zero size are
   * their own outlines. If outlines meet, the distance is 0 and (ax, ay) = (bx, by) is a point of both. If shapes are
   * disjoint, the result is that of vesica_nearest_f32. If one is strictly inside the other, the distance is the least
   * over the whole outline, never a local minimum. Which case holds is decided exactly. Exchanging the shapes exchanges
   * the points and changes no bit. Moving both shapes alike changes no bit of the distance if no coordinate is rounded.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: at aspect ratios up to 1e6 the distance is right to 4 u scale, and the points are that far apart to 16
   * u scale. At any ratio it is above 0 unless outlines meet, and points are on them to 12 u scale before they are
   * rounded. Each number is computed in double, within these bounds, and then rounded to float once. In bounds on
   * errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy|
   * between their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the
   * scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: that of vesica_nearest_f32 for disjoint shapes; 0.1 to 0.5 us for nested ones, for a few 1 us more; 0.4 to
   * 0.8 us if outlines meet, for thin shapes as vesica_crossings_f32; up to 5 us more for near-ties; at worst 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int boundaryDistanceF32(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * Penetration depth: how far and which way must b be moved until the two shapes only touch?
   *
   * <p>Moving b by out-&gt;depth along the unit vector (x, y) is the shortest translation after which a line separates
   * the shapes: a on one side, b on the other, where both may touch the line. For disjoint shapes all three numbers are
   * 0. Overlapping shapes always get a direction. Their depth is 0 if such a line exists without a move: if they touch
   * from outside, if a point lies on an outline, or if points and segments lie along one line. Otherwise the depth is
   * &gt; 0. Exchanging the shapes reverses the direction and changes no other bit, except for two equal shapes in one
   * place. Moving both shapes alike changes no bit if no coordinate is rounded.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: at aspect ratios up to 1e6 the depth is right to 4 u scale; for circles and points, to its last place.
   * The length of (x, y) is 1 to 3 u. After the move at most 8 u scale of overlap is left. Whether the depth is 0 is
   * exact at any ratio; beyond 1e6 no bound on its error is stated. Each number is computed in double, within these
   * bounds, and then rounded to float once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The
   * scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u
   * scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: about 150 ns for points, segments and boxes; 0.5 us with an ellipse, for a few 1 us more; up to 5 us if
   * only exact arithmetic can tell the depth from 0; at worst 25 us.
   *
   * <p>Since: 0.1.
   */
  static native int depthF32(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the double nearest to the true area; a tiny area becomes subnormal or 0. So a shape inside another
   * never has the greater area, and equal shapes have equal areas, whatever kinds and numbers describe them. Each
   * number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Cost: about 20 ns.
   *
   * <p>Since: 0.1.
   */
  static native int shapeAreaF32(int kind, Object numbers, Object out);

  /**
   * Area of the intersection of two shapes.
   *
   * <p>It is exactly 0 if shapes are disjoint, if they only touch, or if one has no area. If one contains the other, it
   * is the vesica_shape_area_f32 of the inner one. It is never more than the area of either, and more than 0 if the
   * insides of shapes with area meet, unless that underflows. Exchanging the shapes changes no bit. Scaling both by a
   * power of two scales the area by its square.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: right to 64 u times the smaller shape's area times the larger aspect ratio, at aspect ratios up to
   * 10^4, even if the outlines nearly touch or coincide and whatever the sizes are. Beyond 10^4 no bound is stated;
   * what is said above holds at any ratio. Each number is computed in double, within these bounds, and then rounded to
   * float once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the
   * largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of at
   * most 4 u times the scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: about 50 ns for two boxes, 150 ns for an ellipse and a box, 0.6 us for two ellipses; up to 10 us if
   * outlines nearly touch or coincide, or if one shape is far larger; at worst 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int areaF32(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
   *
   * <p>It is exactly 1 for equal shapes and exactly 0 for shapes that share no area. Intermediate results never
   * overflow or underflow. Exchanging the shapes, or scaling both by a power of two, changes no bit.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (neither shape has an area).
   *
   * <p>Accuracy: the bound of vesica_area_f32, divided by the area of the union.
   * Each number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Cost: that of vesica_area_f32 and of vesica_shape_area_f32 twice.
   *
   * <p>Since: 0.1.
   */
  static native int iouF32(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * Smallest box of representable numbers that contains a shape.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: each side is the true extreme of the shape, rounded outward once. So a representable box is exact.
   *
   * <p>Cost: up to 80 ns; 1 to 3 us for magnitudes above 2^400 or below 2^-400, and for an ellipse with an oblique axis
   * and representable sides; at worst 6 us.
   *
   * <p>Since: 0.1.
   */
  static native int boundsF32(int kind, Object numbers, Object out);

  /**
   * Box with two opposite corners, in any order.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Since: 0.1.
   */
  static native int aabbFromCornersF32(float x0, float y0, float x1, float y1, Object out);

  /**
   * Rectangle from centre, angle and full size: width along the angle, height across it.
   *
   * <p>Requires: the angle in radians, counter-clockwise from +x if y points up; width, height &gt;= 0.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
   *
   * <p>Accuracy: the axis is (cos, sin), each right to 1 unit in the last place. No double is exactly pi/2, so a
   * quarter turn has an exact axis only by vesica_rects_from_boxes_f32, which takes degrees too. Sizes are exact: if
   * halving one would round (an odd multiple of the smallest subnormal number), the axis is halved instead.
   *
   * <p>Cost: about 40 ns.
   *
   * <p>Since: 0.1.
   */
  static native int rectFromAngleF32(float cx, float cy, float angle, float width, float height, Object out);

  /**
   * Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
   *
   * <p>Corners that are not exactly a rectangle's give a rectangle near them, which need not contain them. The centre
   * is the mean of the corners. The axis is a unit vector along the edge from corner 0 to corner 1, and hx belongs to
   * that edge. Opposite edges are averaged; the longer pair gives the direction, and the shorter pair counts by its
   * part across it. Two or four equal corners are legal: they give a segment, or a point with axis (1, 0).
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_RANGE (a half extent overflows).
   *
   * <p>Accuracy: half extents, and the axis times the longer one, are right to 8 units in the last place of the longer
   * one; the centre is right to 1 unit in its own. Both errors may grow by 2^-98 times the largest coordinate. A
   * rectangle along the coordinate axes is found exactly if its centre and half extents are representable.
   *
   * <p>Cost: about 110 ns.
   *
   * <p>Since: 0.1.
   */
  static native int rectFromCornersF32(Object corners, Object out);

  /**
   * Ellipse from centre, angle and half lengths: a along the angle, b across it.
   *
   * <p>Requires: the angle in radians, counter-clockwise from +x if y points up; a, b &gt;= 0.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
   *
   * <p>Accuracy: the axis is that of vesica_rect_from_angle_f32; half lengths are exact.
   *
   * <p>Cost: about 40 ns.
   *
   * <p>Since: 0.1.
   */
  static native int ellipseFromAngleF32(float cx, float cy, float angle, float a, float b, Object out);

  /**
   * Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
   *
   * <p>A zero vector gives the point (cx, cy).
   *
   * <p>Requires: ratio &gt;= 0.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Since: 0.1.
   */
  static native int ellipseFromRadiusVectorF32(float cx, float cy, float wx, float wy, float ratio, Object out);

  /**
   * Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
   *
   * <p>A singular covariance, or k = 0, gives a segment or a point. The result has a &gt;= b. Its axis is a unit vector
   * with x &gt;= 0, or (1, 0) for equal variances without correlation.
   *
   * <p>Requires: the covariance cxx, cxy, cyy (units squared) positive semidefinite: cxy^2 &lt;= cxx cyy as stored; k
   * &gt;= 0.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE (k &lt; 0), VESICA_E_ARGUMENT (not a
   * covariance), VESICA_E_RANGE (a half length overflows).
   *
   * <p>Accuracy: half lengths and both components of the axis are right to 8 units in their own last place, even if the
   * matrix is nearly singular or nearly a circle's.
   *
   * <p>Cost: about 90 ns.
   *
   * <p>Since: 0.1.
   */
  static native int ellipseFromCovarianceF32(float meanX, float meanY, float cxx, float cxy, float cyy, float k,
      Object out);

  /**
   * Ellipse of the points X with (X - C) . M (X - C) &lt;= 1, where M is symmetric with entries mxx, mxy, myy.
   *
   * <p>The result is that of vesica_ellipse_from_covariance_f32 for the inverse of M and k = 1.
   *
   * <p>Requires: M positive definite as stored.
   *
   * <p>Returns: 0; the shape is valid.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (not positive definite).
   *
   * <p>Accuracy: that of vesica_ellipse_from_covariance_f32. No half length overflows.
   *
   * <p>Cost: about 90 ns.
   *
   * <p>Since: 0.1.
   */
  static native int ellipseFromMatrixF32(float cx, float cy, float mxx, float mxy, float myy, Object out);

  /**
   * Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f32.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many are 1.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: in cache, from columns, with AVX-512: 0.5 to 2 ns a pair in double, 0.3 to 0.8 ns in float; about half of
   * that if one array is a single shape.
   *
   * <p>Since: 0.1.
   */
  static native long overlapManyF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out);

  /**
   * How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f32.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many are not VESICA_DISJOINT.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long relationManyF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out);

  /**
   * Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f32.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many are 1.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long containsManyF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out);

  /**
   * How far apart are a[i] and b[i], and where? The columns are the fields of vesica_nearest_f32's result.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many pairs overlap (distance 0).
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long nearestManyF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object distance, Object ax, Object ay, Object bx, Object by);

  /**
   * How far apart are the outlines of a[i] and b[i]? The columns are the fields of vesica_boundary_distance_f32's
   * result.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many pairs of outlines meet (distance 0).
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long boundaryDistanceManyF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object distance, Object ax, Object ay, Object bx, Object by);

  /**
   * How deep do a[i] and b[i] overlap? The columns are the fields of vesica_depth_f32's result.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many depths are &gt; 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long depthManyF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object depth, Object x, Object y);

  /**
   * What area do a[i] and b[i] share? out[i] is the result of vesica_area_f32.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many areas are &gt; 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long areaManyF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind, long bCount,
      long bStride, long bStep, Object bBase, Object out);

  /**
   * Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f32.
   *
   * <p>If neither of a pair has an area, out[i] is NaN, and the call returns VESICA_E_ARGUMENT unless a shape is
   * invalid.
   *
   * <p>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
   * as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
   *
   * <p>Returns: how many are &gt; 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array that
   * exceeds the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30 ns more
   * where numbers are copied first (docs/benchmarks.md).
   *
   * <p>Since: 0.1.
   */
  static native long iouManyF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind, long bCount,
      long bStride, long bStep, Object bBase, Object out);

  /**
   * Do a[i] and b[j] share a point? Answers as of vesica_overlap_f32; much quicker if both arrays are in spatial order.
   *
   * <p>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride counts elements
   * of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run backwards in memory.
   *
   * <p>Returns: how many are 1.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that
   * exceed the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
   *
   * <p>Since: 0.1.
   */
  static native long overlapMatrixF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * How does a[i] relate to b[j]? The elements of out are answers of vesica_relation_f32.
   *
   * <p>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride counts elements
   * of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run backwards in memory.
   *
   * <p>Returns: how many are not VESICA_DISJOINT.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that
   * exceed the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
   *
   * <p>Since: 0.1.
   */
  static native long relationMatrixF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * Does a[i] contain all of b[j]? The elements of out are answers of vesica_contains_f32.
   *
   * <p>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride counts elements
   * of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run backwards in memory.
   *
   * <p>Returns: how many are 1.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that
   * exceed the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
   *
   * <p>Since: 0.1.
   */
  static native long containsMatrixF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * What area do a[i] and b[j] share? The elements of out are results of vesica_area_f32.
   *
   * <p>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride counts elements
   * of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run backwards in memory.
   *
   * <p>Returns: how many are &gt; 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that
   * exceed the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
   *
   * <p>Since: 0.1.
   */
  static native long areaMatrixF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * Intersection over union of a[i] and b[j]. The elements of out are results of vesica_iou_f32.
   *
   * <p>If neither of a pair has an area, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
   *
   * <p>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride counts elements
   * of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run backwards in memory.
   *
   * <p>Returns: how many are &gt; 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
   * overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
   * written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL),
   * VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that
   * exceed the address space).
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
   *
   * <p>Since: 0.1.
   */
  static native long iouMatrixF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * Which of many shapes overlap one? Their indices are written to out[0], out[1] ..., in ascending order.
   *
   * <p>Requires: one, an array of count 1, which is looked at unless many is empty; capacity, how many indices out has
   * room for. It may be 0, and out then NULL.
   *
   * <p>Returns: how many there are, even if that exceeds the capacity. If room is left, the entry after the last is -1.
   *
   * <p>Errors: VESICA_E_SHAPE if a shape is invalid: it is not selected, and the others are written as usual, up to the
   * -1 or the capacity. Before anything is written: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (one's count is not
   * 1, a negative capacity, and as vesica_overlap_many_f32).
   *
   * <p>Accuracy: every answer is that of vesica_overlap_f32.
   *
   * <p>Cost: that of vesica_overlap_many_f32.
   *
   * <p>Since: 0.1.
   */
  static native long overlapSelectF32(int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      int manyKind, long manyCount, long manyStride, long manyStep, Object manyBase, Object out, long capacity);

  /**
   * Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one whose
   * vesica_iou_f32 with every shape kept before is at most the threshold.
   *
   * <p>Of equal scores the lower index comes first. Infinite scores are legal. At threshold 1 all shapes are kept.
   * Shapes without an area suppress none and are not suppressed.
   *
   * <p>Requires: shapes, of a kind from VESICA_CIRCLE to VESICA_ELLIPSE; scores, one for each; threshold from 0 to
   * 1; scratch, of vesica_nms_scratch bytes or more, with any alignment and content; keep, with room for all indices.
   *
   * <p>Returns: 0, with *kept set to how many are kept. keep has their indices in the order of their scores; the rest
   * of keep is not written.
   *
   * <p>Errors: VESICA_E_SHAPE if a shape is invalid or its score is NaN: it is left out, and the result of the others
   * is written. Before anything is written: VESICA_E_NULL (with count 0 all but shapes and kept may be NULL),
   * VESICA_E_KIND (points and segments too), VESICA_E_ARGUMENT (the array as vesica_overlap_many_f32, threshold, too
   * little scratch).
   *
   * <p>Cost: 0.3 to 1.2 us a shape; in a crowd, that of vesica_iou_many_f32 for each pair of a shape and one that is
   * kept near it: 20,000 in one place, nearly all kept, took 0.5 to 1 ms a shape.
   *
   * <p>Since: 0.1.
   */
  static native int nmsF32(int shapesKind, long shapesCount, long shapesStride, long shapesStep, Object shapesBase,
      Object scores, float threshold, Object scratch, long scratchSize, Object keep, Object kept);

  /**
   * Rectangles from boxes.
   *
   * <p>Requires: boxes, `count` rows of five numbers with any alignment, `stride` bytes apart; angle, a unit of angles,
   * or its sum with VESICA_ANGLE_REVERSED; out, room for `count`.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
   * numbers of that result are NaN, and all other results are written as usual. Before anything is written:
   * VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
   * that exceeds the address space, an unknown unit of angles).
   *
   * <p>Accuracy: the axis is (cos, sin), each right to 1.1 units in the last place. Degrees that are multiples of 90,
   * and whole quarter turns, give exact axes. Sizes are those of vesica_rect_from_angle_f64.
   *
   * <p>Cost: about 30 ns a box.
   *
   * <p>Since: 0.1.
   */
  static native long rectsFromBoxesF64(Object boxes, long count, long stride, int angle, Object out);

  /**
   * Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
   *
   * <p>Requires: as vesica_rects_from_boxes_f64.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
   * numbers of that result are NaN, and all other results are written as usual. Before anything is written:
   * VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
   * that exceeds the address space, an unknown unit of angles).
   *
   * <p>Accuracy: as vesica_rects_from_boxes_f64. Half lengths are halves of width and height.
   *
   * <p>Cost: about 30 ns a box.
   *
   * <p>Since: 0.1.
   */
  static native long ellipsesFromBoxesF64(Object boxes, long count, long stride, int angle, Object out);

  /**
   * Boxes from rectangles or from ellipses: the inverse of the two functions above.
   *
   * <p>Angles are from -180 to 180 degrees, in the unit asked for.
   *
   * <p>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; angle as vesica_rects_from_boxes_f64; boxes, room for
   * `count` rows of five numbers, without gaps.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
   * numbers of that result are NaN, and all other results are written as usual. Before anything is written:
   * VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
   * that exceeds the address space, an unknown unit of angles).
   *
   * <p>Accuracy: width and height are right to 4 units in the last place, and the angle to 2 units in the last place of
   * a quarter turn. If an axis lies exactly along a coordinate axis, degrees and quarter turns are exact.
   *
   * <p>Cost: about 70 ns a shape.
   *
   * <p>Since: 0.1.
   */
  static native long boxesFromShapesF64(int shapesKind, long shapesCount, long shapesStride, long shapesStep,
      Object shapesBase, int angle, Object boxes);

  /**
   * The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
   *
   * <p>The first corner is C - hx u - hy perp(u), the next C + hx u - hy perp(u), and so on round the outline.
   *
   * <p>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; corners, room for `count` rows of eight numbers.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
   * numbers of that result are NaN, and all other results are written as usual. Before anything is written:
   * VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
   * that exceeds the address space, an unknown unit of angles).
   *
   * <p>Accuracy: a coordinate is right to 1 unit in its last place plus 2^-98 times the largest of its three terms.
   *
   * <p>Cost: about 50 ns a shape; 20 ns with AVX2 or AVX-512.
   *
   * <p>Since: 0.1.
   */
  static native long cornersOfShapesF64(int shapesKind, long shapesCount, long shapesStride, long shapesStep,
      Object shapesBase, Object corners);

  /**
   * Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f64.
   *
   * <p>Requires: out, room for `count`.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
   * numbers of that result are NaN, and all other results are written as usual. Before anything is written:
   * VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
   * that exceeds the address space, an unknown unit of angles).
   *
   * <p>Accuracy: that of vesica_bounds_f64.
   *
   * <p>Cost: that of vesica_bounds_f64; with AVX2 or AVX-512 about 10 ns for shapes of which that takes up to 80.
   *
   * <p>Since: 0.1.
   */
  static native long boundsManyF64(int shapesKind, long shapesCount, long shapesStride, long shapesStep,
      Object shapesBase, Object out);

  /**
   * Rectangles from boxes.
   *
   * <p>Requires: boxes, `count` rows of five numbers with any alignment, `stride` bytes apart; angle, a unit of angles,
   * or its sum with VESICA_ANGLE_REVERSED; out, room for `count`.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
   * numbers of that result are NaN, and all other results are written as usual. Before anything is written:
   * VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
   * that exceeds the address space, an unknown unit of angles).
   *
   * <p>Accuracy: the axis is (cos, sin), each right to 1.1 units in the last place. Degrees that are multiples of 90,
   * and whole quarter turns, give exact axes. Sizes are those of vesica_rect_from_angle_f32. Each number is computed in
   * double, within these bounds, and then rounded to float once.
   *
   * <p>Cost: about 30 ns a box.
   *
   * <p>Since: 0.1.
   */
  static native long rectsFromBoxesF32(Object boxes, long count, long stride, int angle, Object out);

  /**
   * Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
   *
   * <p>Requires: as vesica_rects_from_boxes_f32.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
   * numbers of that result are NaN, and all other results are written as usual. Before anything is written:
   * VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
   * that exceeds the address space, an unknown unit of angles).
   *
   * <p>Accuracy: as vesica_rects_from_boxes_f32. Half lengths are halves of width and height.
   * Each number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Cost: about 30 ns a box.
   *
   * <p>Since: 0.1.
   */
  static native long ellipsesFromBoxesF32(Object boxes, long count, long stride, int angle, Object out);

  /**
   * Boxes from rectangles or from ellipses: the inverse of the two functions above.
   *
   * <p>Angles are from -180 to 180 degrees, in the unit asked for.
   *
   * <p>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; angle as vesica_rects_from_boxes_f32; boxes, room for
   * `count` rows of five numbers, without gaps.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
   * numbers of that result are NaN, and all other results are written as usual. Before anything is written:
   * VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
   * that exceeds the address space, an unknown unit of angles).
   *
   * <p>Accuracy: width and height are right to 4 units in the last place, and the angle to 2 units in the last place of
   * a quarter turn. If an axis lies exactly along a coordinate axis, degrees and quarter turns are exact. Each number
   * is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Cost: about 70 ns a shape.
   *
   * <p>Since: 0.1.
   */
  static native long boxesFromShapesF32(int shapesKind, long shapesCount, long shapesStride, long shapesStep,
      Object shapesBase, int angle, Object boxes);

  /**
   * The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
   *
   * <p>The first corner is C - hx u - hy perp(u), the next C + hx u - hy perp(u), and so on round the outline.
   *
   * <p>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; corners, room for `count` rows of eight numbers.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
   * numbers of that result are NaN, and all other results are written as usual. Before anything is written:
   * VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
   * that exceeds the address space, an unknown unit of angles).
   *
   * <p>Accuracy: a coordinate is right to 1 unit in its last place plus 2^-98 times the largest of its three terms.
   * Each number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Cost: about 50 ns a shape; 20 ns with AVX2 or AVX-512.
   *
   * <p>Since: 0.1.
   */
  static native long cornersOfShapesF32(int shapesKind, long shapesCount, long shapesStride, long shapesStep,
      Object shapesBase, Object corners);

  /**
   * Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f32.
   *
   * <p>Requires: out, room for `count`.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
   * numbers of that result are NaN, and all other results are written as usual. Before anything is written:
   * VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
   * that exceeds the address space, an unknown unit of angles).
   *
   * <p>Accuracy: that of vesica_bounds_f32.
   *
   * <p>Cost: that of vesica_bounds_f32; with AVX2 or AVX-512 about 10 ns for shapes of which that takes up to 80.
   *
   * <p>Since: 0.1.
   */
  static native long boundsManyF32(int shapesKind, long shapesCount, long shapesStride, long shapesStep,
      Object shapesBase, Object out);

  /**
   * How many bytes suffice for an index of `count` shapes, of any kinds?
   *
   * <p>Returns: 17 bytes a shape and 64 KiB. A built index takes fewer, mostly 13 a shape: see vesica_index_bytes.
   *
   * <p>Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
   *
   * <p>Since: 0.1.
   */
  static native long indexSize(long count);

  /**
   * How many bytes of scratch does building an index of `count` shapes need?
   *
   * <p>Returns: about 17 bytes a shape and 0.3 MiB.
   *
   * <p>Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
   *
   * <p>Since: 0.1.
   */
  static native long indexScratch(long count);

  /**
   * How many bytes of scratch does a join need, whatever its indexes?
   *
   * <p>Returns: at most 1 MiB.
   *
   * <p>Since: 0.1.
   */
  static native long joinScratch();

  /**
   * Are these bytes an index that is safe to read?
   *
   * <p>Call it once for bytes that you did not just build: they may be cut off, damaged, something else, or from a
   * machine of the other byte order. What passes is safe to read; damage of single shapes' places may pass and change
   * answers.
   *
   * <p>Requires: size, the number of readable bytes. The index may be shorter.
   *
   * <p>Returns: 0 if they are.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (they are not).
   *
   * <p>Cost: it reads all bytes once.
   *
   * <p>Since: 0.1.
   */
  static native int indexCheck(Object index, long size);

  /**
   * How many bytes does a built index take? Save that many.
   *
   * <p>Returns: the bytes, a multiple of 64.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (not an index's header).
   *
   * <p>Since: 0.1.
   */
  static native long indexBytes(Object index);

  /**
   * How many shapes was an index built from?
   *
   * <p>Returns: the number of its items, including invalid shapes.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (not an index's header).
   *
   * <p>Since: 0.1.
   */
  static native long indexCount(Object index);

  /**
   * A box around all valid shapes of an index.
   *
   * <p>Two indexes whose boxes are disjoint have no overlapping pairs.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (not an index's header).
   *
   * <p>Accuracy: the box is a little larger than the smallest one; a side that overflows is infinite. Without valid
   * shapes min is infinity and max is -infinity.
   *
   * <p>Since: 0.1.
   */
  static native int indexBounds(Object index, Object out);

  /**
   * The items of an index in spatial order: shapes near each other have nearby places in it.
   *
   * <p>A join is faster if the arrays of shapes have this order, as it then reads nearby memory.
   *
   * <p>Requires: out has room for `capacity` items. It may be NULL if that is 0.
   *
   * <p>Returns: how many items there are, without the invalid shapes. The first `capacity` of them are written.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned, capacity &lt; 0), VESICA_E_INDEX.
   *
   * <p>Cost: a few ns an item.
   *
   * <p>Since: 0.1.
   */
  static native long indexOrder(Object index, Object out, long capacity);

  /**
   * Builds the index of some sets of shapes. There may be none; sets may then be NULL.
   *
   * <p>If shapes are invalid, the call returns VESICA_E_SHAPE, and the index is complete without them. When shapes have
   * moved, build it again.
   *
   * <p>Requires: index_size &gt;= vesica_index_size(items) and scratch_size &gt;= vesica_index_scratch(items). The
   * scratch may be reused after the call.
   *
   * <p>Returns: how many bytes of the index are used.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a wrong count, size or alignment), VESICA_E_SHAPE.
   *
   * <p>Cost: 30 to 50 ns a shape.
   *
   * <p>Since: 0.1.
   */
  static native long indexBuildF64(int[] setsKinds, long[] setsCounts, long[] setsStrides, long[] setsSteps,
      Object[] setsBases, Object index, long indexSize, Object scratch, long scratchSize);

  /**
   * Which items of an index does one shape overlap? They come in the index's order.
   *
   * <p>To ask for many shapes, index them too and call vesica_join_f64.
   *
   * <p>Requires: sets are those of the index; or NULL, with set_count 0, to find the items whose bounds meet the
   * shape's. Bounds are those in the index, up to about 2^-15 of the extent of nearby shapes larger than
   * vesica_bounds_f64's. one, an array of count 1. out has room for `capacity` items. With capacity 0, out and state
   * may be NULL.
   *
   * <p>Returns: the number of items written; with capacity 0, how many there are.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
   * number or a size is out of range, a pointer is not aligned, the sets have another number of items than the index,
   * the state is from another function, part, parts or query). Other sets, and states of calls with other shapes or
   * distances, are not noticed: answers are then meaningless.
   *
   * <p>Accuracy: exact, if there are sets.
   *
   * <p>Cost: about 0.5 us for a few shapes that are found, 2 us for 1,000 boxes.
   *
   * <p>Since: 0.1.
   */
  static native long indexSelectF64(Object index, int[] setsKinds, long[] setsCounts, long[] setsStrides,
      long[] setsSteps, Object[] setsBases, int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      Object out, long capacity, Object state);

  /**
   * Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
   *
   * <p>If both indexes are the same pointer, pairs are those of two different items a &lt; b: VESICA_JOIN_CONTAINS then
   * finds those of which the lower item contains the higher one, _INSIDE the others. Pair i is out_a[i] and out_b[i].
   * The order of pairs depends on the bytes of the indexes and the query alone. The work may be divided into `parts` of
   * about equal work, which may run at the same time, each with its own scratch. The pairs of all parts, one part after
   * the other, are those of a call with part 0 and parts 1.
   *
   * <p>Requires: query is VESICA_JOIN_OVERLAP ... VESICA_JOIN_INSIDE. sets_a and sets_b are those of the indexes; with
   * VESICA_JOIN_BOUNDS they are ignored. 0 &lt;= part &lt; parts. scratch_size &gt;= vesica_join_scratch(); nothing is
   * kept in the scratch between calls. out_a and out_b have room for `capacity` items. With capacity 0, they and state
   * may be NULL.
   *
   * <p>Returns: the number of pairs written; with capacity 0, how many the whole part has.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_ARGUMENT (an unknown query, a number or a size
   * out of range, a pointer that is not aligned, sets of another number of items, a state from another function).
   *
   * <p>Accuracy: exact for all queries but VESICA_JOIN_BOUNDS.
   *
   * <p>Cost: 10 to 15 ns a shape to find candidates, and 15 to 25 ns a candidate to decide.
   *
   * <p>Since: 0.1.
   */
  static native long joinF64(int query, Object indexA, int[] setsAKinds, long[] setsACounts, long[] setsAStrides,
      long[] setsASteps, Object[] setsABases, Object indexB, int[] setsBKinds, long[] setsBCounts, long[] setsBStrides,
      long[] setsBSteps, Object[] setsBBases, long part, long parts, Object scratch, long scratchSize, Object outA,
      Object outB, long capacity, Object state);

  /**
   * All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those for
   * which vesica_within_f64 is &gt; 0.
   *
   * <p>If both indexes are the same pointer, pairs are those of two different items a &lt; b. They come in index_a's
   * order. Each part takes about the same number of items of index_a; all else is as for vesica_join_f64.
   *
   * <p>Requires: distance &gt;= 0, or infinity for all pairs of valid shapes; sets, part, outputs, capacity and state
   * as vesica_join_f64.
   *
   * <p>Returns: the number of pairs written; with capacity 0, how many the whole part has.
   *
   * <p>Errors: those of vesica_join_f64; VESICA_E_ARGUMENT also for a distance that is negative or NaN.
   *
   * <p>Accuracy: that of vesica_within_f64; pairs that are VESICA_WITHIN_NEARLY are included.
   *
   * <p>Cost: about 1 us a shape of index_a, and that of vesica_within_f64 a candidate: seven times that of
   * vesica_join_f64.
   *
   * <p>Since: 0.1.
   */
  static native long joinWithinF64(Object indexA, int[] setsAKinds, long[] setsACounts, long[] setsAStrides,
      long[] setsASteps, Object[] setsABases, Object indexB, int[] setsBKinds, long[] setsBCounts, long[] setsBStrides,
      long[] setsBSteps, Object[] setsBBases, double distance, long part, long parts, Object outA, Object outB,
      long capacity, Object state);

  /**
   * Which items of an index are nearest to one shape? The nearest comes first, of equally near ones the lower item.
   *
   * <p>An item that overlaps the shape has distance 0. An item whose distance overflows is not found.
   *
   * <p>Requires: sets are those of the index. one, an array of count 1. k &gt;= 0, and out and distance have room for k
   * each. With k = 0 they may be NULL. within, the largest distance to look for, &gt;= 0 or infinity.
   *
   * <p>Returns: how many items were found and written; with k = 0, how many there are within the distance.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
   * number or a size is out of range, a pointer is not aligned, the sets have another number of items than the index,
   * the state is from another function, part, parts or query). Other sets, and states of calls with other shapes or
   * distances, are not noticed: answers are then meaningless.
   *
   * <p>Accuracy: distances are those of vesica_nearest_f64, bit for bit.
   *
   * <p>Cost: 3 to 5 us for 10 of a million AABBs near a point; mostly that of vesica_nearest_f64 for some 10 more than
   * k. Of items that overlap the shape all are asked, as the lowest come first.
   *
   * <p>Since: 0.1.
   */
  static native long indexNearestF64(Object index, int[] setsKinds, long[] setsCounts, long[] setsStrides,
      long[] setsSteps, Object[] setsBases, int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      long k, double within, Object out, Object distance);

  /**
   * Which items of index_b are nearest to each item of sets_a? Row i is out[i * k] ... out[i * k + k - 1].
   *
   * <p>A row is the result of vesica_index_nearest_f64 for item i. If it has fewer than k items, the rest are -1 with
   * distance infinity. If a set is asked for its own neighbours, each item finds itself too, at distance 0, unless k
   * lower items overlap it. If an item of sets_a is invalid, its row holds -1, all other rows are right, and the call
   * returns VESICA_E_SHAPE. Each part takes about the same number of items, and writes only their rows.
   *
   * <p>Requires: sets_b are those of index_b. k &gt;= 1, and out and distance have room for k items a row. If sets_a
   * have no items, they may be NULL. 0 &lt;= part &lt; parts. within, the largest distance to look for, &gt;= 0 or
   * infinity.
   *
   * <p>Returns: how many items were found in all rows of the part.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
   * number or a size is out of range, a pointer is not aligned, the sets have another number of items than the index,
   * the state is from another function, part, parts or query). Other sets, and states of calls with other shapes or
   * distances, are not noticed: answers are then meaningless.
   *
   * <p>Accuracy: distances are those of vesica_nearest_f64, bit for bit.
   *
   * <p>Cost: that of vesica_index_nearest_f64 for each item.
   *
   * <p>Since: 0.1.
   */
  static native long joinNearestF64(int[] setsAKinds, long[] setsACounts, long[] setsAStrides, long[] setsASteps,
      Object[] setsABases, Object indexB, int[] setsBKinds, long[] setsBCounts, long[] setsBStrides, long[] setsBSteps,
      Object[] setsBBases, long k, double within, long part, long parts, Object out, Object distance);

  /**
   * Builds the index of some sets of shapes. There may be none; sets may then be NULL.
   *
   * <p>If shapes are invalid, the call returns VESICA_E_SHAPE, and the index is complete without them. When shapes have
   * moved, build it again.
   *
   * <p>Requires: index_size &gt;= vesica_index_size(items) and scratch_size &gt;= vesica_index_scratch(items). The
   * scratch may be reused after the call.
   *
   * <p>Returns: how many bytes of the index are used.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a wrong count, size or alignment), VESICA_E_SHAPE.
   *
   * <p>Cost: 30 to 50 ns a shape.
   *
   * <p>Since: 0.1.
   */
  static native long indexBuildF32(int[] setsKinds, long[] setsCounts, long[] setsStrides, long[] setsSteps,
      Object[] setsBases, Object index, long indexSize, Object scratch, long scratchSize);

  /**
   * Which items of an index does one shape overlap? They come in the index's order.
   *
   * <p>To ask for many shapes, index them too and call vesica_join_f32.
   *
   * <p>Requires: sets are those of the index; or NULL, with set_count 0, to find the items whose bounds meet the
   * shape's. Bounds are those in the index, up to about 2^-15 of the extent of nearby shapes larger than
   * vesica_bounds_f32's. one, an array of count 1. out has room for `capacity` items. With capacity 0, out and state
   * may be NULL.
   *
   * <p>Returns: the number of items written; with capacity 0, how many there are.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
   * number or a size is out of range, a pointer is not aligned, the sets have another number of items than the index,
   * the state is from another function, part, parts or query). Other sets, and states of calls with other shapes or
   * distances, are not noticed: answers are then meaningless.
   *
   * <p>Accuracy: exact, if there are sets.
   *
   * <p>Cost: about 0.5 us for a few shapes that are found, 2 us for 1,000 boxes.
   *
   * <p>Since: 0.1.
   */
  static native long indexSelectF32(Object index, int[] setsKinds, long[] setsCounts, long[] setsStrides,
      long[] setsSteps, Object[] setsBases, int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      Object out, long capacity, Object state);

  /**
   * Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
   *
   * <p>If both indexes are the same pointer, pairs are those of two different items a &lt; b: VESICA_JOIN_CONTAINS then
   * finds those of which the lower item contains the higher one, _INSIDE the others. Pair i is out_a[i] and out_b[i].
   * The order of pairs depends on the bytes of the indexes and the query alone. The work may be divided into `parts` of
   * about equal work, which may run at the same time, each with its own scratch. The pairs of all parts, one part after
   * the other, are those of a call with part 0 and parts 1.
   *
   * <p>Requires: query is VESICA_JOIN_OVERLAP ... VESICA_JOIN_INSIDE. sets_a and sets_b are those of the indexes; with
   * VESICA_JOIN_BOUNDS they are ignored. 0 &lt;= part &lt; parts. scratch_size &gt;= vesica_join_scratch(); nothing is
   * kept in the scratch between calls. out_a and out_b have room for `capacity` items. With capacity 0, they and state
   * may be NULL.
   *
   * <p>Returns: the number of pairs written; with capacity 0, how many the whole part has.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_ARGUMENT (an unknown query, a number or a size
   * out of range, a pointer that is not aligned, sets of another number of items, a state from another function).
   *
   * <p>Accuracy: exact for all queries but VESICA_JOIN_BOUNDS.
   *
   * <p>Cost: 10 to 15 ns a shape to find candidates, and 15 to 25 ns a candidate to decide.
   *
   * <p>Since: 0.1.
   */
  static native long joinF32(int query, Object indexA, int[] setsAKinds, long[] setsACounts, long[] setsAStrides,
      long[] setsASteps, Object[] setsABases, Object indexB, int[] setsBKinds, long[] setsBCounts, long[] setsBStrides,
      long[] setsBSteps, Object[] setsBBases, long part, long parts, Object scratch, long scratchSize, Object outA,
      Object outB, long capacity, Object state);

  /**
   * All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those for
   * which vesica_within_f32 is &gt; 0.
   *
   * <p>If both indexes are the same pointer, pairs are those of two different items a &lt; b. They come in index_a's
   * order. Each part takes about the same number of items of index_a; all else is as for vesica_join_f32.
   *
   * <p>Requires: distance &gt;= 0, or infinity for all pairs of valid shapes; sets, part, outputs, capacity and state
   * as vesica_join_f32.
   *
   * <p>Returns: the number of pairs written; with capacity 0, how many the whole part has.
   *
   * <p>Errors: those of vesica_join_f32; VESICA_E_ARGUMENT also for a distance that is negative or NaN.
   *
   * <p>Accuracy: that of vesica_within_f32; pairs that are VESICA_WITHIN_NEARLY are included.
   *
   * <p>Cost: about 1 us a shape of index_a, and that of vesica_within_f32 a candidate: seven times that of
   * vesica_join_f32.
   *
   * <p>Since: 0.1.
   */
  static native long joinWithinF32(Object indexA, int[] setsAKinds, long[] setsACounts, long[] setsAStrides,
      long[] setsASteps, Object[] setsABases, Object indexB, int[] setsBKinds, long[] setsBCounts, long[] setsBStrides,
      long[] setsBSteps, Object[] setsBBases, float distance, long part, long parts, Object outA, Object outB,
      long capacity, Object state);

  /**
   * Which items of an index are nearest to one shape? The nearest comes first, of equally near ones the lower item.
   *
   * <p>An item that overlaps the shape has distance 0. An item whose distance overflows is not found.
   *
   * <p>Requires: sets are those of the index. one, an array of count 1. k &gt;= 0, and out and distance have room for k
   * each. With k = 0 they may be NULL. within, the largest distance to look for, &gt;= 0 or infinity.
   *
   * <p>Returns: how many items were found and written; with k = 0, how many there are within the distance.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
   * number or a size is out of range, a pointer is not aligned, the sets have another number of items than the index,
   * the state is from another function, part, parts or query). Other sets, and states of calls with other shapes or
   * distances, are not noticed: answers are then meaningless.
   *
   * <p>Accuracy: distances are those of vesica_nearest_f32, bit for bit.
   *
   * <p>Cost: 3 to 5 us for 10 of a million AABBs near a point; mostly that of vesica_nearest_f32 for some 10 more than
   * k. Of items that overlap the shape all are asked, as the lowest come first.
   *
   * <p>Since: 0.1.
   */
  static native long indexNearestF32(Object index, int[] setsKinds, long[] setsCounts, long[] setsStrides,
      long[] setsSteps, Object[] setsBases, int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      long k, float within, Object out, Object distance);

  /**
   * Which items of index_b are nearest to each item of sets_a? Row i is out[i * k] ... out[i * k + k - 1].
   *
   * <p>A row is the result of vesica_index_nearest_f32 for item i. If it has fewer than k items, the rest are -1 with
   * distance infinity. If a set is asked for its own neighbours, each item finds itself too, at distance 0, unless k
   * lower items overlap it. If an item of sets_a is invalid, its row holds -1, all other rows are right, and the call
   * returns VESICA_E_SHAPE. Each part takes about the same number of items, and writes only their rows.
   *
   * <p>Requires: sets_b are those of index_b. k &gt;= 1, and out and distance have room for k items a row. If sets_a
   * have no items, they may be NULL. 0 &lt;= part &lt; parts. within, the largest distance to look for, &gt;= 0 or
   * infinity.
   *
   * <p>Returns: how many items were found in all rows of the part.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
   * number or a size is out of range, a pointer is not aligned, the sets have another number of items than the index,
   * the state is from another function, part, parts or query). Other sets, and states of calls with other shapes or
   * distances, are not noticed: answers are then meaningless.
   *
   * <p>Accuracy: distances are those of vesica_nearest_f32, bit for bit.
   *
   * <p>Cost: that of vesica_index_nearest_f32 for each item.
   *
   * <p>Since: 0.1.
   */
  static native long joinNearestF32(int[] setsAKinds, long[] setsACounts, long[] setsAStrides, long[] setsASteps,
      Object[] setsABases, Object indexB, int[] setsBKinds, long[] setsBCounts, long[] setsBStrides, long[] setsBSteps,
      Object[] setsBBases, long k, float within, long part, long parts, Object out, Object distance);

  /**
   * A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
   *
   * <p>The first four ratios are from 0 to 1. Shared area over one shape's is 0 if no area is shared, and 1 if the
   * other shape contains it. The last three are at most the IoU, and at least -1 (CIoU: -2). The angle of a shape in
   * CIoU is that of the vector (half length across its axis, half length along it); v is 0 if a shape has no size.
   * Exchanging the shapes exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the others.
   *
   * <p>Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (ratio is no such constant; the area to
   * divide by is 0; or, for GIoU, DIoU and CIoU, neither shape has an area).
   *
   * <p>Accuracy: computed from the result of vesica_area_f64 or vesica_iou_f64 with at most 8 u of further error, for
   * half lengths from 2^-200 to 2^200. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of
   * two shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale"
   * means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: that of vesica_area_f64 or vesica_iou_f64, and 100 to 150 ns more; in arrays 40 to 100 ns more.
   *
   * <p>Since: 0.1.
   */
  static native int ratioF64(int ratio, int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f64.
   *
   * <p>Arrays and errors are those of vesica_iou_many_f64. If a pair has no ratio because an area is 0, out[i] is NaN,
   * and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
   *
   * <p>Returns: how many are &gt; 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.
   *
   * <p>Accuracy: every result has the same bits as vesica_ratio_f64, on every instruction set and in every layout.
   *
   * <p>Cost: that of vesica_iou_many_f64, and 40 to 100 ns a pair.
   *
   * <p>Since: 0.1.
   */
  static native long ratioManyF64(int ratio, int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out);

  /**
   * A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f64.
   *
   * <p>Arrays, row_stride and errors are those of vesica_iou_matrix_f64. If a pair has no ratio because an area is 0,
   * it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
   *
   * <p>Returns: how many are &gt; 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.
   *
   * <p>Accuracy: every result has the same bits as vesica_ratio_f64, on every instruction set and in every layout.
   *
   * <p>Cost: that of vesica_iou_many_f64, and 40 to 100 ns a pair.
   *
   * <p>Since: 0.1.
   */
  static native long ratioMatrixF64(int ratio, int aKind, long aCount, long aStride, long aStep, Object aBase,
      int bKind, long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * How far apart are a[i] and b[j]? The elements of out are distances of vesica_nearest_f64.
   *
   * <p>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f64.
   *
   * <p>Returns: how many pairs overlap (distance 0).
   *
   * <p>Errors: as vesica_iou_matrix_f64.
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Since: 0.1.
   */
  static native long nearestMatrixF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * How far apart are the outlines of a[i] and b[j]? The elements of out are distances of vesica_boundary_distance_f64.
   *
   * <p>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f64.
   *
   * <p>Returns: how many pairs of outlines meet (distance 0).
   *
   * <p>Errors: as vesica_iou_matrix_f64.
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Since: 0.1.
   */
  static native long boundaryDistanceMatrixF64(int aKind, long aCount, long aStride, long aStep, Object aBase,
      int bKind, long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * How deep do a[i] and b[j] overlap? The elements of out are depths of vesica_depth_f64.
   *
   * <p>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f64.
   *
   * <p>Returns: how many depths are &gt; 0.
   *
   * <p>Errors: as vesica_iou_matrix_f64.
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout.
   *
   * <p>Since: 0.1.
   */
  static native long depthMatrixF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
   *
   * <p>It is the distance of vesica_nearest_f64 if they are disjoint, else minus the depth of vesica_depth_f64: 0 if
   * they only touch. Exchanging the shapes changes no bit.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the same bits as vesica_nearest_f64 or, negated, vesica_depth_f64. The sign is exact.
   *
   * <p>Cost: that of vesica_nearest_f64 or vesica_depth_f64.
   *
   * <p>Since: 0.1.
   */
  static native int signedDistanceF64(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * Signed distances of a[i] and b[i]. Arrays and errors are those of vesica_iou_many_f64.
   *
   * <p>Returns: how many pairs overlap (signed distance &lt;= 0).
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the same bits as vesica_nearest_f64 or, negated, vesica_depth_f64. The sign is exact.
   *
   * <p>Since: 0.1.
   */
  static native long signedDistanceManyF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out);

  /**
   * Signed distances of a[i] and b[j]. Arrays, row_stride and errors are those of vesica_iou_matrix_f64.
   *
   * <p>Returns: how many pairs overlap (signed distance &lt;= 0).
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the same bits as vesica_nearest_f64 or, negated, vesica_depth_f64. The sign is exact.
   *
   * <p>Since: 0.1.
   */
  static native long signedDistanceMatrixF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * Are two shapes at most `distance` apart? A distance of exactly that counts, as touching does.
   *
   * <p>With distance 0 the answer is that of vesica_overlap_f64, exact for all kinds. Test for &gt; 0 to miss no
   * pair, and for VESICA_WITHIN_YES to accept only what is certain. Exchanging the shapes changes nothing.
   *
   * <p>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid shapes.
   *
   * <p>Returns: VESICA_WITHIN_NO, VESICA_WITHIN_YES or VESICA_WITHIN_NEARLY.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN), VESICA_E_SHAPE.
   *
   * <p>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0, get no
   * other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of vesica_nearest_f64
   * differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53, half a unit in the last
   * place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
   * lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter
   * size.
   *
   * <p>Cost: 10 to 60 ns; that of vesica_nearest_f64 for ellipses; 1 to 10 us where only exact arithmetic can decide,
   * as when the distance is met exactly. At worst 25 us.
   *
   * <p>Since: 0.1.
   */
  static native int withinF64(int kindA, Object numbersA, int kindB, Object numbersB, double distance);

  /**
   * Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f64.
   *
   * <p>Arrays and errors are those of vesica_overlap_many_f64.
   *
   * <p>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid shapes.
   *
   * <p>Returns: how many answers are &gt; 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN), VESICA_E_SHAPE.
   *
   * <p>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0, get no
   * other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of vesica_nearest_f64
   * differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53, half a unit in the last
   * place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
   * lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter
   * size.
   *
   * <p>Since: 0.1.
   */
  static native long withinManyF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, double distance, Object out);

  /**
   * Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f64.
   *
   * <p>Arrays, row_stride and errors are those of vesica_overlap_matrix_f64.
   *
   * <p>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid shapes.
   *
   * <p>Returns: how many answers are &gt; 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN), VESICA_E_SHAPE.
   *
   * <p>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0, get no
   * other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of vesica_nearest_f64
   * differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53, half a unit in the last
   * place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
   * lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter
   * size.
   *
   * <p>Since: 0.1.
   */
  static native long withinMatrixF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, double distance, Object out, long rowStride);

  /**
   * Greedy non-maximum suppression as vesica_nms_f64, by any ratio, each label on its own.
   *
   * <p>Takes shapes in the order of their scores, highest first. Keeps each one whose ratio with every shape kept
   * before, of the same label, is at most the threshold. Shapes whose score is below least_score are left out.
   *
   * <p>Requires: shapes, scores, threshold and scratch as vesica_nms_f64; labels, one for each shape, or NULL if all
   * are the same; ratio, any but VESICA_RATIO_OVER_FIRST and _OVER_SECOND; least_score, which may be -infinity; most,
   * the largest number to keep; keep, with room for that number or for all shapes, whichever is less.
   *
   * <p>Returns: 0, and keep and *kept as vesica_nms_f64.
   *
   * <p>Errors: as vesica_nms_f64; VESICA_E_ARGUMENT also for ratio, a least_score that is NaN, and a negative most.
   *
   * <p>Cost: that of vesica_nms_f64; ratios other than IoU take 0.1 us more a comparison.
   *
   * <p>Since: 0.1.
   */
  static native int suppressF64(int shapesKind, long shapesCount, long shapesStride, long shapesStep, Object shapesBase,
      Object scores, Object labels, int ratio, double threshold, double leastScore, long most, Object scratch,
      long scratchSize, Object keep, Object kept);

  /**
   * How many bytes of scratch does soft suppression of `count` shapes need?
   *
   * <p>Returns: 64 bytes a shape.
   *
   * <p>Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
   *
   * <p>Since: 0.1.
   */
  static native long suppressSoftScratch(long count);

  /**
   * Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
   *
   * <p>Repeats these steps: take the shape with the highest score, of equal ones the first; keep it; lower the score of
   * each shape not yet kept, of the same label, by `decay` of their ratio. Ends when `most` are kept or every score
   * left is below least_score. keep[k] is the shape kept in step k, and decayed[k] the score that it had then.
   *
   * <p>Requires: shapes, scores and labels as vesica_suppress_f64; ratio, any but VESICA_RATIO_OVER_FIRST and
   * _OVER_SECOND; decay, VESICA_DECAY_LINEAR or _GAUSSIAN, with its parameter; least_score &gt;= 0; scratch of at least
   * vesica_suppress_soft_scratch(count) bytes, aligned to 8; keep and decayed with room for `most` numbers or for all
   * shapes, whichever is less.
   *
   * <p>Returns: 0, with *kept set to how many are kept.
   *
   * <p>Errors: as vesica_suppress_f64. VESICA_E_SHAPE: an invalid shape, or one whose score is NaN, is left out, and
   * the result of the others is written.
   *
   * <p>Accuracy: in every step a score is multiplied once, in double, by 1 - r, rounded once, or by the exponential,
   * right to 1 unit in the last place; times 0 an infinite score is 0. So the same shapes are kept, with the same bits,
   * on every machine. The float function computes in double and rounds only the final scores.
   *
   * <p>Cost: for each kept shape, that of vesica_ratio_matrix_f64 with the shapes of its label that are left.
   *
   * <p>Since: 0.1.
   */
  static native int suppressSoftF64(int shapesKind, long shapesCount, long shapesStride, long shapesStep,
      Object shapesBase, Object scores, Object labels, int ratio, int decay, double parameter, double leastScore,
      long most, Object scratch, long scratchSize, Object keep, Object decayed, Object kept);

  /**
   * A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
   *
   * <p>The first four ratios are from 0 to 1. Shared area over one shape's is 0 if no area is shared, and 1 if the
   * other shape contains it. The last three are at most the IoU, and at least -1 (CIoU: -2). The angle of a shape in
   * CIoU is that of the vector (half length across its axis, half length along it); v is 0 if a shape has no size.
   * Exchanging the shapes exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the others.
   *
   * <p>Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (ratio is no such constant; the area to
   * divide by is 0; or, for GIoU, DIoU and CIoU, neither shape has an area).
   *
   * <p>Accuracy: computed from the result of vesica_area_f32 or vesica_iou_f32 with at most 8 u of further error, for
   * half lengths from 2^-200 to 2^200. Each number is computed in double, within these bounds, and then rounded to
   * float once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the
   * largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of at
   * most 4 u times the scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: that of vesica_area_f32 or vesica_iou_f32, and 100 to 150 ns more; in arrays 40 to 100 ns more.
   *
   * <p>Since: 0.1.
   */
  static native int ratioF32(int ratio, int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f32.
   *
   * <p>Arrays and errors are those of vesica_iou_many_f32. If a pair has no ratio because an area is 0, out[i] is NaN,
   * and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
   *
   * <p>Returns: how many are &gt; 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.
   *
   * <p>Accuracy: every result has the same bits as vesica_ratio_f32, on every instruction set and in every layout.
   * Each number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Cost: that of vesica_iou_many_f32, and 40 to 100 ns a pair.
   *
   * <p>Since: 0.1.
   */
  static native long ratioManyF32(int ratio, int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out);

  /**
   * A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f32.
   *
   * <p>Arrays, row_stride and errors are those of vesica_iou_matrix_f32. If a pair has no ratio because an area is 0,
   * it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
   *
   * <p>Returns: how many are &gt; 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.
   *
   * <p>Accuracy: every result has the same bits as vesica_ratio_f32, on every instruction set and in every layout.
   * Each number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Cost: that of vesica_iou_many_f32, and 40 to 100 ns a pair.
   *
   * <p>Since: 0.1.
   */
  static native long ratioMatrixF32(int ratio, int aKind, long aCount, long aStride, long aStep, Object aBase,
      int bKind, long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * How far apart are a[i] and b[j]? The elements of out are distances of vesica_nearest_f32.
   *
   * <p>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f32.
   *
   * <p>Returns: how many pairs overlap (distance 0).
   *
   * <p>Errors: as vesica_iou_matrix_f32.
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout. Each number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Since: 0.1.
   */
  static native long nearestMatrixF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * How far apart are the outlines of a[i] and b[j]? The elements of out are distances of vesica_boundary_distance_f32.
   *
   * <p>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f32.
   *
   * <p>Returns: how many pairs of outlines meet (distance 0).
   *
   * <p>Errors: as vesica_iou_matrix_f32.
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout. Each number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Since: 0.1.
   */
  static native long boundaryDistanceMatrixF32(int aKind, long aCount, long aStride, long aStep, Object aBase,
      int bKind, long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * How deep do a[i] and b[j] overlap? The elements of out are depths of vesica_depth_f32.
   *
   * <p>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f32.
   *
   * <p>Returns: how many depths are &gt; 0.
   *
   * <p>Errors: as vesica_iou_matrix_f32.
   *
   * <p>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
   * layout. Each number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Since: 0.1.
   */
  static native long depthMatrixF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * Greedy non-maximum suppression as vesica_nms_f32, by any ratio, each label on its own.
   *
   * <p>Takes shapes in the order of their scores, highest first. Keeps each one whose ratio with every shape kept
   * before, of the same label, is at most the threshold. Shapes whose score is below least_score are left out.
   *
   * <p>Requires: shapes, scores, threshold and scratch as vesica_nms_f32; labels, one for each shape, or NULL if all
   * are the same; ratio, any but VESICA_RATIO_OVER_FIRST and _OVER_SECOND; least_score, which may be -infinity; most,
   * the largest number to keep; keep, with room for that number or for all shapes, whichever is less.
   *
   * <p>Returns: 0, and keep and *kept as vesica_nms_f32.
   *
   * <p>Errors: as vesica_nms_f32; VESICA_E_ARGUMENT also for ratio, a least_score that is NaN, and a negative most.
   *
   * <p>Cost: that of vesica_nms_f32; ratios other than IoU take 0.1 us more a comparison.
   *
   * <p>Since: 0.1.
   */
  static native int suppressF32(int shapesKind, long shapesCount, long shapesStride, long shapesStep, Object shapesBase,
      Object scores, Object labels, int ratio, float threshold, float leastScore, long most, Object scratch,
      long scratchSize, Object keep, Object kept);

  /**
   * Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
   *
   * <p>It is the distance of vesica_nearest_f32 if they are disjoint, else minus the depth of vesica_depth_f32: 0 if
   * they only touch. Exchanging the shapes changes no bit.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the same bits as vesica_nearest_f32 or, negated, vesica_depth_f32. The sign is exact.
   * Each number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Cost: that of vesica_nearest_f32 or vesica_depth_f32.
   *
   * <p>Since: 0.1.
   */
  static native int signedDistanceF32(int kindA, Object numbersA, int kindB, Object numbersB, Object out);

  /**
   * Signed distances of a[i] and b[i]. Arrays and errors are those of vesica_iou_many_f32.
   *
   * <p>Returns: how many pairs overlap (signed distance &lt;= 0).
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the same bits as vesica_nearest_f32 or, negated, vesica_depth_f32. The sign is exact.
   * Each number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Since: 0.1.
   */
  static native long signedDistanceManyF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out);

  /**
   * Signed distances of a[i] and b[j]. Arrays, row_stride and errors are those of vesica_iou_matrix_f32.
   *
   * <p>Returns: how many pairs overlap (signed distance &lt;= 0).
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
   *
   * <p>Accuracy: the same bits as vesica_nearest_f32 or, negated, vesica_depth_f32. The sign is exact.
   * Each number is computed in double, within these bounds, and then rounded to float once.
   *
   * <p>Since: 0.1.
   */
  static native long signedDistanceMatrixF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, Object out, long rowStride);

  /**
   * Are two shapes at most `distance` apart? A distance of exactly that counts, as touching does.
   *
   * <p>With distance 0 the answer is that of vesica_overlap_f32, exact for all kinds. Test for &gt; 0 to miss no
   * pair, and for VESICA_WITHIN_YES to accept only what is certain. Exchanging the shapes changes nothing.
   *
   * <p>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid shapes.
   *
   * <p>Returns: VESICA_WITHIN_NO, VESICA_WITHIN_YES or VESICA_WITHIN_NEARLY.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN), VESICA_E_SHAPE.
   *
   * <p>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0, get no
   * other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of vesica_nearest_f32
   * differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53, half a unit in the last
   * place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
   * lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter
   * size.
   *
   * <p>Cost: 10 to 60 ns; that of vesica_nearest_f32 for ellipses; 1 to 10 us where only exact arithmetic can decide,
   * as when the distance is met exactly. At worst 25 us.
   *
   * <p>Since: 0.1.
   */
  static native int withinF32(int kindA, Object numbersA, int kindB, Object numbersB, float distance);

  /**
   * Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f32.
   *
   * <p>Arrays and errors are those of vesica_overlap_many_f32.
   *
   * <p>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid shapes.
   *
   * <p>Returns: how many answers are &gt; 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN), VESICA_E_SHAPE.
   *
   * <p>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0, get no
   * other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of vesica_nearest_f32
   * differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53, half a unit in the last
   * place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
   * lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter
   * size.
   *
   * <p>Since: 0.1.
   */
  static native long withinManyF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, float distance, Object out);

  /**
   * Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of vesica_within_f32.
   *
   * <p>Arrays, row_stride and errors are those of vesica_overlap_matrix_f32.
   *
   * <p>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid shapes.
   *
   * <p>Returns: how many answers are &gt; 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN), VESICA_E_SHAPE.
   *
   * <p>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0, get no
   * other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of vesica_nearest_f32
   * differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53, half a unit in the last
   * place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
   * lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter
   * size.
   *
   * <p>Since: 0.1.
   */
  static native long withinMatrixF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind,
      long bCount, long bStride, long bStep, Object bBase, float distance, Object out, long rowStride);

  /**
   * Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
   *
   * <p>Repeats these steps: take the shape with the highest score, of equal ones the first; keep it; lower the score of
   * each shape not yet kept, of the same label, by `decay` of their ratio. Ends when `most` are kept or every score
   * left is below least_score. keep[k] is the shape kept in step k, and decayed[k] the score that it had then.
   *
   * <p>Requires: shapes, scores and labels as vesica_suppress_f32; ratio, any but VESICA_RATIO_OVER_FIRST and
   * _OVER_SECOND; decay, VESICA_DECAY_LINEAR or _GAUSSIAN, with its parameter; least_score &gt;= 0; scratch of at least
   * vesica_suppress_soft_scratch(count) bytes, aligned to 8; keep and decayed with room for `most` numbers or for all
   * shapes, whichever is less.
   *
   * <p>Returns: 0, with *kept set to how many are kept.
   *
   * <p>Errors: as vesica_suppress_f32. VESICA_E_SHAPE: an invalid shape, or one whose score is NaN, is left out, and
   * the result of the others is written.
   *
   * <p>Accuracy: in every step a score is multiplied once, in double, by 1 - r, rounded once, or by the exponential,
   * right to 1 unit in the last place; times 0 an infinite score is 0. So the same shapes are kept, with the same bits,
   * on every machine. The float function computes in double and rounds only the final scores.
   *
   * <p>Cost: for each kept shape, that of vesica_ratio_matrix_f32 with the shapes of its label that are left.
   *
   * <p>Since: 0.1.
   */
  static native int suppressSoftF32(int shapesKind, long shapesCount, long shapesStride, long shapesStep,
      Object shapesBase, Object scores, Object labels, int ratio, int decay, float parameter, float leastScore,
      long most, Object scratch, long scratchSize, Object keep, Object decayed, Object kept);

  /**
   * Does b touch a while it moves, when first, and where?
   *
   * <p>The normal is that of the face or the round outline that is met; if a corner meets a corner, that of an edge
   * there; if b only slides along a, it is perpendicular to the velocity. For a face that is met at an angle below
   * 2^-80 it may be that of the face beside it, and the point their corner. If two faces meet, the point is the middle
   * of what they share. Shapes that overlap at the start have t = 0, the direction of vesica_depth_f64 and the point of
   * vesica_nearest_f64. Shapes that only touch at the start move apart or slide if (nx, ny).(vx, vy) &gt;= 0. Else they
   * may press together; where corners meet, or a shape has no area, they may also part. Exchanging the shapes and
   * reversing the velocity changes neither the answer nor the time; it reverses the normal, up to rounding.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a velocity that is not finite, a t_end that is negative
   * or NaN), VESICA_E_SHAPE, VESICA_E_RANGE (the time, or a coordinate of the point, would overflow; or an exact
   * position would take more than 2000 bits, as with magnitudes of both 2^1000 and 2^-1000).
   *
   * <p>Accuracy: the answer is exact, and the time is rounded down. The point is within 8 u scale of a's outline before
   * it is rounded; along the outline it may be off by (8 u scale + 4 u R) / |n.v|, n and v of unit length, R the
   * greatest radius of curvature of a: of an ellipse its long half length squared over the short one, far more than its
   * size if it is thin. The normal has length 1 to 4 u. In bounds on errors u is 2^-53, half a unit in the last place
   * of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths;
   * "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: 30 to 50 ns for a miss, 0.2 to 0.6 us for a hit; less for rays (b a point), two circles and two ellipses,
   * see the typed functions; 0.7 to 20 us for contact that only exact arithmetic can decide. At wildly unlike exponents
   * most take 10 to 30 us; at worst 0.3 ms.
   *
   * <p>Since: 0.1.
   */
  static native int castF64(int kindA, Object numbersA, int kindB, Object numbersB, double vx, double vy, double tEnd,
      Object out);

  /**
   * When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]? The columns are the fields of vesica_cast_f64's
   * result.
   *
   * <p>Velocity i is `i * stride` bytes after vx and vy; stride 0 repeats one velocity.
   *
   * <p>Requires: velocities and t_end as vesica_cast_f64; equal counts, or one count of 1, whose shape is used for all.
   * Each output has room for as many numbers as the larger count. Some, but not all, may be NULL. vx and vy need no
   * alignment; without pairs they may be NULL.
   *
   * <p>Returns: how many touch, including those that overlap at the start.
   *
   * <p>Errors: those of vesica_cast_f64. An element with an invalid shape, a velocity that is not finite or a result
   * out of range gets NaN for all its numbers, and all others are written as usual. The call then returns
   * VESICA_E_SHAPE if a shape is invalid, else the error of the last such element.
   *
   * <p>Accuracy: every result has the same bits as vesica_cast_f64.
   *
   * <p>Cost: that of vesica_cast_f64 for each pair; with AVX2 or AVX-512 a half to an eighth of it, except for pairs
   * that overlap at the start.
   *
   * <p>Since: 0.1.
   */
  static native long castManyF64(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind, long bCount,
      long bStride, long bStep, Object bBase, Object vx, Object vy, long stride, double tEnd, Object t, Object x,
      Object y, Object nx, Object ny);

  /**
   * Which of many shapes at rest does one moving shape touch first? If several are touched at that time, the one with
   * the lowest index.
   *
   * <p>Requires: one, the shape that moves, an array of count 1; vx, vy and t_end as vesica_cast_f64.
   *
   * <p>Returns: its index, or the count of `many` if none is touched. *out is its contact, the normal pointing to
   * `one`.
   *
   * <p>Errors: those of vesica_cast_f64. VESICA_E_SHAPE if any shape is invalid. VESICA_E_RANGE only if vesica_cast_f64
   * returns it for a shape that might be touched first.
   *
   * <p>Cost: 5 to 20 ns a shape that is missed.
   *
   * <p>Since: 0.1.
   */
  static native long castFirstF64(int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      int manyKind, long manyCount, long manyStride, long manyStep, Object manyBase, double vx, double vy, double tEnd,
      Object out);

  /**
   * A box that holds a shape throughout its motion, t from 0 to t_end. The shape touches nothing outside it.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: those of vesica_cast_f64; VESICA_E_RANGE if a side would overflow.
   *
   * <p>Accuracy: a side that does not move is that of vesica_bounds_f64. One that moves is too far out by at most four
   * units in the last place of the largest of three numbers: the side at rest, the way it moves, and where it ends.
   *
   * <p>Cost: 15 ns more than vesica_bounds_f64.
   *
   * <p>Since: 0.1.
   */
  static native int sweepBoundsF64(int kind, Object numbers, double vx, double vy, double tEnd, Object out);

  /**
   * Which items of an index does one moving shape touch? They come in the index's order.
   *
   * <p>Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f64. out has
   * room for `capacity` items. With capacity 0, out and state may be NULL.
   *
   * <p>Returns: the number of items written; with capacity 0, how many there are. If state[0] is not -1 then, there are
   * more, and the same call continues (vesica_index.h).
   *
   * <p>Errors: those of vesica_cast_f64, and VESICA_E_INDEX; VESICA_E_ARGUMENT also for sets of another number of items
   * than the index, a pointer that is not aligned, or a state from another function (vesica_index.h). VESICA_E_RANGE
   * only if it cannot be told whether an item is touched, as its exact position at t_end would take more than 2000
   * bits. Then nothing is written, the state is behind that item, and the same call continues; with capacity 0 there is
   * no count. Invalid items are never touched.
   *
   * <p>Accuracy: exact.
   *
   * <p>Cost: a few us, and about 150 ns for each item whose box the swept box meets, for a million circles in any
   * order. If only exact arithmetic can decide an item, that of vesica_cast_f64.
   *
   * <p>Since: 0.1.
   */
  static native long indexCastF64(Object index, int[] setsKinds, long[] setsCounts, long[] setsStrides,
      long[] setsSteps, Object[] setsBases, int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      double vx, double vy, double tEnd, Object out, long capacity, Object state);

  /**
   * Which item of an index does one moving shape touch first? If several are touched at that time, the lowest item.
   *
   * <p>Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f64.
   *
   * <p>Returns: the item, or the index's count if none is touched. *out is its contact, the normal pointing to `one`.
   *
   * <p>Errors: those of vesica_index_cast_f64; VESICA_E_RANGE only as for vesica_cast_first_f64.
   *
   * <p>Cost: about 2 us for a ray at a million shapes.
   *
   * <p>Since: 0.1.
   */
  static native long indexCastFirstF64(Object index, int[] setsKinds, long[] setsCounts, long[] setsStrides,
      long[] setsSteps, Object[] setsBases, int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      double vx, double vy, double tEnd, Object out);

  /**
   * When do two shapes that move and turn touch first? It is proved that there is no contact before t, however thin the
   * shapes are and however fast they turn.
   *
   * <p>At t, from 0 to 1, a centre has moved by t (vx, vy) and an axis has turned by t times the angle, without
   * rounding. *out describes that moment: the point of a that is nearest to b, and the normal that separates them. They
   * are then at most *gap apart.
   *
   * <p>Requires: numbers of turn_a and turn_b finite, angles at most 2^20 in magnitude; tolerance, a length &gt; 0. No
   * pointer may be NULL.
   *
   * <p>Returns: VESICA_CAST_MISS: it is proved that there is no contact from 0 to 1; t is infinity, and all other
   * numbers and the gap are NaN. VESICA_CAST_HIT: it is proved that there is contact after t. VESICA_CAST_NEAR: there
   * may be contact after t; contact of a point with a segment or a point, where there is no depth, is never proved.
   * VESICA_CAST_START: the shapes overlap at t = 0, which is exact; *out is that of vesica_cast_f64, and the gap is 0.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE (a coordinate of the
   * point, or the gap, would overflow).
   *
   * <p>Accuracy: what is said to be proved is certain. The gap is at most the tolerance, except in two cases: the
   * tolerance is below (300 + 10 |angles|) u times the sum of all lengths, the motion's included, u = 2^-53; or the
   * search stopped after 256 directions or 4096 poses.
   *
   * <p>Cost: 0.2 to 0.9 us for boxes, 0.4 to 3 us if one shape is round; 0.14 ms was seen at spins of 10^6 radians; at
   * worst 1.4 ms.
   *
   * <p>Since: 0.1.
   */
  static native int impactTimeF64(int kindA, Object numbersA, Object turnA, int kindB, Object numbersB, Object turnB,
      double tolerance, Object out, Object gap);

  /**
   * A ray at a point.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
   *
   * <p>Accuracy: that of vesica_cast_f64.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f64 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castPointPointF64(Object a, Object b, double vx, double vy, double tEnd, Object out);

  /**
   * A ray at a segment.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
   *
   * <p>Accuracy: that of vesica_cast_f64.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f64 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castSegmentPointF64(Object a, Object b, double vx, double vy, double tEnd, Object out);

  /**
   * A ray at a disc.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
   *
   * <p>Accuracy: that of vesica_cast_f64.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f64 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castCirclePointF64(Object a, Object b, double vx, double vy, double tEnd, Object out);

  /**
   * A ray at an axis-aligned box.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
   *
   * <p>Accuracy: that of vesica_cast_f64.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f64 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castAabbPointF64(Object a, Object b, double vx, double vy, double tEnd, Object out);

  /**
   * A ray at a rectangle.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
   *
   * <p>Accuracy: that of vesica_cast_f64.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f64 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castRectPointF64(Object a, Object b, double vx, double vy, double tEnd, Object out);

  /**
   * A ray at an ellipse.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
   *
   * <p>Accuracy: that of vesica_cast_f64.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f64 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castEllipsePointF64(Object a, Object b, double vx, double vy, double tEnd, Object out);

  /**
   * Two discs.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
   *
   * <p>Accuracy: that of vesica_cast_f64.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f64 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castCircleCircleF64(Object a, Object b, double vx, double vy, double tEnd, Object out);

  /**
   * Two rectangles.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
   *
   * <p>Accuracy: that of vesica_cast_f64.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f64 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castRectRectF64(Object a, Object b, double vx, double vy, double tEnd, Object out);

  /**
   * Does b touch a while it moves, when first, and where?
   *
   * <p>The normal is that of the face or the round outline that is met; if a corner meets a corner, that of an edge
   * there; if b only slides along a, it is perpendicular to the velocity. For a face that is met at an angle below
   * 2^-80 it may be that of the face beside it, and the point their corner. If two faces meet, the point is the middle
   * of what they share. Shapes that overlap at the start have t = 0, the direction of vesica_depth_f32 and the point of
   * vesica_nearest_f32. Shapes that only touch at the start move apart or slide if (nx, ny).(vx, vy) &gt;= 0. Else they
   * may press together; where corners meet, or a shape has no area, they may also part. Exchanging the shapes and
   * reversing the velocity changes neither the answer nor the time; it reverses the normal, up to rounding.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a velocity that is not finite, a t_end that is negative
   * or NaN), VESICA_E_SHAPE, VESICA_E_RANGE (the time, or a coordinate of the point, would overflow; or an exact
   * position would take more than 2000 bits, as with magnitudes of both 2^1000 and 2^-1000).
   *
   * <p>Accuracy: the answer is exact, and the time is rounded down. The point is within 8 u scale of a's outline before
   * it is rounded; along the outline it may be off by (8 u scale + 4 u R) / |n.v|, n and v of unit length, R the
   * greatest radius of curvature of a: of an ellipse its long half length squared over the short one, far more than its
   * size if it is thin. The normal has length 1 to 4 u. In bounds on errors u is 2^-53, half a unit in the last place
   * of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths;
   * "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: 30 to 50 ns for a miss, 0.2 to 0.6 us for a hit; less for rays (b a point), two circles and two ellipses,
   * see the typed functions; 0.7 to 20 us for contact that only exact arithmetic can decide. At wildly unlike exponents
   * most take 10 to 30 us; at worst 0.3 ms.
   *
   * <p>Since: 0.1.
   */
  static native int castF32(int kindA, Object numbersA, int kindB, Object numbersB, float vx, float vy, float tEnd,
      Object out);

  /**
   * When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]? The columns are the fields of vesica_cast_f32's
   * result.
   *
   * <p>Velocity i is `i * stride` bytes after vx and vy; stride 0 repeats one velocity.
   *
   * <p>Requires: velocities and t_end as vesica_cast_f32; equal counts, or one count of 1, whose shape is used for all.
   * Each output has room for as many numbers as the larger count. Some, but not all, may be NULL. vx and vy need no
   * alignment; without pairs they may be NULL.
   *
   * <p>Returns: how many touch, including those that overlap at the start.
   *
   * <p>Errors: those of vesica_cast_f32. An element with an invalid shape, a velocity that is not finite or a result
   * out of range gets NaN for all its numbers, and all others are written as usual. The call then returns
   * VESICA_E_SHAPE if a shape is invalid, else the error of the last such element.
   *
   * <p>Accuracy: every result has the same bits as vesica_cast_f32.
   *
   * <p>Cost: that of vesica_cast_f32 for each pair; with AVX2 or AVX-512 a half to an eighth of it, except for pairs
   * that overlap at the start.
   *
   * <p>Since: 0.1.
   */
  static native long castManyF32(int aKind, long aCount, long aStride, long aStep, Object aBase, int bKind, long bCount,
      long bStride, long bStep, Object bBase, Object vx, Object vy, long stride, float tEnd, Object t, Object x,
      Object y, Object nx, Object ny);

  /**
   * Which of many shapes at rest does one moving shape touch first? If several are touched at that time, the one with
   * the lowest index.
   *
   * <p>Requires: one, the shape that moves, an array of count 1; vx, vy and t_end as vesica_cast_f32.
   *
   * <p>Returns: its index, or the count of `many` if none is touched. *out is its contact, the normal pointing to
   * `one`.
   *
   * <p>Errors: those of vesica_cast_f32. VESICA_E_SHAPE if any shape is invalid. VESICA_E_RANGE only if vesica_cast_f32
   * returns it for a shape that might be touched first.
   *
   * <p>Cost: 5 to 20 ns a shape that is missed.
   *
   * <p>Since: 0.1.
   */
  static native long castFirstF32(int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      int manyKind, long manyCount, long manyStride, long manyStep, Object manyBase, float vx, float vy, float tEnd,
      Object out);

  /**
   * A box that holds a shape throughout its motion, t from 0 to t_end. The shape touches nothing outside it.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: 0.
   *
   * <p>Errors: those of vesica_cast_f32; VESICA_E_RANGE if a side would overflow.
   *
   * <p>Accuracy: a side that does not move is that of vesica_bounds_f32. One that moves is too far out by at most four
   * units in the last place of the largest of three numbers: the side at rest, the way it moves, and where it ends.
   *
   * <p>Cost: 15 ns more than vesica_bounds_f32.
   *
   * <p>Since: 0.1.
   */
  static native int sweepBoundsF32(int kind, Object numbers, float vx, float vy, float tEnd, Object out);

  /**
   * Which items of an index does one moving shape touch? They come in the index's order.
   *
   * <p>Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f32. out has
   * room for `capacity` items. With capacity 0, out and state may be NULL.
   *
   * <p>Returns: the number of items written; with capacity 0, how many there are. If state[0] is not -1 then, there are
   * more, and the same call continues (vesica_index.h).
   *
   * <p>Errors: those of vesica_cast_f32, and VESICA_E_INDEX; VESICA_E_ARGUMENT also for sets of another number of items
   * than the index, a pointer that is not aligned, or a state from another function (vesica_index.h). VESICA_E_RANGE
   * only if it cannot be told whether an item is touched, as its exact position at t_end would take more than 2000
   * bits. Then nothing is written, the state is behind that item, and the same call continues; with capacity 0 there is
   * no count. Invalid items are never touched.
   *
   * <p>Accuracy: exact.
   *
   * <p>Cost: a few us, and about 150 ns for each item whose box the swept box meets, for a million circles in any
   * order. If only exact arithmetic can decide an item, that of vesica_cast_f32.
   *
   * <p>Since: 0.1.
   */
  static native long indexCastF32(Object index, int[] setsKinds, long[] setsCounts, long[] setsStrides,
      long[] setsSteps, Object[] setsBases, int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      float vx, float vy, float tEnd, Object out, long capacity, Object state);

  /**
   * Which item of an index does one moving shape touch first? If several are touched at that time, the lowest item.
   *
   * <p>Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f32.
   *
   * <p>Returns: the item, or the index's count if none is touched. *out is its contact, the normal pointing to `one`.
   *
   * <p>Errors: those of vesica_index_cast_f32; VESICA_E_RANGE only as for vesica_cast_first_f32.
   *
   * <p>Cost: about 2 us for a ray at a million shapes.
   *
   * <p>Since: 0.1.
   */
  static native long indexCastFirstF32(Object index, int[] setsKinds, long[] setsCounts, long[] setsStrides,
      long[] setsSteps, Object[] setsBases, int oneKind, long oneCount, long oneStride, long oneStep, Object oneBase,
      float vx, float vy, float tEnd, Object out);

  /**
   * As vesica_impact_time_f64. The gap is that at the rounded time, and rounded up: it may exceed the tolerance by
   * 2^-24 of the way that the shapes move relative to each other.
   *
   * <p>Errors: those of the double functions.
   *
   * <p>Since: 0.1.
   */
  static native int impactTimeF32(int kindA, Object numbersA, Object turnA, int kindB, Object numbersB, Object turnB,
      float tolerance, Object out, Object gap);

  /**
   * A ray at a point.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
   *
   * <p>Accuracy: that of vesica_cast_f32.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f32 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castPointPointF32(Object a, Object b, float vx, float vy, float tEnd, Object out);

  /**
   * A ray at a segment.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
   *
   * <p>Accuracy: that of vesica_cast_f32.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f32 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castSegmentPointF32(Object a, Object b, float vx, float vy, float tEnd, Object out);

  /**
   * A ray at a disc.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
   *
   * <p>Accuracy: that of vesica_cast_f32.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f32 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castCirclePointF32(Object a, Object b, float vx, float vy, float tEnd, Object out);

  /**
   * A ray at an axis-aligned box.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
   *
   * <p>Accuracy: that of vesica_cast_f32.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f32 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castAabbPointF32(Object a, Object b, float vx, float vy, float tEnd, Object out);

  /**
   * A ray at a rectangle.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
   *
   * <p>Accuracy: that of vesica_cast_f32.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f32 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castRectPointF32(Object a, Object b, float vx, float vy, float tEnd, Object out);

  /**
   * A ray at an ellipse.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
   *
   * <p>Accuracy: that of vesica_cast_f32.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f32 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castEllipsePointF32(Object a, Object b, float vx, float vy, float tEnd, Object out);

  /**
   * Two discs.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
   *
   * <p>Accuracy: that of vesica_cast_f32.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f32 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castCircleCircleF32(Object a, Object b, float vx, float vy, float tEnd, Object out);

  /**
   * Two rectangles.
   *
   * <p>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.
   *
   * <p>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
   *
   * <p>Accuracy: that of vesica_cast_f32.
   *
   * <p>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us. Near-ties cost
   * what vesica_cast_f32 does for other kinds.
   *
   * <p>Since: 0.1.
   */
  static native int castRectRectF32(Object a, Object b, float vx, float vy, float tEnd, Object out);

  /**
   * The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
   *
   * <p>Every shape has an inside, an outline and an outside. The first three characters say what a's inside shares with
   * b's inside, outline and outside; the next three say it of a's outline, the last three of a's outside. F means
   * nothing, 0 single points, 1 lines, 2 an area. The outline of a shape with area is the curve around it, that of a
   * segment its two end points; a point has none. A segment without length is a point; a shape with one size 0 is a
   * segment, with both 0 a point. Two boxes side by side that share a side give "FF2F11212". Exchanging the shapes
   * exchanges rows and columns.
   *
   * <p>Requires: matrix with room for VESICA_DE9IM_SIZE characters.
   *
   * <p>Returns: 0, and nine characters and a final NUL in matrix.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Cost: that of vesica_relation_f64; 0.1 to 1 us more for a segment, 2 us for rectangles whose sides are parallel.
   * At worst 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int de9imF64(int kindA, Object numbersA, int kindB, Object numbersB, Object matrix);

  /**
   * Does a nine-intersection matrix match a pattern, such as "T*F**F***" for "a is within b"?
   *
   * <p>In a pattern F, 0, 1 and 2 match themselves, T matches 0, 1 and 2, and * matches all four.
   *
   * <p>Requires: matrix and pattern, nine such characters and a final NUL each; no T or * in the matrix.
   *
   * <p>Returns: 1 if it matches, 0 if not.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (another length or another character).
   *
   * <p>Accuracy: exact.
   *
   * <p>Since: 0.1.
   */
  static native int de9imMatch(Object matrix, Object pattern);

  /**
   * The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
   *
   * <p>The kinds are points, segments, boxes and rectangles; a point or a segment may also meet a circle or an ellipse.
   * The region is convex. Its vertices x0 y0 x1 y1 ... come counter-clockwise if y points up. The first is the one with
   * the least y, of equal ones that with the least x, by the numbers written. One vertex is a point, two are the ends
   * of a segment. Exchanging the shapes changes no bit; a zero is +0. Unused vertices become 0.
   *
   * <p>Returns: the number of vertices, 1 to 8, or 0 if the shapes share nothing.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND (also for other pairs of kinds than these), VESICA_E_SHAPE, VESICA_E_RANGE
   * (a vertex, or the length of a side that makes one, overflows).
   *
   * <p>Accuracy: the number of vertices is exact: it is that of the true region. A corner of a shape that lies in the
   * other keeps the stored numbers, or those of vesica_corners_of_shapes_f64 for a rectangle. Other vertices are right
   * to 4 u times the largest coordinate or size of either shape. In bounds on errors u is 2^-53, half a unit in the
   * last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
   * lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter
   * size.
   *
   * <p>Cost: that of vesica_overlap_f64 for disjoint shapes; 0.2 to 1 us with a segment, 2 to 6 us for areas; at worst
   * 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int intersectionF64(int kindA, Object numbersA, int kindB, Object numbersB, Object vertices);

  /**
   * The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
   *
   * <p>Every shape has an inside, an outline and an outside. The first three characters say what a's inside shares with
   * b's inside, outline and outside; the next three say it of a's outline, the last three of a's outside. F means
   * nothing, 0 single points, 1 lines, 2 an area. The outline of a shape with area is the curve around it, that of a
   * segment its two end points; a point has none. A segment without length is a point; a shape with one size 0 is a
   * segment, with both 0 a point. Two boxes side by side that share a side give "FF2F11212". Exchanging the shapes
   * exchanges rows and columns.
   *
   * <p>Requires: matrix with room for VESICA_DE9IM_SIZE characters.
   *
   * <p>Returns: 0, and nine characters and a final NUL in matrix.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
   *
   * <p>Accuracy: exact.
   *
   * <p>Cost: that of vesica_relation_f32; 0.1 to 1 us more for a segment, 2 us for rectangles whose sides are parallel.
   * At worst 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int de9imF32(int kindA, Object numbersA, int kindB, Object numbersB, Object matrix);

  /**
   * The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
   *
   * <p>The kinds are points, segments, boxes and rectangles; a point or a segment may also meet a circle or an ellipse.
   * The region is convex. Its vertices x0 y0 x1 y1 ... come counter-clockwise if y points up. The first is the one with
   * the least y, of equal ones that with the least x, by the numbers written. One vertex is a point, two are the ends
   * of a segment. Exchanging the shapes changes no bit; a zero is +0. Unused vertices become 0.
   *
   * <p>Returns: the number of vertices, 1 to 8, or 0 if the shapes share nothing.
   *
   * <p>Errors: VESICA_E_NULL, VESICA_E_KIND (also for other pairs of kinds than these), VESICA_E_SHAPE, VESICA_E_RANGE
   * (a vertex, or the length of a side that makes one, overflows).
   *
   * <p>Accuracy: the number of vertices is exact: it is that of the true region. A corner of a shape that lies in the
   * other keeps the stored numbers, or those of vesica_corners_of_shapes_f32 for a rectangle. Other vertices are right
   * to 4 u times the largest coordinate or size of either shape. Each number is computed in double, within these
   * bounds, and then rounded to float once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The
   * scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u
   * scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
   *
   * <p>Cost: that of vesica_overlap_f32 for disjoint shapes; 0.2 to 1 us with a segment, 2 to 6 us for areas; at worst
   * 30 us.
   *
   * <p>Since: 0.1.
   */
  static native int intersectionF32(int kindA, Object numbersA, int kindB, Object numbersB, Object vertices);

  static int check(boolean wide, int kind, Object numbers) {
    return wide
        ? checkF64(kind, numbers)
        : checkF32(kind, numbers);
  }

  static int overlap(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB) {
    return wide
        ? overlapF64(kindA, numbersA, kindB, numbersB)
        : overlapF32(kindA, numbersA, kindB, numbersB);
  }

  static int relation(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB) {
    return wide
        ? relationF64(kindA, numbersA, kindB, numbersB)
        : relationF32(kindA, numbersA, kindB, numbersB);
  }

  static int contains(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB) {
    return wide
        ? containsF64(kindA, numbersA, kindB, numbersB)
        : containsF32(kindA, numbersA, kindB, numbersB);
  }

  static int crossings(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB, Object out) {
    return wide
        ? crossingsF64(kindA, numbersA, kindB, numbersB, out)
        : crossingsF32(kindA, numbersA, kindB, numbersB, out);
  }

  static int nearest(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB, Object out) {
    return wide
        ? nearestF64(kindA, numbersA, kindB, numbersB, out)
        : nearestF32(kindA, numbersA, kindB, numbersB, out);
  }

  static int boundaryDistance(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB, Object out) {
    return wide
        ? boundaryDistanceF64(kindA, numbersA, kindB, numbersB, out)
        : boundaryDistanceF32(kindA, numbersA, kindB, numbersB, out);
  }

  static int depth(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB, Object out) {
    return wide
        ? depthF64(kindA, numbersA, kindB, numbersB, out)
        : depthF32(kindA, numbersA, kindB, numbersB, out);
  }

  static int shapeArea(boolean wide, int kind, Object numbers, Object out) {
    return wide
        ? shapeAreaF64(kind, numbers, out)
        : shapeAreaF32(kind, numbers, out);
  }

  static int area(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB, Object out) {
    return wide
        ? areaF64(kindA, numbersA, kindB, numbersB, out)
        : areaF32(kindA, numbersA, kindB, numbersB, out);
  }

  static int iou(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB, Object out) {
    return wide
        ? iouF64(kindA, numbersA, kindB, numbersB, out)
        : iouF32(kindA, numbersA, kindB, numbersB, out);
  }

  static int bounds(boolean wide, int kind, Object numbers, Object out) {
    return wide
        ? boundsF64(kind, numbers, out)
        : boundsF32(kind, numbers, out);
  }

  static int aabbFromCorners(boolean wide, double x0, double y0, double x1, double y1, Object out) {
    return wide
        ? aabbFromCornersF64(x0, y0, x1, y1, out)
        : aabbFromCornersF32((float) x0, (float) y0, (float) x1, (float) y1, out);
  }

  static int rectFromAngle(boolean wide, double cx, double cy, double angle, double width, double height, Object out) {
    return wide
        ? rectFromAngleF64(cx, cy, angle, width, height, out)
        : rectFromAngleF32((float) cx, (float) cy, (float) angle, (float) width, (float) height, out);
  }

  static int rectFromCorners(boolean wide, Object corners, Object out) {
    return wide
        ? rectFromCornersF64(corners, out)
        : rectFromCornersF32(corners, out);
  }

  static int ellipseFromAngle(boolean wide, double cx, double cy, double angle, double a, double b, Object out) {
    return wide
        ? ellipseFromAngleF64(cx, cy, angle, a, b, out)
        : ellipseFromAngleF32((float) cx, (float) cy, (float) angle, (float) a, (float) b, out);
  }

  static int ellipseFromRadiusVector(boolean wide, double cx, double cy, double wx, double wy, double ratio,
      Object out) {
    return wide
        ? ellipseFromRadiusVectorF64(cx, cy, wx, wy, ratio, out)
        : ellipseFromRadiusVectorF32((float) cx, (float) cy, (float) wx, (float) wy, (float) ratio, out);
  }

  static int ellipseFromCovariance(boolean wide, double meanX, double meanY, double cxx, double cxy, double cyy,
      double k, Object out) {
    return wide
        ? ellipseFromCovarianceF64(meanX, meanY, cxx, cxy, cyy, k, out)
        : ellipseFromCovarianceF32((float) meanX, (float) meanY, (float) cxx, (float) cxy, (float) cyy, (float) k, out);
  }

  static int ellipseFromMatrix(boolean wide, double cx, double cy, double mxx, double mxy, double myy, Object out) {
    return wide
        ? ellipseFromMatrixF64(cx, cy, mxx, mxy, myy, out)
        : ellipseFromMatrixF32((float) cx, (float) cy, (float) mxx, (float) mxy, (float) myy, out);
  }

  static long overlapMany(boolean wide, Shapes a, Shapes b, Object out) {
    return wide
        ? overlapManyF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out)
        : overlapManyF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out);
  }

  static long relationMany(boolean wide, Shapes a, Shapes b, Object out) {
    return wide
        ? relationManyF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out)
        : relationManyF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out);
  }

  static long containsMany(boolean wide, Shapes a, Shapes b, Object out) {
    return wide
        ? containsManyF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out)
        : containsManyF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out);
  }

  static long nearestMany(boolean wide, Shapes a, Shapes b, Object distance, Object ax, Object ay, Object bx,
      Object by) {
    return wide
        ? nearestManyF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, distance,
            ax, ay, bx, by)
        : nearestManyF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, distance,
            ax, ay, bx, by);
  }

  static long boundaryDistanceMany(boolean wide, Shapes a, Shapes b, Object distance, Object ax, Object ay, Object bx,
      Object by) {
    return wide
        ? boundaryDistanceManyF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            distance, ax, ay, bx, by)
        : boundaryDistanceManyF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            distance, ax, ay, bx, by);
  }

  static long depthMany(boolean wide, Shapes a, Shapes b, Object depth, Object x, Object y) {
    return wide
        ? depthManyF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, depth, x,
            y)
        : depthManyF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, depth, x,
            y);
  }

  static long areaMany(boolean wide, Shapes a, Shapes b, Object out) {
    return wide
        ? areaManyF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out)
        : areaManyF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out);
  }

  static long iouMany(boolean wide, Shapes a, Shapes b, Object out) {
    return wide
        ? iouManyF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out)
        : iouManyF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out);
  }

  static long overlapMatrix(boolean wide, Shapes a, Shapes b, Object out, long rowStride) {
    return wide
        ? overlapMatrixF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride)
        : overlapMatrixF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride);
  }

  static long relationMatrix(boolean wide, Shapes a, Shapes b, Object out, long rowStride) {
    return wide
        ? relationMatrixF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride)
        : relationMatrixF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride);
  }

  static long containsMatrix(boolean wide, Shapes a, Shapes b, Object out, long rowStride) {
    return wide
        ? containsMatrixF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride)
        : containsMatrixF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride);
  }

  static long areaMatrix(boolean wide, Shapes a, Shapes b, Object out, long rowStride) {
    return wide
        ? areaMatrixF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride)
        : areaMatrixF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride);
  }

  static long iouMatrix(boolean wide, Shapes a, Shapes b, Object out, long rowStride) {
    return wide
        ? iouMatrixF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride)
        : iouMatrixF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride);
  }

  static long overlapSelect(boolean wide, Shapes one, Shapes many, Object out, long capacity) {
    return wide
        ? overlapSelectF64(one.kind, one.count, one.stride, one.step, one.base, many.kind, many.count, many.stride,
            many.step, many.base, out, capacity)
        : overlapSelectF32(one.kind, one.count, one.stride, one.step, one.base, many.kind, many.count, many.stride,
            many.step, many.base, out, capacity);
  }

  static int nms(boolean wide, Shapes shapes, Object scores, double threshold, Object scratch, long scratchSize,
      Object keep, Object kept) {
    return wide
        ? nmsF64(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, scores, threshold, scratch,
            scratchSize, keep, kept)
        : nmsF32(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, scores, (float) threshold, scratch,
            scratchSize, keep, kept);
  }

  static long rectsFromBoxes(boolean wide, Object boxes, long count, long stride, int angle, Object out) {
    return wide
        ? rectsFromBoxesF64(boxes, count, stride, angle, out)
        : rectsFromBoxesF32(boxes, count, stride, angle, out);
  }

  static long ellipsesFromBoxes(boolean wide, Object boxes, long count, long stride, int angle, Object out) {
    return wide
        ? ellipsesFromBoxesF64(boxes, count, stride, angle, out)
        : ellipsesFromBoxesF32(boxes, count, stride, angle, out);
  }

  static long boxesFromShapes(boolean wide, Shapes shapes, int angle, Object boxes) {
    return wide
        ? boxesFromShapesF64(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, angle, boxes)
        : boxesFromShapesF32(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, angle, boxes);
  }

  static long cornersOfShapes(boolean wide, Shapes shapes, Object corners) {
    return wide
        ? cornersOfShapesF64(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, corners)
        : cornersOfShapesF32(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, corners);
  }

  static long boundsMany(boolean wide, Shapes shapes, Object out) {
    return wide
        ? boundsManyF64(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, out)
        : boundsManyF32(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, out);
  }

  static long indexBuild(boolean wide, Sets sets, Object index, long indexSize, Object scratch, long scratchSize) {
    return wide
        ? indexBuildF64(sets.kinds, sets.counts, sets.strides, sets.steps, sets.bases, index, indexSize, scratch,
            scratchSize)
        : indexBuildF32(sets.kinds, sets.counts, sets.strides, sets.steps, sets.bases, index, indexSize, scratch,
            scratchSize);
  }

  static long indexSelect(boolean wide, Object index, Sets sets, Shapes one, Object out, long capacity, Object state) {
    return wide
        ? indexSelectF64(index, sets.kinds, sets.counts, sets.strides, sets.steps, sets.bases, one.kind, one.count,
            one.stride, one.step, one.base, out, capacity, state)
        : indexSelectF32(index, sets.kinds, sets.counts, sets.strides, sets.steps, sets.bases, one.kind, one.count,
            one.stride, one.step, one.base, out, capacity, state);
  }

  static long join(boolean wide, int query, Object indexA, Sets setsA, Object indexB, Sets setsB, long part, long parts,
      Object scratch, long scratchSize, Object outA, Object outB, long capacity, Object state) {
    return wide
        ? joinF64(query, indexA, setsA.kinds, setsA.counts, setsA.strides, setsA.steps, setsA.bases, indexB,
            setsB.kinds, setsB.counts, setsB.strides, setsB.steps, setsB.bases, part, parts, scratch, scratchSize, outA,
            outB, capacity, state)
        : joinF32(query, indexA, setsA.kinds, setsA.counts, setsA.strides, setsA.steps, setsA.bases, indexB,
            setsB.kinds, setsB.counts, setsB.strides, setsB.steps, setsB.bases, part, parts, scratch, scratchSize, outA,
            outB, capacity, state);
  }

  static long joinWithin(boolean wide, Object indexA, Sets setsA, Object indexB, Sets setsB, double distance, long part,
      long parts, Object outA, Object outB, long capacity, Object state) {
    return wide
        ? joinWithinF64(indexA, setsA.kinds, setsA.counts, setsA.strides, setsA.steps, setsA.bases, indexB, setsB.kinds,
            setsB.counts, setsB.strides, setsB.steps, setsB.bases, distance, part, parts, outA, outB, capacity, state)
        : joinWithinF32(indexA, setsA.kinds, setsA.counts, setsA.strides, setsA.steps, setsA.bases, indexB, setsB.kinds,
            setsB.counts, setsB.strides, setsB.steps, setsB.bases, (float) distance, part, parts, outA, outB, capacity,
            state);
  }

  static long indexNearest(boolean wide, Object index, Sets sets, Shapes one, long k, double within, Object out,
      Object distance) {
    return wide
        ? indexNearestF64(index, sets.kinds, sets.counts, sets.strides, sets.steps, sets.bases, one.kind, one.count,
            one.stride, one.step, one.base, k, within, out, distance)
        : indexNearestF32(index, sets.kinds, sets.counts, sets.strides, sets.steps, sets.bases, one.kind, one.count,
            one.stride, one.step, one.base, k, (float) within, out, distance);
  }

  static long joinNearest(boolean wide, Sets setsA, Object indexB, Sets setsB, long k, double within, long part,
      long parts, Object out, Object distance) {
    return wide
        ? joinNearestF64(setsA.kinds, setsA.counts, setsA.strides, setsA.steps, setsA.bases, indexB, setsB.kinds,
            setsB.counts, setsB.strides, setsB.steps, setsB.bases, k, within, part, parts, out, distance)
        : joinNearestF32(setsA.kinds, setsA.counts, setsA.strides, setsA.steps, setsA.bases, indexB, setsB.kinds,
            setsB.counts, setsB.strides, setsB.steps, setsB.bases, k, (float) within, part, parts, out, distance);
  }

  static int ratio(boolean wide, int ratio, int kindA, Object numbersA, int kindB, Object numbersB, Object out) {
    return wide
        ? ratioF64(ratio, kindA, numbersA, kindB, numbersB, out)
        : ratioF32(ratio, kindA, numbersA, kindB, numbersB, out);
  }

  static long ratioMany(boolean wide, int ratio, Shapes a, Shapes b, Object out) {
    return wide
        ? ratioManyF64(ratio, a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out)
        : ratioManyF32(ratio, a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            out);
  }

  static long ratioMatrix(boolean wide, int ratio, Shapes a, Shapes b, Object out, long rowStride) {
    return wide
        ? ratioMatrixF64(ratio, a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            out, rowStride)
        : ratioMatrixF32(ratio, a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            out, rowStride);
  }

  static long nearestMatrix(boolean wide, Shapes a, Shapes b, Object out, long rowStride) {
    return wide
        ? nearestMatrixF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride)
        : nearestMatrixF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride);
  }

  static long boundaryDistanceMatrix(boolean wide, Shapes a, Shapes b, Object out, long rowStride) {
    return wide
        ? boundaryDistanceMatrixF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step,
            b.base, out, rowStride)
        : boundaryDistanceMatrixF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step,
            b.base, out, rowStride);
  }

  static long depthMatrix(boolean wide, Shapes a, Shapes b, Object out, long rowStride) {
    return wide
        ? depthMatrixF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride)
        : depthMatrixF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, out,
            rowStride);
  }

  static int signedDistance(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB, Object out) {
    return wide
        ? signedDistanceF64(kindA, numbersA, kindB, numbersB, out)
        : signedDistanceF32(kindA, numbersA, kindB, numbersB, out);
  }

  static long signedDistanceMany(boolean wide, Shapes a, Shapes b, Object out) {
    return wide
        ? signedDistanceManyF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            out)
        : signedDistanceManyF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            out);
  }

  static long signedDistanceMatrix(boolean wide, Shapes a, Shapes b, Object out, long rowStride) {
    return wide
        ? signedDistanceMatrixF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            out, rowStride)
        : signedDistanceMatrixF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            out, rowStride);
  }

  static int within(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB, double distance) {
    return wide
        ? withinF64(kindA, numbersA, kindB, numbersB, distance)
        : withinF32(kindA, numbersA, kindB, numbersB, (float) distance);
  }

  static long withinMany(boolean wide, Shapes a, Shapes b, double distance, Object out) {
    return wide
        ? withinManyF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, distance,
            out)
        : withinManyF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            (float) distance, out);
  }

  static long withinMatrix(boolean wide, Shapes a, Shapes b, double distance, Object out, long rowStride) {
    return wide
        ? withinMatrixF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            distance, out, rowStride)
        : withinMatrixF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base,
            (float) distance, out, rowStride);
  }

  static int suppress(boolean wide, Shapes shapes, Object scores, Object labels, int ratio, double threshold,
      double leastScore, long most, Object scratch, long scratchSize, Object keep, Object kept) {
    return wide
        ? suppressF64(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, scores, labels, ratio,
            threshold, leastScore, most, scratch, scratchSize, keep, kept)
        : suppressF32(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, scores, labels, ratio,
            (float) threshold, (float) leastScore, most, scratch, scratchSize, keep, kept);
  }

  static int suppressSoft(boolean wide, Shapes shapes, Object scores, Object labels, int ratio, int decay,
      double parameter, double leastScore, long most, Object scratch, long scratchSize, Object keep, Object decayed,
      Object kept) {
    return wide
        ? suppressSoftF64(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, scores, labels, ratio,
            decay, parameter, leastScore, most, scratch, scratchSize, keep, decayed, kept)
        : suppressSoftF32(shapes.kind, shapes.count, shapes.stride, shapes.step, shapes.base, scores, labels, ratio,
            decay, (float) parameter, (float) leastScore, most, scratch, scratchSize, keep, decayed, kept);
  }

  static int cast(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB, double vx, double vy,
      double tEnd, Object out) {
    return wide
        ? castF64(kindA, numbersA, kindB, numbersB, vx, vy, tEnd, out)
        : castF32(kindA, numbersA, kindB, numbersB, (float) vx, (float) vy, (float) tEnd, out);
  }

  static long castMany(boolean wide, Shapes a, Shapes b, Object vx, Object vy, long stride, double tEnd, Object t,
      Object x, Object y, Object nx, Object ny) {
    return wide
        ? castManyF64(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, vx, vy,
            stride, tEnd, t, x, y, nx, ny)
        : castManyF32(a.kind, a.count, a.stride, a.step, a.base, b.kind, b.count, b.stride, b.step, b.base, vx, vy,
            stride, (float) tEnd, t, x, y, nx, ny);
  }

  static long castFirst(boolean wide, Shapes one, Shapes many, double vx, double vy, double tEnd, Object out) {
    return wide
        ? castFirstF64(one.kind, one.count, one.stride, one.step, one.base, many.kind, many.count, many.stride,
            many.step, many.base, vx, vy, tEnd, out)
        : castFirstF32(one.kind, one.count, one.stride, one.step, one.base, many.kind, many.count, many.stride,
            many.step, many.base, (float) vx, (float) vy, (float) tEnd, out);
  }

  static int sweepBounds(boolean wide, int kind, Object numbers, double vx, double vy, double tEnd, Object out) {
    return wide
        ? sweepBoundsF64(kind, numbers, vx, vy, tEnd, out)
        : sweepBoundsF32(kind, numbers, (float) vx, (float) vy, (float) tEnd, out);
  }

  static long indexCast(boolean wide, Object index, Sets sets, Shapes one, double vx, double vy, double tEnd,
      Object out, long capacity, Object state) {
    return wide
        ? indexCastF64(index, sets.kinds, sets.counts, sets.strides, sets.steps, sets.bases, one.kind, one.count,
            one.stride, one.step, one.base, vx, vy, tEnd, out, capacity, state)
        : indexCastF32(index, sets.kinds, sets.counts, sets.strides, sets.steps, sets.bases, one.kind, one.count,
            one.stride, one.step, one.base, (float) vx, (float) vy, (float) tEnd, out, capacity, state);
  }

  static long indexCastFirst(boolean wide, Object index, Sets sets, Shapes one, double vx, double vy, double tEnd,
      Object out) {
    return wide
        ? indexCastFirstF64(index, sets.kinds, sets.counts, sets.strides, sets.steps, sets.bases, one.kind, one.count,
            one.stride, one.step, one.base, vx, vy, tEnd, out)
        : indexCastFirstF32(index, sets.kinds, sets.counts, sets.strides, sets.steps, sets.bases, one.kind, one.count,
            one.stride, one.step, one.base, (float) vx, (float) vy, (float) tEnd, out);
  }

  static int impactTime(boolean wide, int kindA, Object numbersA, Object turnA, int kindB, Object numbersB,
      Object turnB, double tolerance, Object out, Object gap) {
    return wide
        ? impactTimeF64(kindA, numbersA, turnA, kindB, numbersB, turnB, tolerance, out, gap)
        : impactTimeF32(kindA, numbersA, turnA, kindB, numbersB, turnB, (float) tolerance, out, gap);
  }

  static int castPointPoint(boolean wide, Object a, Object b, double vx, double vy, double tEnd, Object out) {
    return wide
        ? castPointPointF64(a, b, vx, vy, tEnd, out)
        : castPointPointF32(a, b, (float) vx, (float) vy, (float) tEnd, out);
  }

  static int castSegmentPoint(boolean wide, Object a, Object b, double vx, double vy, double tEnd, Object out) {
    return wide
        ? castSegmentPointF64(a, b, vx, vy, tEnd, out)
        : castSegmentPointF32(a, b, (float) vx, (float) vy, (float) tEnd, out);
  }

  static int castCirclePoint(boolean wide, Object a, Object b, double vx, double vy, double tEnd, Object out) {
    return wide
        ? castCirclePointF64(a, b, vx, vy, tEnd, out)
        : castCirclePointF32(a, b, (float) vx, (float) vy, (float) tEnd, out);
  }

  static int castAabbPoint(boolean wide, Object a, Object b, double vx, double vy, double tEnd, Object out) {
    return wide
        ? castAabbPointF64(a, b, vx, vy, tEnd, out)
        : castAabbPointF32(a, b, (float) vx, (float) vy, (float) tEnd, out);
  }

  static int castRectPoint(boolean wide, Object a, Object b, double vx, double vy, double tEnd, Object out) {
    return wide
        ? castRectPointF64(a, b, vx, vy, tEnd, out)
        : castRectPointF32(a, b, (float) vx, (float) vy, (float) tEnd, out);
  }

  static int castEllipsePoint(boolean wide, Object a, Object b, double vx, double vy, double tEnd, Object out) {
    return wide
        ? castEllipsePointF64(a, b, vx, vy, tEnd, out)
        : castEllipsePointF32(a, b, (float) vx, (float) vy, (float) tEnd, out);
  }

  static int castCircleCircle(boolean wide, Object a, Object b, double vx, double vy, double tEnd, Object out) {
    return wide
        ? castCircleCircleF64(a, b, vx, vy, tEnd, out)
        : castCircleCircleF32(a, b, (float) vx, (float) vy, (float) tEnd, out);
  }

  static int castRectRect(boolean wide, Object a, Object b, double vx, double vy, double tEnd, Object out) {
    return wide
        ? castRectRectF64(a, b, vx, vy, tEnd, out)
        : castRectRectF32(a, b, (float) vx, (float) vy, (float) tEnd, out);
  }

  static int de9im(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB, Object matrix) {
    return wide
        ? de9imF64(kindA, numbersA, kindB, numbersB, matrix)
        : de9imF32(kindA, numbersA, kindB, numbersB, matrix);
  }

  static int intersection(boolean wide, int kindA, Object numbersA, int kindB, Object numbersB, Object vertices) {
    return wide
        ? intersectionF64(kindA, numbersA, kindB, numbersB, vertices)
        : intersectionF32(kindA, numbersA, kindB, numbersB, vertices);
  }
}
