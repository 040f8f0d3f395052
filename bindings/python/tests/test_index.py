# SPDX-License-Identifier: Apache-2.0
"""Index and join against every pair."""
import copy
import math
import mmap
import pickle
import tempfile
import unittest

import numpy
import vesica
from vesica import Kind

from test_queries import ROUNDED, random_shapes


def mixed(count, generator, dtype, kinds=vesica.FIELDS):
    sets = []
    for kind in kinds:
        shapes = random_shapes(kind, count, generator, dtype)
        sets.append(vesica.shapes(kind, spread(shapes, generator)))
    return sets


def spread(shapes, generator):
    """Smaller and further apart, each number of a shape's places moved alike."""
    numbers, moves = shapes.numbers, generator.uniform(-8, 8, (len(shapes), 2)).astype(shapes.dtype)
    for k in range(0, 4 if shapes.kind in (Kind.SEGMENT, Kind.AABB, Kind.CAPSULE) else 2, 2):
        numbers[:, k : k + 2] += moves
    return numbers


def _aligned_copy(data):
    """A writable copy at an address that needs no other."""
    room = numpy.empty(len(data) + 64, numpy.uint8)
    start = -room.ctypes.data % 64
    room[start : start + len(data)] = data
    return room[start : start + len(data)]


class Index(unittest.TestCase):
    def pairs_by_matrix(self, matrix, a, b):
        rows = [numpy.concatenate([matrix(x, y) for y in b], axis=1) for x in a]
        return {tuple(pair) for pair in numpy.argwhere(numpy.concatenate(rows))}

    def test_joins(self):
        generator = numpy.random.default_rng(7)
        kinds = [kind for kind in vesica.FIELDS if kind not in ROUNDED]
        for dtype in ("f8", "f4"):
            a, b = mixed(40, generator, dtype, kinds), mixed(30, generator, dtype, kinds)
            index_a, index_b = vesica.Index(*a), vesica.Index(*b)
            for query in ("overlap", "contains", "inside"):
                expected = self.pairs_by_matrix(
                    vesica.overlap_matrix if query == "overlap" else vesica.contains_matrix,
                    *((a, b) if query != "inside" else (b, a)),
                )
                if query == "inside":
                    expected = {(j, i) for i, j in expected}
                self.assertTrue(expected)
                found = list(zip(*index_a.join(index_b, query)))
                self.assertEqual(len(found), len(set(found)))
                self.assertEqual(set(found), expected)
                self.assertEqual(index_a.join_count(index_b, query), len(expected))
                parts = [index_a.join(index_b, query, part, 3) for part in range(3)]
                self.assertEqual([pair for part in parts for pair in zip(*part)], found)
            self.assertLessEqual(expected, set(zip(*index_a.join(index_b, "bounds"))))
            own = self.pairs_by_matrix(vesica.overlap_matrix, a, a)
            self.assertEqual(set(zip(*index_a.join())), {(i, j) for i, j in own if i < j})

    def test_joins_of_all_kinds(self):
        generator = numpy.random.default_rng(8)
        a, b = mixed(40, generator, "f8"), mixed(30, generator, "f8")
        index_a, index_b = vesica.Index(*a), vesica.Index(*b)
        self.assertEqual(set(zip(*index_a.join(index_b))), self.pairs_by_matrix(vesica.overlap_matrix, a, b))
        near = self.pairs_by_matrix(lambda x, y: vesica.within_matrix(x, y, 0.5), a, b)
        self.assertEqual(set(zip(*index_a.join_within(index_b, 0.5))), near)
        contained = self.pairs_by_matrix(vesica.contains_matrix, a, b)
        self.assertEqual(set(zip(*index_a.join(index_b, "contains"))), contained)

    def test_more_pairs_than_a_call_gives(self):
        same = vesica.circles(numpy.ones((500, 3)))
        self.assertEqual(len(vesica.Index(same).join()[0]), 500 * 499 // 2)

    def test_more_items_than_a_call_gives(self):
        for count in (255, 256, 257, 70_000):
            index = vesica.Index(vesica.circles(numpy.ones((count, 3))))
            for found in (index.select(vesica.points([1, 1])), index.cast(vesica.points([-5, 1]), (1, 0))):
                self.assertEqual(sorted(found.tolist()), list(range(count)))
        self.assertEqual(index.select(vesica.points([9, 9])).tolist(), [])

    def test_windows_and_nearest(self):
        generator = numpy.random.default_rng(3)
        sets = mixed(50, generator, "f8")
        index = vesica.Index(*sets)
        for probe in mixed(3, generator, "f8"):
            for one in probe:
                hits = numpy.concatenate([vesica.overlap(one, shapes) for shapes in sets])
                self.assertEqual(sorted(index.select(one)), numpy.flatnonzero(hits).tolist())
                distances = numpy.concatenate([vesica.nearest(shapes, one).distance for shapes in sets])
                items, found = index.nearest(one, 5)
                expected = sorted(zip(distances, range(len(distances))))[:5]
                self.assertEqual(list(zip(found, items)), expected)
                self.assertEqual(len(index.nearest(one, len(index), 1.0)[0]), (distances <= 1).sum())
        rows, far = index.nearest_of_each(sets[0], sets[4], k=3)
        for i in (0, 7, 60):
            one = sets[0][i] if i < 50 else sets[4][i - 50]
            items, distance = index.nearest(one, 3)
            self.assertEqual((rows[i].tolist(), far[i].tolist()), (items.tolist(), distance.tolist()))

    def test_bytes(self):
        shapes = vesica.circles(numpy.random.default_rng(5).random((3000, 3)) * [100, 100, 1])
        index = vesica.Index(shapes)
        with tempfile.TemporaryFile() as file:
            file.write(index.bytes)
            file.flush()
            mapped = vesica.Index.from_bytes(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ), shapes)
        again = vesica.Index.from_bytes(b"\0" * 0 + index.bytes.tobytes(), shapes)
        for other in (mapped, again):
            numpy.testing.assert_array_equal(index.join(), other.join())
        damaged = bytearray(index.bytes.tobytes())
        damaged[100] ^= 1
        for wrong in (damaged, index.bytes[:1000].tobytes(), b"", b"x" * 5000):
            with self.assertRaises(vesica.VesicaError):
                vesica.Index.from_bytes(wrong, shapes)
        with self.assertRaisesRegex(ValueError, "index of 3000 shapes cannot be that of 10"):
            vesica.Index.from_bytes(index.bytes, shapes[:10])

    def test_joins_with_the_same_bytes(self):
        discs, moved = vesica.circles(numpy.ones((40, 3))), vesica.circles(numpy.ones((40, 3)) * [1, 100, 1])
        index = vesica.Index(discs)
        in_place = vesica.Index.from_bytes(index.bytes, discs)
        self.assertTrue(numpy.may_share_memory(in_place.bytes, index.bytes))
        for other in (in_place, vesica.Index.from_bytes(index.bytes.tobytes(), discs), vesica.Index(discs)):
            self.assertEqual((len(index.join(other)[0]), index.join_count(other)), (1600, 1600))
            self.assertEqual(len(index.join_within(other, 1)[0]), 1600)
        for other in (None, index):
            self.assertEqual((len(index.join(other)[0]), index.join_count(other)), (780, 780))
            self.assertEqual(len(index.join_within(other, 1)[0]), 780)
        self.assertEqual(len(index.join(vesica.Index.from_bytes(index.bytes, moved))[0]), 0)

    def test_bytes_cannot_be_changed(self):
        shapes = vesica.circles(numpy.random.default_rng(5).random((3000, 3)) * [100, 100, 1])
        index = vesica.Index(shapes)
        expected, saved = index.join_count(), _aligned_copy(index.bytes)
        writable, frozen = saved.copy(), saved.view()
        frozen.flags.writeable = False
        indexes = [index, *(vesica.Index.from_bytes(data, shapes) for data in (saved, bytearray(writable), frozen))]
        for each in indexes:
            with self.assertRaises(ValueError):
                each.bytes[:] = 255
            with self.assertRaises(ValueError):
                each.bytes.flags.writeable = True
            for name, value in (("bytes", saved), ("sets", (shapes, shapes))):
                with self.assertRaises(AttributeError):
                    setattr(each, name, value)
        in_place = [numpy.may_share_memory(each.bytes, saved) for each in indexes]
        self.assertEqual(in_place, [False, False, False, True])
        saved[:] = 255
        for each in indexes[:3]:
            self.assertEqual(each.join_count(), expected)

    def test_copies(self):
        for dtype in ("f8", "f4"):
            index = vesica.Index(*mixed(40, numpy.random.default_rng(9), dtype))
            for again in (pickle.loads(pickle.dumps(index)), copy.copy(index), copy.deepcopy(index)):
                self.assertEqual((len(again), again.incomplete), (len(index), False))
                numpy.testing.assert_array_equal(again.join(), index.join())
                self.assertFalse(again.bytes.flags.writeable)

    def test_what_it_is(self):
        shapes = vesica.circles([[0, 0, 1], [5, 5, -1], [3, 0, 1]])
        index = vesica.Index(shapes, vesica.points([]))
        self.assertTrue(index.incomplete)
        self.assertEqual((len(index), sorted(index.order())), (3, [0, 2]))
        box = index.bounds()
        self.assertTrue(-1.1 < box[0] <= -1 and 4 <= box[2] < 4.1)
        self.assertEqual(index.nearest(shapes[0], 0)[0].tolist(), [])
        self.assertEqual(index.nearest(vesica.points([9, 0]), 1, within=math.inf)[1].tolist(), [5])

    def test_refused(self):
        circles = vesica.circles([[0, 0, 1]])
        index = vesica.Index(circles)
        wrong_parts = (
            (vesica.VesicaError, {"parts": 2**64 + 1}),
            (vesica.VesicaError, {"part": 2**64}),
            (vesica.VesicaError, {"part": -1, "parts": 2}),
            (TypeError, {"part": 0.9}),
            (TypeError, {"parts": 1.5}),
        )
        for error, call in (
            (TypeError, lambda: vesica.Index([[0, 0, 1]])),
            (ValueError, lambda: vesica.Index()),
            (TypeError, lambda: vesica.Index(circles, circles.astype("f4"))),
            (TypeError, lambda: index.join(vesica.Index(circles.astype("f4")))),
            (ValueError, lambda: index.join(query="near")),
            (vesica.VesicaError, lambda: index.join(part=2, parts=2)),
            *((error, lambda how=how: index.join(**how)) for error, how in wrong_parts),
            *((error, lambda how=how: index.join_within(None, 1, **how)) for error, how in wrong_parts),
            *((error, lambda how=how: index.join_count(**how)) for error, how in wrong_parts),
            (TypeError, lambda: index.join_within(1, None)),
            (TypeError, lambda: index.select([0, 0, 1])),
            (vesica.VesicaError, lambda: index.nearest(circles[0], 1, -1)),
            (ValueError, lambda: index.nearest(circles[0], -1)),
            (TypeError, lambda: index.nearest(circles[0], b"99")),
            (TypeError, lambda: index.nearest_of_each(circles, k=(2, 2))),
        ):
            with self.assertRaises(error):
                call()


if __name__ == "__main__":
    unittest.main()
