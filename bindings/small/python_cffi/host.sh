# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Python, by cffi and capi/vesica.cdef (Debian: python3-cffi, which only Debian's own python3 sees).
build() { cp "$host"/*.py "$here/../../capi/vesica.cdef" "$work"; }
run() { /usr/bin/python3 -B "$work/vectors.py" "$1"; }
