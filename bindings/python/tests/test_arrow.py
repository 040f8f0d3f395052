# SPDX-License-Identifier: Apache-2.0
"""Arrays of Arrow in GeoArrow's form, exported here by ctypes alone."""
import ctypes
import struct
import unittest

import numpy
import vesica
from vesica.arrow import _RELEASE, _Array, _Schema, _Stream

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


class Stream:
    """Lends levels one by one, as arrays of a table are; `released` counts what has been given back."""

    def __init__(self, *levels):
        self.levels, self.next, self.released = levels, list(levels), 0
        self.release = _RELEASE(self._release)
        get_schema, get_next = (type_(call) for (_, type_), call in zip(_Stream._fields_, (self._schema, self._next)))
        self.stream = _Stream(get_schema, get_next)

    def _release(self, address):
        self.released += 1

    def _lend(self, source, out):
        ctypes.memmove(out, ctypes.addressof(source), ctypes.sizeof(source))
        out.contents.release = ctypes.cast(self.release, ctypes.c_void_p).value
        return 0

    def _schema(self, stream, out):
        return self._lend(self.levels[0].schema, out)

    def _next(self, stream, out):
        return self._lend(self.next.pop(0).array, out) if self.next else 0

    def __arrow_c_stream__(self, requested_schema=None):
        return _capsule(ctypes.addressof(self.stream), b"arrow_array_stream", None)


class Series(Stream):
    """A column of a table, which numpy reads as Python's objects or as numbers."""

    def __init__(self, level, array):
        super().__init__(level)
        self.array = array

    def __array__(self, *more, **named):
        return self.array


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
            (listed([0, 1], Level(b"l", 1, [None, RINGS])), "lists of one size or columns x y, not 'l'"),
            (listed([0, 1], Level(b"+w:2", 1, [None], [Level(b"l", 2, [None, RINGS])])), "doubles or floats"),
            (Level(b"+l", 2, [valid, numpy.array([0, 2, 3], "i4")], [rings], nulls=1), "no nulls"),
        ]:
            with self.assertRaisesRegex(ValueError, words):
                vesica.polygons(exporter)


class Columns(unittest.TestCase):
    """Points, boxes and other shapes of a fixed number of numbers."""

    XY = numpy.array([[0.0, 0], [4, 4], [4.5, 4]])

    def test_points(self):
        for exporter in (
            interleaved(self.XY),
            separated(self.XY),
            interleaved(numpy.hstack([self.XY, self.XY[:, :1]]), 3),
            Stream(separated(self.XY)),
        ):
            self.assertEqual(vesica.overlap(vesica.points(exporter), CENTRE).tolist(), [False, True, True])
        points = vesica.points(separated(self.XY.astype("f4")))
        self.assertEqual((points.dtype, points.numbers.tolist()), (numpy.float32, self.XY.tolist()))
        later = interleaved(self.XY)
        later.array.offset, later.array.length = 1, 2
        self.assertEqual(vesica.points(later).numbers.tolist(), self.XY[1:].tolist())
        self.assertEqual(len(vesica.points(interleaved(self.XY[:0]))), 0)

    def struct(self, rows, names, **more):
        columns = [numpy.ascontiguousarray(rows[:, i]) for i in range(rows.shape[1])]
        children = [Level(b"g", len(c), [None, c], name=n.encode()) for c, n in zip(columns, names.split())]
        return Level(b"+s", len(rows), [None], children, **more)

    def test_boxes(self):
        rows = numpy.array([[0.0, 0, 1, 1], [4, 4, 9, 9]])
        for exporter in (
            self.struct(rows, "xmin ymin xmax ymax", metadata=named("geoarrow.box")),
            self.struct(rows, "min_x min_y max_x max_y"),
            self.struct(rows[:, [2, 0, 3, 1]], "xmax xmin ymax ymin"),
            interleaved(rows, 4),
        ):
            boxes = vesica.aabbs(exporter)
            self.assertEqual(boxes.numbers.tolist(), rows.tolist())
            self.assertEqual(vesica.overlap(boxes, CENTRE).tolist(), [False, True])
        circles = vesica.circles(self.struct(rows, "cx cy unused r"))
        self.assertEqual(circles.numbers.tolist(), rows[:, [0, 1, 3]].tolist())

    def test_nothing_is_copied(self):
        rows = numpy.array([[0.0, 0, 1, 1], [4, 4, 9, 9]])
        struct = self.struct(rows, "xmin ymin xmax ymax")
        addresses = [child.buffers[1] for child in struct.kept[1]]
        self.assertEqual([column.ctypes.data for column in vesica.aabbs(struct).columns], addresses)
        values = self.XY.copy()
        points = vesica.points(interleaved(values))
        self.assertEqual(points.columns[0].ctypes.data, values.ctypes.data)
        self.assertEqual(points.columns[1].ctypes.data, values.ctypes.data + 8)
        self.assertEqual(points.columns[0].strides, (16,))

    def test_streams(self):
        stream = Stream(listed([0, 2, 3], listed(RINGS, interleaved(VERTICES))))
        shapes = vesica.polygons(stream)
        self.assertEqual(vesica.shape_area(shapes).tolist(), [48, 0.5])
        self.assertEqual(stream.released, 0)
        del shapes
        self.assertEqual(stream.released, 2)  # the schema and the array
        lists = Series(listed([0, 2, 3], listed(RINGS, interleaved(VERTICES))), numpy.array([None, None]))
        self.assertEqual(vesica.shape_area(vesica.polygons(lists)).tolist(), [48, 0.5])
        numbers = Series(separated(self.XY), self.XY)
        self.assertEqual(vesica.points(numbers).columns[0].ctypes.data, self.XY.ctypes.data)
        several = Stream(interleaved(self.XY), interleaved(self.XY))
        with self.assertRaisesRegex(ValueError, "an Arrow stream of several arrays"):
            vesica.points(several)
        self.assertEqual(several.released, 3)
        none = Stream(interleaved(self.XY))
        none.next.clear()
        with self.assertRaisesRegex(ValueError, "an Arrow stream without an array"):
            vesica.points(none)

    def test_nulls(self):
        for bits, count, accepted in ((0b111, -1, True), (0b101, -1, False), (0b101, 0, True), (0b101, 1, False)):
            exporter = separated(self.XY)
            valid = numpy.array([bits], "u1")
            exporter.buffers[0] = valid.ctypes.data
            exporter.array.null_count = count
            if accepted:
                self.assertEqual(len(vesica.points(exporter)), 3)
            else:
                with self.assertRaisesRegex(ValueError, "no nulls"):
                    vesica.points(exporter)

    def test_wrong_ones(self):
        rows = numpy.array([[0.0, 0, 1, 1]])
        for make, exporter, words in [
            (vesica.points, self.struct(rows, "a b c d"), "needs the columns x y, not a b c d"),
            (vesica.aabbs, self.struct(rows, "x y z w"), "min_x min_y max_x max_y or xmin ymin xmax ymax, not x y z w"),
            (vesica.aabbs, interleaved(rows[:, :3], 3), "4 doubles or floats, not 3"),
            (vesica.circles, interleaved(rows, 4), "3 doubles or floats, not 4"),
            (vesica.points, self.struct(rows, "x y", metadata=named("geoarrow.box")), "geoarrow.box is none of point"),
            (vesica.points, Level(b"g", 1, [None, rows]), "lists of one size or columns x y, not 'g'"),
        ]:
            with self.assertRaisesRegex(ValueError, words):
                make(exporter)


