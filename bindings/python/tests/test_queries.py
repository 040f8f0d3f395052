# SPDX-License-Identifier: Apache-2.0
"""Every question, every pair of kinds, both types: arrays say what single shapes say, and known answers are right."""
import fractions
import itertools
import math
import pathlib
import random
import struct
import threading
import unittest

import numpy
import vesica
from vesica import Kind, Ratio, Relation

QUERIES = ("overlap", "relation", "contains", "nearest", "boundary_distance", "depth", "area", "iou")
# Shapes with a radius about them: not all questions are for them.
ROUNDED = (Kind.CAPSULE, Kind.ROUND_RECT)
MATRICES = ("overlap", "relation", "contains", "area", "iou", "nearest", "boundary_distance", "depth")


def random_shapes(kind, count, generator, dtype):
    """Of sizes about 1, near enough to each other that half of them overlap."""
    x, y, w, h, angle = generator.uniform((-1, -1, 0.1, 0.1, 0), (1, 1, 1, 1, 2 * math.pi), (count, 5)).T
    columns = {
        Kind.POINT: (x, y),
        Kind.SEGMENT: (x, y, x + w * numpy.cos(angle), y + w * numpy.sin(angle)),
        Kind.CIRCLE: (x, y, w),
        Kind.AABB: (x, y, x + w, y + h),
        Kind.RECT: (x, y, numpy.cos(angle), numpy.sin(angle), w, h),
        Kind.ELLIPSE: (x, y, numpy.cos(angle), numpy.sin(angle), w, h),
        Kind.CAPSULE: (x, y, x + w * numpy.cos(angle), y + w * numpy.sin(angle), h / 4),
        Kind.ROUND_RECT: (x, y, numpy.cos(angle), numpy.sin(angle), w, h, h / 4),
    }[kind]
    return vesica.shapes(kind, numpy.column_stack(columns).astype(dtype))


def is_answered(name, kind_a, kind_b):
    """Whether a question is for two kinds."""
    if kind_a not in ROUNDED and kind_b not in ROUNDED:
        return name != "iou" or kind_a >= Kind.CIRCLE or kind_b >= Kind.CIRCLE  # else the union has no area
    return name not in ("area", "iou")


class Consistent(unittest.TestCase):
    def test_arrays_say_what_single_shapes_say(self):
        generator = numpy.random.default_rng(random.randrange(1 << 30))
        for kind_a, kind_b, dtype in itertools.product(vesica.FIELDS, vesica.FIELDS, ("f8", "f4")):
            a, b = (random_shapes(kind, 7, generator, dtype) for kind in (kind_a, kind_b))
            for name in QUERIES:
                if is_answered(name, kind_a, kind_b):
                    self.compare(name, a, b)
            for name in MATRICES:
                if not is_answered(name, kind_a, kind_b):
                    continue
                many, matrix = getattr(vesica, name), getattr(vesica, f"{name}_matrix")
                rows = matrix(a, b)
                for i in range(7):
                    row = many(a[i], b)
                    numpy.testing.assert_array_equal(rows[i], row[0] if isinstance(row, tuple) else row)
            if Kind.CIRCLE <= min(kind_a, kind_b) and max(kind_a, kind_b) <= Kind.ELLIPSE:
                self.compare_ratios(a, b)
            for i in range(7):
                selected = numpy.flatnonzero(vesica.overlap(a[i], b)).tolist()
                self.assertEqual(vesica.overlap_select(a[i], b).tolist(), selected)

    def compare(self, name, a, b):
        function = getattr(vesica, name)
        many = function(a, b)
        columns = many if isinstance(many, tuple) else (many,)
        for i in range(len(a)):
            one = function(a[i], b[i])
            for column, number in zip(columns, one if isinstance(one, tuple) else (one,)):
                self.assertEqual(column[i], number)
        out = tuple(numpy.empty_like(column) for column in columns)
        function(a, b, out=out if isinstance(many, tuple) else out[0])
        for column, given in zip(columns, out):
            numpy.testing.assert_array_equal(column, given)

    def compare_ratios(self, a, b):
        for which in Ratio:
            many, rows = vesica.ratio(which, a, b), vesica.ratio_matrix(which, a, b)
            for i in range(len(a)):
                self.assertEqual(vesica.ratio(which, a[i], b[i]), many[i])
                numpy.testing.assert_array_equal(rows[i], vesica.ratio(which, a[i], b))

    def test_threads(self):
        generator = numpy.random.default_rng(1)
        a, b = (random_shapes(Kind.RECT, 20_000, generator, "f8") for _ in range(2))
        expected, wrong = vesica.iou(a, b), []

        def work():
            if not (vesica.iou(a, b) == expected).all():
                wrong.append(1)

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])


