# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Python, by ctypes and numpy (Debian: python3-numpy, which only Debian's own python3 sees).
build() {
  /usr/bin/python3 -c 'import numpy'
  cp "$host"/*.py "$here/../../python/vesica/_declarations.py" "$work"
}
run() { /usr/bin/python3 -B "$work/vectors.py" "$1"; }
run_index() { /usr/bin/python3 -B "$work/index.py"; }
