# SPDX-License-Identifier: Apache-2.0
"""Shapes: one, or an array of one kind, as numpy holds them. Nothing is copied that numpy can show in place."""
import ctypes
import enum
import itertools
import math
import operator
import warnings
from collections.abc import Mapping
from numbers import Integral, Number

import numpy

from . import _declarations
from ._library import VesicaError, by_scalar, first_rows, one_of, plainly, real
from ._threads import by_ranges, divided
from .arrow import columns_of, is_arrow


class Kind(enum.IntEnum):
    """The kinds of shapes."""

    POINT = _declarations.POINT
    SEGMENT = _declarations.SEGMENT
    CIRCLE = _declarations.CIRCLE
    AABB = _declarations.AABB
    RECT = _declarations.RECT
    ELLIPSE = _declarations.ELLIPSE
    CAPSULE = _declarations.CAPSULE
    ROUND_RECT = _declarations.ROUND_RECT
    POLYGON = _declarations.POLYGON
    POLYLINE = _declarations.POLYLINE


#: The numbers of each kind, in their order; not of polygons and polylines, which have any number of vertices.
FIELDS = {
    kind: tuple(name for name, _ in getattr(_declarations, f"{kind.name.lower()}_f64")._fields_)
    for kind in Kind
    if kind < Kind.POLYGON
}
# What GeoArrow calls the kinds that it has, and the numbers of boxes.
_GEOARROW = {Kind.POINT: "point", Kind.AABB: "box"}
_GEOARROW_BOX = ("xmin", "ymin", "xmax", "ymax")
VIEWS = {"d": _declarations.shapes_f64, "f": _declarations.shapes_f32}
CHECK = by_scalar("check")
_RECT_FROM_CORNERS, _RECTS_FROM_CORNERS = by_scalar("rect_from_corners"), by_scalar("rects_from_corners")
_MISFIT_OF_ONE = by_scalar("rect_corners_misfit")
_CORNERS_MISFIT, BOUNDS = by_scalar("rect_corners_misfit_many"), by_scalar("bounds_many")
_ELLIPSE_FROM_COVARIANCE = by_scalar("ellipse_from_covariance")
_RECTS_FROM_BOXES, _ELLIPSES_FROM_BOXES = by_scalar("rects_from_boxes"), by_scalar("ellipses_from_boxes")
_BOXES_FROM_SHAPES = by_scalar("boxes_from_shapes")


class _Gathered:
    """The numbers of a single shape that do not lie side by side: ctypes is given a row of them, made at each call."""

    __slots__ = ("cells",)

    def __init__(self, addresses, size):
        self.cells = [memoryview((ctypes.c_char * size).from_address(address)) for address in addresses]

    @property
    def _as_parameter_(self):
        return b"".join(self.cells)


def _record(scalar, addresses):
    """A single shape for the functions of two shapes: its address, or what gathers its numbers.

    They are read at the call, as those of arrays are, so that both follow changes of the memory.
    """
    first, size = addresses[0], ctypes.sizeof(scalar)
    side_by_side = addresses == list(range(first, first + size * len(addresses), size))
    return first if side_by_side and first % ctypes.alignment(scalar) == 0 else _Gathered(addresses, size)


