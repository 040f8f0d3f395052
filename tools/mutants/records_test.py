# SPDX-License-Identifier: Apache-2.0
"""records_test.py RECORDS: each record of harmless.txt is of a line that its file still has, and none is there twice. A
record whose line has changed names no mutant, and its proof may no longer hold."""

import pathlib
import re
import sys

import records

HERE = pathlib.Path(__file__).parent


def as_written(marked):
    """Every line that may have been marked so: if (a {{< -> <=}} b). Braces and arrows may be of the line itself."""
    for begin in re.finditer(r"\{\{", marked):
        for arrow in re.finditer(" -> ", marked[begin.end():]):
            rest = marked[begin.end() + arrow.end():]
            for end in re.finditer(r"\}\}", rest):
                yield marked[:begin.start()] + marked[begin.end():begin.end() + arrow.start()] + rest[end.end():]


def main():
    named = [(file, line) for file, line, _ in records.read(pathlib.Path(sys.argv[1]))]
    texts, faults = {}, [] if named else ["no records"]
    for file, line in named:
        if file not in texts:
            path = HERE.parent.parent / file
            texts[file] = " ".join(path.read_text().split()) if path.exists() else ""
        if not any(" ".join(line.split()) in texts[file] for line in as_written(line)):
            faults.append(f"no such line: {file}\n  {line}")
        if named.count((file, line)) > 1:
            faults.append(f"more than once: {file}\n  {line}")
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
