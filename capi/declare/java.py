# SPDX-License-Identifier: Apache-2.0
"""The package for Java: native methods and what stands behind them in C, records and enums, with javadoc.

A pointer is an Object in Java: an array or a direct buffer, lent to C for the time of the call. An array of shapes is
five arguments: kind, count, stride, the bytes from one number to the next, and the memory.
"""
from description import HEAD, SCALARS, camel

OPENING = "".join(f"// {line}\n" for line in HEAD)
PACKAGE = OPENING + "package vesica;\n\n"
SHAPES = ("point", "segment", "circle", "aabb", "rect", "ellipse")
JAVA = {"int32_t": "int", "int64_t": "long", "ptrdiff_t": "long", "double": "double", "float": "float"}
JNI = {"int": "jint", "long": "jlong", "double": "jdouble", "float": "jfloat", "Object": "jobject", "String": "jstring"}
VIEW = (("int", "Kind"), ("long", "Count"), ("long", "Stride"), ("long", "Step"), ("Object", "Base"))
SETS = (("int[]", "Kinds"), ("long[]", "Counts"), ("long[]", "Strides"), ("long[]", "Steps"), ("Object[]", "Bases"))
ENUMS = {
    "KINDS": ("Kind", "The six kinds of shapes."),
    "RELATIONS": ("Relation", "How a shape a relates to a shape b: the eight relations of RCC-8."),
    "JOINS": ("JoinQuery", "What makes item a of one index and item b of another a pair of a join."),
    "ERRORS": ("ErrorCode", "Why the library has no answer."),
}


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("@", "&#64;").replace("*/", "*&#47;")


def javadoc(text, indent=""):
    """Paragraphs as those of HTML."""
    paragraphs = escaped(text).split("\n\n")
    lines = "\n\n<p>".join(paragraphs).split("\n")
    return f"{indent}/**\n" + "".join(f"{indent} * {line}".rstrip() + "\n" for line in lines) + f"{indent} */\n"


def local(name):
    return camel(name, first=False)


def field_name(name):
    return local(name)


def enum(description, group):
    name, about = ENUMS[group]
    values = ",\n".join(
        javadoc(entry.comment, "  ") + f"  {entry.short.removeprefix('JOIN_').removeprefix('E_')}({entry.value})"
        for entry in description.constants_of(group)
    )
    return (
        f"{PACKAGE}{javadoc(about)}public enum {name} {{\n{values};\n\n"
        f"  /** The library's number. */\n  public final int value;\n\n"
        f"  {name}(int value) {{\n    this.value = value;\n  }}\n\n"
        f"  private static final {name}[] ALL = values();\n\n"
        f"  /** The one with a number of the library's; null if there is none. */\n"
        f"  public static {name} of(int value) {{\n"
        f"    for ({name} each : ALL) if (each.value == value) return each;\n    return null;\n  }}\n}}\n"
    )


def record(entry):
    name = camel(entry.stem)
    fields = ", ".join(f"double {field_name(each.name)}" for each in entry.fields)
    numbers = ", ".join(field_name(each.name) for each in entry.fields)
    texts = "".join(f"\n@param {field_name(each.name)} {each.name}" for each in entry.fields)
    about = javadoc("\n\n".join(entry.paragraphs)).removesuffix(" */\n")
    about += " *\n" + "".join(f" * {line}\n" for line in texts.strip().split("\n")) + " */\n"
    if entry.stem not in SHAPES:
        made = ", ".join(f"n[{i}]" for i in range(len(entry.fields)))
        body = f"\n  static {name} of(double[] n) {{\n    return new {name}({made});\n  }}\n"
        return f"{PACKAGE}{about}public record {name}({fields}) {{{body}}}\n"
    made = ", ".join(f"n[{i}]" for i in range(len(entry.fields)))
    return (
        f"{PACKAGE}{about}public record {name}({fields}) implements Shape {{\n"
        f"  static {name} of(double[] n) {{\n    return new {name}({made});\n  }}\n\n"
        f"  @Override\n  public Kind kind() {{\n    return Kind.{entry.stem.upper()};\n  }}\n\n"
        f"  @Override\n  public double[] numbers() {{\n    return new double[] {{{numbers}}};\n  }}\n}}\n"
    )


def is_pointer(declaration):
    return declaration.is_pointer or declaration.count


def native_name(entry):
    return local(entry.stem) + (entry.scalar or "").upper()


def expanded(declaration):
    """The parameters of a native method that stand for one of C's: (type, name)."""
    name = local(declaration.name)
    if declaration.is_sets:
        return [(kind, name + part) for kind, part in SETS]
    if declaration.is_shapes:
        return [(kind, name + part) for kind, part in VIEW]
    if is_pointer(declaration):
        return [("Object", name)]
    return [(JAVA[declaration.base], name)]


def is_set_count(declaration):
    return declaration.name.startswith("set_count")


def result_in_java(entry):
    return "String" if entry.returns.is_pointer else JAVA[entry.returns.base]


def parameters_in_java(entry):
    return ", ".join(f"{kind} {name}" for each in entry.parameters if not is_set_count(each) for kind, name in expanded(each))


def native_method(entry):
    about = javadoc("\n\n".join(entry.paragraphs), "  ")
    return f"{about}  static native {result_in_java(entry)} {native_name(entry)}({parameters_in_java(entry)});\n\n"


