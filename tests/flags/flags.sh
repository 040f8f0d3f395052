#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# flags.sh COMPILER refused|right|same PROGRAM FLAG...: the core compiled with flags that a user may choose. Either it must
# not compile, and say why; or PROGRAM must find that it answers right, or with the same bits as the library.
set -euo pipefail
compiler=$1 expected=$2 program=$3
flags=(-std=c++20 -O2 -fPIC -DVESICA_EACH_ALONE "${@:4}")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "flags: $*" >&2
  exit 1
}

# The refusal is the first error: nothing after it needs to be compiled.
[ "$expected" != refused ] || flags+=(-Wfatal-errors)

# A query is one source over the core: a decision, and a number.
for query in overlap nearest; do
  if "$compiler" "${flags[@]}" -I"$root/include" -I"$root/src" -c "$root/src/queries/$query.cpp" -o "$folder/$query.o" \
    2>"$folder/errors"; then
    [ "$expected" != refused ] || fail "it compiles"
  else
    grep -q 'error: .*Vesica needs' "$folder/errors" || { cat "$folder/errors" >&2; fail "it does not compile, and does not say why"; }
    [ "$expected" = refused ] || fail "it is refused"
    exit 0
  fi
done
"$compiler" "${flags[@]}" -I"$root/include" -I"$root/src" -c "$root/tests/flags/no_polygons.cpp" -o "$folder/no_polygons.o"
"$compiler" -shared "$folder"/*.o -o "$folder/core.so"
"$program" "$folder/core.so" "$expected"
