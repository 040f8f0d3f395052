// SPDX-License-Identifier: Apache-2.0
// Written by bindings/declare from capi/vesica.json: not to be edited.

package vesica

// #include "declarations.h"
import "C"

import "unsafe"

// Version of this header: major * 10000 + minor * 100 + patch.
const Version = 100

// Kind is a kind of shapes.
type Kind int32

// Kind values.
const (
	// KindPoint: x y
	KindPoint Kind = 0
	// KindSegment: x0 y0 x1 y1
	KindSegment Kind = 1
	// KindCircle: cx cy r
	KindCircle Kind = 2
	// KindAABB: min_x min_y max_x max_y
	KindAABB Kind = 3
	// KindRect: cx cy ux uy hx hy
	KindRect Kind = 4
	// KindEllipse: cx cy ux uy a b
	KindEllipse Kind = 5
	// KindCapsule: x0 y0 x1 y1 r
	KindCapsule Kind = 6
	// KindRoundRect: cx cy ux uy hx hy r
	KindRoundRect Kind = 7
	// KindPolygon: vertices of one or more rings
	KindPolygon Kind = 8
	// KindPolyline: vertices of one or more chains
	KindPolyline Kind = 9
)

// Relation is how a shape relates to another: one of RCC-8's eight.
type Relation uint8

// Relation values.
const (
	// RelationDisjoint: a and b have no common point
	RelationDisjoint Relation = 0
	// RelationTouch: they have common points, but their insides have none
	RelationTouch Relation = 1
	// RelationCross: their insides meet, and neither shape contains the other
	RelationCross Relation = 2
	// RelationInside: b contains a, and a has no point of b's outline
	RelationInside Relation = 3
	// RelationInsideTouch: b contains a, and a has points of b's outline
	RelationInsideTouch Relation = 4
	// RelationContains: a contains b, and b has no point of a's outline
	RelationContains Relation = 5
	// RelationContainsTouch: a contains b, and b has points of a's outline
	RelationContainsTouch Relation = 6
	// RelationEqual: a and b are the same set of points
	RelationEqual Relation = 7
)

// Error is an error code of the library.
type Error int32

// Error values.
const (
	// ErrNull: a pointer is NULL
	ErrNull Error = -1
	// ErrShape: a shape is invalid; vesica_check_f64 or _f32 says why
	ErrShape Error = -2
	// ErrKind: a number is no kind, or the function does not take the kind
	ErrKind Error = -3
	// ErrArgument: another argument is out of its documented range
	ErrArgument Error = -4
	// ErrNotFinite: a number is NaN or infinite
	ErrNotFinite Error = -5
	// ErrNegativeSize: a radius, half extent or half length is negative
	ErrNegativeSize Error = -6
	// ErrZeroAxis: the axis (ux, uy) is (0, 0)
	ErrZeroAxis Error = -7
	// ErrInverted: an AABB's min exceeds its max
	ErrInverted Error = -8
	// ErrRange: a number of the result would overflow its type
	ErrRange Error = -9
	// ErrIndex: bytes are not an index of this version, or are damaged
	ErrIndex Error = -10
	// ErrRings: a polygon has no vertex, or its offsets are negative or decrease
	ErrRings Error = -11
	// ErrNotSimple: edges of a polygon cross, or overlap along a stretch
	ErrNotSimple Error = -12
	// ErrNotConvex: a polygon is not convex, as the function requires
	ErrNotConvex Error = -13
)

// JoinQuery is what makes a pair of a join.
type JoinQuery int32

// JoinQuery values.
const (
	// JoinOverlap: a and b overlap, as by vesica_overlap_f64
	JoinOverlap JoinQuery = 0
	// JoinBounds: their bounds in the indexes do: all pairs that overlap, and some that do not
	JoinBounds JoinQuery = 1
	// JoinContains: a contains b, as by vesica_contains_f64
	JoinContains JoinQuery = 2
	// JoinInside: b contains a
	JoinInside JoinQuery = 3
	// JoinInteriors: their insides share a point, as by vesica_interiors_overlap_f64
	JoinInteriors JoinQuery = 4
)

// Ratio is what a shared area is compared with.
type Ratio int32

// Ratio values.
const (
	// RatioOverUnion: shared area / area of the union of a and b (IoU)
	RatioOverUnion Ratio = 0
	// RatioOverFirst: shared area / area of a (IoF)
	RatioOverFirst Ratio = 1
	// RatioOverSecond: shared area / area of b (IoA)
	RatioOverSecond Ratio = 2
	// RatioOverSmaller: shared area / the smaller of the areas (IoS)
	RatioOverSmaller Ratio = 3
	// RatioGeneralized: IoU - (area of the hull that neither covers / area of the hull) (GIoU)
	RatioGeneralized Ratio = 4
	// RatioDistance: IoU - (distance of the centres / diagonal of the hull)^2 (DIoU)
	RatioDistance Ratio = 5
	// RatioComplete: DIoU - v^2 / (1 - IoU + v), v = (difference of angles / 90 degrees)^2 (CIoU)
	RatioComplete Ratio = 6
)

// Angle is how angles are told, from +x towards +y.
type Angle int32

// Angle values.
const (
	// AngleRadians: radians
	AngleRadians Angle = 0
	// AngleDegrees: degrees
	AngleDegrees Angle = 1
	// AngleQuarters: quarter turns
	AngleQuarters Angle = 2
	// AngleReversed: added to a unit: angles turn the other way, from +x towards -y
	AngleReversed Angle = 4
)

// Decay is how soft suppression lowers scores.
type Decay int32

// Decay values.
const (
	// DecayLinear: score * (1 - r) if r exceeds the parameter, a threshold from 0 to 1
	DecayLinear Decay = 0
	// DecayGaussian: score * exp(-r^2 / parameter) if r > 0; parameter from 2^-100, finite
	DecayGaussian Decay = 1
)

// WithinResult is whether two shapes are so near.
type WithinResult uint8

// WithinResult values.
const (
	// WithinNo: they are farther apart
	WithinNo WithinResult = 0
	// WithinYes: they are at most that far apart
	WithinYes WithinResult = 1
	// WithinNearly: only with ellipses: the distance is too close to the one asked for to decide
	WithinNearly WithinResult = 2
)

// CastResult is what a cast finds.
type CastResult int32

// CastResult values.
const (
	// CastMiss: no contact from 0 to t_end
	CastMiss CastResult = 0
	// CastHit: contact, the first after t = 0
	CastHit CastResult = 1
	// CastStart: the shapes overlap at t = 0, as vesica_overlap_f64 says
	CastStart CastResult = 2
	// CastNear: only from vesica_impact_time_f64: none before t, and perhaps none later
	CastNear CastResult = 3
)

