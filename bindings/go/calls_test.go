// SPDX-License-Identifier: Apache-2.0

package vesica

import (
	"errors"
	"math"
	"os"
	"strconv"
	"strings"
	"testing"
)

// outcome is what a call gives: its result, or its error, and the values.
type outcome struct {
	result int
	err    error
	values []float64
}

var kindNames = []string{"point", "segment", "circle", "aabb", "rect", "ellipse"}
var errorNames = []string{"E_NULL", "E_SHAPE", "E_KIND", "E_ARGUMENT", "E_NOT_FINITE", "E_NEGATIVE_SIZE", "E_ZERO_AXIS",
	"E_INVERTED", "E_RANGE", "E_INDEX"}

func indexOf(names []string, word string) int {
	for i, name := range names {
		if name == word {
			return i
		}
	}
	return -1
}

func must[T any](value T, err error) T {
	if err != nil {
		panic(err)
	}
	return value
}

func number(word string) float64 { return must(strconv.ParseFloat(word, 64)) }

// numbers are those of an argument, without its kind.
func numbers[T Float](argument string) (out []T) {
	for _, word := range strings.Fields(argument) {
		if indexOf(kindNames, word) < 0 {
			out = append(out, T(number(word)))
		}
	}
	return out
}

func kind(argument string) Kind { return Kind(indexOf(kindNames, strings.Fields(argument)[0])) }

func array[T Float](argument string) Array[T] {
	return must(Packed(kind(argument), numbers[T](argument)))
}

func arrays[T Float](arguments []string) (out []Array[T]) {
	for _, argument := range arguments {
		out = append(out, array[T](argument))
	}
	return out
}

func single[T Float](argument string) Any[T] {
	shape := Any[T]{Kind: kind(argument)}
	copy(shape.Numbers[:], numbers[T](argument))
	return shape
}

func floats[N bool | Relation | WithinResult | int64 | float32 | float64](numbers []N) []float64 {
	out := make([]float64, len(numbers))
	for i, number := range numbers {
		switch number := any(number).(type) {
		case bool:
			if number {
				out[i] = 1
			}
		case Relation:
			out[i] = float64(number)
		case WithinResult:
			out[i] = float64(number)
		case int64:
			out[i] = float64(number)
		case float32:
			out[i] = float64(number)
		case float64:
			out[i] = number
		}
	}
	return out
}

// whole is of a call that writes nothing on error.
func whole(result int, err error, values ...float64) outcome {
	if err != nil {
		return outcome{err: err}
	}
	return outcome{result: result, values: values}
}

func truth(yes bool) int {
	if yes {
		return 1
	}
	return 0
}

func ofOneOrTwo[T Float](function string, arguments []string) outcome {
	a := single[T](arguments[0])
	b := single[T](arguments[len(arguments)-1])
	points := func(p ClosestPoints[float64], err error) outcome {
		return whole(0, err, p.Distance, p.AX, p.AY, p.BX, p.BY)
	}
	switch function {
	case "overlap":
		yes, err := Overlap(a, b)
		return whole(truth(yes), err)
	case "interiors_overlap":
		yes, err := InteriorsOverlap(a, b)
		return whole(truth(yes), err)
	case "relation":
		relation, err := RelationOf(a, b)
		return whole(int(relation), err)
	case "contains":
		yes, err := Contains(a, b)
		return whole(truth(yes), err)
	case "nearest":
		return points(Nearest(a, b))
	case "boundary_distance":
		return points(BoundaryDistance(a, b))
	case "depth":
		depth, err := Depth(a, b)
		return whole(0, err, depth.Depth, depth.X, depth.Y)
	case "signed_distance":
		distance, err := SignedDistance(a, b)
		return whole(0, err, distance)
	case "area":
		area, err := Area(a, b)
		return whole(0, err, area)
	case "iou":
		iou, err := IoU(a, b)
		return whole(0, err, iou)
	case "crossings":
		places, err := Crossings(a, b)
		values := []float64{0}
		if places.Shared {
			values[0] = 1
		}
		for _, place := range places.Places {
			values = append(values, place.X, place.Y)
		}
		return whole(len(places.Places), err, values...)
	case "check":
		return whole(0, Check(a))
	case "shape_area":
		area, err := ShapeArea(a)
		return whole(0, err, area)
	case "bounds":
		box, err := Bounds(a)
		return whole(0, err, box.MinX, box.MinY, box.MaxX, box.MaxY)
	}
	panic(function)
}

