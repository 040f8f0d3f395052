#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# refresh.sh [BUILD]: writes anew what follows from the headers, after an addition to them: vesica.json, vesica.cdef and
# vesica_methods.cdef in capi/, the declarations of bindings/, and the ABI's baselines in capi/abi/. BUILD is a build
# folder with tests, by default that of the preset "test". It refuses a change that breaks a baseline (capi/ABI.md);
# before the first release, or with a new SONAME, delete the baseline first.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
capi=$root/capi
build=${1:-$root/build/test}
[ $# -gt 0 ] || (cd "$root" && cmake --preset test)

cmake --build "$build" --target vesica_with_types --target vesica_methods_with_types
new=$(mktemp)
trap 'rm -f "$new"' EXIT
for library in vesica vesica-methods; do
  baseline=$capi/abi/$library.abi
  "$capi/abi/dump.sh" abidw "$build/tests/abi/lib$library.so" "$new"
  if [ -s "$baseline" ]; then
    report=$("$capi/abi/compare.sh" abidiff "$baseline" "$new") && status=0 || status=$?
    if [ "$status" != 0 ] && [ "$status" != 4 ]; then
      echo "$report"
      echo "refresh: $baseline stays as it is" >&2
      exit 1
    fi
  fi
  cat "$new" >"$baseline"
done
python3 -B "$root/tools/describe.py"
python3 -B "$root/bindings/declare"
echo "refreshed: $(cd "$capi" && echo vesica.json ./*.cdef abi/*.abi)"
