#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Finds words in comments that send a reader back to the start of the sentence, or have another everyday meaning.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# These still have some.
not_yet='^(include/vesica/filter|src/kernels|tests/cast)/'
comment='^[[:space:]]*(///?<?|\*|/\*)[[:space:]]*'
mapfile -t files < <(git ls-files '*.hpp' '*.cpp' '*.h' '*.c' '*.cuh' | grep -vE "declarations|_jni|$not_yet")

status=0
# refuse PATTERN ADVICE: prints the comment lines with the pattern.
refuse() {
  local found
  found=$(grep -nHE "$comment" "${files[@]}" | grep -E "$1" || true)
  [ -z "$found" ] && return
  printf '%s\nwords: %s\n' "$found" "$2" >&2
  status=1
}
refuse ':[[:space:]]*(///?<?|\*|/\*)[[:space:]]*(Of|What|Whether|Those) ' 'begin with the thing or a verb'
refuse '\b[Dd]ear(er|est)?\b' 'say slow or slowest'
refuse '\b[Ll]acks?\b' 'say has no'
refuse '\bof itself\b' 'leave it out, or name the thing'
refuse '\bC face\b' 'say C interface'
echo "words: ${#files[@]} files"
exit "$status"
