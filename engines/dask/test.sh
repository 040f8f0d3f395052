#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# test.sh MOVED WORK: overlap_join with Debian's Dask and this tree's Python package.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
. "$here/../common/testing.sh"
/usr/bin/python3 -B "$here/../../bindings/declare" python
export PYTHONPATH=$here/../../bindings/python:$here
/usr/bin/python3 -B "$here/test.py" "$data" "$work" 2>"$work/log" || {
  tail -n 40 "$work/log"
  failures=$((failures + 1))
}
for join in by_cells as_they_are array_and_delayed killed bad_None bad_4; do
  same_pairs "$join" "$work/$join.csv"
done
finish
