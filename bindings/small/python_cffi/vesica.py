# SPDX-License-Identifier: Apache-2.0
"""Vesica by cffi: copy this file and capi/vesica.cdef beside it. `lib` has every function and constant of vesica.h."""
import pathlib

import cffi

VERSION = 100  # the least that this file needs

_probe = cffi.FFI()
_probe.cdef("int32_t vesica_version(void);")
_version = _probe.dlopen("libvesica.so.0").vesica_version()
if _version < VERSION:
    raise ImportError(f"vesica {_version} is older than {VERSION}")
ffi = cffi.FFI()
ffi.cdef(pathlib.Path(__file__).with_name("vesica.cdef").read_text())
lib = ffi.dlopen("libvesica.so.0")


class VesicaError(ValueError):
    def __init__(self, code):
        super().__init__(ffi.string(lib.vesica_strerror(code)).decode())
        self.code = code


def checked(answer):
    """The answer of any function, or its error raised."""
    if answer < 0:
        raise VesicaError(answer)
    return answer


def overlap(kind_a, a, kind_b, b):
    """Do two shapes, each a sequence of its numbers, share a point? Touching counts."""
    for kind, numbers in ((kind_a, a), (kind_b, b)):
        if len(numbers) < checked(lib.vesica_field_count(kind)):
            raise ValueError("too few numbers for a shape")
    return checked(lib.vesica_overlap_f64(kind_a, ffi.new("double[]", a), kind_b, ffi.new("double[]", b))) == 1


def nearest(kind_a, a, kind_b, b):
    """How far apart are two shapes, and where? (distance, (x, y) of a, (x, y) of b)."""
    for kind, numbers in ((kind_a, a), (kind_b, b)):
        if len(numbers) < checked(lib.vesica_field_count(kind)):
            raise ValueError("too few numbers for a shape")
    out = ffi.new("vesica_closest_points_f64 *")
    checked(lib.vesica_nearest_f64(kind_a, ffi.new("double[]", a), kind_b, ffi.new("double[]", b), out))
    return out.distance, (out.ax, out.ay), (out.bx, out.by)


def shapes(kind, buffer):
    """The library's view of contiguous shapes in whatever has a buffer of doubles: array.array, memoryview, ndarray."""
    size = checked(lib.vesica_field_count(kind)) * ffi.sizeof("double")
    numbers = ffi.from_buffer("double[]", buffer)
    view = ffi.new("vesica_shapes_f64 *")
    checked(lib.vesica_shapes_from_records_f64(kind, ffi.sizeof(numbers) // size, numbers, size, view))
    return view, numbers  # the second keeps the memory alive


def overlap_many(kind_a, a, kind_b, b, out):
    """Writes 1 or 0 for each of two arrays in step to out (bytearray, say); an array of one shape is repeated.

    Returns how many overlap. Where a shape is invalid, out has 0 for it and every other answer, and the error is
    raised.
    """
    (view_a, _keep_a), (view_b, _keep_b) = shapes(kind_a, a), shapes(kind_b, b)
    if len(out) < (max(view_a.count, view_b.count) if view_a.count and view_b.count else 0):
        raise ValueError("out is too short")
    answers = ffi.from_buffer("uint8_t[]", out, require_writable=True)
    return checked(lib.vesica_overlap_many_f64(view_a, view_b, answers))
