# SPDX-License-Identifier: Apache-2.0
"""Ratios of shared volume of upright prisms: a shape from one height to another."""
import numpy

from . import _declarations
from ._library import VesicaError, by_scalar, one_of
from ._threads import divided
from .queries import Ratio, finish, in_step, striped
from .shapes import plain, same_scalar

_ONE, _MANY, _MATRIX = (by_scalar(f"volume_ratio{form}") for form in ("", "_many", "_matrix"))


def volume_ratio(which, a, spans_a, b, spans_b, threads=None):
    """A Ratio of shared volume of prisms: shapes a from the heights (low, high) of spans_a, and b from those of spans_b.

    Ratio.OVER_UNION is IoU in three dimensions, of boxes that stand upright and may be turned; OVER_FIRST, OVER_SECOND
    and OVER_SMALLER are as for areas. Spans are (low, high) of a single shape, and (n, 2) of n. Prisms without a volume
    to divide by are a VesicaError (NaN in its `result`).
    """
    which, letter = one_of(Ratio, which, "which"), same_scalar(a, b)
    spans_a, spans_b = _spans(spans_a, a, "spans_a"), _spans(spans_b, b, "spans_b")
    out = numpy.empty(in_step(a, b), a.dtype)

    def ask(a, b, spans_a, spans_b, output):
        return _MANY[letter](which, a, spans_a, b, spans_b, output)

    columns = [*map(_column, (spans_a, spans_b)), (out.ctypes.data, out.itemsize)]
    result = finish(divided(ask, (a.view, b.view), columns, len(out), threads), out, _no_volume, a=a, b=b)
    return result[0].item() if a.single and b.single else result


def volume_ratio_matrix(which, a, spans_a, b, spans_b, threads=None):
    """(len(a), len(b)): a Ratio of shared volume of each prism of a and each of b; as volume_ratio."""
    which, letter = one_of(Ratio, which, "which"), same_scalar(a, b)
    spans_a, spans_b = _spans(spans_a, a, "spans_a"), _spans(spans_b, b, "spans_b")
    out = numpy.empty((len(spans_a), len(spans_b)), a.dtype)

    def ask(a, b, first_a, first_b, *output):
        return _MATRIX[letter](which, a, spans_a[first_a:].ctypes.data, b, spans_b[first_b:].ctypes.data, *output)

    return finish(striped(ask, a, b, out, threads), out, _no_volume, a=a, b=b)


def _column(spans):
    """The address, and the bytes from one span to the next; a single one is repeated."""
    return spans.ctypes.data, spans.strides[0] if len(spans) > 1 else 0


def _no_volume(result):
    return "OVER_UNION, OVER_FIRST, OVER_SECOND or OVER_SMALLER, of prisms with a volume to divide by"


def _spans(spans, shapes, name):
    """The heights of shapes as the library takes them: low, high, low, high ..."""
    spans, count = plain(spans, name), len(shapes.columns[0])
    if spans.dtype.kind not in "iubf":
        raise TypeError(f"{name} are heights, not {spans.dtype}")
    if spans.shape != (count, 2) and not (shapes.single and spans.shape == (2,)):
        wanted = "(low, high)" if shapes.single else f"(low, high) of each of {count} shapes"
        raise ValueError(f"{name} is {wanted}, not an array of shape {spans.shape}")
    spans = numpy.require(spans, shapes.dtype, "CA").reshape(count, 2)
    wrong = numpy.flatnonzero(~((spans[:, 0] <= spans[:, 1]) & numpy.isfinite(spans).all(axis=1)))
    if len(wrong):
        low, high = spans[wrong[0]].tolist()
        raise VesicaError(_declarations.E_SHAPE, f"{name}, row {wrong[0]}: from {low} to {high}")
    return spans
