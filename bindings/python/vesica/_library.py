# SPDX-License-Identifier: Apache-2.0
"""The loaded C library, and its errors as exceptions."""
import ctypes
import pathlib

import numpy

from . import _declarations

_inside = pathlib.Path(__file__).with_name("libvesica.so.0")
# A wheel has the library inside. Beside a library of the system, as in a Debian package, that one is used.
library = ctypes.CDLL(str(_inside) if _inside.exists() else _inside.name)
library.vesica_version.restype = ctypes.c_int32
if library.vesica_version() < _declarations.VERSION:
    raise ImportError(
        f"libvesica {library.vesica_version()} is older than {_declarations.VERSION}, which this package needs: "
        "install a newer one"
    )
_declarations.declare(library)


class VesicaError(ValueError):
    """What the library refuses. `code` is its VESICA_E_... number.

    After an invalid shape among many, `result` is the whole result: False, 0 or NaN for the invalid elements, and the
    right answer for every other. Else it is None, as it is in a copy, such as one from another process.
    """

    def __init__(self, code, message=None, result=None):
        if code == _declarations.E_KIND:
            message = message or "not for this kind of shape"  # C also says so of unknown kinds, which no Kind is
        super().__init__(message or library.vesica_strerror(code).decode())
        self.code = code
        self.result = result

    def __reduce__(self):
        # By default an exception is made anew from its text alone. Results may hold addresses, which do not travel.
        return type(self), (self.code, str(self))


def checked(code):
    """The answer, if it is one."""
    if code < 0:
        raise VesicaError(code)
    return code


def by_scalar(name):
    """A function's two forms, by the letter of numpy's type."""
    return {letter: getattr(library, f"vesica_{name}_{suffix}") for letter, suffix in (("d", "f64"), ("f", "f32"))}


def first_rows(array, count):
    """The first rows of an array, in memory of their own: a view would keep all of the array's."""
    return array if count == len(array) else array[:count].copy()


def all_points(function, a, b, *more):
    """The points (n, 2) that a function of two single shapes writes. Without polygons they are at most 12."""
    out = numpy.empty((12, 2), a.dtype)
    while True:
        count = checked(function(a.kind, a.record, b.kind, b.record, out.ctypes.data, len(out), *more))
        if count <= len(out):
            return first_rows(out, count)
        out = numpy.empty((count, 2), a.dtype)
