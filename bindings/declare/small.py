# SPDX-License-Identifier: Apache-2.0
"""Declarations for the small hosts of bindings/small whose languages cannot read C's: all constants and functions, with the
first sentences of their texts. Languages whose foreign interface reads C take capi/vesica.cdef.
"""
import re
import textwrap

from description import HEAD, SCALARS, broken, camel

WIDTH = 116


def about(entry):
    """The first sentence or question of a text, as one line."""
    text = " ".join(entry.comment.split("\n\n")[0].split("\n"))
    return re.split(r"(?<=[.?]) (?=[A-Z(])", text)[0]


def comment(entry, mark, indent=""):
    lines = textwrap.wrap(about(entry), WIDTH - len(mark) - len(indent), break_on_hyphens=False)
    return "".join(f"{indent}{mark} {line}\n" for line in lines)


def head(mark):
    return "".join(f"{mark} {line}\n" for line in HEAD)


def is_pointer(declaration):
    return declaration.is_pointer or bool(declaration.count)


def is_numbers(declaration):
    """The numbers of one shape, or the corners of a rectangle, which are read."""
    return declaration.is_shape or (declaration.is_const and bool(declaration.count))


def number(declaration, entry):
    """The C type of these numbers: that of the function's scalar."""
    return SCALARS[entry.scalar] if declaration.is_shape else declaration.base


def is_text(declaration):
    return declaration.is_const and declaration.base == "char"


# ---- Ruby ----

RUBY = {"int32_t": "int", "int64_t": "int64_t", "ptrdiff_t": "ptrdiff_t", "double": "double", "float": "float"}


def ruby_type(declaration):
    if is_text(declaration):
        return "const char *"
    return "void *" if is_pointer(declaration) else RUBY[declaration.base]


def ruby(description):
    constants = "".join(f"  {entry.short} = {entry.value}\n" for entry in description.constants)
    functions = "".join(
        f"{comment(entry, '#', '    ')}"
        + broken(f"    '{ruby_type(entry.returns)} {entry.name}({', '.join(map(ruby_type, entry.parameters))})',")
        + "\n"
        for entry in description.functions
    )
    return (
        f"# frozen_string_literal: true\n\n{head('#')}\n# The constants and functions of libvesica.\nmodule Vesica\n"
        f"{constants}\n  # For Fiddle::Importer#extern. A pointer is a string, or what Fiddle makes.\n"
        f"  DECLARATIONS = [\n{functions}  ].freeze\nend\n"
    )


# ---- Perl ----

PERL = {"int32_t": "sint32", "int64_t": "sint64", "ptrdiff_t": "sint64", "double": "double", "float": "float"}


def perl_type(declaration, entry=None):
    if is_text(declaration):
        return "'string'"
    if is_numbers(declaration):
        return f"'{number(declaration, entry)}[]'"
    return "'opaque'" if is_pointer(declaration) else f"'{PERL[declaration.base]}'"


def perl_function(entry):
    types = ", ".join(perl_type(each, entry) for each in entry.parameters)
    return broken(f"    [{entry.name} => [{types}] => {perl_type(entry.returns)}],") + "\n"


def perl(description):
    constants = "".join(f"    {entry.short} => {entry.value},\n" for entry in description.constants)
    functions = "".join(
        f"{comment(entry, '#', '    ')}"
        + perl_function(entry)
        for entry in description.functions
    )
    return (
        f"{head('#')}package VesicaDeclarations;\n\n# The constants and functions of libvesica, for FFI::Platypus: an\n"
        "# opaque is an address. ptrdiff_t is taken to have 64 bits.\nuse strict;\nuse warnings;\n\n"
        f"our %CONSTANTS = (\n{constants});\n\n"
        f"our @FUNCTIONS = (\n{functions});\n\n1;\n"
    )


# ---- Guile ----

GUILE = {"int32_t": "int32", "int64_t": "int64", "ptrdiff_t": "ptrdiff_t", "double": "double", "float": "float"}


def guile_type(declaration):
    return "'*" if is_pointer(declaration) else GUILE[declaration.base]


def guile_function(entry):
    types = " ".join(map(guile_type, entry.parameters))
    return f'{comment(entry, ";;")}(c {entry.name} {guile_type(entry.returns)} {types}'.rstrip() + ")\n"


def guile(description):
    constants = "".join(f"(define-public {entry.name} {entry.value})\n" for entry in description.constants)
    functions = "".join(map(guile_function, description.functions))
    return (
        f"{head(';;')};; The constants and functions of libvesica. A pointer is what bytevector->pointer makes.\n"
        "(define-module (vesica-c)\n  #:use-module (system foreign)\n  #:use-module (system foreign-library))\n\n"
        f"{constants}\n"
        '(define library (load-foreign-library "libvesica.so.0"))\n\n'
        "(define (function name result arguments)\n"
        "  (foreign-library-function library name #:return-type result #:arg-types arguments))\n\n"
        '(let ((found ((function "vesica_version" int32 \'()))))\n  (when (< found VESICA_VERSION)\n'
        '    (error (format #f "vesica ~a is older than ~a" found VESICA_VERSION))))\n\n'
        "(define-syntax-rule (c name result argument ...)\n"
        "  (define-public name (function (symbol->string 'name) result (list argument ...))))\n\n"
        f"{functions}"
    )


