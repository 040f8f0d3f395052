# SPDX-License-Identifier: Apache-2.0
"""All pairs among millions: an index of shapes, joins, windows and nearest shapes."""
import ctypes
import itertools
import math

import numpy

from . import _declarations
from ._library import ABOVE_ZERO, VesicaError, by_scalar, checked, first_rows, library, one_of, real, whole
from ._threads import count_of, in_order, parts_of, worst
from .motion import NUMBERS, Cast, first_of, impact_of, motion, new_impact, turn_record
from .queries import Ratio
from .shapes import Shapes, accepted, first_of_rows, one_shape, same_scalar, the_shapes

_QUERIES = {
    "overlap": _declarations.JOIN_OVERLAP,
    "bounds": _declarations.JOIN_BOUNDS,
    "contains": _declarations.JOIN_CONTAINS,
    "inside": _declarations.JOIN_INSIDE,
    "interiors": _declarations.JOIN_INTERIORS,
}
_STEP = by_scalar("index_step")
_BUILD, _SELECT, _JOIN = by_scalar("index_build"), by_scalar("index_select"), by_scalar("join")
_NEAREST, _JOIN_NEAREST = by_scalar("index_nearest"), by_scalar("join_nearest")
_JOIN_WITHIN, _JOIN_RATIO = by_scalar("join_within"), by_scalar("join_ratio")
_CAST, _CAST_FIRST = by_scalar("index_cast"), by_scalar("index_cast_first")
_IMPACT_TIME = by_scalar("index_impact_time")
_ALIGNMENT = 64
_PAIRS_A_CALL = 1 << 16
_ITEMS_OF_THE_FIRST_CALL = 256  # mostly all
_NO_OUTPUT = (None, None, 0, None)


def _part_of(part, parts):
    """Both as whole numbers that make sense, because ctypes would wrap any other."""
    parts = whole(parts, "parts", 1, (1 << 63) - 1)
    return whole(part, "part", 0, parts - 1), parts


def _aligned(size):
    """So many bytes at an address that the library takes."""
    room = numpy.empty(size + _ALIGNMENT, numpy.uint8)
    start = -room.ctypes.data % _ALIGNMENT
    return room[start : start + size]


def _copied(data):
    """The same bytes at an address that the library takes."""
    copy = _aligned(len(data))
    copy[:] = data
    return copy


def _refused(code, result, sets):
    """The error of a call with sets, which names the first row that is invalid."""
    if code != _declarations.E_SHAPE:
        return VesicaError(code)
    for i, shapes in enumerate(sets):
        rows = shapes.invalid()
        if len(rows):
            return VesicaError(code, first_of_rows(rows, shapes.fault(rows[0]), f" of sets[{i}]"), result)
    return VesicaError(code, None, result)


def _pairs(ask, shares, threads, *more):
    """All pairs that the parts of a join write in as many calls as it takes; more: the types of other columns.

    ask(part, parts, output): writes some pairs.
    """

    def of_part(share):
        written, state = [], numpy.zeros(4, numpy.int64)
        while state[0] != -1:
            columns = [numpy.empty(_PAIRS_A_CALL, dtype) for dtype in (numpy.int64, numpy.int64, *more)]
            found = ask(*share, (*(column.ctypes.data for column in columns), _PAIRS_A_CALL, state.ctypes.data))
            written.append([first_rows(column, found) for column in columns])
        return written

    written = itertools.chain.from_iterable(in_order(of_part, shares, threads))
    return tuple(numpy.concatenate(column) for column in zip(*written))


def _built(ask, memory, threads):
    """The code of a build in the five steps of the library, of which the first and the last have one part."""
    code = 0
    for step in range(5):
        parts = parts_of(threads) if 0 < step < 4 else 1
        codes = in_order(lambda part: ask(step, part, parts, *memory), range(parts), threads)
        code = worst(codes)
        if code < 0:
            break
    return code


