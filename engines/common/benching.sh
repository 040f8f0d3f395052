# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# To be sourced by an engine's bench, after prefix.sh. The shapes are those of draw.py in $data.
common=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
data=${VESICA_ENGINES_DATA:?"the folder of draw.py"}
export LC_ALL=C

# measure COMMAND...: seconds and MiB.
measure() {
  /usr/bin/python3 -B "$common/measure.py" "$@"
}

# row NAME SECONDS MEMORY FILE...: a line of the table; the files have the pairs. Time a shape counts both sides, each of
# $shapes where that is not all.
row() {
  local pairs hash
  read -r pairs hash < <("$common/pairs.sh" "${@:4}")
  awk -v name="$1" -v n="${shapes:-$(wc -l <"$data/a.csv")}" -v pairs="$pairs" -v s="$2" -v mib="$3" -v hash="$hash" 'BEGIN {
    printf "| %s | %d x %d | %d | %.0f | %s | %.12s |\n", name, n, n, pairs, 1e9 * s / (2 * n), mib, hash }'
}
