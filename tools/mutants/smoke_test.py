# SPDX-License-Identifier: Apache-2.0
"""smoke_test.py COMPILER FOLDER: all mutants of smoke/small.hpp, judged by smoke/main.cpp."""

import pathlib
import subprocess
import sys

import judge
import rewrite
import sites

HERE = pathlib.Path(__file__).parent
# A statement whose effect nobody reads, and a comparison at a place where both answers are the same.
SURVIVE = [("x > T()", "x >= T()"), ("corners[0] = sides", ""), ("0", "0 + 1")]
KILLED = [
    ("x > T()", "x <= T()"),
    ("x > T()", "!(x > T())"),
    ("positive(gap) == gap", "positive(gap) != gap"),
    ("positive(gap) == gap", "!(positive(gap) == gap)"),
    ("Verdict::touching", "Verdict::crossing"),
    ("Verdict::apart", "Verdict::touching"),
    ("Verdict::crossing", "Verdict::apart"),
    ("taken(left) == 2", "taken(left) != 2"),
    ("taken(left) == 2", "!(taken(left) == 2)"),
    ("2", "2 + 1"),
    ("5", "5 + 1"),
]


def judged_alone(candidate, text, compiler, folder):
    """The word for one mutant, in a program of its own."""
    mutant = dict(candidate, number=1)
    (folder / "small.hpp").write_bytes(rewrite.rewritten(text, [mutant]))
    subprocess.run([compiler, "-std=c++20", f"-I{folder}", f"-I{HERE}", "-o", folder / "main", folder / "main.cpp"], check=True)
    parts = [judge.Part({"name": "main", "command": [str(folder / "main")]})]
    assert parts[0].run(-1, 60)[0], candidate  # to try a change beside its original changes nothing
    return judge.Judge(parts, judge.reach(parts, 1)).verdict(1)[0]


def main(compiler, folder):
    folder.mkdir(parents=True, exist_ok=True)
    source = str(HERE / "smoke/small.hpp")
    (folder / "main.cpp").write_bytes((HERE / "smoke/main.cpp").read_bytes())
    finder = sites.Finder(lambda path: path == source)
    finder.parse(f"{folder}/unit.cpp", ["-x", "c++", "-std=c++20"], f'#include "{source}"\n')
    found = finder.unique()
    pairs = sorted((c["original"], c["mutated"]) for c in found)
    assert pairs == sorted(SURVIVE + KILLED), pairs

    text = open(source, "rb").read()
    for c in found:
        word = judged_alone(c, text, compiler, folder)
        expected = "survived" if (c["original"], c["mutated"]) in SURVIVE else "killed"
        assert word == expected, (c["original"], c["mutated"], word)

    # Of a sample each is switched on alone, and the same seed draws the same.
    sample = rewrite.sample(found, 5, 1)
    assert sample == rewrite.sample(found, 5, 1) and [c["number"] for c in sample] == [1, 2, 3, 4, 5]
    assert rewrite.rewritten(text, sample).count(b"::vesica_mutant::is(") == 5


main(sys.argv[1], pathlib.Path(sys.argv[2]))
