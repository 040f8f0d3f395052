// SPDX-License-Identifier: Apache-2.0

// What calls cost from Go: as bench/hosts/overhead.c does, with the same rectangles.
package main

import (
	"fmt"
	"time"

	"example.org/vesica"
)

const total = 1_000_000

func rect(i int) vesica.Rect[float64] {
	ux, uy := 0.8, 0.6
	if i%2 == 1 {
		ux, uy = 5.0/13, 12.0/13
	}
	return vesica.Rect[float64]{CX: float64(i*7919%4001) / 1000, CY: float64(i*104729%4003) / 1000, UX: ux, UY: uy,
		HX: 0.5 + float64(i%100)/200, HY: 0.5 + float64(i%70)/140}
}

func least(repeats, calls int, call func(i int)) float64 {
	best := 1e300
	for repeat := 0; repeat < repeats; repeat++ {
		start := time.Now()
		for i := 0; i < calls; i++ {
			call(i)
		}
		if ns := float64(time.Since(start).Nanoseconds()) / float64(calls); ns < best {
			best = ns
		}
	}
	return best
}

func row(question string, one, many func(n int)) {
	some := least(100, 1, func(int) { many(1000) }) / 1e3
	all := least(7, 1, func(int) { many(total) }) / total
	fmt.Printf("Go %s %.4g %.4g %.4g\n", question, least(100, 1000, one), some, all)
}

func main() {
	a, b := make([]vesica.Rect[float64], total), make([]vesica.Rect[float64], total)
	for i := range a {
		a[i], b[i] = rect(i), rect(3*i+1)
	}
	hits, out := make([]bool, total), make([]float64, 5*total)
	column := func(k int) []float64 { return out[k*total : (k+1)*total] }
	columns := vesica.ClosestPointsColumns[float64]{Distance: column(0), AX: column(1), AY: column(2)}
	columns.BX, columns.BY = column(3), column(4)
	row("overlap", func(i int) { vesica.Overlap(a[i%1000], b[i%1000]) },
		func(n int) { vesica.OverlapMany(vesica.Rects(a[:n]), vesica.Rects(b[:n]), hits) })
	row("nearest", func(i int) { vesica.Nearest(a[i%1000], b[i%1000]) },
		func(n int) { vesica.NearestMany(vesica.Rects(a[:n]), vesica.Rects(b[:n]), columns) })
	row("iou", func(i int) { vesica.IoU(a[i%1000], b[i%1000]) },
		func(n int) { vesica.IoUMany(vesica.Rects(a[:n]), vesica.Rects(b[:n]), out) })
}
