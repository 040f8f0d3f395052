# SPDX-License-Identifier: Apache-2.0
"""table.py ROOT LCOV SUMMARY EXCEPTIONS: coverage by folder, and what is not covered.

A line counts as reached, and a branch as taken, where any instantiation of its template does (LCOV). Conditions (MC/DC) are
those of the instantiation that reaches most (SUMMARY), which is all that llvm-cov tells. An exception is for its line and
for the branches that leave from it.
"""

import collections
import json
import pathlib
import sys


def read_lcov(path, root):
    """({file: {line: count}}, {file: {(line, branch): count}}), files relative to the root."""
    files, branches = {}, {}
    for record in open(path):
        key, _, value = record.strip().partition(":")
        if key == "SF":
            name = str(pathlib.Path(value).relative_to(root))
            lines, taken = files.setdefault(name, {}), branches.setdefault(name, {})
        elif key == "DA":
            line, count = value.split(",")[:2]
            lines[int(line)] = lines.get(int(line), 0) + int(count)
        elif key == "BRDA":
            line, block, branch, count = value.split(",")
            place = int(line), f"{block}.{branch}"
            taken[place] = taken.get(place, 0) + (0 if count == "-" else int(count))
    return files, branches


def read_summary(path, root):
    """{file: [conditions, covered]}."""
    files = json.load(open(path))["data"][0]["files"]
    return {
        str(pathlib.Path(f["filename"]).relative_to(root)): [f["summary"]["mcdc"][n] for n in ("count", "covered")]
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
    (files, branches), summaries = read_lcov(lcov, root), read_summary(summary, root)
    excused, used = read_exceptions(exceptions), set()
    tallies, missed, untaken = collections.defaultdict(lambda: [0] * 6), [], []
    for file, lines in sorted(files.items()):
        text = (pathlib.Path(root) / file).read_text().splitlines()
        unreached = [line for line, count in lines.items() if count == 0]
        open_branches = [place for place, count in branches[file].items() if count == 0]
        n, b = len(lines), len(branches[file])
        for tally in (tallies[folder_of(file)], tallies["all"]):
            tally[:] = map(sum, zip(tally, [n, n - len(unreached), b, b - len(open_branches), *summaries[file]]))
        listed = [(line, missed) for line in unreached]
        # A line that is not reached has no branch that is taken: it is listed once.
        listed += [(line, untaken) for line in {line for line, _ in open_branches} - set(unreached)]
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
