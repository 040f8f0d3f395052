# SPDX-License-Identifier: Apache-2.0
"""vectors.py FILE: the shared vectors (bindings/vectors) by vesica.py. Exit status 0 when all answers are right."""
import array
import struct
import sys

import vesica
from vesica import ffi, lib

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


def overlap_f32(kind_a, a, kind_b, b):
    """Every other function is called as in C."""
    return vesica.checked(lib.vesica_overlap_f32(kind_a, ffi.new("float[]", a), kind_b, ffi.new("float[]", b)))


def check_batch(batch):
    expected = [row[1] for row in batch]
    rects, ellipses = (array.array("d", [number for row in batch for number in row[i]]) for i in (2, 3))
    out = bytearray(len(batch))
    valid = next(i for i, code in enumerate(expected) if code < 0)
    first = slice(0, 6 * valid)
    parts = memoryview(rects)[first], memoryview(ellipses)[first]
    count = vesica.overlap_many(lib.VESICA_RECT, parts[0], lib.VESICA_ELLIPSE, parts[1], out)
    check("count", count, sum(expected[:valid]))
    # With an invalid element, an error: and yet every valid one has its answer.
    check("error", answer(vesica.overlap_many, lib.VESICA_RECT, rects, lib.VESICA_ELLIPSE, ellipses, out), -2)
    for (line, code, *_), hit in zip(batch, out):
        check(line, hit, max(code, 0))


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
            call = {"f64": vesica.overlap, "f32": overlap_f32}[what]
            check(line, answer(call, kind_a, a, kind_b, b), int(expected))
            calls += 1
    check_batch(batch)
    try:
        vesica.overlap(lib.VESICA_POINT, [float("nan"), 0], lib.VESICA_CIRCLE, [0, 0, 1])
    except vesica.VesicaError as error:
        print("NaN:", error)
    if vesica.nearest(lib.VESICA_AABB, [0, 0, 2, 2], lib.VESICA_CIRCLE, [6, 1, 1]) == (3, (2, 1), (5, 1)):
        print("nearest: as in C")
    print(f"{calls} calls, {len(batch)} in a batch")
    return 0 if all_right else 1


sys.exit(main(sys.argv[1]))