class Shapes:
    """One shape, or an array of shapes of one kind; made by `points`, `rects`, `shapes` and the like.

    kind: a Kind. single: whether it is one shape, whose answers are numbers and not arrays. dtype: float64 or float32.
    `len`, indexing, slices and masks work as with arrays. The numbers may be changed through the array they came from,
    and those of a shape c[i] or a slice too. Copies, and what pickle makes, have numbers of their own.
    """

    __slots__ = ("kind", "single", "columns", "dtype", "letter", "view", "record")

    def __init__(self, *numbers, **more):
        raise TypeError("shapes are made by points, rects and the like, or shapes(kind, numbers)")

    def __setattr__(self, name, value):
        raise AttributeError(f"{name} of shapes cannot be changed")

    def __delattr__(self, name):
        raise AttributeError(f"{name} of shapes cannot be deleted")

    def __reduce__(self):
        return shapes, (self.kind, self.numbers)

    def __len__(self):
        if self.single:
            raise TypeError("one shape has no length; shapes(kind, [numbers]) makes an array of one")
        return len(self.columns[0])

    def __getitem__(self, index):
        if self.single:
            raise TypeError("one shape cannot be indexed")
        if isinstance(index, tuple) and len(index) == 1:
            (index,) = index  # as numpy.nonzero() gives
        number = _one_number(index)
        if number is None:
            if isinstance(index, list):
                index = (index,)  # by itself, numpy 1.19 takes a list of lists for a tuple
            return _shapes_of(self.kind, _alike([column[index] for column in self.columns]))
        if not -len(self) <= number < len(self):
            raise IndexError(f"shape {number} of {len(self)}")
        return _shapes_of(self.kind, [column[number : number + 1 or None] for column in self.columns], True)

    def __iter__(self):
        return (self[i] for i in range(len(self)))

    def __repr__(self):
        if self.single:
            numbers = ", ".join(f"{name}={float(value):.17g}" for name, value in zip(FIELDS[self.kind], self.numbers))
            return f"<vesica {self.kind.name.lower()} {numbers}>"
        return f"<{len(self)} vesica {self.kind.name.lower()} shapes of {self.dtype}>"

    @property
    def numbers(self):
        """A copy of the numbers: a row a shape, a column a number; of a single shape its numbers."""
        return numpy.stack([column[0] if self.single else column for column in self.columns], axis=-1)

    def structs(self):
        """The structs of the C library, one after the other."""
        return numpy.atleast_2d(numpy.ascontiguousarray(self.numbers))

    def astype(self, dtype):
        """The same shapes with float64 or float32 numbers, which are rounded to float32."""
        dtype = numpy.dtype(dtype)
        if dtype.char not in "df":
            raise TypeError(f"shapes have float64 or float32 numbers, not {dtype}")
        return shapes(self.kind, self.numbers.astype(dtype))

    def invalid(self):
        """The numbers of the invalid shapes: NaN or infinity, a negative size, a zero axis, min above max, no vertex."""
        boxes = numpy.empty((len(self.columns[0]), 4), self.dtype)
        if BOUNDS[self.letter](ctypes.byref(self.view), boxes.ctypes.data) >= 0:
            return numpy.empty(0, numpy.int64)
        suspects = numpy.flatnonzero(numpy.isnan(boxes[:, 0]))  # the boxes of the others may be too large for float32
        rows = (self if self.single else self[suspects]).structs()
        check, start, step = CHECK[self.letter], rows.ctypes.data, rows.strides[0]
        codes = numpy.array([check(self.kind, start + i * step) for i in range(len(rows))], numpy.int64)
        return suspects[(codes < 0) & (codes != _declarations.E_NOT_SIMPLE)]

    def fault(self, i):
        """What makes shape i invalid, in words."""
        return fault_of(FIELDS[self.kind], [column[i] for column in self.columns]) or "it is invalid"


# The numbers that may not be negative, and those that may not be above others.
_SIZES = {"r", "hx", "hy", "a", "b", "width", "height", "radius", "length", "ratio"}
_ORDERED = (("min_x", "max_x"), ("min_y", "max_y"))


def fault_of(names, numbers):
    """Which of a shape's numbers makes it invalid, by its name; None if none does."""
    by_name = dict(zip(names, numbers))
    for name, number in by_name.items():
        if not numpy.isfinite(number) or (name in _SIZES and number < 0):
            return f"{name} is {plainly(number)}"
    if by_name.get("ux") == by_name.get("uy") == 0:
        return "ux and uy are both 0"
    for low, high in _ORDERED:
        if low in by_name and by_name[low] > by_name[high]:
            return f"{low} is {plainly(by_name[low])}, above {high}, {plainly(by_name[high])}"
    for name in ("width", "height") if "radius" in by_name else ():
        if 2 * by_name["radius"] > by_name.get(name, math.inf):
            return f"radius is {plainly(by_name['radius'])}, above half of {name}, {plainly(by_name[name])}"
    return None


def not_finite(what, places):
    """The first of some places (n, 2) that is not finite, in words; None if all are."""
    wrong = numpy.flatnonzero(~numpy.isfinite(places).all(axis=1))
    return f"{what} {wrong[0]} is ({', '.join(map(plainly, places[wrong[0]]))})" if len(wrong) else None


def first_of_rows(rows, fault, of=""):
    """The first of the invalid rows, in words."""
    more = f" (the first of {len(rows)} invalid rows)" if len(rows) > 1 else ""
    return f"row {rows[0]}{of}: {fault}{more}"


# An invalid shape: of a call with shapes, and of a single one.
_OF_SHAPES = (
    _declarations.E_SHAPE,
    _declarations.E_NOT_FINITE,
    _declarations.E_NEGATIVE_SIZE,
    _declarations.E_ZERO_AXIS,
    _declarations.E_INVERTED,
)


