# SPDX-License-Identifier: Apache-2.0
# Sourced by the tests that read the instructions of objects, whose arguments are OBJDUMP COMPILER OBJECT...: sets
# objdump, compiler, objects, and work, a folder for what a test compiles to see that it can fail.
# shellcheck shell=bash disable=SC2034

fail() {
  echo "$(basename "$0" .sh): $1" >&2
  exit 1
}

[ $# -ge 3 ] || fail "usage: $(basename "$0") OBJDUMP COMPILER OBJECT..."
objdump=$1
compiler=$2
objects=("${@:3}")
command -v "$objdump" >/dev/null || fail "no objdump ('$objdump'): nothing can be checked"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