// FusedScore is the score of a cluster of boxes that were fused.
type FusedScore int32

// FusedScore values.
const (
	// FusedMean: the mean of its scores s with weights w: sum(w s) / sum(w)
	FusedMean FusedScore = 0
	// FusedMax: its highest score
	FusedMax FusedScore = 1
)

// MatchRule is which truth a detection takes.
type MatchRule int32

// MatchRule values.
const (
	// MatchVoc: the one of the highest value, taken or not: if it is taken, the detection is a miss
	MatchVoc MatchRule = 0
	// MatchCoco: the one of the highest value among those that are free
	MatchCoco MatchRule = 1
)

// Truth is the part of a truth in the result.
type Truth uint8

// Truth values.
const (
	// TruthCounts: it counts, and one detection may take it
	TruthCounts Truth = 0
	// TruthCrowd: it does not count, any number may take it: "difficult" (VOC), "iscrowd" (COCO)
	TruthCrowd Truth = 1
	// TruthIgnored: it does not count, and one may take it: COCO's truths outside a range of areas
	TruthIgnored Truth = 2
)

// Outcome is what a detection is.
type Outcome uint8

// Outcome values.
const (
	// OutcomeMiss: it took no truth: a false positive
	OutcomeMiss Outcome = 0
	// OutcomeHit: it took one that counts: a true positive
	OutcomeHit Outcome = 1
	// OutcomeIgnored: it took one that does not count, and is neither
	OutcomeIgnored Outcome = 2
)

// PrecisionRule is how precision is averaged over recall.
type PrecisionRule int32

// PrecisionRule values.
const (
	// PrecisionVoc2007: at 11 recalls, 0, 0.1 ... 1
	PrecisionVoc2007 PrecisionRule = 0
	// PrecisionVoc2010: at every truth: the area under the curve, of VOC from 2010 on
	PrecisionVoc2010 PrecisionRule = 1
	// PrecisionCoco: at 101 recalls, 0, 0.01 ... 1
	PrecisionCoco PrecisionRule = 2
)

// Point: A location.
type Point[T Float] struct {
	X T
	Y T
}

func (s Point[T]) one() one { return oneOf[T](KindPoint, unsafe.Pointer(&s)) }

// Points is an array of shapes: the slice itself, which is not copied.
func Points[T Float](shapes []Point[T]) Array[T] {
	return arrayOf[T](KindPoint, first(shapes), len(shapes))
}

// Segment: All points between two end points. If the two are the same, the segment is a point.
type Segment[T Float] struct {
	X0 T
	Y0 T
	X1 T
	Y1 T
}

func (s Segment[T]) one() one { return oneOf[T](KindSegment, unsafe.Pointer(&s)) }

// Segments is an array of shapes: the slice itself, which is not copied.
func Segments[T Float](shapes []Segment[T]) Array[T] {
	return arrayOf[T](KindSegment, first(shapes), len(shapes))
}

// Circle: A disc: centre and radius, r >= 0.
type Circle[T Float] struct {
	CX T
	CY T
	R  T
}

func (s Circle[T]) one() one { return oneOf[T](KindCircle, unsafe.Pointer(&s)) }

// Circles is an array of shapes: the slice itself, which is not copied.
func Circles[T Float](shapes []Circle[T]) Array[T] {
	return arrayOf[T](KindCircle, first(shapes), len(shapes))
}

// AABB: A box along the coordinate axes, min_x <= max_x and min_y <= max_y.
type AABB[T Float] struct {
	MinX T
	MinY T
	MaxX T
	MaxY T
}

func (s AABB[T]) one() one { return oneOf[T](KindAABB, unsafe.Pointer(&s)) }

// AABBs is an array of shapes: the slice itself, which is not copied.
func AABBs[T Float](shapes []AABB[T]) Array[T] {
	return arrayOf[T](KindAABB, first(shapes), len(shapes))
}

// Rect: All points C + s u + t perp(u) with |s| <= hx and |t| <= hy, where C is (cx, cy); hx, hy >= 0 and u != (0, 0).
type Rect[T Float] struct {
	CX T
	CY T
	UX T
	UY T
	HX T
	HY T
}

func (s Rect[T]) one() one { return oneOf[T](KindRect, unsafe.Pointer(&s)) }

// Rects is an array of shapes: the slice itself, which is not copied.
func Rects[T Float](shapes []Rect[T]) Array[T] {
	return arrayOf[T](KindRect, first(shapes), len(shapes))
}

// Ellipse: All points C + s u + t perp(u) with (s/a)^2 + (t/b)^2 <= 1, where C is (cx, cy); a, b >= 0 and u != (0, 0).
type Ellipse[T Float] struct {
	CX T
	CY T
	UX T
	UY T
	A  T
	B  T
}

func (s Ellipse[T]) one() one { return oneOf[T](KindEllipse, unsafe.Pointer(&s)) }

// Ellipses is an array of shapes: the slice itself, which is not copied.
func Ellipses[T Float](shapes []Ellipse[T]) Array[T] {
	return arrayOf[T](KindEllipse, first(shapes), len(shapes))
}

// Capsule: All points at most r from the segment from (x0, y0) to (x1, y1), r >= 0. If its ends are the same, it is a
// disc.
type Capsule[T Float] struct {
	X0 T
	Y0 T
	X1 T
	Y1 T
	R  T
}

func (s Capsule[T]) one() one { return oneOf[T](KindCapsule, unsafe.Pointer(&s)) }

// Capsules is an array of shapes: the slice itself, which is not copied.
func Capsules[T Float](shapes []Capsule[T]) Array[T] {
	return arrayOf[T](KindCapsule, first(shapes), len(shapes))
}

// RoundRect: All points at most r >= 0 from the rectangle (cx, cy, ux, uy, hx, hy): one with round corners.
// hx and hy are the rectangle's, in units of the axis, without the radius; r is in units of the coordinates.
type RoundRect[T Float] struct {
	CX T
	CY T
	UX T
	UY T
	HX T
	HY T
	R  T
}

func (s RoundRect[T]) one() one { return oneOf[T](KindRoundRect, unsafe.Pointer(&s)) }

// RoundRects is an array of shapes: the slice itself, which is not copied.
func RoundRects[T Float](shapes []RoundRect[T]) Array[T] {
	return arrayOf[T](KindRoundRect, first(shapes), len(shapes))
}

// Facts: Facts about a polygon, from vesica_polygon_facts_f64.
//
// vertices leaves out those that repeat the one before on their ring, which closes. Two edges that cross or overlap
// begin at the vertices first_crossing and second_crossing, which are -1 if there are none, and simple is then 1.
// orientation is 1 if the inside is on the left of the first ring's edges, -1 on the right, 0 of a polygon without
// area. area is that of vesica_shape_area_f64 with the sign of the orientation. convex is 1 if vesica_depth_f64 takes
// the polygon. rings are those with a vertex.
type Facts[T Float] struct {
	Vertices       int64
	FirstCrossing  int64
	SecondCrossing int64
	Area           T
	Orientation    int32
	Convex         int32
	Simple         int32
	Rings          int32
}

