# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Puts small faults into the sources, and lists which ones the tests find (mutation testing).
#
#   ./run mutate [N]         N faults, 300 by default; --seed S, --file PATH, --tests NAME...: tools/mutants/README.md

need "${mutant_packages[@]}"
# Only Debian's own Python sees the bindings of Clang.
/usr/bin/python3 -B "$root/tools/mutants/mutate.py" "$root" "$@"
