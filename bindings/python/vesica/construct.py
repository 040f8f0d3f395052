# SPDX-License-Identifier: Apache-2.0
"""Shapes from other descriptions, which the C library makes one by one: about 2 us each."""
import numpy

from ._library import by_scalar, plainly
from .shapes import Kind, constructed, fault_of, floats_of, rows_of

_AABB, _RADIUS_VECTOR = by_scalar("aabb_from_corners"), by_scalar("ellipse_from_radius_vector")
_CAPSULE_FROM_WIDTH, _CAPSULE_FROM_ANGLE = by_scalar("capsule_from_width"), by_scalar("capsule_from_angle")
_MATRIX = by_scalar("ellipse_from_matrix")


def _from_rows(kind, functions, array, what, names, order=None):
    """Shapes from rows of the named numbers; order: in which the function takes them."""
    rows, single = rows_of(array, what, *names)
    given = rows if order is None else rows[:, order]
    return constructed(kind, functions, given, single, lambda i: fault_of(names, rows[i]))


def aabbs_from_corners(array):
    """Boxes along the axes from (n, 4): x0, y0, x1, y1 of two opposite corners, in any order."""
    return _from_rows(Kind.AABB, _AABB, array, "aabbs_from_corners", ("x0", "y0", "x1", "y1"))


def capsules_from_width(array):
    """Capsules from (n, 5): the ends x0, y0, x1, y1 of lines with round ends, and their full width."""
    return _from_rows(Kind.CAPSULE, _CAPSULE_FROM_WIDTH, array, "capsules_from_width", ("x0", "y0", "x1", "y1", "width"))


def capsules_from_angle(array):
    """Capsules from (n, 5): centre x, y, length between the ends of the segment, angle in radians, radius."""
    names = ("x", "y", "length", "angle", "radius")
    return _from_rows(Kind.CAPSULE, _CAPSULE_FROM_ANGLE, array, "capsules_from_angle", names, [0, 1, 3, 2, 4])


def ellipses_from_radius_vector(array):
    """Ellipses from (n, 5): centre x, y, one half axis as a vector wx, wy, and the other's length as a ratio to it."""
    names = ("x", "y", "wx", "wy", "ratio")
    return _from_rows(Kind.ELLIPSE, _RADIUS_VECTOR, array, "ellipses_from_radius_vector", names)


def ellipses_from_matrix(centres, matrices):
    """Ellipses of the points p with (p - c) . M (p - c) <= 1: centres (n, 2), symmetric M (n, 2, 2), or one of each."""
    centres, matrices = floats_of(centres, "centres"), floats_of(matrices, "matrices")
    if centres.shape[-1:] != (2,) or matrices.shape != (*centres.shape, 2) or centres.ndim > 2:
        shapes = f"{centres.shape} and {matrices.shape}"
        raise ValueError(f"centres have the shape (n, 2) and matrices (n, 2, 2), not {shapes}")
    flat = matrices.reshape(-1, 4)
    for i in numpy.flatnonzero((flat[:, 1] != flat[:, 2]) & ~numpy.isnan(flat).any(axis=1))[:1]:
        raise ValueError(f"matrices: row {i} is not symmetric: {plainly(flat[i, 1])} and {plainly(flat[i, 2])}")
    dtype = numpy.result_type(centres, matrices)
    rows = numpy.column_stack((centres.reshape(-1, 2), flat[:, [0, 1, 3]])).astype(dtype)
    rows[numpy.isnan(flat[:, 2]), 3] = numpy.nan

    def fault(i):
        names = ("x", "y", "mxx", "mxy", "myy")
        return fault_of(names, rows[i]) or f"the matrix {' '.join(map(plainly, rows[i, 2:]))} (xx xy yy) is of no ellipse"

    return constructed(Kind.ELLIPSE, _MATRIX, rows, centres.ndim == 1, fault)
