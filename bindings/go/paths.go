// SPDX-License-Identifier: Apache-2.0

package vesica

// #include "declarations.h"
import "C"

import (
	"fmt"
	"math"
	"unsafe"
)

// Polygon is rings of vertices, each joined to a closed curve. What an odd number of them goes around is inside: a ring
// inside another is a hole, whatever their order and directions.
type Polygon[T Float] struct{ path[T] }

// Polyline is chains of vertices, which are not closed and have no inside.
type Polyline[T Float] struct{ path[T] }

// How many numbers a vertex has.
const pair = 2

func (p Polygon[T]) one() one  { return p.oneOf(KindPolygon) }
func (p Polyline[T]) one() one { return p.oneOf(KindPolyline) }

// path is vertices x y x y ..., and where rings begin among them, with the end; nil, if all are of one ring.
type path[T Float] struct {
	xy    []T
	rings []int32
}

// NewPolygon is a polygon of vertices x y x y ..., which are read where they lie at each call. Rings are where each
// ring begins among the vertices, with the end; none, if all are of one ring. They are copied.
func NewPolygon[T Float](xy []T, rings ...int32) (Polygon[T], error) {
	made, err := newPath(xy, rings)
	return Polygon[T]{made}, err
}

// NewPolyline is a polyline, else as NewPolygon, with chains in place of rings.
func NewPolyline[T Float](xy []T, chains ...int32) (Polyline[T], error) {
	made, err := newPath(xy, chains)
	return Polyline[T]{made}, err
}

var errNoVertex = fmt.Errorf("no vertex, where one is needed: %w", ErrRings)

func newPath[T Float](xy []T, rings []int32) (path[T], error) {
	if err := pairs(xy); err != nil {
		return path[T]{}, err
	}
	if len(xy) == 0 {
		return path[T]{}, errNoVertex
	}
	if len(rings) == 0 {
		return path[T]{xy: xy}, nil
	}
	if err := ascend(rings, len(xy)/pair); err != nil {
		return path[T]{}, err
	}
	return path[T]{xy, append([]int32(nil), rings...)}, nil
}

func pairs[T Float](xy []T) error {
	if len(xy)%pair != 0 {
		return fmt.Errorf("%d numbers are no pairs x y: %w", len(xy), ErrArgument)
	}
	return nil
}

// ascend says what is wrong with offsets into that many others.
func ascend(offsets []int32, end int) error {
	if len(offsets) == 0 {
		return fmt.Errorf("no offset, where one more is needed than there are parts: %w", ErrRings)
	}
	before := int32(0)
	for _, offset := range offsets {
		if offset < before {
			return fmt.Errorf("offset %d follows %d, offsets ascend from 0 or more: %w", offset, before, ErrRings)
		}
		before = offset
	}
	if int(before) > end {
		return fmt.Errorf("offset %d, where there are %d: %w", before, end, ErrRings)
	}
	return nil
}

func (k Kind) isPath() bool { return k == KindPolygon || k == KindPolyline }

func offsets(of []int32) *C.int32_t { return (*C.int32_t)(unsafe.Pointer(first(of))) }

func (p path[T]) oneOf(kind Kind) one {
	shape := one{kind: C.int32_t(kind), wide: isWide[T]()}
	array := ofVertices[T](kind, first(p.xy), 1, len(p.xy)/pair)
	of := &shape.shape.path
	of.x, of.y, of.stride, of.count = array.view.field[0], array.view.field[1], array.view.stride, array.view.each
	if p.rings != nil {
		of.rings, of.count = offsets(p.rings), C.int64_t(len(p.rings)-1)
	}
	return shape
}

func arrayOfPath[T Float](shape one) Array[T] {
	of := shape.shape.path
	array := ofVertices[T](Kind(shape.kind), of.x, 1, int(of.count))
	if of.rings != nil {
		array.view.each, array.view.rings = 0, of.rings
		array.view.polygons = offsets([]int32{0, int32(of.count)})
	}
	return array
}

