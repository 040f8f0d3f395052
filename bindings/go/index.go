// SPDX-License-Identifier: Apache-2.0

package vesica

// #include "declarations.h"
import "C"

import (
	"fmt"
	"math"
	"unsafe"
)

// Index is over sets of shapes laid end to end: item i is shape i of the first set, and the next set's items follow.
//
// It holds bounds: the shapes must stay as they were. Any number of goroutines may ask it.
type Index[T Float] struct {
	sets  C.vesica_go_sets
	count C.int32_t // of sets
	items int
	bytes []byte

	// Incomplete tells that invalid shapes were left out. Bytes that were saved do not tell.
	Incomplete bool
}

const alignment = 64

// Pair is an item of one index and an item of another.
type Pair struct{ A, B int64 }

// Neighbour is an item and its distance.
type Neighbour[T Float] struct {
	Item     int64
	Distance T
}

// aligned is memory at an address that the library takes.
func aligned(size int) []byte {
	memory := make([]byte, size+alignment)
	start := -uintptr(unsafe.Pointer(&memory[0])) % alignment
	return memory[start : start+uintptr(size)]
}

func setsOf[T Float](arrays []Array[T]) (sets C.vesica_go_sets, items int, err error) {
	if len(arrays) > len(sets.set) {
		return sets, 0, fmt.Errorf("%d sets, an index has at most %d: %w", len(arrays), len(sets.set), ErrArgument)
	}
	for i, array := range arrays {
		sets.set[i] = array.view
		items += array.Len()
	}
	return sets, items, nil
}

func newIndex[T Float](arrays []Array[T]) (*Index[T], error) {
	sets, items, err := setsOf(arrays)
	return &Index[T]{sets: sets, count: C.int32_t(len(arrays)), items: items}, err
}

// NewIndex leaves invalid shapes out; Incomplete tells.
func NewIndex[T Float](arrays ...Array[T]) (*Index[T], error) { return NewIndexParallel(1, arrays...) }

// NewIndexParallel is NewIndex by so many goroutines; 0 stands for all processors, as far as that pays. The bytes are
// the same.
func NewIndexParallel[T Float](threads int, arrays ...Array[T]) (*Index[T], error) {
	index, err := newIndex(arrays)
	if err != nil {
		return nil, err
	}
	if threads, err = threadsFor(threads, index.items); err != nil {
		return nil, err
	}
	size, err := count(C.vesica_index_size(C.int64_t(index.items)))
	if err != nil {
		return nil, err
	}
	scratch, err := count(C.vesica_index_scratch(C.int64_t(index.items)))
	if err != nil {
		return nil, err
	}
	memory, room := aligned(size), aligned(scratch)
	used, err := count(index.build(threads, memory, room))
	if index.Incomplete = err == ErrShape; index.Incomplete {
		used, err = count(C.vesica_index_bytes(unsafe.Pointer(first(memory))))
	}
	if err != nil {
		return nil, err
	}
	index.bytes = aligned(used)
	copy(index.bytes, memory)
	return index, nil
}

// build gives what the library does.
func (x *Index[T]) build(threads int, memory, scratch []byte) C.int64_t {
	size, room := C.int64_t(len(memory)), C.int64_t(len(scratch))
	if threads == 1 {
		return cIndexBuild(isWide[T](), x.sets, x.count, first(memory), size, first(scratch), room)
	}
	code := C.int64_t(0)
	for step := 0; step <= 4 && code >= 0; step++ {
		parts := threads
		if step == 0 || step == 4 {
			parts = 1
		}
		codes := make([]C.int64_t, parts)
		eachPart(threads, parts, func(part int) {
			codes[part] = cIndexStep(isWide[T](), C.int32_t(step), C.int64_t(part), C.int64_t(parts), x.sets, x.count,
				first(memory), size, first(scratch), room)
		})
		for _, code = range codes {
			if code < 0 {
				break
			}
		}
	}
	return code
}

// IndexFromBytes is the index whose bytes were saved, over the same shapes. They are checked and copied.
func IndexFromBytes[T Float](bytes []byte, arrays ...Array[T]) (*Index[T], error) {
	index, err := newIndex(arrays)
	if err != nil {
		return nil, err
	}
	if len(bytes) == 0 {
		return nil, ErrIndex
	}
	index.bytes = aligned(len(bytes))
	copy(index.bytes, bytes)
	if err := status(C.vesica_index_check(unsafe.Pointer(first(index.bytes)), C.int64_t(len(bytes)))); err != nil {
		return nil, err
	}
	if items := int(C.vesica_index_count(unsafe.Pointer(first(index.bytes)))); items != index.items {
		return nil, fmt.Errorf("an index of %d shapes cannot be that of %d: %w", items, index.items, ErrArgument)
	}
	return index, nil
}

// Bytes are to be saved. They must not be changed.
func (x *Index[T]) Bytes() []byte { return x.bytes }

// Len is how many items there are, invalid shapes included.
func (x *Index[T]) Len() int { return x.items }

// Bounds is a box around all valid shapes, a little larger than the smallest one.
func (x *Index[T]) Bounds() (AABB[float64], error) {
	var out C.vesica_aabb_f64
	err := status(C.vesica_index_bounds(unsafe.Pointer(first(x.bytes)), &out))
	return AABB[float64]{float64(out.min_x), float64(out.min_y), float64(out.max_x), float64(out.max_y)}, err
}

// Order has the items in spatial order: arrays that are laid so are joined quicker.
func (x *Index[T]) Order() ([]int64, error) {
	out := make([]int64, x.items)
	valid, err := count(C.vesica_index_order(unsafe.Pointer(first(x.bytes)), (*C.int64_t)(unsafe.Pointer(first(out))),
		C.int64_t(len(out))))
	return out[:valid], err
}

