#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench.sh MOVED WORK [N]: the rows of all engines for N shapes a side (1e5), and that of one machine first.
. "$(dirname "${BASH_SOURCE[0]}")/../tests/install/prefix.sh"
export VESICA_ENGINES_DATA=$work/data CC=${CC:-cc}
mkdir "$VESICA_ENGINES_DATA"
/usr/bin/python3 -B "$here/common/draw.py" "${3:-1e5}" "$VESICA_ENGINES_DATA"
. "$here/common/benching.sh"

echo "$(lscpu | sed -n 's/^Model name: *//p'), $(nproc) cores; load before: $(cut -d ' ' -f 1 /proc/loadavg)"
echo '| engine | shapes | pairs | ns a shape | MiB | hash of the sorted pairs |'
echo '|---|---|---|---|---|---|'
one_machine=("$moved/bin/vesica-join" --threads 1 "$data/a.csv" "$data/b.csv")
"${one_machine[@]}" 2>"$work/said" | tail -n +2 >"$work/pairs.csv"
read -r _ memory < <(measure "${one_machine[@]}" 2>/dev/null)
seconds=$(sed -n 's/.*indexed in \([0-9.]*\) s, joined in \([0-9.]*\) s.*/\1 \2/p' "$work/said" | awk '{ print $1 + $2 }')
row 'one machine: `vesica-join`' "$seconds" "$memory" "$work/pairs.csv"
for engine in sqlite postgresql mpi dask duckdb; do
  "$here/$engine/bench.sh" "$1" "$work/$engine" || echo "$engine: failed" >&2
done
