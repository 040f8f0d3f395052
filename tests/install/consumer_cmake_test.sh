#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# consumer_cmake_test.sh MOVED WORK: programs in C and C++ built by find_package against the moved install.
. "$(dirname "${BASH_SOURCE[0]}")/prefix.sh"
# CMake must find the package by its own means, and the programs the library by theirs.
unset PKG_CONFIG_PATH LD_LIBRARY_PATH

cmake -S "$here/consumer" -B "$work" -G Ninja -DCMAKE_PREFIX_PATH="$moved" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF \
  -DCMAKE_CXX_FLAGS=-Werror -DCMAKE_C_FLAGS=-Werror
grep -F "vesica_DIR:PATH=$moved/" "$work/CMakeCache.txt"
cmake --build "$work"
for program in c_user methods_user cpp_user core_user; do "$work/$program"; done
# The core is complete without the library; the others use it as it was built, and C never sees a C++ runtime.
if readelf -d "$work/core_user" | grep -F libvesica; then exit 1; fi
if readelf -d "$work/c_user" "$work/methods_user" | grep -F libstdc++; then exit 1; fi
if [ -n "$(find "$moved" -name libvesica.so)" ]; then
  readelf -d "$work/c_user" | grep -F 'libvesica.so.0'
  readelf -d "$work/methods_user" | grep -F 'libvesica-methods.so.0'
else
  if readelf -d "$work/c_user" "$work/methods_user" | grep -F libvesica; then exit 1; fi
fi
