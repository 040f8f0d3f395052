// SPDX-License-Identifier: Apache-2.0

package vesica

// #include "declarations.h"
import "C"

import (
	"fmt"
	"math"
	"unsafe"
)

// Array is an array of shapes of one kind, however it lies in memory. It copies nothing.
type Array[T Float] struct {
	view C.vesica_go_view
}

// Len is how many shapes there are.
func (a Array[T]) Len() int { return int(a.view.count) }

// address is where a value lies. Of C.char, Go takes any that points into an object, whatever else that holds.
func address[E any](value *E) *C.char { return (*C.char)(unsafe.Pointer(value)) }

// first is the address of a slice's first element, or nil.
func first[E any](slice []E) *C.char {
	if len(slice) == 0 {
		return nil
	}
	return address(&slice[0])
}

func arrayOf[T Float](kind Kind, start *C.char, count int) Array[T] {
	return records[T](kind, start, count, kind.Fields())
}

// records has step numbers from one shape to the next.
func records[T Float](kind Kind, start *C.char, count, step int) (array Array[T]) {
	size := unsafe.Sizeof(T(0))
	array.view.kind, array.view.count = C.int32_t(kind), C.int64_t(count)
	array.view.stride = C.ptrdiff_t(uintptr(step) * size)
	if count > 0 {
		for i := 0; i < kind.Fields(); i++ {
			array.view.field[i] = (*C.char)(unsafe.Add(unsafe.Pointer(start), uintptr(i)*size))
		}
	}
	return array
}

// Records is an array of records of step numbers each, of which the first are a shape's.
func Records[T Float](kind Kind, numbers []T, step int) (Array[T], error) {
	if kind.Fields() == 0 {
		return Array[T]{}, ErrKind
	}
	if step < kind.Fields() || len(numbers)%step != 0 {
		return Array[T]{}, fmt.Errorf("%d numbers are no records of %d, of which %d are a shape's: %w", len(numbers),
			step, kind.Fields(), ErrArgument)
	}
	return records[T](kind, first(numbers), len(numbers)/step, step), nil
}

// Packed is an array of shapes whose numbers follow one another.
func Packed[T Float](kind Kind, numbers []T) (Array[T], error) {
	return Records(kind, numbers, kind.Fields())
}

// Columns is an array with a column for each number of the kind, in its order, all of one length.
func Columns[T Float](kind Kind, columns ...[]T) (array Array[T], err error) {
	if kind.Fields() == 0 {
		return array, ErrKind
	}
	if len(columns) != kind.Fields() {
		return array, fmt.Errorf("%d columns, where the kind has %d: %w", len(columns), kind.Fields(), ErrArgument)
	}
	array.view.kind, array.view.count = C.int32_t(kind), C.int64_t(len(columns[0]))
	array.view.stride = C.ptrdiff_t(unsafe.Sizeof(T(0)))
	for i, column := range columns {
		if len(column) != len(columns[0]) {
			return Array[T]{}, fmt.Errorf("columns of %d and %d numbers: %w", len(columns[0]), len(column), ErrArgument)
		}
		array.view.field[i] = first(column)
	}
	return array, nil
}

// arrayOfOne is an array of a single shape: of its own numbers, or of the caller's vertices.
func arrayOfOne[T Float](shape Shape) (Array[T], error) {
	s := shape.one()
	if s.wide != isWide[T]() {
		return Array[T]{}, errScalars
	}
	if Kind(s.kind).isPath() {
		return arrayOfPath[T](s), nil
	}
	return arrayOf[T](Kind(s.kind), address(&s.shape.numbers), 1), nil
}

// times is a product, or the greatest int if that is less.
func times(a, b int) int {
	if b > 0 && a > math.MaxInt/b {
		return math.MaxInt
	}
	return a * b
}

func room(name string, given, needed int) error {
	if given < needed {
		return fmt.Errorf("%s has %d elements, where %d are needed: %w", name, given, needed, ErrArgument)
	}
	return nil
}

// inStep is how many answers arrays in step have.
func inStep[T Float](a, b Array[T]) (int, error) {
	switch {
	case a.Len() == b.Len() || b.Len() == 1:
		return a.Len(), nil
	case a.Len() == 1:
		return b.Len(), nil
	}
	return 0, fmt.Errorf("a has %d shapes and b %d, as many are needed, or one of either: %w", a.Len(), b.Len(),
		ErrArgument)
}

// extent is where memory lies: from an address up to another.
type extent struct{ from, to uintptr }

func extentOf[E any](slice []E) extent {
	if len(slice) == 0 {
		return extent{}
	}
	from := uintptr(unsafe.Pointer(&slice[0]))
	return extent{from, from + uintptr(len(slice))*unsafe.Sizeof(slice[0])}
}

