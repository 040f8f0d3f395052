# SPDX-License-Identifier: Apache-2.0
"""Shapes that move, and turn: when b, moved by t * velocity, first touches a. A ray is a point that moves."""
import ctypes
import enum
import math
from typing import NamedTuple

import numpy

from . import _declarations
from ._library import ABOVE_ZERO, VesicaError, by_scalar, plainly, real
from ._threads import divided
from .queries import columns_of, finish, in_step
from .shapes import Kind, accepted, first_of_rows, one_shape, plain, same_scalar, shapes, the_shapes


class Cast(enum.IntEnum):
    """What a cast finds: MISS, no contact; HIT, contact after t = 0; START, they overlap at t = 0. NEAR is
    impact_time's alone: no contact before t, and perhaps none later."""

    MISS = _declarations.CAST_MISS
    HIT = _declarations.CAST_HIT
    START = _declarations.CAST_START
    NEAR = _declarations.CAST_NEAR


class Impact(NamedTuple):
    """When and where b touches a, and the unit normal there, from a to b: floats, or arrays.

    After a miss t is infinity and the rest is NaN. t is rounded down: there is no contact before it.
    """

    t: numpy.ndarray
    x: numpy.ndarray
    y: numpy.ndarray
    nx: numpy.ndarray
    ny: numpy.ndarray


class Turn(NamedTuple):
    """How a shape moves while t runs from 0 to 1: its centre by (vx, vy), and about that it turns by an angle in
    radians, counter-clockwise where y points up."""

    vx: float = 0.0
    vy: float = 0.0
    angle: float = 0.0


_IMPACTS = {"d": _declarations.impact_f64, "f": _declarations.impact_f32}
_CAST, _CAST_MANY, _CAST_FIRST = by_scalar("cast"), by_scalar("cast_many"), by_scalar("cast_first")
_SWEEP_BOUNDS, _IMPACT_TIME = by_scalar("sweep_bounds"), by_scalar("impact_time")
_TURNS = {"d": _declarations.turn_f64, "f": _declarations.turn_f32}
NUMBERS = {"d": ctypes.c_double, "f": ctypes.c_float}


def impact_of(record):
    return Impact(*(getattr(record, field) for field in Impact._fields))


def finite(given, name, form, dtype):
    """As many finite floats as there are names in the form: "(vx, vy)"."""
    numbers = plain(given, name)
    if numbers.dtype.kind not in "iubf":
        raise TypeError(f"{name} is {form}: numbers, not {numbers.dtype}")
    if numbers.shape != (form.count(",") + 1,):
        raise ValueError(f"{name} is {form}, not an array of shape {numbers.shape}")
    floats = [real(number, name, dtype) if number == number else number for number in map(float, numbers.tolist())]
    if not all(map(math.isfinite, floats)):
        raise VesicaError(_declarations.E_ARGUMENT, f"{name} is ({', '.join(map(plainly, numbers))}), not finite")
    return floats


def motion(velocity, t_end, dtype):
    """The numbers of a motion: vx, vy and when it ends."""
    return (*finite(velocity, "velocity", "(vx, vy)", dtype), real(t_end, "t_end", dtype, 0))


def first_of(item, none, record):
    """(item, Impact) of a cast at many, or None where it touches none of them."""
    return None if item == none else (item, impact_of(record))


def new_impact(letter):
    return _IMPACTS[letter]()


def cast(a, b, velocity, t_end=math.inf, out=None, threads=None):
    """Does b touch a while it moves, t from 0 to t_end, when first, and where?

    Two single shapes give (Cast, Impact), and whether there is contact is exact. Arrays in step, or one shape and an
    array, give an Impact of arrays; velocity is then (2,), or (n, 2) with one for each pair; out has five arrays.
    velocity and t_end are first rounded to the shapes' type.
    """
    letter = same_scalar(a, b)
    if a.single and b.single:
        if out is not None:
            raise TypeError("the answer for two single shapes is one Impact: it has no out")
        record = new_impact(letter)
        numbers = (*motion(velocity, t_end, a.dtype), ctypes.byref(record))
        found = accepted(_CAST[letter](a.kind, a.record, b.kind, b.record, *numbers), a=a, b=b)
        return Cast(found), impact_of(record)
    t_end = real(t_end, "t_end", a.dtype, 0)
    count = in_step(a, b)
    vx, vy, stride, velocities = _velocities(velocity, count, a.dtype)
    result = Impact(*columns_of(Impact, out, count, a.dtype, (*a.columns, *b.columns, velocities)))

    def undefined(_):
        unfit = numpy.flatnonzero(~numpy.isfinite(velocities.reshape(-1, 2)).all(axis=1))
        first = velocities.reshape(-1, 2)[unfit[0]]
        return first_of_rows(unfit, f"it is ({', '.join(map(plainly, first))}), not finite", " of velocity")

    def ask(a, b, vx, vy, *outputs):
        return _CAST_MANY[letter](a, b, vx, vy, stride, t_end, *outputs)

    columns = [(vx, stride), (vy, stride), *((column.ctypes.data, column.itemsize) for column in result)]
    code = divided(ask, (a.view, b.view), columns, count, threads)
    return finish(code, result, undefined, a=a, b=b)


