// SPDX-License-Identifier: Apache-2.0

package vesica

// #include "declarations.h"
import "C"

import (
	"fmt"
	"unsafe"
)

// Motion is how a shape moves: by t times a velocity, t from 0 to End, which may be infinite. A ray is a point that
// moves.
type Motion struct{ VX, VY, End float64 }

// Cast tells whether b touches a while it moves, when first, and where; the normal is from a to b. Whether it does is
// exact, and the time is rounded down. After a miss the time is infinity and the rest NaN.
func Cast[A, B Shape](a A, b B, motion Motion) (CastResult, Impact[float64], error) {
	var found C.int32_t
	n, err := measured(func(wide bool, kindA C.int32_t, numbersA C.vesica_go_numbers, kindB C.int32_t,
		numbersB C.vesica_go_numbers, out unsafe.Pointer) C.int32_t {
		found = cCast(wide, kindA, numbersA, kindB, numbersB, motion.VX, motion.VY, motion.End, out)
		return found
	}, 5, a, b)
	if err != nil {
		return CastMiss, Impact[float64]{}, err
	}
	return CastResult(found), Impact[float64]{n[0], n[1], n[2], n[3], n[4]}, nil
}

// ImpactColumns are for results; nil columns are not written, but one must be.
type ImpactColumns[T Float] struct{ T, X, Y, NX, NY []T }

// CastMany tells when, and where, b[i] touches a[i]. There are as many velocities as shapes in step, or one. It returns
// how many touch. Of an invalid shape or velocity the numbers are NaN, all others are written, and there is an error.
func CastMany[T Float](a, b Array[T], vx, vy []T, end T, out ImpactColumns[T]) (int, error) {
	n, err := inStep(a, b)
	if err == nil {
		err = outputs(a, b, n, out.T, out.X, out.Y, out.NX, out.NY)
	}
	if err == nil && (len(vx) != len(vy) || (len(vx) != n && len(vx) != 1)) {
		err = fmt.Errorf("%d and %d velocities, 1 or %d are needed: %w", len(vx), len(vy), n, ErrArgument)
	}
	if err != nil {
		return 0, err
	}
	stride := C.ptrdiff_t(unsafe.Sizeof(T(0)))
	if len(vx) == 1 {
		stride = 0
	}
	return count(cCastMany(isWide[T](), a.view, b.view, first(vx), first(vy), stride, float64(end), first(out.T),
		first(out.X), first(out.Y), first(out.NX), first(out.NY)))
}

// none is the item of a cast that meets nothing.
const none = -1

// metFirst is the item that was met first of some, or none.
func metFirst[T Float](item, items int, impact Impact[T], err error) (int, Impact[T], error) {
	if err != nil {
		return none, Impact[T]{}, err
	}
	if item == items {
		item = none
	}
	return item, impact, nil
}

// CastFirst tells which of many shapes at rest one moving shape touches first, the lowest of several, or -1. The normal
// points to one.
func CastFirst[T Float](one Shape, many Array[T], motion Motion) (int, Impact[T], error) {
	single, err := arrayOfOne[T](one)
	if err != nil {
		return none, Impact[T]{}, err
	}
	var impact Impact[T]
	item, err := count(cCastFirst(isWide[T](), single.view, many.view, motion.VX, motion.VY, motion.End,
		unsafe.Pointer(&impact)))
	return metFirst(item, many.Len(), impact, err)
}

// SweepBounds is a box that holds a shape throughout its motion.
func SweepBounds[S Shape](shape S, motion Motion) (AABB[float64], error) {
	n, err := measuredOne(func(wide bool, kind C.int32_t, numbers C.vesica_go_numbers, out unsafe.Pointer) C.int32_t {
		return cSweepBounds(wide, kind, numbers, motion.VX, motion.VY, motion.End, out)
	}, 4, shape)
	return AABB[float64]{n[0], n[1], n[2], n[3]}, err
}

// Cast gives the items that one moving shape touches, in the index's order.
func (x *Index[T]) Cast(one Shape, motion Motion) ([]int64, error) {
	return x.all(one, func(single Array[T], out []int64, state unsafe.Pointer) C.int64_t {
		return cIndexCast(isWide[T](), first(x.bytes), x.sets, x.count, single.view, motion.VX, motion.VY, motion.End,
			first(out), C.int64_t(len(out)), state)
	})
}

// CastFirst tells which item one moving shape touches first, the lowest of several, or -1. The normal points to one.
func (x *Index[T]) CastFirst(one Shape, motion Motion) (int, Impact[T], error) {
	single, err := arrayOfOne[T](one)
	if err != nil {
		return none, Impact[T]{}, err
	}
	var impact Impact[T]
	item, err := count(cIndexCastFirst(isWide[T](), first(x.bytes), x.sets, x.count, single.view, motion.VX, motion.VY,
		motion.End, unsafe.Pointer(&impact)))
	return metFirst(item, x.items, impact, err)
}