// ClosestPoints: A distance, and two points that are that far apart: (ax, ay) of shape a and (bx, by) of shape b.
type ClosestPoints[T Float] struct {
	Distance T
	AX       T
	AY       T
	BX       T
	BY       T
}

// Penetration: The shortest move of b that ends its overlap with a: its length, and its unit direction (x, y).
type Penetration[T Float] struct {
	Depth T
	X     T
	Y     T
}

// Span: All heights from low to high; low <= high, both finite.
type Span[T Float] struct {
	Low  T
	High T
}

// Grid: A grid of cells, such as the pixels of a picture.
//
// Cell (i, j) of column i and row j is the box from (x + i dx, y + j dy) to (x + (i + 1) dx, y + (j + 1) dy).
type Grid[T Float] struct {
	X       T
	Y       T
	DX      T
	DY      T
	Columns int64
	Rows    int64
}

// Impact: A first contact: its time t, its point (x, y), and the unit normal (nx, ny) there, from a to b.
//
// After a miss t is infinity and all other numbers are NaN.
type Impact[T Float] struct {
	T  T
	X  T
	Y  T
	NX T
	NY T
}

// Turn: How a shape moves while t runs from 0 to 1: the way (vx, vy) of its centre, and the angle in radians by which
// it turns about its centre. Positive angles turn counter-clockwise if y points up.
type Turn[T Float] struct {
	VX    T
	VY    T
	Angle T
}

// Contacts: The contacts of two overlapping convex shapes: their count, 0 to 2, and one unit normal (nx, ny) from a to
// b.
//
// Contact 0 is at (x0, y0) with depth0, and numbers a0 of shape a and b0 of shape b name it; likewise contact 1. All
// numbers of a contact that is missing are 0, and so is the normal if there is none.
type Contacts[T Float] struct {
	NX     T
	NY     T
	X0     T
	Y0     T
	Depth0 T
	X1     T
	Y1     T
	Depth1 T
	A0     int64
	B0     int64
	A1     int64
	B1     int64
	Count  int64
}

func cOverlap(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape) C.int32_t {
	if wide {
		return C.go_overlap_f64(kindA, a, kindB, b)
	}
	return C.go_overlap_f32(kindA, a, kindB, b)
}

func cInteriorsOverlap(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t,
	b C.vesica_go_shape) C.int32_t {
	if wide {
		return C.go_interiors_overlap_f64(kindA, a, kindB, b)
	}
	return C.go_interiors_overlap_f32(kindA, a, kindB, b)
}

func cContains(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape) C.int32_t {
	if wide {
		return C.go_contains_f64(kindA, a, kindB, b)
	}
	return C.go_contains_f32(kindA, a, kindB, b)
}

func cRelation(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape) C.int32_t {
	if wide {
		return C.go_relation_f64(kindA, a, kindB, b)
	}
	return C.go_relation_f32(kindA, a, kindB, b)
}

func cNearest(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape,
	out *C.char) C.int32_t {
	if wide {
		return C.go_nearest_f64(kindA, a, kindB, b, out)
	}
	return C.go_nearest_f32(kindA, a, kindB, b, out)
}

func cDepth(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape,
	out *C.char) C.int32_t {
	if wide {
		return C.go_depth_f64(kindA, a, kindB, b, out)
	}
	return C.go_depth_f32(kindA, a, kindB, b, out)
}

func cArea(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape,
	out *C.char) C.int32_t {
	if wide {
		return C.go_area_f64(kindA, a, kindB, b, out)
	}
	return C.go_area_f32(kindA, a, kindB, b, out)
}

func cIOU(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape,
	out *C.char) C.int32_t {
	if wide {
		return C.go_iou_f64(kindA, a, kindB, b, out)
	}
	return C.go_iou_f32(kindA, a, kindB, b, out)
}

func cBounds(wide bool, kind C.int32_t, shape C.vesica_go_shape, out *C.char) C.int32_t {
	if wide {
		return C.go_bounds_f64(kind, shape, out)
	}
	return C.go_bounds_f32(kind, shape, out)
}

func cCheck(wide bool, kind C.int32_t, shape C.vesica_go_shape) C.int32_t {
	if wide {
		return C.go_check_f64(kind, shape)
	}
	return C.go_check_f32(kind, shape)
}

func cCrossings(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape, out *C.char,
	capacity C.int64_t, shared *C.char) C.int64_t {
	if wide {
		return C.go_crossings_f64(kindA, a, kindB, b, out, capacity, shared)
	}
	return C.go_crossings_f32(kindA, a, kindB, b, out, capacity, shared)
}

func cBoundaryDistance(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape,
	out *C.char) C.int32_t {
	if wide {
		return C.go_boundary_distance_f64(kindA, a, kindB, b, out)
	}
	return C.go_boundary_distance_f32(kindA, a, kindB, b, out)
}

func cShapeArea(wide bool, kind C.int32_t, shape C.vesica_go_shape, out *C.char) C.int32_t {
	if wide {
		return C.go_shape_area_f64(kind, shape, out)
	}
	return C.go_shape_area_f32(kind, shape, out)
}

func cPolygonFacts(wide bool, polygon *C.char, out *C.char) C.int32_t {
	if wide {
		return C.go_polygon_facts_f64(polygon, out)
	}
	return C.go_polygon_facts_f32(polygon, out)
}

func cAABBFromCorners(wide bool, x0 float64, y0 float64, x1 float64, y1 float64, out *C.char) C.int32_t {
	if wide {
		return C.go_aabb_from_corners_f64(C.double(x0), C.double(y0), C.double(x1), C.double(y1), out)
	}
	return C.go_aabb_from_corners_f32(C.float(x0), C.float(y0), C.float(x1), C.float(y1), out)
}

func cRectFromAngle(wide bool, cx float64, cy float64, angle float64, width float64, height float64,
	out *C.char) C.int32_t {
	if wide {
		return C.go_rect_from_angle_f64(C.double(cx), C.double(cy), C.double(angle), C.double(width), C.double(height), out)
	}
	return C.go_rect_from_angle_f32(C.float(cx), C.float(cy), C.float(angle), C.float(width), C.float(height), out)
}

func cRectFromCorners(wide bool, corners *C.char, out *C.char) C.int32_t {
	if wide {
		return C.go_rect_from_corners_f64(corners, out)
	}
	return C.go_rect_from_corners_f32(corners, out)
}

