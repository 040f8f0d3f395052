# SPDX-License-Identifier: Apache-2.0
"""A sample of candidates, and the sources with each of them switched by ::vesica_mutant::is(number)."""

import collections
import random
import re

# A header of the system's gives no warnings: a mutant need not please them.
PREFIX = b"#pragma GCC system_header\n#include <vesica_mutant.hpp>\n"
ADDED_LINES = PREFIX.count(b"\n")
EFFECT = re.compile(r"\+\+|--|[^=!<>]=[^=]|<<=|>>=")
DIVISION = re.compile(r"/|%")


def sample(candidates, count, seed):
    """At most `count` that do not overlap, each file having its share, numbered from 1."""
    drawn = list(candidates)
    random.Random(seed).shuffle(drawn)
    taken, chosen = collections.defaultdict(list), []
    for c in drawn:
        if len(chosen) == count:
            break
        if all(c["end"] <= a or b <= c["begin"] for a, b in taken[c["file"]]):
            taken[c["file"]].append((c["begin"], c["end"]))
            chosen.append(c)
    chosen.sort(key=lambda c: (c["file"], c["begin"]))
    return [dict(c, number=i + 1) for i, c in enumerate(chosen)]


def in_a_line(text):
    return " ".join(line.split("//")[0].strip() for line in text.split("\n"))


def can_be_evaluated_twice(c):
    """Whether the change may be tried beside the original: it does nothing but give a value, and cannot trap."""
    quiet = c["kind"] in ("comparison", "extremum") or c["kind"] == "arithmetic" and not DIVISION.search(c["original"] + c["mutated"])
    return quiet and not c["changes"] and not EFFECT.search(c["original"])


def switched(c):
    """The text that takes the place of a candidate's: no line more and none less."""
    test = f"::vesica_mutant::is({c['number']})"
    if c["form"] == "condition":
        return f"({test} != static_cast<bool>({c['original']}))"
    if c["form"] == "statement":
        return f"if ({test}) {{}} else {c['original']}"
    mutated = in_a_line(c["mutated"])
    if can_be_evaluated_twice(c):
        both = f"[&] {{ return ::vesica_mutant::differ(({mutated}), ({in_a_line(c['original'])})); }}"
        test = f"::vesica_mutant::is({c['number']}, {both})"
    return f"({test} ? ({mutated}) : ({c['original']}))"


def rewritten(text, chosen):
    """A file's bytes with its candidates switched. Its lines come ADDED_LINES later than before."""
    for c in sorted(chosen, key=lambda c: -c["begin"]):
        text = text[:c["begin"]] + switched(c).encode() + text[c["end"]:]
    return PREFIX + text
