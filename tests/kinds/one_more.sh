#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# one_more.sh FOLDER PYTHON: builds the library in that folder with one more kind (dummy.hpp), without optimisation and
# for no processor in particular, and asks every function that takes kinds with it.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
mkdir -p "$1"
if ! { cmake -S "$root" -B "$1" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DVESICA_DEVELOPER=ON \
  -DCMAKE_CXX_FLAGS_DEBUG= \
  -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=generic "-DCMAKE_CXX_FLAGS=-DVESICA_PORTABLE_ONLY -include $here/dummy.hpp" && cmake --build "$1" --target vesica; } >"$1/build.log" 2>&1; then
  cat "$1/build.log"
  exit 1
fi
cd "$1"
exec "$2" -B "$here/refused_test.py" capi/libvesica.so "$root/capi/vesica.json" --dummy 8
