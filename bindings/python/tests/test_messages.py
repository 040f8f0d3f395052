# SPDX-License-Identifier: Apache-2.0
"""What is said of what a first program passes: messages name the argument or the row, its number, and what fits."""
import math
import re
import unittest
from fractions import Fraction

import numpy
import vesica
from vesica import Kind, Ratio

ROWS = {
    "points": [1, 2],
    "segments": [1, 2, 3, 4],
    "circles": [1, 2, 3],
    "capsules": [1, 2, 3, 4, 1],
    "aabbs": [1, 2, 3, 4],
    "rects": [1, 2, 3, 4, 0],
    "ellipses": [1, 2, 3, 4, 0],
    "ellipses_in_boxes": [1, 2, 3, 4, 0],
    "round_rects": [1, 2, 3, 4, 0, 0.5],
}
QUAD = [[0, 0], [1, 0], [1, 1], [0, 1]]
FLAT = [0, 0, 1, 0, 1, 1, 0, 1]
RECTS = vesica.rects([ROWS["rects"]] * 2)
BOX, DISC = RECTS[0], vesica.circles([0, 0, 1])
INDEX = vesica.Index(RECTS)


class Messages(unittest.TestCase):
    def says(self, words, call, *arguments, error=ValueError, **named):
        """The whole message, in which ... stands for anything."""
        pattern = "^" + re.escape(words).replace(re.escape("..."), ".*") + "$"
        with self.assertRaisesRegex(error, pattern) as caught:
            call(*arguments, **named)
        return caught.exception