// extent is where the numbers of an array lie, with what is between them.
func (a Array[T]) extent() (all extent) {
	if a.Len() == 0 {
		return extent{}
	}
	fields, count := Kind(a.view.kind).Fields(), a.view.count
	if Kind(a.view.kind).isPath() {
		fields, count = 2, a.vertices()
	}
	last := uintptr(count-1) * uintptr(a.view.stride)
	all.from = uintptr(unsafe.Pointer(a.view.field[0]))
	for _, field := range a.view.field[:fields] {
		start := uintptr(unsafe.Pointer(field))
		if start < all.from {
			all.from = start
		}
		if end := start + last + unsafe.Sizeof(T(0)); end > all.to {
			all.to = end
		}
	}
	return all
}

// output says what is wrong with memory for so many results, which must not be where something else is taken.
func output[R any](out []R, needed int, taken ...extent) error {
	if err := room("out", len(out), needed); err != nil {
		return err
	}
	own := extentOf(out[:needed])
	for _, other := range taken {
		if own.from < other.to && other.from < own.to {
			return fmt.Errorf("out overlaps an input or another output, results need memory of their own: %w", ErrArgument)
		}
	}
	return nil
}

func many[T Float, R any](function func(bool, C.vesica_go_view, C.vesica_go_view, *C.char) C.int64_t, a, b Array[T],
	out []R) (int, error) {
	n, err := inStep(a, b)
	if err == nil {
		err = output(out, n, a.extent(), b.extent())
	}
	if err != nil {
		return 0, err
	}
	return count(function(isWide[T](), a.view, b.view, first(out)))
}

// In each of these, arrays are in step, or one is of a single shape, which is repeated. If a shape is invalid its own
// result is 0 or NaN, all others are written, and the error is ErrShape.

// OverlapMany sets out[i]: do a[i] and b[i] share a point? It returns how many do.
func OverlapMany[T Float](a, b Array[T], out []bool) (int, error) {
	return many(cOverlapMany, a, b, out)
}

// InteriorsOverlapMany sets out[i]: do the insides of a[i] and b[i] share a point? It returns how many do.
func InteriorsOverlapMany[T Float](a, b Array[T], out []bool) (int, error) {
	return many(cInteriorsOverlapMany, a, b, out)
}

// RelationMany sets out[i]: how does a[i] relate to b[i]? It returns how many are not disjoint.
func RelationMany[T Float](a, b Array[T], out []Relation) (int, error) {
	return many(cRelationMany, a, b, out)
}

// ContainsMany sets out[i]: does a[i] hold all of b[i]? It returns how many do.
func ContainsMany[T Float](a, b Array[T], out []bool) (int, error) {
	return many(cContainsMany, a, b, out)
}

// AreaMany sets out[i] to the area that a[i] and b[i] share. It returns how many are above 0.
func AreaMany[T Float](a, b Array[T], out []T) (int, error) { return many(cAreaMany, a, b, out) }

// IoUMany sets out[i] to the intersection over union of a[i] and b[i]. It returns how many are above 0.
func IoUMany[T Float](a, b Array[T], out []T) (int, error) { return many(cIOUMany, a, b, out) }

// ClosestPointsColumns are for results; nil columns are not written, but one must be.
type ClosestPointsColumns[T Float] struct{ Distance, AX, AY, BX, BY []T }

// PenetrationColumns are for results; nil columns are not written, but one must be.
type PenetrationColumns[T Float] struct{ Depth, X, Y []T }

// outputs says what is wrong with columns for so many results each, of which nil ones are not written.
func outputs[T Float](needed int, inputs []extent, columns ...[]T) error {
	taken := append(make([]extent, 0, 9), inputs...)
	for _, column := range columns {
		if column == nil {
			continue
		}
		if err := output(column, needed, taken...); err != nil {
			return err
		}
		taken = append(taken, extentOf(column[:needed]))
	}
	return nil
}

type closest = func(bool, C.vesica_go_view, C.vesica_go_view, *C.char, *C.char, *C.char, *C.char, *C.char) C.int64_t

func closestMany[T Float](function closest, a, b Array[T], out ClosestPointsColumns[T]) (int, error) {
	n, err := inStep(a, b)
	if err == nil {
		err = outputs(n, []extent{a.extent(), b.extent()}, out.Distance, out.AX, out.AY, out.BX, out.BY)
	}
	if err != nil {
		return 0, err
	}
	return count(function(isWide[T](), a.view, b.view, first(out.Distance), first(out.AX), first(out.AY), first(out.BX),
		first(out.BY)))
}

// NearestMany tells how far a[i] and b[i] are apart, and where. It returns how many overlap.
func NearestMany[T Float](a, b Array[T], out ClosestPointsColumns[T]) (int, error) {
	return closestMany(cNearestMany, a, b, out)
}

