// SPDX-License-Identifier: Apache-2.0

package vesica

import (
	"math"
	"testing"
)

func TestCasts(t *testing.T) {
	disc, wall := Circle[float64]{R: 1}, AABB[float64]{10, -5, 12, 5}
	met := Impact[float64]{3, 10, 0, -1, 0}
	forever := math.Inf(1)
	if found, impact, err := Cast(wall, disc, Motion{3, 0, forever}); found != CastHit || impact != met || err != nil {
		t.Error(found, impact, err)
	}
	if found, impact, err := Cast(wall, disc, Motion{3, 0, 2.5}); found != CastMiss || impact.T != forever || err != nil {
		t.Error(found, impact, err)
	}
	if found, _, err := Cast(wall, wall, Motion{3, 0, 2.5}); found != CastStart || err != nil {
		t.Error(found, err)
	}
	walls := AABBs([]AABB[float64]{{20, -5, 22, 5}, wall, wall})
	if item, impact, err := CastFirst(disc, walls, Motion{3, 0, 9}); item != 1 || impact != met || err != nil {
		t.Error(item, impact, err)
	}
	if item, _, err := CastFirst(disc, walls, Motion{-3, 0, 9}); item != -1 || err != nil {
		t.Error(item, err)
	}
	index := must(NewIndex(walls))
	if items, err := index.Cast(disc, Motion{1, 0, 10}); len(items) != 2 || err != nil {
		t.Error(items, err)
	}
	if item, impact, err := index.CastFirst(disc, Motion{3, 0, 9}); item != 1 || impact != met || err != nil {
		t.Error(item, impact, err)
	}
	times := make([]float64, 3)
	_, err := CastMany(walls, Circles([]Circle[float64]{disc}), []float64{2, -1, math.NaN()}, make([]float64, 3), 99,
		ImpactColumns[float64]{T: times})
	if err != ErrArgument || times[0] != 9.5 || times[1] != forever || !math.IsNaN(times[2]) {
		t.Error(times, err)
	}
	// Times that are written over velocities are none; beside them they are.
	all, one := []float64{2, 2, 2, 0, 0, 0, 0}, Circles([]Circle[float64]{disc})
	for _, out := range []ImpactColumns[float64]{{T: all[1:]}, {T: times, NY: all[2:]}} {
		_, err = CastMany(walls, one, all[:3], make([]float64, 3), 99, out)
		refused(t, err, ErrArgument, "out overlaps an input")
		_, err = CastMany(walls, one, make([]float64, 3), all[:3], 99, out)
		refused(t, err, ErrArgument, "out overlaps an input")
	}
	_, err = CastMany(walls, one, all[:3], make([]float64, 3), 99, ImpactColumns[float64]{T: all[3:]})
	if err != nil || all[3] != 9.5 || all[4] != 4.5 || all[5] != 4.5 {
		t.Error(all, err)
	}
	box := must(SweepBounds(disc, Motion{3, 0, 2}))
	if !must(Contains(box, AABB[float64]{-1, -1, 7, 1})) {
		t.Error(box)
	}
}

func TestShapesThatTurn(t *testing.T) {
	bar, speck, wall := Segment[float64]{-1, 0, 1, 0}, Circle[float64]{0, 0.5, 1e-8}, AABB[float64]{10, -5, 12, 5}
	still, by := Turn[float64]{}, func(angle float64) Turn[float64] { return Turn[float64]{Angle: angle} }
	found, impact, gap, err := ImpactTime(bar, by(math.Pi), speck, still, 1e-7)
	if found != CastHit || impact.T > 0.5 || impact.T < 0.499999 || gap > 1e-7 || err != nil {
		t.Error(found, impact, gap, err)
	}
	found, impact, gap, err = ImpactTime(bar, by(1.57), speck, still, 1e-7)
	if found != CastMiss || impact.T != math.Inf(1) || !math.IsNaN(gap) || err != nil {
		t.Error(found, impact, gap, err)
	}
	// Without area contact is never proved.
	if found, _, _, err = ImpactTime(bar, by(3), Point[float64]{0, 0.5}, still, 1e-7); found != CastNear || err != nil {
		t.Error(found, err)
	}
	found, impact, gap, err = ImpactTime(wall, by(1), wall, still, 1)
	if found != CastStart || impact.T != 0 || gap != 0 || err != nil {
		t.Error(found, impact, gap, err)
	}
	if _, _, _, err = ImpactTime(wall, by(2e6), speck, still, 1); err != ErrArgument {
		t.Error(err)
	}
	if _, _, _, err = ImpactTime(wall, still, speck, still, 0); err != ErrArgument {
		t.Error(err)
	}
	if _, _, _, err = ImpactTime(wall, still, Circle[float32]{R: 1}, still, 1); Code(err) != ErrArgument {
		t.Error(err)
	}
}

func TestBoxes(t *testing.T) {
	rects := make([]Rect[float64], 2)
	rows := []float64{1, 2, 6, 4, 90, 77, 1, 2, -6, 4, 90, 77}
	err := RectsFromBoxes(rows, 6, AngleDegrees, rects)
	if want := (Rect[float64]{1, 2, 0, 1, 3, 2}); err != ErrShape || rects[0] != want || !math.IsNaN(rects[1].CX) {
		t.Error(rects, err)
	}
	back := make([][5]float64, 1)
	err = BoxesFromShapes(Rects(rects[:1]), AngleQuarters|AngleReversed, back)
	if back[0] != [5]float64{1, 2, 6, 4, -1} || err != nil {
		t.Error(back, err)
	}
	for _, err := range []error{
		BoxesFromShapes(Rects(rects), AngleQuarters, back),
		BoxesFromShapes(Rects(rects[:1]), Angle(3), back),
		RectsFromBoxes(rows, 5, AngleDegrees, rects),
		RectsFromBoxes(rows, 4, AngleDegrees, rects),
	} {
		if Code(err) != ErrArgument {
			t.Error(err)
		}
	}
}

func TestRatiosAndSuppression(t *testing.T) {
	small, large := AABB[float64]{0, 0, 2, 2}, AABB[float64]{0, 0, 4, 4}
	if ratio, err := RatioOf(RatioOverSecond, small, large); ratio != 0.25 || err != nil {
		t.Error(ratio, err)
	}
	if _, err := RatioOf(RatioOverFirst, Point[float64]{}, large); err != ErrArgument {
		t.Error(err)
	}
	both, score := AABBs([]AABB[float64]{small, large}), 1.5
	bySmaller := Suppression[float64]{Threshold: 0.5, Ratio: RatioOverSmaller}
	byLabels := bySmaller
	byLabels.Labels = []int32{1, 2}
	for i, how := range []Suppression[float64]{{Threshold: 0.5}, bySmaller, byLabels, {Most: 1}, {LeastScore: &score}} {
		if kept, err := Suppress(both, []float64{1, 2}, how); len(kept) != []int{2, 1, 2, 1, 1}[i] || err != nil {
			t.Error(i, kept, err)
		}
	}
	byLabels.Labels = []int32{1}
	if _, err := Suppress(both, []float64{1, 2}, byLabels); Code(err) != ErrArgument {
		t.Error(err)
	}
}
