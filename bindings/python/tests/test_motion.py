# SPDX-License-Identifier: Apache-2.0
"""Casts by numbers that are known, and what is refused."""
import math
import unittest

import numpy
import vesica
from vesica import Cast

WALL = vesica.aabbs([10, -5, 12, 5])
DISC = vesica.circles([0, 0, 1])
WALLS = vesica.aabbs([[20, -5, 22, 5], [10, -5, 12, 5], [10, -1, 11, 1]])


class Motion(unittest.TestCase):
    def test_one(self):
        found, impact = vesica.cast(WALL, DISC, (3, 0))
        self.assertIs(found, Cast.HIT)
        self.assertEqual(impact, (3, 10, 0, -1, 0))
        found, impact = vesica.cast(WALL, DISC, (3, 0), 2.5)
        self.assertIs(found, Cast.MISS)
        self.assertEqual(impact.t, math.inf)
        self.assertTrue(math.isnan(impact.x))
        self.assertIs(vesica.cast(WALL, vesica.points([11, 0]), (1, 0))[0], Cast.START)

    def test_arrays(self):
        self.assertEqual(vesica.cast(WALLS, DISC, (2, 0)).t.tolist(), [9.5, 4.5, 4.5])
        velocities = numpy.array([[1, 0, 9], [-1, 0, 9], [2, 0, 9]], "f8")[:, :2]
        self.assertEqual(vesica.cast(WALLS, DISC, velocities).t.tolist(), [19, math.inf, 4.5])
        out = [numpy.empty(3) for _ in range(5)]
        self.assertEqual(vesica.cast(WALLS, DISC, (2, 0), 5, out).t.tolist(), [math.inf, 4.5, 4.5])
        self.assertEqual(out[0].tolist(), [math.inf, 4.5, 4.5])
        self.assertEqual(vesica.cast(WALLS.astype("f4"), DISC.astype("f4"), (2, 0)).t.dtype, numpy.float32)
        with self.assertRaises(vesica.VesicaError) as caught:
            vesica.cast(WALLS, DISC, [[1, 0], [math.nan, 0], [1, 0]])
        self.assertEqual(caught.exception.result.t[[0, 2]].tolist(), [19, 9])
        self.assertTrue(math.isnan(caught.exception.result.t[1]))

    def test_outputs_apart_from_velocities(self):
        numbers = numpy.ones((3, 7), order="F")
        columns = list(numbers.T)
        for wrong in (columns[1:6], columns[:5]):
            with self.assertRaisesRegex(ValueError, "out overlaps an input"):
                vesica.cast(WALLS, DISC, numbers[:, :2], out=wrong)
        one = numpy.array([2.0, 0])
        with self.assertRaisesRegex(ValueError, "out overlaps an input"):
            vesica.cast(WALL, vesica.circles([[0, 0, 1]]), one, out=[one[:1], None, None, None, None])
        self.assertEqual(vesica.cast(WALLS, DISC, numbers[:, :2] * [2, 0], out=columns[2:]).t.tolist(), [9.5, 4.5, 4.5])

    def test_velocities_that_are_not_numbers(self):
        hidden = numpy.ma.masked_equal([1.0, 0], 1)
        for error, wrong in ((ValueError, hidden), (TypeError, ["1", "0"]), (TypeError, [1j, 0])):
            for a in (WALL, WALLS):
                with self.assertRaises(error):
                    vesica.cast(a, DISC, wrong)

    def test_many(self):
        self.assertEqual(vesica.cast_first(DISC, WALLS, (2, 0)), (1, (4.5, 10, 0, -1, 0)))
        self.assertIsNone(vesica.cast_first(DISC, WALLS, (-2, 0)))
        index = vesica.Index(WALLS, vesica.circles([[5, 0, 1]]))
        self.assertEqual(sorted(index.cast(DISC, (1, 0), 9)), [1, 2, 3])
        self.assertEqual(index.cast(DISC, (0, 1)).tolist(), [])
        self.assertEqual(index.cast_first(DISC, (1, 0)), (3, (3, 4, 0, -1, 0)))
        self.assertIsNone(index.cast_first(DISC, (0, 1)))

    def test_bounds(self):
        box = vesica.sweep_bounds(DISC, (0, 3), 2)
        self.assertTrue(vesica.contains(box, vesica.aabbs([-1, -1, 1, 7])))
        self.assertFalse(vesica.overlap(box, vesica.points([0, 7.001])))

    def test_turning(self):
        bar, disc = vesica.segments([-1, 0, 1, 0]), vesica.circles([0, 0.5, 1e-8])
        found, impact, gap = vesica.impact_time(bar, (0, 0, math.pi), disc, vesica.Turn(), 1e-7)
        self.assertIs(found, Cast.HIT)
        self.assertAlmostEqual(impact.t, 0.5, 6)
        self.assertLessEqual(impact.t, 0.5)
        self.assertLessEqual(gap, 1e-7)
        found, impact, gap = vesica.impact_time(bar, (0, 0, 1.57), disc, (0, 0, 0), 1e-7)
        self.assertIs(found, Cast.MISS)
        self.assertTrue(impact.t == math.inf and math.isnan(gap))
        # Without area contact is never proved.
        near = vesica.impact_time(bar, (0, 0, math.pi), vesica.points([0, 0.5]), (0, 0, 0), 1e-7)[0]
        self.assertIs(near, Cast.NEAR)
        self.assertEqual(vesica.impact_time(WALL, (1, 2, 3), WALL, (3, 2, 1), 1)[::2], (Cast.START, 0))

    def test_manifold(self):
        ground = vesica.rects([0, 0, 8, 2, 0])
        rows = numpy.array([[1, 1.875, 1, 0, 1, 1], [1, 9, 1, 0, 1, 1], [1, 1.875, 1, 0, -1, 1]])
        boxes = vesica.shapes(vesica.Kind.RECT, rows)
        one = vesica.manifold(ground, boxes[0])
        self.assertEqual((one.count, one.normal.tolist(), one.depths.tolist()), (2, [0, 1], [0.125, 0.125]))
        self.assertEqual((one.points.tolist(), one.numbers.tolist()), ([[2, 0.9375], [0, 0.9375]], [[2, 1], [3, 0]]))
        two = vesica.manifold(boxes[:2].astype("f4"), ground.astype("f4"))
        self.assertEqual((two.count.tolist(), two.normal.tolist()), ([2, 0], [[0, -1], [0, 0]]))
        self.assertEqual((two.points.shape, two.depths.shape, two.numbers.shape), ((2, 2, 2), (2, 2), (2, 2, 2)))
        self.assertEqual(two.points[0].tolist(), one.points[::-1].tolist())
        with self.assertRaisesRegex(vesica.VesicaError, "row 2 of b") as caught:
            vesica.manifold(ground, boxes)
        self.assertEqual(caught.exception.result.count[:2].tolist(), [2, 0])
        self.assertLess(caught.exception.result.count[2], 0)
        draw = numpy.random.default_rng(1)
        rows = [[*draw.uniform(-1, 1, 2), *draw.uniform(0.5, 2, 2), draw.uniform(0, 7)] for _ in range(2000)]
        first, second = vesica.rects(rows[:1000]), vesica.rects(rows[1000:])
        found = vesica.manifold(first, second)
        quads = vesica.manifold(*(vesica.polygons(vesica.corners(rects)) for rects in (first, second)))
        self.assertEqual(found.count.tolist(), quads.count.tolist())
        self.assertEqual(found.numbers.tolist(), quads.numbers.tolist())
        numpy.testing.assert_allclose(found.points, quads.points, atol=1e-14)
        numpy.testing.assert_allclose(found.depths, quads.depths, atol=1e-14)
        self.assertEqual(found.depths.max(axis=1).tolist(), vesica.depth(first, second).depth.tolist())
        quad = vesica.polygons([[-4, -1], [4, -1], [4, 1], [-4, 1]])
        self.assertEqual(vesica.manifold(quad, boxes[0]).points.tolist(), one.points.tolist())

    def test_refused(self):
        for error, words, call in (
            (ValueError, r"\(vx, vy\)", lambda: vesica.cast(WALL, DISC, 3)),
            (ValueError, r"\(2,\) or \(3, 2\)", lambda: vesica.cast(WALLS, DISC, [[1, 2]] * 2)),
            (vesica.VesicaError, "t_end is -1", lambda: vesica.cast(WALLS, DISC, (1, 0), -1)),
            (vesica.VesicaError, "", lambda: vesica.cast(WALL, DISC, (math.inf, 0))),
            (TypeError, "a single shape", lambda: vesica.sweep_bounds(WALLS, (1, 0), 1)),
            (vesica.VesicaError, "", lambda: vesica.cast_first(WALLS, DISC, (1, 0))),
            (ValueError, r"\(vx, vy, angle\)", lambda: vesica.impact_time(WALL, (1, 2), DISC, (0, 0, 0), 1)),
            (TypeError, "two single", lambda: vesica.impact_time(WALLS, (1, 2, 3), DISC, (0, 0, 0), 1)),
            (vesica.VesicaError, "", lambda: vesica.impact_time(WALL, (1, 2, 3), DISC, (0, 0, 0), 0)),
            (vesica.VesicaError, "", lambda: vesica.impact_time(WALL, (1, 2, 2e6), DISC, (0, 0, 0), 1)),
            (TypeError, "float64", lambda: vesica.cast(WALL, DISC.astype("f4"), (1, 0))),
        ):
            with self.assertRaisesRegex(error, words):
                call()


if __name__ == "__main__":
    unittest.main()
