# SPDX-License-Identifier: Apache-2.0
"""Questions about shapes. Two single shapes give a number, arrays in step an array; `_matrix` asks of every pair."""
import bisect
import ctypes
import enum
import math
from numbers import Real
from typing import NamedTuple

import numpy

from . import _declarations
from ._library import VesicaError, by_scalar, checked, first_rows, library, one_of, real, whole
from ._threads import count_of, cut, divided, in_order, parts_of, ranges, worst
from .shapes import (
    BOUNDS,
    FIELDS,
    Kind,
    accepted,
    all_points,
    exactly,
    first_of_rows,
    one_shape,
    plain,
    refused,
    same_scalar,
    shapes,
    the_shapes,
)


class Relation(enum.IntEnum):
    """How a shape a relates to a shape b; the eight relations of RCC-8."""

    DISJOINT = _declarations.DISJOINT
    TOUCH = _declarations.TOUCH
    CROSS = _declarations.CROSS
    INSIDE = _declarations.INSIDE
    INSIDE_TOUCH = _declarations.INSIDE_TOUCH
    CONTAINS = _declarations.CONTAINS
    CONTAINS_TOUCH = _declarations.CONTAINS_TOUCH
    EQUAL = _declarations.EQUAL


class Ratio(enum.IntEnum):
    """What a shared area is compared with; the last three take from IoU what else is unlike."""

    OVER_UNION = _declarations.RATIO_OVER_UNION  # IoU
    OVER_FIRST = _declarations.RATIO_OVER_FIRST  # IoF
    OVER_SECOND = _declarations.RATIO_OVER_SECOND  # IoA
    OVER_SMALLER = _declarations.RATIO_OVER_SMALLER  # IoS
    GENERALIZED = _declarations.RATIO_GENERALIZED  # GIoU
    DISTANCE = _declarations.RATIO_DISTANCE  # DIoU
    COMPLETE = _declarations.RATIO_COMPLETE  # CIoU


class Gaussian(enum.IntEnum):
    """A distance of two shapes as Gaussian distributions. None is an IoU: ProbIoU is 1 - HELLINGER."""

    BHATTACHARYYA = _declarations.GAUSSIAN_BHATTACHARYYA
    HELLINGER = _declarations.GAUSSIAN_HELLINGER
    KULLBACK_LEIBLER = _declarations.GAUSSIAN_KULLBACK_LEIBLER  # KLD, of a from b
    WASSERSTEIN = _declarations.GAUSSIAN_WASSERSTEIN  # GWD, the squared distance


class Within(enum.IntEnum):
    """Whether two shapes are at most so far apart. NEARLY, only with ellipses: too close to decide."""

    NO = _declarations.WITHIN_NO
    YES = _declarations.WITHIN_YES
    NEARLY = _declarations.WITHIN_NEARLY


class ClosestPoints(NamedTuple):
    """A distance, the point (ax, ay) of a and the point (bx, by) of b: floats, or arrays."""

    distance: numpy.ndarray
    ax: numpy.ndarray
    ay: numpy.ndarray
    bx: numpy.ndarray
    by: numpy.ndarray


class Penetration(NamedTuple):
    """How far b must be moved, and in which direction (x, y), until it only touches a: floats, or arrays."""

    depth: numpy.ndarray
    x: numpy.ndarray
    y: numpy.ndarray


class Crossings(NamedTuple):
    """The places (n, 2) where two outlines meet, and whether they share a stretch."""

    places: numpy.ndarray
    shared: bool


def _output(out, shape, dtypes, inputs):
    """An array for results: the caller's, if it can take them. inputs: arrays that it may share no memory with."""
    if out is None:
        return numpy.empty(shape, dtypes[0])
    if not isinstance(out, numpy.ndarray) or out.dtype not in dtypes:
        wanted = " or ".join(str(numpy.dtype(dtype)) for dtype in dtypes)
        raise TypeError(f"out must be an array of {wanted}, not {getattr(out, 'dtype', type(out).__name__)}")
    if out.shape != shape:
        raise ValueError(f"out must have the shape {shape}, not {out.shape}")
    if not out.flags.writeable:
        raise ValueError("out cannot be written to")
    if not out.flags.aligned:
        raise ValueError("out is not aligned: its numbers must lie at multiples of their size")
    contiguous = out.shape[-1] == 1 or out.strides[-1] == out.itemsize
    if out.size and (not contiguous or (out.ndim == 2 and out.strides[0] % out.itemsize != 0)):
        raise ValueError("the last axis of out must be contiguous")
    if out.ndim == 2 and len(out) > 1 and abs(out.strides[0]) < out.shape[1] * out.itemsize:
        raise ValueError("the rows of out overlap one another")
    if any(numpy.may_share_memory(out, array) for array in inputs):
        raise ValueError("out overlaps an input")
    return out


