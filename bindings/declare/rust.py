# SPDX-License-Identifier: Apache-2.0
"""The crate vesica-sys: constants, structs, functions, and a trait that has both scalars' functions by one name."""
import re

from description import HEAD, SCALARS, WIDTH, broken, camel, filled

NUMBERS = {
    "uint8_t": "u8",
    "int32_t": "i32",
    "int64_t": "i64",
    "ptrdiff_t": "isize",
    "float": "f32",
    "double": "f64",
    "void": "c_void",
    "char": "u8",
}
OPENING = "".join(f"// {line}\n" for line in HEAD) + "use core::ffi::c_void;\n\n"
TRAIT = """\
/// `f64` and `f32`, each with the functions of its type.
///
/// # Safety
/// Nothing else can be one.
#[allow(missing_docs, clippy::missing_safety_doc, clippy::too_many_arguments)]
pub unsafe trait Scalar: Copy + Default + PartialEq + PartialOrd + core::fmt::Debug + 'static {
"""


def text(entry, indent=""):
    """Paragraphs, in which nothing is taken for markup."""
    escaped = (re.sub(r"([\[\]<>*])", r"\\\1", paragraph) for paragraph in entry.paragraphs)
    lines = filled("\n\n".join(escaped), WIDTH - 4 - len(indent)).split("\n")
    return "".join(f"{indent}/// {line}".rstrip() + "\n" for line in lines if entry.comment)


def base(declaration, scalar):
    """The type that is pointed to; scalar is the name that stands for float and double."""
    name = declaration.base
    if name.startswith("vesica_"):
        generic = camel(name[len("vesica_") : -4])
        return f"{generic}<{scalar or SCALAR_OF[name[-3:]]}>"
    if name in SCALARS.values() and scalar:
        return scalar
    return NUMBERS[name]


SCALAR_OF = {suffix: NUMBERS[name] for suffix, name in SCALARS.items()}


def type_of(declaration, scalar=None):
    name = base(declaration, scalar)
    if declaration.is_pointer or declaration.count:
        return f"*{'const' if declaration.is_const else 'mut'} {name}"
    return name


def field(declaration):
    name = type_of(declaration, "T") if declaration.is_pointer else base(declaration, "T")
    return f"    pub {declaration.name}: " + (f"[{name}; {declaration.count}]" if declaration.count else name) + ",\n"


def struct(entry):
    name = camel(entry.stem)
    default = "" if any(each.is_pointer for each in entry.fields) else "Default, "
    fields = "".join(map(field, entry.fields))
    aliases = "".join(
        f"/// [`{name}`] of {number}.\npub type vesica_{entry.stem}_{suffix} = {name}<{number}>;\n"
        for suffix, number in SCALAR_OF.items()
    )
    return (
        f"{text(entry)}#[repr(C)]\n#[derive(Clone, Copy, Debug, {default}PartialEq)]\n#[allow(missing_docs)]\n"
        f"pub struct {name}<T> {{\n{fields}}}\n{aliases}\n"
    )


def signature(entry, name, scalar=None):
    parameters = "".join(f"{each.name}: {type_of(each, scalar)}, " for each in entry.parameters)
    return f"fn {name}({parameters[:-2]}) -> {type_of(entry.returns, scalar)}"


def call(entry, suffix):
    names = ", ".join(each.name for each in entry.parameters)
    head = signature(entry, entry.stem, SCALAR_OF[suffix])
    body = broken(f"        vesica_{entry.stem}_{suffix}({names})")
    return f"    #[inline]\n{broken(f'    unsafe {head} {{')}\n{body}\n    }}\n"


def implementation(functions, suffix):
    calls = "".join(call(entry, suffix) for entry in functions)
    return f"unsafe impl Scalar for {SCALAR_OF[suffix]} {{\n{calls}}}\n"


def constant(entry):
    return f"{text(entry)}pub const {entry.name}: i32 = {entry.value};\n"


def files(description):
    generic = description.in_double("functions")
    functions = "".join(
        f"{text(each, '    ')}{broken(f'    pub {signature(each, each.name)};')}\n" for each in description.functions
    )
    return {
        "bindings/rust/vesica-sys/src/declarations.rs": OPENING
        + "".join(map(constant, description.constants))
        + "\n"
        + "".join(map(struct, description.in_double("structs")))
        + f'extern "C" {{\n{functions}}}\n\n'
        + TRAIT
        + "".join(broken(f"    unsafe {signature(each, each.stem, 'Self')};") + "\n" for each in generic)
        + "}\n"
        + "".join(implementation(generic, suffix) for suffix in SCALARS)
    }
