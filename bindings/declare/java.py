# SPDX-License-Identifier: Apache-2.0
"""The package for Java: native methods and what stands behind them in C, records and enums, with javadoc.

A pointer is an Object in Java: an array or a direct buffer, lent to C for the time of the call. An array of shapes is
five arguments: kind, count, stride, the bytes from one number to the next, and the memory.
"""
from description import ENUMS, HEAD, SCALARS, SHAPES, WIDTH, broken, camel, filled

OPENING = "".join(f"// {line}\n" for line in HEAD)
PACKAGE = OPENING + "package vesica;\n\n"
JAVA = {"int32_t": "int", "int64_t": "long", "ptrdiff_t": "long", "double": "double", "float": "float"}
JNI = {
    "int": "jint",
    "long": "jlong",
    "double": "jdouble",
    "float": "jfloat",
    "Object": "jobject",
    "String": "jstring",
    "int[]": "jintArray",
    "long[]": "jlongArray",
    "Object[]": "jobjectArray",
}
VIEW = (("int", "Kind"), ("long", "Count"), ("long", "Stride"), ("long", "Step"), ("Object", "Base"))
SETS = (("int[]", "Kinds"), ("long[]", "Counts"), ("long[]", "Strides"), ("long[]", "Steps"), ("Object[]", "Bases"))


def escaped(text):
    for character, entity in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("@", "&#64;"), ("*/", "*&#47;")):
        text = text.replace(character, entity)
    return text


def javadoc(text, indent=""):
    """Paragraphs as those of HTML."""
    paragraphs = escaped(text).split("\n\n")
    lines = filled("\n\n<p>".join(paragraphs), WIDTH - 3 - len(indent)).split("\n")
    return f"{indent}/**\n" + "".join(f"{indent} * {line}".rstrip() + "\n" for line in lines) + f"{indent} */\n"


def local(name):
    return camel(name, first=False)


def field_name(name):
    return local(name)


def enum(description, group):
    name, about = ENUMS[group]
    values = ",\n".join(
        javadoc(entry.meaning, "  ") + f"  {entry.own}({entry.value})"
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
    given = [each for each in entry.parameters if not is_set_count(each)]
    return ", ".join(f"{kind} {name}" for each in given for kind, name in expanded(each))


def native_method(entry):
    about = javadoc("\n\n".join(entry.paragraphs), "  ")
    declared = f"  static native {result_in_java(entry)} {native_name(entry)}({parameters_in_java(entry)});"
    return f"{about}{broken(declared)}\n\n"


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
        broken(f"  static {result_in_java(entry)} {stem}(boolean wide, {', '.join(declared)}) {{")
        + "\n    return wide\n"
        + broken(f"        ? {calls[0]}")
        + "\n"
        + broken(f"        : {calls[1]};")
        + "\n  }\n\n"
    )


class Body:
    """What is between the braces of a function in C: memory is prepared, lent, seen as arrays of shapes, passed."""

    def __init__(self):
        self.held = self.sets = 0
        self.prepare, self.views, self.passed = [], [], []

    def take(self, declaration, scalar):
        name = local(declaration.name)
        number = SCALARS.get(scalar)
        if declaration.is_sets:
            lent = f"lent_to[{self.sets}]"
            parts = ", ".join(name + part for _, part in SETS)
            self.prepare.append(f"  if (!prepare_sets(env, {parts}, &{lent})) return NOT_LENT;\n")
            self.views.append(f"    vesica_shapes_{scalar} {name}[MAX_SETS];\n    SETS({name}, {lent}, {number});\n")
            self.passed += [name, f"{lent}.count"]
            self.sets += 1
        elif declaration.is_shapes:
            parts = ", ".join(name + part for _, part in VIEW[:-1])
            address = self.hold(f"{name}Base")
            self.views.append(
                f"    vesica_shapes_{scalar} {name};\n    VIEW({name}, {parts}, {address}, {number});\n"
            )
            self.passed.append(f"&{name}")
        elif is_pointer(declaration):
            self.passed.append(self.hold(name))
        else:
            self.passed.append(name)

    def hold(self, name):
        """Memory that one object lends: its address in the call."""
        self.prepare.append(f"  prepare(env, {name}, &held[{self.held}]);\n")
        self.held += 1
        return f"held[{self.held - 1}].address"

    def text(self, returns, call):
        """What sets lend is taken first and given back last."""
        sets = [f"env, lent_to[{i}].held, lent_to[{i}].count" for i in range(self.sets)]
        all_lent = sets + [f"env, held, {self.held}"] * (self.held > 0)
        lend = "\n      && ".join(f"lend({each})" for each in all_lent)
        back = "".join(f"  give_back({each});\n" for each in all_lent[self.sets :] + sets)
        asked = broken(f"    returned = {call};")
        return (
            f"  lent held[{self.held}];\n" * (self.held > 0)
            + f"  lent_sets lent_to[{self.sets}];\n" * (self.sets > 0)
            + f"  {returns} returned = NOT_LENT;\n  (void)type;\n"
            + "".join(self.prepare)
            + f"  if ({lend}) {{\n{''.join(self.views)}{asked}\n  }}\n{back}  return returned;\n"
        )


def function_in_c(entry):
    body, parameters = Body(), ["JNIEnv* env", "jclass type"]
    for each in entry.parameters:
        if not is_set_count(each):
            parameters += [f"{JNI[kind]} {name}" for kind, name in expanded(each)]
            body.take(each, entry.scalar)
    call = f"{entry.name}({', '.join(body.passed)})"
    if entry.returns.is_pointer:
        text = f"  (void)type;\n  return (*env)->NewStringUTF(env, {call});\n"
    elif not body.held and not body.sets:
        text = f"  (void)env, (void)type;\n  return {call};\n"
    else:
        text = body.text(entry.returns.base, call)
    returns = JNI[result_in_java(entry)]
    head = f"JNIEXPORT {returns} JNICALL Java_vesica_Native_{native_name(entry)}({', '.join(parameters)}) {{"
    return f"{broken(head)}\n{text}}}\n\n"


def called(description):
    """All functions but those of two given kinds, and what makes views, which are made here."""
    pairs = tuple(f"overlap_{kind}_" for kind in SHAPES)
    return [
        entry
        for entry in description.functions
        if not entry.stem.startswith(pairs) and entry.stem not in ("shapes_from_records", "isa_name")
    ]


def files(description):
    functions = called(description)
    version = next(entry for entry in description.constants if entry.short == "VERSION")
    records = [entry for entry in description.in_double("structs") if entry.is_of_scalars]
    native = (
        PACKAGE
        + "/** The functions of the C library, with their texts. Object is an array or a direct buffer. */\n"
        + f"final class Native {{\n{javadoc(version.comment, '  ')}  static final int VERSION = {version.value};\n\n"
        + "  private Native() {}\n\n  static {\n    Library.load();\n  }\n\n"
        + "".join(map(native_method, functions))
        + "".join(dispatcher(entry) for entry in functions if entry.scalar == "f64")
    ).rstrip("\n") + "\n}\n"
    return {
        "bindings/java/generated/vesica/Native.java": native,
        "bindings/java/generated/vesica_jni.c": "".join(f"/* {line} */\n" for line in HEAD)
        + '#include "lend.h"\n\n'
        + "".join(map(function_in_c, functions)).rstrip("\n")
        + "\n",
        **{f"bindings/java/generated/vesica/{camel(entry.stem)}.java": record(entry) for entry in records},
        **{f"bindings/java/generated/vesica/{ENUMS[group][0]}.java": enum(description, group) for group in ENUMS},
    }
