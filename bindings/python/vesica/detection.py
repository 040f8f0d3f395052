# SPDX-License-Identifier: Apache-2.0
"""What is done around detectors: assignment, fusion of boxes, average precision."""
import ctypes

import numpy

from . import _declarations
from ._library import VesicaError, by_scalar, checked, first_rows, library, real
from .queries import as_type, finish, labels_of, scores_of
from .shapes import first_of_rows, plain, shapes

_ASSIGN, _FUSE = by_scalar("assign_greedy"), by_scalar("fuse")
_FUSED_SCORES = {"mean": _declarations.FUSED_MEAN, "max": _declarations.FUSED_MAX}


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


def fuse(boxes, scores, threshold=0.55, *, weights=None, labels=None, score="mean"):
    """Weighted boxes fusion: (means, scores, clusters), the means as shapes, and for each box its cluster.

    Takes boxes, aabbs or rects, in the order of score times weight, the highest first. Each joins the cluster of its
    label whose mean it has the highest IoU with, if that exceeds the threshold, or begins one. A mean counts a box by
    score times weight. score: "mean" of a cluster, by the weights, or "max". Rectangles are averaged in whichever of
    their four forms has its corners nearest to the first one's; vesica.c.vesica_fuse_f64 says more. Scores, weights and
    threshold are first rounded to the boxes' type.
    """
    if score not in _FUSED_SCORES:
        raise ValueError(f"score is {score!r}, not one of {', '.join(_FUSED_SCORES)}")
    scores = as_type(scores_of(scores, boxes), boxes.dtype)
    weights = None if weights is None else as_type(scores_of(weights, boxes, "weights"), boxes.dtype)
    labels = labels_of(labels, boxes)
    threshold = real(threshold, "threshold", boxes.dtype, 0, 1)
    scratch = _scratch(library.vesica_fuse_scratch(len(boxes)))
    fused = numpy.empty((len(boxes), len(boxes.columns)), boxes.dtype)
    fused_scores, clusters = numpy.empty(len(boxes), boxes.dtype), numpy.empty(len(boxes), numpy.int64)
    count = ctypes.c_int64()
    code = _FUSE[boxes.letter](
        *(ctypes.byref(boxes.view), scores.ctypes.data, None if weights is None else weights.ctypes.data),
        *(None if labels is None else labels.ctypes.data, threshold, _FUSED_SCORES[score]),
        *(scratch.ctypes.data, scratch.nbytes, fused.ctypes.data, fused_scores.ctypes.data, clusters.ctypes.data),
        ctypes.byref(count),
    )
    if code not in (0, _declarations.E_SHAPE):
        checked(code)
    means = shapes(boxes.kind, first_rows(fused, count.value))
    result = means, first_rows(fused_scores, count.value), clusters
    if code == _declarations.E_SHAPE and not len(boxes.invalid()):
        unfit = numpy.flatnonzero(clusters < 0)
        fault = "the score or the weight is not from 0 to 2**480, or the box is beyond 2**1020"
        raise VesicaError(code, first_of_rows(unfit, fault), result)
    return finish(code, result, boxes=boxes)
