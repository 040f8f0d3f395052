# SPDX-License-Identifier: Apache-2.0
"""Polygons and polylines: shapes of any number of vertices, which are read where numpy has them."""
import ctypes
from collections.abc import Mapping

import numpy

from . import _declarations
from .arrow import is_arrow, of_geoarrow
from .shapes import MADE, VIEWS, Kind, Shapes, floats_of, new_shapes, not_finite

# The C struct of a polygon, as numbers of the size of a pointer: x, y, stride, rings, count.
_STRUCT = numpy.dtype(
    {
        "names": ["x", "y", "stride", "rings", "count"],
        "formats": [numpy.uintp, numpy.uintp, numpy.intp, numpy.uintp, numpy.int64],
        "itemsize": ctypes.sizeof(_declarations.polygon_f64),
    }
)


class Paths(Shapes):
    """One polygon or polyline, or an array of them; made by `polygons` and `polylines`.

    `len`, indexing, slices and masks work as with arrays, and copy no vertex. Vertices may be changed through the array
    that they came from.
    """

    __slots__ = ()

    def __reduce__(self):
        return _of_rings, (self.kind, self.rings, self.dtype, self.single)

    def __getitem__(self, index):
        if self.single:
            raise TypeError("one shape cannot be indexed")
        picked = self.columns[0][index]
        if picked.ndim > 1:
            raise ValueError(f"an array of shapes has one dimension, not the shape {picked.shape}")
        return _paths_of(self.kind, self.dtype, numpy.atleast_1d(picked), self.columns[1:], picked.ndim == 0)

    def __repr__(self):
        what = self.kind.name.lower()
        if self.single:
            return f"<vesica {what} of {sum(len(ring) for ring in self.rings[0])} vertices>"
        return f"<{len(self)} vesica {what} shapes of {self.dtype}>"

    @property
    def rings(self):
        """A list for each shape of copies (n, 2) of its rings, or chains."""
        vertices = self.columns[1]
        found, start, stride = [], vertices.ctypes.data, vertices.strides[0]
        for struct in self.columns[0]:
            first = (int(struct["x"]) - start) // stride
            ends = [0, int(struct["count"])]
            if struct["rings"] != 0:
                offsets = self.columns[2]
                j = (int(struct["rings"]) - offsets.ctypes.data) // offsets.itemsize
                ends = offsets[j : j + int(struct["count"]) + 1]
            found.append([vertices[first + a : first + b].copy() for a, b in zip(ends, ends[1:])])
        return found

    def ragged(self):
        """(vertices (m, 2), offsets of rings, offsets of shapes): as GeoArrow and shapely.from_ragged_array have them.

        Vertices are not copied if the shapes lie one after the other, as those of an array and of a slice do.
        """
        structs, vertices = self.columns[:2]
        counts, index = structs["count"], numpy.arange(len(structs) + 1, dtype=numpy.int32)
        if len(structs) == 0:
            return vertices[:0], index, index
        with_rings = len(self.columns) > 2
        base, step = vertices.ctypes.data, vertices.strides[0]
        if with_rings:
            base, step = self.columns[2].ctypes.data, self.columns[2].itemsize
        first = (structs["rings" if with_rings else "x"] - numpy.uintp(base)).astype(numpy.int64) // step
        ends = first + counts
        if (first[1:] != ends[:-1]).any():
            return _of_rings(self.kind, self.rings, self.dtype).ragged()
        offsets = numpy.append(first, ends[-1])
        if not with_rings:
            return vertices, offsets.astype(numpy.int32), index
        return vertices, self.columns[2][offsets[0] : offsets[-1] + 1], (offsets - offsets[0]).astype(numpy.int32)

    @property
    def numbers(self):
        raise TypeError("polygons and polylines have no row of numbers; see `rings`")

    def astype(self, dtype):
        """The same shapes with float64 or float32 numbers, which are rounded to float32."""
        dtype = numpy.dtype(dtype)
        if dtype.char not in "df":
            raise TypeError(f"shapes have float64 or float32 numbers, not {dtype}")
        rings = [[ring.astype(dtype) for ring in each] for each in self.rings]
        return _of_rings(self.kind, rings, dtype, self.single)

    def structs(self):
        return self.columns[0]

    def fault(self, i):
        for k, ring in enumerate(self[int(i) : int(i) + 1].rings[0] if not self.single else self.rings[0]):
            wrong = not_finite(f"ring {k}, vertex", ring)
            if wrong:
                return wrong
        return "it has no vertex"


