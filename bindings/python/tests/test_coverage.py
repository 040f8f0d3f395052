# SPDX-License-Identifier: Apache-2.0
"""Shares of cells."""
import math
import unittest

import numpy

import vesica


class Coverage(unittest.TestCase):
    def test_shares(self):
        box = vesica.aabbs([0.5, 0.25, 2.5, 1.75])
        expected = [[0.375, 0.75, 0.375], [0.375, 0.75, 0.375]]
        self.assertEqual(vesica.coverage(box, 2, 3).tolist(), expected)
        single = vesica.coverage(box.astype(numpy.float32), 2, 3)
        self.assertEqual((single.dtype, single.tolist()), (numpy.float32, expected))
        wide = vesica.coverage(box, 1, 2, origin=(0.5, 0.25), cell=(1, 1.5))
        self.assertEqual(wide.tolist(), [[1, 1]])
        self.assertEqual(vesica.coverage(box, 1, 1, origin=(0.5, 0.75), cell=0.5).tolist(), [[1]])

    def test_ring(self):
        outer, inner = (vesica.coverage(vesica.circles([20, 20, r]), 40, 40) for r in (9, 5))
        self.assertAlmostEqual((outer - inner).sum(), math.pi * (81 - 25), places=10)

    def test_cells(self):
        disc = vesica.circles([7.5, 5.5, 3.2])
        rows, columns, shares = vesica.coverage_cells(disc, 9, 12)
        dense = numpy.zeros((9, 12))
        dense[rows, columns] = shares
        self.assertEqual(dense.tolist(), vesica.coverage(disc, 9, 12).tolist())
        self.assertTrue((shares > 0).all())

    def test_bad_input(self):
        with self.assertRaises(vesica.VesicaError):
            vesica.coverage(vesica.circles([0, 0, -1]), 2, 2)
        with self.assertRaises(vesica.VesicaError):
            vesica.coverage(vesica.circles([0, 0, 1]), 2, 2, cell=0)
        with self.assertRaises((TypeError, ValueError)):
            vesica.coverage(vesica.circles([[0, 0, 1]]), 2, 2)


if __name__ == "__main__":
    unittest.main()