def refused(code, result=None, **operands):
    """The error of a call with shapes, which names the shape and the number that the library refuses."""
    message = None
    if code == _declarations.E_KIND:
        kinds = dict.fromkeys(shape.kind.name.lower() for shape in operands.values())
        message = f"not for {' and '.join(kinds)} shapes"
    elif code in _OF_SHAPES:
        message = "; ".join(filter(None, (_invalid_in(name, shape) for name, shape in operands.items())))
    return VesicaError(code, message, result)


def _invalid_in(name, shape):
    rows = shape.invalid()
    if len(rows) == 0:
        return None
    fault = shape.fault(rows[0])
    return f"{name}: {fault}" if shape.single else first_of_rows(rows, fault, f" of {name}")


def accepted(code, **operands):
    """The answer of a call with shapes, if it is one."""
    if code < 0:
        raise refused(code, **operands)
    return code


def all_points(function, a, b, *more):
    """The points (n, 2) that a function of two single shapes writes. Without polygons they are at most 12."""
    out = numpy.empty((12, 2), a.dtype)
    while True:
        count = function(a.kind, a.record, b.kind, b.record, out.ctypes.data, len(out), *more)
        accepted(count, a=a, b=b)
        if count <= len(out):
            return first_rows(out, count)
        out = numpy.empty((count, 2), a.dtype)


def _shapes_of(kind, columns, single=False):
    """Shapes of columns that fit: as many as the kind has numbers, of one dimension, type, length and stride.

    The library reads where they say, so nobody else makes any.
    """
    dtype = columns[0].dtype
    letter = dtype.char
    stride = columns[0].strides[0] if len(columns[0]) > 1 else dtype.itemsize
    addresses = [column.ctypes.data for column in columns]
    view = VIEWS[letter](int(kind), 0, len(columns[0]), stride, (ctypes.c_void_p * 8)(*addresses))
    scalar = ctypes.c_double if letter == "d" else ctypes.c_float
    # view is the C library's of the array; record what the functions of two shapes take for a single shape.
    record = _record(scalar, addresses) if single else None
    return new_shapes(Shapes, kind, single, tuple(columns), dtype, view, record)


def new_shapes(made_as, kind, single, columns, dtype, view, record):
    """Shapes with these members, which belong together."""
    made = made_as.__new__(made_as)
    for name, value in zip(Shapes.__slots__, (kind, single, columns, dtype, dtype.char, view, record)):
        object.__setattr__(made, name, value)
    return made


def the_shapes(value, name):
    """value, if it is Shapes; an error that says how to make them if not."""
    if isinstance(value, Shapes):
        return value
    if _has_shapes(value):
        raise TypeError(f"{name} is a list of shapes: {_TOGETHER}")
    raise TypeError(
        f"{name} is {type(value).__name__}: say which shapes it holds, as in vesica.rects({name}) "
        f"or vesica.shapes(vesica.Kind.CIRCLE, {name})"
    )


MADE = {Shapes}  # and what is derived from it
_TOGETHER = "make one array of them, as by vesica.shapes(kind, [shape.numbers for shape in ...])"


def _has_shapes(value):
    return isinstance(value, (list, tuple)) and any(isinstance(each, Shapes) for each in value)


def one_shape(value, name):
    """value, if it is a single shape, or an array of one."""
    count = len(the_shapes(value, name).columns[0])
    if count != 1:
        raise VesicaError(_declarations.E_ARGUMENT, f"{name} has {count} shapes, not a single one: take {name}[i]")
    return value


def same_scalar(a, b, name_a="a", name_b="b"):
    """The letter of the type that the numbers of both have."""
    if the_shapes(a, name_a).letter != the_shapes(b, name_b).letter:
        raise TypeError(
            f"{name_a} has {a.dtype} numbers and {name_b} {b.dtype}: convert one of them, as by {name_a}.astype('f8')"
        )
    return a.letter


def _one_number(index):
    """An index that is one whole number, of whatever type, as an int; None for any other."""
    if isinstance(index, (bool, numpy.bool_)):
        raise TypeError("a bool is not the number of a shape; a mask has one for each")
    try:
        return operator.index(index)
    except TypeError:
        return None


def plain(values, name):
    """Values as an array that has them all. Those that a mask hides would come to light, so there may be none."""
    if isinstance(values, Shapes):
        raise TypeError(f"{name} are {values.kind.name.lower()} shapes already, not an array of numbers")
    if hasattr(values, "__dlpack__") and not isinstance(values, numpy.ndarray):
        values = _of_dlpack(values, name)
    kinds, masked = _elements(values) if isinstance(values, (list, tuple)) else (set(), numpy.ma.is_masked(values))
    if not kinds.isdisjoint(MADE):
        raise TypeError(f"{name} are shapes already: {_TOGETHER}")
    if masked:
        raise ValueError(f"{name}: some of the numbers are masked, and masks are not looked at; take the others alone")
    array = _as_array(values, name)
    if kinds - {float, list, tuple} and array.dtype.kind == "f" and _rounded(values, array):
        raise ValueError(f"{name}: {array.dtype} lacks some of these whole numbers: above 2**53 it has not all")
    return array


