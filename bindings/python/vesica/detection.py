# SPDX-License-Identifier: Apache-2.0
"""What is done around detectors: assignment, fusion of boxes, average precision."""
import ctypes
import enum

import numpy

from . import _declarations
from ._library import VesicaError, by_scalar, checked, first_rows, library, real, whole
from .queries import as_type, finish, labels_of, scores_of
from .shapes import first_of_rows, plain, shapes

_ASSIGN, _FUSE = by_scalar("assign_greedy"), by_scalar("fuse")
_MATCH, _PRECISION = by_scalar("match_truths"), by_scalar("average_precision")
_MATCH_RULES = {"voc": _declarations.MATCH_VOC, "coco": _declarations.MATCH_COCO}
_PRECISION_RULES = {
    "voc2007": _declarations.PRECISION_VOC_2007,
    "voc2010": _declarations.PRECISION_VOC_2010,
    "coco": _declarations.PRECISION_COCO,
}
_FUSED_SCORES = {"mean": _declarations.FUSED_MEAN, "max": _declarations.FUSED_MAX}


class Truth(enum.IntEnum):
    """What a truth is for average precision; the last two do not count.

    Any number of detections may take a CROWD ("difficult" of VOC, "iscrowd" of COCO), one an IGNORED truth (COCO's
    outside a range of areas).
    """

    COUNTS = _declarations.TRUTH_COUNTS
    CROWD = _declarations.TRUTH_CROWD
    IGNORED = _declarations.TRUTH_IGNORED


class Outcome(enum.IntEnum):
    """What a detection is: a false positive, a true positive, or neither, as it took a truth that does not count."""

    MISS = _declarations.OUTCOME_MISS
    HIT = _declarations.OUTCOME_HIT
    IGNORED = _declarations.OUTCOME_IGNORED


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
    with the lower a, then b. Pairs whose value is NaN are not taken. Returns the numbers k: the matches are a[k] and b[k]
    with values[k]. a, b and values: what Index.join_ratio returns. A solver of the linear assignment problem
    may find a larger sum.
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


def _rule(rule, rules):
    if rule not in rules:
        raise ValueError(f"rule is {rule!r}, not one of {', '.join(rules)}")
    return rules[rule]


def _codes(codes, name, shape):
    """Codes of one byte, such as those of Outcome."""
    codes = plain(codes, name)
    if codes.shape != shape:
        raise ValueError(f"{name} has the shape {codes.shape}, not {shape}")
    if codes.dtype.kind not in "iub" and codes.size:
        raise TypeError(f"{name} are whole numbers, not {codes.dtype}")
    if codes.size and not 0 <= int(codes.min()) <= int(codes.max()) <= 2:
        raise VesicaError(_declarations.E_ARGUMENT, f"{name} are 0, 1 or 2")
    return numpy.require(codes, numpy.uint8, "CA")


def match_truths(a, b, values, scores, truths, thresholds=0.5, *, rule="coco", flags=None):
    """Which detections hit a truth? (outcomes, taken): for each threshold a row of Outcome and of truths, or -1.

    a, b, values: pairs of a detection and a truth with their IoU, as Index.join_ratio gives at the lowest threshold.
    Detections and truths of several pictures are numbered through; only those of one picture are pairs. scores: of each
    detection; truths: how many there are; flags: a Truth for each, if not all count. rule: "voc", a detection takes the
    best truth, and misses if that is taken; "coco", it takes the best one that is free. A single threshold has a single
    row. Scores and thresholds are first rounded to the values' type.
    """
    rule, truths = _rule(rule, _MATCH_RULES), whole(truths, "truths")
    values = _numbers(values, "values")
    a, b = _items(a, "a", len(values)), _items(b, "b", len(values))
    scores = as_type(_numbers(scores, "scores"), values.dtype)
    rows = as_type(_numbers(numpy.atleast_1d(plain(thresholds, "thresholds")), "thresholds"), values.dtype)
    flags = None if flags is None else _codes(flags, "flags", (truths,))
    scratch = _scratch(library.vesica_match_truths_scratch(len(values), len(scores), truths))
    shape = len(rows), len(scores)
    outcomes, taken = numpy.empty(shape, numpy.uint8), numpy.empty(shape, numpy.int64)
    checked(
        _MATCH[values.dtype.char](
            *(rule, a.ctypes.data, b.ctypes.data, values.ctypes.data, len(values), scores.ctypes.data, len(scores)),
            *(None if flags is None else flags.ctypes.data, truths, rows.ctypes.data, len(rows)),
            *(scratch.ctypes.data, scratch.nbytes, outcomes.ctypes.data, taken.ctypes.data),
        )
    )
    return (outcomes[0], taken[0]) if numpy.ndim(thresholds) == 0 else (outcomes, taken)


def average_precision(scores, outcomes, truths, *, rule="coco"):
    """The average precision of detections of one class; of several rows of outcomes, an array.

    scores and outcomes: of each detection, outcomes as match_truths gives them. truths: how many of them count. rule:
    the recalls at which precision is averaged: "voc2007", 0, 0.1 ... 1; "voc2010", at every truth, the area under the
    curve; "coco", 0, 0.01 ... 1. NaN if there are no truths.
    """
    rule, truths = _rule(rule, _PRECISION_RULES), whole(truths, "truths")
    scores = _numbers(scores, "scores")
    outcomes = plain(outcomes, "outcomes")
    rows = outcomes.shape[:-1] if outcomes.ndim else ()
    outcomes = _codes(outcomes, "outcomes", (*rows, len(scores)))
    scratch = _scratch(library.vesica_average_precision_scratch(len(scores)))
    out = numpy.empty(rows, scores.dtype)
    for row in numpy.ndindex(rows):
        checked(
            _PRECISION[scores.dtype.char](
                *(rule, scores.ctypes.data, outcomes[row].ctypes.data, len(scores), truths),
                *(scratch.ctypes.data, scratch.nbytes, out[row + (...,)].ctypes.data),
            )
        )
    return out if rows else out.item()
