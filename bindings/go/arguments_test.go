// SPDX-License-Identifier: Apache-2.0

package vesica

import (
	"errors"
	"math"
	"math/rand"
	"os"
	"strconv"
	"strings"
	"testing"
	"time"
)

func disc(cx, r float64) Circle[float64] { return Circle[float64]{CX: cx, R: r} }

func refused(t *testing.T, err error, code Error, words string) {
	t.Helper()
	if !errors.Is(err, code) || !strings.Contains(err.Error(), words) {
		t.Errorf("%v, not %q", err, words)
	}
}

func TestInvalidShapes(t *testing.T) {
	_, err := Overlap(disc(0, -1), disc(0, 1))
	refused(t, err, ErrShape, "a shape is invalid")
	refused(t, Check(disc(0, -1)), ErrNegativeSize, "negative")
	discs := Circles([]Circle[float64]{disc(0, 1), disc(0, -1), disc(9, 1), disc(1, math.NaN())})
	hits := []bool{true, true, true, true}
	_, err = OverlapMany(discs, Circles([]Circle[float64]{disc(1, 1)}), hits)
	refused(t, err, ErrShape, "invalid")
	if !hits[0] || hits[1] || hits[2] || hits[3] {
		t.Error(hits)
	}
}

func TestArguments(t *testing.T) {
	three := Circles([]Circle[float64]{disc(0, 1), disc(0, 1), disc(0, 1)})
	_, err := OverlapMany(three, Circles([]Circle[float64]{disc(0, 1), disc(1, 1)}), make([]bool, 3))
	refused(t, err, ErrArgument, "a has 3 shapes and b 2, as many are needed, or one of either")
	_, err = OverlapMatrix(three, three, make([]bool, 8))
	refused(t, err, ErrArgument, "out has 8 elements, where 9 are needed")
	_, err = Overlap(disc(0, 1), Circle[float32]{R: 1})
	refused(t, err, ErrArgument, "one shape has float64 numbers and one float32")
	_, err = Packed(KindCircle, []float64{1, 2})
	refused(t, err, ErrArgument, "2 numbers are no records of 3")
	_, err = Packed(Kind(10), []float64{1, 2})
	refused(t, err, ErrKind, "kind")
	_, err = Overlap(Any[float64]{Kind: 9}, disc(0, 1))
	refused(t, err, ErrKind, "kind")
	_, err = Columns(KindPoint, []float64{1}, []float64{1, 2})
	refused(t, err, ErrArgument, "columns of 1 and 2 numbers")
	_, err = NearestMany(three, three, ClosestPointsColumns[float64]{})
	refused(t, err, Error(-1), "")
	numbers := make([]float64, 9)
	own := must(Packed(KindCircle, numbers))
	_, err = AreaMany(own, three, numbers[4:])
	refused(t, err, ErrArgument, "out overlaps an input")
	_, err = DepthMany(three, own, PenetrationColumns[float64]{X: numbers[6:]})
	refused(t, err, ErrArgument, "out overlaps an input")
	sharedColumns(t, three)
	_, err = NMS(three, []float64{1}, 0.5)
	refused(t, err, ErrArgument, "3 shapes need as many scores, not 1")
	_, err = IndexFromBytes(make([]byte, 640), three)
	refused(t, err, ErrIndex, "")
	index := must(NewIndex(three))
	_, err = IndexFromBytes(index.Bytes(), three, three)
	refused(t, err, ErrArgument, "an index of 3 shapes cannot be that of 6")
	_, err = index.Select(Circle[float32]{R: 1})
	refused(t, err, ErrArgument, "float32")
	_, err = index.JoinPart(index, JoinOverlap, 2, 2)
	refused(t, err, ErrArgument, "")
}

// Rows are of k however few items there are, so that k is refused if no memory has room for them.
func TestNearestOfVeryMany(t *testing.T) {
	discs := Circles([]Circle[float64]{disc(0, 1), disc(1, 1), disc(2, 1), disc(3, 1)})
	index := must(NewIndex(discs))
	for _, k := range []int{math.MaxInt, math.MaxInt/4 + 1, math.MaxInt / 4, math.MaxInt >> 13} {
		_, _, err := index.NearestOfEach(k, 1, discs)
		refused(t, err, ErrArgument, "too many for any memory")
	}
	items, distances, err := index.NearestOfEach(6, 0, discs)
	if err != nil || len(items) != 24 || items[4] != -1 || distances[4] != math.Inf(1) {
		t.Error(items, distances, err)
	}
	items, distances, err = index.NearestOfEach(6, 0, Circles([]Circle[float64]{}))
	if err != nil || len(items) != 0 || len(distances) != 0 {
		t.Error(items, distances, err)
	}
	if product := times(math.MaxInt/4+1, 4); product != math.MaxInt {
		t.Error(product)
	}
}

