#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# docs_test.sh COMPILER...: the programs of docs/cuda.md compile, the one for a device through host/cuda_runtime.h, and it
# prints what the page says.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
page=$here/../../docs/cuda.md
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

block() { awk -v open="\`\`\`$1" '$0 == open { inside = 1; next } $0 == "```" { inside = 0 } inside' "$page"; }
block cpp >"$work/constants.cpp"
block cuda >"$work/batch.cpp"
[ "$(grep -c static_assert "$work/constants.cpp")" -ge 3 ]
says=$(sed -n 's/^It prints `\([^`]*\)`.*/\1/p' "$page")
[ -n "$says" ]
flags=(-std=c++20 -Wall -Wextra -Werror -I"$here/host" -I"$here/../../include")
"$1" "${flags[@]}" -fsyntax-only "$work/constants.cpp"
"$1" "${flags[@]}" -O1 -o "$work/batch" "$work/batch.cpp"
[ "$("$work/batch")" = "$says" ]