class OfRows(Messages):
    """Errors of single numbers, by the name of the number and the row."""

    def test_constructors(self):
        for make, row, wrong, words in (
            ("rects", ROWS["rects"], (2, -3), "width is -3"),
            ("rects", ROWS["rects"], (3, -0.5), "height is -0.5"),
            ("rects", ROWS["rects"], (4, math.inf), "angle is inf"),
            ("ellipses", ROWS["ellipses"], (2, -3), "a is -3"),
            ("ellipses_in_boxes", ROWS["rects"], (3, -3), "height is -3"),
            ("round_rects", ROWS["round_rects"], (5, -1), "radius is -1"),
            ("round_rects", ROWS["round_rects"], (5, 2), "radius is 2, above half of width, 3"),
            ("round_rects", ROWS["round_rects"], (0, math.nan), "x is nan"),
        ):
            for dtype in ("f8", "f4"):
                rows = numpy.array([row] * 4, dtype)
                rows[2, wrong[0]] = wrong[1]
                error = self.says(f"row 2: {words}", getattr(vesica, make), rows, error=vesica.VesicaError)
                self.assertEqual(error.result.invalid().tolist(), [2])
                self.says(words, getattr(vesica, make), rows[2], error=vesica.VesicaError)
                rows[3] = rows[2]
                self.says(f"row 2: {words} (the first of 2 invalid rows)", getattr(vesica, make), rows)

    def test_operands(self):
        for make, wrong, words in (
            ("points", [1, math.nan], "y is nan"),
            ("segments", [1, 2, math.inf, 4], "x1 is inf"),
            ("circles", [1, 2, -3], "r is -3"),
            ("capsules", [1, 2, 3, 4, -1], "r is -1"),
            ("aabbs", [3, 2, 1, 4], "min_x is 3, above max_x, 1"),
            ("aabbs", [1, 4.5, 3, 4], "min_y is 4.5, above max_y, 4"),
        ):
            many = getattr(vesica, make)([ROWS[make], ROWS[make], wrong])
            self.says(f"row 2 of a: {words}", vesica.overlap, many, DISC)
            self.says(f"row 2 of b: {words}", vesica.area, DISC, many)
            self.says(f"row 2 of many: {words}", vesica.overlap_select, DISC, many)
            self.says(f"row 2 of shape: {words}", vesica.bounds, many)
            self.says(f"row 2 of shape: {words}", vesica.shape_area, many)
            self.says(f"row 2 of sets[0]: {words}", INDEX.nearest_of_each, many)
            self.says(f"row 2 of a: {words}...; row 2 of b: {words}...", vesica.overlap_matrix, many, many)
            self.says(f"b: {words}", vesica.nearest, DISC, many[2])
            self.says(f"a: {words}", vesica.relation, many[2], DISC)
            self.says(f"a: {words}", vesica.cast, many[2], DISC, (1, 0))
            self.says(f"one: {words}", vesica.cast_first, many[2], RECTS, (1, 0))
            self.says(f"shape: {words}", vesica.sweep_bounds, many[2], (1, 0), 1)
            self.says(f"shape: {words}", INDEX.select, many[2])
            self.says(f"shape: {words}", INDEX.nearest, many[2])
            self.says(words, vesica.check, many[2])
        axes = vesica.shapes(Kind.RECT, [[0, 0, 0, 0, 1, 1]])
        self.says("row 0 of a: ux and uy are both 0", vesica.overlap, axes, DISC)

    def test_polygons(self):
        bad = numpy.array([QUAD] * 3, float)
        bad[1, 2, 0] = math.nan
        self.says("row 1 of a: ring 0, vertex 2 is (nan, 1)", vesica.overlap, vesica.polygons(bad), DISC)
        self.says("a: ring 0, vertex 2 is (nan, 1)", vesica.overlap, vesica.polygons(bad)[1], DISC)
        holes = vesica.polygons([[QUAD, QUAD], [QUAD, bad[1]]])
        self.says("row 1 of shape: ring 1, vertex 2 is (nan, 1)", vesica.bounds, holes)

    def test_results(self):
        points = vesica.points([[0, 0], [1, 1]])
        nothing = "the areas leave nothing to divide by"
        self.says(nothing, vesica.iou, points[0], points[0])
        self.says(f"row 0: {nothing}", vesica.iou, points, points)
        boxes = vesica.aabbs([[0, 0, 1, 1], [0] * 4])
        self.says(f"a[0] and b[1]: {nothing}", vesica.iou_matrix, points[:1], boxes)
        self.says(f"row 1: {nothing}", vesica.ratio, Ratio.OVER_FIRST, boxes, points)
        far = vesica.points([[-1.7e308, 0]])
        self.says("row 0: the result is out of the range...", vesica.nearest, far, vesica.points([[1.7e308, 0]]))

    def test_corners(self):
        crossed, unknown = [[0, 0], [1, 0], [0, 1], [1, 1]], [[0, 0], [1, 0], [1, math.nan], [0, 1]]
        made = vesica.rects_from_corners
        self.says("row 1: corners are crossed, not in order round the outline", made, [QUAD, crossed, QUAD])
        self.says("corners are crossed, not in order round the outline", made, crossed)
        error = self.says("row 0: corner 2 is (1, nan) (the first of 2 invalid rows)", made, [unknown, crossed, QUAD])
        self.assertEqual(error.result[2].numbers.tolist(), [0.5, 0.5, 1, 0, 0.5, 0.5])
        rects = made([QUAD, QUAD])
        self.says("row 1 of corners: corner 2 is (1, nan)", vesica.rect_corners_misfit, [QUAD, unknown], rects)
        error = self.says("row 1 of rect: hx is -1", vesica.rect_corners_misfit, [QUAD] * 2,
                          vesica.shapes(Kind.RECT, [[0.5, 0.5, 1, 0, 0.5, 0.5], [0, 0, 1, 0, -1, 1]]))
        self.assertEqual(error.result[0], 0)

    def test_covariances(self):
        make, one = vesica.ellipses_from_covariance, numpy.eye(2)
        negative = "the covariance 1 0 -1 (xx xy yy) has a negative variance"
        self.says(f"row 1: {negative}", make, [[0, 0]] * 2, [one, [[1, 0], [0, -1]]])
        self.says("covariances: row 1 is not symmetric: 1 and 0", make, [[0, 0]] * 2, [one, [[1, 1], [0, 1]]])
        self.says("row 0: cxx is inf", make, [[0, 0]], [[[math.inf, 0], [0, 1]]])
        self.says("k is -1 (0 or more)", make, [0, 0], one, -1)
        self.says("means have the shape (n, 2) and covariances (n, 2, 2), not (2,) and (2,)", make, [0, 0], [1, 1])


