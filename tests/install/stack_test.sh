#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# stack_test.sh MOVED WORK [ROWS]: the pyramid of examples/stack stands for 10 seconds, and no energy comes from nowhere.
# Without the numbers of contacts it does not: then each step begins without the last impulses.
. "$(dirname "${BASH_SOURCE[0]}")/prefix.sh"

source=$here/../../examples/stack/stack.c
warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Werror)
"$CC" -std=c11 -O2 "${warnings[@]}" -o "$work/stack" "$source" "${flags[@]}" -lm
"$work/stack" "${3:-16}"
[ -z "${3:-}" ] || exit 0

sed 's/if (before != NULL)/if (0)/' "$source" >"$work/forgets.c"
if cmp -s "$source" "$work/forgets.c"; then echo "nothing was left out of $source"; exit 1; fi
"$CC" -std=c11 -O2 -o "$work/forgets" "$work/forgets.c" "${flags[@]}" -lm
if "$work/forgets" 16; then echo "it stands without the last impulses too: this test cannot fail"; exit 1; fi
