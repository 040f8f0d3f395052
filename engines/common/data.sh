#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# data.sh MOVED WORK: the shapes of all engines' tests, and the pairs of one machine by the program of ./run join, which
# expected.txt tells.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
VESICA_ENGINES_DATA=$work
. "$here/testing.sh"

programs=$here/../../examples
/usr/bin/python3 -B "$here/draw.py" 20000 "$work"
"$CC" -std=c99 -O2 "-I$programs/demo" "-I$here" -o "$work/join" "$programs"/join/*.c "$programs"/demo/{fields,line}.c \
  "$here"/{geometry,vertices,wkt}.c "${flags[@]}" -lm
"$work/join" "$work/a.csv" "$work/b.csv" 2>/dev/null | tail -n +2 >"$work/pairs.csv"
same_pairs 'one machine' "$work/pairs.csv"
finish
