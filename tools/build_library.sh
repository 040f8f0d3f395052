#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build_library.sh static|shared DIRECTORY: builds the library in DIRECTORY, and prints the folder that holds it.
# VESICA_ARCHIVE or VESICA_SHARED may name a folder that holds it already.
set -euo pipefail
case $1 in
  static) found=${VESICA_ARCHIVE:-} shared=OFF ;;
  shared) found=${VESICA_SHARED:-} shared=ON ;;
esac
if [ -z "$found" ]; then
  root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
  cmake -S "$root" -B "$2" -DCMAKE_BUILD_TYPE=Release "-DBUILD_SHARED_LIBS=$shared" >&2
  cmake --build "$2" --target vesica --parallel "$(getconf _NPROCESSORS_ONLN)" >&2
  found=$2/capi
fi
echo "$found"
