# SPDX-License-Identifier: Apache-2.0
"""Threads change no bit: results, their order and errors are those of one thread."""
import math
import unittest
from unittest import mock

import numpy
import vesica
from vesica import Gaussian, Kind, Ratio, _threads

from test_queries import random_shapes

THREADS = (2, 3, 7)


def outcome(call, threads):
    """What a call gives, or raises, as bytes and texts that can be compared."""
    try:
        return plainly(call(threads))
    except vesica.VesicaError as error:
        return error.code, str(error), plainly(error.result)


def plainly(given):
    if isinstance(given, vesica.Shapes):
        return given.numbers.tobytes()
    if isinstance(given, tuple):
        return tuple(map(plainly, given))
    return (given.dtype.str, given.shape, given.tobytes()) if isinstance(given, numpy.ndarray) else given


def drawn(kind, count, dtype, wrong=()):
    """Shapes of which some are invalid, in columns, so that parts of them do not lie side by side."""
    numbers = random_shapes(kind, count, numpy.random.default_rng(kind), dtype).numbers
    for i in wrong:
        numbers[i, -1] = math.nan
    return vesica.shapes(kind, numpy.asfortranarray(numbers))


class Threads(unittest.TestCase):
    def setUp(self):
        patch = mock.patch.object(_threads, "LEAST", 500)
        patch.start()
        self.addCleanup(patch.stop)

    def same(self, call, *about, fails=False):
        one = outcome(call, 1)
        failed = isinstance(one, tuple) and isinstance(one[0], int)
        self.assertEqual(failed, fails, about)
        for threads in THREADS:
            with mock.patch.object(_threads, "Thread", wraps=_threads.Thread) as thread:
                self.assertEqual(outcome(call, threads), one, (about, threads))
            thread.assert_called()

    def test_pairs(self):
        n = 8 * 1024 + 331
        for dtype in ("f8", "f4"):
            for wrong in ((), (0,), (5, n // 2, n - 1)):
                a, b = drawn(Kind.RECT, n, dtype, wrong), drawn(Kind.ELLIPSE, n, dtype)
                names = ["overlap", "interiors_overlap", "relation", "contains", "nearest", "boundary_distance"]
                names += ["depth", "signed_distance", "area"]
                for name in names if dtype == "f4" or wrong else names[:3]:
                    call = getattr(vesica, name)
                    self.same(lambda threads: call(a, b, threads=threads), name, wrong, fails=bool(wrong))
                self.same(lambda threads: vesica.within(a[::-1], b, 0.5, threads=threads), wrong, fails=bool(wrong))
                self.same(lambda threads: vesica.overlap(a, b[7], threads=threads), "one", wrong, fails=bool(wrong))
                self.same(lambda threads: vesica.overlap(b[7:8], a, threads=threads), "one", wrong, fails=bool(wrong))

    def test_outputs(self):
        n = 5003
        a, b, room = drawn(Kind.CIRCLE, n, "f8"), drawn(Kind.AABB, n, "f8"), numpy.zeros((n, 5))
        expected = vesica.nearest(a, b, threads=1)
        columns = [numpy.empty(n) for _ in expected]
        vesica.nearest(a, b, columns, threads=3)
        for column, values in zip(columns, expected):
            numpy.testing.assert_array_equal(column, values)
        vesica.iou_matrix(a, b[:3], room[:, 1:4], threads=3)
        numpy.testing.assert_array_equal(room[:, 1:4], vesica.iou_matrix(a, b[:3], threads=1))
        self.assertFalse(room[:, [0, 4]].any())

    def test_errors_of_several_kinds(self):
        n = 4 * 1024
        numbers = numpy.tile([0.0, 0, 1, 1], (n, 1))
        numbers[10] = numbers[3000] = 0  # nothing to divide by
        boxes = vesica.aabbs(numbers)
        self.same(lambda threads: vesica.iou(boxes, boxes, threads=threads), fails=True)
        self.same(lambda threads: vesica.ratio(Ratio.GENERALIZED, boxes, boxes, threads=threads), fails=True)
        numbers[2000, 0] = 2  # invalid
        self.same(lambda threads: vesica.iou(boxes, boxes, threads=threads), fails=True)
        self.assertEqual(outcome(lambda threads: vesica.iou(boxes, boxes, threads=threads), 3)[0], -2)
        discs = drawn(Kind.CIRCLE, n, "f8")
        self.same(lambda threads: vesica.gaussian_distance(Gaussian.WASSERSTEIN, discs, discs, threads=threads))
        concave = vesica.polygons([[0, 0], [4, 0], [1, 1], [0, 4]])
        self.same(lambda threads: vesica.depth(concave, discs, threads=threads), fails=True)

    def test_matrices(self):
        for rows, columns in ((1031, 7), (7, 1031), (1, 2001), (67, 61)):
            a, b = drawn(Kind.RECT, rows, "f8", [rows // 2]), drawn(Kind.CIRCLE, columns, "f8")
            for name in ("overlap", "iou", "nearest", "relation"):
                call = getattr(vesica, f"{name}_matrix")
                self.same(lambda threads: call(a, b, threads=threads), name, rows, fails=True)
            if columns > 50:
                self.same(lambda threads: vesica.within_matrix(b, b, 0.1, threads=threads), rows)

    def test_manifolds_and_volumes(self):
        for wrong in ((), (3, 4000)):
            a, b = drawn(Kind.RECT, 5003, "f8", wrong), drawn(Kind.RECT, 5003, "f8")[::-1]
            self.same(lambda threads: vesica.manifold(a, b, threads=threads), wrong, fails=bool(wrong))
            spans = numpy.sort(numpy.random.default_rng(6).random((5003, 2)), axis=1)
            for of_b, spans_b in ((b, spans[::-1]), (b[1], spans[1])):
                call = lambda threads: vesica.volume_ratio(Ratio.OVER_UNION, a, spans, of_b, spans_b, threads=threads)
                self.same(call, wrong, fails=bool(wrong))
        for rows, columns in ((1031, 7), (7, 1031)):
            sides = a[5 : 5 + rows], spans[5 : 5 + rows], b[:columns], spans[:columns]
            self.same(lambda threads: vesica.volume_ratio_matrix(Ratio.OVER_SMALLER, *sides, threads=threads), rows)

    def test_selections(self):
        for wrong in ((), (3, 4000)):
            many = drawn(Kind.CIRCLE, 5003, "f4", wrong)
            for call in (vesica.overlap_select, vesica.interiors_overlap_select):
                self.same(lambda threads: call(many[1], many, threads=threads), wrong, fails=bool(wrong))

    def test_one_shape(self):
        for wrong in ((), (3, 4000)):
            rects = drawn(Kind.RECT, 5003, "f8", wrong)
            for call in (vesica.bounds, vesica.corners, vesica.shape_area):
                self.same(lambda threads: call(rects, threads=threads), call.__name__, fails=bool(wrong))
            self.same(lambda threads: vesica.boxes(rects, threads=threads), fails=bool(wrong))
            rows = numpy.random.default_rng(4).random((5003, 6)) * [1, 1, 1, 1, 6, 0.1] + [0, 0, 0.2, 0.2, 0, 0]
            rows[list(wrong), 2] = -1
            for call in (vesica.rects, vesica.ellipses, vesica.ellipses_in_boxes):
                self.same(lambda threads: call(rows[::-1, :5], threads=threads), call.__name__, fails=bool(wrong))
            self.same(lambda threads: vesica.round_rects(rows, threads=threads), fails=bool(wrong))
            corners = vesica.corners(drawn(Kind.RECT, 5003, "f4"))
            corners[list(wrong), 1] = corners[list(wrong), 2] + 9
            self.same(lambda threads: vesica.rects_from_corners(corners, threads=threads), fails=bool(wrong))
            if not wrong:
                near = vesica.rects_from_corners(corners)
                self.same(lambda threads: vesica.rect_corners_misfit(corners[:, ::-1], near, threads=threads))
        quads = numpy.random.default_rng(3).random((3001, 4, 2))
        for call in (vesica.min_area_rects, vesica.min_perimeter_rects):
            self.same(lambda threads: call(quads, threads=threads))

    def test_paths(self):
        quads = vesica.polygons(vesica.corners(drawn(Kind.RECT, 3001, "f8")))
        corners = [[0, 0], [1, 0], [1, 1], [0, 1]]
        rings = vesica.polygons([corners[: 3 + i % 2] for i in range(2001)])
        discs = drawn(Kind.CIRCLE, 3001, "f8")
        self.same(lambda threads: vesica.overlap(quads, discs, threads=threads))
        self.same(lambda threads: vesica.area(rings[::-1], discs[:2001], threads=threads))
        self.same(lambda threads: vesica.contains(rings[5], discs, threads=threads))
        self.same(lambda threads: vesica.bounds(rings, threads=threads))

    def test_casts(self):
        n = 5003
        a, b = drawn(Kind.RECT, n, "f8"), drawn(Kind.CIRCLE, n, "f8")
        velocities = numpy.asfortranarray(numpy.random.default_rng(1).random((n, 2)))
        self.same(lambda threads: vesica.cast(a, b, velocities, 3, threads=threads))
        self.same(lambda threads: vesica.cast(a, b[0], (1, 0), threads=threads))
        velocities[[7, 4999]] = math.inf
        self.same(lambda threads: vesica.cast(a, b, velocities, 3, threads=threads), fails=True)

    def test_suppression(self):
        draw, n = numpy.random.default_rng(9), 1033
        patch = mock.patch.object(vesica.queries, "_BOXES_A_GROUP", 150)
        patch.start()
        self.addCleanup(patch.stop)
        for wrong in ((), (3, 690)):
            for dtype in ("f8", "f4"):
                boxes = drawn(Kind.RECT, n, dtype, wrong)
                scores = draw.integers(0, 40, n) / 64  # many are equal
                for labels in (draw.integers(0, 97, n), draw.integers(0, 3, n) << 20, -draw.integers(1, 9, n)):
                    for how in ({}, {"most": 50}, {"threshold": 0.9}, {"least_score": 0.1 + 1e-13}):
                        call = lambda threads: vesica.nms(boxes, scores, labels=labels, threads=threads, **how)
                        self.same(call, dtype, how, fails=bool(wrong))
                        grouped = outcome(call, 1)
                        with mock.patch.object(vesica.queries, "_BOXES_A_GROUP", n):
                            self.assertEqual(outcome(call, 1), grouped, (dtype, how))
                    for how in ({"most": 50}, {"decay": "gaussian", "least_score": 0.1}) if dtype == "f8" else ():
                        call = lambda threads: vesica.nms_soft(boxes, scores, labels=labels, threads=threads, **how)
                        self.same(call, dtype, how, fails=bool(wrong))
                        grouped = outcome(call, 1)
                        with mock.patch.object(vesica.queries, "_BOXES_A_GROUP", n):
                            self.assertEqual(outcome(call, 1), grouped, (dtype, how))
            if not wrong:
                quads = vesica.polygons(vesica.corners(boxes))
                self.same(lambda threads: vesica.nms(quads, scores, labels=labels, threads=threads))
        scores[[7, 644]] = math.nan
        self.same(lambda threads: vesica.nms(boxes, scores, labels=labels, threads=threads), fails=True)

    def test_indexes(self):
        for dtype in ("f8", "f4"):
            for wrong in ((), (3, 4000)):
                sets = drawn(Kind.RECT, 5003, dtype, wrong), drawn(Kind.CIRCLE, 2999, dtype)
                spread = [vesica.shapes(each.kind, each.numbers + 0) for each in sets]
                for each in spread:
                    moves = numpy.random.default_rng(2).uniform(-90, 90, (len(each), 2)).astype(dtype)
                    each.columns[0][:] += moves[:, 0]
                    each.columns[1][:] += moves[:, 1]
                one = vesica.Index(*spread, threads=1)
                for threads in THREADS:
                    index = vesica.Index(*spread, threads=threads)
                    numpy.testing.assert_array_equal(index.bytes, one.bytes)
                    self.assertEqual(index.incomplete, bool(wrong))
                other = vesica.Index(spread[1][::2])
                for query in ("overlap", "contains", "interiors", "bounds"):
                    self.same(lambda threads: one.join(other, query, threads=threads), query)
                    self.same(lambda threads: one.join(None, query, threads=threads), query)
                    self.same(lambda threads: one.join_count(other, query, threads=threads), query)
                self.same(lambda threads: one.join_within(other, 0.5, threads=threads))
                self.same(lambda threads: one.join_within(None, -0.1, threads=threads))
                self.same(lambda threads: one.join_ratio(None, Ratio.OVER_SMALLER, 0.1, threads=threads))
                self.same(lambda threads: one.nearest_of_each(*spread, k=3, threads=threads), fails=bool(wrong))

    def test_without_threads(self):
        for started in (0, 1):
            starts = [None] * started + [RuntimeError("can't start new thread")]
            with mock.patch.object(_threads.Thread, "start", side_effect=starts):
                self.assertEqual(_threads.in_order(lambda part: part, range(9), 7), list(range(9)))

    def test_exceptions_are_those_of_the_first_part(self):
        def fail(part):
            if part in (2, 5):
                raise ValueError(f"part {part}")
            return part

        for threads in (1, *THREADS):
            self.assertEqual(_threads.in_order(fail, [0, 1, 3, 4], threads), [0, 1, 3, 4])
            with self.assertRaisesRegex(ValueError, "part 2"):
                _threads.in_order(fail, range(8), threads)


class Counts(unittest.TestCase):
    def test_up_to_a_hundred_thousand_answers_are_those_of_one_thread(self):
        discs = vesica.circles(numpy.ones((100_001, 3)))
        with mock.patch.object(_threads, "Thread", side_effect=OSError("a thread")):
            vesica.overlap(discs[1:], discs[0])
            vesica.overlap(discs, discs[0], threads=1)
            vesica.overlap_matrix(discs[:100], discs[:1000], threads=2)
            vesica.Index(discs[1:]), vesica.Index(discs, threads=1)
            with mock.patch.object(_threads, "available", return_value=2):
                for call in (lambda: vesica.overlap(discs, discs[0]), lambda: vesica.Index(discs)):
                    with self.assertRaisesRegex(OSError, "a thread"):
                        call()
            with mock.patch.object(_threads, "available", return_value=1):
                vesica.overlap(discs, discs[0])

    def test_that_processors_are_counted(self):
        self.assertGreaterEqual(_threads.available(), 1)
        with mock.patch.object(_threads.os, "sched_getaffinity", create=True, return_value={1, 5}):
            self.assertEqual(_threads.available(), 2)

    def test_how_many_work(self):
        with mock.patch.object(_threads, "available", return_value=64):
            counts = [_threads.count_of(None, n) for n in (0, 100_000, 100_001, 150_000, 10**6, 10**7)]
            self.assertEqual(counts, [1, 1, 2, 3, 20, 64])
            self.assertEqual([_threads.count_of(n, 10**6) for n in (1, 2, 64, 2000)], [1, 2, 64, 977])

    def test_ranges(self):
        for count, threads in ((100_001, 1), (100_001, 2), (100_001, 7), (1024, 3), (3 * 1024 + 1, 2)):
            spans = _threads.ranges(count, threads)
            self.assertEqual((spans[0][0], spans[-1][1]), (0, count))
            self.assertEqual([end for _, end in spans[:-1]], [begin for begin, _ in spans[1:]])
            self.assertTrue(all(begin % 1024 == 0 and begin < end for begin, end in spans))

    def test_refused(self):
        discs = vesica.circles(numpy.ones((4, 3)))
        for wrong, error in ((0, vesica.VesicaError), (-1, vesica.VesicaError), (1.5, TypeError), ("2", TypeError)):
            for call in (lambda n: vesica.overlap(discs, discs, threads=n), lambda n: vesica.Index(discs, threads=n)):
                with self.assertRaisesRegex(error, "threads is"):
                    call(wrong)
        with self.assertRaisesRegex(ValueError, "threads is 2: threads divide a whole join, not a part of 4"):
            vesica.Index(discs).join(part=1, parts=4, threads=2)


if __name__ == "__main__":
    unittest.main()
