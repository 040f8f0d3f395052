#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh OUT [TREE]: writes OUT/vesica-<version>-windows-x86_64.zip: the DLL, its import library and its module
# definition file, headers, the CMake package and the licence. Built by g++ of mingw-w64 under build/windows, or taken
# from TREE, a build tree that has it built.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
[ $# = 1 ] || [ $# = 2 ] || { echo 'usage: build.sh OUT [TREE]' >&2; exit 2; }
mkdir -p "$1"
out=$(cd "$1" && pwd)

# The time in the DLL and of the files is the release's: the same tree gives the same zip.
SOURCE_DATE_EPOCH=$("$root/packaging/date.sh")
export SOURCE_DATE_EPOCH

tree=${2:-}
if [ -z "$tree" ]; then
  tree=$root/build/windows
  cmake -S "$root" -B "$tree" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_TOOLCHAIN_FILE=$root/packaging/windows/mingw.cmake"
  cmake --build "$tree"
fi

version=$(sed -n 's/^project(vesica VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
name=vesica-$version-windows-x86_64
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT
cmake --install "$tree" --prefix "$stage/$name" --strip >/dev/null
cp "$root/LICENSE" "$stage/$name/LICENSE.txt"
find "$stage" -type f -exec touch -d "@$SOURCE_DATE_EPOCH" {} +
rm -f "$out/$name.zip"
(cd "$stage" && find "$name" -type f | LC_ALL=C sort | TZ=UTC zip -q -X -@ "$out/$name.zip")
echo "$out/$name.zip"
