# SPDX-License-Identifier: Apache-2.0
"""Facts about a polygon, and boxes about its edges, which change no bit of an answer."""
import math
import unittest

import numpy
import vesica

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]


class Facts(unittest.TestCase):
    def test_known(self):
        for dtype in ("f8", "f4"):
            of = lambda *rings: vesica.polygon_facts(vesica.polygons([[numpy.array(ring, dtype) for ring in rings]])[0])
            self.assertEqual(of(SQUARE), (4, -1, -1, 16, 1, True, True, 1))
            self.assertEqual(of(SQUARE[::-1]), (4, -1, -1, -16, -1, True, True, 1))
            self.assertEqual(of(SQUARE + SQUARE[:1], [[1, 1], [2, 1], [2, 2]]), (7, -1, -1, 15.5, 1, False, True, 2))
            crossed = of([[0, 0], [2, 2], [2, 0], [0, 2]])
            self.assertEqual((crossed.simple, crossed.convex), (False, False))
            self.assertEqual(sorted([crossed.first_crossing, crossed.second_crossing]), [0, 2])
            self.assertEqual(of([[1, 1]]).orientation, 0)

    def test_refused(self):
        with self.assertRaisesRegex(TypeError, "polygon is of the type list, not a polygon: vesica.polygons makes one"):
            vesica.polygon_facts(SQUARE)
        with self.assertRaisesRegex(TypeError, "polygon is an array of 1 polygons, not a single one: take polygon.i."):
            vesica.polygon_facts(vesica.polygons([SQUARE]))
        with self.assertRaisesRegex(vesica.VesicaError, "not for polyline shapes"):
            vesica.polygon_facts(vesica.polylines(SQUARE))
        with self.assertRaisesRegex(vesica.VesicaError, r"^polygon: ring 0, vertex 1 is \(nan, 0\)$"):
            vesica.polygon_facts(vesica.polygons([[0, 0], [math.nan, 0], [1, 1]]))


class Boxes(unittest.TestCase):
    def test_answers_are_those_without(self):
        draw = numpy.random.default_rng(5)
        angles = numpy.sort(draw.uniform(0, 2 * math.pi, 300))
        coast = numpy.column_stack([numpy.cos(angles), numpy.sin(angles)]) * draw.uniform(3, 5, (300, 1))
        others = draw.uniform(-6, 6, (40, 2))
        for dtype in ("f8", "f4"):
            for make in (vesica.polygons, vesica.polylines):
                path = make([[coast.astype(dtype), coast[:50].astype(dtype) / 2]])[0]
                boxes = vesica.PolygonBoxes(path)
                discs = numpy.column_stack([others, others[:, 0] ** 2 / 9])
                probes = [*vesica.points(others.astype(dtype)), *vesica.circles(discs.astype(dtype))]
                found = []
                for probe in probes:
                    found.append(boxes.overlap(probe))
                    self.assertIs(boxes.overlap(probe), vesica.overlap(path, probe))
                    self.assertEqual(boxes.nearest(probe), vesica.nearest(path, probe))
                    self.assertIs(boxes.within(probe, 0.7), vesica.within(path, probe, 0.7))
                self.assertEqual(set(found), {False, True})

    def test_refused(self):
        boxes, square = vesica.PolygonBoxes(vesica.polygons(SQUARE)), vesica.polygons([SQUARE])
        self.assertIs(boxes.overlap(vesica.points([[1, 1]])), True)  # an array of one
        with self.assertRaisesRegex(TypeError, "path is an array of 1 polygons, not a single one"):
            vesica.PolygonBoxes(square)
        with self.assertRaisesRegex(TypeError, "path is of the type Shapes, not a polygon"):
            vesica.PolygonBoxes(vesica.points([1, 1]))
        with self.assertRaisesRegex(vesica.VesicaError, "path: ring 0, vertex 1 is"):
            vesica.PolygonBoxes(vesica.polygons([[0, 0], [math.nan, 0], [1, 1]]))
        with self.assertRaisesRegex(TypeError, "other is list: say which shapes it holds"):
            boxes.overlap([1, 1])
        with self.assertRaisesRegex(TypeError, "the path has float64 numbers and other float32"):
            boxes.overlap(vesica.points(numpy.zeros(2, "f4")))
        with self.assertRaisesRegex(vesica.VesicaError, "other: r is -1"):
            boxes.nearest(vesica.circles([0, 0, -1]))
        with self.assertRaisesRegex(vesica.VesicaError, "other has 2 shapes, not a single one"):
            boxes.overlap(vesica.points([[1, 1]] * 2))
        with self.assertRaisesRegex(vesica.VesicaError, "distance is nan, not a number"):
            boxes.within(vesica.points([1, 1]), math.nan)


if __name__ == "__main__":
    unittest.main()
