// SPDX-License-Identifier: Apache-2.0

package vesica

import (
	"fmt"
	"runtime"
	"sync"
	"sync/atomic"
)

// threadsFor is how many goroutines work on so many elements, if the caller asks for threads.
func threadsFor(threads, elements int) (int, error) {
	// With fewer elements each, starting a goroutine takes longer than it saves.
	const least = 50_000
	if threads < 0 {
		return 0, fmt.Errorf("%d threads: %w", threads, ErrArgument)
	}
	if threads > 0 {
		return threads, nil
	}
	if available := runtime.GOMAXPROCS(0); available < 1+elements/least {
		return available, nil
	}
	return 1 + elements/least, nil
}

// partsOfJoin is more than threads, as some parts take longer than others.
func partsOfJoin(threads int) int {
	if threads == 1 {
		return 1
	}
	return 8 * threads
}

// eachPart calls task for each part once, by at most so many goroutines at the same time, and waits for all.
func eachPart(threads, parts int, task func(part int)) {
	if threads > parts {
		threads = parts
	}
	var next atomic.Int64
	var group sync.WaitGroup
	work := func() {
		defer group.Done()
		for part := int(next.Add(1)) - 1; part < parts; part = int(next.Add(1)) - 1 {
			task(part)
		}
	}
	group.Add(threads)
	for i := 1; i < threads; i++ {
		go work()
	}
	work()
	group.Wait()
}
