// SPDX-License-Identifier: Apache-2.0

package vesica

// #include "declarations.h"
import "C"

import (
	"fmt"
	"math"
	"unsafe"
)

// RatioOf is a ratio of two shapes. ErrArgument, if the shape whose area divides has none, or neither has.
func RatioOf[A, B Shape](ratio Ratio, a A, b B) (float64, error) {
	n, err := measured(func(wide bool, kindA C.int32_t, shapeA C.vesica_go_shape, kindB C.int32_t,
		shapeB C.vesica_go_shape, out *C.char) C.int32_t {
		return cRatio(wide, C.int32_t(ratio), kindA, shapeA, kindB, shapeB, out)
	}, 1, a, b)
	return n[0], err
}

// RatioMany sets out[i] to a ratio of a[i] and b[i]. It returns how many are above 0. With ErrArgument, where there is
// none: its result is NaN, and all others are written.
func RatioMany[T Float](ratio Ratio, a, b Array[T], out []T) (int, error) {
	return many(func(wide bool, a, b C.vesica_go_view, out *C.char) C.int64_t {
		return cRatioMany(wide, C.int32_t(ratio), a, b, out)
	}, a, b, out)
}

// RatioMatrix has a ratio of each of a with each of b, else as RatioMany.
func RatioMatrix[T Float](ratio Ratio, a, b Array[T], out []T) (int, error) {
	return matrix(func(wide bool, a, b C.vesica_go_view, out *C.char, row C.ptrdiff_t) C.int64_t {
		return cRatioMatrix(wide, C.int32_t(ratio), a, b, out, row)
	}, a, b, out)
}

// NearestMatrix has the distance of each of a from each of b. It returns how many pairs overlap.
func NearestMatrix[T Float](a, b Array[T], out []T) (int, error) {
	return matrix(cNearestMatrix, a, b, out)
}

// BoundaryDistanceMatrix has the distance of the outline of each of a from that of each of b. It returns how many meet.
func BoundaryDistanceMatrix[T Float](a, b Array[T], out []T) (int, error) {
	return matrix(cBoundaryDistanceMatrix, a, b, out)
}

// DepthMatrix has how deep each of a and each of b overlap. It returns how many depths are above 0.
func DepthMatrix[T Float](a, b Array[T], out []T) (int, error) {
	return matrix(cDepthMatrix, a, b, out)
}

// Suppression is how Suppress chooses. Its zero value keeps what overlaps nothing better, by intersection over union.
type Suppression[T Float] struct {
	Threshold  T       // of the ratio with every better shape that was kept
	Ratio      Ratio   // any but RatioOverFirst and RatioOverSecond
	Labels     []int32 // one for each shape, only those of the same suppress one another; nil, if all are alike
	LeastScore *T      // shapes below it are not looked at; nil, if all are
	Most       int     // how many are kept at most; 0, if any number
}

// Suppress suppresses greedily: it gives the indices of the shapes kept, best score first. With ErrShape, if a shape is
// invalid, they are those without it.
func Suppress[T Float](shapes Array[T], scores []T, how Suppression[T]) ([]int64, error) {
	n := shapes.Len()
	if len(scores) != n || (how.Labels != nil && len(how.Labels) != n) {
		return nil, fmt.Errorf("%d shapes need as many scores, and labels or none, not %d and %d: %w", n, len(scores),
			len(how.Labels), ErrArgument)
	}
	size, err := count(C.vesica_nms_scratch(C.int64_t(n)))
	if err != nil {
		return nil, err
	}
	least, most := math.Inf(-1), n
	if how.LeastScore != nil {
		least = float64(*how.LeastScore)
	}
	if how.Most != 0 && how.Most < n {
		most = how.Most
	}
	scratch, keep, kept := make([]byte, size), make([]int64, n), int64(0)
	err = status(cSuppress(isWide[T](), shapes.view, first(scores), first(how.Labels), C.int32_t(how.Ratio),
		float64(how.Threshold), least, C.int64_t(most), first(scratch), C.int64_t(size), first(keep), address(&kept)))
	if err != nil && err != ErrShape {
		return nil, err
	}
	return keep[:kept], err
}

// Boxes are five adjacent numbers each: centre x, y, width along the angle, height across it, angle. In what follows an
// invalid one gives NaN throughout, all others are written, and the error is ErrShape or ErrRange.

type fromBoxes = func(bool, *C.char, C.int64_t, C.ptrdiff_t, C.int32_t, *C.char) C.int64_t

func shapesFromBoxes[T Float, S any](function fromBoxes, boxes []T, step int, angle Angle, out []S) error {
	if step < 5 || len(boxes)%step != 0 {
		return fmt.Errorf("%d numbers are no rows of %d, of which 5 are a box's: %w", len(boxes), step, ErrArgument)
	}
	n := len(boxes) / step
	if err := output(out, n, extentOf(boxes)); err != nil {
		return err
	}
	_, err := count(function(isWide[T](), first(boxes), C.int64_t(n), C.ptrdiff_t(uintptr(step)*unsafe.Sizeof(T(0))),
		C.int32_t(angle), first(out)))
	return err
}

// RectsFromBoxes makes rectangles from rows of step numbers, of which the first five are a box. Angles may be
// AngleDegrees|AngleReversed and the like; multiples of 90 degrees turn exactly.
func RectsFromBoxes[T Float](boxes []T, step int, angle Angle, out []Rect[T]) error {
	return shapesFromBoxes(cRectsFromBoxes, boxes, step, angle, out)
}

// EllipsesFromBoxes makes ellipses from the boxes about them, whose sides they touch in the middle.
func EllipsesFromBoxes[T Float](boxes []T, step int, angle Angle, out []Ellipse[T]) error {
	return shapesFromBoxes(cEllipsesFromBoxes, boxes, step, angle, out)
}

// BoxesFromShapes is the way back: the boxes of rectangles, or about ellipses.
func BoxesFromShapes[T Float](shapes Array[T], angle Angle, out [][5]T) error {
	if err := output(out, shapes.Len(), shapes.extent()); err != nil {
		return err
	}
	_, err := count(cBoxesFromShapes(isWide[T](), shapes.view, C.int32_t(angle), first(out)))
	return err
}

// CornersOf has the corners x0 y0 ... x3 y3 of rectangles, or of the boxes about ellipses.
func CornersOf[T Float](shapes Array[T], out [][8]T) error {
	if err := output(out, shapes.Len(), shapes.extent()); err != nil {
		return err
	}
	_, err := count(cCornersOfShapes(isWide[T](), shapes.view, first(out)))
	return err
}

// BoundsMany has the smallest boxes of representable numbers that contain shapes.
func BoundsMany[T Float](shapes Array[T], out []AABB[T]) error {
	if err := output(out, shapes.Len(), shapes.extent()); err != nil {
		return err
	}
	_, err := count(cBoundsMany(isWide[T](), shapes.view, first(out)))
	return err
}
