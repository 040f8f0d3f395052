#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# unfused.sh OBJDUMP COMPILER OBJECT...: no object whose results have the bits of the scalar functions fuses a product
# with a sum where the source does not say so. g++ 12 does it in spite of -ffp-contract=off where neighbouring numbers
# alternate between a sum and a difference: vfmaddsub and vfmsubadd, which nothing in the source asks for.
#
# Three rules, for x86-64:
#   src/isa/<set>.cpp, _calls                may fuse: they only decide
#   src/isa/<set>_queries.cpp                fuse where the source says so, but never in alternation
#   all others                               fuse in functions for processors that do (fast_hit_fused and
#                                            find_meeting_fused of src/queries/cast.cpp, area_in_disc_fused), and not
#                                            in alternation there
set -euo pipefail

# shellcheck source=tests/batch/objects.sh
. "$(dirname "${BASH_SOURCE[0]}")/objects.sh"

# found RULE OBJECT: the functions of an object with instructions that the rule forbids, and one such instruction each.
found() {
  "$objdump" -d --no-show-raw-insn "$2" | awk -v rule="$1" '
    /^[0-9a-f]+ <.*>:$/ { function_name = $2; allowed = rule == "queries" || $2 ~ /fast_hit_fused|find_meeting_fused|area_in_disc_fused/ }
    $2 ~ /^vf(maddsub|msubadd)[0-9]/ || (!allowed && $2 ~ /^vfn?m(add|sub)[0-9]/) {
      if (!seen[function_name]++) print "  " function_name " " $2
    }'
}

# The test can fail: this is what the compiler makes of such numbers where it may.
cat >"$work/alternate.c" <<'END'
void alternate(double *restrict r, const double *restrict a, const double *restrict b, const double *restrict c) {
  r[0] = a[0] * b[0] - c[0];
  r[1] = a[1] * b[1] + c[1];
}
END
"$compiler" -O2 -mfma -ffp-contract=fast -x c -c "$work/alternate.c" -o "$work/fused.o"
[ -n "$(found plain "$work/fused.o")" ] || fail "does not see that products and sums are fused"
"$compiler" -O2 -x c -c "$work/alternate.c" -o "$work/plain.o"
[ -z "$(found plain "$work/plain.o")" ] || fail "sees what is not there"

checked=0
wrong=0
for object in "${objects[@]}"; do
  case $object in
    */vesica_index.dir/*) rule=plain ;;
    */isa/*_queries.*) rule=queries ;;
    */isa/dispatch.*) rule=plain ;;
    */isa/*) continue ;;
    *) rule=plain ;;
  esac
  functions=$(found $rule "$object")
  if [ -n "$functions" ]; then
    printf '%s fuses products and sums:\n%s\n' "$object" "$functions" >&2
    wrong=1
  fi
  checked=$((checked + 1))
done
[ $checked -ge 20 ] || fail "only $checked objects among the arguments"
[ $wrong = 0 ] || exit 1
echo "objects that fuse nothing unasked: $checked"
