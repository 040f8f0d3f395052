// SPDX-License-Identifier: Apache-2.0

// Package vesica answers exact overlap queries between plain 2D shapes: points, segments, circles, boxes, rotated
// rectangles, ellipses, capsules, rounded rectangles, polygons and polylines, in float64 and float32.
//
//	car, err := vesica.RectFromAngle(0.0, 0.0, 0.5, 4.0, 2.0) // centre, angle, width, height
//	people := []vesica.Circle[float64]{{CX: 1.4, CY: 1.5, R: 0.5}, {CX: 8, CY: 1, R: 0.5}}
//	hit, err := vesica.Overlap(car, people[0])        // true
//	vesica.OverlapMany(vesica.Rects(cars), vesica.Circles(people), hits)
//	index, err := vesica.NewIndex(vesica.Circles(people))
//	pairs, err := index.Join(index, vesica.JoinOverlap)
//
// Shapes are closed and solid, and touching is overlap. Answers that are yes or no are exact for every valid input.
// Capsules and rounded rectangles are for Check, Bounds, ShapeArea, Overlap, RelationOf, Contains, Nearest, Depth,
// SignedDistance, Within, Area, IoU, ratios, suppression, Cast, ImpactTime, SweepBounds, and BoundaryDistance but with
// an ellipse; the same holds of arrays. An index of them has joins by overlap or distance, Select, Nearest and casts.
// Polygons and polylines are for the same but ImpactTime, and for BoundaryDistance with any kind; polylines have no
// area. Depth needs convex polygons, else it returns ErrNotConvex; so do SignedDistance and Within where they need it.
// Other functions return ErrKind for these kinds.
//
// Slices are used where they lie. An invalid shape is ErrShape; in a batch all other answers are written all the same.
// The C library's vesica.h has the whole text of each function.
package vesica

// #cgo CFLAGS: -I${SRCDIR}/include
// #cgo LDFLAGS: ${SRCDIR}/lib/libvesica.a -lm
// #include "declarations.h"
import "C"

import (
	"errors"
	"fmt"
	"unsafe"
)

// Float is what numbers are.
type Float interface{ float32 | float64 }

// Shape is one shape: a Point, Segment, Circle, AABB, Rect, Ellipse, Capsule, RoundRect, Polygon, Polyline or Any.
type Shape interface{ one() one }

// The most numbers that a kind has. declarations.h has room for as many.
const mostFields = 7

// Any is a shape whose kind is known at run time, with its numbers in the order of its struct.
type Any[T Float] struct {
	Kind    Kind
	Numbers [mostFields]T
}

func (s Any[T]) one() one {
	kind := s.Kind
	if kind.Fields() == 0 { // also of polygons, which are no numbers
		kind = -1
	}
	return oneOf[T](kind, unsafe.Pointer(&s.Numbers))
}

// one is a shape as C takes it.
type one struct {
	kind  C.int32_t
	wide  bool
	shape C.vesica_go_shape
}

func isWide[T Float]() bool {
	var number T
	return unsafe.Sizeof(number) == 8
}

// Fields is how many numbers a shape of a kind has, or 0 for polygons, polylines and unknown kinds.
func (k Kind) Fields() int {
	if k < KindPoint || k > KindRoundRect {
		return 0
	}
	return [...]int{2, 4, 3, 4, 6, 6, 5, 7}[k]
}

func oneOf[T Float](kind Kind, numbers unsafe.Pointer) one {
	shape := one{kind: C.int32_t(kind), wide: isWide[T]()}
	copy((*[mostFields]T)(unsafe.Pointer(&shape.shape.numbers))[:], unsafe.Slice((*T)(numbers), kind.Fields()))
	return shape
}

func (e Error) Error() string { return C.GoString(C.vesica_strerror(C.int32_t(e))) }

var errScalars = fmt.Errorf("one shape has float64 numbers and one float32, convert one of them: %w", ErrArgument)

func init() {
	if err := newEnough(int32(C.vesica_version())); err != nil {
		panic(err)
	}
}

func newEnough(version int32) error {
	if version < Version {
		return fmt.Errorf("libvesica %d is older than %d, which this package needs: link a newer one", version, Version)
	}
	return nil
}

// count is an answer or an error.
func count[Code ~int32 | ~int64](code Code) (int, error) {
	if code < 0 {
		return 0, Error(code)
	}
	return int(code), nil
}

// status is nil or an error.
func status(code C.int32_t) error {
	_, err := count(code)
	return err
}

func codeOf[A, B Shape](function func(bool, C.int32_t, C.vesica_go_shape, C.int32_t, C.vesica_go_shape) C.int32_t,
	a A, b B) (int, error) {
	first, second := a.one(), b.one()
	if first.wide != second.wide {
		return 0, errScalars
	}
	return count(function(first.wide, first.kind, first.shape, second.kind, second.shape))
}

type measure = func(bool, C.int32_t, C.vesica_go_shape, C.int32_t, C.vesica_go_shape, *C.char) C.int32_t

// measured has the result's numbers, of either type, as float64, which holds both.
func measured[A, B Shape](function measure, numbers int, a A, b B) (out [5]float64, err error) {
	first, second := a.one(), b.one()
	if first.wide != second.wide {
		return out, errScalars
	}
	code := function(first.wide, first.kind, first.shape, second.kind, second.shape, address(&out))
	if !first.wide {
		out = widened((*[10]float32)(unsafe.Pointer(&out)), numbers)
	}
	return out, status(code)
}

