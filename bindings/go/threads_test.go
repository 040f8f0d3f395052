// SPDX-License-Identifier: Apache-2.0

package vesica

import (
	"bytes"
	"errors"
	"math/rand"
	"reflect"
	"testing"
)

// scattered is some rectangles, one of which may be invalid.
func scattered[T Float](seed int64, n int, valid bool) Array[T] {
	random := rand.New(rand.NewSource(seed))
	rects := make([]Rect[T], n)
	for i := range rects {
		rects[i] = Rect[T]{T(300 * random.Float64()), T(300 * random.Float64()), 1, T(random.Float64()), 0.5, 0.3}
	}
	if !valid {
		rects[n/2].HX = -1
	}
	return Rects(rects)
}

func testThreads[T Float](t *testing.T) {
	a, b := scattered[T](1, 60_000, true), scattered[T](2, 70_000, false)
	alone, other := must(NewIndex(a)), must(NewIndex(b))
	pairs := must(alone.Join(other, JoinOverlap))
	if len(pairs) < 60_000 || len(pairs) != must(alone.JoinCount(other, JoinOverlap)) {
		t.Fatalf("%d pairs", len(pairs))
	}
	for threads := 0; threads < 6; threads++ {
		first, second := must(NewIndexParallel(threads, a)), must(NewIndexParallel(threads, b))
		if !bytes.Equal(first.Bytes(), alone.Bytes()) || !bytes.Equal(second.Bytes(), other.Bytes()) {
			t.Errorf("other bytes by %d goroutines", threads)
		}
		if first.Incomplete || !second.Incomplete {
			t.Errorf("by %d goroutines the wrong index has invalid shapes", threads)
		}
		if !reflect.DeepEqual(must(first.JoinParallel(second, JoinOverlap, threads)), pairs) {
			t.Errorf("other pairs by %d goroutines", threads)
		}
	}
	if _, err := alone.JoinParallel(other, JoinQuery(99), 3); !errors.Is(err, ErrArgument) {
		t.Errorf("a query that does not exist: %v", err)
	}
	if _, err := alone.JoinParallel(other, JoinOverlap, -1); !errors.Is(err, ErrArgument) {
		t.Errorf("-1 goroutines join: %v", err)
	}
	if _, err := NewIndexParallel(-1, a); !errors.Is(err, ErrArgument) {
		t.Errorf("-1 goroutines build: %v", err)
	}
}

func TestThreads(t *testing.T) {
	t.Run("float64", testThreads[float64])
	t.Run("float32", testThreads[float32])
	empty := must(NewIndexParallel[float64](4))
	if pairs := must(empty.JoinParallel(empty, JoinOverlap, 4)); len(pairs) != 0 {
		t.Errorf("%d pairs of nothing", len(pairs))
	}
	for elements, threads := range map[int]int{0: 1, 49_999: 1} {
		if found := must(threadsFor(0, elements)); found != threads {
			t.Errorf("%d goroutines for %d elements", found, elements)
		}
	}
}
