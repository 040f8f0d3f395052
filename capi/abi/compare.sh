#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# compare.sh ABIDIFF OLD NEW: two dumps of the ABI. Prints what differs; exit status 0 nothing, 4 an addition alone,
# 8 what was there is changed or gone, 1 they could not be compared.
set -euo pipefail

[ $# = 3 ] || { echo "usage: compare.sh ABIDIFF OLD NEW" >&2; exit 1; }
command -v "$1" >/dev/null || { echo "compare: no abidiff ('$1'; Debian: abigail-tools)" >&2; exit 1; }
status=0
report=$("$1" --no-architecture --harmless "$2" "$3") || status=$?
[ -z "$report" ] || echo "$report"
# abidiff's bits: 1 failed, 2 wrong usage, 4 something changed, 8 what was there is surely broken. A changed parameter
# or field is 4 alone, as abidiff cannot tell whether callers bear it; ours, compiled against the header, do not.
[ $((status & 3)) = 0 ] || { echo "compare: abidiff failed, status $status" >&2; exit 1; }
[ $((status & 8)) = 0 ] || exit 8
! grep -Eq 'changes summary:.* [1-9][0-9]* (\([^)]*\) )?Changed' <<<"$report" || exit 8
exit $((status & 4))
