#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# refresh.sh [BUILD]: after an addition to the headers, writes anew what is checked in beside them and derived from
# them: vesica.json, vesica.cdef and the ABI's baseline abi/vesica.abi. BUILD is a build folder with tests, by default
# that of the preset "test". A change that breaks the baseline is refused (ABI.md); before the first release, or with a
# new SONAME, delete the baseline first.
set -euo pipefail

capi=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(dirname "$capi")
build=${1:-$root/build/test}
[ $# -gt 0 ] || (cd "$root" && cmake --preset test)

cmake --build "$build" --target vesica_with_types
library=$build/tests/abi/libvesica.so
baseline=$capi/abi/vesica.abi
new=$(mktemp)
trap 'rm -f "$new"' EXIT
"$capi/abi/dump.sh" abidw "$library" "$new"
if [ -s "$baseline" ]; then
  report=$("$capi/abi/compare.sh" abidiff "$baseline" "$new") && status=0 || status=$?
  if [ "$status" != 0 ] && [ "$status" != 4 ]; then
    echo "$report"
    echo "refresh: the baseline stays as it is" >&2
    exit 1
  fi
fi
cat "$new" >"$baseline"
python3 -B "$capi/describe.py"
echo "refreshed: $capi/vesica.json $capi/vesica.cdef $baseline"
