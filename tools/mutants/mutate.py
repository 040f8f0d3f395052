# SPDX-License-Identifier: Apache-2.0
"""mutate.py ROOT [N] [--seed S] [--file PATH]... [--tests NAME...] [--workers W] [--budget SECONDS] [--again | --report]:
which faults do the tests find?

N (default 300) small changes of the library's sources, drawn by the seed (default 1), each switched on at run time, so that
one build has them all; then, for each, the parts of tests to which it makes a difference, those likely to find it first,
until one fails. What is not found in the budget of processor seconds stays open, and is judged again where the same command
has a larger one. Works under build/mutate and goes on where it was interrupted. Prints tables by kind and by folder, and
those that no test found. Exit status 1 where one of these is not listed in harmless.txt.
"""

import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess

import judge
import records
import rewrite
import sites

HERE = pathlib.Path(__file__).parent
OWN = ("include/", "src/", "capi/")
WORDS = ("killed", "equivalent", "slower", "survived", "open", "unreached", "not run")


def arguments():
    parser = argparse.ArgumentParser(prog="./run mutate", description=__doc__.split(":", 1)[1])
    parser.add_argument("root", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("count", nargs="?", type=int, default=300, metavar="N")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--file", action="append", default=[], help="only of sources whose path begins so")
    parser.add_argument("--tests", nargs="+", default=(HERE / "tests.txt").read_text().split(), metavar="NAME")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--budget", type=float, default=float("inf"), metavar="SECONDS")
    parser.add_argument("--again", action="store_true", help="judge what no test found and harmless.txt does not name once more")
    parser.add_argument("--report", action="store_true", help="only print what was judged so far")
    return parser.parse_args()


def update(path, content):
    """Writes a file unless it is that already, so that what depends on it is not built again."""
    if not path.exists() or path.read_bytes() != content:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def files_of(root):
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=root, check=True, capture_output=True)
    return [name for name in listed.stdout.decode().split() if (root / name).is_file()]


def reached_by(root, unit, sources, known):
    """The sources that a source includes, itself among them."""
    if unit not in known:
        known[unit] = {unit}
        for name in re.findall(r'^#include ["<]([\w/.]+)[">]', (root / unit).read_text(), re.M):
            for folder in [str(pathlib.Path(unit).parent), "include", "src", "capi", "capi/include"]:
                if f"{folder}/{name}" in sources:
                    known[unit] = known[unit] | reached_by(root, f"{folder}/{name}", sources, known)
                    break
    return known[unit]


def candidates(root, names, folder, prefixes):
    """Those of the sources of this processor's library whose path begins so; kept until a source changes."""
    sources = [n for n in names if n.startswith(OWN) and n.endswith((".hpp", ".cpp")) and
               not re.search(r"/(isa|lanes)/(neon|simd128)", n)]
    texts = b"".join((root / n).read_bytes() for n in sources + [str(HERE / "sites.py")])
    digest = hashlib.sha256(texts + repr(prefixes).encode()).hexdigest()
    kept = folder / f"candidates-{digest[:16]}.json"
    if kept.exists():
        return json.loads(kept.read_text())
    wanted = {n for n in sources if n.startswith(tuple(prefixes))}
    own = set(sources)
    finder = sites.Finder(lambda path: path[len(str(root)) + 1:] in wanted, lambda path: path[len(str(root)) + 1:] in own)
    flags = ["-x", "c++", "-std=c++20", "-DNDEBUG"] + [f"-I{root}/{f}" for f in ("include", "src", "capi", "capi/include")]
    vectors = ["-mavx2", "-mfma", "-mbmi2", "-mpopcnt", "-mavx512f", "-mavx512vl", "-mavx512bw", "-mavx512dq"]
    headers = [n for n in sources if n.startswith("include/") and n in wanted]
    if headers:
        finder.parse(f"{root}/headers.cpp", flags, "".join(f"#include \"{root}/{n}\"\n" for n in headers))
    left, known = wanted - set(headers), {}
    for name in sources:
        if name.endswith(".cpp") and reached_by(root, name, set(sources), known) & left:
            finder.parse(f"{root}/{name}", flags + (vectors if "/isa/avx" in name else []))
            left -= known[name]
    found = finder.unique()
    for c in found:
        c["file"] = c["file"][len(str(root)) + 1:]
    kept.write_text(json.dumps(found))
    return found


