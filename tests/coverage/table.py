# SPDX-License-Identifier: Apache-2.0
"""table.py ROOT LCOV SUMMARY EXCEPTIONS: coverage by folder, and what is not covered.

A line counts as reached where any instantiation of its template reaches it (LCOV). Branches and conditions (MC/DC) are
those of the instantiation that reaches most (SUMMARY), which is all that llvm-cov tells.
"""

import collections
import json
import pathlib
import sys


def read_lcov(path, root):
    """{file: {line: count}}, files relative to the root."""
    files, lines = {}, {}
    for record in open(path):
        key, _, value = record.strip().partition(":")
        if key == "SF":
            lines = files.setdefault(str(pathlib.Path(value).relative_to(root)), {})
        elif key == "DA":
            line, count = value.split(",")[:2]
            lines[int(line)] = lines.get(int(line), 0) + int(count)
    return files


def read_summary(path, root):
    """{file: [branches, taken, conditions, covered]}."""
    files = json.load(open(path))["data"][0]["files"]
    return {
        str(pathlib.Path(f["filename"]).relative_to(root)): [
            f["summary"][kind][n] for kind in ("branches", "mcdc") for n in ("count", "covered")
        ]
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
    files, summaries, excused = read_lcov(lcov, root), read_summary(summary, root), read_exceptions(exceptions)
    tallies, missed, used = collections.defaultdict(lambda: [0] * 6), [], set()
    for file, lines in sorted(files.items()):
        text = (pathlib.Path(root) / file).read_text().splitlines()
        unreached = [line for line, count in lines.items() if count == 0]
        numbers = [len(lines), len(lines) - len(unreached), *summaries[file]]
        for tally in (tallies[folder_of(file)], tallies["all"]):
            tally[:] = map(sum, zip(tally, numbers))
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
