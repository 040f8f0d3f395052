# SPDX-License-Identifier: Apache-2.0
"""Shares of pixels, hulls, smallest rectangles and Gaussians, beside photutils, sep, OpenCV and numpy, from Python.

Each row has fresh shapes in every call and is the least of several passes, in ns a call. "call" is a call of C from
ctypes that does nothing, which the numbers of vesica include; the peers' calls are those of their own extensions. Peers
that are not installed have no number.
"""
import ctypes
import math
import time

import numpy

import vesica
from vesica import _declarations

PASSES = 9


def peer(name):
    try:
        return __import__(name, fromlist=["*"])
    except ImportError:
        return None


def least(function, arguments):
    """ns a call."""
    best = math.inf
    for _ in range(PASSES):
        start = time.perf_counter()
        for each in arguments:
            function(*each)
        best = min(best, time.perf_counter() - start)
    return best / len(arguments) * 1e9


def row(name, ours, *theirs):
    cells = [f"{time:12.0f}" if time is not None else f"{'':12}" for time in (ours, *theirs)]
    print(f"{name:34}" + "".join(cells), flush=True)


def pixels(random):
    geometry, sep = peer("photutils.geometry"), peer("sep")
    ask = vesica.c.vesica_coverage_f64
    for radius in (3, 5, 10, 30):
        size, calls = 2 * radius + 3, max(50, 20000 // radius)
        places = random.uniform(size / 2 - 0.5, size / 2 + 0.5, (calls, 2))
        out = numpy.empty((size, size))
        grid = _declarations.grid_f64(0, 0, 1, 1, size, size)
        for kind, ratio, turn in (("disc", 1, 0), ("ellipse", 0.4, 0.5)):
            ours, theirs = [], []
            for x, y in places:
                shape = (
                    _declarations.circle_f64(x, y, radius)
                    if kind == "disc"
                    else _declarations.ellipse_f64(x, y, math.cos(turn), math.sin(turn), radius, radius * ratio)
                )
                number = int(vesica.Kind.CIRCLE if kind == "disc" else vesica.Kind.ELLIPSE)
                ours.append((number, ctypes.addressof(shape), ctypes.addressof(grid), out.ctypes.data, size, shape))
                box = (-x, size - x, -y, size - y, size, size)
                theirs.append((*box, radius, 1, 1) if kind == "disc" else (*box, radius, radius * ratio, turn, 1, 1))
            time_of_peer = None
            if geometry:
                function = geometry.circular_overlap_grid if kind == "disc" else geometry.elliptical_overlap_grid
                time_of_peer = least(function, theirs)
            row(f"pixels of a {kind}, radius {radius}", least(lambda *a: ask(*a[:5]), ours), time_of_peer)
        if sep:
            image = numpy.ones((size, size))
            sums = [(image, x - 0.5, y - 0.5, radius) for x, y in places]
            exact = least(lambda data, x, y, r: sep.sum_circle(data, [x], [y], r, subpix=0), sums)
            row(f"  sep: sum in a disc, radius {radius}", None, exact)


def points(random):
    cv = peer("cv2")
    for count in (4, 8, 64, 1000):
        sets = random.uniform(-1, 1, (2000 if count < 1000 else 200, count, 2)).astype(numpy.float32)
        out = numpy.empty((count, 2), numpy.float32)
        rect = _declarations.rect_f32()
        paths = [_declarations.polygon_f32(s.ctypes.data, s.ctypes.data + 4, 8, None, count) for s in sets]
        hulls = [(ctypes.addressof(p), out.ctypes.data, count) for p in paths]
        rects = [(ctypes.addressof(p), ctypes.addressof(rect)) for p in paths]
        by_cv = [(s,) for s in sets]
        row(f"hull of {count} points", least(vesica.c.vesica_convex_hull_f32, hulls),
            least(cv.convexHull, by_cv) if cv else None)  # fmt: skip
        row(f"smallest rectangle of {count} points", least(vesica.c.vesica_min_area_rect_f32, rects),
            least(cv.minAreaRect, by_cv) if cv else None)  # fmt: skip


def gaussians(random):
    """ProbIoU of 1,000 rectangles with 1,000, ns a pair on one thread; beside the formula in numpy."""

    def in_numpy(p, q):
        def covariance(rows):
            a, b, angle = rows[:, 2] ** 2 / 12, rows[:, 3] ** 2 / 12, rows[:, 4]
            c, s = numpy.cos(angle), numpy.sin(angle)
            return a * c * c + b * s * s, a * s * s + b * c * c, (a - b) * c * s

        (a, b, c), (d, e, f) = ([v[:, None] for v in covariance(p)], covariance(q))
        dx, dy = p[:, 0, None] - q[:, 0], p[:, 1, None] - q[:, 1]
        det = (a + d) * (b + e) - (c + f) ** 2
        means = ((a + d) * dy**2 + (b + e) * dx**2 - 2 * (c + f) * dx * dy) / (4 * det)
        sizes = numpy.log(det / (4 * numpy.sqrt((a * b - c * c) * (d * e - f * f)))) / 2
        return 1 - numpy.sqrt(1 - numpy.exp(-means - sizes))

    n, low, high = 1000, [0, 0, 2, 2, 0], [100, 100, 20, 20, 3]
    p, q = random.uniform(low, high, (n, 5)), random.uniform(low, high, (n, 5))
    a, b = vesica.rects(p), vesica.rects(q)
    for which in vesica.Gaussian:
        ours = least(lambda: vesica.gaussian_distance_matrix(which, a, b, threads=1), [()])
        numpys = least(lambda: in_numpy(p, q), [()]) / n**2 if which == vesica.Gaussian.HELLINGER else None
        row(f"Gaussians, {which.name.lower()}: a pair", ours / n**2, numpys)


def main():
    print(f"{'ns a call':34}{'vesica':>12}{'peer':>12}")
    row("call", least(vesica.c.vesica_version, [()] * 20000))
    pixels(numpy.random.default_rng(1))
    points(numpy.random.default_rng(2))
    gaussians(numpy.random.default_rng(3))


if __name__ == "__main__":
    main()
