// SPDX-License-Identifier: Apache-2.0

package vesica

import (
	"math"
	"testing"
)

func equal[V comparable](t *testing.T, name string, got V, err error, expected V) {
	t.Helper()
	if err != nil || got != expected {
		t.Error(name, got, err, "not", expected)
	}
}

// frame is a square of side 8 with a hole of side 4 in its middle.
func frame[T Float]() Polygon[T] {
	return must(NewPolygon([]T{0, 0, 8, 0, 8, 8, 0, 8, 2, 2, 6, 2, 6, 6, 2, 6}, 0, 4, 8))
}

func onePolygon[T Float](t *testing.T) {
	t.Helper()
	hollow := frame[T]()
	triangle := must(NewPolygon([]T{0, 0, 4, 0, 0, 3}))
	chain := must(NewPolyline([]T{-1, 1, 9, 1, 9, 9}))
	centre := Circle[T]{CX: 4, CY: 4, R: 1}
	inHole, err := Overlap(hollow, centre)
	equal(t, "Overlap", inHole, err, false)
	crossed, err := Overlap(hollow, chain)
	equal(t, "Overlap", crossed, err, true)
	insides, err := InteriorsOverlap(hollow, Circle[T]{CX: 4, CY: 4, R: 2})
	equal(t, "InteriorsOverlap", insides, err, false)
	relation, err := RelationOf(triangle, Point[T]{1, 1})
	equal(t, "RelationOf", relation, err, RelationContains)
	holds, err := Contains(hollow, Circle[T]{CX: 1, CY: 1, R: 1})
	equal(t, "Contains", holds, err, true)
	near, err := Nearest(hollow, centre)
	equal(t, "Nearest", near.Distance, err, 1)
	outline, err := BoundaryDistance(triangle, Circle[T]{CX: 1, CY: 1, R: 0.5})
	equal(t, "BoundaryDistance", outline.Distance, err, 0.5)
	depth, err := Depth(triangle, Point[T]{1, 1})
	equal(t, "Depth", depth.Depth, err, 1)
	distance, err := SignedDistance(triangle, Point[T]{-3, 0})
	equal(t, "SignedDistance", distance, err, 3)
	within, err := Within(triangle, Point[T]{-3, 0}, 3)
	equal(t, "Within", within, err, WithinYes)
	area, err := Area(triangle, AABB[T]{0, 0, 2, 9})
	equal(t, "Area", area, err, 4.5)
	iou, err := IoU(hollow, AABB[T]{0, 0, 8, 8})
	equal(t, "IoU", iou, err, 0.75)
	ratio, err := RatioOf(RatioOverFirst, triangle, AABB[T]{0, 0, 2, 9})
	equal(t, "RatioOf", ratio, err, 0.75)
	own, err := ShapeArea(hollow)
	equal(t, "ShapeArea", own, err, 48)
	bounds, err := Bounds(triangle)
	equal(t, "Bounds", bounds, err, AABB[float64]{0, 0, 4, 3})
	found, impact, err := Cast(triangle, Point[T]{9, 1}, Motion{VX: -1, End: 99})
	equal(t, "Cast", found, err, CastHit)
	equal(t, "Cast", math.Abs(impact.T-19.0/3) < 1e-6, err, true)
	swept, err := SweepBounds(triangle, Motion{VX: 1, End: 2})
	equal(t, "SweepBounds", swept.MaxX >= 6 && swept.MaxX < 6.001, err, true)
	if err := Check(hollow); err != nil {
		t.Error(err)
	}
}

func TestOnePolygon(t *testing.T) {
	onePolygon[float64](t)
	onePolygon[float32](t)
}

// Quads of side 2, 3 apart.
func row[T Float](count int) []T {
	var xy []T
	for i := 0; i < count; i++ {
		x := T(3 * i)
		xy = append(xy, x, 0, x+2, 0, x+2, 2, x, 2)
	}
	return xy
}

