#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh DIRECTORY [ARGUMENT...]: builds vesica.wasm into DIRECTORY, by clang, lld, wasi-libc, libc++-14-dev-wasm32
# and libclang-rt-14-dev-wasm32, and near_tie_hash.wasm, which tests it; and into DIRECTORY/simd the same with vectors.
# CMake has the arguments.
set -euo pipefail
[ $# -gt 0 ] || { echo 'usage: build.sh DIRECTORY [ARGUMENT...]' >&2; exit 2; }
module=$(cd "$(dirname "${BASH_SOURCE[0]}")/module" && pwd)
cmake -S "$module" -B "$1" -G Ninja -Wno-dev --toolchain "$module/wasm32-wasi.cmake" "${@:2}"
cmake --build "$1"
cmake -S "$module" -B "$1/simd" -G Ninja -Wno-dev --toolchain "$module/wasm32-wasi.cmake" -DCMAKE_CXX_FLAGS=-msimd128 \
  "${@:2}"
cmake --build "$1/simd"
