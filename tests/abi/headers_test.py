# SPDX-License-Identifier: Apache-2.0
"""headers_test.py LIBRARY: the headers, the version script, the library and tests/capi agree, with nothing left out.

What exists is taken from the headers (capi/describe.py), so that what is added later is checked without a new line.
"""
import ctypes
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "capi"))
import describe  # noqa: E402

failures = []


def expect(condition, message):
    if not condition:
        failures.append(message)


def nodes_of_map():
    """{name: release} of every exported name."""
    result, release = {}, None
    for line in (ROOT / "capi/vesica.map").read_text().split("\n"):
        node = re.match(r"VESICA_(\d+\.\d+) \{", line)
        name = re.fullmatch(r" +(vesica_\w+);", line)
        if node:
            release = node[1]
        elif name:
            expect(name[1] not in result, f"{name[1]} is in vesica.map twice")
            result[name[1]] = release
    return result


def functions_are_exported(description, nodes):
    declared = {entry["name"]: entry["since"] for entry in description["functions"]}
    for name in declared.keys() | nodes.keys():
        expect(name in declared, f"{name} is in vesica.map, but in no header")
        expect(name in nodes, f"{name} is in a header, but not in vesica.map")
        expect(declared.get(name) == nodes.get(name),
               f"{name}: since {declared.get(name)} in its header, at the node of {nodes.get(name)} in vesica.map")


def constants_are_functions(description, library):
    declared = {entry["name"]: entry for entry in description["functions"]}
    for entry in description["constants"]:
        function = declared.get(entry["function"])
        if function is None or (function["returns"], function["parameters"]) != ("int32_t", []):
            expect(False, f"{entry['name']} has no function int32_t {entry['function']}(void)")
        elif not hasattr(library, entry["function"]):
            expect(False, f"{entry['function']} is not in the library")
        else:
            value = getattr(library, entry["function"])()
            expect(value == entry["value"], f"{entry['name']} is {entry['value']}, its function returns {value}")


def structs_are_pinned(description):
    """Their sizes and offsets are literals in tests/capi; none may be left out there."""
    text = "".join(path.read_text() for path in sorted((ROOT / "tests/capi").glob("*.cpp")))
    for entry in description["structs"]:
        pinned = re.search(rf"EXPECT_EQ\(sizeof\({entry['name']}\), (\d+)u\)", text)
        expect(pinned, f"tests/capi/*.cpp does not say EXPECT_EQ(sizeof({entry['name']}), {entry['size']}u)")
        expect(not pinned or int(pinned[1]) == entry["size"],
               f"{entry['name']} has {entry['size']} bytes, tests/capi says otherwise")


def main(path):
    description = describe.describe()
    expect(len(description["constants"]) >= 19 and len(description["structs"]) >= 14, "the headers were not understood")
    functions_are_exported(description, nodes_of_map())
    constants_are_functions(description, ctypes.CDLL(path))
    structs_are_pinned(description)
    for failure in failures:
        print(failure)
    counts = ", ".join(f"{len(description[key])} {key}" for key in ("functions", "constants", "structs"))
    print(counts + (f": {len(failures)} disagree" if failures else ": all agree"))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