func constructed[T Float](function string, arguments []string) outcome {
	n := numbers[T](arguments[0])
	rect := func(r Rect[T], err error) outcome {
		return whole(0, err, floats([]T{r.CX, r.CY, r.UX, r.UY, r.HX, r.HY})...)
	}
	capsule := func(c Capsule[T], err error) outcome {
		return whole(0, err, floats([]T{c.X0, c.Y0, c.X1, c.Y1, c.R})...)
	}
	ellipse := func(e Ellipse[T], err error) outcome {
		return whole(0, err, floats([]T{e.CX, e.CY, e.UX, e.UY, e.A, e.B})...)
	}
	switch function {
	case "aabb_from_corners":
		box, err := AABBFromCorners(n[0], n[1], n[2], n[3])
		return whole(0, err, floats([]T{box.MinX, box.MinY, box.MaxX, box.MaxY})...)
	case "rect_from_angle":
		return rect(RectFromAngle(n[0], n[1], n[2], n[3], n[4]))
	case "rect_from_corners":
		return rect(RectFromCorners(*(*[8]T)(n)))
	case "rect_corners_misfit":
		r := numbers[T](arguments[1])
		misfit, err := RectCornersMisfit(*(*[8]T)(n), Rect[T]{r[0], r[1], r[2], r[3], r[4], r[5]})
		return whole(0, err, float64(misfit))
	case "round_rect_from_angle":
		r, err := RoundRectFromAngle(n[0], n[1], n[2], n[3], n[4], n[5])
		return whole(0, err, floats([]T{r.CX, r.CY, r.UX, r.UY, r.HX, r.HY, r.R})...)
	case "capsule_from_angle":
		return capsule(CapsuleFromAngle(n[0], n[1], n[2], n[3], n[4]))
	case "capsule_from_width":
		return capsule(CapsuleFromWidth(n[0], n[1], n[2], n[3], n[4]))
	case "ellipse_from_angle":
		return ellipse(EllipseFromAngle(n[0], n[1], n[2], n[3], n[4]))
	case "ellipse_from_radius_vector":
		return ellipse(EllipseFromRadiusVector(n[0], n[1], n[2], n[3], n[4]))
	case "ellipse_from_covariance":
		return ellipse(EllipseFromCovariance(n[0], n[1], n[2], n[3], n[4], n[5]))
	case "ellipse_from_matrix":
		return ellipse(EllipseFromMatrix(n[0], n[1], n[2], n[3], n[4]))
	}
	panic(function)
}

func impactValues[T Float](i Impact[T]) []float64 { return floats([]T{i.T, i.X, i.Y, i.NX, i.NY}) }

// firstOutcome is what was met first, as the library tells it.
func firstOutcome[T Float](item int, impact Impact[T], err error, items int) outcome {
	if item < 0 && err == nil {
		item, impact.T = items, T(math.Inf(1))
	}
	return whole(item, err, impactValues(impact)...)
}

func ofTurns[T Float](arguments []string) outcome {
	turn := func(argument string) Turn[float64] {
		n := numbers[float64](argument)
		return Turn[float64]{n[0], n[1], n[2]}
	}
	found, impact, gap, err := ImpactTime(single[T](arguments[0]), turn(arguments[1]), single[T](arguments[2]),
		turn(arguments[3]), numbers[float64](arguments[4])[0])
	return whole(int(found), err, append(impactValues(impact), gap)...)
}

