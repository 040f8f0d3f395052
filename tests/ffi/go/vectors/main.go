// SPDX-License-Identifier: Apache-2.0

// vectors FILE: the shared vectors (../../vectors.txt) by this package. Exit status 0 when all answers are right.
package main

import (
	"bufio"
	"errors"
	"fmt"
	"math"
	"os"
	"strconv"
	"strings"

	"example.org/vesica"
)

type numbers = [6]float64

var (
	allRight = true

	lines    []int
	expected []int
	rects    []vesica.Rect
	ellipses []vesica.Ellipse
)

func check(line, answer, expected int) {
	if answer != expected {
		fmt.Printf("line %d: %d, not %d\n", line, answer, expected)
		allRight = false
	}
}

// one is the answer, 1 or 0, or the code of the error.
func one(hit bool, err error) int {
	var code vesica.Error
	switch {
	case errors.As(err, &code):
		return int(code)
	case hit:
		return 1
	}
	return 0
}

func must[T any](value T, err error) T {
	if err != nil {
		panic(err)
	}
	return value
}

func shape(words []string) (kind int32, n numbers) {
	for i := range n {
		n[i] = math.Float64frombits(must(strconv.ParseUint(words[1+i], 16, 64)))
	}
	return int32(must(strconv.Atoi(words[0]))), n
}

func narrow(n numbers) (f [6]float32) {
	for i := range n {
		f[i] = float32(n[i])
	}
	return f
}

func readVector(line int, words []string) {
	code := must(strconv.Atoi(words[1]))
	kindA, a := shape(words[2:9])
	kindB, b := shape(words[9:16])
	switch words[0] {
	case "f64":
		check(line, one(vesica.OverlapNumbers(kindA, &a, kindB, &b)), code)
	case "f32":
		fa, fb := narrow(a), narrow(b)
		check(line, one(vesica.OverlapNumbers(kindA, &fa, kindB, &fb)), code)
	case "many":
		lines, expected = append(lines, line), append(expected, code)
		rects = append(rects, vesica.Rect{CX: a[0], CY: a[1], UX: a[2], UY: a[3], HX: a[4], HY: a[5]})
		ellipses = append(ellipses, vesica.Ellipse{CX: b[0], CY: b[1], UX: b[2], UY: b[3], A: b[4], B: b[5]})
	}
}

func checkBatch() {
	out := make([]bool, len(lines))
	valid, hits := 0, 0
	for ; expected[valid] >= 0; valid++ {
		hits += expected[valid]
	}
	if n, err := vesica.OverlapMany(rects[:valid], ellipses[:valid], out); n != hits || err != nil {
		allRight = false
	}
	// With an invalid element, an error: and yet every valid one has its answer.
	if _, err := vesica.OverlapMany(rects, ellipses, out); err != vesica.ErrShape {
		allRight = false
	}
	for i, line := range lines {
		wanted := expected[i]
		if wanted < 0 {
			wanted = 0
		}
		check(line, one(out[i], nil), wanted)
	}
}

func main() {
	file := must(os.Open(os.Args[1]))
	calls := 0
	scanner := bufio.NewScanner(file)
	for line := 1; scanner.Scan(); line++ {
		if words := strings.Fields(scanner.Text()); words[0] != "#" {
			readVector(line, words)
			if words[0] != "many" {
				calls++
			}
		}
	}
	checkBatch()
	if _, err := vesica.Overlap(vesica.Point{X: math.NaN()}, vesica.Circle{R: 1}); err != nil {
		fmt.Println("NaN:", err)
	}
	closest, err := vesica.Nearest(vesica.AABB{MaxX: 2, MaxY: 2}, vesica.Circle{CX: 6, CY: 1, R: 1})
	if want := (vesica.ClosestPoints{3, 2, 1, 5, 1}); err == nil && closest == want {
		fmt.Println("nearest: as in C")
	}
	fmt.Printf("%d calls, %d in a batch\n", calls, len(lines))
	if !allRight {
		os.Exit(1)
	}
}
