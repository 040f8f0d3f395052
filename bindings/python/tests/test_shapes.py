# SPDX-License-Identifier: Apache-2.0
"""What arrays are taken, that they are taken where they lie, and what is said of others."""
import copy
import math
import pickle
import tracemalloc
import unittest

import numpy
import vesica
from vesica import Kind

RECTS = numpy.array([[0, 0, 0.8, 0.6, 2, 1], [5, 1, 1, 0, 1, 3], [9, 9, 0.6, 0.8, 4, 1]])
DISC = vesica.circles([4, 1, 1.5])


class Layouts(unittest.TestCase):
    def check(self, shapes):
        self.assertEqual(vesica.overlap(shapes, DISC.astype(shapes.dtype)).tolist(), [False, True, False])
        numpy.testing.assert_array_equal(shapes.numbers, RECTS.astype(shapes.dtype))

    def test_rows_columns_strides(self):
        wide = numpy.full((3, 9), numpy.nan)
        wide[:, 2:8] = RECTS
        every_second = numpy.repeat(RECTS, 2, axis=0)[::2]
        for array in (RECTS, numpy.asfortranarray(RECTS), wide[:, 2:8], every_second, RECTS[::-1].copy()[::-1]):
            self.check(vesica.shapes(Kind.RECT, array))

    def test_float32_big_endian_and_lists(self):
        self.check(vesica.shapes(Kind.RECT, RECTS.astype("f4")))
        self.check(vesica.shapes(Kind.RECT, RECTS.astype(">f8")))
        self.check(vesica.shapes(Kind.RECT, RECTS.tolist()))

    def test_structured(self):
        records = numpy.zeros(3, [("id", "i4"), *((name, "f8") for name in vesica.FIELDS[Kind.RECT]), ("more", "f4")])
        for name, column in zip(vesica.FIELDS[Kind.RECT], RECTS.T):
            records[name] = column
        self.check(vesica.shapes(Kind.RECT, records))
        self.check(vesica.shapes(Kind.RECT, records[::-1].copy()[::-1]))
        one = vesica.shapes(Kind.RECT, records[1])
        self.assertTrue(one.single and vesica.overlap(one, DISC))

    def test_read_only(self):
        array = RECTS.copy()
        array.flags.writeable = False
        self.check(vesica.shapes(Kind.RECT, array))

    def test_changes_of_the_array_are_seen(self):
        array = RECTS.copy()
        shapes = vesica.shapes(Kind.RECT, array)
        array[0, 0] = 4
        self.assertTrue(vesica.overlap(shapes, DISC)[0])

    def test_single_shapes_see_changes_too(self):
        point, points = vesica.points([50.0, 0]), vesica.points([[50.0, 0]])
        names = vesica.FIELDS[Kind.CIRCLE]
        padded = {"names": names, "formats": ["f8"] * 3, "offsets": [1, 12, 30], "itemsize": 40}
        records, odd = numpy.zeros(3, [(name, "f8") for name in names]), numpy.zeros(3, padded)
        rows, columns, wide = numpy.zeros((3, 3)), numpy.zeros((3, 3), order="F"), numpy.zeros((3, 6))
        makers = {
            "a row": (vesica.circles(rows[1]), lambda x: rows.__setitem__((1, 0), x)),
            "of rows": (vesica.circles(rows)[1], lambda x: rows.__setitem__((1, 0), x)),
            "of columns": (vesica.circles(columns)[1], lambda x: columns.__setitem__((1, 0), x)),
            "with gaps": (vesica.circles(wide[::-1, ::-2])[1], lambda x: wide.__setitem__((1, 5), x)),
            "a record": (vesica.shapes(Kind.CIRCLE, records[1]), lambda x: records["cx"].__setitem__(1, x)),
            "unaligned": (vesica.shapes(Kind.CIRCLE, odd)[1], lambda x: odd["cx"].__setitem__(1, x)),
        }
        for name, (disc, move) in makers.items():
            for x in (0, 50, 49, 50):
                move(x)
                self.assertIs(vesica.overlap(disc, point), x == 50, name)
                self.assertEqual(vesica.overlap(disc, points).tolist(), [x == 50], name)
                self.assertEqual(vesica.nearest(disc, point).ax, x, name)
                self.assertIn(f"cx={x},", repr(disc))
            move(0)

    def test_single_shapes_of_float32_columns(self):
        rects = vesica.shapes(Kind.RECT, numpy.asfortranarray(RECTS, "f4"))
        self.assertEqual([vesica.overlap(rect, DISC.astype("f4")) for rect in rects], [False, True, False])

    def test_no_copy(self):
        array = numpy.zeros((200_000, 6))
        array[:, 2] = 1
        out = numpy.empty(len(array), bool)
        tracemalloc.start()
        vesica.overlap(vesica.shapes(Kind.RECT, array[:, :]), DISC, out=out)
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        self.assertLess(peak, 100_000)

    def test_indexing(self):
        shapes = vesica.shapes(Kind.RECT, RECTS)
        self.assertEqual(len(shapes), 3)
        self.assertTrue(vesica.overlap(shapes[1], DISC) and vesica.overlap(shapes[-2], DISC))
        self.assertEqual(vesica.overlap(shapes[1:], DISC).tolist(), [True, False])
        self.assertEqual(vesica.overlap(shapes[[False, True, True]], DISC).tolist(), [True, False])
        self.assertEqual([vesica.overlap(shape, DISC) for shape in shapes], [False, True, False])
        for index in (3, -4):
            with self.assertRaises(IndexError):
                shapes[index]
        with self.assertRaises(TypeError):
            len(shapes[0])

    def test_numbers_as_indexes(self):
        shapes = vesica.shapes(Kind.RECT, RECTS)
        for index in (1, numpy.int8(1), numpy.uint64(1), numpy.array(1), numpy.array(-2), (1,), (numpy.int64(-2),)):
            self.assertTrue(shapes[index].single)
            self.assertIs(vesica.overlap(shapes[index], DISC), True)
        for index in (numpy.array([2, 1]), ([2, 1],), numpy.nonzero([False, True, True]), ..., ()):
            self.assertIn(True, vesica.overlap(shapes[index], DISC).tolist())
        with self.assertRaisesRegex(IndexError, "shape 3 of 3"):
            shapes[numpy.array(3)]

    def test_indexes_of_other_dimensions(self):
        shapes = vesica.shapes(Kind.RECT, RECTS)
        for index in (numpy.array([[0, 1], [2, 0]]), [[0, 1]], None, (..., None), (..., 0), numpy.array(True)):
            with self.assertRaisesRegex(ValueError, "one dimension, not the shape"):
                shapes[index]
        for index in (True, numpy.True_, numpy.False_):
            with self.assertRaisesRegex(TypeError, "a bool is not the number"):
                shapes[index]

    def test_empty(self):
        empty = vesica.circles([])
        self.assertEqual(len(empty), 0)
        self.assertEqual(vesica.overlap(empty, DISC).shape, (0,))
        self.assertEqual(vesica.overlap_matrix(empty, DISC).shape, (0, 1))
        self.assertEqual(vesica.overlap(vesica.circles(numpy.empty((0, 3))), DISC).shape, (0,))


