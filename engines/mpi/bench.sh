#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench.sh MOVED WORK: a row for 1, 2 and 4 ranks, then what they sent to each other.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
. "$here/../common/benching.sh"
. "$here/../common/unprivileged.sh"
stage=$(mktemp -d "${TMPDIR:-/tmp}/vesica-mpi.XXXXXX")
trap 'rm -rf "$stage"' EXIT
"$here/build.sh" "$stage"
cp "$data"/[ab].npy "$LD_LIBRARY_PATH/libvesica.so.0" "$stage"
chmod -R a+rX "$stage"
hand_over "$stage"
export LD_LIBRARY_PATH=$stage
cd "$stage"
for n in 1 2 4; do
  rm -f pairs.*
  read -r _ _ _ _ _ _ _ seconds _ memory _ shuffled _ neighbours < <(
    unprivileged mpirun --oversubscribe --bind-to none -n "$n" ./join_mpi a.npy b.npy pairs)
  row "MPI: $n rank(s), $shuffled bytes to their cells, $neighbours to neighbours" "$seconds" "$memory a rank" pairs.*.csv
done
