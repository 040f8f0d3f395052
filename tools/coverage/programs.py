# SPDX-License-Identifier: Apache-2.0
"""programs.py TESTS <CTestTestfile.cmake: the targets that the tests need whose names match the expression, a line each:
their programs, where these are of the build, and the libraries loaded before them."""

import os
import re
import sys

text = sys.stdin.read()
targets = set()
for name, program in re.findall(r'^add_test\(\[=\[(\w+)\]=\] "([^"]+)"', text, re.M):
    if re.search(sys.argv[1], name) and "/build/coverage/" in program:
        targets.add(os.path.basename(program))
for name, settings in re.findall(r'^set_tests_properties\(\[=\[(\w+)\]=\] PROPERTIES (.*)', text, re.M):
    if re.search(sys.argv[1], name):
        targets.update(re.findall(r"LD_PRELOAD=\S*/lib(\w+)\.so", settings))
print("\n".join(sorted(targets)))