// BoundaryDistanceMany tells how far the outlines of a[i] and b[i] are apart. It returns how many meet.
func BoundaryDistanceMany[T Float](a, b Array[T], out ClosestPointsColumns[T]) (int, error) {
	return closestMany(cBoundaryDistanceMany, a, b, out)
}

// DepthMany tells how deep a[i] and b[i] overlap. It returns how many depths are above 0.
func DepthMany[T Float](a, b Array[T], out PenetrationColumns[T]) (int, error) {
	n, err := inStep(a, b)
	if err == nil {
		err = outputs(n, []extent{a.extent(), b.extent()}, out.Depth, out.X, out.Y)
	}
	if err != nil {
		return 0, err
	}
	return count(cDepthMany(isWide[T](), a.view, b.view, first(out.Depth), first(out.X), first(out.Y)))
}

func matrix[T Float, R any](
	function func(bool, C.vesica_go_view, C.vesica_go_view, *C.char, C.ptrdiff_t) C.int64_t, a, b Array[T],
	out []R) (int, error) {
	if err := output(out, times(a.Len(), b.Len()), a.extent(), b.extent()); err != nil {
		return 0, err
	}
	return count(function(isWide[T](), a.view, b.view, first(out), C.ptrdiff_t(b.Len())))
}

// Of every pair: out[i*b.Len()+j] is of a[i] and b[j].

// OverlapMatrix tells of each of a whether it overlaps each of b. It returns how many pairs do.
func OverlapMatrix[T Float](a, b Array[T], out []bool) (int, error) {
	return matrix(cOverlapMatrix, a, b, out)
}

// InteriorsOverlapMatrix tells of each of a whether its inside shares a point with that of each of b. It returns how many
// pairs do.
func InteriorsOverlapMatrix[T Float](a, b Array[T], out []bool) (int, error) {
	return matrix(cInteriorsOverlapMatrix, a, b, out)
}

// RelationMatrix tells how each of a relates to each of b. It returns how many are not disjoint.
func RelationMatrix[T Float](a, b Array[T], out []Relation) (int, error) {
	return matrix(cRelationMatrix, a, b, out)
}

// ContainsMatrix tells of each of a whether it holds all of each of b. It returns how many do.
func ContainsMatrix[T Float](a, b Array[T], out []bool) (int, error) {
	return matrix(cContainsMatrix, a, b, out)
}

// AreaMatrix has the area that each of a shares with each of b. It returns how many are above 0.
func AreaMatrix[T Float](a, b Array[T], out []T) (int, error) { return matrix(cAreaMatrix, a, b, out) }

// IoUMatrix has the intersection over union of each of a with each of b. It returns how many are above 0.
func IoUMatrix[T Float](a, b Array[T], out []T) (int, error) { return matrix(cIOUMatrix, a, b, out) }

// OverlapSelect gives the indices of those of many that overlap one, in ascending order. With ErrShape too, if it is
// one of many that is invalid: it is not among them.
func OverlapSelect[T Float](one Shape, many Array[T]) ([]int64, error) {
	return selected(cOverlapSelect, one, many)
}

// InteriorsOverlapSelect gives the indices of those of many whose insides share a point with that of one; otherwise as
// OverlapSelect.
func InteriorsOverlapSelect[T Float](one Shape, many Array[T]) ([]int64, error) {
	return selected(cInteriorsOverlapSelect, one, many)
}

func selected[T Float](
	function func(bool, C.vesica_go_view, C.vesica_go_view, *C.char, C.int64_t) C.int64_t, one Shape, many Array[T],
) ([]int64, error) {
	single, err := arrayOfOne[T](one)
	if err != nil {
		return nil, err
	}
	out := make([]int64, many.Len()+1)
	_, err = count(function(isWide[T](), single.view, many.view, first(out), C.int64_t(len(out))))
	if err != nil && err != ErrShape {
		return nil, err
	}
	for i, index := range out {
		if index < 0 {
			return out[:i], err
		}
	}
	return out, err
}

// NMS suppresses greedily: it gives the indices of the shapes kept, best score first.
//
// Each shape kept has an intersection over union of at most threshold with every better one that was kept. With
// ErrShape, if a shape is invalid, they are those without it.
func NMS[T Float](shapes Array[T], scores []T, threshold T) ([]int64, error) {
	n := shapes.Len()
	if len(scores) != n {
		return nil, fmt.Errorf("%d shapes need as many scores, not %d: %w", n, len(scores), ErrArgument)
	}
	size, err := count(C.vesica_nms_scratch(C.int64_t(n)))
	if err != nil {
		return nil, err
	}
	scratch, keep, kept := make([]byte, size), make([]int64, n), int64(0)
	err = status(cNMS(isWide[T](), shapes.view, first(scores), float64(threshold), first(scratch), C.int64_t(size),
		first(keep), address(&kept)))
	if err != nil && err != ErrShape {
		return nil, err
	}
	return keep[:kept], err
}
