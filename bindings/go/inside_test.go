// SPDX-License-Identifier: Apache-2.0

package vesica

import "testing"

// world is an object that holds a pointer besides the numbers that are passed to C.
type world[T Float] struct {
	name                         *string
	discs                        [3]Circle[T]
	numbers                      [9]T
	bools                        [3]bool
	relations                    [3]Relation
	within                       [3]WithinResult
	out                          [5][3]T
	rows                         [15]T
	rects                        [3]Rect[T]
	ellipses                     [3]Ellipse[T]
	boxes                        [3][5]T
	corners                      [3][8]T
	bounds                       [3]AABB[T]
	scores, velocities, standing [3]T
	labels                       [3]int32
	bytes                        [2048]byte
	offsets                      [4]int32
}

func newWorld[T Float]() *world[T] {
	w := &world[T]{name: new(string), labels: [3]int32{1, 2, 3}, numbers: [9]T{0, 0, 1, 5, 0, 1, 9, 0, 1},
		offsets: [4]int32{0, 1, 2, 3}}
	for i := range w.discs {
		w.discs[i] = Circle[T]{T(4 * i), 0, 1}
		copy(w.rows[5*i:], []T{T(4 * i), 0, 2, 1, 0})
		w.scores[i], w.velocities[i] = T(i), 1
	}
	return w
}

// inside calls everything that takes a slice, with slices of an object that holds a pointer to Go memory.
func inside[T Float](t *testing.T) {
	t.Helper()
	w := newWorld[T]()
	one, discs := Circle[T]{R: 1}, Circles(w.discs[:])
	still := Circles([]Circle[T]{one})
	done := func(name string) func(int, error) {
		return func(_ int, err error) {
			t.Helper()
			if err != nil {
				t.Error(name, err)
			}
		}
	}
	failed := func(name string, err error) { t.Helper(); done(name)(0, err) }
	packed := must(Packed(KindCircle, w.numbers[:]))
	columns := must(Columns(KindPoint, w.scores[:], w.standing[:]))
	if n := must(OverlapMany(discs, still, w.bools[:])); n != 1 || !w.bools[0] || w.bools[1] {
		t.Error(n, w.bools)
	}
	done("packed")(OverlapMany(packed, still, w.bools[:]))
	done("columns")(OverlapMany(columns, still, w.bools[:]))
	paths := must(Paths(KindPolygon, w.rows[:6], w.offsets[:], w.offsets[:]))
	done("paths")(OverlapMany(paths, still, w.bools[:]))
	_, err := Overlap(must(NewPolyline(w.rows[:6], w.offsets[:]...)), one)
	failed("NewPolyline", err)
	done("even paths")(OverlapMany(must(EvenPaths(KindPolygon, w.rows[:12], 2)), still, w.bools[:]))
	done("RelationMany")(RelationMany(discs, still, w.relations[:]))
	done("ContainsMany")(ContainsMany(discs, still, w.bools[:]))
	done("WithinMany")(WithinMany(discs, still, 1, w.within[:]))
	done("AreaMany")(AreaMany(discs, still, w.out[0][:]))
	done("RatioMany")(RatioMany(RatioOverUnion, discs, still, w.out[0][:]))
	closest := ClosestPointsColumns[T]{w.out[0][:], w.out[1][:], w.out[2][:], w.out[3][:], w.out[4][:]}
	done("NearestMany")(NearestMany(discs, still, closest))
	done("BoundaryDistanceMany")(BoundaryDistanceMany(discs, still, closest))
	done("DepthMany")(DepthMany(discs, still, PenetrationColumns[T]{w.out[0][:], w.out[1][:], w.out[2][:]}))
	done("SignedDistanceMany")(SignedDistanceMany(discs, still, w.out[0][:]))
	done("OverlapMatrix")(OverlapMatrix(discs, still, w.bools[:]))
	done("WithinMatrix")(WithinMatrix(discs, still, 1, w.within[:]))
	done("NearestMatrix")(NearestMatrix(discs, still, w.out[0][:]))
	done("CastMany")(CastMany(discs, still, w.velocities[:], w.standing[:], 9,
		ImpactColumns[T]{w.out[0][:], w.out[1][:], w.out[2][:], w.out[3][:], w.out[4][:]}))
	failed("RectsFromBoxes", RectsFromBoxes(w.rows[:], 5, AngleRadians, w.rects[:]))
	failed("EllipsesFromBoxes", EllipsesFromBoxes(w.rows[:], 5, AngleRadians, w.ellipses[:]))
	failed("BoxesFromShapes", BoxesFromShapes(Rects(w.rects[:]), AngleRadians, w.boxes[:]))
	failed("CornersOf", CornersOf(Ellipses(w.ellipses[:]), w.corners[:]))
	failed("BoundsMany", BoundsMany(discs, w.bounds[:]))
	if w.rects[1].CX != 4 || w.boxes[2] != [5]T{8, 0, 2, 1, 0} || w.bounds[1].MaxX != 5 {
		t.Error(w.rects, w.boxes, w.bounds)
	}
	_, err = OverlapSelect(one, discs)
	failed("OverlapSelect", err)
	_, _, err = CastFirst(one, discs, Motion{VX: 1, End: 9})
	failed("CastFirst", err)
	_, err = NMS(discs, w.scores[:], 0.5)
	failed("NMS", err)
	_, err = Suppress(discs, w.scores[:], Suppression[T]{Threshold: 0.5, Labels: w.labels[:]})
	failed("Suppress", err)
	_, _, err = SuppressSoft(discs, w.scores[:], SoftSuppression[T]{Parameter: 0.5, Labels: w.labels[:]})
	failed("SuppressSoft", err)
	ofIndexInside(t, w)
}

func ofIndexInside[T Float](t *testing.T, w *world[T]) {
	t.Helper()
	one, discs := Circle[T]{R: 1}, Circles(w.discs[:])
	index := must(NewIndex(discs, discs))
	size := copy(w.bytes[:], index.Bytes())
	if size != len(index.Bytes()) {
		t.Fatal(len(index.Bytes()))
	}
	saved := must(IndexFromBytes(w.bytes[:size], discs, discs))
	items, err := saved.Select(one)
	if err != nil || len(items) != 2 {
		t.Error(items, err)
	}
	if pairs, err := index.Join(saved, JoinOverlap); err != nil || len(pairs) != 12 {
		t.Error(pairs, err)
	}
	if pairs, err := index.JoinWithin(saved, 1); err != nil || len(pairs) != 12 {
		t.Error(pairs, err)
	}
	if found, _, err := index.NearestOfEach(2, 1, discs); err != nil || len(found) != 6 {
		t.Error(found, err)
	}
	if found, err := index.Nearest(one, 2, 1); err != nil || len(found) != 2 {
		t.Error(found, err)
	}
	if items, err := index.Cast(one, Motion{VX: 1, End: 9}); err != nil || len(items) != 6 {
		t.Error(items, err)
	}
	if item, _, err := index.CastFirst(one, Motion{VX: 1, End: 9}); err != nil || item != 0 {
		t.Error(item, err)
	}
}

func TestSlicesInsideObjectsWithPointers(t *testing.T) {
	inside[float64](t)
	inside[float32](t)
}
