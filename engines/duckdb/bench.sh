#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench.sh MOVED WORK: rows of the join by one thread, by two, and with less memory than it would take.
. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
. "$here/../common/benching.sh"
. "$here/load.sh"
"$here/build.sh" "$work"
cd "$work"
load | sql database=all.db >/dev/null
join pairs.csv >join.sql
timed() {
  local seconds memory
  read -r seconds memory < <(measure sh -c 'node "$0" database=all.db "$@" <join.sql' "$here/sql.mjs" "${@:2}")
  row "$1" "$seconds" "$memory" pairs.csv
}
timed 'DuckDB: `vs_join`, one thread' threads=1
timed 'DuckDB: `vs_join`, two threads' threads=2
timed 'DuckDB: `vs_join`, two threads, `memory_limit` 100 MB' threads=2 memory_limit=100MB temp_directory=spill