def write_tree(root, names, tree, chosen):
    """A copy of the sources, mutated, that is compiled quickly."""
    by_file = collections.defaultdict(list)
    for c in chosen:
        by_file[c["file"]].append(c)
    for name in names:
        content = (root / name).read_bytes()
        if name in by_file:
            content = rewrite.rewritten(content, by_file[name])
        if name in ("src/CMakeLists.txt", "src/index/CMakeLists.txt", "capi/CMakeLists.txt"):
            content = b"add_compile_options(-O1 -w)\n" + content.replace(b"-O2", b"-O1")
        if name == "tests/CMakeLists.txt":  # where the compiler sees through a mutant it may warn of what that leaves unset
            content = b"add_compile_options(-w)\n" + content
        update(tree / name, content)
    update(tree / "include/vesica_mutant.hpp", (HERE / "vesica_mutant.hpp").read_bytes())


def refused(log, tree, chosen):
    """Numbers of the mutants in lines of which the compiler complains; or else of their file: what is evaluated for an
    argument of a builtin function is named by the call alone."""
    lines, by_line, by_file = log.split("\n"), collections.defaultdict(set), collections.defaultdict(set)
    for c in chosen:
        by_file[c["file"]].add(c["number"])
        for i in range(c["original"].count("\n") + 1):
            by_line[c["file"], c["line"] + i].add(c["number"])
    numbers, context = set(), set()
    for line in lines:
        place = re.match(r"\s*(?:In file included from |inlined from .* at )?(\S+?):(\d+):(?:\d+:?)? *(.*)", line)
        if not place:
            continue
        name = str(pathlib.Path(tree / "build/test" / place[1]).resolve())
        file = name[len(str(tree)) + 1:] if name.startswith(str(tree)) else ""
        at = by_line[file, int(place[2]) - rewrite.ADDED_LINES]
        if place[3].startswith(("error", "fatal error")):
            numbers |= at or context or by_file[file]
            context = set()
        else:
            context = context | at if not place[3].startswith("note") else context
    return numbers


def targets_of(tree, names, log):
    """The programs of the named tests, the tree being configured first."""
    if subprocess.run(["cmake", "--preset", "test"], cwd=tree, stdout=log, stderr=log).returncode:
        raise SystemExit(f"mutate: cannot be configured: {log.name}")
    programs, preloaded = {}, set()
    for file in (tree / "build/test").rglob("CTestTestfile.cmake"):
        text = file.read_text()
        programs.update(re.findall(r'^add_test\((?:\[=*\[)?(\w+)(?:\]=*\])? "([^"]+)"', text, re.M))
        preloaded.update(re.findall(r"LD_PRELOAD=\S*/lib(\w+)\.so", text))
    missing = [name for name in names if name not in programs]
    if missing:
        raise SystemExit("mutate: no such test: " + " ".join(missing))
    return sorted({pathlib.Path(programs[name]).name for name in names} | preloaded)


def check(tree, targets, log):
    """Whether the sources of the library are accepted that the targets need; quicker than to compile them."""
    needed = subprocess.run(["ninja", "-C", "build/test", "-t", "commands", *targets], cwd=tree, check=True,
                            capture_output=True, text=True).stdout.split("\n")
    compiled = [c for c in needed if re.search(f" -c {tree}/(src|capi)/", c)]

    def one(command):
        return subprocess.run(re.sub(r" -MD .* -c ", " -fsyntax-only ", command), shell=True, cwd=tree / "build/test",
                              stdout=log, stderr=log).returncode

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return not any(list(pool.map(one, compiled)))


def build(tree, targets, log):
    return subprocess.run(["cmake", "--build", "--preset", "test", "--target", *targets, "--", "-k", "0"], cwd=tree,
                          stdout=log, stderr=log).returncode == 0


