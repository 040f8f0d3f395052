#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# zones_test.sh MOVED WORK: examples/zones compiles, and counts who is in each zone.
. "$(dirname "${BASH_SOURCE[0]}")/prefix.sh"

"$CC" -std=c11 -O1 -Wall -Wextra -Wpedantic -Wconversion -Werror -o "$work/zones" "$here/../../examples/zones/main.c" \
  "${flags[@]}"
[ "$("$work/zones")" = $'zone 0: 2\nzone 1: 2' ]
