#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# each_alone.sh COMPILER INCLUDE FOLDER: every header in and below a folder of INCLUDE compiled before anything else,
# twice in one file, without a warning, and with the words as macros that <windows.h> makes macros. What only an
# instance of a template would show is not seen.
set -euo pipefail
compiler=$1 include=$2 folder=$3
flags=(-std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wdouble-promotion
  -Werror -Dnear= -Dfar= -Dsmall=char -I"$include" -x c++ -)

# alone HEADER COMMAND...
alone() {
  printf '#include <%s>\n#include <%s>\n' "$1" "$1" | "${@:2}" || { echo "$1 does not compile alone" >&2; return 1; }
}
export -f alone

headers=$(cd "$include" && find "$folder" -name '*.hpp' | sort)
[ -n "$headers" ] || { echo "no headers in $include/$folder" >&2; exit 1; }
xargs -P2 -I{} bash -c 'alone "$@"' alone {} "$compiler" "${flags[@]}" <<<"$headers"
echo "$(wc -l <<<"$headers") headers"
