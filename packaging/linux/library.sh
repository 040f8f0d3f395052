#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# library.sh [TARGET...]: builds the library for each target (targets.sh; all four unless told) in build/linux/TARGET, and
# checks that it runs on any Linux with that C library, as wheels promise: with glibc 2.17 or later, or with musl. Prints
# a line for each: the target and the folder.
# shellcheck disable=SC2154
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
# Paths in the library begin in the repository: one tree gives the same bytes in any folder.
export CFLAGS=-ffile-prefix-map=$root/= CXXFLAGS=-ffile-prefix-map=$root/=

# build TARGET TREE
build() {
  # shellcheck source=/dev/null
  . "$root/packaging/linux/targets.sh"
  # The programs are program.sh's.
  cmake -S "$root" -B "$2" -G Ninja -DCMAKE_BUILD_TYPE=Release "${toolchain[@]}" \
    "-DVESICA_PROGRAMS=$([ "$libc" = musl ] && echo ON || echo OFF)" -DVESICA_STATIC_PROGRAMS=ON
  cmake --build "$2" --target vesica vesica_methods
  local library
  for library in "$2"/capi/libvesica{,-methods}.so; do
    "$root/tests/abi/c_only.sh" "$NM" readelf "$library"
    [ "$libc" = musl ] || "$root/tests/abi/c_library.sh" "$NM" "$library"
  done
}

[ $# -gt 0 ] || set -- x86_64-gnu x86_64-musl aarch64-gnu aarch64-musl
for target in "$@"; do
  (build "$target" "$root/build/linux/$target") >&2
  echo "$target $root/build/linux/$target"
done
