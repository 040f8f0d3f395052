# SPDX-License-Identifier: Apache-2.0
"""index.py: index and join by vesica_index.py. The hashes are those of tests/index/same_bytes_test.cpp."""
import sys

import numpy
import vesica
from vesica import CIRCLE, POINT, RECT
from vesica_index import CONTAINS, Index, join

MASK = 2**64 - 1


def touching(count, seed):
    """Rectangles, circles and points over 20 scales, many of which touch."""

    def draw(below):
        nonlocal seed
        seed = (seed * 6364136223846793005 + 1442695040888963407) & MASK
        return (seed >> 33) % below

    rects, circles, points = [], [], []
    for i in range(count):
        unit = 2.0 ** -draw(20) if i % 7 == 0 else 1.0
        x, y = draw(60) * unit, draw(60) * unit
        if i % 5 == 0:
            circles.append((x, y, unit / 2))
        elif i % 5 == 1:
            points.append((x + unit / 2, y))
        else:
            rects.append((x, y, i % 2, 1 - i % 3 / 4, unit / 2, unit / 4))
    return (RECT, numpy.array(rects)), (CIRCLE, numpy.array(circles)), (POINT, numpy.array(points))


def fnv(numbers):
    state = 0xCBF29CE484222325
    for number in numbers:
        state = (state ^ number) * 0x100000001B3 & MASK
    return state


def hash_pairs(pairs):
    return fnv(numpy.stack(pairs, axis=1).ravel().tolist())


a, b = Index(*touching(9000, 1)), Index(*touching(7000, 2))
if sys.byteorder == "little":
    assert fnv(a.bytes()) == 14017431053294008823
assert hash_pairs(join(a, b)) == 9459960488521776375
assert hash_pairs(join(a)) == 12175247251169411526
assert hash_pairs(join(a, room=7)) == 12175247251169411526
floats = [Index(*((kind, array.astype("f4")) for kind, array in touching(n, s))) for n, s in ((9000, 1), (7000, 2))]
assert hash_pairs(join(*floats)) == 9459960488521776375

# Known answers: squares of half size 1 in a row, 2 apart, so that neighbours touch; columns of a structured array.
row = numpy.zeros(10, [("name", "S4"), *((field, "f8") for field in vesica.FIELDS[RECT])])
row["cx"], row["ux"], row["hx"], row["hy"] = 2 * numpy.arange(10), 1, 1, 1
squares = Index((RECT, row))
assert len(squares) == 10 and not squares.has_invalid and sorted(squares.order()) == list(range(10))
assert sorted(zip(*map(numpy.ndarray.tolist, join(squares)))) == [(i, i + 1) for i in range(9)]
assert sorted(squares.select(CIRCLE, (6, 3, 2)).tolist()) == [3]
assert sorted(squares.select(POINT, (7, 0)).tolist()) == [3, 4]
assert squares.select(POINT, (7, 2)).size == 0
items, distance = squares.nearest(POINT, (7, 3), 4)
assert items.tolist() == [3, 4, 2, 5] and distance.tolist() == [2, 2, 8**0.5, 8**0.5]
assert [part.size for part in squares.nearest(POINT, (7, 3), 4, within=2)] == [2, 2]
dot = Index((POINT, numpy.array([[4.0, 1.0]])))
assert [side.tolist() for side in join(squares, dot, CONTAINS)] == [[2], [0]]

# Saved bytes answer as they did; damaged ones are refused; an invalid shape is left out, and said.
again = Index((RECT, row), data=squares.bytes())
assert hash_pairs(join(again)) == hash_pairs(join(squares))
for damaged in (squares.bytes()[:-64], b"\xff" + squares.bytes()[1:], b""):
    try:
        Index((RECT, row), data=damaged)
        raise SystemExit("a damaged index is taken")
    except vesica.VesicaError as error:
        assert error.code == -10, error
row["hx"][5] = -1
broken = Index((RECT, row))
assert broken.has_invalid and len(broken.order()) == 9 and len(join(broken)[0]) == 7
print("index: as in C")