func ofMotion[T Float](function string, arguments []string) outcome {
	if function == "cast_many" {
		a, b := array[T](arguments[0]), array[T](arguments[1])
		n := a.Len()
		if b.Len() > n {
			n = b.Len()
		}
		c := make([]T, 5*n)
		out := ImpactColumns[T]{c[:n], c[n : 2*n], c[2*n : 3*n], c[3*n : 4*n], c[4*n:]}
		count, err := CastMany(a, b, numbers[T](arguments[2]), numbers[T](arguments[3]), numbers[T](arguments[4])[0],
			out)
		return outcome{count, err, floats(c)}
	}
	of := 1
	if function == "cast" || function == "cast_first" {
		of = 2
	}
	n := numbers[float64](arguments[of])
	motion, one := Motion{n[0], n[1], n[2]}, single[T](arguments[0])
	switch function {
	case "cast":
		found, impact, err := Cast(one, single[T](arguments[1]), motion)
		return whole(int(found), err, impactValues(impact)...)
	case "cast_first":
		many := array[T](arguments[1])
		item, impact, err := CastFirst(one, many, motion)
		return firstOutcome(item, impact, err, many.Len())
	case "sweep_bounds":
		box, err := SweepBounds(one, motion)
		return whole(0, err, box.MinX, box.MinY, box.MaxX, box.MaxY)
	}
	index := must(NewIndex(arrays[T](arguments[2:])...))
	if function == "index_cast" {
		items, err := index.Cast(one, motion)
		return whole(len(items), err, floats(items)...)
	}
	item, impact, err := index.CastFirst(one, motion)
	return firstOutcome(item, impact, err, index.Len())
}

func ofBoxes[T Float](function string, arguments []string) outcome {
	var values []float64
	var err error
	angle := func() Angle { return Angle(numbers[float64](arguments[1])[0]) }
	switch function {
	case "rects_from_boxes":
		boxes := numbers[T](arguments[0])
		rects := make([]Rect[T], len(boxes)/5)
		err = RectsFromBoxes(boxes, 5, angle(), rects)
		for _, r := range rects {
			values = append(values, floats([]T{r.CX, r.CY, r.UX, r.UY, r.HX, r.HY})...)
		}
	case "ellipses_from_boxes":
		boxes := numbers[T](arguments[0])
		ellipses := make([]Ellipse[T], len(boxes)/5)
		err = EllipsesFromBoxes(boxes, 5, angle(), ellipses)
		for _, e := range ellipses {
			values = append(values, floats([]T{e.CX, e.CY, e.UX, e.UY, e.A, e.B})...)
		}
	case "boxes_from_shapes":
		shapes := array[T](arguments[0])
		boxes := make([][5]T, shapes.Len())
		err = BoxesFromShapes(shapes, angle(), boxes)
		for _, box := range boxes {
			values = append(values, floats(box[:])...)
		}
	case "corners_of_shapes":
		shapes := array[T](arguments[0])
		corners := make([][8]T, shapes.Len())
		err = CornersOf(shapes, corners)
		for _, each := range corners {
			values = append(values, floats(each[:])...)
		}
	case "bounds_many":
		shapes := array[T](arguments[0])
		bounds := make([]AABB[T], shapes.Len())
		err = BoundsMany(shapes, bounds)
		for _, b := range bounds {
			values = append(values, floats([]T{b.MinX, b.MinY, b.MaxX, b.MaxY})...)
		}
	}
	return outcome{0, err, values}
}

func ofRatios[T Float](function string, arguments []string) outcome {
	ratio := Ratio(number(arguments[0]))
	if function == "ratio" {
		value, err := RatioOf(ratio, single[T](arguments[1]), single[T](arguments[2]))
		return whole(0, err, value)
	}
	a, b := array[T](arguments[1]), array[T](arguments[2])
	if function == "ratio_matrix" {
		out := make([]T, a.Len()*b.Len())
		count, err := RatioMatrix(ratio, a, b, out)
		return outcome{count, err, floats(out)}
	}
	out := make([]T, must(inStep(a, b)))
	count, err := RatioMany(ratio, a, b, out)
	return outcome{count, err, floats(out)}
}

