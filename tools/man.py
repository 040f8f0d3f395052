#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes section 3 man pages from the comments of the headers: one for every function, one for every header.

man.py DIRECTORY

The functions are those of the version scripts, all of them: one without a page, or a page without one, is an error.
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
import describe  # noqa: E402 (it stands beside this file, which must stay free of __pycache__)

# Sections of a page, by the parts of a comment.
SECTIONS = {"": "DESCRIPTION", "Requires": "REQUIREMENTS", "Returns": "RETURN VALUE", "Errors": "ERRORS",
            "Accuracy": "ACCURACY", "Cost": "COST", "Since": "HISTORY"}


def escaped(text):
    """Text as roff prints it literally; a minus sign is one, a hyphen within a word stays a hyphen."""
    text = text.replace("\\", "\\e").replace("^", "\\(ha").replace("~", "\\(ti").replace("`", "\\(ga")
    text = re.sub(r"(?<![A-Za-z0-9])-|-(?=>)|(?<=\+)-", r"\\-", text)
    return text.replace("'", "\\(aq")


def filled(text):
    """A paragraph that roff fills: constants and the project's functions in bold."""
    text = re.sub(r"(?<![\w<>/])((?:VESICA|vesica)_\w+)(?![\w>])", r"\\fB\1\\fR", escaped(" ".join(text.split())))
    return re.sub(r"^(?=[.])", r"\\&", text)


def literal(lines):
    return [".nf", *(re.sub(r"^(?=[.])", r"\\&", escaped(line)) for line in lines), ".fi"]


def titled(name, summary, version):
    return [f'.TH {name} 3 "" "Vesica {version}" "Vesica manual"', ".SH NAME", f"{name} \\- {filled(summary)}"]


def written_struct(entry):
    return ["typedef struct {", *(f"    {describe.declared(field)};" for field in entry["fields"]),
            f"}} {entry['name']};"]


def prototype(entry):
    gap = "" if entry["returns"].endswith("*") else " "
    opening = entry["returns"] + gap + entry["name"] + "("
    parameters = [describe.declared(parameter) for parameter in entry["parameters"]] or ["void"]
    if len(opening) + len(", ".join(parameters)) < 74:
        return [opening + ", ".join(parameters) + ");"]
    return [opening, *(f"    {parameter}," for parameter in parameters[:-1]), f"    {parameters[-1]});"]


def summary_of(text):
    """One phrase for NAME: the first sentence, up to a colon if it is long."""
    first = re.split(r"(?<=[^.][.?])\s", " ".join(text.split("\n\n")[0].split()))[0].rstrip(".")
    return first.split(":")[0] if len(first) > 80 else first


def library(header):
    """The lines of the section on the library that a header belongs to."""
    name = describe.LIBRARIES[header]
    return [".SH LIBRARY", f"Vesica (\\fI{escaped(name)}\\fR, \\fI\\-l{escaped(name.removeprefix('lib'))}\\fR)"]


def capitalised(text):
    return text[:1].upper() + text[1:]


def page(entry, description):
    parts = describe.parted(entry["comment"])
    used = {parameter["type"].replace("const ", "").rstrip(" *") for parameter in entry["parameters"]}
    lines = titled(entry["name"], summary_of(parts[""]), description["version"])
    lines += library(entry["header"]) + [".SH SYNOPSIS"]
    lines += literal([f"#include <{entry['header']}>"])
    for struct in description["structs"]:
        if struct["name"] in used:
            lines += [".PP", *literal(written_struct(struct))]
    lines += [".PP", *literal(prototype(entry))]
    parts[""] += "\n\nvesica(3) has the rules that hold for every function."
    parts["Since"] = "since Vesica " + parts["Since"]
    for part, body in parts.items():
        title = SECTIONS[part]
        lines.append(f".SH {title}" if " " not in title else f'.SH "{title}"')
        for number, paragraph in enumerate(re.split(r"\n\s*\n", body)):
            lines += ([".PP"] if number else []) + [filled(capitalised(paragraph) if part else paragraph)]
    others = [pathlib.PurePath(header).stem for header in describe.HEADERS]
    return lines + [".SH SEE ALSO", ", ".join(f"\\fB{other}\\fR(3)" for other in others)]


def overview(header, text, description):
    """The page of a header: its opening comment, constants, types, and what functions there are."""
    name = pathlib.PurePath(header).stem
    opening = describe.words(re.match(r"/\*(.*?)\*/", text, re.S)[1])
    title, *rest = (part for part in re.split(r"\n\s*\n", opening) if not part.startswith("SPDX-"))
    lines = titled(name, title.split(": ", 1)[1].rstrip("."), description["version"])
    lines += library(header) + [".SH SYNOPSIS", *literal([f"#include <{header}>"]), ".SH DESCRIPTION"]
    for number, part in enumerate(re.split(r"\n(?= *- )", "\n\n".join(rest))):
        for again, paragraph in enumerate(re.split(r"\n\s*\n", part)):
            bullet = re.match(r" *- ", paragraph)
            lines += [".IP \\(bu 2"] if bullet else [".PP"] if number or again else []
            lines.append(filled(paragraph[bullet.end():] if bullet else paragraph))
    own = {kind: [entry for entry in description[kind] if entry["header"] == header]
           for kind in ("constants", "structs", "functions")}
    lines.append(".SH CONSTANTS")
    for entry in own["constants"]:
        lines += [".TP", f".BR {entry['name']} \" = {escaped(str(entry['value']))}\"", filled(entry["comment"]) or "\\&"]
    if own["structs"]:
        lines.append(".SH TYPES")
    for entry in own["structs"]:
        lines += [".PP", filled(entry["comment"]), ".PP", *literal(written_struct(entry))]
    if own["functions"]:
        lines += [".SH FUNCTIONS", "Each has a page of its own."]
    for entry in own["functions"]:
        lines += [".TP", f".BR {entry['name']} (3)", filled(summary_of(entry["comment"]))]
    others = [pathlib.PurePath(other).stem for other in describe.HEADERS if other != header]
    return lines + [".SH SEE ALSO", *(f".BR {other} (3)" for other in others)]


def pages():
    """{name: lines} of all pages."""
    description = describe.describe()
    texts = {header: (describe.INCLUDE / header).read_text(encoding="utf-8") for header in describe.HEADERS}
    result = {entry["name"]: page(entry, description) for entry in description["functions"]}
    maps = "".join((describe.CAPI / name).read_text(encoding="utf-8") for name in describe.MAPS.values())
    exported = set(re.findall(r"^\s+(vesica_\w+);", maps, re.M))
    if exported != set(result):
        raise describe.HeaderError(f"in only one of the maps and the headers: {sorted(exported ^ set(result))}")
    result.update((pathlib.PurePath(header).stem, overview(header, text, description))
                  for header, text in texts.items())
    return result


def main(arguments):
    if len(arguments) != 1 or arguments[0].startswith("-"):
        sys.exit(__doc__)
    directory = pathlib.Path(arguments[0])
    directory.mkdir(parents=True, exist_ok=True)
    try:
        for name, lines in pages().items():
            (directory / f"{name}.3").write_text("\n".join(lines) + "\n", encoding="utf-8")
    except describe.HeaderError as error:
        sys.exit(f"man: {error}")


if __name__ == "__main__":
    main(sys.argv[1:])
