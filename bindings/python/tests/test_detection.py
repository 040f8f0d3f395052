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


def iou_of_boxes(a, b):
    width, height = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
    if width <= 0 or height <= 0:
        return 0
    areas = [(box[2] - box[0]) * (box[3] - box[1]) for box in (a, b)]
    return width * height / (sum(areas) - width * height)


class Fuse(unittest.TestCase):
    def test_is_the_definition(self):
        generator = numpy.random.default_rng(11)
        for count in (0, 1, 150):
            centres, halves = generator.integers(0, 6, (count, 2)) * 1.4, generator.uniform(0.4, 1, (count, 2))
            centres = centres + generator.uniform(-0.2, 0.2, (count, 2))
            rows = numpy.hstack([centres - halves, centres + halves])
            scores, weights = generator.uniform(0.1, 1, count), generator.integers(1, 4, count)
            labels = generator.integers(0, 2, count)
            members, means, clusters = [], [], [None] * count
            for i in sorted(range(count), key=lambda i: -scores[i] * weights[i]):
                fitting = [c for c in range(len(means)) if labels[members[c][0]] == labels[i]]
                ious = [iou_of_boxes(means[c], rows[i]) for c in fitting]
                if ious and max(ious) > 0.3:
                    clusters[i] = fitting[ious.index(max(ious))]
                    members[clusters[i]].append(i)
                else:
                    clusters[i] = len(means)
                    members.append([i]), means.append(None)
                own = members[clusters[i]]
                means[clusters[i]] = numpy.average(rows[own], axis=0, weights=(scores * weights)[own])
            found = vesica.fuse(vesica.aabbs(rows), scores, 0.3, weights=weights, labels=labels)
            self.assertEqual(found[2].tolist(), clusters)
            numpy.testing.assert_allclose(found[0].numbers, numpy.reshape(means, (-1, 4)), rtol=0, atol=1e-14)
            numpy.testing.assert_allclose(found[1], [numpy.average(scores[m], weights=weights[m]) for m in members])
            highest = vesica.fuse(vesica.aabbs(rows), scores, 0.3, weights=weights, labels=labels, score="max")
            self.assertEqual(highest[1].tolist(), [scores[m].max() for m in members])

    def test_refusals(self):
        boxes = vesica.aabbs(numpy.array([[0, 0, 1, 1], [2, 0, 1, 1]], "f4"))
        with self.assertRaises(vesica.VesicaError) as caught:
            vesica.fuse(boxes, [1, 1])
        means, scores, clusters = caught.exception.result
        self.assertEqual((means.dtype, len(means), scores.tolist(), clusters.tolist()), ("f4", 1, [1], [0, -1]))
        with self.assertRaises(vesica.VesicaError) as caught:
            vesica.fuse(boxes[:1], [-1])
        self.assertIn("row 0: the score or the weight", str(caught.exception))
        self.assertEqual(caught.exception.result[2].tolist(), [-1])
        for wrong in ({"threshold": 2}, {"threshold": math.nan}, {"score": "least"}, {"weights": [1]}, {"labels": [1]}):
            with self.assertRaises(ValueError):
                vesica.fuse(boxes[:0] if "threshold" in wrong else boxes, [] if "threshold" in wrong else [1, 1], **wrong)
        with self.assertRaises(vesica.VesicaError):
            vesica.fuse(vesica.circles([[0, 0, 1]]), [1])
        with self.assertRaises(TypeError):
            vesica.fuse(boxes, ["a", "b"])


if __name__ == "__main__":
    unittest.main()
