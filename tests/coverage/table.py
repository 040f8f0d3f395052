# SPDX-License-Identifier: Apache-2.0
"""table.py ROOT LCOV SUMMARY EXCEPTIONS: coverage by folder, and what is not covered.

Lines and branches are counted over all instantiations of a template, from LCOV. Conditions (MC/DC) are of the
instantiation that reaches most, from SUMMARY: that is what llvm-cov gives.
"""

import collections
import json
import pathlib
import sys


def read_lcov(path, root):
    """{file: ({line: count}, {branch: count})}, files relative to the root."""
    files, lines, branches = {}, {}, {}
    for record in open(path):
        key, _, value = record.strip().partition(":")
        if key == "SF":
            lines, branches = files.setdefault(str(pathlib.Path(value).relative_to(root)), ({}, {}))
        elif key == "DA":
            line, count = value.split(",")[:2]
            lines[int(line)] = lines.get(int(line), 0) + int(count)
        elif key == "BRDA":
            line, block, branch, count = value.split(",")
            place = (int(line), block, branch)
            branches[place] = branches.get(place, 0) + (0 if count == "-" else int(count))
    return files


def read_conditions(path, root):
    """{file: (conditions, covered)}."""
    files = json.load(open(path))["data"][0]["files"]
    return {
        str(pathlib.Path(f["filename"]).relative_to(root)): (f["summary"]["mcdc"]["count"], f["summary"]["mcdc"]["covered"])
        for f in files
    }


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
    root, lcov, summary, exceptions = sys.argv[1:]
    files, conditions, excused = read_lcov(lcov, root), read_conditions(summary, root), read_exceptions(exceptions)
    tallies, missed, used = collections.defaultdict(lambda: [0] * 6), [], set()
    for file, (lines, branches) in sorted(files.items()):
        text = (pathlib.Path(root) / file).read_text().splitlines()
        unreached = [line for line, count in lines.items() if count == 0]
        met, count = conditions.get(file, (0, 0))[1], conditions.get(file, (0, 0))[0]
        for tally in (tallies[folder_of(file)], tallies["all"]):
            for i, n in enumerate((len(lines), len(lines) - len(unreached), len(branches),
                                   sum(c > 0 for c in branches.values()), count, met)):
                tally[i] += n
        for line in sorted(unreached):
            place = (file, text[line - 1].strip())
            if place in excused:
                used.add(place)
            else:
                missed.append(f"{file}:{line}: {place[1]}")
    print(f"{'folder':40} {'lines':>15} {'branches':>15} {'conditions':>15}")
    for folder in sorted(tallies, key=lambda name: (name == "all", name)):
        n, reached, b, taken, c, met = tallies[folder]
        print(f"{folder:40} {n:7} {share(reached, n)} {b:7} {share(taken, b)} {c:7} {share(met, c)}")
    for place in sorted(excused - used):
        print(f"no longer an exception: {' | '.join(place)}")
    print(f"{len(missed)} lines are not reached:")
    print("\n".join(missed))
    sys.exit(1 if missed or excused - used else 0)


if __name__ == "__main__":
    main()