class Out(unittest.TestCase):
    """Vertices and offsets, as others take them."""

    def test_the_same_vertices(self):
        for shapes in (
            vesica.polygons(listed([0, 2, 3], listed(RINGS, interleaved(VERTICES)))),
            vesica.polygons(VERTICES, RINGS),
            vesica.polygons(VERTICES[:8].reshape(2, 4, 2)),
            vesica.polygons([[VERTICES[:4], VERTICES[4:8]], VERTICES[8:]]),
        ):
            for part in (shapes, shapes[1:], shapes[:1], shapes[0], shapes[:0]):
                vertices, rings, parts = part.ragged()
                self.assertEqual(vertices.ctypes.data, part.columns[1].ctypes.data)
                again = vesica.polygons(vertices, rings, parts)
                expected = [[ring.tolist() for ring in each] for each in part.rings]
                self.assertEqual([[ring.tolist() for ring in each] for each in again.rings], expected)
                self.assertEqual((rings.dtype, parts.dtype, parts[0]), ("i4", "i4", 0))

    def test_chosen_shapes(self):
        for shapes, areas in (
            (vesica.polygons(VERTICES, RINGS, [0, 2, 3]), [0.5, 48, 48]),
            (vesica.polygons(VERTICES, RINGS[[0, 1, 2]]), [16, 64, 64]),
        ):
            again = vesica.polygons(*shapes[[1, 0, 0]].ragged())
            self.assertEqual(vesica.shape_area(again).tolist(), areas)


class Tensor:
    """A tensor of another library, on one of DLPack's devices."""

    def __init__(self, array, device=1):
        self.array, self.device = array, device

    def __dlpack__(self, *, stream=None):
        return self.array.__dlpack__()

    def __dlpack_device__(self):
        return self.device, 0

    def __array__(self, *more, **named):
        return self.array


class DLPack(unittest.TestCase):
    def test_nothing_is_copied(self):
        values = numpy.array([[0.0, 0, 1], [4, 4, 1]])
        circles = vesica.circles(Tensor(values))
        self.assertEqual(vesica.overlap(circles, CENTRE).tolist(), [False, True])
        self.assertEqual(circles.columns[0].ctypes.data, values.ctypes.data)
        quads = VERTICES[:8].reshape(2, 4, 2).copy()
        self.assertEqual(vesica.polygons(Tensor(quads)).columns[1].ctypes.data, quads.ctypes.data)

    def test_other_devices(self):
        for device, words in ((2, "CUDA 0"), (8, "Metal 0"), (99, "of DLPack's type 99 0")):
            with self.assertRaisesRegex(TypeError, f"the tensor is on the device {words}; move it to the CPU first"):
                vesica.circles(Tensor(numpy.zeros((1, 3)), device))
            with self.assertRaisesRegex(TypeError, f"on the device {words}"):
                vesica.nms(vesica.circles([[0, 0, 1]]), Tensor(numpy.zeros(1), device))


if __name__ == "__main__":
    unittest.main()
