# SPDX-License-Identifier: Apache-2.0
"""Shares of the cells of a grid that a shape covers."""
import ctypes

import numpy

from . import _declarations
from ._library import by_scalar, checked
from .shapes import the_shapes

_COVERAGE, _COVERAGE_CELLS = by_scalar("coverage"), by_scalar("coverage_cells")
_GRIDS = {"d": _declarations.grid_f64, "f": _declarations.grid_f32}


def coverage(shape, rows, columns, *, origin=(0, 0), cell=(1, 1)):
    """The share (rows, columns) of each cell that one shape covers, from 0 to 1.

    origin: the corner of cell [0, 0]. cell: the width and height of each, or one number for both. Cell [j, i] begins
    at origin + (i width, j height): pixels of a picture, if their corners, not their centres, have whole coordinates.
    """
    grid = _grid(shape, rows, columns, origin, cell)
    out = numpy.empty((rows, columns), shape.dtype)
    checked(_COVERAGE[shape.letter](shape.kind, shape.record, ctypes.byref(grid), out.ctypes.data, columns))
    return out


def coverage_cells(shape, rows, columns, *, origin=(0, 0), cell=(1, 1)):
    """The cells of which one shape covers more than nothing: three arrays, row, column and share of each.

    In no particular order; else as coverage.
    """
    grid = _grid(shape, rows, columns, origin, cell)

    def ask(cells, shares):
        return checked(
            _COVERAGE_CELLS[shape.letter](
                shape.kind, shape.record, ctypes.byref(grid), cells.ctypes.data, shares.ctypes.data, len(cells)
            )
        )

    count = ask(numpy.empty(0, numpy.int64), numpy.empty(0, shape.dtype))
    cells, shares = numpy.empty(count, numpy.int64), numpy.empty(count, shape.dtype)
    ask(cells, shares)
    return cells // max(columns, 1), cells % max(columns, 1), shares


def _grid(shape, rows, columns, origin, cell):
    if not the_shapes(shape, "shape").single:
        raise TypeError("the shares are those of a single shape")
    width, height = cell if numpy.ndim(cell) else (cell, cell)
    return _GRIDS[shape.letter](*origin, width, height, columns, rows)
