# SPDX-License-Identifier: Apache-2.0
"""ctypes' view of the library, with docstrings."""
from description import HEAD, broken, filled

NUMBERS = {
    "uint8_t": "c_uint8",
    "int32_t": "c_int32",
    "int64_t": "c_int64",
    "float": "c_float",
    "double": "c_double",
    "ptrdiff_t": "c_ssize_t",
}

OPENING = f"# {HEAD[0]}\n# {HEAD[1]}\n" + '''\
"""The constants, structs and functions of libvesica for ctypes. help() of a function has its text."""
from ctypes import Structure, c_char_p, c_double, c_float, c_int32, c_int64, c_ssize_t, c_uint8, c_void_p

'''

END = '''

def declare(library):
    """Gives the functions of a loaded library their types and texts."""
    for name, (result, parameters, text) in FUNCTIONS.items():
        function = getattr(library, name)
        function.restype, function.argtypes, function.__doc__ = result, parameters, text
'''


def type_of(declaration):
    """Pointers are addresses: numbers, structs and arrays of them are passed alike."""
    if declaration.is_pointer:
        return "c_char_p" if declaration.base == "char" else "c_void_p"
    return NUMBERS[declaration.base]


def parameter(declaration):
    return "c_void_p" if declaration.count else type_of(declaration)


def field(declaration):
    return f"{type_of(declaration)} * {declaration.count}" if declaration.count else type_of(declaration)


def text_of(comment):
    """A docstring, for whose quotes and backslashes nothing has to be done: the headers have none."""
    if '"""' in comment or "\\" in comment:
        raise ValueError(f"a comment with quotes or a backslash: {comment!r}")
    return f'"""{filled(comment, 108)}"""'


def struct(entry):
    fields = "".join(f'        ("{each.name}", {field(each)}),\n' for each in entry.fields)
    return f"class {entry.short}(Structure):\n    {text_of(entry.comment)}\n\n    _fields_ = [\n{fields}    ]\n"


def function(entry):
    parameters = "".join(parameter(each) + ", " for each in entry.parameters)
    names = ", ".join(each.name for each in entry.parameters)
    return (
        f'    "{entry.name}": (\n'
        f"        {type_of(entry.returns)},\n"
        + broken(f"        ({parameters.strip()}),")
        + "\n"
        f"        {text_of(entry.name + '(' + names + ')' + chr(10) * 2 + entry.comment)},\n"
        "    ),\n"
    )


def files(description):
    constants = "\n".join(f"{entry.short} = {entry.value}" for entry in description.constants)
    structs = "\n\n".join(map(struct, description.structs))
    functions = "".join(map(function, description.functions))
    return {
        "bindings/python/vesica/_declarations.py": f"{OPENING}{constants}\n\n\n{structs}"
        f"\n\n# A function's result, parameters and text.\nFUNCTIONS = {{\n{functions}}}\n{END}"
    }
