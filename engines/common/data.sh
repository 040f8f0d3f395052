#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# data.sh MOVED WORK: the shapes of all engines' tests, and the pairs of one machine by vesica-join, which
# expected.txt tells.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
VESICA_ENGINES_DATA=$work
. "$here/testing.sh"

/usr/bin/python3 -B "$here/draw.py" 20000 "$work"
"$moved/bin/vesica-join" "$work/a.csv" "$work/b.csv" 2>/dev/null | tail -n +2 >"$work/pairs.csv"
same_pairs 'one machine' "$work/pairs.csv"
finish
