# SPDX-License-Identifier: Apache-2.0
"""How the parts of two single shapes meet: nine-intersection matrices, and the region that they share."""
import ctypes

import numpy

from . import _declarations
from ._library import VesicaError, by_scalar, checked, library
from .shapes import accepted, all_points, same_scalar

_DE9IM, _INTERSECTION = by_scalar("de9im"), by_scalar("intersection")


def _two(a, b, what):
    if not (a.single and b.single):
        raise TypeError(f"{what} is of two single shapes: take a[i] and b[i]")


def de9im(a, b):
    """The nine-intersection matrix of two single shapes, as geographic systems have it, such as "FF2F11212". Exact."""
    letter = same_scalar(a, b)
    _two(a, b, "a nine-intersection matrix")
    out = ctypes.create_string_buffer(10)
    accepted(_DE9IM[letter](a.kind, a.record, b.kind, b.record, out), a=a, b=b)
    return out.value.decode()


def de9im_match(matrix, pattern):
    """Does a nine-intersection matrix fit a pattern of F, 0, 1, 2, T (any of 0, 1 and 2) and * (anything)?"""
    for name, text in (("matrix", matrix), ("pattern", pattern)):
        if not isinstance(text, str):
            raise TypeError(f"{name} is a text of nine characters, not {type(text).__name__}")
        if len(text) != 9 or set(text) - set("F012T*"[: 4 if name == "matrix" else 6]):
            of = "F, 0, 1 and 2" if name == "matrix" else "F, 0, 1, 2, T and *"
            raise VesicaError(_declarations.E_ARGUMENT, f"{name} is {text!r}, not nine characters of {of}")
    return bool(checked(library.vesica_de9im_match(matrix.encode(), pattern.encode())))


def intersection(a, b):
    """The vertices (n, 2) of the region that two shapes share, counter-clockwise; n is 0 where they do not overlap.

    Of points, segments, aabbs, rects and convex polygons; also of a point or a segment and any shape. Of a segment and
    a polygon or a polyline, two vertices for each piece, in order along the segment.
    """
    letter = same_scalar(a, b)
    _two(a, b, "a shared region")
    return all_points(_INTERSECTION[letter], a, b)
