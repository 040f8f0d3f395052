#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh PROGRAM ARCHITECTURE LIBRARY [OPTION...]: the benchmark by nvcc, which needs minutes, for sm_90 and the like or
# "native", against the libvesica.so of a folder; options are nvcc's.
set -euo pipefail
program=$1 architecture=$2 library=$(cd "$3" && pwd)
bench=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
root=$bench/..
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
flags=(-std=c++20 -O2 "-I$root/include" "-I$root/capi/include" "-I$bench" -c --output-directory "$work")
device=(-x cu --expt-relaxed-constexpr "-arch=$architecture" "${@:4}")
nvcc "${flags[@]}" "${device[@]}" "$bench/cuda/main.cpp" "$bench/cuda/any_pair.cpp"
nvcc "${flags[@]}" -Xcompiler -ffp-contract=off "$bench/contacts.cpp" "$bench/workloads.cpp"
mkdir -p "$(dirname "$program")"
nvcc -o "$program" "$work"/*.o "-L$library" -lvesica -Xlinker "-rpath=$library"
