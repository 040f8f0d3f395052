# SPDX-License-Identifier: Apache-2.0
"""What is done around detectors: against definitions in plain Python."""
import math
import unittest

import numpy
import vesica

from test_index import mixed


class JoinRatio(unittest.TestCase):
    def test_is_the_matrix_where_shapes_overlap(self):
        generator = numpy.random.default_rng(3)
        for dtype in ("f8", "f4"):
            a, b = mixed(30, generator, dtype), mixed(20, generator, dtype)
            index_a, index_b = vesica.Index(*a), vesica.Index(*b)
            for ratio, threshold in ((vesica.Ratio.OVER_UNION, 0.1), (vesica.Ratio.OVER_FIRST, 0), (4, -math.inf)):
                expected = {}
                offset_a = 0
                for x in a:
                    offset_b = 0
                    for y in b:
                        try:
                            matrix = vesica.ratio_matrix(ratio, x, y)
                        except vesica.VesicaError as error:
                            matrix = error.result
                        where = numpy.argwhere((matrix >= threshold) & vesica.overlap_matrix(x, y))
                        expected |= {(offset_a + i, offset_b + j): matrix[i, j] for i, j in where.tolist()}
                        offset_b += len(y)
                    offset_a += len(x)
                self.assertGreater(len(expected), 50)
                i, j, value = index_a.join_ratio(index_b, ratio, threshold)
                self.assertEqual(value.dtype, dtype)
                self.assertEqual(dict(zip(zip(i.tolist(), j.tolist()), value)), expected)
                parts = [index_a.join_ratio(index_b, ratio, threshold, part, 3) for part in range(3)]
                for whole, column in zip((i, j, value), zip(*parts)):
                    numpy.testing.assert_array_equal(numpy.concatenate(column), whole)

    def test_refusals(self):
        index = vesica.Index(vesica.aabbs([[0, 0, 1, 1], [0, 0, 2, 1]]))
        self.assertEqual([column.tolist() for column in index.join_ratio()], [[0], [1], [0.5]])
        for arguments in ({"ratio": 9}, {"threshold": math.nan}, {"part": 1}):
            with self.assertRaises(ValueError):
                index.join_ratio(**arguments)


class AssignGreedy(unittest.TestCase):
    def test_is_the_definition(self):
        generator = numpy.random.default_rng(5)
        for count in (0, 1, 200):
            for dtype in ("f8", "f4"):
                a, b = generator.integers(0, 40, (2, count))
                values = generator.integers(0, 20, count).astype(dtype)
                expected, used_a, used_b = [], set(), set()
                for k in sorted(range(count), key=lambda k: (-values[k], a[k], b[k])):
                    if a[k] not in used_a and b[k] not in used_b:
                        used_a.add(a[k]), used_b.add(b[k]), expected.append(k)
                self.assertEqual(vesica.assign_greedy(a, b, values).tolist(), expected)

    def test_refusals(self):
        self.assertEqual(vesica.assign_greedy([0, 0], [1, 2], [math.nan, -math.inf]).tolist(), [1])
        for arguments in (([-1], [0], [1]), ([0], [0, 1], [1]), ([2**31], [0], [1])):
            with self.assertRaises(ValueError):
                vesica.assign_greedy(*arguments)
        for arguments in (([0.5], [0], [1]), ([0], [0], ["a"]), ([0], [0], [[1]])):
            with self.assertRaises(TypeError):
                vesica.assign_greedy(*arguments)


if __name__ == "__main__":
    unittest.main()
