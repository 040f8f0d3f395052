#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# variables.sh NM LIBRARY [none]: of all that can be written to once the library is loaded, the pointer to the chosen
# kernels (src/isa/dispatch.cpp) is the only variable; with "none" there is not even that. Reads the full symbol table,
# so the library must not be stripped.
set -euo pipefail

fail() {
  echo "variables: $1" >&2
  exit 1
}

[ $# = 2 ] || [ "$*" = "${1-} ${2-} none" ] || fail "usage: variables.sh NM LIBRARY [none]"
command -v "$1" >/dev/null || fail "no nm ('$1'): nothing can be checked"
ours=_ZN6vesica14chosen_kernelsE # vesica::chosen_kernels
# Every other name in a writable section comes with the compiler: marks of the start files, and in libgcc the
# processor's features behind __builtin_cpu_supports, which the loader has them filled in with.
theirs='__dso_handle|__TMC_END__|completed(\.[0-9]+)?|__cpu_model|__cpu_features2'
# Sections that are written by the loader and then made read-only.
relocated='\.data\.rel\.ro.*|\.dynamic|\.got.*|\.(pre)?(init|fini)_array|\.ctors|\.dtors|\.tm_clone_table'
writable='\.(data|bss|tdata|tbss|sdata|sbss|ldata|lbss).*|\*COM\*'
table=$("$1" -f sysv --defined-only "$2" | awk -F'|' 'NF == 7 {gsub(/ /, ""); print $7, $1}')
variables=$(grep -E "^($writable) " <<<"$table" | grep -Ev "^($relocated) " | awk '{print $2}')
if [ $# = 3 ]; then
  grep -q '^\.text vesica_' <<<"$table" || fail "no symbol table, or not the library: $2"
  if grep -Evx "$theirs" <<<"$variables"; then fail "these variables are new: the library keeps no state"; fi
  echo "no variable"
  exit
fi
grep -Eq "^\.data\.rel\.ro .*kernels_[a-z0-9]+E?$" <<<"$table" || fail "no symbol table, or not the library: $2"
grep -qx "$ours" <<<"$variables" || fail "the pointer to the chosen kernels is not there: what else was overlooked?"
if grep -Evx "$ours|$theirs" <<<"$variables"; then
  fail "these variables are new: the library keeps no state"
fi
echo "one variable: $ours"
