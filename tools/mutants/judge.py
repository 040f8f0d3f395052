# SPDX-License-Identifier: Apache-2.0
"""Which test kills which mutant. A test is cut into parts of some cases each, so that little more runs than what finds the
fault. A part is killed by a failure, a crash, or three times its usual processor time and three seconds more."""

import collections
import concurrent.futures
import json
import os
import pathlib
import random
import resource
import subprocess
import tempfile
import threading
import time

PARTS = 24


class Part:
    """A test as ctest would run it, or one of its parts: every so manieth of its cases."""

    def __init__(self, record, index=0, count=1):
        self.test, self.command = record["name"], record["command"]
        self.name = self.test if count == 1 else f"{self.test}/{index}"
        properties = {p["name"]: p["value"] for p in record.get("properties", [])}
        self.folder = properties.get("WORKING_DIRECTORY")
        self.settings = dict(s.split("=", 1) for s in properties.get("ENVIRONMENT", []))
        if count > 1:
            self.settings.update(GTEST_TOTAL_SHARDS=str(count), GTEST_SHARD_INDEX=str(index))
        self.skipped = properties.get("SKIP_RETURN_CODE")

    def run(self, mutant, seconds, reached=None):
        """(Whether it passes, processor seconds)."""
        environment = dict(os.environ, **self.settings, VESICA_MUTANT=str(mutant), GTEST_FAIL_FAST="1", GTEST_BRIEF="1")
        environment.pop("VESICA_MUTANT_REACHED", None)
        if reached:
            environment["VESICA_MUTANT_REACHED"] = reached

        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        process = subprocess.Popen(self.command, cwd=self.folder, env=environment, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, preexec_fn=limit)
        # What sleeps spends no processor time; the clock of a loaded machine is no measure either.
        alarm = threading.Timer(20 * seconds + 60, process.kill)
        alarm.start()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        alarm.cancel()
        return process.returncode in (0, self.skipped), used.ru_utime + used.ru_stime


def cases_of(record):
    """How many cases a test has; 1 where it is no program of GoogleTest's."""
    command = record["command"]
    if b"GTEST_TOTAL_SHARDS" not in pathlib.Path(command[0]).read_bytes():
        return 1
    listing = subprocess.run([*command, "--gtest_list_tests"], check=True, capture_output=True, text=True).stdout
    return sum(line.startswith("  ") for line in listing.split("\n"))


def parts_of(build, names):
    listing = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True, text=True)
    records = {r["name"]: r for r in json.loads(listing.stdout)["tests"]}
    missing = [name for name in names if name not in records or "command" not in records[name]]
    if missing:
        raise SystemExit("mutate: no such test, or not built: " + " ".join(missing))
    parts = []
    for name in names:
        count = max(1, min(PARTS, cases_of(records[name])))
        parts += [Part(records[name], i, count) for i in range(count)]
    return parts


def built_at(part):
    facts = os.stat(part.command[0])
    return [facts.st_size, facts.st_mtime_ns]


def reach(parts, count, kept=None, workers=1):
    """{part: [processor seconds, numbers of the mutants to which it makes a difference, when it was built]}. With no mutant
    every part must pass. What a file keeps from an earlier time is not asked again, unless the test was built since."""
    result = json.loads(kept.read_text()) if kept and kept.exists() else {}

    def one(part):
        with tempfile.NamedTemporaryFile() as file:
            file.write(bytes(count + 1))
            file.flush()
            passes, seconds = part.run(-1, 3600, file.name)
            if not passes:
                # Where a change was tried beside its original it had an effect.
                passes, seconds = part.run(0, 3600)
                if not passes:
                    raise SystemExit(f"mutate: {part.name} fails without a mutant")
                print(f"{part.name} is judged for all mutants: it fails where changes are tried", flush=True)
                return seconds, list(range(1, count + 1))
            with open(file.name, "rb") as marks:
                return seconds, [i for i, mark in enumerate(marks.read()) if mark]

    left = [p for p in parts if result.get(p.name, [])[2:] != [built_at(p)]]
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        for i, (part, answer) in enumerate(zip(left, pool.map(one, left))):
            result[part.name] = [*answer, built_at(part)]
            if kept and (i % PARTS == 0 or part is left[-1]):
                kept.write_text(json.dumps(result))
    for test in dict.fromkeys(p.test for p in parts) if kept else ():
        those = [result[p.name] for p in parts if p.test == test]
        print(f"{test}: {sum(t[0] for t in those):.1f} s, reaches {len(set().union(*(t[1] for t in those)))}", flush=True)
    return result


