# SPDX-License-Identifier: Apache-2.0
"""Convex hulls of points, and the smallest rectangles about them."""
import numpy

from ._library import by_scalar, checked, first_rows
from .paths import Paths, polygons
from .queries import numbers_of
from .shapes import Kind, shapes

_CONVEX_HULL = by_scalar("convex_hull")
_MIN_AREA_RECTS, _MIN_PERIMETER_RECTS = by_scalar("min_area_rect_many"), by_scalar("min_perimeter_rect_many")


def convex_hull(points):
    """The corners (m, 2) of the hull of points (n, 2), exact, counter-clockwise where y points up.

    They begin at the lowest of the leftmost points; none is on the line between its neighbours. points: what `polygons`
    takes as a single one, or a polygon or polyline, whose vertices are meant.
    """
    path = _paths(points)
    if not path.single:
        raise ValueError(f"convex_hull takes the points (n, 2) of one shape, not an array of {len(path)} shapes")
    out = numpy.empty((sum(len(ring) for ring in path.rings[0]), 2), path.dtype)
    count = checked(_CONVEX_HULL[path.letter](path.record, out.ctypes.data, len(out)))
    return first_rows(out, count)


def min_area_rects(points, threads=None):
    """The rectangles of the least area that contain the points of each shape, in any order.

    points: what `polygons` takes, such as quads (n, 4, 2), or polygons or polylines, whose vertices are meant. A side of
    each rectangle lies along an edge of the hull; its axis is that edge's direction.
    """
    return _smallest(points, _MIN_AREA_RECTS, threads)


def min_perimeter_rects(points, threads=None):
    """The rectangles of the least perimeter; else as min_area_rects."""
    return _smallest(points, _MIN_PERIMETER_RECTS, threads)


def _paths(points):
    return points if isinstance(points, Paths) else polygons(points)


def _smallest(points, functions, threads):
    return shapes(Kind.RECT, numbers_of(_paths(points), functions, 6, threads))
