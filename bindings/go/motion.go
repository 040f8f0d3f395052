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
	n, err := measured(func(wide bool, kindA C.int32_t, shapeA C.vesica_go_shape, kindB C.int32_t,
		shapeB C.vesica_go_shape, out *C.char) C.int32_t {
		found = cCast(wide, kindA, shapeA, kindB, shapeB, motion.VX, motion.VY, motion.End, out)
		return found
	}, 5, a, b)
	if err != nil {
		return CastMiss, Impact[float64]{}, err
	}
	return CastResult(found), Impact[float64]{n[0], n[1], n[2], n[3], n[4]}, nil
}

// ImpactTime tells when two shapes that move and turn touch first, t from 0 to 1. It is proved that there is no contact
// before t, however thin they are and however fast they turn.
//
// At t a centre has moved by t times (VX, VY), and a shape has turned about it by t times Angle, at most 2^20 radians.
// The impact is the place at t: the point of a nearest to b, and the normal that separates them. The gap is how far
// apart they are then at most: no more than the tolerance, a length above 0, but for rounding and very long searches,
// as vesica_motion.h tells.
//
//   - CastMiss: proved, there is no contact from 0 to 1. The time is infinity, the rest NaN.
//   - CastHit: proved, there is contact after t.
//   - CastNear: they come as near as the gap. There may be contact after t, or none. Of a point and a segment, or two
//     points, contact is never proved.
//   - CastStart: they overlap at t = 0, exactly. The gap is 0.
func ImpactTime[A, B Shape](a A, turnA Turn[float64], b B, turnB Turn[float64], tolerance float64) (found CastResult,
	impact Impact[float64], gap float64, err error) {
	var code C.int32_t
	n, err := measured(func(wide bool, kindA C.int32_t, shapeA C.vesica_go_shape, kindB C.int32_t,
		shapeB C.vesica_go_shape, out *C.char) C.int32_t {
		if wide {
			code = cImpactTime(wide, kindA, shapeA, address(&turnA), kindB, shapeB, address(&turnB), tolerance, out,
				address(&gap))
			return code
		}
		narrowA, narrowB, narrowGap := narrow(turnA), narrow(turnB), float32(0)
		code = cImpactTime(wide, kindA, shapeA, address(&narrowA), kindB, shapeB, address(&narrowB), tolerance, out,
			address(&narrowGap))
		gap = float64(narrowGap)
		return code
	}, 5, a, b)
	if err != nil {
		return CastMiss, Impact[float64]{}, 0, err
	}
	return CastResult(code), Impact[float64]{n[0], n[1], n[2], n[3], n[4]}, gap, nil
}

func narrow(turn Turn[float64]) Turn[float32] {
	return Turn[float32]{float32(turn.VX), float32(turn.VY), float32(turn.Angle)}
}

// ImpactColumns are for results; nil columns are not written, but one must be.
type ImpactColumns[T Float] struct{ T, X, Y, NX, NY []T }

// CastMany tells when, and where, b[i] touches a[i]. There are as many velocities as shapes in step, or one. It returns
// how many touch. Of an invalid shape or velocity the numbers are NaN, all others are written, and there is an error.
func CastMany[T Float](a, b Array[T], vx, vy []T, end T, out ImpactColumns[T]) (int, error) {
	n, err := inStep(a, b)
	if err == nil {
		inputs := []extent{a.extent(), b.extent(), extentOf(vx), extentOf(vy)}
		err = outputs(n, inputs, out.T, out.X, out.Y, out.NX, out.NY)
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
		address(&impact)))
	return metFirst(item, many.Len(), impact, err)
}

// SweepBounds is a box that holds a shape throughout its motion.
func SweepBounds[S Shape](shape S, motion Motion) (AABB[float64], error) {
	n, err := measuredOne(func(wide bool, kind C.int32_t, shape C.vesica_go_shape, out *C.char) C.int32_t {
		return cSweepBounds(wide, kind, shape, motion.VX, motion.VY, motion.End, out)
	}, 4, shape)
	return AABB[float64]{n[0], n[1], n[2], n[3]}, err
}

// Cast gives the items that one moving shape touches, in the index's order.
func (x *Index[T]) Cast(one Shape, motion Motion) ([]int64, error) {
	return x.all(one, func(single Array[T], out []int64, state *C.char) C.int64_t {
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
		motion.End, address(&impact)))
	return metFirst(item, x.items, impact, err)
}