# numpy before 1.24 makes objects of ragged rows, and warns.
_WARNS = tuple(map(int, numpy.__version__.split(".")[:2])) < (1, 24)


def _as_objects(values):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return numpy.asarray(values)


def _as_array(values, name):
    """Values as numpy takes them, if these are numbers; an error that says which is none if not."""
    try:
        array = _as_objects(values) if _WARNS else numpy.asarray(values)
    except ValueError:
        raise _no_numbers(values, name) from None
    objects = array.dtype.kind == "O" and not (array.ndim and all(isinstance(each, Number) for each in array.flat))
    if objects or array.dtype.kind in "US":
        raise _no_numbers(values, name)
    return array


def _no_numbers(values, name):
    """The error for what is no array of numbers, with the first row that makes it none."""
    if hasattr(values, "__array__") and numpy.ndim(values):
        values = numpy.asarray(values).tolist()
    if not isinstance(values, (list, tuple)):
        given = repr(values) if values is None or isinstance(values, str) else f"of the type {type(values).__name__}"
        return TypeError(f"{name} is {given}, not an array of numbers")
    one = (str, bytes, Shapes)
    sizes = [None if isinstance(row, one) or not hasattr(row, "__len__") else len(row) for row in values]
    for i, (row, size) in enumerate(zip(values, sizes)):
        if isinstance(row, Mapping):
            return TypeError(f"{name}: row {i} is a dict; columns of one dict are taken, not a list of dicts")
        if size is None and not isinstance(row, Number):
            return TypeError(f"{name}: row {i} is {row!r}, not numbers")
        if size != sizes[0]:
            has = ("one number" if n is None else f"{n} numbers" for n in (size, sizes[0]))
            return ValueError(f"{name}: row {i} has {next(has)}, row 0 has {next(has)}")
    for i, row in enumerate(values):
        for j, value in enumerate(row if sizes[i] else ()):
            if not isinstance(value, Number) and not hasattr(value, "__len__") or isinstance(value, (str, bytes)):
                return TypeError(f"{name}: row {i}, number {j} is {value!r}, not a number")
    return ValueError(f"{name}: rows of unequal length, or something that is no number, are no array")


# What DLPack calls the devices whose memory this processor reads, and others.
_READ_HERE = {1, 3, 11, 13}  # its own; CUDA's and ROCm's pinned and managed memory
_DEVICES = {2: "CUDA", 4: "OpenCL", 7: "Vulkan", 8: "Metal", 10: "ROCm", 14: "oneAPI", 15: "WebGPU"}


def _of_dlpack(tensor, name):
    """A tensor of another library, as PyTorch, JAX and CuPy have them, where it lies."""
    device, number = tensor.__dlpack_device__()
    if int(device) not in _READ_HERE:
        where = _DEVICES.get(int(device), f"of DLPack's type {int(device)}")
        raise TypeError(f"{name}: the tensor is on the device {where} {number}; move it to the CPU first, as by .cpu()")
    if not hasattr(numpy, "from_dlpack"):  # before 1.22
        return numpy.asarray(tensor)
    return numpy.from_dlpack(tensor)


def _elements(values):
    """The types in a list and in the lists within, and whether any are masked. No deeper list is taken than three."""
    types = set()
    for _ in range(3):
        kinds = set(map(type, values))
        types |= kinds
        if any(issubclass(kind, numpy.ma.MaskedArray) for kind in kinds) and any(map(numpy.ma.is_masked, values)):
            return types, True
        lists = {kind for kind in kinds if issubclass(kind, (list, tuple))}
        if not lists:
            break
        within = values if lists == kinds else [each for each in values if isinstance(each, (list, tuple))]
        values = list(itertools.chain.from_iterable(within))
    return types, False


def _rounded(values, array):
    """Whether a list had whole numbers, beside others, that its array of floats has not. Smaller ones it always has."""
    if not (numpy.abs(array) >= 2.0**53).any():
        return False
    given = numpy.array(values, object).ravel().tolist()
    return any(isinstance(a, Integral) and int(a) != b for a, b in zip(given, array.ravel().tolist()))