func ofTopology[T Float](function string, arguments []string) outcome {
	switch function {
	case "de9im_match":
		fits, err := DE9IMMatch(arguments[0], strings.TrimSpace(arguments[1]))
		return whole(truth(fits), err)
	case "de9im":
		matrix, err := DE9IM(single[T](arguments[0]), single[T](arguments[1]))
		values := []float64{}
		for _, letter := range matrix {
			values = append(values, float64(strings.IndexRune("F012", letter)-1))
		}
		return whole(0, err, values...)
	case "intersection":
		vertices, err := Intersection(single[T](arguments[0]), single[T](arguments[1]))
		values := []float64{}
		for _, vertex := range vertices {
			values = append(values, vertex.X, vertex.Y)
		}
		return whole(len(vertices), err, values...)
	case "within":
		found, err := Within(single[T](arguments[0]), single[T](arguments[1]), number(strings.TrimSpace(arguments[2])))
		return whole(int(found), err)
	case "join_within":
		slash := indexOf(arguments, "/")
		a := must(NewIndex(arrays[T](arguments[1:slash])...))
		b := a
		if slash+1 < len(arguments) {
			b = must(NewIndex(arrays[T](arguments[slash+1:])...))
		}
		pairs, err := a.JoinWithin(b, numbers[T](arguments[0])[0])
		values := []float64{}
		for _, pair := range pairs {
			values = append(values, float64(pair.A), float64(pair.B))
		}
		return whole(len(pairs), err, values...)
	case "suppress_soft":
		words := numbers[T](arguments[2])
		how := SoftSuppression[T]{Ratio: Ratio(words[0]), Decay: Decay(words[1]), Parameter: words[2],
			LeastScore: words[3], Most: int(words[4])}
		if len(arguments) > 3 {
			for _, label := range numbers[float64](arguments[3]) {
				how.Labels = append(how.Labels, int32(label))
			}
		}
		kept, left, err := SuppressSoft(array[T](arguments[0]), numbers[T](arguments[1]), how)
		return outcome{0, err, append(floats(kept), floats(left)...)}
	}
	a, b, distance := array[T](arguments[0]), array[T](arguments[1]), numbers[T](arguments[2])[0]
	if function == "within_matrix" {
		out := make([]WithinResult, a.Len()*b.Len())
		count, err := WithinMatrix(a, b, distance, out)
		return outcome{count, err, floats(out)}
	}
	out := make([]WithinResult, must(inStep(a, b)))
	count, err := WithinMany(a, b, distance, out)
	return outcome{count, err, floats(out)}
}

func suppressed[T Float](arguments []string) outcome {
	words := numbers[T](arguments[2])
	how := Suppression[T]{Ratio: Ratio(words[0]), Threshold: words[1], LeastScore: &words[2], Most: int(words[3])}
	if len(arguments) > 3 {
		for _, label := range numbers[float64](arguments[3]) {
			how.Labels = append(how.Labels, int32(label))
		}
	}
	kept, err := Suppress(array[T](arguments[0]), numbers[T](arguments[1]), how)
	return outcome{0, err, floats(kept)}
}

