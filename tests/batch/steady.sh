#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# steady.sh OBJDUMP COMPILER OBJECT...: in the objects whose calls do not read the control register
# (src/isa/<set>_calls.cpp) each instruction that rounds, compares or converts floating-point numbers says itself how,
# and suppresses exceptions: {rn-sae} or {sae} of AVX-512.
set -euo pipefail

# shellcheck source=tests/batch/objects.sh
. "$(dirname "${BASH_SOURCE[0]}")/objects.sh"

# All of SSE, AVX and AVX-512 that MXCSR is for, by the beginnings of their names.
arithmetic='^v?(add|sub|mul|div|sqrt|max|min|cmp[a-z_]*|u?comi|cvt[a-z0-9]*|round|rndscale|reduce|range|scalef|fixupimm'
arithmetic+='|getexp|getmant|rcp|rsqrt|dp|hadd|hsub|addsub|fn?m(add|sub|addsub|subadd)[0-9]*)(sub)?[ps][sd]?[a-z0-9]*$'

# unsteady OBJECT: such instructions without {sae} or {rn-sae}, by function.
unsteady() {
  "$objdump" -d --no-show-raw-insn "$1" | awk -v arithmetic="$arithmetic" '
    /^[0-9a-f]+ <.*>:$/ { function_name = $2 }
    $2 ~ arithmetic && !/sae}/ { print "  " function_name " " $2 }' | sort -u
}

# The test can fail: these are what the compiler makes of plain arithmetic.
for expression in 'a + b' 'a * b + c' 'a < b' '(float)a' '(int)a' '__builtin_sqrt(a)' 'a / b'; do
  echo "double plain(double a, double b, double c) { (void)b; (void)c; return $expression; }" >"$work/plain.c"
  for flags in -O2 "-O2 -mavx512f -ffp-contract=fast"; do
    # shellcheck disable=SC2086
    "$compiler" $flags -x c -c "$work/plain.c" -o "$work/plain.o"
    [ -n "$(unsteady "$work/plain.o")" ] || fail "does not see $expression"
  done
done

checked=0
wrong=0
for object in "${objects[@]}"; do
  case $object in */isa/*_calls.*) ;; *) continue ;; esac
  [ "$("$objdump" -d "$object" | grep -c 'sae}')" -ge 10 ] || fail "$object has few steady instructions"
  found=$(unsteady "$object")
  if [ -n "$found" ]; then
    printf '%s depends on the control register:\n%s\n' "$object" "$found" >&2
    wrong=1
  fi
  checked=$((checked + 1))
done
[ $checked -gt 0 ] || fail "no object of calls among the arguments"
[ $wrong = 0 ] || exit 1
echo "objects of steady calls: $checked"