def in_step(a, b):
    """How many answers two operands in step have."""
    counts = {len(shape.columns[0]) for shape in (a, b)}
    counts.discard(1)
    if len(counts) > 1:
        raise ValueError(f"a has {len(a.columns[0])} shapes and b {len(b.columns[0])}: as many, or one of either")
    return counts.pop() if counts else 1


# Errors of single elements, after which the results of all others are there.
_WRITTEN = (_declarations.E_SHAPE, _declarations.E_RANGE)


def finish(code, result, undefined=None, scores=(), **operands):
    """The result, or the error with it; operands: what may be invalid, by the names of the parameters.

    undefined(result): what makes E_ARGUMENT an error of single elements, in words; else nothing was written. scores:
    which make a shape invalid where they are NaN.
    """
    if code >= 0:
        return result
    written = code in _WRITTEN or (undefined is not None and code == _declarations.E_ARGUMENT)
    error = refused(code, result if written else None, **operands)
    unknown = numpy.flatnonzero(numpy.isnan(scores))
    if code == _declarations.E_SHAPE and len(unknown):
        nan = first_of_rows(unknown, "it is NaN", " of scores")
        invalid = any(len(shape.invalid()) for shape in operands.values())
        raise VesicaError(code, f"{error}; {nan}" if invalid else nan, error.result)
    if code == _declarations.E_RANGE:
        raise VesicaError(code, f"{_first_nan(result)}{error}", error.result)
    if code == _declarations.E_ARGUMENT and written:
        raise VesicaError(code, undefined(result), error.result)
    raise error


def _first_nan(result):
    """Which of the results is the first that is NaN: "row 2: "."""
    values = result[0] if isinstance(result, tuple) else result
    if values is None or numpy.ndim(values) == 0:
        return ""
    where = numpy.argwhere(numpy.isnan(values))
    if len(where) == 0:
        return ""
    return f"row {where[0][0]}: " if values.ndim == 1 else f"a[{where[0][0]}] and b[{where[0][1]}]: "


def _no_area(result):
    return f"{_first_nan(result)}the areas leave nothing to divide by"


def _no_variance(result):
    return f"{_first_nan(result)}a shape without an area"


def columns_of(named, out, count, dtype, inputs):
    """An array for each field of a named tuple of results: the caller's, if it has one for it."""
    given = (None,) * len(named._fields) if out is None else out
    if len(given) != len(named._fields):
        raise ValueError(f"out has an array, or None, for each of {' '.join(named._fields)}")
    columns = [_output(column, (count,), (dtype,), inputs) for column in given]
    if out is not None:
        _apart(columns)
    return columns


def _apart(columns):
    """Contiguous arrays may not overlap: each must end where the next one begins, or before."""
    spans = sorted((column.ctypes.data, column.nbytes) for column in columns)
    if any(start + size > following for (start, size), (following, _) in zip(spans, spans[1:])):
        raise ValueError("two arrays of out overlap")


