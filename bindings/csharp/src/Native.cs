// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
using System;
using System.Runtime.InteropServices;

namespace Vesica
{
    /// <summary>The functions of the C library, with their texts.</summary>
    internal static unsafe partial class Native
    {
        /// <summary>
        /// of this header: major * 10000 + minor * 100 + patch
        /// </summary>
        internal const int Version = 100;

        /// <summary>
        /// <para>Version of the loaded library. If it is below VESICA_VERSION, the library is older than the
        /// header.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_version();

        /// <summary>
        /// <para>VESICA_VERSION_MAJOR of the loaded library.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_version_major();

        /// <summary>
        /// <para>VESICA_VERSION_MINOR of the loaded library.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_version_minor();

        /// <summary>
        /// <para>VESICA_VERSION_PATCH of the loaded library.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_version_patch();

        /// <summary>
        /// <para>What an error code means, as one English phrase without a full stop.</para>
        /// <para>Returns: static text, never NULL: "success" for answers (&gt;= 0), "unknown error" for unknown
        /// codes.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr vesica_strerror(int code);

        /// <summary>
        /// <para>How many numbers does a shape of this kind have?</para>
        /// <para>Returns: 2, 4, 3, 4, 6, 6 for VESICA_POINT ... VESICA_ELLIPSE.</para>
        /// <para>Errors: VESICA_E_KIND.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_field_count(int kind);

        /// <summary>
        /// <para>Name of a kind.</para>
        /// <para>Returns: static text: "point", "segment", "circle", "aabb", "rect" or "ellipse"; NULL for an unknown
        /// kind.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr vesica_kind_name(int kind);

        /// <summary>
        /// <para>Name of the instruction set that batches use: the best one of this processor. Answers never depend on
        /// it.</para>
        /// <para>The environment variable VESICA_ISA selects another one. It is read once, when the library is loaded.
        /// An unknown name is ignored, and so is a set that the processor, or this build of the library, lacks.</para>
        /// <para>Returns: static text: "sse2", "avx2", "avx512", "neon", "simd128" or "portable".</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr vesica_isa_name();

        /// <summary>
        /// <para>Is a shape valid, and if not, which rule does it break?</para>
        /// <para>Returns: 0 for a valid shape, else the first rule broken: VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE,
        /// VESICA_E_ZERO_AXIS or VESICA_E_INVERTED.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND.</para>
        /// <para>Cost: a few ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_check_f64(int kind, void* numbers);

        /// <summary>
        /// <para>Do two shapes share a point? Touching counts.</para>
        /// <para>Returns: 1 if they do, 0 if not.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: about 2 ns more than the function named after the two kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_overlap_f64(int kindA, void* numbersA, int kindB, void* numbersB);

        /// <summary>
        /// <para>How does a relate to b? The answer is one of the eight relations of the region connection calculus
        /// (RCC-8).</para>
        /// <para>The outline of a shape with area is the curve around it. The outline of a segment, or of a shape with
        /// one size zero, is its two end points. A point, or a shape without any size, has no outline. The inside is
        /// the shape without its outline. If several relations fit, VESICA_EQUAL comes first, then those of
        /// containment, then VESICA_CROSS. So a segment that ends on the middle of another touches it; two segments on
        /// one line that overlap in part cross; a point on the rim of a disc is VESICA_INSIDE_TOUCH. Exchanging the
        /// shapes always gives the converse relation.</para>
        /// <para>Returns: VESICA_DISJOINT ... VESICA_EQUAL. Equal sets are VESICA_EQUAL, whatever kinds and numbers
        /// describe them.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: up to twice that of vesica_overlap_f64; 0.1 to 8 us if shapes touch or are equal; at worst 30
        /// us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_relation_f64(int kindA, void* numbersA, int kindB, void* numbersB);

        /// <summary>
        /// <para>Does a contain all of b? A shape contains itself, and whatever touches its outline from inside.</para>
        /// <para>Returns: 1 if vesica_relation_f64 is VESICA_CONTAINS, VESICA_CONTAINS_TOUCH or VESICA_EQUAL, else
        /// 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: that of vesica_relation_f64.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_contains_f64(int kindA, void* numbersA, int kindB, void* numbersB);

        /// <summary>
        /// <para>Where do the outlines of two shapes meet? Touching counts.</para>
        /// <para>The outline of a shape with area is the curve around it. A segment, a point and a shape without area
        /// are their own outlines. A contact counts as one place, however closely the curves touch there. If straight
        /// outlines share a stretch, its two end points are places, and out-&gt;shared is 1; so equal boxes meet at
        /// their four corners. Two equal curves meet everywhere: then the count is 0 and out-&gt;shared is 1. Places
        /// come in order along a's outline, counter-clockwise in the frame of its axis. The start is a box's corner C -
        /// hx u - hy perp(u), an ellipse's point C + a u (one without area begins as a box), a circle's point C + (r,
        /// 0), or a segment's first end.</para>
        /// <para>Returns: the number of places, 0 to 8.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the number is exact. A place is right to 4 u times the largest coordinate or size of either
        /// shape, even where the outlines nearly coincide. Places closer to one another than that may come in either
        /// order or be equal. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two
        /// shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale"
        /// means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.</para>
        /// <para>Cost: 1 to 10 us; at worst 30 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_crossings_f64(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>How far apart are two solid shapes, and which of their points are closest?</para>
        /// <para>If the shapes overlap (as vesica_overlap_f64 tells), the distance is 0 and both points are one common
        /// point. If not, the distance is &gt; 0. Exchanging the shapes exchanges the points and changes no bit. Moving
        /// both shapes alike changes no bit of the distance if no coordinate is rounded.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the distance is right to 4 u scale at any aspect ratio; the largest error seen was 1 u
        /// scale, and 3.3 u beside the ends of the thinnest ellipses. Its relative error is at most 2 u above 1e-10
        /// scale (aspect ratios up to 1e6) or 1e-14 scale (up to 1000). Closest points are right to 4 u scale, and a
        /// common point to 8 u scale, before they are rounded. In bounds on errors u is 2^-53, half a unit in the last
        /// place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
        /// lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over
        /// shorter size.</para>
        /// <para>Cost: 100 to 250 ns for disjoint shapes, 450 ns for a point and an ellipse, 500 ns for the thinnest
        /// ellipses; 50 ns if a shape holds the other's centre; 0.3 to 3 us for shapes that cross, near-ties and
        /// magnitudes above 2^40 or below 2^-40; at worst 25 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_nearest_f64(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>How far apart are the outlines of two shapes, and where do they come closest?</para>
        /// <para>The outline of a shape with area is the curve around it. A point, a segment and a shape with a zero
        /// size are their own outlines. If outlines meet, the distance is 0 and (ax, ay) = (bx, by) is a point of both.
        /// If shapes are disjoint, the result is that of vesica_nearest_f64. If one is strictly inside the other, the
        /// distance is the least over the whole outline, never a local minimum. Which case holds is decided exactly.
        /// Exchanging the shapes exchanges the points and changes no bit. Moving both shapes alike changes no bit of
        /// the distance if no coordinate is rounded.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: at aspect ratios up to 1e6 the distance is right to 4 u scale, and the points are that far
        /// apart to 16 u scale. At any ratio it is above 0 unless outlines meet, and points are on them to 12 u scale
        /// before they are rounded. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of
        /// two shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u
        /// scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.</para>
        /// <para>Cost: that of vesica_nearest_f64 for disjoint shapes; 0.1 to 0.5 us for nested ones, for a few 1 us
        /// more; 0.4 to 0.8 us if outlines meet, for thin shapes as vesica_crossings_f64; up to 5 us more for
        /// near-ties; at worst 30 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_boundary_distance_f64(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>Penetration depth: how far and which way must b be moved until the two shapes only touch?</para>
        /// <para>Moving b by out-&gt;depth along the unit vector (x, y) is the shortest translation after which a line
        /// separates the shapes: a on one side, b on the other, where both may touch the line. For disjoint shapes all
        /// three numbers are 0. Overlapping shapes always get a direction. Their depth is 0 if such a line exists
        /// without a move: if they touch from outside, if a point lies on an outline, or if points and segments lie
        /// along one line. Otherwise the depth is &gt; 0. Exchanging the shapes reverses the direction and changes no
        /// other bit, except for two equal shapes in one place. Moving both shapes alike changes no bit if no
        /// coordinate is rounded.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: at aspect ratios up to 1e6 the depth is right to 4 u scale; for circles and points, to its
        /// last place. The length of (x, y) is 1 to 3 u. After the move at most 8 u scale of overlap is left. Whether
        /// the depth is 0 is exact at any ratio; beyond 1e6 no bound on its error is stated. In bounds on errors u is
        /// 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
        /// their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale.
        /// An aspect ratio is longer over shorter size.</para>
        /// <para>Cost: about 150 ns for points, segments and boxes; 0.5 us with an ellipse, for a few 1 us more; up to
        /// 5 us if only exact arithmetic can tell the depth from 0; at worst 25 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_depth_f64(int kindA, void* numbersA, int kindB, void* numbersB, void* output);

        /// <summary>
        /// <para>Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a
        /// segment.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the double nearest to the true area; a tiny area becomes subnormal or 0. So a shape inside
        /// another never has the greater area, and equal shapes have equal areas, whatever kinds and numbers describe
        /// them.</para>
        /// <para>Cost: about 20 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_shape_area_f64(int kind, void* numbers, void* output);

        /// <summary>
        /// <para>Area of the intersection of two shapes.</para>
        /// <para>It is exactly 0 if shapes are disjoint, if they only touch, or if one has no area. If one contains the
        /// other, it is the vesica_shape_area_f64 of the inner one. It is never more than the area of either, and more
        /// than 0 if the insides of shapes with area meet, unless that underflows. Exchanging the shapes changes no
        /// bit. Scaling both by a power of two scales the area by its square.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: right to 64 u times the smaller shape's area times the larger aspect ratio, at aspect ratios
        /// up to 10^4, even if the outlines nearly touch or coincide and whatever the sizes are. Beyond 10^4 no bound
        /// is stated; what is said above holds at any ratio. In bounds on errors u is 2^-53, half a unit in the last
        /// place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
        /// lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over
        /// shorter size.</para>
        /// <para>Cost: about 50 ns for two boxes, 150 ns for an ellipse and a box, 0.6 us for two ellipses; up to 10 us
        /// if outlines nearly touch or coincide, or if one shape is far larger; at worst 30 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_area_f64(int kindA, void* numbersA, int kindB, void* numbersB, void* output);

        /// <summary>
        /// <para>Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover
        /// together.</para>
        /// <para>It is exactly 1 for equal shapes and exactly 0 for shapes that share no area. Intermediate results
        /// never overflow or underflow. Exchanging the shapes, or scaling both by a power of two, changes no
        /// bit.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (neither shape has an
        /// area).</para>
        /// <para>Accuracy: the bound of vesica_area_f64, divided by the area of the union.</para>
        /// <para>Cost: that of vesica_area_f64 and of vesica_shape_area_f64 twice.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_iou_f64(int kindA, void* numbersA, int kindB, void* numbersB, void* output);

        /// <summary>
        /// <para>Smallest box of representable numbers that contains a shape.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: each side is the true extreme of the shape, rounded outward once. So a representable box is
        /// exact.</para>
        /// <para>Cost: up to 80 ns; 1 to 3 us for magnitudes above 2^400 or below 2^-400, and for an ellipse with an
        /// oblique axis and representable sides; at worst 6 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_bounds_f64(int kind, void* numbers, void* output);

        /// <summary>
        /// <para>Box with two opposite corners, in any order.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_aabb_from_corners_f64(double x0, double y0, double x1, double y1,
            void* output);

