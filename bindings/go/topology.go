// SPDX-License-Identifier: Apache-2.0

package vesica

// #include <stdlib.h>
// #include "declarations.h"
import "C"

import (
	"fmt"
	"strings"
	"unsafe"
)

// Within tells whether two shapes are at most distance apart. Exactly so far counts, and exact, but for ellipses. If
// distance is negative, it tells whether they overlap at least that deep.
func Within[A, B Shape](a A, b B, distance float64) (WithinResult, error) {
	code, err := codeOf(func(wide bool, kindA C.int32_t, shapeA C.vesica_go_shape, kindB C.int32_t,
		shapeB C.vesica_go_shape) C.int32_t {
		return cWithin(wide, kindA, shapeA, kindB, shapeB, distance)
	}, a, b)
	return WithinResult(code), err
}

// WithinMany sets out[i]: are a[i] and b[i] at most distance apart? It returns how many are, or are WithinNearly.
func WithinMany[T Float](a, b Array[T], distance T, out []WithinResult) (int, error) {
	return many(func(wide bool, a, b C.vesica_go_view, out *C.char) C.int64_t {
		return cWithinMany(wide, a, b, float64(distance), out)
	}, a, b, out)
}

// WithinMatrix tells of each of a whether it is at most distance from each of b.
func WithinMatrix[T Float](a, b Array[T], distance T, out []WithinResult) (int, error) {
	return matrix(func(wide bool, a, b C.vesica_go_view, out *C.char, row C.ptrdiff_t) C.int64_t {
		return cWithinMatrix(wide, a, b, float64(distance), out, row)
	}, a, b, out)
}

// SignedDistance is the distance of two shapes or, below 0, how deep they overlap.
func SignedDistance[A, B Shape](a A, b B) (float64, error) {
	n, err := measured(cSignedDistance, 1, a, b)
	return n[0], err
}

// SignedDistanceMany sets out[i] to the signed distance of a[i] and b[i]. It returns how many overlap.
func SignedDistanceMany[T Float](a, b Array[T], out []T) (int, error) {
	return many(cSignedDistanceMany, a, b, out)
}

// SignedDistanceMatrix has the signed distance of each of a and each of b. It returns how many pairs overlap.
func SignedDistanceMatrix[T Float](a, b Array[T], out []T) (int, error) {
	return matrix(cSignedDistanceMatrix, a, b, out)
}

// DE9IM is the nine-intersection matrix of two shapes, as geographic systems have it, such as "FF2F11212". Exact.
func DE9IM[A, B Shape](a A, b B) (string, error) {
	first, second := a.one(), b.one()
	if first.wide != second.wide {
		return "", errScalars
	}
	var text [10]byte
	code := cDe9im(first.wide, first.kind, first.shape, second.kind, second.shape, address(&text))
	if err := status(code); err != nil {
		return "", err
	}
	return string(text[:9]), nil
}

// DE9IMMatch tells whether such a matrix fits a pattern of F, 0, 1, 2, T (any of 0, 1 and 2) and * (anything).
func DE9IMMatch(matrix, pattern string) (bool, error) {
	if strings.Contains(matrix+pattern, "\x00") {
		return false, ErrArgument
	}
	first, second := C.CString(matrix), C.CString(pattern)
	defer C.free(unsafe.Pointer(first))
	defer C.free(unsafe.Pointer(second))
	code, err := count(C.vesica_de9im_match(first, second))
	return code == 1, err
}

// Intersection has the vertices of the region that two shapes share, counter-clockwise; none if they do not overlap. It
// is of points, segments, boxes, rectangles and convex polygons, or of a point or a segment and any shape. Of a segment
// and a polygon or a polyline it has two vertices for each piece, in order along the segment.
func Intersection[A, B Shape](a A, b B) ([]Point[float64], error) {
	return pointsOf(a.one(), b.one(), func(a, b one, out *C.char, room C.int64_t) C.int64_t {
		return cIntersection(a.wide, a.kind, a.shape, b.kind, b.shape, out, room)
	})
}

// SoftSuppression is how SuppressSoft chooses.
type SoftSuppression[T Float] struct {
	Decay      Decay   // DecayLinear: what has a ratio r above Parameter keeps 1 - r; DecayGaussian: exp(-r*r/Parameter)
	Parameter  T       // a threshold from 0 to 1, or what r*r is divided by
	Ratio      Ratio   // any but RatioOverFirst and RatioOverSecond
	Labels     []int32 // one for each shape, only those of the same lower one another; nil, if all are alike
	LeastScore T       // it ends when no score is left that is at least this, from 0
	Most       int     // how many are kept at most; 0, if any number
}

// SuppressSoft gives the indices of shapes as they are taken, best score first, and the scores that were left then:
// each shape taken lowers those of what it has a ratio with. With ErrShape, if a shape is invalid, they are those
// without it.
func SuppressSoft[T Float](shapes Array[T], scores []T, how SoftSuppression[T]) ([]int64, []T, error) {
	n := shapes.Len()
	if len(scores) != n || (how.Labels != nil && len(how.Labels) != n) {
		return nil, nil, fmt.Errorf("%d shapes need as many scores, and labels or none, not %d and %d: %w", n, len(scores),
			len(how.Labels), ErrArgument)
	}
	size, err := count(C.vesica_suppress_soft_scratch(C.int64_t(n)))
	if err != nil {
		return nil, nil, err
	}
	most := n
	if how.Most != 0 && how.Most < n {
		most = how.Most
	}
	scratch, keep, left, kept := make([]int64, size/8), make([]int64, n), make([]T, n), int64(0)
	err = status(cSuppressSoft(isWide[T](), shapes.view, first(scores), first(how.Labels), C.int32_t(how.Ratio),
		C.int32_t(how.Decay), float64(how.Parameter), float64(how.LeastScore), C.int64_t(most), first(scratch),
		C.int64_t(size), first(keep), first(left), address(&kept)))
	if err != nil && err != ErrShape {
		return nil, nil, err
	}
	return keep[:kept], left[:kept], err
}

// JoinWithin gives all pairs of an item of this index and one of another that are at most distance apart, as Join does.
// Of ellipses also those too near to it to tell. If distance is negative, the pairs overlap at least that deep.
func (x *Index[T]) JoinWithin(other *Index[T], distance T) ([]Pair, error) {
	const capacity = 1 << 14
	a, b, state := make([]int64, capacity), make([]int64, capacity), make([]int64, 4)
	pairs := []Pair{}
	for state[0] != -1 {
		found, err := count(cJoinWithin(isWide[T](), first(x.bytes), x.sets, x.count, first(other.bytes), other.sets,
			other.count, float64(distance), 0, 1, first(a), first(b), capacity, first(state)))
		if err != nil {
			return nil, err
		}
		for i := 0; i < found; i++ {
			pairs = append(pairs, Pair{a[i], b[i]})
		}
	}
	return pairs, nil
}
