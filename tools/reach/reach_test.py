# SPDX-License-Identifier: Apache-2.0
"""reach_test.py NM STRESS MACHINE=OBJECT... ...: every exported function is attacked by every machine.

The machines are the test of floating-point environments, the fuzzer, the stress test and the search for slow inputs.
vesica.json lists the functions. What a machine calls is read from its objects; the stress test also prints the
functions that it calls by name. A function that a machine does not call needs a line in exceptions.txt. A line there is
an error if the machine calls all of its functions.
"""
import collections
import fnmatch
import json
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
MACHINES = ("environment", "fuzz", "stress", "slowest")


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def called(nm, objects):
    names = set()
    for path in objects:
        names.update(re.findall(r"^ +U (vesica_\w+)$", output(nm, path), re.M))
    return names


def exceptions():
    """[(machine, pattern, line)] of exceptions.txt: machines by commas, a pattern of functions, then why."""
    result = []
    for number, line in enumerate((HERE / "exceptions.txt").read_text().splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        machines, pattern, reason = line.split(maxsplit=2)
        result += [(machine, pattern, number) for machine in machines.split(",")]
        assert reason and set(machines.split(",")) <= set(MACHINES), line
    return result


def main():
    nm, stress = sys.argv[1:3]
    objects = collections.defaultdict(list)
    for argument in sys.argv[3:]:
        machine, path = argument.split("=", 1)
        objects[machine] += path.split(",")
    description = json.loads((HERE.parents[1] / "capi" / "vesica.json").read_text())
    functions = {function["name"] for function in description["functions"]}
    failures, used = [], set()
    excepted = exceptions()
    for machine in MACHINES:
        reached = called(nm, objects[machine])
        if machine == "stress":
            reached.update(output(stress, "--functions").split())
        if not reached & functions:
            failures.append(f"{machine}: calls nothing")
        for name in sorted(functions - reached):
            lines = [line for who, pattern, line in excepted if who == machine and fnmatch.fnmatchcase(name, pattern)]
            used.update((machine, line) for line in lines)
            if not lines:
                failures.append(f"{machine}: does not call {name}, and exceptions.txt does not say why")
    for machine, pattern, line in excepted:
        if (machine, line) not in used:
            failures.append(f"exceptions.txt:{line}: {machine} calls all of {pattern}")
    print("\n".join(failures) or f"{len(functions)} functions, {len(MACHINES)} machines")
    return 1 if failures else 0


sys.exit(main())
