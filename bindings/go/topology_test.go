// SPDX-License-Identifier: Apache-2.0

package vesica

import (
	"math"
	"testing"
)

func TestNearDeepAndHowTheyMeet(t *testing.T) {
	square := func(x, y float64) AABB[float64] { return AABB[float64]{x, y, x + 2, y + 2} }
	a, b, disc := square(0, 0), square(1, 1), Circle[float64]{6, 1, 1}
	boxes := AABBs([]AABB[float64]{a, b, square(5, 0)})
	if found, err := Within(a, disc, 3); found != WithinYes || err != nil {
		t.Error(found, err)
	}
	if found, err := Within(a, disc, 2.999); found != WithinNo || err != nil {
		t.Error(found, err)
	}
	ellipse := Ellipse[float64]{5, 0, 1, 0, 2, 1}
	if found, err := Within(Point[float64]{}, ellipse, 3); found != WithinYes || err != nil {
		t.Error(found, err)
	}
	if found, err := Within(Ellipse[float64]{-2, 0, 1, 0, 2, 1}, ellipse, 3); found != WithinNearly || err != nil {
		t.Error(found, err)
	}
	if _, err := Within(a, b, math.NaN()); err != ErrArgument {
		t.Error(err)
	}
	if found, err := Within(a, b, -1); found != WithinYes || err != nil {
		t.Error(found, err)
	}
	near, signed := make([]WithinResult, 3), make([]float64, 3)
	if n, err := WithinMany(boxes, AABBs([]AABB[float64]{a}), 2, near); n != 2 || err != nil || near[2] != WithinNo {
		t.Error(n, err, near)
	}
	n, err := SignedDistanceMany(boxes, AABBs([]AABB[float64]{a}), signed)
	if n != 2 || err != nil || signed[0] != -2 || signed[1] != -1 || signed[2] != 3 {
		t.Error(n, err, signed)
	}
	index := must(NewIndex(boxes))
	if pairs, err := index.JoinWithin(index, 2); len(pairs) != 2 || err != nil {
		t.Error(pairs, err)
	}
	if matrix, err := DE9IM(a, square(2, 0)); matrix != "FF2F11212" || err != nil {
		t.Error(matrix, err)
	}
	if fits, err := DE9IMMatch("FF2F11212", "FF*FT****"); !fits || err != nil {
		t.Error(fits, err)
	}
	for _, pattern := range []string{"T*", "T********\x00", "X********"} {
		if _, err := DE9IMMatch("FF2F11212", pattern); err != ErrArgument {
			t.Error(pattern, err)
		}
	}
	if region, err := Intersection(a, b); len(region) != 4 || region[0] != (Point[float64]{1, 1}) || err != nil {
		t.Error(region, err)
	}
	if _, err := Intersection(a, disc); err != ErrKind {
		t.Error(err)
	}
}

func TestSoftSuppression(t *testing.T) {
	boxes := AABBs([]AABB[float64]{{0, 0, 4, 4}, {0, 0, 4, 3}, {9, 9, 10, 10}})
	scores := []float64{1, 0.75, 0.5}
	kept, left, err := SuppressSoft(boxes, scores, SoftSuppression[float64]{Parameter: 0.5})
	if err != nil || len(kept) != 3 || kept[1] != 2 || kept[2] != 1 || left[2] != 0.1875 {
		t.Error(kept, left, err)
	}
	how := SoftSuppression[float64]{Decay: DecayGaussian, Parameter: 0.5, Labels: []int32{1, 2, 1}, Most: 2}
	if kept, left, err := SuppressSoft(boxes, scores, how); err != nil || len(kept) != 2 || left[1] != 0.75 {
		t.Error(kept, left, err)
	}
	if _, _, err := SuppressSoft(boxes, scores[:2], how); Code(err) != ErrArgument {
		t.Error(err)
	}
}

func TestCapsulesAndRoundedRectangles(t *testing.T) {
	bars := []Capsule[float64]{{0, 0, 4, 0, 1}, {0, 5, 4, 5, 1}}
	rounded, end := RoundRect[float64]{10, 0, 1, 0, 2, 1, 0.5}, Point[float64]{5, 0}
	if hit, err := Overlap(bars[0], end); !hit || err != nil {
		t.Error(hit, err)
	}
	if hit, err := Overlap(bars[0], Point[float64]{5, 5e-324}); hit || err != nil {
		t.Error(hit, err)
	}
	if found, err := Nearest(bars[0], rounded); found.Distance != 2.5 || err != nil {
		t.Error(found, err)
	}
	// The radius is the seventh number.
	anyOne := Any[float64]{KindRoundRect, [mostFields]float64{10, 0, 1, 0, 2, 1, 0.5}}
	if found, err := Nearest(bars[0], anyOne); found.Distance != 2.5 || err != nil {
		t.Error(found, err)
	}
	if box, err := Bounds(rounded); box != (AABB[float64]{7.5, -1.5, 12.5, 1.5}) || err != nil {
		t.Error(box, err)
	}
	hits := []bool{false, true}
	if n, err := OverlapMany(Capsules(bars), Points([]Point[float64]{end}), hits); n != 1 || !hits[0] || err != nil {
		t.Error(n, hits, err)
	}
	index := must(NewIndex(Capsules(bars), RoundRects([]RoundRect[float64]{rounded})))
	if items, err := index.Select(rounded); len(items) != 1 || items[0] != 2 || err != nil {
		t.Error(items, err)
	}
	if shared, err := Area(bars[0], rounded); shared != 0 || err != nil {
		t.Error(shared, err)
	}
	if holds, err := Contains(rounded, Ellipse[float64]{10, 0, 1, 0, 1, 1}); !holds || err != nil {
		t.Error(holds, err)
	}
	if found, err := BoundaryDistance(rounded, Ellipse[float64]{10, 0, 1, 0, 1, 1}); found.Distance != 0.5 || err != nil {
		t.Error(found, err)
	}
}
