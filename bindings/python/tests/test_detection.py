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
        for wrong in ({"threshold": 2}, {"threshold": math.nan}, {"score": "least"}, {"weights": []}, {"labels": [1, 1]}):
            with self.assertRaises(ValueError):
                vesica.fuse(boxes[:1], [1], **wrong)
        with self.assertRaises(vesica.VesicaError):
            vesica.fuse(vesica.circles([[0, 0, 1]]), [1])
        with self.assertRaises(TypeError):
            vesica.fuse(boxes, ["a", "b"])


class Picture:
    """Boxes found and true, with integer corners so that many IoUs are equal or 1/2."""

    def __init__(self, generator):
        found, true = generator.integers(0, 30), generator.integers(0, 10)
        corner = generator.integers(0, 15, (true, 2))
        self.true = numpy.hstack([corner, corner + generator.integers(2, 7, corner.shape)])
        near = self.true[generator.integers(0, true, found)] if true else generator.integers(0, 9, (found, 4))
        near = near + generator.integers(-1, 2, near.shape)
        self.found = numpy.hstack([near[:, :2], numpy.maximum(near[:, :2] + 1, near[:, 2:])])
        self.scores = generator.integers(0, 20, found) / 16
        self.crowd = generator.random(true) < 0.2
        overlap = [vesica.Index(vesica.aabbs(self.found)), vesica.Index(vesica.aabbs(self.true))]
        self.pairs = [overlap[0].join_ratio(overlap[1], ratio) for ratio in (0, 1)]
        self.iou = numpy.zeros((found, true))
        for crowd, (i, j, value) in enumerate(self.pairs):
            own = self.crowd[j] == crowd
            self.iou[i[own], j[own]] = value[own]


def areas(boxes):
    return (boxes[:, 2] - boxes[:, 0]) * (boxes[:, 3] - boxes[:, 1])


def coco_by_rows(pictures, threshold, most, least_area, most_area):
    """AP at one threshold, as COCO's program finds it: picture by picture, over dense matrices."""
    rows, count = [], 0
    for picture in pictures:
        order = numpy.argsort(-picture.scores, kind="stable")[:most]
        outside = (areas(picture.true) < least_area) | (areas(picture.true) > most_area)
        ignored = picture.crowd | outside
        count += numpy.count_nonzero(~ignored)
        by_class = sorted(range(len(picture.true)), key=lambda t: bool(ignored[t]))
        free = [True] * len(picture.true)
        for d in order:
            best, at_least = None, min(threshold, 1 - 1e-10)
            for t in by_class:
                if not free[t] and not picture.crowd[t]:
                    continue
                if best is not None and not ignored[best] and ignored[t]:
                    break
                if picture.iou[d, t] >= at_least:
                    best, at_least = t, picture.iou[d, t]
            box_area = areas(picture.found[d : d + 1])[0]
            if best is None:
                rows.append((picture.scores[d], False, not least_area <= box_area <= most_area))
            else:
                free[best] = False
                rows.append((picture.scores[d], True, bool(ignored[best])))
    if count == 0:
        return math.nan
    if not rows:
        return 0.0
    score, matched, ignored = (numpy.array(column) for column in zip(*rows))
    order = numpy.argsort(-score, kind="mergesort")
    hits = numpy.cumsum((matched & ~ignored)[order]).astype(float)
    misses = numpy.cumsum((~matched & ~ignored)[order]).astype(float)
    recall, precision = hits / count, hits / (hits + misses + numpy.spacing(1))
    precision = numpy.maximum.accumulate(precision[::-1])[::-1]
    places = numpy.searchsorted(recall, numpy.linspace(0, 1, 101), side="left")
    return numpy.mean([precision[place] if place < len(precision) else 0 for place in places])


def voc_by_rows(pictures, threshold, points):
    """AP as VOC's program does it: one detection after the other, over all pictures."""
    rows = [(s, p, d) for p, picture in enumerate(pictures) for d, s in enumerate(picture.scores)]
    rows.sort(key=lambda row: -row[0])
    taken, true, false = set(), [], []
    for _, p, d in rows:
        ious, hit, miss = pictures[p].iou[d], 0, 0
        best = int(numpy.argmax(ious)) if len(ious) else None
        if best is None or ious[best] < threshold:
            miss = 1
        elif not pictures[p].crowd[best]:
            hit, miss = ((p, best) not in taken, (p, best) in taken)
            taken.add((p, best))
        true.append(hit), false.append(miss)
    count = sum(numpy.count_nonzero(~picture.crowd) for picture in pictures)
    if count == 0:
        return math.nan
    true, false = numpy.cumsum(true).astype(float), numpy.cumsum(false).astype(float)
    with numpy.errstate(invalid="ignore"):
        recall, precision = true / count, numpy.nan_to_num(true / (true + false))
    if points == 11:
        return sum(max(precision[recall >= t], default=0) / 11 for t in numpy.arange(0, 1.1, 0.1))
    recall, precision = numpy.r_[0, recall, 1], numpy.r_[0, precision, 0]
    for k in range(len(precision) - 2, -1, -1):
        precision[k] = max(precision[k], precision[k + 1])
    rises = numpy.flatnonzero(recall[1:] != recall[:-1])
    return sum((recall[rises + 1] - recall[rises]) * precision[rises + 1])


