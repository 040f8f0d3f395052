#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# library.sh TARGET: builds the library for TARGET (targets.sh) in build/linux/TARGET, and checks that it runs on any
# Linux with that C library, as wheels promise: with glibc 2.17 or later, or with musl. Prints the folder.
# shellcheck disable=SC2154
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
[ $# = 1 ] || { echo 'usage: library.sh TARGET' >&2; exit 2; }
# shellcheck source=/dev/null
. "$root/packaging/linux/targets.sh"
tree=$root/build/linux/$1

# Paths in the library begin in the repository: one tree gives the same bytes in any folder.
export CFLAGS=-ffile-prefix-map=$root/= CXXFLAGS=-ffile-prefix-map=$root/=
cmake -S "$root" -B "$tree" -G Ninja -DCMAKE_BUILD_TYPE=Release "${toolchain[@]}" >&2
cmake --build "$tree" --target vesica vesica_methods >&2

for name in vesica vesica-methods; do
  library=$tree/capi/lib$name.so
  "$root/tests/abi/c_only.sh" "$NM" readelf "$library" >&2
  [ "$libc" = musl ] || "$root/tests/abi/c_library.sh" "$NM" "$library" >&2
done
echo "$tree"
