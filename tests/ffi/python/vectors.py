# SPDX-License-Identifier: Apache-2.0
"""vectors.py FILE: the shared vectors (../vectors.txt) by vesica.py. Exit status 0 when all answers are right."""
import struct
import sys

import numpy
import vesica
from vesica import AABB, CIRCLE, ELLIPSE, POINT, RECT

all_right = True


def check(line, answer, expected):
    global all_right
    if answer != expected:
        print(f"line {line}: {answer}, not {expected}")
        all_right = False


def answer(call, *arguments):
    """What the call returns, or its error's code."""
    try:
        return int(call(*arguments))
    except vesica.VesicaError as error:
        return error.code


def check_batch(batch):
    expected = [row[1] for row in batch]
    numbers_a, numbers_b = (numpy.array([row[i] for row in batch]) for i in (2, 3))

    # Records of a program's own, in which the rectangle is a part; columns, as the transposed array has them.
    rects = numpy.zeros(len(batch), [("id", "i4"), *((name, "f8") for name in vesica.FIELDS[RECT])])
    for name, column in zip(vesica.FIELDS[RECT], numbers_a.T):
        rects[name] = column
    ellipses = numpy.asfortranarray(numbers_b)

    out = numpy.zeros(len(batch), bool)
    valid = next(i for i, code in enumerate(expected) if code < 0)
    count = vesica.overlap_many(RECT, rects[:valid], ELLIPSE, ellipses[:valid], out[:valid])
    check("count", count, sum(expected[:valid]))
    # With an invalid element, an error: and yet every valid one has its answer.
    check("error", answer(vesica.overlap_many, RECT, rects, ELLIPSE, ellipses, out), -2)
    for (line, code, *_), hit in zip(batch, out):
        check(line, int(hit), max(code, 0))

    # In float, as the scalar calls are.
    floats = [array[:valid].astype("f4") for array in (numbers_a, numbers_b)]
    vesica.overlap_many(RECT, floats[0], ELLIPSE, floats[1], out[:valid])
    check("float", out[:valid].tolist(), [vesica.overlap(RECT, a, ELLIPSE, b, "f4") for a, b in zip(*floats)])

    # Every pair; the diagonal is the batch. Rows backwards, every second one: still no copy.
    matrix = numpy.zeros((valid, valid), numpy.uint8)
    vesica.overlap_matrix(RECT, rects[:valid], ELLIPSE, ellipses[:valid], matrix)
    check("matrix", matrix.diagonal().tolist(), expected[:valid])
    step = slice(valid - 1, None, -2)
    thinned = numpy.zeros(len(expected[step]), bool)
    vesica.overlap_many(RECT, rects[step], ELLIPSE, ellipses[step], thinned)
    check("step", thinned.tolist(), [code == 1 for code in expected[step]])


def main(path):
    calls, batch = 0, []
    for line, text in enumerate(open(path), 1):
        if text.startswith("#"):
            continue
        what, expected, *words = text.split()
        kind_a, kind_b = int(words[0]), int(words[7])
        a, b = (struct.unpack(">6d", bytes.fromhex("".join(words[i : i + 6]))) for i in (1, 8))
        if what == "many":
            batch.append((line, int(expected), a, b))
        else:
            dtype = {"f64": "f8", "f32": "f4"}[what]
            check(line, answer(vesica.overlap, kind_a, a, kind_b, b, dtype), int(expected))
            calls += 1
    check_batch(batch)
    try:
        vesica.overlap(POINT, [float("nan"), 0], CIRCLE, [0, 0, 1])
    except vesica.VesicaError as error:
        print("NaN:", error)
    if vesica.nearest(AABB, [0, 0, 2, 2], CIRCLE, [6, 1, 1]) == (3, 2, 1, 5, 1):
        print("nearest: as in C")
    print(f"{calls} calls, {len(batch)} in a batch")
    return 0 if all_right else 1


sys.exit(main(sys.argv[1]))
