#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# join_test.sh MOVED WORK: vesica-join as it is installed on files good and bad, beside all pairs by scalar calls; its
# numbers beside strtod's; its manual page beside its help.
. "$(dirname "${BASH_SOURCE[0]}")/prefix.sh"

common=$here/../../engines/common
warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Werror)
"$CC" -std=c99 -O1 "${warnings[@]}" "-I$common" -o "$work/number_test" "$here/number_test.c" "$common/number.c"
"$work/number_test"

cd "$work"
# The program finds the library without being told where.
(unset LD_LIBRARY_PATH && "$moved/bin/vesica-join" --version)
diff <("$moved/bin/vesica-join" --help | grep -o -e '--[a-z-]*' | sort -u) \
  <(sed 's/\\-/-/g' "$moved/share/man/man1/vesica-join.1" | grep -o -e '--[a-z-]*' | sort -u)
# numpy is of Debian's own python3.
/usr/bin/python3 -B "$here/join_test.py" "$moved/bin/vesica-join"
