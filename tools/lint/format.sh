#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# format.sh [--fix]: every C and C++ file is laid out as clang-format 14 does it (.clang-format); --fix does it. What
# clang-format leaves alone, comments and the public headers, has no line of more than 120 columns either.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
tool=clang-format-14
command -v $tool >/dev/null || { echo "format: no $tool: nothing can be checked" >&2; exit 2; }

# The public headers are C, laid out by hand: one operand a line where it helps. bindings/declare writes
# declarations.h, and the folders `generated`.
mapfile -d '' -t files < <(find include src capi bindings engines examples programs tests tools bench docs \
  \( -name build -o -name generated \) -prune -o -type f \
  ! -path 'capi/include/vesica*.h' ! -path 'bindings/go/declarations.h' \
  \( -name '*.c' -o -name '*.h' -o -name '*.cpp' -o -name '*.hpp' -o -name '*.cu' -o -name '*.cuh' \) -print0)
[ ${#files[@]} -gt 400 ] || { echo "format: only ${#files[@]} files found" >&2; exit 2; }
if [ "${1:-}" = --fix ]; then
  printf '%s\0' "${files[@]}" | xargs -0 $tool -i
else
  printf '%s\0' "${files[@]}" | xargs -0 $tool --dry-run -Werror || { echo 'format: to mend it: ./run lint --fix' >&2; exit 1; }
fi
long=$(printf '%s\0' "${files[@]}" capi/include/vesica*.h | LC_ALL=C.UTF-8 xargs -0 grep -nE '^.{121,}$' || true)
if [ -n "$long" ]; then
  echo "$long"
  echo 'format: lines of more than 120 columns' >&2
  exit 1
fi
echo "format: ${#files[@]} files"