def dispatcher(entry):
    """Of a function with two forms: the choice by scalar, with arrays of shapes as objects."""
    declared, passed = [], {"f64": [], "f32": []}
    for each in entry.parameters:
        name = local(each.name)
        if is_set_count(each):
            continue
        if each.is_sets or each.is_shapes:
            declared.append(f"{'Sets' if each.is_sets else 'Shapes'} {name}")
            parts = [f"{name}.{part[0].lower()}{part[1:]}" for _, part in (SETS if each.is_sets else VIEW)]
            passed["f64"] += parts
            passed["f32"] += parts
        elif each.base in SCALARS.values() and not is_pointer(each):
            declared.append(f"double {name}")
            passed["f64"].append(name)
            passed["f32"].append(f"(float) {name}")
        else:
            declared.append(f"{expanded(each)[0][0]} {name}")
            passed["f64"].append(name)
            passed["f32"].append(name)
    stem = local(entry.stem)
    calls = [f"{stem}{suffix.upper()}({', '.join(names)})" for suffix, names in passed.items()]
    return (
        f"  static {result_in_java(entry)} {stem}(boolean wide, {', '.join(declared)}) {{\n"
        f"    return wide\n        ? {calls[0]}\n        : {calls[1]};\n  }}\n\n"
    )


def function_in_c(entry):
    parameters, prepare, made, passed, held = [], [], [], [], 0
    sets = [each for each in entry.parameters if each.is_sets]
    for each in entry.parameters:
        if is_set_count(each):
            continue
        name = local(each.name)
        for kind, part in expanded(each):
            parameters.append(f"{JNI.get(kind) or {'int[]': 'jintArray', 'long[]': 'jlongArray'}.get(kind, 'jobjectArray')} {part}")
        if each.is_sets:
            i = sets.index(each)
            prepare.append(f"  ok = prepare_sets(env, {name}Kinds, {name}Counts, {name}Strides, {name}Steps, {name}Bases, &lent_to[{i}]) && ok;\n")
            made.append(f"    vesica_shapes_{entry.scalar} {name}[MAX_SETS];\n    SETS({name}, lent_to[{i}], {SCALARS[entry.scalar]});\n")
            passed += [name, f"lent_to[{i}].count"]
        elif each.is_shapes:
            prepare.append(f"  prepare(env, {name}Base, &held[{held}]);\n")
            made.append(
                f"    vesica_shapes_{entry.scalar} {name};\n    VIEW({name}, {name}Kind, {name}Count, {name}Stride, {name}Step, "
                f"held[{held}].address, {SCALARS[entry.scalar]});\n"
            )
            passed.append(f"&{name}")
            held += 1
        elif is_pointer(each):
            prepare.append(f"  prepare(env, {name}, &held[{held}]);\n")
            passed.append(f"held[{held}].address")
            held += 1
        else:
            passed.append(name)
    head = (
        f"JNIEXPORT {JNI[result_in_java(entry)]} JNICALL Java_vesica_Native_{native_name(entry)}("
        f"{', '.join(['JNIEnv* env', 'jclass type', *parameters])}) {{\n"
    )
    call = f"{entry.name}({', '.join(passed)})"
    if entry.returns.is_pointer:
        return f"{head}  (void)type;\n  return (*env)->NewStringUTF(env, {call});\n}}\n\n"
    if not held and not sets:
        return f"{head}  (void)env, (void)type;\n  return {call};\n}}\n\n"
    # What a set lends is taken first and given back last.
    lend = " && ".join([*(["ok"] if sets else []), *(f"lend(env, lent_to[{i}].held, lent_to[{i}].count)" for i in range(len(sets))), *([f"lend(env, held, {held})"] if held else [])])
    back = (f"  give_back(env, held, {held});\n" if held else "") + "".join(
        f"  give_back(env, lent_to[{i}].held, lent_to[{i}].count);\n" for i in range(len(sets))
    )
    return (
        head
        + (f"  lent held[{held}];\n" if held else "")
        + (f"  lent_sets lent_to[{len(sets)}];\n  int ok = 1;\n" if sets else "")
        + f"  {entry.returns.base} answer = NOT_LENT;\n  (void)type;\n"
        + "".join(prepare)
        + f"  if ({lend}) {{\n{''.join(made)}    answer = {call};\n  }}\n{back}  return answer;\n}}\n\n"
    )


def called(description):
    """All functions but those of two given kinds, and what makes views, which are made here."""
    pairs = tuple(f"overlap_{kind}_" for kind in SHAPES)
    return [
        entry
        for entry in description.functions
        if not entry.stem.startswith(pairs) and entry.stem not in ("shapes_from_records", "index_step", "isa_name")
    ]


def files(description):
    functions = called(description)
    version = next(entry for entry in description.constants if entry.short == "VERSION")
    records = [entry for entry in description.in_double("structs") if entry.stem not in ("shapes", "crossing_points")]
    native = (
        PACKAGE
        + "/** The functions of the C library, with their texts. Object is an array or a direct buffer. */\n"
        + f"final class Native {{\n{javadoc(version.comment, '  ')}  static final int VERSION = {version.value};\n\n"
        + "  private Native() {}\n\n  static {\n    Library.load();\n  }\n\n"
        + "".join(map(native_method, functions))
        + "".join(dispatcher(entry) for entry in functions if entry.scalar == "f64")
    ).rstrip("\n") + "\n}\n"
    return {
        "java/src/vesica/Native.java": native,
        "java/native/vesica_jni.c": "".join(f"/* {line} */\n" for line in HEAD)
        + '#include "lend.h"\n\n'
        + "".join(map(function_in_c, functions)).rstrip("\n")
        + "\n",
        **{f"java/src/vesica/{camel(entry.stem)}.java": record(entry) for entry in records},
        **{f"java/src/vesica/{ENUMS[group][0]}.java": enum(description, group) for group in ENUMS},
    }
