# SPDX-License-Identifier: Apache-2.0
"""What arrays are taken, that they are taken where they lie, and what is said of others."""
import math
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

    def test_invalid_rows(self):
        with self.assertRaisesRegex(vesica.VesicaError, "1 invalid rows, the first is number 1") as caught:
            vesica.rects([[1, 2, 6, 4, 0], [1, 2, -6, 4, 0]])
        self.assertEqual(caught.exception.result[0].numbers.tolist(), [1, 2, 1, 0, 3, 2])
        with self.assertRaises(vesica.VesicaError):
            vesica.boxes(vesica.points([[1, 2]]))

    def test_corners(self):
        corners = [[0, 0], [2, 0], [2, 1], [0, 1]]
        self.assertEqual(vesica.rects_from_corners(corners).numbers.tolist(), [1, 0.5, 1, 0, 1, 0.5])
        self.assertEqual(len(vesica.rects_from_corners([corners] * 3)), 3)
        with self.assertRaisesRegex(ValueError, r"\(n, 4, 2\)"):
            vesica.rects_from_corners([0] * 8)
        with self.assertRaisesRegex(vesica.VesicaError, "rect 1"):
            vesica.rects_from_corners([corners, [[math.nan, 0]] * 4])

    def test_covariance(self):
        ellipse = vesica.ellipses_from_covariance([1, 2], [[9, 0], [0, 4]], 2)
        self.assertEqual(ellipse.numbers.tolist(), [1, 2, 1, 0, 6, 4])
        many = vesica.ellipses_from_covariance([[1, 2], [3, 4]], [[[9, 0], [0, 4]]] * 2)
        self.assertEqual(many.numbers[1].tolist(), [3, 4, 1, 0, 3, 2])
        with self.assertRaisesRegex(ValueError, "symmetric"):
            vesica.ellipses_from_covariance([1, 2], [[9, 1], [0, 4]])
        with self.assertRaises(vesica.VesicaError):
            vesica.ellipses_from_covariance([1, 2], [[1, 5], [5, 1]])


class Refused(unittest.TestCase):
    def refused(self, error, words, call, *arguments, **named):
        with self.assertRaisesRegex(error, words):
            call(*arguments, **named)

    def test_arrays(self):
        self.refused(ValueError, "6 numbers each .cx cy ux uy hx hy.*not .7,", vesica.shapes, Kind.RECT, [1] * 7)
        self.refused(ValueError, "5 numbers each .x y width height angle", vesica.rects, [[1, 2, 3, 4]])
        self.refused(ValueError, "not .1, 2, 3", vesica.circles, [[[1, 2, 3], [4, 5, 6]]])
        self.refused(TypeError, "float64 or float32 numbers, not <U1", vesica.points, ["a", "b"])
        self.refused(TypeError, "not float16", vesica.points, numpy.zeros(2, "f2"))
        self.refused(TypeError, "not complex128", vesica.points, numpy.zeros(2, complex))
        self.refused(ValueError, "missing: r", vesica.shapes, Kind.CIRCLE, numpy.zeros(2, [("cx", "f8"), ("cy", "f8")]))
        mixed = numpy.zeros(2, [("cx", "f8"), ("cy", "f4"), ("r", "f8")])
        self.refused(TypeError, "all float64 or all float32", vesica.shapes, Kind.CIRCLE, mixed)
        self.refused(ValueError, "7", vesica.shapes, 7, [1, 2])

    def test_operands(self):
        discs = vesica.circles([[0, 0, 1]] * 3)
        self.refused(TypeError, "a is list: say which shapes it holds", vesica.overlap, [1, 2, 3], discs)
        self.refused(TypeError, "b is ndarray", vesica.overlap, discs, numpy.zeros((3, 3)))
        self.refused(TypeError, "float64 numbers and b float32", vesica.overlap, discs, discs.astype("f4"))
        self.refused(ValueError, "a has 3 shapes and b 2", vesica.overlap, discs, discs[:2])

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

    def test_invalid_shapes(self):
        discs = vesica.circles([[0, 0, 1], [0, 0, -1], [1, 1, 1], [math.nan, 0, 1]])
        with self.assertRaisesRegex(vesica.VesicaError, "2 invalid shapes in a, the first is number 1") as caught:
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
        with self.assertRaisesRegex(vesica.VesicaError, "negative"):
            vesica.check(discs[1])
        vesica.check(discs[0])


if __name__ == "__main__":
    unittest.main()
