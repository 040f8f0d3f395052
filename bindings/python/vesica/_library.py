# SPDX-License-Identifier: Apache-2.0
"""The loaded C library, and its errors as exceptions."""
import ctypes
import math
import operator
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


def isa_name():
    """The instruction set that is used, such as "avx512"; no answer depends on it."""
    return library.vesica_isa_name().decode()


ABOVE_ZERO = 5e-324  # the least number that is


def real(value, name, dtype=numpy.float64, least=-math.inf, most=math.inf):
    """A number of a call, rounded to the shapes' type; an error that names it if it is not from least to most."""
    if isinstance(value, (str, bytes)):
        raise TypeError(f"{name} is {value!r}, not a number")
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is of the type {type(value).__name__}, not a number") from None
    rounded = number if dtype == numpy.float64 else ctypes.c_float(number).value
    if not least <= rounded <= most:
        raise VesicaError(_declarations.E_ARGUMENT, f"{name} is {plainly(number)}{_range(least, most)}")
    return rounded


def whole(value, name, least=0, most=math.inf):
    """A whole number of a call, which ctypes would wrap; an error that names it if it is not from least to most."""
    try:
        number = operator.index(value)
    except TypeError:
        given = repr(value) if isinstance(value, (str, bytes, float)) else f"of the type {type(value).__name__}"
        raise TypeError(f"{name} is {given}, not a whole number") from None
    if not least <= number <= most:
        raise VesicaError(_declarations.E_ARGUMENT, f"{name} is {number}{_range(least, most)}")
    return number


def _range(least, most):
    most = math.inf if most >= 1 << 62 and isinstance(most, int) else most  # what has room in 64 bits
    if least == -math.inf:
        return ", not a number" if most == math.inf else f" ({plainly(most)} at most)"
    if least == ABOVE_ZERO:
        return " (above 0)"
    return f" ({plainly(least)} or more)" if most == math.inf else f" ({plainly(least)} to {plainly(most)})"


def plainly(number):
    """A number as people write it: 3, not 3.0, with all its digits."""
    text = str(number)
    return text[:-2] if text.endswith(".0") else text


def one_of(enumeration, value, name):
    """A member of an enumeration; an error that lists its members for anything else."""
    try:
        return enumeration(value)
    except ValueError:
        members = ", ".join(member.name for member in enumeration)
        raise ValueError(f"{name} is {value!r}, not one of vesica.{enumeration.__name__}: {members}") from None


def first_rows(array, count):
    """The first rows of an array, in memory of their own: a view would keep all of the array's."""
    return array if count == len(array) else array[:count].copy()
