#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# build.sh DIRECTORY: the source and binary packages of this tree, as its files are now, into DIRECTORY.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mkdir -p "$1"
out=$(cd "$1" && pwd)

# dpkg-buildpackage wants the folder debian at the top. The build is done in a copy that has it there, so that nothing of
# it is left in this tree; DIRECTORY may lie in build/.
work=$out/work
rm -rf "$work" "$out"/vesica_* "$out"/vesica-tools* "$out"/libvesica*
mkdir -p "$work/vesica"
tar -C "$root" --exclude=./build --exclude=./.git --exclude=./debian --exclude=__pycache__ -cf - . | tar -C "$work/vesica" -xf -
cp -r "$work/vesica/packaging/debian" "$work/vesica/debian"

cores=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}
if ! (cd "$work/vesica" && dpkg-buildpackage --no-sign --jobs-force="$cores") >"$out/build.log" 2>&1; then
  tail -n 30 "$out/build.log" >&2
  echo "build.sh: failed; all of it is in $out/build.log" >&2
  exit 1
fi
mv "$work"/vesica_* "$work"/vesica-tools* "$work"/libvesica* "$out"
rm -rf "$work"