def exactly(values, dtype):
    """Numbers as a type of floats, or None where it lacks one of them."""
    if values.dtype == dtype:
        return values
    with numpy.errstate(all="ignore"):
        floats = values.astype(dtype)
    if values.dtype.kind in "iu":
        # numpy would compare rounded integers; Python compares what they are. Smaller ones are never rounded.
        large = numpy.abs(floats) >= 2.0 ** (numpy.finfo(dtype).nmant + 1)
        same = floats[large].tolist() == values[large].tolist()
    else:
        same = numpy.array_equal(floats, values, equal_nan=values.dtype.kind == "f")
    return floats if same else None


def _alike(columns):
    """Columns with one stride, as the library wants them: copies only where they differ."""
    for column in columns:
        if column.ndim != 1:
            raise ValueError(f"an array of shapes has one dimension, not the shape {column.shape}")
    strides = {column.strides[0] for column in columns if len(column) > 1}
    return columns if len(strides) <= 1 else [numpy.ascontiguousarray(column) for column in columns]


def floats_of(array, name):
    """Numbers as float64, or as float32 where they are that. Only what is neither is copied."""
    array = plain(array, name)
    if array.dtype.kind in "iub":
        floats = exactly(array, numpy.float64)
        if floats is None:
            lacks = f"float64 lacks some of these numbers of {array.dtype}: above 2**53 it has not all"
            raise ValueError(f"{name}: {lacks}")
        return floats
    if array.dtype.char not in "df":
        hint = ": convert them, as by .astype('f8')" if array.dtype.kind in "fO" else ""
        raise TypeError(f"{name} have float64 or float32 numbers, not {array.dtype}{hint}")
    return array.astype(array.dtype.newbyteorder("=")) if not array.dtype.isnative else array


def rows_of(array, what, *names):
    """An array with a column for each of the names, and whether it is only one row."""
    named = _columns(array, what, names)
    if named is not None:
        columns, single = named
        return numpy.stack(columns, axis=-1), single
    return _rows(array, what, names)


def _rows(array, what, names):
    array = floats_of(array, what)
    if array.ndim == 2 and array.shape[1] == len(names):
        return array, False
    if array.ndim == 1 and len(array) == len(names):
        return array[None, :], True
    if array.size == 0 and array.ndim == 1:
        return array.reshape(0, len(names)), False
    raise ValueError(
        f"{what} need {len(names)} numbers each ({' '.join(names)}): an array of shape (n, {len(names)}) or "
        f"({len(names)},), not {array.shape}{_other_rows(array.shape, what, len(names))}"
    )


def _other_rows(shape, what, wanted):
    """What rows of another length may be."""
    if len(shape) == 2 and shape[0] == wanted:
        return "; if each column is a shape, take its transpose"
    turned = what in ("rects", "ellipses", "ellipses_in_boxes", "round_rects")
    if turned and (shape[-1:] == (8,) or shape[-2:] == (4, 2)):
        return "; four corners are taken by vesica.rects_from_corners"
    if turned and shape[-1:] == (4,):
        return "; x0 y0 x1 y1 are taken by vesica.aabbs, and boxes that are not turned have an angle of 0"
    if turned and shape[-1:] == (6,):
        return "; cx cy ux uy and half sizes are taken by vesica.shapes(kind, array)"
    return ""


def _columns(array, what, wanted):
    """The columns of a dict, a table or structured array by their names, and whether it is of one shape.

    None for what has no such names: a table may be taken by the order of its columns.
    """
    names = getattr(getattr(array, "dtype", None), "names", None)
    if names is None and isinstance(array, Mapping):
        names = list(array)
    if names is None and not isinstance(array, Shapes) and hasattr(array, "columns"):
        of_table = list(array.columns)
        names = of_table if set(wanted) <= set(of_table) or len(of_table) != len(wanted) else None
    if names is None:
        return None
    missing = [name for name in wanted if name not in names]
    if missing:
        raise ValueError(f"{what} need fields {' '.join(wanted)}; missing: {' '.join(missing)}")
    record = getattr(array, "ndim", None) == 0
    array = numpy.atleast_1d(array) if record else array
    columns = [floats_of(array[name], f"{what}: {name}") for name in wanted]
    types = {str(column.dtype) for column in columns}
    if len(types) > 1:
        which = ", ".join(f"{name} {column.dtype}" for name, column in zip(wanted, columns))
        raise TypeError(f"the fields of {what} are all float64 or all float32, not {which}")
    scalars = all(column.ndim == 0 for column in columns)
    columns = [column.reshape(1) if scalars else column for column in columns]
    if len({column.shape for column in columns}) > 1:
        lengths = ", ".join(f"{name} {len(column) if column.ndim else 'one'}" for name, column in zip(wanted, columns))
        raise ValueError(f"{what} have columns of different lengths: {lengths}")
    return _alike(columns), record or scalars


