// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.
use core::ffi::c_void;

pub const VESICA_VERSION_MAJOR: i32 = 0;
pub const VESICA_VERSION_MINOR: i32 = 1;
pub const VESICA_VERSION_PATCH: i32 = 0;
/// of this header: major \* 10000 + minor \* 100 + patch
pub const VESICA_VERSION: i32 = 100;
/// x y
pub const VESICA_POINT: i32 = 0;
/// x0 y0 x1 y1
pub const VESICA_SEGMENT: i32 = 1;
/// cx cy r
pub const VESICA_CIRCLE: i32 = 2;
/// min_x min_y max_x max_y
pub const VESICA_AABB: i32 = 3;
/// cx cy ux uy hx hy
pub const VESICA_RECT: i32 = 4;
/// cx cy ux uy a b
pub const VESICA_ELLIPSE: i32 = 5;
/// x0 y0 x1 y1 r
pub const VESICA_CAPSULE: i32 = 6;
/// cx cy ux uy hx hy r
pub const VESICA_ROUND_RECT: i32 = 7;
/// vertices of one or more rings
pub const VESICA_POLYGON: i32 = 8;
/// vertices of one or more chains
pub const VESICA_POLYLINE: i32 = 9;
/// a and b have no common point
pub const VESICA_DISJOINT: i32 = 0;
/// they have common points, but their insides have none
pub const VESICA_TOUCH: i32 = 1;
/// their insides meet, and neither shape contains the other
pub const VESICA_CROSS: i32 = 2;
/// b contains a, and a has no point of b's outline
pub const VESICA_INSIDE: i32 = 3;
/// b contains a, and a has points of b's outline
pub const VESICA_INSIDE_TOUCH: i32 = 4;
/// a contains b, and b has no point of a's outline
pub const VESICA_CONTAINS: i32 = 5;
/// a contains b, and b has points of a's outline
pub const VESICA_CONTAINS_TOUCH: i32 = 6;
/// a and b are the same set of points
pub const VESICA_EQUAL: i32 = 7;
/// a pointer is NULL
pub const VESICA_E_NULL: i32 = -1;
/// a shape is invalid; vesica_check_f64 or _f32 says why
pub const VESICA_E_SHAPE: i32 = -2;
/// a number is no kind, or the function does not take the kind
pub const VESICA_E_KIND: i32 = -3;
/// another argument is out of its documented range
pub const VESICA_E_ARGUMENT: i32 = -4;
/// a number is NaN or infinite
pub const VESICA_E_NOT_FINITE: i32 = -5;
/// a radius, half extent or half length is negative
pub const VESICA_E_NEGATIVE_SIZE: i32 = -6;
/// the axis (ux, uy) is (0, 0)
pub const VESICA_E_ZERO_AXIS: i32 = -7;
/// an AABB's min exceeds its max
pub const VESICA_E_INVERTED: i32 = -8;
/// a number of the result would overflow its type
pub const VESICA_E_RANGE: i32 = -9;
/// bytes are not an index of this version, or are damaged
pub const VESICA_E_INDEX: i32 = -10;
/// a polygon has no vertex, or its offsets are negative or decrease
pub const VESICA_E_RINGS: i32 = -11;
/// edges of a polygon cross, or overlap along a stretch
pub const VESICA_E_NOT_SIMPLE: i32 = -12;
/// a polygon is not convex, as the function requires
pub const VESICA_E_NOT_CONVEX: i32 = -13;
pub const VESICA_ANGLE_RADIANS: i32 = 0;
pub const VESICA_ANGLE_DEGREES: i32 = 1;
/// quarter turns
pub const VESICA_ANGLE_QUARTERS: i32 = 2;
/// added to a unit: angles turn the other way, from +x towards -y
pub const VESICA_ANGLE_REVERSED: i32 = 4;
/// the mean of its scores s with weights w: sum(w s) / sum(w)
pub const VESICA_FUSED_MEAN: i32 = 0;
/// its highest score
pub const VESICA_FUSED_MAX: i32 = 1;
/// the one of the highest value, taken or not: if it is taken, the detection is a miss
pub const VESICA_MATCH_VOC: i32 = 0;
/// the one of the highest value among those that are free
pub const VESICA_MATCH_COCO: i32 = 1;
/// it counts, and one detection may take it
pub const VESICA_TRUTH_COUNTS: i32 = 0;
/// it does not count, any number may take it: "difficult" (VOC), "iscrowd" (COCO)
pub const VESICA_TRUTH_CROWD: i32 = 1;
/// it does not count, and one may take it: COCO's truths outside a range of areas
pub const VESICA_TRUTH_IGNORED: i32 = 2;
/// it took no truth: a false positive
pub const VESICA_OUTCOME_MISS: i32 = 0;
/// it took one that counts: a true positive
pub const VESICA_OUTCOME_HIT: i32 = 1;
/// it took one that does not count, and is neither
pub const VESICA_OUTCOME_IGNORED: i32 = 2;
/// at 11 recalls, 0, 0.1 ... 1
pub const VESICA_PRECISION_VOC_2007: i32 = 0;
/// at every truth: the area under the curve, of VOC from 2010 on
pub const VESICA_PRECISION_VOC_2010: i32 = 1;
/// at 101 recalls, 0, 0.01 ... 1
pub const VESICA_PRECISION_COCO: i32 = 2;
/// Bhattacharyya's distance, from 0 to infinity
pub const VESICA_GAUSSIAN_BHATTACHARYYA: i32 = 0;
/// Hellinger's distance, from 0 to 1; ProbIoU is 1 - this
pub const VESICA_GAUSSIAN_HELLINGER: i32 = 1;
/// Kullback-Leibler divergence of a from b (KLD), from 0 to infinity
pub const VESICA_GAUSSIAN_KULLBACK_LEIBLER: i32 = 2;
/// squared Wasserstein distance (GWD), an area from 0 to infinity
pub const VESICA_GAUSSIAN_WASSERSTEIN: i32 = 3;
/// a and b overlap, as by vesica_overlap_f64
pub const VESICA_JOIN_OVERLAP: i32 = 0;
/// their bounds in the indexes do: all pairs that overlap, and some that do not
pub const VESICA_JOIN_BOUNDS: i32 = 1;
/// a contains b, as by vesica_contains_f64
pub const VESICA_JOIN_CONTAINS: i32 = 2;
/// b contains a
pub const VESICA_JOIN_INSIDE: i32 = 3;
/// their insides share a point, as by vesica_interiors_overlap_f64
pub const VESICA_JOIN_INTERIORS: i32 = 4;
/// shared area / area of the union of a and b (IoU)
pub const VESICA_RATIO_OVER_UNION: i32 = 0;
/// shared area / area of a (IoF)
pub const VESICA_RATIO_OVER_FIRST: i32 = 1;
/// shared area / area of b (IoA)
pub const VESICA_RATIO_OVER_SECOND: i32 = 2;
/// shared area / the smaller of the areas (IoS)
pub const VESICA_RATIO_OVER_SMALLER: i32 = 3;
/// IoU - (area of the hull that neither covers / area of the hull) (GIoU)
pub const VESICA_RATIO_GENERALIZED: i32 = 4;
/// IoU - (distance of the centres / diagonal of the hull)^2 (DIoU)
pub const VESICA_RATIO_DISTANCE: i32 = 5;
/// DIoU - v^2 / (1 - IoU + v), v = (difference of angles / 90 degrees)^2 (CIoU)
pub const VESICA_RATIO_COMPLETE: i32 = 6;
/// they are farther apart
pub const VESICA_WITHIN_NO: i32 = 0;
/// they are at most that far apart
pub const VESICA_WITHIN_YES: i32 = 1;
/// only with ellipses: the distance is too close to the one asked for to decide
pub const VESICA_WITHIN_NEARLY: i32 = 2;
/// score \* (1 - r) if r exceeds the parameter, a threshold from 0 to 1
pub const VESICA_DECAY_LINEAR: i32 = 0;
/// score \* exp(-r^2 / parameter) if r \> 0; parameter from 2^-100, finite
pub const VESICA_DECAY_GAUSSIAN: i32 = 1;
/// no contact from 0 to t_end
pub const VESICA_CAST_MISS: i32 = 0;
/// contact, the first after t = 0
pub const VESICA_CAST_HIT: i32 = 1;
/// the shapes overlap at t = 0, as vesica_overlap_f64 says
pub const VESICA_CAST_START: i32 = 2;
/// only from vesica_impact_time_f64: none before t, and perhaps none later
pub const VESICA_CAST_NEAR: i32 = 3;
/// characters of a nine-intersection matrix with its final NUL
pub const VESICA_DE9IM_SIZE: i32 = 10;

/// A location.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Point<T> {
    pub x: T,
    pub y: T,
}
/// [`Point`] of f64.
pub type vesica_point_f64 = Point<f64>;
/// [`Point`] of f32.
pub type vesica_point_f32 = Point<f32>;

/// All points between two end points. If the two are the same, the segment is a point.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Segment<T> {
    pub x0: T,
    pub y0: T,
    pub x1: T,
    pub y1: T,
}
/// [`Segment`] of f64.
pub type vesica_segment_f64 = Segment<f64>;
/// [`Segment`] of f32.
pub type vesica_segment_f32 = Segment<f32>;

/// A disc: centre and radius, r \>= 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Circle<T> {
    pub cx: T,
    pub cy: T,
    pub r: T,
}
/// [`Circle`] of f64.
pub type vesica_circle_f64 = Circle<f64>;
/// [`Circle`] of f32.
pub type vesica_circle_f32 = Circle<f32>;

/// A box along the coordinate axes, min_x \<= max_x and min_y \<= max_y.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Aabb<T> {
    pub min_x: T,
    pub min_y: T,
    pub max_x: T,
    pub max_y: T,
}
/// [`Aabb`] of f64.
pub type vesica_aabb_f64 = Aabb<f64>;
/// [`Aabb`] of f32.
pub type vesica_aabb_f32 = Aabb<f32>;

/// All points C + s u + t perp(u) with |s| \<= hx and |t| \<= hy, where C is (cx, cy); hx, hy \>= 0 and u != (0, 0).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Rect<T> {
    pub cx: T,
    pub cy: T,
    pub ux: T,
    pub uy: T,
    pub hx: T,
    pub hy: T,
}
/// [`Rect`] of f64.
pub type vesica_rect_f64 = Rect<f64>;
/// [`Rect`] of f32.
pub type vesica_rect_f32 = Rect<f32>;

/// All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 \<= 1, where C is (cx, cy); a, b \>= 0 and u != (0, 0).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Ellipse<T> {
    pub cx: T,
    pub cy: T,
    pub ux: T,
    pub uy: T,
    pub a: T,
    pub b: T,
}
/// [`Ellipse`] of f64.
pub type vesica_ellipse_f64 = Ellipse<f64>;
/// [`Ellipse`] of f32.
pub type vesica_ellipse_f32 = Ellipse<f32>;

/// All points at most r from the segment from (x0, y0) to (x1, y1), r \>= 0. If its ends are the same, it is a disc.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Capsule<T> {
    pub x0: T,
    pub y0: T,
    pub x1: T,
    pub y1: T,
    pub r: T,
}
/// [`Capsule`] of f64.
pub type vesica_capsule_f64 = Capsule<f64>;
/// [`Capsule`] of f32.
pub type vesica_capsule_f32 = Capsule<f32>;

/// All points at most r \>= 0 from the rectangle (cx, cy, ux, uy, hx, hy): one with round corners.
/// hx and hy are the rectangle's, in units of the axis, without the radius; r is in units of the coordinates.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct RoundRect<T> {
    pub cx: T,
    pub cy: T,
    pub ux: T,
    pub uy: T,
    pub hx: T,
    pub hy: T,
    pub r: T,
}
/// [`RoundRect`] of f64.
pub type vesica_round_rect_f64 = RoundRect<f64>;
/// [`RoundRect`] of f32.
pub type vesica_round_rect_f32 = RoundRect<f32>;

/// A polygon, or a polyline: vertices in the caller's memory, which are read and not kept.
///
/// A polygon is the points on an edge, and those around which its rings cross an odd number of times. So a ring inside
/// another one is a hole, and rings need no order and no direction. Each ring's last vertex is joined to its first,
/// which may also be repeated at the end. A ring of one vertex is a point, one of two a segment. A polyline is the
/// points on an edge of its chains, which are not closed. It has no inside. Vertex i is at x + i \* stride bytes and y
/// + i \* stride bytes. stride is 16 for x y x y ..., 8 for two columns. rings has count + 1 offsets: ring j has the
/// vertices rings\[j\] to rings\[j + 1\] - 1. If rings is NULL there is one ring of `count` vertices. At least one
/// vertex is needed; empty rings are allowed.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Polygon<T> {
    pub x: *const T,
    pub y: *const T,
    pub stride: isize,
    pub rings: *const i32,
    pub count: i64,
}
/// [`Polygon`] of f64.
pub type vesica_polygon_f64 = Polygon<f64>;
/// [`Polygon`] of f32.
pub type vesica_polygon_f32 = Polygon<f32>;

/// A polyline. Its members are laid out as those of vesica_polygon_f64, with chains for rings.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Polyline<T> {
    pub x: *const T,
    pub y: *const T,
    pub stride: isize,
    pub rings: *const i32,
    pub count: i64,
}
/// [`Polyline`] of f64.
pub type vesica_polyline_f64 = Polyline<f64>;
/// [`Polyline`] of f32.
pub type vesica_polyline_f32 = Polyline<f32>;

/// Facts about a polygon, from vesica_polygon_facts_f64.
///
/// vertices leaves out those that repeat the one before on their ring, which closes. Two edges that cross or overlap
/// begin at the vertices first_crossing and second_crossing, which are -1 if there are none, and simple is then 1.
/// orientation is 1 if the inside is on the left of the first ring's edges, -1 on the right, 0 of a polygon without
/// area. area is that of vesica_shape_area_f64 with the sign of the orientation. convex is 1 if vesica_depth_f64 takes
/// the polygon. rings are those with a vertex.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Facts<T> {
    pub vertices: i64,
    pub first_crossing: i64,
    pub second_crossing: i64,
    pub area: T,
    pub orientation: i32,
    pub convex: i32,
    pub simple: i32,
    pub rings: i32,
}
/// [`Facts`] of f64.
pub type vesica_facts_f64 = Facts<f64>;
/// [`Facts`] of f32.
pub type vesica_facts_f32 = Facts<f32>;

/// A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct ClosestPoints<T> {
    pub distance: T,
    pub ax: T,
    pub ay: T,
    pub bx: T,
    pub by: T,
}
/// [`ClosestPoints`] of f64.
pub type vesica_closest_points_f64 = ClosestPoints<f64>;
/// [`ClosestPoints`] of f32.
pub type vesica_closest_points_f32 = ClosestPoints<f32>;

/// The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Penetration<T> {
    pub depth: T,
    pub x: T,
    pub y: T,
}
/// [`Penetration`] of f64.
pub type vesica_penetration_f64 = Penetration<f64>;
/// [`Penetration`] of f32.
pub type vesica_penetration_f32 = Penetration<f32>;

/// An array of shapes of one kind in any memory layout: records, packed or padded, or one column per number.
///
/// Number k of element i is at field\[k\] + i \* stride bytes, with k in the order of the shape's struct. stride is the
/// size of a record for records, sizeof(double) for columns, 0 to repeat one shape, and negative to run backwards.
/// Fields beyond those of the kind are ignored. Numbers need no alignment.
/// reserved must be 0, and of these kinds each 0 and rings and polygons NULL. vesica_shapes_from_records_f64 sets them;
/// if you fill the struct yourself, start from {0}.
///
/// For polygons and polylines, field\[0\] and field\[1\] are x and y of vertex 0, and stride leads from vertex to
/// vertex. Which vertices element i has is said in one of four ways:  - each \> 0, rings NULL: vertices i \* each to (i
/// + 1) \* each - 1. So 4 describes quads, and 3 triangles.  - rings, and polygons NULL: the one ring rings\[i\] to
/// rings\[i + 1\] - 1.  - rings and polygons: the rings polygons\[i\] to polygons\[i + 1\] - 1. These are the offsets
/// of GeoArrow's polygons.  - each 0, rings NULL: field\[0\] is the first of structs vesica_polygon_f64, stride bytes
/// apart. field\[1\] is ignored. With rings, each may be the number of vertices in the columns, or 0. If it is given,
/// an element whose offsets exceed it is invalid, and nothing beyond is read. Offsets must be aligned.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Shapes<T> {
    pub kind: i32,
    pub reserved: i32,
    pub count: i64,
    pub stride: isize,
    pub field: [*const T; 8],
    pub rings: *const i32,
    pub polygons: *const i32,
    pub each: i64,
}
/// [`Shapes`] of f64.
pub type vesica_shapes_f64 = Shapes<f64>;
/// [`Shapes`] of f32.
pub type vesica_shapes_f32 = Shapes<f32>;

/// All heights from low to high; low \<= high, both finite.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Span<T> {
    pub low: T,
    pub high: T,
}
/// [`Span`] of f64.
pub type vesica_span_f64 = Span<f64>;
/// [`Span`] of f32.
pub type vesica_span_f32 = Span<f32>;

/// A grid of cells, such as the pixels of a picture.
///
/// Cell (i, j) of column i and row j is the box from (x + i dx, y + j dy) to (x + (i + 1) dx, y + (j + 1) dy).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Grid<T> {
    pub x: T,
    pub y: T,
    pub dx: T,
    pub dy: T,
    pub columns: i64,
    pub rows: i64,
}
/// [`Grid`] of f64.
pub type vesica_grid_f64 = Grid<f64>;
/// [`Grid`] of f32.
pub type vesica_grid_f32 = Grid<f32>;

/// A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.
///
/// After a miss t is infinity and all other numbers are NaN.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Impact<T> {
    pub t: T,
    pub x: T,
    pub y: T,
    pub nx: T,
    pub ny: T,
}
/// [`Impact`] of f64.
pub type vesica_impact_f64 = Impact<f64>;
/// [`Impact`] of f32.
pub type vesica_impact_f32 = Impact<f32>;

/// How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which it
/// turns about its centre. Positive angles turn counter-clockwise if y points up.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Turn<T> {
    pub vx: T,
    pub vy: T,
    pub angle: T,
}
/// [`Turn`] of f64.
pub type vesica_turn_f64 = Turn<f64>;
/// [`Turn`] of f32.
pub type vesica_turn_f32 = Turn<f32>;

/// The contacts of two overlapping convex shapes: their count, 0 to 2, and one unit normal (nx, ny) from a to b.
///
/// Contact 0 is at (x0, y0) with depth0, and numbers a0 of shape a and b0 of shape b name it; likewise contact 1. All
/// numbers of a contact that is missing are 0, and so is the normal if there is none.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub struct Contacts<T> {
    pub nx: T,
    pub ny: T,
    pub x0: T,
    pub y0: T,
    pub depth0: T,
    pub x1: T,
    pub y1: T,
    pub depth1: T,
    pub a0: i64,
    pub b0: i64,
    pub a1: i64,
    pub b1: i64,
    pub count: i64,
}
/// [`Contacts`] of f64.
pub type vesica_contacts_f64 = Contacts<f64>;
/// [`Contacts`] of f32.
pub type vesica_contacts_f32 = Contacts<f32>;