class Known(unittest.TestCase):
    a, b = vesica.aabbs([0, 0, 2, 2]), vesica.aabbs([1, 1, 3, 3])
    inner, away = vesica.circles([1, 1, 0.5]), vesica.circles([6, 1, 1])

    def test_capsules_and_rounded_rectangles(self):
        capsules = vesica.shapes(Kind.CAPSULE, [[0, 0, 4, 0, 1], [0, 5, 4, 5, 1]])
        rounded = vesica.shapes(Kind.ROUND_RECT, [10, 0, 1, 0, 2, 1, 0.5])
        self.assertEqual(vesica.overlap(capsules, vesica.points([5, 0])).tolist(), [True, False])
        self.assertIs(vesica.overlap(capsules[0], vesica.points([5, numpy.nextafter(0, 1)])), False)
        self.assertEqual(vesica.nearest(capsules[0], rounded).distance, 2.5)
        self.assertIs(vesica.within(capsules[0], rounded, 2.5), vesica.Within.YES)
        self.assertEqual(vesica.bounds(rounded).numbers.tolist(), [7.5, -1.5, 12.5, 1.5])
        self.assertEqual(vesica.Index(capsules).select(vesica.points([5, 0])).tolist(), [0])
        self.assertEqual(vesica.area(capsules[0], rounded), 0)
        self.assertEqual(len(vesica.crossings(capsules[0], rounded).places), 0)
        self.assertIs(vesica.contains(rounded, vesica.ellipses([10, 0, 1, 1, 0])), True)
        touching = vesica.crossings(rounded, vesica.ellipses([10, 0, 1, 1.5, 0]))
        self.assertEqual(touching.places.tolist(), [[10, -1.5], [10, 1.5]])

    def test_single_shapes(self):
        self.assertIs(vesica.overlap(self.a, self.b), True)
        self.assertIs(vesica.overlap(self.a, self.away), False)
        self.assertIs(vesica.relation(self.a, self.b), Relation.CROSS)
        self.assertIs(vesica.contains(self.a, self.inner), True)
        self.assertEqual(vesica.area(self.a, self.b), 1)
        self.assertEqual(vesica.iou(self.a, self.b), 1 / 7)
        self.assertEqual(vesica.nearest(self.a, self.away), (3, 2, 1, 5, 1))
        self.assertEqual(vesica.boundary_distance(self.a, self.inner).distance, 0.5)
        self.assertEqual(vesica.depth(self.a, self.b).depth, 1)
        self.assertEqual(vesica.shape_area(self.a), 4)
        self.assertIs(type(vesica.shape_area(self.a.astype("f4"))), float)
        self.assertEqual(vesica.bounds(self.away).numbers.tolist(), [5, 0, 7, 2])

    def test_crossings(self):
        crossings = vesica.crossings(self.a, self.b)
        self.assertEqual(sorted(map(tuple, crossings.places)), [(1, 2), (2, 1)])
        self.assertFalse(crossings.shared)
        self.assertTrue(vesica.crossings(self.a, self.a).shared)
        self.assertEqual(vesica.crossings(self.a, self.away).places.shape, (0, 2))

    def test_arrays(self):
        both = vesica.aabbs([[0, 0, 2, 2], [1, 1, 3, 3]])
        self.assertEqual(vesica.iou_matrix(both, both).tolist(), [[1, 1 / 7], [1 / 7, 1]])
        self.assertEqual(vesica.shape_area(both).tolist(), [4, 4])
        self.assertEqual(vesica.bounds(both).numbers.tolist(), both.numbers.tolist())
        self.assertEqual(vesica.relation(both, self.a).tolist(), [Relation.EQUAL, Relation.CROSS])
        out = numpy.empty((2, 5))
        vesica.area_matrix(both, both, out=out[:, :2])
        self.assertEqual(out[:, :2].tolist(), [[4, 1], [1, 4]])

    def test_suppression(self):
        boxes = vesica.rects([[0, 0, 2, 2, 0], [0.1, 0, 2, 2, 1], [5, 0, 2, 2, 2]], degrees=True)
        self.assertEqual(vesica.nms(boxes, [0.5, 0.9, 0.1], 0.5).tolist(), [1, 2])
        self.assertEqual(vesica.nms(boxes, [0.5, 0.9, 0.1], 1).tolist(), [1, 0, 2])
        self.assertEqual(vesica.nms(boxes[:0], [], 0.5).tolist(), [])
        with self.assertRaises(vesica.VesicaError):
            vesica.nms(boxes, [1, 2, 3], 1.5)
        with self.assertRaises(vesica.VesicaError):
            vesica.nms(vesica.points([[1, 2]]), [1])


    def test_suppression_by_labels(self):
        boxes = vesica.aabbs([[0, 0, 4, 4], [0, 0, 2, 2], [0, 0, 4, 3], [9, 9, 10, 10]])
        scores = [4, 3, 2, 1]
        self.assertEqual(vesica.nms(boxes, scores).tolist(), [0, 1, 3])
        self.assertEqual(vesica.nms(boxes, scores, ratio=Ratio.OVER_SMALLER).tolist(), [0, 3])
        self.assertEqual(vesica.nms(boxes, scores, labels=[0, 0, 7, 0]).tolist(), [0, 1, 2, 3])
        self.assertEqual(vesica.nms(boxes, scores, least_score=2).tolist(), [0, 1])
        self.assertEqual(vesica.nms(boxes, scores, most=1).tolist(), [0])
        with self.assertRaisesRegex(TypeError, "labels"):
            vesica.nms(boxes, scores, labels=[0.5, 1, 2, 3])
        with self.assertRaisesRegex(ValueError, "4 boxes need as many labels"):
            vesica.nms(boxes, scores, labels=[0, 1])
        for ratio in (Ratio.OVER_FIRST, Ratio.OVER_SECOND):
            with self.assertRaises(vesica.VesicaError):
                vesica.nms(boxes, scores, ratio=ratio)

    def test_how_many_are_kept(self):
        boxes = vesica.aabbs([[i, 0, i + 0.5, 1] for i in range(4)])
        for call in (vesica.nms, lambda *given, **how: vesica.nms_soft(*given, **how)[0]):
            for most, kept in ((0, 0), (3, 3), (4, 4), (2**70, 4), (2**64 + 1, 4), (numpy.uint8(2), 2)):
                self.assertEqual(len(call(boxes, [4, 3, 2, 1], most=most)), kept)
            for most in (-1, -(2**63), -(2**64) + 4, -(2**70)):
                with self.assertRaisesRegex(vesica.VesicaError, f"most is {most} .0 or more.") as caught:
                    call(boxes, [4, 3, 2, 1], most=most)
                self.assertEqual(caught.exception.code, vesica._declarations.E_ARGUMENT)

    def test_labels_of_any_size(self):
        boxes = vesica.aabbs([[0, 0, 2, 2]] * 3)
        unlike = (
            ([1, 2**32 + 1, 2**33 + 1], [0, 1, 2]),
            ([-(2**31), 2**31, -(2**31)], [0, 1]),
            (numpy.array([2**64 - 1, 2**32 - 1, 2**64 - 1], "u8"), [0, 1]),
            (numpy.array([7, 0, 7, 0, 8, 0], "i2")[::2], [0, 2]),
            ([True, False, True], [0, 1]),
        )
        for labels, kept in unlike:
            self.assertEqual(vesica.nms(boxes, [0.9, 0.8, 0.7], labels=labels).tolist(), kept)
            soft = vesica.nms_soft(boxes, [0.9, 0.8, 0.7], 0.1, labels=labels, least_score=0.5)
            self.assertEqual(soft[0].tolist(), kept)
        self.assertEqual(vesica.nms(boxes[:0], [], labels=[]).tolist(), [])
        for wrong in ([1.0, 2, 3], ["1", "2", "3"], [2**64, 0, 1], [None, 1, 2], [1j, 2, 3]):
            for call in (vesica.nms, vesica.nms_soft):
                with self.assertRaisesRegex(TypeError, "labels"):
                    call(boxes, [3, 2, 1], labels=wrong)
        with self.assertRaisesRegex(ValueError, "labels: .*masked"):
            vesica.nms(boxes, [3, 2, 1], labels=numpy.ma.masked_equal([1, 2, 3], 2))

    def test_scores_keep_their_order(self):
        boxes = vesica.aabbs([[0, 0, 2, 2]] * 2)
        narrow, scores = boxes.astype("f4"), numpy.array([0.9, 0.9 + 1e-12])
        self.assertEqual(vesica.nms(boxes, scores).tolist(), [1])
        for unequal in (scores, [2**24, 2**24 + 1], [0.0, 1e300]):
            self.assertEqual(vesica.nms(narrow, unequal).tolist(), [1])
            self.assertEqual(vesica.nms(narrow, unequal, least_score=unequal[1]).tolist(), [1])
            self.assertEqual(vesica.nms(narrow, unequal[::-1]).tolist(), [0])
            self.assertEqual(vesica.nms(narrow, unequal, 1, least_score=unequal[1]).tolist(), [1])
            self.assertEqual(len(vesica.nms_soft(narrow, unequal)[0]), 2)
        self.assertEqual(vesica.nms(boxes, [2**53, 2**53 + 1]).tolist(), [1])
        self.assertEqual(vesica.nms(narrow, scores, least_score=2).tolist(), [])
        with self.assertRaises(vesica.VesicaError):
            vesica.nms(narrow, [0.9, numpy.nan])
        for call in (vesica.nms, vesica.nms_soft):
            for wrong in (["1", "2"], [1j, 2], [None, 1]):
                with self.assertRaisesRegex(TypeError, "scores"):
                    call(boxes, wrong)
            with self.assertRaisesRegex(ValueError, "scores: .*masked"):
                call(boxes, numpy.ma.masked_equal([1.0, 2], 1))
        from_float32 = numpy.array([0.1, 0.9], "f4").tolist()
        for exact in ([0.25, 0.5], [1, 2], from_float32, numpy.array([1, 2], "f2"), [False, True]):
            self.assertEqual(vesica.nms(narrow, exact).tolist(), [1])
        with self.assertRaises(TypeError):
            vesica.nms(boxes, scores, most=0.9)

    def test_least_scores_are_compared_as_they_are(self):
        wide = vesica.aabbs([[i, 0, i + 0.5, 1] for i in range(2)])
        tenth, large = float(numpy.float32(0.1)), 2**53
        # The number of boxes kept: each for itself, so it is that of the scores that are not below the least.
        for scores, least in (
            ([tenth, 0.75], tenth + 5e-10),
            ([tenth, 0.75], tenth - 5e-10),
            (numpy.array([tenth, 0.75], "f4"), tenth + 5e-10),
            ([large + 3, large + 1], large + 4),
            ([large + 3, large + 1], float(large + 4)),
            ([large + 3, large + 1], large + 3),
            ([float(large), float(large + 2)], large + 1),
            ([float(large), 2.0], numpy.int64(large + 1)),
            (numpy.array([2**64 - 1, 2**64 - 2], "u8"), 2**64 - 1),
            (numpy.array([2**64 - 1, 0], "u8"), -1),
            ([1, 2], 2**70),
            ([1, 2], -(2**70)),
            ([1, 2], 1e300),
            ([1, 2], fractions.Fraction(3, 2)),
            ([1, 2], math.inf),
            ([1, math.inf], math.inf),
            ([-math.inf, 2], -math.inf),
            ([True, False], 0.1),
            ([1, 2], numpy.array(2.0)),
        ):
            kept = sum(not score < numpy.asarray(least).item() for score in numpy.asarray(scores).tolist())
            for boxes in (wide, wide.astype("f4")):
                self.assertEqual(len(vesica.nms(boxes, scores, least_score=least)), kept, (scores, least))
        for boxes in (wide, wide.astype("f4")):
            for scores in ([1, 2], [0.1, 1e-50], [large + 3, large + 1]):
                with self.assertRaisesRegex(vesica.VesicaError, "least_score is nan, not a number"):
                    vesica.nms(boxes, scores, least_score=math.nan)
            with self.assertRaisesRegex(TypeError, "least_score is of the type str, not a number"):
                vesica.nms(boxes, [1, 2], least_score="1")

    def test_scores_that_are_not_aligned(self):
        boxes, bytes_of_scores = vesica.aabbs([[0, 0, 2, 2]] * 2), numpy.zeros(17, numpy.uint8)
        scores = bytes_of_scores[1:].view("f8")
        scores[:] = 1, 2
        self.assertEqual(vesica.nms(boxes, scores).tolist(), [1])

    def test_results_of_refused_arguments(self):
        boxes = vesica.aabbs([[0, 0, 2, 2], [1, 1, 3, 3]])
        points = vesica.points([[0, 0], [1, 1]])
        for call in (
            lambda: vesica.within(boxes, boxes, math.nan),
            lambda: vesica.within_matrix(boxes, boxes, math.nan),
            lambda: vesica.nms(boxes, [1, 2], threshold=5),
            lambda: vesica.nms_soft(boxes, [1, 2], least_score=-1),
            lambda: vesica.overlap_select(boxes, boxes),
        ):
            with self.assertRaises(vesica.VesicaError) as caught:
                call()
            self.assertIsNone(caught.exception.result)
        for call in (vesica.iou, vesica.iou_matrix, lambda a, b: vesica.ratio(Ratio.OVER_UNION, a, b),
                     lambda a, b: vesica.ratio_matrix(Ratio.OVER_UNION, a, b)):
            with self.assertRaises(vesica.VesicaError) as caught:
                call(points, points)
            self.assertTrue(numpy.isnan(caught.exception.result).all())

    def test_ratios(self):
        wanted = [1 / 7, 1 / 4, 1 / 4, 1 / 4, 1 / 7 - 2 / 9, 1 / 7 - 1 / 9, 1 / 7 - 1 / 9]
        for which, number in zip(Ratio, wanted):
            self.assertAlmostEqual(vesica.ratio(which, self.a, self.b), number, 15)
        flat = vesica.aabbs([0, 0, 0, 2])
        self.assertEqual(vesica.ratio(Ratio.OVER_SECOND, flat, self.a), 0)
        with self.assertRaises(vesica.VesicaError):
            vesica.ratio(Ratio.OVER_FIRST, flat, self.a)
        with self.assertRaises(ValueError):
            vesica.ratio(7, self.a, self.b)

    def test_corners(self):
        rects = vesica.rects([[10, 20, 6, 4, 90], [0, 0, 2, 2, 0]], degrees=True)
        turned = [[12, 17], [12, 23], [8, 23], [8, 17]]
        self.assertEqual(vesica.corners(rects).tolist(), [turned, [[-1, -1], [1, -1], [1, 1], [-1, 1]]])
        self.assertEqual(vesica.corners(rects[0]).tolist(), turned)
        with self.assertRaises(vesica.VesicaError):
            vesica.corners(self.away)

    def test_matrices_of_distances(self):
        both = vesica.aabbs([[0, 0, 2, 2], [1, 1, 3, 3]])
        apart = vesica.circles([[6, 1, 1], [1, 1, 0.5]])
        self.assertEqual(vesica.nearest_matrix(both, apart).tolist(), [[3, 0], [2, 0]])
        self.assertEqual(vesica.boundary_distance_matrix(both, apart)[0].tolist(), [3, 0.5])
        self.assertEqual(vesica.depth_matrix(both, both).tolist(), [[2, 1], [1, 2]])