func widened(narrow *[10]float32, numbers int) (out [5]float64) {
	for i := 0; i < numbers; i++ {
		out[i] = float64(narrow[i])
	}
	return out
}

// Overlap tells whether two shapes share a point. Touching counts. Exact.
func Overlap[A, B Shape](a A, b B) (bool, error) {
	code, err := codeOf(cOverlap, a, b)
	return code == 1, err
}

// InteriorsOverlap tells whether the insides of two shapes share a point. Touching does not count. Exact.
func InteriorsOverlap[A, B Shape](a A, b B) (bool, error) {
	code, err := codeOf(cInteriorsOverlap, a, b)
	return code == 1, err
}

// RelationOf tells how a relates to b. Exact.
func RelationOf[A, B Shape](a A, b B) (Relation, error) {
	code, err := codeOf(cRelation, a, b)
	return Relation(code), err
}

// Contains tells whether a holds all of b. Equal shapes do. Exact.
func Contains[A, B Shape](a A, b B) (bool, error) {
	code, err := codeOf(cContains, a, b)
	return code == 1, err
}

// Nearest tells how far the solid shapes are apart, and which of their points are closest.
func Nearest[A, B Shape](a A, b B) (ClosestPoints[float64], error) {
	n, err := measured(cNearest, 5, a, b)
	return ClosestPoints[float64]{n[0], n[1], n[2], n[3], n[4]}, err
}

// BoundaryDistance tells how far the outlines are apart, that of a shape inside another too.
func BoundaryDistance[A, B Shape](a A, b B) (ClosestPoints[float64], error) {
	n, err := measured(cBoundaryDistance, 5, a, b)
	return ClosestPoints[float64]{n[0], n[1], n[2], n[3], n[4]}, err
}

// Depth tells how far and in which direction b must move until it only touches a.
func Depth[A, B Shape](a A, b B) (Penetration[float64], error) {
	n, err := measured(cDepth, 3, a, b)
	return Penetration[float64]{n[0], n[1], n[2]}, err
}

// Area is the area that a and b share.
func Area[A, B Shape](a A, b B) (float64, error) {
	n, err := measured(cArea, 1, a, b)
	return n[0], err
}

// IoU is intersection over union, from 0 to 1.
func IoU[A, B Shape](a A, b B) (float64, error) {
	n, err := measured(cIOU, 1, a, b)
	return n[0], err
}

// CrossingPoints are the places where two outlines meet, and whether they share a stretch.
type CrossingPoints struct {
	Places []Point[float64]
	Shared bool
}

// Crossings are the places where the outlines meet, in order along a's. Their number is exact.
func Crossings[A, B Shape](a A, b B) (CrossingPoints, error) {
	var shared C.int32_t
	places, err := pointsOf(a.one(), b.one(), func(a, b one, out *C.char, room C.int64_t) C.int64_t {
		return cCrossings(a.wide, a.kind, a.shape, b.kind, b.shape, out, room, address(&shared))
	})
	return CrossingPoints{places, shared == 1}, err
}

// No two shapes but paths have more places or vertices.
const mostPoints = 12

// pointsOf has the points that a function of two shapes writes. It is asked again if they are more than mostPoints.
func pointsOf(a, b one, function func(a, b one, out *C.char, room C.int64_t) C.int64_t) ([]Point[float64], error) {
	if a.wide != b.wide {
		return nil, errScalars
	}
	wide := make([]Point[float64], mostPoints)
	found, err := count(function(a, b, first(wide), mostPoints))
	if err == nil && found > mostPoints {
		wide = make([]Point[float64], found)
		found, err = count(function(a, b, first(wide), C.int64_t(found)))
	}
	if err != nil {
		return nil, err
	}
	if !a.wide {
		narrow := unsafe.Slice((*Point[float32])(unsafe.Pointer(first(wide))), found)
		for i := found - 1; i >= 0; i-- { // each is read before its room is written
			wide[i] = Point[float64]{float64(narrow[i].X), float64(narrow[i].Y)}
		}
	}
	return wide[:found:found], nil
}

// Check is nil for a valid shape, else the first rule that it breaks.
func Check[S Shape](shape S) error {
	s := shape.one()
	return status(cCheck(s.wide, s.kind, s.shape))
}

func measuredOne[S Shape](function func(bool, C.int32_t, C.vesica_go_shape, *C.char) C.int32_t, numbers int,
	shape S) (out [5]float64, err error) {
	s := shape.one()
	code := function(s.wide, s.kind, s.shape, address(&out))
	if !s.wide {
		out = widened((*[10]float32)(unsafe.Pointer(&out)), numbers)
	}
	return out, status(code)
}

// ShapeArea is the area of one shape.
func ShapeArea[S Shape](shape S) (float64, error) {
	n, err := measuredOne(cShapeArea, 1, shape)
	return n[0], err
}

// Bounds is the smallest box of representable numbers, of the shape's type, that contains a shape.
func Bounds[S Shape](shape S) (AABB[float64], error) {
	n, err := measuredOne(cBounds, 4, shape)
	return AABB[float64]{n[0], n[1], n[2], n[3]}, err
}

// Code is the library's number of an error: an Error, or what wraps one. Of others it is 0.
func Code(err error) Error {
	var code Error
	errors.As(err, &code)
	return code
}