func cRectCornersMisfit(wide bool, corners *C.char, r *C.char, misfit *C.char) C.int32_t {
	if wide {
		return C.go_rect_corners_misfit_f64(corners, r, misfit)
	}
	return C.go_rect_corners_misfit_f32(corners, r, misfit)
}

func cRoundRectFromAngle(wide bool, cx float64, cy float64, angle float64, width float64, height float64,
	radius float64, out *C.char) C.int32_t {
	if wide {
		return C.go_round_rect_from_angle_f64(C.double(cx), C.double(cy), C.double(angle), C.double(width), C.double(height),
			C.double(radius), out)
	}
	return C.go_round_rect_from_angle_f32(C.float(cx), C.float(cy), C.float(angle), C.float(width), C.float(height),
		C.float(radius), out)
}

func cCapsuleFromAngle(wide bool, cx float64, cy float64, angle float64, length float64, radius float64,
	out *C.char) C.int32_t {
	if wide {
		return C.go_capsule_from_angle_f64(C.double(cx), C.double(cy), C.double(angle), C.double(length), C.double(radius),
			out)
	}
	return C.go_capsule_from_angle_f32(C.float(cx), C.float(cy), C.float(angle), C.float(length), C.float(radius), out)
}

func cCapsuleFromWidth(wide bool, x0 float64, y0 float64, x1 float64, y1 float64, width float64,
	out *C.char) C.int32_t {
	if wide {
		return C.go_capsule_from_width_f64(C.double(x0), C.double(y0), C.double(x1), C.double(y1), C.double(width), out)
	}
	return C.go_capsule_from_width_f32(C.float(x0), C.float(y0), C.float(x1), C.float(y1), C.float(width), out)
}

func cEllipseFromAngle(wide bool, cx float64, cy float64, angle float64, a float64, b float64, out *C.char) C.int32_t {
	if wide {
		return C.go_ellipse_from_angle_f64(C.double(cx), C.double(cy), C.double(angle), C.double(a), C.double(b), out)
	}
	return C.go_ellipse_from_angle_f32(C.float(cx), C.float(cy), C.float(angle), C.float(a), C.float(b), out)
}

func cEllipseFromRadiusVector(wide bool, cx float64, cy float64, wx float64, wy float64, ratio float64,
	out *C.char) C.int32_t {
	if wide {
		return C.go_ellipse_from_radius_vector_f64(C.double(cx), C.double(cy), C.double(wx), C.double(wy), C.double(ratio),
			out)
	}
	return C.go_ellipse_from_radius_vector_f32(C.float(cx), C.float(cy), C.float(wx), C.float(wy), C.float(ratio), out)
}

func cEllipseFromCovariance(wide bool, meanX float64, meanY float64, cxx float64, cxy float64, cyy float64, k float64,
	out *C.char) C.int32_t {
	if wide {
		return C.go_ellipse_from_covariance_f64(C.double(meanX), C.double(meanY), C.double(cxx), C.double(cxy), C.double(cyy),
			C.double(k), out)
	}
	return C.go_ellipse_from_covariance_f32(C.float(meanX), C.float(meanY), C.float(cxx), C.float(cxy), C.float(cyy),
		C.float(k), out)
}

func cEllipseFromMatrix(wide bool, cx float64, cy float64, mxx float64, mxy float64, myy float64,
	out *C.char) C.int32_t {
	if wide {
		return C.go_ellipse_from_matrix_f64(C.double(cx), C.double(cy), C.double(mxx), C.double(mxy), C.double(myy), out)
	}
	return C.go_ellipse_from_matrix_f32(C.float(cx), C.float(cy), C.float(mxx), C.float(mxy), C.float(myy), out)
}

func cOverlapMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_overlap_many_f64(a, b, out)
	}
	return C.go_overlap_many_f32(a, b, out)
}

func cInteriorsOverlapMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_interiors_overlap_many_f64(a, b, out)
	}
	return C.go_interiors_overlap_many_f32(a, b, out)
}

func cRelationMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_relation_many_f64(a, b, out)
	}
	return C.go_relation_many_f32(a, b, out)
}

func cContainsMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_contains_many_f64(a, b, out)
	}
	return C.go_contains_many_f32(a, b, out)
}

func cNearestMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, distance *C.char, ax *C.char, ay *C.char,
	bx *C.char, by *C.char) C.int64_t {
	if wide {
		return C.go_nearest_many_f64(a, b, distance, ax, ay, bx, by)
	}
	return C.go_nearest_many_f32(a, b, distance, ax, ay, bx, by)
}

func cBoundaryDistanceMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, distance *C.char, ax *C.char, ay *C.char,
	bx *C.char, by *C.char) C.int64_t {
	if wide {
		return C.go_boundary_distance_many_f64(a, b, distance, ax, ay, bx, by)
	}
	return C.go_boundary_distance_many_f32(a, b, distance, ax, ay, bx, by)
}

func cDepthMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, depth *C.char, x *C.char, y *C.char) C.int64_t {
	if wide {
		return C.go_depth_many_f64(a, b, depth, x, y)
	}
	return C.go_depth_many_f32(a, b, depth, x, y)
}

func cAreaMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_area_many_f64(a, b, out)
	}
	return C.go_area_many_f32(a, b, out)
}

func cIOUMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_iou_many_f64(a, b, out)
	}
	return C.go_iou_many_f32(a, b, out)
}

func cOverlapMatrix(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char, rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_overlap_matrix_f64(a, b, out, rowStride)
	}
	return C.go_overlap_matrix_f32(a, b, out, rowStride)
}

func cInteriorsOverlapMatrix(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char,
	rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_interiors_overlap_matrix_f64(a, b, out, rowStride)
	}
	return C.go_interiors_overlap_matrix_f32(a, b, out, rowStride)
}

func cRelationMatrix(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char, rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_relation_matrix_f64(a, b, out, rowStride)
	}
	return C.go_relation_matrix_f32(a, b, out, rowStride)
}

func cContainsMatrix(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char, rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_contains_matrix_f64(a, b, out, rowStride)
	}
	return C.go_contains_matrix_f32(a, b, out, rowStride)
}

func cAreaMatrix(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char, rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_area_matrix_f64(a, b, out, rowStride)
	}
	return C.go_area_matrix_f32(a, b, out, rowStride)
}

func cIOUMatrix(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char, rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_iou_matrix_f64(a, b, out, rowStride)
	}
	return C.go_iou_matrix_f32(a, b, out, rowStride)
}

func cOverlapSelect(wide bool, one C.vesica_go_view, many C.vesica_go_view, out *C.char, capacity C.int64_t) C.int64_t {
	if wide {
		return C.go_overlap_select_f64(one, many, out, capacity)
	}
	return C.go_overlap_select_f32(one, many, out, capacity)
}

