#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# join_test.sh MOVED WORK: the program of `./run join` on files good and bad, beside all pairs by scalar calls.
. "$(dirname "${BASH_SOURCE[0]}")/prefix.sh"

warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Werror)
examples=$here/../../examples
demo=$examples/demo common=$here/../../engines/common
"$CC" -std=c99 -O1 "${warnings[@]}" "-I$demo" "-I$common" -o "$work/join" "$examples"/join/*.c "$demo/fields.c" "$demo/line.c" \
  "$common"/{geometry,vertices,wkt}.c "${flags[@]}" -lm
cd "$work"
# numpy is of Debian's own python3.
/usr/bin/python3 -B "$here/join_test.py" ./join