class _Query:
    """A question about two shapes: its C functions and the types of its results."""

    def __init__(self, name, dtypes=None, convert=None, result=None, record=None, first=(), last=(), undefined=None):
        self.one, self.many = by_scalar(name), by_scalar(f"{name}_many")
        self.undefined = undefined  # as of finish
        self.first, self.last = first, last  # arguments before the shapes, and after
        self.dtypes = dtypes  # of codes; numbers have the shapes' own
        self.convert = convert  # a single code
        self.result, self.record = result, record  # a named tuple, and the C struct it comes from

    def __call__(self, a, b, out, threads):
        letter = same_scalar(a, b)
        if a.single and b.single:
            return self._single(letter, a, b, out)
        count, inputs = in_step(a, b), (*a.columns, *b.columns)
        if self.result is None:
            columns = result = _output(out, (count,), self.dtypes or (a.dtype,), inputs)
            columns = (columns,)
        else:
            columns = result = self.result(*columns_of(self.result, out, count, a.dtype, inputs))

        def ask(a, b, *outputs):
            return self.many[letter](*self.first, a, b, *self.last, *outputs)

        outputs = [(column.ctypes.data, column.itemsize) for column in columns]
        code = divided(ask, (a.view, b.view), outputs, count, threads)
        return finish(code, result, self.undefined, a=a, b=b)

    def _single(self, letter, a, b, out):
        if out is not None:
            raise TypeError("the answer for two single shapes is a number: it has no out")
        function = self.one[letter]
        if self.convert is not None:
            code = function(a.kind, a.record, b.kind, b.record, *self.last)
            return self.convert(code if code >= 0 else finish(code, None, a=a, b=b))
        record = self.record[letter]()
        code = function(*self.first, a.kind, a.record, b.kind, b.record, ctypes.byref(record))
        if code < 0:
            finish(code, None, self.undefined, a=a, b=b)
        if self.result is None:
            return record.value
        return self.result(*(getattr(record, field) for field in self.result._fields))


