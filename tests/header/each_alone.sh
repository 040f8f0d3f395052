#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# each_alone.sh COMPILER INCLUDE FOLDER: every header of a folder below INCLUDE compiled before anything else, twice in
# one file, without a warning.
set -euo pipefail
compiler=$1 include=$2 folder=$3
flags=(-std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror)
count=0
for header in "$include/$folder"/*.hpp; do
  name=$folder/$(basename "$header")
  printf '#include <%s>\n#include <%s>\n' "$name" "$name" | "$compiler" "${flags[@]}" -I"$include" -x c++ -
  count=$((count + 1))
done
[ "$count" -gt 0 ] || { echo "no headers in $include/$folder" >&2; exit 1; }
echo "$count headers"
