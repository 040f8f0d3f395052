# SPDX-License-Identifier: Apache-2.0
"""Distances of Gaussians: ProbIoU, KLD and GWD beside their formulas in numpy."""
import unittest

import numpy
import vesica
from vesica import Gaussian


def covariances(rows):
    width, height, angle = rows[:, 2], rows[:, 3], rows[:, 4]
    turn = numpy.array([[numpy.cos(angle), -numpy.sin(angle)], [numpy.sin(angle), numpy.cos(angle)]]).transpose(2, 0, 1)
    squares = numpy.zeros((len(rows), 2, 2))
    squares[:, 0, 0], squares[:, 1, 1] = width**2 / 12, height**2 / 12
    return turn @ squares @ turn.transpose(0, 2, 1)


def root(matrices):
    values, vectors = numpy.linalg.eigh(matrices)
    return (vectors * numpy.sqrt(values)[:, None, :]) @ vectors.transpose(0, 2, 1)


class Distances(unittest.TestCase):
    def setUp(self):
        random = numpy.random.default_rng(1)
        low, high = [0, 0, 1, 1, 0], [9, 9, 9, 9, 3]
        self.p, self.q = random.uniform(low, high, (50, 5)), random.uniform(low, high, (50, 5))
        self.a, self.b = vesica.rects(self.p), vesica.rects(self.q)

    def test_formulas(self):
        s, t, d = covariances(self.p), covariances(self.q), (self.p - self.q)[:, :2]
        det, trace = numpy.linalg.det, lambda m: numpy.trace(m, axis1=1, axis2=2)

        def square(m):
            return numpy.einsum("ni,nij,nj->n", d, numpy.linalg.inv(m), d)

        mean = (s + t) / 2
        bhattacharyya = square(mean) / 8 + numpy.log(det(mean) / numpy.sqrt(det(s) * det(t))) / 2
        divergence = (trace(numpy.linalg.inv(t) @ s) - 2 + square(t) + numpy.log(det(t) / det(s))) / 2
        wasserstein = (d**2).sum(1) + trace(s + t - 2 * root(root(s) @ t @ root(s)))
        for which, expected in [
            (Gaussian.BHATTACHARYYA, bhattacharyya),
            (Gaussian.HELLINGER, numpy.sqrt(1 - numpy.exp(-bhattacharyya))),
            (Gaussian.KULLBACK_LEIBLER, divergence),
            (Gaussian.WASSERSTEIN, wasserstein),
        ]:
            numpy.testing.assert_allclose(vesica.gaussian_distance(which, self.a, self.b), expected, 1e-12)

    def test_forms(self):
        for which in Gaussian:
            matrix = vesica.gaussian_distance_matrix(which, self.a, self.b)
            self.assertEqual(matrix[3, 7], vesica.gaussian_distance(which, self.a[3], self.b[7]))
            numpy.testing.assert_array_equal(vesica.gaussian_distance(which, self.a, self.b), matrix.diagonal())
        with self.assertRaises(ValueError):
            vesica.gaussian_distance(4, self.a, self.b)
        with self.assertRaises(vesica.VesicaError):
            vesica.gaussian_distance(0, self.a, vesica.points([0, 0]))
        with self.assertRaises(vesica.VesicaError) as raised:
            vesica.gaussian_distance(0, vesica.rects([[0, 0, 1, 0, 0], [0, 0, 1, 1, 0]]), vesica.circles([0, 0, 1]))
        self.assertEqual(numpy.isnan(raised.exception.result).tolist(), [True, False])


if __name__ == "__main__":
    unittest.main()