def _stripes(count, threads):
    """[(begin, end)] of the rows or columns of a matrix, of which a few may be much work."""
    step = max(-(-count // (4 * threads)), 1) if threads > 1 else count
    return [(begin, min(begin + step, count)) for begin in range(0, count, max(step, 1))] or [(0, 0)]


def striped(ask, a, b, result, threads):
    """The code of a matrix of answers, of which threads answer stripes, along its longer side.

    ask(a, b, first_a, first_b, address, row): a and b are the C structs from those shapes on.
    """
    threads, shape = count_of(threads, result.size), result.shape
    row = result.strides[0] // result.itemsize if result.size else shape[1]
    by_rows = shape[0] >= shape[1]
    step = (row if by_rows else 1) * result.itemsize

    def of_stripe(span):
        begin, views = span[0], (a.view, b.view)
        if threads > 1:
            views = (cut(a.view, *span), b.view) if by_rows else (a.view, cut(b.view, *span))
        first = (begin, 0) if by_rows else (0, begin)
        return ask(*map(ctypes.byref, views), *first, result.ctypes.data + begin * step, row)

    return worst(in_order(of_stripe, _stripes(max(shape), threads), threads))


class _Matrix:
    """The same question of every pair of two arrays."""

    def __init__(self, name, dtypes=None, first=(), last=(), undefined=None):
        self.function, self.dtypes = by_scalar(f"{name}_matrix"), dtypes
        self.first, self.last, self.undefined = first, last, undefined

    def __call__(self, a, b, out, threads):
        letter = same_scalar(a, b)
        shape = (len(a.columns[0]), len(b.columns[0]))
        result = _output(out, shape, self.dtypes or (a.dtype,), (*a.columns, *b.columns))

        def ask(a, b, first_a, first_b, *output):
            return self.function[letter](*self.first, a, b, *self.last, *output)

        code = striped(ask, a, b, result, threads)
        return finish(code, result, self.undefined, a=a, b=b)


def _structs(name):
    return {"d": getattr(_declarations, f"{name}_f64"), "f": getattr(_declarations, f"{name}_f32")}


_NUMBER = {"d": ctypes.c_double, "f": ctypes.c_float}
_BYTES = (numpy.bool_, numpy.uint8)
_OVERLAP = _Query("overlap", _BYTES, bool)
_INTERIORS = _Query("interiors_overlap", _BYTES, bool)
_RELATION = _Query("relation", (numpy.uint8,), Relation)
_CONTAINS = _Query("contains", _BYTES, bool)
_NEAREST = _Query("nearest", result=ClosestPoints, record=_structs("closest_points"))
_BOUNDARY_DISTANCE = _Query("boundary_distance", result=ClosestPoints, record=_structs("closest_points"))
_DEPTH = _Query("depth", result=Penetration, record=_structs("penetration"))
_SIGNED_DISTANCE = _Query("signed_distance", record=_NUMBER)
_AREA = _Query("area", record=_NUMBER)
_IOU = _Query("iou", record=_NUMBER, undefined=_no_area)
_OVERLAP_MATRIX, _CONTAINS_MATRIX = _Matrix("overlap", _BYTES), _Matrix("contains", _BYTES)
_INTERIORS_MATRIX = _Matrix("interiors_overlap", _BYTES)
_RELATION_MATRIX = _Matrix("relation", (numpy.uint8,))
_AREA_MATRIX, _IOU_MATRIX = _Matrix("area"), _Matrix("iou", undefined=_no_area)
_NEAREST_MATRIX, _BOUNDARY_DISTANCE_MATRIX = _Matrix("nearest"), _Matrix("boundary_distance")
_DEPTH_MATRIX, _SIGNED_DISTANCE_MATRIX = _Matrix("depth"), _Matrix("signed_distance")
_RATIO = {which: _Query("ratio", record=_NUMBER, first=(which,), undefined=_no_area) for which in Ratio}
_RATIO_MATRIX = {which: _Matrix("ratio", first=(which,), undefined=_no_area) for which in Ratio}
_GAUSSIAN = {which: _Query("gaussian_distance", record=_NUMBER, first=(which,), undefined=_no_variance) for which in Gaussian}
_GAUSSIAN_MATRIX = {which: _Matrix("gaussian_distance", first=(which,), undefined=_no_variance) for which in Gaussian}
_SELECT, _SUPPRESS, _SOFT = by_scalar("overlap_select"), by_scalar("suppress"), by_scalar("suppress_soft")
_INTERIORS_SELECT = by_scalar("interiors_overlap_select")
_DECAYS = {"linear": _declarations.DECAY_LINEAR, "gaussian": _declarations.DECAY_GAUSSIAN}
_CROSSINGS = by_scalar("crossings")
_SHAPE_AREA, _SHAPE_AREAS = by_scalar("shape_area"), by_scalar("shape_area_many")
_CORNERS = by_scalar("corners_of_shapes")

# Every question takes shapes a and b. Two single shapes give a number. Arrays in step give an array; of one shape and
# an array, the one is repeated. `out` is a contiguous array to write to. All are float64, or all float32. `threads`
# divides more than 100,000 answers; by default among as many threads as the process has processors. The results and
# the errors are those of one.
# VesicaError is raised for invalid shapes; its `result` has the answers of the others.


def overlap(a, b, out=None, threads=None):
    """Do a and b share a point? Touching counts. Exact. bool; out may also be uint8."""
    return _OVERLAP(a, b, out, threads)


def overlap_matrix(a, b, out=None, threads=None):
    """(len(a), len(b)) of bool: does each of a overlap each of b?"""
    return _OVERLAP_MATRIX(a, b, out, threads)


def _selected(functions, one, many, threads):
    letter = same_scalar(one_shape(one, "one"), many, "one", "many")
    count = len(many.columns[0])

    def ask(span):
        part, room = cut(many.view, *span), span[1] - span[0]
        out = numpy.zeros(room, numpy.int64)
        code = functions[letter](ctypes.byref(one.view), ctypes.byref(part), out.ctypes.data, room)
        # With an invalid shape, which is never selected, -1 follows the others.
        return code, out[: code if code >= 0 else numpy.argmax(out == -1)] + span[0]

    threads = count_of(threads, count)
    parts = in_order(ask, ranges(count, threads), threads) if count else [(0, numpy.empty(0, numpy.int64))]
    found = numpy.concatenate([items for _, items in parts])
    return finish(worst([code for code, _ in parts]), found, one=one, many=many)


def overlap_select(one, many, threads=None):
    """The indices of those of `many` that overlap a single shape, ascending."""
    return _selected(_SELECT, one, many, threads)


def interiors_overlap(a, b, out=None, threads=None):
    """Do the insides of a and b share a point? Touching does not count. Exact. bool; out may also be uint8."""
    return _INTERIORS(a, b, out, threads)


def interiors_overlap_matrix(a, b, out=None, threads=None):
    """(len(a), len(b)) of bool: do the insides of each of a and each of b share a point?"""
    return _INTERIORS_MATRIX(a, b, out, threads)


def interiors_overlap_select(one, many, threads=None):
    """The indices of those of `many` whose insides share a point with that of a single shape, ascending."""
    return _selected(_INTERIORS_SELECT, one, many, threads)


def relation(a, b, out=None, threads=None):
    """How does a relate to b? A Relation, or an array of uint8 with their numbers. Exact."""
    return _RELATION(a, b, out, threads)


def relation_matrix(a, b, out=None, threads=None):
    """(len(a), len(b)) of uint8: the Relation of each of a to each of b."""
    return _RELATION_MATRIX(a, b, out, threads)


def contains(a, b, out=None, threads=None):
    """Does a hold all of b? Equal shapes do. Exact. bool; out may also be uint8."""
    return _CONTAINS(a, b, out, threads)


def contains_matrix(a, b, out=None, threads=None):
    """(len(a), len(b)) of bool: does each of a hold all of each of b?"""
    return _CONTAINS_MATRIX(a, b, out, threads)


def nearest(a, b, out=None, threads=None):
    """How far are the solid shapes apart, and which of their points are closest? ClosestPoints; out has five arrays."""
    return _NEAREST(a, b, out, threads)


def nearest_matrix(a, b, out=None, threads=None):
    """(len(a), len(b)): the distance of each of a from each of b; 0 where they overlap."""
    return _NEAREST_MATRIX(a, b, out, threads)


def boundary_distance(a, b, out=None, threads=None):
    """How far are the outlines apart, that of a shape inside another too? ClosestPoints; out has five arrays."""
    return _BOUNDARY_DISTANCE(a, b, out, threads)


def boundary_distance_matrix(a, b, out=None, threads=None):
    """(len(a), len(b)): the distance of the outline of each of a from that of each of b."""
    return _BOUNDARY_DISTANCE_MATRIX(a, b, out, threads)


def depth(a, b, out=None, threads=None):
    """How far and in which direction must b move until it only touches a? Penetration; out has three arrays."""
    return _DEPTH(a, b, out, threads)


def depth_matrix(a, b, out=None, threads=None):
    """(len(a), len(b)): how far each of b must move until it only touches each of a; 0 where they do not overlap."""
    return _DEPTH_MATRIX(a, b, out, threads)


def signed_distance(a, b, out=None, threads=None):
    """How far are the solid shapes apart or, below 0, how deep do they overlap?"""
    return _SIGNED_DISTANCE(a, b, out, threads)


def signed_distance_matrix(a, b, out=None, threads=None):
    """(len(a), len(b)): the signed distance of each of a and each of b."""
    return _SIGNED_DISTANCE_MATRIX(a, b, out, threads)


def within(a, b, distance, out=None, threads=None):
    """Are a and b at most `distance` apart? Exactly so far counts. A Within, or an array of uint8 with their numbers.

    With a negative distance: do they overlap at least that deep? Exact for the distance as rounded to the shapes' type.
    With ellipses it may be Within.NEARLY where their distance or depth is too near the one asked for to decide.
    """
    last = (real(distance, "distance", the_shapes(a, "a").dtype),)
    return _Query("within", (numpy.uint8,), Within, last=last)(a, b, out, threads)


def within_matrix(a, b, distance, out=None, threads=None):
    """(len(a), len(b)) of uint8: is each of a at most `distance` from each of b? The numbers of Within; as within."""
    last = (real(distance, "distance", the_shapes(a, "a").dtype),)
    return _Matrix("within", (numpy.uint8,), last=last)(a, b, out, threads)


def area(a, b, out=None, threads=None):
    """The area that a and b share, in square units."""
    return _AREA(a, b, out, threads)


def area_matrix(a, b, out=None, threads=None):
    """(len(a), len(b)): the area that each of a shares with each of b."""
    return _AREA_MATRIX(a, b, out, threads)


def iou(a, b, out=None, threads=None):
    """Intersection over union: the shared area over that of both, from 0 to 1."""
    return _IOU(a, b, out, threads)


def iou_matrix(a, b, out=None, threads=None):
    """(len(a), len(b)): intersection over union of each of a with each of b."""
    return _IOU_MATRIX(a, b, out, threads)


def ratio(which, a, b, out=None, threads=None):
    """A Ratio of a and b: what share of one is covered by the other, GIoU, DIoU or CIoU.

    The last three are with the box along the coordinate axes about both shapes. Two shapes whose areas leave nothing to
    divide by are a VesicaError (NaN in its `result`).
    """
    return _RATIO[one_of(Ratio, which, "which")](a, b, out, threads)


def ratio_matrix(which, a, b, out=None, threads=None):
    """(len(a), len(b)): a Ratio of each of a and each of b."""
    return _RATIO_MATRIX[one_of(Ratio, which, "which")](a, b, out, threads)


def gaussian_distance(which, a, b, out=None, threads=None):
    """A distance of circles, boxes, rectangles or ellipses as Gaussian distributions, as `which` of Gaussian says.

    The variance of a rectangle is width^2 / 12 along its sides, of an ellipse a^2 / 4 along its axes. Papers on GWD and
    KLD take width^2 / 4: for theirs multiply widths and heights of rectangles by sqrt(3). A shape without an area is a
    VesicaError (NaN in its `result`), except for WASSERSTEIN.
    """
    return _GAUSSIAN[one_of(Gaussian, which, "which")](a, b, out, threads)


def gaussian_distance_matrix(which, a, b, out=None, threads=None):
    """(len(a), len(b)): a distance of each of a from each of b as Gaussian distributions."""
    return _GAUSSIAN_MATRIX[one_of(Gaussian, which, "which")](a, b, out, threads)


def crossings(a, b):
    """The places where the outlines of two single shapes meet, in order along a's. Their number is exact."""
    letter = same_scalar(a, b)
    if not (a.single and b.single):
        raise TypeError("crossings are those of two single shapes: take a[i] and b[i]")
    shared = ctypes.c_int32()
    return Crossings(all_points(_CROSSINGS[letter], a, b, ctypes.byref(shared)), bool(shared.value))


def shape_area(shape, threads=None):
    """The area of a single shape, or of each of an array."""
    out = numpy.empty(len(the_shapes(shape, "shape").columns[0]), shape.dtype)
    if shape.single:
        accepted(_SHAPE_AREA[shape.letter](shape.kind, shape.record, out.ctypes.data), shape=shape)
        return out[0].item()
    code = divided(_SHAPE_AREAS[shape.letter], [shape.view], [(out.ctypes.data, out.itemsize)], len(out), threads)
    return finish(code, out, shape=shape)


def bounds(shape, threads=None):
    """The smallest boxes that surely contain shapes, as aabbs."""
    return shapes(Kind.AABB, numbers_of(shape, BOUNDS, 4, threads))


def corners(shape, threads=None):
    """The corners of rectangles, or of the boxes about ellipses: (n, 4, 2), or (4, 2) of a single one."""
    numbers = numbers_of(shape, _CORNERS, 8, threads)
    return numbers.reshape(numbers.shape[:-1] + (4, 2))


def numbers_of(shape, functions, numbers, threads):
    """Some numbers of each shape, by a C function of arrays."""
    the_shapes(shape, "shape")
    out = numpy.empty((len(shape.columns[0]), numbers), shape.dtype)
    result = out[0] if shape.single else out
    outputs = [(out.ctypes.data, numbers * out.itemsize)]
    return finish(divided(functions[shape.letter], [shape.view], outputs, len(out), threads), result, shape=shape)


def nms(boxes, scores, threshold=0.5, *, labels=None, ratio=Ratio.OVER_UNION, least_score=None, most=None,
        threads=None):
    """Greedy suppression: the indices of the boxes kept, best score first.

    Each box kept has a ratio of at most `threshold` with every better one that was kept, and has the same label. boxes:
    shapes with an area, polygons too; scores: a number each, which are compared as they are; labels: a whole number
    each; ratio: any but OVER_FIRST and OVER_SECOND; least_score, compared as it is: boxes below it are left out; most:
    how many are kept at most. The threshold is first rounded to the boxes' type. Threads share the labels.
    """
    scores, labels, ratio = scores_of(scores, boxes), labels_of(labels, boxes), _symmetric(ratio)
    threshold = real(threshold, "threshold", boxes.dtype, 0, 1)
    ranks, least_score = _in_order(scores, boxes.dtype, least_score)
    room = _room(most, boxes)

    def kept_of(boxes, ranks, labels):
        keep, kept = numpy.empty(min(room, len(boxes)), numpy.int64), ctypes.c_int64()
        scratch = numpy.empty(checked(library.vesica_nms_scratch(len(boxes))), numpy.uint8)
        code = _SUPPRESS[boxes.letter](
            *(ctypes.byref(boxes.view), ranks.ctypes.data, None if labels is None else labels.ctypes.data, ratio),
            *(threshold, least_score, len(keep), scratch.ctypes.data, len(scratch)),
            *(keep.ctypes.data, ctypes.byref(kept)),
        )
        keep = first_rows(keep, kept.value)
        return code, keep, ranks[keep]

    code, keep, _ = _by_groups(kept_of, boxes, ranks, labels, room, threads)
    return finish(code, keep, scores=ranks, boxes=boxes)


def _by_groups(kept_of, boxes, scores, labels, room, threads):
    """The code, the indices and the scores that kept_of(boxes, scores, labels) gives, which threads ask about groups."""
    groups = [] if labels is None else _groups(labels)
    if len(groups) < 2:
        return kept_of(boxes, scores, labels)
    rows = boxes.structs() if boxes.kind in FIELDS else None  # of one box side by side, as the library reads them

    def of_group(which):
        some = boxes[which] if rows is None else shapes(boxes.kind, rows[which])
        code, keep, left = kept_of(some, scores[which], labels[which])
        return code, which[keep], left

    codes, kept, left = zip(*in_order(of_group, groups, count_of(threads, len(boxes))))
    kept, left = numpy.concatenate(kept), numpy.concatenate(left)
    order = numpy.argsort(-left, kind="stable")  # merges groups, which are in order
    if (numpy.diff(left[order]) == 0).any():
        order = numpy.lexsort((kept, -left))  # of equal scores the lower index comes first, as in the library
    return worst(codes), kept[order[:room]], left[order[:room]]


_BOXES_A_GROUP = 1024


def _groups(labels):
    """Where the labels of each group are, ascending; no two groups have a label in common.

    The library looks at the labels of boxes that overlap, which are nearly all where labels are pictures. Groups of few
    labels spare that.
    """
    groups = min(len(labels) // _BOXES_A_GROUP, 1 << 16)
    if groups < 2:
        return []
    mixed = labels.astype(numpy.uint32)
    for shift, factor in ((16, 0x85EBCA6B), (13, 0xC2B2AE35), (16, 1)):  # the end of MurmurHash3
        mixed ^= mixed >> numpy.uint32(shift)
        mixed *= numpy.uint32(factor)
    group = (mixed % numpy.uint32(groups)).astype(numpy.uint16)
    ends = numpy.cumsum(numpy.bincount(group, minlength=groups))
    return [which for which in numpy.split(numpy.argsort(group, kind="stable"), ends[:-1]) if len(which)]


def nms_soft(boxes, scores, parameter=0.5, *, decay="linear", labels=None, ratio=Ratio.OVER_UNION, least_score=0.0,
             most=None, threads=None):
    """Soft suppression: (indices, scores), as they are taken, with the scores that were left then.

    The best is taken again and again, and lowers those that it has a ratio r with: "linear", times 1 - r where r is
    above the parameter; "gaussian", times exp(-r^2 / parameter). Scores, parameter and least_score are rounded to the
    boxes' type. The rest as nms.
    """
    scores, labels, ratio = scores_of(scores, boxes), labels_of(labels, boxes), _symmetric(ratio)
    scores = as_type(scores, boxes.dtype)
    if decay not in _DECAYS:
        raise ValueError(f"decay is {decay!r}, not one of {', '.join(_DECAYS)}")
    of_decay = (0, 1) if decay == "linear" else (2.0**-100, numpy.finfo(boxes.dtype).max)
    parameter = real(parameter, "parameter", boxes.dtype, *of_decay)
    least_score = real(least_score, "least_score", boxes.dtype, 0)
    room = _room(most, boxes)

    def kept_of(boxes, scores, labels):
        capacity, kept = min(room, len(boxes)), ctypes.c_int64()
        keep, left = numpy.empty(capacity, numpy.int64), numpy.empty(capacity, boxes.dtype)
        scratch = numpy.empty(checked(library.vesica_suppress_soft_scratch(len(boxes))) // 8 + 1, numpy.int64)
        code = _SOFT[boxes.letter](
            *(ctypes.byref(boxes.view), scores.ctypes.data, None if labels is None else labels.ctypes.data, ratio),
            *(_DECAYS[decay], parameter, least_score, capacity, scratch.ctypes.data, scratch.nbytes),
            *(keep.ctypes.data, left.ctypes.data, ctypes.byref(kept)),
        )
        return code, first_rows(keep, kept.value), first_rows(left, kept.value)

    # The library lowers scores in double. Rounded to float32 they do not tell how groups are to be merged.
    in_groups = boxes.letter == "d"
    code, *result = (
        _by_groups(kept_of, boxes, scores, labels, room, threads) if in_groups else kept_of(boxes, scores, labels)
    )
    return finish(code, tuple(result), scores=scores, boxes=boxes)


def _room(most, boxes):
    """How many boxes may be kept. ctypes would wrap a number that has no place in 64 bits."""
    return len(boxes) if most is None else min(whole(most, "most"), len(boxes))


def _symmetric(ratio):
    """A ratio that is the same for both orders of two boxes."""
    ratio = one_of(Ratio, ratio, "ratio")
    if ratio in (Ratio.OVER_FIRST, Ratio.OVER_SECOND):
        raise VesicaError(_declarations.E_ARGUMENT, f"ratio is {ratio.name}: of two boxes either may come first")
    return ratio


def _one_each(name, values, boxes):
    """An array with a value for each box."""
    values = plain(values, name)
    if values.shape != (len(boxes),):
        raise ValueError(f"{len(boxes)} boxes need as many {name}, not an array of shape {values.shape}")
    return values


def scores_of(scores, boxes, name="scores"):
    if the_shapes(boxes, "boxes").single:
        raise TypeError("boxes are an array of shapes, not a single one")
    scores = _one_each(name, scores, boxes)
    if scores.dtype.kind not in "iubf":
        raise TypeError(f"{name} are numbers, not {scores.dtype}")
    return scores


def as_type(scores, dtype):
    with numpy.errstate(over="ignore"):
        return numpy.require(scores, dtype, "CA")


def _in_order(scores, dtype, least):
    """Scores and the least one as the library takes them, in the boxes' type. Where this would round any of them, their
    ranks: so unequal scores stay unequal. Scores below the least one become minus infinity, below all ranks."""
    least = -math.inf if least is None else numpy.asarray(least).item()
    if not isinstance(least, Real):
        raise TypeError(f"least_score is of the type {type(least).__name__}, not a number")
    real(least, "least_score")
    exact = exactly(scores, dtype)
    with numpy.errstate(over="ignore"):
        rounds = dtype.type(least).item() != least
    if exact is None or rounds:
        # Python compares integers and floats as they are; numpy would round some.
        values, rank = numpy.unique(scores, return_inverse=True)
        below, rank = rank < bisect.bisect_left(values.tolist(), least), rank.astype(float)
        rank[numpy.isnan(scores)] = numpy.nan
        rank[below] = -numpy.inf
        exact, least = rank, -1.0
    return as_type(exact, dtype), float(least)


def labels_of(labels, boxes):
    """The labels as the library takes them, or others that are equal where they are; None for none."""
    if labels is None:
        return None
    if any(isinstance(label, str) for label in numpy.ravel(numpy.asarray(labels))[:1]):
        raise TypeError("labels are whole numbers: number texts by numpy.unique(labels, return_inverse=True)[1]")
    labels = _one_each("labels", labels, boxes)
    if labels.size == 0:
        return numpy.empty(0, numpy.int32)
    if labels.dtype.kind not in "iub":
        raise TypeError(f"labels are whole numbers of at most 64 bits, not {labels.dtype}")
    room = numpy.iinfo(numpy.int32)
    if int(labels.min()) < room.min or int(labels.max()) > room.max:
        labels = numpy.unique(labels, return_inverse=True)[1]
    return numpy.require(labels, numpy.int32, "CA")
