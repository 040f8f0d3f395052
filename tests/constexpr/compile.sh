#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# compile.sh COMPILER: known.cpp, the corpus and the hosts' vectors as static assertions; and a spoilt one must fail. Then
# what constants and calls at run time give, which is the same.
set -euo pipefail
compiler=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
compile() { "$compiler" -std=c++20 -Wall -Wextra -Werror -I"$root/include" -fsyntax-only "$1"; }
cases() { python3 -B "$here/cases.py" "$root/tests/corpus/cases.csv" "$root/bindings/vectors/vectors.txt" "$@"; }

compile "$here/known.cpp"
"$compiler" -std=c++20 -O1 -Wall -Wextra -Werror -I"$root/include" -o "$work/same_bits" "$here/same_bits.cpp"
"$work/same_bits"
cases >"$work/cases.cpp"
compile "$work/cases.cpp"
cases --spoil >"$work/spoilt.cpp"
if compile "$work/spoilt.cpp" 2>"$work/errors"; then
  echo "a wrong answer compiled"
  exit 1
fi
grep 'static.*assert' "$work/errors" | head -n 1