class Constructors(unittest.TestCase):
    def test_degrees_are_exact_at_quarter_turns(self):
        angles = (0, 90, 180, 270, 360, -90, 450, 36000090)
        turns = vesica.rects([[0, 0, 4, 2, angle] for angle in angles], degrees=True)
        axes = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 0), (0, -1), (0, 1), (0, 1)]
        self.assertEqual([tuple(row) for row in turns.numbers[:, 2:4]], axes)
        self.assertTrue(vesica.overlap(turns[1], vesica.points([-1, 2])))

    def test_degrees_and_radians(self):
        angles = numpy.linspace(-720, 720, 1001)
        rows = numpy.column_stack([numpy.zeros((1001, 2)), numpy.ones((1001, 2)), angles])
        by_degrees = vesica.rects(rows, degrees=True).numbers
        for (_, _, ux, uy, *_), angle in zip(by_degrees, angles):
            self.assertAlmostEqual(ux, math.cos(math.radians(angle)), delta=1e-14)
            self.assertAlmostEqual(uy, math.sin(math.radians(angle)), delta=1e-14)

    def test_sizes(self):
        self.assertEqual(vesica.rects([1, 2, 6, 4, 0]).numbers.tolist(), [1, 2, 1, 0, 3, 2])
        self.assertEqual(vesica.ellipses([1, 2, 6, 4, 0]).numbers.tolist(), [1, 2, 1, 0, 6, 4])
        self.assertEqual(vesica.rects(numpy.zeros((2, 5), "f4")).dtype, numpy.float32)

    def test_units_and_senses(self):
        rows = [[1, 2, 6, 4, 90], [3, 4, 5, 2, -30]]
        by_degrees = vesica.rects(rows, degrees=True).numbers
        turned = numpy.array(rows)
        turned[:, 4] *= -1
        self.assertEqual(vesica.rects(turned, degrees=True, reverse=True).numbers.tolist(), by_degrees.tolist())
        self.assertEqual(vesica.rects([1, 2, 6, 4, 1], quarters=True).numbers.tolist(), by_degrees[0].tolist())
        self.assertEqual(vesica.ellipses([1, 2, 3, 2, 1], quarters=True).numbers.tolist(), by_degrees[0].tolist())
        self.assertEqual(vesica.ellipses_in_boxes(rows, True).numbers.tolist(), by_degrees.tolist())
        self.assertEqual(vesica.boxes(vesica.rects(rows, True), True)[0].tolist(), rows[0])
        back = vesica.boxes(vesica.rects(rows, True)[0], quarters=True, reverse=True)
        self.assertEqual(back.tolist(), [1, 2, 6, 4, -1])
        every_other = numpy.repeat(numpy.array(rows, "f8"), 2, axis=0)[::2, ::-1][:, ::-1]
        self.assertEqual(vesica.rects(every_other, True).numbers.tolist(), by_degrees.tolist())
        with self.assertRaisesRegex(ValueError, "not both"):
            vesica.rects(rows, degrees=True, quarters=True)
        huge = 1.7e308
        self.assertEqual(vesica.ellipses([0, 0, huge, 1, 0]).numbers.tolist(), [0, 0, 1, 0, huge, 1])

    def test_half_axes_that_cannot_be_halved(self):
        for dtype, least in (("f8", 5e-324), ("f4", 1e-45)):
            a, b = numpy.array([least, 7 * least], dtype)
            for row in ([0, 0, a, 1, 0], [0, 0, 1, b, 0], [0, 0, b, a, 0], [0, 0, a, 0, 0]):
                made = vesica.ellipses(numpy.array([row], dtype)).numbers[0].tolist()
                self.assertEqual(made, [0, 0, 1, 0, float(row[2]), float(row[3])])
        rows = numpy.array([[1, 2, 3, 5e-324, 0], [0, 0, -1, 1, 0], [0, 0, math.nan, 1, 0], [0, 0, 1, math.inf, 0]])
        with self.assertRaisesRegex(vesica.VesicaError, "row 1: a is -1 .the first of 3 invalid rows") as caught:
            vesica.ellipses(rows)
        self.assertEqual(caught.exception.result[0].numbers.tolist(), [1, 2, 1, 0, 3, 5e-324])
        self.assertEqual(rows[0, 2], 3)

    def test_invalid_rows(self):
        with self.assertRaisesRegex(vesica.VesicaError, "^row 1: width is -6$") as caught:
            vesica.rects([[1, 2, 6, 4, 0], [1, 2, -6, 4, 0]])
        self.assertEqual(caught.exception.result[0].numbers.tolist(), [1, 2, 1, 0, 3, 2])
        with self.assertRaises(vesica.VesicaError):
            vesica.boxes(vesica.points([[1, 2]]))

    def test_capsules_and_rounded_rectangles(self):
        self.assertEqual(vesica.capsules([1, 2, 3, 4, 5]).numbers.tolist(), [1, 2, 3, 4, 5])
        self.assertIs(vesica.capsules([[1, 2, 3, 4, 5]]).kind, vesica.Kind.CAPSULE)
        upright = [1, 2, 6, 4, 90, 1]
        self.assertEqual(vesica.round_rects(upright, degrees=True).numbers.tolist(), [1, 2, 0, 1, 2, 1, 1])
        self.assertEqual(vesica.round_rects([]).numbers.shape, (0, 7))
        functions = vesica.c.vesica_round_rect_from_angle_f64, vesica.c.vesica_round_rect_from_angle_f32
        for letter, function in zip("df", functions):
            row = numpy.array([1, 2, 6.1, 4.3, 0.7, 0.3], letter)
            made = numpy.empty(7, letter)
            x, y, width, height, angle, radius = row.tolist()
            self.assertEqual(function(x, y, angle, width, height, radius, made.ctypes.data), 0)
            self.assertEqual(vesica.round_rects(row).numbers.tolist(), made.tolist())
            self.assertEqual(vesica.round_rects(row).dtype, made.dtype)

    def test_rounded_rectangles_with_a_wrong_radius(self):
        rows = [[1, 2, 6, 4, 0, 2], [1, 2, 6, 4, 0, 2.1], [1, 2, 6, 4, 0, -1], [1, 2, -6, -4, 0, -9]]
        rows += [[1, 2, 6, 4, 0, math.nan], [1, 2, 6, 4, 0, math.inf], [1, 2, math.inf, 4, 0, math.inf]]
        with self.assertRaisesRegex(vesica.VesicaError, "row 1: radius is 2.1, above half of height, 4 .the first of 6") as caught:
            vesica.round_rects(rows)
        self.assertEqual(caught.exception.result[0].numbers.tolist(), [1, 2, 1, 0, 1, 0, 2])
        self.assertTrue(numpy.isnan(caught.exception.result.numbers[1:]).all())
        self.assertEqual(rows[0][2], 6)

    def test_corners(self):
        corners = [[0, 0], [2, 0], [2, 1], [0, 1]]
        self.assertEqual(vesica.rects_from_corners(corners).numbers.tolist(), [1, 0.5, 1, 0, 1, 0.5])
        self.assertEqual(len(vesica.rects_from_corners([corners] * 3)), 3)
        self.assertEqual(len(vesica.rects_from_corners([])), 0)
        flat = [0, 0, 2, 0, 2, 1, 0, 1]
        for one in (flat, numpy.array(flat, "f4"), numpy.repeat(numpy.array(flat), 2)[::2]):
            self.assertEqual(vesica.rects_from_corners(one).numbers.tolist(), [1, 0.5, 1, 0, 1, 0.5])
        rows = numpy.array([flat] * 3)
        for many in (rows, numpy.asfortranarray(rows), rows.tolist(), rows.reshape(3, 4, 2)[::-1], rows.astype("f4")):
            self.assertEqual(vesica.rects_from_corners(many).numbers.tolist(), [[1, 0.5, 1, 0, 1, 0.5]] * 3)
        with self.assertRaisesRegex(ValueError, r"\(n, 4, 2\), .*not \(6,\)"):
            vesica.rects_from_corners([0] * 6)
        with self.assertRaisesRegex(vesica.VesicaError, r"^row 1: corner 0 is \(nan, 0\)$"):
            vesica.rects_from_corners([corners, [[math.nan, 0]] * 4])
        rows_of_a_table = [[0, 0], [2, 0], [0, 1], [2, 1]]
        with self.assertRaisesRegex(vesica.VesicaError, "^row 1: corners are crossed") as caught:
            vesica.rects_from_corners([corners, rows_of_a_table])
        self.assertEqual(caught.exception.result[0].numbers.tolist(), [1, 0.5, 1, 0, 1, 0.5])
        self.assertEqual(caught.exception.result.invalid().tolist(), [1])
        self.assertEqual(caught.exception.code, vesica._declarations.E_SHAPE)

    def test_misfit_of_corners(self):
        skewed = [[0, 0], [4, 0], [5, 1], [1, 1]]
        rect = vesica.rects_from_corners(skewed)
        misfit = vesica.rect_corners_misfit(skewed, rect)
        self.assertEqual((type(misfit), misfit), (float, 0.5))
        square = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
        both = vesica.rects_from_corners(numpy.array([skewed, square], "f4"))
        misfits = vesica.rect_corners_misfit(numpy.array([skewed, square], "f4"), both)
        self.assertEqual((misfits.dtype, misfits.tolist()), (numpy.float32, [0.5, 0]))
        self.assertEqual(vesica.rect_corners_misfit([], both.astype("f8")[:0]).tolist(), [])

    def test_covariance(self):
        ellipse = vesica.ellipses_from_covariance([1, 2], [[9, 0], [0, 4]], 2)
        self.assertEqual(ellipse.numbers.tolist(), [1, 2, 1, 0, 6, 4])
        many = vesica.ellipses_from_covariance([[1, 2], [3, 4]], [[[9, 0], [0, 4]]] * 2)
        self.assertEqual(many.numbers[1].tolist(), [3, 4, 1, 0, 3, 2])
        with self.assertRaisesRegex(ValueError, "symmetric"):
            vesica.ellipses_from_covariance([1, 2], [[9, 1], [0, 4]])
        with self.assertRaises(vesica.VesicaError):
            vesica.ellipses_from_covariance([1, 2], [[1, 5], [5, 1]])

    def test_covariances_of_both_types(self):
        means, matrix = numpy.array([1, 2], "f4"), numpy.diag([0.01, 0.04])
        mixed, wide = (vesica.ellipses_from_covariance(m, matrix, 2) for m in (means, means.astype("f8")))
        self.assertEqual((mixed.dtype, mixed.numbers.tolist()), (numpy.float64, wide.numbers.tolist()))
        self.assertEqual(vesica.ellipses_from_covariance(means, matrix.astype("f4")).dtype, numpy.float32)

    def test_covariances_that_are_not_numbers(self):
        for nan in ((0, 0), (0, 1), (1, 0), (1, 1), slice(None)):
            matrix = numpy.eye(2)
            matrix[nan] = math.nan
            kept = matrix.copy()
            with self.assertRaisesRegex(vesica.VesicaError, "^c.. is nan") as caught:
                vesica.ellipses_from_covariance([1, 2], matrix)
            self.assertEqual(caught.exception.code, vesica._declarations.E_NOT_FINITE)
            numpy.testing.assert_array_equal(matrix, kept)


