# SPDX-License-Identifier: Apache-2.0
"""Distances that are asked about, nine-intersection matrices, shared regions and soft suppression, by known numbers."""
import math
import unittest

import numpy
import vesica
from vesica import Within

BOX = vesica.aabbs([0, 0, 2, 2])
BOXES = vesica.aabbs([[0, 0, 2, 2], [1, 1, 3, 3], [5, 0, 6, 2]])


class Topology(unittest.TestCase):
    def test_within(self):
        disc = vesica.circles([6, 1, 1])
        self.assertIs(vesica.within(BOX, disc, 3), Within.YES)
        self.assertIs(vesica.within(BOX, disc, numpy.nextafter(3, 0)), Within.NO)
        left, right = vesica.ellipses([-2, 0, 2, 1, 0]), vesica.ellipses([5, 0, 2, 1, 0])
        self.assertIs(vesica.within(vesica.points([0, 0]), right, 3), Within.YES)
        self.assertIs(vesica.within(left, right, 3), Within.NEARLY)
        self.assertEqual(vesica.within(BOXES, disc, 2).tolist(), [0, 1, 1])
        self.assertEqual(vesica.within_matrix(BOXES, BOXES[:2], 2).tolist(), [[1, 1], [1, 1], [0, 1]])
        first, second = vesica.Index(BOXES).join_within(None, 2)
        self.assertEqual(sorted(zip(first.tolist(), second.tolist())), [(0, 1), (1, 2)])
        with self.assertRaises(vesica.VesicaError):
            vesica.within(BOX, disc, math.nan)
        with self.assertRaises(vesica.VesicaError):
            vesica.Index(BOXES).join_within(None, math.nan)
        self.assertEqual(vesica.within(BOXES, BOX, -1).tolist(), [1, 1, 0])
        self.assertEqual(vesica.within(BOXES, BOX, -1.5).tolist(), [1, 0, 0])
        first, second = vesica.Index(BOXES).join_within(None, -1)
        self.assertEqual(list(zip(first.tolist(), second.tolist())), [(0, 1)])

    def test_signed_distance(self):
        self.assertEqual(vesica.signed_distance(BOXES, BOX).tolist(), [-2, -1, 3])
        self.assertEqual(vesica.signed_distance_matrix(BOXES[1:], BOXES[:1]).tolist(), [[-1], [3]])
        self.assertEqual(vesica.signed_distance(BOX, vesica.circles([6, 1, 1])), 3)

    def test_matrices(self):
        self.assertEqual(vesica.de9im(BOX, vesica.aabbs([2, 0, 4, 2])), "FF2F11212")
        self.assertTrue(vesica.de9im_match("FF2F11212", "FF*FT****"))
        self.assertFalse(vesica.de9im_match("FF2F11212", "T********"))
        for error, matrix, pattern in (
            (vesica.VesicaError, "FF2F11212", "T*"),
            (vesica.VesicaError, "T********", "T********"),
            (ValueError, "FF2F11212\0", "T********"),
            (TypeError, b"FF2F11212", "T********"),
        ):
            with self.assertRaises(error):
                vesica.de9im_match(matrix, pattern)
        with self.assertRaisesRegex(TypeError, "two single shapes"):
            vesica.de9im(BOXES, BOX)

    def test_regions(self):
        self.assertEqual(vesica.intersection(BOX, BOXES[1]).tolist(), [[1, 1], [2, 1], [2, 2], [1, 2]])
        self.assertEqual(vesica.intersection(BOX, BOXES[2]).shape, (0, 2))
        self.assertEqual(vesica.intersection(BOX.astype("f4"), BOXES[1].astype("f4")).dtype, numpy.float32)
        with self.assertRaises(vesica.VesicaError):
            vesica.intersection(BOX, vesica.circles([0, 0, 1]))

    def test_soft_suppression(self):
        boxes = vesica.aabbs([[0, 0, 4, 4], [0, 0, 4, 3], [9, 9, 10, 10]])
        kept, scores = vesica.nms_soft(boxes, [1, 0.8, 0.5])
        self.assertEqual((kept.tolist(), scores.tolist()), ([0, 2, 1], [1, 0.5, 0.2]))
        kept, scores = vesica.nms_soft(boxes, [1, 0.8, 0.5], labels=[1, 2, 1], most=2, decay="gaussian")
        self.assertEqual((kept.tolist(), scores.tolist()), ([0, 1], [1, 0.8]))
        self.assertEqual(vesica.nms_soft(boxes, [1, 0.8, 0.5], least_score=0.3)[0].tolist(), [0, 2])
        with self.assertRaisesRegex(ValueError, "linear, gaussian"):
            vesica.nms_soft(boxes, [1, 2, 3], decay="cubic")
        with self.assertRaises(vesica.VesicaError):
            vesica.nms_soft(boxes, [1, 2, 3], 2)


if __name__ == "__main__":
    unittest.main()
