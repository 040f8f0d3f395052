// SPDX-License-Identifier: Apache-2.0
// Written by capi/declare from capi/vesica.json: not to be edited.
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
        /// <para>Version of the loaded library, to be compared with VESICA_VERSION: a smaller one is older than the
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
        /// <para>What an error code means, as one English phrase without a final stop.</para>
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
        /// <para>Name of the instruction set that batches run on: the best that this processor has. Answers never
        /// depend on it.</para>
        /// <para>The environment variable VESICA_ISA forces another one. It is read once, when the library is loaded. A
        /// name that is unknown, or of a set that the processor lacks, is ignored.</para>
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
        /// all but the outline. If several relations fit, VESICA_EQUAL comes first, then those of containment, then
        /// VESICA_CROSS. So a segment that ends on the middle of another touches it, two segments along one line that
        /// overlap in part cross, and a point on the rim of a disc is inside with touch. Exchanging the shapes always
        /// gives the converse relation.</para>
        /// <para>Returns: VESICA_DISJOINT ... VESICA_EQUAL. Equal sets are VESICA_EQUAL, whatever kinds and numbers
        /// describe them.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: up to twice that of vesica_overlap_f64; 0.1 to 8 us if shapes touch or are equal, at worst
        /// 30.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_relation_f64(int kindA, void* numbersA, int kindB, void* numbersB);

        /// <summary>
        /// <para>Does a contain all of b? A shape contains itself, and what touches its outline from inside.</para>
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
        /// are their own outlines. A contact of any order is one place. If straight outlines have a stretch in common,
        /// its two end points are places, and out-&gt;shared is 1. So equal boxes have their four corners. Equal curves
        /// have no single places: then the count is 0 and out-&gt;shared is 1. Places come in order along a's outline,
        /// counter-clockwise in the frame of its axis. The start is a box's corner C - hx u - hy perp(u), an ellipse's
        /// point C + a u, a circle's point C + (r, 0), or a segment's first end.</para>
        /// <para>Returns: the number of places, 0 to 8.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the number is exact. A place is right to 4 u times the largest coordinate or size of either
        /// shape, however closely the outlines touch or coincide. Places closer to one another than that may come in
        /// either order or be equal. Bounds on computed numbers use u = 2^-53. The scale of two shapes is the largest
        /// of |dx| and |dy| between their centres and of their half lengths. An aspect ratio is a shape's longer size
        /// over its shorter one.</para>
        /// <para>Cost: 1 to 10 us; at worst 100 us, where exponents are wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_crossings_f64(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>How far apart are two solid shapes, and which of their points are closest?</para>
        /// <para>If the shapes overlap (as vesica_overlap_f64 tells), the distance is 0 and both points are one common
        /// point. If not, the distance is &gt; 0. Exchanging the shapes exchanges the points and changes no bit. Moving
        /// both shapes by the same exact amounts changes no bit of the distance.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the distance is right to 4 u scale at any aspect ratio; the largest error seen was 1 u
        /// scale. It is right to 2 u of itself if it is above 1e-10 scale (aspect ratios up to 1e6) or above 1e-14
        /// scale (up to 1000). Before their coordinates are rounded, closest points are within 4 u scale of the
        /// outlines, and a common point is within 8 u scale of both shapes. Bounds on computed numbers use u = 2^-53.
        /// The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths. An
        /// aspect ratio is a shape's longer size over its shorter one.</para>
        /// <para>Cost: 100 to 200 ns for disjoint shapes, 300 ns for the thinnest ellipses; 50 ns if a shape holds the
        /// other's centre; 0.3 to 3 us for shapes that cross, for ties within rounding and for magnitudes beyond
        /// 2^+-40; at worst 40.</para>
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
        /// Exchanging the shapes exchanges the points and changes no bit. Moving both shapes by the same exact amounts
        /// changes no bit of the distance.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: at aspect ratios up to 1e6 the distance is right to 4 u scale, and the points are that far
        /// apart to 16 u scale. At any, it is above 0 if outlines do not meet, and points are on them to 12 u scale
        /// before they are rounded. Bounds on computed numbers use u = 2^-53. The scale of two shapes is the largest of
        /// |dx| and |dy| between their centres and of their half lengths. An aspect ratio is a shape's longer size over
        /// its shorter one.</para>
        /// <para>Cost: that of vesica_nearest_f64 for disjoint shapes; 0.1 to 0.5 us for nested ones, 1 us more for
        /// few; 0.5 to 2 us for a common point, of needles as vesica_crossings_f64; 5 us more if exact arithmetic must
        /// tell; at worst 100 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_boundary_distance_f64(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>Penetration depth: how far and which way must b be moved until the two shapes only touch?</para>
        /// <para>Moving b by out-&gt;depth along the unit vector (x, y) is the shortest translation after which a line
        /// separates the shapes: a on one side, b on the other, where both may touch the line. For disjoint shapes all
        /// three numbers are 0. Overlapping shapes always get a direction. Their depth is 0 if such a line is there
        /// already: if they touch from outside, if a point lies on an outline, or if points and segments lie along one
        /// line. Otherwise the depth is &gt; 0. Exchanging the shapes reverses the direction and changes no other bit,
        /// except for two equal shapes in one place. Moving both shapes by the same exact amounts changes no
        /// bit.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: at aspect ratios up to 1e6 the depth is right to 4 u scale; of two circles, and of a point
        /// and a circle, to its last place. The length of (x, y) is 1 but for 3 u, and it moves b clear but for 8 u
        /// scale. Whether the depth is 0 is exact. Bounds on computed numbers use u = 2^-53. The scale of two shapes is
        /// the largest of |dx| and |dy| between their centres and of their half lengths. An aspect ratio is a shape's
        /// longer size over its shorter one.</para>
        /// <para>Cost: about 150 ns for points, segments and boxes; 0.5 us with an ellipse, and 1 us more for few of
        /// these; up to 5 us if only exact arithmetic can tell the depth from 0; at worst 40 us, where exponents are
        /// wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_depth_f64(int kindA, void* numbersA, int kindB, void* numbersB, void* output);

        /// <summary>
        /// <para>Area of one shape: 4 hx hy u.u of a rectangle, pi a b u.u of an ellipse, 0 of a point or a
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
        /// <para>Accuracy: within 64 u of the smaller shape's area times the larger aspect ratio, at aspect ratios up
        /// to 10^4, however near the outlines are to touching or coinciding and however different the sizes are. Bounds
        /// on computed numbers use u = 2^-53. The scale of two shapes is the largest of |dx| and |dy| between their
        /// centres and of their half lengths. An aspect ratio is a shape's longer size over its shorter one.</para>
        /// <para>Cost: about 50 ns for two boxes, 150 ns for an ellipse and a box, 0.6 us for two ellipses; up to 10 us
        /// if outlines nearly touch or coincide, or if one shape is far larger; at worst 40 us, where exponents are
        /// wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_area_f64(int kindA, void* numbersA, int kindB, void* numbersB, void* output);

        /// <summary>
        /// <para>Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover
        /// together.</para>
        /// <para>It is exactly 1 for equal shapes and exactly 0 for shapes that share no area. Nothing overflows or
        /// underflows on the way, whatever the sizes. Exchanging the shapes, or scaling both by a power of two, changes
        /// no bit.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (neither shape has an
        /// area).</para>
        /// <para>Accuracy: the bound of vesica_area_f64, over the area of the union.</para>
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
        /// <para>Cost: up to 80 ns; 1 to 3 us for magnitudes beyond 2^+-400, and for an ellipse with an oblique axis
        /// and representable sides; at worst 20 us.</para>
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
        /// <para>Accuracy: the axis is (cos, sin), each right to 1 unit in the last place. No number is exactly a
        /// quarter turn, so the axis of one is parallel to a coordinate axis only to that rounding. Sizes are exact: if
        /// halving one would round (an odd multiple of the smallest subnormal number), the axis is halved
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
        /// the longer one; the centre is right to 1 unit in its own. To both comes 2^-98 times the largest coordinate.
        /// The corners of an axis-parallel rectangle give exactly it if its centre and half extents are
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
        /// <para>Accuracy: the axis as that of vesica_rect_from_angle_f64; half lengths are exact.</para>
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
        /// however near the matrix is to a singular one or to a circle's.</para>
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
        /// <para>Accuracy: that of vesica_ellipse_from_covariance_f64; no half length overflows.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: in cache, from columns, with AVX-512: 0.6 to 1.1 ns a pair in double, 0.3 to 0.5 ns in float
        /// (see README.md).</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_iou_many_f64(void* a, void* b, void* output);

        /// <summary>
        /// <para>Do a[i] and b[j] share a point? The elements of out are answers of vesica_overlap_f64.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. It is at least b's count, unless a's count is at most 1, or negative: then the rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows
        /// that overlap, or an array or rows beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: that of one shape against many, however large the arrays are.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_overlap_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>How does a[i] relate to b[j]? The elements of out are answers of vesica_relation_f64.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. It is at least b's count, unless a's count is at most 1, or negative: then the rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are not VESICA_DISJOINT.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows
        /// that overlap, or an array or rows beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: that of one shape against many, however large the arrays are.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_relation_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Does a[i] contain all of b[j]? The elements of out are answers of vesica_contains_f64.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. It is at least b's count, unless a's count is at most 1, or negative: then the rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows
        /// that overlap, or an array or rows beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: that of one shape against many, however large the arrays are.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_contains_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>What area do a[i] and b[j] share? The elements of out are results of vesica_area_f64.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. It is at least b's count, unless a's count is at most 1, or negative: then the rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows
        /// that overlap, or an array or rows beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: that of one shape against many, however large the arrays are.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_area_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Intersection over union of a[i] and b[j]. The elements of out are results of vesica_iou_f64.</para>
        /// <para>If neither of a pair has an area, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape
        /// is invalid.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. It is at least b's count, unless a's count is at most 1, or negative: then the rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows
        /// that overlap, or an array or rows beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: that of one shape against many, however large the arrays are.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_iou_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Which of many shapes overlap one? Their indices are written to out[0], out[1] ..., in ascending
        /// order.</para>
        /// <para>Requires: one, an array of count 1; capacity, how many indices out has room for. It may be 0, and out
        /// then NULL.</para>
        /// <para>Returns: how many there are, even if that is beyond the capacity. If room is left, the entry after the
        /// last is -1.</para>
        /// <para>Errors: VESICA_E_SHAPE if a shape is invalid: it is not selected, and the indices of valid ones are
        /// written; -1 or the capacity ends them. Before anything is written: VESICA_E_NULL, VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (one's count is not 1, a negative capacity, and as vesica_overlap_many_f64).</para>
        /// <para>Accuracy: every answer is that of vesica_overlap_f64.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_overlap_select_f64(void* one, void* many, void* output, long capacity);

        /// <summary>
        /// <para>Bytes of scratch memory that vesica_nms_f64 and vesica_nms_f32 need for that many shapes.</para>
        /// <para>Returns: about 97 bytes for each, and 380,416.</para>
        /// <para>Errors: VESICA_E_ARGUMENT (a negative count, or one above 2147483647).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_nms_scratch(long count);

        /// <summary>
        /// <para>Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps
        /// each one whose vesica_iou_f64 with every shape kept before is at most the threshold.</para>
        /// <para>Equal scores go by index, and infinite scores are legal. At threshold 1 all shapes are kept.</para>
        /// <para>Requires: shapes, of a kind from VESICA_CIRCLE to VESICA_ELLIPSE; scores, one for each; threshold from
        /// 0 to 1; scratch, of vesica_nms_scratch bytes or more, with any alignment and content; keep, with room for
        /// all indices.</para>
        /// <para>Returns: 0. keep has the indices of the kept shapes in the order of their scores, and *kept how many
        /// they are. What follows them in keep is not written.</para>
        /// <para>Errors: VESICA_E_SHAPE if a shape is invalid or its score is NaN: the result is that without it, and
        /// is written. Before anything is written: VESICA_E_NULL (if there are no shapes, only shapes and kept are
        /// looked at), VESICA_E_KIND (points and segments too), VESICA_E_ARGUMENT (the array as
        /// vesica_overlap_many_f64, threshold, too little scratch).</para>
        /// <para>Cost: an index, sorting, and an IoU where bounds and areas allow one above the threshold: 0.3 to 1.2
        /// us a shape.</para>
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
        /// all but the outline. If several relations fit, VESICA_EQUAL comes first, then those of containment, then
        /// VESICA_CROSS. So a segment that ends on the middle of another touches it, two segments along one line that
        /// overlap in part cross, and a point on the rim of a disc is inside with touch. Exchanging the shapes always
        /// gives the converse relation.</para>
        /// <para>Returns: VESICA_DISJOINT ... VESICA_EQUAL. Equal sets are VESICA_EQUAL, whatever kinds and numbers
        /// describe them.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: up to twice that of vesica_overlap_f32; 0.1 to 8 us if shapes touch or are equal, at worst
        /// 30.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_relation_f32(int kindA, void* numbersA, int kindB, void* numbersB);

        /// <summary>
        /// <para>Does a contain all of b? A shape contains itself, and what touches its outline from inside.</para>
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
        /// are their own outlines. A contact of any order is one place. If straight outlines have a stretch in common,
        /// its two end points are places, and out-&gt;shared is 1. So equal boxes have their four corners. Equal curves
        /// have no single places: then the count is 0 and out-&gt;shared is 1. Places come in order along a's outline,
        /// counter-clockwise in the frame of its axis. The start is a box's corner C - hx u - hy perp(u), an ellipse's
        /// point C + a u, a circle's point C + (r, 0), or a segment's first end.</para>
        /// <para>Returns: the number of places, 0 to 8.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the number is exact. A place is right to 4 u times the largest coordinate or size of either
        /// shape, however closely the outlines touch or coincide. Places closer to one another than that may come in
        /// either order or be equal. Each number is computed in double, within these bounds, and then rounded to float
        /// once. Bounds on computed numbers use u = 2^-53. The scale of two shapes is the largest of |dx| and |dy|
        /// between their centres and of their half lengths. An aspect ratio is a shape's longer size over its shorter
        /// one.</para>
        /// <para>Cost: 1 to 10 us; at worst 100 us, where exponents are wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_crossings_f32(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>How far apart are two solid shapes, and which of their points are closest?</para>
        /// <para>If the shapes overlap (as vesica_overlap_f32 tells), the distance is 0 and both points are one common
        /// point. If not, the distance is &gt; 0. Exchanging the shapes exchanges the points and changes no bit. Moving
        /// both shapes by the same exact amounts changes no bit of the distance.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: the distance is right to 4 u scale at any aspect ratio; the largest error seen was 1 u
        /// scale. It is right to 2 u of itself if it is above 1e-10 scale (aspect ratios up to 1e6) or above 1e-14
        /// scale (up to 1000). Before their coordinates are rounded, closest points are within 4 u scale of the
        /// outlines, and a common point is within 8 u scale of both shapes. Each number is computed in double, within
        /// these bounds, and then rounded to float once. Bounds on computed numbers use u = 2^-53. The scale of two
        /// shapes is the largest of |dx| and |dy| between their centres and of their half lengths. An aspect ratio is a
        /// shape's longer size over its shorter one.</para>
        /// <para>Cost: 100 to 200 ns for disjoint shapes, 300 ns for the thinnest ellipses; 50 ns if a shape holds the
        /// other's centre; 0.3 to 3 us for shapes that cross, for ties within rounding and for magnitudes beyond
        /// 2^+-40; at worst 40.</para>
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
        /// Exchanging the shapes exchanges the points and changes no bit. Moving both shapes by the same exact amounts
        /// changes no bit of the distance.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: at aspect ratios up to 1e6 the distance is right to 4 u scale, and the points are that far
        /// apart to 16 u scale. At any, it is above 0 if outlines do not meet, and points are on them to 12 u scale
        /// before they are rounded. Each number is computed in double, within these bounds, and then rounded to float
        /// once. Bounds on computed numbers use u = 2^-53. The scale of two shapes is the largest of |dx| and |dy|
        /// between their centres and of their half lengths. An aspect ratio is a shape's longer size over its shorter
        /// one.</para>
        /// <para>Cost: that of vesica_nearest_f32 for disjoint shapes; 0.1 to 0.5 us for nested ones, 1 us more for
        /// few; 0.5 to 2 us for a common point, of needles as vesica_crossings_f32; 5 us more if exact arithmetic must
        /// tell; at worst 100 us.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_boundary_distance_f32(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>Penetration depth: how far and which way must b be moved until the two shapes only touch?</para>
        /// <para>Moving b by out-&gt;depth along the unit vector (x, y) is the shortest translation after which a line
        /// separates the shapes: a on one side, b on the other, where both may touch the line. For disjoint shapes all
        /// three numbers are 0. Overlapping shapes always get a direction. Their depth is 0 if such a line is there
        /// already: if they touch from outside, if a point lies on an outline, or if points and segments lie along one
        /// line. Otherwise the depth is &gt; 0. Exchanging the shapes reverses the direction and changes no other bit,
        /// except for two equal shapes in one place. Moving both shapes by the same exact amounts changes no
        /// bit.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: at aspect ratios up to 1e6 the depth is right to 4 u scale; of two circles, and of a point
        /// and a circle, to its last place. The length of (x, y) is 1 but for 3 u, and it moves b clear but for 8 u
        /// scale. Whether the depth is 0 is exact. Each number is computed in double, within these bounds, and then
        /// rounded to float once. Bounds on computed numbers use u = 2^-53. The scale of two shapes is the largest of
        /// |dx| and |dy| between their centres and of their half lengths. An aspect ratio is a shape's longer size over
        /// its shorter one.</para>
        /// <para>Cost: about 150 ns for points, segments and boxes; 0.5 us with an ellipse, and 1 us more for few of
        /// these; up to 5 us if only exact arithmetic can tell the depth from 0; at worst 40 us, where exponents are
        /// wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_depth_f32(int kindA, void* numbersA, int kindB, void* numbersB, void* output);

        /// <summary>
        /// <para>Area of one shape: 4 hx hy u.u of a rectangle, pi a b u.u of an ellipse, 0 of a point or a
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
        /// <para>Accuracy: within 64 u of the smaller shape's area times the larger aspect ratio, at aspect ratios up
        /// to 10^4, however near the outlines are to touching or coinciding and however different the sizes are. Each
        /// number is computed in double, within these bounds, and then rounded to float once. Bounds on computed
        /// numbers use u = 2^-53. The scale of two shapes is the largest of |dx| and |dy| between their centres and of
        /// their half lengths. An aspect ratio is a shape's longer size over its shorter one.</para>
        /// <para>Cost: about 50 ns for two boxes, 150 ns for an ellipse and a box, 0.6 us for two ellipses; up to 10 us
        /// if outlines nearly touch or coincide, or if one shape is far larger; at worst 40 us, where exponents are
        /// wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_area_f32(int kindA, void* numbersA, int kindB, void* numbersB, void* output);

        /// <summary>
        /// <para>Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover
        /// together.</para>
        /// <para>It is exactly 1 for equal shapes and exactly 0 for shapes that share no area. Nothing overflows or
        /// underflows on the way, whatever the sizes. Exchanging the shapes, or scaling both by a power of two, changes
        /// no bit.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (neither shape has an
        /// area).</para>
        /// <para>Accuracy: the bound of vesica_area_f32, over the area of the union.
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
        /// <para>Cost: up to 80 ns; 1 to 3 us for magnitudes beyond 2^+-400, and for an ellipse with an oblique axis
        /// and representable sides; at worst 20 us.</para>
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
        /// <para>Accuracy: the axis is (cos, sin), each right to 1 unit in the last place. No number is exactly a
        /// quarter turn, so the axis of one is parallel to a coordinate axis only to that rounding. Sizes are exact: if
        /// halving one would round (an odd multiple of the smallest subnormal number), the axis is halved
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
        /// the longer one; the centre is right to 1 unit in its own. To both comes 2^-98 times the largest coordinate.
        /// The corners of an axis-parallel rectangle give exactly it if its centre and half extents are
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
        /// <para>Accuracy: the axis as that of vesica_rect_from_angle_f32; half lengths are exact.</para>
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
        /// however near the matrix is to a singular one or to a circle's.</para>
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
        /// <para>Accuracy: that of vesica_ellipse_from_covariance_f32; no half length overflows.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: in cache, from columns, with AVX-512: 0.6 to 1.1 ns a pair in double, 0.3 to 0.5 ns in float
        /// (see README.md).</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
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
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (counts that are negative or do not agree,
        /// reserved is not 0, or an array that is beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_iou_many_f32(void* a, void* b, void* output);

        /// <summary>
        /// <para>Do a[i] and b[j] share a point? The elements of out are answers of vesica_overlap_f32.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. It is at least b's count, unless a's count is at most 1, or negative: then the rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows
        /// that overlap, or an array or rows beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: that of one shape against many, however large the arrays are.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_overlap_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>How does a[i] relate to b[j]? The elements of out are answers of vesica_relation_f32.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. It is at least b's count, unless a's count is at most 1, or negative: then the rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are not VESICA_DISJOINT.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows
        /// that overlap, or an array or rows beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: that of one shape against many, however large the arrays are.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_relation_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Does a[i] contain all of b[j]? The elements of out are answers of vesica_contains_f32.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. It is at least b's count, unless a's count is at most 1, or negative: then the rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are 1.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows
        /// that overlap, or an array or rows beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: that of one shape against many, however large the arrays are.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_contains_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>What area do a[i] and b[j] share? The elements of out are results of vesica_area_f32.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. It is at least b's count, unless a's count is at most 1, or negative: then the rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows
        /// that overlap, or an array or rows beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: that of one shape against many, however large the arrays are.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_area_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Intersection over union of a[i] and b[j]. The elements of out are results of vesica_iou_f32.</para>
        /// <para>If neither of a pair has an area, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape
        /// is invalid.</para>
        /// <para>Requires: room for a matrix: out[i * row_stride + j] is the result for a[i] and b[j]. row_stride
        /// counts elements of out. It is at least b's count, unless a's count is at most 1, or negative: then the rows
        /// run backwards in memory.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid: its results are 0 (bytes) or NaN (numbers), and all
        /// others are written as usual. Before anything is written: VESICA_E_NULL (if there is nothing to answer,
        /// fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, reserved is not 0, rows
        /// that overlap, or an array or rows beyond the address space).</para>
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Cost: that of one shape against many, however large the arrays are.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_iou_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Which of many shapes overlap one? Their indices are written to out[0], out[1] ..., in ascending
        /// order.</para>
        /// <para>Requires: one, an array of count 1; capacity, how many indices out has room for. It may be 0, and out
        /// then NULL.</para>
        /// <para>Returns: how many there are, even if that is beyond the capacity. If room is left, the entry after the
        /// last is -1.</para>
        /// <para>Errors: VESICA_E_SHAPE if a shape is invalid: it is not selected, and the indices of valid ones are
        /// written; -1 or the capacity ends them. Before anything is written: VESICA_E_NULL, VESICA_E_KIND,
        /// VESICA_E_ARGUMENT (one's count is not 1, a negative capacity, and as vesica_overlap_many_f32).</para>
        /// <para>Accuracy: every answer is that of vesica_overlap_f32.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_overlap_select_f32(void* one, void* many, void* output, long capacity);

        /// <summary>
        /// <para>Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps
        /// each one whose vesica_iou_f32 with every shape kept before is at most the threshold.</para>
        /// <para>Equal scores go by index, and infinite scores are legal. At threshold 1 all shapes are kept.</para>
        /// <para>Requires: shapes, of a kind from VESICA_CIRCLE to VESICA_ELLIPSE; scores, one for each; threshold from
        /// 0 to 1; scratch, of vesica_nms_scratch bytes or more, with any alignment and content; keep, with room for
        /// all indices.</para>
        /// <para>Returns: 0. keep has the indices of the kept shapes in the order of their scores, and *kept how many
        /// they are. What follows them in keep is not written.</para>
        /// <para>Errors: VESICA_E_SHAPE if a shape is invalid or its score is NaN: the result is that without it, and
        /// is written. Before anything is written: VESICA_E_NULL (if there are no shapes, only shapes and kept are
        /// looked at), VESICA_E_KIND (points and segments too), VESICA_E_ARGUMENT (the array as
        /// vesica_overlap_many_f32, threshold, too little scratch).</para>
        /// <para>Cost: an index, sorting, and an IoU where bounds and areas allow one above the threshold: 0.3 to 1.2
        /// us a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_nms_f32(void* shapes, void* scores, float threshold, void* scratch,
            long scratchSize, void* keep, void* kept);

        /// <summary>
        /// <para>Rectangles from boxes.</para>
        /// <para>Requires: boxes, `count` rows of five numbers with any alignment, `stride` bytes apart; out, room for
        /// `count`.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would be
        /// beyond the finite ones: its result is NaN throughout, and all others are written as usual. Before anything
        /// is written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array beyond the address space, an unknown unit of angles).</para>
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
        /// <para>Ellipses from the boxes about them, whose sides they touch in the middle.</para>
        /// <para>Requires: as vesica_rects_from_boxes_f64.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would be
        /// beyond the finite ones: its result is NaN throughout, and all others are written as usual. Before anything
        /// is written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array beyond the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: as vesica_rects_from_boxes_f64. Half lengths are halves of width and height.</para>
        /// <para>Cost: about 30 ns a box.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_ellipses_from_boxes_f64(void* boxes, long count, IntPtr stride, int angle,
            void* output);

        /// <summary>
        /// <para>Boxes from rectangles, or about ellipses: the way back.</para>
        /// <para>An angle is from -180 to 180 degrees.</para>
        /// <para>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; boxes, room for `count` rows of five numbers,
        /// without gaps.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would be
        /// beyond the finite ones: its result is NaN throughout, and all others are written as usual. Before anything
        /// is written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array beyond the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: width and height are right to 4 units in the last place, and the angle to 2 units in the
        /// last place of a quarter turn. Of an axis that is exactly along a coordinate axis, degrees and quarter turns
        /// are exact.</para>
        /// <para>Cost: about 70 ns a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_boxes_from_shapes_f64(void* shapes, int angle, void* boxes);

        /// <summary>
        /// <para>The four corners of rectangles, or of the boxes about ellipses: x0 y0 ... x3 y3.</para>
        /// <para>Corners go round from C - hx u - hy perp(u) to C + hx u - hy perp(u).</para>
        /// <para>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; corners, room for `count` rows of eight
        /// numbers.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would be
        /// beyond the finite ones: its result is NaN throughout, and all others are written as usual. Before anything
        /// is written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array beyond the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: a coordinate is right to 1 unit in its last place and 2^-98 times the largest of its three
        /// terms.</para>
        /// <para>Cost: about 70 ns a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_corners_of_shapes_f64(void* shapes, void* corners);

        /// <summary>
        /// <para>The bounds of shapes of any kind: out[i] is the result of vesica_bounds_f64.</para>
        /// <para>Requires: out, room for `count`.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would be
        /// beyond the finite ones: its result is NaN throughout, and all others are written as usual. Before anything
        /// is written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array beyond the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: that of vesica_bounds_f64.</para>
        /// <para>Cost: that of vesica_bounds_f64.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_bounds_many_f64(void* shapes, void* output);

        /// <summary>
        /// <para>Rectangles from boxes.</para>
        /// <para>Requires: boxes, `count` rows of five numbers with any alignment, `stride` bytes apart; out, room for
        /// `count`.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would be
        /// beyond the finite ones: its result is NaN throughout, and all others are written as usual. Before anything
        /// is written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array beyond the address space, an unknown unit of angles).</para>
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
        /// <para>Ellipses from the boxes about them, whose sides they touch in the middle.</para>
        /// <para>Requires: as vesica_rects_from_boxes_f32.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would be
        /// beyond the finite ones: its result is NaN throughout, and all others are written as usual. Before anything
        /// is written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array beyond the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: as vesica_rects_from_boxes_f32. Half lengths are halves of width and height.
        /// Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: about 30 ns a box.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_ellipses_from_boxes_f32(void* boxes, long count, IntPtr stride, int angle,
            void* output);

        /// <summary>
        /// <para>Boxes from rectangles, or about ellipses: the way back.</para>
        /// <para>An angle is from -180 to 180 degrees.</para>
        /// <para>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; boxes, room for `count` rows of five numbers,
        /// without gaps.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would be
        /// beyond the finite ones: its result is NaN throughout, and all others are written as usual. Before anything
        /// is written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array beyond the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: width and height are right to 4 units in the last place, and the angle to 2 units in the
        /// last place of a quarter turn. Of an axis that is exactly along a coordinate axis, degrees and quarter turns
        /// are exact. Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: about 70 ns a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_boxes_from_shapes_f32(void* shapes, int angle, void* boxes);

        /// <summary>
        /// <para>The four corners of rectangles, or of the boxes about ellipses: x0 y0 ... x3 y3.</para>
        /// <para>Corners go round from C - hx u - hy perp(u) to C + hx u - hy perp(u).</para>
        /// <para>Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; corners, room for `count` rows of eight
        /// numbers.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would be
        /// beyond the finite ones: its result is NaN throughout, and all others are written as usual. Before anything
        /// is written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array beyond the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: a coordinate is right to 1 unit in its last place and 2^-98 times the largest of its three
        /// terms. Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: about 70 ns a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_corners_of_shapes_f32(void* shapes, void* corners);

        /// <summary>
        /// <para>The bounds of shapes of any kind: out[i] is the result of vesica_bounds_f32.</para>
        /// <para>Requires: out, room for `count`.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would be
        /// beyond the finite ones: its result is NaN throughout, and all others are written as usual. Before anything
        /// is written: VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative
        /// count, an array beyond the address space, an unknown unit of angles).</para>
        /// <para>Accuracy: that of vesica_bounds_f32.</para>
        /// <para>Cost: that of vesica_bounds_f32.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_bounds_many_f32(void* shapes, void* output);

        /// <summary>
        /// <para>How many bytes suffice for an index of `count` shapes, of any kinds?</para>
        /// <para>Returns: 17 bytes a shape and 64 KiB. A built index takes fewer, mostly 13 a shape: vesica_index_bytes
        /// tells.</para>
        /// <para>Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_size(long count);

        /// <summary>
        /// <para>How many bytes of scratch does building an index of `count` shapes need?</para>
        /// <para>Returns: about 18 bytes a shape, and a constant.</para>
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
        /// <para>Are these bytes an index that queries can read?</para>
        /// <para>Ask it once of bytes that come from elsewhere. They may be short, foreign or damaged, or from a
        /// machine of the other byte order. What passes is safe to read.</para>
        /// <para>Requires: size is the number of bytes there. The index may be shorter.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (it is
        /// none).</para>
        /// <para>Cost: it reads all bytes once.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_index_check(void* index, long size);

        /// <summary>
        /// <para>How many bytes does a built index take? So many are to be saved.</para>
        /// <para>Returns: the bytes, a multiple of 64.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (its header is
        /// none).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_bytes(void* index);

        /// <summary>
        /// <para>How many shapes was an index built from?</para>
        /// <para>Returns: the number of its items, invalid shapes included.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (its header is
        /// none).</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_count(void* index);

        /// <summary>
        /// <para>A box around all valid shapes of an index.</para>
        /// <para>Indexes whose boxes are disjoint have no pairs.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (its header is
        /// none).</para>
        /// <para>Accuracy: the box is a little larger than the smallest one. It is infinite where that exceeds the
        /// finite numbers. Without valid shapes min is infinity and max is -infinity.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_index_bounds(void* index, void* output);

        /// <summary>
        /// <para>The items of an index in spatial order: shapes that are near to each other stand near to each
        /// other.</para>
        /// <para>A join is faster if the arrays of shapes have this order, for then it reads them from near to
        /// near.</para>
        /// <para>Requires: out has room for `capacity` items. It may be NULL if that is 0.</para>
        /// <para>Returns: how many items there are, without the invalid shapes. The first `capacity` of them are
        /// written.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned, capacity &lt; 0),
        /// VESICA_E_INDEX.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_order(void* index, void* output, long capacity);

        /// <summary>
        /// <para>Builds the index of some sets of shapes.</para>
        /// <para>Invalid shapes are left out. The call then returns VESICA_E_SHAPE, and the index of all others is
        /// complete. After any other error nothing is written. Shapes that moved need a new index.</para>
        /// <para>Requires: index_size &gt;= vesica_index_size(items) and scratch_size &gt;=
        /// vesica_index_scratch(items). The scratch is free again after the call.</para>
        /// <para>Returns: the bytes of the index that are used.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a count, a size or an alignment),
        /// VESICA_E_SHAPE.</para>
        /// <para>Cost: 30 to 50 ns a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_build_f64(void* sets, int setCount, void* index, long indexSize,
            void* scratch, long scratchSize);

        /// <summary>
        /// <para>Which items of an index does one shape overlap? They come in the index's order.</para>
        /// <para>Many shapes are better joined: index them too.</para>
        /// <para>Requires: sets are those of the index. NULL with set_count 0 asks for the items whose bounds meet
        /// those of the shape. one is a single shape (count 1). out has room for `capacity` items. With capacity 0, out
        /// and state may be NULL.</para>
        /// <para>Returns: the number of items written; with capacity 0, how many there are.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (one is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, sets are not the index's,
        /// the state is not of this call).</para>
        /// <para>Accuracy: exact, if there are sets.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_select_f64(void* index, void* sets, int setCount, void* one,
            void* output, long capacity, void* state);

        /// <summary>
        /// <para>All pairs of an item of index_a and an item of index_b for which a query holds, each pair once.</para>
        /// <para>If both indexes are the same pointer, pairs are those of two different items a &lt; b. Pair i is
        /// out_a[i] and out_b[i]. The order of pairs depends on the bytes of the indexes and the query alone. Work may
        /// be shared out: each part of `parts` is about as much work as any other, and may run at the same time with a
        /// scratch of its own. The pairs of all parts, one part after the other, are the pairs of part 0 of 1.</para>
        /// <para>Requires: query is VESICA_JOIN_OVERLAP ... VESICA_JOIN_INSIDE. sets_a and sets_b are those of the
        /// indexes; with VESICA_JOIN_BOUNDS they are not looked at. 0 &lt;= part &lt; parts. scratch_size &gt;=
        /// vesica_join_scratch(); the scratch is free between calls. out_a and out_b have room for `capacity` items.
        /// With capacity 0, they and state may be NULL.</para>
        /// <para>Returns: the number of pairs written; with capacity 0, how many the whole part has.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_ARGUMENT (as above, and for an unknown
        /// query).</para>
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
        /// once: those whose answer from vesica_within_f64 is &gt; 0.</para>
        /// <para>If both indexes are the same pointer, pairs are those of two different items a &lt; b. They come in
        /// index_a's order. Parts are runs of about as many items of index_a as any other; all else is as with
        /// vesica_join_f64.</para>
        /// <para>Requires: distance &gt;= 0, or infinity, which asks for all pairs of valid shapes; sets, part,
        /// outputs, capacity and state as vesica_join_f64.</para>
        /// <para>Returns: the number of pairs written; with capacity 0, how many the whole part has.</para>
        /// <para>Errors: those of vesica_join_f64; VESICA_E_ARGUMENT also for a distance that is negative or
        /// NaN.</para>
        /// <para>Accuracy: that of vesica_within_f64; a pair that is VESICA_WITHIN_NEARLY is among them.</para>
        /// <para>Cost: about 1 us a shape of index_a and that of vesica_within_f64 a candidate: seven times that of
        /// vesica_join_f64.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_join_within_f64(void* indexA, void* setsA, int setCountA, void* indexB,
            void* setsB, int setCountB, double distance, long part, long parts, void* outA, void* outB, long capacity,
            void* state);

        /// <summary>
        /// <para>Which items of an index are nearest to one shape? They come with the nearest first; at equal distances
        /// by number.</para>
        /// <para>An item that overlaps the shape has distance 0. An item whose distance exceeds the finite numbers is
        /// not found.</para>
        /// <para>Requires: sets are those of the index. one is a single shape (count 1). k &gt;= 0, and out and
        /// distance have room for k each. With k = 0 they may be NULL. within &gt;= 0 is the largest distance asked
        /// for; infinity asks for any.</para>
        /// <para>Returns: how many items were found and written; with k = 0, how many there are within the
        /// distance.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (one is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, sets are not the index's,
        /// the state is not of this call).</para>
        /// <para>Accuracy: distances are those of vesica_nearest_f64, bit for bit.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_nearest_f64(void* index, void* sets, int setCount, void* one, long k,
            double within, void* output, void* distance);

        /// <summary>
        /// <para>Which items of index_b are nearest to each item of sets_a? Row i is out[i * k] ... out[i * k + k -
        /// 1].</para>
        /// <para>A row is what vesica_index_nearest_f64 says of item i, followed by -1, with distance infinity, up to
        /// k. Of one set with itself each item finds itself too, at distance 0. If an item of sets_a is invalid, its
        /// row holds -1, all other rows are right, and the call returns VESICA_E_SHAPE. Each of `parts` is a run of
        /// about as many items as any other, and only its rows are written.</para>
        /// <para>Requires: sets_b are those of index_b. k &gt;= 1, and out and distance have room for k items a row. 0
        /// &lt;= part &lt; parts. within &gt;= 0 is the largest distance asked for; infinity asks for any.</para>
        /// <para>Returns: how many items were found in all rows of the part.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (one is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, sets are not the index's,
        /// the state is not of this call).</para>
        /// <para>Accuracy: distances are those of vesica_nearest_f64, bit for bit.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_join_nearest_f64(void* setsA, int setCountA, void* indexB, void* setsB,
            int setCountB, long k, double within, long part, long parts, void* output, void* distance);

        /// <summary>
        /// <para>Builds the index of some sets of shapes.</para>
        /// <para>Invalid shapes are left out. The call then returns VESICA_E_SHAPE, and the index of all others is
        /// complete. After any other error nothing is written. Shapes that moved need a new index.</para>
        /// <para>Requires: index_size &gt;= vesica_index_size(items) and scratch_size &gt;=
        /// vesica_index_scratch(items). The scratch is free again after the call.</para>
        /// <para>Returns: the bytes of the index that are used.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a count, a size or an alignment),
        /// VESICA_E_SHAPE.</para>
        /// <para>Cost: 30 to 50 ns a shape.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_build_f32(void* sets, int setCount, void* index, long indexSize,
            void* scratch, long scratchSize);

        /// <summary>
        /// <para>Which items of an index does one shape overlap? They come in the index's order.</para>
        /// <para>Many shapes are better joined: index them too.</para>
        /// <para>Requires: sets are those of the index. NULL with set_count 0 asks for the items whose bounds meet
        /// those of the shape. one is a single shape (count 1). out has room for `capacity` items. With capacity 0, out
        /// and state may be NULL.</para>
        /// <para>Returns: the number of items written; with capacity 0, how many there are.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (one is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, sets are not the index's,
        /// the state is not of this call).</para>
        /// <para>Accuracy: exact, if there are sets.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_select_f32(void* index, void* sets, int setCount, void* one,
            void* output, long capacity, void* state);

        /// <summary>
        /// <para>All pairs of an item of index_a and an item of index_b for which a query holds, each pair once.</para>
        /// <para>If both indexes are the same pointer, pairs are those of two different items a &lt; b. Pair i is
        /// out_a[i] and out_b[i]. The order of pairs depends on the bytes of the indexes and the query alone. Work may
        /// be shared out: each part of `parts` is about as much work as any other, and may run at the same time with a
        /// scratch of its own. The pairs of all parts, one part after the other, are the pairs of part 0 of 1.</para>
        /// <para>Requires: query is VESICA_JOIN_OVERLAP ... VESICA_JOIN_INSIDE. sets_a and sets_b are those of the
        /// indexes; with VESICA_JOIN_BOUNDS they are not looked at. 0 &lt;= part &lt; parts. scratch_size &gt;=
        /// vesica_join_scratch(); the scratch is free between calls. out_a and out_b have room for `capacity` items.
        /// With capacity 0, they and state may be NULL.</para>
        /// <para>Returns: the number of pairs written; with capacity 0, how many the whole part has.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_ARGUMENT (as above, and for an unknown
        /// query).</para>
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
        /// once: those whose answer from vesica_within_f32 is &gt; 0.</para>
        /// <para>If both indexes are the same pointer, pairs are those of two different items a &lt; b. They come in
        /// index_a's order. Parts are runs of about as many items of index_a as any other; all else is as with
        /// vesica_join_f32.</para>
        /// <para>Requires: distance &gt;= 0, or infinity, which asks for all pairs of valid shapes; sets, part,
        /// outputs, capacity and state as vesica_join_f32.</para>
        /// <para>Returns: the number of pairs written; with capacity 0, how many the whole part has.</para>
        /// <para>Errors: those of vesica_join_f32; VESICA_E_ARGUMENT also for a distance that is negative or
        /// NaN.</para>
        /// <para>Accuracy: that of vesica_within_f32; a pair that is VESICA_WITHIN_NEARLY is among them.</para>
        /// <para>Cost: about 1 us a shape of index_a and that of vesica_within_f32 a candidate: seven times that of
        /// vesica_join_f32.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_join_within_f32(void* indexA, void* setsA, int setCountA, void* indexB,
            void* setsB, int setCountB, float distance, long part, long parts, void* outA, void* outB, long capacity,
            void* state);

        /// <summary>
        /// <para>Which items of an index are nearest to one shape? They come with the nearest first; at equal distances
        /// by number.</para>
        /// <para>An item that overlaps the shape has distance 0. An item whose distance exceeds the finite numbers is
        /// not found.</para>
        /// <para>Requires: sets are those of the index. one is a single shape (count 1). k &gt;= 0, and out and
        /// distance have room for k each. With k = 0 they may be NULL. within &gt;= 0 is the largest distance asked
        /// for; infinity asks for any.</para>
        /// <para>Returns: how many items were found and written; with k = 0, how many there are within the
        /// distance.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (one is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, sets are not the index's,
        /// the state is not of this call).</para>
        /// <para>Accuracy: distances are those of vesica_nearest_f32, bit for bit.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_nearest_f32(void* index, void* sets, int setCount, void* one, long k,
            float within, void* output, void* distance);

        /// <summary>
        /// <para>Which items of index_b are nearest to each item of sets_a? Row i is out[i * k] ... out[i * k + k -
        /// 1].</para>
        /// <para>A row is what vesica_index_nearest_f32 says of item i, followed by -1, with distance infinity, up to
        /// k. Of one set with itself each item finds itself too, at distance 0. If an item of sets_a is invalid, its
        /// row holds -1, all other rows are right, and the call returns VESICA_E_SHAPE. Each of `parts` is a run of
        /// about as many items as any other, and only its rows are written.</para>
        /// <para>Requires: sets_b are those of index_b. k &gt;= 1, and out and distance have room for k items a row. 0
        /// &lt;= part &lt; parts. within &gt;= 0 is the largest distance asked for; infinity asks for any.</para>
        /// <para>Returns: how many items were found in all rows of the part.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (one is invalid),
        /// VESICA_E_ARGUMENT (a number or a size is out of range, a pointer is not aligned, sets are not the index's,
        /// the state is not of this call).</para>
        /// <para>Accuracy: distances are those of vesica_nearest_f32, bit for bit.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_join_nearest_f32(void* setsA, int setCountA, void* indexB, void* setsB,
            int setCountB, long k, float within, long part, long parts, void* output, void* distance);

        /// <summary>
        /// <para>What share of a's area does b cover, or of b's area a? And other ratios by which detections are
        /// compared.</para>
        /// <para>The first four are from 0 to 1. One over a shape is 0 if no area is shared, and 1 if the other shape
        /// contains it. The last three are at most the IoU, and at least -1, for CIoU -2. The angle of a shape in CIoU
        /// is that of the vector (half length across its axis, half length along it); v is 0 if a shape has no size.
        /// Exchanging the shapes exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the others.</para>
        /// <para>Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (ratio is no such constant;
        /// the shape whose area divides has none; for the others, neither shape has one).</para>
        /// <para>Accuracy: within 8 u of what follows from the shared area or the IoU, which are right as
        /// vesica_area_f64 and vesica_iou_f64 tell, for half lengths from 2^-200 to 2^200. Bounds on computed numbers
        /// use u = 2^-53. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their
        /// half lengths. An aspect ratio is a shape's longer size over its shorter one.</para>
        /// <para>Cost: that of vesica_area_f64 or vesica_iou_f64, and 100 to 150 ns more; 40 to 100 in arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ratio_f64(int ratio, int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f64.</para>
        /// <para>Arrays and errors are those of vesica_iou_many_f64. If a pair has no ratio since an area is 0, out[i]
        /// is NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.</para>
        /// <para>Accuracy: every result has the bits of vesica_ratio_f64, on every instruction set and in every
        /// layout.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_ratio_many_f64(int ratio, void* a, void* b, void* output);

        /// <summary>
        /// <para>A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f64.</para>
        /// <para>Arrays, row_stride and errors are those of vesica_iou_matrix_f64. If a pair has no ratio since an area
        /// is 0, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.</para>
        /// <para>Accuracy: every result has the bits of vesica_ratio_f64, on every instruction set and in every
        /// layout.</para>
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
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
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
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
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
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_depth_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>How far apart are two shapes or, as a number below 0, how deep do they overlap?</para>
        /// <para>The distance of vesica_nearest_f64 if they are disjoint, else minus the depth of vesica_depth_f64: 0
        /// where they only touch. Exchanging the shapes changes no bit.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: that of vesica_nearest_f64 and of vesica_depth_f64, bit for bit. The sign is exact.</para>
        /// <para>Cost: that of vesica_nearest_f64 or of vesica_depth_f64, whichever it is.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_signed_distance_f64(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>Signed distances of a[i] and b[i]. Arrays and errors are those of vesica_iou_many_f64.</para>
        /// <para>Returns: how many pairs overlap (signed distance &lt;= 0).</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: that of vesica_nearest_f64 and of vesica_depth_f64, bit for bit. The sign is exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_signed_distance_many_f64(void* a, void* b, void* output);

        /// <summary>
        /// <para>Signed distances of a[i] and b[j]. Arrays, row_stride and errors are those of
        /// vesica_iou_matrix_f64.</para>
        /// <para>Returns: how many pairs overlap (signed distance &lt;= 0).</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: that of vesica_nearest_f64 and of vesica_depth_f64, bit for bit. The sign is exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_signed_distance_matrix_f64(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Are two shapes at most `distance` apart? Exactly so far apart counts, as touching does.</para>
        /// <para>Distance 0 asks what vesica_overlap_f64 does, and is exact for all kinds. Who must not miss a pair
        /// takes an answer &gt; 0 for a yes; who must not have a wrong one takes VESICA_WITHIN_YES. Exchanging the
        /// shapes changes nothing.</para>
        /// <para>Requires: distance &gt;= 0, or infinity, of which any two valid shapes are within.</para>
        /// <para>Returns: VESICA_WITHIN_NO, VESICA_WITHIN_YES or VESICA_WITHIN_NEARLY.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact for points, segments, circles, boxes, rectangles and ellipses that have a half length
        /// of 0. A pair with another ellipse that is disjoint is VESICA_WITHIN_NEARLY if its distance, as
        /// vesica_nearest_f64 has it, is less than 5 u scale from the one asked for; the answers yes and no are
        /// certain. Bounds on computed numbers use u = 2^-53. The scale of two shapes is the largest of |dx| and |dy|
        /// between their centres and of their half lengths. An aspect ratio is a shape's longer size over its shorter
        /// one.</para>
        /// <para>Cost: 10 to 60 ns; that of vesica_nearest_f64 for ellipses; 1 to 10 us where only exact arithmetic can
        /// decide, as it must for distances that are exact; more where exponents are wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_within_f64(int kindA, void* numbersA, int kindB, void* numbersB,
            double distance);

        /// <summary>
        /// <para>Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f64.</para>
        /// <para>Arrays and errors are those of vesica_overlap_many_f64.</para>
        /// <para>Requires: distance &gt;= 0, or infinity, of which any two valid shapes are within.</para>
        /// <para>Returns: how many answers are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact for points, segments, circles, boxes, rectangles and ellipses that have a half length
        /// of 0. A pair with another ellipse that is disjoint is VESICA_WITHIN_NEARLY if its distance, as
        /// vesica_nearest_f64 has it, is less than 5 u scale from the one asked for; the answers yes and no are
        /// certain. Bounds on computed numbers use u = 2^-53. The scale of two shapes is the largest of |dx| and |dy|
        /// between their centres and of their half lengths. An aspect ratio is a shape's longer size over its shorter
        /// one.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_within_many_f64(void* a, void* b, double distance, void* output);

        /// <summary>
        /// <para>Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of
        /// vesica_within_f64.</para>
        /// <para>Arrays, row_stride and errors are those of vesica_overlap_matrix_f64.</para>
        /// <para>Requires: distance &gt;= 0, or infinity, of which any two valid shapes are within.</para>
        /// <para>Returns: how many answers are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact for points, segments, circles, boxes, rectangles and ellipses that have a half length
        /// of 0. A pair with another ellipse that is disjoint is VESICA_WITHIN_NEARLY if its distance, as
        /// vesica_nearest_f64 has it, is less than 5 u scale from the one asked for; the answers yes and no are
        /// certain. Bounds on computed numbers use u = 2^-53. The scale of two shapes is the largest of |dx| and |dy|
        /// between their centres and of their half lengths. An aspect ratio is a shape's longer size over its shorter
        /// one.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_within_matrix_f64(void* a, void* b, double distance, void* output,
            IntPtr rowStride);

        /// <summary>
        /// <para>Greedy non-maximum suppression as vesica_nms_f64, by any ratio and among like labels.</para>
        /// <para>Takes shapes in the order of their scores, highest first. Keeps each one whose ratio with every shape
        /// kept before, of the same label, is at most the threshold. Shapes whose score is below least_score are not
        /// looked at.</para>
        /// <para>Requires: shapes, scores, threshold, scratch and keep as vesica_nms_f64; labels, one for each, or NULL
        /// if all are alike; ratio, any but VESICA_RATIO_OVER_FIRST and _OVER_SECOND; least_score, which may be
        /// -infinity; most, how many are kept at most: keep needs room for no more.</para>
        /// <para>Returns: 0, and keep and *kept as vesica_nms_f64.</para>
        /// <para>Errors: as vesica_nms_f64; VESICA_E_ARGUMENT also for ratio, a least_score that is NaN, and a negative
        /// most.</para>
        /// <para>Cost: that of vesica_nms_f64; ratios other than IoU cost 0.1 us more a comparison.</para>
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
        /// <para>Soft suppression: what a better shape covers keeps a lower score.</para>
        /// <para>Again and again takes the shape with the highest score, of equal ones the first, keeps it, and lowers
        /// the score of each shape not yet kept, of the same label, by `decay` of their ratio. Ends when `most` are
        /// kept or no score is left that is at least least_score. keep[k] is the shape taken in turn k, and decayed[k]
        /// the score that it then had.</para>
        /// <para>Requires: shapes, scores and labels as vesica_suppress_f64; ratio, any but VESICA_RATIO_OVER_FIRST and
        /// _OVER_SECOND; decay, VESICA_DECAY_LINEAR or _GAUSSIAN, with its parameter; least_score &gt;= 0; scratch of
        /// at least vesica_suppress_soft_scratch(count) bytes, aligned to 8; keep and decayed with room for as many as
        /// are kept.</para>
        /// <para>Returns: 0, with *kept set to how many are kept.</para>
        /// <para>Errors: as vesica_suppress_f64. VESICA_E_SHAPE: an invalid shape, or one whose score is NaN, is left
        /// out, and all else is written.</para>
        /// <para>Accuracy: in every turn a score is multiplied once, in double, by 1 - r, rounded once, or by the
        /// exponential, right to 1 unit in the last place. So the choice is that of the definition in double, the same
        /// bits on every machine. Floats are widened first, and only the final scores rounded.</para>
        /// <para>Cost: for each kept shape, that of vesica_ratio_matrix_f64 with all of its label that are left.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_suppress_soft_f64(void* shapes, void* scores, void* labels, int ratio,
            int decay, double parameter, double leastScore, long most, void* scratch, long scratchSize, void* keep,
            void* decayed, void* kept);

        /// <summary>
        /// <para>What share of a's area does b cover, or of b's area a? And other ratios by which detections are
        /// compared.</para>
        /// <para>The first four are from 0 to 1. One over a shape is 0 if no area is shared, and 1 if the other shape
        /// contains it. The last three are at most the IoU, and at least -1, for CIoU -2. The angle of a shape in CIoU
        /// is that of the vector (half length across its axis, half length along it); v is 0 if a shape has no size.
        /// Exchanging the shapes exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the others.</para>
        /// <para>Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (ratio is no such constant;
        /// the shape whose area divides has none; for the others, neither shape has one).</para>
        /// <para>Accuracy: within 8 u of what follows from the shared area or the IoU, which are right as
        /// vesica_area_f32 and vesica_iou_f32 tell, for half lengths from 2^-200 to 2^200. Each number is computed in
        /// double, within these bounds, and then rounded to float once. Bounds on computed numbers use u = 2^-53. The
        /// scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths. An
        /// aspect ratio is a shape's longer size over its shorter one.</para>
        /// <para>Cost: that of vesica_area_f32 or vesica_iou_f32, and 100 to 150 ns more; 40 to 100 in arrays.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_ratio_f32(int ratio, int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>A ratio of a[i] and b[i]: out[i] is the result of vesica_ratio_f32.</para>
        /// <para>Arrays and errors are those of vesica_iou_many_f32. If a pair has no ratio since an area is 0, out[i]
        /// is NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.</para>
        /// <para>Accuracy: every result has the bits of vesica_ratio_f32, on every instruction set and in every layout.
        /// Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_ratio_many_f32(int ratio, void* a, void* b, void* output);

        /// <summary>
        /// <para>A ratio of a[i] and b[j]: out[i * row_stride + j] is the result of vesica_ratio_f32.</para>
        /// <para>Arrays, row_stride and errors are those of vesica_iou_matrix_f32. If a pair has no ratio since an area
        /// is 0, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.</para>
        /// <para>Returns: how many are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.</para>
        /// <para>Accuracy: every result has the bits of vesica_ratio_f32, on every instruction set and in every layout.
        /// Each number is computed in double, within these bounds, and then rounded to float once.</para>
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
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
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
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
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
        /// <para>Accuracy: every result has the bits of the function for two shapes, on every instruction set and in
        /// every layout. Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_depth_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Greedy non-maximum suppression as vesica_nms_f32, by any ratio and among like labels.</para>
        /// <para>Takes shapes in the order of their scores, highest first. Keeps each one whose ratio with every shape
        /// kept before, of the same label, is at most the threshold. Shapes whose score is below least_score are not
        /// looked at.</para>
        /// <para>Requires: shapes, scores, threshold, scratch and keep as vesica_nms_f32; labels, one for each, or NULL
        /// if all are alike; ratio, any but VESICA_RATIO_OVER_FIRST and _OVER_SECOND; least_score, which may be
        /// -infinity; most, how many are kept at most: keep needs room for no more.</para>
        /// <para>Returns: 0, and keep and *kept as vesica_nms_f32.</para>
        /// <para>Errors: as vesica_nms_f32; VESICA_E_ARGUMENT also for ratio, a least_score that is NaN, and a negative
        /// most.</para>
        /// <para>Cost: that of vesica_nms_f32; ratios other than IoU cost 0.1 us more a comparison.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_suppress_f32(void* shapes, void* scores, void* labels, int ratio,
            float threshold, float leastScore, long most, void* scratch, long scratchSize, void* keep, void* kept);

        /// <summary>
        /// <para>How far apart are two shapes or, as a number below 0, how deep do they overlap?</para>
        /// <para>The distance of vesica_nearest_f32 if they are disjoint, else minus the depth of vesica_depth_f32: 0
        /// where they only touch. Exchanging the shapes changes no bit.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: that of vesica_nearest_f32 and of vesica_depth_f32, bit for bit. The sign is exact.
        /// Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Cost: that of vesica_nearest_f32 or of vesica_depth_f32, whichever it is.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_signed_distance_f32(int kindA, void* numbersA, int kindB, void* numbersB,
            void* output);

        /// <summary>
        /// <para>Signed distances of a[i] and b[i]. Arrays and errors are those of vesica_iou_many_f32.</para>
        /// <para>Returns: how many pairs overlap (signed distance &lt;= 0).</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.</para>
        /// <para>Accuracy: that of vesica_nearest_f32 and of vesica_depth_f32, bit for bit. The sign is exact.
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
        /// <para>Accuracy: that of vesica_nearest_f32 and of vesica_depth_f32, bit for bit. The sign is exact.
        /// Each number is computed in double, within these bounds, and then rounded to float once.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_signed_distance_matrix_f32(void* a, void* b, void* output, IntPtr rowStride);

        /// <summary>
        /// <para>Are two shapes at most `distance` apart? Exactly so far apart counts, as touching does.</para>
        /// <para>Distance 0 asks what vesica_overlap_f32 does, and is exact for all kinds. Who must not miss a pair
        /// takes an answer &gt; 0 for a yes; who must not have a wrong one takes VESICA_WITHIN_YES. Exchanging the
        /// shapes changes nothing.</para>
        /// <para>Requires: distance &gt;= 0, or infinity, of which any two valid shapes are within.</para>
        /// <para>Returns: VESICA_WITHIN_NO, VESICA_WITHIN_YES or VESICA_WITHIN_NEARLY.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact for points, segments, circles, boxes, rectangles and ellipses that have a half length
        /// of 0. A pair with another ellipse that is disjoint is VESICA_WITHIN_NEARLY if its distance, as
        /// vesica_nearest_f32 has it, is less than 5 u scale from the one asked for; the answers yes and no are
        /// certain. Bounds on computed numbers use u = 2^-53. The scale of two shapes is the largest of |dx| and |dy|
        /// between their centres and of their half lengths. An aspect ratio is a shape's longer size over its shorter
        /// one.</para>
        /// <para>Cost: 10 to 60 ns; that of vesica_nearest_f32 for ellipses; 1 to 10 us where only exact arithmetic can
        /// decide, as it must for distances that are exact; more where exponents are wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_within_f32(int kindA, void* numbersA, int kindB, void* numbersB,
            float distance);

        /// <summary>
        /// <para>Are a[i] and b[i] at most `distance` apart? out[i] is the answer of vesica_within_f32.</para>
        /// <para>Arrays and errors are those of vesica_overlap_many_f32.</para>
        /// <para>Requires: distance &gt;= 0, or infinity, of which any two valid shapes are within.</para>
        /// <para>Returns: how many answers are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact for points, segments, circles, boxes, rectangles and ellipses that have a half length
        /// of 0. A pair with another ellipse that is disjoint is VESICA_WITHIN_NEARLY if its distance, as
        /// vesica_nearest_f32 has it, is less than 5 u scale from the one asked for; the answers yes and no are
        /// certain. Bounds on computed numbers use u = 2^-53. The scale of two shapes is the largest of |dx| and |dy|
        /// between their centres and of their half lengths. An aspect ratio is a shape's longer size over its shorter
        /// one.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_within_many_f32(void* a, void* b, float distance, void* output);

        /// <summary>
        /// <para>Are a[i] and b[j] at most `distance` apart? out[i * row_stride + j] is the answer of
        /// vesica_within_f32.</para>
        /// <para>Arrays, row_stride and errors are those of vesica_overlap_matrix_f32.</para>
        /// <para>Requires: distance &gt;= 0, or infinity, of which any two valid shapes are within.</para>
        /// <para>Returns: how many answers are &gt; 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is negative or NaN),
        /// VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact for points, segments, circles, boxes, rectangles and ellipses that have a half length
        /// of 0. A pair with another ellipse that is disjoint is VESICA_WITHIN_NEARLY if its distance, as
        /// vesica_nearest_f32 has it, is less than 5 u scale from the one asked for; the answers yes and no are
        /// certain. Bounds on computed numbers use u = 2^-53. The scale of two shapes is the largest of |dx| and |dy|
        /// between their centres and of their half lengths. An aspect ratio is a shape's longer size over its shorter
        /// one.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_within_matrix_f32(void* a, void* b, float distance, void* output,
            IntPtr rowStride);

        /// <summary>
        /// <para>Soft suppression: what a better shape covers keeps a lower score.</para>
        /// <para>Again and again takes the shape with the highest score, of equal ones the first, keeps it, and lowers
        /// the score of each shape not yet kept, of the same label, by `decay` of their ratio. Ends when `most` are
        /// kept or no score is left that is at least least_score. keep[k] is the shape taken in turn k, and decayed[k]
        /// the score that it then had.</para>
        /// <para>Requires: shapes, scores and labels as vesica_suppress_f32; ratio, any but VESICA_RATIO_OVER_FIRST and
        /// _OVER_SECOND; decay, VESICA_DECAY_LINEAR or _GAUSSIAN, with its parameter; least_score &gt;= 0; scratch of
        /// at least vesica_suppress_soft_scratch(count) bytes, aligned to 8; keep and decayed with room for as many as
        /// are kept.</para>
        /// <para>Returns: 0, with *kept set to how many are kept.</para>
        /// <para>Errors: as vesica_suppress_f32. VESICA_E_SHAPE: an invalid shape, or one whose score is NaN, is left
        /// out, and all else is written.</para>
        /// <para>Accuracy: in every turn a score is multiplied once, in double, by 1 - r, rounded once, or by the
        /// exponential, right to 1 unit in the last place. So the choice is that of the definition in double, the same
        /// bits on every machine. Floats are widened first, and only the final scores rounded.</para>
        /// <para>Cost: for each kept shape, that of vesica_ratio_matrix_f32 with all of its label that are left.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_suppress_soft_f32(void* shapes, void* scores, void* labels, int ratio,
            int decay, float parameter, float leastScore, long most, void* scratch, long scratchSize, void* keep,
            void* decayed, void* kept);

        /// <summary>
        /// <para>Does b touch a while it moves, when first, and where?</para>
        /// <para>The normal is that of the face or the round outline that is met; where a corner meets a corner, that
        /// of an edge there; where b only slides along a, it is across the velocity. Of a face that is met at an angle
        /// below 2^-80 it may be that of the face beside it, and the point their corner. The point of two faces that
        /// meet is the middle of what they share. Shapes that overlap at the start have t = 0, the direction of
        /// vesica_depth_f64 and the point of vesica_nearest_f64. So shapes that only touch, with a normal that does not
        /// point against the velocity, are moving apart. Exchanging the shapes and turning the velocity round changes
        /// neither the answer nor the time, and the normal but for its sign and rounding.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a velocity that is not finite, a t_end that
        /// is negative or NaN), VESICA_E_SHAPE, VESICA_E_RANGE (the time, or a coordinate of the point, would exceed
        /// the finite numbers; or the digits of a place at some time span more than 2000 bits, which takes exponents
        /// that are wildly unlike).</para>
        /// <para>Accuracy: the answer is exact, and the time is rounded down. The point is within 8 u scale of a's
        /// outline; along that it may be off by (8 u scale + 4 u R) / |n.v|, n and v of unit length, R the greatest
        /// radius of curvature of a: of an ellipse its long half length squared over the short one, far more than its
        /// size if it is thin. The normal is unit to 4 u. Bounds on computed numbers use u = 2^-53. The scale of two
        /// shapes is the largest of |dx| and |dy| between their centres and of their half lengths. An aspect ratio is a
        /// shape's longer size over its shorter one.</para>
        /// <para>Cost: 30 to 50 ns for a miss, 0.2 to 0.6 us for a hit; of a ray (b a point), two circles and two
        /// ellipses less, see the typed functions; 0.7 to 20 us for contact that only exact arithmetic can decide; at
        /// worst 2 ms, where exponents are wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_f64(int kindA, void* numbersA, int kindB, void* numbersB, double vx,
            double vy, double tEnd, void* output);

        /// <summary>
        /// <para>When, and where, does b[i], moved by t (vx[i], vy[i]), touch a[i]? The columns are the fields of
        /// vesica_cast_f64's result.</para>
        /// <para>Velocity i is at vx and vy + i * stride bytes; stride 0 repeats one.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count. Some, but not all, may be NULL.</para>
        /// <para>Returns: how many touch, those that overlap at the start included.</para>
        /// <para>Errors: as above. An element with an invalid shape, a velocity that is not finite or a result out of
        /// range has NaN for its numbers, all others are written as usual, and the call returns VESICA_E_SHAPE if there
        /// is an invalid shape, else the error.</para>
        /// <para>Accuracy: every result has the bits of vesica_cast_f64.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_cast_many_f64(void* a, void* b, void* vx, void* vy, IntPtr stride,
            double tEnd, void* t, void* x, void* y, void* nx, void* ny);

        /// <summary>
        /// <para>Which of many shapes at rest does one moving shape touch first? Of several at one time the one with
        /// the lowest number.</para>
        /// <para>Requires: one, the shape that moves, is a single one (count 1).</para>
        /// <para>Returns: its number, or the count of `many` if there is none. *out is its contact, the normal pointing
        /// to `one`.</para>
        /// <para>Errors: as above. An invalid shape anywhere is one. VESICA_E_RANGE only if vesica_cast_f64 returns it
        /// for one of the shapes, and that might be touched first: where another one is certainly touched before, there
        /// is no error.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_cast_first_f64(void* one, void* many, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A box that holds a shape throughout its motion, t from 0 to t_end: what is outside of it is never
        /// touched.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: as above; VESICA_E_RANGE if a side would exceed the finite numbers.</para>
        /// <para>Accuracy: a side that does not move is that of vesica_bounds_f64. One that does is too far out by at
        /// most three steps between numbers as large as the largest of the side at rest, its way and where it
        /// ends.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_sweep_bounds_f64(int kind, void* numbers, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>Which items of an index does one moving shape touch? They come in the index's order.</para>
        /// <para>Requires: sets are those of the index. one is a single shape (count 1). out has room for `capacity`
        /// items. With capacity 0, out and state may be NULL.</para>
        /// <para>Returns: the number of items written; with capacity 0, how many there are.</para>
        /// <para>Errors: as above, and VESICA_E_INDEX; VESICA_E_ARGUMENT also for sets that are not the index's, a
        /// pointer that is not aligned, or a state that is not of this call. Invalid items are never touched.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_cast_f64(void* index, void* sets, int setCount, void* one, double vx,
            double vy, double tEnd, void* output, long capacity, void* state);

        /// <summary>
        /// <para>Which item of an index does one moving shape touch first? Of several at one time the one with the
        /// lowest number.</para>
        /// <para>Requires: sets are those of the index. one is a single shape (count 1).</para>
        /// <para>Returns: the item, or the index's count if there is none. *out is its contact, the normal pointing to
        /// `one`.</para>
        /// <para>Errors: those of vesica_index_cast_f64; VESICA_E_RANGE only as of vesica_cast_first_f64.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_cast_first_f64(void* index, void* sets, int setCount, void* one,
            double vx, double vy, double tEnd, void* output);

        /// <summary>
        /// <para>When do two shapes that move and turn touch first? t is proved: however thin they are and however fast
        /// they turn, there is no contact before.</para>
        /// <para>At t, from 0 to 1, a centre has moved by t (vx, vy) and an axis has turned by t times the angle, as
        /// real numbers do. *out is the place then: the point of a that is nearest to b, and the normal that separates
        /// them. They are at most *gap apart.</para>
        /// <para>Requires: numbers of turn_a and turn_b finite, angles at most 2^20 in magnitude; tolerance above 0, a
        /// length. No pointer may be NULL.</para>
        /// <para>Returns: VESICA_CAST_MISS: proved, there is no contact from 0 to 1; then t is infinity, all other
        /// numbers and the gap are NaN. VESICA_CAST_HIT: proved, there is contact after t. VESICA_CAST_NEAR: there may
        /// be contact after t. Of a point and a segment, or two points, which have no depth in each other, contact is
        /// never proved. VESICA_CAST_START: the shapes overlap at t = 0, which is exact; *out is as of vesica_cast_f64,
        /// and the gap 0.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE (a coordinate
        /// of the point, or the gap, would exceed the finite numbers). On an error nothing is written.</para>
        /// <para>Accuracy: that there is no contact before t, a miss and a hit are certain. The gap is at most the
        /// tolerance, unless that is below what rounding allows, (120 + 4 |angles|) u times the sum of all lengths, u =
        /// 2^-53, the motion's included; or 256 directions or 4096 poses were looked at.</para>
        /// <para>Cost: 0.2 to 0.9 us for boxes, 0.4 to 3 us where one shape is round; 0.14 ms was seen at spins of
        /// 10^6 radians, 1.4 ms where exponents are wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_impact_time_f64(int kindA, void* numbersA, void* turnA, int kindB,
            void* numbersB, void* turnB, double tolerance, void* output, void* gap);

        /// <summary>
        /// <para>A ray at a point.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f64 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_point_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a segment.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f64 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_segment_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a disc.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f64 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_circle_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at an axis-aligned box.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f64 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_aabb_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a rectangle.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f64 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_rect_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at an ellipse.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f64 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_ellipse_point_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>Two discs.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f64 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_circle_circle_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>Two rectangles.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f64.</para>
        /// <para>Accuracy: that of vesica_cast_f64.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f64 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_rect_rect_f64(void* a, void* b, double vx, double vy, double tEnd,
            void* output);

        /// <summary>
        /// <para>Does b touch a while it moves, when first, and where?</para>
        /// <para>The normal is that of the face or the round outline that is met; where a corner meets a corner, that
        /// of an edge there; where b only slides along a, it is across the velocity. Of a face that is met at an angle
        /// below 2^-80 it may be that of the face beside it, and the point their corner. The point of two faces that
        /// meet is the middle of what they share. Shapes that overlap at the start have t = 0, the direction of
        /// vesica_depth_f32 and the point of vesica_nearest_f32. So shapes that only touch, with a normal that does not
        /// point against the velocity, are moving apart. Exchanging the shapes and turning the velocity round changes
        /// neither the answer nor the time, and the normal but for its sign and rounding.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a velocity that is not finite, a t_end that
        /// is negative or NaN), VESICA_E_SHAPE, VESICA_E_RANGE (the time, or a coordinate of the point, would exceed
        /// the finite numbers; or the digits of a place at some time span more than 2000 bits, which takes exponents
        /// that are wildly unlike).</para>
        /// <para>Accuracy: the answer is exact, and the time is rounded down. The point is within 8 u scale of a's
        /// outline; along that it may be off by (8 u scale + 4 u R) / |n.v|, n and v of unit length, R the greatest
        /// radius of curvature of a: of an ellipse its long half length squared over the short one, far more than its
        /// size if it is thin. The normal is unit to 4 u. Bounds on computed numbers use u = 2^-53. The scale of two
        /// shapes is the largest of |dx| and |dy| between their centres and of their half lengths. An aspect ratio is a
        /// shape's longer size over its shorter one.</para>
        /// <para>Cost: 30 to 50 ns for a miss, 0.2 to 0.6 us for a hit; of a ray (b a point), two circles and two
        /// ellipses less, see the typed functions; 0.7 to 20 us for contact that only exact arithmetic can decide; at
        /// worst 2 ms, where exponents are wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_f32(int kindA, void* numbersA, int kindB, void* numbersB, float vx,
            float vy, float tEnd, void* output);

        /// <summary>
        /// <para>When, and where, does b[i], moved by t (vx[i], vy[i]), touch a[i]? The columns are the fields of
        /// vesica_cast_f32's result.</para>
        /// <para>Velocity i is at vx and vy + i * stride bytes; stride 0 repeats one.</para>
        /// <para>Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as
        /// many numbers as the larger count. Some, but not all, may be NULL.</para>
        /// <para>Returns: how many touch, those that overlap at the start included.</para>
        /// <para>Errors: as above. An element with an invalid shape, a velocity that is not finite or a result out of
        /// range has NaN for its numbers, all others are written as usual, and the call returns VESICA_E_SHAPE if there
        /// is an invalid shape, else the error.</para>
        /// <para>Accuracy: every result has the bits of vesica_cast_f32.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_cast_many_f32(void* a, void* b, void* vx, void* vy, IntPtr stride,
            float tEnd, void* t, void* x, void* y, void* nx, void* ny);

        /// <summary>
        /// <para>Which of many shapes at rest does one moving shape touch first? Of several at one time the one with
        /// the lowest number.</para>
        /// <para>Requires: one, the shape that moves, is a single one (count 1).</para>
        /// <para>Returns: its number, or the count of `many` if there is none. *out is its contact, the normal pointing
        /// to `one`.</para>
        /// <para>Errors: as above. An invalid shape anywhere is one. VESICA_E_RANGE only if vesica_cast_f32 returns it
        /// for one of the shapes, and that might be touched first: where another one is certainly touched before, there
        /// is no error.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_cast_first_f32(void* one, void* many, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A box that holds a shape throughout its motion, t from 0 to t_end: what is outside of it is never
        /// touched.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: 0.</para>
        /// <para>Errors: as above; VESICA_E_RANGE if a side would exceed the finite numbers.</para>
        /// <para>Accuracy: a side that does not move is that of vesica_bounds_f32. One that does is too far out by at
        /// most three steps between numbers as large as the largest of the side at rest, its way and where it
        /// ends.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_sweep_bounds_f32(int kind, void* numbers, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>Which items of an index does one moving shape touch? They come in the index's order.</para>
        /// <para>Requires: sets are those of the index. one is a single shape (count 1). out has room for `capacity`
        /// items. With capacity 0, out and state may be NULL.</para>
        /// <para>Returns: the number of items written; with capacity 0, how many there are.</para>
        /// <para>Errors: as above, and VESICA_E_INDEX; VESICA_E_ARGUMENT also for sets that are not the index's, a
        /// pointer that is not aligned, or a state that is not of this call. Invalid items are never touched.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_cast_f32(void* index, void* sets, int setCount, void* one, float vx,
            float vy, float tEnd, void* output, long capacity, void* state);

        /// <summary>
        /// <para>Which item of an index does one moving shape touch first? Of several at one time the one with the
        /// lowest number.</para>
        /// <para>Requires: sets are those of the index. one is a single shape (count 1).</para>
        /// <para>Returns: the item, or the index's count if there is none. *out is its contact, the normal pointing to
        /// `one`.</para>
        /// <para>Errors: those of vesica_index_cast_f32; VESICA_E_RANGE only as of vesica_cast_first_f32.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern long vesica_index_cast_first_f32(void* index, void* sets, int setCount, void* one,
            float vx, float vy, float tEnd, void* output);

        /// <summary>
        /// <para>As vesica_impact_time_f64. The gap is that at the rounded time, and rounded up.</para>
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
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f32 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_point_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a segment.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f32 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_segment_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a disc.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f32 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_circle_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at an axis-aligned box.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f32 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_aabb_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at a rectangle.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f32 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_rect_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>A ray at an ellipse.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f32 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_ellipse_point_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>Two discs.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f32 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_circle_circle_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>Two rectangles.</para>
        /// <para>Requires: vx and vy finite; both may be 0. t_end &gt;= 0, or infinity.</para>
        /// <para>Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as of
        /// vesica_cast_f32.</para>
        /// <para>Accuracy: that of vesica_cast_f32.</para>
        /// <para>Cost: 15 to 25 ns for a miss, 60 to 180 ns for a hit; of two rectangles 30 to 50 and 0.3 us. What the
        /// kinds' own way leaves open costs what vesica_cast_f32 does of other kinds.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_cast_rect_rect_f32(void* a, void* b, float vx, float vy, float tEnd,
            void* output);

        /// <summary>
        /// <para>The nine-intersection matrix of two shapes (DE-9IM), as geographic systems have it.</para>
        /// <para>Every shape has an inside, an outline and an outside. The nine characters say of a's inside with b's
        /// inside, outline and outside, then of a's outline with those three, then of a's outside, what they share: F
        /// for nothing, else the dimension: 0 for single points, 1 for lines, 2 for an area. The outline of a segment
        /// is its two end points; a point has none; that of a shape with area is the curve around it. A segment without
        /// length is a point; a shape with one size 0 is a segment, with both a point. So a box that shares a side with
        /// another gives "FF2F11212". Exchanging the shapes exchanges rows and columns.</para>
        /// <para>Requires: matrix with room for VESICA_DE9IM_SIZE characters.</para>
        /// <para>Returns: 0, and nine characters and a final NUL in matrix.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: that of vesica_relation_f64; 0.1 to 1 us more for a segment, 2 us for rectangles whose sides are
        /// parallel.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_de9im_f64(int kindA, void* numbersA, int kindB, void* numbersB, void* matrix);

        /// <summary>
        /// <para>Does a nine-intersection matrix fit a pattern, such as "T*F**F***" for "a is within b"?</para>
        /// <para>Each character of the pattern is one of F, 0, 1 and 2, which is meant literally; T, any of 0, 1 and 2;
        /// and *, which fits all.</para>
        /// <para>Requires: matrix and pattern, nine such characters and a final NUL each; no T or * in the
        /// matrix.</para>
        /// <para>Returns: 1 if it fits, 0 if not.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (another length or another character).</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_de9im_match(void* matrix, void* pattern);

        /// <summary>
        /// <para>The region that two shapes share, as its vertices: of two with straight outlines, or of a segment and
        /// any shape.</para>
        /// <para>The kinds are points, segments, boxes and rectangles; a point or a segment may also go with a circle
        /// or an ellipse. The region is convex. Its vertices x0 y0 x1 y1 ... come counter-clockwise where y points up,
        /// from the one that is lowest, of two equally low ones the left one, as their numbers have it. One vertex is a
        /// point, two are a segment's ends. Of the same two shapes in either order they are the same numbers, and the
        /// same bits: a zero is +0. Vertices that are not used become 0.</para>
        /// <para>Returns: the number of vertices, 1 to 8, or 0 where vesica_overlap_f64 says that nothing is
        /// shared.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND (also for two kinds that are not as above), VESICA_E_SHAPE,
        /// VESICA_E_RANGE (a vertex, or the length of a side that makes one, exceeds the finite numbers).</para>
        /// <para>Accuracy: the number of vertices is exact: a true vertex each, before they are rounded. A shape's own
        /// corner has the numbers that are stored, of a rectangle those of vesica_corners_of_shapes_f64. Others are
        /// right to 4 u times the largest coordinate or size of either shape. Bounds on computed numbers use u = 2^-53.
        /// The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths. An
        /// aspect ratio is a shape's longer size over its shorter one.</para>
        /// <para>Cost: that of vesica_overlap_f64 for disjoint shapes; 0.2 to 1 us with a segment, 2 to 6 us for areas;
        /// at worst 300 us, where exponents are wildly unlike.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_intersection_f64(int kindA, void* numbersA, int kindB, void* numbersB,
            void* vertices);

        /// <summary>
        /// <para>The nine-intersection matrix of two shapes (DE-9IM), as geographic systems have it.</para>
        /// <para>Every shape has an inside, an outline and an outside. The nine characters say of a's inside with b's
        /// inside, outline and outside, then of a's outline with those three, then of a's outside, what they share: F
        /// for nothing, else the dimension: 0 for single points, 1 for lines, 2 for an area. The outline of a segment
        /// is its two end points; a point has none; that of a shape with area is the curve around it. A segment without
        /// length is a point; a shape with one size 0 is a segment, with both a point. So a box that shares a side with
        /// another gives "FF2F11212". Exchanging the shapes exchanges rows and columns.</para>
        /// <para>Requires: matrix with room for VESICA_DE9IM_SIZE characters.</para>
        /// <para>Returns: 0, and nine characters and a final NUL in matrix.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.</para>
        /// <para>Accuracy: exact.</para>
        /// <para>Cost: that of vesica_relation_f32; 0.1 to 1 us more for a segment, 2 us for rectangles whose sides are
        /// parallel.</para>
        /// <para>Since: 0.1.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int vesica_de9im_f32(int kindA, void* numbersA, int kindB, void* numbersB, void* matrix);

        /// <summary>
        /// <para>The region that two shapes share, as its vertices: of two with straight outlines, or of a segment and
        /// any shape.</para>
        /// <para>The kinds are points, segments, boxes and rectangles; a point or a segment may also go with a circle
        /// or an ellipse. The region is convex. Its vertices x0 y0 x1 y1 ... come counter-clockwise where y points up,
        /// from the one that is lowest, of two equally low ones the left one, as their numbers have it. One vertex is a
        /// point, two are a segment's ends. Of the same two shapes in either order they are the same numbers, and the
        /// same bits: a zero is +0. Vertices that are not used become 0.</para>
        /// <para>Returns: the number of vertices, 1 to 8, or 0 where vesica_overlap_f32 says that nothing is
        /// shared.</para>
        /// <para>Errors: VESICA_E_NULL, VESICA_E_KIND (also for two kinds that are not as above), VESICA_E_SHAPE,
        /// VESICA_E_RANGE (a vertex, or the length of a side that makes one, exceeds the finite numbers).</para>
        /// <para>Accuracy: the number of vertices is exact: a true vertex each, before they are rounded. A shape's own
        /// corner has the numbers that are stored, of a rectangle those of vesica_corners_of_shapes_f32. Others are
        /// right to 4 u times the largest coordinate or size of either shape. Each number is computed in double, within
        /// these bounds, and then rounded to float once. Bounds on computed numbers use u = 2^-53. The scale of two
        /// shapes is the largest of |dx| and |dy| between their centres and of their half lengths. An aspect ratio is a
        /// shape's longer size over its shorter one.</para>
        /// <para>Cost: that of vesica_overlap_f32 for disjoint shapes; 0.2 to 1 us with a segment, 2 to 6 us for areas;
        /// at worst 300 us, where exponents are wildly unlike.</para>
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
