#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# join_patterns_test.sh MOVED WORK: the code of docs/join.md compiles, and finds all pairs.
. "$(dirname "${BASH_SOURCE[0]}")/prefix.sh"

awk '$0 == "```c" { inside = 1; next } $0 == "```" { inside = 0 } inside' "$here/../../docs/join.md" >"$work/patterns.c"
[ "$(grep -c '^int64_t each_pair\|^int64_t collide\|^const void \*map_index' "$work/patterns.c")" = 4 ]
cat "$here/../../examples/patterns/main.c" >>"$work/patterns.c"
"$CC" -std=c11 -D_GNU_SOURCE -O1 -Wall -Wextra -Wpedantic -Wconversion -Werror -o "$work/patterns" "$work/patterns.c" \
  "${flags[@]}"
cd "$work"
./patterns