extern "C" {
    /// Do two shapes share a point? Touching counts.
    ///
    /// Returns: 1 if they do, 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: as the function named after the two kinds, and a dispatch.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    /// Do the insides of two shapes share a point? Touching does not count.
    ///
    /// The inside is the shape without its outline, as vesica_relation_f64 says. So two rectangles side by side get 0,
    /// and so does a point on the rim of a disc or a segment along an edge. Two segments that cross get 1, and two
    /// equal points. If both shapes have an area, the answer is 1 where vesica_relation_f64 is VESICA_CROSS or more.
    ///
    /// Returns: 1 if they do, 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: as vesica_overlap_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_interiors_overlap_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    /// Does a contain all of b? A shape contains itself, and whatever touches its outline from inside.
    ///
    /// Returns: 1 if vesica_relation_f64 is VESICA_CONTAINS, VESICA_CONTAINS_TOUCH or VESICA_EQUAL, else 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: as vesica_relation_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_contains_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    /// How does a relate to b? The answer is one of the eight relations of the region connection calculus (RCC-8).
    ///
    /// The outline of a shape with area is the curve around it. The outline of a segment, or of a shape with one size
    /// zero, is its two end points. A point, or a shape without any size, has no outline. The inside is the shape
    /// without its outline. If several relations fit, VESICA_EQUAL comes first, then those of containment, then
    /// VESICA_CROSS. So a segment that ends on the middle of another touches it; two segments on one line that overlap
    /// in part cross; a point on the rim of a disc is VESICA_INSIDE_TOUCH. Exchanging the shapes always gives the
    /// converse relation.
    ///
    /// The outline of a polygon is its edges, but a polygon whose vertices are on one line is a segment. The outline of
    /// a polyline is the points where an odd number of its chains end.
    ///
    /// Requires: simple polygons, as vesica_check_f64 says. Others get one of the eight relations, without a meaning.
    /// The same holds for vesica_contains_f64 and vesica_interiors_overlap_f64.
    ///
    /// Returns: VESICA_DISJOINT ... VESICA_EQUAL. Equal sets are VESICA_EQUAL, whatever kinds and numbers describe
    /// them.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: up to twice vesica_overlap_f64; more if shapes touch or are equal.
    ///
    /// Since: 0.1.
    pub fn vesica_relation_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    /// How far apart are two solid shapes, and which of their points are closest?
    ///
    /// If the shapes overlap (as vesica_overlap_f64 says), the distance is 0 and both points are one common point. If
    /// not, the distance is \> 0. Exchanging the shapes exchanges the points and changes no bit. Moving both shapes
    /// alike changes no bit of the distance if no coordinate is rounded. The distance of a polygon or a polyline is the
    /// least over its edges, each asked as a segment.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the distance is right to 4 u scale at any aspect ratio; the largest error seen was 1 u scale, and 3.3
    /// u beside the ends of the thinnest ellipses. Its relative error is at most 2 u above 1e-10 scale (aspect ratios
    /// up to 1e6) or 1e-14 scale (up to 1000). Closest points are right to 4 u scale, and a common point to 8 u scale,
    /// before they are rounded. Points of capsules and rounded rectangles are rounded twice. For polygons and polylines
    /// the scale is the largest over pairs of an edge and the other shape or its edge. In bounds on errors u is 2^-53,
    /// half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their
    /// centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect
    /// ratio is longer over shorter size.
    ///
    /// Cost: ten to thirty times vesica_overlap_f64; more for shapes that cross and near-ties.
    ///
    /// Since: 0.1.
    pub fn vesica_nearest_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut ClosestPoints<f64>) -> i32;
    /// Penetration depth: how far and which way must b be moved until the two shapes only touch?
    ///
    /// Moving b by out-\>depth along the unit vector (x, y) is the shortest translation after which a line separates
    /// the shapes: a on one side, b on the other, where both may touch the line. For disjoint shapes all three numbers
    /// are 0. Overlapping shapes always get a direction. Their depth is 0 if such a line exists without a move: if they
    /// touch from outside, if a point lies on an outline, or if points and segments lie along one line. Otherwise the
    /// depth is \> 0. Exchanging the shapes reverses the direction and changes no other bit, except for two equal
    /// shapes in one place. Moving both shapes alike changes no bit if no coordinate is rounded. Polygons must be
    /// convex: one ring that turns one way only and winds once, collinear vertices allowed. A polygon or polyline whose
    /// vertices are on one line is a segment or a point.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_NOT_CONVEX, VESICA_E_RANGE.
    ///
    /// Accuracy: at aspect ratios up to 1e6 the depth is right to 4 u scale; for circles and points, to its last place.
    /// The length of (x, y) is 1 to 3 u. After the move at most 8 u scale of overlap is left. Whether the depth is 0 is
    /// exact at any ratio; beyond 1e6 no bound on its error is stated. In bounds on errors u is 2^-53, half a unit in
    /// the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their
    /// half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over
    /// shorter size.
    ///
    /// Cost: about as vesica_nearest_f64; three times as much with an ellipse.
    ///
    /// Since: 0.1.
    pub fn vesica_depth_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut Penetration<f64>) -> i32;
    /// Area of the intersection of two shapes.
    ///
    /// It is exactly 0 if shapes are disjoint, if they only touch, or if one has no area. If one contains the other, it
    /// is the vesica_shape_area_f64 of the inner one. It is never more than the area of either, and more than 0 if the
    /// insides of shapes with area meet, unless that underflows. Exchanging the shapes changes no bit. Scaling both by
    /// a power of two scales the area by its square.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: right to 64 u times the smaller shape's area times the larger aspect ratio, at aspect ratios up to
    /// 10^4, even if the outlines nearly touch or coincide and whatever the sizes are. Beyond 10^4 no bound is stated;
    /// what is said above holds at any ratio. With a capsule or a rounded rectangle the bound holds if neither shape is
    /// more than 10^12 times as long as the other.
    /// Polygons: their edges must not cross. Rings have any order and direction. An area within its error bound of 0 is
    /// 0, and one within it of the smaller shape's area is that area; if both hold, the exact relation decides. So it
    /// is exactly 0 if shapes only touch, and exactly the inner one's area if one contains the other; but insides that
    /// share less than the bound share 0, too. Of two polygons the bound is 192 u g w: g is the greatest height above
    /// or below the middle of the box that their boxes share, and w the sum of the widths that pairs of their edges
    /// share, for convex polygons 4 times the width of that box. With another shape it is 192 u t l: t is that shape's
    /// half width and half height and the polygon's greatest distance from its centre, and l the length of the outline
    /// in it and the same half lengths; in units of its half lengths if it is an ellipse. A polyline has no area. In
    /// bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx|
    /// and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u
    /// times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: six times vesica_overlap_f64 for boxes, fifty times for two ellipses; more if outlines nearly touch or
    /// coincide, or if one shape is far larger.
    ///
    /// Since: 0.1.
    pub fn vesica_area_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f64) -> i32;
    /// Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
    ///
    /// It is exactly 1 for equal shapes and exactly 0 for shapes that share no area. Intermediate results never
    /// overflow or underflow. Exchanging the shapes, or scaling both by a power of two, changes no bit.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (neither shape has an area).
    ///
    /// Accuracy: the bound of vesica_area_f64, divided by the area of the union; for polygons up to three times as
    /// much.
    ///
    /// Cost: vesica_area_f64 and twice vesica_shape_area_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_iou_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f64) -> i32;
    /// Smallest box of representable numbers that contains a shape.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: each side is the true extreme of the shape, rounded outward once. So a representable box is exact.
    ///
    /// Cost: up to ten times vesica_overlap_f64; more for magnitudes above 2^400 or below 2^-400.
    ///
    /// Since: 0.1.
    pub fn vesica_bounds_f64(kind: i32, shape: *const c_void, out: *mut Aabb<f64>) -> i32;
    /// Is a shape valid, and if not, which rule does it break?
    ///
    /// A polygon is simple if its edges neither cross nor overlap along a stretch; they may touch. A ring of two places
    /// is allowed. Functions that need this say so; they do not check it, and vesica_overlap_f64 and others take any
    /// polygon.
    ///
    /// Returns: 0 for a valid shape, else the first rule broken: VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE,
    /// VESICA_E_ZERO_AXIS, VESICA_E_INVERTED, VESICA_E_RINGS or VESICA_E_NOT_SIMPLE.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND.
    ///
    /// Since: 0.1.
    pub fn vesica_check_f64(kind: i32, shape: *const c_void) -> i32;
    /// The meaning of an error code, as one English phrase without a full stop.
    ///
    /// Returns: static text, never NULL: "success" for answers (\>= 0), "unknown error" for unknown codes.
    ///
    /// Errors: none.
    ///
    /// Since: 0.1.
    pub fn vesica_strerror(code: i32) -> *const u8;
    /// Where do the outlines of two shapes meet? Touching counts.
    ///
    /// The outline of a shape with area is the curve around it. A segment, a point and a shape without area are their
    /// own outlines. A contact is one place, however closely the curves touch there. If straight parts of outlines
    /// share a stretch, or arcs about one corner do, its two end points are places, and \*shared is 1. So equal boxes
    /// meet at their four corners, and equal capsules where their sides begin and end. Equal circles and ellipses meet
    /// everywhere: then the count is 0 and \*shared is 1. Places come in order along a's outline, counter-clockwise in
    /// the frame of its axis. The start is a box's corner C - hx u - hy perp(u), an ellipse's point C + a u (one
    /// without area begins as a box), a circle's point C + (r, 0), or a segment's first end. With a radius the start is
    /// where the side from that corner or end begins: for a capsule, its right side, seen from the first end. With a
    /// polygon or a polyline, places come in order along that, or along a if both are: from the first vertex of the
    /// first ring on. A vertex on an edge is a place. Within a stretch that is shared, vertices where both outlines go
    /// straight on are none. A polygon whose vertices are on one line is a segment that begins at its least x, then
    /// least y. Where edges of a polygon or a polyline cross one another on the other outline, a place may count for
    /// each of them.
    ///
    /// Requires: capacity, how many places out has room for. It may be 0, and out then NULL. shared may be NULL.
    ///
    /// Returns: how many places there are, even if that exceeds the capacity: at most 8, or 12 of an ellipse with a
    /// rounded rectangle, unless a shape is a polygon or a polyline. The first `capacity` are written, and \*shared is
    /// set to 1 or 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a negative capacity), VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the number is exact. A place is right to 4 u times the largest coordinate or size of either shape,
    /// even where the outlines nearly coincide. Places closer to one another than that may come in either order or be
    /// equal. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the
    /// largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of
    /// at most 4 u times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: several times vesica_nearest_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_crossings_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Point<f64>,
        capacity: i64, shared: *mut i32) -> i64;
    /// How far apart are the outlines of two shapes, and where do they come closest?
    ///
    /// The outline of a shape with area is the curve around it. A point, a segment and a shape with a zero size are
    /// their own outlines. The outline of a polygon or a polyline is its edges. If outlines meet, the distance is 0 and
    /// (ax, ay) = (bx, by) is a point of both. If shapes are disjoint, the result is as of vesica_nearest_f64. If one
    /// is strictly inside the other, the distance is the least over the whole outline, never a local minimum. Which
    /// case holds is decided exactly. Exchanging the shapes exchanges the points and changes no bit. Moving both shapes
    /// alike changes no bit of the distance if no coordinate is rounded.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: at aspect ratios up to 1e6 the distance is right to 4 u scale, and the points are that far apart to 16
    /// u scale. At any ratio it is above 0 unless outlines meet, and points are on them to 12 u scale before they are
    /// rounded. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the
    /// largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of
    /// at most 4 u times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: as vesica_nearest_f64 for disjoint shapes; up to three times as much if outlines meet or are nested, with
    /// a capsule or a rounded rectangle up to twenty times.
    ///
    /// Since: 0.1.
    pub fn vesica_boundary_distance_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut ClosestPoints<f64>) -> i32;
    /// Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment. A radius
    /// r adds r times the core's perimeter, and pi r r; the perimeter of a segment is twice its length.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the double nearest to the true area; a tiny area becomes subnormal or 0. So a shape inside another
    /// never has the greater area, and equal shapes have equal areas, whatever kinds and numbers describe them.
    /// Capsules and rounded rectangles that have both a size and a radius are excepted: their area is computed with a
    /// relative error of 2^-96 and rounded once, so it may rarely be the double beside the nearest. A polygon's edges
    /// must not cross; its area is right to 8 u times the height of its box times the sum of its edges' widths, and 0
    /// only if each ring is flat. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two
    /// shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale"
    /// means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Since: 0.1.
    pub fn vesica_shape_area_f64(kind: i32, shape: *const c_void, out: *mut f64) -> i32;
    /// States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
    ///
    /// The first ring is the first one that is neither a point nor a segment. If y points up, a shell whose inside is
    /// on the left of its edges is counter-clockwise. Where several pairs of edges cross, any one of them is named.
    /// Then area and orientation mean nothing.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (the area).
    ///
    /// Accuracy: exact, but the area, which is as vesica_shape_area_f64 says.
    ///
    /// Cost: as vesica_check_f64, and a few ns for each vertex.
    ///
    /// Since: 0.1.
    pub fn vesica_polygon_facts_f64(polygon: *const Polygon<f64>, out: *mut Facts<f64>) -> i32;
    /// Are the two points the same?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_point_f64(a: *const Point<f64>, b: *const Point<f64>) -> i32;
    /// Does the point lie on the segment? End points count.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_segment_f64(a: *const Point<f64>, b: *const Segment<f64>) -> i32;
    /// Does the point lie in the disc or on its rim?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_circle_f64(a: *const Point<f64>, b: *const Circle<f64>) -> i32;
    /// Does the point lie in the box or on its outline?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_aabb_f64(a: *const Point<f64>, b: *const Aabb<f64>) -> i32;
    /// Does the point lie in the rectangle or on its outline?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_rect_f64(a: *const Point<f64>, b: *const Rect<f64>) -> i32;
    /// Does the point lie in the ellipse or on its outline?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_ellipse_f64(a: *const Point<f64>, b: *const Ellipse<f64>) -> i32;
    /// Do the segments share a point? End points count, and so do stretches along one line.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_segment_segment_f64(a: *const Segment<f64>, b: *const Segment<f64>) -> i32;
    /// Does the segment meet the disc? A tangent segment does.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_segment_circle_f64(a: *const Segment<f64>, b: *const Circle<f64>) -> i32;
    /// Does the segment meet the box? A segment inside it does.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_segment_aabb_f64(a: *const Segment<f64>, b: *const Aabb<f64>) -> i32;
    /// Does the segment meet the rectangle? A segment inside it does.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_segment_rect_f64(a: *const Segment<f64>, b: *const Rect<f64>) -> i32;
    /// Does the segment meet the ellipse? A tangent segment does.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_segment_ellipse_f64(a: *const Segment<f64>, b: *const Ellipse<f64>) -> i32;
    /// Do the discs share a point? Discs that touch from outside do.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_circle_circle_f64(a: *const Circle<f64>, b: *const Circle<f64>) -> i32;
    /// Do the disc and the box share a point?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_circle_aabb_f64(a: *const Circle<f64>, b: *const Aabb<f64>) -> i32;
    /// Do the disc and the rectangle share a point?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_circle_rect_f64(a: *const Circle<f64>, b: *const Rect<f64>) -> i32;
    /// Do the disc and the ellipse share a point?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_circle_ellipse_f64(a: *const Circle<f64>, b: *const Ellipse<f64>) -> i32;
    /// Do the boxes share a point? Boxes that share an edge or a corner do.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_aabb_aabb_f64(a: *const Aabb<f64>, b: *const Aabb<f64>) -> i32;
    /// Do the box and the rectangle share a point?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_aabb_rect_f64(a: *const Aabb<f64>, b: *const Rect<f64>) -> i32;
    /// Do the box and the ellipse share a point?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_aabb_ellipse_f64(a: *const Aabb<f64>, b: *const Ellipse<f64>) -> i32;
    /// Do the rectangles share a point? Rectangles that share an edge or a corner do.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_rect_rect_f64(a: *const Rect<f64>, b: *const Rect<f64>) -> i32;
    /// Do the rectangle and the ellipse share a point? They do if one is inside the other.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_rect_ellipse_f64(a: *const Rect<f64>, b: *const Ellipse<f64>) -> i32;
    /// Do the ellipses share a point? They do if one is inside the other.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_ellipse_ellipse_f64(a: *const Ellipse<f64>, b: *const Ellipse<f64>) -> i32;
    /// Box with two opposite corners, in any order.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE.
    ///
    /// Accuracy: exact.
    ///
    /// Since: 0.1.
    pub fn vesica_aabb_from_corners_f64(x0: f64, y0: f64, x1: f64, y1: f64, out: *mut Aabb<f64>) -> i32;
    /// Rectangle from centre, angle and full size: width along the angle, height across it.
    ///
    /// Requires: the angle in radians, counter-clockwise from +x if y points up; width, height \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
    ///
    /// Accuracy: the axis is (cos, sin), each right to 1.1 units in the last place, and of equal components at the
    /// doubles nearest to +-pi/4 and +-3pi/4. No double is exactly pi/2, so a quarter turn has an exact axis only by
    /// vesica_rects_from_boxes_f64, which takes degrees too. Sizes are exact: if halving one would round (an odd
    /// multiple of the smallest subnormal number), the axis is halved instead.
    ///
    /// Since: 0.1.
    pub fn vesica_rect_from_angle_f64(cx: f64, cy: f64, angle: f64, width: f64, height: f64,
        out: *mut Rect<f64>) -> i32;
    /// Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
    ///
    /// Corners that are not exactly a rectangle's give a rectangle near them, which need not contain them. The centre
    /// is the mean of the corners. The axis is a unit vector along the edge from corner 0 to corner 1, and hx belongs
    /// to that edge. Opposite edges are averaged; the longer pair gives the direction, and the shorter pair counts by
    /// its part across it. Two or four equal corners are legal: they give a segment, or a point with axis (1, 0).
    /// vesica_rect_corners_misfit_f64 says how far the corners are off.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (opposite edges are more than 90 degrees apart, as
    /// with corners in another order), VESICA_E_RANGE (a half extent overflows). Edges that are no longer along x and y
    /// than 8 epsilon times the largest coordinate may be rounding, and are not an error. Epsilon is 2^-52, or 2^-23 in
    /// float.
    ///
    /// Accuracy: half extents, and the axis times the longer one, are right to 8 units in the last place of the longer
    /// one; the centre is right to 1 unit in its own. Both errors may grow by 2^-98 times the largest coordinate. A
    /// rectangle along the coordinate axes is found exactly if its centre and half extents are representable.
    ///
    /// Since: 0.1.
    pub fn vesica_rect_from_corners_f64(corners: *const f64, out: *mut Rect<f64>) -> i32;
    /// The largest distance from a given corner to the rectangle's corner that corresponds to it.
    ///
    /// The four corners may start at any corner of the rectangle and run in either sense: the least result of the eight
    /// ways counts. So 0 means that they are exactly the rectangle's corners, in order round the outline. The rectangle
    /// may come from vesica_rect_from_corners_f64, or be any other.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, errors of the rectangle as vesica_check_f64, VESICA_E_RANGE (the
    /// result overflows).
    ///
    /// Accuracy: 3 units in the last place, plus 2^-96 times the largest coordinate of corners, centre and half axes.
    ///
    /// Since: 0.1.
    pub fn vesica_rect_corners_misfit_f64(corners: *const f64, r: *const Rect<f64>, misfit: *mut f64) -> i32;
    /// Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
    /// across.
    ///
    /// Requires: the angle in radians, counter-clockwise from +x if y points up; width, height, radius \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE, VESICA_E_ARGUMENT (the radius is more than
    /// half the width or height).
    ///
    /// Accuracy: the axis as vesica_rect_from_angle_f64; the radius is exact. The sizes of the rectangle inside, width
    /// - 2 radius and height - 2 radius, are each rounded once. With radius 0 it is that function's rectangle.
    ///
    /// Since: 0.1.
    pub fn vesica_round_rect_from_angle_f64(cx: f64, cy: f64, angle: f64, width: f64, height: f64, radius: f64,
        out: *mut RoundRect<f64>) -> i32;
    /// Capsule from centre, angle, the length between the ends of its segment, and radius.
    ///
    /// The angle points from (x0, y0) to (x1, y1). The whole capsule is length + 2 radius long.
    ///
    /// Requires: the angle in radians, counter-clockwise from +x if y points up; length, radius \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE, VESICA_E_RANGE (an end overflows).
    ///
    /// Accuracy: the ends are those of the segment that vesica_rect_from_angle_f64 makes of this length and height 0,
    /// each coordinate right to 0.51 units in its last place. With centre (0, 0) they are opposite. The radius is
    /// exact.
    ///
    /// Since: 0.1.
    pub fn vesica_capsule_from_angle_f64(cx: f64, cy: f64, angle: f64, length: f64, radius: f64,
        out: *mut Capsule<f64>) -> i32;
    /// Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round ends.
    ///
    /// Requires: width \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
    ///
    /// Accuracy: exact. Only half an odd multiple of the smallest subnormal number is rounded, to an even multiple.
    ///
    /// Since: 0.1.
    pub fn vesica_capsule_from_width_f64(x0: f64, y0: f64, x1: f64, y1: f64, width: f64, out: *mut Capsule<f64>) -> i32;
    /// Ellipse from centre, angle and half lengths: a along the angle, b across it.
    ///
    /// Requires: the angle in radians, counter-clockwise from +x if y points up; a, b \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
    ///
    /// Accuracy: the axis as vesica_rect_from_angle_f64; half lengths are exact.
    ///
    /// Since: 0.1.
    pub fn vesica_ellipse_from_angle_f64(cx: f64, cy: f64, angle: f64, a: f64, b: f64, out: *mut Ellipse<f64>) -> i32;
    /// Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
    ///
    /// A zero vector gives the point (cx, cy).
    ///
    /// Requires: ratio \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
    ///
    /// Accuracy: exact.
    ///
    /// Since: 0.1.
    pub fn vesica_ellipse_from_radius_vector_f64(cx: f64, cy: f64, wx: f64, wy: f64, ratio: f64,
        out: *mut Ellipse<f64>) -> i32;
    /// Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
    ///
    /// A singular covariance, or k = 0, gives a segment or a point. The result has a \>= b. Its axis is a unit vector
    /// with x \>= 0, or (1, 0) for equal variances without correlation.
    ///
    /// Requires: the covariance cxx, cxy, cyy (units squared) positive semidefinite: cxy^2 \<= cxx cyy as stored; k \>=
    /// 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE (k \< 0), VESICA_E_ARGUMENT (not a
    /// covariance), VESICA_E_RANGE (a half length overflows).
    ///
    /// Accuracy: half lengths and both components of the axis are right to 8 units in their own last place, even if the
    /// matrix is nearly singular or nearly a circle's. Exchanging cxx and cyy exchanges the components, up to signs.
    ///
    /// Since: 0.1.
    pub fn vesica_ellipse_from_covariance_f64(mean_x: f64, mean_y: f64, cxx: f64, cxy: f64, cyy: f64, k: f64,
        out: *mut Ellipse<f64>) -> i32;
    /// Ellipse of the points X with (X - C) . M (X - C) \<= 1, where M is symmetric with entries mxx, mxy, myy.
    ///
    /// The result is as of vesica_ellipse_from_covariance_f64 for the inverse of M and k = 1.
    ///
    /// Requires: M positive definite as stored.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (not positive definite).
    ///
    /// Accuracy: as vesica_ellipse_from_covariance_f64. No half length overflows.
    ///
    /// Since: 0.1.
    pub fn vesica_ellipse_from_matrix_f64(cx: f64, cy: f64, mxx: f64, mxy: f64, myy: f64,
        out: *mut Ellipse<f64>) -> i32;
    /// Describes an array of `count` records. Each starts with a shape's struct.
    ///
    /// Requires: base, the first record's shape, which may be NULL if count is 0; stride, the bytes from one record to
    /// the next; count \>= 0.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (negative count).
    ///
    /// Since: 0.1.
    pub fn vesica_shapes_from_records_f64(kind: i32, count: i64, base: *const c_void, stride: isize,
        out: *mut Shapes<f64>) -> i32;
    /// Do a\[i\] and b\[i\] share a point? out\[i\] is the answer of vesica_overlap_f64.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a fifth to a tenth of vesica_overlap_f64 a pair; about half of that if one array is a single shape.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8) -> i64;
    /// Do the insides of a\[i\] and b\[i\] share a point? out\[i\] is the answer of vesica_interiors_overlap_f64.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: as vesica_overlap_many_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_interiors_overlap_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8) -> i64;
    /// How does a\[i\] relate to b\[i\]? out\[i\] is the answer of vesica_relation_f64.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many are not VESICA_DISJOINT.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_relation_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8) -> i64;
    /// Does a\[i\] contain all of b\[i\]? out\[i\] is the answer of vesica_contains_f64.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_contains_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8) -> i64;
    /// How far apart are a\[i\] and b\[i\], and where? The columns are the fields of vesica_nearest_f64's result.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many pairs overlap (distance 0).
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_nearest_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, distance: *mut f64, ax: *mut f64,
        ay: *mut f64, bx: *mut f64, by: *mut f64) -> i64;
    /// How far apart are the outlines of a\[i\] and b\[i\]? The columns are the fields of
    /// vesica_boundary_distance_f64's result.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many pairs of outlines meet (distance 0).
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_boundary_distance_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, distance: *mut f64,
        ax: *mut f64, ay: *mut f64, bx: *mut f64, by: *mut f64) -> i64;
    /// How deep do a\[i\] and b\[i\] overlap? The columns are the fields of vesica_depth_f64's result.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many depths are \> 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_depth_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, depth: *mut f64, x: *mut f64,
        y: *mut f64) -> i64;
    /// The area that a\[i\] and b\[i\] share: out\[i\] is the result of vesica_area_f64.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many areas are \> 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_area_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64) -> i64;
    /// Intersection over union of a\[i\] and b\[i\]: out\[i\] is the result of vesica_iou_f64.
    ///
    /// If neither of a pair has an area, out\[i\] is NaN, and the call returns VESICA_E_ARGUMENT unless a shape is
    /// invalid.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_iou_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64) -> i64;
    /// Do a\[i\] and b\[j\] share a point? The elements of out are answers of vesica_overlap_f64. Arrays in spatial
    /// order are much faster.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_matrix_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8,
        row_stride: isize) -> i64;
    /// Do the insides of a\[i\] and b\[j\] share a point? The elements of out are answers of
    /// vesica_interiors_overlap_f64.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_interiors_overlap_matrix_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8,
        row_stride: isize) -> i64;
    /// How does a\[i\] relate to b\[j\]? The elements of out are answers of vesica_relation_f64.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are not VESICA_DISJOINT.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_relation_matrix_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8,
        row_stride: isize) -> i64;
    /// Does a\[i\] contain all of b\[j\]? The elements of out are answers of vesica_contains_f64.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_contains_matrix_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8,
        row_stride: isize) -> i64;
    /// The area that a\[i\] and b\[j\] share. The elements of out are results of vesica_area_f64.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_area_matrix_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64,
        row_stride: isize) -> i64;
    /// Intersection over union of a\[i\] and b\[j\]. The elements of out are results of vesica_iou_f64.
    ///
    /// If neither of a pair has an area, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_iou_matrix_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64, row_stride: isize) -> i64;
    /// Which of many shapes overlap one? Their indices are written to out\[0\], out\[1\] ..., in ascending order.
    ///
    /// Requires: one, an array of count 1, which is looked at unless many is empty; capacity, how many indices out has
    /// room for. It may be 0, and out then NULL.
    ///
    /// Returns: how many there are, even if that exceeds the capacity. If room is left, the entry after the last is -1.
    ///
    /// Errors: VESICA_E_SHAPE if a shape is invalid: it is not selected, and the others are written as usual, up to the
    /// -1 or the capacity. Before anything is written: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (one's count is
    /// not 1, a negative capacity, and as vesica_overlap_many_f64).
    ///
    /// Accuracy: every answer is as of vesica_overlap_f64.
    ///
    /// Cost: as vesica_overlap_many_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_select_f64(one: *const Shapes<f64>, many: *const Shapes<f64>, out: *mut i64,
        capacity: i64) -> i64;
    /// Which of many shapes share a point of their insides with that of one? As vesica_overlap_select_f64, with the
    /// answers of vesica_interiors_overlap_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_interiors_overlap_select_f64(one: *const Shapes<f64>, many: *const Shapes<f64>, out: *mut i64,
        capacity: i64) -> i64;
    /// How many bytes of scratch do vesica_nms_f64, vesica_suppress_f64 and their float forms need for `count` shapes?
    ///
    /// Returns: 0.4 MB, and for each shape at most 140 bytes, about 97 from 10,000 shapes on.
    ///
    /// Errors: VESICA_E_ARGUMENT (a negative count, or one above 2147483647).
    ///
    /// Since: 0.1.
    pub fn vesica_nms_scratch(count: i64) -> i64;
    /// Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one
    /// whose vesica_iou_f64 with every shape kept before is at most the threshold.
    ///
    /// The lower index of equal scores comes first. Infinite scores are legal. At threshold 1 all shapes are kept.
    /// Shapes without an area suppress none and are not suppressed.
    ///
    /// Requires: shapes, of a kind with an area; scores, one for each; threshold from 0 to 1; scratch, of
    /// vesica_nms_scratch bytes or more, with any alignment and content; keep, with room for all indices.
    ///
    /// Returns: 0, with \*kept set to how many are kept. keep has their indices in the order of their scores; the rest
    /// of keep is not written.
    ///
    /// Errors: VESICA_E_SHAPE if a shape is invalid or its score is NaN: it is left out, and the result of the others
    /// is written. Before anything is written: VESICA_E_NULL (with count 0 all but shapes and kept may be NULL),
    /// VESICA_E_KIND (points, segments and polylines too), VESICA_E_ARGUMENT (the array as vesica_overlap_many_f64,
    /// threshold, too little scratch).
    ///
    /// Accuracy: the ratio that is compared is as of vesica_iou_f64; in float, the ratio rounded to float.
    ///
    /// Cost: as vesica_iou_many_f64 for each pair of a shape and one that is kept near it.
    ///
    /// Since: 0.1.
    pub fn vesica_nms_f64(shapes: *const Shapes<f64>, scores: *const f64, threshold: f64, scratch: *mut c_void,
        scratch_size: i64, keep: *mut i64, kept: *mut i64) -> i32;
    /// Version of the loaded library. If it is below VESICA_VERSION, the library is older than the header.
    ///
    /// Since: 0.1.
    pub fn vesica_version() -> i32;
    /// VESICA_VERSION_MAJOR of the loaded library.
    ///
    /// Since: 0.1.
    pub fn vesica_version_major() -> i32;
    /// VESICA_VERSION_MINOR of the loaded library.
    ///
    /// Since: 0.1.
    pub fn vesica_version_minor() -> i32;
    /// VESICA_VERSION_PATCH of the loaded library.
    ///
    /// Since: 0.1.
    pub fn vesica_version_patch() -> i32;
    /// How many numbers does a shape of this kind have?
    ///
    /// Returns: 2, 4, 3, 4, 6, 6, 5, 7 for VESICA_POINT ... VESICA_ROUND_RECT.
    ///
    /// Errors: VESICA_E_KIND, also for polygons and polylines, which have any number of vertices.
    ///
    /// Since: 0.1.
    pub fn vesica_field_count(kind: i32) -> i32;
    /// Name of a kind.
    ///
    /// Returns: static text: "point", "segment", "circle", "aabb", "rect", "ellipse", "capsule" or "round_rect"; NULL
    /// for an unknown kind.
    ///
    /// Since: 0.1.
    pub fn vesica_kind_name(kind: i32) -> *const u8;
    /// Name of the instruction set that batches use: the best one of this processor. Answers never depend on it.
    ///
    /// The environment variable VESICA_ISA selects another one. It is read once, when the library is loaded. Unknown
    /// names are ignored, and so are sets that this processor or this build does not have.
    ///
    /// Returns: static text: "sse2", "avx2", "avx512", "neon", "simd128" or "portable".
    ///
    /// Since: 0.1.
    pub fn vesica_isa_name() -> *const u8;
    /// Is a shape valid, and if not, which rule does it break?
    ///
    /// A polygon is simple if its edges neither cross nor overlap along a stretch; they may touch. A ring of two places
    /// is allowed. Functions that need this say so; they do not check it, and vesica_overlap_f32 and others take any
    /// polygon.
    ///
    /// Returns: 0 for a valid shape, else the first rule broken: VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE,
    /// VESICA_E_ZERO_AXIS, VESICA_E_INVERTED, VESICA_E_RINGS or VESICA_E_NOT_SIMPLE.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND.
    ///
    /// Since: 0.1.
    pub fn vesica_check_f32(kind: i32, shape: *const c_void) -> i32;
    /// Do two shapes share a point? Touching counts.
    ///
    /// Returns: 1 if they do, 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: as the function named after the two kinds, and a dispatch.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    /// Do the insides of two shapes share a point? Touching does not count.
    ///
    /// The inside is the shape without its outline, as vesica_relation_f32 says. So two rectangles side by side get 0,
    /// and so does a point on the rim of a disc or a segment along an edge. Two segments that cross get 1, and two
    /// equal points. If both shapes have an area, the answer is 1 where vesica_relation_f32 is VESICA_CROSS or more.
    ///
    /// Returns: 1 if they do, 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: as vesica_overlap_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_interiors_overlap_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    /// How does a relate to b? The answer is one of the eight relations of the region connection calculus (RCC-8).
    ///
    /// The outline of a shape with area is the curve around it. The outline of a segment, or of a shape with one size
    /// zero, is its two end points. A point, or a shape without any size, has no outline. The inside is the shape
    /// without its outline. If several relations fit, VESICA_EQUAL comes first, then those of containment, then
    /// VESICA_CROSS. So a segment that ends on the middle of another touches it; two segments on one line that overlap
    /// in part cross; a point on the rim of a disc is VESICA_INSIDE_TOUCH. Exchanging the shapes always gives the
    /// converse relation.
    ///
    /// The outline of a polygon is its edges, but a polygon whose vertices are on one line is a segment. The outline of
    /// a polyline is the points where an odd number of its chains end.
    ///
    /// Requires: simple polygons, as vesica_check_f32 says. Others get one of the eight relations, without a meaning.
    /// The same holds for vesica_contains_f32 and vesica_interiors_overlap_f32.
    ///
    /// Returns: VESICA_DISJOINT ... VESICA_EQUAL. Equal sets are VESICA_EQUAL, whatever kinds and numbers describe
    /// them.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: up to twice vesica_overlap_f32; more if shapes touch or are equal.
    ///
    /// Since: 0.1.
    pub fn vesica_relation_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    /// Does a contain all of b? A shape contains itself, and whatever touches its outline from inside.
    ///
    /// Returns: 1 if vesica_relation_f32 is VESICA_CONTAINS, VESICA_CONTAINS_TOUCH or VESICA_EQUAL, else 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: as vesica_relation_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_contains_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    /// Where do the outlines of two shapes meet? Touching counts.
    ///
    /// The outline of a shape with area is the curve around it. A segment, a point and a shape without area are their
    /// own outlines. A contact is one place, however closely the curves touch there. If straight parts of outlines
    /// share a stretch, or arcs about one corner do, its two end points are places, and \*shared is 1. So equal boxes
    /// meet at their four corners, and equal capsules where their sides begin and end. Equal circles and ellipses meet
    /// everywhere: then the count is 0 and \*shared is 1. Places come in order along a's outline, counter-clockwise in
    /// the frame of its axis. The start is a box's corner C - hx u - hy perp(u), an ellipse's point C + a u (one
    /// without area begins as a box), a circle's point C + (r, 0), or a segment's first end. With a radius the start is
    /// where the side from that corner or end begins: for a capsule, its right side, seen from the first end. With a
    /// polygon or a polyline, places come in order along that, or along a if both are: from the first vertex of the
    /// first ring on. A vertex on an edge is a place. Within a stretch that is shared, vertices where both outlines go
    /// straight on are none. A polygon whose vertices are on one line is a segment that begins at its least x, then
    /// least y. Where edges of a polygon or a polyline cross one another on the other outline, a place may count for
    /// each of them.
    ///
    /// Requires: capacity, how many places out has room for. It may be 0, and out then NULL. shared may be NULL.
    ///
    /// Returns: how many places there are, even if that exceeds the capacity: at most 8, or 12 of an ellipse with a
    /// rounded rectangle, unless a shape is a polygon or a polyline. The first `capacity` are written, and \*shared is
    /// set to 1 or 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a negative capacity), VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the number is exact. A place is right to 4 u times the largest coordinate or size of either shape,
    /// even where the outlines nearly coincide. Places closer to one another than that may come in either order or be
    /// equal. Each number is computed in double, within these bounds, and then rounded to float once. In bounds on
    /// errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy|
    /// between their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the
    /// scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: several times vesica_nearest_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_crossings_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Point<f32>,
        capacity: i64, shared: *mut i32) -> i64;
    /// How far apart are two solid shapes, and which of their points are closest?
    ///
    /// If the shapes overlap (as vesica_overlap_f32 says), the distance is 0 and both points are one common point. If
    /// not, the distance is \> 0. Exchanging the shapes exchanges the points and changes no bit. Moving both shapes
    /// alike changes no bit of the distance if no coordinate is rounded. The distance of a polygon or a polyline is the
    /// least over its edges, each asked as a segment.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the distance is right to 4 u scale at any aspect ratio; the largest error seen was 1 u scale, and 3.3
    /// u beside the ends of the thinnest ellipses. Its relative error is at most 2 u above 1e-10 scale (aspect ratios
    /// up to 1e6) or 1e-14 scale (up to 1000). Closest points are right to 4 u scale, and a common point to 8 u scale,
    /// before they are rounded. Points of capsules and rounded rectangles are rounded twice. For polygons and polylines
    /// the scale is the largest over pairs of an edge and the other shape or its edge. Each number is computed in
    /// double, within these bounds, and then rounded to float once. In bounds on errors u is 2^-53, half a unit in the
    /// last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
    /// lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over
    /// shorter size.
    ///
    /// Cost: ten to thirty times vesica_overlap_f32; more for shapes that cross and near-ties.
    ///
    /// Since: 0.1.
    pub fn vesica_nearest_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut ClosestPoints<f32>) -> i32;
    /// How far apart are the outlines of two shapes, and where do they come closest?
    ///
    /// The outline of a shape with area is the curve around it. A point, a segment and a shape with a zero size are
    /// their own outlines. The outline of a polygon or a polyline is its edges. If outlines meet, the distance is 0 and
    /// (ax, ay) = (bx, by) is a point of both. If shapes are disjoint, the result is as of vesica_nearest_f32. If one
    /// is strictly inside the other, the distance is the least over the whole outline, never a local minimum. Which
    /// case holds is decided exactly. Exchanging the shapes exchanges the points and changes no bit. Moving both shapes
    /// alike changes no bit of the distance if no coordinate is rounded.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: at aspect ratios up to 1e6 the distance is right to 4 u scale, and the points are that far apart to 16
    /// u scale. At any ratio it is above 0 unless outlines meet, and points are on them to 12 u scale before they are
    /// rounded. Each number is computed in double, within these bounds, and then rounded to float once. In bounds on
    /// errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy|
    /// between their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the
    /// scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: as vesica_nearest_f32 for disjoint shapes; up to three times as much if outlines meet or are nested, with
    /// a capsule or a rounded rectangle up to twenty times.
    ///
    /// Since: 0.1.
    pub fn vesica_boundary_distance_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut ClosestPoints<f32>) -> i32;
    /// Penetration depth: how far and which way must b be moved until the two shapes only touch?
    ///
    /// Moving b by out-\>depth along the unit vector (x, y) is the shortest translation after which a line separates
    /// the shapes: a on one side, b on the other, where both may touch the line. For disjoint shapes all three numbers
    /// are 0. Overlapping shapes always get a direction. Their depth is 0 if such a line exists without a move: if they
    /// touch from outside, if a point lies on an outline, or if points and segments lie along one line. Otherwise the
    /// depth is \> 0. Exchanging the shapes reverses the direction and changes no other bit, except for two equal
    /// shapes in one place. Moving both shapes alike changes no bit if no coordinate is rounded. Polygons must be
    /// convex: one ring that turns one way only and winds once, collinear vertices allowed. A polygon or polyline whose
    /// vertices are on one line is a segment or a point.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_NOT_CONVEX, VESICA_E_RANGE.
    ///
    /// Accuracy: at aspect ratios up to 1e6 the depth is right to 4 u scale; for circles and points, to its last place.
    /// The length of (x, y) is 1 to 3 u. After the move at most 8 u scale of overlap is left. Whether the depth is 0 is
    /// exact at any ratio; beyond 1e6 no bound on its error is stated. Each number is computed in double, within these
    /// bounds, and then rounded to float once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The
    /// scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4
    /// u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: about as vesica_nearest_f32; three times as much with an ellipse.
    ///
    /// Since: 0.1.
    pub fn vesica_depth_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut Penetration<f32>) -> i32;
    /// Area of one shape: 4 hx hy u.u for a rectangle, pi a b u.u for an ellipse, 0 for a point or a segment. A radius
    /// r adds r times the core's perimeter, and pi r r; the perimeter of a segment is twice its length.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the double nearest to the true area; a tiny area becomes subnormal or 0. So a shape inside another
    /// never has the greater area, and equal shapes have equal areas, whatever kinds and numbers describe them.
    /// Capsules and rounded rectangles that have both a size and a radius are excepted: their area is computed with a
    /// relative error of 2^-96 and rounded once, so it may rarely be the double beside the nearest. A polygon's edges
    /// must not cross; its area is right to 8 u times the height of its box times the sum of its edges' widths, and 0
    /// only if each ring is flat. Each number is computed in double, within these bounds, and then rounded to float
    /// once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest
    /// of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of at most
    /// 4 u times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Since: 0.1.
    pub fn vesica_shape_area_f32(kind: i32, shape: *const c_void, out: *mut f32) -> i32;
    /// States facts of a polygon: its vertices, area and direction, whether it is convex, and where its edges cross.
    ///
    /// The first ring is the first one that is neither a point nor a segment. If y points up, a shell whose inside is
    /// on the left of its edges is counter-clockwise. Where several pairs of edges cross, any one of them is named.
    /// Then area and orientation mean nothing.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (the area).
    ///
    /// Accuracy: exact, but the area, which is as vesica_shape_area_f32 says.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Cost: as vesica_check_f32, and a few ns for each vertex.
    ///
    /// Since: 0.1.
    pub fn vesica_polygon_facts_f32(polygon: *const Polygon<f32>, out: *mut Facts<f32>) -> i32;
    /// Area of the intersection of two shapes.
    ///
    /// It is exactly 0 if shapes are disjoint, if they only touch, or if one has no area. If one contains the other, it
    /// is the vesica_shape_area_f32 of the inner one. It is never more than the area of either, and more than 0 if the
    /// insides of shapes with area meet, unless that underflows. Exchanging the shapes changes no bit. Scaling both by
    /// a power of two scales the area by its square.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: right to 64 u times the smaller shape's area times the larger aspect ratio, at aspect ratios up to
    /// 10^4, even if the outlines nearly touch or coincide and whatever the sizes are. Beyond 10^4 no bound is stated;
    /// what is said above holds at any ratio. With a capsule or a rounded rectangle the bound holds if neither shape is
    /// more than 10^12 times as long as the other.
    /// Polygons: their edges must not cross. Rings have any order and direction. An area within its error bound of 0 is
    /// 0, and one within it of the smaller shape's area is that area; if both hold, the exact relation decides. So it
    /// is exactly 0 if shapes only touch, and exactly the inner one's area if one contains the other; but insides that
    /// share less than the bound share 0, too. Of two polygons the bound is 192 u g w: g is the greatest height above
    /// or below the middle of the box that their boxes share, and w the sum of the widths that pairs of their edges
    /// share, for convex polygons 4 times the width of that box. With another shape it is 192 u t l: t is that shape's
    /// half width and half height and the polygon's greatest distance from its centre, and l the length of the outline
    /// in it and the same half lengths; in units of its half lengths if it is an ellipse. A polyline has no area. Each
    /// number is computed in double, within these bounds, and then rounded to float once. In bounds on errors u is
    /// 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their
    /// centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect
    /// ratio is longer over shorter size.
    ///
    /// Cost: six times vesica_overlap_f32 for boxes, fifty times for two ellipses; more if outlines nearly touch or
    /// coincide, or if one shape is far larger.
    ///
    /// Since: 0.1.
    pub fn vesica_area_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f32) -> i32;
    /// Intersection over union (Jaccard index) of two shapes: the area they share over the area they cover together.
    ///
    /// It is exactly 1 for equal shapes and exactly 0 for shapes that share no area. Intermediate results never
    /// overflow or underflow. Exchanging the shapes, or scaling both by a power of two, changes no bit.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (neither shape has an area).
    ///
    /// Accuracy: the bound of vesica_area_f32, divided by the area of the union; for polygons up to three times as
    /// much. Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Cost: vesica_area_f32 and twice vesica_shape_area_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_iou_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f32) -> i32;
    /// Smallest box of representable numbers that contains a shape.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: each side is the true extreme of the shape, rounded outward once. So a representable box is exact.
    ///
    /// Cost: up to ten times vesica_overlap_f32; more for magnitudes above 2^400 or below 2^-400.
    ///
    /// Since: 0.1.
    pub fn vesica_bounds_f32(kind: i32, shape: *const c_void, out: *mut Aabb<f32>) -> i32;
    /// Are the two points the same?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_point_f32(a: *const Point<f32>, b: *const Point<f32>) -> i32;
    /// Does the point lie on the segment? End points count.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_segment_f32(a: *const Point<f32>, b: *const Segment<f32>) -> i32;
    /// Does the point lie in the disc or on its rim?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_circle_f32(a: *const Point<f32>, b: *const Circle<f32>) -> i32;
    /// Does the point lie in the box or on its outline?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_aabb_f32(a: *const Point<f32>, b: *const Aabb<f32>) -> i32;
    /// Does the point lie in the rectangle or on its outline?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_rect_f32(a: *const Point<f32>, b: *const Rect<f32>) -> i32;
    /// Does the point lie in the ellipse or on its outline?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_point_ellipse_f32(a: *const Point<f32>, b: *const Ellipse<f32>) -> i32;
    /// Do the segments share a point? End points count, and so do stretches along one line.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_segment_segment_f32(a: *const Segment<f32>, b: *const Segment<f32>) -> i32;
    /// Does the segment meet the disc? A tangent segment does.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_segment_circle_f32(a: *const Segment<f32>, b: *const Circle<f32>) -> i32;
    /// Does the segment meet the box? A segment inside it does.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_segment_aabb_f32(a: *const Segment<f32>, b: *const Aabb<f32>) -> i32;
    /// Does the segment meet the rectangle? A segment inside it does.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_segment_rect_f32(a: *const Segment<f32>, b: *const Rect<f32>) -> i32;
    /// Does the segment meet the ellipse? A tangent segment does.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_segment_ellipse_f32(a: *const Segment<f32>, b: *const Ellipse<f32>) -> i32;
    /// Do the discs share a point? Discs that touch from outside do.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_circle_circle_f32(a: *const Circle<f32>, b: *const Circle<f32>) -> i32;
    /// Do the disc and the box share a point?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_circle_aabb_f32(a: *const Circle<f32>, b: *const Aabb<f32>) -> i32;
    /// Do the disc and the rectangle share a point?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_circle_rect_f32(a: *const Circle<f32>, b: *const Rect<f32>) -> i32;
    /// Do the disc and the ellipse share a point?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_circle_ellipse_f32(a: *const Circle<f32>, b: *const Ellipse<f32>) -> i32;
    /// Do the boxes share a point? Boxes that share an edge or a corner do.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_aabb_aabb_f32(a: *const Aabb<f32>, b: *const Aabb<f32>) -> i32;
    /// Do the box and the rectangle share a point?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_aabb_rect_f32(a: *const Aabb<f32>, b: *const Rect<f32>) -> i32;
    /// Do the box and the ellipse share a point?
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_aabb_ellipse_f32(a: *const Aabb<f32>, b: *const Ellipse<f32>) -> i32;
    /// Do the rectangles share a point? Rectangles that share an edge or a corner do.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_rect_rect_f32(a: *const Rect<f32>, b: *const Rect<f32>) -> i32;
    /// Do the rectangle and the ellipse share a point? They do if one is inside the other.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_rect_ellipse_f32(a: *const Rect<f32>, b: *const Ellipse<f32>) -> i32;
    /// Do the ellipses share a point? They do if one is inside the other.
    ///
    /// Returns: 1 if the shapes share a point (touching counts), 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a few ns to 20 ns. Rare near-ties that only exact arithmetic can decide take up to a few hundred times
    /// that.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_ellipse_ellipse_f32(a: *const Ellipse<f32>, b: *const Ellipse<f32>) -> i32;
    /// Box with two opposite corners, in any order.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE.
    ///
    /// Accuracy: exact.
    ///
    /// Since: 0.1.
    pub fn vesica_aabb_from_corners_f32(x0: f32, y0: f32, x1: f32, y1: f32, out: *mut Aabb<f32>) -> i32;
    /// Rectangle from centre, angle and full size: width along the angle, height across it.
    ///
    /// Requires: the angle in radians, counter-clockwise from +x if y points up; width, height \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
    ///
    /// Accuracy: the axis is (cos, sin), each right to 1.1 units in the last place, and of equal components at the
    /// doubles nearest to +-pi/4 and +-3pi/4. No double is exactly pi/2, so a quarter turn has an exact axis only by
    /// vesica_rects_from_boxes_f32, which takes degrees too. Sizes are exact: if halving one would round (an odd
    /// multiple of the smallest subnormal number), the axis is halved instead.
    ///
    /// Since: 0.1.
    pub fn vesica_rect_from_angle_f32(cx: f32, cy: f32, angle: f32, width: f32, height: f32,
        out: *mut Rect<f32>) -> i32;
    /// Rectangle from its four corners x0 y0 ... x3 y3, in order round the outline in either sense.
    ///
    /// Corners that are not exactly a rectangle's give a rectangle near them, which need not contain them. The centre
    /// is the mean of the corners. The axis is a unit vector along the edge from corner 0 to corner 1, and hx belongs
    /// to that edge. Opposite edges are averaged; the longer pair gives the direction, and the shorter pair counts by
    /// its part across it. Two or four equal corners are legal: they give a segment, or a point with axis (1, 0).
    /// vesica_rect_corners_misfit_f32 says how far the corners are off.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (opposite edges are more than 90 degrees apart, as
    /// with corners in another order), VESICA_E_RANGE (a half extent overflows). Edges that are no longer along x and y
    /// than 8 epsilon times the largest coordinate may be rounding, and are not an error. Epsilon is 2^-52, or 2^-23 in
    /// float.
    ///
    /// Accuracy: half extents, and the axis times the longer one, are right to 8 units in the last place of the longer
    /// one; the centre is right to 1 unit in its own. Both errors may grow by 2^-98 times the largest coordinate. A
    /// rectangle along the coordinate axes is found exactly if its centre and half extents are representable.
    ///
    /// Since: 0.1.
    pub fn vesica_rect_from_corners_f32(corners: *const f32, out: *mut Rect<f32>) -> i32;
    /// The largest distance from a given corner to the rectangle's corner that corresponds to it.
    ///
    /// The four corners may start at any corner of the rectangle and run in either sense: the least result of the eight
    /// ways counts. So 0 means that they are exactly the rectangle's corners, in order round the outline. The rectangle
    /// may come from vesica_rect_from_corners_f32, or be any other.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, errors of the rectangle as vesica_check_f32, VESICA_E_RANGE (the
    /// result overflows).
    ///
    /// Accuracy: 3 units in the last place, plus 2^-96 times the largest coordinate of corners, centre and half axes.
    ///
    /// Since: 0.1.
    pub fn vesica_rect_corners_misfit_f32(corners: *const f32, r: *const Rect<f32>, misfit: *mut f32) -> i32;
    /// Rounded rectangle from centre, angle and full size, its round corners included: width along the angle, height
    /// across.
    ///
    /// Requires: the angle in radians, counter-clockwise from +x if y points up; width, height, radius \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE, VESICA_E_ARGUMENT (the radius is more than
    /// half the width or height).
    ///
    /// Accuracy: the axis as vesica_rect_from_angle_f32; the radius is exact. The sizes of the rectangle inside, width
    /// - 2 radius and height - 2 radius, are each rounded once. With radius 0 it is that function's rectangle.
    ///
    /// Since: 0.1.
    pub fn vesica_round_rect_from_angle_f32(cx: f32, cy: f32, angle: f32, width: f32, height: f32, radius: f32,
        out: *mut RoundRect<f32>) -> i32;
    /// Capsule from centre, angle, the length between the ends of its segment, and radius.
    ///
    /// The angle points from (x0, y0) to (x1, y1). The whole capsule is length + 2 radius long.
    ///
    /// Requires: the angle in radians, counter-clockwise from +x if y points up; length, radius \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE, VESICA_E_RANGE (an end overflows).
    ///
    /// Accuracy: the ends are those of the segment that vesica_rect_from_angle_f32 makes of this length and height 0,
    /// each coordinate right to 0.51 units in its last place. With centre (0, 0) they are opposite. The radius is
    /// exact.
    ///
    /// Since: 0.1.
    pub fn vesica_capsule_from_angle_f32(cx: f32, cy: f32, angle: f32, length: f32, radius: f32,
        out: *mut Capsule<f32>) -> i32;
    /// Capsule from the ends of its segment and its full width, twice the radius: a line of that width with round ends.
    ///
    /// Requires: width \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
    ///
    /// Accuracy: exact. Only half an odd multiple of the smallest subnormal number is rounded, to an even multiple.
    ///
    /// Since: 0.1.
    pub fn vesica_capsule_from_width_f32(x0: f32, y0: f32, x1: f32, y1: f32, width: f32, out: *mut Capsule<f32>) -> i32;
    /// Ellipse from centre, angle and half lengths: a along the angle, b across it.
    ///
    /// Requires: the angle in radians, counter-clockwise from +x if y points up; a, b \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
    ///
    /// Accuracy: the axis as vesica_rect_from_angle_f32; half lengths are exact.
    ///
    /// Since: 0.1.
    pub fn vesica_ellipse_from_angle_f32(cx: f32, cy: f32, angle: f32, a: f32, b: f32, out: *mut Ellipse<f32>) -> i32;
    /// Ellipse from centre, radius vector and ratio: one half axis is (wx, wy), the other is ratio times perp(wx, wy).
    ///
    /// A zero vector gives the point (cx, cy).
    ///
    /// Requires: ratio \>= 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE.
    ///
    /// Accuracy: exact.
    ///
    /// Since: 0.1.
    pub fn vesica_ellipse_from_radius_vector_f32(cx: f32, cy: f32, wx: f32, wy: f32, ratio: f32,
        out: *mut Ellipse<f32>) -> i32;
    /// Ellipse of the points within k standard deviations of a mean (Mahalanobis distance at most k).
    ///
    /// A singular covariance, or k = 0, gives a segment or a point. The result has a \>= b. Its axis is a unit vector
    /// with x \>= 0, or (1, 0) for equal variances without correlation.
    ///
    /// Requires: the covariance cxx, cxy, cyy (units squared) positive semidefinite: cxy^2 \<= cxx cyy as stored; k \>=
    /// 0.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_NEGATIVE_SIZE (k \< 0), VESICA_E_ARGUMENT (not a
    /// covariance), VESICA_E_RANGE (a half length overflows).
    ///
    /// Accuracy: half lengths and both components of the axis are right to 8 units in their own last place, even if the
    /// matrix is nearly singular or nearly a circle's. Exchanging cxx and cyy exchanges the components, up to signs.
    ///
    /// Since: 0.1.
    pub fn vesica_ellipse_from_covariance_f32(mean_x: f32, mean_y: f32, cxx: f32, cxy: f32, cyy: f32, k: f32,
        out: *mut Ellipse<f32>) -> i32;
    /// Ellipse of the points X with (X - C) . M (X - C) \<= 1, where M is symmetric with entries mxx, mxy, myy.
    ///
    /// The result is as of vesica_ellipse_from_covariance_f32 for the inverse of M and k = 1.
    ///
    /// Requires: M positive definite as stored.
    ///
    /// Returns: 0; the shape is valid.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_NOT_FINITE, VESICA_E_ARGUMENT (not positive definite).
    ///
    /// Accuracy: as vesica_ellipse_from_covariance_f32. No half length overflows.
    ///
    /// Since: 0.1.
    pub fn vesica_ellipse_from_matrix_f32(cx: f32, cy: f32, mxx: f32, mxy: f32, myy: f32,
        out: *mut Ellipse<f32>) -> i32;
    /// Describes an array of `count` records. Each starts with a shape's struct.
    ///
    /// Requires: base, the first record's shape, which may be NULL if count is 0; stride, the bytes from one record to
    /// the next; count \>= 0.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (negative count).
    ///
    /// Since: 0.1.
    pub fn vesica_shapes_from_records_f32(kind: i32, count: i64, base: *const c_void, stride: isize,
        out: *mut Shapes<f32>) -> i32;
    /// Do a\[i\] and b\[i\] share a point? out\[i\] is the answer of vesica_overlap_f32.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a fifth to a tenth of vesica_overlap_f32 a pair; about half of that if one array is a single shape.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8) -> i64;
    /// Do the insides of a\[i\] and b\[i\] share a point? out\[i\] is the answer of vesica_interiors_overlap_f32.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: as vesica_overlap_many_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_interiors_overlap_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8) -> i64;
    /// How does a\[i\] relate to b\[i\]? out\[i\] is the answer of vesica_relation_f32.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many are not VESICA_DISJOINT.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_relation_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8) -> i64;
    /// Does a\[i\] contain all of b\[i\]? out\[i\] is the answer of vesica_contains_f32.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_contains_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8) -> i64;
    /// How far apart are a\[i\] and b\[i\], and where? The columns are the fields of vesica_nearest_f32's result.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many pairs overlap (distance 0).
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_nearest_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, distance: *mut f32, ax: *mut f32,
        ay: *mut f32, bx: *mut f32, by: *mut f32) -> i64;
    /// How far apart are the outlines of a\[i\] and b\[i\]? The columns are the fields of
    /// vesica_boundary_distance_f32's result.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many pairs of outlines meet (distance 0).
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_boundary_distance_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, distance: *mut f32,
        ax: *mut f32, ay: *mut f32, bx: *mut f32, by: *mut f32) -> i64;
    /// How deep do a\[i\] and b\[i\] overlap? The columns are the fields of vesica_depth_f32's result.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many depths are \> 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_depth_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, depth: *mut f32, x: *mut f32,
        y: *mut f32) -> i64;
    /// The area that a\[i\] and b\[i\] share: out\[i\] is the result of vesica_area_f32.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many areas are \> 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_area_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32) -> i64;
    /// Intersection over union of a\[i\] and b\[i\]: out\[i\] is the result of vesica_iou_f32.
    ///
    /// If neither of a pair has an area, out\[i\] is NaN, and the call returns VESICA_E_ARGUMENT unless a shape is
    /// invalid.
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. Each output has room for as many numbers
    /// as the larger count, or for none if a count is 0. Of several output columns some, but not all, may be NULL.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and outputs may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT
    /// (counts that are negative or do not agree, an unused member that is not 0 or NULL, an array that exceeds the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: a pair takes from a fifth of the time of the function for two shapes to about as much
    /// (docs/benchmarks.md).
    ///
    /// Since: 0.1.
    pub fn vesica_iou_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32) -> i64;
    /// Do a\[i\] and b\[j\] share a point? The elements of out are answers of vesica_overlap_f32. Arrays in spatial
    /// order are much faster.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_matrix_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8,
        row_stride: isize) -> i64;
    /// Do the insides of a\[i\] and b\[j\] share a point? The elements of out are answers of
    /// vesica_interiors_overlap_f32.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_interiors_overlap_matrix_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8,
        row_stride: isize) -> i64;
    /// How does a\[i\] relate to b\[j\]? The elements of out are answers of vesica_relation_f32.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are not VESICA_DISJOINT.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_relation_matrix_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8,
        row_stride: isize) -> i64;
    /// Does a\[i\] contain all of b\[j\]? The elements of out are answers of vesica_contains_f32.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are 1.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_contains_matrix_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8,
        row_stride: isize) -> i64;
    /// The area that a\[i\] and b\[j\] share. The elements of out are results of vesica_area_f32.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_area_matrix_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32,
        row_stride: isize) -> i64;
    /// Intersection over union of a\[i\] and b\[j\]. The elements of out are results of vesica_iou_f32.
    ///
    /// If neither of a pair has an area, it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
    ///
    /// Requires: room for a matrix: out\[i \* row_stride + j\] is the result for a\[i\] and b\[j\]. row_stride counts
    /// elements of out. With two or more rows its magnitude is at least b's count; if it is negative, rows run
    /// backwards in memory.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, else VESICA_E_RANGE if a number of an element's results would
    /// overflow: its results are 0 (bytes) or NaN (numbers), and all others are written as usual. Before anything is
    /// written: VESICA_E_NULL (but if a count is 0, fields and out may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a
    /// negative count, an unused member that is not 0 or NULL, rows that overlap, or an array or rows that exceed the
    /// address space).
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Cost: for each pair at most as in a batch of one shape against many, whatever the size of the arrays.
    ///
    /// Since: 0.1.
    pub fn vesica_iou_matrix_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32, row_stride: isize) -> i64;
    /// Which of many shapes overlap one? Their indices are written to out\[0\], out\[1\] ..., in ascending order.
    ///
    /// Requires: one, an array of count 1, which is looked at unless many is empty; capacity, how many indices out has
    /// room for. It may be 0, and out then NULL.
    ///
    /// Returns: how many there are, even if that exceeds the capacity. If room is left, the entry after the last is -1.
    ///
    /// Errors: VESICA_E_SHAPE if a shape is invalid: it is not selected, and the others are written as usual, up to the
    /// -1 or the capacity. Before anything is written: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (one's count is
    /// not 1, a negative capacity, and as vesica_overlap_many_f32).
    ///
    /// Accuracy: every answer is as of vesica_overlap_f32.
    ///
    /// Cost: as vesica_overlap_many_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_overlap_select_f32(one: *const Shapes<f32>, many: *const Shapes<f32>, out: *mut i64,
        capacity: i64) -> i64;
    /// Which of many shapes share a point of their insides with that of one? As vesica_overlap_select_f32, with the
    /// answers of vesica_interiors_overlap_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_interiors_overlap_select_f32(one: *const Shapes<f32>, many: *const Shapes<f32>, out: *mut i64,
        capacity: i64) -> i64;
    /// Greedy non-maximum suppression: takes shapes in the order of their scores, highest first, and keeps each one
    /// whose vesica_iou_f32 with every shape kept before is at most the threshold.
    ///
    /// The lower index of equal scores comes first. Infinite scores are legal. At threshold 1 all shapes are kept.
    /// Shapes without an area suppress none and are not suppressed.
    ///
    /// Requires: shapes, of a kind with an area; scores, one for each; threshold from 0 to 1; scratch, of
    /// vesica_nms_scratch bytes or more, with any alignment and content; keep, with room for all indices.
    ///
    /// Returns: 0, with \*kept set to how many are kept. keep has their indices in the order of their scores; the rest
    /// of keep is not written.
    ///
    /// Errors: VESICA_E_SHAPE if a shape is invalid or its score is NaN: it is left out, and the result of the others
    /// is written. Before anything is written: VESICA_E_NULL (with count 0 all but shapes and kept may be NULL),
    /// VESICA_E_KIND (points, segments and polylines too), VESICA_E_ARGUMENT (the array as vesica_overlap_many_f32,
    /// threshold, too little scratch).
    ///
    /// Accuracy: the ratio that is compared is as of vesica_iou_f32; in float, the ratio rounded to float.
    ///
    /// Cost: as vesica_iou_many_f32 for each pair of a shape and one that is kept near it.
    ///
    /// Since: 0.1.
    pub fn vesica_nms_f32(shapes: *const Shapes<f32>, scores: *const f32, threshold: f32, scratch: *mut c_void,
        scratch_size: i64, keep: *mut i64, kept: *mut i64) -> i32;
    /// Rectangles from boxes.
    ///
    /// Requires: boxes, `count` rows of five numbers with any alignment, `stride` bytes apart; angle, a unit of angles,
    /// or its sum with VESICA_ANGLE_REVERSED; out, room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: the axis is (cos, sin), each right to 1.1 units in the last place. Degrees that are multiples of 90,
    /// and whole quarter turns, give exact axes. In both units an angle and its complement have the same components,
    /// exchanged: a rectangle and the same one turned by a quarter, its width and height exchanged, are VESICA_EQUAL.
    /// In radians, as in vesica_rect_from_angle_f64. Sizes are those of vesica_rect_from_angle_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_rects_from_boxes_f64(boxes: *const f64, count: i64, stride: isize, angle: i32,
        out: *mut Rect<f64>) -> i64;
    /// Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
    ///
    /// Requires: as vesica_rects_from_boxes_f64.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: as vesica_rects_from_boxes_f64. Half lengths are halves of width and height.
    ///
    /// Since: 0.1.
    pub fn vesica_ellipses_from_boxes_f64(boxes: *const f64, count: i64, stride: isize, angle: i32,
        out: *mut Ellipse<f64>) -> i64;
    /// Rectangles from four corners each: out\[i\] is the result of vesica_rect_from_corners_f64.
    ///
    /// Crossed corners, in another order than round the outline, make their element invalid.
    ///
    /// Requires: corners, `count` rows of eight numbers x0 y0 ... x3 y3 with any alignment, `stride` bytes apart; out,
    /// room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: as vesica_rect_from_corners_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_rects_from_corners_f64(corners: *const f64, count: i64, stride: isize, out: *mut Rect<f64>) -> i64;
    /// How far corners are from those of rectangles: misfit\[i\] is the result of vesica_rect_corners_misfit_f64.
    ///
    /// Requires: corners, a row for each rectangle, as vesica_rects_from_corners_f64; rects, of kind VESICA_RECT;
    /// misfit, room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: as vesica_rect_corners_misfit_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_rect_corners_misfit_many_f64(corners: *const f64, stride: isize, rects: *const Shapes<f64>,
        misfit: *mut f64) -> i64;
    /// Boxes from rectangles or from ellipses: the inverse of the first two functions.
    ///
    /// Angles are from -180 to 180 degrees, in the unit asked for.
    ///
    /// Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; angle as vesica_rects_from_boxes_f64; boxes, room for
    /// `count` rows of five numbers, without gaps.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: width and height are right to 4 units in the last place, and the angle to 2 units in the last place of
    /// a quarter turn. If an axis lies exactly along a coordinate axis, degrees and quarter turns are exact.
    ///
    /// Since: 0.1.
    pub fn vesica_boxes_from_shapes_f64(shapes: *const Shapes<f64>, angle: i32, boxes: *mut f64) -> i64;
    /// The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
    ///
    /// The first corner is C - hx u - hy perp(u), the next C + hx u - hy perp(u), and so on round the outline.
    ///
    /// Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; corners, room for `count` rows of eight numbers.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: a coordinate is right to 1 unit in its last place plus 2^-98 times the largest of its three terms.
    ///
    /// Since: 0.1.
    pub fn vesica_corners_of_shapes_f64(shapes: *const Shapes<f64>, corners: *mut f64) -> i64;
    /// Bounding boxes of an array of any kind: out\[i\] is the result of vesica_bounds_f64.
    ///
    /// Requires: out, room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: as vesica_bounds_f64.
    ///
    /// Cost: as vesica_bounds_f64; up to eight times less with AVX2 or AVX-512.
    ///
    /// Since: 0.1.
    pub fn vesica_bounds_many_f64(shapes: *const Shapes<f64>, out: *mut Aabb<f64>) -> i64;
    /// Areas of an array of any kind: out\[i\] is the result of vesica_shape_area_f64.
    ///
    /// Requires: out, room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: as vesica_shape_area_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_shape_area_many_f64(shapes: *const Shapes<f64>, out: *mut f64) -> i64;
    /// The convex hull of points: the smallest convex polygon that contains them.
    ///
    /// Points are the vertices of a polygon; their order and its rings do not matter. Corners of the hull run counter-
    /// clockwise where y points up, from the lowest of the leftmost points on. None of them is on the line between its
    /// neighbours. Equal points have one corner; points on one line have two.
    ///
    /// Requires: out, room for `capacity` points: as many as there are, because they are sorted there.
    ///
    /// Returns: the number of corners.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT (less room). Nothing is written.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: that of sorting the points.
    ///
    /// Since: 0.1.
    pub fn vesica_convex_hull_f64(points: *const Polygon<f64>, out: *mut Point<f64>, capacity: i64) -> i64;
    /// The rectangle of the least area that contains points.
    ///
    /// Points are as in vesica_convex_hull_f64. The rectangle has a side along an edge of their hull. Its axis is the
    /// direction of that edge, counter-clockwise round the hull where y points up, and hx is half the length along it.
    /// Of equal rectangles it is the first, from the lowest of the leftmost points on; areas are compared as they are
    /// computed. Points on one line give a rectangle without height. vesica_rect_corners_misfit_f64 says how far four
    /// corners are from it.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (a number would overflow), VESICA_E_NOT_CONVEX (the points
    /// are no convex ring, and the hull of all or of the first ones has more than 768 corners: find it by
    /// vesica_convex_hull_f64 first).
    ///
    /// Accuracy: no point is outside by more than 8 u times the sum of the points' extent and the largest coordinate,
    /// and each side is that near to a point. The same number of smallest subnormal numbers adds to that. In bounds on
    /// errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy|
    /// between their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the
    /// scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: that of vesica_convex_hull_f64, and for each corner of the hull about as much again as for a point.
    ///
    /// Since: 0.1.
    pub fn vesica_min_area_rect_f64(points: *const Polygon<f64>, out: *mut Rect<f64>) -> i32;
    /// The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f64.
    ///
    /// Returns: 0.
    ///
    /// Errors: as vesica_min_area_rect_f64.
    ///
    /// Accuracy: as vesica_min_area_rect_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_min_perimeter_rect_f64(points: *const Polygon<f64>, out: *mut Rect<f64>) -> i32;
    /// The rectangles of the least area about each polygon or polyline of an array.
    ///
    /// Requires: points, of kind VESICA_POLYGON or VESICA_POLYLINE; out, room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: as the arrays above. If the hull of an element has too many corners, that is VESICA_E_SHAPE.
    ///
    /// Accuracy: as vesica_min_area_rect_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_min_area_rect_many_f64(points: *const Shapes<f64>, out: *mut Rect<f64>) -> i64;
    /// The rectangles of the least perimeter about each polygon or polyline of an array.
    ///
    /// Requires: as vesica_min_area_rect_many_f64.
    ///
    /// Errors: as vesica_min_area_rect_many_f64.
    ///
    /// Accuracy: as vesica_min_area_rect_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_min_perimeter_rect_many_f64(points: *const Shapes<f64>, out: *mut Rect<f64>) -> i64;
    /// Rectangles from boxes.
    ///
    /// Requires: boxes, `count` rows of five numbers with any alignment, `stride` bytes apart; angle, a unit of angles,
    /// or its sum with VESICA_ANGLE_REVERSED; out, room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: the axis is (cos, sin), each right to 1.1 units in the last place. Degrees that are multiples of 90,
    /// and whole quarter turns, give exact axes. In both units an angle and its complement have the same components,
    /// exchanged: a rectangle and the same one turned by a quarter, its width and height exchanged, are VESICA_EQUAL.
    /// In radians, as in vesica_rect_from_angle_f32. Sizes are those of vesica_rect_from_angle_f32. Each number is
    /// computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_rects_from_boxes_f32(boxes: *const f32, count: i64, stride: isize, angle: i32,
        out: *mut Rect<f32>) -> i64;
    /// Ellipses from their bounding boxes: each touches the sides of its turned box in the middle.
    ///
    /// Requires: as vesica_rects_from_boxes_f32.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: as vesica_rects_from_boxes_f32. Half lengths are halves of width and height.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_ellipses_from_boxes_f32(boxes: *const f32, count: i64, stride: isize, angle: i32,
        out: *mut Ellipse<f32>) -> i64;
    /// Rectangles from four corners each: out\[i\] is the result of vesica_rect_from_corners_f32.
    ///
    /// Crossed corners, in another order than round the outline, make their element invalid.
    ///
    /// Requires: corners, `count` rows of eight numbers x0 y0 ... x3 y3 with any alignment, `stride` bytes apart; out,
    /// room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: as vesica_rect_from_corners_f32.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_rects_from_corners_f32(corners: *const f32, count: i64, stride: isize, out: *mut Rect<f32>) -> i64;
    /// How far corners are from those of rectangles: misfit\[i\] is the result of vesica_rect_corners_misfit_f32.
    ///
    /// Requires: corners, a row for each rectangle, as vesica_rects_from_corners_f32; rects, of kind VESICA_RECT;
    /// misfit, room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: as vesica_rect_corners_misfit_f32.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_rect_corners_misfit_many_f32(corners: *const f32, stride: isize, rects: *const Shapes<f32>,
        misfit: *mut f32) -> i64;
    /// Boxes from rectangles or from ellipses: the inverse of the first two functions.
    ///
    /// Angles are from -180 to 180 degrees, in the unit asked for.
    ///
    /// Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; angle as vesica_rects_from_boxes_f32; boxes, room for
    /// `count` rows of five numbers, without gaps.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: width and height are right to 4 units in the last place, and the angle to 2 units in the last place of
    /// a quarter turn. If an axis lies exactly along a coordinate axis, degrees and quarter turns are exact. Each
    /// number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_boxes_from_shapes_f32(shapes: *const Shapes<f32>, angle: i32, boxes: *mut f32) -> i64;
    /// The four corners of rectangles, or of the turned boxes that bound ellipses: x0 y0 ... x3 y3.
    ///
    /// The first corner is C - hx u - hy perp(u), the next C + hx u - hy perp(u), and so on round the outline.
    ///
    /// Requires: shapes, of kind VESICA_RECT or VESICA_ELLIPSE; corners, room for `count` rows of eight numbers.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: a coordinate is right to 1 unit in its last place plus 2^-98 times the largest of its three terms.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_corners_of_shapes_f32(shapes: *const Shapes<f32>, corners: *mut f32) -> i64;
    /// Bounding boxes of an array of any kind: out\[i\] is the result of vesica_bounds_f32.
    ///
    /// Requires: out, room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: as vesica_bounds_f32.
    ///
    /// Cost: as vesica_bounds_f32; up to eight times less with AVX2 or AVX-512.
    ///
    /// Since: 0.1.
    pub fn vesica_bounds_many_f32(shapes: *const Shapes<f32>, out: *mut Aabb<f32>) -> i64;
    /// Areas of an array of any kind: out\[i\] is the result of vesica_shape_area_f32.
    ///
    /// Requires: out, room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_SHAPE if an element is invalid, or VESICA_E_RANGE if a number of its result would overflow: all
    /// numbers of that result are NaN, and all other results are written as usual. Before anything is written:
    /// VESICA_E_NULL (if count is 0, arrays may be NULL), VESICA_E_KIND, VESICA_E_ARGUMENT (a negative count, an array
    /// that exceeds the address space, an unknown unit of angles).
    ///
    /// Accuracy: as vesica_shape_area_f32.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_shape_area_many_f32(shapes: *const Shapes<f32>, out: *mut f32) -> i64;
    /// The convex hull of points: the smallest convex polygon that contains them.
    ///
    /// Points are the vertices of a polygon; their order and its rings do not matter. Corners of the hull run counter-
    /// clockwise where y points up, from the lowest of the leftmost points on. None of them is on the line between its
    /// neighbours. Equal points have one corner; points on one line have two.
    ///
    /// Requires: out, room for `capacity` points: as many as there are, because they are sorted there.
    ///
    /// Returns: the number of corners.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_ARGUMENT (less room). Nothing is written.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: that of sorting the points.
    ///
    /// Since: 0.1.
    pub fn vesica_convex_hull_f32(points: *const Polygon<f32>, out: *mut Point<f32>, capacity: i64) -> i64;
    /// The rectangle of the least area that contains points.
    ///
    /// Points are as in vesica_convex_hull_f32. The rectangle has a side along an edge of their hull. Its axis is the
    /// direction of that edge, counter-clockwise round the hull where y points up, and hx is half the length along it.
    /// Of equal rectangles it is the first, from the lowest of the leftmost points on; areas are compared as they are
    /// computed. Points on one line give a rectangle without height. vesica_rect_corners_misfit_f32 says how far four
    /// corners are from it.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_SHAPE, VESICA_E_RANGE (a number would overflow), VESICA_E_NOT_CONVEX (the points
    /// are no convex ring, and the hull of all or of the first ones has more than 768 corners: find it by
    /// vesica_convex_hull_f32 first).
    ///
    /// Accuracy: no point is outside by more than 8 u times the sum of the points' extent and the largest coordinate,
    /// and each side is that near to a point. The same number of smallest subnormal numbers adds to that. Each number
    /// is computed in double, within these bounds, and then rounded to float once. In bounds on errors u is 2^-53, half
    /// a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and
    /// of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is
    /// longer over shorter size.
    ///
    /// Cost: that of vesica_convex_hull_f32, and for each corner of the hull about as much again as for a point.
    ///
    /// Since: 0.1.
    pub fn vesica_min_area_rect_f32(points: *const Polygon<f32>, out: *mut Rect<f32>) -> i32;
    /// The rectangle of the least perimeter that contains points, else as vesica_min_area_rect_f32.
    ///
    /// Returns: 0.
    ///
    /// Errors: as vesica_min_area_rect_f32.
    ///
    /// Accuracy: as vesica_min_area_rect_f32.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_min_perimeter_rect_f32(points: *const Polygon<f32>, out: *mut Rect<f32>) -> i32;
    /// The rectangles of the least area about each polygon or polyline of an array.
    ///
    /// Requires: points, of kind VESICA_POLYGON or VESICA_POLYLINE; out, room for `count`.
    ///
    /// Returns: 0.
    ///
    /// Errors: as the arrays above. If the hull of an element has too many corners, that is VESICA_E_SHAPE.
    ///
    /// Accuracy: as vesica_min_area_rect_f32.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_min_area_rect_many_f32(points: *const Shapes<f32>, out: *mut Rect<f32>) -> i64;
    /// The rectangles of the least perimeter about each polygon or polyline of an array.
    ///
    /// Requires: as vesica_min_area_rect_many_f32.
    ///
    /// Errors: as vesica_min_area_rect_many_f32.
    ///
    /// Accuracy: as vesica_min_area_rect_f32.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_min_perimeter_rect_many_f32(points: *const Shapes<f32>, out: *mut Rect<f32>) -> i64;
    /// All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
    /// like.
    ///
    /// Pair i is out_a\[i\] and out_b\[i\], and values\[i\] is the result of vesica_ratio_f64 for them, the item of
    /// index_a first. Threshold 0 finds every pair that overlaps and has a ratio; GIoU, DIoU and CIoU may be below 0,
    /// so there -infinity does. A pair without a ratio, as two shapes without area have no IoU, is left out. Order,
    /// parts, states, and pairs of an index with itself are as for vesica_join_f64.
    ///
    /// Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE; threshold, not NaN; values with room
    /// for `capacity` numbers. The rest is as for vesica_join_f64 with VESICA_JOIN_OVERLAP. With capacity 0, out_a,
    /// out_b, values and state may be NULL.
    ///
    /// Returns: the number of pairs written; with capacity 0, how many the whole part has.
    ///
    /// Errors: those of vesica_join_f64; VESICA_E_ARGUMENT also for ratio and threshold.
    ///
    /// Accuracy: as vesica_ratio_f64, bit for bit; in float, the ratio rounded to float is compared.
    ///
    /// Cost: vesica_join_f64, and vesica_ratio_f64 for each pair whose bounds meet; for boxes and rectangles and a
    /// threshold above 0 only for those whose bounds and areas allow such a ratio, unless it is over the first or the
    /// second.
    ///
    /// Since: 0.1.
    pub fn vesica_join_ratio_f64(ratio: i32, threshold: f64, index_a: *const c_void, sets_a: *const Shapes<f64>,
        set_count_a: i32, index_b: *const c_void, sets_b: *const Shapes<f64>, set_count_b: i32, part: i64, parts: i64,
        scratch: *mut c_void, scratch_size: i64, out_a: *mut i64, out_b: *mut i64, values: *mut f64, capacity: i64,
        state: *mut i64) -> i64;
    /// How many bytes of scratch does greedy assignment of `count` pairs need?
    ///
    /// Returns: 32 bytes a pair, and a bit for each of count_a and of count_b.
    ///
    /// Errors: VESICA_E_ARGUMENT (a number is negative or above 2^31 - 1).
    ///
    /// Since: 0.1.
    pub fn vesica_assign_greedy_scratch(count: i64, count_a: i64, count_b: i64) -> i64;
    /// Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
    /// free, until there is none.
    ///
    /// Pair k is item a\[k\] of one side and item b\[k\] of the other, with values\[k\], as vesica_join_ratio_f64
    /// writes them. Of equal values the pair with the lower item of a comes first, then the lower item of b, then the
    /// lower k. A pair whose value is NaN is not taken. chosen\[0\], chosen\[1\] ... are the numbers k of the pairs
    /// taken, the best first. The sum of values may be less than the largest possible one; that is the answer of a
    /// solver for sparse assignment.
    ///
    /// Requires: 0 \<= a\[k\] \< count_a and 0 \<= b\[k\] \< count_b. scratch of at least
    /// vesica_assign_greedy_scratch(count, count_a, count_b) bytes, aligned to 8. chosen, room for the least of count,
    /// count_a and count_b. With count 0 all pointers may be NULL.
    ///
    /// Returns: how many pairs are taken.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (a number, an item or a size is out of range, the scratch is not
    /// aligned). Nothing is written.
    ///
    /// Cost: a sort of the values.
    ///
    /// Since: 0.1.
    pub fn vesica_assign_greedy_f64(a: *const i64, b: *const i64, values: *const f64, count: i64, count_a: i64,
        count_b: i64, scratch: *mut c_void, scratch_size: i64, chosen: *mut i64) -> i64;
    /// How many bytes of scratch does the fusion of `count` boxes need?
    ///
    /// Returns: about 350 bytes a box, and 0.4 MiB.
    ///
    /// Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
    ///
    /// Since: 0.1.
    pub fn vesica_fuse_scratch(count: i64) -> i64;
    /// Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted mean.
    ///
    /// Takes boxes in the order of score times weight, the highest first, of equal ones by number. Each joins the
    /// cluster of its label whose mean it has the highest IoU with, of equal ones the first, if that IoU exceeds the
    /// threshold; otherwise it begins a cluster. A box counts in its cluster's mean by score times weight: with p = s
    /// w,
    ///
    ///     mean = sum(p x) / sum(p)
    ///
    /// for each coordinate x of a box along the axes, and for the centre and each half length of a rectangle. A
    /// rectangle is the same when it is turned by 180 degrees, or by 90 with its half lengths exchanged. Of these four
    /// forms each member has the one whose corners are nearest to those of the cluster's first member, by the sum of
    /// the squares of their distances, both about one centre. The direction of the mean is that of the sum of p times
    /// their unit directions, and is written as a unit vector. If all p of a cluster are 0, its mean is its first box;
    /// if all its weights are 0, its mean score is the first one. A cluster of one box is that box, bit for bit. Record
    /// c of fused, of the shapes' kind, and fused_scores\[c\] are those of cluster c; clusters\[i\] is that of box i.
    /// The paper then multiplies a score by min(n, m) / m, for n boxes in the cluster and m models: clusters gives n.
    ///
    /// Requires: shapes of kind VESICA_AABB or VESICA_RECT; scores from 0 to 2^480, one for each; weights in the same
    /// range, such as that of a box's model, or NULL for 1; labels, or NULL if all are the same; threshold from 0 to 1;
    /// fused_score VESICA_FUSED_MEAN or _MAX; scratch of at least vesica_fuse_scratch(count) bytes; fused with room for
    /// `count` records of vesica_aabb_f64 or vesica_rect_f64, fused_scores and clusters for as many numbers.
    ///
    /// Returns: 0, with \*count set to the number of clusters.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (the threshold, fused_score, or a size is out of range).
    /// VESICA_E_SHAPE: boxes are left out, and have cluster -1, that are invalid, whose coordinates
    /// or half lengths exceed 2^1020, or whose score or weight is out of range; the result of all others is written.
    ///
    /// Accuracy: IoU is that of vesica_iou_f64 and the mean before it is rounded to the output's type. With n boxes in
    /// the cluster, a coordinate x of the mean is right to 4 u (n d + |x|) + n 2^-1074, d the largest difference from
    /// that of the first box; a score to 4 u n times the highest; a direction to 4 u n, if all are within 45 degrees of
    /// the first. The float function computes in double and rounds its results. In bounds on errors u is 2^-53, half a
    /// unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and
    /// of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is
    /// longer over shorter size.
    ///
    /// Cost: an index of the boxes, and vesica_iou_f64 for each mean that the bounds of a box meet.
    ///
    /// Since: 0.1.
    pub fn vesica_fuse_f64(shapes: *const Shapes<f64>, scores: *const f64, weights: *const f64, labels: *const i32,
        threshold: f64, fused_score: i32, scratch: *mut c_void, scratch_size: i64, fused: *mut c_void,
        fused_scores: *mut f64, clusters: *mut i64, count: *mut i64) -> i32;
    /// A ratio of shared volume: IoU and its relatives of two upright prisms.
    ///
    /// A prism is what lies above a shape, its base, from span's low to its high. The shared volume is the shared area
    /// of the bases times the shared height. Ratios are from 0 to 1; prisms that only touch share nothing. Exchanging
    /// the prisms exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the others.
    ///
    /// Requires: ratio, one of VESICA_RATIO_OVER_UNION, _OVER_FIRST, _OVER_SECOND, _OVER_SMALLER.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE (or low above high, or a height that is not finite),
    /// VESICA_E_ARGUMENT (another ratio, or the volume to divide by is 0), VESICA_E_RANGE (an area overflows).
    ///
    /// Accuracy: computed from vesica_iou_f64 of the bases and vesica_shape_area_f64 with at most 12 u of further
    /// error, for areas from 2^-400 to 2^400. The float function takes both as floats. In bounds on errors u is 2^-53,
    /// half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their
    /// centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect
    /// ratio is longer over shorter size.
    ///
    /// Cost: as vesica_iou_f64, and the two areas.
    ///
    /// Since: 0.1.
    pub fn vesica_volume_ratio_f64(ratio: i32, kind_a: i32, a: *const c_void, span_a: *const Span<f64>, kind_b: i32,
        b: *const c_void, span_b: *const Span<f64>, out: *mut f64) -> i32;
    /// A ratio of shared volume of the prisms a\[i\] from spans_a\[i\] and b\[i\] from spans_b\[i\].
    ///
    /// Arrays are those of vesica_iou_many_f64. If a pair has an error, out\[i\] is NaN, and the call returns
    /// VESICA_E_SHAPE if a shape or a span is invalid, else VESICA_E_ARGUMENT if a volume is 0, else VESICA_E_RANGE.
    ///
    /// Requires: spans, as many as there are shapes beside them.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE.
    ///
    /// Accuracy: every result has the same bits as vesica_volume_ratio_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_volume_ratio_many_f64(ratio: i32, a: *const Shapes<f64>, spans_a: *const Span<f64>,
        b: *const Shapes<f64>, spans_b: *const Span<f64>, out: *mut f64) -> i64;
    /// A ratio of shared volume of every a\[i\] and b\[j\], in out\[i \* row_stride + j\].
    ///
    /// Arrays and row_stride are those of vesica_iou_matrix_f64, errors those of vesica_volume_ratio_many_f64.
    ///
    /// Requires: spans, as many as there are shapes beside them.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE.
    ///
    /// Accuracy: every result has the same bits as vesica_volume_ratio_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_volume_ratio_matrix_f64(ratio: i32, a: *const Shapes<f64>, spans_a: *const Span<f64>,
        b: *const Shapes<f64>, spans_b: *const Span<f64>, out: *mut f64, row_stride: isize) -> i64;
    /// How many bytes of scratch does matching by `count` pairs need?
    ///
    /// Returns: 32 bytes a pair, 36 a detection, 1 a truth, and 4.
    ///
    /// Errors: VESICA_E_ARGUMENT (a number is negative or above 2^31 - 1).
    ///
    /// Since: 0.1.
    pub fn vesica_match_truths_scratch(count: i64, detections: i64, truths: i64) -> i64;
    /// Which detections hit a truth, at each of some thresholds?
    ///
    /// Pair k is detection a\[k\] and truth b\[k\] with values\[k\], as vesica_join_ratio_f64 writes them at the lowest
    /// threshold or below; detections and truths of many pictures are numbered through. A pair whose value is NaN is
    /// none. COCO takes the shared area over the detection's (VESICA_RATIO_OVER_FIRST) for crowds in place of IoU. At
    /// each threshold detections take truths in the order of their scores, the highest first, of equal ones by number:
    ///
    ///   - VESICA_MATCH_VOC: the truth with the highest value, of equal ones the first. If it counts and is taken, or
    /// its     value is below the threshold, the detection is a miss.   - VESICA_MATCH_COCO: of the free truths with at
    /// least the threshold, or 1 - 1e-10 if that is less, the one with the     highest value, of equal ones the last.
    /// Those that do not count are asked only if there is none that does.
    ///
    /// outcomes\[t \* detections + i\] is VESICA_OUTCOME_... of detection i at threshold t, and taken\[...\] the truth
    /// it takes, or -1. As COCO, leave out all but the 100 best detections of a picture beforehand; and as for its
    /// ranges of areas, call a miss whose own area is out of the range VESICA_OUTCOME_IGNORED afterwards.
    ///
    /// Requires: rule, VESICA_MATCH_VOC or _COCO; 0 \<= a\[k\] \< detections and 0 \<= b\[k\] \< truths; scores, one
    /// for each detection; flags, VESICA_TRUTH_... of each truth, or NULL if all count; scratch of at least
    /// vesica_match_truths_scratch(count, detections, truths) bytes, aligned to 8; outcomes, and taken if it is not
    /// NULL, with room for detections times threshold_count numbers. Pointers to nothing may be NULL.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (an unknown rule or flag, an item or a size out of range, a score or a
    /// threshold that is NaN, a scratch that is not aligned). Nothing is written.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a sort; then for each threshold a walk over all pairs.
    ///
    /// Since: 0.1.
    pub fn vesica_match_truths_f64(rule: i32, a: *const i64, b: *const i64, values: *const f64, count: i64,
        scores: *const f64, detections: i64, flags: *const u8, truths: i64, thresholds: *const f64,
        threshold_count: i64, scratch: *mut c_void, scratch_size: i64, outcomes: *mut u8, taken: *mut i64) -> i32;
    /// How many bytes of scratch does the average precision of `count` detections need?
    ///
    /// Returns: 32 bytes a detection.
    ///
    /// Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
    ///
    /// Since: 0.1.
    pub fn vesica_average_precision_scratch(count: i64) -> i64;
    /// Average precision (AP) of detections of one class.
    ///
    /// With the detections in the order of their scores, the highest first, of equal ones by number, and without those
    /// that are ignored: after each, precision is hits / detections so far, and recall hits so far / truths. The best
    /// precision at a recall is the highest one after any detection whose recall is at least that, or 0 if there is
    /// none. AP is the mean of the best precision at the recalls of `rule`. Recalls are compared in double, as the
    /// programs of the challenges do: 0.1 i and 0.01 i are rounded, and so are hits / truths. COCO's mean AP is the
    /// mean over its thresholds, 0.50, 0.55 ... 0.95, and classes.
    ///
    /// Requires: rule, one of VESICA_PRECISION_VOC_2007 to _COCO; scores and outcomes (VESICA_OUTCOME_...), one for
    /// each detection; truths, how many of them count; scratch of at least vesica_average_precision_scratch(count)
    /// bytes, aligned to 8.
    ///
    /// Returns: 0; \*out is from 0 to 1, or NaN without truths.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (an unknown rule or outcome, a score that is NaN, more hits than
    /// truths, a size out of range, a scratch that is not aligned).
    ///
    /// Accuracy: u times the number of hits plus 2, for VESICA_PRECISION_COCO 103 u at most. COCO's own program has up
    /// to 2 u less, since it adds 2 u to each divisor. In bounds on errors u is 2^-53, half a unit in the last place of
    /// 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths;
    /// "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: a sort.
    ///
    /// Since: 0.1.
    pub fn vesica_average_precision_f64(rule: i32, scores: *const f64, outcomes: *const u8, count: i64, truths: i64,
        scratch: *mut c_void, scratch_size: i64, out: *mut f64) -> i32;
    /// The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
    ///
    /// A shape's Gaussian has the mean m and the covariance S of its points: the variance along a side of a rectangle
    /// is width^2 / 12, as in ProbIoU; along an axis of an ellipse it is a^2 / 4, a the half length. Papers on GWD and
    /// KLD take width^2 / 4: to have theirs, multiply the half sizes of rectangles by sqrt(3). The four distances are,
    /// with d = m_a - m_b and S = (S_a + S_b) / 2:
    ///
    ///     BHATTACHARYYA     d^T S^-1 d / 8 + log(det S / sqrt(det S_a det S_b)) / 2
    ///     HELLINGER         sqrt(1 - exp(-BHATTACHARYYA))
    ///     KULLBACK_LEIBLER  (trace(S_b^-1 S_a) - 2 + d^T S_b^-1 d + log(det S_b / det S_a)) / 2
    ///     WASSERSTEIN       d^T d + trace(S_a + S_b - 2 (S_a^1/2 S_b S_a^1/2)^1/2)
    ///
    /// Equal Gaussians have exactly 0. Exchanging the shapes changes no bit, except of KULLBACK_LEIBLER. Losses are
    /// made of these numbers in many ways, such as 1 - 1 / (1 + log(1 + x)).
    ///
    /// Requires: which, one of VESICA_GAUSSIAN_BHATTACHARYYA to VESICA_GAUSSIAN_WASSERSTEIN.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND (also points, segments and shapes with round corners or vertices),
    /// VESICA_E_SHAPE, VESICA_E_ARGUMENT (no such distance; or a size is 0, which only WASSERSTEIN takes),
    /// VESICA_E_RANGE (the distance would overflow; or, except for WASSERSTEIN, one size is more than 2^400 times
    /// another).
    ///
    /// Accuracy: a relative error of at most 24 u, and 2^-1074; also if the Gaussians are nearly equal, thin, or far
    /// apart. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the
    /// largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of
    /// at most 4 u times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: a few roots and logarithms; in a matrix about a third of a call or less a pair.
    ///
    /// Since: 0.1.
    pub fn vesica_gaussian_distance_f64(which: i32, kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut f64) -> i32;
    /// The distance of a\[i\] and b\[i\]: out\[i\] is the result of vesica_gaussian_distance_f64.
    ///
    /// Arrays are those of vesica_iou_many_f64. If a pair has an error, out\[i\] is NaN, and the call returns
    /// VESICA_E_SHAPE if a shape is invalid, else VESICA_E_ARGUMENT if a size is 0, else VESICA_E_RANGE.
    ///
    /// Returns: how many are 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE.
    ///
    /// Accuracy: every result has the same bits as vesica_gaussian_distance_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_gaussian_distance_many_f64(which: i32, a: *const Shapes<f64>, b: *const Shapes<f64>,
        out: *mut f64) -> i64;
    /// The distance of a\[i\] and b\[j\]: out\[i \* row_stride + j\] is the result of vesica_gaussian_distance_f64.
    ///
    /// Arrays and row_stride are those of vesica_iou_matrix_f64, errors those of vesica_gaussian_distance_many_f64.
    ///
    /// Returns: how many are 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE.
    ///
    /// Accuracy: every result has the same bits as vesica_gaussian_distance_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_gaussian_distance_matrix_f64(which: i32, a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64,
        row_stride: isize) -> i64;
    /// All pairs that overlap and whose ratio is at least `threshold`, with the ratio: a sparse matrix of IoU and the
    /// like.
    ///
    /// Pair i is out_a\[i\] and out_b\[i\], and values\[i\] is the result of vesica_ratio_f32 for them, the item of
    /// index_a first. Threshold 0 finds every pair that overlaps and has a ratio; GIoU, DIoU and CIoU may be below 0,
    /// so there -infinity does. A pair without a ratio, as two shapes without area have no IoU, is left out. Order,
    /// parts, states, and pairs of an index with itself are as for vesica_join_f32.
    ///
    /// Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE; threshold, not NaN; values with room
    /// for `capacity` numbers. The rest is as for vesica_join_f32 with VESICA_JOIN_OVERLAP. With capacity 0, out_a,
    /// out_b, values and state may be NULL.
    ///
    /// Returns: the number of pairs written; with capacity 0, how many the whole part has.
    ///
    /// Errors: those of vesica_join_f32; VESICA_E_ARGUMENT also for ratio and threshold.
    ///
    /// Accuracy: as vesica_ratio_f32, bit for bit; in float, the ratio rounded to float is compared.
    ///
    /// Cost: vesica_join_f32, and vesica_ratio_f32 for each pair whose bounds meet; for boxes and rectangles and a
    /// threshold above 0 only for those whose bounds and areas allow such a ratio, unless it is over the first or the
    /// second.
    ///
    /// Since: 0.1.
    pub fn vesica_join_ratio_f32(ratio: i32, threshold: f32, index_a: *const c_void, sets_a: *const Shapes<f32>,
        set_count_a: i32, index_b: *const c_void, sets_b: *const Shapes<f32>, set_count_b: i32, part: i64, parts: i64,
        scratch: *mut c_void, scratch_size: i64, out_a: *mut i64, out_b: *mut i64, values: *mut f32, capacity: i64,
        state: *mut i64) -> i64;
    /// Greedy assignment, as of tracks to detections: takes the pair with the highest value whose two items are both
    /// free, until there is none.
    ///
    /// Pair k is item a\[k\] of one side and item b\[k\] of the other, with values\[k\], as vesica_join_ratio_f32
    /// writes them. Of equal values the pair with the lower item of a comes first, then the lower item of b, then the
    /// lower k. A pair whose value is NaN is not taken. chosen\[0\], chosen\[1\] ... are the numbers k of the pairs
    /// taken, the best first. The sum of values may be less than the largest possible one; that is the answer of a
    /// solver for sparse assignment.
    ///
    /// Requires: 0 \<= a\[k\] \< count_a and 0 \<= b\[k\] \< count_b. scratch of at least
    /// vesica_assign_greedy_scratch(count, count_a, count_b) bytes, aligned to 8. chosen, room for the least of count,
    /// count_a and count_b. With count 0 all pointers may be NULL.
    ///
    /// Returns: how many pairs are taken.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (a number, an item or a size is out of range, the scratch is not
    /// aligned). Nothing is written.
    ///
    /// Cost: a sort of the values.
    ///
    /// Since: 0.1.
    pub fn vesica_assign_greedy_f32(a: *const i64, b: *const i64, values: *const f32, count: i64, count_a: i64,
        count_b: i64, scratch: *mut c_void, scratch_size: i64, chosen: *mut i64) -> i64;
    /// Weighted boxes fusion: boxes of one object, as several detectors or views find them, become their weighted mean.
    ///
    /// Takes boxes in the order of score times weight, the highest first, of equal ones by number. Each joins the
    /// cluster of its label whose mean it has the highest IoU with, of equal ones the first, if that IoU exceeds the
    /// threshold; otherwise it begins a cluster. A box counts in its cluster's mean by score times weight: with p = s
    /// w,
    ///
    ///     mean = sum(p x) / sum(p)
    ///
    /// for each coordinate x of a box along the axes, and for the centre and each half length of a rectangle. A
    /// rectangle is the same when it is turned by 180 degrees, or by 90 with its half lengths exchanged. Of these four
    /// forms each member has the one whose corners are nearest to those of the cluster's first member, by the sum of
    /// the squares of their distances, both about one centre. The direction of the mean is that of the sum of p times
    /// their unit directions, and is written as a unit vector. If all p of a cluster are 0, its mean is its first box;
    /// if all its weights are 0, its mean score is the first one. A cluster of one box is that box, bit for bit. Record
    /// c of fused, of the shapes' kind, and fused_scores\[c\] are those of cluster c; clusters\[i\] is that of box i.
    /// The paper then multiplies a score by min(n, m) / m, for n boxes in the cluster and m models: clusters gives n.
    ///
    /// Requires: shapes of kind VESICA_AABB or VESICA_RECT; scores from 0 to 2^480, one for each; weights in the same
    /// range, such as that of a box's model, or NULL for 1; labels, or NULL if all are the same; threshold from 0 to 1;
    /// fused_score VESICA_FUSED_MEAN or _MAX; scratch of at least vesica_fuse_scratch(count) bytes; fused with room for
    /// `count` records of vesica_aabb_f32 or vesica_rect_f32, fused_scores and clusters for as many numbers.
    ///
    /// Returns: 0, with \*count set to the number of clusters.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (the threshold, fused_score, or a size is out of range).
    /// VESICA_E_SHAPE: boxes are left out, and have cluster -1, that are invalid, whose coordinates
    /// or half lengths exceed 2^1020, or whose score or weight is out of range; the result of all others is written.
    ///
    /// Accuracy: IoU is that of vesica_iou_f32 and the mean before it is rounded to the output's type. With n boxes in
    /// the cluster, a coordinate x of the mean is right to 4 u (n d + |x|) + n 2^-1074, d the largest difference from
    /// that of the first box; a score to 4 u n times the highest; a direction to 4 u n, if all are within 45 degrees of
    /// the first. The float function computes in double and rounds its results. In bounds on errors u is 2^-53, half a
    /// unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and
    /// of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is
    /// longer over shorter size.
    ///
    /// Cost: an index of the boxes, and vesica_iou_f32 for each mean that the bounds of a box meet.
    ///
    /// Since: 0.1.
    pub fn vesica_fuse_f32(shapes: *const Shapes<f32>, scores: *const f32, weights: *const f32, labels: *const i32,
        threshold: f32, fused_score: i32, scratch: *mut c_void, scratch_size: i64, fused: *mut c_void,
        fused_scores: *mut f32, clusters: *mut i64, count: *mut i64) -> i32;
    /// Which detections hit a truth, at each of some thresholds?
    ///
    /// Pair k is detection a\[k\] and truth b\[k\] with values\[k\], as vesica_join_ratio_f32 writes them at the lowest
    /// threshold or below; detections and truths of many pictures are numbered through. A pair whose value is NaN is
    /// none. COCO takes the shared area over the detection's (VESICA_RATIO_OVER_FIRST) for crowds in place of IoU. At
    /// each threshold detections take truths in the order of their scores, the highest first, of equal ones by number:
    ///
    ///   - VESICA_MATCH_VOC: the truth with the highest value, of equal ones the first. If it counts and is taken, or
    /// its     value is below the threshold, the detection is a miss.   - VESICA_MATCH_COCO: of the free truths with at
    /// least the threshold, or 1 - 1e-10 if that is less, the one with the     highest value, of equal ones the last.
    /// Those that do not count are asked only if there is none that does.
    ///
    /// outcomes\[t \* detections + i\] is VESICA_OUTCOME_... of detection i at threshold t, and taken\[...\] the truth
    /// it takes, or -1. As COCO, leave out all but the 100 best detections of a picture beforehand; and as for its
    /// ranges of areas, call a miss whose own area is out of the range VESICA_OUTCOME_IGNORED afterwards.
    ///
    /// Requires: rule, VESICA_MATCH_VOC or _COCO; 0 \<= a\[k\] \< detections and 0 \<= b\[k\] \< truths; scores, one
    /// for each detection; flags, VESICA_TRUTH_... of each truth, or NULL if all count; scratch of at least
    /// vesica_match_truths_scratch(count, detections, truths) bytes, aligned to 8; outcomes, and taken if it is not
    /// NULL, with room for detections times threshold_count numbers. Pointers to nothing may be NULL.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (an unknown rule or flag, an item or a size out of range, a score or a
    /// threshold that is NaN, a scratch that is not aligned). Nothing is written.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a sort; then for each threshold a walk over all pairs.
    ///
    /// Since: 0.1.
    pub fn vesica_match_truths_f32(rule: i32, a: *const i64, b: *const i64, values: *const f32, count: i64,
        scores: *const f32, detections: i64, flags: *const u8, truths: i64, thresholds: *const f32,
        threshold_count: i64, scratch: *mut c_void, scratch_size: i64, outcomes: *mut u8, taken: *mut i64) -> i32;
    /// Average precision (AP) of detections of one class.
    ///
    /// With the detections in the order of their scores, the highest first, of equal ones by number, and without those
    /// that are ignored: after each, precision is hits / detections so far, and recall hits so far / truths. The best
    /// precision at a recall is the highest one after any detection whose recall is at least that, or 0 if there is
    /// none. AP is the mean of the best precision at the recalls of `rule`. Recalls are compared in double, as the
    /// programs of the challenges do: 0.1 i and 0.01 i are rounded, and so are hits / truths. COCO's mean AP is the
    /// mean over its thresholds, 0.50, 0.55 ... 0.95, and classes.
    ///
    /// Requires: rule, one of VESICA_PRECISION_VOC_2007 to _COCO; scores and outcomes (VESICA_OUTCOME_...), one for
    /// each detection; truths, how many of them count; scratch of at least vesica_average_precision_scratch(count)
    /// bytes, aligned to 8.
    ///
    /// Returns: 0; \*out is from 0 to 1, or NaN without truths.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (an unknown rule or outcome, a score that is NaN, more hits than
    /// truths, a size out of range, a scratch that is not aligned).
    ///
    /// Accuracy: u times the number of hits plus 2, for VESICA_PRECISION_COCO 103 u at most. COCO's own program has up
    /// to 2 u less, since it adds 2 u to each divisor. Each number is computed in double, within these bounds, and then
    /// rounded to float once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two
    /// shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale"
    /// means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: a sort.
    ///
    /// Since: 0.1.
    pub fn vesica_average_precision_f32(rule: i32, scores: *const f32, outcomes: *const u8, count: i64, truths: i64,
        scratch: *mut c_void, scratch_size: i64, out: *mut f32) -> i32;
    /// A ratio of shared volume: IoU and its relatives of two upright prisms.
    ///
    /// A prism is what lies above a shape, its base, from span's low to its high. The shared volume is the shared area
    /// of the bases times the shared height. Ratios are from 0 to 1; prisms that only touch share nothing. Exchanging
    /// the prisms exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the others.
    ///
    /// Requires: ratio, one of VESICA_RATIO_OVER_UNION, _OVER_FIRST, _OVER_SECOND, _OVER_SMALLER.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE (or low above high, or a height that is not finite),
    /// VESICA_E_ARGUMENT (another ratio, or the volume to divide by is 0), VESICA_E_RANGE (an area overflows).
    ///
    /// Accuracy: computed from vesica_iou_f32 of the bases and vesica_shape_area_f32 with at most 12 u of further
    /// error, for areas from 2^-400 to 2^400. The float function takes both as floats. Each number is computed in
    /// double, within these bounds, and then rounded to float once. In bounds on errors u is 2^-53, half a unit in the
    /// last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
    /// lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over
    /// shorter size.
    ///
    /// Cost: as vesica_iou_f32, and the two areas.
    ///
    /// Since: 0.1.
    pub fn vesica_volume_ratio_f32(ratio: i32, kind_a: i32, a: *const c_void, span_a: *const Span<f32>, kind_b: i32,
        b: *const c_void, span_b: *const Span<f32>, out: *mut f32) -> i32;
    /// A ratio of shared volume of the prisms a\[i\] from spans_a\[i\] and b\[i\] from spans_b\[i\].
    ///
    /// Arrays are those of vesica_iou_many_f32. If a pair has an error, out\[i\] is NaN, and the call returns
    /// VESICA_E_SHAPE if a shape or a span is invalid, else VESICA_E_ARGUMENT if a volume is 0, else VESICA_E_RANGE.
    ///
    /// Requires: spans, as many as there are shapes beside them.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE.
    ///
    /// Accuracy: every result has the same bits as vesica_volume_ratio_f32.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_volume_ratio_many_f32(ratio: i32, a: *const Shapes<f32>, spans_a: *const Span<f32>,
        b: *const Shapes<f32>, spans_b: *const Span<f32>, out: *mut f32) -> i64;
    /// A ratio of shared volume of every a\[i\] and b\[j\], in out\[i \* row_stride + j\].
    ///
    /// Arrays and row_stride are those of vesica_iou_matrix_f32, errors those of vesica_volume_ratio_many_f32.
    ///
    /// Requires: spans, as many as there are shapes beside them.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE.
    ///
    /// Accuracy: every result has the same bits as vesica_volume_ratio_f32.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_volume_ratio_matrix_f32(ratio: i32, a: *const Shapes<f32>, spans_a: *const Span<f32>,
        b: *const Shapes<f32>, spans_b: *const Span<f32>, out: *mut f32, row_stride: isize) -> i64;
    /// The distance of two circles, boxes, rectangles or ellipses as Gaussian distributions.
    ///
    /// A shape's Gaussian has the mean m and the covariance S of its points: the variance along a side of a rectangle
    /// is width^2 / 12, as in ProbIoU; along an axis of an ellipse it is a^2 / 4, a the half length. Papers on GWD and
    /// KLD take width^2 / 4: to have theirs, multiply the half sizes of rectangles by sqrt(3). The four distances are,
    /// with d = m_a - m_b and S = (S_a + S_b) / 2:
    ///
    ///     BHATTACHARYYA     d^T S^-1 d / 8 + log(det S / sqrt(det S_a det S_b)) / 2
    ///     HELLINGER         sqrt(1 - exp(-BHATTACHARYYA))
    ///     KULLBACK_LEIBLER  (trace(S_b^-1 S_a) - 2 + d^T S_b^-1 d + log(det S_b / det S_a)) / 2
    ///     WASSERSTEIN       d^T d + trace(S_a + S_b - 2 (S_a^1/2 S_b S_a^1/2)^1/2)
    ///
    /// Equal Gaussians have exactly 0. Exchanging the shapes changes no bit, except of KULLBACK_LEIBLER. Losses are
    /// made of these numbers in many ways, such as 1 - 1 / (1 + log(1 + x)).
    ///
    /// Requires: which, one of VESICA_GAUSSIAN_BHATTACHARYYA to VESICA_GAUSSIAN_WASSERSTEIN.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND (also points, segments and shapes with round corners or vertices),
    /// VESICA_E_SHAPE, VESICA_E_ARGUMENT (no such distance; or a size is 0, which only WASSERSTEIN takes),
    /// VESICA_E_RANGE (the distance would overflow; or, except for WASSERSTEIN, one size is more than 2^400 times
    /// another).
    ///
    /// Accuracy: a relative error of at most 24 u, and 2^-1074; also if the Gaussians are nearly equal, thin, or far
    /// apart. Each number is computed in double, within these bounds, and then rounded to float once. In bounds on
    /// errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy|
    /// between their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the
    /// scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: a few roots and logarithms; in a matrix about a third of a call or less a pair.
    ///
    /// Since: 0.1.
    pub fn vesica_gaussian_distance_f32(which: i32, kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut f32) -> i32;
    /// The distance of a\[i\] and b\[i\]: out\[i\] is the result of vesica_gaussian_distance_f32.
    ///
    /// Arrays are those of vesica_iou_many_f32. If a pair has an error, out\[i\] is NaN, and the call returns
    /// VESICA_E_SHAPE if a shape is invalid, else VESICA_E_ARGUMENT if a size is 0, else VESICA_E_RANGE.
    ///
    /// Returns: how many are 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE.
    ///
    /// Accuracy: every result has the same bits as vesica_gaussian_distance_f32.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_gaussian_distance_many_f32(which: i32, a: *const Shapes<f32>, b: *const Shapes<f32>,
        out: *mut f32) -> i64;
    /// The distance of a\[i\] and b\[j\]: out\[i \* row_stride + j\] is the result of vesica_gaussian_distance_f32.
    ///
    /// Arrays and row_stride are those of vesica_iou_matrix_f32, errors those of vesica_gaussian_distance_many_f32.
    ///
    /// Returns: how many are 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE.
    ///
    /// Accuracy: every result has the same bits as vesica_gaussian_distance_f32.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_gaussian_distance_matrix_f32(which: i32, a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32,
        row_stride: isize) -> i64;
    /// How many bytes suffice for an index of `count` shapes, of any kinds?
    ///
    /// Returns: 17 bytes a shape and 64 KiB. A built index takes fewer, mostly 13 a shape: see vesica_index_bytes.
    ///
    /// Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
    ///
    /// Since: 0.1.
    pub fn vesica_index_size(count: i64) -> i64;
    /// How many bytes of scratch does building an index of `count` shapes need?
    ///
    /// Returns: about 17 bytes a shape and 0.3 MiB.
    ///
    /// Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
    ///
    /// Since: 0.1.
    pub fn vesica_index_scratch(count: i64) -> i64;
    /// How many bytes of scratch does a join need, whatever its indexes?
    ///
    /// Returns: at most 1 MiB.
    ///
    /// Since: 0.1.
    pub fn vesica_join_scratch() -> i64;
    /// Are these bytes an index that is safe to read?
    ///
    /// Call it once for bytes that you did not just build: they may be cut off, damaged, something else, or from a
    /// machine of the other byte order. What passes is safe to read; damage of single shapes' places may pass and
    /// change answers.
    ///
    /// Requires: size, the number of readable bytes. The index may be shorter.
    ///
    /// Returns: 0 if they are.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (they are not).
    ///
    /// Cost: it reads all bytes once.
    ///
    /// Since: 0.1.
    pub fn vesica_index_check(index: *const c_void, size: i64) -> i32;
    /// How many bytes does a built index take? Save that many.
    ///
    /// Returns: the bytes, a multiple of 64.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (not an index's header).
    ///
    /// Since: 0.1.
    pub fn vesica_index_bytes(index: *const c_void) -> i64;
    /// How many shapes was an index built from?
    ///
    /// Returns: the number of its items, including invalid shapes.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (not an index's header).
    ///
    /// Since: 0.1.
    pub fn vesica_index_count(index: *const c_void) -> i64;
    /// A box around all valid shapes of an index.
    ///
    /// Two indexes whose boxes are disjoint have no overlapping pairs.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned), VESICA_E_INDEX (not an index's header).
    ///
    /// Accuracy: the box is a little larger than the smallest one; a side that overflows is infinite. Without valid
    /// shapes min is infinity and max is -infinity.
    ///
    /// Since: 0.1.
    pub fn vesica_index_bounds(index: *const c_void, out: *mut Aabb<f64>) -> i32;
    /// The items of an index in spatial order: shapes near each other have nearby places in it.
    ///
    /// A join is faster if the arrays of shapes have this order, as it then reads nearby memory.
    ///
    /// Requires: out has room for `capacity` items. It may be NULL if that is 0.
    ///
    /// Returns: how many items there are, without the invalid shapes. The first `capacity` of them are written.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (the index is not aligned, capacity \< 0), VESICA_E_INDEX.
    ///
    /// Since: 0.1.
    pub fn vesica_index_order(index: *const c_void, out: *mut i64, capacity: i64) -> i64;
    /// Builds the index of some sets of shapes. There may be none; sets may then be NULL.
    ///
    /// If shapes are invalid, the call returns VESICA_E_SHAPE, and the index is complete without them. When shapes have
    /// moved, build it again.
    ///
    /// Requires: index_size \>= vesica_index_size(items) and scratch_size \>= vesica_index_scratch(items). The scratch
    /// may be reused after the call.
    ///
    /// Returns: how many bytes of the index are used.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a wrong count, size or alignment), VESICA_E_SHAPE.
    ///
    /// Cost: a few times vesica_bounds_many_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_index_build_f64(sets: *const Shapes<f64>, set_count: i32, index: *mut c_void, index_size: i64,
        scratch: *mut c_void, scratch_size: i64) -> i64;
    /// One part of a build by several threads, in five steps. The bytes are those of vesica_index_build_f64.
    ///
    /// Steps 0 and 4 have one part. Steps 1, 2 and 3 have as many parts as the caller likes, and these may run at the
    /// same time. All parts of a step must end before the next step begins. All other arguments are the same in all
    /// calls.
    ///
    /// Requires: 0 \<= step \<= 4 and 0 \<= part \< parts; parts is 1 in steps 0 and 4. The rest is as for the build.
    ///
    /// Returns: 0; at step 4 what vesica_index_build_f64 returns.
    ///
    /// Errors: those of vesica_index_build_f64. VESICA_E_ARGUMENT also, with nothing done, if step, part or parts is
    /// out of range, if the scratch is not from step 0 of a build that has not ended, if a part of the step before is
    /// missing, or if some of this part was done before. A part without shapes (there may be more parts than shapes)
    /// has nothing to do: a missing or repeated one is not noticed.
    ///
    /// Cost: in all as the build: three fifths in step 1; a tenth in step 0, which cannot be divided.
    ///
    /// Since: 0.1.
    pub fn vesica_index_step_f64(step: i32, part: i64, parts: i64, sets: *const Shapes<f64>, set_count: i32,
        index: *mut c_void, index_size: i64, scratch: *mut c_void, scratch_size: i64) -> i64;
    /// Which items of an index does one shape overlap? They come in the index's order.
    ///
    /// To ask for many shapes, index them too and call vesica_join_f64.
    ///
    /// Requires: sets are those of the index; or NULL, with set_count 0, to find the items whose bounds meet the
    /// shape's. Bounds are those in the index, up to about 2^-15 of the extent of nearby shapes larger than
    /// vesica_bounds_f64's. one, an array of count 1. out has room for `capacity` items. With capacity 0, out and state
    /// may be NULL.
    ///
    /// Returns: the number of items written; with capacity 0, how many there are.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
    /// number or a size is out of range, a pointer is not aligned, the sets have another number of items than the
    /// index, the state is from another function, part, parts or query). Other sets, and states of calls with other
    /// shapes or distances, are not noticed: answers are then meaningless.
    ///
    /// Accuracy: exact, if there are sets.
    ///
    /// Cost: a search, and vesica_overlap_f64 for each item whose bounds meet those of the shape.
    ///
    /// Since: 0.1.
    pub fn vesica_index_select_f64(index: *const c_void, sets: *const Shapes<f64>, set_count: i32,
        one: *const Shapes<f64>, out: *mut i64, capacity: i64, state: *mut i64) -> i64;
    /// Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
    ///
    /// If both indexes are the same pointer, pairs are two different items a \< b: VESICA_JOIN_CONTAINS then finds
    /// pairs whose lower item contains the higher one, _INSIDE the others. Pair i is out_a\[i\] and out_b\[i\]. The
    /// order of pairs depends on the bytes of the indexes and the query alone. The work may be divided into `parts` of
    /// about equal work, which may run at the same time, each with its own scratch. The pairs of all parts, one part
    /// after the other, are those of a call with part 0 and parts 1.
    ///
    /// Requires: query is VESICA_JOIN_OVERLAP ... VESICA_JOIN_INTERIORS. sets_a and sets_b are those of the indexes;
    /// with VESICA_JOIN_BOUNDS they are ignored. 0 \<= part \< parts. scratch_size \>= vesica_join_scratch(); nothing
    /// is kept in the scratch between calls. out_a and out_b have room for `capacity` items. With capacity 0, they and
    /// state may be NULL.
    ///
    /// Returns: the number of pairs written; with capacity 0, how many the whole part has.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND (also for VESICA_JOIN_CONTAINS and _INSIDE where a set of
    /// either side has kinds that vesica_contains_f64 does not take together), VESICA_E_ARGUMENT (an unknown query, a
    /// number or a size out of range, a pointer that is not aligned, sets of another number of items, a state from
    /// another function).
    ///
    /// Accuracy: exact for all queries but VESICA_JOIN_BOUNDS.
    ///
    /// Cost: about twice vesica_overlap_f64 for each shape, and the same for each pair whose bounds meet.
    ///
    /// Since: 0.1.
    pub fn vesica_join_f64(query: i32, index_a: *const c_void, sets_a: *const Shapes<f64>, set_count_a: i32,
        index_b: *const c_void, sets_b: *const Shapes<f64>, set_count_b: i32, part: i64, parts: i64,
        scratch: *mut c_void, scratch_size: i64, out_a: *mut i64, out_b: *mut i64, capacity: i64,
        state: *mut i64) -> i64;
    /// All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those
    /// for which vesica_within_f64 is \> 0.
    ///
    /// If both indexes are the same pointer, pairs are those of two different items a \< b. They come in index_a's
    /// order. Each part takes about the same number of items of index_a; all else is as for vesica_join_f64.
    ///
    /// Requires: distance, infinity for all pairs of valid shapes, \< 0 for those that overlap at least -distance deep;
    /// sets, part, outputs, capacity and state as vesica_join_f64.
    ///
    /// Returns: the number of pairs written; with capacity 0, how many the whole part has.
    ///
    /// Errors: those of vesica_join_f64; VESICA_E_ARGUMENT also for a distance that is NaN.
    ///
    /// Accuracy: as vesica_within_f64; pairs that are VESICA_WITHIN_NEARLY are included.
    ///
    /// Cost: seven times vesica_join_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_join_within_f64(index_a: *const c_void, sets_a: *const Shapes<f64>, set_count_a: i32,
        index_b: *const c_void, sets_b: *const Shapes<f64>, set_count_b: i32, distance: f64, part: i64, parts: i64,
        out_a: *mut i64, out_b: *mut i64, capacity: i64, state: *mut i64) -> i64;
    /// Which items of an index are nearest to one shape? The nearest comes first, of equally near ones the lower item.
    ///
    /// An item that overlaps the shape has distance 0. An item whose distance overflows is not found.
    ///
    /// Requires: sets are those of the index. one, an array of count 1. k \>= 0, and out and distance have room for k
    /// each. With k = 0 they may be NULL. within, the largest distance to look for, \>= 0 or infinity.
    ///
    /// Returns: how many items were found and written; with k = 0, how many there are within the distance.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
    /// number or a size is out of range, a pointer is not aligned, the sets have another number of items than the
    /// index, the state is from another function, part, parts or query). Other sets, and states of calls with other
    /// shapes or distances, are not noticed: answers are then meaningless.
    ///
    /// Accuracy: distances are those of vesica_nearest_f64, bit for bit.
    ///
    /// Cost: a search, and vesica_nearest_f64 for a few items more than k, and for all items that overlap the shape, as
    /// the lowest come first. Of points and boxes along the axes about k are measured.
    ///
    /// Since: 0.1.
    pub fn vesica_index_nearest_f64(index: *const c_void, sets: *const Shapes<f64>, set_count: i32,
        one: *const Shapes<f64>, k: i64, within: f64, out: *mut i64, distance: *mut f64) -> i64;
    /// Which items of index_b are nearest to each item of sets_a? Row i is out\[i \* k\] ... out\[i \* k + k - 1\].
    ///
    /// A row is the result of vesica_index_nearest_f64 for item i. If it has fewer than k items, the rest are -1 with
    /// distance infinity. If a set is asked for its own neighbours, each item finds itself too, at distance 0, unless k
    /// lower items overlap it. If an item of sets_a is invalid, its row holds -1, all other rows are right, and the
    /// call returns VESICA_E_SHAPE. Each part takes about the same number of items, and writes only their rows.
    ///
    /// Requires: sets_b are those of index_b. k \>= 1, and out and distance have room for k items a row. If sets_a have
    /// no items, they may be NULL. 0 \<= part \< parts. within, the largest distance to look for, \>= 0 or infinity.
    ///
    /// Returns: how many items were found in all rows of the part.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
    /// number or a size is out of range, a pointer is not aligned, the sets have another number of items than the
    /// index, the state is from another function, part, parts or query). Other sets, and states of calls with other
    /// shapes or distances, are not noticed: answers are then meaningless.
    ///
    /// Accuracy: distances are those of vesica_nearest_f64, bit for bit.
    ///
    /// Cost: vesica_index_nearest_f64 for each item.
    ///
    /// Since: 0.1.
    pub fn vesica_join_nearest_f64(sets_a: *const Shapes<f64>, set_count_a: i32, index_b: *const c_void,
        sets_b: *const Shapes<f64>, set_count_b: i32, k: i64, within: f64, part: i64, parts: i64, out: *mut i64,
        distance: *mut f64) -> i64;
    /// How many bytes do the boxes of a polygon or a polyline take?
    ///
    /// Returns: 64 bytes, and about 1.07 for each vertex.
    ///
    /// Errors: VESICA_E_ARGUMENT (vertices is below 1 or above 2^58).
    ///
    /// Since: 0.1.
    pub fn vesica_polygon_boxes_size(vertices: i64) -> i64;
    /// Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a zone.
    ///
    /// They lie in memory of the caller, and may be saved, sent or mapped. Answers are the same bits as without them.
    /// The path must be as it was when they were made. Functions of arrays need no such boxes: where one path is asked
    /// about many shapes, they are made within the call.
    ///
    /// Requires: boxes are aligned to 8 bytes. size is at least vesica_polygon_boxes_size of the number of vertices.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND (not a polygon or a polyline), VESICA_E_SHAPE, VESICA_E_ARGUMENT (size is
    /// less, or the boxes are not aligned).
    ///
    /// Cost: one pass over the vertices.
    ///
    /// Since: 0.1.
    pub fn vesica_polygon_boxes_f64(kind: i32, path: *const c_void, boxes: *mut c_void, size: i64) -> i32;
    /// Does a path with boxes overlap another shape? As vesica_overlap_f64, for any kind b.
    ///
    /// Requires: the boxes are of this path, by a function of the same scalar type.
    ///
    /// Returns: 1 or 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_INDEX (no boxes of a path with these vertices), VESICA_E_SHAPE.
    ///
    /// Since: 0.1.
    pub fn vesica_polygon_boxes_overlap_f64(kind: i32, path: *const c_void, boxes: *const c_void, size: i64,
        kind_b: i32, b: *const c_void) -> i32;
    /// The distance of a path with boxes and another shape, and where it is. As vesica_nearest_f64.
    /// Requires, Errors: those of vesica_polygon_boxes_overlap_f64; also VESICA_E_RANGE.
    ///
    /// Returns: 0.
    ///
    /// Cost: with another polygon or polyline as vesica_nearest_f64, since boxes do not help there.
    ///
    /// Since: 0.1.
    pub fn vesica_polygon_boxes_nearest_f64(kind: i32, path: *const c_void, boxes: *const c_void, size: i64,
        kind_b: i32, b: *const c_void, out: *mut ClosestPoints<f64>) -> i32;
    /// Are a path with boxes and another shape at most a distance apart? As vesica_within_f64.
    /// Requires, Errors: those of vesica_polygon_boxes_overlap_f64; also VESICA_E_ARGUMENT (distance is NaN) and
    /// VESICA_E_NOT_CONVEX.
    ///
    /// Returns: VESICA_WITHIN_YES, VESICA_WITHIN_NO or VESICA_WITHIN_NEARLY.
    ///
    /// Since: 0.1.
    pub fn vesica_polygon_boxes_within_f64(kind: i32, path: *const c_void, boxes: *const c_void, size: i64, kind_b: i32,
        b: *const c_void, distance: f64) -> i32;
    /// Builds the index of some sets of shapes. There may be none; sets may then be NULL.
    ///
    /// If shapes are invalid, the call returns VESICA_E_SHAPE, and the index is complete without them. When shapes have
    /// moved, build it again.
    ///
    /// Requires: index_size \>= vesica_index_size(items) and scratch_size \>= vesica_index_scratch(items). The scratch
    /// may be reused after the call.
    ///
    /// Returns: how many bytes of the index are used.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a wrong count, size or alignment), VESICA_E_SHAPE.
    ///
    /// Cost: a few times vesica_bounds_many_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_index_build_f32(sets: *const Shapes<f32>, set_count: i32, index: *mut c_void, index_size: i64,
        scratch: *mut c_void, scratch_size: i64) -> i64;
    /// One part of a build by several threads, in five steps. The bytes are those of vesica_index_build_f32.
    ///
    /// Steps 0 and 4 have one part. Steps 1, 2 and 3 have as many parts as the caller likes, and these may run at the
    /// same time. All parts of a step must end before the next step begins. All other arguments are the same in all
    /// calls.
    ///
    /// Requires: 0 \<= step \<= 4 and 0 \<= part \< parts; parts is 1 in steps 0 and 4. The rest is as for the build.
    ///
    /// Returns: 0; at step 4 what vesica_index_build_f32 returns.
    ///
    /// Errors: those of vesica_index_build_f32. VESICA_E_ARGUMENT also, with nothing done, if step, part or parts is
    /// out of range, if the scratch is not from step 0 of a build that has not ended, if a part of the step before is
    /// missing, or if some of this part was done before. A part without shapes (there may be more parts than shapes)
    /// has nothing to do: a missing or repeated one is not noticed.
    ///
    /// Cost: in all as the build: three fifths in step 1; a tenth in step 0, which cannot be divided.
    ///
    /// Since: 0.1.
    pub fn vesica_index_step_f32(step: i32, part: i64, parts: i64, sets: *const Shapes<f32>, set_count: i32,
        index: *mut c_void, index_size: i64, scratch: *mut c_void, scratch_size: i64) -> i64;
    /// Which items of an index does one shape overlap? They come in the index's order.
    ///
    /// To ask for many shapes, index them too and call vesica_join_f32.
    ///
    /// Requires: sets are those of the index; or NULL, with set_count 0, to find the items whose bounds meet the
    /// shape's. Bounds are those in the index, up to about 2^-15 of the extent of nearby shapes larger than
    /// vesica_bounds_f32's. one, an array of count 1. out has room for `capacity` items. With capacity 0, out and state
    /// may be NULL.
    ///
    /// Returns: the number of items written; with capacity 0, how many there are.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
    /// number or a size is out of range, a pointer is not aligned, the sets have another number of items than the
    /// index, the state is from another function, part, parts or query). Other sets, and states of calls with other
    /// shapes or distances, are not noticed: answers are then meaningless.
    ///
    /// Accuracy: exact, if there are sets.
    ///
    /// Cost: a search, and vesica_overlap_f32 for each item whose bounds meet those of the shape.
    ///
    /// Since: 0.1.
    pub fn vesica_index_select_f32(index: *const c_void, sets: *const Shapes<f32>, set_count: i32,
        one: *const Shapes<f32>, out: *mut i64, capacity: i64, state: *mut i64) -> i64;
    /// Join: all pairs of an item of index_a and an item of index_b for which a query holds, each pair once.
    ///
    /// If both indexes are the same pointer, pairs are two different items a \< b: VESICA_JOIN_CONTAINS then finds
    /// pairs whose lower item contains the higher one, _INSIDE the others. Pair i is out_a\[i\] and out_b\[i\]. The
    /// order of pairs depends on the bytes of the indexes and the query alone. The work may be divided into `parts` of
    /// about equal work, which may run at the same time, each with its own scratch. The pairs of all parts, one part
    /// after the other, are those of a call with part 0 and parts 1.
    ///
    /// Requires: query is VESICA_JOIN_OVERLAP ... VESICA_JOIN_INTERIORS. sets_a and sets_b are those of the indexes;
    /// with VESICA_JOIN_BOUNDS they are ignored. 0 \<= part \< parts. scratch_size \>= vesica_join_scratch(); nothing
    /// is kept in the scratch between calls. out_a and out_b have room for `capacity` items. With capacity 0, they and
    /// state may be NULL.
    ///
    /// Returns: the number of pairs written; with capacity 0, how many the whole part has.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND (also for VESICA_JOIN_CONTAINS and _INSIDE where a set of
    /// either side has kinds that vesica_contains_f32 does not take together), VESICA_E_ARGUMENT (an unknown query, a
    /// number or a size out of range, a pointer that is not aligned, sets of another number of items, a state from
    /// another function).
    ///
    /// Accuracy: exact for all queries but VESICA_JOIN_BOUNDS.
    ///
    /// Cost: about twice vesica_overlap_f32 for each shape, and the same for each pair whose bounds meet.
    ///
    /// Since: 0.1.
    pub fn vesica_join_f32(query: i32, index_a: *const c_void, sets_a: *const Shapes<f32>, set_count_a: i32,
        index_b: *const c_void, sets_b: *const Shapes<f32>, set_count_b: i32, part: i64, parts: i64,
        scratch: *mut c_void, scratch_size: i64, out_a: *mut i64, out_b: *mut i64, capacity: i64,
        state: *mut i64) -> i64;
    /// All pairs of an item of index_a and an item of index_b that are at most `distance` apart, each pair once: those
    /// for which vesica_within_f32 is \> 0.
    ///
    /// If both indexes are the same pointer, pairs are those of two different items a \< b. They come in index_a's
    /// order. Each part takes about the same number of items of index_a; all else is as for vesica_join_f32.
    ///
    /// Requires: distance, infinity for all pairs of valid shapes, \< 0 for those that overlap at least -distance deep;
    /// sets, part, outputs, capacity and state as vesica_join_f32.
    ///
    /// Returns: the number of pairs written; with capacity 0, how many the whole part has.
    ///
    /// Errors: those of vesica_join_f32; VESICA_E_ARGUMENT also for a distance that is NaN.
    ///
    /// Accuracy: as vesica_within_f32; pairs that are VESICA_WITHIN_NEARLY are included.
    ///
    /// Cost: seven times vesica_join_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_join_within_f32(index_a: *const c_void, sets_a: *const Shapes<f32>, set_count_a: i32,
        index_b: *const c_void, sets_b: *const Shapes<f32>, set_count_b: i32, distance: f32, part: i64, parts: i64,
        out_a: *mut i64, out_b: *mut i64, capacity: i64, state: *mut i64) -> i64;
    /// Which items of an index are nearest to one shape? The nearest comes first, of equally near ones the lower item.
    ///
    /// An item that overlaps the shape has distance 0. An item whose distance overflows is not found.
    ///
    /// Requires: sets are those of the index. one, an array of count 1. k \>= 0, and out and distance have room for k
    /// each. With k = 0 they may be NULL. within, the largest distance to look for, \>= 0 or infinity.
    ///
    /// Returns: how many items were found and written; with k = 0, how many there are within the distance.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
    /// number or a size is out of range, a pointer is not aligned, the sets have another number of items than the
    /// index, the state is from another function, part, parts or query). Other sets, and states of calls with other
    /// shapes or distances, are not noticed: answers are then meaningless.
    ///
    /// Accuracy: distances are those of vesica_nearest_f32, bit for bit.
    ///
    /// Cost: a search, and vesica_nearest_f32 for a few items more than k, and for all items that overlap the shape, as
    /// the lowest come first. Of points and boxes along the axes about k are measured.
    ///
    /// Since: 0.1.
    pub fn vesica_index_nearest_f32(index: *const c_void, sets: *const Shapes<f32>, set_count: i32,
        one: *const Shapes<f32>, k: i64, within: f32, out: *mut i64, distance: *mut f32) -> i64;
    /// Which items of index_b are nearest to each item of sets_a? Row i is out\[i \* k\] ... out\[i \* k + k - 1\].
    ///
    /// A row is the result of vesica_index_nearest_f32 for item i. If it has fewer than k items, the rest are -1 with
    /// distance infinity. If a set is asked for its own neighbours, each item finds itself too, at distance 0, unless k
    /// lower items overlap it. If an item of sets_a is invalid, its row holds -1, all other rows are right, and the
    /// call returns VESICA_E_SHAPE. Each part takes about the same number of items, and writes only their rows.
    ///
    /// Requires: sets_b are those of index_b. k \>= 1, and out and distance have room for k items a row. If sets_a have
    /// no items, they may be NULL. 0 \<= part \< parts. within, the largest distance to look for, \>= 0 or infinity.
    ///
    /// Returns: how many items were found in all rows of the part.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_SHAPE (`one` is invalid), VESICA_E_ARGUMENT (a
    /// number or a size is out of range, a pointer is not aligned, the sets have another number of items than the
    /// index, the state is from another function, part, parts or query). Other sets, and states of calls with other
    /// shapes or distances, are not noticed: answers are then meaningless.
    ///
    /// Accuracy: distances are those of vesica_nearest_f32, bit for bit.
    ///
    /// Cost: vesica_index_nearest_f32 for each item.
    ///
    /// Since: 0.1.
    pub fn vesica_join_nearest_f32(sets_a: *const Shapes<f32>, set_count_a: i32, index_b: *const c_void,
        sets_b: *const Shapes<f32>, set_count_b: i32, k: i64, within: f32, part: i64, parts: i64, out: *mut i64,
        distance: *mut f32) -> i64;
    /// Makes boxes about the edges of a polygon or a polyline that is asked again and again, such as a coast or a zone.
    ///
    /// They lie in memory of the caller, and may be saved, sent or mapped. Answers are the same bits as without them.
    /// The path must be as it was when they were made. Functions of arrays need no such boxes: where one path is asked
    /// about many shapes, they are made within the call.
    ///
    /// Requires: boxes are aligned to 8 bytes. size is at least vesica_polygon_boxes_size of the number of vertices.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND (not a polygon or a polyline), VESICA_E_SHAPE, VESICA_E_ARGUMENT (size is
    /// less, or the boxes are not aligned).
    ///
    /// Cost: one pass over the vertices.
    ///
    /// Since: 0.1.
    pub fn vesica_polygon_boxes_f32(kind: i32, path: *const c_void, boxes: *mut c_void, size: i64) -> i32;
    /// Does a path with boxes overlap another shape? As vesica_overlap_f32, for any kind b.
    ///
    /// Requires: the boxes are of this path, by a function of the same scalar type.
    ///
    /// Returns: 1 or 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_INDEX (no boxes of a path with these vertices), VESICA_E_SHAPE.
    ///
    /// Since: 0.1.
    pub fn vesica_polygon_boxes_overlap_f32(kind: i32, path: *const c_void, boxes: *const c_void, size: i64,
        kind_b: i32, b: *const c_void) -> i32;
    /// The distance of a path with boxes and another shape, and where it is. As vesica_nearest_f32.
    /// Requires, Errors: those of vesica_polygon_boxes_overlap_f32; also VESICA_E_RANGE.
    ///
    /// Returns: 0.
    ///
    /// Cost: with another polygon or polyline as vesica_nearest_f32, since boxes do not help there.
    ///
    /// Since: 0.1.
    pub fn vesica_polygon_boxes_nearest_f32(kind: i32, path: *const c_void, boxes: *const c_void, size: i64,
        kind_b: i32, b: *const c_void, out: *mut ClosestPoints<f32>) -> i32;
    /// Are a path with boxes and another shape at most a distance apart? As vesica_within_f32.
    /// Requires, Errors: those of vesica_polygon_boxes_overlap_f32; also VESICA_E_ARGUMENT (distance is NaN) and
    /// VESICA_E_NOT_CONVEX.
    ///
    /// Returns: VESICA_WITHIN_YES, VESICA_WITHIN_NO or VESICA_WITHIN_NEARLY.
    ///
    /// Since: 0.1.
    pub fn vesica_polygon_boxes_within_f32(kind: i32, path: *const c_void, boxes: *const c_void, size: i64, kind_b: i32,
        b: *const c_void, distance: f32) -> i32;
    /// A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
    ///
    /// The first four ratios are from 0 to 1. Shared area over one shape's is 0 if no area is shared, and 1 if the
    /// other shape contains it. The last three are at most the IoU, and at least -1 (CIoU: -2). The angle of a shape in
    /// CIoU is the vector's (half length across its axis, half length along it); v is 0 if a shape has no size.
    /// Exchanging the shapes exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the others. The centre, the
    /// width and the height of a polygon are those of its box.
    ///
    /// Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (ratio is no such constant; the area to
    /// divide by is 0; or, for GIoU, DIoU and CIoU, neither shape has an area).
    ///
    /// Accuracy: computed from the result of vesica_area_f64 or vesica_iou_f64 with at most 8 u of further error, for
    /// half lengths from 2^-200 to 2^200. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale
    /// of two shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u
    /// scale" means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: up to four times vesica_area_f64 or vesica_iou_f64 for boxes; little more than these for ellipses.
    ///
    /// Since: 0.1.
    pub fn vesica_ratio_f64(ratio: i32, kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut f64) -> i32;
    /// A ratio of a\[i\] and b\[i\]: out\[i\] is the result of vesica_ratio_f64.
    ///
    /// Arrays and errors are those of vesica_iou_many_f64. If a pair has no ratio because an area is 0, out\[i\] is
    /// NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.
    ///
    /// Accuracy: every result has the same bits as vesica_ratio_f64, on every instruction set and in every layout.
    ///
    /// Since: 0.1.
    pub fn vesica_ratio_many_f64(ratio: i32, a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64) -> i64;
    /// A ratio of a\[i\] and b\[j\]: out\[i \* row_stride + j\] is the result of vesica_ratio_f64.
    ///
    /// Arrays, row_stride and errors are those of vesica_iou_matrix_f64. If a pair has no ratio because an area is 0,
    /// it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.
    ///
    /// Accuracy: every result has the same bits as vesica_ratio_f64, on every instruction set and in every layout.
    ///
    /// Since: 0.1.
    pub fn vesica_ratio_matrix_f64(ratio: i32, a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64,
        row_stride: isize) -> i64;
    /// How far apart are a\[i\] and b\[j\]? The elements of out are distances of vesica_nearest_f64.
    ///
    /// Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f64.
    ///
    /// Returns: how many pairs overlap (distance 0).
    ///
    /// Errors: as vesica_iou_matrix_f64.
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Since: 0.1.
    pub fn vesica_nearest_matrix_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64,
        row_stride: isize) -> i64;
    /// How far apart are the outlines of a\[i\] and b\[j\]? The elements of out are distances of
    /// vesica_boundary_distance_f64.
    ///
    /// Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f64.
    ///
    /// Returns: how many pairs of outlines meet (distance 0).
    ///
    /// Errors: as vesica_iou_matrix_f64.
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Since: 0.1.
    pub fn vesica_boundary_distance_matrix_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64,
        row_stride: isize) -> i64;
    /// How deep do a\[i\] and b\[j\] overlap? The elements of out are depths of vesica_depth_f64.
    ///
    /// Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f64.
    ///
    /// Returns: how many depths are \> 0.
    ///
    /// Errors: as vesica_iou_matrix_f64.
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout.
    ///
    /// Since: 0.1.
    pub fn vesica_depth_matrix_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64,
        row_stride: isize) -> i64;
    /// Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
    ///
    /// It is the distance of vesica_nearest_f64 if they are disjoint, else minus the depth of vesica_depth_f64: 0 if
    /// they only touch. Exchanging the shapes changes no bit. Polygons that overlap the other shape must be convex,
    /// else the error is VESICA_E_NOT_CONVEX.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the same bits as vesica_nearest_f64 or, negated, vesica_depth_f64. The sign is exact.
    ///
    /// Cost: as vesica_nearest_f64 or vesica_depth_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_signed_distance_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut f64) -> i32;
    /// Signed distances of a\[i\] and b\[i\]. Arrays and errors are those of vesica_iou_many_f64.
    ///
    /// Returns: how many pairs overlap (signed distance \<= 0).
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the same bits as vesica_nearest_f64 or, negated, vesica_depth_f64. The sign is exact.
    ///
    /// Since: 0.1.
    pub fn vesica_signed_distance_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64) -> i64;
    /// Signed distances of a\[i\] and b\[j\]. Arrays, row_stride and errors are those of vesica_iou_matrix_f64.
    ///
    /// Returns: how many pairs overlap (signed distance \<= 0).
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the same bits as vesica_nearest_f64 or, negated, vesica_depth_f64. The sign is exact.
    ///
    /// Since: 0.1.
    pub fn vesica_signed_distance_matrix_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64,
        row_stride: isize) -> i64;
    /// Are two shapes at most `distance` apart? A distance of exactly that counts, as touching does.
    ///
    /// With distance 0 the answer is as of vesica_overlap_f64, exact for all kinds. With distance \< 0 the question is
    /// whether they overlap at least -distance deep, as defined for vesica_depth_f64. So a tolerance of either sign is
    /// one call. With ellipses, test for \> 0 to miss no pair, and for VESICA_WITHIN_YES to accept only what is
    /// certain. Exchanging the shapes changes nothing. A polygon or a polyline is within a distance \>= 0 if one of its
    /// edges is, as a segment, or if the shapes overlap. It is nearly so if no edge is, but one is nearly. For a
    /// distance \< 0 polygons that overlap the other shape must be convex, else the error is VESICA_E_NOT_CONVEX. Their
    /// depth is compared as vesica_depth_f64 rounds it.
    ///
    /// Requires: distance, any number. With infinity the answer is yes for any two valid shapes, with -infinity no.
    ///
    /// Returns: VESICA_WITHIN_NO, VESICA_WITHIN_YES or VESICA_WITHIN_NEARLY.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is NaN), VESICA_E_SHAPE.
    ///
    /// Accuracy: yes and no are always right. Only an ellipse without a half length of 0 may get another answer,
    /// VESICA_WITHIN_NEARLY. With distance \> 0: if the other shape is such an ellipse too, and the distance of
    /// vesica_nearest_f64 differs from the one asked for by at most 5 u scale + 2^-1074. With distance \< 0: if the
    /// other shape is neither a point nor a circle, and the depth differs from -distance by at most 10 u (scale +
    /// |distance|) + 2^-1073, and by the shorter size of each shape whose aspect ratio exceeds 1e6. In bounds on errors
    /// u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
    /// their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
    /// aspect ratio is longer over shorter size.
    ///
    /// Cost: one to six times vesica_overlap_f64; as vesica_nearest_f64 or vesica_depth_f64 for ellipses.
    ///
    /// Since: 0.1.
    pub fn vesica_within_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, distance: f64) -> i32;
    /// Are a\[i\] and b\[i\] at most `distance` apart? out\[i\] is the answer of vesica_within_f64.
    ///
    /// Arrays and errors are those of vesica_overlap_many_f64.
    ///
    /// Requires: distance, any number. With infinity the answer is yes for any two valid shapes, with -infinity no.
    ///
    /// Returns: how many answers are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is NaN), VESICA_E_SHAPE.
    ///
    /// Accuracy: yes and no are always right. Only an ellipse without a half length of 0 may get another answer,
    /// VESICA_WITHIN_NEARLY. With distance \> 0: if the other shape is such an ellipse too, and the distance of
    /// vesica_nearest_f64 differs from the one asked for by at most 5 u scale + 2^-1074. With distance \< 0: if the
    /// other shape is neither a point nor a circle, and the depth differs from -distance by at most 10 u (scale +
    /// |distance|) + 2^-1073, and by the shorter size of each shape whose aspect ratio exceeds 1e6. In bounds on errors
    /// u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
    /// their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
    /// aspect ratio is longer over shorter size.
    ///
    /// Since: 0.1.
    pub fn vesica_within_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, distance: f64, out: *mut u8) -> i64;
    /// Are a\[i\] and b\[j\] at most `distance` apart? out\[i \* row_stride + j\] is the answer of vesica_within_f64.
    ///
    /// Arrays, row_stride and errors are those of vesica_overlap_matrix_f64.
    ///
    /// Requires: distance, any number. With infinity the answer is yes for any two valid shapes, with -infinity no.
    ///
    /// Returns: how many answers are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is NaN), VESICA_E_SHAPE.
    ///
    /// Accuracy: yes and no are always right. Only an ellipse without a half length of 0 may get another answer,
    /// VESICA_WITHIN_NEARLY. With distance \> 0: if the other shape is such an ellipse too, and the distance of
    /// vesica_nearest_f64 differs from the one asked for by at most 5 u scale + 2^-1074. With distance \< 0: if the
    /// other shape is neither a point nor a circle, and the depth differs from -distance by at most 10 u (scale +
    /// |distance|) + 2^-1073, and by the shorter size of each shape whose aspect ratio exceeds 1e6. In bounds on errors
    /// u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
    /// their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
    /// aspect ratio is longer over shorter size.
    ///
    /// Since: 0.1.
    pub fn vesica_within_matrix_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, distance: f64, out: *mut u8,
        row_stride: isize) -> i64;
    /// Greedy non-maximum suppression as vesica_nms_f64, by any ratio, each label on its own.
    ///
    /// Takes shapes in the order of their scores, highest first. Keeps each one whose ratio with every shape kept
    /// before, of the same label, is at most the threshold. Shapes whose score is below least_score are left out.
    ///
    /// Requires: shapes, scores, threshold and scratch as vesica_nms_f64; labels, one for each shape, or NULL if all
    /// are the same; ratio, any but VESICA_RATIO_OVER_FIRST and _OVER_SECOND; least_score, which may be -infinity;
    /// most, the largest number to keep; keep, with room for that number or for all shapes, whichever is less.
    ///
    /// Returns: 0, and keep and \*kept as vesica_nms_f64.
    ///
    /// Errors: as vesica_nms_f64; VESICA_E_ARGUMENT also for ratio, a least_score that is NaN, and a negative most.
    ///
    /// Accuracy: the ratio that is compared is as of vesica_ratio_f64; in float, the ratio rounded to float.
    ///
    /// Cost: as vesica_nms_f64; ratios other than IoU take longer for each comparison.
    ///
    /// Since: 0.1.
    pub fn vesica_suppress_f64(shapes: *const Shapes<f64>, scores: *const f64, labels: *const i32, ratio: i32,
        threshold: f64, least_score: f64, most: i64, scratch: *mut c_void, scratch_size: i64, keep: *mut i64,
        kept: *mut i64) -> i32;
    /// How many bytes of scratch does soft suppression of `count` shapes need?
    ///
    /// Returns: 72 bytes a shape.
    ///
    /// Errors: VESICA_E_ARGUMENT (count is negative or above 2^31 - 1).
    ///
    /// Since: 0.1.
    pub fn vesica_suppress_soft_scratch(count: i64) -> i64;
    /// Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
    ///
    /// Repeats these steps: take the shape with the highest score, of equal ones the first; keep it; lower the score of
    /// each shape not yet kept, of the same label, by `decay` of their ratio. Ends when `most` are kept or every score
    /// left is below least_score. So a shape whose own score is below least_score, such as -infinity, is never kept.
    /// keep\[k\] is the shape kept in step k, and decayed\[k\] the score that it had then.
    ///
    /// Requires: shapes, scores and labels as vesica_suppress_f64; ratio, any but VESICA_RATIO_OVER_FIRST and
    /// _OVER_SECOND; decay, VESICA_DECAY_LINEAR or _GAUSSIAN, with its parameter; least_score \>= 0; scratch of at
    /// least vesica_suppress_soft_scratch(count) bytes, aligned to 8; keep and decayed with room for `most` numbers or
    /// for all shapes, whichever is less.
    ///
    /// Returns: 0, with \*kept set to how many are kept.
    ///
    /// Errors: as vesica_suppress_f64. VESICA_E_SHAPE: an invalid shape, or one whose score is NaN, is left out, and
    /// the result of the others is written.
    ///
    /// Accuracy: in every step a score is multiplied once, in double, by 1 - r, rounded once, or by the exponential,
    /// right to 1 unit in the last place; times 0 an infinite score is 0. So the same shapes are kept, with the same
    /// bits, on every machine. The float function computes in double and rounds only the final scores.
    ///
    /// Cost: for each kept shape, as vesica_ratio_matrix_f64 with the shapes of its label that are left.
    ///
    /// Since: 0.1.
    pub fn vesica_suppress_soft_f64(shapes: *const Shapes<f64>, scores: *const f64, labels: *const i32, ratio: i32,
        decay: i32, parameter: f64, least_score: f64, most: i64, scratch: *mut c_void, scratch_size: i64,
        keep: *mut i64, decayed: *mut f64, kept: *mut i64) -> i32;
    /// The share of each cell that a shape covers: out\[j \* row_stride + i\] is area covered / area of cell (i, j).
    ///
    /// Shares are from 0 to 1. Points, segments and polylines cover nothing. A ring is the difference of two discs'
    /// shares.
    ///
    /// Requires: grid with dx \> 0 and dy \> 0; out, room for the rows, row_stride elements apart, at least `columns`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (the grid, or rows that overlap),
    /// VESICA_E_RANGE (a part of the shape is more than 2^44 cells from the corner of the grid). Nothing is written.
    ///
    /// Accuracy: cells inside have 1 and cells outside 0, exactly, unless the outline is within 4 u times the largest
    /// coordinate of the shape and of the grid's corner. Other shares are right to 16 u, and what such a displacement
    /// of the outline adds. Polygons must be simple, and the error is for each edge in the cell. In bounds on errors u
    /// is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
    /// their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
    /// aspect ratio is longer over shorter size.
    ///
    /// Cost: a small multiple of writing the cells, and about that of an overlap for each cell on the outline.
    ///
    /// Since: 0.1.
    pub fn vesica_coverage_f64(kind: i32, shape: *const c_void, grid: *const Grid<f64>, out: *mut f64,
        row_stride: isize) -> i32;
    /// The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f64 has them.
    ///
    /// cells\[k\] is the number of a cell, j \* columns + i. Each cell is named once, in no particular order.
    ///
    /// Requires: grid as vesica_coverage_f64; cells and shares, room for `capacity` each.
    ///
    /// Returns: the number of such cells. If it exceeds capacity, only the first `capacity` are written.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (the grid, or capacity \< 0),
    /// VESICA_E_RANGE.
    ///
    /// Accuracy: as vesica_coverage_f64.
    ///
    /// Cost: as vesica_coverage_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_coverage_cells_f64(kind: i32, shape: *const c_void, grid: *const Grid<f64>, cells: *mut i64,
        shares: *mut f64, capacity: i64) -> i64;
    /// A ratio by which detections are compared: IoU and its relatives, as `ratio` says.
    ///
    /// The first four ratios are from 0 to 1. Shared area over one shape's is 0 if no area is shared, and 1 if the
    /// other shape contains it. The last three are at most the IoU, and at least -1 (CIoU: -2). The angle of a shape in
    /// CIoU is the vector's (half length across its axis, half length along it); v is 0 if a shape has no size.
    /// Exchanging the shapes exchanges OVER_FIRST and OVER_SECOND, and changes no bit of the others. The centre, the
    /// width and the height of a polygon are those of its box.
    ///
    /// Requires: ratio, one of VESICA_RATIO_OVER_UNION to VESICA_RATIO_COMPLETE.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (ratio is no such constant; the area to
    /// divide by is 0; or, for GIoU, DIoU and CIoU, neither shape has an area).
    ///
    /// Accuracy: computed from the result of vesica_area_f32 or vesica_iou_f32 with at most 8 u of further error, for
    /// half lengths from 2^-200 to 2^200. Each number is computed in double, within these bounds, and then rounded to
    /// float once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the
    /// largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale" means an error of
    /// at most 4 u times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: up to four times vesica_area_f32 or vesica_iou_f32 for boxes; little more than these for ellipses.
    ///
    /// Since: 0.1.
    pub fn vesica_ratio_f32(ratio: i32, kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut f32) -> i32;
    /// A ratio of a\[i\] and b\[i\]: out\[i\] is the result of vesica_ratio_f32.
    ///
    /// Arrays and errors are those of vesica_iou_many_f32. If a pair has no ratio because an area is 0, out\[i\] is
    /// NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.
    ///
    /// Accuracy: every result has the same bits as vesica_ratio_f32, on every instruction set and in every layout.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_ratio_many_f32(ratio: i32, a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32) -> i64;
    /// A ratio of a\[i\] and b\[j\]: out\[i \* row_stride + j\] is the result of vesica_ratio_f32.
    ///
    /// Arrays, row_stride and errors are those of vesica_iou_matrix_f32. If a pair has no ratio because an area is 0,
    /// it gets NaN, and the call returns VESICA_E_ARGUMENT unless a shape is invalid.
    ///
    /// Returns: how many are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT.
    ///
    /// Accuracy: every result has the same bits as vesica_ratio_f32, on every instruction set and in every layout.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_ratio_matrix_f32(ratio: i32, a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32,
        row_stride: isize) -> i64;
    /// How far apart are a\[i\] and b\[j\]? The elements of out are distances of vesica_nearest_f32.
    ///
    /// Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f32.
    ///
    /// Returns: how many pairs overlap (distance 0).
    ///
    /// Errors: as vesica_iou_matrix_f32.
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout. Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_nearest_matrix_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32,
        row_stride: isize) -> i64;
    /// How far apart are the outlines of a\[i\] and b\[j\]? The elements of out are distances of
    /// vesica_boundary_distance_f32.
    ///
    /// Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f32.
    ///
    /// Returns: how many pairs of outlines meet (distance 0).
    ///
    /// Errors: as vesica_iou_matrix_f32.
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout. Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_boundary_distance_matrix_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32,
        row_stride: isize) -> i64;
    /// How deep do a\[i\] and b\[j\] overlap? The elements of out are depths of vesica_depth_f32.
    ///
    /// Requires: room for a matrix, and row_stride, as vesica_iou_matrix_f32.
    ///
    /// Returns: how many depths are \> 0.
    ///
    /// Errors: as vesica_iou_matrix_f32.
    ///
    /// Accuracy: every result has the same bits as the function for two shapes, on every instruction set, in every
    /// layout. Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_depth_matrix_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32,
        row_stride: isize) -> i64;
    /// Greedy non-maximum suppression as vesica_nms_f32, by any ratio, each label on its own.
    ///
    /// Takes shapes in the order of their scores, highest first. Keeps each one whose ratio with every shape kept
    /// before, of the same label, is at most the threshold. Shapes whose score is below least_score are left out.
    ///
    /// Requires: shapes, scores, threshold and scratch as vesica_nms_f32; labels, one for each shape, or NULL if all
    /// are the same; ratio, any but VESICA_RATIO_OVER_FIRST and _OVER_SECOND; least_score, which may be -infinity;
    /// most, the largest number to keep; keep, with room for that number or for all shapes, whichever is less.
    ///
    /// Returns: 0, and keep and \*kept as vesica_nms_f32.
    ///
    /// Errors: as vesica_nms_f32; VESICA_E_ARGUMENT also for ratio, a least_score that is NaN, and a negative most.
    ///
    /// Accuracy: the ratio that is compared is as of vesica_ratio_f32; in float, the ratio rounded to float.
    ///
    /// Cost: as vesica_nms_f32; ratios other than IoU take longer for each comparison.
    ///
    /// Since: 0.1.
    pub fn vesica_suppress_f32(shapes: *const Shapes<f32>, scores: *const f32, labels: *const i32, ratio: i32,
        threshold: f32, least_score: f32, most: i64, scratch: *mut c_void, scratch_size: i64, keep: *mut i64,
        kept: *mut i64) -> i32;
    /// Signed distance: how far apart are two shapes or, as a negative number, how deep do they overlap?
    ///
    /// It is the distance of vesica_nearest_f32 if they are disjoint, else minus the depth of vesica_depth_f32: 0 if
    /// they only touch. Exchanging the shapes changes no bit. Polygons that overlap the other shape must be convex,
    /// else the error is VESICA_E_NOT_CONVEX.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the same bits as vesica_nearest_f32 or, negated, vesica_depth_f32. The sign is exact.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Cost: as vesica_nearest_f32 or vesica_depth_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_signed_distance_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut f32) -> i32;
    /// Signed distances of a\[i\] and b\[i\]. Arrays and errors are those of vesica_iou_many_f32.
    ///
    /// Returns: how many pairs overlap (signed distance \<= 0).
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the same bits as vesica_nearest_f32 or, negated, vesica_depth_f32. The sign is exact.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_signed_distance_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32) -> i64;
    /// Signed distances of a\[i\] and b\[j\]. Arrays, row_stride and errors are those of vesica_iou_matrix_f32.
    ///
    /// Returns: how many pairs overlap (signed distance \<= 0).
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_RANGE.
    ///
    /// Accuracy: the same bits as vesica_nearest_f32 or, negated, vesica_depth_f32. The sign is exact.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Since: 0.1.
    pub fn vesica_signed_distance_matrix_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32,
        row_stride: isize) -> i64;
    /// Are two shapes at most `distance` apart? A distance of exactly that counts, as touching does.
    ///
    /// With distance 0 the answer is as of vesica_overlap_f32, exact for all kinds. With distance \< 0 the question is
    /// whether they overlap at least -distance deep, as defined for vesica_depth_f32. So a tolerance of either sign is
    /// one call. With ellipses, test for \> 0 to miss no pair, and for VESICA_WITHIN_YES to accept only what is
    /// certain. Exchanging the shapes changes nothing. A polygon or a polyline is within a distance \>= 0 if one of its
    /// edges is, as a segment, or if the shapes overlap. It is nearly so if no edge is, but one is nearly. For a
    /// distance \< 0 polygons that overlap the other shape must be convex, else the error is VESICA_E_NOT_CONVEX. Their
    /// depth is compared as vesica_depth_f32 rounds it.
    ///
    /// Requires: distance, any number. With infinity the answer is yes for any two valid shapes, with -infinity no.
    ///
    /// Returns: VESICA_WITHIN_NO, VESICA_WITHIN_YES or VESICA_WITHIN_NEARLY.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is NaN), VESICA_E_SHAPE.
    ///
    /// Accuracy: yes and no are always right. Only an ellipse without a half length of 0 may get another answer,
    /// VESICA_WITHIN_NEARLY. With distance \> 0: if the other shape is such an ellipse too, and the distance of
    /// vesica_nearest_f32 differs from the one asked for by at most 5 u scale + 2^-1074. With distance \< 0: if the
    /// other shape is neither a point nor a circle, and the depth differs from -distance by at most 10 u (scale +
    /// |distance|) + 2^-1073, and by the shorter size of each shape whose aspect ratio exceeds 1e6. In bounds on errors
    /// u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
    /// their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
    /// aspect ratio is longer over shorter size.
    ///
    /// Cost: one to six times vesica_overlap_f32; as vesica_nearest_f32 or vesica_depth_f32 for ellipses.
    ///
    /// Since: 0.1.
    pub fn vesica_within_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, distance: f32) -> i32;
    /// Are a\[i\] and b\[i\] at most `distance` apart? out\[i\] is the answer of vesica_within_f32.
    ///
    /// Arrays and errors are those of vesica_overlap_many_f32.
    ///
    /// Requires: distance, any number. With infinity the answer is yes for any two valid shapes, with -infinity no.
    ///
    /// Returns: how many answers are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is NaN), VESICA_E_SHAPE.
    ///
    /// Accuracy: yes and no are always right. Only an ellipse without a half length of 0 may get another answer,
    /// VESICA_WITHIN_NEARLY. With distance \> 0: if the other shape is such an ellipse too, and the distance of
    /// vesica_nearest_f32 differs from the one asked for by at most 5 u scale + 2^-1074. With distance \< 0: if the
    /// other shape is neither a point nor a circle, and the depth differs from -distance by at most 10 u (scale +
    /// |distance|) + 2^-1073, and by the shorter size of each shape whose aspect ratio exceeds 1e6. In bounds on errors
    /// u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
    /// their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
    /// aspect ratio is longer over shorter size.
    ///
    /// Since: 0.1.
    pub fn vesica_within_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, distance: f32, out: *mut u8) -> i64;
    /// Are a\[i\] and b\[j\] at most `distance` apart? out\[i \* row_stride + j\] is the answer of vesica_within_f32.
    ///
    /// Arrays, row_stride and errors are those of vesica_overlap_matrix_f32.
    ///
    /// Requires: distance, any number. With infinity the answer is yes for any two valid shapes, with -infinity no.
    ///
    /// Returns: how many answers are \> 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (distance is NaN), VESICA_E_SHAPE.
    ///
    /// Accuracy: yes and no are always right. Only an ellipse without a half length of 0 may get another answer,
    /// VESICA_WITHIN_NEARLY. With distance \> 0: if the other shape is such an ellipse too, and the distance of
    /// vesica_nearest_f32 differs from the one asked for by at most 5 u scale + 2^-1074. With distance \< 0: if the
    /// other shape is neither a point nor a circle, and the depth differs from -distance by at most 10 u (scale +
    /// |distance|) + 2^-1073, and by the shorter size of each shape whose aspect ratio exceeds 1e6. In bounds on errors
    /// u is 2^-53, half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between
    /// their centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An
    /// aspect ratio is longer over shorter size.
    ///
    /// Since: 0.1.
    pub fn vesica_within_matrix_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, distance: f32, out: *mut u8,
        row_stride: isize) -> i64;
    /// Soft suppression (soft-NMS): a shape that a better one covers is not dropped, but gets a lower score.
    ///
    /// Repeats these steps: take the shape with the highest score, of equal ones the first; keep it; lower the score of
    /// each shape not yet kept, of the same label, by `decay` of their ratio. Ends when `most` are kept or every score
    /// left is below least_score. So a shape whose own score is below least_score, such as -infinity, is never kept.
    /// keep\[k\] is the shape kept in step k, and decayed\[k\] the score that it had then.
    ///
    /// Requires: shapes, scores and labels as vesica_suppress_f32; ratio, any but VESICA_RATIO_OVER_FIRST and
    /// _OVER_SECOND; decay, VESICA_DECAY_LINEAR or _GAUSSIAN, with its parameter; least_score \>= 0; scratch of at
    /// least vesica_suppress_soft_scratch(count) bytes, aligned to 8; keep and decayed with room for `most` numbers or
    /// for all shapes, whichever is less.
    ///
    /// Returns: 0, with \*kept set to how many are kept.
    ///
    /// Errors: as vesica_suppress_f32. VESICA_E_SHAPE: an invalid shape, or one whose score is NaN, is left out, and
    /// the result of the others is written.
    ///
    /// Accuracy: in every step a score is multiplied once, in double, by 1 - r, rounded once, or by the exponential,
    /// right to 1 unit in the last place; times 0 an infinite score is 0. So the same shapes are kept, with the same
    /// bits, on every machine. The float function computes in double and rounds only the final scores.
    ///
    /// Cost: for each kept shape, as vesica_ratio_matrix_f32 with the shapes of its label that are left.
    ///
    /// Since: 0.1.
    pub fn vesica_suppress_soft_f32(shapes: *const Shapes<f32>, scores: *const f32, labels: *const i32, ratio: i32,
        decay: i32, parameter: f32, least_score: f32, most: i64, scratch: *mut c_void, scratch_size: i64,
        keep: *mut i64, decayed: *mut f32, kept: *mut i64) -> i32;
    /// The share of each cell that a shape covers: out\[j \* row_stride + i\] is area covered / area of cell (i, j).
    ///
    /// Shares are from 0 to 1. Points, segments and polylines cover nothing. A ring is the difference of two discs'
    /// shares.
    ///
    /// Requires: grid with dx \> 0 and dy \> 0; out, room for the rows, row_stride elements apart, at least `columns`.
    ///
    /// Returns: 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (the grid, or rows that overlap),
    /// VESICA_E_RANGE (a part of the shape is more than 2^44 cells from the corner of the grid). Nothing is written.
    ///
    /// Accuracy: cells inside have 1 and cells outside 0, exactly, unless the outline is within 4 u times the largest
    /// coordinate of the shape and of the grid's corner. Other shares are right to 16 u, and what such a displacement
    /// of the outline adds. Polygons must be simple, and the error is for each edge in the cell. Each number is
    /// computed in double, within these bounds, and then rounded to float once. In bounds on errors u is 2^-53, half a
    /// unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and
    /// of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is
    /// longer over shorter size.
    ///
    /// Cost: a small multiple of writing the cells, and about that of an overlap for each cell on the outline.
    ///
    /// Since: 0.1.
    pub fn vesica_coverage_f32(kind: i32, shape: *const c_void, grid: *const Grid<f32>, out: *mut f32,
        row_stride: isize) -> i32;
    /// The cells of which a shape covers more than nothing, and their shares, as vesica_coverage_f32 has them.
    ///
    /// cells\[k\] is the number of a cell, j \* columns + i. Each cell is named once, in no particular order.
    ///
    /// Requires: grid as vesica_coverage_f32; cells and shares, room for `capacity` each.
    ///
    /// Returns: the number of such cells. If it exceeds capacity, only the first `capacity` are written.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_ARGUMENT (the grid, or capacity \< 0),
    /// VESICA_E_RANGE.
    ///
    /// Accuracy: as vesica_coverage_f32.
    /// Each number is computed in double, within these bounds, and then rounded to float once.
    ///
    /// Cost: as vesica_coverage_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_coverage_cells_f32(kind: i32, shape: *const c_void, grid: *const Grid<f32>, cells: *mut i64,
        shares: *mut f32, capacity: i64) -> i64;
    /// Does b touch a while it moves, when first, and where?
    ///
    /// The normal belongs to the face or the round outline that is hit. If a corner hits a corner, it belongs to an
    /// edge there. If b only slides along a, it is perpendicular to the velocity. At an angle below 2^-80 to a face,
    /// the normal may belong to the face beside it, and the point their corner. If two faces meet, the point is the
    /// middle of what they share. Shapes that overlap at the start have t = 0, the direction of vesica_depth_f64 and
    /// the point of vesica_nearest_f64. Shapes that only touch at the start move apart or slide if (nx, ny).(vx, vy)
    /// \>= 0. Otherwise they approach, but where corners meet, or a shape has no area, they may also separate.
    /// Exchanging the shapes and reversing the velocity changes neither the answer nor the time. It reverses the
    /// normal, up to rounding. A polygon or polyline is hit as the first of its edges is. Of several edges hit at one
    /// time, one hit from the front counts before one that b slides along. If it overlaps at the start and both shapes
    /// are convex, the normal is as said above. Otherwise it is that of the overlapping edge that b moves into most
    /// directly, or (0, 0) if no edge overlaps.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a velocity that is not finite, a t_end that is negative
    /// or NaN), VESICA_E_SHAPE, VESICA_E_RANGE (the time, or a coordinate of the point, would overflow; or an exact
    /// position would take more than 2000 bits, as with magnitudes of both 2^1000 and 2^-1000).
    ///
    /// Accuracy: the answer is exact, and the time is rounded down. The point is within 8 u scale of a's outline before
    /// it is rounded; along the outline it may be off by (8 u scale + 4 u R) / |n.v|, n and v of unit length, R the
    /// greatest radius of curvature of a: of an ellipse its long half length squared over the short one, far more than
    /// its size if it is thin. The normal has length 1 to 4 u. In bounds on errors u is 2^-53, half a unit in the last
    /// place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
    /// lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over
    /// shorter size.
    ///
    /// Cost: a small multiple of vesica_overlap_f64 for a miss, ten times that for a hit. Rays (b a point), two circles
    /// and two ellipses take less. For polygons, a few comparisons an edge, and a cast for each edge in the swept box.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32;
    /// When and where does b\[i\], moved by t (vx\[i\], vy\[i\]), touch a\[i\]? The columns are the fields of
    /// vesica_cast_f64's result.
    ///
    /// Velocity i is `i \* stride` bytes after vx and vy; stride 0 repeats one velocity.
    ///
    /// Requires: velocities and t_end as vesica_cast_f64; equal counts, or one count of 1, whose shape is used for all.
    /// Each output has room for as many numbers as the larger count. Some, but not all, may be NULL. vx and vy need no
    /// alignment; without pairs they may be NULL.
    ///
    /// Returns: how many touch, including those that overlap at the start.
    ///
    /// Errors: those of vesica_cast_f64. An element with an invalid shape, a velocity that is not finite or a result
    /// out of range gets NaN for all its numbers, and all others are written as usual. The call then returns
    /// VESICA_E_SHAPE if a shape is invalid, else the error of the last such element.
    ///
    /// Accuracy: every result has the same bits as vesica_cast_f64.
    ///
    /// Cost: as vesica_cast_f64 for each pair; with AVX2 or AVX-512 a half to an eighth of it, except for pairs that
    /// overlap at the start.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, vx: *const f64, vy: *const f64,
        stride: isize, t_end: f64, t: *mut f64, x: *mut f64, y: *mut f64, nx: *mut f64, ny: *mut f64) -> i64;
    /// Which of many shapes at rest does one moving shape touch first? If several are touched at that time, the one
    /// with the lowest index.
    ///
    /// Requires: one, the shape that moves, an array of count 1; vx, vy and t_end as vesica_cast_f64.
    ///
    /// Returns: its index, or the count of `many` if none is touched. \*out is its contact, the normal pointing to
    /// `one`.
    ///
    /// Errors: those of vesica_cast_f64. VESICA_E_SHAPE if any shape is invalid. VESICA_E_RANGE only if vesica_cast_f64
    /// returns it for a shape that might be touched first.
    ///
    /// Cost: less than vesica_cast_f64 for each shape that is missed.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_first_f64(one: *const Shapes<f64>, many: *const Shapes<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i64;
    /// A box that holds a shape throughout its motion, t from 0 to t_end. The shape touches nothing outside it.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: 0.
    ///
    /// Errors: those of vesica_cast_f64; VESICA_E_RANGE if a side would overflow.
    ///
    /// Accuracy: a side that does not move is as of vesica_bounds_f64. One that moves is too far out by less than 5.5
    /// units in the last place of the largest of three numbers: the side at rest, the way it moves, and where it ends.
    ///
    /// Since: 0.1.
    pub fn vesica_sweep_bounds_f64(kind: i32, shape: *const c_void, vx: f64, vy: f64, t_end: f64,
        out: *mut Aabb<f64>) -> i32;
    /// Which items of an index does one moving shape touch? They come in the index's order.
    ///
    /// Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f64. out has
    /// room for `capacity` items. With capacity 0, out and state may be NULL.
    ///
    /// Returns: the number of items written; with capacity 0, how many there are. If state\[0\] is not -1 then, there
    /// are more, and the same call continues (vesica_index.h).
    ///
    /// Errors: those of vesica_cast_f64, and VESICA_E_INDEX; VESICA_E_ARGUMENT also for sets of another number of items
    /// than the index, a pointer that is not aligned, or a state from another function (vesica_index.h). VESICA_E_RANGE
    /// only if an item is undecided, because its exact position at t_end would take more than 2000 bits. Then nothing
    /// is written, the state is behind that item, and the same call continues; with capacity 0 there is no count.
    /// Invalid items are never touched.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a search, and vesica_cast_f64 for each item whose box the swept box meets.
    ///
    /// Since: 0.1.
    pub fn vesica_index_cast_f64(index: *const c_void, sets: *const Shapes<f64>, set_count: i32,
        one: *const Shapes<f64>, vx: f64, vy: f64, t_end: f64, out: *mut i64, capacity: i64, state: *mut i64) -> i64;
    /// Which item of an index does one moving shape touch first? If several are touched at that time, the lowest item.
    ///
    /// Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f64.
    ///
    /// Returns: the item, or the index's count if none is touched. \*out is its contact, the normal pointing to `one`.
    ///
    /// Errors: those of vesica_index_cast_f64; VESICA_E_RANGE only as for vesica_cast_first_f64.
    ///
    /// Cost: a search, and vesica_cast_f64 for the few items near the ray.
    ///
    /// Since: 0.1.
    pub fn vesica_index_cast_first_f64(index: *const c_void, sets: *const Shapes<f64>, set_count: i32,
        one: *const Shapes<f64>, vx: f64, vy: f64, t_end: f64, out: *mut Impact<f64>) -> i64;
    /// When do two shapes that move and turn touch first? It is proved that there is no contact before t, however thin
    /// the shapes are and however fast they turn.
    ///
    /// At t, from 0 to 1, a centre has moved by t (vx, vy) and an axis has turned by t times the angle, without
    /// rounding. \*out describes that moment: the point of a that is nearest to b, and the normal that separates them.
    /// They are then at most \*gap apart. A polygon must be convex, and its centre is the middle of its bounds, each
    /// coordinate rounded to a double; a path on one line is a segment.
    ///
    /// Requires: numbers of turn_a and turn_b finite, angles at most 2^20 in magnitude; tolerance, a length \> 0. No
    /// pointer may be NULL.
    ///
    /// Returns: VESICA_CAST_MISS: it is proved that there is no contact from 0 to 1; t is infinity, and all other
    /// numbers and the gap are NaN. VESICA_CAST_HIT: it is proved that there is contact after t. VESICA_CAST_NEAR:
    /// there may be contact after t; contact of a point with a segment or a point, where there is no depth, is never
    /// proved. VESICA_CAST_START: the shapes overlap at t = 0, which is exact; \*out is as of vesica_cast_f64, and the
    /// gap is 0.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_NOT_CONVEX, VESICA_E_RANGE (a
    /// coordinate of the point, or the gap, would overflow).
    ///
    /// Accuracy: what is said to be proved is certain. The gap is at most the tolerance, except in two cases: the
    /// tolerance is below (300 + 10 |angles|) u times the sum of all lengths, the motion's included, u = 2^-53; or the
    /// search stopped after 256 directions or 4096 poses. Angles above 10^5 often stop it: then only the gap says that
    /// it exceeds the tolerance, so compare them.
    ///
    /// Cost: a small multiple of vesica_cast_f64; a thousand times that at angles of 10^6 radians. For two polygons it
    /// grows with the product of their numbers of vertices.
    ///
    /// Since: 0.1.
    pub fn vesica_impact_time_f64(kind_a: i32, a: *const c_void, turn_a: *const Turn<f64>, kind_b: i32,
        b: *const c_void, turn_b: *const Turn<f64>, tolerance: f64, out: *mut Impact<f64>, gap: *mut f64) -> i32;
    /// Which item of an index does a shape that moves and turns touch first? It is proved that there is no contact with
    /// any item before t.
    ///
    /// The items are at rest. Each is asked as by vesica_impact_time_f64, the item as a and `one` as b; the one with
    /// the least t counts, and of several the lowest. \*out, \*gap and \*answer are its results. Items are not asked if
    /// they stay farther than the tolerance from all places of `one`, nor if they are first that near after t.
    ///
    /// Requires: sets are those of the index. one, an array of count 1; turn and tolerance as for
    /// vesica_impact_time_f64.
    ///
    /// Returns: the item, with \*answer VESICA_CAST_HIT, _NEAR or _START; or the index's count, with VESICA_CAST_MISS.
    ///
    /// Errors: those of vesica_index_cast_f64; VESICA_E_RANGE, and VESICA_E_NOT_CONVEX of a polygon in the index, only
    /// for an item that might be touched first.
    ///
    /// Cost: a search, and vesica_impact_time_f64 for the items near the way.
    ///
    /// Since: 0.1.
    pub fn vesica_index_impact_time_f64(index: *const c_void, sets: *const Shapes<f64>, set_count: i32,
        one: *const Shapes<f64>, turn: *const Turn<f64>, tolerance: f64, out: *mut Impact<f64>, gap: *mut f64,
        answer: *mut i32) -> i64;
    /// Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
    ///
    /// The normal is the direction of vesica_depth_f64, and the greatest depth is its depth. The facing edge of a is
    /// the edge whose outward normal is nearest to (nx, ny), and that of b the one whose outward normal is nearest to
    /// the opposite. Edges of capsules and rounded rectangles are those of the core, moved along the normal by the
    /// radius. Seen along the normal, both edges are intervals. The contacts are at both ends of what the intervals
    /// share, in the order of the normal turned counter-clockwise by a right angle. The depth there is how far a's edge
    /// is beyond b's along the normal, and the point is midway. If a depth is below 0, that contact is left out. There
    /// is one contact if one shape has no edge (a point, a circle, an ellipse, a shape without a size), if the
    /// intervals share no more than e, or if a depth is below -e; between that and 0 it is 0. Otherwise there are two.
    /// e is about 2^-47 scale, which is rounding. As a box tilts, its second depth falls to 0 before its contact is
    /// left out; as it slides off an edge, both contacts become one place. So no threshold decides what is parallel.
    /// Where another edge, or another normal, becomes the nearest, the normal, the numbers and the lesser contact may
    /// jump; the greatest depth never does. a0 and b0 are the numbers of the vertices at which the facing edges end on
    /// contact 0's side. So they stay while the same edges face each other, whichever is the longer. An edge beside a
    /// shape without one has the number of its first vertex counter-clockwise, and a shape without an edge 0. Vertices
    /// of polygons count as stored. Edges on one line, to e, are one edge, and a vertex that is repeated has one of its
    /// numbers. Vertices of an AABB, a rectangle and a rounded one count from (-hx, -hy) in its frame: (hx, -hy) is 1,
    /// (hx, hy) 2, as in vesica_corners_of_shapes_f64. A segment and a capsule begin at vertex 0. So does a polygon or
    /// polyline on one line, at its leftmost vertex. An ellipse with a half length of 0 counts as a rectangle.
    /// Exchanging the shapes reverses the normal, the numbers and the order, and changes no other bit, except for two
    /// equal shapes in one place. Moving both alike changes no depth if no coordinate is rounded. For contacts before
    /// the shapes touch, give them a radius: round_rect in place of rect. Then subtract both radii.
    ///
    /// Returns: the count; 0 for disjoint shapes.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_NOT_CONVEX, VESICA_E_RANGE (a depth or a
    /// coordinate would overflow).
    ///
    /// Accuracy: the normal and the greatest depth have the bits of vesica_depth_f64. The lesser depth and the points
    /// are right to 16 u scale (1 + s), where s is the slope of the steeper edge against the line across the normal, at
    /// most 1 where corners have 90 degrees or more; the points also to 16 u of their coordinates and the radii. To
    /// that comes 4 e where edges were joined, or where a depth below 0 has become 0. In bounds on errors u is 2^-53,
    /// half a unit in the last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their
    /// centres and of their half lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect
    /// ratio is longer over shorter size.
    ///
    /// Cost: one and a half to three times vesica_depth_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_manifold_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut Contacts<f64>) -> i32;
    /// The contacts of a\[i\] and b\[i\].
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. out has room for as many manifolds as
    /// the larger count.
    ///
    /// Returns: how many pairs have a contact.
    ///
    /// Errors: also VESICA_E_ARGUMENT, as vesica_depth_many_f64. A pair with an error has that error for its count, and
    /// 0 for all else; the others are written as usual. The call then returns VESICA_E_SHAPE if a shape is invalid,
    /// else the error of the last such pair.
    ///
    /// Accuracy: every result has the same bits as vesica_manifold_f64.
    ///
    /// Cost: as vesica_manifold_f64 for each pair.
    ///
    /// Since: 0.1.
    pub fn vesica_manifold_many_f64(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut Contacts<f64>) -> i64;
    /// A ray at a point.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
    ///
    /// Accuracy: as vesica_cast_f64.
    ///
    /// Cost: as vesica_overlap_f64 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_point_point_f64(a: *const Point<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32;
    /// A ray at a segment.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
    ///
    /// Accuracy: as vesica_cast_f64.
    ///
    /// Cost: as vesica_overlap_f64 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_segment_point_f64(a: *const Segment<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32;
    /// A ray at a disc.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
    ///
    /// Accuracy: as vesica_cast_f64.
    ///
    /// Cost: as vesica_overlap_f64 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_circle_point_f64(a: *const Circle<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32;
    /// A ray at an axis-aligned box.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
    ///
    /// Accuracy: as vesica_cast_f64.
    ///
    /// Cost: as vesica_overlap_f64 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_aabb_point_f64(a: *const Aabb<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32;
    /// A ray at a rectangle.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
    ///
    /// Accuracy: as vesica_cast_f64.
    ///
    /// Cost: as vesica_overlap_f64 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_rect_point_f64(a: *const Rect<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32;
    /// A ray at an ellipse.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
    ///
    /// Accuracy: as vesica_cast_f64.
    ///
    /// Cost: as vesica_overlap_f64 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_ellipse_point_f64(a: *const Ellipse<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32;
    /// Two discs.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
    ///
    /// Accuracy: as vesica_cast_f64.
    ///
    /// Cost: as vesica_overlap_f64 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_circle_circle_f64(a: *const Circle<f64>, b: *const Circle<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32;
    /// Two rectangles.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f64.
    ///
    /// Accuracy: as vesica_cast_f64.
    ///
    /// Cost: as vesica_overlap_f64 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f64.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_rect_rect_f64(a: *const Rect<f64>, b: *const Rect<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32;
    /// Does b touch a while it moves, when first, and where?
    ///
    /// The normal belongs to the face or the round outline that is hit. If a corner hits a corner, it belongs to an
    /// edge there. If b only slides along a, it is perpendicular to the velocity. At an angle below 2^-80 to a face,
    /// the normal may belong to the face beside it, and the point their corner. If two faces meet, the point is the
    /// middle of what they share. Shapes that overlap at the start have t = 0, the direction of vesica_depth_f32 and
    /// the point of vesica_nearest_f32. Shapes that only touch at the start move apart or slide if (nx, ny).(vx, vy)
    /// \>= 0. Otherwise they approach, but where corners meet, or a shape has no area, they may also separate.
    /// Exchanging the shapes and reversing the velocity changes neither the answer nor the time. It reverses the
    /// normal, up to rounding. A polygon or polyline is hit as the first of its edges is. Of several edges hit at one
    /// time, one hit from the front counts before one that b slides along. If it overlaps at the start and both shapes
    /// are convex, the normal is as said above. Otherwise it is that of the overlapping edge that b moves into most
    /// directly, or (0, 0) if no edge overlaps.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_ARGUMENT (a velocity that is not finite, a t_end that is negative
    /// or NaN), VESICA_E_SHAPE, VESICA_E_RANGE (the time, or a coordinate of the point, would overflow; or an exact
    /// position would take more than 2000 bits, as with magnitudes of both 2^1000 and 2^-1000).
    ///
    /// Accuracy: the answer is exact, and the time is rounded down. The point is within 8 u scale of a's outline before
    /// it is rounded; along the outline it may be off by (8 u scale + 4 u R) / |n.v|, n and v of unit length, R the
    /// greatest radius of curvature of a: of an ellipse its long half length squared over the short one, far more than
    /// its size if it is thin. The normal has length 1 to 4 u. In bounds on errors u is 2^-53, half a unit in the last
    /// place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
    /// lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over
    /// shorter size.
    ///
    /// Cost: a small multiple of vesica_overlap_f32 for a miss, ten times that for a hit. Rays (b a point), two circles
    /// and two ellipses take less. For polygons, a few comparisons an edge, and a cast for each edge in the swept box.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32;
    /// When and where does b\[i\], moved by t (vx\[i\], vy\[i\]), touch a\[i\]? The columns are the fields of
    /// vesica_cast_f32's result.
    ///
    /// Velocity i is `i \* stride` bytes after vx and vy; stride 0 repeats one velocity.
    ///
    /// Requires: velocities and t_end as vesica_cast_f32; equal counts, or one count of 1, whose shape is used for all.
    /// Each output has room for as many numbers as the larger count. Some, but not all, may be NULL. vx and vy need no
    /// alignment; without pairs they may be NULL.
    ///
    /// Returns: how many touch, including those that overlap at the start.
    ///
    /// Errors: those of vesica_cast_f32. An element with an invalid shape, a velocity that is not finite or a result
    /// out of range gets NaN for all its numbers, and all others are written as usual. The call then returns
    /// VESICA_E_SHAPE if a shape is invalid, else the error of the last such element.
    ///
    /// Accuracy: every result has the same bits as vesica_cast_f32.
    ///
    /// Cost: as vesica_cast_f32 for each pair; with AVX2 or AVX-512 a half to an eighth of it, except for pairs that
    /// overlap at the start.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, vx: *const f32, vy: *const f32,
        stride: isize, t_end: f32, t: *mut f32, x: *mut f32, y: *mut f32, nx: *mut f32, ny: *mut f32) -> i64;
    /// Which of many shapes at rest does one moving shape touch first? If several are touched at that time, the one
    /// with the lowest index.
    ///
    /// Requires: one, the shape that moves, an array of count 1; vx, vy and t_end as vesica_cast_f32.
    ///
    /// Returns: its index, or the count of `many` if none is touched. \*out is its contact, the normal pointing to
    /// `one`.
    ///
    /// Errors: those of vesica_cast_f32. VESICA_E_SHAPE if any shape is invalid. VESICA_E_RANGE only if vesica_cast_f32
    /// returns it for a shape that might be touched first.
    ///
    /// Cost: less than vesica_cast_f32 for each shape that is missed.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_first_f32(one: *const Shapes<f32>, many: *const Shapes<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i64;
    /// A box that holds a shape throughout its motion, t from 0 to t_end. The shape touches nothing outside it.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: 0.
    ///
    /// Errors: those of vesica_cast_f32; VESICA_E_RANGE if a side would overflow.
    ///
    /// Accuracy: a side that does not move is as of vesica_bounds_f32. One that moves is too far out by less than 5.5
    /// units in the last place of the largest of three numbers: the side at rest, the way it moves, and where it ends.
    ///
    /// Since: 0.1.
    pub fn vesica_sweep_bounds_f32(kind: i32, shape: *const c_void, vx: f32, vy: f32, t_end: f32,
        out: *mut Aabb<f32>) -> i32;
    /// Which items of an index does one moving shape touch? They come in the index's order.
    ///
    /// Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f32. out has
    /// room for `capacity` items. With capacity 0, out and state may be NULL.
    ///
    /// Returns: the number of items written; with capacity 0, how many there are. If state\[0\] is not -1 then, there
    /// are more, and the same call continues (vesica_index.h).
    ///
    /// Errors: those of vesica_cast_f32, and VESICA_E_INDEX; VESICA_E_ARGUMENT also for sets of another number of items
    /// than the index, a pointer that is not aligned, or a state from another function (vesica_index.h). VESICA_E_RANGE
    /// only if an item is undecided, because its exact position at t_end would take more than 2000 bits. Then nothing
    /// is written, the state is behind that item, and the same call continues; with capacity 0 there is no count.
    /// Invalid items are never touched.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: a search, and vesica_cast_f32 for each item whose box the swept box meets.
    ///
    /// Since: 0.1.
    pub fn vesica_index_cast_f32(index: *const c_void, sets: *const Shapes<f32>, set_count: i32,
        one: *const Shapes<f32>, vx: f32, vy: f32, t_end: f32, out: *mut i64, capacity: i64, state: *mut i64) -> i64;
    /// Which item of an index does one moving shape touch first? If several are touched at that time, the lowest item.
    ///
    /// Requires: sets are those of the index. one, an array of count 1; vx, vy and t_end as vesica_cast_f32.
    ///
    /// Returns: the item, or the index's count if none is touched. \*out is its contact, the normal pointing to `one`.
    ///
    /// Errors: those of vesica_index_cast_f32; VESICA_E_RANGE only as for vesica_cast_first_f32.
    ///
    /// Cost: a search, and vesica_cast_f32 for the few items near the ray.
    ///
    /// Since: 0.1.
    pub fn vesica_index_cast_first_f32(index: *const c_void, sets: *const Shapes<f32>, set_count: i32,
        one: *const Shapes<f32>, vx: f32, vy: f32, t_end: f32, out: *mut Impact<f32>) -> i64;
    /// As vesica_impact_time_f64. The gap is that at the rounded time, and rounded up: it may exceed the tolerance by
    /// 2^-24 of the way that the shapes move relative to each other. Where the double function returns VESICA_CAST_HIT,
    /// this one may return VESICA_CAST_NEAR.
    ///
    /// Errors: those of the double functions.
    ///
    /// Since: 0.1.
    pub fn vesica_impact_time_f32(kind_a: i32, a: *const c_void, turn_a: *const Turn<f32>, kind_b: i32,
        b: *const c_void, turn_b: *const Turn<f32>, tolerance: f32, out: *mut Impact<f32>, gap: *mut f32) -> i32;
    /// Which item of an index does a shape that moves and turns touch first? It is proved that there is no contact with
    /// any item before t.
    ///
    /// The items are at rest. Each is asked as by vesica_impact_time_f32, the item as a and `one` as b; the one with
    /// the least t counts, and of several the lowest. \*out, \*gap and \*answer are its results. Items are not asked if
    /// they stay farther than the tolerance from all places of `one`, nor if they are first that near after t.
    ///
    /// Requires: sets are those of the index. one, an array of count 1; turn and tolerance as for
    /// vesica_impact_time_f32.
    ///
    /// Returns: the item, with \*answer VESICA_CAST_HIT, _NEAR or _START; or the index's count, with VESICA_CAST_MISS.
    ///
    /// Errors: those of vesica_index_cast_f32; VESICA_E_RANGE, and VESICA_E_NOT_CONVEX of a polygon in the index, only
    /// for an item that might be touched first.
    ///
    /// Cost: a search, and vesica_impact_time_f32 for the items near the way.
    ///
    /// Since: 0.1.
    pub fn vesica_index_impact_time_f32(index: *const c_void, sets: *const Shapes<f32>, set_count: i32,
        one: *const Shapes<f32>, turn: *const Turn<f32>, tolerance: f32, out: *mut Impact<f32>, gap: *mut f32,
        answer: *mut i32) -> i64;
    /// Contact manifold: where do two convex shapes press on each other, how deep, and along which normal?
    ///
    /// The normal is the direction of vesica_depth_f32, and the greatest depth is its depth. The facing edge of a is
    /// the edge whose outward normal is nearest to (nx, ny), and that of b the one whose outward normal is nearest to
    /// the opposite. Edges of capsules and rounded rectangles are those of the core, moved along the normal by the
    /// radius. Seen along the normal, both edges are intervals. The contacts are at both ends of what the intervals
    /// share, in the order of the normal turned counter-clockwise by a right angle. The depth there is how far a's edge
    /// is beyond b's along the normal, and the point is midway. If a depth is below 0, that contact is left out. There
    /// is one contact if one shape has no edge (a point, a circle, an ellipse, a shape without a size), if the
    /// intervals share no more than e, or if a depth is below -e; between that and 0 it is 0. Otherwise there are two.
    /// e is about 2^-47 scale, which is rounding. As a box tilts, its second depth falls to 0 before its contact is
    /// left out; as it slides off an edge, both contacts become one place. So no threshold decides what is parallel.
    /// Where another edge, or another normal, becomes the nearest, the normal, the numbers and the lesser contact may
    /// jump; the greatest depth never does. a0 and b0 are the numbers of the vertices at which the facing edges end on
    /// contact 0's side. So they stay while the same edges face each other, whichever is the longer. An edge beside a
    /// shape without one has the number of its first vertex counter-clockwise, and a shape without an edge 0. Vertices
    /// of polygons count as stored. Edges on one line, to e, are one edge, and a vertex that is repeated has one of its
    /// numbers. Vertices of an AABB, a rectangle and a rounded one count from (-hx, -hy) in its frame: (hx, -hy) is 1,
    /// (hx, hy) 2, as in vesica_corners_of_shapes_f32. A segment and a capsule begin at vertex 0. So does a polygon or
    /// polyline on one line, at its leftmost vertex. An ellipse with a half length of 0 counts as a rectangle.
    /// Exchanging the shapes reverses the normal, the numbers and the order, and changes no other bit, except for two
    /// equal shapes in one place. Moving both alike changes no depth if no coordinate is rounded. For contacts before
    /// the shapes touch, give them a radius: round_rect in place of rect. Then subtract both radii.
    ///
    /// Returns: the count; 0 for disjoint shapes.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND, VESICA_E_SHAPE, VESICA_E_NOT_CONVEX, VESICA_E_RANGE (a depth or a
    /// coordinate would overflow).
    ///
    /// Accuracy: the normal and the greatest depth have the bits of vesica_depth_f32. The lesser depth and the points
    /// are right to 16 u scale (1 + s), where s is the slope of the steeper edge against the line across the normal, at
    /// most 1 where corners have 90 degrees or more; the points also to 16 u of their coordinates and the radii. To
    /// that comes 4 e where edges were joined, or where a depth below 0 has become 0. Each number is computed in
    /// double, within these bounds, and then rounded to float once. In bounds on errors u is 2^-53, half a unit in the
    /// last place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
    /// lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over
    /// shorter size.
    ///
    /// Cost: one and a half to three times vesica_depth_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_manifold_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut Contacts<f32>) -> i32;
    /// The contacts of a\[i\] and b\[i\].
    ///
    /// Requires: equal counts, or one count of 1, whose shape is used for all. out has room for as many manifolds as
    /// the larger count.
    ///
    /// Returns: how many pairs have a contact.
    ///
    /// Errors: also VESICA_E_ARGUMENT, as vesica_depth_many_f32. A pair with an error has that error for its count, and
    /// 0 for all else; the others are written as usual. The call then returns VESICA_E_SHAPE if a shape is invalid,
    /// else the error of the last such pair.
    ///
    /// Accuracy: every result has the same bits as vesica_manifold_f32.
    ///
    /// Cost: as vesica_manifold_f32 for each pair.
    ///
    /// Since: 0.1.
    pub fn vesica_manifold_many_f32(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut Contacts<f32>) -> i64;
    /// A ray at a point.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
    ///
    /// Accuracy: as vesica_cast_f32.
    ///
    /// Cost: as vesica_overlap_f32 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_point_point_f32(a: *const Point<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32;
    /// A ray at a segment.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
    ///
    /// Accuracy: as vesica_cast_f32.
    ///
    /// Cost: as vesica_overlap_f32 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_segment_point_f32(a: *const Segment<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32;
    /// A ray at a disc.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
    ///
    /// Accuracy: as vesica_cast_f32.
    ///
    /// Cost: as vesica_overlap_f32 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_circle_point_f32(a: *const Circle<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32;
    /// A ray at an axis-aligned box.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
    ///
    /// Accuracy: as vesica_cast_f32.
    ///
    /// Cost: as vesica_overlap_f32 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_aabb_point_f32(a: *const Aabb<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32;
    /// A ray at a rectangle.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
    ///
    /// Accuracy: as vesica_cast_f32.
    ///
    /// Cost: as vesica_overlap_f32 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_rect_point_f32(a: *const Rect<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32;
    /// A ray at an ellipse.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
    ///
    /// Accuracy: as vesica_cast_f32.
    ///
    /// Cost: as vesica_overlap_f32 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_ellipse_point_f32(a: *const Ellipse<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32;
    /// Two discs.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
    ///
    /// Accuracy: as vesica_cast_f32.
    ///
    /// Cost: as vesica_overlap_f32 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_circle_circle_f32(a: *const Circle<f32>, b: *const Circle<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32;
    /// Two rectangles.
    ///
    /// Requires: vx and vy finite; both may be 0. t_end \>= 0, or infinity.
    ///
    /// Returns: VESICA_CAST_MISS, VESICA_CAST_HIT or VESICA_CAST_START.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT, VESICA_E_SHAPE, VESICA_E_RANGE, as vesica_cast_f32.
    ///
    /// Accuracy: as vesica_cast_f32.
    ///
    /// Cost: as vesica_overlap_f32 for a miss, ten times as much for a hit; for two rectangles as vesica_cast_f32.
    ///
    /// Since: 0.1.
    pub fn vesica_cast_rect_rect_f32(a: *const Rect<f32>, b: *const Rect<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32;
    /// The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
    ///
    /// Every shape has an inside, an outline and an outside. The first three characters say what a's inside shares with
    /// b's inside, outline and outside; the next three say it of a's outline, the last three of a's outside. F means
    /// nothing, 0 single points, 1 lines, 2 an area. The outline of a shape with area is the curve around it, a
    /// segment's its two end points; a point has none. A segment without length is a point; a shape with one size 0 is
    /// a segment, with both 0 a point; a capsule or rounded rectangle without a radius is its core. Two boxes side by
    /// side that share a side give "FF2F11212". Exchanging the shapes exchanges rows and columns. Polygons and
    /// polylines have insides and outlines as vesica_relation_f64 says.
    ///
    /// Requires: matrix with room for VESICA_DE9IM_SIZE characters; simple polygons. Others get a matrix without a
    /// meaning.
    ///
    /// Returns: 0, and nine characters and a final NUL in matrix.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND (also for kinds that vesica_relation_f64 does not take together),
    /// VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: as vesica_relation_f64; more for a segment, for shapes whose sides are parallel, and for equal radii.
    ///
    /// Since: 0.1.
    pub fn vesica_de9im_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, matrix: *mut u8) -> i32;
    /// Does a nine-intersection matrix match a pattern, such as "T\*F\*\*F\*\*\*" for "a is within b"?
    ///
    /// In a pattern F, 0, 1 and 2 match themselves, T matches 0, 1 and 2, and \* matches all four.
    ///
    /// Requires: matrix and pattern, nine such characters and a final NUL each; no T or \* in the matrix.
    ///
    /// Returns: 1 if it matches, 0 if not.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_ARGUMENT (another length or another character).
    ///
    /// Accuracy: exact.
    ///
    /// Since: 0.1.
    pub fn vesica_de9im_match(matrix: *const u8, pattern: *const u8) -> i32;
    /// The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
    ///
    /// The kinds are points, segments, boxes and rectangles. A point or a segment may also meet a circle, an ellipse, a
    /// capsule or a rounded rectangle, and a polygon that is convex a box, a rectangle or another one. A polygon on one
    /// line is a segment. The region is convex. Its vertices x0 y0 x1 y1 ... come counter-clockwise if y points up. The
    /// first is the one with the least y, of equal ones that with the least x, by the numbers written. One vertex is a
    /// point, two are the ends of a segment. A vertex in the middle of a straight side is none. Exchanging the shapes
    /// changes no bit; a zero is +0.
    ///
    /// A segment and a polygon of any rings, or a polyline, may share several pieces. Then two vertices are written for
    /// each piece, where it begins and where it ends, in order along the segment; of a single point, twice the same. A
    /// point has one vertex.
    ///
    /// Requires: capacity, how many vertices out has room for. It may be 0, and out then NULL.
    ///
    /// Returns: how many vertices there are, even if that exceeds the capacity, and 0 if the shapes share nothing: at
    /// most 8, of two polygons as many as both have, of a segment and a path twice its vertices and two more. The first
    /// `capacity` are written.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND (also for other pairs of kinds than these), VESICA_E_ARGUMENT (a negative
    /// capacity), VESICA_E_SHAPE, VESICA_E_NOT_CONVEX (a polygon, unless the other shape is a point or a segment),
    /// VESICA_E_RANGE (a vertex, or the length of a side that makes one, overflows).
    ///
    /// Accuracy: the number of vertices is exact: it is the true region's. A corner of a shape that lies in the other
    /// keeps the stored numbers, or the numbers of vesica_corners_of_shapes_f64 for a rectangle. Others are right to 4
    /// u times the largest coordinate or size of either shape. In bounds on errors u is 2^-53, half a unit in the last
    /// place of 1. The scale of two shapes is the largest of |dx| and |dy| between their centres and of their half
    /// lengths; "right to 4 u scale" means an error of at most 4 u times the scale. An aspect ratio is longer over
    /// shorter size.
    ///
    /// Cost: as vesica_overlap_f64 for disjoint shapes, else about as vesica_crossings_f64. For two polygons it grows
    /// with the product of their numbers of vertices, for a segment and a path with the number of vertices.
    ///
    /// Since: 0.1.
    pub fn vesica_intersection_f64(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Point<f64>,
        capacity: i64) -> i64;
    /// The nine-intersection matrix of two shapes (DE-9IM), as geographic systems write it.
    ///
    /// Every shape has an inside, an outline and an outside. The first three characters say what a's inside shares with
    /// b's inside, outline and outside; the next three say it of a's outline, the last three of a's outside. F means
    /// nothing, 0 single points, 1 lines, 2 an area. The outline of a shape with area is the curve around it, a
    /// segment's its two end points; a point has none. A segment without length is a point; a shape with one size 0 is
    /// a segment, with both 0 a point; a capsule or rounded rectangle without a radius is its core. Two boxes side by
    /// side that share a side give "FF2F11212". Exchanging the shapes exchanges rows and columns. Polygons and
    /// polylines have insides and outlines as vesica_relation_f32 says.
    ///
    /// Requires: matrix with room for VESICA_DE9IM_SIZE characters; simple polygons. Others get a matrix without a
    /// meaning.
    ///
    /// Returns: 0, and nine characters and a final NUL in matrix.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND (also for kinds that vesica_relation_f32 does not take together),
    /// VESICA_E_SHAPE.
    ///
    /// Accuracy: exact.
    ///
    /// Cost: as vesica_relation_f32; more for a segment, for shapes whose sides are parallel, and for equal radii.
    ///
    /// Since: 0.1.
    pub fn vesica_de9im_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, matrix: *mut u8) -> i32;
    /// The vertices of the region that two shapes share: two with straight outlines, or a segment and any shape.
    ///
    /// The kinds are points, segments, boxes and rectangles. A point or a segment may also meet a circle, an ellipse, a
    /// capsule or a rounded rectangle, and a polygon that is convex a box, a rectangle or another one. A polygon on one
    /// line is a segment. The region is convex. Its vertices x0 y0 x1 y1 ... come counter-clockwise if y points up. The
    /// first is the one with the least y, of equal ones that with the least x, by the numbers written. One vertex is a
    /// point, two are the ends of a segment. A vertex in the middle of a straight side is none. Exchanging the shapes
    /// changes no bit; a zero is +0.
    ///
    /// A segment and a polygon of any rings, or a polyline, may share several pieces. Then two vertices are written for
    /// each piece, where it begins and where it ends, in order along the segment; of a single point, twice the same. A
    /// point has one vertex.
    ///
    /// Requires: capacity, how many vertices out has room for. It may be 0, and out then NULL.
    ///
    /// Returns: how many vertices there are, even if that exceeds the capacity, and 0 if the shapes share nothing: at
    /// most 8, of two polygons as many as both have, of a segment and a path twice its vertices and two more. The first
    /// `capacity` are written.
    ///
    /// Errors: VESICA_E_NULL, VESICA_E_KIND (also for other pairs of kinds than these), VESICA_E_ARGUMENT (a negative
    /// capacity), VESICA_E_SHAPE, VESICA_E_NOT_CONVEX (a polygon, unless the other shape is a point or a segment),
    /// VESICA_E_RANGE (a vertex, or the length of a side that makes one, overflows).
    ///
    /// Accuracy: the number of vertices is exact: it is the true region's. A corner of a shape that lies in the other
    /// keeps the stored numbers, or the numbers of vesica_corners_of_shapes_f32 for a rectangle. Others are right to 4
    /// u times the largest coordinate or size of either shape. Each number is computed in double, within these bounds,
    /// and then rounded to float once. In bounds on errors u is 2^-53, half a unit in the last place of 1. The scale of
    /// two shapes is the largest of |dx| and |dy| between their centres and of their half lengths; "right to 4 u scale"
    /// means an error of at most 4 u times the scale. An aspect ratio is longer over shorter size.
    ///
    /// Cost: as vesica_overlap_f32 for disjoint shapes, else about as vesica_crossings_f32. For two polygons it grows
    /// with the product of their numbers of vertices, for a segment and a path with the number of vertices.
    ///
    /// Since: 0.1.
    pub fn vesica_intersection_f32(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Point<f32>,
        capacity: i64) -> i64;
}

