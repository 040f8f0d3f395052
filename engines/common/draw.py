# SPDX-License-Identifier: Apache-2.0
"""draw.py COUNT FOLDER: the shapes that every engine joins, a.csv and b.csv in words and a.npy and b.npy as records.

Shapes of all kinds, mixed; numbers are short, so that many touch exactly. There are about 0.8 pairs a shape of a,
whatever COUNT is. The stream of numpy's RandomState is frozen, so that all versions draw the same.
"""
import pathlib
import sys

import numpy

KINDS = ("point", "segment", "circle", "aabb", "rect", "ellipse")
FIELDS = (2, 4, 3, 4, 6, 6)
RECORD = numpy.dtype([("kind", "<i8"), ("numbers", "<f8", 7)])
AXES = numpy.array([(1, 0), (0, 1), (0.75, 0.5), (-1, 1), (0.6, 0.8), (-0.28, 0.96)])
STEP = 1 / 8  # of all coordinates and sizes


def draw(count, seed):
    random = numpy.random.RandomState(seed)
    side = max(1, int(8 * 1.6 * count**0.5))
    shapes = numpy.zeros(count, RECORD)
    shapes["kind"] = random.randint(0, 6, count)
    x, y = random.randint(0, side, (2, count)) * STEP
    h, k = random.randint(0, 9, (2, count)) * STEP
    axis = AXES[random.randint(0, len(AXES), count)]
    columns = {
        0: (x, y),
        1: (x, y, x + h, y + k),
        2: (x, y, h),
        3: (x, y, x + h, y + k),
        4: (x, y, axis[:, 0], axis[:, 1], h, k),
        5: (x, y, axis[:, 0], axis[:, 1], h, k),
    }
    for kind, numbers in columns.items():
        of_kind = shapes["kind"] == kind
        for i, column in enumerate(numbers):
            shapes["numbers"][of_kind, i] = column[of_kind]
    return shapes


def words(shape):
    kind = shape["kind"]
    return " ".join((KINDS[kind], *map(repr, shape["numbers"][: FIELDS[kind]].tolist())))


def main(count, folder):
    folder = pathlib.Path(folder)
    for seed, name in enumerate("ab"):
        shapes = draw(int(float(count)), seed)
        numpy.save(folder / f"{name}.npy", shapes)
        with open(folder / f"{name}.csv", "w") as file:
            file.writelines(words(shape) + "\n" for shape in shapes)


if __name__ == "__main__":
    main(*sys.argv[1:])