// Columns of one slice are results as any others, unless they share numbers.
func sharedColumns(t *testing.T, three Array[float64]) {
	t.Helper()
	const words = "overlaps an input or another output"
	all := make([]float64, 7)
	beside, within := all[3:], all[2:]
	_, err := NearestMany(three, three, ClosestPointsColumns[float64]{Distance: all, AX: all})
	refused(t, err, ErrArgument, words)
	_, err = NearestMany(three, three, ClosestPointsColumns[float64]{Distance: all, BY: within})
	refused(t, err, ErrArgument, words)
	_, err = BoundaryDistanceMany(three, three, ClosestPointsColumns[float64]{AX: within, BY: all})
	refused(t, err, ErrArgument, words)
	_, err = DepthMany(three, three, PenetrationColumns[float64]{Depth: all, Y: within})
	refused(t, err, ErrArgument, words)
	still := make([]float64, 1)
	_, err = CastMany(three, three, still, still, 1, ImpactColumns[float64]{T: all, NY: within})
	refused(t, err, ErrArgument, words)
	n, err := DepthMany(three, three, PenetrationColumns[float64]{Depth: all, Y: beside})
	if n != 3 || err != nil || all[2] != 2 || all[3]*all[3] > 1 {
		t.Error(n, err, all)
	}
}

func TestAnOlderLibraryIsRefused(t *testing.T) {
	if err := newEnough(Version); err != nil {
		t.Error(err)
	}
	words := "libvesica 99 is older than 100, which this package needs: link a newer one"
	if err := newEnough(99); err == nil || err.Error() != words {
		t.Error(err)
	}
}

func TestNothingAtAll(t *testing.T) {
	none := Circles([]Circle[float64]{})
	if n, err := OverlapMany(none, none, nil); n != 0 || err != nil {
		t.Error(n, err)
	}
	index := must(NewIndex(none))
	if len(must(index.Select(disc(0, 1)))) != 0 || len(must(index.Join(index, JoinOverlap))) != 0 {
		t.Error("something")
	}
	must(NewIndex[float64]())
}

func TestLayouts(t *testing.T) {
	records := must(Records(KindCircle, []float64{0, 0, 1, 77, 5, 0, 1, 77}, 4))
	columns := must(Columns(KindCircle, []float64{0, 5}, []float64{0, 0}, []float64{1, 1}))
	relations := make([]Relation, 2)
	if n, err := RelationMany(records, columns, relations); n != 2 || err != nil || relations[1] != RelationEqual {
		t.Error(n, err, relations)
	}
}

func TestNothingIsCopied(t *testing.T) {
	shapes, out := make([]Rect[float64], 100_000), make([]bool, 100_000)
	for i := range shapes {
		shapes[i].UX = 1
	}
	array := Rects(shapes)
	if array.view.field[0] != first(shapes) {
		t.Error("another address")
	}
	var before = testing.AllocsPerRun(3, func() { must(OverlapMany(array, array, out)) })
	if before > 2 {
		t.Errorf("%g allocations", before)
	}
}