func manyPolygons[T Float](t *testing.T) {
	t.Helper()
	quads := must(EvenPaths(KindPolygon, row[T](3), 4))
	ringed := must(Paths(KindPolygon, row[T](3), []int32{0, 4, 8, 12}, nil))
	nested := must(Paths(KindPolygon, row[T](3), []int32{0, 4, 8, 12}, []int32{0, 1, 3}))
	copies := must(Polygons([]Polygon[T]{
		must(NewPolygon(row[T](1))), must(NewPolygon(row[T](2), 4, 8)), must(NewPolygon(row[T](3)[16:])), frame[T](),
	}))
	if quads.Len() != 3 || ringed.Len() != 3 || nested.Len() != 2 || copies.Len() != 4 {
		t.Fatal(quads.Len(), ringed.Len(), nested.Len(), copies.Len())
	}
	discs := Circles([]Circle[T]{{1, 1, 1}, {4, 1, 1}, {9, 9, 1}})
	hits := make([]bool, 12)
	n, err := OverlapMany(quads, discs, hits)
	equal(t, "OverlapMany", n, err, 2)
	n, err = OverlapMatrix(copies, discs, hits)
	equal(t, "OverlapMatrix", n, err, 4)
	for i, expected := range []bool{true, false, false, false, true, false, false, false, false, true, true, false} {
		equal(t, "OverlapMatrix", hits[i], nil, expected)
	}
	relations := make([]Relation, 3)
	n, err = RelationMany(quads, ringed, relations)
	equal(t, "RelationMany", n, err, 3)
	equal(t, "RelationMany", relations[2], nil, RelationEqual)
	areas := make([]T, 6)
	n, err = AreaMatrix(nested, quads, areas)
	equal(t, "AreaMatrix", n, err, 3)
	for i, expected := range []T{4, 0, 0, 0, 4, 4} {
		equal(t, "AreaMatrix", areas[i], nil, expected)
	}
	boxes := make([]AABB[T], 2)
	equal(t, "BoundsMany", true, BoundsMany(nested, boxes), true)
	equal(t, "BoundsMany", boxes[1], nil, AABB[T]{3, 0, 8, 2})
	distances := make([]T, 3)
	roof := must(EvenPaths(KindPolyline, []T{0, 5, 9, 5}, 2))
	n, err = NearestMany(quads, roof, ClosestPointsColumns[T]{Distance: distances})
	equal(t, "NearestMany", n, err, 0)
	equal(t, "NearestMany", distances[1], nil, 3)
	chosen, err := OverlapSelect(must(NewPolygon([]T{1, 1, 4, 1, 4, 1.5})), quads)
	equal(t, "OverlapSelect", len(chosen), err, 2)
	around := []T{-2, -2, 9, -2, 9, 9, -2, 9, -3, -3, 99, -3, 99, 99, -3, 99}
	chosen, err = OverlapSelect(must(NewPolygon(around, 0, 4, 8)), discs)
	equal(t, "OverlapSelect", len(chosen), err, 1)
	kept, err := NMS(quads, []T{1, 2, 3}, 0.5)
	equal(t, "NMS", len(kept), err, 3)

	index := must(NewIndex(quads, discs, copies))
	pairs, err := index.Join(must(NewIndex(ringed)), JoinOverlap)
	equal(t, "Join", len(pairs), err, 3+2+3+3)
	items, err := index.Select(frame[T]())
	equal(t, "Select", len(items), err, 3+2+4)
	neighbours, err := index.Nearest(must(NewPolyline([]T{20, 1, 30, 1})), 1, T(math.Inf(1)))
	equal(t, "Nearest", neighbours[0], err, Neighbour[T]{2, 12})
}

func TestManyPolygons(t *testing.T) {
	manyPolygons[float64](t)
	manyPolygons[float32](t)
}

// Vertices may change between calls: they are not copied, but by Polygons.
func TestVerticesAreReadWhereTheyLie(t *testing.T) {
	xy := row[float64](1)
	one, many := must(NewPolygon(xy)), must(EvenPaths(KindPolygon, xy, 4))
	copies := must(Polygons([]Polygon[float64]{one}))
	for i := range xy {
		xy[i] += 9
	}
	out := make([]AABB[float64], 1)
	bounds, err := Bounds(one)
	equal(t, "Bounds", bounds, err, AABB[float64]{9, 9, 11, 11})
	equal(t, "BoundsMany", true, BoundsMany(many, out), true)
	equal(t, "BoundsMany", out[0], nil, bounds)
	equal(t, "BoundsMany", true, BoundsMany(copies, out), true)
	equal(t, "BoundsMany", out[0].MaxX, nil, 2)
}