class Vectors(unittest.TestCase):
    """The calls that every host of the library answers: contact to the last place, both types, errors."""

    def test_shared_vectors(self):
        path = pathlib.Path(__file__).with_name("vectors.txt")
        calls = 0
        for line, text in enumerate(path.read_text().splitlines(), 1):
            if text.startswith("#"):
                continue
            what, expected, *words = text.split()
            dtype = "f4" if what == "f32" else "f8"
            shapes = []
            for at in (0, 7):
                numbers = struct.unpack(">6d", bytes.fromhex("".join(words[at + 1 : at + 7])))
                kind = int(words[at])
                if 0 <= kind < len(vesica.FIELDS):
                    numbers = numbers[: len(vesica.FIELDS[Kind(kind)])]
                    shapes.append(vesica.shapes(kind, numpy.array(numbers, dtype)))
            if len(shapes) < 2:
                continue  # an unknown kind: there are no such shapes here
            try:
                answer = int(vesica.overlap(*shapes))
            except vesica.VesicaError as error:
                answer = error.code
            self.assertEqual(answer, int(expected), f"line {line}")
            calls += 1
        self.assertGreater(calls, 150)


class Documented(unittest.TestCase):
    def test_every_c_function_has_its_text(self):
        from vesica import _declarations

        for name in _declarations.FUNCTIONS:
            self.assertTrue(getattr(vesica.c, name).__doc__.startswith(f"{name}("))

    def test_every_name_has_a_text(self):
        for name in vesica.__all__:
            self.assertTrue(getattr(vesica, name).__doc__, name)


