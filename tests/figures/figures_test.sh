#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# figures_test.sh PROGRAM DOCS WRITTEN: PROGRAM writes well-formed SVG into the folder WRITTEN, the very files that are
# checked in under DOCS/figures, and each of them is shown on a page of DOCS.
set -euo pipefail
program=$1
docs=$2
written=$3
failures=0

complain() {
  echo "$1"
  failures=$((failures + 1))
}

rm -rf "$written"
mkdir -p "$written"
"$program" "$written"
for path in "$written"/*.svg; do
  name=$(basename "$path")
  xmllint --noout "$path" || complain "$name is not XML"
  [ "$(xmllint --xpath 'name(/*)' "$path")" = svg ] || complain "$name is not SVG"
  cmp "$path" "$docs/figures/$name" || complain "$name is not what is checked in; to write it anew: ./run figures"
  grep -q "(figures/$name)" "$docs"/*.md || complain "no page shows $name"
done
for path in "$docs"/figures/*.svg; do
  [ -e "$written/$(basename "$path")" ] || complain "nothing writes $path"
done
[ "$(find "$written" -name '*.svg' | wc -l)" -ge 6 ] || complain "fewer than six figures"

# Told nothing, or a folder that is not there, it says so.
status=0
"$program" 2>/dev/null || status=$?
[ $status = 2 ] || complain "status without a folder: $status"
status=0
"$program" "$written/missing" 2>/dev/null || status=$?
[ $status = 1 ] || complain "status with a folder that is not there: $status"

[ $failures = 0 ]
