# SPDX-License-Identifier: Apache-2.0
"""Which test kills which mutant. A test is killed by a failure, a crash, or three times its usual processor time and five
seconds more."""

import concurrent.futures
import json
import os
import random
import resource
import subprocess
import tempfile
import threading
import time


class Test:
    """A test as ctest would run it."""

    def __init__(self, record):
        self.name, self.command = record["name"], record["command"]
        properties = {p["name"]: p["value"] for p in record.get("properties", [])}
        self.folder = properties.get("WORKING_DIRECTORY")
        self.settings = dict(s.split("=", 1) for s in properties.get("ENVIRONMENT", []))
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


def tests_of(build, names):
    listing = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True, text=True)
    records = {r["name"]: r for r in json.loads(listing.stdout)["tests"]}
    missing = [name for name in names if name not in records or "command" not in records[name]]
    if missing:
        raise SystemExit("mutate: no such test, or not built: " + " ".join(missing))
    return [Test(records[name]) for name in names]


def reach(tests, count, kept=None):
    """{test: [processor seconds, numbers of the mutants that it reaches]}. With no mutant every test must pass. What a
    file keeps from an earlier time is not asked again."""
    result = json.loads(kept.read_text()) if kept and kept.exists() else {}
    for test in tests:
        if test.name in result:
            continue
        with tempfile.NamedTemporaryFile() as file:
            file.write(bytes(count + 1))
            file.flush()
            passes, seconds = test.run(-1, 3600, file.name)
            if not passes:
                raise SystemExit(f"mutate: {test.name} fails without a mutant")
            marks = open(file.name, "rb").read()
        result[test.name] = [seconds, [i for i, mark in enumerate(marks) if mark]]
        print(f"{test.name}: {seconds:.1f} s, reaches {len(result[test.name][1])}", flush=True)
        if kept:
            kept.write_text(json.dumps(result))
    return result


def verdict(number, tests, reached):
    """(Word, the test that killed it or none)."""
    those = sorted((t for t in tests if number in reached[t.name][1]), key=lambda t: reached[t.name][0])
    for test in those:
        passes, _ = test.run(number, 3 * reached[test.name][0] + 5)
        if not passes:
            return "killed", test.name
    return ("survived", "-") if those else ("unreached", "-")


def judge(mutants, tests, reached, results, workers):
    """Appends a line a mutant to the file of results; those that have one are not judged again. In an order that makes
    those judged so far a fair sample."""
    done = {int(line.split()[0]) for line in open(results)} if os.path.exists(results) else set()
    left = [m["number"] for m in mutants if m["number"] not in done]
    random.Random(1).shuffle(left)
    lock, began = threading.Lock(), time.time()
    with open(results, "a") as out, concurrent.futures.ThreadPoolExecutor(workers) as pool:
        def one(number):
            word, killer = verdict(number, tests, reached)
            with lock:
                out.write(f"{number} {word} {killer}\n")
                out.flush()

        for i, future in enumerate(concurrent.futures.as_completed([pool.submit(one, n) for n in left])):
            future.result()
            if (i + 1) % 50 == 0:
                print(f"{i + 1} of {len(left)} judged, {time.time() - began:.0f} s", flush=True)