class Refused(unittest.TestCase):
    def refused(self, error, words, call, *arguments, **named):
        with self.assertRaisesRegex(error, words):
            call(*arguments, **named)

    def test_misfit_of_corners(self):
        square, rect = [[-1, -1], [1, -1], [1, 1], [-1, 1]], vesica.rects([0, 0, 2, 2, 0])
        of = vesica.rect_corners_misfit
        self.refused(TypeError, "corners are float64 and rect float32", of, square, rect.astype("f4"))
        self.refused(ValueError, "corners are of 2 rectangles, and rect has 1", of, [square] * 2, rect)
        self.refused(ValueError, r"\(n, 4, 2\)", of, [0] * 6, rect)
        self.refused(TypeError, "say which shapes", of, square, square)
        self.refused(vesica.VesicaError, "circle shapes, not rectangles", of, square, vesica.circles([0, 0, 1]))
        negative = vesica.shapes(Kind.RECT, [0, 0, 1, 0, 1, -1])
        self.refused(vesica.VesicaError, "^rect: hy is -1$", of, square, negative)

    def test_arrays(self):
        self.refused(ValueError, "6 numbers each .cx cy ux uy hx hy.*not .7,", vesica.shapes, Kind.RECT, [1] * 7)
        self.refused(ValueError, "5 numbers each .x y width height angle", vesica.rects, [[1, 2, 3, 4]])
        self.refused(ValueError, "not .1, 2, 3", vesica.circles, [[[1, 2, 3], [4, 5, 6]]])
        self.refused(TypeError, "points: row 0 is 'a', not numbers", vesica.points, ["a", "b"])
        self.refused(TypeError, "not float16", vesica.points, numpy.zeros(2, "f2"))
        self.refused(TypeError, "not complex128", vesica.points, numpy.zeros(2, complex))
        self.refused(ValueError, "missing: r", vesica.shapes, Kind.CIRCLE, numpy.zeros(2, [("cx", "f8"), ("cy", "f8")]))
        mixed = numpy.zeros(2, [("cx", "f8"), ("cy", "f4"), ("r", "f8")])
        self.refused(TypeError, "all float64 or all float32", vesica.shapes, Kind.CIRCLE, mixed)
        self.refused(ValueError, "7", vesica.shapes, 7, [1, 2])

    def test_arrays_of_other_dimensions(self):
        square = numpy.zeros((2, 2), [("x", "f8"), ("y", "f8")])
        pairs = numpy.zeros(2, [("x", "f8", (2,)), ("y", "f8", (2,))])
        for array in (square, pairs, pairs[0]):
            self.refused(ValueError, "one dimension, not the shape .*2", vesica.shapes, Kind.POINT, array)

    def test_numbers_that_would_be_rounded(self):
        for wrong in ([2**53 + 1, 0], [-(2**53) - 1, 0], [2**63 - 1, 0], numpy.array([2**64 - 1, 0], "u8")):
            self.refused(ValueError, "above 2..53", vesica.points, wrong)
        for right in ([2**53, 0], [-(2**63), 2**62], numpy.array([2**63, 2**60 + 2**9], "u8"), [True, False]):
            self.assertEqual([int(x) for x in vesica.points(right).numbers], [int(x) for x in right])
        for wrong in (
            [2**53 + 1, 0.5],
            [0.5, -(2**53) - 1],
            [[1, 2], (2**53 + 1, 0.5)],
            [[0.5, 1], numpy.array([2**53 + 1, 1])],
            [numpy.int64(2**53 + 1), 0.5],
            [2**63 + 1, -1],
        ):
            self.refused(ValueError, "above 2..53", vesica.points, wrong)
        self.refused(ValueError, "scores: .*above 2..53", vesica.nms, vesica.circles([[0, 0, 1]] * 2), [2**53 + 1, 0.5])
        for right in ([2**53, 0.5], [2**53 + 2, 1e300], [2.0**60, 0.5], [2**70 + 0.0, math.inf], [math.nan, 2**53]):
            numpy.testing.assert_array_equal(vesica.points(right).numbers, right)
        points = vesica.points([0.5, 2])
        for dtype in (int, "f2", complex, bool, "U9"):
            self.refused(TypeError, "float64 or float32", points.astype, dtype)
        self.assertEqual(points.astype(">f4").numbers.tolist(), [0.5, 2])

    def test_masks(self):
        hidden = numpy.ma.masked_greater(numpy.array([[0.0, 9], [1, 2]]), 5)
        self.refused(ValueError, "masked", vesica.points, hidden)
        self.refused(ValueError, "masked", vesica.rects_from_corners, numpy.ma.masked_less(numpy.zeros((4, 2)), 1))
        self.assertEqual(vesica.points(hidden[1]).numbers.tolist(), [1, 2])
        for listed in (list(hidden), tuple(hidden), list(hidden[0]), [[1, 2], hidden[0]], [[0.0, numpy.ma.masked]]):
            self.refused(ValueError, "masked", vesica.points, listed)
        self.refused(ValueError, "masked", vesica.rects_from_corners, [[hidden[0]] * 4, [hidden[1]] * 4])
        self.assertEqual(vesica.points([hidden[1], [3, 4]]).numbers.tolist(), [[1, 2], [3, 4]])
        records = numpy.ma.zeros(2, [("x", "f8"), ("y", "f8"), ("z", "f8")])
        records["z"][1] = numpy.ma.masked
        self.assertEqual(len(vesica.shapes(Kind.POINT, records)), 2)
        records["y"][1] = numpy.ma.masked
        self.refused(ValueError, "masked", vesica.shapes, Kind.POINT, records)

    def test_construction_and_attributes(self):
        x = numpy.zeros(2)
        for columns in ([x], [x, x[:1]], [x, x.astype("f4")], [x, x[::-1]], [x, numpy.zeros((2, 2))], []):
            self.refused(TypeError, "made by points", vesica.Shapes, Kind.POINT, columns)
        discs = vesica.circles([[0, 0, 1]] * 3)
        self.refused(TypeError, "made by points", discs.__init__, Kind.RECT, discs.columns)
        for shape in (discs, discs[0]):
            for name in ("kind", "single", "dtype", "columns", "letter", "view", "record", "other"):
                self.refused(AttributeError, f"{name} of shapes cannot be changed", setattr, shape, name, Kind.RECT)
                self.refused(AttributeError, f"{name} of shapes cannot be deleted", delattr, shape, name)
            self.assertIsInstance(shape.columns, tuple)

    def test_operands(self):
        discs = vesica.circles([[0, 0, 1]] * 3)
        self.refused(TypeError, "a is list: say which shapes it holds", vesica.overlap, [1, 2, 3], discs)
        self.refused(TypeError, "b is ndarray", vesica.overlap, discs, numpy.zeros((3, 3)))
        self.refused(TypeError, "float64 numbers and b float32", vesica.overlap, discs, discs.astype("f4"))
        self.refused(ValueError, "a has 3 shapes and b 2", vesica.overlap, discs, discs[:2])
        self.refused(ValueError, "a has 3 shapes and b 0", vesica.overlap, discs, discs[:0])
        self.refused(ValueError, "a has 0 shapes and b 3", vesica.cast, discs[:0], discs, (1, 0))

    def test_single_shapes(self):
        discs = vesica.circles([[0, 0, 1]] * 3)
        index, of_three = vesica.Index(discs), "has 3 shapes, not a single one"
        self.refused(vesica.VesicaError, f"one {of_three}", vesica.overlap_select, discs, discs[:0])
        self.refused(vesica.VesicaError, "one has 0 shapes", vesica.overlap_select, discs[:0], discs)
        self.refused(vesica.VesicaError, f"one {of_three}", vesica.cast_first, discs, discs, (1, 0))
        self.refused(vesica.VesicaError, f"shape {of_three}", index.select, discs)
        self.refused(vesica.VesicaError, f"shape {of_three}", index.nearest, discs)
        self.refused(vesica.VesicaError, f"shape {of_three}", index.cast, discs, (1, 0))
        self.refused(vesica.VesicaError, f"shape {of_three}", index.cast_first, discs, (1, 0))
        self.assertEqual(vesica.overlap_select(discs[:1], discs).tolist(), [0, 1, 2])

    def test_kinds(self):
        points, discs = vesica.points([[0, 0]]), vesica.circles([[0, 0, 1]])
        for call, arguments in (
            (vesica.corners, [points]),
            (vesica.boxes, [points]),
            (vesica.nms, [points, [1]]),
            (vesica.nms_soft, [points, [1]]),
        ):
            self.refused(vesica.VesicaError, "^not for point shapes$", call, *arguments)
        self.refused(vesica.VesicaError, "^not for circle shapes$", vesica.intersection, discs[0], discs[0])
        quad = vesica.polygons([[0, 0], [1, 0], [1, 1]])
        self.refused(vesica.VesicaError, "^not for circle and polygon shapes$", vesica.intersection, discs[0], quad)

    def test_outputs(self):
        discs = vesica.circles(numpy.ones((3, 3)))
        frozen = numpy.zeros(3, bool)
        frozen.flags.writeable = False
        rows = numpy.ones((3, 3))
        self.refused(TypeError, "out must be an array of bool or uint8", vesica.overlap, discs, discs, numpy.zeros(3))
        self.refused(TypeError, "of float64, not float32", vesica.iou, discs, discs, numpy.zeros(3, "f4"))
        self.refused(TypeError, "not list", vesica.iou, discs, discs, [0, 0, 0])
        self.refused(ValueError, "shape .3,., not .4,", vesica.overlap, discs, discs, numpy.zeros(4, bool))
        self.refused(ValueError, "cannot be written", vesica.overlap, discs, discs, frozen)
        self.refused(ValueError, "contiguous", vesica.overlap, discs, discs, numpy.zeros(6, bool)[::2])
        self.refused(ValueError, "overlaps an input", vesica.area, vesica.circles(rows), discs, rows.ravel()[:3])
        self.refused(ValueError, "distance ax ay bx by", vesica.nearest, discs, discs, [None] * 4)
        self.refused(TypeError, "no out", vesica.overlap, discs[0], discs[0], numpy.zeros(1, bool))
        self.refused(TypeError, "two single shapes", vesica.crossings, discs, discs)
        self.refused(ValueError, "3 boxes need as many scores", vesica.nms, discs, [1, 2])

    def test_outputs_that_lie_wrong(self):
        discs = vesica.circles(numpy.ones((3, 3)))
        unaligned = numpy.zeros(25, numpy.uint8)[1:].view("f8")
        self.refused(ValueError, "aligned", vesica.iou, discs, discs, unaligned)
        room = numpy.zeros(20)
        one, other = room[:3], room[2:5]
        for out in ((one, one, None, None, None), (None, one, None, None, other), (other, None, None, one, None)):
            self.refused(ValueError, "two arrays of out overlap", vesica.nearest, discs, discs, out)
        vesica.nearest(discs, discs, [room[i : i + 3] for i in (12, 0, 3, 9, 6)])
        rows = numpy.lib.stride_tricks.as_strided(room, (3, 3), (16, 8))
        self.refused(ValueError, "rows of out overlap", vesica.iou_matrix, discs, discs, rows)
        wide = numpy.zeros((3, 5))
        for column in (wide[:, ::2][:, :1], numpy.zeros((3, 1), order="F"), wide[::-1, 4:]):
            vesica.iou_matrix(discs, discs[:1], column)
            self.assertEqual(column.tolist(), [[1], [1], [1]])
        room[:] = 0
        vesica.iou(discs[:1], discs[:1], room[::3][:1])
        self.assertEqual((room[0], room[1:].any()), (1, False))

    def test_copies_of_shapes(self):
        rects = vesica.shapes(Kind.RECT, RECTS)
        for shape in (rects, rects[1], rects[:0], rects[::-2], rects.astype("f4")):
            for again in (pickle.loads(pickle.dumps(shape)), copy.copy(shape), copy.deepcopy(shape)):
                about = [(each.kind, each.single, each.dtype, each.numbers.tolist()) for each in (shape, again)]
                self.assertEqual(*about)
                self.assertFalse(numpy.may_share_memory(again.columns[0], shape.columns[0]))

    def test_copies_of_errors(self):
        with self.assertRaises(vesica.VesicaError) as caught:
            vesica.rects([[1, 2, -6, 4, 0]])
        error = caught.exception
        for again in (pickle.loads(pickle.dumps(error)), copy.copy(error), copy.deepcopy(error)):
            self.assertIs(type(again), vesica.VesicaError)
            self.assertEqual((again.code, str(again), again.result), (error.code, str(error), None))

    def test_invalid_shapes(self):
        discs = vesica.circles([[0, 0, 1], [0, 0, -1], [1, 1, 1], [math.nan, 0, 1]])
        with self.assertRaisesRegex(vesica.VesicaError, "^row 1 of a: r is -1 .the first of 2 invalid rows.$") as caught:
            vesica.overlap(discs, DISC)
        self.assertEqual(caught.exception.code, -2)
        self.assertEqual(discs.invalid().tolist(), [1, 3])
        with self.assertRaises(vesica.VesicaError) as caught:
            vesica.overlap_matrix(discs, discs)
        self.assertEqual(caught.exception.result[0].tolist(), [True, False, True, False])
        with self.assertRaises(vesica.VesicaError) as caught:
            vesica.overlap_select(discs[0], discs)
        self.assertEqual(caught.exception.result.tolist(), [0, 2])
        with self.assertRaises(vesica.VesicaError) as caught:
            vesica.area(discs, discs)
        self.assertTrue(numpy.isnan(caught.exception.result[[1, 3]]).all())
        with self.assertRaises(vesica.VesicaError) as caught:
            vesica.nms(discs, [1, 2, 3, 4], 0.5)
        self.assertEqual(caught.exception.result.tolist(), [2, 0])
        for call in (vesica.nms, vesica.nms_soft):
            with self.assertRaisesRegex(vesica.VesicaError, "^row 1 of scores: it is NaN .the first of 2 invalid rows.$"):
                call(discs[[0, 2, 0]], [1, math.nan, math.nan])
            with self.assertRaisesRegex(vesica.VesicaError, "^row 1 of boxes: r is -1; row 0 of scores: it is NaN$"):
                call(discs[:2], [math.nan, 1])
        with self.assertRaisesRegex(vesica.VesicaError, "^r is -1$"):
            vesica.check(discs[1])
        vesica.check(discs[0])


if __name__ == "__main__":
    unittest.main()
