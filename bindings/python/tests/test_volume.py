# SPDX-License-Identifier: Apache-2.0
"""Ratios of shared volume: beside the ratio of areas, forms, errors."""
import unittest

import numpy
import vesica
from vesica import Ratio


class Volumes(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(1)
        low, high = [0, 0, 1, 1, 0], [5, 5, 5, 5, 3]
        self.a, self.b = (vesica.rects(random.uniform(low, high, (n, 5))) for n in (20, 30))
        self.p, self.q = (numpy.sort(random.uniform(0, 3, (n, 2))) for n in (20, 30))

    def test_definition(self):
        shared = vesica.area_matrix(self.a, self.b)
        low, high = (f(self.p[:, None, k], self.q[None, :, k]) for f, k in ((numpy.maximum, 0), (numpy.minimum, 1)))
        shared *= numpy.maximum(high - low, 0)
        first = (vesica.shape_area(self.a) * (self.p[:, 1] - self.p[:, 0]))[:, None]
        second = (vesica.shape_area(self.b) * (self.q[:, 1] - self.q[:, 0]))[None, :]
        for ratio, whole in [
            (Ratio.OVER_UNION, first + second - shared),
            (Ratio.OVER_FIRST, first),
            (Ratio.OVER_SECOND, second),
            (Ratio.OVER_SMALLER, numpy.minimum(first, second)),
        ]:
            got = vesica.volume_ratio_matrix(ratio, self.a, self.p, self.b, self.q)
            numpy.testing.assert_allclose(got, shared / whole, 1e-12, 1e-14)
            self.assertEqual(got[3, 7], vesica.volume_ratio(ratio, self.a[3], self.p[3], self.b[7], self.q[7]))
            step = vesica.volume_ratio(ratio, self.a, self.p, self.b[:20], self.q[:20])
            numpy.testing.assert_array_equal(step, got.diagonal())

    def test_float32_and_polygons(self):
        zone = vesica.polygons(numpy.array([[[0, 0], [2, 0], [2, 2], [0, 2]]], "f4"))
        post = vesica.aabbs(numpy.array([[1, 0, 3, 2], [5, 5, 6, 6]], "f4"))
        got = vesica.volume_ratio_matrix(Ratio.OVER_UNION, zone, [[0, 2]], post, [[1, 3], [0, 1]])
        self.assertEqual(got.dtype, numpy.float32)
        numpy.testing.assert_array_equal(got, numpy.array([[1 / 7, 0]], "f4"))

    def test_errors(self):
        cube = vesica.aabbs([0, 0, 1, 1])
        for spans in ([1, 0], [0, numpy.inf], [numpy.nan, 1]):
            with self.assertRaises(vesica.VesicaError):
                vesica.volume_ratio(Ratio.OVER_UNION, cube, spans, cube, [0, 1])
        for spans in (3, [1, 2, 3], [[0, 1], [0, 1]]):
            with self.assertRaises(ValueError):
                vesica.volume_ratio(Ratio.OVER_UNION, cube, spans, cube, [0, 1])
        with self.assertRaises(vesica.VesicaError):
            vesica.volume_ratio(Ratio.GENERALIZED, cube, [0, 1], cube, [0, 1])
        with self.assertRaises(vesica.VesicaError) as raised:
            vesica.volume_ratio(Ratio.OVER_FIRST, vesica.aabbs([[0, 0, 1, 1]] * 2), [[0, 1], [1, 1]], cube, [0, 1])
        self.assertEqual(numpy.isnan(raised.exception.result).tolist(), [False, True])


if __name__ == "__main__":
    unittest.main()
