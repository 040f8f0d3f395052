# SPDX-License-Identifier: Apache-2.0
"""Vesica by ctypes, for numpy: copy this file, and python/vesica/_declarations.py beside it. `c` has every function.

No array of float64 or float32 is copied, however its memory lies.
"""
import collections
import ctypes

import _declarations
import numpy
from _declarations import AABB, CIRCLE, E_KIND, E_SHAPE, ELLIPSE, POINT, RECT, SEGMENT, VERSION
FIELDS = (
    ("x", "y"),
    ("x0", "y0", "x1", "y1"),
    ("cx", "cy", "r"),
    ("min_x", "min_y", "max_x", "max_y"),
    ("cx", "cy", "ux", "uy", "hx", "hy"),
    ("cx", "cy", "ux", "uy", "a", "b"),
)


class VesicaError(ValueError):
    def __init__(self, code):
        super().__init__(_library.vesica_strerror(code).decode())
        self.code = code


_library = ctypes.CDLL("libvesica.so.0")
_library.vesica_version.restype = ctypes.c_int32
if _library.vesica_version() < VERSION:
    raise ImportError(f"vesica {_library.vesica_version()} is older than {VERSION}")
_declarations.declare(_library)
c = _library
_DOUBLE, _FLOAT = numpy.dtype("f8"), numpy.dtype("f4")
_overlap = {_DOUBLE: c.vesica_overlap_f64, _FLOAT: c.vesica_overlap_f32}
_many = {_DOUBLE: c.vesica_overlap_many_f64, _FLOAT: c.vesica_overlap_many_f32}
_matrix = {_DOUBLE: c.vesica_overlap_matrix_f64, _FLOAT: c.vesica_overlap_matrix_f32}
_Shapes = _declarations.shapes_f64  # that of floats is laid out alike
ClosestPoints = collections.namedtuple("ClosestPoints", "distance ax ay bx by")


def _checked(answer):
    if answer < 0:
        raise VesicaError(answer)
    return answer


def _two(kind_a, a, kind_b, b, dtype):
    a, b = numpy.ascontiguousarray(a, dtype), numpy.ascontiguousarray(b, dtype)
    for kind, numbers in ((kind_a, a), (kind_b, b)):
        if 0 <= kind < len(FIELDS) and numbers.size < len(FIELDS[kind]):
            raise ValueError(f"a shape of kind {kind} has {len(FIELDS[kind])} numbers")
    return a, b


def overlap(kind_a, a, kind_b, b, dtype="f8"):
    """Do two shapes, each a sequence of its numbers, share a point? Touching counts."""
    dtype = numpy.dtype(dtype)
    a, b = _two(kind_a, a, kind_b, b, dtype)
    return _checked(_overlap[dtype](kind_a, a.ctypes.data, kind_b, b.ctypes.data)) == 1


def nearest(kind_a, a, kind_b, b):
    """How far apart are two shapes, and which of their points are closest? ClosestPoints."""
    a, b = _two(kind_a, a, kind_b, b, _DOUBLE)
    out = numpy.empty(5)
    _checked(c.vesica_nearest_f64(kind_a, a.ctypes.data, kind_b, b.ctypes.data, out.ctypes.data))
    return ClosestPoints(*out)


def _shapes(kind, array):
    """The library's view of an array: structured, with fields as in FIELDS, or a row a shape and a column a number."""
    if not 0 <= kind < len(FIELDS):
        raise VesicaError(E_KIND)
    if array.dtype.names is None:
        columns = [array[:, i] for i in range(len(FIELDS[kind]))]
    else:
        columns = [array[name] for name in FIELDS[kind]]
    dtype = columns[0].dtype
    if dtype not in _overlap or any(column.dtype != dtype for column in columns):
        raise TypeError("the numbers must be all float64 or all float32")
    field = (ctypes.c_void_p * 6)(*(column.ctypes.data for column in columns))
    return _Shapes(kind, 0, len(array), columns[0].strides[0], field), dtype


def _call(functions, kind_a, a, kind_b, b, out, *more):
    (shapes_a, dtype), (shapes_b, dtype_b) = _shapes(kind_a, a), _shapes(kind_b, b)
    if dtype != dtype_b:
        raise TypeError("one array is of float64, the other of float32")
    if out.dtype not in ("u1", "?") or not out.flags.c_contiguous or not out.flags.writeable:
        raise TypeError("out must be contiguous, of uint8 or bool")
    addresses = ctypes.byref(shapes_a), ctypes.byref(shapes_b), out.ctypes.data
    return _checked(functions[dtype](*addresses, *more))


def overlap_many(kind_a, a, kind_b, b, out):
    """Writes where two arrays in step overlap to out, of uint8 or bool; an array of one shape is repeated.

    Returns how many overlap. Where a shape is invalid, out has 0 for it and every other answer, and the error is
    raised.
    """
    if len(out) != (max(len(a), len(b)) if len(a) and len(b) else 0):
        raise ValueError("out must be as long as the longer array")
    return _call(_many, kind_a, a, kind_b, b, out)


def overlap_matrix(kind_a, a, kind_b, b, out):
    """Writes where each of a overlaps each of b to out[i, j]; else as overlap_many."""
    if out.shape != (len(a), len(b)):
        raise ValueError("out must have a row for each of a, a column for each of b")
    return _call(_matrix, kind_a, a, kind_b, b, out, len(b))
