# SPDX-License-Identifier: Apache-2.0
"""Two threads against one, by `threads=` of the Python package: large arrays, index builds and joins.

Each pass has fresh rectangles, which one thread and two are asked in turns; the least of several passes, in ms.
"""
import math
import time

import numpy

import vesica

PASSES = 6
COUNT = 1_000_000
SIDE = 3_000  # of a matrix


def scattered(random, count):
    """Rectangles about 1 wide and high, 0.4 to a unit of area."""
    width = math.sqrt(count / 0.4)
    rows = numpy.empty((count, 5))
    rows[:, :2] = random.uniform(0, width, (count, 2))
    rows[:, 2:4] = random.uniform(0.2, 1.8, (count, 2))
    rows[:, 4] = random.uniform(0, 360, count)
    return vesica.rects(rows, degrees=True)


def questions(a, b):
    index_a, index_b, some = vesica.Index(a), vesica.Index(b), slice(0, SIDE)
    return {
        "build an index": lambda threads: vesica.Index(a, threads=threads),
        "join": lambda threads: index_a.join(index_b, threads=threads),
        "overlap, in step": lambda threads: vesica.overlap(a, b, threads=threads),
        "IoU, in step": lambda threads: vesica.iou(a, b, threads=threads),
        "IoU, a matrix of 3,000 x 3,000": lambda threads: vesica.iou_matrix(a[some], b[some], threads=threads),
        "nearest, in step": lambda threads: vesica.nearest(a, b, threads=threads),
    }


def main():
    random = numpy.random.default_rng()
    times = {}
    for number in range(PASSES):
        for name, ask in questions(scattered(random, COUNT), scattered(random, COUNT)).items():
            best = times.setdefault(name, {1: math.inf, 2: math.inf})
            for threads in (1, 2) if number % 2 else (2, 1):
                begin = time.perf_counter()
                ask(threads)
                best[threads] = min(best[threads], time.perf_counter() - begin)
    print(f"\n10^6 rectangles a side, {PASSES} passes\n\n{'':32}{'1 thread':>10}{'2':>10}{'ratio':>8}")
    for name, best in times.items():
        print(f"{name:32}{1e3 * best[1]:10.1f}{1e3 * best[2]:10.1f}{best[1] / best[2]:8.2f}")


if __name__ == "__main__":
    main()