/// `f64` and `f32`, each with the functions of its type.
///
/// # Safety
/// Nothing else can be one.
#[allow(missing_docs, clippy::missing_safety_doc, clippy::too_many_arguments)]
pub unsafe trait Scalar: Copy + Default + PartialEq + PartialOrd + core::fmt::Debug + 'static {
    unsafe fn overlap(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    unsafe fn interiors_overlap(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    unsafe fn contains(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    unsafe fn relation(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32;
    unsafe fn nearest(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut ClosestPoints<Self>) -> i32;
    unsafe fn depth(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Penetration<Self>) -> i32;
    unsafe fn area(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Self) -> i32;
    unsafe fn iou(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Self) -> i32;
    unsafe fn bounds(kind: i32, shape: *const c_void, out: *mut Aabb<Self>) -> i32;
    unsafe fn check(kind: i32, shape: *const c_void) -> i32;
    unsafe fn crossings(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Point<Self>,
        capacity: i64, shared: *mut i32) -> i64;
    unsafe fn boundary_distance(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut ClosestPoints<Self>) -> i32;
    unsafe fn shape_area(kind: i32, shape: *const c_void, out: *mut Self) -> i32;
    unsafe fn polygon_facts(polygon: *const Polygon<Self>, out: *mut Facts<Self>) -> i32;
    unsafe fn overlap_point_point(a: *const Point<Self>, b: *const Point<Self>) -> i32;
    unsafe fn overlap_point_segment(a: *const Point<Self>, b: *const Segment<Self>) -> i32;
    unsafe fn overlap_point_circle(a: *const Point<Self>, b: *const Circle<Self>) -> i32;
    unsafe fn overlap_point_aabb(a: *const Point<Self>, b: *const Aabb<Self>) -> i32;
    unsafe fn overlap_point_rect(a: *const Point<Self>, b: *const Rect<Self>) -> i32;
    unsafe fn overlap_point_ellipse(a: *const Point<Self>, b: *const Ellipse<Self>) -> i32;
    unsafe fn overlap_segment_segment(a: *const Segment<Self>, b: *const Segment<Self>) -> i32;
    unsafe fn overlap_segment_circle(a: *const Segment<Self>, b: *const Circle<Self>) -> i32;
    unsafe fn overlap_segment_aabb(a: *const Segment<Self>, b: *const Aabb<Self>) -> i32;
    unsafe fn overlap_segment_rect(a: *const Segment<Self>, b: *const Rect<Self>) -> i32;
    unsafe fn overlap_segment_ellipse(a: *const Segment<Self>, b: *const Ellipse<Self>) -> i32;
    unsafe fn overlap_circle_circle(a: *const Circle<Self>, b: *const Circle<Self>) -> i32;
    unsafe fn overlap_circle_aabb(a: *const Circle<Self>, b: *const Aabb<Self>) -> i32;
    unsafe fn overlap_circle_rect(a: *const Circle<Self>, b: *const Rect<Self>) -> i32;
    unsafe fn overlap_circle_ellipse(a: *const Circle<Self>, b: *const Ellipse<Self>) -> i32;
    unsafe fn overlap_aabb_aabb(a: *const Aabb<Self>, b: *const Aabb<Self>) -> i32;
    unsafe fn overlap_aabb_rect(a: *const Aabb<Self>, b: *const Rect<Self>) -> i32;
    unsafe fn overlap_aabb_ellipse(a: *const Aabb<Self>, b: *const Ellipse<Self>) -> i32;
    unsafe fn overlap_rect_rect(a: *const Rect<Self>, b: *const Rect<Self>) -> i32;
    unsafe fn overlap_rect_ellipse(a: *const Rect<Self>, b: *const Ellipse<Self>) -> i32;
    unsafe fn overlap_ellipse_ellipse(a: *const Ellipse<Self>, b: *const Ellipse<Self>) -> i32;
    unsafe fn aabb_from_corners(x0: Self, y0: Self, x1: Self, y1: Self, out: *mut Aabb<Self>) -> i32;
    unsafe fn rect_from_angle(cx: Self, cy: Self, angle: Self, width: Self, height: Self, out: *mut Rect<Self>) -> i32;
    unsafe fn rect_from_corners(corners: *const Self, out: *mut Rect<Self>) -> i32;
    unsafe fn rect_corners_misfit(corners: *const Self, r: *const Rect<Self>, misfit: *mut Self) -> i32;
    unsafe fn round_rect_from_angle(cx: Self, cy: Self, angle: Self, width: Self, height: Self, radius: Self,
        out: *mut RoundRect<Self>) -> i32;
    unsafe fn capsule_from_angle(cx: Self, cy: Self, angle: Self, length: Self, radius: Self,
        out: *mut Capsule<Self>) -> i32;
    unsafe fn capsule_from_width(x0: Self, y0: Self, x1: Self, y1: Self, width: Self, out: *mut Capsule<Self>) -> i32;
    unsafe fn ellipse_from_angle(cx: Self, cy: Self, angle: Self, a: Self, b: Self, out: *mut Ellipse<Self>) -> i32;
    unsafe fn ellipse_from_radius_vector(cx: Self, cy: Self, wx: Self, wy: Self, ratio: Self,
        out: *mut Ellipse<Self>) -> i32;
    unsafe fn ellipse_from_covariance(mean_x: Self, mean_y: Self, cxx: Self, cxy: Self, cyy: Self, k: Self,
        out: *mut Ellipse<Self>) -> i32;
    unsafe fn ellipse_from_matrix(cx: Self, cy: Self, mxx: Self, mxy: Self, myy: Self, out: *mut Ellipse<Self>) -> i32;
    unsafe fn shapes_from_records(kind: i32, count: i64, base: *const c_void, stride: isize,
        out: *mut Shapes<Self>) -> i32;
    unsafe fn overlap_many(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut u8) -> i64;
    unsafe fn interiors_overlap_many(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut u8) -> i64;
    unsafe fn relation_many(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut u8) -> i64;
    unsafe fn contains_many(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut u8) -> i64;
    unsafe fn nearest_many(a: *const Shapes<Self>, b: *const Shapes<Self>, distance: *mut Self, ax: *mut Self,
        ay: *mut Self, bx: *mut Self, by: *mut Self) -> i64;
    unsafe fn boundary_distance_many(a: *const Shapes<Self>, b: *const Shapes<Self>, distance: *mut Self, ax: *mut Self,
        ay: *mut Self, bx: *mut Self, by: *mut Self) -> i64;
    unsafe fn depth_many(a: *const Shapes<Self>, b: *const Shapes<Self>, depth: *mut Self, x: *mut Self,
        y: *mut Self) -> i64;
    unsafe fn area_many(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self) -> i64;
    unsafe fn iou_many(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self) -> i64;
    unsafe fn overlap_matrix(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut u8, row_stride: isize) -> i64;
    unsafe fn interiors_overlap_matrix(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut u8,
        row_stride: isize) -> i64;
    unsafe fn relation_matrix(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut u8, row_stride: isize) -> i64;
    unsafe fn contains_matrix(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut u8, row_stride: isize) -> i64;
    unsafe fn area_matrix(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self, row_stride: isize) -> i64;
    unsafe fn iou_matrix(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self, row_stride: isize) -> i64;
    unsafe fn overlap_select(one: *const Shapes<Self>, many: *const Shapes<Self>, out: *mut i64, capacity: i64) -> i64;
    unsafe fn interiors_overlap_select(one: *const Shapes<Self>, many: *const Shapes<Self>, out: *mut i64,
        capacity: i64) -> i64;
    unsafe fn nms(shapes: *const Shapes<Self>, scores: *const Self, threshold: Self, scratch: *mut c_void,
        scratch_size: i64, keep: *mut i64, kept: *mut i64) -> i32;
    unsafe fn rects_from_boxes(boxes: *const Self, count: i64, stride: isize, angle: i32, out: *mut Rect<Self>) -> i64;
    unsafe fn ellipses_from_boxes(boxes: *const Self, count: i64, stride: isize, angle: i32,
        out: *mut Ellipse<Self>) -> i64;
    unsafe fn rects_from_corners(corners: *const Self, count: i64, stride: isize, out: *mut Rect<Self>) -> i64;
    unsafe fn rect_corners_misfit_many(corners: *const Self, stride: isize, rects: *const Shapes<Self>,
        misfit: *mut Self) -> i64;
    unsafe fn boxes_from_shapes(shapes: *const Shapes<Self>, angle: i32, boxes: *mut Self) -> i64;
    unsafe fn corners_of_shapes(shapes: *const Shapes<Self>, corners: *mut Self) -> i64;
    unsafe fn bounds_many(shapes: *const Shapes<Self>, out: *mut Aabb<Self>) -> i64;
    unsafe fn shape_area_many(shapes: *const Shapes<Self>, out: *mut Self) -> i64;
    unsafe fn convex_hull(points: *const Polygon<Self>, out: *mut Point<Self>, capacity: i64) -> i64;
    unsafe fn min_area_rect(points: *const Polygon<Self>, out: *mut Rect<Self>) -> i32;
    unsafe fn min_perimeter_rect(points: *const Polygon<Self>, out: *mut Rect<Self>) -> i32;
    unsafe fn min_area_rect_many(points: *const Shapes<Self>, out: *mut Rect<Self>) -> i64;
    unsafe fn min_perimeter_rect_many(points: *const Shapes<Self>, out: *mut Rect<Self>) -> i64;
    unsafe fn join_ratio(ratio: i32, threshold: Self, index_a: *const c_void, sets_a: *const Shapes<Self>,
        set_count_a: i32, index_b: *const c_void, sets_b: *const Shapes<Self>, set_count_b: i32, part: i64, parts: i64,
        scratch: *mut c_void, scratch_size: i64, out_a: *mut i64, out_b: *mut i64, values: *mut Self, capacity: i64,
        state: *mut i64) -> i64;
    unsafe fn assign_greedy(a: *const i64, b: *const i64, values: *const Self, count: i64, count_a: i64, count_b: i64,
        scratch: *mut c_void, scratch_size: i64, chosen: *mut i64) -> i64;
    unsafe fn fuse(shapes: *const Shapes<Self>, scores: *const Self, weights: *const Self, labels: *const i32,
        threshold: Self, fused_score: i32, scratch: *mut c_void, scratch_size: i64, fused: *mut c_void,
        fused_scores: *mut Self, clusters: *mut i64, count: *mut i64) -> i32;
    unsafe fn volume_ratio(ratio: i32, kind_a: i32, a: *const c_void, span_a: *const Span<Self>, kind_b: i32,
        b: *const c_void, span_b: *const Span<Self>, out: *mut Self) -> i32;
    unsafe fn volume_ratio_many(ratio: i32, a: *const Shapes<Self>, spans_a: *const Span<Self>, b: *const Shapes<Self>,
        spans_b: *const Span<Self>, out: *mut Self) -> i64;
    unsafe fn volume_ratio_matrix(ratio: i32, a: *const Shapes<Self>, spans_a: *const Span<Self>,
        b: *const Shapes<Self>, spans_b: *const Span<Self>, out: *mut Self, row_stride: isize) -> i64;
    unsafe fn match_truths(rule: i32, a: *const i64, b: *const i64, values: *const Self, count: i64,
        scores: *const Self, detections: i64, flags: *const u8, truths: i64, thresholds: *const Self,
        threshold_count: i64, scratch: *mut c_void, scratch_size: i64, outcomes: *mut u8, taken: *mut i64) -> i32;
    unsafe fn average_precision(rule: i32, scores: *const Self, outcomes: *const u8, count: i64, truths: i64,
        scratch: *mut c_void, scratch_size: i64, out: *mut Self) -> i32;
    unsafe fn gaussian_distance(which: i32, kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut Self) -> i32;
    unsafe fn gaussian_distance_many(which: i32, a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self) -> i64;
    unsafe fn gaussian_distance_matrix(which: i32, a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self,
        row_stride: isize) -> i64;
    unsafe fn index_build(sets: *const Shapes<Self>, set_count: i32, index: *mut c_void, index_size: i64,
        scratch: *mut c_void, scratch_size: i64) -> i64;
    unsafe fn index_step(step: i32, part: i64, parts: i64, sets: *const Shapes<Self>, set_count: i32,
        index: *mut c_void, index_size: i64, scratch: *mut c_void, scratch_size: i64) -> i64;
    unsafe fn index_select(index: *const c_void, sets: *const Shapes<Self>, set_count: i32, one: *const Shapes<Self>,
        out: *mut i64, capacity: i64, state: *mut i64) -> i64;
    unsafe fn join(query: i32, index_a: *const c_void, sets_a: *const Shapes<Self>, set_count_a: i32,
        index_b: *const c_void, sets_b: *const Shapes<Self>, set_count_b: i32, part: i64, parts: i64,
        scratch: *mut c_void, scratch_size: i64, out_a: *mut i64, out_b: *mut i64, capacity: i64,
        state: *mut i64) -> i64;
    unsafe fn join_within(index_a: *const c_void, sets_a: *const Shapes<Self>, set_count_a: i32, index_b: *const c_void,
        sets_b: *const Shapes<Self>, set_count_b: i32, distance: Self, part: i64, parts: i64, out_a: *mut i64,
        out_b: *mut i64, capacity: i64, state: *mut i64) -> i64;
    unsafe fn index_nearest(index: *const c_void, sets: *const Shapes<Self>, set_count: i32, one: *const Shapes<Self>,
        k: i64, within: Self, out: *mut i64, distance: *mut Self) -> i64;
    unsafe fn join_nearest(sets_a: *const Shapes<Self>, set_count_a: i32, index_b: *const c_void,
        sets_b: *const Shapes<Self>, set_count_b: i32, k: i64, within: Self, part: i64, parts: i64, out: *mut i64,
        distance: *mut Self) -> i64;
    unsafe fn polygon_boxes(kind: i32, path: *const c_void, boxes: *mut c_void, size: i64) -> i32;
    unsafe fn polygon_boxes_overlap(kind: i32, path: *const c_void, boxes: *const c_void, size: i64, kind_b: i32,
        b: *const c_void) -> i32;
    unsafe fn polygon_boxes_nearest(kind: i32, path: *const c_void, boxes: *const c_void, size: i64, kind_b: i32,
        b: *const c_void, out: *mut ClosestPoints<Self>) -> i32;
    unsafe fn polygon_boxes_within(kind: i32, path: *const c_void, boxes: *const c_void, size: i64, kind_b: i32,
        b: *const c_void, distance: Self) -> i32;
    unsafe fn ratio(ratio: i32, kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Self) -> i32;
    unsafe fn ratio_many(ratio: i32, a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self) -> i64;
    unsafe fn ratio_matrix(ratio: i32, a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self,
        row_stride: isize) -> i64;
    unsafe fn nearest_matrix(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self, row_stride: isize) -> i64;
    unsafe fn boundary_distance_matrix(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self,
        row_stride: isize) -> i64;
    unsafe fn depth_matrix(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self, row_stride: isize) -> i64;
    unsafe fn signed_distance(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Self) -> i32;
    unsafe fn signed_distance_many(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self) -> i64;
    unsafe fn signed_distance_matrix(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Self,
        row_stride: isize) -> i64;
    unsafe fn within(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, distance: Self) -> i32;
    unsafe fn within_many(a: *const Shapes<Self>, b: *const Shapes<Self>, distance: Self, out: *mut u8) -> i64;
    unsafe fn within_matrix(a: *const Shapes<Self>, b: *const Shapes<Self>, distance: Self, out: *mut u8,
        row_stride: isize) -> i64;
    unsafe fn suppress(shapes: *const Shapes<Self>, scores: *const Self, labels: *const i32, ratio: i32,
        threshold: Self, least_score: Self, most: i64, scratch: *mut c_void, scratch_size: i64, keep: *mut i64,
        kept: *mut i64) -> i32;
    unsafe fn suppress_soft(shapes: *const Shapes<Self>, scores: *const Self, labels: *const i32, ratio: i32,
        decay: i32, parameter: Self, least_score: Self, most: i64, scratch: *mut c_void, scratch_size: i64,
        keep: *mut i64, decayed: *mut Self, kept: *mut i64) -> i32;
    unsafe fn coverage(kind: i32, shape: *const c_void, grid: *const Grid<Self>, out: *mut Self,
        row_stride: isize) -> i32;
    unsafe fn coverage_cells(kind: i32, shape: *const c_void, grid: *const Grid<Self>, cells: *mut i64,
        shares: *mut Self, capacity: i64) -> i64;
    unsafe fn cast(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, vx: Self, vy: Self, t_end: Self,
        out: *mut Impact<Self>) -> i32;
    unsafe fn cast_many(a: *const Shapes<Self>, b: *const Shapes<Self>, vx: *const Self, vy: *const Self, stride: isize,
        t_end: Self, t: *mut Self, x: *mut Self, y: *mut Self, nx: *mut Self, ny: *mut Self) -> i64;
    unsafe fn cast_first(one: *const Shapes<Self>, many: *const Shapes<Self>, vx: Self, vy: Self, t_end: Self,
        out: *mut Impact<Self>) -> i64;
    unsafe fn sweep_bounds(kind: i32, shape: *const c_void, vx: Self, vy: Self, t_end: Self,
        out: *mut Aabb<Self>) -> i32;
    unsafe fn index_cast(index: *const c_void, sets: *const Shapes<Self>, set_count: i32, one: *const Shapes<Self>,
        vx: Self, vy: Self, t_end: Self, out: *mut i64, capacity: i64, state: *mut i64) -> i64;
    unsafe fn index_cast_first(index: *const c_void, sets: *const Shapes<Self>, set_count: i32,
        one: *const Shapes<Self>, vx: Self, vy: Self, t_end: Self, out: *mut Impact<Self>) -> i64;
    unsafe fn impact_time(kind_a: i32, a: *const c_void, turn_a: *const Turn<Self>, kind_b: i32, b: *const c_void,
        turn_b: *const Turn<Self>, tolerance: Self, out: *mut Impact<Self>, gap: *mut Self) -> i32;
    unsafe fn index_impact_time(index: *const c_void, sets: *const Shapes<Self>, set_count: i32,
        one: *const Shapes<Self>, turn: *const Turn<Self>, tolerance: Self, out: *mut Impact<Self>, gap: *mut Self,
        answer: *mut i32) -> i64;
    unsafe fn manifold(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Contacts<Self>) -> i32;
    unsafe fn manifold_many(a: *const Shapes<Self>, b: *const Shapes<Self>, out: *mut Contacts<Self>) -> i64;
    unsafe fn cast_point_point(a: *const Point<Self>, b: *const Point<Self>, vx: Self, vy: Self, t_end: Self,
        out: *mut Impact<Self>) -> i32;
    unsafe fn cast_segment_point(a: *const Segment<Self>, b: *const Point<Self>, vx: Self, vy: Self, t_end: Self,
        out: *mut Impact<Self>) -> i32;
    unsafe fn cast_circle_point(a: *const Circle<Self>, b: *const Point<Self>, vx: Self, vy: Self, t_end: Self,
        out: *mut Impact<Self>) -> i32;
    unsafe fn cast_aabb_point(a: *const Aabb<Self>, b: *const Point<Self>, vx: Self, vy: Self, t_end: Self,
        out: *mut Impact<Self>) -> i32;
    unsafe fn cast_rect_point(a: *const Rect<Self>, b: *const Point<Self>, vx: Self, vy: Self, t_end: Self,
        out: *mut Impact<Self>) -> i32;
    unsafe fn cast_ellipse_point(a: *const Ellipse<Self>, b: *const Point<Self>, vx: Self, vy: Self, t_end: Self,
        out: *mut Impact<Self>) -> i32;
    unsafe fn cast_circle_circle(a: *const Circle<Self>, b: *const Circle<Self>, vx: Self, vy: Self, t_end: Self,
        out: *mut Impact<Self>) -> i32;
    unsafe fn cast_rect_rect(a: *const Rect<Self>, b: *const Rect<Self>, vx: Self, vy: Self, t_end: Self,
        out: *mut Impact<Self>) -> i32;
    unsafe fn de9im(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, matrix: *mut u8) -> i32;
    unsafe fn intersection(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Point<Self>,
        capacity: i64) -> i64;
}
unsafe impl Scalar for f64 {
    #[inline]
    unsafe fn overlap(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32 {
        vesica_overlap_f64(kind_a, a, kind_b, b)
    }
    #[inline]
    unsafe fn interiors_overlap(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32 {
        vesica_interiors_overlap_f64(kind_a, a, kind_b, b)
    }
    #[inline]
    unsafe fn contains(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32 {
        vesica_contains_f64(kind_a, a, kind_b, b)
    }
    #[inline]
    unsafe fn relation(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32 {
        vesica_relation_f64(kind_a, a, kind_b, b)
    }
    #[inline]
    unsafe fn nearest(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut ClosestPoints<f64>) -> i32 {
        vesica_nearest_f64(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn depth(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Penetration<f64>) -> i32 {
        vesica_depth_f64(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn area(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f64) -> i32 {
        vesica_area_f64(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn iou(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f64) -> i32 {
        vesica_iou_f64(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn bounds(kind: i32, shape: *const c_void, out: *mut Aabb<f64>) -> i32 {
        vesica_bounds_f64(kind, shape, out)
    }
    #[inline]
    unsafe fn check(kind: i32, shape: *const c_void) -> i32 {
        vesica_check_f64(kind, shape)
    }
    #[inline]
    unsafe fn crossings(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Point<f64>,
        capacity: i64, shared: *mut i32) -> i64 {
        vesica_crossings_f64(kind_a, a, kind_b, b, out, capacity, shared)
    }
    #[inline]
    unsafe fn boundary_distance(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut ClosestPoints<f64>) -> i32 {
        vesica_boundary_distance_f64(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn shape_area(kind: i32, shape: *const c_void, out: *mut f64) -> i32 {
        vesica_shape_area_f64(kind, shape, out)
    }
    #[inline]
    unsafe fn polygon_facts(polygon: *const Polygon<f64>, out: *mut Facts<f64>) -> i32 {
        vesica_polygon_facts_f64(polygon, out)
    }
    #[inline]
    unsafe fn overlap_point_point(a: *const Point<f64>, b: *const Point<f64>) -> i32 {
        vesica_overlap_point_point_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_point_segment(a: *const Point<f64>, b: *const Segment<f64>) -> i32 {
        vesica_overlap_point_segment_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_point_circle(a: *const Point<f64>, b: *const Circle<f64>) -> i32 {
        vesica_overlap_point_circle_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_point_aabb(a: *const Point<f64>, b: *const Aabb<f64>) -> i32 {
        vesica_overlap_point_aabb_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_point_rect(a: *const Point<f64>, b: *const Rect<f64>) -> i32 {
        vesica_overlap_point_rect_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_point_ellipse(a: *const Point<f64>, b: *const Ellipse<f64>) -> i32 {
        vesica_overlap_point_ellipse_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_segment_segment(a: *const Segment<f64>, b: *const Segment<f64>) -> i32 {
        vesica_overlap_segment_segment_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_segment_circle(a: *const Segment<f64>, b: *const Circle<f64>) -> i32 {
        vesica_overlap_segment_circle_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_segment_aabb(a: *const Segment<f64>, b: *const Aabb<f64>) -> i32 {
        vesica_overlap_segment_aabb_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_segment_rect(a: *const Segment<f64>, b: *const Rect<f64>) -> i32 {
        vesica_overlap_segment_rect_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_segment_ellipse(a: *const Segment<f64>, b: *const Ellipse<f64>) -> i32 {
        vesica_overlap_segment_ellipse_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_circle_circle(a: *const Circle<f64>, b: *const Circle<f64>) -> i32 {
        vesica_overlap_circle_circle_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_circle_aabb(a: *const Circle<f64>, b: *const Aabb<f64>) -> i32 {
        vesica_overlap_circle_aabb_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_circle_rect(a: *const Circle<f64>, b: *const Rect<f64>) -> i32 {
        vesica_overlap_circle_rect_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_circle_ellipse(a: *const Circle<f64>, b: *const Ellipse<f64>) -> i32 {
        vesica_overlap_circle_ellipse_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_aabb_aabb(a: *const Aabb<f64>, b: *const Aabb<f64>) -> i32 {
        vesica_overlap_aabb_aabb_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_aabb_rect(a: *const Aabb<f64>, b: *const Rect<f64>) -> i32 {
        vesica_overlap_aabb_rect_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_aabb_ellipse(a: *const Aabb<f64>, b: *const Ellipse<f64>) -> i32 {
        vesica_overlap_aabb_ellipse_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_rect_rect(a: *const Rect<f64>, b: *const Rect<f64>) -> i32 {
        vesica_overlap_rect_rect_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_rect_ellipse(a: *const Rect<f64>, b: *const Ellipse<f64>) -> i32 {
        vesica_overlap_rect_ellipse_f64(a, b)
    }
    #[inline]
    unsafe fn overlap_ellipse_ellipse(a: *const Ellipse<f64>, b: *const Ellipse<f64>) -> i32 {
        vesica_overlap_ellipse_ellipse_f64(a, b)
    }
    #[inline]
    unsafe fn aabb_from_corners(x0: f64, y0: f64, x1: f64, y1: f64, out: *mut Aabb<f64>) -> i32 {
        vesica_aabb_from_corners_f64(x0, y0, x1, y1, out)
    }
    #[inline]
    unsafe fn rect_from_angle(cx: f64, cy: f64, angle: f64, width: f64, height: f64, out: *mut Rect<f64>) -> i32 {
        vesica_rect_from_angle_f64(cx, cy, angle, width, height, out)
    }
    #[inline]
    unsafe fn rect_from_corners(corners: *const f64, out: *mut Rect<f64>) -> i32 {
        vesica_rect_from_corners_f64(corners, out)
    }
    #[inline]
    unsafe fn rect_corners_misfit(corners: *const f64, r: *const Rect<f64>, misfit: *mut f64) -> i32 {
        vesica_rect_corners_misfit_f64(corners, r, misfit)
    }
    #[inline]
    unsafe fn round_rect_from_angle(cx: f64, cy: f64, angle: f64, width: f64, height: f64, radius: f64,
        out: *mut RoundRect<f64>) -> i32 {
        vesica_round_rect_from_angle_f64(cx, cy, angle, width, height, radius, out)
    }
    #[inline]
    unsafe fn capsule_from_angle(cx: f64, cy: f64, angle: f64, length: f64, radius: f64,
        out: *mut Capsule<f64>) -> i32 {
        vesica_capsule_from_angle_f64(cx, cy, angle, length, radius, out)
    }
    #[inline]
    unsafe fn capsule_from_width(x0: f64, y0: f64, x1: f64, y1: f64, width: f64, out: *mut Capsule<f64>) -> i32 {
        vesica_capsule_from_width_f64(x0, y0, x1, y1, width, out)
    }
    #[inline]
    unsafe fn ellipse_from_angle(cx: f64, cy: f64, angle: f64, a: f64, b: f64, out: *mut Ellipse<f64>) -> i32 {
        vesica_ellipse_from_angle_f64(cx, cy, angle, a, b, out)
    }
    #[inline]
    unsafe fn ellipse_from_radius_vector(cx: f64, cy: f64, wx: f64, wy: f64, ratio: f64,
        out: *mut Ellipse<f64>) -> i32 {
        vesica_ellipse_from_radius_vector_f64(cx, cy, wx, wy, ratio, out)
    }
    #[inline]
    unsafe fn ellipse_from_covariance(mean_x: f64, mean_y: f64, cxx: f64, cxy: f64, cyy: f64, k: f64,
        out: *mut Ellipse<f64>) -> i32 {
        vesica_ellipse_from_covariance_f64(mean_x, mean_y, cxx, cxy, cyy, k, out)
    }
    #[inline]
    unsafe fn ellipse_from_matrix(cx: f64, cy: f64, mxx: f64, mxy: f64, myy: f64, out: *mut Ellipse<f64>) -> i32 {
        vesica_ellipse_from_matrix_f64(cx, cy, mxx, mxy, myy, out)
    }
    #[inline]
    unsafe fn shapes_from_records(kind: i32, count: i64, base: *const c_void, stride: isize,
        out: *mut Shapes<f64>) -> i32 {
        vesica_shapes_from_records_f64(kind, count, base, stride, out)
    }
    #[inline]
    unsafe fn overlap_many(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8) -> i64 {
        vesica_overlap_many_f64(a, b, out)
    }
    #[inline]
    unsafe fn interiors_overlap_many(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8) -> i64 {
        vesica_interiors_overlap_many_f64(a, b, out)
    }
    #[inline]
    unsafe fn relation_many(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8) -> i64 {
        vesica_relation_many_f64(a, b, out)
    }
    #[inline]
    unsafe fn contains_many(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8) -> i64 {
        vesica_contains_many_f64(a, b, out)
    }
    #[inline]
    unsafe fn nearest_many(a: *const Shapes<f64>, b: *const Shapes<f64>, distance: *mut f64, ax: *mut f64, ay: *mut f64,
        bx: *mut f64, by: *mut f64) -> i64 {
        vesica_nearest_many_f64(a, b, distance, ax, ay, bx, by)
    }
    #[inline]
    unsafe fn boundary_distance_many(a: *const Shapes<f64>, b: *const Shapes<f64>, distance: *mut f64, ax: *mut f64,
        ay: *mut f64, bx: *mut f64, by: *mut f64) -> i64 {
        vesica_boundary_distance_many_f64(a, b, distance, ax, ay, bx, by)
    }
    #[inline]
    unsafe fn depth_many(a: *const Shapes<f64>, b: *const Shapes<f64>, depth: *mut f64, x: *mut f64,
        y: *mut f64) -> i64 {
        vesica_depth_many_f64(a, b, depth, x, y)
    }
    #[inline]
    unsafe fn area_many(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64) -> i64 {
        vesica_area_many_f64(a, b, out)
    }
    #[inline]
    unsafe fn iou_many(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64) -> i64 {
        vesica_iou_many_f64(a, b, out)
    }
    #[inline]
    unsafe fn overlap_matrix(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8, row_stride: isize) -> i64 {
        vesica_overlap_matrix_f64(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn interiors_overlap_matrix(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8,
        row_stride: isize) -> i64 {
        vesica_interiors_overlap_matrix_f64(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn relation_matrix(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8, row_stride: isize) -> i64 {
        vesica_relation_matrix_f64(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn contains_matrix(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut u8, row_stride: isize) -> i64 {
        vesica_contains_matrix_f64(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn area_matrix(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64, row_stride: isize) -> i64 {
        vesica_area_matrix_f64(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn iou_matrix(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64, row_stride: isize) -> i64 {
        vesica_iou_matrix_f64(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn overlap_select(one: *const Shapes<f64>, many: *const Shapes<f64>, out: *mut i64, capacity: i64) -> i64 {
        vesica_overlap_select_f64(one, many, out, capacity)
    }
    #[inline]
    unsafe fn interiors_overlap_select(one: *const Shapes<f64>, many: *const Shapes<f64>, out: *mut i64,
        capacity: i64) -> i64 {
        vesica_interiors_overlap_select_f64(one, many, out, capacity)
    }
    #[inline]
    unsafe fn nms(shapes: *const Shapes<f64>, scores: *const f64, threshold: f64, scratch: *mut c_void,
        scratch_size: i64, keep: *mut i64, kept: *mut i64) -> i32 {
        vesica_nms_f64(shapes, scores, threshold, scratch, scratch_size, keep, kept)
    }
    #[inline]
    unsafe fn rects_from_boxes(boxes: *const f64, count: i64, stride: isize, angle: i32, out: *mut Rect<f64>) -> i64 {
        vesica_rects_from_boxes_f64(boxes, count, stride, angle, out)
    }
    #[inline]
    unsafe fn ellipses_from_boxes(boxes: *const f64, count: i64, stride: isize, angle: i32,
        out: *mut Ellipse<f64>) -> i64 {
        vesica_ellipses_from_boxes_f64(boxes, count, stride, angle, out)
    }
    #[inline]
    unsafe fn rects_from_corners(corners: *const f64, count: i64, stride: isize, out: *mut Rect<f64>) -> i64 {
        vesica_rects_from_corners_f64(corners, count, stride, out)
    }
    #[inline]
    unsafe fn rect_corners_misfit_many(corners: *const f64, stride: isize, rects: *const Shapes<f64>,
        misfit: *mut f64) -> i64 {
        vesica_rect_corners_misfit_many_f64(corners, stride, rects, misfit)
    }
    #[inline]
    unsafe fn boxes_from_shapes(shapes: *const Shapes<f64>, angle: i32, boxes: *mut f64) -> i64 {
        vesica_boxes_from_shapes_f64(shapes, angle, boxes)
    }
    #[inline]
    unsafe fn corners_of_shapes(shapes: *const Shapes<f64>, corners: *mut f64) -> i64 {
        vesica_corners_of_shapes_f64(shapes, corners)
    }
    #[inline]
    unsafe fn bounds_many(shapes: *const Shapes<f64>, out: *mut Aabb<f64>) -> i64 {
        vesica_bounds_many_f64(shapes, out)
    }
    #[inline]
    unsafe fn shape_area_many(shapes: *const Shapes<f64>, out: *mut f64) -> i64 {
        vesica_shape_area_many_f64(shapes, out)
    }
    #[inline]
    unsafe fn convex_hull(points: *const Polygon<f64>, out: *mut Point<f64>, capacity: i64) -> i64 {
        vesica_convex_hull_f64(points, out, capacity)
    }
    #[inline]
    unsafe fn min_area_rect(points: *const Polygon<f64>, out: *mut Rect<f64>) -> i32 {
        vesica_min_area_rect_f64(points, out)
    }
    #[inline]
    unsafe fn min_perimeter_rect(points: *const Polygon<f64>, out: *mut Rect<f64>) -> i32 {
        vesica_min_perimeter_rect_f64(points, out)
    }
    #[inline]
    unsafe fn min_area_rect_many(points: *const Shapes<f64>, out: *mut Rect<f64>) -> i64 {
        vesica_min_area_rect_many_f64(points, out)
    }
    #[inline]
    unsafe fn min_perimeter_rect_many(points: *const Shapes<f64>, out: *mut Rect<f64>) -> i64 {
        vesica_min_perimeter_rect_many_f64(points, out)
    }
    #[inline]
    unsafe fn join_ratio(ratio: i32, threshold: f64, index_a: *const c_void, sets_a: *const Shapes<f64>,
        set_count_a: i32, index_b: *const c_void, sets_b: *const Shapes<f64>, set_count_b: i32, part: i64, parts: i64,
        scratch: *mut c_void, scratch_size: i64, out_a: *mut i64, out_b: *mut i64, values: *mut f64, capacity: i64,
        state: *mut i64) -> i64 {
        vesica_join_ratio_f64(ratio, threshold, index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, part, parts,
            scratch, scratch_size, out_a, out_b, values, capacity, state)
    }
    #[inline]
    unsafe fn assign_greedy(a: *const i64, b: *const i64, values: *const f64, count: i64, count_a: i64, count_b: i64,
        scratch: *mut c_void, scratch_size: i64, chosen: *mut i64) -> i64 {
        vesica_assign_greedy_f64(a, b, values, count, count_a, count_b, scratch, scratch_size, chosen)
    }
    #[inline]
    unsafe fn fuse(shapes: *const Shapes<f64>, scores: *const f64, weights: *const f64, labels: *const i32,
        threshold: f64, fused_score: i32, scratch: *mut c_void, scratch_size: i64, fused: *mut c_void,
        fused_scores: *mut f64, clusters: *mut i64, count: *mut i64) -> i32 {
        vesica_fuse_f64(shapes, scores, weights, labels, threshold, fused_score, scratch, scratch_size, fused,
            fused_scores, clusters, count)
    }
    #[inline]
    unsafe fn volume_ratio(ratio: i32, kind_a: i32, a: *const c_void, span_a: *const Span<f64>, kind_b: i32,
        b: *const c_void, span_b: *const Span<f64>, out: *mut f64) -> i32 {
        vesica_volume_ratio_f64(ratio, kind_a, a, span_a, kind_b, b, span_b, out)
    }
    #[inline]
    unsafe fn volume_ratio_many(ratio: i32, a: *const Shapes<f64>, spans_a: *const Span<f64>, b: *const Shapes<f64>,
        spans_b: *const Span<f64>, out: *mut f64) -> i64 {
        vesica_volume_ratio_many_f64(ratio, a, spans_a, b, spans_b, out)
    }
    #[inline]
    unsafe fn volume_ratio_matrix(ratio: i32, a: *const Shapes<f64>, spans_a: *const Span<f64>, b: *const Shapes<f64>,
        spans_b: *const Span<f64>, out: *mut f64, row_stride: isize) -> i64 {
        vesica_volume_ratio_matrix_f64(ratio, a, spans_a, b, spans_b, out, row_stride)
    }
    #[inline]
    unsafe fn match_truths(rule: i32, a: *const i64, b: *const i64, values: *const f64, count: i64, scores: *const f64,
        detections: i64, flags: *const u8, truths: i64, thresholds: *const f64, threshold_count: i64,
        scratch: *mut c_void, scratch_size: i64, outcomes: *mut u8, taken: *mut i64) -> i32 {
        vesica_match_truths_f64(rule, a, b, values, count, scores, detections, flags, truths, thresholds,
            threshold_count, scratch, scratch_size, outcomes, taken)
    }
    #[inline]
    unsafe fn average_precision(rule: i32, scores: *const f64, outcomes: *const u8, count: i64, truths: i64,
        scratch: *mut c_void, scratch_size: i64, out: *mut f64) -> i32 {
        vesica_average_precision_f64(rule, scores, outcomes, count, truths, scratch, scratch_size, out)
    }
    #[inline]
    unsafe fn gaussian_distance(which: i32, kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut f64) -> i32 {
        vesica_gaussian_distance_f64(which, kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn gaussian_distance_many(which: i32, a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64) -> i64 {
        vesica_gaussian_distance_many_f64(which, a, b, out)
    }
    #[inline]
    unsafe fn gaussian_distance_matrix(which: i32, a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64,
        row_stride: isize) -> i64 {
        vesica_gaussian_distance_matrix_f64(which, a, b, out, row_stride)
    }
    #[inline]
    unsafe fn index_build(sets: *const Shapes<f64>, set_count: i32, index: *mut c_void, index_size: i64,
        scratch: *mut c_void, scratch_size: i64) -> i64 {
        vesica_index_build_f64(sets, set_count, index, index_size, scratch, scratch_size)
    }
    #[inline]
    unsafe fn index_step(step: i32, part: i64, parts: i64, sets: *const Shapes<f64>, set_count: i32, index: *mut c_void,
        index_size: i64, scratch: *mut c_void, scratch_size: i64) -> i64 {
        vesica_index_step_f64(step, part, parts, sets, set_count, index, index_size, scratch, scratch_size)
    }
    #[inline]
    unsafe fn index_select(index: *const c_void, sets: *const Shapes<f64>, set_count: i32, one: *const Shapes<f64>,
        out: *mut i64, capacity: i64, state: *mut i64) -> i64 {
        vesica_index_select_f64(index, sets, set_count, one, out, capacity, state)
    }
    #[inline]
    unsafe fn join(query: i32, index_a: *const c_void, sets_a: *const Shapes<f64>, set_count_a: i32,
        index_b: *const c_void, sets_b: *const Shapes<f64>, set_count_b: i32, part: i64, parts: i64,
        scratch: *mut c_void, scratch_size: i64, out_a: *mut i64, out_b: *mut i64, capacity: i64,
        state: *mut i64) -> i64 {
        vesica_join_f64(query, index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, part, parts, scratch,
            scratch_size, out_a, out_b, capacity, state)
    }
    #[inline]
    unsafe fn join_within(index_a: *const c_void, sets_a: *const Shapes<f64>, set_count_a: i32, index_b: *const c_void,
        sets_b: *const Shapes<f64>, set_count_b: i32, distance: f64, part: i64, parts: i64, out_a: *mut i64,
        out_b: *mut i64, capacity: i64, state: *mut i64) -> i64 {
        vesica_join_within_f64(index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, distance, part, parts, out_a,
            out_b, capacity, state)
    }
    #[inline]
    unsafe fn index_nearest(index: *const c_void, sets: *const Shapes<f64>, set_count: i32, one: *const Shapes<f64>,
        k: i64, within: f64, out: *mut i64, distance: *mut f64) -> i64 {
        vesica_index_nearest_f64(index, sets, set_count, one, k, within, out, distance)
    }
    #[inline]
    unsafe fn join_nearest(sets_a: *const Shapes<f64>, set_count_a: i32, index_b: *const c_void,
        sets_b: *const Shapes<f64>, set_count_b: i32, k: i64, within: f64, part: i64, parts: i64, out: *mut i64,
        distance: *mut f64) -> i64 {
        vesica_join_nearest_f64(sets_a, set_count_a, index_b, sets_b, set_count_b, k, within, part, parts, out,
            distance)
    }
    #[inline]
    unsafe fn polygon_boxes(kind: i32, path: *const c_void, boxes: *mut c_void, size: i64) -> i32 {
        vesica_polygon_boxes_f64(kind, path, boxes, size)
    }
    #[inline]
    unsafe fn polygon_boxes_overlap(kind: i32, path: *const c_void, boxes: *const c_void, size: i64, kind_b: i32,
        b: *const c_void) -> i32 {
        vesica_polygon_boxes_overlap_f64(kind, path, boxes, size, kind_b, b)
    }
    #[inline]
    unsafe fn polygon_boxes_nearest(kind: i32, path: *const c_void, boxes: *const c_void, size: i64, kind_b: i32,
        b: *const c_void, out: *mut ClosestPoints<f64>) -> i32 {
        vesica_polygon_boxes_nearest_f64(kind, path, boxes, size, kind_b, b, out)
    }
    #[inline]
    unsafe fn polygon_boxes_within(kind: i32, path: *const c_void, boxes: *const c_void, size: i64, kind_b: i32,
        b: *const c_void, distance: f64) -> i32 {
        vesica_polygon_boxes_within_f64(kind, path, boxes, size, kind_b, b, distance)
    }
    #[inline]
    unsafe fn ratio(ratio: i32, kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f64) -> i32 {
        vesica_ratio_f64(ratio, kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn ratio_many(ratio: i32, a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64) -> i64 {
        vesica_ratio_many_f64(ratio, a, b, out)
    }
    #[inline]
    unsafe fn ratio_matrix(ratio: i32, a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64,
        row_stride: isize) -> i64 {
        vesica_ratio_matrix_f64(ratio, a, b, out, row_stride)
    }
    #[inline]
    unsafe fn nearest_matrix(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64, row_stride: isize) -> i64 {
        vesica_nearest_matrix_f64(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn boundary_distance_matrix(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64,
        row_stride: isize) -> i64 {
        vesica_boundary_distance_matrix_f64(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn depth_matrix(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64, row_stride: isize) -> i64 {
        vesica_depth_matrix_f64(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn signed_distance(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f64) -> i32 {
        vesica_signed_distance_f64(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn signed_distance_many(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64) -> i64 {
        vesica_signed_distance_many_f64(a, b, out)
    }
    #[inline]
    unsafe fn signed_distance_matrix(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut f64,
        row_stride: isize) -> i64 {
        vesica_signed_distance_matrix_f64(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn within(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, distance: f64) -> i32 {
        vesica_within_f64(kind_a, a, kind_b, b, distance)
    }
    #[inline]
    unsafe fn within_many(a: *const Shapes<f64>, b: *const Shapes<f64>, distance: f64, out: *mut u8) -> i64 {
        vesica_within_many_f64(a, b, distance, out)
    }
    #[inline]
    unsafe fn within_matrix(a: *const Shapes<f64>, b: *const Shapes<f64>, distance: f64, out: *mut u8,
        row_stride: isize) -> i64 {
        vesica_within_matrix_f64(a, b, distance, out, row_stride)
    }
    #[inline]
    unsafe fn suppress(shapes: *const Shapes<f64>, scores: *const f64, labels: *const i32, ratio: i32, threshold: f64,
        least_score: f64, most: i64, scratch: *mut c_void, scratch_size: i64, keep: *mut i64, kept: *mut i64) -> i32 {
        vesica_suppress_f64(shapes, scores, labels, ratio, threshold, least_score, most, scratch, scratch_size, keep,
            kept)
    }
    #[inline]
    unsafe fn suppress_soft(shapes: *const Shapes<f64>, scores: *const f64, labels: *const i32, ratio: i32, decay: i32,
        parameter: f64, least_score: f64, most: i64, scratch: *mut c_void, scratch_size: i64, keep: *mut i64,
        decayed: *mut f64, kept: *mut i64) -> i32 {
        vesica_suppress_soft_f64(shapes, scores, labels, ratio, decay, parameter, least_score, most, scratch,
            scratch_size, keep, decayed, kept)
    }
    #[inline]
    unsafe fn coverage(kind: i32, shape: *const c_void, grid: *const Grid<f64>, out: *mut f64,
        row_stride: isize) -> i32 {
        vesica_coverage_f64(kind, shape, grid, out, row_stride)
    }
    #[inline]
    unsafe fn coverage_cells(kind: i32, shape: *const c_void, grid: *const Grid<f64>, cells: *mut i64, shares: *mut f64,
        capacity: i64) -> i64 {
        vesica_coverage_cells_f64(kind, shape, grid, cells, shares, capacity)
    }
    #[inline]
    unsafe fn cast(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32 {
        vesica_cast_f64(kind_a, a, kind_b, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_many(a: *const Shapes<f64>, b: *const Shapes<f64>, vx: *const f64, vy: *const f64, stride: isize,
        t_end: f64, t: *mut f64, x: *mut f64, y: *mut f64, nx: *mut f64, ny: *mut f64) -> i64 {
        vesica_cast_many_f64(a, b, vx, vy, stride, t_end, t, x, y, nx, ny)
    }
    #[inline]
    unsafe fn cast_first(one: *const Shapes<f64>, many: *const Shapes<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i64 {
        vesica_cast_first_f64(one, many, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn sweep_bounds(kind: i32, shape: *const c_void, vx: f64, vy: f64, t_end: f64, out: *mut Aabb<f64>) -> i32 {
        vesica_sweep_bounds_f64(kind, shape, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn index_cast(index: *const c_void, sets: *const Shapes<f64>, set_count: i32, one: *const Shapes<f64>,
        vx: f64, vy: f64, t_end: f64, out: *mut i64, capacity: i64, state: *mut i64) -> i64 {
        vesica_index_cast_f64(index, sets, set_count, one, vx, vy, t_end, out, capacity, state)
    }
    #[inline]
    unsafe fn index_cast_first(index: *const c_void, sets: *const Shapes<f64>, set_count: i32, one: *const Shapes<f64>,
        vx: f64, vy: f64, t_end: f64, out: *mut Impact<f64>) -> i64 {
        vesica_index_cast_first_f64(index, sets, set_count, one, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn impact_time(kind_a: i32, a: *const c_void, turn_a: *const Turn<f64>, kind_b: i32, b: *const c_void,
        turn_b: *const Turn<f64>, tolerance: f64, out: *mut Impact<f64>, gap: *mut f64) -> i32 {
        vesica_impact_time_f64(kind_a, a, turn_a, kind_b, b, turn_b, tolerance, out, gap)
    }
    #[inline]
    unsafe fn index_impact_time(index: *const c_void, sets: *const Shapes<f64>, set_count: i32, one: *const Shapes<f64>,
        turn: *const Turn<f64>, tolerance: f64, out: *mut Impact<f64>, gap: *mut f64, answer: *mut i32) -> i64 {
        vesica_index_impact_time_f64(index, sets, set_count, one, turn, tolerance, out, gap, answer)
    }
    #[inline]
    unsafe fn manifold(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Contacts<f64>) -> i32 {
        vesica_manifold_f64(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn manifold_many(a: *const Shapes<f64>, b: *const Shapes<f64>, out: *mut Contacts<f64>) -> i64 {
        vesica_manifold_many_f64(a, b, out)
    }
    #[inline]
    unsafe fn cast_point_point(a: *const Point<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32 {
        vesica_cast_point_point_f64(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_segment_point(a: *const Segment<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32 {
        vesica_cast_segment_point_f64(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_circle_point(a: *const Circle<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32 {
        vesica_cast_circle_point_f64(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_aabb_point(a: *const Aabb<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32 {
        vesica_cast_aabb_point_f64(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_rect_point(a: *const Rect<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32 {
        vesica_cast_rect_point_f64(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_ellipse_point(a: *const Ellipse<f64>, b: *const Point<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32 {
        vesica_cast_ellipse_point_f64(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_circle_circle(a: *const Circle<f64>, b: *const Circle<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32 {
        vesica_cast_circle_circle_f64(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_rect_rect(a: *const Rect<f64>, b: *const Rect<f64>, vx: f64, vy: f64, t_end: f64,
        out: *mut Impact<f64>) -> i32 {
        vesica_cast_rect_rect_f64(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn de9im(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, matrix: *mut u8) -> i32 {
        vesica_de9im_f64(kind_a, a, kind_b, b, matrix)
    }
    #[inline]
    unsafe fn intersection(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Point<f64>,
        capacity: i64) -> i64 {
        vesica_intersection_f64(kind_a, a, kind_b, b, out, capacity)
    }
}
unsafe impl Scalar for f32 {
    #[inline]
    unsafe fn overlap(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32 {
        vesica_overlap_f32(kind_a, a, kind_b, b)
    }
    #[inline]
    unsafe fn interiors_overlap(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32 {
        vesica_interiors_overlap_f32(kind_a, a, kind_b, b)
    }
    #[inline]
    unsafe fn contains(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32 {
        vesica_contains_f32(kind_a, a, kind_b, b)
    }
    #[inline]
    unsafe fn relation(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void) -> i32 {
        vesica_relation_f32(kind_a, a, kind_b, b)
    }
    #[inline]
    unsafe fn nearest(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut ClosestPoints<f32>) -> i32 {
        vesica_nearest_f32(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn depth(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Penetration<f32>) -> i32 {
        vesica_depth_f32(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn area(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f32) -> i32 {
        vesica_area_f32(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn iou(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f32) -> i32 {
        vesica_iou_f32(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn bounds(kind: i32, shape: *const c_void, out: *mut Aabb<f32>) -> i32 {
        vesica_bounds_f32(kind, shape, out)
    }
    #[inline]
    unsafe fn check(kind: i32, shape: *const c_void) -> i32 {
        vesica_check_f32(kind, shape)
    }
    #[inline]
    unsafe fn crossings(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Point<f32>,
        capacity: i64, shared: *mut i32) -> i64 {
        vesica_crossings_f32(kind_a, a, kind_b, b, out, capacity, shared)
    }
    #[inline]
    unsafe fn boundary_distance(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut ClosestPoints<f32>) -> i32 {
        vesica_boundary_distance_f32(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn shape_area(kind: i32, shape: *const c_void, out: *mut f32) -> i32 {
        vesica_shape_area_f32(kind, shape, out)
    }
    #[inline]
    unsafe fn polygon_facts(polygon: *const Polygon<f32>, out: *mut Facts<f32>) -> i32 {
        vesica_polygon_facts_f32(polygon, out)
    }
    #[inline]
    unsafe fn overlap_point_point(a: *const Point<f32>, b: *const Point<f32>) -> i32 {
        vesica_overlap_point_point_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_point_segment(a: *const Point<f32>, b: *const Segment<f32>) -> i32 {
        vesica_overlap_point_segment_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_point_circle(a: *const Point<f32>, b: *const Circle<f32>) -> i32 {
        vesica_overlap_point_circle_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_point_aabb(a: *const Point<f32>, b: *const Aabb<f32>) -> i32 {
        vesica_overlap_point_aabb_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_point_rect(a: *const Point<f32>, b: *const Rect<f32>) -> i32 {
        vesica_overlap_point_rect_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_point_ellipse(a: *const Point<f32>, b: *const Ellipse<f32>) -> i32 {
        vesica_overlap_point_ellipse_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_segment_segment(a: *const Segment<f32>, b: *const Segment<f32>) -> i32 {
        vesica_overlap_segment_segment_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_segment_circle(a: *const Segment<f32>, b: *const Circle<f32>) -> i32 {
        vesica_overlap_segment_circle_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_segment_aabb(a: *const Segment<f32>, b: *const Aabb<f32>) -> i32 {
        vesica_overlap_segment_aabb_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_segment_rect(a: *const Segment<f32>, b: *const Rect<f32>) -> i32 {
        vesica_overlap_segment_rect_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_segment_ellipse(a: *const Segment<f32>, b: *const Ellipse<f32>) -> i32 {
        vesica_overlap_segment_ellipse_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_circle_circle(a: *const Circle<f32>, b: *const Circle<f32>) -> i32 {
        vesica_overlap_circle_circle_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_circle_aabb(a: *const Circle<f32>, b: *const Aabb<f32>) -> i32 {
        vesica_overlap_circle_aabb_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_circle_rect(a: *const Circle<f32>, b: *const Rect<f32>) -> i32 {
        vesica_overlap_circle_rect_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_circle_ellipse(a: *const Circle<f32>, b: *const Ellipse<f32>) -> i32 {
        vesica_overlap_circle_ellipse_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_aabb_aabb(a: *const Aabb<f32>, b: *const Aabb<f32>) -> i32 {
        vesica_overlap_aabb_aabb_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_aabb_rect(a: *const Aabb<f32>, b: *const Rect<f32>) -> i32 {
        vesica_overlap_aabb_rect_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_aabb_ellipse(a: *const Aabb<f32>, b: *const Ellipse<f32>) -> i32 {
        vesica_overlap_aabb_ellipse_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_rect_rect(a: *const Rect<f32>, b: *const Rect<f32>) -> i32 {
        vesica_overlap_rect_rect_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_rect_ellipse(a: *const Rect<f32>, b: *const Ellipse<f32>) -> i32 {
        vesica_overlap_rect_ellipse_f32(a, b)
    }
    #[inline]
    unsafe fn overlap_ellipse_ellipse(a: *const Ellipse<f32>, b: *const Ellipse<f32>) -> i32 {
        vesica_overlap_ellipse_ellipse_f32(a, b)
    }
    #[inline]
    unsafe fn aabb_from_corners(x0: f32, y0: f32, x1: f32, y1: f32, out: *mut Aabb<f32>) -> i32 {
        vesica_aabb_from_corners_f32(x0, y0, x1, y1, out)
    }
    #[inline]
    unsafe fn rect_from_angle(cx: f32, cy: f32, angle: f32, width: f32, height: f32, out: *mut Rect<f32>) -> i32 {
        vesica_rect_from_angle_f32(cx, cy, angle, width, height, out)
    }
    #[inline]
    unsafe fn rect_from_corners(corners: *const f32, out: *mut Rect<f32>) -> i32 {
        vesica_rect_from_corners_f32(corners, out)
    }
    #[inline]
    unsafe fn rect_corners_misfit(corners: *const f32, r: *const Rect<f32>, misfit: *mut f32) -> i32 {
        vesica_rect_corners_misfit_f32(corners, r, misfit)
    }
    #[inline]
    unsafe fn round_rect_from_angle(cx: f32, cy: f32, angle: f32, width: f32, height: f32, radius: f32,
        out: *mut RoundRect<f32>) -> i32 {
        vesica_round_rect_from_angle_f32(cx, cy, angle, width, height, radius, out)
    }
    #[inline]
    unsafe fn capsule_from_angle(cx: f32, cy: f32, angle: f32, length: f32, radius: f32,
        out: *mut Capsule<f32>) -> i32 {
        vesica_capsule_from_angle_f32(cx, cy, angle, length, radius, out)
    }
    #[inline]
    unsafe fn capsule_from_width(x0: f32, y0: f32, x1: f32, y1: f32, width: f32, out: *mut Capsule<f32>) -> i32 {
        vesica_capsule_from_width_f32(x0, y0, x1, y1, width, out)
    }
    #[inline]
    unsafe fn ellipse_from_angle(cx: f32, cy: f32, angle: f32, a: f32, b: f32, out: *mut Ellipse<f32>) -> i32 {
        vesica_ellipse_from_angle_f32(cx, cy, angle, a, b, out)
    }
    #[inline]
    unsafe fn ellipse_from_radius_vector(cx: f32, cy: f32, wx: f32, wy: f32, ratio: f32,
        out: *mut Ellipse<f32>) -> i32 {
        vesica_ellipse_from_radius_vector_f32(cx, cy, wx, wy, ratio, out)
    }
    #[inline]
    unsafe fn ellipse_from_covariance(mean_x: f32, mean_y: f32, cxx: f32, cxy: f32, cyy: f32, k: f32,
        out: *mut Ellipse<f32>) -> i32 {
        vesica_ellipse_from_covariance_f32(mean_x, mean_y, cxx, cxy, cyy, k, out)
    }
    #[inline]
    unsafe fn ellipse_from_matrix(cx: f32, cy: f32, mxx: f32, mxy: f32, myy: f32, out: *mut Ellipse<f32>) -> i32 {
        vesica_ellipse_from_matrix_f32(cx, cy, mxx, mxy, myy, out)
    }
    #[inline]
    unsafe fn shapes_from_records(kind: i32, count: i64, base: *const c_void, stride: isize,
        out: *mut Shapes<f32>) -> i32 {
        vesica_shapes_from_records_f32(kind, count, base, stride, out)
    }
    #[inline]
    unsafe fn overlap_many(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8) -> i64 {
        vesica_overlap_many_f32(a, b, out)
    }
    #[inline]
    unsafe fn interiors_overlap_many(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8) -> i64 {
        vesica_interiors_overlap_many_f32(a, b, out)
    }
    #[inline]
    unsafe fn relation_many(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8) -> i64 {
        vesica_relation_many_f32(a, b, out)
    }
    #[inline]
    unsafe fn contains_many(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8) -> i64 {
        vesica_contains_many_f32(a, b, out)
    }
    #[inline]
    unsafe fn nearest_many(a: *const Shapes<f32>, b: *const Shapes<f32>, distance: *mut f32, ax: *mut f32, ay: *mut f32,
        bx: *mut f32, by: *mut f32) -> i64 {
        vesica_nearest_many_f32(a, b, distance, ax, ay, bx, by)
    }
    #[inline]
    unsafe fn boundary_distance_many(a: *const Shapes<f32>, b: *const Shapes<f32>, distance: *mut f32, ax: *mut f32,
        ay: *mut f32, bx: *mut f32, by: *mut f32) -> i64 {
        vesica_boundary_distance_many_f32(a, b, distance, ax, ay, bx, by)
    }
    #[inline]
    unsafe fn depth_many(a: *const Shapes<f32>, b: *const Shapes<f32>, depth: *mut f32, x: *mut f32,
        y: *mut f32) -> i64 {
        vesica_depth_many_f32(a, b, depth, x, y)
    }
    #[inline]
    unsafe fn area_many(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32) -> i64 {
        vesica_area_many_f32(a, b, out)
    }
    #[inline]
    unsafe fn iou_many(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32) -> i64 {
        vesica_iou_many_f32(a, b, out)
    }
    #[inline]
    unsafe fn overlap_matrix(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8, row_stride: isize) -> i64 {
        vesica_overlap_matrix_f32(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn interiors_overlap_matrix(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8,
        row_stride: isize) -> i64 {
        vesica_interiors_overlap_matrix_f32(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn relation_matrix(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8, row_stride: isize) -> i64 {
        vesica_relation_matrix_f32(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn contains_matrix(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut u8, row_stride: isize) -> i64 {
        vesica_contains_matrix_f32(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn area_matrix(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32, row_stride: isize) -> i64 {
        vesica_area_matrix_f32(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn iou_matrix(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32, row_stride: isize) -> i64 {
        vesica_iou_matrix_f32(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn overlap_select(one: *const Shapes<f32>, many: *const Shapes<f32>, out: *mut i64, capacity: i64) -> i64 {
        vesica_overlap_select_f32(one, many, out, capacity)
    }
    #[inline]
    unsafe fn interiors_overlap_select(one: *const Shapes<f32>, many: *const Shapes<f32>, out: *mut i64,
        capacity: i64) -> i64 {
        vesica_interiors_overlap_select_f32(one, many, out, capacity)
    }
    #[inline]
    unsafe fn nms(shapes: *const Shapes<f32>, scores: *const f32, threshold: f32, scratch: *mut c_void,
        scratch_size: i64, keep: *mut i64, kept: *mut i64) -> i32 {
        vesica_nms_f32(shapes, scores, threshold, scratch, scratch_size, keep, kept)
    }
    #[inline]
    unsafe fn rects_from_boxes(boxes: *const f32, count: i64, stride: isize, angle: i32, out: *mut Rect<f32>) -> i64 {
        vesica_rects_from_boxes_f32(boxes, count, stride, angle, out)
    }
    #[inline]
    unsafe fn ellipses_from_boxes(boxes: *const f32, count: i64, stride: isize, angle: i32,
        out: *mut Ellipse<f32>) -> i64 {
        vesica_ellipses_from_boxes_f32(boxes, count, stride, angle, out)
    }
    #[inline]
    unsafe fn rects_from_corners(corners: *const f32, count: i64, stride: isize, out: *mut Rect<f32>) -> i64 {
        vesica_rects_from_corners_f32(corners, count, stride, out)
    }
    #[inline]
    unsafe fn rect_corners_misfit_many(corners: *const f32, stride: isize, rects: *const Shapes<f32>,
        misfit: *mut f32) -> i64 {
        vesica_rect_corners_misfit_many_f32(corners, stride, rects, misfit)
    }
    #[inline]
    unsafe fn boxes_from_shapes(shapes: *const Shapes<f32>, angle: i32, boxes: *mut f32) -> i64 {
        vesica_boxes_from_shapes_f32(shapes, angle, boxes)
    }
    #[inline]
    unsafe fn corners_of_shapes(shapes: *const Shapes<f32>, corners: *mut f32) -> i64 {
        vesica_corners_of_shapes_f32(shapes, corners)
    }
    #[inline]
    unsafe fn bounds_many(shapes: *const Shapes<f32>, out: *mut Aabb<f32>) -> i64 {
        vesica_bounds_many_f32(shapes, out)
    }
    #[inline]
    unsafe fn shape_area_many(shapes: *const Shapes<f32>, out: *mut f32) -> i64 {
        vesica_shape_area_many_f32(shapes, out)
    }
    #[inline]
    unsafe fn convex_hull(points: *const Polygon<f32>, out: *mut Point<f32>, capacity: i64) -> i64 {
        vesica_convex_hull_f32(points, out, capacity)
    }
    #[inline]
    unsafe fn min_area_rect(points: *const Polygon<f32>, out: *mut Rect<f32>) -> i32 {
        vesica_min_area_rect_f32(points, out)
    }
    #[inline]
    unsafe fn min_perimeter_rect(points: *const Polygon<f32>, out: *mut Rect<f32>) -> i32 {
        vesica_min_perimeter_rect_f32(points, out)
    }
    #[inline]
    unsafe fn min_area_rect_many(points: *const Shapes<f32>, out: *mut Rect<f32>) -> i64 {
        vesica_min_area_rect_many_f32(points, out)
    }
    #[inline]
    unsafe fn min_perimeter_rect_many(points: *const Shapes<f32>, out: *mut Rect<f32>) -> i64 {
        vesica_min_perimeter_rect_many_f32(points, out)
    }
    #[inline]
    unsafe fn join_ratio(ratio: i32, threshold: f32, index_a: *const c_void, sets_a: *const Shapes<f32>,
        set_count_a: i32, index_b: *const c_void, sets_b: *const Shapes<f32>, set_count_b: i32, part: i64, parts: i64,
        scratch: *mut c_void, scratch_size: i64, out_a: *mut i64, out_b: *mut i64, values: *mut f32, capacity: i64,
        state: *mut i64) -> i64 {
        vesica_join_ratio_f32(ratio, threshold, index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, part, parts,
            scratch, scratch_size, out_a, out_b, values, capacity, state)
    }
    #[inline]
    unsafe fn assign_greedy(a: *const i64, b: *const i64, values: *const f32, count: i64, count_a: i64, count_b: i64,
        scratch: *mut c_void, scratch_size: i64, chosen: *mut i64) -> i64 {
        vesica_assign_greedy_f32(a, b, values, count, count_a, count_b, scratch, scratch_size, chosen)
    }
    #[inline]
    unsafe fn fuse(shapes: *const Shapes<f32>, scores: *const f32, weights: *const f32, labels: *const i32,
        threshold: f32, fused_score: i32, scratch: *mut c_void, scratch_size: i64, fused: *mut c_void,
        fused_scores: *mut f32, clusters: *mut i64, count: *mut i64) -> i32 {
        vesica_fuse_f32(shapes, scores, weights, labels, threshold, fused_score, scratch, scratch_size, fused,
            fused_scores, clusters, count)
    }
    #[inline]
    unsafe fn volume_ratio(ratio: i32, kind_a: i32, a: *const c_void, span_a: *const Span<f32>, kind_b: i32,
        b: *const c_void, span_b: *const Span<f32>, out: *mut f32) -> i32 {
        vesica_volume_ratio_f32(ratio, kind_a, a, span_a, kind_b, b, span_b, out)
    }
    #[inline]
    unsafe fn volume_ratio_many(ratio: i32, a: *const Shapes<f32>, spans_a: *const Span<f32>, b: *const Shapes<f32>,
        spans_b: *const Span<f32>, out: *mut f32) -> i64 {
        vesica_volume_ratio_many_f32(ratio, a, spans_a, b, spans_b, out)
    }
    #[inline]
    unsafe fn volume_ratio_matrix(ratio: i32, a: *const Shapes<f32>, spans_a: *const Span<f32>, b: *const Shapes<f32>,
        spans_b: *const Span<f32>, out: *mut f32, row_stride: isize) -> i64 {
        vesica_volume_ratio_matrix_f32(ratio, a, spans_a, b, spans_b, out, row_stride)
    }
    #[inline]
    unsafe fn match_truths(rule: i32, a: *const i64, b: *const i64, values: *const f32, count: i64, scores: *const f32,
        detections: i64, flags: *const u8, truths: i64, thresholds: *const f32, threshold_count: i64,
        scratch: *mut c_void, scratch_size: i64, outcomes: *mut u8, taken: *mut i64) -> i32 {
        vesica_match_truths_f32(rule, a, b, values, count, scores, detections, flags, truths, thresholds,
            threshold_count, scratch, scratch_size, outcomes, taken)
    }
    #[inline]
    unsafe fn average_precision(rule: i32, scores: *const f32, outcomes: *const u8, count: i64, truths: i64,
        scratch: *mut c_void, scratch_size: i64, out: *mut f32) -> i32 {
        vesica_average_precision_f32(rule, scores, outcomes, count, truths, scratch, scratch_size, out)
    }
    #[inline]
    unsafe fn gaussian_distance(which: i32, kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void,
        out: *mut f32) -> i32 {
        vesica_gaussian_distance_f32(which, kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn gaussian_distance_many(which: i32, a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32) -> i64 {
        vesica_gaussian_distance_many_f32(which, a, b, out)
    }
    #[inline]
    unsafe fn gaussian_distance_matrix(which: i32, a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32,
        row_stride: isize) -> i64 {
        vesica_gaussian_distance_matrix_f32(which, a, b, out, row_stride)
    }
    #[inline]
    unsafe fn index_build(sets: *const Shapes<f32>, set_count: i32, index: *mut c_void, index_size: i64,
        scratch: *mut c_void, scratch_size: i64) -> i64 {
        vesica_index_build_f32(sets, set_count, index, index_size, scratch, scratch_size)
    }
    #[inline]
    unsafe fn index_step(step: i32, part: i64, parts: i64, sets: *const Shapes<f32>, set_count: i32, index: *mut c_void,
        index_size: i64, scratch: *mut c_void, scratch_size: i64) -> i64 {
        vesica_index_step_f32(step, part, parts, sets, set_count, index, index_size, scratch, scratch_size)
    }
    #[inline]
    unsafe fn index_select(index: *const c_void, sets: *const Shapes<f32>, set_count: i32, one: *const Shapes<f32>,
        out: *mut i64, capacity: i64, state: *mut i64) -> i64 {
        vesica_index_select_f32(index, sets, set_count, one, out, capacity, state)
    }
    #[inline]
    unsafe fn join(query: i32, index_a: *const c_void, sets_a: *const Shapes<f32>, set_count_a: i32,
        index_b: *const c_void, sets_b: *const Shapes<f32>, set_count_b: i32, part: i64, parts: i64,
        scratch: *mut c_void, scratch_size: i64, out_a: *mut i64, out_b: *mut i64, capacity: i64,
        state: *mut i64) -> i64 {
        vesica_join_f32(query, index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, part, parts, scratch,
            scratch_size, out_a, out_b, capacity, state)
    }
    #[inline]
    unsafe fn join_within(index_a: *const c_void, sets_a: *const Shapes<f32>, set_count_a: i32, index_b: *const c_void,
        sets_b: *const Shapes<f32>, set_count_b: i32, distance: f32, part: i64, parts: i64, out_a: *mut i64,
        out_b: *mut i64, capacity: i64, state: *mut i64) -> i64 {
        vesica_join_within_f32(index_a, sets_a, set_count_a, index_b, sets_b, set_count_b, distance, part, parts, out_a,
            out_b, capacity, state)
    }
    #[inline]
    unsafe fn index_nearest(index: *const c_void, sets: *const Shapes<f32>, set_count: i32, one: *const Shapes<f32>,
        k: i64, within: f32, out: *mut i64, distance: *mut f32) -> i64 {
        vesica_index_nearest_f32(index, sets, set_count, one, k, within, out, distance)
    }
    #[inline]
    unsafe fn join_nearest(sets_a: *const Shapes<f32>, set_count_a: i32, index_b: *const c_void,
        sets_b: *const Shapes<f32>, set_count_b: i32, k: i64, within: f32, part: i64, parts: i64, out: *mut i64,
        distance: *mut f32) -> i64 {
        vesica_join_nearest_f32(sets_a, set_count_a, index_b, sets_b, set_count_b, k, within, part, parts, out,
            distance)
    }
    #[inline]
    unsafe fn polygon_boxes(kind: i32, path: *const c_void, boxes: *mut c_void, size: i64) -> i32 {
        vesica_polygon_boxes_f32(kind, path, boxes, size)
    }
    #[inline]
    unsafe fn polygon_boxes_overlap(kind: i32, path: *const c_void, boxes: *const c_void, size: i64, kind_b: i32,
        b: *const c_void) -> i32 {
        vesica_polygon_boxes_overlap_f32(kind, path, boxes, size, kind_b, b)
    }
    #[inline]
    unsafe fn polygon_boxes_nearest(kind: i32, path: *const c_void, boxes: *const c_void, size: i64, kind_b: i32,
        b: *const c_void, out: *mut ClosestPoints<f32>) -> i32 {
        vesica_polygon_boxes_nearest_f32(kind, path, boxes, size, kind_b, b, out)
    }
    #[inline]
    unsafe fn polygon_boxes_within(kind: i32, path: *const c_void, boxes: *const c_void, size: i64, kind_b: i32,
        b: *const c_void, distance: f32) -> i32 {
        vesica_polygon_boxes_within_f32(kind, path, boxes, size, kind_b, b, distance)
    }
    #[inline]
    unsafe fn ratio(ratio: i32, kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f32) -> i32 {
        vesica_ratio_f32(ratio, kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn ratio_many(ratio: i32, a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32) -> i64 {
        vesica_ratio_many_f32(ratio, a, b, out)
    }
    #[inline]
    unsafe fn ratio_matrix(ratio: i32, a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32,
        row_stride: isize) -> i64 {
        vesica_ratio_matrix_f32(ratio, a, b, out, row_stride)
    }
    #[inline]
    unsafe fn nearest_matrix(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32, row_stride: isize) -> i64 {
        vesica_nearest_matrix_f32(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn boundary_distance_matrix(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32,
        row_stride: isize) -> i64 {
        vesica_boundary_distance_matrix_f32(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn depth_matrix(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32, row_stride: isize) -> i64 {
        vesica_depth_matrix_f32(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn signed_distance(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut f32) -> i32 {
        vesica_signed_distance_f32(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn signed_distance_many(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32) -> i64 {
        vesica_signed_distance_many_f32(a, b, out)
    }
    #[inline]
    unsafe fn signed_distance_matrix(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut f32,
        row_stride: isize) -> i64 {
        vesica_signed_distance_matrix_f32(a, b, out, row_stride)
    }
    #[inline]
    unsafe fn within(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, distance: f32) -> i32 {
        vesica_within_f32(kind_a, a, kind_b, b, distance)
    }
    #[inline]
    unsafe fn within_many(a: *const Shapes<f32>, b: *const Shapes<f32>, distance: f32, out: *mut u8) -> i64 {
        vesica_within_many_f32(a, b, distance, out)
    }
    #[inline]
    unsafe fn within_matrix(a: *const Shapes<f32>, b: *const Shapes<f32>, distance: f32, out: *mut u8,
        row_stride: isize) -> i64 {
        vesica_within_matrix_f32(a, b, distance, out, row_stride)
    }
    #[inline]
    unsafe fn suppress(shapes: *const Shapes<f32>, scores: *const f32, labels: *const i32, ratio: i32, threshold: f32,
        least_score: f32, most: i64, scratch: *mut c_void, scratch_size: i64, keep: *mut i64, kept: *mut i64) -> i32 {
        vesica_suppress_f32(shapes, scores, labels, ratio, threshold, least_score, most, scratch, scratch_size, keep,
            kept)
    }
    #[inline]
    unsafe fn suppress_soft(shapes: *const Shapes<f32>, scores: *const f32, labels: *const i32, ratio: i32, decay: i32,
        parameter: f32, least_score: f32, most: i64, scratch: *mut c_void, scratch_size: i64, keep: *mut i64,
        decayed: *mut f32, kept: *mut i64) -> i32 {
        vesica_suppress_soft_f32(shapes, scores, labels, ratio, decay, parameter, least_score, most, scratch,
            scratch_size, keep, decayed, kept)
    }
    #[inline]
    unsafe fn coverage(kind: i32, shape: *const c_void, grid: *const Grid<f32>, out: *mut f32,
        row_stride: isize) -> i32 {
        vesica_coverage_f32(kind, shape, grid, out, row_stride)
    }
    #[inline]
    unsafe fn coverage_cells(kind: i32, shape: *const c_void, grid: *const Grid<f32>, cells: *mut i64, shares: *mut f32,
        capacity: i64) -> i64 {
        vesica_coverage_cells_f32(kind, shape, grid, cells, shares, capacity)
    }
    #[inline]
    unsafe fn cast(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32 {
        vesica_cast_f32(kind_a, a, kind_b, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_many(a: *const Shapes<f32>, b: *const Shapes<f32>, vx: *const f32, vy: *const f32, stride: isize,
        t_end: f32, t: *mut f32, x: *mut f32, y: *mut f32, nx: *mut f32, ny: *mut f32) -> i64 {
        vesica_cast_many_f32(a, b, vx, vy, stride, t_end, t, x, y, nx, ny)
    }
    #[inline]
    unsafe fn cast_first(one: *const Shapes<f32>, many: *const Shapes<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i64 {
        vesica_cast_first_f32(one, many, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn sweep_bounds(kind: i32, shape: *const c_void, vx: f32, vy: f32, t_end: f32, out: *mut Aabb<f32>) -> i32 {
        vesica_sweep_bounds_f32(kind, shape, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn index_cast(index: *const c_void, sets: *const Shapes<f32>, set_count: i32, one: *const Shapes<f32>,
        vx: f32, vy: f32, t_end: f32, out: *mut i64, capacity: i64, state: *mut i64) -> i64 {
        vesica_index_cast_f32(index, sets, set_count, one, vx, vy, t_end, out, capacity, state)
    }
    #[inline]
    unsafe fn index_cast_first(index: *const c_void, sets: *const Shapes<f32>, set_count: i32, one: *const Shapes<f32>,
        vx: f32, vy: f32, t_end: f32, out: *mut Impact<f32>) -> i64 {
        vesica_index_cast_first_f32(index, sets, set_count, one, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn impact_time(kind_a: i32, a: *const c_void, turn_a: *const Turn<f32>, kind_b: i32, b: *const c_void,
        turn_b: *const Turn<f32>, tolerance: f32, out: *mut Impact<f32>, gap: *mut f32) -> i32 {
        vesica_impact_time_f32(kind_a, a, turn_a, kind_b, b, turn_b, tolerance, out, gap)
    }
    #[inline]
    unsafe fn index_impact_time(index: *const c_void, sets: *const Shapes<f32>, set_count: i32, one: *const Shapes<f32>,
        turn: *const Turn<f32>, tolerance: f32, out: *mut Impact<f32>, gap: *mut f32, answer: *mut i32) -> i64 {
        vesica_index_impact_time_f32(index, sets, set_count, one, turn, tolerance, out, gap, answer)
    }
    #[inline]
    unsafe fn manifold(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Contacts<f32>) -> i32 {
        vesica_manifold_f32(kind_a, a, kind_b, b, out)
    }
    #[inline]
    unsafe fn manifold_many(a: *const Shapes<f32>, b: *const Shapes<f32>, out: *mut Contacts<f32>) -> i64 {
        vesica_manifold_many_f32(a, b, out)
    }
    #[inline]
    unsafe fn cast_point_point(a: *const Point<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32 {
        vesica_cast_point_point_f32(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_segment_point(a: *const Segment<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32 {
        vesica_cast_segment_point_f32(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_circle_point(a: *const Circle<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32 {
        vesica_cast_circle_point_f32(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_aabb_point(a: *const Aabb<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32 {
        vesica_cast_aabb_point_f32(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_rect_point(a: *const Rect<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32 {
        vesica_cast_rect_point_f32(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_ellipse_point(a: *const Ellipse<f32>, b: *const Point<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32 {
        vesica_cast_ellipse_point_f32(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_circle_circle(a: *const Circle<f32>, b: *const Circle<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32 {
        vesica_cast_circle_circle_f32(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn cast_rect_rect(a: *const Rect<f32>, b: *const Rect<f32>, vx: f32, vy: f32, t_end: f32,
        out: *mut Impact<f32>) -> i32 {
        vesica_cast_rect_rect_f32(a, b, vx, vy, t_end, out)
    }
    #[inline]
    unsafe fn de9im(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, matrix: *mut u8) -> i32 {
        vesica_de9im_f32(kind_a, a, kind_b, b, matrix)
    }
    #[inline]
    unsafe fn intersection(kind_a: i32, a: *const c_void, kind_b: i32, b: *const c_void, out: *mut Point<f32>,
        capacity: i64) -> i64 {
        vesica_intersection_f32(kind_a, a, kind_b, b, out, capacity)
    }
}
