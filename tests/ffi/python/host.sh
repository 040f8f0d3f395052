# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Python, by ctypes and numpy (Debian: python3-numpy, which only Debian's own python3 sees).
build() { /usr/bin/python3 -c 'import numpy'; }
run() { /usr/bin/python3 -B "$host/vectors.py" "$1"; }
run_index() { /usr/bin/python3 -B "$host/index.py"; }