func cInteriorsOverlapSelect(wide bool, one C.vesica_go_view, many C.vesica_go_view, out *C.char,
	capacity C.int64_t) C.int64_t {
	if wide {
		return C.go_interiors_overlap_select_f64(one, many, out, capacity)
	}
	return C.go_interiors_overlap_select_f32(one, many, out, capacity)
}

func cNMS(wide bool, shapes C.vesica_go_view, scores *C.char, threshold float64, scratch *C.char, scratchSize C.int64_t,
	keep *C.char, kept *C.char) C.int32_t {
	if wide {
		return C.go_nms_f64(shapes, scores, C.double(threshold), scratch, scratchSize, keep, kept)
	}
	return C.go_nms_f32(shapes, scores, C.float(threshold), scratch, scratchSize, keep, kept)
}

func cRectsFromBoxes(wide bool, boxes *C.char, count C.int64_t, stride C.ptrdiff_t, angle C.int32_t,
	out *C.char) C.int64_t {
	if wide {
		return C.go_rects_from_boxes_f64(boxes, count, stride, angle, out)
	}
	return C.go_rects_from_boxes_f32(boxes, count, stride, angle, out)
}

func cEllipsesFromBoxes(wide bool, boxes *C.char, count C.int64_t, stride C.ptrdiff_t, angle C.int32_t,
	out *C.char) C.int64_t {
	if wide {
		return C.go_ellipses_from_boxes_f64(boxes, count, stride, angle, out)
	}
	return C.go_ellipses_from_boxes_f32(boxes, count, stride, angle, out)
}

func cRectsFromCorners(wide bool, corners *C.char, count C.int64_t, stride C.ptrdiff_t, out *C.char) C.int64_t {
	if wide {
		return C.go_rects_from_corners_f64(corners, count, stride, out)
	}
	return C.go_rects_from_corners_f32(corners, count, stride, out)
}

func cRectCornersMisfitMany(wide bool, corners *C.char, stride C.ptrdiff_t, rects C.vesica_go_view,
	misfit *C.char) C.int64_t {
	if wide {
		return C.go_rect_corners_misfit_many_f64(corners, stride, rects, misfit)
	}
	return C.go_rect_corners_misfit_many_f32(corners, stride, rects, misfit)
}

func cBoxesFromShapes(wide bool, shapes C.vesica_go_view, angle C.int32_t, boxes *C.char) C.int64_t {
	if wide {
		return C.go_boxes_from_shapes_f64(shapes, angle, boxes)
	}
	return C.go_boxes_from_shapes_f32(shapes, angle, boxes)
}

func cCornersOfShapes(wide bool, shapes C.vesica_go_view, corners *C.char) C.int64_t {
	if wide {
		return C.go_corners_of_shapes_f64(shapes, corners)
	}
	return C.go_corners_of_shapes_f32(shapes, corners)
}

func cBoundsMany(wide bool, shapes C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_bounds_many_f64(shapes, out)
	}
	return C.go_bounds_many_f32(shapes, out)
}

func cShapeAreaMany(wide bool, shapes C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_shape_area_many_f64(shapes, out)
	}
	return C.go_shape_area_many_f32(shapes, out)
}

func cConvexHull(wide bool, points *C.char, out *C.char, capacity C.int64_t) C.int64_t {
	if wide {
		return C.go_convex_hull_f64(points, out, capacity)
	}
	return C.go_convex_hull_f32(points, out, capacity)
}

func cMinAreaRect(wide bool, points *C.char, out *C.char) C.int32_t {
	if wide {
		return C.go_min_area_rect_f64(points, out)
	}
	return C.go_min_area_rect_f32(points, out)
}

func cMinPerimeterRect(wide bool, points *C.char, out *C.char) C.int32_t {
	if wide {
		return C.go_min_perimeter_rect_f64(points, out)
	}
	return C.go_min_perimeter_rect_f32(points, out)
}

func cMinAreaRectMany(wide bool, points C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_min_area_rect_many_f64(points, out)
	}
	return C.go_min_area_rect_many_f32(points, out)
}

func cMinPerimeterRectMany(wide bool, points C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_min_perimeter_rect_many_f64(points, out)
	}
	return C.go_min_perimeter_rect_many_f32(points, out)
}

func cJoinRatio(wide bool, ratio C.int32_t, threshold float64, indexA *C.char, setsA C.vesica_go_sets,
	setCountA C.int32_t, indexB *C.char, setsB C.vesica_go_sets, setCountB C.int32_t, part C.int64_t, parts C.int64_t,
	scratch *C.char, scratchSize C.int64_t, outA *C.char, outB *C.char, values *C.char, capacity C.int64_t,
	state *C.char) C.int64_t {
	if wide {
		return C.go_join_ratio_f64(ratio, C.double(threshold), indexA, setsA, setCountA, indexB, setsB, setCountB, part,
			parts, scratch, scratchSize, outA, outB, values, capacity, state)
	}
	return C.go_join_ratio_f32(ratio, C.float(threshold), indexA, setsA, setCountA, indexB, setsB, setCountB, part, parts,
		scratch, scratchSize, outA, outB, values, capacity, state)
}

func cAssignGreedy(wide bool, a *C.char, b *C.char, values *C.char, count C.int64_t, countA C.int64_t, countB C.int64_t,
	scratch *C.char, scratchSize C.int64_t, chosen *C.char) C.int64_t {
	if wide {
		return C.go_assign_greedy_f64(a, b, values, count, countA, countB, scratch, scratchSize, chosen)
	}
	return C.go_assign_greedy_f32(a, b, values, count, countA, countB, scratch, scratchSize, chosen)
}

func cFuse(wide bool, shapes C.vesica_go_view, scores *C.char, weights *C.char, labels *C.char, threshold float64,
	fusedScore C.int32_t, scratch *C.char, scratchSize C.int64_t, fused *C.char, fusedScores *C.char, clusters *C.char,
	count *C.char) C.int32_t {
	if wide {
		return C.go_fuse_f64(shapes, scores, weights, labels, C.double(threshold), fusedScore, scratch, scratchSize, fused,
			fusedScores, clusters, count)
	}
	return C.go_fuse_f32(shapes, scores, weights, labels, C.float(threshold), fusedScore, scratch, scratchSize, fused,
		fusedScores, clusters, count)
}

func cVolumeRatio(wide bool, ratio C.int32_t, kindA C.int32_t, a C.vesica_go_shape, spanA *C.char, kindB C.int32_t,
	b C.vesica_go_shape, spanB *C.char, out *C.char) C.int32_t {
	if wide {
		return C.go_volume_ratio_f64(ratio, kindA, a, spanA, kindB, b, spanB, out)
	}
	return C.go_volume_ratio_f32(ratio, kindA, a, spanA, kindB, b, spanB, out)
}

