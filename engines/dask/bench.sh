#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench.sh MOVED WORK: a row for one worker and for two, each of one thread and 1 GiB.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
. "$here/../common/benching.sh"
/usr/bin/python3 -B "$here/../../bindings/declare" python
export PYTHONPATH=$here/../../bindings/python:$here
for workers in 1 2; do
  rm -rf "$work/pairs" "$work/pairs.csv"
  read -r seconds memory < <(/usr/bin/python3 -B "$here/join.py" "$data/a.npy" "$data/b.npy" "$work/pairs" \
    --workers "$workers" | /usr/bin/python3 -c 'import json; said = json.load(open(0)); print(said["seconds"], said["MiB"])')
  /usr/bin/python3 -B - "$work/pairs" >"$work/pairs.csv" <<'PYTHON'
import pathlib, sys
import numpy
for path in pathlib.Path(sys.argv[1]).iterdir():
    for a, b in numpy.fromfile(path, "<i8").reshape(-1, 2).tolist():
        print(a, b, sep=",")
PYTHON
  row "Dask: $workers worker(s) of 1 GiB" "$seconds" "$memory a worker" "$work/pairs.csv"
done