// Whatever is passed, there is an answer or an error. Every question is answered now and then.
func TestAnyArguments(t *testing.T) {
	const questions = 24
	calls, seed := 5000, time.Now().UnixNano()
	if text := os.Getenv("VESICA_CALLS"); text != "" {
		calls = must(strconv.Atoi(text))
	}
	t.Log("seed", seed)
	draw := rand.New(rand.NewSource(seed)).Intn
	values := []float64{0, math.Copysign(0, -1), 1, -1, 0.5, math.NaN(), math.Inf(1), 5e-324, 1.7e308, 1e-200}
	special := func() float64 { return values[draw(len(values))] }
	kind := func() Kind {
		if draw(20) == 0 {
			return Kind(draw(10) - 1)
		}
		// Capsules and rounded rectangles come seldom: many questions are not for them.
		if draw(4) == 0 {
			return Kind(draw(8))
		}
		return Kind(draw(6))
	}
	numbers := func(kind Kind) []float64 {
		count := kind.Fields() * draw(6)
		if draw(4) == 0 {
			count = draw(40)
		}
		out := make([]float64, count)
		for i := range out {
			if out[i] = float64(draw(9)); draw(40) == 0 {
				out[i] = special()
			}
		}
		return out
	}
	// Paths of few vertices, with offsets that often are none.
	pathOf := func(kind Kind) (Array[float64], Shape, error) {
		xy := make([]float64, 2*draw(12)+draw(20)/19)
		for i := range xy {
			if xy[i] = float64(draw(9)); draw(40) == 0 {
				xy[i] = special()
			}
		}
		offsets := func() []int32 {
			out := make([]int32, draw(4))
			for i := range out {
				out[i] = int32(3*i + draw(9)/8 - draw(9)/8)
			}
			return out
		}
		rings := offsets()
		shape, err := NewPolygon(xy, rings...)
		if draw(2) == 0 {
			array, err := EvenPaths(kind, xy, draw(5))
			return array, shape, err
		}
		polygons := offsets()
		if draw(2) == 0 {
			polygons = nil
		}
		array, failed := Paths(kind, xy, rings, polygons)
		if err == nil {
			err = failed
		}
		return array, shape, err
	}
	single := func(kind Kind, numbers []float64) Any[float64] {
		shape := Any[float64]{Kind: kind}
		copy(shape.Numbers[:], numbers)
		return shape
	}
	turn := func() Turn[float64] { return Turn[float64]{float64(draw(9)) - 4, float64(draw(5)) - 2, special()} }
	var answered [questions]int
	for i := 0; i < calls; i++ {
		kindA, kindB := kind(), kind()
		first, second := numbers(kindA), numbers(kindB)
		a, errA := Records(kindA, first, kindA.Fields()+draw(3)/2)
		b, errB := Packed(kindB, second)
		if errA != nil || errB != nil {
			continue
		}
		var one, two Shape = single(kindA, first), single(kindB, second)
		if draw(6) == 0 {
			if array, shape, failed := pathOf(KindPolygon + Kind(draw(2))); failed == nil {
				a, one = array, shape
			}
		}
		bools, out, scores := make([]bool, draw(100)), make([]float64, draw(100)), make([]float64, a.Len()+draw(3)/2)
		motion := Motion{special(), float64(draw(5)) - 2, special()}
		question := draw(questions)
		var err error
		switch question {
		case 0:
			_, err = OverlapMany(a, b, bools)
		case 1:
			_, err = ContainsMatrix(a, b, bools)
		case 2:
			_, err = AreaMany(a, b, out)
		case 3:
			_, err = IoUMatrix(a, b, out)
		case 4:
			_, err = DepthMany(a, b, PenetrationColumns[float64]{X: out})
		case 5:
			_, err = NMS(a, scores, special())
		case 6:
			index, failed := NewIndex(a, b)
			if err = failed; err == nil {
				_, err = index.Join(index, JoinQuery(draw(6)-1))
			}
		case 7:
			index, failed := NewIndex(a)
			if err = failed; err == nil {
				_, _, err = index.NearestOfEach(draw(5)-1, special(), b, a)
			}
		case 8:
			_, err = RatioMany(Ratio(draw(10)-1), a, b, out)
		case 9:
			_, err = Suppress(a, scores, Suppression[float64]{Threshold: special(), Most: draw(9) - 2})
		case 10:
			err = BoxesFromShapes(a, Angle(draw(10)-1), make([][5]float64, draw(9)))
		case 11:
			boxes, stride := second[:len(second)/5*5], 5
			if draw(4) == 0 {
				boxes, stride = second, draw(9)-1
			}
			err = RectsFromBoxes(boxes, stride, Angle(draw(10)-1), make([]Rect[float64], draw(9)))
		case 12:
			_, err = CastMany(a, b, scores, scores, motion.End, ImpactColumns[float64]{Y: out})
		case 13:
			_, _, err = CastFirst(one, b, motion)
		case 14:
			_, err = WithinMatrix(a, b, special(), make([]WithinResult, draw(100)))
		case 15:
			_, err = Intersection(one, two)
		case 16:
			how := SoftSuppression[float64]{Decay: Decay(draw(2)), Parameter: 0.5, Most: draw(9) - 1}
			if draw(2) == 0 {
				how.Decay, how.Parameter = Decay(draw(4)-1), special()
			}
			_, _, err = SuppressSoft(a, scores, how)
		case 17:
			_, err = SignedDistanceMany(a, b, out)
		case 18:
			matrix, failed := DE9IM(one, two)
			if err = failed; err == nil {
				_, err = DE9IMMatch(matrix, []string{"T*F**FFF*", "0123T*F**", "T*", "", "\x00"}[draw(5)])
			}
		case 19:
			_, err = Within(one, two, special())
		case 20:
			_, _, err = Cast(one, two, motion)
		case 21:
			_, _, _, err = ImpactTime(one, turn(), two, turn(), special())
		case 22:
			_, err = SignedDistance(one, two)
		default:
			_, err = IndexFromBytes(make([]byte, draw(900)), a)
		}
		if err == nil {
			answered[question]++
		}
	}
	t.Log("answered:", answered, "of", calls)
	// Bytes that are 0 are no index.
	for question, count := range answered[:questions-1] {
		if count == 0 && calls >= 5000 {
			t.Errorf("question %d of %v: nothing was answered", question, answered)
		}
	}
}
