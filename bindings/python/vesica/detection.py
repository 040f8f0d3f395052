# SPDX-License-Identifier: Apache-2.0
"""What is done around detectors: assignment, fusion of boxes, average precision."""
import numpy

from ._library import by_scalar, checked, first_rows, library
from .shapes import plain

_ASSIGN = by_scalar("assign_greedy")


def _numbers(values, name):
    """Numbers in a row, as float32 if they are, else as float64."""
    values = plain(values, name)
    if values.dtype.kind not in "iubf" or values.ndim != 1:
        raise TypeError(f"{name} is numbers in a row, not an array of {values.dtype} of shape {values.shape}")
    return numpy.require(values, numpy.float32 if values.dtype == numpy.float32 else numpy.float64, "CA")


def _items(items, name, count):
    """So many numbers of items."""
    items = plain(items, name)
    if items.shape != (count,):
        raise ValueError(f"{name} has a whole number for each of {count} values, not an array of shape {items.shape}")
    if items.dtype.kind not in "iu" and items.size:
        raise TypeError(f"{name} are whole numbers, not {items.dtype}")
    return numpy.require(items, numpy.int64, "CA")


def _scratch(size):
    """So many bytes, at a multiple of 8."""
    return numpy.empty(checked(size) // 8 + 1, numpy.int64)


def _count_of(items):
    return max(int(items.max()) + 1, 0) if len(items) else 0


def assign_greedy(a, b, values):
    """Greedy assignment, as of tracks to detections: which of the pairs a[k], b[k] are taken, the best value first.

    Takes the pair with the highest value whose two items are both free, until there is none; of equal values the one
    with the lower a, then b. Pairs whose value is NaN are not taken. Returns the numbers k: a[k], b[k] and values[k] are
    the matches. a, b and values: what Index.join_ratio returns. A solver of sparse assignment, such as scipy's
    min_weight_full_bipartite_matching, may find a larger sum.
    """
    values = _numbers(values, "values")
    a, b = _items(a, "a", len(values)), _items(b, "b", len(values))
    counts = len(values), _count_of(a), _count_of(b)
    scratch, chosen = _scratch(library.vesica_assign_greedy_scratch(*counts)), numpy.empty(min(counts), numpy.int64)
    found = checked(
        _ASSIGN[values.dtype.char](
            *(a.ctypes.data, b.ctypes.data, values.ctypes.data, *counts),
            *(scratch.ctypes.data, scratch.nbytes, chosen.ctypes.data),
        )
    )
    return first_rows(chosen, found)