class OfArrays(Messages):
    """Whatever a constructor is given: shapes, or what is wrong with it."""

    def test_what_is_taken(self):
        for name, row in ROWS.items():
            make, n = getattr(vesica, name), len(row)
            expected = make(numpy.array([row] * 2, float)).numbers.tolist()
            table = numpy.array([row] * 2, float)
            for array in (
                [row, tuple(row)],
                (row, row),
                [numpy.array(row, float)] * 2,
                table.astype("f4"),
                numpy.asfortranarray(table),
                numpy.repeat(table, 2, axis=0)[::2],
                numpy.repeat(table, 2, axis=1)[:, ::2],
                table.astype(">f8"),
                numpy.ma.masked_array(table),
            ):
                self.assertEqual(make(array).numbers.tolist(), expected, name)
            if name != "round_rects":
                self.assertEqual(make(table.astype("i1")).numbers.tolist(), expected)
            self.assertEqual(make(row).numbers.tolist(), expected[0])
            self.assertTrue(make(row).single)
            for empty in ([], (), numpy.empty((0, n)), numpy.empty(0, "f4")):
                self.assertEqual(make(empty).numbers.shape, (0, len(expected[0])))

    def test_columns_by_name(self):
        table = {"name": ["a", "b"], "x": [1, 2], "y": [3, 4], "width": [5, 6], "height": [7, 8], "angle": [0, 90]}
        expected = vesica.rects([[1, 3, 5, 7, 0], [2, 4, 6, 8, 90]], degrees=True).numbers.tolist()
        self.assertEqual(vesica.rects(table, degrees=True).numbers.tolist(), expected)
        records = numpy.zeros(2, [(name, "f8") for name in ("angle", "height", "width", "x", "y")])
        for name in records.dtype.names:
            records[name] = table[name]
        self.assertEqual(vesica.rects(records, degrees=True).numbers.tolist(), expected)
        one = vesica.rects(records[1], degrees=True)
        self.assertEqual((one.single, one.numbers.tolist()), (True, expected[1]))
        self.assertEqual(vesica.circles({"cx": 1, "cy": 2, "r": 3}).numbers.tolist(), [1, 2, 3])
        self.says(
            "rects need fields x y width height angle; missing: angle", vesica.rects, dict(list(table.items())[:5]),
        )
        self.says("circles have columns of different lengths: cx 2, cy 2, r 1", vesica.circles,
                  {"cx": [1, 2], "cy": [1, 2], "r": [1]})
        self.says("circles have columns of different lengths: cx 2, cy 2, r one", vesica.circles,
                  {"cx": [1, 2], "cy": [1, 2], "r": 1})
        self.says("the fields of points are all float64 or all float32, not x float32, y float64", vesica.points,
                  {"x": numpy.zeros(2, "f4"), "y": [1, 2]}, error=TypeError)
        self.says("circles: r: row 1 is 'a', not numbers", vesica.circles, {"cx": [1, 2], "cy": [1, 2], "r": [1, "a"]},
                  error=TypeError)

    def test_what_is_no_array(self):
        for name, row in ROWS.items():
            make, n = getattr(vesica, name), len(row)
            need, have = f"{name} need {n} numbers each (...): ", f"{name} have float64 or float32 numbers, not "
            convert = ": convert them, as by .astype('f8')"
            for given, words, error in (
                (None, f"{name} is None, not an array of numbers", TypeError),
                ("text", f"{name} is 'text', not an array of numbers", TypeError),
                ((row for _ in range(2)), f"{name} is of the type generator, not an array of numbers", TypeError),
                ({1, 2}, f"{name} is of the type set, not an array of numbers", TypeError),
                (["1"] * n, f"{name}: row 0 is '1', not numbers", TypeError),
                ([row, None], f"{name}: row 1 is None, not numbers", TypeError),
                ([row, row[:-1] + [None]], f"{name}: row 1, number {n - 1} is None, not a number", TypeError),
                ([row, row[:-1] + ["x"]], f"{name}: row 1, number {n - 1} is 'x', not a number", TypeError),
                ([row, row[:-1]], f"{name}: row 1 has {n - 1} number...", ValueError),
                ([row, 1], f"{name}: row 1 has one number, row 0 has {n} numbers", ValueError),
                (numpy.array([row, ["x"] * n], object), f"{name}: row 1, number 0 is 'x', not a number", TypeError),
                ([{"x": 1}], f"{name}: row 0 is a dict; columns of one dict are taken, not a list of dicts", TypeError),
                (3.0, f"{need}an array of shape (n, {n}) or ({n},), not ()", ValueError),
                ([[]], f"{need}..., not (1, 0)", ValueError),
                ([row + [1]], f"{need}..., not (1, {n + 1})...", ValueError),
                (numpy.zeros((n, 9)), f"{need}... ({n}, 9); if each column is a shape, take its transpose", ValueError),
                (numpy.zeros((2, n), "f2"), f"{have}float16{convert}", TypeError),
                (numpy.zeros((2, n), complex), f"{have}complex128", TypeError),
                (numpy.zeros((2, n), "M8[s]"), f"{have}datetime64[s]", TypeError),
                ([[Fraction(1, 2)] * n], f"{have}object{convert}", TypeError),
                ([[2**53 + 1] * n], f"{name}: float64 lacks some of these numbers of int64: ...", ValueError),
                (numpy.ma.masked_less([row] * 2, 2), f"{name}: some of the numbers are masked, ...", ValueError),
                (DISC, f"{name} are circle shapes already, not an array of numbers", TypeError),
                ([BOX, BOX], f"{name} are shapes already: make one array of them, as by vesica.shapes(...", TypeError),
            ):
                self.says(words, make, given, error=error)
        self.says("...; four corners are taken by vesica.rects_from_corners", vesica.rects, [FLAT])
        aabbs = "x0 y0 x1 y1 are taken by vesica.aabbs, and boxes that are not turned have an angle of 0"
        self.says(f"...; {aabbs}", vesica.rects, [[0] * 4])
        self.says("...; cx cy ux uy and half sizes are taken by vesica.shapes(kind, array)", vesica.rects, [[0] * 6])

    def test_kinds(self):
        for given in ("rect", 99, None, [1, 2]):
            words = f"kind is {given!r}, not one of vesica.Kind: POINT, SEGMENT, ..., POLYLINE"
            self.says(words, vesica.shapes, given, [1, 2])
        words = "polygon shapes have vertices: they are made by vesica.polygons"
        self.says(words, vesica.shapes, Kind.POLYGON, [1], error=TypeError)

    def test_lists_of_shapes(self):
        words = "a is a list of shapes: make one array of them, as by vesica.shapes(..."
        self.says(words, vesica.overlap, [BOX], DISC, error=TypeError)
        self.says("sets[0] is a list of shapes: ...", vesica.Index, [RECTS], error=TypeError)