def numbered_through(pictures, most=None):
    """(a, b, values), scores, areas found, crowd and areas true, of all pictures."""
    columns, found, true = [], 0, 0
    kept = [numpy.sort(numpy.argsort(-picture.scores, kind="stable")[:most]) for picture in pictures]
    for picture, own in zip(pictures, kept):
        place = numpy.full(len(picture.scores), -1)
        place[own] = numpy.arange(len(own))
        for crowd, (i, j, value) in enumerate(picture.pairs):
            use = (picture.crowd[j] == crowd) & (place[i] >= 0)
            columns.append((place[i[use]] + found, j[use] + true, value[use]))
        found, true = found + len(own), true + len(picture.true)
    return (
        [numpy.concatenate(column) for column in zip(*columns)],
        numpy.concatenate([picture.scores[own] for picture, own in zip(pictures, kept)]),
        numpy.concatenate([areas(picture.found[own]) for picture, own in zip(pictures, kept)]),
        numpy.concatenate([picture.crowd for picture in pictures]),
        numpy.concatenate([areas(picture.true) for picture in pictures]),
    )


class AveragePrecision(unittest.TestCase):
    def test_by_hand(self):
        # Hit, miss, hit, ignored, miss, of three truths: precision 1 at recall 1/3, 2/3 at 2/3.
        scores, outcomes = [0.5, 0.9, 0.8, 0.6, 0.7], [0, 1, 0, 2, 1]
        for rule, expected in (("voc2010", 5 / 9), ("voc2007", 6 / 11), ("coco", 56 / 101)):
            self.assertAlmostEqual(vesica.average_precision(scores, outcomes, 3, rule=rule), expected, 14)
        self.assertTrue(math.isnan(vesica.average_precision([], [], 0)))

    def test_is_that_of_coco(self):
        generator, seen = numpy.random.default_rng(17), []
        thresholds = numpy.linspace(0.5, 0.95, 10)
        for _ in range(25):
            pictures = [Picture(generator) for _ in range(generator.integers(1, 5))]
            for most, least_area, most_area in ((100, 0, 1e10), (100, 4, 16), (5, 0, 1e10)):
                pairs, scores, found_areas, crowd, true_areas = numbered_through(pictures, most)
                outside = (true_areas < least_area) | (true_areas > most_area)
                flags = numpy.where(crowd, vesica.Truth.CROWD, numpy.where(outside, vesica.Truth.IGNORED, 0))
                # A crowd outside is a crowd still.
                outcomes, _ = vesica.match_truths(*pairs, scores, len(flags), thresholds, flags=flags)
                foreign = (found_areas < least_area) | (found_areas > most_area)
                outcomes[(outcomes == vesica.Outcome.MISS) & foreign] = vesica.Outcome.IGNORED
                count = numpy.count_nonzero(flags == 0)
                result = vesica.average_precision(scores, outcomes, count)
                expected = [coco_by_rows(pictures, t, most, least_area, most_area) for t in thresholds]
                numpy.testing.assert_allclose(result, expected, rtol=0, atol=1e-13)
                seen += [x for x in expected if 0 < x < 1]
        self.assertGreater(len(seen), 300)

    def test_is_that_of_voc(self):
        generator, seen = numpy.random.default_rng(19), []
        for _ in range(60):
            pictures = [Picture(generator) for _ in range(generator.integers(1, 5))]
            for picture in pictures:
                # VOC has IoU for difficult truths too.
                picture.pairs[1] = picture.pairs[0]
                picture.iou[:] = 0
                picture.iou[picture.pairs[0][0], picture.pairs[0][1]] = picture.pairs[0][2]
            pairs, scores, _, crowd, _ = numbered_through(pictures)
            outcomes, _ = vesica.match_truths(*pairs, scores, len(crowd), 0.5, rule="voc", flags=crowd)
            for points, rule in ((11, "voc2007"), (None, "voc2010")):
                result = vesica.average_precision(scores, outcomes, numpy.count_nonzero(~crowd), rule=rule)
                expected = voc_by_rows(pictures, 0.5, points)
                numpy.testing.assert_allclose(result, expected, rtol=0, atol=1e-13)
                seen += [expected] if 0 < expected < 1 else []
        self.assertGreater(len(seen), 60)

    def test_refusals(self):
        pair = [0], [0], [1.0]
        for wrong in (
            lambda: vesica.match_truths(*pair, [1], 1, rule="pascal"),
            lambda: vesica.match_truths(*pair, [1], 0),
            lambda: vesica.match_truths(*pair, [math.nan], 1),
            lambda: vesica.match_truths(*pair, [1], 1, math.nan),
            lambda: vesica.match_truths(*pair, [1], 1, flags=[3]),
            lambda: vesica.match_truths(*pair, [1], 1, flags=[0, 0]),
            lambda: vesica.match_truths(*pair, [1], -1),
            lambda: vesica.average_precision([1], [1], 0),
            lambda: vesica.average_precision([1], [1, 0], 2),
            lambda: vesica.average_precision([1], [-1], 2),
            lambda: vesica.average_precision([1], [1], 2, rule="voc"),
        ):
            self.assertRaises(ValueError, wrong)
        self.assertRaises(TypeError, vesica.average_precision, [1], [0.5], 2)
        self.assertEqual(vesica.match_truths(*pair, [1], 1)[0].tolist(), [vesica.Outcome.HIT])


if __name__ == "__main__":
    unittest.main()