        /// <summary>
        /// <para>Rectangle from centre, angle and full size: width along the angle, height across it.</para>
        /// <para>Requires: the angle in radians, counter-clockwise from +x if y points up; width, height &gt;=
        /// 0.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.</para>
        /// <para>Accuracy: the axis is (cos, sin), each right to 1 unit in the last place. No double is exactly pi/2,
        /// so a quarter turn has an exact axis only by vesica_rects_from_boxes_f64, which takes degrees too. Sizes are
        /// exact: if halving one would round (an odd multiple of the smallest subnormal number), the axis is halved
        /// instead.</para>
        /// <para>Cost: about 40 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_rect_from_angle_f64(double cx, double cy, double angle, double width,
            double height, void* output);

        /// <summary>
        /// <para>Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.</para>
        /// <para>Corners that are not exactly a rectangle's give a rectangle near them, which need not contain them.
        /// The centre is the mean of the corners. The axis is a unit vector along the edge from corner 0 to corner 1,
        /// and hx belongs to that edge. Opposite edges are averaged; the longer pair gives the direction, and the
        /// shorter pair counts by its part across it. Two or four equal corners are legal: they give a segment, or a
        /// point with axis (1, 0).</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_RANGE (a half extent overflows).</para>
        /// <para>Accuracy: half extents, and the axis times the longer one, are right to 8 units in the last place of
        /// the longer one; the centre is right to 1 unit in its own. Both errors may grow by 2^-98 times the largest
        /// coordinate. A rectangle along the coordinate axes is found exactly if its centre and half extents are
        /// representable.</para>
        /// <para>Cost: about 110 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_rect_from_corners_f64(void* corners, void* output);

        /// <summary>
        /// <para>Ellipse from centre, angle and half lengths: a along the angle, b across it.</para>
        /// <para>Requires: the angle in radians, counter-clockwise from +x if y points up; a, b &gt;= 0.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.</para>
        /// <para>Accuracy: the axis is that of vesica_rect_from_angle_f64; half lengths are exact.</para>
        /// <para>Cost: about 40 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ellipse_from_angle_f64(double cx, double cy, double angle, double a, double b,
            void* output);

        /// <summary>
        /// <para>Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times
        /// perp(wx, wy).</para>
        /// <para>A zero vector gives the point (cx, cy).</para>
        /// <para>Requires: ratio &gt;= 0.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ellipse_from_radius_vector_f64(double cx, double cy, double wx, double wy,
            double ratio, void* output);

        /// <summary>
        /// <para>Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).</para>
        /// <para>A singular covariance, or k = 0, gives a segment or a point. The result has a &gt;= b. Its axis is a
        /// unit vector with x &gt;= 0, or (1, 0) for equal variances without correlation.</para>
        /// <para>Requires: the covariance cxx, cxy, cyy (units squared) positive semidefinite: cxy^2 &lt;= cxx cyy as
        /// stored; k &gt;= 0.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE (k &lt; 0), VESICA_E_ARGUMENT (not
        /// a covariance), VESICA_E_RANGE (a half length overflows).</para>
        /// <para>Accuracy: half lengths and both components of the axis are right to 8 units in their own last place,
        /// even if the matrix is nearly singular or nearly a circle's.</para>
        /// <para>Cost: about 90 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ellipse_from_covariance_f64(double meanX, double meanY, double cxx,
            double cxy, double cyy, double k, void* output);

        /// <summary>
        /// <para>Ellipse of the points X with (X - C) . M (X - C) &lt;= 1, where M is symmetric with entries mxx, mxy,
        /// myy.</para>
        /// <para>The result is that of vesica_ellipse_from_covariance_f64 for the inverse of M and k = 1.</para>
        /// <para>Requires: M positive definite as stored.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (not positive definite).</para>
        /// <para>Accuracy: that of vesica_ellipse_from_covariance_f64. No half length overflows.</para>
        /// <para>Cost: about 90 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ellipse_from_matrix_f64(double cx, double cy, double mxx, double mxy,
            double myy, void* output);

        /// <summary>
        /// <para>Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f64.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: in cache, from columns, with AVX-512: 0.5 to 2 ns a pair in double, 0.3 to 0.8 ns in float;
        /// about half of that if one array is a single shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_overlap_many_f64(void* a, void* b, void* output);

        /// <summary>
        /// <para>How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f64.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many are not VESICA_DISJOINT.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_relation_many_f64(void* a, void* b, void* output);

        /// <summary>
        /// <para>Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f64.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_contains_many_f64(void* a, void* b, void* output);

        /// <summary>
        /// <para>How far apart are a[i] and b[i], and where? The columns are the fields of vesica_nearest_f64's
        /// result.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many pairs overlap (distance 0).</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_nearest_many_f64(void* a, void* b, void* distance, void* ax, void* ay,
            void* bx, void* by);

        /// <summary>
        /// <para>How far apart are the outlines of a[i] and b[i]? The columns are the fields of
        /// vesica_boundary_distance_f64's result.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many pairs of outlines meet (distance 0).</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_boundary_distance_many_f64(void* a, void* b, void* distance, void* ax,
            void* ay, void* bx, void* by);

        /// <summary>
        /// <para>How deep do a[i] and b[i] overlap? The columns are the fields of vesica_depth_f64's result.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many depths are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_depth_many_f64(void* a, void* b, void* depth, void* x, void* y);

        /// <summary>
        /// <para>What area do a[i] and b[i] share? out[i] is the result of vesica_area_f64.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many areas are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_area_many_f64(void* a, void* b, void* output);

        /// <summary>
        /// <para>Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f64.</para>
        /// <para>If neither of a pair has an area, out[i] is NaN, and the call returns VESICA_E_ARGUMENT unless a shape
        /// is invalid.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_iou_many_f64(void* a, void* b, void* output);

        /// <summary>
        /// <para>Do a[i] and b[j] share a point? Answers as of vesica_overlap_f64; much quicker if both arrays are in
        /// spatial order.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that exceed
        /// the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the
        /// arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_overlap_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>How does a[i] relate to b[j]? The elements of out are answers of vesica_relation_f64.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are not VESICA_DISJOINT.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that exceed
        /// the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the
        /// arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_relation_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Does a[i] contain all of b[j]? The elements of out are answers of vesica_contains_f64.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that exceed
        /// the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the
        /// arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_contains_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>What area do a[i] and b[j] share? The elements of out are results of vesica_area_f64.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that exceed
        /// the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the
        /// arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_area_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Intersection over union of a[i] and b[j]. The elements of out are results of vesica_iou_f64.</para>
        /// <para>If neither of a pair has an area, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape
        /// is invalid.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that exceed
        /// the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the
        /// arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_iou_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Which of many shapes overlap one? Their indices are written to out[0], out[1] ..., in ascending
        /// order.</para>
        /// <para>Requires: one, an array of count 1, which is looked at unless many is empty; capacity, how many
        /// indices out has room for. It may be 0, and out then NULL.</para>
        /// <para>Returns: how many there are, even if that exceeds the capacity. If room is left, the entry after the
        /// last is -1.</para>
        /// <para>Errors: VESICA_E_SHAPE if a shape is invalid: it is not selected, and the others are written as usual,
        /// up to the -1 or the capacity. Before anything is written: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT
        /// (one's count is not 1, a negative capacity, and as vesica_overlap_many_f64).</para>
        /// <para>Accuracy: every answer is that of vesica_overlap_f64.</para>
        /// <para>Cost: that of vesica_overlap_many_f64.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_overlap_select_f64(void* one, void* many, void* output, long capacity);

        /// <summary>
        /// <para>How many bytes of scratch do vesica_nms_f64, vesica_suppress_f64 and their float forms need for
        /// `count` shapes?</para>
        /// <para>Returns: 0.4 MB, and for each shape at most 140 bytes, about 97 from 10,000 shapes on.</para>
        /// <para>Errors: VESICA_E_ARGUMENT (a negative count, or one above 2147483647).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_nms_scratch(long count);

        /// <summary>
        /// <para>Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps
        /// each one whose vesica_iou_f64 with every shape kept before is at most the threshold.</para>
        /// <para>Of equal scores the lower index comes first. Infinite scores are legal. At threshold 1 all shapes are
        /// kept. Shapes without an area suppress none and are not suppressed.</para>
        /// <para>Requires: shapes, of a kind from VESICA_CIRCLE to VESICA_ELLIPSE; scores, one for each; threshold from
        /// 0 to 1; scratch, of vesica_nms_scratch bytes or more, with any alignment and content; keep, with room for
        /// all indices.</para>
        /// <para>Returns: 0, with *kept set to how many are kept. keep has their indices in the order of their scores;
        /// the rest of keep is not written.</para>
        /// <para>Errors: VESICA_E_SHAPE if a shape is invalid or its score is NaN: it is left out, and the result of
        /// the others is written. Before anything is written: VESICA_E_NULL (with count 0 all but shapes and kept may
        /// be NULL), VESICA_E_KIND (points and segments too), VESICA_E_ARGUMENT (the array as vesica_overlap_many_f64,
        /// threshold, too little scratch).</para>
        /// <para>Cost: 0.3 to 1.2 us a shape; in a crowd, that of vesica_iou_many_f64 for each pair of a shape and one
        /// that is kept near it: 20,000 in one place, nearly all kept, took 0.5 to 1 ms a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_nms_f64(void* shapes, void* scores, double threshold, void* scratch,
            long scratchSize, void* keep, void* kept);

        /// <summary>
        /// <para>Is a shape valid, and if not, which rule does it break?</para>
        /// <para>Returns: 0 for a valid shape, else the first rule broken: VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE,
        /// VESICA_E_ZERO_AXIS or VESICA_E_INVERTED.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND.</para>
        /// <para>Cost: a few ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_check_f32(int kind, void* numbers);

        /// <summary>
        /// <para>Do two shapes share a point? Touching counts.</para>
        /// <para>Returns: 1 if they do, 0 if not.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: about 2 ns more than the function named after the two kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_overlap_f32(int kindA, void* numbersA, int kindB, void* numbersB);

        /// <summary>
        /// <para>How does a relate to b? The answer is one of the eight relations of the region connection calculus
        /// (RCC-8).</para>
        /// <para>The outline of a shape with area is the curve around it. The outline of a segment, or of a shape with
        /// one size zero, is its two end points. A point, or a shape without any size, has no outline. The inside is
        /// the shape without its outline. If several relations fit, VESICA_EQUAL comes first, then those of
        /// containment, then VESICA_CROSS. So a segment that ends on the middle of another touches it; two segments on
        /// one line that overlap in part cross; a point on the rim of a disc is VESICA_INSIDE_TOUCH. Exchanging the
        /// shapes always gives the converse relation.</para>
        /// <para>Returns: VESICA_DISJOINT ... VESICA_EQUAL. Equal sets are VESICA_EQUAL, whatever kinds and numbers
        /// describe them.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: up to twice that of vesica_overlap_f32; 0.1 to 8 us if shapes touch or are equal; at worst 30
        /// us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_relation_f32(int kindA, void* numbersA, int kindB, void* numbersB);

        /// <summary>
        /// <para>Does a contain all of b? A shape contains itself, and whatever touches its outline from inside.</para>
        /// <para>Returns: 1 if vesica_relation_f32 is VESICA_CONTAINS, VESICA_CONTAINS_TOUCH or VESICA_EQUAL, else
        /// 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: that of vesica_relation_f32.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_contains_f32(int kindA, void* numbersA, int kindB, void* numbersB);

        /// <summary>
        /// <para>Where do the outlines of two shapes meet? Touching counts.</para>
        /// <para>The outline of a shape with area is the curve around it. A segment, a point and a shape without area
        /// are their own outlines. A contact counts as one place, however closely the curves touch there. If straight
        /// outlines share a stretch, its two end points are places, and out-&gt;shared is 1; so equal boxes meet at
        /// their four corners. Two equal curves meet everywhere: then the count is 0 and out-&gt;shared is 1. Places
        /// come in order along a's outline, counter-clockwise in the frame of its axis. The start is a box's corner C -
        /// hx u - hy perp(u), an ellipse's point C + a u (one without area begins as a box), a circle's point C + (r,
        /// 0), or a segment's first end.</para>
        /// <para>Returns: the number of places, 0 to 8.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the number is exact. A place is right to 4 u times the largest coordinate or size of either
        /// shape, even where the outlines nearly coincide. Places closer to one another than that may come in either
        /// order or be equal. Each number is computed in double, within these bounds, and then rounded to float once.
        /// In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest
        /// of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of at
        /// most 4 u times the scale. An aspect ratio is longer over shorter size.</para>
        /// <para>Cost: 1 to 10 us; at worst 30 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_crossings_f32(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>How far apart are two solid shapes, and which of their points are closest?</para>
        /// <para>If the shapes overlap (as vesica_overlap_f32 tells), the distance is 0 and both points are one common
        /// point. If not, the distance is &gt; 0. Exchanging the shapes exchanges the points and changes no bit. Moving
        /// both shapes alike changes no bit of the distance if no coordinate is rounded.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the distance is right to 4 u scale at any aspect ratio; the largest error seen was 1 u
        /// scale, and 3.3 u beside the ends of the thinnest ellipses. Its relative error is at most 2 u above 1e-10
        /// scale (aspect ratios up to 1e6) or 1e-14 scale (up to 1000). Closest points are right to 4 u scale, and a
        /// common point to 8 u scale, before they are rounded. Each number is computed in double, within these bounds,
        /// and then rounded to float once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The
        /// scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right
        /// to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter
        /// size.</para>
        /// <para>Cost: 100 to 250 ns for disjoint shapes, 450 ns for a point and an ellipse, 500 ns for the thinnest
        /// ellipses; 50 ns if a shape holds the other's centre; 0.3 to 3 us for shapes that cross, near-ties and
        /// magnitudes above 2^40 or below 2^-40; at worst 25 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_nearest_f32(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>How far apart are the outlines of two shapes, and where do they come closest?</para>
        /// <para>The outline of a shape with area is the curve around it. A point, a segment and a shape with a zero
        /// size are their own outlines. If outlines meet, the distance is 0 and (ax, ay) = (bx, by) is a point of both.
        /// If shapes are disjoint, the result is that of vesica_nearest_f32. If one is strictly inside the other, the
        /// distance is the least over the whole outline, never a local minimum. Which case holds is decided exactly.
        /// Exchanging the shapes exchanges the points and changes no bit. Moving both shapes alike changes no bit of
        /// the distance if no coordinate is rounded.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: at aspect ratios up to 1e6 the distance is right to 4 u scale, and the points are that far
        /// apart to 16 u scale. At any ratio it is above 0 unless outlines meet, and points are on them to 12 u scale
        /// before they are rounded. Each number is computed in double, within these bounds, and then rounded to float
        /// once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the
        /// largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an
        /// error of at most 4 u times the scale. An aspect ratio is longer over shorter size.</para>
        /// <para>Cost: that of vesica_nearest_f32 for disjoint shapes; 0.1 to 0.5 us for nested ones, for a few 1 us
        /// more; 0.4 to 0.8 us if outlines meet, for thin shapes as vesica_crossings_f32; up to 5 us more for
        /// near-ties; at worst 30 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_boundary_distance_f32(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>Penetration depth: how far and which way must b be moved until the two shapes only touch?</para>
        /// <para>Moving b by out-&gt;depth along the unit vector (x, y) is the shortest translation after which a line
        /// separates the shapes: a on one side, b on the other, where both may touch the line. For disjoint shapes all
        /// three numbers are 0. Overlapping shapes always get a direction. Their depth is 0 if such a line exists
        /// without a move: if they touch from outside, if a point lies on an outline, or if points and segments lie
        /// along one line. Otherwise the depth is &gt; 0. Exchanging the shapes reverses the direction and changes no
        /// other bit, except for two equal shapes in one place. Moving both shapes alike changes no bit if no
        /// coordinate is rounded.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: at aspect ratios up to 1e6 the depth is right to 4 u scale; for circles and points, to its
        /// last place. The length of (x, y) is 1 to 3 u. After the move at most 8 u scale of overlap is left. Whether
        /// the depth is 0 is exact at any ratio; beyond 1e6 no bound on its error is stated. Each number is computed in
        /// double, within these bounds, and then rounded to float once. In bounds on errors u is 2^-53, half a unit in
        /// the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of
        /// their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is
        /// longer over shorter size.</para>
        /// <para>Cost: about 150 ns for points, segments and boxes; 0.5 us with an ellipse, for a few 1 us more; up to
        /// 5 us if only exact arithmetic can tell the depth from 0; at worst 25 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_depth_f32(int kindA, void* numbersA, int kindB, void* numbersB, void* output);

        /// <summary>
        /// <para>Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a
        /// segment.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the double nearest to the true area; a tiny area becomes subnormal or 0. So a shape inside
        /// another never has the greater area, and equal shapes have equal areas, whatever kinds and numbers describe
        /// them. Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: about 20 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_shape_area_f32(int kind, void* numbers, void* output);

        /// <summary>
        /// <para>Area of the intersection of two shapes.</para>
        /// <para>It is exactly 0 if shapes are disjoint, if they only touch, or if one has no area. If one contains the
        /// other, it is the vesica_shape_area_f32 of the inner one. It is never more than the area of either, and more
        /// than 0 if the insides of shapes with area meet, unless that underflows. Exchanging the shapes changes no
        /// bit. Scaling both by a power of two scales the area by its square.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: right to 64 u times the smaller shape's area times the larger aspect ratio, at aspect ratios
        /// up to 10^4, even if the outlines nearly touch or coincide and whatever the sizes are. Beyond 10^4 no bound
        /// is stated; what is said above holds at any ratio. Each number is computed in double, within these bounds,
        /// and then rounded to float once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The
        /// scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right
        /// to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter
        /// size.</para>
        /// <para>Cost: about 50 ns for two boxes, 150 ns for an ellipse and a box, 0.6 us for two ellipses; up to 10 us
        /// if outlines nearly touch or coincide, or if one shape is far larger; at worst 30 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_area_f32(int kindA, void* numbersA, int kindB, void* numbersB, void* output);

        /// <summary>
        /// <para>Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover
        /// together.</para>
        /// <para>It is exactly 1 for equal shapes and exactly 0 for shapes that share no area. Intermediate results
        /// never overflow or underflow. Exchanging the shapes, or scaling both by a power of two, changes no
        /// bit.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (neither shape has an
        /// area).</para>
        /// <para>Accuracy: the bound of vesica_area_f32, divided by the area of the union.
        /// Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: that of vesica_area_f32 and of vesica_shape_area_f32 twice.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_iou_f32(int kindA, void* numbersA, int kindB, void* numbersB, void* output);

        /// <summary>
        /// <para>Smallest box of representable numbers that contains a shape.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: each side is the true extreme of the shape, rounded outward once. So a representable box is
        /// exact.</para>
        /// <para>Cost: up to 80 ns; 1 to 3 us for magnitudes above 2^400 or below 2^-400, and for an ellipse with an
        /// oblique axis and representable sides; at worst 6 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_bounds_f32(int kind, void* numbers, void* output);

        /// <summary>
        /// <para>Box with two opposite corners, in any order.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_aabb_from_corners_f32(float x0, float y0, float x1, float y1, void* output);

        /// <summary>
        /// <para>Rectangle from centre, angle and full size: width along the angle, height across it.</para>
        /// <para>Requires: the angle in radians, counter-clockwise from +x if y points up; width, height &gt;=
        /// 0.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.</para>
        /// <para>Accuracy: the axis is (cos, sin), each right to 1 unit in the last place. No double is exactly pi/2,
        /// so a quarter turn has an exact axis only by vesica_rects_from_boxes_f32, which takes degrees too. Sizes are
        /// exact: if halving one would round (an odd multiple of the smallest subnormal number), the axis is halved
        /// instead.</para>
        /// <para>Cost: about 40 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_rect_from_angle_f32(float cx, float cy, float angle, float width,
            float height, void* output);

        /// <summary>
        /// <para>Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.</para>
        /// <para>Corners that are not exactly a rectangle's give a rectangle near them, which need not contain them.
        /// The centre is the mean of the corners. The axis is a unit vector along the edge from corner 0 to corner 1,
        /// and hx belongs to that edge. Opposite edges are averaged; the longer pair gives the direction, and the
        /// shorter pair counts by its part across it. Two or four equal corners are legal: they give a segment, or a
        /// point with axis (1, 0).</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_RANGE (a half extent overflows).</para>
        /// <para>Accuracy: half extents, and the axis times the longer one, are right to 8 units in the last place of
        /// the longer one; the centre is right to 1 unit in its own. Both errors may grow by 2^-98 times the largest
        /// coordinate. A rectangle along the coordinate axes is found exactly if its centre and half extents are
        /// representable.</para>
        /// <para>Cost: about 110 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_rect_from_corners_f32(void* corners, void* output);

        /// <summary>
        /// <para>Ellipse from centre, angle and half lengths: a along the angle, b across it.</para>
        /// <para>Requires: the angle in radians, counter-clockwise from +x if y points up; a, b &gt;= 0.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.</para>
        /// <para>Accuracy: the axis is that of vesica_rect_from_angle_f32; half lengths are exact.</para>
        /// <para>Cost: about 40 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ellipse_from_angle_f32(float cx, float cy, float angle, float a, float b,
            void* output);

        /// <summary>
        /// <para>Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times
        /// perp(wx, wy).</para>
        /// <para>A zero vector gives the point (cx, cy).</para>
        /// <para>Requires: ratio &gt;= 0.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ellipse_from_radius_vector_f32(float cx, float cy, float wx, float wy,
            float ratio, void* output);

        /// <summary>
        /// <para>Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).</para>
        /// <para>A singular covariance, or k = 0, gives a segment or a point. The result has a &gt;= b. Its axis is a
        /// unit vector with x &gt;= 0, or (1, 0) for equal variances without correlation.</para>
        /// <para>Requires: the covariance cxx, cxy, cyy (units squared) positive semidefinite: cxy^2 &lt;= cxx cyy as
        /// stored; k &gt;= 0.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE (k &lt; 0), VESICA_E_ARGUMENT (not
        /// a covariance), VESICA_E_RANGE (a half length overflows).</para>
        /// <para>Accuracy: half lengths and both components of the axis are right to 8 units in their own last place,
        /// even if the matrix is nearly singular or nearly a circle's.</para>
        /// <para>Cost: about 90 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ellipse_from_covariance_f32(float meanX, float meanY, float cxx, float cxy,
            float cyy, float k, void* output);

        /// <summary>
        /// <para>Ellipse of the points X with (X - C) . M (X - C) &lt;= 1, where M is symmetric with entries mxx, mxy,
        /// myy.</para>
        /// <para>The result is that of vesica_ellipse_from_covariance_f32 for the inverse of M and k = 1.</para>
        /// <para>Requires: M positive definite as stored.</para>
        /// <para>Returns: 0; the shape is valid.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (not positive definite).</para>
        /// <para>Accuracy: that of vesica_ellipse_from_covariance_f32. No half length overflows.</para>
        /// <para>Cost: about 90 ns.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ellipse_from_matrix_f32(float cx, float cy, float mxx, float mxy, float myy,
            void* output);

        /// <summary>
        /// <para>Do a[i] and b[i] share a point? out[i] is the answer of vesica_overlap_f32.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: in cache, from columns, with AVX-512: 0.5 to 2 ns a pair in double, 0.3 to 0.8 ns in float;
        /// about half of that if one array is a single shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_overlap_many_f32(void* a, void* b, void* output);

        /// <summary>
        /// <para>How does a[i] relate to b[i]? out[i] is the answer of vesica_relation_f32.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many are not VESICA_DISJOINT.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_relation_many_f32(void* a, void* b, void* output);

        /// <summary>
        /// <para>Does a[i] contain all of b[i]? out[i] is the answer of vesica_contains_f32.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_contains_many_f32(void* a, void* b, void* output);

        /// <summary>
        /// <para>How far apart are a[i] and b[i], and where? The columns are the fields of vesica_nearest_f32's
        /// result.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many pairs overlap (distance 0).</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_nearest_many_f32(void* a, void* b, void* distance, void* ax, void* ay,
            void* bx, void* by);

        /// <summary>
        /// <para>How far apart are the outlines of a[i] and b[i]? The columns are the fields of
        /// vesica_boundary_distance_f32's result.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many pairs of outlines meet (distance 0).</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_boundary_distance_many_f32(void* a, void* b, void* distance, void* ax,
            void* ay, void* bx, void* by);

        /// <summary>
        /// <para>How deep do a[i] and b[i] overlap? The columns are the fields of vesica_depth_f32's result.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many depths are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_depth_many_f32(void* a, void* b, void* depth, void* x, void* y);

        /// <summary>
        /// <para>What area do a[i] and b[i] share? out[i] is the result of vesica_area_f32.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many areas are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_area_many_f32(void* a, void* b, void* output);

        /// <summary>
        /// <para>Intersection over union of a[i] and b[i]: out[i] is the result of vesica_iou_f32.</para>
        /// <para>If neither of a pair has an area, out[i] is NaN, and the call returns VESICA_E_ARGUMENT unless a shape
        /// is invalid.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count, or for none if a count is 0. Of several output columns some, but not all,
        /// may be NULL.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL),
        /// VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree, reserved is not 0, or an array
        /// that exceeds the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: a pair takes a fifth of the time of the function for two shapes to about as much, and up to 30
        /// ns more where numbers are copied first (docs/benchmarks.md).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_iou_many_f32(void* a, void* b, void* output);

        /// <summary>
        /// <para>Do a[i] and b[j] share a point? Answers as of vesica_overlap_f32; much quicker if both arrays are in
        /// spatial order.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that exceed
        /// the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the
        /// arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_overlap_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>How does a[i] relate to b[j]? The elements of out are answers of vesica_relation_f32.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are not VESICA_DISJOINT.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that exceed
        /// the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the
        /// arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_relation_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Does a[i] contain all of b[j]? The elements of out are answers of vesica_contains_f32.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that exceed
        /// the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the
        /// arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_contains_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>What area do a[i] and b[j] share? The elements of out are results of vesica_area_f32.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that exceed
        /// the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the
        /// arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_area_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Intersection over union of a[i] and b[j]. The elements of out are results of vesica_iou_f32.</para>
        /// <para>If neither of a pair has an area, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape
        /// is invalid.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's
        /// results would overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual.
        /// Before anything is written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows that overlap, or an array or rows that exceed
        /// the address space).</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Cost: for each pair at most as in a batch of one shape against many, whatever the size of the
        /// arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_iou_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Which of many shapes overlap one? Their indices are written to out[0], out[1] ..., in ascending
        /// order.</para>
        /// <para>Requires: one, an array of count 1, which is looked at unless many is empty; capacity, how many
        /// indices out has room for. It may be 0, and out then NULL.</para>
        /// <para>Returns: how many there are, even if that exceeds the capacity. If room is left, the entry after the
        /// last is -1.</para>
        /// <para>Errors: VESICA_E_SHAPE if a shape is invalid: it is not selected, and the others are written as usual,
        /// up to the -1 or the capacity. Before anything is written: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT
        /// (one's count is not 1, a negative capacity, and as vesica_overlap_many_f32).</para>
        /// <para>Accuracy: every answer is that of vesica_overlap_f32.</para>
        /// <para>Cost: that of vesica_overlap_many_f32.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_overlap_select_f32(void* one, void* many, void* output, long capacity);

        /// <summary>
        /// <para>Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps
        /// each one whose vesica_iou_f32 with every shape kept before is at most the threshold.</para>
        /// <para>Of equal scores the lower index comes first. Infinite scores are legal. At threshold 1 all shapes are
        /// kept. Shapes without an area suppress none and are not suppressed.</para>
        /// <para>Requires: shapes, of a kind from VESICA_CIRCLE to VESICA_ELLIPSE; scores, one for each; threshold from
        /// 0 to 1; scratch, of vesica_nms_scratch bytes or more, with any alignment and content; keep, with room for
        /// all indices.</para>
        /// <para>Returns: 0, with *kept set to how many are kept. keep has their indices in the order of their scores;
        /// the rest of keep is not written.</para>
        /// <para>Errors: VESICA_E_SHAPE if a shape is invalid or its score is NaN: it is left out, and the result of
        /// the others is written. Before anything is written: VESICA_E_NULL (with count 0 all but shapes and kept may
        /// be NULL), VESICA_E_KIND (points and segments too), VESICA_E_ARGUMENT (the array as vesica_overlap_many_f32,
        /// threshold, too little scratch).</para>
        /// <para>Cost: 0.3 to 1.2 us a shape; in a crowd, that of vesica_iou_many_f32 for each pair of a shape and one
        /// that is kept near it: 20,000 in one place, nearly all kept, took 0.5 to 1 ms a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_nms_f32(void* shapes, void* scores, float threshold, void* scratch,
            long scratchSize, void* keep, void* kept);

        /// <summary>
        /// <para>Rectangles from boxes.</para>
        /// <para>Requires: boxes, `count` rows of five numbers with any alignment, `stride` bytes apart; angle, a unit
        /// of angles, or its sum with VESICA_ANGLE_REVERSED; out, room for `count`.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would
        /// overflow: all numbers of that result are NaN, and all other results are written as usual. Before anything is
        /// written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array that exceeds the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: the axis is (cos, sin), each right to 1.1 units in the last place. Degrees that are
        /// multiples of 90, and whole quarter turns, give exact axes. Sizes are those of
        /// vesica_rect_from_angle_f64.</para>
        /// <para>Cost: about 30 ns a box.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_rects_from_boxes_f64(void* boxes, long count, IntPtr stride, int angle,
            void* output);

        /// <summary>
        /// <para>Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.</para>
        /// <para>Requires: as vesica_rects_from_boxes_f64.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would
        /// overflow: all numbers of that result are NaN, and all other results are written as usual. Before anything is
        /// written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array that exceeds the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: as vesica_rects_from_boxes_f64. Half lengths are halves of width and height.</para>
        /// <para>Cost: about 30 ns a box.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_ellipses_from_boxes_f64(void* boxes, long count, IntPtr stride, int angle,
            void* output);

        /// <summary>
        /// <para>Boxes from rectangles or from ellipses: the inverse of the two functions above.</para>
        /// <para>Angles are from -180 to 180 degrees, in the unit asked for.</para>
        /// <para>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; angle as vesica_rects_from_boxes_f64; boxes,
        /// room for `count` rows of five numbers, without gaps.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would
        /// overflow: all numbers of that result are NaN, and all other results are written as usual. Before anything is
        /// written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array that exceeds the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: width and height are right to 4 units in the last place, and the angle to 2 units in the
        /// last place of a quarter turn. If an axis lies exactly along a coordinate axis, degrees and quarter turns are
        /// exact.</para>
        /// <para>Cost: about 70 ns a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_boxes_from_shapes_f64(void* shapes, int angle, void* boxes);

        /// <summary>
        /// <para>The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.</para>
        /// <para>The first corner is C - hx u - hy perp(u), the next C + hx u - hy perp(u), and so on round the
        /// outline.</para>
        /// <para>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; corners, room for `count` rows of eight
        /// numbers.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would
        /// overflow: all numbers of that result are NaN, and all other results are written as usual. Before anything is
        /// written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array that exceeds the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: a coordinate is right to 1 unit in its last place plus 2^-98 times the largest of its three
        /// terms.</para>
        /// <para>Cost: about 50 ns a shape; 20 ns with AVX2 or AVX-512.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_corners_of_shapes_f64(void* shapes, void* corners);

        /// <summary>
        /// <para>Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f64.</para>
        /// <para>Requires: out, room for `count`.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would
        /// overflow: all numbers of that result are NaN, and all other results are written as usual. Before anything is
        /// written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array that exceeds the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: that of vesica_bounds_f64.</para>
        /// <para>Cost: that of vesica_bounds_f64; with AVX2 or AVX-512 about 10 ns for shapes of which that takes up to
        /// 80.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_bounds_many_f64(void* shapes, void* output);

        /// <summary>
        /// <para>Rectangles from boxes.</para>
        /// <para>Requires: boxes, `count` rows of five numbers with any alignment, `stride` bytes apart; angle, a unit
        /// of angles, or its sum with VESICA_ANGLE_REVERSED; out, room for `count`.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would
        /// overflow: all numbers of that result are NaN, and all other results are written as usual. Before anything is
        /// written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array that exceeds the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: the axis is (cos, sin), each right to 1.1 units in the last place. Degrees that are
        /// multiples of 90, and whole quarter turns, give exact axes. Sizes are those of vesica_rect_from_angle_f32.
        /// Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: about 30 ns a box.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_rects_from_boxes_f32(void* boxes, long count, IntPtr stride, int angle,
            void* output);

        /// <summary>
        /// <para>Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.</para>
        /// <para>Requires: as vesica_rects_from_boxes_f32.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would
        /// overflow: all numbers of that result are NaN, and all other results are written as usual. Before anything is
        /// written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array that exceeds the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: as vesica_rects_from_boxes_f32. Half lengths are halves of width and height.
        /// Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: about 30 ns a box.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_ellipses_from_boxes_f32(void* boxes, long count, IntPtr stride, int angle,
            void* output);

        /// <summary>
        /// <para>Boxes from rectangles or from ellipses: the inverse of the two functions above.</para>
        /// <para>Angles are from -180 to 180 degrees, in the unit asked for.</para>
        /// <para>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; angle as vesica_rects_from_boxes_f32; boxes,
        /// room for `count` rows of five numbers, without gaps.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would
        /// overflow: all numbers of that result are NaN, and all other results are written as usual. Before anything is
        /// written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array that exceeds the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: width and height are right to 4 units in the last place, and the angle to 2 units in the
        /// last place of a quarter turn. If an axis lies exactly along a coordinate axis, degrees and quarter turns are
        /// exact. Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: about 70 ns a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_boxes_from_shapes_f32(void* shapes, int angle, void* boxes);

        /// <summary>
        /// <para>The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.</para>
        /// <para>The first corner is C - hx u - hy perp(u), the next C + hx u - hy perp(u), and so on round the
        /// outline.</para>
        /// <para>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; corners, room for `count` rows of eight
        /// numbers.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would
        /// overflow: all numbers of that result are NaN, and all other results are written as usual. Before anything is
        /// written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array that exceeds the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: a coordinate is right to 1 unit in its last place plus 2^-98 times the largest of its three
        /// terms. Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: about 50 ns a shape; 20 ns with AVX2 or AVX-512.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_corners_of_shapes_f32(void* shapes, void* corners);

        /// <summary>
        /// <para>Bounding boxes of an array of any kind: out[i] is the result of vesica_bounds_f32.</para>
        /// <para>Requires: out, room for `count`.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would
        /// overflow: all numbers of that result are NaN, and all other results are written as usual. Before anything is
        /// written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array that exceeds the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: that of vesica_bounds_f32.</para>
        /// <para>Cost: that of vesica_bounds_f32; with AVX2 or AVX-512 about 10 ns for shapes of which that takes up to
        /// 80.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_bounds_many_f32(void* shapes, void* output);

        /// <summary>
        /// <para>How many bytes suffice for an index of `count` shapes, of any kinds?</para>
        /// <para>Returns: 17 bytes a shape and 64 KiB. A built index takes fewer, mostly 13 a shape: see
        /// vesica_index_bytes.</para>
        /// <para>Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_size(long count);

        /// <summary>
        /// <para>How many bytes of scratch does building an index of `count` shapes need?</para>
        /// <para>Returns: about 17 bytes a shape and 0.3 MiB.</para>
        /// <para>Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_scratch(long count);

        /// <summary>
        /// <para>How many bytes of scratch does a join need, whatever its indexes?</para>
        /// <para>Returns: at most 1 MiB.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_join_scratch();

        /// <summary>
        /// <para>Are these bytes an index that is safe to read?</para>
        /// <para>Call it once for bytes that you did not just build: they may be cut off, damaged, something else, or
        /// from a machine of the other byte order. What passes is safe to read; damage of single shapes' places may
        /// pass and change answers.</para>
        /// <para>Requires: size, the number of readable bytes. The index may be shorter.</para>
        /// <para>Returns: 0 if they are.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (they are
        /// not).</para>
        /// <para>Cost: it reads all bytes once.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_index_check(void* index, long size);

        /// <summary>
        /// <para>How many bytes does a built index take? Save that many.</para>
        /// <para>Returns: the bytes, a multiple of 64.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (not an index's
        /// header).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_bytes(void* index);

        /// <summary>
        /// <para>How many shapes was an index built from?</para>
        /// <para>Returns: the number of its items, including invalid shapes.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (not an index's
        /// header).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_count(void* index);

        /// <summary>
        /// <para>A box around all valid shapes of an index.</para>
        /// <para>Two indexes whose boxes are disjoint have no overlapping pairs.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (not an index's
        /// header).</para>
        /// <para>Accuracy: the box is a little larger than the smallest one; a side that overflows is infinite. Without
        /// valid shapes min is infinity and max is -infinity.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_index_bounds(void* index, void* output);

        /// <summary>
        /// <para>The items of an index in spatial order: shapes near each other have nearby places in it.</para>
        /// <para>A join is faster if the arrays of shapes have this order, as it then reads nearby memory.</para>
        /// <para>Requires: out has room for `capacity` items. It may be NULL if that is 0.</para>
        /// <para>Returns: how many items there are, without the invalid shapes. The first `capacity` of them are
        /// written.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned, capacity &lt; 0),
        /// VESICA_E_INDEX.</para>
        /// <para>Cost: a few ns an item.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_order(void* index, void* output, long capacity);

        /// <summary>
        /// <para>Builds the index of some sets of shapes. There may be none; sets may then be NULL.</para>
        /// <para>If shapes are invalid, the call returns VESICA_E_SHAPE, and the index is complete without them. When
        /// shapes have moved, build it again.</para>
        /// <para>Requires: index_size &gt;= vesica_index_size(items) and scratch_size &gt;=
        /// vesica_index_scratch(items). The scratch may be reused after the call.</para>
        /// <para>Returns: how many bytes of the index are used.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a wrong count, size or alignment),
        /// VESICA_E_SHAPE.</para>
        /// <para>Cost: 30 to 50 ns a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_build_f64(void* sets, int setCount, void* index, long indexSize,
            void* scratch, long scratchSize);

        /// <summary>
        /// <para>Which items of an index does one shape overlap? They come in the index's order.</para>
        /// <para>To ask for many shapes, index them too and call vesica_join_f64.</para>
        /// <para>Requires: sets are those of the index; or NULL, with set_count 0, to find the items whose bounds meet
        /// the shape's. Bounds are those in the index, up to about 2^-15 of the extent of nearby shapes larger than
        /// vesica_bounds_f64's. one, an array of count 1. out has room for `capacity` items. With capacity 0, out and
        /// state may be NULL.</para>
        /// <para>Returns: the number of items written; with capacity 0, how many there are.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, the sets have another
        /// number of items than the index, the state is from another function, part, parts or query). Other sets, and
        /// states of calls with other shapes or distances, are not noticed: answers are then meaningless.</para>
        /// <para>Accuracy: exact, if there are sets.</para>
        /// <para>Cost: about 0.5 us for a few shapes that are found, 2 us for 1,000 boxes.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_select_f64(void* index, void* sets, int setCount, void* one,
            void* output, long capacity, void* state);

        /// <summary>
        /// <para>Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair
        /// once.</para>
        /// <para>If both indexes are the same pointer, pairs are those of two different items a &lt; b:
        /// VESICA_JOIN_CONTAINS then finds those of which the lower item contains the higher one, _INSIDE the others.
        /// Pair i is out_a[i] and out_b[i]. The order of pairs depends on the bytes of the indexes and the query alone.
        /// The work may be divided into `parts` of about equal work, which may run at the same time, each with its own
        /// scratch. The pairs of all parts, one part after the other, are those of a call with part 0 and parts
        /// 1.</para>
        /// <para>Requires: query is VESICA_JOIN_OVERLAP ... VESICA_JOIN_INSIDE. sets_a and sets_b are those of the
        /// indexes; with VESICA_JOIN_BOUNDS they are ignored. 0 &lt;= part &lt; parts. scratch_size &gt;=
        /// vesica_join_scratch(); nothing is kept in the scratch between calls. out_a and out_b have room for
        /// `capacity` items. With capacity 0, they and state may be NULL.</para>
        /// <para>Returns: the number of pairs written; with capacity 0, how many the whole part has.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_ARGUMENT (an unknown query, a number or
        /// a size out of range, a pointer that is not aligned, sets of another number of items, a state from another
        /// function).</para>
        /// <para>Accuracy: exact for all queries but VESICA_JOIN_BOUNDS.</para>
        /// <para>Cost: 10 to 15 ns a shape to find candidates, and 15 to 25 ns a candidate to decide.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_join_f64(int query, void* indexA, void* setsA, int setCountA, void* indexB,
            void* setsB, int setCountB, long part, long parts, void* scratch, long scratchSize, void* outA, void* outB,
            long capacity, void* state);

        /// <summary>
        /// <para>All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair
        /// once: those for which vesica_within_f64 is &gt; 0.</para>
        /// <para>If both indexes are the same pointer, pairs are those of two different items a &lt; b. They come in
        /// index_a's order. Each part takes about the same number of items of index_a; all else is as for
        /// vesica_join_f64.</para>
        /// <para>Requires: distance &gt;= 0, or infinity for all pairs of valid shapes; sets, part, outputs, capacity
        /// and state as vesica_join_f64.</para>
        /// <para>Returns: the number of pairs written; with capacity 0, how many the whole part has.</para>
        /// <para>Errors: those of vesica_join_f64; VESICA_E_ARGUMENT also for a distance that is negative or
        /// NaN.</para>
        /// <para>Accuracy: that of vesica_within_f64; pairs that are VESICA_WITHIN_NEARLY are included.</para>
        /// <para>Cost: about 1 us a shape of index_a, and that of vesica_within_f64 a candidate: seven times that of
        /// vesica_join_f64.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_join_within_f64(void* indexA, void* setsA, int setCountA, void* indexB,
            void* setsB, int setCountB, double distance, long part, long parts, void* outA, void* outB, long capacity,
            void* state);

        /// <summary>
        /// <para>Which items of an index are nearest to one shape? The nearest comes first, of equally near ones the
        /// lower item.</para>
        /// <para>An item that overlaps the shape has distance 0. An item whose distance overflows is not found.</para>
        /// <para>Requires: sets are those of the index. one, an array of count 1. k &gt;= 0, and out and distance have
        /// room for k each. With k = 0 they may be NULL. within, the largest distance to look for, &gt;= 0 or
        /// infinity.</para>
        /// <para>Returns: how many items were found and written; with k = 0, how many there are within the
        /// distance.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, the sets have another
        /// number of items than the index, the state is from another function, part, parts or query). Other sets, and
        /// states of calls with other shapes or distances, are not noticed: answers are then meaningless.</para>
        /// <para>Accuracy: distances are those of vesica_nearest_f64, bit for bit.</para>
        /// <para>Cost: 3 to 5 us for 10 of a million AABBs near a point; mostly that of vesica_nearest_f64 for some 10
        /// more than k. Of items that overlap the shape all are asked, as the lowest come first.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_nearest_f64(void* index, void* sets, int setCount, void* one, long k,
            double within, void* output, void* distance);

        /// <summary>
        /// <para>Which items of index_b are nearest to each item of sets_a? Row i is out[i * k] ... out[i * k + k -
        /// 1].</para>
        /// <para>A row is the result of vesica_index_nearest_f64 for item i. If it has fewer than k items, the rest are
        /// -1 with distance infinity. If a set is asked for its own neighbours, each item finds itself too, at distance
        /// 0, unless k lower items overlap it. If an item of sets_a is invalid, its row holds -1, all other rows are
        /// right, and the call returns VESICA_E_SHAPE. Each part takes about the same number of items, and writes only
        /// their rows.</para>
        /// <para>Requires: sets_b are those of index_b. k &gt;= 1, and out and distance have room for k items a row. If
        /// sets_a have no items, they may be NULL. 0 &lt;= part &lt; parts. within, the largest distance to look for,
        /// &gt;= 0 or infinity.</para>
        /// <para>Returns: how many items were found in all rows of the part.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, the sets have another
        /// number of items than the index, the state is from another function, part, parts or query). Other sets, and
        /// states of calls with other shapes or distances, are not noticed: answers are then meaningless.</para>
        /// <para>Accuracy: distances are those of vesica_nearest_f64, bit for bit.</para>
        /// <para>Cost: that of vesica_index_nearest_f64 for each item.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_join_nearest_f64(void* setsA, int setCountA, void* indexB, void* setsB,
            int setCountB, long k, double within, long part, long parts, void* output, void* distance);

        /// <summary>
        /// <para>Builds the index of some sets of shapes. There may be none; sets may then be NULL.</para>
        /// <para>If shapes are invalid, the call returns VESICA_E_SHAPE, and the index is complete without them. When
        /// shapes have moved, build it again.</para>
        /// <para>Requires: index_size &gt;= vesica_index_size(items) and scratch_size &gt;=
        /// vesica_index_scratch(items). The scratch may be reused after the call.</para>
        /// <para>Returns: how many bytes of the index are used.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a wrong count, size or alignment),
        /// VESICA_E_SHAPE.</para>
        /// <para>Cost: 30 to 50 ns a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_build_f32(void* sets, int setCount, void* index, long indexSize,
            void* scratch, long scratchSize);

        /// <summary>
        /// <para>Which items of an index does one shape overlap? They come in the index's order.</para>
        /// <para>To ask for many shapes, index them too and call vesica_join_f32.</para>
        /// <para>Requires: sets are those of the index; or NULL, with set_count 0, to find the items whose bounds meet
        /// the shape's. Bounds are those in the index, up to about 2^-15 of the extent of nearby shapes larger than
        /// vesica_bounds_f32's. one, an array of count 1. out has room for `capacity` items. With capacity 0, out and
        /// state may be NULL.</para>
        /// <para>Returns: the number of items written; with capacity 0, how many there are.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, the sets have another
        /// number of items than the index, the state is from another function, part, parts or query). Other sets, and
        /// states of calls with other shapes or distances, are not noticed: answers are then meaningless.</para>
        /// <para>Accuracy: exact, if there are sets.</para>
        /// <para>Cost: about 0.5 us for a few shapes that are found, 2 us for 1,000 boxes.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_select_f32(void* index, void* sets, int setCount, void* one,
            void* output, long capacity, void* state);

        /// <summary>
        /// <para>Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair
        /// once.</para>
        /// <para>If both indexes are the same pointer, pairs are those of two different items a &lt; b:
        /// VESICA_JOIN_CONTAINS then finds those of which the lower item contains the higher one, _INSIDE the others.
        /// Pair i is out_a[i] and out_b[i]. The order of pairs depends on the bytes of the indexes and the query alone.
        /// The work may be divided into `parts` of about equal work, which may run at the same time, each with its own
        /// scratch. The pairs of all parts, one part after the other, are those of a call with part 0 and parts
        /// 1.</para>
        /// <para>Requires: query is VESICA_JOIN_OVERLAP ... VESICA_JOIN_INSIDE. sets_a and sets_b are those of the
        /// indexes; with VESICA_JOIN_BOUNDS they are ignored. 0 &lt;= part &lt; parts. scratch_size &gt;=
        /// vesica_join_scratch(); nothing is kept in the scratch between calls. out_a and out_b have room for
        /// `capacity` items. With capacity 0, they and state may be NULL.</para>
        /// <para>Returns: the number of pairs written; with capacity 0, how many the whole part has.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_ARGUMENT (an unknown query, a number or
        /// a size out of range, a pointer that is not aligned, sets of another number of items, a state from another
        /// function).</para>
        /// <para>Accuracy: exact for all queries but VESICA_JOIN_BOUNDS.</para>
        /// <para>Cost: 10 to 15 ns a shape to find candidates, and 15 to 25 ns a candidate to decide.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_join_f32(int query, void* indexA, void* setsA, int setCountA, void* indexB,
            void* setsB, int setCountB, long part, long parts, void* scratch, long scratchSize, void* outA, void* outB,
            long capacity, void* state);

        /// <summary>
        /// <para>All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair
        /// once: those for which vesica_within_f32 is &gt; 0.</para>
        /// <para>If both indexes are the same pointer, pairs are those of two different items a &lt; b. They come in
        /// index_a's order. Each part takes about the same number of items of index_a; all else is as for
        /// vesica_join_f32.</para>
        /// <para>Requires: distance &gt;= 0, or infinity for all pairs of valid shapes; sets, part, outputs, capacity
        /// and state as vesica_join_f32.</para>
        /// <para>Returns: the number of pairs written; with capacity 0, how many the whole part has.</para>
        /// <para>Errors: those of vesica_join_f32; VESICA_E_ARGUMENT also for a distance that is negative or
        /// NaN.</para>
        /// <para>Accuracy: that of vesica_within_f32; pairs that are VESICA_WITHIN_NEARLY are included.</para>
        /// <para>Cost: about 1 us a shape of index_a, and that of vesica_within_f32 a candidate: seven times that of
        /// vesica_join_f32.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_join_within_f32(void* indexA, void* setsA, int setCountA, void* indexB,
            void* setsB, int setCountB, float distance, long part, long parts, void* outA, void* outB, long capacity,
            void* state);

        /// <summary>
        /// <para>Which items of an index are nearest to one shape? The nearest comes first, of equally near ones the
        /// lower item.</para>
        /// <para>An item that overlaps the shape has distance 0. An item whose distance overflows is not found.</para>
        /// <para>Requires: sets are those of the index. one, an array of count 1. k &gt;= 0, and out and distance have
        /// room for k each. With k = 0 they may be NULL. within, the largest distance to look for, &gt;= 0 or
        /// infinity.</para>
        /// <para>Returns: how many items were found and written; with k = 0, how many there are within the
        /// distance.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, the sets have another
        /// number of items than the index, the state is from another function, part, parts or query). Other sets, and
        /// states of calls with other shapes or distances, are not noticed: answers are then meaningless.</para>
        /// <para>Accuracy: distances are those of vesica_nearest_f32, bit for bit.</para>
        /// <para>Cost: 3 to 5 us for 10 of a million AABBs near a point; mostly that of vesica_nearest_f32 for some 10
        /// more than k. Of items that overlap the shape all are asked, as the lowest come first.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_nearest_f32(void* index, void* sets, int setCount, void* one, long k,
            float within, void* output, void* distance);

        /// <summary>
        /// <para>Which items of index_b are nearest to each item of sets_a? Row i is out[i * k] ... out[i * k + k -
        /// 1].</para>
        /// <para>A row is the result of vesica_index_nearest_f32 for item i. If it has fewer than k items, the rest are
        /// -1 with distance infinity. If a set is asked for its own neighbours, each item finds itself too, at distance
        /// 0, unless k lower items overlap it. If an item of sets_a is invalid, its row holds -1, all other rows are
        /// right, and the call returns VESICA_E_SHAPE. Each part takes about the same number of items, and writes only
        /// their rows.</para>
        /// <para>Requires: sets_b are those of index_b. k &gt;= 1, and out and distance have room for k items a row. If
        /// sets_a have no items, they may be NULL. 0 &lt;= part &lt; parts. within, the largest distance to look for,
        /// &gt;= 0 or infinity.</para>
        /// <para>Returns: how many items were found in all rows of the part.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, the sets have another
        /// number of items than the index, the state is from another function, part, parts or query). Other sets, and
        /// states of calls with other shapes or distances, are not noticed: answers are then meaningless.</para>
        /// <para>Accuracy: distances are those of vesica_nearest_f32, bit for bit.</para>
        /// <para>Cost: that of vesica_index_nearest_f32 for each item.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_join_nearest_f32(void* setsA, int setCountA, void* indexB, void* setsB,
            int setCountB, long k, float within, long part, long parts, void* output, void* distance);

        /// <summary>
        /// <para>A ratio by which detections are compared: IoU and its relatives, as `ratio` says.</para>
        /// <para>The first four ratios are from 0 to 1. Shared area over one shape's is 0 if no area is shared, and 1
        /// if the other shape contains it. The last three are at most the IoU, and at least -1 (CIoU: -2). The angle of
        /// a shape in CIoU is that of the vector (half length across its axis, half length along it); v is 0 if a shape
        /// has no size. Exchanging the shapes exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the
        /// others.</para>
        /// <para>Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (ratio is no such constant;
        /// the area to divide by is 0; or, for GIoU, DIoU and CIoU, neither shape has an area).</para>
        /// <para>Accuracy: computed from the result of vesica_area_f64 or vesica_iou_f64 with at most 8 u of further
        /// error, for half lengths from 2^-200 to 2^200. In bounds on errors u is 2^-53, half a unit in the last place
        /// of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
        /// lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over
        /// shorter size.</para>
        /// <para>Cost: that of vesica_area_f64 or vesica_iou_f64, and 100 to 150 ns more; in arrays 40 to 100 ns
        /// more.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ratio_f64(int ratio, int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f64.</para>
        /// <para>Arrays and errors are those of vesica_iou_many_f64. If a pair has no ratio because an area is 0,
        /// out[i] is NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.</para>
        /// <para>Accuracy: every result has the same bits as vesica_ratio_f64, on every instruction set and in every
        /// layout.</para>
        /// <para>Cost: that of vesica_iou_many_f64, and 40 to 100 ns a pair.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_ratio_many_f64(int ratio, void* a, void* b, void* output);

        /// <summary>
        /// <para>A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f64.</para>
        /// <para>Arrays, row_stride and errors are those of vesica_iou_matrix_f64. If a pair has no ratio because an
        /// area is 0, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.</para>
        /// <para>Accuracy: every result has the same bits as vesica_ratio_f64, on every instruction set and in every
        /// layout.</para>
        /// <para>Cost: that of vesica_iou_many_f64, and 40 to 100 ns a pair.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_ratio_matrix_f64(int ratio, void* a, void* b, void* output,
            IntPtr rowStride);

        /// <summary>
        /// <para>How far apart are a[i] and b[j]? The elements of out are distances of vesica_nearest_f64.</para>
        /// <para>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f64.</para>
        /// <para>Returns: how many pairs overlap (distance 0).</para>
        /// <para>Errors: as vesica_iou_matrix_f64.</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_nearest_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>How far apart are the outlines of a[i] and b[j]? The elements of out are distances of
        /// vesica_boundary_distance_f64.</para>
        /// <para>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f64.</para>
        /// <para>Returns: how many pairs of outlines meet (distance 0).</para>
        /// <para>Errors: as vesica_iou_matrix_f64.</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_boundary_distance_matrix_f64(void* a, void* b, void* output,
            IntPtr rowStride);

        /// <summary>
        /// <para>How deep do a[i] and b[j] overlap? The elements of out are depths of vesica_depth_f64.</para>
        /// <para>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f64.</para>
        /// <para>Returns: how many depths are &gt; 0.</para>
        /// <para>Errors: as vesica_iou_matrix_f64.</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_depth_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Signed distance: how far apart are two shapes or, as a negative number, how deep do they
        /// overlap?</para>
        /// <para>It is the distance of vesica_nearest_f64 if they are disjoint, else minus the depth of
        /// vesica_depth_f64: 0 if they only touch. Exchanging the shapes changes no bit.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the same bits as vesica_nearest_f64 or, negated, vesica_depth_f64. The sign is exact.</para>
        /// <para>Cost: that of vesica_nearest_f64 or vesica_depth_f64.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_signed_distance_f64(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>Signed distances of a[i] and b[i]. Arrays and errors are those of vesica_iou_many_f64.</para>
        /// <para>Returns: how many pairs overlap (signed distance &lt;= 0).</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the same bits as vesica_nearest_f64 or, negated, vesica_depth_f64. The sign is exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_signed_distance_many_f64(void* a, void* b, void* output);

        /// <summary>
        /// <para>Signed distances of a[i] and b[j]. Arrays, row_stride and errors are those of
        /// vesica_iou_matrix_f64.</para>
        /// <para>Returns: how many pairs overlap (signed distance &lt;= 0).</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the same bits as vesica_nearest_f64 or, negated, vesica_depth_f64. The sign is exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_signed_distance_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Are two shapes at most `distance` apart? A distance of exactly that counts, as touching does.</para>
        /// <para>With distance 0 the answer is that of vesica_overlap_f64, exact for all kinds. Test for &gt; 0 to miss
        /// no pair, and for VESICA_WITHIN_YES to accept only what is certain. Exchanging the shapes changes
        /// nothing.</para>
        /// <para>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid
        /// shapes.</para>
        /// <para>Returns: VESICA_WITHIN_NO, VESICA_WITHIN_YES or VESICA_WITHIN_NEARLY.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0,
        /// get no other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of
        /// vesica_nearest_f64 differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53,
        /// half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their
        /// centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
        /// aspect ratio is longer over shorter size.</para>
        /// <para>Cost: 10 to 60 ns; that of vesica_nearest_f64 for ellipses; 1 to 10 us where only exact arithmetic can
        /// decide, as when the distance is met exactly. At worst 25 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_within_f64(int kindA, void* numbersA, int kindB, void* numbersB,
            double distance);

        /// <summary>
        /// <para>Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f64.</para>
        /// <para>Arrays and errors are those of vesica_overlap_many_f64.</para>
        /// <para>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid
        /// shapes.</para>
        /// <para>Returns: how many answers are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0,
        /// get no other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of
        /// vesica_nearest_f64 differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53,
        /// half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their
        /// centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
        /// aspect ratio is longer over shorter size.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_within_many_f64(void* a, void* b, double distance, void* output);

        /// <summary>
        /// <para>Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of
        /// vesica_within_f64.</para>
        /// <para>Arrays, row_stride and errors are those of vesica_overlap_matrix_f64.</para>
        /// <para>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid
        /// shapes.</para>
        /// <para>Returns: how many answers are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0,
        /// get no other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of
        /// vesica_nearest_f64 differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53,
        /// half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their
        /// centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
        /// aspect ratio is longer over shorter size.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_within_matrix_f64(void* a, void* b, double distance, void* output,
            IntPtr rowStride);

        /// <summary>
        /// <para>Greedy non-maximum suppression as vesica_nms_f64, by any ratio, each label on its own.</para>
        /// <para>Takes shapes in the order of their scores, highest first. Keeps each one whose ratio with every shape
        /// kept before, of the same label, is at most the threshold. Shapes whose score is below least_score are left
        /// out.</para>
        /// <para>Requires: shapes, scores, threshold and scratch as vesica_nms_f64; labels, one for each shape, or NULL
        /// if all are the same; ratio, any but VESICA_RATIO_OVER_FIRST and _OVER_SECOND; least_score, which may be
        /// -infinity; most, the largest number to keep; keep, with room for that number or for all shapes, whichever is
        /// less.</para>
        /// <para>Returns: 0, and keep and *kept as vesica_nms_f64.</para>
        /// <para>Errors: as vesica_nms_f64; VESICA_E_ARGUMENT also for ratio, a least_score that is NaN, and a negative
        /// most.</para>
        /// <para>Cost: that of vesica_nms_f64; ratios other than IoU take 0.1 us more a comparison.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_suppress_f64(void* shapes, void* scores, void* labels, int ratio,
            double threshold, double leastScore, long most, void* scratch, long scratchSize, void* keep, void* kept);

        /// <summary>
        /// <para>How many bytes of scratch does soft suppression of `count` shapes need?</para>
        /// <para>Returns: 64 bytes a shape.</para>
        /// <para>Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_suppress_soft_scratch(long count);

        /// <summary>
        /// <para>Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower
        /// score.</para>
        /// <para>Repeats these steps: take the shape with the highest score, of equal ones the first; keep it; lower
        /// the score of each shape not yet kept, of the same label, by `decay` of their ratio. Ends when `most` are
        /// kept or every score left is below least_score. keep[k] is the shape kept in step k, and decayed[k] the score
        /// that it had then.</para>
        /// <para>Requires: shapes, scores and labels as vesica_suppress_f64; ratio, any but VESICA_RATIO_OVER_FIRST and
        /// _OVER_SECOND; decay, VESICA_DECAY_LINEAR or _GAUSSIAN, with its parameter; least_score &gt;= 0; scratch of
        /// at least vesica_suppress_soft_scratch(count) bytes, aligned to 8; keep and decayed with room for `most`
        /// numbers or for all shapes, whichever is less.</para>
        /// <para>Returns: 0, with *kept set to how many are kept.</para>
        /// <para>Errors: as vesica_suppress_f64. VESICA_E_SHAPE: an invalid shape, or one whose score is NaN, is left
        /// out, and the result of the others is written.</para>
        /// <para>Accuracy: in every step a score is multiplied once, in double, by 1 - r, rounded once, or by the
        /// exponential, right to 1 unit in the last place; times 0 an infinite score is 0. So the same shapes are kept,
        /// with the same bits, on every machine. The float function computes in double and rounds only the final
        /// scores.</para>
        /// <para>Cost: for each kept shape, that of vesica_ratio_matrix_f64 with the shapes of its label that are
        /// left.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_suppress_soft_f64(void* shapes, void* scores, void* labels, int ratio,
            int decay, double parameter, double leastScore, long most, void* scratch, long scratchSize, void* keep,
            void* decayed, void* kept);

        /// <summary>
        /// <para>A ratio by which detections are compared: IoU and its relatives, as `ratio` says.</para>
        /// <para>The first four ratios are from 0 to 1. Shared area over one shape's is 0 if no area is shared, and 1
        /// if the other shape contains it. The last three are at most the IoU, and at least -1 (CIoU: -2). The angle of
        /// a shape in CIoU is that of the vector (half length across its axis, half length along it); v is 0 if a shape
        /// has no size. Exchanging the shapes exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the
        /// others.</para>
        /// <para>Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (ratio is no such constant;
        /// the area to divide by is 0; or, for GIoU, DIoU and CIoU, neither shape has an area).</para>
        /// <para>Accuracy: computed from the result of vesica_area_f32 or vesica_iou_f32 with at most 8 u of further
        /// error, for half lengths from 2^-200 to 2^200. Each number is computed in double, within these bounds, and
        /// then rounded to float once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of
        /// two shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u
        /// scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.</para>
        /// <para>Cost: that of vesica_area_f32 or vesica_iou_f32, and 100 to 150 ns more; in arrays 40 to 100 ns
        /// more.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ratio_f32(int ratio, int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f32.</para>
        /// <para>Arrays and errors are those of vesica_iou_many_f32. If a pair has no ratio because an area is 0,
        /// out[i] is NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.</para>
        /// <para>Accuracy: every result has the same bits as vesica_ratio_f32, on every instruction set and in every
        /// layout. Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: that of vesica_iou_many_f32, and 40 to 100 ns a pair.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_ratio_many_f32(int ratio, void* a, void* b, void* output);

        /// <summary>
        /// <para>A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f32.</para>
        /// <para>Arrays, row_stride and errors are those of vesica_iou_matrix_f32. If a pair has no ratio because an
        /// area is 0, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.</para>
        /// <para>Accuracy: every result has the same bits as vesica_ratio_f32, on every instruction set and in every
        /// layout. Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: that of vesica_iou_many_f32, and 40 to 100 ns a pair.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_ratio_matrix_f32(int ratio, void* a, void* b, void* output,
            IntPtr rowStride);

        /// <summary>
        /// <para>How far apart are a[i] and b[j]? The elements of out are distances of vesica_nearest_f32.</para>
        /// <para>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f32.</para>
        /// <para>Returns: how many pairs overlap (distance 0).</para>
        /// <para>Errors: as vesica_iou_matrix_f32.</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout. Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_nearest_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>How far apart are the outlines of a[i] and b[j]? The elements of out are distances of
        /// vesica_boundary_distance_f32.</para>
        /// <para>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f32.</para>
        /// <para>Returns: how many pairs of outlines meet (distance 0).</para>
        /// <para>Errors: as vesica_iou_matrix_f32.</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout. Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_boundary_distance_matrix_f32(void* a, void* b, void* output,
            IntPtr rowStride);

        /// <summary>
        /// <para>How deep do a[i] and b[j] overlap? The elements of out are depths of vesica_depth_f32.</para>
        /// <para>Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f32.</para>
        /// <para>Returns: how many depths are &gt; 0.</para>
        /// <para>Errors: as vesica_iou_matrix_f32.</para>
        /// <para>Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in
        /// every layout. Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_depth_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Greedy non-maximum suppression as vesica_nms_f32, by any ratio, each label on its own.</para>
        /// <para>Takes shapes in the order of their scores, highest first. Keeps each one whose ratio with every shape
        /// kept before, of the same label, is at most the threshold. Shapes whose score is below least_score are left
        /// out.</para>
        /// <para>Requires: shapes, scores, threshold and scratch as vesica_nms_f32; labels, one for each shape, or NULL
        /// if all are the same; ratio, any but VESICA_RATIO_OVER_FIRST and _OVER_SECOND; least_score, which may be
        /// -infinity; most, the largest number to keep; keep, with room for that number or for all shapes, whichever is
        /// less.</para>
        /// <para>Returns: 0, and keep and *kept as vesica_nms_f32.</para>
        /// <para>Errors: as vesica_nms_f32; VESICA_E_ARGUMENT also for ratio, a least_score that is NaN, and a negative
        /// most.</para>
        /// <para>Cost: that of vesica_nms_f32; ratios other than IoU take 0.1 us more a comparison.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_suppress_f32(void* shapes, void* scores, void* labels, int ratio,
            float threshold, float leastScore, long most, void* scratch, long scratchSize, void* keep, void* kept);

        /// <summary>
        /// <para>Signed distance: how far apart are two shapes or, as a negative number, how deep do they
        /// overlap?</para>
        /// <para>It is the distance of vesica_nearest_f32 if they are disjoint, else minus the depth of
        /// vesica_depth_f32: 0 if they only touch. Exchanging the shapes changes no bit.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the same bits as vesica_nearest_f32 or, negated, vesica_depth_f32. The sign is exact.
        /// Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: that of vesica_nearest_f32 or vesica_depth_f32.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_signed_distance_f32(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>Signed distances of a[i] and b[i]. Arrays and errors are those of vesica_iou_many_f32.</para>
        /// <para>Returns: how many pairs overlap (signed distance &lt;= 0).</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the same bits as vesica_nearest_f32 or, negated, vesica_depth_f32. The sign is exact.
        /// Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_signed_distance_many_f32(void* a, void* b, void* output);

        /// <summary>
        /// <para>Signed distances of a[i] and b[j]. Arrays, row_stride and errors are those of
        /// vesica_iou_matrix_f32.</para>
        /// <para>Returns: how many pairs overlap (signed distance &lt;= 0).</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the same bits as vesica_nearest_f32 or, negated, vesica_depth_f32. The sign is exact.
        /// Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_signed_distance_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Are two shapes at most `distance` apart? A distance of exactly that counts, as touching does.</para>
        /// <para>With distance 0 the answer is that of vesica_overlap_f32, exact for all kinds. Test for &gt; 0 to miss
        /// no pair, and for VESICA_WITHIN_YES to accept only what is certain. Exchanging the shapes changes
        /// nothing.</para>
        /// <para>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid
        /// shapes.</para>
        /// <para>Returns: VESICA_WITHIN_NO, VESICA_WITHIN_YES or VESICA_WITHIN_NEARLY.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0,
        /// get no other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of
        /// vesica_nearest_f32 differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53,
        /// half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their
        /// centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
        /// aspect ratio is longer over shorter size.</para>
        /// <para>Cost: 10 to 60 ns; that of vesica_nearest_f32 for ellipses; 1 to 10 us where only exact arithmetic can
        /// decide, as when the distance is met exactly. At worst 25 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_within_f32(int kindA, void* numbersA, int kindB, void* numbersB,
            float distance);

        /// <summary>
        /// <para>Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f32.</para>
        /// <para>Arrays and errors are those of vesica_overlap_many_f32.</para>
        /// <para>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid
        /// shapes.</para>
        /// <para>Returns: how many answers are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0,
        /// get no other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of
        /// vesica_nearest_f32 differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53,
        /// half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their
        /// centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
        /// aspect ratio is longer over shorter size.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_within_many_f32(void* a, void* b, float distance, void* output);

        /// <summary>
        /// <para>Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of
        /// vesica_within_f32.</para>
        /// <para>Arrays, row_stride and errors are those of vesica_overlap_matrix_f32.</para>
        /// <para>Requires: distance &gt;= 0. It may be infinity: then the answer is yes for any two valid
        /// shapes.</para>
        /// <para>Returns: how many answers are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: yes and no are always right. All kinds but ellipses, and ellipses with a half length of 0,
        /// get no other answer. A disjoint pair with another ellipse gets VESICA_WITHIN_NEARLY if the distance of
        /// vesica_nearest_f32 differs by less than 5 u scale from the one asked for. In bounds on errors u is 2^-53,
        /// half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their
        /// centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
        /// aspect ratio is longer over shorter size.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_within_matrix_f32(void* a, void* b, float distance, void* output,
            IntPtr rowStride);

        /// <summary>
        /// <para>Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower
        /// score.</para>
        /// <para>Repeats these steps: take the shape with the highest score, of equal ones the first; keep it; lower
        /// the score of each shape not yet kept, of the same label, by `decay` of their ratio. Ends when `most` are
        /// kept or every score left is below least_score. keep[k] is the shape kept in step k, and decayed[k] the score
        /// that it had then.</para>
        /// <para>Requires: shapes, scores and labels as vesica_suppress_f32; ratio, any but VESICA_RATIO_OVER_FIRST and
        /// _OVER_SECOND; decay, VESICA_DECAY_LINEAR or _GAUSSIAN, with its parameter; least_score &gt;= 0; scratch of
        /// at least vesica_suppress_soft_scratch(count) bytes, aligned to 8; keep and decayed with room for `most`
        /// numbers or for all shapes, whichever is less.</para>
        /// <para>Returns: 0, with *kept set to how many are kept.</para>
        /// <para>Errors: as vesica_suppress_f32. VESICA_E_SHAPE: an invalid shape, or one whose score is NaN, is left
        /// out, and the result of the others is written.</para>
        /// <para>Accuracy: in every step a score is multiplied once, in double, by 1 - r, rounded once, or by the
        /// exponential, right to 1 unit in the last place; times 0 an infinite score is 0. So the same shapes are kept,
        /// with the same bits, on every machine. The float function computes in double and rounds only the final
        /// scores.</para>
        /// <para>Cost: for each kept shape, that of vesica_ratio_matrix_f32 with the shapes of its label that are
        /// left.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_suppress_soft_f32(void* shapes, void* scores, void* labels, int ratio,
            int decay, float parameter, float leastScore, long most, void* scratch, long scratchSize, void* keep,
            void* decayed, void* kept);

        /// <summary>
        /// <para>Does b touch a while it moves, when first, and where?</para>
        /// <para>The normal is that of the face or the round outline that is met; if a corner meets a corner, that of
        /// an edge there; if b only slides along a, it is perpendicular to the velocity. For a face that is met at an
        /// angle below 2^-80 it may be that of the face beside it, and the point their corner. If two faces meet, the
        /// point is the middle of what they share. Shapes that overlap at the start have t = 0, the direction of
        /// vesica_depth_f64 and the point of vesica_nearest_f64. Shapes that only touch at the start move apart or
        /// slide if (nx, ny).(vx, vy) &gt;= 0. Else they may press together; where corners meet, or a shape has no
        /// area, they may also part. Exchanging the shapes and reversing the velocity changes neither the answer nor
        /// the time; it reverses the normal, up to rounding.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a velocity that is not finite, a t_end that
        /// is negative or NaN), VESICA_E_SHAPE, VESICA_E_RANGE (the time, or a coordinate of the point, would overflow;
        /// or an exact position would take more than 2000 bits, as with magnitudes of both 2^1000 and 2^-1000).</para>
        /// <para>Accuracy: the answer is exact, and the time is rounded down. The point is within 8 u scale of a's
        /// outline before it is rounded; along the outline it may be off by (8 u scale + 4 u R) / |n.v|, n and v of
        /// unit length, R the greatest radius of curvature of a: of an ellipse its long half length squared over the
        /// short one, far more than its size if it is thin. The normal has length 1 to 4 u. In bounds on errors u is
        /// 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
        /// their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale.
        /// An aspect ratio is longer over shorter size.</para>
        /// <para>Cost: 30 to 50 ns for a miss, 0.2 to 0.6 us for a hit; less for rays (b a point), two circles and two
        /// ellipses, see the typed functions; 0.7 to 20 us for contact that only exact arithmetic can decide. At wildly
        /// unlike exponents most take 10 to 30 us; at worst 0.3 ms.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_f64(int kindA, void* numbersA, int kindB, void* numbersB, double vx,
            double vy, double tEnd, void* output);

        /// <summary>
        /// <para>When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]? The columns are the fields of
        /// vesica_cast_f64's result.</para>
        /// <para>Velocity i is `i * stride` bytes after vx and vy; stride 0 repeats one velocity.</para>
        /// <para>Requires: velocities and t_end as vesica_cast_f64; equal counts, or one count of 1, whose shape is
        /// used for all. Each output has room for as many numbers as the larger count. Some, but not all, may be NULL.
        /// vx and vy need no alignment; without pairs they may be NULL.</para>
        /// <para>Returns: how many touch, including those that overlap at the start.</para>
        /// <para>Errors: those of vesica_cast_f64. An element with an invalid shape, a velocity that is not finite or a
        /// result out of range gets NaN for all its numbers, and all others are written as usual. The call then returns
        /// VESICA_E_SHAPE if a shape is invalid, else the error of the last such element.</para>
        /// <para>Accuracy: every result has the same bits as vesica_cast_f64.</para>
        /// <para>Cost: that of vesica_cast_f64 for each pair; with AVX2 or AVX-512 a half to an eighth of it, except
        /// for pairs that overlap at the start.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_cast_many_f64(void* a, void* b, void* vx, void* vy, IntPtr stride,
            double tEnd, void* t, void* x, void* y, void* nx, void* ny);

        /// <summary>
        /// <para>Which of many shapes at rest does one moving shape touch first? If several are touched at that time,
        /// the one with the lowest index.</para>
        /// <para>Requires: one, the shape that moves, an array of count 1; vx, vy and t_end as vesica_cast_f64.</para>
        /// <para>Returns: its index, or the count of `many` if none is touched. *out is its contact, the normal
        /// pointing to `one`.</para>
        /// <para>Errors: those of vesica_cast_f64. VESICA_E_SHAPE if any shape is invalid. VESICA_E_RANGE only if
        /// vesica_cast_f64 returns it for a shape that might be touched first.</para>
        /// <para>Cost: 5 to 20 ns a shape that is missed.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_cast_first_f64(void* one, void* many, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A box that holds a shape throughout its motion, t from 0 to t_end. The shape touches nothing outside
        /// it.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: those of vesica_cast_f64; VESICA_E_RANGE if a side would overflow.</para>
        /// <para>Accuracy: a side that does not move is that of vesica_bounds_f64. One that moves is too far out by at
        /// most four units in the last place of the largest of three numbers: the side at rest, the way it moves, and
        /// where it ends.</para>
        /// <para>Cost: 15 ns more than vesica_bounds_f64.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_sweep_bounds_f64(int kind, void* numbers, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>Which items of an index does one moving shape touch? They come in the index's order.</para>
        /// <para>Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f64.
        /// out has room for `capacity` items. With capacity 0, out and state may be NULL.</para>
        /// <para>Returns: the number of items written; with capacity 0, how many there are. If state[0] is not -1 then,
        /// there are more, and the same call continues (vesica_index.h).</para>
        /// <para>Errors: those of vesica_cast_f64, and VESICA_E_INDEX; VESICA_E_ARGUMENT also for sets of another
        /// number of items than the index, a pointer that is not aligned, or a state from another function
        /// (vesica_index.h). VESICA_E_RANGE only if it cannot be told whether an item is touched, as its exact position
        /// at t_end would take more than 2000 bits. Then nothing is written, the state is behind that item, and the
        /// same call continues; with capacity 0 there is no count. Invalid items are never touched.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: a few us, and about 150 ns for each item whose box the swept box meets, for a million circles in
        /// any order. If only exact arithmetic can decide an item, that of vesica_cast_f64.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_cast_f64(void* index, void* sets, int setCount, void* one, double vx,
            double vy, double tEnd, void* output, long capacity, void* state);

        /// <summary>
        /// <para>Which item of an index does one moving shape touch first? If several are touched at that time, the
        /// lowest item.</para>
        /// <para>Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as
        /// vesica_cast_f64.</para>
        /// <para>Returns: the item, or the index's count if none is touched. *out is its contact, the normal pointing
        /// to `one`.</para>
        /// <para>Errors: those of vesica_index_cast_f64; VESICA_E_RANGE only as for vesica_cast_first_f64.</para>
        /// <para>Cost: about 2 us for a ray at a million shapes.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_cast_first_f64(void* index, void* sets, int setCount, void* one,
            double vx, double vy, double tEnd, void* output);

        /// <summary>
        /// <para>When do two shapes that move and turn touch first? It is proved that there is no contact before t,
        /// however thin the shapes are and however fast they turn.</para>
        /// <para>At t, from 0 to 1, a centre has moved by t (vx, vy) and an axis has turned by t times the angle,
        /// without rounding. *out describes that moment: the point of a that is nearest to b, and the normal that
        /// separates them. They are then at most *gap apart.</para>
        /// <para>Requires: numbers of turn_a and turn_b finite, angles at most 2^20 in magnitude; tolerance, a length
        /// &gt; 0. No pointer may be NULL.</para>
        /// <para>Returns: VESICA_CAST_MISS: it is proved that there is no contact from 0 to 1; t is infinity, and all
        /// other numbers and the gap are NaN. VESICA_CAST_HIT: it is proved that there is contact after t.
        /// VESICA_CAST_NEAR: there may be contact after t; contact of a point with a segment or a point, where there is
        /// no depth, is never proved. VESICA_CAST_START: the shapes overlap at t = 0, which is exact; *out is that of
        /// vesica_cast_f64, and the gap is 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE (a coordinate
        /// of the point, or the gap, would overflow).</para>
        /// <para>Accuracy: what is said to be proved is certain. The gap is at most the tolerance, except in two cases:
        /// the tolerance is below (300 + 10 |angles|) u times the sum of all lengths, the motion's included, u = 2^-53;
        /// or the search stopped after 256 directions or 4096 poses.</para>
        /// <para>Cost: 0.2 to 0.9 us for boxes, 0.4 to 3 us if one shape is round; 0.14 ms was seen at spins of 10^6
        /// radians; at worst 1.4 ms.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_impact_time_f64(int kindA, void* numbersA, void* turnA, int kindB,
            void* numbersB, void* turnB, double tolerance, void* output, void* gap);

        /// <summary>
        /// <para>A ray at a point.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f64 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_point_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a segment.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f64 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_segment_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a disc.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f64 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_circle_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at an axis-aligned box.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f64 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_aabb_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a rectangle.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f64 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_rect_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at an ellipse.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f64 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_ellipse_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>Two discs.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f64 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_circle_circle_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>Two rectangles.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f64 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_rect_rect_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>Does b touch a while it moves, when first, and where?</para>
        /// <para>The normal is that of the face or the round outline that is met; if a corner meets a corner, that of
        /// an edge there; if b only slides along a, it is perpendicular to the velocity. For a face that is met at an
        /// angle below 2^-80 it may be that of the face beside it, and the point their corner. If two faces meet, the
        /// point is the middle of what they share. Shapes that overlap at the start have t = 0, the direction of
        /// vesica_depth_f32 and the point of vesica_nearest_f32. Shapes that only touch at the start move apart or
        /// slide if (nx, ny).(vx, vy) &gt;= 0. Else they may press together; where corners meet, or a shape has no
        /// area, they may also part. Exchanging the shapes and reversing the velocity changes neither the answer nor
        /// the time; it reverses the normal, up to rounding.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a velocity that is not finite, a t_end that
        /// is negative or NaN), VESICA_E_SHAPE, VESICA_E_RANGE (the time, or a coordinate of the point, would overflow;
        /// or an exact position would take more than 2000 bits, as with magnitudes of both 2^1000 and 2^-1000).</para>
        /// <para>Accuracy: the answer is exact, and the time is rounded down. The point is within 8 u scale of a's
        /// outline before it is rounded; along the outline it may be off by (8 u scale + 4 u R) / |n.v|, n and v of
        /// unit length, R the greatest radius of curvature of a: of an ellipse its long half length squared over the
        /// short one, far more than its size if it is thin. The normal has length 1 to 4 u. In bounds on errors u is
        /// 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
        /// their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale.
        /// An aspect ratio is longer over shorter size.</para>
        /// <para>Cost: 30 to 50 ns for a miss, 0.2 to 0.6 us for a hit; less for rays (b a point), two circles and two
        /// ellipses, see the typed functions; 0.7 to 20 us for contact that only exact arithmetic can decide. At wildly
        /// unlike exponents most take 10 to 30 us; at worst 0.3 ms.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_f32(int kindA, void* numbersA, int kindB, void* numbersB, float vx,
            float vy, float tEnd, void* output);

        /// <summary>
        /// <para>When and where does b[i], moved by t (vx[i], vy[i]), touch a[i]? The columns are the fields of
        /// vesica_cast_f32's result.</para>
        /// <para>Velocity i is `i * stride` bytes after vx and vy; stride 0 repeats one velocity.</para>
        /// <para>Requires: velocities and t_end as vesica_cast_f32; equal counts, or one count of 1, whose shape is
        /// used for all. Each output has room for as many numbers as the larger count. Some, but not all, may be NULL.
        /// vx and vy need no alignment; without pairs they may be NULL.</para>
        /// <para>Returns: how many touch, including those that overlap at the start.</para>
        /// <para>Errors: those of vesica_cast_f32. An element with an invalid shape, a velocity that is not finite or a
        /// result out of range gets NaN for all its numbers, and all others are written as usual. The call then returns
        /// VESICA_E_SHAPE if a shape is invalid, else the error of the last such element.</para>
        /// <para>Accuracy: every result has the same bits as vesica_cast_f32.</para>
        /// <para>Cost: that of vesica_cast_f32 for each pair; with AVX2 or AVX-512 a half to an eighth of it, except
        /// for pairs that overlap at the start.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_cast_many_f32(void* a, void* b, void* vx, void* vy, IntPtr stride,
            float tEnd, void* t, void* x, void* y, void* nx, void* ny);

        /// <summary>
        /// <para>Which of many shapes at rest does one moving shape touch first? If several are touched at that time,
        /// the one with the lowest index.</para>
        /// <para>Requires: one, the shape that moves, an array of count 1; vx, vy and t_end as vesica_cast_f32.</para>
        /// <para>Returns: its index, or the count of `many` if none is touched. *out is its contact, the normal
        /// pointing to `one`.</para>
        /// <para>Errors: those of vesica_cast_f32. VESICA_E_SHAPE if any shape is invalid. VESICA_E_RANGE only if
        /// vesica_cast_f32 returns it for a shape that might be touched first.</para>
        /// <para>Cost: 5 to 20 ns a shape that is missed.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_cast_first_f32(void* one, void* many, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A box that holds a shape throughout its motion, t from 0 to t_end. The shape touches nothing outside
        /// it.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: those of vesica_cast_f32; VESICA_E_RANGE if a side would overflow.</para>
        /// <para>Accuracy: a side that does not move is that of vesica_bounds_f32. One that moves is too far out by at
        /// most four units in the last place of the largest of three numbers: the side at rest, the way it moves, and
        /// where it ends.</para>
        /// <para>Cost: 15 ns more than vesica_bounds_f32.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_sweep_bounds_f32(int kind, void* numbers, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>Which items of an index does one moving shape touch? They come in the index's order.</para>
        /// <para>Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f32.
        /// out has room for `capacity` items. With capacity 0, out and state may be NULL.</para>
        /// <para>Returns: the number of items written; with capacity 0, how many there are. If state[0] is not -1 then,
        /// there are more, and the same call continues (vesica_index.h).</para>
        /// <para>Errors: those of vesica_cast_f32, and VESICA_E_INDEX; VESICA_E_ARGUMENT also for sets of another
        /// number of items than the index, a pointer that is not aligned, or a state from another function
        /// (vesica_index.h). VESICA_E_RANGE only if it cannot be told whether an item is touched, as its exact position
        /// at t_end would take more than 2000 bits. Then nothing is written, the state is behind that item, and the
        /// same call continues; with capacity 0 there is no count. Invalid items are never touched.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: a few us, and about 150 ns for each item whose box the swept box meets, for a million circles in
        /// any order. If only exact arithmetic can decide an item, that of vesica_cast_f32.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_cast_f32(void* index, void* sets, int setCount, void* one, float vx,
            float vy, float tEnd, void* output, long capacity, void* state);

        /// <summary>
        /// <para>Which item of an index does one moving shape touch first? If several are touched at that time, the
        /// lowest item.</para>
        /// <para>Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as
        /// vesica_cast_f32.</para>
        /// <para>Returns: the item, or the index's count if none is touched. *out is its contact, the normal pointing
        /// to `one`.</para>
        /// <para>Errors: those of vesica_index_cast_f32; VESICA_E_RANGE only as for vesica_cast_first_f32.</para>
        /// <para>Cost: about 2 us for a ray at a million shapes.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_cast_first_f32(void* index, void* sets, int setCount, void* one,
            float vx, float vy, float tEnd, void* output);

        /// <summary>
        /// <para>As vesica_impact_time_f64. The gap is that at the rounded time, and rounded up: it may exceed the
        /// tolerance by 2^-24 of the way that the shapes move relative to each other.</para>
        /// <para>Errors: those of the double functions.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_impact_time_f32(int kindA, void* numbersA, void* turnA, int kindB,
            void* numbersB, void* turnB, float tolerance, void* output, void* gap);

        /// <summary>
        /// <para>A ray at a point.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f32 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_point_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a segment.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f32 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_segment_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a disc.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f32 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_circle_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at an axis-aligned box.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f32 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_aabb_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a rectangle.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f32 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_rect_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at an ellipse.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f32 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_ellipse_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>Two discs.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f32 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_circle_circle_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>Two rectangles.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 7 to 25 ns for a miss, 60 to 180 ns for a hit; for two rectangles 30 to 50 ns and 0.3 us.
        /// Near-ties cost what vesica_cast_f32 does for other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_rect_rect_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.</para>
        /// <para>Every shape has an inside, an outline and an outside. The first three characters say what a's inside
        /// shares with b's inside, outline and outside; the next three say it of a's outline, the last three of a's
        /// outside. F means nothing, 0 single points, 1 lines, 2 an area. The outline of a shape with area is the curve
        /// around it, that of a segment its two end points; a point has none. A segment without length is a point; a
        /// shape with one size 0 is a segment, with both 0 a point. Two boxes side by side that share a side give
        /// "FF2F11212". Exchanging the shapes exchanges rows and columns.</para>
        /// <para>Requires: matrix with room for VESICA_DE9IM_SIZE characters.</para>
        /// <para>Returns: 0, and nine characters and a final NUL in matrix.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: that of vesica_relation_f64; 0.1 to 1 us more for a segment, 2 us for rectangles whose sides are
        /// parallel. At worst 30 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_de9im_f64(int kindA, void* numbersA, int kindB, void* numbersB, void* matrix);

        /// <summary>
        /// <para>Does a nine-intersection matrix match a pattern, such as "T*F**F***" for "a is within b"?</para>
        /// <para>In a pattern F, 0, 1 and 2 match themselves, T matches 0, 1 and 2, and * matches all four.</para>
        /// <para>Requires: matrix and pattern, nine such characters and a final NUL each; no T or * in the
        /// matrix.</para>
        /// <para>Returns: 1 if it matches, 0 if not.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (another length or another character).</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_de9im_match(void* matrix, void* pattern);

        /// <summary>
        /// <para>The vertices of the region that two shapes share: two with straight outlines, or a segment and any
        /// shape.</para>
        /// <para>The kinds are points, segments, boxes and rectangles; a point or a segment may also meet a circle or
        /// an ellipse. The region is convex. Its vertices x0 y0 x1 y1 ... come counter-clockwise if y points up. The
        /// first is the one with the least y, of equal ones that with the least x, by the numbers written. One vertex
        /// is a point, two are the ends of a segment. Exchanging the shapes changes no bit; a zero is +0. Unused
        /// vertices become 0.</para>
        /// <para>Returns: the number of vertices, 1 to 8, or 0 if the shapes share nothing.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND (also for other pairs of kinds than these), VESICA_E_SHAPE,
        /// VESICA_E_RANGE (a vertex, or the length of a side that makes one, overflows).</para>
        /// <para>Accuracy: the number of vertices is exact: it is that of the true region. A corner of a shape that
        /// lies in the other keeps the stored numbers, or those of vesica_corners_of_shapes_f64 for a rectangle. Other
        /// vertices are right to 4 u times the largest coordinate or size of either shape. In bounds on errors u is
        /// 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
        /// their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale.
        /// An aspect ratio is longer over shorter size.</para>
        /// <para>Cost: that of vesica_overlap_f64 for disjoint shapes; 0.2 to 1 us with a segment, 2 to 6 us for areas;
        /// at worst 30 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_intersection_f64(int kindA, void* numbersA, int kindB, void* numbersB,
            void* vertices);

        /// <summary>
        /// <para>The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.</para>
        /// <para>Every shape has an inside, an outline and an outside. The first three characters say what a's inside
        /// shares with b's inside, outline and outside; the next three say it of a's outline, the last three of a's
        /// outside. F means nothing, 0 single points, 1 lines, 2 an area. The outline of a shape with area is the curve
        /// around it, that of a segment its two end points; a point has none. A segment without length is a point; a
        /// shape with one size 0 is a segment, with both 0 a point. Two boxes side by side that share a side give
        /// "FF2F11212". Exchanging the shapes exchanges rows and columns.</para>
        /// <para>Requires: matrix with room for VESICA_DE9IM_SIZE characters.</para>
        /// <para>Returns: 0, and nine characters and a final NUL in matrix.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: that of vesica_relation_f32; 0.1 to 1 us more for a segment, 2 us for rectangles whose sides are
        /// parallel. At worst 30 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_de9im_f32(int kindA, void* numbersA, int kindB, void* numbersB, void* matrix);

        /// <summary>
        /// <para>The vertices of the region that two shapes share: two with straight outlines, or a segment and any
        /// shape.</para>
        /// <para>The kinds are points, segments, boxes and rectangles; a point or a segment may also meet a circle or
        /// an ellipse. The region is convex. Its vertices x0 y0 x1 y1 ... come counter-clockwise if y points up. The
        /// first is the one with the least y, of equal ones that with the least x, by the numbers written. One vertex
        /// is a point, two are the ends of a segment. Exchanging the shapes changes no bit; a zero is +0. Unused
        /// vertices become 0.</para>
        /// <para>Returns: the number of vertices, 1 to 8, or 0 if the shapes share nothing.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND (also for other pairs of kinds than these), VESICA_E_SHAPE,
        /// VESICA_E_RANGE (a vertex, or the length of a side that makes one, overflows).</para>
        /// <para>Accuracy: the number of vertices is exact: it is that of the true region. A corner of a shape that
        /// lies in the other keeps the stored numbers, or those of vesica_corners_of_shapes_f32 for a rectangle. Other
        /// vertices are right to 4 u times the largest coordinate or size of either shape. Each number is computed in
        /// double, within these bounds, and then rounded to float once. In bounds on errors u is 2^-53, half a unit in
        /// the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of
        /// their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is
        /// longer over shorter size.</para>
        /// <para>Cost: that of vesica_overlap_f32 for disjoint shapes; 0.2 to 1 us with a segment, 2 to 6 us for areas;
        /// at worst 30 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_intersection_f32(int kindA, void* numbersA, int kindB, void* numbersB,
            void* vertices);

        internal static int Check(bool wide, int kind, void* numbers)
        {
            return wide
                ? vesica_check_f64(kind, numbers)
                : vesica_check_f32(kind, numbers);
        }

        internal static int Overlap(bool wide, int kindA, void* numbersA, int kindB, void* numbersB)
        {
            return wide
                ? vesica_overlap_f64(kindA, numbersA, kindB, numbersB)
                : vesica_overlap_f32(kindA, numbersA, kindB, numbersB);
        }

        internal static int Relation(bool wide, int kindA, void* numbersA, int kindB, void* numbersB)
        {
            return wide
                ? vesica_relation_f64(kindA, numbersA, kindB, numbersB)
                : vesica_relation_f32(kindA, numbersA, kindB, numbersB);
        }

        internal static int Contains(bool wide, int kindA, void* numbersA, int kindB, void* numbersB)
        {
            return wide
                ? vesica_contains_f64(kindA, numbersA, kindB, numbersB)
                : vesica_contains_f32(kindA, numbersA, kindB, numbersB);
        }

        internal static int Crossings(bool wide, int kindA, void* numbersA, int kindB, void* numbersB, void* output)
        {
            return wide
                ? vesica_crossings_f64(kindA, numbersA, kindB, numbersB, output)
                : vesica_crossings_f32(kindA, numbersA, kindB, numbersB, output);
        }

        internal static int Nearest(bool wide, int kindA, void* numbersA, int kindB, void* numbersB, void* output)
        {
            return wide
                ? vesica_nearest_f64(kindA, numbersA, kindB, numbersB, output)
                : vesica_nearest_f32(kindA, numbersA, kindB, numbersB, output);
        }

        internal static int BoundaryDistance(bool wide, int kindA, void* numbersA, int kindB, void* numbersB,
            void* output)
        {
            return wide
                ? vesica_boundary_distance_f64(kindA, numbersA, kindB, numbersB, output)
                : vesica_boundary_distance_f32(kindA, numbersA, kindB, numbersB, output);
        }

        internal static int Depth(bool wide, int kindA, void* numbersA, int kindB, void* numbersB, void* output)
        {
            return wide
                ? vesica_depth_f64(kindA, numbersA, kindB, numbersB, output)
                : vesica_depth_f32(kindA, numbersA, kindB, numbersB, output);
        }

        internal static int ShapeArea(bool wide, int kind, void* numbers, void* output)
        {
            return wide
                ? vesica_shape_area_f64(kind, numbers, output)
                : vesica_shape_area_f32(kind, numbers, output);
        }

        internal static int Area(bool wide, int kindA, void* numbersA, int kindB, void* numbersB, void* output)
        {
            return wide
                ? vesica_area_f64(kindA, numbersA, kindB, numbersB, output)
                : vesica_area_f32(kindA, numbersA, kindB, numbersB, output);
        }

        internal static int Iou(bool wide, int kindA, void* numbersA, int kindB, void* numbersB, void* output)
        {
            return wide
                ? vesica_iou_f64(kindA, numbersA, kindB, numbersB, output)
                : vesica_iou_f32(kindA, numbersA, kindB, numbersB, output);
        }

        internal static int Bounds(bool wide, int kind, void* numbers, void* output)
        {
            return wide
                ? vesica_bounds_f64(kind, numbers, output)
                : vesica_bounds_f32(kind, numbers, output);
        }

        internal static int AabbFromCorners(bool wide, double x0, double y0, double x1, double y1, void* output)
        {
            return wide
                ? vesica_aabb_from_corners_f64(x0, y0, x1, y1, output)
                : vesica_aabb_from_corners_f32((float)x0, (float)y0, (float)x1, (float)y1, output);
        }

        internal static int RectFromAngle(bool wide, double cx, double cy, double angle, double width, double height,
            void* output)
        {
            return wide
                ? vesica_rect_from_angle_f64(cx, cy, angle, width, height, output)
                : vesica_rect_from_angle_f32((float)cx, (float)cy, (float)angle, (float)width, (float)height, output);
        }

        internal static int RectFromCorners(bool wide, void* corners, void* output)
        {
            return wide
                ? vesica_rect_from_corners_f64(corners, output)
                : vesica_rect_from_corners_f32(corners, output);
        }

        internal static int EllipseFromAngle(bool wide, double cx, double cy, double angle, double a, double b,
            void* output)
        {
            return wide
                ? vesica_ellipse_from_angle_f64(cx, cy, angle, a, b, output)
                : vesica_ellipse_from_angle_f32((float)cx, (float)cy, (float)angle, (float)a, (float)b, output);
        }

        internal static int EllipseFromRadiusVector(bool wide, double cx, double cy, double wx, double wy, double ratio,
            void* output)
        {
            return wide
                ? vesica_ellipse_from_radius_vector_f64(cx, cy, wx, wy, ratio, output)
                : vesica_ellipse_from_radius_vector_f32((float)cx, (float)cy, (float)wx, (float)wy, (float)ratio,
                    output);
        }

        internal static int EllipseFromCovariance(bool wide, double meanX, double meanY, double cxx, double cxy,
            double cyy, double k, void* output)
        {
            return wide
                ? vesica_ellipse_from_covariance_f64(meanX, meanY, cxx, cxy, cyy, k, output)
                : vesica_ellipse_from_covariance_f32((float)meanX, (float)meanY, (float)cxx, (float)cxy, (float)cyy,
                    (float)k, output);
        }

        internal static int EllipseFromMatrix(bool wide, double cx, double cy, double mxx, double mxy, double myy,
            void* output)
        {
            return wide
                ? vesica_ellipse_from_matrix_f64(cx, cy, mxx, mxy, myy, output)
                : vesica_ellipse_from_matrix_f32((float)cx, (float)cy, (float)mxx, (float)mxy, (float)myy, output);
        }

        internal static long OverlapMany(bool wide, void* a, void* b, void* output)
        {
            return wide
                ? vesica_overlap_many_f64(a, b, output)
                : vesica_overlap_many_f32(a, b, output);
        }

        internal static long RelationMany(bool wide, void* a, void* b, void* output)
        {
            return wide
                ? vesica_relation_many_f64(a, b, output)
                : vesica_relation_many_f32(a, b, output);
        }

        internal static long ContainsMany(bool wide, void* a, void* b, void* output)
        {
            return wide
                ? vesica_contains_many_f64(a, b, output)
                : vesica_contains_many_f32(a, b, output);
        }

        internal static long NearestMany(bool wide, void* a, void* b, void* distance, void* ax, void* ay, void* bx,
            void* by)
        {
            return wide
                ? vesica_nearest_many_f64(a, b, distance, ax, ay, bx, by)
                : vesica_nearest_many_f32(a, b, distance, ax, ay, bx, by);
        }

        internal static long BoundaryDistanceMany(bool wide, void* a, void* b, void* distance, void* ax, void* ay,
            void* bx, void* by)
        {
            return wide
                ? vesica_boundary_distance_many_f64(a, b, distance, ax, ay, bx, by)
                : vesica_boundary_distance_many_f32(a, b, distance, ax, ay, bx, by);
        }

        internal static long DepthMany(bool wide, void* a, void* b, void* depth, void* x, void* y)
        {
            return wide
                ? vesica_depth_many_f64(a, b, depth, x, y)
                : vesica_depth_many_f32(a, b, depth, x, y);
        }

        internal static long AreaMany(bool wide, void* a, void* b, void* output)
        {
            return wide
                ? vesica_area_many_f64(a, b, output)
                : vesica_area_many_f32(a, b, output);
        }

        internal static long IouMany(bool wide, void* a, void* b, void* output)
        {
            return wide
                ? vesica_iou_many_f64(a, b, output)
                : vesica_iou_many_f32(a, b, output);
        }

        internal static long OverlapMatrix(bool wide, void* a, void* b, void* output, IntPtr rowStride)
        {
            return wide
                ? vesica_overlap_matrix_f64(a, b, output, rowStride)
                : vesica_overlap_matrix_f32(a, b, output, rowStride);
        }

        internal static long RelationMatrix(bool wide, void* a, void* b, void* output, IntPtr rowStride)
        {
            return wide
                ? vesica_relation_matrix_f64(a, b, output, rowStride)
                : vesica_relation_matrix_f32(a, b, output, rowStride);
        }

        internal static long ContainsMatrix(bool wide, void* a, void* b, void* output, IntPtr rowStride)
        {
            return wide
                ? vesica_contains_matrix_f64(a, b, output, rowStride)
                : vesica_contains_matrix_f32(a, b, output, rowStride);
        }

        internal static long AreaMatrix(bool wide, void* a, void* b, void* output, IntPtr rowStride)
        {
            return wide
                ? vesica_area_matrix_f64(a, b, output, rowStride)
                : vesica_area_matrix_f32(a, b, output, rowStride);
        }

        internal static long IouMatrix(bool wide, void* a, void* b, void* output, IntPtr rowStride)
        {
            return wide
                ? vesica_iou_matrix_f64(a, b, output, rowStride)
                : vesica_iou_matrix_f32(a, b, output, rowStride);
        }

        internal static long OverlapSelect(bool wide, void* one, void* many, void* output, long capacity)
        {
            return wide
                ? vesica_overlap_select_f64(one, many, output, capacity)
                : vesica_overlap_select_f32(one, many, output, capacity);
        }

        internal static int Nms(bool wide, void* shapes, void* scores, double threshold, void* scratch,
            long scratchSize, void* keep, void* kept)
        {
            return wide
                ? vesica_nms_f64(shapes, scores, threshold, scratch, scratchSize, keep, kept)
                : vesica_nms_f32(shapes, scores, (float)threshold, scratch, scratchSize, keep, kept);
        }

        internal static long RectsFromBoxes(bool wide, void* boxes, long count, IntPtr stride, int angle, void* output)
        {
            return wide
                ? vesica_rects_from_boxes_f64(boxes, count, stride, angle, output)
                : vesica_rects_from_boxes_f32(boxes, count, stride, angle, output);
        }

        internal static long EllipsesFromBoxes(bool wide, void* boxes, long count, IntPtr stride, int angle,
            void* output)
        {
            return wide
                ? vesica_ellipses_from_boxes_f64(boxes, count, stride, angle, output)
                : vesica_ellipses_from_boxes_f32(boxes, count, stride, angle, output);
        }

        internal static long BoxesFromShapes(bool wide, void* shapes, int angle, void* boxes)
        {
            return wide
                ? vesica_boxes_from_shapes_f64(shapes, angle, boxes)
                : vesica_boxes_from_shapes_f32(shapes, angle, boxes);
        }

        internal static long CornersOfShapes(bool wide, void* shapes, void* corners)
        {
            return wide
                ? vesica_corners_of_shapes_f64(shapes, corners)
                : vesica_corners_of_shapes_f32(shapes, corners);
        }

        internal static long BoundsMany(bool wide, void* shapes, void* output)
        {
            return wide
                ? vesica_bounds_many_f64(shapes, output)
                : vesica_bounds_many_f32(shapes, output);
        }

        internal static long IndexBuild(bool wide, void* sets, int setCount, void* index, long indexSize, void* scratch,
            long scratchSize)
        {
            return wide
                ? vesica_index_build_f64(sets, setCount, index, indexSize, scratch, scratchSize)
                : vesica_index_build_f32(sets, setCount, index, indexSize, scratch, scratchSize);
        }

        internal static long IndexSelect(bool wide, void* index, void* sets, int setCount, void* one, void* output,
            long capacity, void* state)
        {
            return wide
                ? vesica_index_select_f64(index, sets, setCount, one, output, capacity, state)
                : vesica_index_select_f32(index, sets, setCount, one, output, capacity, state);
        }

        internal static long Join(bool wide, int query, void* indexA, void* setsA, int setCountA, void* indexB,
            void* setsB, int setCountB, long part, long parts, void* scratch, long scratchSize, void* outA, void* outB,
            long capacity, void* state)
        {
            return wide
                ? vesica_join_f64(query, indexA, setsA, setCountA, indexB, setsB, setCountB, part, parts, scratch,
                    scratchSize, outA, outB, capacity, state)
                : vesica_join_f32(query, indexA, setsA, setCountA, indexB, setsB, setCountB, part, parts, scratch,
                    scratchSize, outA, outB, capacity, state);
        }

        internal static long JoinWithin(bool wide, void* indexA, void* setsA, int setCountA, void* indexB, void* setsB,
            int setCountB, double distance, long part, long parts, void* outA, void* outB, long capacity, void* state)
        {
            return wide
                ? vesica_join_within_f64(indexA, setsA, setCountA, indexB, setsB, setCountB, distance, part, parts,
                    outA, outB, capacity, state)
                : vesica_join_within_f32(indexA, setsA, setCountA, indexB, setsB, setCountB, (float)distance, part,
                    parts, outA, outB, capacity, state);
        }

        internal static long IndexNearest(bool wide, void* index, void* sets, int setCount, void* one, long k,
            double within, void* output, void* distance)
        {
            return wide
                ? vesica_index_nearest_f64(index, sets, setCount, one, k, within, output, distance)
                : vesica_index_nearest_f32(index, sets, setCount, one, k, (float)within, output, distance);
        }

        internal static long JoinNearest(bool wide, void* setsA, int setCountA, void* indexB, void* setsB,
            int setCountB, long k, double within, long part, long parts, void* output, void* distance)
        {
            return wide
                ? vesica_join_nearest_f64(setsA, setCountA, indexB, setsB, setCountB, k, within, part, parts, output,
                    distance)
                : vesica_join_nearest_f32(setsA, setCountA, indexB, setsB, setCountB, k, (float)within, part, parts,
                    output, distance);
        }

        internal static int Ratio(bool wide, int ratio, int kindA, void* numbersA, int kindB, void* numbersB,
            void* output)
        {
            return wide
                ? vesica_ratio_f64(ratio, kindA, numbersA, kindB, numbersB, output)
                : vesica_ratio_f32(ratio, kindA, numbersA, kindB, numbersB, output);
        }

        internal static long RatioMany(bool wide, int ratio, void* a, void* b, void* output)
        {
            return wide
                ? vesica_ratio_many_f64(ratio, a, b, output)
                : vesica_ratio_many_f32(ratio, a, b, output);
        }

        internal static long RatioMatrix(bool wide, int ratio, void* a, void* b, void* output, IntPtr rowStride)
        {
            return wide
                ? vesica_ratio_matrix_f64(ratio, a, b, output, rowStride)
                : vesica_ratio_matrix_f32(ratio, a, b, output, rowStride);
        }

        internal static long NearestMatrix(bool wide, void* a, void* b, void* output, IntPtr rowStride)
        {
            return wide
                ? vesica_nearest_matrix_f64(a, b, output, rowStride)
                : vesica_nearest_matrix_f32(a, b, output, rowStride);
        }

        internal static long BoundaryDistanceMatrix(bool wide, void* a, void* b, void* output, IntPtr rowStride)
        {
            return wide
                ? vesica_boundary_distance_matrix_f64(a, b, output, rowStride)
                : vesica_boundary_distance_matrix_f32(a, b, output, rowStride);
        }

        internal static long DepthMatrix(bool wide, void* a, void* b, void* output, IntPtr rowStride)
        {
            return wide
                ? vesica_depth_matrix_f64(a, b, output, rowStride)
                : vesica_depth_matrix_f32(a, b, output, rowStride);
        }

        internal static int SignedDistance(bool wide, int kindA, void* numbersA, int kindB, void* numbersB,
            void* output)
        {
            return wide
                ? vesica_signed_distance_f64(kindA, numbersA, kindB, numbersB, output)
                : vesica_signed_distance_f32(kindA, numbersA, kindB, numbersB, output);
        }

        internal static long SignedDistanceMany(bool wide, void* a, void* b, void* output)
        {
            return wide
                ? vesica_signed_distance_many_f64(a, b, output)
                : vesica_signed_distance_many_f32(a, b, output);
        }

        internal static long SignedDistanceMatrix(bool wide, void* a, void* b, void* output, IntPtr rowStride)
        {
            return wide
                ? vesica_signed_distance_matrix_f64(a, b, output, rowStride)
                : vesica_signed_distance_matrix_f32(a, b, output, rowStride);
        }

        internal static int Within(bool wide, int kindA, void* numbersA, int kindB, void* numbersB, double distance)
        {
            return wide
                ? vesica_within_f64(kindA, numbersA, kindB, numbersB, distance)
                : vesica_within_f32(kindA, numbersA, kindB, numbersB, (float)distance);
        }

        internal static long WithinMany(bool wide, void* a, void* b, double distance, void* output)
        {
            return wide
                ? vesica_within_many_f64(a, b, distance, output)
                : vesica_within_many_f32(a, b, (float)distance, output);
        }

        internal static long WithinMatrix(bool wide, void* a, void* b, double distance, void* output, IntPtr rowStride)
        {
            return wide
                ? vesica_within_matrix_f64(a, b, distance, output, rowStride)
                : vesica_within_matrix_f32(a, b, (float)distance, output, rowStride);
        }

        internal static int Suppress(bool wide, void* shapes, void* scores, void* labels, int ratio, double threshold,
            double leastScore, long most, void* scratch, long scratchSize, void* keep, void* kept)
        {
            return wide
                ? vesica_suppress_f64(shapes, scores, labels, ratio, threshold, leastScore, most, scratch, scratchSize,
                    keep, kept)
                : vesica_suppress_f32(shapes, scores, labels, ratio, (float)threshold, (float)leastScore, most, scratch,
                    scratchSize, keep, kept);
        }

        internal static int SuppressSoft(bool wide, void* shapes, void* scores, void* labels, int ratio, int decay,
            double parameter, double leastScore, long most, void* scratch, long scratchSize, void* keep, void* decayed,
            void* kept)
        {
            return wide
                ? vesica_suppress_soft_f64(shapes, scores, labels, ratio, decay, parameter, leastScore, most, scratch,
                    scratchSize, keep, decayed, kept)
                : vesica_suppress_soft_f32(shapes, scores, labels, ratio, decay, (float)parameter, (float)leastScore,
                    most, scratch, scratchSize, keep, decayed, kept);
        }

        internal static int Cast(bool wide, int kindA, void* numbersA, int kindB, void* numbersB, double vx, double vy,
            double tEnd, void* output)
        {
            return wide
                ? vesica_cast_f64(kindA, numbersA, kindB, numbersB, vx, vy, tEnd, output)
                : vesica_cast_f32(kindA, numbersA, kindB, numbersB, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static long CastMany(bool wide, void* a, void* b, void* vx, void* vy, IntPtr stride, double tEnd,
            void* t, void* x, void* y, void* nx, void* ny)
        {
            return wide
                ? vesica_cast_many_f64(a, b, vx, vy, stride, tEnd, t, x, y, nx, ny)
                : vesica_cast_many_f32(a, b, vx, vy, stride, (float)tEnd, t, x, y, nx, ny);
        }

        internal static long CastFirst(bool wide, void* one, void* many, double vx, double vy, double tEnd,
            void* output)
        {
            return wide
                ? vesica_cast_first_f64(one, many, vx, vy, tEnd, output)
                : vesica_cast_first_f32(one, many, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static int SweepBounds(bool wide, int kind, void* numbers, double vx, double vy, double tEnd,
            void* output)
        {
            return wide
                ? vesica_sweep_bounds_f64(kind, numbers, vx, vy, tEnd, output)
                : vesica_sweep_bounds_f32(kind, numbers, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static long IndexCast(bool wide, void* index, void* sets, int setCount, void* one, double vx,
            double vy, double tEnd, void* output, long capacity, void* state)
        {
            return wide
                ? vesica_index_cast_f64(index, sets, setCount, one, vx, vy, tEnd, output, capacity, state)
                : vesica_index_cast_f32(index, sets, setCount, one, (float)vx, (float)vy, (float)tEnd, output, capacity,
                    state);
        }

        internal static long IndexCastFirst(bool wide, void* index, void* sets, int setCount, void* one, double vx,
            double vy, double tEnd, void* output)
        {
            return wide
                ? vesica_index_cast_first_f64(index, sets, setCount, one, vx, vy, tEnd, output)
                : vesica_index_cast_first_f32(index, sets, setCount, one, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static int ImpactTime(bool wide, int kindA, void* numbersA, void* turnA, int kindB, void* numbersB,
            void* turnB, double tolerance, void* output, void* gap)
        {
            return wide
                ? vesica_impact_time_f64(kindA, numbersA, turnA, kindB, numbersB, turnB, tolerance, output, gap)
                : vesica_impact_time_f32(kindA, numbersA, turnA, kindB, numbersB, turnB, (float)tolerance, output, gap);
        }

        internal static int CastPointPoint(bool wide, void* a, void* b, double vx, double vy, double tEnd, void* output)
        {
            return wide
                ? vesica_cast_point_point_f64(a, b, vx, vy, tEnd, output)
                : vesica_cast_point_point_f32(a, b, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static int CastSegmentPoint(bool wide, void* a, void* b, double vx, double vy, double tEnd,
            void* output)
        {
            return wide
                ? vesica_cast_segment_point_f64(a, b, vx, vy, tEnd, output)
                : vesica_cast_segment_point_f32(a, b, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static int CastCirclePoint(bool wide, void* a, void* b, double vx, double vy, double tEnd,
            void* output)
        {
            return wide
                ? vesica_cast_circle_point_f64(a, b, vx, vy, tEnd, output)
                : vesica_cast_circle_point_f32(a, b, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static int CastAabbPoint(bool wide, void* a, void* b, double vx, double vy, double tEnd, void* output)
        {
            return wide
                ? vesica_cast_aabb_point_f64(a, b, vx, vy, tEnd, output)
                : vesica_cast_aabb_point_f32(a, b, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static int CastRectPoint(bool wide, void* a, void* b, double vx, double vy, double tEnd, void* output)
        {
            return wide
                ? vesica_cast_rect_point_f64(a, b, vx, vy, tEnd, output)
                : vesica_cast_rect_point_f32(a, b, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static int CastEllipsePoint(bool wide, void* a, void* b, double vx, double vy, double tEnd,
            void* output)
        {
            return wide
                ? vesica_cast_ellipse_point_f64(a, b, vx, vy, tEnd, output)
                : vesica_cast_ellipse_point_f32(a, b, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static int CastCircleCircle(bool wide, void* a, void* b, double vx, double vy, double tEnd,
            void* output)
        {
            return wide
                ? vesica_cast_circle_circle_f64(a, b, vx, vy, tEnd, output)
                : vesica_cast_circle_circle_f32(a, b, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static int CastRectRect(bool wide, void* a, void* b, double vx, double vy, double tEnd, void* output)
        {
            return wide
                ? vesica_cast_rect_rect_f64(a, b, vx, vy, tEnd, output)
                : vesica_cast_rect_rect_f32(a, b, (float)vx, (float)vy, (float)tEnd, output);
        }

        internal static int De9im(bool wide, int kindA, void* numbersA, int kindB, void* numbersB, void* matrix)
        {
            return wide
                ? vesica_de9im_f64(kindA, numbersA, kindB, numbersB, matrix)
                : vesica_de9im_f32(kindA, numbersA, kindB, numbersB, matrix);
        }

        internal static int Intersection(bool wide, int kindA, void* numbersA, int kindB, void* numbersB,
            void* vertices)
        {
            return wide
                ? vesica_intersection_f64(kindA, numbersA, kindB, numbersB, vertices)
                : vesica_intersection_f32(kindA, numbersA, kindB, numbersB, vertices);
        }
    }
}
