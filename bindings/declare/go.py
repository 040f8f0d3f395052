# SPDX-License-Identifier: Apache-2.0
"""The module for Go: constants and structs with their texts, and the C functions by one name for both scalars.

Go memory that holds pointers to Go memory must not be passed to C. So views of arrays, and one shape, go
by value, to functions of a header that is written too. There addresses are of char: of void, Go would look for such
pointers in the whole object about them, and refuse slices inside one that has any.
"""
from description import HEAD, SCALARS, SHAPES, WIDTH, broken, camel, filled

OPENING = "".join(f"// {line}\n" for line in HEAD)
# The texts of groups of constants, the type, and the prefix of each name.
GROUPS = {
    "KINDS": ("Kind is a kind of shapes.", "Kind", "int32", "Kind"),
    "RELATIONS": ("Relation is how a shape relates to another: one of RCC-8's eight.", "Relation", "uint8", "Relation"),
    "ERRORS": ("Error is an error code of the library.", "Error", "int32", "Err"),
    "JOINS": ("JoinQuery is what makes a pair of a join.", "JoinQuery", "int32", "Join"),
    "RATIOS": ("Ratio is what a shared area is compared with.", "Ratio", "int32", "Ratio"),
    "ANGLES": ("Angle is how angles are told, from +x towards +y.", "Angle", "int32", "Angle"),
    "DECAYS": ("Decay is how soft suppression lowers scores.", "Decay", "int32", "Decay"),
    "WITHINS": ("WithinResult is whether two shapes are so near.", "WithinResult", "uint8", "Within"),
    "CASTS": ("CastResult is what a cast finds.", "CastResult", "int32", "Cast"),
    "FUSED_SCORES": ("FusedScore is the score of a cluster of boxes that were fused.", "FusedScore", "int32", "Fused"),
    "MATCH_RULES": ("MatchRule is which truth a detection takes.", "MatchRule", "int32", "Match"),
    "TRUTHS": ("Truth is the part of a truth in the result.", "Truth", "uint8", "Truth"),
    "OUTCOMES": ("Outcome is what a detection is.", "Outcome", "uint8", "Outcome"),
    "PRECISION_RULES": ("PrecisionRule is how precision is averaged over recall.", "PrecisionRule", "int32", "Precision"),
}

HEADER = '''\
#ifndef VESICA_GO_H
#define VESICA_GO_H

#include <string.h>
#include <vesica.h>

/* vesica_shapes_f64 and vesica_shapes_f32. */
typedef struct {
    int32_t kind, reserved;
    int64_t count;
    ptrdiff_t stride;
    const char *field[8];
    const int32_t *rings, *polygons;
    int64_t each;
} vesica_go_view;

/* As many as an index may have. */
typedef struct {
    vesica_go_view set[64];
} vesica_go_sets;

/* vesica_polygon_f64 and vesica_polygon_f32. Polylines have the same members. */
typedef struct {
    const char *x, *y;
    ptrdiff_t stride;
    const int32_t *rings;
    int64_t count;
} vesica_go_path;

/* One shape: its numbers, in double or float, or the path of a polygon or a polyline. */
typedef struct {
    double numbers[7];
    vesica_go_path path;
} vesica_go_shape;

'''
# The struct of one shape of any kind, for each scalar.
READ = '''\
typedef union {
    %(base)s numbers[7];
    vesica_polygon_%(suffix)s path;
} vesica_go_%(suffix)s;

static inline vesica_go_%(suffix)s go_read_%(suffix)s(int32_t kind, const vesica_go_shape *shape) {
    vesica_go_%(suffix)s read;
    if (kind < VESICA_POLYGON) {
        memcpy(&read.numbers, &shape->numbers, sizeof read.numbers);
    } else {
        memcpy(&read.path, &shape->path, sizeof read.path);
    }
    return read;
}

'''


def name_of(name, first=True):
    """As Go writes names: cx is CX, min_x MinX, aabb AABB."""
    words = name.lower().split("_")
    short = ("aabb", "iou", "nms")
    is_short = [word in short or (len(word) <= 2 and word not in ("no", "of")) for word in words]
    capital = [word.upper() if upper else word.capitalize() for word, upper in zip(words, is_short)]
    return "".join(capital) if first else words[0] + "".join(capital[1:])


def comment(text):
    return "".join(f"// {line}".rstrip() + "\n" for line in filled(text, WIDTH - 3).split("\n"))


def constants(description, group):
    about, kind, base, prefix = GROUPS[group]
    lines = []
    for entry in description.constants_of(group):
        name = prefix + name_of(entry.own)
        lines += [f"\t// {name}: {entry.meaning}", f"\t{name} {kind} = {entry.value}"]
    values = "\n".join(lines)
    return f"{comment(about)}type {kind} {base}\n\n// {kind} values.\nconst (\n{values}\n)\n\n"


def field(declaration, width):
    base = "T" if declaration.base in SCALARS.values() else declaration.base.removesuffix("_t")
    array = f"[{declaration.count}]" if declaration.count else ""
    return f"\t{name_of(declaration.name):{width}} {array}{base}\n"