# ---- Languages to which VESICA_VERSION and vesica_version are one name ----


def constant_name(entry):
    return entry.name.replace("VERSION", "DECLARED_VERSION").lower()


# ---- Fortran ----

# What writes an array of structs, not one.
SHAPES_OUT = ("rects_from_boxes", "ellipses_from_boxes", "bounds_many", "crossings", "intersection")

FORTRAN = {
    "int32_t": "integer(c_int32_t)",
    "int64_t": "integer(c_int64_t)",
    "ptrdiff_t": "integer(c_ptrdiff_t)",
    "double": "real(c_double)",
    "float": "real(c_float)",
}


def fortran_lines(text, indent):
    """One statement, on as many lines as it takes."""
    lines = textwrap.wrap(text, WIDTH - len(indent), subsequent_indent="  ", break_long_words=False)
    return "".join(f"{indent}{line}{'' if i + 1 == len(lines) else ' &'}\n" for i, line in enumerate(lines))


def fortran_argument(declaration, entry, is_array):
    name = declaration.name
    if is_numbers(declaration):
        return f"{FORTRAN[number(declaration, entry)]}, intent(in) :: {name}(*)"
    if declaration.is_pointer and declaration.base.startswith("vesica_") and not declaration.is_sets and not is_array:
        intent = "in" if declaration.is_const else "out"
        return f"type({declaration.base}), intent({intent}) :: {name}"
    if is_pointer(declaration):
        return f"type(c_ptr), value :: {name}"
    return f"{FORTRAN[declaration.base]}, value :: {name}"


def fortran_result(entry):
    return "type(c_ptr)" if entry.returns.is_pointer else FORTRAN[entry.returns.base]


def fortran_function(entry):
    names = ", ".join(each.name for each in entry.parameters)
    is_array = entry.stem in SHAPES_OUT
    arguments = "".join(
        f"      {fortran_argument(each, entry, is_array and each.name == 'out')}\n" for each in entry.parameters
    )
    statement = f"{fortran_result(entry)} function {entry.name}({names}) bind(c)"
    return (
        f"{comment(entry, '!>', '    ')}{fortran_lines(statement, '    ')}"
        f"      import\n{arguments}    end function\n\n"
    )


def fortran_field(declaration):
    base = "type(c_ptr)" if declaration.is_pointer else FORTRAN[declaration.base]
    return f"    {base} :: {declaration.name}{f'({declaration.count})' if declaration.count else ''}\n"


def fortran(description):
    constants = "".join(
        f"  integer(c_int32_t), parameter :: {constant_name(entry)} = {entry.value}\n"
        for entry in description.constants
    )
    structs = "".join(
        f"{comment(entry, '!>', '  ')}  type, bind(c) :: {entry.name}\n"
        f"{''.join(map(fortran_field, entry.fields))}  end type\n\n"
        for entry in description.structs
    )
    functions = "".join(map(fortran_function, description.functions)).rstrip("\n")
    return (
        f"{head('!')}"
        "!> The constants, types and functions of libvesica. Arrays that are written, and what may be NULL,\n"
        "!> are c_ptr: c_loc of an array that is a target, or c_null_ptr. The constants of the version are called\n"
        "!> vesica_declared_version, as names differ by more than case.\n"
        "module vesica_c\n  use, intrinsic :: iso_c_binding\n  implicit none\n  public\n\n"
        f"{constants}\n{structs}  interface\n{functions}\n  end interface\nend module\n"
    )


# ---- Pascal ----

PASCAL = {
    "int32_t": "Int32",
    "int64_t": "Int64",
    "ptrdiff_t": "PtrInt",
    "uint8_t": "Byte",
    "double": "Double",
    "float": "Single",
}
PASCAL_POINTERS = {
    "void": "Pointer",
    "char": "PChar",
    "uint8_t": "PByte",
    "int32_t": "PInt32",
    "int64_t": "PInt64",
    "double": "PDouble",
    "float": "PSingle",
}
RESERVED = {"out": "output"}


def pascal_struct(name):
    """vesica_point_f64 as TVesicaPointF64."""
    return "T" + camel(name)


def pascal_type(declaration):
    if not is_pointer(declaration):
        return PASCAL[declaration.base]
    if declaration.base.startswith("vesica_"):
        return "P" + pascal_struct(declaration.base)[1:]
    return PASCAL_POINTERS[declaration.base]


