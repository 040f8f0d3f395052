package main

import (
	"fmt"
	"math"

	"example.org/vesica"
)

func main() {
	car, err := vesica.RectFromAngle(0.0, 0.0, 36.87*math.Pi/180, 4.0, 2.0) // x, y, angle, width, height
	person := vesica.Ellipse[float64]{CX: 1.5, CY: 1, UX: 1, UY: 0, A: 1, B: 0.5}
	post := vesica.Circle[float64]{CX: 5, CY: 0, R: 0.5}
	if err != nil {
		panic(err)
	}

	hit, _ := vesica.Overlap(car, person)
	gap, _ := vesica.Nearest(car, post)
	iou, err := vesica.IoU(car, person)
	if err != nil {
		panic(err)
	}
	answer := map[bool]int{true: 1}[hit]
	fmt.Printf("overlap %d, distance %.3f, IoU %.3f\n", answer, gap.Distance, iou)
}
