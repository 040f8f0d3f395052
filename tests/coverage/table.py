# SPDX-License-Identifier: Apache-2.0
"""table.py ROOT LCOV DETAILS EXCEPTIONS: coverage by folder, and what is not covered.

A line counts as reached, and a branch as taken, where any instantiation of its template does (LCOV; branches by their
column, DETAILS). Conditions (MC/DC) are those of the instantiation that reaches most, which is all that llvm-cov tells.
An exception is for its line and for the branches that leave from it.
"""

import collections
import json
import pathlib
import re
import sys


def read_lcov(path, root):
    """{file: {line: count}}, files relative to the root. Without lines that nothing runs: the preprocessor's, and those of
    functions that only the compiler may call."""
    files, lines = {}, {}
    for record in open(path):
        key, _, value = record.strip().partition(":")
        if key == "SF":
            lines = files.setdefault(str(pathlib.Path(value).relative_to(root)), {})
        elif key == "DA":
            line, count = value.split(",")[:2]
            lines[int(line)] = lines.get(int(line), 0) + int(count)
    for name, lines in files.items():
        for line in never_run((pathlib.Path(root) / name).read_text().splitlines()):
            lines.pop(line, None)
    return files


def never_run(text):
    """Numbers of lines."""
    numbers, end = set(), None
    for number, line in enumerate(text, 1):
        indent = line[:len(line) - len(line.lstrip())]
        if end is None and re.match(r"\s*(static |inline )*consteval ", line):
            end = indent + "}"
        if end is not None or line.startswith("#"):
            numbers.add(number)
        if end is not None and (line == end or (line.startswith(end[:-1]) and line.endswith("}") and "{" in line)):
            end = None
    return numbers


def read_details(path, root):
    """({file: {(line, column, way): count}}, {file: [conditions, covered]}). A branch has two ways."""
    branches, conditions = {}, {}
    for file in json.load(open(path))["data"][0]["files"]:
        name = str(pathlib.Path(file["filename"]).relative_to(root))
        taken = branches.setdefault(name, {})
        for line, column, _, _, when_true, when_false, *_ in file["branches"]:
            for way, count in ((True, when_true), (False, when_false)):
                taken[line, column, way] = taken.get((line, column, way), 0) + count
        conditions[name] = [file["summary"]["mcdc"][n] for n in ("count", "covered")]
    return branches, conditions


def read_exceptions(path):
    """The pairs of file and text of a line that need not be reached; the rest of a record is the proof."""
    records = [line.rstrip("\n").split(" | ") for line in open(path) if line.strip() and not line.startswith("#")]
    return {(record[0], record[1]) for record in records}


def folder_of(file):
    parts = pathlib.PurePath(file).parts[:-1]
    return "/".join(parts[:3])


def share(covered, count):
    return f"{100 * covered / count:6.2f}%" if count else "      -"


def main():
    root, lcov, details, exceptions = sys.argv[1:]
    files, (branches, conditions) = read_lcov(lcov, root), read_details(details, root)
    excused, used = read_exceptions(exceptions), set()
    tallies, missed, untaken = collections.defaultdict(lambda: [0] * 6), [], []
    for file, lines in sorted(files.items()):
        text = (pathlib.Path(root) / file).read_text().splitlines()
        unreached = [line for line, count in lines.items() if count == 0]
        open_branches = [place for place, count in branches[file].items() if count == 0]
        n, b = len(lines), len(branches[file])
        for tally in (tallies[folder_of(file)], tallies["all"]):
            tally[:] = map(sum, zip(tally, [n, n - len(unreached), b, b - len(open_branches), *conditions[file]]))
        listed = [(line, missed) for line in unreached]
        # A line that is not reached has no branch that is taken: it is listed once.
        listed += [(line, untaken) for line in {line for line, _, _ in open_branches} - set(unreached)]
        for line, those in sorted(listed, key=lambda pair: pair[0]):
            place = (file, text[line - 1].strip())
            if place in excused:
                used.add(place)
            else:
                those.append(f"{file}:{line}: {place[1]}")
    print(f"{'folder':40} {'lines':>15} {'branches':>15} {'conditions':>15}")
    for folder in sorted(tallies, key=lambda name: (name == "all", name)):
        n, reached, b, taken, c, met = tallies[folder]
        print(f"{folder:40} {n:7} {share(reached, n)} {b:7} {share(taken, b)} {c:7} {share(met, c)}")
    for place in sorted(excused - used):
        print(f"no longer an exception: {' | '.join(place)}")
    print(f"{len(missed)} lines are not reached:")
    print("\n".join(missed))
    print(f"{len(untaken)} lines that are reached have a branch that is never taken:")
    print("\n".join(untaken))
    sys.exit(1 if missed or untaken or excused - used else 0)


if __name__ == "__main__":
    main()
