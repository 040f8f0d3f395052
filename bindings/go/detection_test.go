// SPDX-License-Identifier: Apache-2.0

package vesica

import (
	"errors"
	"math"
	"reflect"
	"testing"
)

func testDetection[T Float](t *testing.T) {
	a, b := scattered[T](3, 900, true), scattered[T](4, 800, true)
	matrix := make([]T, a.Len()*b.Len())
	must(RatioMatrix(RatioOverSmaller, a, b, matrix))
	pairs := must(must(NewIndex(a)).JoinRatio(must(NewIndex(b)), RatioOverSmaller, 0.25))
	wanted := 0
	for _, value := range matrix {
		if value >= 0.25 {
			wanted++
		}
	}
	if wanted < 3 || len(pairs) != wanted {
		t.Errorf("%d pairs, not %d", len(pairs), wanted)
	}
	for _, pair := range pairs {
		if matrix[int(pair.A)*b.Len()+int(pair.B)] != pair.Value {
			t.Errorf("another ratio: %v", pair)
		}
	}

	// The best pair shares an item with the two that follow; items may be told in any order.
	given := []RatioPair[T]{{0, 0, 0.5}, {5, 0, 0.75}, {0, 1, 0.25}, {5, 1, 0.625}, {2, 2, T(math.NaN())}}
	if chosen := must(AssignGreedy(given)); !reflect.DeepEqual(chosen, []int64{1, 2}) {
		t.Errorf("chosen %v", chosen)
	}
	if _, err := AssignGreedy([]RatioPair[T]{{-1, 0, 1}}); !errors.Is(err, ErrArgument) {
		t.Errorf("item -1: %v", err)
	}
	if chosen := must(AssignGreedy([]RatioPair[T]{})); len(chosen) != 0 {
		t.Errorf("chosen of nothing: %v", chosen)
	}

	boxes := AABBs([]AABB[T]{{0, 0, 4, 4}, {0.5, 0, 4.5, 4}, {20, 0, 24, 4}})
	scores := []T{0.75, 0.25, 0.5}
	fused := must(Fuse(boxes, scores, Fusion[T]{Threshold: 0.55}))
	if !reflect.DeepEqual(fused.Numbers, []T{0.125, 0, 4.125, 4, 20, 0, 24, 4}) || fused.Boxes.Len() != 2 {
		t.Errorf("fused %v", fused.Numbers)
	}
	if !reflect.DeepEqual(fused.Scores, []T{0.5, 0.5}) || !reflect.DeepEqual(fused.Clusters, []int64{0, 0, 1}) {
		t.Errorf("fused %v, %v", fused.Scores, fused.Clusters)
	}
	if best := must(Fuse(boxes, scores, Fusion[T]{Threshold: 0.55, Score: FusedMax})); best.Scores[0] != 0.75 {
		t.Errorf("the highest score: %v", best.Scores)
	}
	weighed := Fusion[T]{Threshold: 0.5, Weights: []T{3, 1, 1}}
	if mean := must(Fuse(boxes, []T{0.5, 0.5, 0.5}, weighed)); mean.Numbers[0] != 0.125 {
		t.Errorf("weights: %v", mean.Numbers)
	}
	labelled := Fusion[T]{Threshold: 0.5, Labels: []int32{1, 2, 1}}
	if apart := must(Fuse(boxes, scores, labelled)); !reflect.DeepEqual(apart.Clusters, []int64{0, 2, 1}) {
		t.Errorf("labels: %v", apart.Clusters)
	}
	some, err := Fuse(boxes, []T{0.75, -1, 0.5}, Fusion[T]{Threshold: 0.55})
	if !errors.Is(err, ErrShape) || !reflect.DeepEqual(some.Clusters, []int64{0, -1, 1}) {
		t.Errorf("a negative score: %v, %v", some.Clusters, err)
	}
	if _, err := Fuse(boxes, scores[:2], Fusion[T]{}); !errors.Is(err, ErrArgument) {
		t.Errorf("too few scores: %v", err)
	}

	// Detection 1 is better than 0 and takes truth 0; 2 takes a crowd.
	hits := []RatioPair[T]{{0, 0, 0.875}, {1, 0, 0.75}, {2, 1, 0.875}}
	found := must(MatchTruths(MatchCoco, hits, []T{0.5, 1, 0.25}, []Truth{TruthCounts, TruthCrowd}, []T{0.5, 0.8}))
	if !reflect.DeepEqual(found.Outcomes, []Outcome{OutcomeMiss, OutcomeHit, OutcomeIgnored, OutcomeHit, OutcomeMiss,
		OutcomeIgnored}) || !reflect.DeepEqual(found.Taken, []int64{-1, 0, 1, 0, -1, 1}) {
		t.Errorf("matched %v", found)
	}
	if _, err := MatchTruths(MatchRule(9), hits, []T{1, 1, 1}, make([]Truth, 2), []T{0.5}); !errors.Is(err, ErrArgument) {
		t.Errorf("no such rule: %v", err)
	}
	// One hit of two truths, after a miss: the best precision is 1/2 up to recall 1/2, then 0.
	outcomes := []Outcome{OutcomeHit, OutcomeMiss, OutcomeIgnored}
	if ap := must(AveragePrecision(PrecisionVoc2010, []T{0.5, 1, 2}, outcomes, 2)); ap != 0.25 {
		t.Errorf("average precision %v", ap)
	}
	if ap := must(AveragePrecision(PrecisionCoco, []T{}, []Outcome{}, 0)); ap == ap {
		t.Errorf("average precision of nothing: %v", ap)
	}
	if _, err := AveragePrecision(PrecisionCoco, []T{1}, []Outcome{}, 1); !errors.Is(err, ErrArgument) {
		t.Errorf("too few outcomes: %v", err)
	}
}

func TestDetection(t *testing.T) {
	t.Run("float64", testDetection[float64])
	t.Run("float32", testDetection[float32])
}
