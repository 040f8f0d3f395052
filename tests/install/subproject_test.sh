#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# subproject_test.sh WORK: the library from its sources, shared and static, inside a parent project in C, and what such a
# build installs. The objects of all builds are the same, so they are compiled once.
#   - by add_subdirectory and by FetchContent: the parent's program runs, the parent installs nothing of ours
#   - with VESICA_INSTALL: programs by find_package and by pkg-config against the install, moved, of a parent with and
#     without a build type; and a program that needs a library of the parent's that needs ours
#   - the whole alone: nothing beside compilers is asked for, and the library is shared, unless told otherwise;
#     pkg-config's files follow the folders that are told
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
rm -rf "$1"
mkdir -p "$1"
work=$(cd "$1" && pwd)
unset PKG_CONFIG_PATH LD_LIBRARY_PATH

fail() {
  echo "subproject_test: $1" >&2
  exit 1
}

# parent CMAKE_ARGUMENT...: configures and builds the parent, which must not compile src/ a second time. The C interface is one
# source of a shared library, and the parts of an archive.
compiled=
parent() {
  cmake -S "$here/subproject" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DVESICA_SOURCE="$root" "$@"
  cmake --build "$work/build" | tee "$work/log"
  [ -z "$compiled" ] || ! grep -q 'Building CXX object vesica/src/' "$work/log" || fail "compiled again with $*"
  compiled=yes
}

# needed PROGRAM: the shared libraries it needs, but for libc and libm.
needed() {
  readelf -dW "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\].*/\1/p' | grep -Ev '^lib[cm]\.so' || true
}

for linkage in shared static; do
  shared=$([ $linkage = shared ] && echo ON || echo OFF)
  library=$([ $linkage = shared ] && echo libvesica.so.0 || true)
  for by in add_subdirectory FetchContent; do
    echo "subproject_test: $linkage, $by"
    parent -DBY=$by -DBUILD_SHARED_LIBS=$shared -DVESICA_INSTALL=OFF
    "$work/build/c_user"
    "$work/build/methods_user"
    [ "$(needed "$work/build/c_user" | grep -v of_parent)" = "$library" ] || fail "c_user needs $(needed "$work/build/c_user")"
    rm -rf "$work/prefix"
    cmake --install "$work/build" --prefix "$work/prefix"
    [ "$(cd "$work/prefix" && find . ! -type d)" = ./bin/c_user ] || fail 'the parent installs more than its program'
  done

  echo "subproject_test: $linkage, installed"
  parent -DBY=add_subdirectory -DBUILD_SHARED_LIBS=$shared -DVESICA_INSTALL=ON
  cmake --install "$work/build" --prefix "$work/prefix" >"$work/log"
  grep -F vesica-targets-release.cmake "$work/log" || fail 'a parent of build type Release installs no paths'
  # Without a build type of the parent's ours is Release still, and that is what is installed.
  parent -DBY=add_subdirectory -DBUILD_SHARED_LIBS=$shared -DVESICA_INSTALL=ON -DCMAKE_BUILD_TYPE=
  bash "$here/install_moved.sh" "$work/build" "$work/$linkage"
  bash "$here/consumer_cmake_test.sh" "$work/$linkage" "$work/by_cmake"
  bash "$here/consumer_pkgconfig_test.sh" "$work/$linkage" "$work/by_pkgconfig"
  for program in by_cmake/c_user by_pkgconfig/c_user; do
    [ "$(needed "$work/$program")" = "$library" ] || fail "$program needs $(needed "$work/$program")"
  done
  rm -rf "$work/by_parent"
  cmake -S "$here/subproject/user" -B "$work/by_parent" -G Ninja -DCMAKE_PREFIX_PATH="$work/$linkage"
  cmake --build "$work/by_parent"
  "$work/by_parent/methods_user"
done

echo 'subproject_test: unless told otherwise'
# Where the parent says nothing: its own library is static, as CMake has it, and ours is shared.
cmake -S "$here/subproject" -B "$work/silent" -G Ninja -DVESICA_SOURCE="$root"
ninja -C "$work/silent" -t targets all >"$work/targets"
grep -q '^libof_parent.a:' "$work/targets" || fail 'our choice of libraries is made for the parent too'
grep -q '^vesica/capi/libvesica.so:' "$work/targets" || fail 'the library is not shared'
cmake -S "$root" -B "$work/plain" -G Ninja -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON -DCMAKE_FIND_USE_CMAKE_SYSTEM_PATH=OFF
ninja -C "$work/plain" -t targets all >"$work/targets"
grep -q '^capi/libvesica.so:' "$work/targets" || fail 'the library is not shared'
if grep -q '^tests/' "$work/targets"; then fail 'tests are built'; fi

# pkg_config FLAGS CMAKE_ARGUMENT...: what pkg-config says of the library in these folders.
pkg_config() {
  cmake -S "$root" -B "$work/plain" -DCMAKE_INSTALL_PREFIX=/opt/vesica "${@:2}" >"$work/log"
  flags=$(PKG_CONFIG_PATH=$work/plain pkg-config --cflags --libs vesica-methods | sed 's/ *$//')
  [ "$flags" = "$1" ] || fail "with ${*:2} pkg-config says $flags"
}
at=$work/plain/../..
pkg_config "-I$at/include -L$at/lib -lvesica-methods -lvesica" -DCMAKE_INSTALL_LIBDIR=lib
pkg_config "-I/of/c -L$at/lib -lvesica-methods -lvesica" -DCMAKE_INSTALL_INCLUDEDIR=/of/c
pkg_config '-I/of/c -L/of/libraries -lvesica-methods -lvesica' -DCMAKE_INSTALL_LIBDIR=/of/libraries
pkg_config '-I/opt/vesica/include -L/of/libraries -lvesica-methods -lvesica' -DCMAKE_INSTALL_INCLUDEDIR=include
echo 'subproject_test: passed'