func cVolumeRatioMany(wide bool, ratio C.int32_t, a C.vesica_go_view, spansA *C.char, b C.vesica_go_view,
	spansB *C.char, out *C.char) C.int64_t {
	if wide {
		return C.go_volume_ratio_many_f64(ratio, a, spansA, b, spansB, out)
	}
	return C.go_volume_ratio_many_f32(ratio, a, spansA, b, spansB, out)
}

func cVolumeRatioMatrix(wide bool, ratio C.int32_t, a C.vesica_go_view, spansA *C.char, b C.vesica_go_view,
	spansB *C.char, out *C.char, rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_volume_ratio_matrix_f64(ratio, a, spansA, b, spansB, out, rowStride)
	}
	return C.go_volume_ratio_matrix_f32(ratio, a, spansA, b, spansB, out, rowStride)
}

func cMatchTruths(wide bool, rule C.int32_t, a *C.char, b *C.char, values *C.char, count C.int64_t, scores *C.char,
	detections C.int64_t, flags *C.char, truths C.int64_t, thresholds *C.char, thresholdCount C.int64_t, scratch *C.char,
	scratchSize C.int64_t, outcomes *C.char, taken *C.char) C.int32_t {
	if wide {
		return C.go_match_truths_f64(rule, a, b, values, count, scores, detections, flags, truths, thresholds, thresholdCount,
			scratch, scratchSize, outcomes, taken)
	}
	return C.go_match_truths_f32(rule, a, b, values, count, scores, detections, flags, truths, thresholds, thresholdCount,
		scratch, scratchSize, outcomes, taken)
}

func cAveragePrecision(wide bool, rule C.int32_t, scores *C.char, outcomes *C.char, count C.int64_t, truths C.int64_t,
	scratch *C.char, scratchSize C.int64_t, out *C.char) C.int32_t {
	if wide {
		return C.go_average_precision_f64(rule, scores, outcomes, count, truths, scratch, scratchSize, out)
	}
	return C.go_average_precision_f32(rule, scores, outcomes, count, truths, scratch, scratchSize, out)
}

func cGaussianDistance(wide bool, which C.int32_t, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t,
	b C.vesica_go_shape, out *C.char) C.int32_t {
	if wide {
		return C.go_gaussian_distance_f64(which, kindA, a, kindB, b, out)
	}
	return C.go_gaussian_distance_f32(which, kindA, a, kindB, b, out)
}

func cGaussianDistanceMany(wide bool, which C.int32_t, a C.vesica_go_view, b C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_gaussian_distance_many_f64(which, a, b, out)
	}
	return C.go_gaussian_distance_many_f32(which, a, b, out)
}

func cGaussianDistanceMatrix(wide bool, which C.int32_t, a C.vesica_go_view, b C.vesica_go_view, out *C.char,
	rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_gaussian_distance_matrix_f64(which, a, b, out, rowStride)
	}
	return C.go_gaussian_distance_matrix_f32(which, a, b, out, rowStride)
}

func cIndexBuild(wide bool, sets C.vesica_go_sets, setCount C.int32_t, index *C.char, indexSize C.int64_t,
	scratch *C.char, scratchSize C.int64_t) C.int64_t {
	if wide {
		return C.go_index_build_f64(sets, setCount, index, indexSize, scratch, scratchSize)
	}
	return C.go_index_build_f32(sets, setCount, index, indexSize, scratch, scratchSize)
}

func cIndexStep(wide bool, step C.int32_t, part C.int64_t, parts C.int64_t, sets C.vesica_go_sets, setCount C.int32_t,
	index *C.char, indexSize C.int64_t, scratch *C.char, scratchSize C.int64_t) C.int64_t {
	if wide {
		return C.go_index_step_f64(step, part, parts, sets, setCount, index, indexSize, scratch, scratchSize)
	}
	return C.go_index_step_f32(step, part, parts, sets, setCount, index, indexSize, scratch, scratchSize)
}

func cIndexSelect(wide bool, index *C.char, sets C.vesica_go_sets, setCount C.int32_t, one C.vesica_go_view,
	out *C.char, capacity C.int64_t, state *C.char) C.int64_t {
	if wide {
		return C.go_index_select_f64(index, sets, setCount, one, out, capacity, state)
	}
	return C.go_index_select_f32(index, sets, setCount, one, out, capacity, state)
}

func cJoin(wide bool, query C.int32_t, indexA *C.char, setsA C.vesica_go_sets, setCountA C.int32_t, indexB *C.char,
	setsB C.vesica_go_sets, setCountB C.int32_t, part C.int64_t, parts C.int64_t, scratch *C.char, scratchSize C.int64_t,
	outA *C.char, outB *C.char, capacity C.int64_t, state *C.char) C.int64_t {
	if wide {
		return C.go_join_f64(query, indexA, setsA, setCountA, indexB, setsB, setCountB, part, parts, scratch, scratchSize,
			outA, outB, capacity, state)
	}
	return C.go_join_f32(query, indexA, setsA, setCountA, indexB, setsB, setCountB, part, parts, scratch, scratchSize,
		outA, outB, capacity, state)
}

func cJoinWithin(wide bool, indexA *C.char, setsA C.vesica_go_sets, setCountA C.int32_t, indexB *C.char,
	setsB C.vesica_go_sets, setCountB C.int32_t, distance float64, part C.int64_t, parts C.int64_t, outA *C.char,
	outB *C.char, capacity C.int64_t, state *C.char) C.int64_t {
	if wide {
		return C.go_join_within_f64(indexA, setsA, setCountA, indexB, setsB, setCountB, C.double(distance), part, parts, outA,
			outB, capacity, state)
	}
	return C.go_join_within_f32(indexA, setsA, setCountA, indexB, setsB, setCountB, C.float(distance), part, parts, outA,
		outB, capacity, state)
}

func cIndexNearest(wide bool, index *C.char, sets C.vesica_go_sets, setCount C.int32_t, one C.vesica_go_view,
	k C.int64_t, within float64, out *C.char, distance *C.char) C.int64_t {
	if wide {
		return C.go_index_nearest_f64(index, sets, setCount, one, k, C.double(within), out, distance)
	}
	return C.go_index_nearest_f32(index, sets, setCount, one, k, C.float(within), out, distance)
}

func cJoinNearest(wide bool, setsA C.vesica_go_sets, setCountA C.int32_t, indexB *C.char, setsB C.vesica_go_sets,
	setCountB C.int32_t, k C.int64_t, within float64, part C.int64_t, parts C.int64_t, out *C.char,
	distance *C.char) C.int64_t {
	if wide {
		return C.go_join_nearest_f64(setsA, setCountA, indexB, setsB, setCountB, k, C.double(within), part, parts, out,
			distance)
	}
	return C.go_join_nearest_f32(setsA, setCountA, indexB, setsB, setCountB, k, C.float(within), part, parts, out,
		distance)
}

