#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What Python adds: ns a call of two shapes, and ns an element of arrays of 1e3 and 1e6, the least of seven."""
import timeit

import numpy
import vesica


def least(call, number):
    return min(timeit.repeat(call, number=number, repeat=7)) / number * 1e9


def rects(count, generator):
    columns = (generator.random((count, 2)) * 4, generator.random((count, 2)) + 0.5, generator.random(count) * 6)
    return vesica.rects(numpy.column_stack(columns))


def main():
    generator = numpy.random.default_rng(1)
    a, b = rects(10**6, generator), rects(10**6, generator)
    print("| rect, rect, float64 | one call | 1e3, an element | 1e6, an element | 1e6, out= given |")
    print("|---|---|---|---|---|")
    for name in ("overlap", "relation", "nearest", "depth", "iou"):
        function = getattr(vesica, name)
        one_a, one_b, some_a, some_b = a[0], b[0], a[:1000], b[:1000]
        result = function(a, b)
        row = (
            least(lambda: function(one_a, one_b), 20_000),
            least(lambda: function(some_a, some_b), 200) / 1e3,
            least(lambda: function(a, b), 1) / 1e6,
            least(lambda: function(a, b, out=result), 1) / 1e6,
        )
        print(f"| {name} | " + " | ".join(f"{ns:.4g} ns" for ns in row) + " |")


if __name__ == "__main__":
    main()