class Judge:
    """Runs the parts that reach a mutant, in the order in which they are likely to kill it soonest: by what they have
    killed so far in its folder, and by what they take."""

    def __init__(self, parts, reached):
        self.parts = parts
        self.seconds = {p.name: reached[p.name][0] for p in parts}
        self.reaching = collections.defaultdict(list)
        for part in parts:
            for number in reached[part.name][1]:
                self.reaching[number].append(part)
        self.runs, self.kills = collections.Counter(), collections.Counter()

    def worth(self, folder, part):
        """Kills a second, by one kill in four runs that nobody has seen."""
        key = (folder, part.test)
        return (self.kills[key] + 1) / (self.runs[key] + 4) / (self.seconds[part.name] + 0.02)

    def verdict(self, number, folder="", budget=float("inf")):
        """(Word, the part that killed it or none, processor seconds). After the budget it is open."""
        left = list(self.reaching[number])
        if not left:
            return "unreached", "-", 0.0
        used = 0.0
        while left:
            part = max(left, key=lambda p: self.worth(folder, p))
            if used + self.seconds[part.name] > budget:
                return "open", "-", used
            left.remove(part)
            passes, seconds = part.run(number, 3 * self.seconds[part.name] + 3)
            used += seconds
            self.learn(folder, part.test, not passes)
            if not passes:
                return "killed", part.name, used
        return "survived", "-", used

    def learn(self, folder, test, killed):
        self.runs[folder, test] += 1
        self.kills[folder, test] += killed


def read_results(path):
    """{number: [word, part, seconds]}: the last line of each mutant."""
    lines = [line.split() for line in open(path)] if os.path.exists(path) else []
    return {int(line[0]): [line[1], line[2], float(line[3])] for line in lines}


def judge(mutants, parts, reached, results, workers, budget=float("inf"), again=False):
    """Appends a line a mutant to the file of results; those that have one are not judged again, but for the open ones, or
    all that are not killed. In an order that makes those judged so far a fair sample."""
    done = read_results(results)
    words = ("open", "survived", "unreached") if again else ("open",)
    left = [m for m in mutants if done.get(m["number"], ["open"])[0] in words]
    random.Random(1).shuffle(left)
    left.sort(key=lambda m: m["number"] in done)
    judging, lock, began = Judge(parts, reached), threading.Lock(), time.time()
    folders = {m["number"]: os.path.dirname(m["file"]) for m in mutants}
    for number, (word, part, _) in done.items():
        # One that harmless.txt names may be killed all the same, and is not among those asked for again.
        if word == "killed" and number in folders:
            judging.learn(folders[number], part.split("/")[0], True)
    with open(results, "a") as out, concurrent.futures.ThreadPoolExecutor(workers) as pool:
        def one(mutant):
            word, killer, seconds = judging.verdict(mutant["number"], folders[mutant["number"]], budget)
            if word == "unreached" and mutant["number"] in done:
                return  # by these tests; others have run it
            with lock:
                out.write(f"{mutant['number']} {word} {killer} {seconds:.2f}\n")
                out.flush()

        for i, future in enumerate(concurrent.futures.as_completed([pool.submit(one, m) for m in left])):
            future.result()
            if (i + 1) % 50 == 0:
                print(f"{i + 1} of {len(left)} judged, {time.time() - began:.0f} s", flush=True)