func ofArrays[T Float](function string, arguments []string) outcome {
	a, b := array[T](arguments[0]), array[T](arguments[1])
	n := a.Len()
	if strings.HasSuffix(function, "_matrix") {
		n *= b.Len()
	} else if b.Len() > n {
		n = b.Len()
	}
	bools, relations, out := make([]bool, n), make([]Relation, n), make([]T, 5*n)
	column := func(i int) []T { return out[i*n : (i+1)*n] }
	closest := ClosestPointsColumns[T]{column(0), column(1), column(2), column(3), column(4)}
	ofBools := func(count int, err error) outcome { return outcome{count, err, floats(bools)} }
	ofRelations := func(count int, err error) outcome { return outcome{count, err, floats(relations)} }
	ofColumns := func(columns int) func(int, error) outcome {
		return func(count int, err error) outcome { return outcome{count, err, floats(out[:columns*n])} }
	}
	switch function {
	case "overlap_many":
		return ofBools(OverlapMany(a, b, bools))
	case "interiors_overlap_many":
		return ofBools(InteriorsOverlapMany(a, b, bools))
	case "contains_many":
		return ofBools(ContainsMany(a, b, bools))
	case "relation_many":
		return ofRelations(RelationMany(a, b, relations))
	case "area_many":
		return ofColumns(1)(AreaMany(a, b, column(0)))
	case "iou_many":
		return ofColumns(1)(IoUMany(a, b, column(0)))
	case "nearest_many":
		return ofColumns(5)(NearestMany(a, b, closest))
	case "boundary_distance_many":
		return ofColumns(5)(BoundaryDistanceMany(a, b, closest))
	case "depth_many":
		return ofColumns(3)(DepthMany(a, b, PenetrationColumns[T]{column(0), column(1), column(2)}))
	case "overlap_matrix":
		return ofBools(OverlapMatrix(a, b, bools))
	case "interiors_overlap_matrix":
		return ofBools(InteriorsOverlapMatrix(a, b, bools))
	case "contains_matrix":
		return ofBools(ContainsMatrix(a, b, bools))
	case "relation_matrix":
		return ofRelations(RelationMatrix(a, b, relations))
	case "area_matrix":
		return ofColumns(1)(AreaMatrix(a, b, column(0)))
	case "iou_matrix":
		return ofColumns(1)(IoUMatrix(a, b, column(0)))
	case "signed_distance_many":
		return ofColumns(1)(SignedDistanceMany(a, b, column(0)))
	case "signed_distance_matrix":
		return ofColumns(1)(SignedDistanceMatrix(a, b, column(0)))
	case "nearest_matrix":
		return ofColumns(1)(NearestMatrix(a, b, column(0)))
	case "boundary_distance_matrix":
		return ofColumns(1)(BoundaryDistanceMatrix(a, b, column(0)))
	case "depth_matrix":
		return ofColumns(1)(DepthMatrix(a, b, column(0)))
	case "interiors_overlap_select":
		indices, err := InteriorsOverlapSelect(single[T](arguments[0]), b)
		return outcome{len(indices), err, floats(indices)}
	case "overlap_select":
		indices, err := OverlapSelect(single[T](arguments[0]), b)
		return outcome{len(indices), err, floats(indices)}
	}
	panic(function)
}

// ofIndexes has arguments before the sets, and the sets of two indexes on both sides of a slash.
func ofIndexes[T Float](function string, leading, rest []string) outcome {
	setsA, setsB := rest, []string{}
	if slash := indexOf(rest, "/"); slash >= 0 {
		setsA, setsB = rest[:slash], rest[slash+1:]
	}
	a := must(NewIndex(arrays[T](setsA)...))
	a = must(IndexFromBytes(a.Bytes(), arrays[T](setsA)...))
	b := a
	if len(setsB) > 0 {
		b = must(NewIndex(arrays[T](setsB)...))
	}
	items := func(items []int64, err error) outcome { return whole(len(items), err, floats(items)...) }
	switch function {
	case "index_bounds":
		box, err := a.Bounds()
		return whole(0, err, box.MinX, box.MinY, box.MaxX, box.MaxY)
	case "index_order":
		return items(a.Order())
	case "index_select":
		return items(a.Select(single[T](leading[0])))
	case "index_nearest":
		found, err := a.Nearest(single[T](leading[0]), int(numbers[float64](leading[1])[0]), numbers[T](leading[1])[1])
		values := make([]float64, 2*len(found))
		for i, neighbour := range found {
			values[i], values[len(found)+i] = float64(neighbour.Item), float64(neighbour.Distance)
		}
		return whole(len(found), err, values...)
	case "join":
		pairs, err := a.Join(b, JoinQuery(number(leading[0])))
		if n := must(a.JoinCount(b, JoinQuery(number(leading[0])))); n != len(pairs) {
			panic("another count")
		}
		values := []float64{}
		for _, pair := range pairs {
			values = append(values, float64(pair.A), float64(pair.B))
		}
		return whole(len(pairs), err, values...)
	case "join_nearest":
		k, within := int(numbers[float64](leading[0])[0]), numbers[T](leading[0])[1]
		found, distances, err := b.NearestOfEach(k, within, arrays[T](setsA)...)
		n := 0
		for _, item := range found {
			n += truth(item >= 0)
		}
		return outcome{n, err, append(floats(found), floats(distances)...)}
	}
	panic(function)
}

