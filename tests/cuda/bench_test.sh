#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bench_test.sh PROGRAM: the benchmark through the device's stand-in has a row for every two kinds, scalar and form, with
# right answers; and its exit status says what was wrong.
set -euo pipefail
program=$1
fail() {
  echo "$1"
  exit 1
}
status() {
  local code=0
  "$@" >/dev/null 2>&1 || code=$?
  echo "$code"
}

rows=$("$program" --pairs 600 /mixed)
# 21 pairs of kinds; two points do not overlap half the time.
[ "$(grep -c '/mixed ' <<<"$rows")" -ge 80 ] || fail "too few rows: $rows"
# On a busy machine a speed may be printed as 0.00.
awk '/\/mixed / && ($NF != 0 || $3 !~ /^[0-9]+\.[0-9]+$/) { bad = 1 } END { exit bad }' <<<"$rows" ||
  fail "a wrong answer: $rows"
near=$("$program" --pairs 600 rect_ellipse /near)
[ "$(grep -c '/step/near ' <<<"$near")" = 2 ] || fail "$near"
[ "$(VESICA_NO_DEVICE=1 status "$program")" = 3 ] || fail "no device is exit status 3"
said=$(VESICA_NO_DEVICE=1 "$program" 2>&1) || true
grep -q 'no CUDA device' <<<"$said" || fail "no device is not said: $said"
for wrong in "" 0; do
  [ "$(status "$program" --pairs $wrong)" = 2 ] || fail "--pairs $wrong is exit status 2"
done
