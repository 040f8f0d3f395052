#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes vesica/_declarations.py, ctypes' view of the C library, from ../capi/vesica.json.

declare.py          writes it
declare.py --check  exits with 1 if it is not what the description says
"""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
DESCRIPTION = HERE.parent / "capi" / "vesica.json"
DECLARATIONS = HERE / "vesica" / "_declarations.py"
# The named methods are another library, which this package does not have.
HEADERS = ("vesica.h", "vesica_index.h", "vesica_motion.h")
NUMBERS = {
    "uint8_t": "c_uint8",
    "int32_t": "c_int32",
    "int64_t": "c_int64",
    "float": "c_float",
    "double": "c_double",
    "ptrdiff_t": "c_ssize_t",
}

HEAD = '''# SPDX-License-Identifier: Apache-2.0
# Written by declare.py from capi/vesica.json: not to be edited.
"""The constants, structs and functions of vesica.h and the headers it includes for ctypes. help() of a function has its text."""
from ctypes import Structure, c_char_p, c_double, c_float, c_int32, c_int64, c_ssize_t, c_uint8, c_void_p

'''

FOOT = '''

def declare(library):
    """Gives the functions of a loaded library their types and texts."""
    for name, (result, parameters, text) in FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes, function.__doc__ = result, parameters, text
'''


def ctypes_name(declaration):
    """Pointers are addresses: numbers, structs and arrays of them are passed alike."""
    kind = declaration["type"]
    if "*" in kind or "[" in kind:
        return "c_char_p" if kind == "const char *" else "c_void_p"
    return NUMBERS[kind.removeprefix("const ")]


def parameter_type(parameter):
    return "c_void_p" if "count" in parameter else ctypes_name(parameter)


def field_type(field):
    name = ctypes_name(field)
    return f"{name} * {field['count']}" if "count" in field else name


def text_of(comment):
    """A docstring, for whose quotes and backslashes nothing has to be done: the headers have none."""
    if '"""' in comment or "\\" in comment:
        raise ValueError(f"a comment with quotes or a backslash: {comment!r}")
    return f'"""{comment}"""'


def constants(entries):
    return [f"{entry['name'].removeprefix('VESICA_')} = {entry['value']}" for entry in entries]


def struct(entry):
    fields = "".join(f'        ("{field["name"]}", {field_type(field)}),\n' for field in entry["fields"])
    return (
        f"class {entry['name'].removeprefix('vesica_')}(Structure):\n"
        f"    {text_of(entry['comment'])}\n\n"
        f"    _fields_ = [\n{fields}    ]\n"
    )


def function(entry):
    parameters = "".join(parameter_type(parameter) + ", " for parameter in entry["parameters"])
    names = ", ".join(parameter["name"] for parameter in entry["parameters"])
    return (
        f'    "{entry["name"]}": (\n'
        f"        {ctypes_name({'type': entry['returns']})},\n"
        f"        ({parameters.strip()}),\n"
        f"        {text_of(entry['name'] + '(' + names + ')' + chr(10) * 2 + entry['comment'])},\n"
        "    ),\n"
    )


def declarations():
    description = json.loads(DESCRIPTION.read_text())
    chosen = {
        part: [entry for entry in description[part] if entry["header"] in HEADERS]
        for part in ("constants", "structs", "functions")
    }
    return (
        HEAD
        + "\n".join(constants(chosen["constants"]))
        + "\n\n\n"
        + "\n\n".join(struct(entry) for entry in chosen["structs"])
        + "\n\n# A function's result, parameters and text.\nFUNCTIONS = {\n"
        + "".join(function(entry) for entry in chosen["functions"])
        + "}\n"
        + FOOT
    )


def main(arguments):
    if arguments == ["--check"]:
        if DECLARATIONS.read_text() == declarations():
            return 0
        print(f"{DECLARATIONS} is not what {DESCRIPTION} says: run capi/refresh.sh", file=sys.stderr)
        return 1
    DECLARATIONS.write_text(declarations())
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