class OfPolygons(Messages):
    def test_what_is_taken(self):
        quad = vesica.polygons(QUAD).rings[0][0].tolist()
        table = numpy.array([FLAT] * 3)
        for array in (
            [QUAD] * 3,
            numpy.array([QUAD] * 3, "f4"),
            [FLAT] * 3,
            table,
            table.astype("f4"),
            numpy.asfortranarray(table, float),
            numpy.repeat(table, 2, axis=0)[::2].astype(float)[::-1],
            numpy.repeat(table, 2, axis=1)[:, ::2],
        ):
            for make in (vesica.polygons, vesica.polylines):
                self.assertEqual([[ring.tolist() for ring in each] for each in make(array).rings], [[quad]] * 3)
        for one in (FLAT, numpy.array(FLAT, "f4"), QUAD):
            self.assertTrue(vesica.polygons(one).single)
            self.assertEqual(vesica.polygons(one).rings[0][0].tolist(), quad)
        ragged = [QUAD, FLAT[:6], numpy.array(QUAD[:3]), [QUAD, QUAD]]
        of_objects = numpy.empty(4, object)
        of_objects[:] = ragged
        for array in (ragged, tuple(ragged), of_objects):
            made = vesica.polygons(array)
            self.assertEqual([len(rings) for rings in made.rings], [1, 1, 1, 2])
            self.assertEqual(made.rings[1][0].tolist(), quad[:3])
        for empty in ([], (), numpy.empty((0, 4, 2)), numpy.empty((0, 8))):
            self.assertEqual(len(vesica.polygons(empty)), 0)
        hole = [[0.25, 0.25], [0.5, 0.25], [0.5, 0.5], [0.25, 0.5]]
        for rings in ([[QUAD, hole]] * 3, numpy.array([[QUAD, hole]] * 3)):
            self.assertEqual(vesica.shape_area(vesica.polygons(rings)).tolist(), [0.9375] * 3)
        self.assertEqual(vesica.area(vesica.polygons([FLAT]), vesica.polygons([FLAT])).tolist(), [1])

    def test_what_is_none(self):
        shapes = "polygons have vertices of the shape (n, k, 2), ..., or rows x0 y0 x1 y1 x2 y2 ..., not "
        for given, words, error in (
            (None, "polygons is None, not an array of numbers", TypeError),
            ("POLYGON((0 0,1 0,1 1))", "polygons is 'POLYGON((0 0,1 0,1 1))', not an array of numbers", TypeError),
            ({"x": [1]}, "polygons is of the type dict, not an array of numbers", TypeError),
            (map(list, [QUAD]), "polygons is of the type map, not an array of numbers", TypeError),
            ([[None, None]], "polygons: row 0: row 0 is None, not numbers", TypeError),
            ([QUAD, None], "polygons: row 1 is of the type NoneType, not an array of vertices", TypeError),
            ([QUAD, "abc"], "polygons: row 1 is of the type str, not an array of vertices", TypeError),
            ([QUAD, {"x": 1}], "polygons: row 1 is of the type dict, not an array of vertices", TypeError),
            ([QUAD, [[0, 0], [1]]], "polygons: row 1: row 1 has 1 number..., row 0 has 2 numbers", ValueError),
            ([QUAD, [1, 2, 3]], "polygons: row 1: vertices have the shape (k, 2), not (3,)", ValueError),
            ([QUAD, []], "polygons: row 1: vertices have the shape (k, 2), not (0,)", ValueError),
            ([[QUAD, [[0, 0, 0]]]], "polygons: row 0, ring 1: vertices have the shape (k, 2), not (1, 3)", ValueError),
            (numpy.zeros((4, 3)), shapes + "(4, 3); leave out the third coordinate, as by [..., :2]", ValueError),
            (numpy.zeros((5, 4)), shapes + "(5, 4); boxes x0 y0 x1 y1 are vesica.aabbs, ...", ValueError),
            (numpy.zeros((0, 2)), "polygons: a polygon needs a vertex", ValueError),
            (RECTS, "polygons are rect shapes already, not an array of numbers", TypeError),
        ):
            self.says(words, vesica.polygons, given, error=error)
        words = "convex_hull takes the points (n, 2) of one shape, not an array of 2 shapes"
        self.says(words, vesica.convex_hull, [QUAD] * 2)