def built(root, names, folder, state, chosen, tests):
    """The sample less what does not compile, built. What does not is noted, for the next time."""
    tree, checked = folder / "tree", (state / "checked").exists()
    refusals = state / "refused.txt"
    refusals.touch()
    while True:
        numbers = {int(n) for n in refusals.read_text().split()}
        chosen = [c for c in chosen if c["number"] not in numbers]
        write_tree(root, names, tree, chosen)
        with open(folder / "build.log", "w+") as log:
            targets = targets_of(tree, tests, log)
            if not checked and check(tree, targets, log):
                checked = True
                (state / "checked").touch()
            if checked and build(tree, targets, log):
                return chosen
            log.seek(0)
            numbers = refused(log.read(), tree, chosen)
        if not numbers:
            raise SystemExit(f"mutate: the build fails, and not for a mutant: {folder}/build.log")
        print(f"{len(numbers)} do not compile", flush=True)
        with open(refusals, "a") as out:
            out.write("".join(f"{n}\n" for n in sorted(numbers)))


def harmless(path):
    """{(file, marked line): word}"""
    return {(file, line): "slower" if proof.startswith("Slower only") else "equivalent"
            for file, line, proof in records.read(path)}


def marked(root, c):
    """The line of a candidate, with the change where it is: if (a {{< -> <=}} b) for instance. Lines become one."""
    text = (root / c["file"]).read_bytes()
    begin, end = text.rfind(b"\n", 0, c["begin"]) + 1, text.find(b"\n", c["end"])
    change = f"{{{{{c['original']} -> {c['mutated'] or 'nothing'}}}}}"
    return " ".join((text[begin:c["begin"]].decode() + change + text[c["end"]:end].decode()).split())


def table(title, counts):
    print(f"\n{title:36}" + "".join(f"{w:>11}" for w in WORDS))
    for row in [*sorted(counts), None]:
        total = sum(counts.values(), collections.Counter()) if row is None else counts[row]
        print(f"{row or 'all':36}" + "".join(f"{total[w]:11}" for w in WORDS))


def report(root, chosen, results, known):
    """Two tables; the number of those that no test found and harmless.txt does not name."""
    kinds, folders, killers = (collections.defaultdict(collections.Counter) for _ in range(3))
    total, seconds, results = collections.Counter(), 0.0, judge.read_results(results)
    for c in chosen:
        word, part, used = results.get(c["number"], ("not run", "-", 0.0))
        if word != "killed":
            word = known.get((c["file"], marked(root, c)), word)
        for counts in (kinds[c["kind"]], folders[os.path.dirname(c["file"])], total):
            counts[word] += 1
        killers[part.split("/")[0]][word] += 1
        seconds += used
        if word in ("survived", "open", "unreached"):
            print(f"{word} {c['number']}: {c['file']}:{c['line']}\n  {marked(root, c)}")
    table("by kind", kinds)
    table("by folder", folders)
    order = sorted(killers, key=lambda test: -killers[test]["killed"])
    print("\nkilled by: " + ", ".join(f"{test} {killers[test]['killed']}" for test in order if killers[test]["killed"]))
    unknown = total["survived"] + total["open"] + total["unreached"]
    judged = total["killed"] + unknown
    print(f"{total['killed']} of {judged} that are not known to be harmless: {100 * total['killed'] / max(1, judged):.1f} %; "
          f"{seconds:.0f} s of processor time to judge")
    return unknown


def main():
    options = arguments()
    root = options.root.resolve()
    folder = root / "build/mutate"
    folder.mkdir(parents=True, exist_ok=True)
    names = files_of(root)
    found = candidates(root, names, folder, options.file or [""])
    chosen = rewrite.sample(found, options.count, options.seed)
    key = hashlib.sha256(json.dumps(chosen).encode()).hexdigest()[:16]
    print(f"{len(chosen)} of {len(found)} candidates, seed {options.seed}: build/mutate/{key}", flush=True)
    state = folder / key
    state.mkdir(exist_ok=True)
    results, known = state / "results.txt", harmless(HERE / "harmless.txt")
    if options.report:
        chosen = json.loads((state / "mutants.json").read_text())
    else:
        chosen = built(root, names, folder, state, chosen, options.tests)
        (state / "mutants.json").write_text(json.dumps(chosen, indent=1))
        parts = judge.parts_of(folder / "tree/build/test", options.tests)
        reached = judge.reach(parts, chosen[-1]["number"], state / "reach.json", options.workers)
        asked = [c for c in chosen if not options.again or (c["file"], marked(root, c)) not in known]
        judge.judge(asked, parts, reached, results, options.workers, options.budget, options.again)
    raise SystemExit(1 if report(root, chosen, results, known) else 0)


if __name__ == "__main__":
    main()
