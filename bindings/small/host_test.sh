#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# host_test.sh MOVED WORK HOST OLDER: a host's folder, built by its own host.sh, answers the vectors with the library
# installed in MOVED (HOST may be a path), and knows two closest points; finds every answer that is made wrong in them;
# and refuses the library in OLDER.
set -euo pipefail

# Not every language's tools can take a library from a place with a space in its name.
plain=$(mktemp -d)
trap 'rm -rf "$plain"' EXIT
ln -s "$1" "$plain/moved"
set -- "$plain/moved/" "${@:2}"

. "$(dirname "${BASH_SOURCE[0]}")/../../tests/install/prefix.sh"
host=$(cd "$here" && cd "$3" && pwd) older=$4 vectors=$here/../vectors/vectors.txt failures=0

complain() {
  printf '%s: %s; it printed\n%s\n' "$host" "$1" "$(head -n 30 <<<"$output")" >&2
  failures=$((failures + 1))
}

# shellcheck source=/dev/null
. "$host/host.sh"  # build, into $work; run VECTORS
cd "$work"
# What a host needs may be missing: the command that failed is named, there and in `run`.
trap 'echo "$host: failed: $BASH_COMMAND" >&2' ERR
set -E
build
set +E
trap - ERR

output=$(run "$vectors") || complain "fails in $(declare -f run | sed '1,2d; $d')"
counts=$(awk '/^f/ { calls++ } /^many/ { batch++ } END { printf "%d calls, %d in a batch", calls, batch }' "$vectors")
grep -Fxq "$counts" <<<"$output" || complain "does not report '$counts'"
grep -q '^NaN: .*a shape is invalid' <<<"$output" || complain "has no error to show for NaN"

grep -Fxq 'nearest: as in C' <<<"$output" || complain 'has other closest points'

# The first line of each of these gets an answer that is not so.
awk '/^(f64 1|f64 0|f64 -2|f64 -3|f32 1|f32 0|f32 -2|many 1|many 0) / && !seen[$1 $2]++ {
       $2 = $2 == 1 ? 0 : 1
       print "line " NR >"spoilt"
     }
     { print }' "$vectors" >wrong.txt
if output=$(run wrong.txt 2>&1); then complain 'takes wrong vectors for right'; fi
found=$(sed -n 's/^\(line [0-9]*\): .*/\1/p' <<<"$output")
[ "$found" = "$(cat spoilt)" ] || complain "does not find these answers to be wrong: $(tr '\n' ' ' <spoilt)"

export LD_LIBRARY_PATH=$older:$LD_LIBRARY_PATH
if output=$(run "$vectors" 2>&1); then complain 'takes a library that is too old'; fi
grep -q 'older than [0-9]' <<<"$output" || complain 'does not say that the library is too old'

[ $failures = 0 ] || exit 1
echo "$3: $counts"
