#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# unchanged.sh ABIDW ABIDIFF LIBRARY MAP BASELINE: the ABI is that of the checked-in baseline. LIBRARY holds debug
# information. An addition fails too, until the baseline is refreshed: what is added is then seen in review.
set -euo pipefail

fail() {
  echo "unchanged: $1" >&2
  exit 1
}

[ $# = 5 ] || fail "usage: unchanged.sh ABIDW ABIDIFF LIBRARY MAP BASELINE"
library=$3 map=$4 baseline=$5
scripts=$(dirname "${BASH_SOURCE[0]}")/../../capi/abi
[ -s "$baseline" ] || fail "no baseline $baseline; to write it: tools/refresh.sh"
now=$(mktemp)
trap 'rm -f "$now"' EXIT
"$scripts/dump.sh" "$1" "$library" "$now"

# Where debug information were missing, there would be nothing to compare, and nothing would ever differ.
listed=$(grep -c '^ *vesica_[a-z0-9_]*;' "$map")
typed=$(grep -c '<function-decl name=.vesica_.*elf-symbol-id=' "$now" || true)
[ "$listed" = "$typed" ] || fail "$listed names in the map, but the types of $typed functions"

status=0
"$scripts/compare.sh" "$2" "$baseline" "$now" || status=$?
case $status in
  0) echo "$typed functions and their types, as in the baseline" ;;
  4) fail "added to the ABI. If that is meant, refresh the baseline and commit it: tools/refresh.sh" ;;
  8) fail "BROKEN: programs built against the baseline would misbehave. This may not be released (capi/ABI.md)." ;;
  *) fail "the two could not be compared" ;;
esac
