#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Describes the C interface for other languages, from the headers alone: capi/vesica.json (everything, comments included),
and for cffi and LuaJIT a file of declarations for each library, capi/vesica.cdef and capi/vesica_methods.cdef.

describe.py          writes all of them
describe.py --check  exits with 1 where a file is not what the headers say

The headers are read strictly: what is not one of the few forms they use is an error, so that nothing is left out.

The headers say everything once. Here each comment is made complete by itself:
  - A function takes the parts (PARTS) that its comment does not have from the heading above it.
  - "As vesica_..._f64." becomes the text of the double function, with the names of the float ones.
  - A comment that uses u or the scale takes their definitions from the top of vesica.h.
"""
import difflib
import json
import pathlib
import re
import sys

CAPI = pathlib.Path(__file__).resolve().parent.parent / "capi"
INCLUDE = CAPI / "include"
# Each header's library, without its version, and the version script of what that exports.
QUESTIONS = ("vesica.h", "vesica_boxes.h", "vesica_detection.h", "vesica_index.h", "vesica_measures.h",
             "vesica_motion.h", "vesica_topology.h")
LIBRARIES = {**dict.fromkeys(QUESTIONS, "libvesica"), "vesica_methods.h": "libvesica-methods"}
MAPS = {**dict.fromkeys(QUESTIONS, "vesica.map"), "vesica_methods.h": "methods.map"}
HEADERS = tuple(LIBRARIES)
# Each library's file of declarations: it has all headers of the library.
CDEFS = {"libvesica": "vesica.cdef", "libvesica-methods": "vesica_methods.cdef"}
# The parts of a comment behind its description, in their order.
PARTS = ("Requires", "Returns", "Errors", "Accuracy", "Cost", "Since")
# Bytes of each type a struct may hold, each aligned to its size; those of 64-bit machines.
POINTER_SIZE = 8
SIZES = {"uint8_t": 1, "int32_t": 4, "float": 4, "int64_t": 8, "double": 8, "ptrdiff_t": 8}
# Macros without a value that are not constants: the include guards, and what marks an exported function.
NOT_CONSTANTS = {header.upper().replace(".", "_") for header in HEADERS} | {"VESICA_API"}

PART = re.compile(r"^(" + "|".join(PARTS) + "): ", re.M)
HEADING = re.compile(r"/\* ---- (?P<title>.*?) ----(?P<parts>.*?)\*/", re.S)
REFERENCE = re.compile(r"As (vesica_\w+_f64)(, rounded to float)?\.")
ROUNDED = "\nEach number is computed in double, within these bounds, and then rounded to float once."
DEFINITION = re.compile(r"^ - (In bounds on errors u is.*?)(?=^ - |\Z)", re.M | re.S)
CONSTANT = re.compile(r"#define (?P<name>[A-Z]\w*) +\(?(?P<value>-?\d+)\)?(?: */\*\*<(?P<comment>.*?)\*/)?\n", re.S)
STRUCT = re.compile(r"typedef struct \{(?P<body>[^{}]*)\} (?P<name>\w+);")
FUNCTION = re.compile(r"VESICA_API (?P<returns>[\w ]+?)(?P<stars>[ *]*)\b(?P<name>\w+)\((?P<parameters>[^()]*)\);")
DECLARATION = re.compile(r"(?P<base>(?:const )?\w+) (?P<stars>\**)(?P<name>\w+)(?:\[(?P<count>\d+)\])?")


class HeaderError(Exception):
    pass


def words(comment):
    """The text of a comment: paragraphs and line breaks stay, the frame of stars goes."""
    lines = [re.sub(r"^\s*\* ?", "", line).rstrip() for line in (comment or "").split("\n")]
    return "\n".join(lines).strip()


def parted(comment):
    """A comment as {"": description, part: text ...}."""
    description, *rest = PART.split(comment)
    parts = dict(zip(rest[::2], (text.strip() for text in rest[1::2])))
    if rest[::2] != [part for part in PARTS if part in parts]:
        raise HeaderError(f"parts of a comment out of their order, or one twice: {comment!r}")
    return {"": description.strip(), **parts}


def joined(parts):
    """The comment of these parts, in their order: the description, an empty line, and a part a line."""
    rest = "\n".join(f"{part}: {parts[part]}" for part in PARTS if part in parts)
    return parts[""] + ("\n\n" + rest if rest else "")


def declaration(text):
    """{name, type, count?} of a field or a parameter; count is that of an array."""
    match = DECLARATION.fullmatch(" ".join(text.split()))
    if match is None:
        raise HeaderError(f"not a plain declaration: {text!r}")
    entry = {"name": match["name"], "type": match["base"] + (" " + match["stars"] if match["stars"] else "")}
    if match["count"]:
        entry["count"] = int(match["count"])
    return entry


def fields(body):
    """Fields of a struct, with their places by natural alignment, and the struct's size and alignment."""
    result, end, largest = [], 0, 1
    for line in filter(None, (part.strip() for part in body.split(";"))):
        first, *others = line.split(",")
        base = first.rsplit(" ", 1)[0]
        for text in [first] + [base + other for other in others]:
            field = declaration(text)
            size = POINTER_SIZE if "*" in field["type"] else SIZES.get(field["type"])
            if size is None:
                raise HeaderError(f"a field of a type whose size is not known: {text!r}")
            field["offset"] = -(-end // size) * size
            end = field["offset"] + size * field.get("count", 1)
            largest = max(largest, size)
            result.append(field)
    return {"size": -(-end // largest) * largest, "alignment": largest, "fields": result}


def struct(match, comment, header):
    if not comment:
        raise HeaderError(f"{match['name']} has no comment")
    return {"name": match["name"], "header": header, "comment": comment, **fields(match["body"])}


def function(match, comment, header):
    text = match["parameters"]
    return {"name": match["name"], "header": header,
            "returns": (match["returns"] + " " + match["stars"].replace(" ", "")).strip(),
            "parameters": [] if text == "void" else [declaration(part) for part in text.split(",")],
            "comment": comment}


def constant(match, comment, header):
    return {"name": match["name"], "header": header, "value": int(match["value"]),
            "comment": words(match["comment"]) or comment}


def constants_and_rest(text):
    """What the preprocessor would take away: constants are kept, other directives and what is for C++ or C11 go."""
    text = text.replace("\\\n", " ")
    text = re.sub(r"#(?:ifdef __cplusplus|if !defined\(__cplusplus\) &&[^\n]*)\n.*?#endif\n", "", text, flags=re.S)
    lines = []
    for line in text.split("\n"):
        macro = re.match(r"#define (\w+)(\(?)", line)
        if macro and not macro[2] and macro[1] not in NOT_CONSTANTS:
            lines.append(line)
        elif not line.startswith("#"):
            lines.append(line)
    return "\n".join(lines) + "\n"


def read(path):
    """All constants, structs and functions of a header, in its order."""
    found = {"constants": [], "structs": [], "functions": []}
    forms = ((CONSTANT, constant, "constants"), (STRUCT, struct, "structs"), (FUNCTION, function, "functions"))
    text = constants_and_rest(path.read_text(encoding="utf-8"))
    at, comment, heading = 0, "", {}
    while at < len(text):
        if text[at].isspace():
            at += 1
        elif text.startswith("/* ----", at):
            match = HEADING.match(text, at)
            heading = parted(words(match["parts"]))
            if heading.pop(""):
                raise HeaderError(f"{path.name}: a heading with more than parts: {match[0]!r}")
            at = match.end()
        elif text.startswith("/*", at):
            end = text.index("*/", at)
            comment = words(text[at + 3:end]) if text.startswith("/**", at) else ""
            at = end + 2
        else:
            for form, build, where in forms:
                match = form.match(text, at)
                if match:
                    break
            else:
                line = text[at:].split("\n", 1)[0]
                raise HeaderError(f"{path.name}: neither a constant, a struct nor a function: {line!r}")
            if where == "functions" and not REFERENCE.fullmatch(comment):
                comment = joined({**heading, **parted(comment)})
            found[where].append(build(match, comment, path.name))
            at, comment = match.end(), ""
    return found


def in_float(comment, rounded):
    """The comment of a double function or struct, for the float one of the same name."""
    parts = parted(comment.replace("_f64", "_f32").replace("sizeof(double)", "sizeof(float)"))
    if rounded:
        parts["Accuracy"] += ROUNDED
    return joined(parts)


def complete(found, definition):
    """Makes the comments of structs and functions complete, and takes from them since when a function is there."""
    entries = {entry["name"]: entry for entry in found["structs"] + found["functions"]}
    for entry in entries.values():
        reference = REFERENCE.fullmatch(entry["comment"])
        if reference:
            if reference[1].replace("_f64", "_f32") != entry["name"]:
                raise HeaderError(f"{entry['name']} refers to {reference[1]}")
            entry["comment"] = in_float(entries[reference[1]]["comment"], reference[2])
    for entry in found["functions"]:
        parts = parted(entry["comment"])
        if re.search(r"\d u\b", parts.get("Accuracy", "")):
            parts["Accuracy"] += "\n" + definition
        since = re.fullmatch(r"(\d+\.\d+)\.", parts.get("Since", ""))
        if since is None:
            raise HeaderError(f"{entry['name']}: neither its comment nor its heading says since when it is there")
        entry["since"], entry["comment"] = since[1], joined(parts)


def describe(directory=INCLUDE):
    """The description of all headers as one dictionary; its form is that of vesica.json."""
    found = {"constants": [], "structs": [], "functions": []}
    for header in HEADERS:
        for kind, entries in read(directory / header).items():
            found[kind] += entries
    opening = words((directory / HEADERS[0]).read_text(encoding="utf-8").split("*/", 1)[0].removeprefix("/*"))
    complete(found, " ".join(DEFINITION.search(opening)[1].split()))
    values = {entry["name"]: entry["value"] for entry in found["constants"]}
    version = [values["VESICA_VERSION_" + part] for part in ("MAJOR", "MINOR", "PATCH")]
    libraries = {header: f"{library}.so.{version[0]}" for header, library in LIBRARIES.items()}
    return {"libraries": libraries, "version": ".".join(map(str, version)),
            "pointer_size": POINTER_SIZE, **found}


def declared(entry):
    gap = "" if entry["type"].endswith("*") else " "
    return entry["type"] + gap + entry["name"] + (f"[{entry['count']}]" if "count" in entry else "")


def cdef(description, library):
    """Declarations of one library without a macro: one enum of all constants, structs, prototypes."""
    headers = [header for header in HEADERS if LIBRARIES[header] == library]
    own = {kind: [entry for entry in description[kind] if entry["header"] in headers]
           for kind in ("constants", "structs", "functions")}
    needed = "" if HEADERS[0] in headers else "; to be read after vesica.cdef"
    what = f"{headers[0]} says" if len(headers) == 1 else f"{' and '.join(headers)} say"
    lines = ["/* SPDX-License-Identifier: Apache-2.0 */",
             f"/* Vesica {description['version']} for cffi and LuaJIT: {description['libraries'][headers[0]]}{needed}.",
             f" * Written by tools/describe.py; {what} what each means. */", "", "enum {"]
    lines += [f"    {entry['name']} = {entry['value']}," for entry in own["constants"]]
    lines += ["};", ""]
    for entry in own["structs"]:
        lines += ["typedef struct {", *(f"    {declared(field)};" for field in entry["fields"]),
                  f"}} {entry['name']};", ""]
    for entry in own["functions"]:
        gap = "" if entry["returns"].endswith("*") else " "
        parameters = ", ".join(map(declared, entry["parameters"])) or "void"
        lines.append(f"{entry['returns']}{gap}{entry['name']}({parameters});")
    return "\n".join(lines) + "\n"


def texts():
    description = describe()
    return {CAPI / "vesica.json": json.dumps(description, indent=1, ensure_ascii=False) + "\n",
            **{CAPI / name: cdef(description, library) for library, name in CDEFS.items()}}


def check():
    fresh = True
    for path, text in texts().items():
        old = path.read_text(encoding="utf-8") if path.exists() else ""
        if old != text:
            fresh = False
            difference = difflib.unified_diff(old.split("\n"), text.split("\n"), path.name, "headers", n=1, lineterm="")
            print("\n".join(list(difference)[:40]))
    if not fresh:
        print("describe: not what the headers say; to write it anew: tools/refresh.sh")
    return fresh


def main(arguments):
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    try:
        if arguments:
            sys.exit(0 if check() else 1)
        for path, text in texts().items():
            path.write_text(text, encoding="utf-8")
    except HeaderError as error:
        sys.exit(f"describe: {error}")


if __name__ == "__main__":
    main(sys.argv[1:])
