# SPDX-License-Identifier: Apache-2.0
"""Arrays of Arrow in GeoArrow's form, by the C data interface: their vertices and offsets, where they lie."""
import ctypes
import struct

import numpy

_NAME = b"ARROW:extension:name"


class _Schema(ctypes.Structure):
    """struct ArrowSchema."""


class _Array(ctypes.Structure):
    """struct ArrowArray."""


_Schema._fields_ = [
    ("format", ctypes.c_char_p),
    ("name", ctypes.c_char_p),
    ("metadata", ctypes.c_void_p),
    ("flags", ctypes.c_int64),
    ("n_children", ctypes.c_int64),
    ("children", ctypes.POINTER(ctypes.POINTER(_Schema))),
    ("dictionary", ctypes.c_void_p),
    ("release", ctypes.c_void_p),
    ("private_data", ctypes.c_void_p),
]
_Array._fields_ = [
    ("length", ctypes.c_int64),
    ("null_count", ctypes.c_int64),
    ("offset", ctypes.c_int64),
    ("n_buffers", ctypes.c_int64),
    ("n_children", ctypes.c_int64),
    ("buffers", ctypes.POINTER(ctypes.c_void_p)),
    ("children", ctypes.POINTER(ctypes.POINTER(_Array))),
    ("dictionary", ctypes.c_void_p),
    ("release", ctypes.c_void_p),
    ("private_data", ctypes.c_void_p),
]

_pointer = ctypes.pythonapi.PyCapsule_GetPointer
_pointer.restype, _pointer.argtypes = ctypes.c_void_p, (ctypes.py_object, ctypes.c_char_p)


class _Memory:
    """Numbers at an address, for as long as their owner lives."""

    def __init__(self, address, shape, strides, dtype, owner):
        self.owner = owner
        self.__array_interface__ = {
            **{"version": 3, "data": (address, True), "shape": shape, "strides": strides, "typestr": dtype.str}
        }


def of_geoarrow(exporter, geometries):
    """(vertices (n, 2), [offsets of rings, of parts ...]): views of the arrays that an object exports.

    geometries: the names of GeoArrow's types that are wanted.
    """
    owner = exporter.__arrow_c_array__()
    schema = _Schema.from_address(_pointer(owner[0], b"arrow_schema"))
    array = _Array.from_address(_pointer(owner[1], b"arrow_array"))
    name = _extension(schema)
    if name and name not in [f"geoarrow.{each}" for each in geometries]:
        raise ValueError(f"an Arrow array of {name} is none of {', '.join(geometries)}")
    offsets, start, count = [], array.offset, array.length
    while schema.format in (b"+l", b"+L"):
        _without_nulls(array)
        dtype = numpy.dtype("i4" if schema.format == b"+l" else "i8")
        address = (array.buffers[1] or 0) + start * dtype.itemsize
        if not array.buffers[1]:  # as is allowed of an array without elements
            offsets.append(numpy.zeros(1, dtype))
        else:
            offsets.append(numpy.asarray(_Memory(address, (count + 1,), None, dtype, owner)))
        schema, array = schema.children[0].contents, array.children[0].contents
        start, count = array.offset, array.length
    if not offsets:
        raise ValueError(f"an Arrow array of lists of vertices is needed, not of the format {schema.format.decode()!r}")
    return _vertices(schema, array, start, count, owner), offsets[::-1]


def _extension(schema):
    """GeoArrow's name of the type, or None."""
    if not schema.metadata:
        return None
    at, texts = schema.metadata, []

    def number():
        nonlocal at
        (value,) = struct.unpack("=i", ctypes.string_at(at, 4))
        at += 4
        return value

    for _ in range(2 * number()):
        length = number()
        texts.append(ctypes.string_at(at, length))
        at += length
    return dict(zip(texts[::2], texts[1::2])).get(_NAME, b"").decode() or None


def _without_nulls(array):
    if array.null_count != 0 and array.n_buffers > 0 and array.buffers[0]:
        raise ValueError("an Arrow array of shapes must have no nulls: drop or fill them first")


def _vertices(schema, array, start, count, owner):
    """A view of x and y: side by side, or columns at any distance."""
    _without_nulls(array)
    if schema.format.startswith(b"+w:"):
        width = int(schema.format[3:])
        first = array.children[0].contents
        places, step = [first.offset + start * width + i for i in range(2)], width
        columns, formats = [first, first], [schema.children[0].contents.format] * 2
    elif schema.format == b"+s":
        names = [schema.children[i].contents.name for i in range(schema.n_children)]
        if names[:2] != [b"x", b"y"]:
            raise ValueError(f"vertices in Arrow have the columns x and y, not {names}")
        columns = [array.children[i].contents for i in range(2)]
        places, step, width = [start + column.offset for column in columns], 1, 2
        formats = [schema.children[i].contents.format for i in range(2)]
    else:
        raise ValueError(f"vertices in Arrow are pairs or columns x and y, not {schema.format.decode()!r}")
    if width < 2 or formats not in ([b"g"] * 2, [b"f"] * 2):
        raise ValueError(f"coordinates in Arrow are two doubles or floats, not {formats} of {width}")
    dtype = numpy.dtype("f8" if formats[0] == b"g" else "f4")
    if count == 0:
        return numpy.empty((0, 2), dtype)
    for column in columns:
        _without_nulls(column)
    x, y = [(column.buffers[1] or 0) + place * dtype.itemsize for column, place in zip(columns, places)]
    return numpy.asarray(_Memory(x, (count, 2), (step * dtype.itemsize, y - x), dtype, owner))