def shapes(kind, array):
    """Shapes of a kind from their numbers as the library has them (FIELDS), without a copy.

    array: (n, numbers), a row a shape, of any strides; (numbers,) for a single shape; a list of such; a structured
    array, a dict or a table, as pandas and polars have it, with columns of the names in FIELDS, among others; or an
    array of Arrow, of structs that have such columns, or of lists that have so many numbers. Boxes along the axes may
    have GeoArrow's names there. A table that has other names is taken by the order of its columns.
    """
    kind = one_of(Kind, kind, "kind")
    if kind not in FIELDS:
        raise TypeError(f"{kind.name.lower()} shapes have vertices: they are made by vesica.{kind.name.lower()}s")
    if is_arrow(array):
        names = [FIELDS[kind], _GEOARROW_BOX] if kind == Kind.AABB else [FIELDS[kind]]
        return _shapes_of(kind, columns_of(array, _GEOARROW.get(kind), *names))
    what = f"{kind.name.lower()}s"
    named = _columns(array, what, FIELDS[kind])
    if named is not None:
        return _shapes_of(kind, *named)
    rows, single = _rows(array, what, FIELDS[kind])
    return _shapes_of(kind, list(rows.T), single)


_BOX = ("x", "y", "width", "height", "angle")


def points(xy):
    """Points from (n, 2): x, y."""
    return shapes(Kind.POINT, xy)


def segments(ends):
    """Segments from (n, 4): x0, y0, x1, y1."""
    return shapes(Kind.SEGMENT, ends)


def circles(xyr):
    """Discs from (n, 3): centre x, y and radius."""
    return shapes(Kind.CIRCLE, xyr)


def capsules(xyxyr):
    """Capsules from (n, 5): the ends x0, y0, x1, y1 of a segment, and radius."""
    return shapes(Kind.CAPSULE, xyxyr)


def aabbs(xyxy):
    """Boxes along the axes from (n, 4): min x, min y, max x, max y, as detectors give them."""
    return shapes(Kind.AABB, xyxy)


def rects(array, degrees=False, *, quarters=False, reverse=False, threads=None):
    """Rotated rectangles from (n, 5): centre x, y, width, height, angle of the width's edge. A row for a single one.

    The angle is in radians, degrees, or quarter turns, from +x towards +y (counter-clockwise where y points up), or
    with `reverse` the other way. Multiples of 90 degrees turn exactly. An invalid row is a VesicaError, whose `result`
    has NaN for it. shapes(Kind.RECT, ...) takes the library's own six numbers without a copy.
    """
    rows, single = rows_of(array, "rects", *_BOX)
    return _from_boxes(Kind.RECT, _RECTS_FROM_BOXES, rows, single, angle_unit(degrees, quarters, reverse), _BOX, threads)


def ellipses(array, degrees=False, *, quarters=False, reverse=False, threads=None):
    """Ellipses from (n, 5): centre x, y, half axes a, b, angle of a; else as rects."""
    names = ("x", "y", "a", "b", "angle")
    rows, single = rows_of(array, "ellipses", *names)
    unit, boxes_of_one = angle_unit(degrees, quarters, reverse), numpy.array(rows)
    sizes = boxes_of_one[:, 2:4]
    # The library halves what it gets, or the axis where that would round. Of a size of 1 it never does.
    sizes[(sizes >= 0) & numpy.isfinite(sizes)] = 1
    return _from_boxes(Kind.ELLIPSE, _ELLIPSES_FROM_BOXES, boxes_of_one, single, unit, names, threads, rows)


def ellipses_in_boxes(array, degrees=False, *, quarters=False, reverse=False, threads=None):
    """Ellipses from the boxes about them, (n, 5) as of rects, whose sides they touch in the middle."""
    rows, single = rows_of(array, "ellipses_in_boxes", *_BOX)
    return _from_boxes(Kind.ELLIPSE, _ELLIPSES_FROM_BOXES, rows, single, angle_unit(degrees, quarters, reverse), _BOX, threads)


def round_rects(array, degrees=False, *, quarters=False, reverse=False, threads=None):
    """Rounded rectangles from (n, 6): x, y, width, height, angle as rects, and the radius of the corners.

    Width and height include the round corners. A radius of more than half of one of them is an invalid row.
    """
    names = (*_BOX, "radius")
    rows, single = rows_of(array, "round_rects", *names)
    unit, core, radius = angle_unit(degrees, quarters, reverse), numpy.array(rows[:, :5]), rows[:, 5]
    with numpy.errstate(all="ignore"):
        core[:, 2:4] -= 2 * radius[:, None]
    core[radius < 0, 2] = -1  # a negative size, which the library refuses
    return _from_boxes(Kind.ROUND_RECT, _RECTS_FROM_BOXES, core, single, unit, names, threads, rows)