// Select gives the items that one shape overlaps, in the index's order.
func (x *Index[T]) Select(one Shape) ([]int64, error) {
	return x.all(one, func(single Array[T], out []int64, state *C.char) C.int64_t {
		return cIndexSelect(isWide[T](), first(x.bytes), x.sets, x.count, single.view, first(out), C.int64_t(len(out)),
			state)
	})
}

// all has the items of a question about one shape, which is put twice: how many, and which.
func (x *Index[T]) all(one Shape, ask func(single Array[T], out []int64, state *C.char) C.int64_t) ([]int64, error) {
	single, err := arrayOfOne[T](one)
	if err != nil {
		return nil, err
	}
	found, err := count(ask(single, nil, nil))
	if err != nil || found == 0 {
		return []int64{}, err
	}
	out, state := make([]int64, found), [4]int64{}
	_, err = count(ask(single, out, address(&state)))
	return out, err
}

// Nearest gives the k items nearest to one shape, at most within away; infinity asks for any.
func (x *Index[T]) Nearest(one Shape, k int, within T) ([]Neighbour[T], error) {
	single, err := arrayOfOne[T](one)
	if err != nil {
		return nil, err
	}
	if k < 0 {
		return nil, fmt.Errorf("k is %d, not a count: %w", k, ErrArgument)
	}
	if k > x.items {
		k = x.items
	}
	items, distances := make([]int64, k), make([]T, k)
	found, err := count(cIndexNearest(isWide[T](), first(x.bytes), x.sets, x.count, single.view, C.int64_t(k),
		float64(within), first(items), first(distances)))
	if err != nil {
		return nil, err
	}
	out := make([]Neighbour[T], 0, k)
	for i := 0; i < found && i < k; i++ {
		out = append(out, Neighbour[T]{items[i], distances[i]})
	}
	return out, nil
}

// NearestOfEach gives rows of k: the items nearest to each shape of some arrays, and their distances, filled up by -1
// at distance infinity. With ErrShape, if a shape is invalid: its row holds -1, and all others are right.
func (x *Index[T]) NearestOfEach(k int, within T, arrays ...Array[T]) ([]int64, []T, error) {
	sets, items, err := setsOf(arrays)
	if err != nil {
		return nil, nil, err
	}
	if k < 1 {
		return nil, nil, fmt.Errorf("k is %d, not 1 or more: %w", k, ErrArgument)
	}
	// More numbers than that have no room in any address space: make would panic.
	const most = math.MaxInt / 8 & (1<<44 - 1)
	needed := times(items, k)
	if needed > most {
		return nil, nil, fmt.Errorf("%d rows of %d items are too many for any memory: %w", items, k, ErrArgument)
	}
	out, distances := make([]int64, needed), make([]T, needed)
	_, err = count(cJoinNearest(isWide[T](), sets, C.int32_t(len(arrays)), first(x.bytes), x.sets, x.count, C.int64_t(k),
		float64(within), 0, 1, first(out), first(distances)))
	return out, distances, err
}

// Join gives all pairs of an item of this index and one of another; of an index with itself the pairs a < b.
func (x *Index[T]) Join(other *Index[T], query JoinQuery) ([]Pair, error) {
	return x.JoinPart(other, query, 0, 1)
}

// JoinPart is one of parts parts of a join, which goroutines may ask at the same time.
func (x *Index[T]) JoinPart(other *Index[T], query JoinQuery, part, parts int) ([]Pair, error) {
	const capacity = 1 << 14
	a, b, state := make([]int64, capacity), make([]int64, capacity), make([]int64, 4)
	pairs := []Pair{}
	for state[0] != -1 {
		found, err := x.join(other, query, part, parts, a, b, state)
		if err != nil {
			return nil, err
		}
		for i := 0; i < found; i++ {
			pairs = append(pairs, Pair{a[i], b[i]})
		}
	}
	return pairs, nil
}

// JoinParallel is Join by so many goroutines; 0 stands for all processors, as far as that pays. The pairs are the same,
// in the same order.
func (x *Index[T]) JoinParallel(other *Index[T], query JoinQuery, threads int) ([]Pair, error) {
	threads, err := threadsFor(threads, x.items+other.items)
	if err != nil {
		return nil, err
	}
	parts := partsOfJoin(threads)
	pairs, errs := make([][]Pair, parts), make([]error, parts)
	eachPart(threads, parts, func(part int) { pairs[part], errs[part] = x.JoinPart(other, query, part, parts) })
	all := pairs[0]
	for part, err := range errs {
		if err != nil {
			return nil, err
		}
		if part > 0 {
			all = append(all, pairs[part]...)
		}
	}
	return all, nil
}

// JoinCount is how many pairs Join gives.
func (x *Index[T]) JoinCount(other *Index[T], query JoinQuery) (int, error) {
	return x.join(other, query, 0, 1, nil, nil, nil)
}

func (x *Index[T]) join(other *Index[T], query JoinQuery, part, parts int, a, b, state []int64) (int, error) {
	size, err := count(C.vesica_join_scratch())
	if err != nil {
		return 0, err
	}
	return count(cJoin(isWide[T](), C.int32_t(query), first(x.bytes), x.sets, x.count, first(other.bytes), other.sets,
		other.count, C.int64_t(part), C.int64_t(parts), first(aligned(size)), C.int64_t(size), first(a), first(b),
		C.int64_t(len(a)), first(state)))
}
