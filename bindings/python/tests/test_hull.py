# SPDX-License-Identifier: Apache-2.0
"""Convex hulls and the smallest rectangles."""
import unittest

import numpy

import vesica

QUADS = numpy.array([[[0, 0], [4, 0], [4, 2], [0, 2]], [[0, 0], [3, 4], [-1, 7], [-4, 3]]], float)


class Hull(unittest.TestCase):
    def test_hull_of_points(self):
        points = [[2, 1], [0, 0], [4, 0], [1, 0], [4, 3], [2, 2]]
        for dtype in (numpy.float64, numpy.float32):
            corners = vesica.convex_hull(numpy.array(points, dtype))
            self.assertEqual(corners.dtype, dtype)
            self.assertEqual(corners.tolist(), [[0, 0], [4, 0], [4, 3], [2, 2]])
        self.assertEqual(vesica.convex_hull(vesica.polygons(QUADS)[0]).tolist(), QUADS[0].tolist())
        with self.assertRaises(ValueError):
            vesica.convex_hull(QUADS)
        with self.assertRaises(vesica.VesicaError):
            vesica.convex_hull([[0, 0], [numpy.nan, 1]])

    def test_smallest_rects(self):
        rects = vesica.min_area_rects(QUADS)
        self.assertEqual(rects.numbers[0].tolist(), [2, 1, 1, 0, 2, 1])
        numpy.testing.assert_allclose(rects.numbers[1], [-0.5, 3.5, 0.8, -0.6, 2.5, 2.5], rtol=1e-14)
        self.assertTrue(vesica.contains(vesica.bounds(rects), vesica.polygons(QUADS)).all())
        single = vesica.min_perimeter_rects(QUADS[0, [0, 2, 3, 1]])
        self.assertTrue(single.single)
        self.assertEqual(single.numbers.tolist(), [2, 1, 1, 0, 2, 1])

    def test_invalid_points(self):
        quads = QUADS.copy()
        quads[0, 0, 0] = numpy.inf
        with self.assertRaises(vesica.VesicaError) as caught:
            vesica.min_area_rects(quads)
        self.assertIn("row 0 of shape: ring 0, vertex 0 is (inf, 0)", str(caught.exception))
        numpy.testing.assert_allclose(caught.exception.result[1, 4:], 2.5)


if __name__ == "__main__":
    unittest.main()
