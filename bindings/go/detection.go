// SPDX-License-Identifier: Apache-2.0

package vesica

// #include "declarations.h"
import "C"

import "fmt"

// RatioPair is an item of one index, an item of another, and a ratio of them.
type RatioPair[T Float] struct {
	A, B  int64
	Value T
}

// JoinRatio gives all pairs of an item of this index and one of another that overlap and whose ratio is at least
// threshold; of an index with itself the pairs a < b. A pair without a ratio is left out.
func (x *Index[T]) JoinRatio(other *Index[T], ratio Ratio, threshold T) ([]RatioPair[T], error) {
	const capacity = 1 << 14
	size, err := count(C.vesica_join_scratch())
	if err != nil {
		return nil, err
	}
	a, b, values := make([]int64, capacity), make([]int64, capacity), make([]T, capacity)
	scratch, state, pairs := aligned(size), make([]int64, 4), []RatioPair[T]{}
	for state[0] != -1 {
		found, err := count(cJoinRatio(isWide[T](), C.int32_t(ratio), float64(threshold), first(x.bytes), x.sets, x.count,
			first(other.bytes), other.sets, other.count, 0, 1, first(scratch), C.int64_t(size), first(a), first(b),
			first(values), capacity, first(state)))
		if err != nil {
			return nil, err
		}
		for i := 0; i < found; i++ {
			pairs = append(pairs, RatioPair[T]{a[i], b[i], values[i]})
		}
	}
	return pairs, nil
}

// columns are those of pairs, and how many items each side has at least.
func columns[T Float](pairs []RatioPair[T]) (a, b []int64, values []T, countA, countB int64) {
	a, b, values = make([]int64, len(pairs)), make([]int64, len(pairs)), make([]T, len(pairs))
	for i, pair := range pairs {
		a[i], b[i], values[i] = pair.A, pair.B, pair.Value
		if pair.A >= countA {
			countA = pair.A + 1
		}
		if pair.B >= countB {
			countB = pair.B + 1
		}
	}
	return a, b, values, countA, countB
}

// scratchOf is memory at a multiple of 8 bytes.
func scratchOf(size C.int64_t) ([]byte, error) {
	needed, err := count(size)
	return aligned(needed), err
}

// AssignGreedy takes the pair with the highest value whose two items are both free, until there is none: which of pairs,
// the best first. Of equal values the pair with the lower A comes first, then the lower B.
func AssignGreedy[T Float](pairs []RatioPair[T]) ([]int64, error) {
	a, b, values, countA, countB := columns(pairs)
	n := C.int64_t(len(pairs))
	scratch, err := scratchOf(C.vesica_assign_greedy_scratch(n, C.int64_t(countA), C.int64_t(countB)))
	if err != nil {
		return nil, err
	}
	chosen := make([]int64, len(pairs))
	taken, err := count(cAssignGreedy(isWide[T](), first(a), first(b), first(values), n, C.int64_t(countA),
		C.int64_t(countB), first(scratch), C.int64_t(len(scratch)), first(chosen)))
	return chosen[:taken], err
}

// Fusion is how Fuse works.
type Fusion[T Float] struct {
	Threshold T          // a box joins the cluster whose mean has a higher IoU with it than this, the highest of all
	Weights   []T        // one for each box, such as that of its model; nil, if all are 1
	Labels    []int32    // one for each box, only those of the same are fused; nil, if all are alike
	Score     FusedScore // of a cluster
}

// Fused is what boxes became. Clusters has the cluster of each box, or -1.
type Fused[T Float] struct {
	Boxes    Array[T]
	Numbers  []T // of Boxes, four or six each
	Scores   []T
	Clusters []int64
}

// Fuse is weighted boxes fusion: boxes of one object, AABBs or rectangles, become their mean by score times weight. With
// ErrShape, if a box, its score or its weight is invalid: its cluster is -1, and the others are fused without it.
func Fuse[T Float](boxes Array[T], scores []T, how Fusion[T]) (Fused[T], error) {
	n := boxes.Len()
	if len(scores) != n || (how.Weights != nil && len(how.Weights) != n) || (how.Labels != nil && len(how.Labels) != n) {
		return Fused[T]{}, fmt.Errorf("%d boxes need as many scores, and weights and labels or none, not %d, %d and %d: %w",
			n, len(scores), len(how.Weights), len(how.Labels), ErrArgument)
	}
	scratch, err := scratchOf(C.vesica_fuse_scratch(C.int64_t(n)))
	if err != nil {
		return Fused[T]{}, err
	}
	kind := Kind(boxes.view.kind)
	numbers, fused, clusters, found := make([]T, n*kind.Fields()), make([]T, n), make([]int64, n), int64(0)
	err = status(cFuse(isWide[T](), boxes.view, first(scores), first(how.Weights), first(how.Labels),
		float64(how.Threshold), C.int32_t(how.Score), first(scratch), C.int64_t(len(scratch)), first(numbers), first(fused),
		first(clusters), address(&found)))
	if err != nil && err != ErrShape {
		return Fused[T]{}, err
	}
	numbers = numbers[:int(found)*kind.Fields()]
	array, wrong := Packed(kind, numbers)
	if wrong != nil {
		return Fused[T]{}, wrong
	}
	return Fused[T]{array, numbers, fused[:found], clusters}, err
}

// Matches are rows, one for each threshold, of the outcome of each detection, and of the truth that it took, or -1.
type Matches struct {
	Outcomes []Outcome
	Taken    []int64
}

// MatchTruths says which detections hit a truth, at each of some thresholds. A pair's A is a detection and its B a truth.
// scores: of each detection; flags: one for each truth.
func MatchTruths[T Float](rule MatchRule, pairs []RatioPair[T], scores []T, flags []Truth, thresholds []T) (Matches, error) {
	a, b, values, _, _ := columns(pairs)
	n, detections, truths := C.int64_t(len(pairs)), C.int64_t(len(scores)), C.int64_t(len(flags))
	scratch, err := scratchOf(C.vesica_match_truths_scratch(n, detections, truths))
	if err != nil {
		return Matches{}, err
	}
	results := times(len(scores), len(thresholds))
	out := Matches{make([]Outcome, results), make([]int64, results)}
	err = status(cMatchTruths(isWide[T](), C.int32_t(rule), first(a), first(b), first(values), n, first(scores), detections,
		first(flags), truths, first(thresholds), C.int64_t(len(thresholds)), first(scratch), C.int64_t(len(scratch)),
		first(out.Outcomes), first(out.Taken)))
	if err != nil {
		return Matches{}, err
	}
	return out, nil
}

// AveragePrecision is that of detections of one class, or NaN without truths; truths is how many of them count.
func AveragePrecision[T Float](rule PrecisionRule, scores []T, outcomes []Outcome, truths int) (T, error) {
	if len(scores) != len(outcomes) {
		return 0, fmt.Errorf("%d scores need as many outcomes, not %d: %w", len(scores), len(outcomes), ErrArgument)
	}
	scratch, err := scratchOf(C.vesica_average_precision_scratch(C.int64_t(len(scores))))
	if err != nil {
		return 0, err
	}
	var out T
	err = status(cAveragePrecision(isWide[T](), C.int32_t(rule), first(scores), first(outcomes), C.int64_t(len(scores)),
		C.int64_t(truths), first(scratch), C.int64_t(len(scratch)), address(&out)))
	return out, err
}
