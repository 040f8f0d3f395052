# SPDX-License-Identifier: Apache-2.0
"""headers_test.py LIBRARY METHODS: headers, version scripts, libraries and tests/capi agree, with nothing left out.

What exists is taken from the headers (tools/describe.py), so that what is added later is checked without a new line.
"""
import ctypes
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import describe  # noqa: E402

failures = []


def expect(condition, message):
    if not condition:
        failures.append(message)


def nodes_of_map(name):
    """{name: release} of every exported name."""
    result, release = {}, None
    for line in (ROOT / "capi" / name).read_text().split("\n"):
        node = re.match(r"VESICA(?:_METHODS)?_(\d+\.\d+) \{", line)
        function = re.fullmatch(r" +(vesica_\w+);", line)
        if node:
            release = node[1]
        elif function:
            expect(function[1] not in result, f"{function[1]} is in {name} twice")
            result[function[1]] = release
    return result


def functions_are_exported(description, where, library):
    """Of one library, whose version script is `where`: all its headers together."""
    headers = [header for header in describe.HEADERS if describe.MAPS[header] == where]
    nodes = nodes_of_map(where)
    declared = {entry["name"]: entry["since"] for entry in description["functions"] if entry["header"] in headers}
    for name in declared.keys() | nodes.keys():
        expect(name in declared, f"{name} is in {where}, but not in {' or '.join(headers)}")
        expect(name in nodes, f"{name} is in {' or '.join(headers)}, but not in {where}")
        expect(declared.get(name) == nodes.get(name),
               f"{name}: since {declared.get(name)} in its header, at the node of {nodes.get(name)} in {where}")
        expect(hasattr(library, name), f"{name} is not in the library")


def constants_agree(description):
    """A header's own text, vesica.json and the declarations hold the same constants. None of them is a function."""
    described = json.loads((ROOT / "capi/vesica.json").read_text())["constants"]
    functions = {entry["name"] for entry in description["functions"]}
    of_library = {}
    for header in describe.HEADERS:
        path = ROOT / "capi/include" / header
        written = dict(re.findall(r"^#define (VESICA_\w+)[ (]+(-?\d+)", path.read_text(), re.M))
        listed = {entry["name"]: str(entry["value"]) for entry in described if entry["header"] == header}
        expect(written, f"{header} has no constants")
        of_library.setdefault(describe.CDEFS[describe.LIBRARIES[header]], {}).update(written)
        for name in written.keys() | listed.keys():
            values = written.get(name), listed.get(name)
            expect(len(set(values)) == 1, f"{name}: header and vesica.json say {values}")
            expect(name.startswith("VESICA_VERSION") or name.lower() not in functions, f"{name} is a function too")
    for name, written in of_library.items():
        text = (ROOT / "capi" / name).read_text()
        declared = dict(re.findall(r"^    (VESICA_\w+) = (-?\d+),$", text, re.M))
        differ = sorted(dict(written.items() ^ declared.items()))
        expect(not differ, f"{name} and its headers disagree on {differ}")


def structs_are_pinned(description):
    """Their sizes and offsets are literals in tests/capi; none may be left out there."""
    text = "".join(path.read_text() for path in sorted((ROOT / "tests/capi").glob("*.cpp")))
    for entry in description["structs"]:
        pinned = re.search(rf"EXPECT_EQ\(sizeof\({entry['name']}\), (\d+)u\)", text)
        expect(pinned, f"tests/capi/*.cpp does not say EXPECT_EQ(sizeof({entry['name']}), {entry['size']}u)")
        expect(not pinned or int(pinned[1]) == entry["size"],
               f"{entry['name']} has {entry['size']} bytes, tests/capi says otherwise")


def main(*libraries):
    description = describe.describe()
    expect(len(description["constants"]) >= 19 and len(description["structs"]) >= 14, "the headers were not understood")
    for where, library in zip(dict.fromkeys(describe.MAPS.values()), libraries, strict=True):
        functions_are_exported(description, where, ctypes.CDLL(library))
    constants_agree(description)
    structs_are_pinned(description)
    for failure in failures:
        print(failure)
    counts = ", ".join(f"{len(description[key])} {key}" for key in ("functions", "constants", "structs"))
    print(counts + (f": {len(failures)} disagree" if failures else ": all agree"))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
