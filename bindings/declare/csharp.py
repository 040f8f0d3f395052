# SPDX-License-Identifier: Apache-2.0
"""The assembly for C#: functions for the runtime's own calls, structs and enums, with XML comments.

Structs of doubles have the plain name, those of floats end on F, as those of System.Drawing do.
"""
from description import ENUMS, HEAD, SCALARS, SHAPES, WIDTH, broken, camel, filled

OPENING = "".join(f"// {line}\n" for line in HEAD)
NUMBERS = {
    "int32_t": "int",
    "int64_t": "long",
    "ptrdiff_t": "IntPtr",
    "double": "double",
    "float": "float",
}
KEYWORDS = {"out": "output"}


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def summary(paragraphs, indent):
    texts = [escaped(paragraph) for paragraph in paragraphs]
    if len(texts) > 1:
        texts = [f"<para>{each}</para>" for each in texts]
    lines = [line for text in texts for line in filled(text, WIDTH - 4 - len(indent)).split("\n")]
    body = "".join(f"{indent}/// {line}\n" for line in lines)
    return f"{indent}/// <summary>\n{body}{indent}/// </summary>\n"


def local(name):
    return KEYWORDS.get(name) or camel(name, first=False)


def enum(description, group):
    name, about = ENUMS[group]
    values = "".join(
        summary([entry.meaning], "        ")
        + f"        {camel(entry.own)} = {entry.value},\n"
        for entry in description.constants_of(group)
    )
    base = " : byte" if group in ("RELATIONS", "WITHINS") else ""
    return f"{summary([about], '    ')}    public enum {name}{base}\n    {{\n{values}    }}\n\n"


def struct(entry, suffix):
    name = camel(entry.stem) + ("F" if suffix == "f32" else "")
    number = SCALARS[suffix]
    names = [each.name.upper() if len(each.name) <= 2 else camel(each.name) for each in entry.fields]
    parameters = ", ".join(f"{NUMBERS[each.base]} {local(each.name)}" for each in entry.fields)
    texts = "".join(
        f"        /// <summary>{escaped(each.name)}</summary>\n        public {NUMBERS[each.base]} {field};\n\n"
        for each, field in zip(entry.fields, names)
    )
    sets = "".join(f"            {field} = {local(each.name)};\n" for each, field in zip(entry.fields, names))
    shape = ""
    if entry.stem in SHAPES:
        writes = "".join(f"            to[{i}] = {field};\n" for i, field in enumerate(names))
        wide = "true" if suffix == "f64" else "false"
        shape = (
            "\n        /// <inheritdoc/>\n"
            f"        public Kind Kind {{ get {{ return Kind.{camel(entry.stem)}; }} }}\n\n"
            f"        /// <inheritdoc/>\n        public bool IsDouble {{ get {{ return {wide}; }} }}\n\n"
            f"        unsafe void IShape.Write(void* numbers)\n        {{\n"
            f"            var to = ({number}*)numbers;\n{writes}        }}\n"
        )
    base = " : IShape" if entry.stem in SHAPES else ""
    return (
        f"{summary(entry.paragraphs, '    ')}    [StructLayout(LayoutKind.Sequential)]\n"
        f"    public struct {name}{base}\n    {{\n{texts}"
        f"        /// <summary>From its numbers.</summary>\n"
        f"        public {name}({parameters})\n        {{\n{sets}        }}\n{shape}    }}\n\n"
    )


def type_of(declaration):
    if declaration.is_pointer or declaration.count:
        return "void*"
    return NUMBERS[declaration.base]


def result(entry):
    return "IntPtr" if entry.returns.is_pointer else NUMBERS[entry.returns.base]


def imported(entry):
    parameters = ", ".join(f"{type_of(each)} {local(each.name)}" for each in entry.parameters)
    return (
        f"{summary(entry.paragraphs, '        ')}"
        "        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]\n"
        + broken(f"        internal static extern {result(entry)} {entry.name}({parameters});")
        + "\n\n"
    )


def dispatcher(entry):
    """Of a function with two forms: the choice by scalar."""
    declared, double, single = [], [], []
    for each in entry.parameters:
        is_scalar = type_of(each) in SCALARS.values()
        declared.append(f"{'double' if is_scalar else type_of(each)} {local(each.name)}")
        double.append(local(each.name))
        single.append(f"(float){local(each.name)}" if is_scalar else local(each.name))
    return (
        broken(f"        internal static {result(entry)} {camel(entry.stem)}(bool wide, {', '.join(declared)})")
        + "\n        {\n            return wide\n"
        + broken(f"                ? vesica_{entry.stem}_f64({', '.join(double)})")
        + "\n"
        + broken(f"                : vesica_{entry.stem}_f32({', '.join(single)});")
        + "\n        }\n\n"
    )


def called(description):
    pairs = tuple(f"overlap_{kind}_" for kind in SHAPES)
    return [
        entry
        for entry in description.functions
        if not entry.stem.startswith(pairs) and entry.stem != "shapes_from_records"
    ]


def files(description):
    functions = called(description)
    version = next(entry for entry in description.constants if entry.short == "VERSION")
    structs = [entry for entry in description.structs if not entry.has_pointers]
    native = (
        f"{OPENING}using System;\nusing System.Runtime.InteropServices;\n\nnamespace Vesica\n{{\n"
        "    /// <summary>The functions of the C library, with their texts.</summary>\n"
        "    internal static unsafe partial class Native\n    {\n"
        f"{summary([version.comment], '        ')}        internal const int Version = {version.value};\n\n"
        + "".join(map(imported, functions))
        + "".join(dispatcher(entry) for entry in functions if entry.scalar == "f64").rstrip("\n")
        + "\n    }\n}\n"
    )
    types = (
        f"{OPENING}using System.Runtime.InteropServices;\n\nnamespace Vesica\n{{\n"
        + "".join(enum(description, group) for group in ENUMS)
        + "".join(struct(entry, entry.scalar) for entry in structs).rstrip("\n")
        + "\n}\n"
    )
    return {"bindings/csharp/generated/Native.cs": native, "bindings/csharp/generated/Types.cs": types}