def boxes(shape, degrees=False, *, quarters=False, reverse=False, threads=None):
    """The way back: (n, 5) of centre x, y, width, height, angle of rectangles, or of the boxes about ellipses."""
    unit = angle_unit(degrees, quarters, reverse)
    out = numpy.empty((len(the_shapes(shape, "shape").columns[0]), 5), shape.dtype)

    def ask(view, row):
        return _BOXES_FROM_SHAPES[shape.letter](view, unit, row)

    code = divided(ask, [shape.view], [(out.ctypes.data, out.strides[0])], len(out), threads)
    result = out[0] if shape.single else out
    if code < 0:
        raise refused(code, result if code != _declarations.E_KIND else None, shape=shape)
    return result


def angle_unit(degrees, quarters, reverse):
    """The library's number of a unit of angles and a sense."""
    if degrees and quarters:
        raise ValueError("angles are in degrees or in quarter turns, not both")
    unit = _declarations.ANGLE_DEGREES if degrees else _declarations.ANGLE_RADIANS
    unit = _declarations.ANGLE_QUARTERS if quarters else unit
    return unit + _declarations.ANGLE_REVERSED if reverse else unit


def _from_boxes(kind, functions, rows, single, unit, names, threads, given=None):
    """Shapes that the library makes from rows.

    names: of the columns that the caller gave. given: these, where rows are made from them: half sizes, or a radius.
    """
    if rows.strides[1] != rows.itemsize:
        rows = numpy.ascontiguousarray(rows)
    out = numpy.empty((len(rows), 6), rows.dtype)
    code = _from_rows(functions, rows, out, threads, unit)
    if kind == Kind.ELLIPSE and given is not None:
        valid = ~numpy.isnan(out[:, 4])
        out[valid, 4:6] = given[valid, 2:4]
    if kind == Kind.ROUND_RECT:
        out = numpy.column_stack((out, given[:, 5]))
        out[numpy.isnan(out[:, 4]), 6] = numpy.nan
    rows = rows if given is None else given
    return _made(code, kind, out, single, lambda i: fault_of(names, rows[i]))


def _from_rows(functions, rows, out, threads, *more):
    """The code of a function that makes a row of numbers from each row of others."""
    function, start, step = functions[rows.dtype.char], rows.ctypes.data, rows.strides[0]

    def ask(begin, end):
        return function(start + begin * step, end - begin, step, *more, out.ctypes.data + begin * out.strides[0])

    return by_ranges(ask, len(rows), threads)


def _made(code, kind, numbers, single, fault):
    """Shapes of rows that the library made, or its error with them. fault(i): what is wrong with row i, in words."""
    made = _shapes_of(kind, list(numbers.T), single)
    if code >= 0:
        return made
    wrong = made.invalid()
    if len(wrong) == 0:
        raise VesicaError(code, result=made)
    why = fault(wrong[0]) or str(VesicaError(code))
    raise VesicaError(code, why if single else first_of_rows(wrong, why), made)


def rects_from_corners(corners, threads=None):
    """Rectangles from (n, 4, 2) or (n, 8): four corners in order round the outline, in either sense; one for a single.

    Corners that are not exactly a rectangle's give one near them: `rect_corners_misfit` says how near. A row of crossed
    corners, as in the order of a table's rows, is a VesicaError, whose `result` has NaN for it.
    """
    rows, single = _corner_rows(corners)
    out = numpy.empty((len(rows), 6), rows.dtype)
    code = _from_rows(_RECTS_FROM_CORNERS, rows, out, threads)

    def fault(i):
        alone = _RECT_FROM_CORNERS[rows.dtype.char](rows[i].ctypes.data, numpy.empty(6, rows.dtype).ctypes.data)
        crossed = "corners are crossed, not in order round the outline"
        return crossed if alone == _declarations.E_ARGUMENT else not_finite("corner", rows[i].reshape(4, 2))

    return _made(code, Kind.RECT, out, single, fault)


