# SPDX-License-Identifier: Apache-2.0
"""Index and join by ctypes, for numpy: copy this file and vesica.py. Items and pairs are arrays of int64."""
import ctypes

import numpy
from vesica import E_SHAPE, _checked, _library, _Shapes, _shapes

OVERLAP, BOUNDS, CONTAINS, INSIDE = range(4)  # what makes a pair

_int32, _int64, _pointer, _sets = ctypes.c_int32, ctypes.c_int64, ctypes.c_void_p, ctypes.POINTER(_Shapes)
_SIGNATURES = {
    "vesica_index_size": (_int64,),
    "vesica_index_scratch": (_int64,),
    "vesica_join_scratch": (),
    "vesica_index_check": (_pointer, _int64),
    "vesica_index_bytes": (_pointer,),
    "vesica_index_count": (_pointer,),
    "vesica_index_order": (_pointer, _pointer, _int64),
}
_TYPED = {
    "build": ("vesica_index_build", (_sets, _int32, _pointer, _int64, _pointer, _int64)),
    "select": ("vesica_index_select", (_pointer, _sets, _int32, _sets, _pointer, _int64, _pointer)),
    "join": (
        "vesica_join",
        (_int32, *(_pointer, _sets, _int32) * 2, _int64, _int64, _pointer, _int64, _pointer, _pointer, _int64, _pointer),
    ),
}
for _name, _types in _SIGNATURES.items():
    _library[_name].argtypes = _types
    _library[_name].restype = _int32 if _name == "vesica_index_check" else _int64
_functions = {}
for _type, _suffix, _scalar in ((numpy.dtype("f8"), "f64", ctypes.c_double), (numpy.dtype("f4"), "f32", ctypes.c_float)):
    _nearest = ("vesica_index_nearest", (_pointer, _sets, _int32, _sets, _int64, _scalar, _pointer, _pointer))
    for _key, (_name, _types) in {**_TYPED, "nearest": _nearest}.items():
        _functions[_key, _type] = _library[f"{_name}_{_suffix}"]
        _functions[_key, _type].argtypes = _types
        _functions[_key, _type].restype = _int64


def _aligned(size):
    memory = numpy.empty(size + 64, "u1")
    return memory[-memory.ctypes.data % 64 :][:size]


class Index:
    """An index over sets of shapes laid end to end, each a kind and an array as vesica.overlap_many takes it.

    Invalid shapes are left out, and `has_invalid` tells. The arrays are kept, not copied: shapes that moved need a new
    index. `data` is what `bytes()` gave for the same sets, from a file or another process, and is checked.
    """

    def __init__(self, *sets, data=None):
        views = [_shapes(kind, array) for kind, array in sets]
        dtypes = {dtype for _, dtype in views}
        if len(dtypes) != 1:
            raise TypeError("sets of one type of number are needed")
        (self.dtype,) = dtypes
        self._arrays = sets
        self._sets = (_Shapes * len(views))(*(view for view, _ in views))
        self.has_invalid = False
        if data is None:
            self._build(sum(view.count for view, _ in views))
        else:
            self._memory = _aligned(len(data))
            self._memory[:] = numpy.frombuffer(data, "u1")
            _checked(_library.vesica_index_check(self._at, len(data)))

    def _build(self, count):
        self._memory = _aligned(_checked(_library.vesica_index_size(count)))
        scratch = _aligned(_checked(_library.vesica_index_scratch(count)))
        result = self._function("build")(
            self._sets, len(self._sets), self._at, self._memory.size, scratch.ctypes.data, scratch.size
        )
        self.has_invalid = result == E_SHAPE
        if not self.has_invalid:
            _checked(result)

    def _function(self, name):
        return _functions[name, self.dtype]

    @property
    def _at(self):
        return self._memory.ctypes.data

    def __len__(self):
        return _library.vesica_index_count(self._at)

    def bytes(self):
        return self._memory[: _library.vesica_index_bytes(self._at)].tobytes()

    def order(self):
        """Valid items in spatial order: arrays laid in it are joined faster."""
        out = numpy.empty(len(self), "i8")
        return out[: _checked(_library.vesica_index_order(self._at, out.ctypes.data, len(out)))]

    def select(self, kind, shape):
        """The items that one shape overlaps."""
        one, _ = _shapes(kind, numpy.asarray(shape, self.dtype)[None, :])
        call = self._function("select")
        count = _checked(call(self._at, self._sets, len(self._sets), one, None, 0, None))
        out, state = numpy.empty(count, "i8"), numpy.zeros(4, "i8")
        if count > 0:
            _checked(call(self._at, self._sets, len(self._sets), one, out.ctypes.data, count, state.ctypes.data))
        return out

    def nearest(self, kind, shape, k, within=numpy.inf):
        """The k items nearest to one shape, at most `within` away, and their distances."""
        one, _ = _shapes(kind, numpy.asarray(shape, self.dtype)[None, :])
        items, distance = numpy.empty(k, "i8"), numpy.empty(k, self.dtype)
        found = self._function("nearest")(
            self._at, self._sets, len(self._sets), one, k, within, items.ctypes.data, distance.ctypes.data
        )
        return items[: _checked(found)], distance[:found]


def join(a, b=None, query=OVERLAP, room=65536):
    """All pairs of an item of a and one of b, as two arrays; of a alone, those of two items of it, the lower one first.

    `room` is how many pairs are fetched at a time.
    """
    b = a if b is None else b
    if a.dtype != b.dtype:
        raise TypeError("one index is of float64, the other of float32")
    scratch = _aligned(_library.vesica_join_scratch())
    state, pages = numpy.zeros(4, "i8"), [numpy.empty((2, 0), "i8")]
    while state[0] != -1:
        page = numpy.empty((2, room), "i8")
        found = a._function("join")(
            query, a._at, a._sets, len(a._sets), b._at, b._sets, len(b._sets), 0, 1, scratch.ctypes.data, scratch.size,
            page[0].ctypes.data, page[1].ctypes.data, room, state.ctypes.data,
        )  # fmt: skip
        pages.append(page[:, : _checked(found)])
    return tuple(numpy.concatenate(pages, axis=1))
