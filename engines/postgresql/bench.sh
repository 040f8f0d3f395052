#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench.sh MOVED WORK: rows of the join by the index and by vesica_join, and what the server's own types and PostGIS take
# for the same query over other shapes: bounding boxes, circles around them, and the boxes as polygons.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
. "$here/../common/benching.sh"
. "$here/server.sh"
. "$here/load.sh"
make_server -c shared_buffers=512MB -c jit=off
createdb bench
load bench

# timed NAME QUERY: its row. The memory is that of the largest process of the server since it was started.
timed() {
  local begin end memory
  begin=$(date +%s.%N)
  sql bench -F, <<<"$2" >"$work/pairs.csv"
  end=$(date +%s.%N)
  memory=$(awk '/VmHWM/ { print int($2 / 1024) }' "/proc/$(head -n 1 "$stage/server/data/postmaster.pid")/status")
  row "$1" "$(awk "BEGIN { print $end - $begin }")" "$memory" "$work/pairs.csv"
}