func cPolygonBoxes(wide bool, kind C.int32_t, path *C.char, boxes *C.char, size C.int64_t) C.int32_t {
	if wide {
		return C.go_polygon_boxes_f64(kind, path, boxes, size)
	}
	return C.go_polygon_boxes_f32(kind, path, boxes, size)
}

func cPolygonBoxesOverlap(wide bool, kind C.int32_t, path *C.char, boxes *C.char, size C.int64_t, kindB C.int32_t,
	b C.vesica_go_shape) C.int32_t {
	if wide {
		return C.go_polygon_boxes_overlap_f64(kind, path, boxes, size, kindB, b)
	}
	return C.go_polygon_boxes_overlap_f32(kind, path, boxes, size, kindB, b)
}

func cPolygonBoxesNearest(wide bool, kind C.int32_t, path *C.char, boxes *C.char, size C.int64_t, kindB C.int32_t,
	b C.vesica_go_shape, out *C.char) C.int32_t {
	if wide {
		return C.go_polygon_boxes_nearest_f64(kind, path, boxes, size, kindB, b, out)
	}
	return C.go_polygon_boxes_nearest_f32(kind, path, boxes, size, kindB, b, out)
}

func cPolygonBoxesWithin(wide bool, kind C.int32_t, path *C.char, boxes *C.char, size C.int64_t, kindB C.int32_t,
	b C.vesica_go_shape, distance float64) C.int32_t {
	if wide {
		return C.go_polygon_boxes_within_f64(kind, path, boxes, size, kindB, b, C.double(distance))
	}
	return C.go_polygon_boxes_within_f32(kind, path, boxes, size, kindB, b, C.float(distance))
}

func cRatio(wide bool, ratio C.int32_t, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape,
	out *C.char) C.int32_t {
	if wide {
		return C.go_ratio_f64(ratio, kindA, a, kindB, b, out)
	}
	return C.go_ratio_f32(ratio, kindA, a, kindB, b, out)
}

func cRatioMany(wide bool, ratio C.int32_t, a C.vesica_go_view, b C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_ratio_many_f64(ratio, a, b, out)
	}
	return C.go_ratio_many_f32(ratio, a, b, out)
}

func cRatioMatrix(wide bool, ratio C.int32_t, a C.vesica_go_view, b C.vesica_go_view, out *C.char,
	rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_ratio_matrix_f64(ratio, a, b, out, rowStride)
	}
	return C.go_ratio_matrix_f32(ratio, a, b, out, rowStride)
}

func cNearestMatrix(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char, rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_nearest_matrix_f64(a, b, out, rowStride)
	}
	return C.go_nearest_matrix_f32(a, b, out, rowStride)
}

func cBoundaryDistanceMatrix(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char,
	rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_boundary_distance_matrix_f64(a, b, out, rowStride)
	}
	return C.go_boundary_distance_matrix_f32(a, b, out, rowStride)
}

func cDepthMatrix(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char, rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_depth_matrix_f64(a, b, out, rowStride)
	}
	return C.go_depth_matrix_f32(a, b, out, rowStride)
}

func cSignedDistance(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape,
	out *C.char) C.int32_t {
	if wide {
		return C.go_signed_distance_f64(kindA, a, kindB, b, out)
	}
	return C.go_signed_distance_f32(kindA, a, kindB, b, out)
}

func cSignedDistanceMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_signed_distance_many_f64(a, b, out)
	}
	return C.go_signed_distance_many_f32(a, b, out)
}

func cSignedDistanceMatrix(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char,
	rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_signed_distance_matrix_f64(a, b, out, rowStride)
	}
	return C.go_signed_distance_matrix_f32(a, b, out, rowStride)
}

func cWithin(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape,
	distance float64) C.int32_t {
	if wide {
		return C.go_within_f64(kindA, a, kindB, b, C.double(distance))
	}
	return C.go_within_f32(kindA, a, kindB, b, C.float(distance))
}

func cWithinMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, distance float64, out *C.char) C.int64_t {
	if wide {
		return C.go_within_many_f64(a, b, C.double(distance), out)
	}
	return C.go_within_many_f32(a, b, C.float(distance), out)
}

func cWithinMatrix(wide bool, a C.vesica_go_view, b C.vesica_go_view, distance float64, out *C.char,
	rowStride C.ptrdiff_t) C.int64_t {
	if wide {
		return C.go_within_matrix_f64(a, b, C.double(distance), out, rowStride)
	}
	return C.go_within_matrix_f32(a, b, C.float(distance), out, rowStride)
}

func cSuppress(wide bool, shapes C.vesica_go_view, scores *C.char, labels *C.char, ratio C.int32_t, threshold float64,
	leastScore float64, most C.int64_t, scratch *C.char, scratchSize C.int64_t, keep *C.char, kept *C.char) C.int32_t {
	if wide {
		return C.go_suppress_f64(shapes, scores, labels, ratio, C.double(threshold), C.double(leastScore), most, scratch,
			scratchSize, keep, kept)
	}
	return C.go_suppress_f32(shapes, scores, labels, ratio, C.float(threshold), C.float(leastScore), most, scratch,
		scratchSize, keep, kept)
}

func cSuppressSoft(wide bool, shapes C.vesica_go_view, scores *C.char, labels *C.char, ratio C.int32_t, decay C.int32_t,
	parameter float64, leastScore float64, most C.int64_t, scratch *C.char, scratchSize C.int64_t, keep *C.char,
	decayed *C.char, kept *C.char) C.int32_t {
	if wide {
		return C.go_suppress_soft_f64(shapes, scores, labels, ratio, decay, C.double(parameter), C.double(leastScore), most,
			scratch, scratchSize, keep, decayed, kept)
	}
	return C.go_suppress_soft_f32(shapes, scores, labels, ratio, decay, C.float(parameter), C.float(leastScore), most,
		scratch, scratchSize, keep, decayed, kept)
}

func cCoverage(wide bool, kind C.int32_t, shape C.vesica_go_shape, grid *C.char, out *C.char,
	rowStride C.ptrdiff_t) C.int32_t {
	if wide {
		return C.go_coverage_f64(kind, shape, grid, out, rowStride)
	}
	return C.go_coverage_f32(kind, shape, grid, out, rowStride)
}

func cCoverageCells(wide bool, kind C.int32_t, shape C.vesica_go_shape, grid *C.char, cells *C.char, shares *C.char,
	capacity C.int64_t) C.int64_t {
	if wide {
		return C.go_coverage_cells_f64(kind, shape, grid, cells, shares, capacity)
	}
	return C.go_coverage_cells_f32(kind, shape, grid, cells, shares, capacity)
}

