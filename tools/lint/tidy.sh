#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# tidy.sh: clang-tidy 14 (.clang-tidy) finds no fault in the library, and in the core as far as the library and one
# program use it. One instruction set stands for all: their sources are the same.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
tool=clang-tidy-14
command -v $tool >/dev/null || { echo "tidy: no $tool: nothing can be checked" >&2; exit 2; }

files=(capi/*.cpp src/*.cpp src/isa/dispatch.cpp src/isa/portable.cpp src/isa/portable_queries.cpp
  tests/install/consumer/core_user.cpp)
flags=(-std=c++20 -fno-exceptions -Iinclude -Isrc -Icapi -Icapi/include -DVESICA_BUILDING)
printf '%s\0' "${files[@]}" |
  xargs -0 -P "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}" -I{} $tool --quiet --warnings-as-errors='*' {} -- "${flags[@]}"
echo "tidy: ${#files[@]} files"
