# SPDX-License-Identifier: Apache-2.0
"""Polygons and polylines: what they are made of, that vertices are read in place, and what is said of others."""
import pickle
import unittest

import numpy
import vesica

SQUARES = numpy.array(
    [[[0, 0], [1, 0], [1, 1], [0, 1]], [[2, 0], [3, 0], [3, 1], [2, 1]], [[9, 9], [8, 9], [8, 8], [9, 8]]], float
)
DISC = vesica.circles([2.5, 0.5, 0.25])
ANSWERS = [False, True, False]


class Forms(unittest.TestCase):
    def check(self, shapes, answers=ANSWERS):
        self.assertEqual(vesica.overlap(shapes, DISC.astype(shapes.dtype)).tolist(), answers)
        self.assertEqual(vesica.overlap_matrix(DISC.astype(shapes.dtype), shapes).tolist(), [answers])

    def test_arrays(self):
        wide = numpy.full((3, 4, 5), numpy.nan)
        wide[:, :, 1:3] = SQUARES
        for array in (SQUARES, SQUARES.astype("f4"), SQUARES.astype(">f8"), SQUARES.astype(int), wide[:, :, 1:3]):
            self.check(vesica.polygons(array))
        self.check(vesica.polygons(numpy.asfortranarray(SQUARES)))
        self.check(vesica.polygons(SQUARES.tolist()))

    def test_single(self):
        one = vesica.polygons(SQUARES[1])
        self.assertTrue(one.single)
        self.assertIs(vesica.overlap(one, DISC), True)
        self.assertEqual(vesica.overlap(one, vesica.polygons(SQUARES)).tolist(), ANSWERS)
        vesica.check(one)

    def test_lists_of_unlike_polygons(self):
        with_hole = [[[0, 0], [5, 0], [5, 5], [0, 5]], [[2, 0.1], [3, 0.1], [3, 1], [2, 1]]]
        shapes = vesica.polygons([SQUARES[0], SQUARES[1][:3], with_hole, [[0, 0], [9, 0], [9, 9]]])
        self.assertEqual(len(shapes), 4)
        self.check(shapes, [False, True, False, True])
        self.assertEqual([len(rings) for rings in shapes.rings], [1, 1, 2, 1])

    def test_offsets(self):
        vertices = SQUARES.reshape(-1, 2)
        self.check(vesica.polygons(vertices, [0, 4, 8, 12]))
        self.check(vesica.polygons(vertices, numpy.array([0, 4, 8, 12]), numpy.array([0, 1, 3])), [False, True])
        self.check(vesica.polygons(vertices, (numpy.array([0, 4, 8, 12]), numpy.array([0, 1, 3]))), [False, True])
        for offsets in ([0, 4, 13], [4, 0, 12], [-1, 4], [0.0, 4.0], []):
            with self.assertRaises(ValueError):
                vesica.polygons(vertices, numpy.array(offsets))
        with self.assertRaises(ValueError):
            vesica.polygons(vertices, [0, 4, 8, 12], [0, 4])

    def test_polylines_have_no_inside(self):
        around = numpy.array([[0.0, 0], [5, 0], [5, 5], [0, 5], [0, 0]])
        self.assertTrue(vesica.overlap(vesica.polygons(around), DISC))
        self.assertFalse(vesica.overlap(vesica.polylines(around), DISC))

    def test_changes_are_seen(self):
        array = SQUARES.copy()
        shapes = vesica.polygons(array)
        one = shapes[0]
        array[0, :, 0] += 2
        self.check(shapes, [True, True, False])
        self.assertTrue(vesica.overlap(one, DISC))

    def test_indexing(self):
        shapes = vesica.polygons(SQUARES)
        self.check(shapes[::-1], ANSWERS[::-1])
        self.check(shapes[numpy.array([True, True, False])], [False, True])
        self.check(shapes[[1, 1]], [True, True])
        self.assertEqual([vesica.overlap(shape, DISC) for shape in shapes], ANSWERS)
        numpy.testing.assert_array_equal(shapes[-1].rings[0][0], SQUARES[2])
        with self.assertRaises(IndexError):
            shapes[3]

    def test_copies(self):
        shapes = vesica.polygons([SQUARES[0], SQUARES[1][:3]])
        self.check(pickle.loads(pickle.dumps(shapes)), [False, True])
        self.assertTrue(pickle.loads(pickle.dumps(shapes[1])).single)
        self.check(shapes.astype("f4"), [False, True])

    def test_bounds_and_index(self):
        shapes = vesica.polygons(SQUARES)
        self.assertEqual(vesica.bounds(shapes).numbers[1].tolist(), [2, 0, 3, 1])
        index = vesica.Index(shapes, vesica.circles([[2.5, 0.5, 0.25], [0, 0, 0.1]]))
        a, b = index.join()
        self.assertEqual(sorted(zip(a.tolist(), b.tolist())), [(0, 4), (1, 3)])
        self.assertEqual(sorted(index.cast(vesica.points([-1, 0.5]), (1, 0)).tolist()), [0, 1, 3])
        item, impact = index.cast_first(shapes[0], (1, 0), 0.5)
        self.assertEqual((item, impact.t), (0, 0))
        item, impact = index.cast_first(vesica.points([1.5, 0.5]), (1, 0))
        self.assertEqual((item, impact.t), (1, 0.5))

    def test_questions(self):
        shapes = vesica.polygons(SQUARES)
        twice = vesica.polygons(SQUARES + [0.5, 0])
        numpy.testing.assert_allclose(vesica.area(shapes, twice), 0.5)
        numpy.testing.assert_allclose(vesica.iou_matrix(shapes, twice).diagonal(), 1 / 3)
        self.assertEqual(vesica.shape_area(shapes).tolist(), [1, 1, 1])
        self.assertEqual(vesica.nms(vesica.polygons(SQUARES[[0, 0, 1]]), [0.9, 0.8, 0.1]).tolist(), [0, 2])
        self.assertEqual(vesica.nearest(shapes[0], shapes[1]).distance, 1)
        self.assertEqual(vesica.depth(shapes[0], twice[0]).depth, 0.5)
        self.assertEqual(vesica.signed_distance(shapes, twice).tolist(), [-0.5] * 3)
        self.assertIs(vesica.relation(shapes[1], DISC), vesica.Relation.CONTAINS)
        self.assertEqual(vesica.within(shapes[0], DISC, 1.25), vesica.Within.YES)
        hit, impact = vesica.cast(shapes[0], DISC, (-1, 0))
        self.assertEqual((hit, impact.t), (vesica.Cast.HIT, 1.25))
        self.assertEqual(len(vesica.crossings(shapes[1], vesica.circles([2.5, 0.5, 0.6])).places), 8)
        self.assertEqual(vesica.de9im(shapes[0], shapes[1]), "FF2FF1212")
        hit, impact, gap = vesica.impact_time(shapes[0], (0, 0, 0), shapes[1], (-2, 0, 0), 1e-6)
        self.assertIs(hit, vesica.Cast.HIT)
        self.assertAlmostEqual(impact.t, 0.5, 5)
        self.assertLessEqual(gap, 1e-6)
        bent = vesica.polygons([[0, 0], [6, 0], [6, 4], [4, 4], [4, 2], [2, 2], [2, 4], [0, 4]])
        self.assertEqual(vesica.intersection(bent, vesica.segments([-1, 3, 9, 3])).tolist(),
                         [[0, 3], [2, 3], [4, 3], [6, 3]])
        self.assertEqual(len(vesica.intersection(shapes[0], shapes[0])), 4)
        with self.assertRaises(vesica.VesicaError):
            vesica.intersection(bent, shapes[0])

    def test_bad_vertices(self):
        array = SQUARES.copy()
        array[2, 1, 0] = numpy.nan
        with self.assertRaises(vesica.VesicaError) as caught:
            vesica.overlap(vesica.polygons(array), DISC)
        self.assertIn("row 2 of a: ring 0, vertex 1 is (nan, 9)", str(caught.exception))
        self.assertEqual(caught.exception.result.tolist(), ANSWERS)
        for wrong in (SQUARES[0, 0], SQUARES[:, :, :1], "text", numpy.zeros((2, 0, 2))):
            with self.assertRaises((ValueError, TypeError)):
                vesica.polygons(wrong)
        with self.assertRaises(TypeError):
            vesica.shapes(vesica.Kind.POLYGON, SQUARES)


if __name__ == "__main__":
    unittest.main()