func cCast(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape, vx float64,
	vy float64, tEnd float64, out *C.char) C.int32_t {
	if wide {
		return C.go_cast_f64(kindA, a, kindB, b, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_cast_f32(kindA, a, kindB, b, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cCastMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, vx *C.char, vy *C.char, stride C.ptrdiff_t,
	tEnd float64, t *C.char, x *C.char, y *C.char, nx *C.char, ny *C.char) C.int64_t {
	if wide {
		return C.go_cast_many_f64(a, b, vx, vy, stride, C.double(tEnd), t, x, y, nx, ny)
	}
	return C.go_cast_many_f32(a, b, vx, vy, stride, C.float(tEnd), t, x, y, nx, ny)
}

func cCastFirst(wide bool, one C.vesica_go_view, many C.vesica_go_view, vx float64, vy float64, tEnd float64,
	out *C.char) C.int64_t {
	if wide {
		return C.go_cast_first_f64(one, many, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_cast_first_f32(one, many, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cSweepBounds(wide bool, kind C.int32_t, shape C.vesica_go_shape, vx float64, vy float64, tEnd float64,
	out *C.char) C.int32_t {
	if wide {
		return C.go_sweep_bounds_f64(kind, shape, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_sweep_bounds_f32(kind, shape, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cIndexCast(wide bool, index *C.char, sets C.vesica_go_sets, setCount C.int32_t, one C.vesica_go_view, vx float64,
	vy float64, tEnd float64, out *C.char, capacity C.int64_t, state *C.char) C.int64_t {
	if wide {
		return C.go_index_cast_f64(index, sets, setCount, one, C.double(vx), C.double(vy), C.double(tEnd), out, capacity,
			state)
	}
	return C.go_index_cast_f32(index, sets, setCount, one, C.float(vx), C.float(vy), C.float(tEnd), out, capacity, state)
}

func cIndexCastFirst(wide bool, index *C.char, sets C.vesica_go_sets, setCount C.int32_t, one C.vesica_go_view,
	vx float64, vy float64, tEnd float64, out *C.char) C.int64_t {
	if wide {
		return C.go_index_cast_first_f64(index, sets, setCount, one, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_index_cast_first_f32(index, sets, setCount, one, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cImpactTime(wide bool, kindA C.int32_t, a C.vesica_go_shape, turnA *C.char, kindB C.int32_t, b C.vesica_go_shape,
	turnB *C.char, tolerance float64, out *C.char, gap *C.char) C.int32_t {
	if wide {
		return C.go_impact_time_f64(kindA, a, turnA, kindB, b, turnB, C.double(tolerance), out, gap)
	}
	return C.go_impact_time_f32(kindA, a, turnA, kindB, b, turnB, C.float(tolerance), out, gap)
}

func cIndexImpactTime(wide bool, index *C.char, sets C.vesica_go_sets, setCount C.int32_t, one C.vesica_go_view,
	turn *C.char, tolerance float64, out *C.char, gap *C.char, answer *C.char) C.int64_t {
	if wide {
		return C.go_index_impact_time_f64(index, sets, setCount, one, turn, C.double(tolerance), out, gap, answer)
	}
	return C.go_index_impact_time_f32(index, sets, setCount, one, turn, C.float(tolerance), out, gap, answer)
}

func cManifold(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape,
	out *C.char) C.int32_t {
	if wide {
		return C.go_manifold_f64(kindA, a, kindB, b, out)
	}
	return C.go_manifold_f32(kindA, a, kindB, b, out)
}

func cManifoldMany(wide bool, a C.vesica_go_view, b C.vesica_go_view, out *C.char) C.int64_t {
	if wide {
		return C.go_manifold_many_f64(a, b, out)
	}
	return C.go_manifold_many_f32(a, b, out)
}

func cCastPointPoint(wide bool, a *C.char, b *C.char, vx float64, vy float64, tEnd float64, out *C.char) C.int32_t {
	if wide {
		return C.go_cast_point_point_f64(a, b, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_cast_point_point_f32(a, b, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cCastSegmentPoint(wide bool, a *C.char, b *C.char, vx float64, vy float64, tEnd float64, out *C.char) C.int32_t {
	if wide {
		return C.go_cast_segment_point_f64(a, b, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_cast_segment_point_f32(a, b, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cCastCirclePoint(wide bool, a *C.char, b *C.char, vx float64, vy float64, tEnd float64, out *C.char) C.int32_t {
	if wide {
		return C.go_cast_circle_point_f64(a, b, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_cast_circle_point_f32(a, b, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cCastAABBPoint(wide bool, a *C.char, b *C.char, vx float64, vy float64, tEnd float64, out *C.char) C.int32_t {
	if wide {
		return C.go_cast_aabb_point_f64(a, b, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_cast_aabb_point_f32(a, b, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cCastRectPoint(wide bool, a *C.char, b *C.char, vx float64, vy float64, tEnd float64, out *C.char) C.int32_t {
	if wide {
		return C.go_cast_rect_point_f64(a, b, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_cast_rect_point_f32(a, b, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cCastEllipsePoint(wide bool, a *C.char, b *C.char, vx float64, vy float64, tEnd float64, out *C.char) C.int32_t {
	if wide {
		return C.go_cast_ellipse_point_f64(a, b, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_cast_ellipse_point_f32(a, b, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cCastCircleCircle(wide bool, a *C.char, b *C.char, vx float64, vy float64, tEnd float64, out *C.char) C.int32_t {
	if wide {
		return C.go_cast_circle_circle_f64(a, b, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_cast_circle_circle_f32(a, b, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cCastRectRect(wide bool, a *C.char, b *C.char, vx float64, vy float64, tEnd float64, out *C.char) C.int32_t {
	if wide {
		return C.go_cast_rect_rect_f64(a, b, C.double(vx), C.double(vy), C.double(tEnd), out)
	}
	return C.go_cast_rect_rect_f32(a, b, C.float(vx), C.float(vy), C.float(tEnd), out)
}

func cDe9im(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape,
	matrix *C.char) C.int32_t {
	if wide {
		return C.go_de9im_f64(kindA, a, kindB, b, matrix)
	}
	return C.go_de9im_f32(kindA, a, kindB, b, matrix)
}

func cIntersection(wide bool, kindA C.int32_t, a C.vesica_go_shape, kindB C.int32_t, b C.vesica_go_shape, out *C.char,
	capacity C.int64_t) C.int64_t {
	if wide {
		return C.go_intersection_f64(kindA, a, kindB, b, out, capacity)
	}
	return C.go_intersection_f32(kindA, a, kindB, b, out, capacity)
}
