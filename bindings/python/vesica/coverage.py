# SPDX-License-Identifier: Apache-2.0
"""Shares of the cells of a grid that a shape covers."""
import ctypes

import numpy

from . import _declarations
from ._library import ABOVE_ZERO, by_scalar, real, whole
from .motion import finite
from .shapes import accepted, the_shapes

_COVERAGE, _COVERAGE_CELLS = by_scalar("coverage"), by_scalar("coverage_cells")
_GRIDS = {"d": _declarations.grid_f64, "f": _declarations.grid_f32}


def coverage(shape, rows, columns, *, origin=(0, 0), cell=(1, 1)):
    """The share (rows, columns) of each cell that one shape covers, from 0 to 1.

    origin: the corner of cell [0, 0]. cell: the width and height of each, or one number for both. Cell [j, i] begins
    at origin + (i width, j height): pixels of a picture, if their corners, not their centres, have whole coordinates.
    """
    grid = _grid(shape, rows, columns, origin, cell)
    out = numpy.empty((rows, columns), shape.dtype)
    code = _COVERAGE[shape.letter](shape.kind, shape.record, ctypes.byref(grid), out.ctypes.data, columns)
    accepted(code, shape=shape)
    return out


def coverage_cells(shape, rows, columns, *, origin=(0, 0), cell=(1, 1)):
    """The cells of which one shape covers more than nothing: three arrays, row, column and share of each.

    In no particular order; else as coverage.
    """
    grid = _grid(shape, rows, columns, origin, cell)

    def ask(cells, shares):
        outputs = cells.ctypes.data, shares.ctypes.data, len(cells)
        code = _COVERAGE_CELLS[shape.letter](shape.kind, shape.record, ctypes.byref(grid), *outputs)
        return accepted(code, shape=shape)

    count = ask(numpy.empty(0, numpy.int64), numpy.empty(0, shape.dtype))
    cells, shares = numpy.empty(count, numpy.int64), numpy.empty(count, shape.dtype)
    ask(cells, shares)
    return cells // max(columns, 1), cells % max(columns, 1), shares


def _grid(shape, rows, columns, origin, cell):
    if not the_shapes(shape, "shape").single:
        raise TypeError("shape is an array: the shares are those of a single shape, shape[i]")
    rows, columns = whole(rows, "rows", 0, _MOST), whole(columns, "columns", 0, _MOST)
    cell = cell if numpy.ndim(cell) else (cell, cell)
    sizes = finite(cell, "cell", "(width, height)", shape.dtype)
    sizes = [real(size, "cell", shape.dtype, ABOVE_ZERO) for size in sizes]
    return _GRIDS[shape.letter](*finite(origin, "origin", "(x, y)", shape.dtype), *sizes, columns, rows)


_MOST = (1 << 63) - 1
