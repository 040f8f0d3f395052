# SPDX-License-Identifier: Apache-2.0
"""Arrays of Arrow in GeoArrow's form, exported here by ctypes alone."""
import ctypes
import struct
import unittest

import numpy
import vesica
from vesica.arrow import _Array, _Schema

_capsule = ctypes.pythonapi.PyCapsule_New
_capsule.restype, _capsule.argtypes = ctypes.py_object, (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p)

VERTICES = numpy.array([[0.0, 0], [8, 0], [8, 8], [0, 8], [2, 2], [6, 2], [6, 6], [2, 6], [20, 0], [21, 0], [20, 1]])
RINGS = numpy.array([0, 4, 8, 11], "i4")
CENTRE = vesica.circles([4, 4, 1])


class Level:
    """One array and its schema; what is lent lives as long as this."""

    def __init__(self, form, length, buffers, children=(), name=b"", metadata=None, offset=0, nulls=0):
        self.kept = buffers, children, metadata
        self.schema_children = (ctypes.POINTER(_Schema) * len(children))(*(ctypes.pointer(c.schema) for c in children))
        self.array_children = (ctypes.POINTER(_Array) * len(children))(*(ctypes.pointer(c.array) for c in children))
        self.buffers = (ctypes.c_void_p * len(buffers))(*(None if b is None else b.ctypes.data for b in buffers))
        address = None if metadata is None else ctypes.cast(ctypes.c_char_p(metadata), ctypes.c_void_p)
        self.schema = _Schema(form, name, address, 0, len(children), self.schema_children)
        self.array = _Array(length, nulls, offset, len(buffers), len(children), self.buffers, self.array_children)

    def __arrow_c_array__(self, requested_schema=None):
        at = (ctypes.addressof(self.schema), b"arrow_schema"), (ctypes.addressof(self.array), b"arrow_array")
        return tuple(_capsule(address, name, None) for address, name in at)


def named(name):
    key, value = b"ARROW:extension:name", name.encode()
    return struct.pack("=ii", 1, len(key)) + key + struct.pack("=i", len(value)) + value


def interleaved(vertices, width=2):
    values = numpy.ascontiguousarray(vertices)
    form = {"d": b"g", "f": b"f"}[values.dtype.char]
    return Level(b"+w:%d" % width, len(values), [None], [Level(form, values.size, [None, values])])


def separated(vertices):
    columns = [numpy.ascontiguousarray(vertices[:, i]) for i in range(2)]
    form = {"d": b"g", "f": b"f"}[columns[0].dtype.char]
    children = [Level(form, len(c), [None, c], name=n) for c, n in zip(columns, (b"x", b"y"))]
    return Level(b"+s", len(vertices), [None], children)


def listed(offsets, child, **more):
    offsets = numpy.asarray(offsets, more.pop("dtype", "i4"))
    form = b"+l" if offsets.dtype.itemsize == 4 else b"+L"
    length = more.pop("length", len(offsets) - 1)
    return Level(form, length, [None, offsets], [child], **more)


class GeoArrow(unittest.TestCase):
    def check(self, exporter, dtype=float):
        shapes = vesica.polygons(exporter)
        self.assertEqual(shapes.dtype, dtype)
        self.assertEqual(vesica.overlap(shapes, CENTRE.astype(dtype)).tolist(), [False, False])
        self.assertEqual(vesica.shape_area(shapes).tolist(), [48, 0.5])
        return shapes

    def test_polygons(self):
        parts = [0, 2, 3]
        self.check(listed(parts, listed(RINGS, interleaved(VERTICES)), metadata=named("geoarrow.polygon")))
        self.check(listed(parts, listed(RINGS, separated(VERTICES))))
        self.check(listed(parts, listed(RINGS, separated(VERTICES.astype("f4")))), numpy.float32)
        self.check(listed(parts, listed(RINGS, interleaved(VERTICES), dtype="i8"), dtype="i8"))
        deep = numpy.hstack([VERTICES, numpy.full((len(VERTICES), 1), numpy.nan)])
        self.check(listed(parts, listed(RINGS, interleaved(deep, 3))))
        self.check(listed([0, 1, 2], listed(parts, listed(RINGS, interleaved(VERTICES)))))  # MultiPolygon

    def test_slices(self):
        rings = listed(RINGS, interleaved(VERTICES))
        shapes = vesica.polygons(listed([0, 2, 3], rings, length=1, offset=1))
        self.assertEqual(vesica.shape_area(shapes).tolist(), [0.5])
        later = interleaved(VERTICES)
        later.array.offset, later.array.length = 8, 3
        self.assertEqual(vesica.shape_area(vesica.polygons(listed([0, 1], listed([0, 3], later)))).tolist(), [0.5])

    def test_nothing_is_copied(self):
        values = VERTICES.copy()
        shapes = self.check(listed([0, 2, 3], listed(RINGS, interleaved(values))))
        self.assertEqual(shapes.columns[1].ctypes.data, values.ctypes.data)
        self.assertEqual(shapes.columns[2].ctypes.data, RINGS.ctypes.data)
        values[8:] *= 2
        self.assertEqual(vesica.shape_area(shapes).tolist(), [48, 2])

    def test_lines(self):
        chains = listed([0, 3, 8], interleaved(VERTICES), metadata=named("geoarrow.linestring"))
        self.assertEqual(vesica.overlap(vesica.polylines(chains), CENTRE).tolist(), [False, False])
        self.assertEqual(vesica.nearest(vesica.polylines(chains), CENTRE).distance.tolist(), [3, 1])
        with self.assertRaisesRegex(ValueError, "geoarrow.linestring is none of polygon, multipolygon"):
            vesica.polygons(chains)

    def test_none(self):
        empty = Level(b"+l", 0, [None, None], [listed([0], interleaved(VERTICES[:0]))])
        self.assertEqual(len(vesica.polygons(empty)), 0)

    def test_wrong_ones(self):
        rings = listed(RINGS, interleaved(VERTICES))
        valid = numpy.array([1], "u1")
        for exporter, words in [
            (interleaved(VERTICES), "lists of vertices is needed"),
            (listed([0, 4], rings), "offsets of polygons must ascend from 0 or more to 3"),
            (listed([0, 2], listed([0, 4, 99], interleaved(VERTICES))), "offsets of rings must ascend"),
            (listed([0, 2], listed([0, 4, 3], interleaved(VERTICES))), "offsets of rings must ascend"),
            (listed([0, 1], Level(b"l", 1, [None, RINGS])), "pairs or columns x and y, not 'l'"),
            (listed([0, 1], Level(b"+w:2", 1, [None], [Level(b"l", 2, [None, RINGS])])), "doubles or floats"),
            (Level(b"+l", 2, [valid, numpy.array([0, 2, 3], "i4")], [rings], nulls=1), "no nulls"),
        ]:
            with self.assertRaisesRegex(ValueError, words):
                vesica.polygons(exporter)


if __name__ == "__main__":
    unittest.main()
