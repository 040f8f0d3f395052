#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# finds_faults.sh PROGRAM: wrong answers put in on purpose are found, shrunk to a short case, and replayed.
set -euo pipefail

stress=$1

fail() {
  echo "finds_faults: $1" >&2
  exit 1
}

# finds FAULT LAW LENGTH OPTION...: the stress test finds the fault as one of the law, in a case of at most so many
# characters, which fails again with the fault and does not without.
finds() {
  local fault=$1 law=$2 length=$3 found status=0 replay
  shift 3
  found=$("$stress" 0 --seed 7 --seconds 240 --query "${law%%.*}" --fault "$fault" --stop-at "$law" "$@") || status=$?
  [ $status = 1 ] || fail "$fault: exit status $status, not 1"
  replay=$(grep -A1 "^FAULT $law: " <<<"$found" | sed -n "s/^  --replay '\(.*\)'$/\1/p" | head -n 1)
  [ -n "$replay" ] || fail "$fault: no fault of $law in: $found"
  [ ${#replay} -le "$length" ] || fail "$fault: not short: $replay"
  status=0
  found=$("$stress" --replay "$replay" --fault "$fault" "$@") || status=$?
  [ $status = 1 ] && grep -q "^FAULT $law: " <<<"$found" || fail "$fault: not replayed: $replay"
  found=$("$stress" --replay "$replay" "$@") || true
  ! grep -q "^FAULT $law: " <<<"$found" || fail "$fault: $replay fails without it too"
  echo "$fault: $replay"
}

finds touching_missed overlap.exact_stage 160
finds guard_left_out overlap.exact_stage 100
finds converse_forgotten relation.exact_stage 120
finds distance_off nearest.of_scale 200
finds depth_off depth.exchanged 120
finds area_off area.exchanged 120
finds reach_short within.overlap_is_within 160
finds end_forgotten de9im.relation 120
finds vertex_lost intersection.unused_is_0 220
finds lane_flipped batch.overlap_sse2 160

# A run that is resumed goes on where it stopped.
state=$(mktemp)
rm "$state"
trap 'rm -f "$state"' EXIT
known=$(dirname "$0")/known_faults.txt
"$stress" 2000 --seed 7 --query overlap --known "$known" --resume "$state" >/dev/null
again=$("$stress" 2000 --query overlap --known "$known" --resume "$state")
grep -q '^seed 7, from group [1-9]' <<<"$again" || fail "not resumed: $again"
total=$("$stress" 1 --query overlap --known "$known" --resume "$state" | sed -n 's/^  overlap *\([0-9]*\) asked.*/\1/p')
[ "$total" -ge 4000 ] || fail "resumed counts: $total"
