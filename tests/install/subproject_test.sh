#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# subproject_test.sh WORK: the library from its sources, shared and static, inside a parent project in C, and what such a
# build installs. The objects of all builds of one linkage are the same, so they are compiled once.
#   - by FetchContent and by add_subdirectory, as docs/guide.md shows them whole: the README's program says what it should
#   - the same in a parent with a library of its own: its programs run, it installs nothing of ours
#   - static: the size of programs that ask little
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
. "$here/block.sh"

fail() {
  echo "subproject_test: $1" >&2
  exit 1
}

# build CMAKE_ARGUMENT...: configures and builds the project in the folder `parent`, which must compile the library once.
mkdir "$work/parent"
ln -s "$root" "$work/parent/vesica"
compiled=
build() {
  cmake -S "$work/parent" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=$shared "$@"
  cmake --build "$work/build" | tee "$work/log"
  [ -z "$compiled" ] || ! grep -q 'Building CXX object vesica/' "$work/log" || fail "compiled again with $*"
  compiled=yes
}

# parent CMAKE_ARGUMENT...: our own parent.
parent() {
  cp "$here"/subproject/*.* "$here"/consumer/*.c "$work/parent"
  build "$@"
}

# sample N CMAKE_ARGUMENT...: the Nth project of docs/guide.md. FetchContent's objects are put beside the other ways'.
says=$(sed -n 's/^It prints `\([^`]*\)`.*/\1/p' "$root/README.md" | head -n 1)
[ -n "$says" ] || fail 'the README does not say what its program prints'
sample() {
  # shellcheck disable=SC2016
  block "$root/docs/guide.md" cmake "$1" | sed 's,^FetchContent_Declare(.*[^)],& BINARY_DIR ${PROJECT_BINARY_DIR}/vesica,' \
    >"$work/parent/CMakeLists.txt"
  block "$root/README.md" c >"$work/parent/demo.c"
  build "${@:2}"
  [ "$("$work/build/app")" = "$says" ] || fail "project $1 of the guide does not print $says"
}

# at_most BYTES NAME STATEMENT FLAG...: a program with the archive is so large without symbols, and returns 0.
at_most() {
  printf '#include <vesica.h>\nint main(void) {\n%s\n}\n' "$3" >"$work/$2.c"
  "$CC" -O2 -s -I"$root/capi/include" -o "$work/$2" "$work/$2.c" "${@:4}" "$work/build/vesica/capi/libvesica.a" -lm
  "$work/$2" || fail "$2 returns $?"
  local size
  size=$(stat -c %s "$work/$2")
  echo "subproject_test: a program that asks $2 takes $size bytes"
  [ "$size" -le "$1" ] || fail "$2 takes $size bytes, more than $1"
}

# needed PROGRAM: the shared libraries it needs, but for libc and libm.
needed() {
  readelf -dW "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\].*/\1/p' | grep -Ev '^lib[cm]\.so' || true
}

for linkage in shared static; do
  shared=$([ $linkage = shared ] && echo ON || echo OFF)
  library=$([ $linkage = shared ] && echo libvesica.so.0 || true)
  rm -rf "$work/build"
  compiled=
  sample 2 -DFETCHCONTENT_SOURCE_DIR_VESICA="$work/parent/vesica"
  sample 3
  for by in add_subdirectory FetchContent; do
    echo "subproject_test: $linkage, $by"
    parent -DBY=$by -DVESICA_INSTALL=OFF
    "$work/build/c_user"
    "$work/build/methods_user"
    [ "$(needed "$work/build/c_user" | grep -v of_parent)" = "$library" ] || fail "c_user needs $(needed "$work/build/c_user")"
    rm -rf "$work/prefix"
    cmake --install "$work/build" --prefix "$work/prefix"
    [ "$(cd "$work/prefix" && find . ! -type d)" = ./bin/c_user ] || fail 'the parent installs more than its program'
  done

  if [ $linkage = static ]; then
    shapes='vesica_rect_f64 a = {0, 0, 0.8, 0.6, 2, 1}; vesica_ellipse_f64 b = {1.5, 1, 1, 0, 1, 0.5};'
    at_most 500000 overlap "$shapes return vesica_overlap_f64(VESICA_RECT, &a, VESICA_ELLIPSE, &b) != 1;"
    at_most 60000 overlap_rect_ellipse "$shapes return vesica_overlap_rect_ellipse_f64(&a, &b) != 1;" -Wl,--gc-sections
  fi

  echo "subproject_test: $linkage, installed"
  parent -DBY=add_subdirectory -DVESICA_INSTALL=ON
  cmake --install "$work/build" --prefix "$work/prefix" >"$work/log"
  grep -F vesica-targets-release.cmake "$work/log" || fail 'a parent of build type Release installs no paths'
  # Without a build type of the parent's ours is Release still, and that is what is installed.
  parent -DBY=add_subdirectory -DVESICA_INSTALL=ON -DCMAKE_BUILD_TYPE=
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
cmake -S "$work/parent" -B "$work/silent" -G Ninja
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