def _velocities(velocity, count, dtype):
    """The addresses of both columns, the bytes from one to the next, and the array that has them."""
    array = plain(velocity, "velocity")
    if array.dtype.kind not in "iubf":
        raise TypeError(f"velocity has numbers, not {array.dtype}")
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

    The normal points to `one`. Of several at one time it is the one with the lowest index. velocity and t_end are first
    rounded to the shapes' type.
    """
    letter = same_scalar(one_shape(one, "one"), many, "one", "many")
    record, count = new_impact(letter), len(many.columns[0])
    arguments = ctypes.byref(one.view), ctypes.byref(many.view), *motion(velocity, t_end, one.dtype)
    item = accepted(_CAST_FIRST[letter](*arguments, ctypes.byref(record)), one=one, many=many)
    return first_of(item, count, record)


class Manifold(NamedTuple):
    """Contacts of two overlapping convex shapes: how many, and the unit normal from a to b; for each, in rows of which
    the last are 0 if there are fewer, the point, the depth, and the numbers (of a, of b) that name it."""

    count: numpy.ndarray
    normal: numpy.ndarray
    points: numpy.ndarray
    depths: numpy.ndarray
    numbers: numpy.ndarray


_MANIFOLD, _MANIFOLD_MANY = by_scalar("manifold"), by_scalar("manifold_many")
_CONTACTS = {
    letter: numpy.dtype([("normal", letter, 2), ("contacts", letter, (2, 3)), ("numbers", "q", (2, 2)), ("count", "q")])
    for letter in "df"
}


def manifold(a, b, threads=None):
    """Where do two convex shapes press on each other, how deep, and along which normal: a Manifold, for physics.

    The normal and the greatest depth are those of depth(). Where edges face each other there are two contacts, at the
    ends of what they share, named by the numbers of the vertices at which the edges end there. These stay while the
    same edges face each other, so that a solver can begin with its last impulses (vesica.c.vesica_manifold_f64).
    Two single shapes give a count and arrays of one pair. Arrays in step, or one shape and an array, give arrays with a
    row for each pair; if there is an error, the count of its pair is that error, and VesicaError has the result.
    """
    letter = same_scalar(a, b)
    single = a.single and b.single
    out = numpy.zeros(1 if single else in_step(a, b), _CONTACTS[letter])
    if single:
        accepted(_MANIFOLD[letter](a.kind, a.record, b.kind, b.record, out.ctypes.data), a=a, b=b)
        out = out[0]
    result = Manifold(
        *(out["count"], out["normal"], out["contacts"][..., :2], out["contacts"][..., 2], out["numbers"]),
    )
    if single:
        return result._replace(count=int(result.count))
    columns = [(out.ctypes.data, out.itemsize)]
    code = divided(_MANIFOLD_MANY[letter], (a.view, b.view), columns, len(out), threads)
    return finish(code, result, a=a, b=b)


def sweep_bounds(shape, velocity, t_end):
    """A box, as aabbs, that holds a single shape throughout its motion, velocity and t_end rounded to its type."""
    if not the_shapes(shape, "shape").single:
        raise TypeError("sweep_bounds takes a single shape")
    out = numpy.empty(4, shape.dtype)
    moved = motion(velocity, t_end, shape.dtype)
    accepted(_SWEEP_BOUNDS[shape.letter](shape.kind, shape.record, *moved, out.ctypes.data), shape=shape)
    return shapes(Kind.AABB, out)


_MOST_RADIANS = 2.0**20


def turn_record(turn, name, dtype):
    """A C struct."""
    vx, vy, angle = finite(turn, name, "(vx, vy, angle)", dtype)
    angle = real(angle, f"the angle of {name}", dtype, -_MOST_RADIANS, _MOST_RADIANS)
    return _TURNS[dtype.char](vx, vy, angle)


def impact_time(a, turn_a, b, turn_b, tolerance):
    """When do two single shapes that move and turn touch first? Proved: there is no contact before, however thin they
    are and however fast they turn.

    turn_a and turn_b are a Turn, or (vx, vy, angle): what centre and axis have done when t is 1; at t they have done
    t times that. Angles are at most 2**20 radians. Turns and tolerance are first rounded to the shapes' type. The
    answer is (Cast, Impact, gap), the impact being the place at t: the point of a nearest to b, and the normal that
    separates them. They are at most gap apart there, which is at most the tolerance, a length above 0, but for rounding
    and very long searches (see vesica.c.vesica_impact_time_f64).

    Cast.MISS: proved, no contact from 0 to 1; t is infinity, the rest NaN. HIT: proved, contact after t. NEAR: they
    come as near as the gap; there may be contact after t. START: they overlap at t = 0, exactly; the gap is 0.
    """
    letter = same_scalar(a, b)
    if not (a.single and b.single):
        raise TypeError("impact_time takes two single shapes")
    turns = [turn_record(turn_a, "turn_a", a.dtype), turn_record(turn_b, "turn_b", a.dtype)]
    tolerance = real(tolerance, "tolerance", a.dtype, ABOVE_ZERO)
    record, gap = new_impact(letter), NUMBERS[letter]()
    found = _IMPACT_TIME[letter](
        *(a.kind, a.record, ctypes.byref(turns[0]), b.kind, b.record, ctypes.byref(turns[1])),
        *(tolerance, ctypes.byref(record), ctypes.byref(gap)),
    )
    return Cast(accepted(found, a=a, b=b)), impact_of(record), gap.value
