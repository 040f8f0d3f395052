#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# exported_names.sh NM LIBRARY MAP: what the library exports is what the version script lists, each name at its node,
# and nothing else. (The linker alone would not say so: it leaves out a listed name that it is told may be undefined.)
set -euo pipefail

fail() {
  echo "exported_names: $1" >&2
  exit 1
}

[ $# = 3 ] || fail "usage: exported_names.sh NM LIBRARY MAP"
command -v "$1" >/dev/null || fail "no nm ('$1'): nothing can be checked"
# A node "VESICA_0.1 {" and below it "name;" up to "local:". GNU ld, and not lld, exports nodes too, as absolute symbols.
listed=$(awk '/^[A-Z].*\{/ {node = $1; global = 0}
              /global:/ {global = 1} /local:|\}/ {global = 0}
              global && /;/ {sub(/;.*/, ""); gsub(/[ \t]/, ""); print $0 "@@" node}' "$3" | LC_ALL=C sort)
exported=$("$1" -D --defined-only --with-symbol-versions "$2" |
  awk '$2 != "A" {print $3}' | LC_ALL=C sort)
grep -q '^vesica_[a-z0-9_]*@@' <<<"$listed" || fail "no names found in $3"
if ! diff --label "the map" --label "the library" -u0 <(echo "$listed") <(echo "$exported"); then
  fail "the library's names are not the map's"
fi
echo "$(wc -l <<<"$listed") names, as listed"
