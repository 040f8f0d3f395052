#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What calls cost from Python: as bench/hosts/overhead.c does, with the same rectangles."""
import timeit

import numpy
import vesica


def least(call, number, repeat):
    return min(timeit.repeat(call, number=number, repeat=repeat)) / number * 1e9


def rects(i):
    odd = i % 2 == 1
    columns = (
        (i * 7919 % 4001) / 1000,
        (i * 104729 % 4003) / 1000,
        numpy.where(odd, 5 / 13, 0.8),
        numpy.where(odd, 12 / 13, 0.6),
        0.5 + (i % 100) / 200,
        0.5 + (i % 70) / 140,
    )
    return vesica.shapes(vesica.Kind.RECT, numpy.column_stack(columns))


def main():
    numbers = numpy.arange(10**6)
    a, b = rects(numbers), rects(3 * numbers + 1)
    for name in ("overlap", "nearest", "iou"):
        function = getattr(vesica, name)
        one_a, one_b, some_a, some_b = a[0], b[0], a[:1000], b[:1000]
        out, some_out = function(a, b), function(some_a, some_b)
        row = (
            least(lambda: function(one_a, one_b), 1000, 100),
            least(lambda: function(some_a, some_b, out=some_out), 1, 100) / 1e3,
            least(lambda: function(a, b, out=out), 1, 7) / 1e6,
        )
        print("Python", name, *(f"{ns:.4g}" for ns in row))


if __name__ == "__main__":
    main()