MADE.add(Paths)


def _paths_of(kind, dtype, structs, kept, single=False):
    """Paths of C structs that lead into the arrays that are kept."""
    structs = numpy.ascontiguousarray(structs)
    address = structs.ctypes.data
    view = VIEWS[dtype.char](int(kind), 0, len(structs), _STRUCT.itemsize, (ctypes.c_void_p * 8)(address))
    return new_shapes(Paths, kind, single, (structs, *kept), dtype, view, address if single else None)


def polygons(vertices, *offsets):
    """Polygons. Their holes, and what is inside, follow from the even-odd rule, in whatever order the rings are.

    vertices: (n, k, 2), so that (n, 4, 2) are quads and (n, 3, 2) triangles; (k, 2) for a single polygon; rows of
    x0 y0 x1 y1 x2 y2 ..., so that (n, 8) are quads; a list of polygons, each (k, 2), such a row, or a list of rings;
    (m, 2) with offsets; or an array of Arrow in GeoArrow's form, which has
    __arrow_c_array__ or __arrow_c_stream__. Arrays are read where they lie.
    offsets: where each ring begins among the vertices, with the end: one ring a polygon. With a second array, where each
    polygon begins among the rings: those of GeoArrow, and of shapely.to_ragged_array.
    """
    return _make(Kind.POLYGON, vertices, offsets)


def polylines(vertices, *offsets):
    """Polylines, which are not closed and have no inside; else as polygons, with chains in place of rings."""
    return _make(Kind.POLYLINE, vertices, offsets)


# The types of GeoArrow that each kind is made of.
_GEOARROW = {Kind.POLYGON: ("polygon", "multipolygon"), Kind.POLYLINE: ("linestring", "multilinestring")}


def _of_arrow(kind, array):
    vertices, (rings, *parts) = of_geoarrow(array, _GEOARROW[kind])
    if len(parts) > 1:  # parts of parts of rings: the latter's offsets follow
        parts = [parts[0][_sound(parts[1], len(parts[0]) - 1, "offsets of parts")]]
    return _of_offsets(kind, vertices, rings, *parts)


