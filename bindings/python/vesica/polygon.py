# SPDX-License-Identifier: Apache-2.0
"""A single polygon: facts about it, and boxes about its edges for one that is asked again and again."""
import ctypes
from typing import NamedTuple

import numpy

from . import _declarations
from ._library import VesicaError, by_scalar, checked, library, real
from .paths import Paths
from .queries import ClosestPoints, Within
from .shapes import Kind, accepted, one_shape, same_scalar

_FACTS = by_scalar("polygon_facts")
_FACTS_RECORDS = {"d": _declarations.facts_f64, "f": _declarations.facts_f32}
_BOXES, _OVERLAP = by_scalar("polygon_boxes"), by_scalar("polygon_boxes_overlap")
_NEAREST, _WITHIN = by_scalar("polygon_boxes_nearest"), by_scalar("polygon_boxes_within")
_CLOSEST = {"d": _declarations.closest_points_f64, "f": _declarations.closest_points_f32}


class Facts(NamedTuple):
    """What polygon_facts says of a polygon.

    vertices: without repeated ones. first_crossing, second_crossing: the vertices at which two edges that cross begin,
    or -1. area: negative if the inside is on the right of the first ring's edges. orientation: 1 if it is on the left
    (counter-clockwise where y points up), -1 on the right, 0 without an area.
    """

    vertices: int
    first_crossing: int
    second_crossing: int
    area: float
    orientation: int
    convex: bool
    simple: bool
    rings: int


def _path(value, name):
    if not isinstance(value, Paths):
        raise TypeError(f"{name} is of the type {type(value).__name__}, not a polygon: vesica.polygons makes one")
    if not value.single:
        raise TypeError(f"{name} is an array of {len(value)} polygons, not a single one: take {name}[i]")
    return value


def polygon_facts(polygon):
    """Facts about a single polygon: is it simple, is it convex, which edges cross, and which way round does it go?

    Exact, but the area, which is as of shape_area. If edges cross, area and orientation have no meaning.
    """
    if _path(polygon, "polygon").kind != Kind.POLYGON:
        raise VesicaError(_declarations.E_KIND, "not for polyline shapes")
    record = _FACTS_RECORDS[polygon.letter]()
    accepted(_FACTS[polygon.letter](polygon.record, ctypes.byref(record)), polygon=polygon)
    facts = Facts(*(getattr(record, field) for field in Facts._fields))
    return facts._replace(convex=bool(facts.convex), simple=bool(facts.simple))


class PolygonBoxes:
    """Boxes about the edges of one large polygon or polyline that is asked about single shapes again and again.

    Answers are those of overlap, nearest and within, bit for bit. The vertices must stay as they were. Functions of
    arrays need no such boxes: they make their own.
    """

    def __init__(self, path):
        self.path = _path(path, "path")
        vertices = max(sum(len(ring) for ring in path.rings[0]), 1)
        self._boxes = numpy.zeros(checked(library.vesica_polygon_boxes_size(vertices)) // 8 + 1, numpy.int64)
        code = _BOXES[path.letter](path.kind, path.record, self._boxes.ctypes.data, self._boxes.nbytes)
        accepted(code, path=path)

    def __repr__(self):
        return f"<vesica boxes about the edges of {self.path!r}>"

    def _ask(self, functions, other, *more):
        same_scalar(self.path, one_shape(other, "other"), "the path", "other")
        path = (self.path.kind, self.path.record, self._boxes.ctypes.data, self._boxes.nbytes)
        other = other if other.single else other[0]
        return accepted(functions[other.letter](*path, other.kind, other.record, *more), path=self.path, other=other)

    def overlap(self, other):
        """Does a single shape share a point with the path? Exact."""
        return bool(self._ask(_OVERLAP, other))

    def nearest(self, other):
        """How far is a single shape from the path, and which of their points are closest? ClosestPoints."""
        record = _CLOSEST[self.path.letter]()
        self._ask(_NEAREST, other, ctypes.byref(record))
        return ClosestPoints(*(getattr(record, field) for field in ClosestPoints._fields))

    def within(self, other, distance):
        """Is a single shape at most `distance` from the path? A Within, as vesica.within gives it."""
        return Within(self._ask(_WITHIN, other, real(distance, "distance", self.path.dtype)))
