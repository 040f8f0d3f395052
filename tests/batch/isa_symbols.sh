#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# isa_symbols.sh [--unoptimised] NM OBJECT...: the objects of instruction sets among these (src/isa/<set>.cpp) must
# export their table and nothing else. Any other global or weak symbol could be merged by a linker with one of a plainer
# object, and code for the wrong processor would run everywhere.
# --unoptimised: inline functions of the core are not inlined then, and the portable lanes, which are for the baseline as
# all other objects are, may export those as weak symbols.
set -euo pipefail

fail() {
  echo "isa_symbols: $1" >&2
  exit 1
}

may_be_weak=
if [ "${1:-}" = --unoptimised ]; then
  may_be_weak=portable
  shift
fi
[ $# -ge 2 ] || fail "usage: isa_symbols.sh [--unoptimised] NM OBJECT..."
nm=$1
shift
command -v "$nm" >/dev/null || fail "no nm ('$nm'): nothing can be checked"

checked=0
wrong=0
for object in "$@"; do
  case $object in
    */isa/dispatch.*) continue ;;
    */isa/*) ;;
    *) continue ;;
  esac
  set_name=$(basename "$object")
  set_name=${set_name%%.*}
  scope=
  case $object in */index/*) scope=5index ;; esac
  table=_ZN6vesica$scope$((8 + ${#set_name}))kernels_${set_name}E # vesica::kernels_<set>, vesica::index::kernels_<set>
  # POSIX format: name, type, value, size. Upper-case types are global; u is unique, v and w are weak.
  types='^[A-Zuvw]$'
  [ "$set_name" != "$may_be_weak" ] || types='^[A-UX-Zu]$'
  # How 32-bit x86 learns its own address: two instructions, and hidden.
  exported=$("$nm" -P --defined-only "$object" |
    awk -v types="$types" '$2 ~ types && $1 !~ /^__x86\.get_pc_thunk\./ {print $1}')
  if [ "$exported" != "$table" ]; then
    echo "$object exports what is not its table $table:" >&2
    grep -vx "$table" <<<"$exported" >&2 || echo "  (the table itself is missing)" >&2
    wrong=1
  fi
  checked=$((checked + 1))
done
[ $checked -gt 0 ] || fail "no object of an instruction set among the arguments"
[ $wrong = 0 ] || exit 1
echo "objects that export their table alone: $checked"