def _make(kind, vertices, offsets):
    what = f"{kind.name.lower()}s"
    if not offsets and is_arrow(vertices):
        return _of_arrow(kind, vertices)
    if len(offsets) == 1 and isinstance(offsets[0], tuple):
        offsets = offsets[0]
    if offsets:
        return _of_offsets(kind, _pairs(vertices, f"vertices of {what} with offsets"), *offsets)
    if isinstance(vertices, numpy.ndarray) and vertices.dtype == object and vertices.ndim == 1:
        vertices = vertices.tolist()  # arrays in an array, as tables have them
    if isinstance(vertices, (list, tuple)) and (len(vertices) == 0 or not _is_even(vertices)):
        return _of_rings(kind, [_rings_of(each, f"{what}: row {i}") for i, each in enumerate(vertices)])
    vertices = floats_of(vertices, what)
    in_rows = vertices.shape[-1:] != (2,) and vertices.ndim in (1, 2) and _are_places(vertices.shape[-1])
    if in_rows:
        vertices = vertices.reshape(*vertices.shape[:-1], vertices.shape[-1] // 2, 2)
    if vertices.ndim == 4 and vertices.shape[-1] == 2:
        return _of_rings(kind, vertices)  # as many rings each, of as many vertices
    if vertices.ndim not in (2, 3) or vertices.shape[-1] != 2:
        raise ValueError(_wanted(what, vertices.shape))
    single = vertices.ndim == 2
    each = vertices.shape[-2]
    if each == 0:
        raise ValueError(f"{what}: a {kind.name.lower()} needs a vertex")
    flat = vertices.reshape(-1, 2)
    return _of_ranges(kind, flat, numpy.arange(0, len(flat), each), each, single)


def _are_places(numbers):
    """May a row of so many numbers be x0 y0 x1 y1 ...? Four are rather a box or the ends of a segment."""
    return numbers >= 6 and numbers % 2 == 0


def _wanted(what, shape):
    hint = ""
    if len(shape) > 1 and shape[-1] == 3:
        hint = "; leave out the third coordinate, as by [..., :2]"
    elif shape[-1:] == (4,):
        hint = "; boxes x0 y0 x1 y1 are vesica.aabbs, segments vesica.segments"
    return (
        f"{what} have vertices of the shape (n, k, 2), (k, 2) for a single one, or rows x0 y0 x1 y1 x2 y2 ..., "
        f"not {shape}{hint}"
    )


def _rings_of(given, where):
    """The rings of one shape of a list: it is a ring, a row x0 y0 x1 y1 ..., or a list of rings."""
    if isinstance(given, (str, bytes, Mapping)) or not hasattr(given, "__getitem__"):
        raise TypeError(f"{where} is of the type {type(given).__name__}, not an array of vertices")
    if len(given) and numpy.ndim(given[0]) == 2:
        return [_pairs(ring, f"{where}, ring {k}") for k, ring in enumerate(given)]
    if len(given) and numpy.ndim(given[0]) == 0 and _are_places(len(given)):
        return [floats_of(given, where).reshape(-1, 2)]
    return [_pairs(given, where)]


def _is_even(vertices):
    """Do nested lists make one array of numbers?"""
    try:
        return len({numpy.shape(each) for each in vertices}) <= 1 and numpy.asarray(vertices).dtype != object
    except ValueError:
        return False


def _pairs(vertices, what="vertices"):
    vertices = floats_of(vertices, what)
    if vertices.ndim != 2 or vertices.shape[1] != 2:
        raise ValueError(f"{what}: vertices have the shape (k, 2), not {vertices.shape}")
    return vertices


def _of_ranges(kind, vertices, first, count, single=False):
    """Paths of one ring each: `count` vertices from each `first` on."""
    structs = numpy.zeros(len(first), _STRUCT)
    structs["x"] = vertices.ctypes.data + first * vertices.strides[0]
    structs["y"] = structs["x"] + numpy.array(vertices.strides[1], numpy.intp).astype(numpy.uintp)
    structs["stride"] = vertices.strides[0]
    structs["count"] = count
    return _paths_of(kind, vertices.dtype, structs, (vertices,), single)


def _sound(offsets, end, name):
    offsets = numpy.asarray(offsets)
    if offsets.ndim != 1 or len(offsets) == 0 or offsets.dtype.kind not in "iu":
        raise ValueError(f"{name} are an array of whole numbers, one more than there are parts")
    if offsets[0] < 0 or offsets[-1] > end or (offsets[1:] < offsets[:-1]).any():
        raise ValueError(f"{name} must ascend from 0 or more to {end} at most")
    if offsets[-1] >= 1 << 31:
        raise ValueError(f"{name} must be below 2**31")
    return offsets


def _of_offsets(kind, vertices, rings, parts=None):
    rings = _sound(rings, len(vertices), "offsets of rings")
    if parts is None:
        return _of_ranges(kind, vertices, rings[:-1].astype(numpy.int64), numpy.diff(rings))
    parts = _sound(parts, len(rings) - 1, "offsets of polygons")
    rings = numpy.ascontiguousarray(rings, numpy.int32)
    structs = numpy.zeros(len(parts) - 1, _STRUCT)
    structs["x"] = vertices.ctypes.data
    structs["y"] = vertices.ctypes.data + vertices.strides[1]
    structs["stride"] = vertices.strides[0]
    structs["rings"] = rings.ctypes.data + parts[:-1].astype(numpy.int64) * rings.itemsize
    structs["count"] = numpy.diff(parts)
    return _paths_of(kind, vertices.dtype, structs, (vertices, rings))


def _of_rings(kind, shapes, dtype=None, single=False):
    """Paths from a list of lists of rings, whose vertices are copied behind one another."""
    rings = [_pairs(ring) for each in shapes for ring in each]
    dtype = dtype or (numpy.result_type(*rings) if rings else numpy.dtype(float))
    vertices = numpy.concatenate([numpy.empty((0, 2), dtype), *rings]).astype(dtype)
    offsets = [numpy.cumsum([0, *map(len, rings)])]
    if any(len(each) != 1 for each in shapes):
        offsets.append(numpy.cumsum([0, *map(len, shapes)]))
    made = _of_offsets(kind, vertices, *offsets)
    return made[0] if single else made
