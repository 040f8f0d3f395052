# SPDX-License-Identifier: Apache-2.0
"""table.py ROOT LCOV DETAILS EXCEPTIONS: coverage by folder, and what is not covered.

A line counts as reached, a branch as taken, and a condition as shown to decide alone (MC/DC), where any instantiation of
its template does (LCOV; branches and conditions by their columns, DETAILS). Clang 19 keeps no record of a decision that
chooses between objects of a class by ?:. So of a decision with && alone, or with || alone, the branches tell as well: there
a condition decides alone where it has ended the evaluation, and all have once been evaluated to the other end.
A condition that is constant in each instance llvm-cov has among the branches of the file, and of no instance of the
function: that is no branch and no condition here.
An exception is for its line and for the branches and conditions that leave from it.
"""

import collections
import json
import operator
import pathlib
import re
import sys


def read_lcov(path, root):
    """{file: {line: count}}, files relative to the root. Without lines that nothing runs: the preprocessor's, those of
    functions that only the compiler may call, and of blocks that it alone enters."""
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
        if end is None and re.match(r"\s*if \(std::is_constant_evaluated\(\).*\{", line):
            end = indent + "}"
        if end is not None and (line.startswith(end) or (line.startswith(end[:-1]) and line.endswith("}") and "{" in line)):
            end = None
    return numbers


def read_details(path, root):
    """({file: {(line, column, way): count}}, {file: {(place of the decision, number): whether a condition is shown}}). A
    branch has two ways."""
    branches, conditions = {}, {}
    data = json.load(open(path))["data"][0]
    for file in data["files"]:
        name = str(pathlib.Path(file["filename"]).relative_to(root))
        taken = branches.setdefault(name, {})
        conditions[name] = {}
        for line, column, _, _, when_true, when_false, *_ in file["branches"]:
            for way, count in ((True, when_true), (False, when_false)):
                taken[line, column, way] = taken.get((line, column, way), 0) + count
    texts = {name: (pathlib.Path(root) / name).read_text().splitlines() for name in conditions}
    constant = take_constants(data["functions"], branches, root)
    for function in data["functions"]:
        path = pathlib.Path(function["filenames"][0])
        name = str(path.relative_to(root)) if path.is_relative_to(root) else ""
        if name not in conditions:
            continue
        known = [(place, None) for place in constant[name]]
        for *begin_and_end, _, _, recorded in function["mcdc_records"]:
            begin, end = tuple(begin_and_end[:2]), tuple(begin_and_end[2:])
            within = sorted([(tuple(b[:2]), b[4:6]) for b in function["branches"]
                             if b[6] == 0 and begin <= tuple(b[:2]) and tuple(b[2:4]) <= end]
                            + [(place, count) for place, count in known if begin <= place < end])
            if len(within) != len(recorded):  # an operand has branches of its own, or is constant in this instance alone
                within = [(begin, (0, 0) if len(within) > len(recorded) else None)] * len(recorded)
            counts = [count for _, count in within if count]
            told = iter(by_branches(text_between(texts[name], begin, end), counts))
            for number, (shown, (_, count)) in enumerate(zip(recorded, within)):
                if count:
                    shown = next(told) or shown
                    conditions[name][begin, number] = conditions[name].get((begin, number), False) or shown
    return branches, conditions


def take_constants(functions, branches, root):
    """Removes the branches of what is constant, and returns their places: {file: {(line, column)}}."""
    counted = collections.defaultdict(set)
    for function in functions:
        for branch in function["branches"]:
            counted[function["filenames"][branch[6]]].add(tuple(branch[:2]))
    constant = {}
    for name, taken in branches.items():
        constant[name] = {way[:2] for way in taken} - counted[str(pathlib.Path(root) / name)]
        branches[name] = {way: count for way, count in taken.items() if way[:2] not in constant[name]}
    return constant


def text_between(lines, begin, end):
    """From one place to another, counted from 1, the end not among it."""
    first, last = lines[begin[0] - 1], lines[end[0] - 1]
    if begin[0] == end[0]:
        return first[begin[1] - 1:end[1] - 1]
    return "\n".join([first[begin[1] - 1:], *lines[begin[0]:end[0] - 1], last[:end[1] - 1]])


def by_branches(text, counts):
    """Of the conditions of one decision, in order, with how often each was true and false: whether each decided alone. No
    answer where operators are mixed."""
    operators = set(re.findall(r"&&|\|\|", text))
    if operators not in ({"&&"}, {"||"}):
        return [False] * len(counts)
    end, on = (1, 0) if operators == {"&&"} else (0, 1)
    return [c[end] > 0 and counts[-1][on] > 0 for c in counts]


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
    tallies, missed, untaken, unshown = collections.defaultdict(lambda: [0] * 6), [], [], []
    forgiven = [0, 0, 0]
    for file, lines in sorted(files.items()):
        text = (pathlib.Path(root) / file).read_text().splitlines()
        unreached = [line for line, count in lines.items() if count == 0]
        branches[file] = {way: count for way, count in branches[file].items() if way[0] in lines}
        open_branches = [place for place, count in branches[file].items() if count == 0]
        shown = {condition: met for condition, met in conditions[file].items() if condition[0][0] in lines}
        hidden = [place for place, is_shown in shown.items() if not is_shown]
        n, b, c = len(lines), len(branches[file]), len(shown)
        for tally in (tallies[folder_of(file)], tallies["all"]):
            tally[:] = map(sum, zip(tally, [n, n - len(unreached), b, b - len(open_branches), c, c - len(hidden)]))
        forgiven = [count + sum((file, text[line - 1].strip()) in excused for line in lines) for count, lines in zip(
            forgiven, (unreached, [place[0] for place in open_branches], [begin[0] for begin, _ in hidden]))]
        listed = [(line, missed) for line in unreached]
        # A line that is not reached has no branch that is taken: it is listed once.
        untaken_lines = {line for line, _, _ in open_branches} - set(unreached)
        listed += [(line, untaken) for line in untaken_lines]
        listed += [(line, unshown) for line in {begin[0] for begin, _ in hidden} - untaken_lines - set(unreached)]
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
    n, b, c = n - forgiven[0], b - forgiven[1], c - forgiven[2]
    print(f"{'all but exceptions':40} {n:7} {share(reached, n)} {b:7} {share(taken, b)} {c:7} {share(met, c)}")
    for place in sorted(excused - used):
        print(f"no longer an exception: {' | '.join(place)}")
    print(f"{len(missed)} lines are not reached:")
    print("\n".join(missed))
    print(f"{len(untaken)} lines that are reached have a branch that is never taken:")
    print("\n".join(untaken))
    print(f"{len(unshown)} more lines have a condition that never decides alone:")
    print("\n".join(unshown))
    sys.exit(1 if missed or untaken or unshown or excused - used else 0)


if __name__ == "__main__":
    main()