def pascal_field(declaration):
    base = pascal_type(declaration) if declaration.is_pointer else PASCAL[declaration.base]
    kind = f"array[0..{declaration.count - 1}] of {base}" if declaration.count else base
    return f"    {declaration.name}: {kind};\n"


def pascal_function(entry):
    names = "; ".join(f"{RESERVED.get(each.name, each.name)}: {pascal_type(each)}" for each in entry.parameters)
    declared = f"function {entry.name}{f'({names})' if names else ''}: {pascal_type(entry.returns)};"
    text = f"{declared} cdecl; external vesica_library;"
    lines = textwrap.wrap(text, WIDTH, subsequent_indent="  ", break_long_words=False)
    return comment(entry, "//") + "\n".join(lines) + "\n"


def pascal(description):
    constants = "".join(f"  {constant_name(entry)} = {entry.value};\n" for entry in description.constants)
    structs = "".join(
        f"{comment(entry, '//', '  ')}  {pascal_struct(entry.name)} = record\n"
        f"{''.join(map(pascal_field, entry.fields))}  end;\n"
        f"  P{pascal_struct(entry.name)[1:]} = ^{pascal_struct(entry.name)};\n"
        for entry in description.structs
    )
    functions = "".join(map(pascal_function, description.functions))
    return (
        f"{head('//')}"
        "// The constants, records and functions of libvesica. Arrays may be nil where the header says so.\n"
        "unit vesica_c;\n\n{$mode objfpc}{$H+}{$packrecords c}\n\ninterface\n\n"
        f"const\n  vesica_library = 'vesica';\n{constants}\ntype\n{structs}\n{functions}\nimplementation\n\nend.\n"
    )


# ---- Ada ----

ADA = {
    "int32_t": "Integer_32",
    "int64_t": "Integer_64",
    "ptrdiff_t": "ptrdiff_t",
    "double": "IEEE_Float_64",
    "float": "IEEE_Float_32",
}


def ada_name(name):
    """vesica_point_f64 as Vesica_Point_F64."""
    return "_".join(word.capitalize() for word in RESERVED.get(name, name).split("_"))


def ada_type(declaration):
    if is_text(declaration):
        return "chars_ptr"
    return "System.Address" if is_pointer(declaration) else ADA[declaration.base]


def ada_field(declaration):
    if declaration.count:
        kind = {"double": "Doubles_8", "float": "Floats_8"}.get(declaration.base)
        kind = "Addresses_8" if declaration.is_pointer else kind
    else:
        kind = ada_type(declaration)
    return f"      {ada_name(declaration.name)} : {kind};\n"


def ada_function(entry):
    names = "; ".join(f"{ada_name(each.name)} : {ada_type(each)}" for each in entry.parameters)
    text = f"function {ada_name(entry.name)}{f' ({names})' if names else ''} return {ada_type(entry.returns)}"
    lines = textwrap.wrap(text, WIDTH - 3, initial_indent="   ", subsequent_indent="      ", break_long_words=False)
    end = f'     with Import, Convention => C, External_Name => "{entry.name}";\n'
    return comment(entry, "-- ", "   ") + "\n".join(lines) + "\n" + end


def ada(description):
    constants = "".join(
        f"   {ada_name(constant_name(entry))} : constant := {entry.value};\n" for entry in description.constants
    )
    structs = "".join(
        f"{comment(entry, '-- ', '   ')}   type {ada_name(entry.name)} is record\n"
        f"{''.join(map(ada_field, entry.fields))}   end record with Convention => C;\n\n"
        for entry in description.structs
    )
    functions = "\n".join(map(ada_function, description.functions))
    return (
        f"{head('-- ')}"
        "--  The constants, records and functions of libvesica. A pointer is an address: Null_Address where\n"
        "--  the header allows NULL.\nwith Interfaces; use Interfaces;\nwith Interfaces.C; use Interfaces.C;\n"
        "with Interfaces.C.Strings; use Interfaces.C.Strings;\nwith System;\n\npackage Vesica_C is\n\n"
        f"{constants}\n"
        "   type Doubles_8 is array (1 .. 8) of IEEE_Float_64 with Convention => C;\n"
        "   type Floats_8 is array (1 .. 8) of IEEE_Float_32 with Convention => C;\n"
        "   type Addresses_8 is array (1 .. 8) of System.Address with Convention => C;\n\n"
        f"{structs}{functions}\nend Vesica_C;\n"
    )


def files(description):
    return {
        "bindings/small/ada/vesica_c.ads": ada(description),
        "bindings/small/fortran/vesica_c.f90": fortran(description),
        "bindings/small/guile/vesica-c.scm": guile(description),
        "bindings/small/pascal/vesica_c.pas": pascal(description),
        "bindings/small/perl/VesicaDeclarations.pm": perl(description),
        "bindings/small/ruby/vesica_declarations.rb": ruby(description),
    }