def struct(entry):
    name = name_of(entry.stem)
    text = comment(f"{name}: " + "\n\n".join(entry.paragraphs))
    width = max(len(name_of(each.name)) for each in entry.fields)
    fields = "".join(field(each, width) for each in entry.fields)
    method = ""
    if entry.stem in SHAPES:
        method = f"func (s {name}[T]) one() one {{ return oneOf[T](Kind{name}, unsafe.Pointer(&s)) }}\n\n"
        method += (
            f"// {name}s is an array of shapes: the slice itself, which is not copied.\n"
            f"func {name}s[T Float](shapes []{name}[T]) Array[T] {{\n"
            f"\treturn arrayOf[T](Kind{name}, first(shapes), len(shapes))\n}}\n\n"
        )
    return f"{text}type {name}[T Float] struct {{\n{fields}}}\n\n{method}"


def in_c(declaration):
    """The type of a parameter of the header's function."""
    if declaration.is_sets:
        return "vesica_go_sets"
    if declaration.is_shapes:
        return "vesica_go_view"
    if declaration.is_shape:
        return "vesica_go_shape"
    if declaration.is_pointer or declaration.count:
        return "char *" if not declaration.is_const else "const char *"
    return declaration.base


def declared_in_c(declaration):
    kind = in_c(declaration)
    return kind + ("" if kind.endswith("*") else " ") + declaration.name


def passed_in_c(declaration, kind, suffix):
    """A copy where needed, and what is passed; kind is the parameter before it, of one shape its kind."""
    name = declaration.name
    if declaration.is_sets:
        copy = f"    vesica_shapes_{suffix} of_{name}[64];\n    memcpy(of_{name}, &{name}, sizeof of_{name});\n"
        return copy, f"of_{name}"
    if declaration.is_shapes:
        copy = f"    vesica_shapes_{suffix} of_{name};\n    memcpy(&of_{name}, &{name}, sizeof of_{name});\n"
        return copy, f"&of_{name}"
    if declaration.is_shape:
        return f"    vesica_go_{suffix} of_{name} = go_read_{suffix}({kind.name}, &{name});\n", f"&of_{name}"
    kind = in_c(declaration)
    return "", f"({kind.replace('char', 'void')}){name}" if "*" in kind else name


def function_in_c(entry, suffix):
    parameters = ", ".join(
        f"{SCALARS[suffix]} {each.name}" if in_c(each) in SCALARS.values() else declared_in_c(each)
        for each in entry.parameters
    )
    before = [None, *entry.parameters]
    passed = [passed_in_c(each, kind, suffix) for kind, each in zip(before, entry.parameters)]
    copies = "".join(copy for copy, _ in passed)
    names = ", ".join(name for _, name in passed)
    return (
        broken(f"static inline {entry.returns.base} go_{entry.stem}_{suffix}({parameters}) {{")
        + f"\n{copies}"
        + broken(f"    return vesica_{entry.stem}_{suffix}({names});")
        + "\n}\n\n"
    )


def in_go(declaration):
    kind = in_c(declaration)
    if "*" in kind:
        return "*C.char"
    return "float64" if kind in SCALARS.values() else f"C.{kind}"


def local(name):
    return camel(name, first=False)


def function_in_go(entry):
    name = "c" + name_of(entry.stem)
    parameters = "".join(f", {local(each.name)} {in_go(each)}" for each in entry.parameters)
    calls = {}
    for suffix, base in SCALARS.items():
        names = ", ".join(
            f"C.{base}({local(each.name)})" if in_go(each) == "float64" else local(each.name)
            for each in entry.parameters
        )
        calls[suffix] = f"C.go_{entry.stem}_{suffix}({names})"
    return (
        broken(f"func {name}(wide bool{parameters}) C.{entry.returns.base} {{", "\t")
        + "\n\tif wide {\n"
        + broken(f"\t\treturn {calls['f64']}", "\t")
        + "\n\t}\n"
        + broken(f"\treturn {calls['f32']}", "\t")
        + "\n}\n\n"
    )


def called(description):
    """The functions with a form for each scalar, but for the pairs of kinds: those in general are as good from Go."""
    pairs = tuple(f"overlap_{kind}_" for kind in SHAPES)
    return [
        entry
        for entry in description.in_double("functions")
        if not entry.stem.startswith(pairs) and entry.stem != "shapes_from_records"
    ]


def files(description):
    functions = called(description)
    version = next(entry for entry in description.constants if entry.short == "VERSION")
    return {
        "bindings/go/declarations.h": "".join(f"/* {line} */\n" for line in HEAD)
        + HEADER
        + "".join(READ % {"base": base, "suffix": suffix} for suffix, base in SCALARS.items())
        + "".join(function_in_c(entry, suffix) for entry in functions for suffix in SCALARS)
        + "#endif\n",
        "bindings/go/declarations.go": OPENING
        + '\npackage vesica\n\n// #include "declarations.h"\nimport "C"\n\nimport "unsafe"\n\n'
        + f"// Version {version.comment}.\nconst Version = {version.value}\n\n"
        + "".join(constants(description, group) for group in GROUPS)
        + "".join(struct(entry) for entry in description.in_double("structs") if not entry.has_pointers)
        + "".join(map(function_in_go, functions)).rstrip("\n")
        + "\n",
    }