func ofVertices[T Float](kind Kind, start *C.char, count, each int) (array Array[T]) {
	size := unsafe.Sizeof(T(0))
	array.view.kind, array.view.count, array.view.each = C.int32_t(kind), C.int64_t(count), C.int64_t(each)
	array.view.stride = C.ptrdiff_t(pair * size)
	if array.view.field[0] = start; start != nil {
		array.view.field[1] = (*C.char)(unsafe.Add(unsafe.Pointer(start), size))
	}
	return array
}

// vertices is how many there are behind an array of polygons or polylines.
func (a Array[T]) vertices() C.int64_t {
	if a.view.rings == nil {
		return a.view.each * a.view.count
	}
	return a.view.each
}

// EvenPaths is an array of polygons or polylines of as many vertices each, in one ring or chain: 4 are quads, 3
// triangles. The vertices x y x y ... follow one another.
func EvenPaths[T Float](kind Kind, xy []T, each int) (array Array[T], err error) {
	if !kind.isPath() {
		return array, ErrKind
	}
	if each < 1 || len(xy)%pair != 0 || len(xy)/pair%each != 0 {
		return array, fmt.Errorf("%d numbers are no paths of %d vertices x y: %w", len(xy), each, ErrArgument)
	}
	return ofVertices[T](kind, first(xy), len(xy)/pair/each, each), nil
}

// Paths is an array of polygons or polylines with any number of vertices x y x y .... Rings are where each ring begins
// among the vertices, with the end: as GeoArrow has them. They ascend. If polygons is nil, a ring is a polygon; else it
// is where each polygon begins among the rings, with the end, and is copied. All else is read where it lies.
func Paths[T Float](kind Kind, xy []T, rings, polygons []int32) (array Array[T], err error) {
	if !kind.isPath() {
		return array, ErrKind
	}
	if err = pairs(xy); err == nil {
		err = ascend(rings, len(xy)/pair)
	}
	if err == nil && len(xy) == 0 && len(rings) > 1 {
		err = errNoVertex
	}
	if err == nil && polygons != nil {
		err = ascend(polygons, len(rings)-1)
	}
	if err != nil {
		return array, err
	}
	array = ofVertices[T](kind, first(xy), len(rings)-1, len(xy)/pair)
	array.view.rings = offsets(rings)
	if polygons != nil {
		array.view.count = C.int64_t(len(polygons) - 1)
		array.view.polygons = offsets(append([]int32(nil), polygons...))
	}
	return array, nil
}

// Polygons is an array of copies. Paths copies no vertex.
func Polygons[T Float](shapes []Polygon[T]) (Array[T], error) {
	return copied(KindPolygon, len(shapes), func(i int) path[T] { return shapes[i].path })
}

// Polylines is an array of copies. Paths copies no vertex.
func Polylines[T Float](shapes []Polyline[T]) (Array[T], error) {
	return copied(KindPolyline, len(shapes), func(i int) path[T] { return shapes[i].path })
}

func copied[T Float](kind Kind, count int, at func(i int) path[T]) (Array[T], error) {
	xy, rings, polygons := []T{}, []int32{0}, []int32{0}
	for i := 0; i < count; i++ {
		of := at(i)
		if (len(xy)+len(of.xy))/pair > math.MaxInt32 {
			return Array[T]{}, fmt.Errorf("more than %d vertices: %w", math.MaxInt32, ErrArgument)
		}
		ends := of.rings
		if ends == nil {
			ends = []int32{0, int32(len(of.xy) / pair)}
		}
		shift := int32(len(xy)/pair) - ends[0]
		for _, end := range ends[1:] {
			rings = append(rings, end+shift)
		}
		xy = append(xy, of.xy[pair*int(ends[0]):pair*int(ends[len(ends)-1])]...)
		polygons = append(polygons, int32(len(rings)-1))
	}
	return Paths(kind, xy, rings, polygons)
}
