#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes c.d.ts, TypeScript's view of the WebAssembly module, and constants.mjs from ../capi/vesica.json.

declare.py          writes them
declare.py --check  exits with 1 if one is not what the description says
"""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
DESCRIPTION = HERE.parent / "capi" / "vesica.json"
# The named methods are another library, which the module does not have.
HEADERS = ("vesica.h", "vesica_index.h", "vesica_motion.h")
HEAD = "// SPDX-License-Identifier: Apache-2.0\n// Written by declare.py from capi/vesica.json: not to be edited.\n"


def type_of(declaration):
    """Pointers are addresses in the module's memory."""
    kind = declaration["type"].removeprefix("const ")
    return "bigint" if kind == "int64_t" and "count" not in declaration else "number"


def comment(text, indent):
    lines = "\n".join(f"{indent} * {line}".rstrip() for line in text.split("\n"))
    return f"{indent}/**\n{lines}\n{indent} */\n"


def function(entry):
    parameters = ", ".join(f"{parameter['name']}: {type_of(parameter)}" for parameter in entry["parameters"])
    return f"{comment(entry['comment'], '  ')}  {entry['name']}({parameters}): {type_of({'type': entry['returns']})};\n"


def constant(entry):
    about = f"/** {entry['comment']} */\n" if entry["comment"] else ""
    return f"{about}export const {entry['name'].removeprefix('VESICA_')} = {entry['value']};\n"


def files():
    description = json.loads(DESCRIPTION.read_text())
    functions = [function(entry) for entry in description["functions"] if entry["header"] in HEADERS]
    constants = [constant(entry) for entry in description["constants"] if entry["header"] in HEADERS]
    about = comment("The module's exports: the C library. Pointers are addresses in `memory`, int64_t are bigint.", "")
    return {
        HERE / "c.d.ts": f"{HEAD}\n{about}export interface C {{\n  memory: WebAssembly.Memory;\n" + "".join(functions) + "}\n",
        HERE / "constants.mjs": HEAD + "\n" + "".join(constants),
    }


def main(arguments):
    stale = [path for path, text in files().items() if not path.exists() or path.read_text() != text]
    if arguments == ["--check"]:
        for path in stale:
            print(f"{path} is not what {DESCRIPTION} says: run capi/refresh.sh", file=sys.stderr)
        return bool(stale)
    for path in stale:
        path.write_text(files()[path])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