class OfArguments(Messages):
    def test_numbers(self):
        nms, soft, cast = vesica.nms, vesica.nms_soft, vesica.cast
        still = (0, 0, 0)
        for words, call, *arguments in (
            ("threshold is 1.5 (0 to 1)", nms, RECTS, [1, 2], 1.5),
            ("threshold is nan (0 to 1)", nms, RECTS, [1, 2], math.nan),
            ("parameter is -1.5 (0 to 1)", soft, RECTS, [1, 2], -1.5),
            ("distance is nan, not a number", vesica.within, BOX, DISC, math.nan),
            ("distance is nan, not a number", vesica.within_matrix, RECTS, DISC, math.nan),
            ("distance is nan, not a number", INDEX.join_within, None, math.nan),
            ("velocity is (nan, 1), not finite", cast, BOX, DISC, (math.nan, 1)),
            ("velocity is (vx, vy), not an array of shape (3,)", cast, BOX, DISC, (1, 2, 3)),
            ("t_end is -1 (0 or more)", cast, BOX, DISC, (1, 0), -1),
            ("t_end is -1 (0 or more)", cast, RECTS, DISC, (1, 0), -1),
            ("t_end is nan (0 or more)", vesica.cast_first, DISC, RECTS, (1, 0), math.nan),
            ("t_end is -1 (0 or more)", INDEX.cast, DISC, (1, 0), -1),
            ("t_end is -1 (0 or more)", vesica.sweep_bounds, BOX, (1, 0), -1),
            ("row 1 of velocity: it is (0, inf), not finite", cast, RECTS, DISC, [(0, 1), (0, math.inf)]),
            ("tolerance is 0 (above 0)", vesica.impact_time, BOX, still, DISC, still, 0),
            ("turn_b is (0, nan, 0), not finite", vesica.impact_time, BOX, still, DISC, (0, math.nan, 0), 1),
            ("the angle of turn_a is 2000000 (...)", vesica.impact_time, BOX, (0, 0, 2e6), DISC, still, 1),
            ("k is -1 (0 or more)", INDEX.nearest, DISC, -1),
            ("within is -1 (0 or more)", INDEX.nearest, DISC, 1, -1),
            ("parts is 0 (1 or more)", INDEX.join, None, "overlap", 0, 0),
            ("part is 2 (0 to 1)", INDEX.join, None, "overlap", 2, 2),
            ("rows is -1 (0 or more)", vesica.coverage, BOX, -1, 2),
            ("matrix is 'FF', not nine characters of F, 0, 1 and 2", vesica.de9im_match, "FF", "T********"),
        ):
            self.says(words, call, *arguments)
        self.says("k is 0 (1 or more)", INDEX.nearest_of_each, RECTS, k=0)
        self.says("within is -1 (0 or more)", INDEX.nearest_of_each, RECTS, within=-1)
        self.says("parameter is 0 (7.888609052210118e-31 to ...)", soft, RECTS, [1, 2], 0, decay="gaussian")
        self.says("least_score is -1 (0 or more)", soft, RECTS, [1, 2], least_score=-1)
        self.says("cell is 0 (above 0)", vesica.coverage, BOX, 1, 2, cell=0)
        self.says("origin is (x, y), not an array of shape (1,)", vesica.coverage, BOX, 1, 2, origin=(1,))
        self.says("cell is (width, height), not an array of shape (3,)", vesica.coverage, BOX, 1, 2, cell=(1, 1, 1))
        self.says("origin is (nan, 0), not finite", vesica.coverage, BOX, 1, 2, origin=(math.nan, 0))
        self.says(
            "query is 'touch', not one of overlap, bounds, contains, inside, interiors", INDEX.join, query="touch",
        )
        self.says("decay is 'box', not one of linear, gaussian", soft, RECTS, [1, 2], decay="box")
        self.says("ratio is 'iou', not one of vesica.Ratio: OVER_UNION, ..., COMPLETE", nms, RECTS, [1, 2], ratio="iou")
        self.says(
            "which is 'iou', not one of vesica.Ratio: OVER_UNION, ..., COMPLETE", vesica.ratio, "iou", RECTS, RECTS,
        )
        self.says("ratio is OVER_FIRST: of two boxes either may come first", nms, RECTS, [1, 2], ratio=Ratio.OVER_FIRST)

    def test_types(self):
        for words, call, *arguments in (
            ("threshold is '0.5', not a number", vesica.nms, RECTS, [1, 2], "0.5"),
            ("distance is of the type NoneType, not a number", vesica.within, BOX, DISC, None),
            ("k is 1.5, not a whole number", INDEX.nearest, DISC, 1.5),
            ("rows is 1.5, not a whole number", vesica.coverage, BOX, 1.5, 2),
            ("boxes is list: say which shapes it holds, ...", vesica.nms, [ROWS["rects"]], [1]),
            ("boxes are an array of shapes, not a single one", vesica.nms, BOX, [1]),
            ("other is of the type Shapes, not an index: vesica.Index(other) makes one", INDEX.join, RECTS),
            ("other is of the type int, not an index", INDEX.join_within, 2, None),
            ("shape is an array: the shares are those of a single shape, shape[i]", vesica.coverage, RECTS, 1, 2),
        ):
            self.says(words, call, *arguments, error=TypeError)
        texts = "labels are whole numbers: number texts by numpy.unique(labels, return_inverse=True)[1]"
        self.says(texts, vesica.nms, RECTS, [1, 2], labels=["car", "bus"], error=TypeError)
        objects = numpy.array(["car", "bus"], object)
        self.says(texts, vesica.nms, RECTS, [1, 2], labels=objects, error=TypeError)

    def test_parameters_are_rounded_before_they_are_compared(self):
        narrow = RECTS.astype("f4")
        self.assertEqual(vesica.nms(narrow, [1, 2], 1 + 1e-12).tolist(), [1, 0])
        self.says("threshold is 1.000000000001 (0 to 1)", vesica.nms, RECTS, [1, 2], 1 + 1e-12)
        self.says("tolerance is 1e-60 (above 0)", vesica.impact_time, narrow[0], (0, 0, 0), narrow[0], (0, 0, 0), 1e-60)
        self.says("velocity is (1e+300, 0), not finite", vesica.cast, narrow[0], narrow[0], (1e300, 0))


if __name__ == "__main__":
    unittest.main()