class OwnMemory(unittest.TestCase):
    """Few results of a large array keep no more memory alive than their own."""

    def test_results(self):
        discs = vesica.circles(numpy.column_stack([10 * numpy.arange(1000.0), numpy.zeros(1000), numpy.ones(1000)]))
        probe, index = vesica.circles([50, 0, 1]), vesica.Index(discs)
        same = vesica.circles(numpy.ones((1000, 3)))
        wrong = vesica.circles([[0, 0, 1], [0, 0, -1]])[numpy.arange(1000) % 2]
        with self.assertRaises(vesica.VesicaError) as caught:
            vesica.overlap_select(vesica.points([0, 0]), wrong)
        results = [
            vesica.overlap_select(probe, discs),
            vesica.interiors_overlap_select(probe, discs),
            vesica.nms(same, numpy.arange(1000)),
            *vesica.nms_soft(same, numpy.arange(1000), 0.5, least_score=998.5),
            vesica.crossings(discs[0], vesica.circles([1, 0, 1])).places,
            vesica.intersection(vesica.aabbs([0, 0, 2, 2]), vesica.aabbs([1, 1, 3, 3])),
            vesica.convex_hull(numpy.arange(2000.0).reshape(1000, 2)),
            *index.nearest(probe, 1000, within=1),
            *index.join(vesica.Index(probe)),
            *index.join_within(vesica.Index(probe), 0),
            index.select(probe),
            index.cast(probe, (0, 1)),
            vesica.Index(wrong[1:3], probe).order(),
        ]
        self.assertEqual([len(result) for result in results], [1] * 5 + [2, 4, 2] + [1] * 8 + [2])
        for result in (*results, caught.exception.result):
            self.assertLessEqual(getattr(result.base, "nbytes", 0), result.nbytes)


if __name__ == "__main__":
    unittest.main()