class Index:
    """An index over sets of shapes, of any kinds but of one scalar type, laid end to end.

    Item i is shape i of the first set, and the next set's items follow. The index holds bounds: the arrays must stay as
    they were. Where shapes are invalid the index of the others is made, and `incomplete` is True.

    threads, here and in joins: among how many threads more than 100,000 items are divided, by default all that the
    process has processors for. The bytes, and the pairs and their order, are those of one.
    """

    def __init__(self, *sets, threads=None):
        self._take(sets)
        size, scratch = library.vesica_index_size(self.count), library.vesica_index_scratch(self.count)
        room, scratch = _aligned(checked(size)), _aligned(checked(scratch))
        threads = count_of(threads, self.count)
        memory = (self._sets, len(sets), room.ctypes.data, len(room), scratch.ctypes.data, len(scratch))
        code = _BUILD[self._letter](*memory) if threads == 1 else _built(_STEP[self._letter], memory, threads)
        self.incomplete = code == _declarations.E_SHAPE
        if not self.incomplete:
            checked(code)
        used = checked(library.vesica_index_bytes(room.ctypes.data))
        self._own(_copied(room[:used]) if used < len(room) // 2 else room[:used])

    @classmethod
    def from_bytes(cls, data, *sets):
        """The index whose `bytes` were saved, over the same shapes. Damaged or foreign bytes are a VesicaError.

        Read-only bytes at a multiple of 64, as a file has that is mapped for reading, are read in place. They are
        checked once: the file, or what else they show, may not change as long as the index is used. Others are copied.
        """
        self = cls.__new__(cls)
        self._take(sets)
        data = numpy.frombuffer(data, numpy.uint8)
        self._own(_copied(data) if data.flags.writeable or data.ctypes.data % _ALIGNMENT else data)
        checked(library.vesica_index_check(self._address(), len(self.bytes)))
        built_of = checked(library.vesica_index_count(self._address()))
        if built_of != self.count:
            raise ValueError(f"an index of {built_of} shapes cannot be that of {self.count}")
        self.incomplete = None  # bytes do not tell
        return self

    def _take(self, sets):
        if not sets:
            raise ValueError("an index is of one set of shapes or more; a set may be empty")
        for i, shapes in enumerate(sets):
            same_scalar(the_shapes(sets[0], "sets[0]"), shapes, "sets[0]", f"sets[{i}]")
        self._shapes = sets
        self._letter = sets[0].letter
        self._sets = (type(sets[0].view) * len(sets))(*(shapes.view for shapes in sets))
        self.count = sum(len(shapes.columns[0]) for shapes in sets)

    def _own(self, data):
        """Keeps bytes, so that none can be changed by way of the index: the library trusts them."""
        self._bytes = numpy.frombuffer(memoryview(data).toreadonly(), numpy.uint8)

    def _address(self):
        return self._bytes.ctypes.data

    @property
    def bytes(self):
        """What `from_bytes` takes, as a read-only array."""
        return self._bytes

    @property
    def sets(self):
        """The sets of shapes."""
        return self._shapes

    def __reduce__(self):
        return type(self).from_bytes, (self._bytes.tobytes(), *self.sets), {"incomplete": self.incomplete}

    def __len__(self):
        return self.count

    def __repr__(self):
        return f"<vesica index of {self.count} shapes, {len(self.bytes)} bytes>"

    def order(self):
        """The items in spatial order: arrays that are laid so are joined quicker."""
        out = numpy.empty(self.count, numpy.int64)
        return first_rows(out, checked(library.vesica_index_order(self._address(), out.ctypes.data, len(out))))

    def bounds(self):
        """(min x, min y, max x, max y) around all valid shapes; indexes whose boxes are disjoint have no pairs."""
        box = _declarations.aabb_f64()
        checked(library.vesica_index_bounds(self._address(), ctypes.byref(box)))
        return box.min_x, box.min_y, box.max_x, box.max_y

    def join(self, other=None, query="overlap", part=0, parts=1, threads=None):
        """All pairs of an item of this index and one of another: two arrays of item numbers, each pair once.

        other: an index; None, or this index itself, for the pairs a < b of this one. query: "overlap", "contains" (the
        first item contains the second), "inside", "interiors" (touching does not count), or "bounds" for candidates.
        Parts may be asked by several processes; threads divide a whole join.
        """
        other, ask = self._joined(other), self._join(query)
        return _pairs(lambda *share: ask(other, *share), *self._shares(other, part, parts, threads))

    def join_within(self, other, distance, part=0, parts=1, threads=None):
        """All pairs at most `distance` apart, as join gives them. Of ellipses also those too near to tell.

        other: an index; None, or this index itself, for the pairs a < b of this one. With a negative distance, pairs that
        overlap at least that deep. The distance is first rounded to the shapes' type.
        """
        other = self._joined(other)
        indexes = self._address(), self._sets, len(self._sets), other._address(), other._sets, len(other._sets)
        ask, distance = _JOIN_WITHIN[self._letter], real(distance, "distance", self.sets[0].dtype)
        return _pairs(
            lambda part, parts, output: checked(ask(*indexes, distance, part, parts, *output)),
            *self._shares(other, part, parts, threads),
        )

    def join_ratio(self, other=None, ratio=Ratio.OVER_UNION, threshold=0.0, part=0, parts=1, threads=None):
        """All pairs that overlap and whose ratio, such as IoU, is at least `threshold`: (first, second, ratio).

        They come as join gives them, the values as vesica.ratio: a sparse matrix. Threshold 0 gives every pair that
        overlaps; for GIoU, DIoU and CIoU, which may be negative, -inf does. Pairs without a ratio, since neither shape
        has an area, are left out. The threshold is first rounded to the shapes' type.
        """
        other = self._joined(other)
        asked = one_of(Ratio, ratio, "ratio"), real(threshold, "threshold", self.sets[0].dtype)
        return _pairs(
            lambda *share: self._join_by(_JOIN_RATIO, asked, other, *share),
            *(*self._shares(other, part, parts, threads), self.sets[0].dtype),
        )

    def join_count(self, other=None, query="overlap", part=0, parts=1, threads=None):
        """How many pairs `join` would give."""
        other, ask = self._joined(other), self._join(query)
        shares, threads = self._shares(other, part, parts, threads)
        return sum(in_order(lambda share: ask(other, *share, _NO_OUTPUT), shares, threads))

    def _shares(self, other, part, parts, threads):
        """([(part, parts)] of a join, by how many threads)."""
        part, parts = _part_of(part, parts)
        if parts > 1:
            if threads not in (None, 1):
                raise ValueError(f"threads is {threads}: threads divide a whole join, not a part of {parts}")
            return [(part, parts)], 1
        threads = count_of(threads, self.count + other.count)
        return [(i, parts_of(threads)) for i in range(parts_of(threads))], threads

    def _joined(self, other):
        other = self if other is None else other
        if not isinstance(other, Index):
            hint = ": vesica.Index(other) makes one" if isinstance(other, Shapes) else ""
            raise TypeError(f"other is of the type {type(other).__name__}, not an index{hint}")
        same_scalar(self.sets[0], other.sets[0], "this index", "the other")
        if other is not self and other._address() == self._address():
            # Both were read in place from the same bytes. The library would take them for one index.
            other = Index.from_bytes(bytearray(other._bytes), *other.sets)
        return other

    def _join(self, query):
        """A function of (other, part, parts, output)."""
        if query not in _QUERIES:
            raise ValueError(f"query is {query!r}, not one of {', '.join(_QUERIES)}")
        return lambda *share: self._join_by(_JOIN, (_QUERIES[query],), *share)

    def _join_by(self, functions, asked, other, part, parts, output):
        scratch = _aligned(checked(library.vesica_join_scratch()))
        return checked(
            functions[self._letter](
                *asked,
                *(self._address(), self._sets, len(self._sets)),
                *(other._address(), other._sets, len(other._sets)),
                *(part, parts, scratch.ctypes.data, len(scratch)),
                *output,
            )
        )

    def select(self, shape):
        """The items that a single shape overlaps. For many shapes, index and join them."""
        same_scalar(self.sets[0], one_shape(shape, "shape"), "the index", "shape")
        return self._items(_SELECT[self._letter], shape)

    def _items(self, function, shape, *asked):
        """All items of a question, in as many calls as it takes."""
        arguments = (self._address(), self._sets, len(self._sets), ctypes.byref(shape.view), *asked)
        found, room, state = [], _ITEMS_OF_THE_FIRST_CALL, numpy.zeros(4, numpy.int64)
        while state[0] != -1:
            out = numpy.empty(room, numpy.int64)
            count = function(*arguments, out.ctypes.data, room, state.ctypes.data)
            found.append(first_rows(out, accepted(count, shape=shape)))
            room = _PAIRS_A_CALL
        return found[0] if len(found) == 1 else numpy.concatenate(found)

    def cast(self, shape, velocity, t_end=math.inf):
        """The items that a single shape, moved by t * velocity from t = 0 to t_end, touches.

        velocity and t_end are first rounded to the shapes' type.
        """
        same_scalar(self.sets[0], one_shape(shape, "shape"), "the index", "shape")
        return self._items(_CAST[self._letter], shape, *motion(velocity, t_end, shape.dtype))

    def cast_first(self, shape, velocity, t_end=math.inf):
        """The item that a moving shape touches first, the lowest of several: (item, Impact), or None; as cast."""
        same_scalar(self.sets[0], one_shape(shape, "shape"), "the index", "shape")
        record = new_impact(self._letter)
        item = _CAST_FIRST[self._letter](
            *(self._address(), self._sets, len(self._sets), ctypes.byref(shape.view)),
            *(*motion(velocity, t_end, shape.dtype), ctypes.byref(record)),
        )
        return first_of(accepted(item, shape=shape), self.count, record)

    def impact_time(self, shape, turn, tolerance):
        """The item that a moving and turning shape touches first, the lowest of several: (item, Cast, Impact, gap), or
        None if it is proved that there is none. Proved: there is no contact with any item before.

        The items are at rest. The answer is of impact_time for the item and the shape; Cast is HIT, NEAR or START.
        """
        same_scalar(self.sets[0], one_shape(shape, "shape"), "the index", "shape")
        record, gap, answer = new_impact(self._letter), NUMBERS[self._letter](), ctypes.c_int32()
        way = turn_record(turn, "turn", shape.dtype)
        item = _IMPACT_TIME[self._letter](
            *(self._address(), self._sets, len(self._sets), ctypes.byref(shape.view)),
            *(ctypes.byref(way), real(tolerance, "tolerance", shape.dtype, ABOVE_ZERO), ctypes.byref(record)),
            *(ctypes.byref(gap), ctypes.byref(answer)),
        )
        found = accepted(item, shape=shape) < self.count
        return (item, Cast(answer.value), impact_of(record), gap.value) if found else None

    def nearest(self, shape, k=1, within=math.inf):
        """The k items nearest to a single shape, and their distances, nearest first; at equal distances by number.

        within, the largest distance, is first rounded to the shapes' type.
        """
        same_scalar(self.sets[0], one_shape(shape, "shape"), "the index", "shape")
        k, within = min(whole(k, "k"), self.count), real(within, "within", shape.dtype, 0)
        out, distance = numpy.empty(k, numpy.int64), numpy.empty(k, shape.dtype)
        found = _NEAREST[self._letter](
            *(self._address(), self._sets, len(self._sets), ctypes.byref(shape.view)),
            *(k, within, out.ctypes.data, distance.ctypes.data),
        )
        accepted(found, shape=shape)
        return (first_rows(out, found), first_rows(distance, found)) if k else (out, distance)

    def nearest_of_each(self, *sets, k=1, within=math.inf, threads=None):
        """Of each shape of some sets, the k nearest items: two arrays (n, k), filled up by -1 at distance infinity.

        within is as of nearest.
        """
        for i, shapes in enumerate(sets):
            same_scalar(self.sets[0], shapes, "the index", f"sets[{i}]")
        asked = (type(self.sets[0].view) * len(sets))(*(shapes.view for shapes in sets))
        count, k = sum(len(shapes.columns[0]) for shapes in sets), whole(k, "k", 1)
        within = real(within, "within", self.sets[0].dtype, 0)
        out, distance = numpy.empty((count, k), numpy.int64), numpy.empty((count, k), self.sets[0].dtype)
        threads = count_of(threads, count)
        parts = parts_of(threads)

        def ask(part):
            return _JOIN_NEAREST[self._letter](
                *(asked, len(sets), self._address(), self._sets, len(self._sets)),
                *(k, within, part, parts, out.ctypes.data, distance.ctypes.data),
            )

        code = worst(in_order(ask, range(parts), threads))
        if code < 0:
            raise _refused(code, (out, distance), sets)
        return out, distance
