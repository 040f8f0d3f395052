# SPDX-License-Identifier: Apache-2.0
"""Shapes that move: when b, moved by t * velocity, first touches a. A ray is a point that moves."""
import ctypes
import enum
import math
from typing import NamedTuple

import numpy

from . import _declarations
from ._library import VesicaError, by_scalar, checked
from .queries import columns_of, finish, in_step
from .shapes import Kind, same_scalar, shapes, the_shapes


class Cast(enum.IntEnum):
    """What a cast finds."""

    MISS = _declarations.CAST_MISS
    HIT = _declarations.CAST_HIT
    START = _declarations.CAST_START


class Impact(NamedTuple):
    """When and where b touches a, and the unit normal there, from a to b: floats, or arrays.

    After a miss t is infinity and the rest is NaN. t is rounded down: there is no contact before it.
    """

    t: numpy.ndarray
    x: numpy.ndarray
    y: numpy.ndarray
    nx: numpy.ndarray
    ny: numpy.ndarray


_IMPACTS = {"d": _declarations.impact_f64, "f": _declarations.impact_f32}
_CAST, _CAST_MANY, _CAST_FIRST = by_scalar("cast"), by_scalar("cast_many"), by_scalar("cast_first")
_SWEEP_BOUNDS = by_scalar("sweep_bounds")


def impact_of(record):
    return Impact(*(getattr(record, field) for field in Impact._fields))


def pair(velocity):
    """Two floats."""
    numbers = numpy.asarray(velocity, numpy.float64)
    if numbers.shape != (2,):
        raise ValueError(f"a velocity is (vx, vy), not an array of shape {numbers.shape}")
    return float(numbers[0]), float(numbers[1])


def first_of(item, none, record):
    """(item, Impact) of a cast at many, or None where it touches none of them."""
    return None if item == none else (item, impact_of(record))


def new_impact(letter):
    return _IMPACTS[letter]()


def cast(a, b, velocity, t_end=math.inf, out=None):
    """Does b touch a while it moves, t from 0 to t_end, when first, and where?

    Two single shapes give (Cast, Impact), and whether there is contact is exact. Arrays in step, or one shape and an
    array, give an Impact of arrays; velocity is then (2,), or (n, 2) with one for each pair; out has five arrays.
    """
    letter = same_scalar(a, b)
    if a.single and b.single:
        if out is not None:
            raise TypeError("the answer for two single shapes is one Impact: it has no out")
        record = new_impact(letter)
        numbers = (*pair(velocity), float(t_end), ctypes.byref(record))
        return Cast(checked(_CAST[letter](a.kind, a.record, b.kind, b.record, *numbers))), impact_of(record)
    if not t_end >= 0:
        raise VesicaError(_declarations.E_ARGUMENT, f"t_end is {t_end}, not 0 or more")
    count = in_step(a, b)
    vx, vy, stride, kept = _velocities(velocity, count, a.dtype)
    result = Impact(*columns_of(Impact, out, count, a, b))
    code = _CAST_MANY[letter](
        *(ctypes.byref(a.view), ctypes.byref(b.view), vx, vy, stride, float(t_end)),
        *(column.ctypes.data for column in result),
    )
    del kept
    return finish(code, result, a=a, b=b)


def _velocities(velocity, count, dtype):
    """The addresses of both columns, the bytes from one to the next, and what keeps them."""
    array = numpy.asarray(velocity)
    if array.dtype.kind not in "iubf":
        raise TypeError(f"velocities are numbers, not {array.dtype}")
    if array.shape not in ((2,), (count, 2)):
        raise ValueError(f"velocity has the shape (2,) or ({count}, 2), not {array.shape}")
    array = array.astype(dtype, copy=False)
    if not array.flags.aligned:
        array = array.copy()
    stride = 0 if array.ndim == 1 else array.strides[0]
    start = array.ctypes.data
    return start, start + array.strides[-1], stride, array


def cast_first(one, many, velocity, t_end=math.inf):
    """Which of many shapes at rest does one moving shape touch first: (index, Impact), or None.

    The normal points to `one`. Of several at one time it is the one with the lowest index.
    """
    letter = same_scalar(one, many, "one", "many")
    record, count = new_impact(letter), len(many.columns[0])
    arguments = (ctypes.byref(one.view), ctypes.byref(many.view), *pair(velocity), float(t_end), ctypes.byref(record))
    return first_of(checked(_CAST_FIRST[letter](*arguments)), count, record)


def sweep_bounds(shape, velocity, t_end):
    """A box, as aabbs, that holds a single shape throughout its motion."""
    if not the_shapes(shape, "shape").single:
        raise TypeError("sweep_bounds takes a single shape")
    out = numpy.empty(4, shape.dtype)
    checked(_SWEEP_BOUNDS[shape.letter](shape.kind, shape.record, *pair(velocity), float(t_end), out.ctypes.data))
    return shapes(Kind.AABB, out)