func answer[T Float](function string, arguments []string) outcome {
	switch {
	case strings.Contains(function, "boxes") || function == "corners_of_shapes" || function == "bounds_many":
		return ofBoxes[T](function, arguments)
	case function == "impact_time":
		return ofTurns[T](arguments)
	case strings.Contains(function, "cast") || function == "sweep_bounds":
		return ofMotion[T](function, arguments)
	case strings.HasPrefix(function, "ratio"):
		return ofRatios[T](function, arguments)
	case strings.HasPrefix(function, "within") || strings.HasPrefix(function, "de9im") || function == "intersection" ||
		function == "join_within" || function == "suppress_soft":
		return ofTopology[T](function, arguments)
	case function == "suppress":
		return suppressed[T](arguments)
	case strings.Contains(function, "_from_") || function == "rect_corners_misfit":
		return constructed[T](function, arguments)
	case function == "index_nearest":
		return ofIndexes[T](function, arguments[:2], arguments[2:])
	case function == "index_select" || strings.HasPrefix(function, "join"):
		return ofIndexes[T](function, arguments[:1], arguments[1:])
	case strings.HasPrefix(function, "index_"):
		return ofIndexes[T](function, nil, arguments)
	case function == "nms":
		kept, err := NMS(array[T](arguments[0]), numbers[T](arguments[1]), numbers[T](arguments[2])[0])
		return outcome{0, err, floats(kept)}
	case strings.HasSuffix(function, "_many") || strings.HasSuffix(function, "_matrix") ||
		strings.HasSuffix(function, "_select"):
		return ofArrays[T](function, arguments)
	}
	return ofOneOrTwo[T](function, arguments)
}

func same(a []float64, words []string) bool {
	if len(a) != len(words) {
		return false
	}
	for i, word := range words {
		b := number(word)
		if math.Float64bits(a[i]) != math.Float64bits(b) && !(math.IsNaN(a[i]) && math.IsNaN(b)) {
			return false
		}
	}
	return true
}

func isRight(line string) bool {
	left, right, _ := strings.Cut(line, " = ")
	parts := strings.Split(left, " | ")
	function, scalar, _ := strings.Cut(parts[0], " ")
	var given outcome
	if scalar == "f64" {
		given = answer[float64](function, parts[1:])
	} else {
		given = answer[float32](function, parts[1:])
	}
	words := strings.Fields(right)
	result, values := words[0], words[1:]
	if given.err != nil {
		var code Error
		if !errors.As(given.err, &code) || indexOf(errorNames, result) != int(-code)-1 {
			return false
		}
		return len(values) == 0 || same(given.values, values)
	}
	return result == strconv.Itoa(given.result) && same(given.values, values)
}

func lines(t *testing.T) (out []string) {
	path := os.Getenv("VESICA_CALLS_FILE")
	if path == "" {
		path = "../calls/calls.txt"
	}
	text, err := os.ReadFile(path)
	if err != nil {
		t.Fatal(err)
	}
	for _, line := range strings.Split(strings.TrimSpace(string(text)), "\n") {
		if !strings.HasPrefix(line, "#") {
			out = append(out, line)
		}
	}
	return out
}

func TestEveryCallIsRight(t *testing.T) {
	for _, line := range lines(t) {
		if !isRight(line) {
			t.Error(line)
		}
	}
	if n := len(lines(t)); n < 700 {
		t.Errorf("only %d calls", n)
	}
}

// The first call of each function, with its last word made what no call gives.
func TestWrongAnswersAreFound(t *testing.T) {
	functions := map[string]bool{}
	for _, line := range lines(t) {
		function, _, _ := strings.Cut(line, " ")
		if spoilt := line[:strings.LastIndex(line, " ")] + " 7.5"; !functions[function] && isRight(spoilt) {
			t.Error(spoilt)
		}
		functions[function] = true
	}
	if len(functions) < 70 {
		t.Errorf("only %d functions", len(functions))
	}
}