func TestWrongPaths(t *testing.T) {
	_, err := NewPolygon([]float64{1, 2, 3})
	refused(t, err, ErrArgument, "3 numbers are no pairs x y")
	_, err = NewPolygon([]float64{})
	refused(t, err, ErrRings, "no vertex")
	_, err = NewPolygon([]float64{1, 2, 3, 4}, 0, 3)
	refused(t, err, ErrRings, "offset 3, where there are 2")
	_, err = NewPolyline([]float64{1, 2, 3, 4}, 0, 2, 1)
	refused(t, err, ErrRings, "offset 1 follows 2")
	_, err = NewPolyline([]float64{1, 2, 3, 4}, -1, 2)
	refused(t, err, ErrRings, "offset -1 follows 0")
	_, err = EvenPaths(KindPolygon, row[float64](2), 3)
	refused(t, err, ErrArgument, "16 numbers are no paths of 3 vertices")
	_, err = EvenPaths(KindPolygon, row[float64](2), 0)
	refused(t, err, ErrArgument, "no paths of 0")
	_, err = EvenPaths(KindRect, row[float64](2), 4)
	refused(t, err, ErrKind, "kind")
	_, err = Paths(KindCircle, row[float64](2), []int32{0, 4}, nil)
	refused(t, err, ErrKind, "kind")
	_, err = Paths(KindPolygon, row[float64](2), nil, nil)
	refused(t, err, ErrRings, "no offset")
	_, err = Paths(KindPolygon, row[float64](2), []int32{0, 9}, nil)
	refused(t, err, ErrRings, "offset 9, where there are 8")
	_, err = Paths(KindPolygon, row[float64](2), []int32{0, 4, 8}, []int32{0, 3})
	refused(t, err, ErrRings, "offset 3, where there are 2")
	_, err = Paths(KindPolygon, []float64{}, []int32{0, 0}, nil)
	refused(t, err, ErrRings, "no vertex")
	_, err = Packed(KindPolygon, row[float64](1))
	refused(t, err, ErrKind, "")

	_, err = Overlap(Polygon[float64]{}, disc(0, 1))
	refused(t, err, ErrShape, "invalid")
	_, err = Depth(frame[float64](), disc(0, 1))
	refused(t, err, ErrNotConvex, "convex")
	_, err = DE9IM(frame[float64](), must(NewPolygon([]float32{0, 0})))
	refused(t, err, ErrArgument, "float32")
	refused(t, Check(must(NewPolygon([]float64{0, 0, 4, 4, 4, 0, 0, 4}))), ErrNotSimple, "")
	xy := row[float64](3)
	xy[9] = math.NaN()
	hits := make([]bool, 3)
	quads := must(EvenPaths(KindPolygon, xy, 4))
	_, err = OverlapMany(quads, Circles([]Circle[float64]{disc(6, 9)}), hits)
	refused(t, err, ErrShape, "invalid")
	if !hits[0] || hits[1] || !hits[2] {
		t.Error(hits)
	}
	_, err = AreaMany(quads, quads, xy[21:])
	refused(t, err, ErrArgument, "out overlaps an input")

	// Offsets that a caller spoils later spoil their own shapes' answers alone.
	rings := []int32{0, 4, 8, 12}
	ringed := must(Paths(KindPolygon, row[float64](3), rings, nil))
	rings[2] = 1 << 30
	_, err = OverlapMany(ringed, Circles([]Circle[float64]{disc(6, 9)}), hits)
	refused(t, err, ErrShape, "invalid")
	if !hits[0] || hits[1] || hits[2] {
		t.Error(hits)
	}
}

func TestNoPolygonAtAll(t *testing.T) {
	none := must(Polygons([]Polygon[float64]{}))
	if n, err := OverlapMany(none, must(EvenPaths(KindPolyline, []float64{}, 3)), nil); n != 0 || err != nil {
		t.Error(n, err)
	}
	if pairs := must(must(NewIndex(none)).Join(must(NewIndex(none)), JoinOverlap)); len(pairs) != 0 {
		t.Error(pairs)
	}
}
