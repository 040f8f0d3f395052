# SPDX-License-Identifier: Apache-2.0
"""Arrays of Arrow in GeoArrow's form, by the C data interface: their numbers, where they lie."""
import ctypes
import struct

import numpy

_NAME = b"ARROW:extension:name"


class _Schema(ctypes.Structure):
    """struct ArrowSchema."""


class _Array(ctypes.Structure):
    """struct ArrowArray."""


class _Stream(ctypes.Structure):
    """struct ArrowArrayStream."""


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
_Stream._fields_ = [
    ("get_schema", ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(_Stream), ctypes.POINTER(_Schema))),
    ("get_next", ctypes.CFUNCTYPE(ctypes.c_int, ctypes.POINTER(_Stream), ctypes.POINTER(_Array))),
    ("get_last_error", ctypes.c_void_p),
    ("release", ctypes.c_void_p),
    ("private_data", ctypes.c_void_p),
]
_RELEASE = ctypes.CFUNCTYPE(None, ctypes.c_void_p)

_pointer = ctypes.pythonapi.PyCapsule_GetPointer
_pointer.restype, _pointer.argtypes = ctypes.c_void_p, (ctypes.py_object, ctypes.c_char_p)


class _Memory:
    """Numbers at an address, for as long as their owner lives."""

    def __init__(self, address, shape, strides, dtype, owner):
        self.owner = owner
        self.__array_interface__ = {
            **{"version": 3, "data": (address, True), "shape": shape, "strides": strides, "typestr": dtype.str}
        }


class _Taken:
    """The one array of a stream. It is released with the last view of its numbers."""

    def __init__(self, exporter):
        self.schema, self.array = _Schema(), _Array()
        capsule = exporter.__arrow_c_stream__()
        stream = _Stream.from_address(_pointer(capsule, b"arrow_array_stream"))
        later = _Array()
        codes = stream.get_schema(stream, self.schema), stream.get_next(stream, self.array)
        if any(codes) or (self.array.release and stream.get_next(stream, later)):
            raise ValueError(f"an Arrow stream ends in the error {max(codes)}")
        if later.release:
            _RELEASE(later.release)(ctypes.addressof(later))
            raise ValueError("an Arrow stream of several arrays: make one of them first, as by combine_chunks()")
        if not self.array.release:
            raise ValueError("an Arrow stream without an array")

    def __del__(self):
        for struct in (self.schema, self.array):
            if struct.release:
                _RELEASE(struct.release)(ctypes.addressof(struct))


def is_arrow(value):
    """Is it an array of Arrow, or a stream of what numpy has no numbers for, such as lists? A table's columns have."""
    if hasattr(value, "__arrow_c_array__") or not hasattr(value, "__arrow_c_stream__"):
        return hasattr(value, "__arrow_c_array__")
    return not hasattr(value, "__array__") or (
        not hasattr(value, "columns") and numpy.asarray(value).dtype.kind not in "fiub"
    )


def _imported(exporter):
    """(owner, schema, array)."""
    if not hasattr(exporter, "__arrow_c_array__"):
        owner = _Taken(exporter)
        return owner, owner.schema, owner.array
    owner = exporter.__arrow_c_array__()
    schema = _Schema.from_address(_pointer(owner[0], b"arrow_schema"))
    return owner, schema, _Array.from_address(_pointer(owner[1], b"arrow_array"))


def of_geoarrow(exporter, geometries):
    """(vertices (n, 2), [offsets of rings, of parts ...]): views of the arrays that an object exports.

    geometries: the names of GeoArrow's types that are wanted.
    """
    owner, schema, array = _imported(exporter)
    _check_name(schema, geometries)
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
    (x, y), step, dtype = _places(schema, array, start, [(b"x", b"y")])
    if count == 0:
        return numpy.empty((0, 2), dtype), offsets[::-1]
    return numpy.asarray(_Memory(x, (count, 2), (step, y - x), dtype, owner)), offsets[::-1]


def columns_of(exporter, geometry, *names):
    """A view of each column of an array of structs, or of pairs and the like.

    geometry: GeoArrow's name of the type, or None. names: tuples of the columns' names, any of which will do.
    """
    owner, schema, array = _imported(exporter)
    _check_name(schema, [geometry] if geometry else [])
    places, step, dtype = _places(schema, array, array.offset, [tuple(map(str.encode, each)) for each in names])
    count = array.length
    if count == 0:
        return [numpy.empty(0, dtype) for _ in places]
    return [numpy.asarray(_Memory(place, (count,), (step,), dtype, owner)) for place in places]


def _check_name(schema, geometries):
    name = _extension(schema)
    if name and name not in [f"geoarrow.{each}" for each in geometries]:
        raise ValueError(f"an Arrow array of {name} is none of {', '.join(geometries)}")


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
    if array.null_count == 0 or array.n_buffers == 0 or not array.buffers[0]:
        return
    first, count = array.offset, array.length
    bits = numpy.asarray(_Memory(array.buffers[0], ((first + count + 7) // 8,), None, numpy.dtype("u1"), None))
    if array.null_count > 0 or not numpy.unpackbits(bits, bitorder="little")[first : first + count].all():
        raise ValueError("an Arrow array of shapes must have no nulls: drop or fill them first")


def _places(schema, array, start, names):
    """(addresses, step, dtype): where the numbers of the first element lie, and how far the next one's are."""
    _without_nulls(array)
    wanted = names[0]
    if schema.format.startswith(b"+w:"):
        width = int(schema.format[3:])
        columns, formats = [array.children[0].contents], [schema.children[0].contents.format]
        places, step = [(0, columns[0].offset + start * width + i) for i in range(len(wanted))], width
    elif schema.format == b"+s":
        found = [schema.children[i].contents.name for i in range(schema.n_children)]
        wanted = next((each for each in names if set(each) <= set(found)), None)
        if wanted is None:
            raise ValueError(f"an Arrow array of structs needs the columns {_words(names)}, not {_words([found])}")
        indexes = [found.index(name) for name in wanted]
        columns = [array.children[i].contents for i in indexes]
        formats = [schema.children[i].contents.format for i in indexes]
        places, step, width = [(i, start + column.offset) for i, column in enumerate(columns)], 1, len(wanted)
    else:
        form = schema.format.decode()
        raise ValueError(f"numbers in Arrow are lists of one size or columns {_words(names)}, not {form!r}")
    points_have_more = wanted == (b"x", b"y") and width > 2
    if (width != len(wanted) and not points_have_more) or set(formats) not in ({b"g"}, {b"f"}):
        formats = ", ".join(form.decode() for form in formats)
        raise ValueError(f"numbers in Arrow are {len(wanted)} doubles or floats, not {width} of the format {formats}")
    for column in columns:
        _without_nulls(column)
    dtype = numpy.dtype("f8" if formats[0] == b"g" else "f4")
    return [(columns[i].buffers[1] or 0) + place * dtype.itemsize for i, place in places], step * dtype.itemsize, dtype


def _words(names):
    return " or ".join(" ".join(name.decode() for name in each) for each in names)