def rect_corners_misfit(corners, rect, threads=None):
    """How far corners (n, 4, 2) or (n, 8) are off those of rectangles: an array, or a float for a single rectangle.

    It is the largest distance from a given corner to the rectangle's corner that corresponds to it. The corners may
    start at any corner of the rectangle and run in either sense.
    """
    rows, _ = _corner_rows(corners)
    if the_shapes(rect, "rect").kind != Kind.RECT:
        raise VesicaError(_declarations.E_KIND, f"rect holds {rect.kind.name.lower()} shapes, not rectangles")
    if rows.dtype != rect.dtype:
        raise TypeError(f"corners are {rows.dtype} and rect {rect.dtype}: both are float64, or both float32")
    if len(rows) != len(rect.columns[0]):
        raise ValueError(f"corners are of {len(rows)} rectangles, and rect has {len(rect.columns[0])}")
    out = numpy.empty(len(rows), rows.dtype)
    result = None if rect.single else out
    if rect.single:
        code = _MISFIT_OF_ONE[rect.letter](rows.ctypes.data, rect.record, out.ctypes.data)
    else:

        def ask(rect_view, row, misfit):
            return _CORNERS_MISFIT[rect.letter](row, rows.strides[0], rect_view, misfit)

        columns = [(rows.ctypes.data, rows.strides[0]), (out.ctypes.data, out.itemsize)]
        code = divided(ask, [rect.view], columns, len(rows), threads)
    if code < 0:
        for i in numpy.flatnonzero(~numpy.isfinite(rows).all(axis=1))[:1]:
            raise VesicaError(code, f"row {i} of corners: {not_finite('corner', rows[i].reshape(4, 2))}", result)
        raise refused(code, result, rect=rect)
    return out[0].item() if rect.single else out


def _corner_rows(corners):
    """Four corners each as rows of 8 numbers, and whether they are of a single rectangle."""
    corners = floats_of(corners, "corners")
    if corners.shape == (0,):
        corners = corners.reshape(0, 8)
    in_pairs = corners.shape[-2:] == (4, 2)
    if corners.shape[-1:] != (8,) and not in_pairs or corners.ndim > 2 + in_pairs:
        raise ValueError(f"corners have the shape (n, 4, 2), (n, 8), or (4, 2) or (8,) for one, not {corners.shape}")
    rows = corners.reshape(-1, 8)
    if len(rows) and rows.strides[1] != rows.itemsize:
        rows = numpy.ascontiguousarray(rows)
    return rows, corners.ndim == 1 + in_pairs


def ellipses_from_covariance(means, covariances, k=1.0):
    """Ellipses of the points within k standard deviations: means (n, 2), covariances (n, 2, 2), or one of each.

    They are float32 where means and covariances both are.
    """
    means, covariances = floats_of(means, "means"), floats_of(covariances, "covariances")
    if means.shape[-1:] != (2,) or covariances.shape != (*means.shape, 2) or means.ndim > 2:
        raise ValueError(
            f"means have the shape (n, 2) and covariances (n, 2, 2), not {means.shape} and {covariances.shape}"
        )
    dtype = numpy.result_type(means, covariances)
    k = real(k, "k", dtype, 0)
    rows, matrices = means.reshape(-1, 2).astype(dtype), covariances.reshape(-1, 2, 2).astype(dtype)
    upper, lower = matrices[:, 0, 1], matrices[:, 1, 0]
    unknown = numpy.isnan(upper) | numpy.isnan(lower)
    skew = (upper != lower) & ~unknown
    if skew.any():
        i = numpy.argmax(skew)
        raise ValueError(f"covariances: row {i} is not symmetric: {plainly(upper[i])} and {plainly(lower[i])}")
    upper[unknown] = numpy.nan  # the library is given this one, and says what is wrong
    given = numpy.column_stack((rows, matrices[:, 0, 0], upper, matrices[:, 1, 1], numpy.full(len(rows), k, dtype)))

    def fault(i):
        finite = fault_of(("x", "y", "cxx", "cxy", "cyy", "k"), given[i])
        return finite or f"the covariance {' '.join(map(plainly, given[i, 2:5]))} (xx xy yy) has a negative variance"

    return constructed(Kind.ELLIPSE, _ELLIPSE_FROM_COVARIANCE, given, means.ndim == 1, fault)


def constructed(kind, functions, rows, single, fault):
    """Shapes that a constructor of the C library makes of a row of arguments each, one by one."""
    numbers, function, first = numpy.empty((len(rows), len(FIELDS[kind])), rows.dtype), functions[rows.dtype.char], 0
    for i, row in enumerate(rows):
        code = function(*row, numbers[i].ctypes.data)
        if code < 0:
            numbers[i] = numpy.nan
            first = first or code
    return _made(first, kind, numbers, single, fault)


def check(shape):
    """Raises VesicaError, which says why, if a single shape is invalid. Of arrays, `Shapes.invalid` tells which are."""
    if not the_shapes(shape, "shape").single:
        raise TypeError("check takes a single shape")
    code = CHECK[shape.letter](shape.kind, shape.record)
    if code < 0:
        raise VesicaError(code, shape.fault(0) if len(shape.invalid()) else None)
